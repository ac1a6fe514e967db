// SPDX-License-Identifier: MIT
// Where things stand. libyaml's marks are exact for scalars and for what is in brackets; a collection of lines has its
// end mark at the next token, beyond comments, so its end is that of its last value. New lines go behind the line in
// which that stands, and its comment.

#include "scene/yaml_edit.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct Edit
{
    size_t begin, end; // bytes that go
    size_t text, textSize;
    int order;
} Edit;

static yaml_node_t* getNode(const swYamlEdits* edits, int node)
{
    return yaml_document_get_node(&edits->yaml->document, node);
}

static bool isBreak(char c)
{
    return c == '\n' || c == '\r';
}

static bool isSpace(char c)
{
    return c == ' ' || c == '\t';
}

static int countChildren(const yaml_node_t* node)
{
    return node->type == YAML_SEQUENCE_NODE  ? (int)(node->data.sequence.items.top - node->data.sequence.items.start)
           : node->type == YAML_MAPPING_NODE ? (int)(node->data.mapping.pairs.top - node->data.mapping.pairs.start)
                                             : 0;
}

// Of a list its item, of a mapping the value, and where its key or the item itself begins.
static int getChild(const yaml_node_t* node, int index)
{
    return node->type == YAML_SEQUENCE_NODE ? node->data.sequence.items.start[index]
                                            : node->data.mapping.pairs.start[index].value;
}

// ---- before the first change ----

static size_t skipMark(const char* text, size_t size)
{
    return size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
}

static swResult findBytes(swYamlEdits* edits)
{
    size_t begin = skipMark(edits->text, edits->size);
    uint32_t* bytes = swAppendItems(edits->yaml->host, &edits->bytes, edits->size - begin + 1, sizeof(uint32_t));
    if (bytes == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    size_t count = 0;
    for (size_t i = begin; i < edits->size; ++i)
    {
        if (((unsigned char)edits->text[i] & 0xC0) != 0x80)
        {
            bytes[count++] = (uint32_t)i;
        }
    }
    bytes[count++] = (uint32_t)edits->size;
    edits->bytes.count = count;
    return SW_SUCCESS;
}

// How often each node is used, twice if what holds it is. A node stands before what it holds.
static swResult countShares(swYamlEdits* edits)
{
    yaml_document_t* document = &edits->yaml->document;
    int count = (int)(document->nodes.top - document->nodes.start);
    int* shares = swAppendItems(edits->yaml->host, &edits->shares, (size_t)count + 1, sizeof(int));
    if (shares == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    memset(shares, 0, ((size_t)count + 1) * sizeof(int));
    for (int i = 1; i <= count; ++i)
    {
        const yaml_node_t* node = getNode(edits, i);
        for (int j = 0; j < countChildren(node); ++j)
        {
            shares[getChild(node, j)] += shares[i] > 1 ? 2 : 1;
        }
    }
    return SW_SUCCESS;
}

// The line ends of the text, and how far its sections are indented.
static swLayout findLayout(const swYamlEdits* edits)
{
    swLayout layout = {"\n", 2};
    for (size_t i = 0; i < edits->size; ++i)
    {
        if (isBreak(edits->text[i]))
        {
            bool isPair = edits->text[i] == '\r' && i + 1 < edits->size && edits->text[i + 1] == '\n';
            layout.lineEnd = isPair ? "\r\n" : edits->text[i] == '\r' ? "\r" : "\n";
            break;
        }
    }
    const yaml_node_t* root = yaml_document_get_root_node(&edits->yaml->document);
    if (root == NULL || root->type != YAML_MAPPING_NODE)
    {
        return layout;
    }
    for (yaml_node_pair_t* pair = root->data.mapping.pairs.start; pair < root->data.mapping.pairs.top; ++pair)
    {
        const yaml_node_t* value = getNode(edits, pair->value);
        if (value->type == YAML_MAPPING_NODE && value->data.mapping.style != YAML_FLOW_MAPPING_STYLE &&
            value->start_mark.column > 0 && value->start_mark.column <= 8)
        {
            layout.step = value->start_mark.column;
            break;
        }
    }
    return layout;
}

swResult swBeginYamlEdits(swYaml* yaml, const char* text, size_t size, swYamlEdits* edits)
{
    *edits = (swYamlEdits){.yaml = yaml, .text = text, .size = size, .added = {.host = yaml->host}};
    edits->result = findBytes(edits);
    edits->result = edits->result == SW_SUCCESS ? countShares(edits) : edits->result;
    if (edits->result != SW_SUCCESS)
    {
        return swFail(yaml->host, edits->result, "No memory to write %s.", yaml->name);
    }
    edits->layout = findLayout(edits);
    return SW_SUCCESS;
}

void swEndYamlEdits(swYamlEdits* edits)
{
    const swHost* host = edits->yaml->host;
    swFreeItems(host, &edits->bytes, sizeof(uint32_t));
    swFreeItems(host, &edits->shares, sizeof(int));
    swFreeItems(host, &edits->edits, sizeof(Edit));
    swFreeItems(host, &edits->added.chars, 1);
}

swResult swRefuseYamlEdit(swYamlEdits* edits, const yaml_node_t* node, const char* why)
{
    if (edits->result == SW_SUCCESS)
    {
        edits->result = SW_ERROR_FORMAT;
        swFail(edits->yaml->host, SW_ERROR_FORMAT,
               "%s:%d: this cannot be written without touching what stands beside "
               "it: %s. Nothing was written.",
               edits->yaml->name, (int)node->start_mark.line + 1, why);
    }
    return edits->result;
}

// ---- changes ----

static void addEdit(swYamlEdits* edits, size_t begin, size_t end, size_t addedFrom)
{
    Edit* edit = swAppendItems(edits->yaml->host, &edits->edits, 1, sizeof(Edit));
    if (edit == NULL || edits->added.isBroken)
    {
        if (edits->result == SW_SUCCESS)
        {
            edits->result = swFail(edits->yaml->host, SW_ERROR_NO_MEMORY, "No memory to write %s.", edits->yaml->name);
        }
        return;
    }
    *edit = (Edit){begin, end, addedFrom, edits->added.chars.count - addedFrom, (int)edits->edits.count};
}

static int compareEdits(const void* a, const void* b)
{
    const Edit *left = a, *right = b;
    return left->begin != right->begin ? (left->begin < right->begin ? -1 : 1) : left->order - right->order;
}

swResult swMakeYamlEdits(swYamlEdits* edits, char** text, size_t* size)
{
    const Edit* list = edits->edits.data;
    if (edits->result != SW_SUCCESS)
    {
        return edits->result;
    }
    if (edits->edits.count > 1)
    {
        qsort(edits->edits.data, edits->edits.count, sizeof(Edit), compareEdits);
    }
    size_t total = edits->size, at = 0, to = 0;
    for (size_t i = 0; i < edits->edits.count; ++i)
    {
        if (list[i].begin < at || list[i].end < list[i].begin)
        {
            return swFail(edits->yaml->host, SW_ERROR_FORMAT,
                          "%s: two changes meet in one place, so nothing was written.", edits->yaml->name);
        }
        at = list[i].end;
        total += list[i].textSize - (list[i].end - list[i].begin);
    }
    char* made = swAllocate(edits->yaml->host, total + 1);
    if (made == NULL)
    {
        return swFail(edits->yaml->host, SW_ERROR_NO_MEMORY, "No memory to write %s.", edits->yaml->name);
    }
    at = 0;
    for (size_t i = 0; i < edits->edits.count; ++i)
    {
        memcpy(made + to, edits->text + at, list[i].begin - at);
        to += list[i].begin - at;
        if (list[i].textSize > 0)
        {
            memcpy(made + to, (const char*)edits->added.chars.data + list[i].text, list[i].textSize);
        }
        to += list[i].textSize;
        at = list[i].end;
    }
    memcpy(made + to, edits->text + at, edits->size - at);
    made[total] = '\0';
    *text = made;
    *size = total;
    return SW_SUCCESS;
}

// ---- where things stand ----

static size_t findByte(const swYamlEdits* edits, yaml_mark_t mark)
{
    const uint32_t* bytes = edits->bytes.data;
    return bytes[mark.index < edits->bytes.count ? mark.index : edits->bytes.count - 1];
}

// Behind anchors and tags.
static size_t findBegin(const swYamlEdits* edits, const yaml_node_t* node)
{
    size_t at = findByte(edits, node->start_mark), end = findByte(edits, node->end_mark);
    while (at < end && (edits->text[at] == '&' || edits->text[at] == '!'))
    {
        while (at < end && !isSpace(edits->text[at]) && !isBreak(edits->text[at]))
        {
            ++at;
        }
        while (at < end && (isSpace(edits->text[at]) || isBreak(edits->text[at])))
        {
            ++at;
        }
    }
    return at;
}

static bool isInBrackets(const yaml_node_t* node)
{
    return node->type == YAML_SEQUENCE_NODE  ? node->data.sequence.style == YAML_FLOW_SEQUENCE_STYLE
           : node->type == YAML_MAPPING_NODE ? node->data.mapping.style == YAML_FLOW_MAPPING_STYLE
                                             : false;
}

static size_t findChildBegin(const swYamlEdits* edits, const yaml_node_t* node, int index)
{
    int child = node->type == YAML_SEQUENCE_NODE ? node->data.sequence.items.start[index]
                                                 : node->data.mapping.pairs.start[index].key;
    return findByte(edits, getNode(edits, child)->start_mark);
}

// Behind the last character of a value.
static size_t findEnd(const swYamlEdits* edits, const yaml_node_t* node)
{
    while (node->type != YAML_SCALAR_NODE && !isInBrackets(node) && countChildren(node) > 0)
    {
        node = getNode(edits, getChild(node, countChildren(node) - 1));
    }
    size_t end = findByte(edits, node->end_mark), begin = findByte(edits, node->start_mark);
    while (end > begin && (isBreak(edits->text[end - 1]) || isSpace(edits->text[end - 1])))
    {
        --end; // of a text in lines of its own, behind | or >
    }
    return end;
}

static size_t findLine(const swYamlEdits* edits, size_t at)
{
    size_t least = skipMark(edits->text, edits->size);
    while (at > least && !isBreak(edits->text[at - 1]))
    {
        --at;
    }
    return at;
}

static size_t findNextLine(const swYamlEdits* edits, size_t at)
{
    while (at < edits->size && !isBreak(edits->text[at]))
    {
        ++at;
    }
    if (at + 1 < edits->size && edits->text[at] == '\r' && edits->text[at + 1] == '\n')
    {
        ++at;
    }
    return at < edits->size ? at + 1 : at;
}

bool swIsYamlShared(const swYamlEdits* edits, int node)
{
    const yaml_node_t* at = getNode(edits, node);
    bool isShared = ((const int*)edits->shares.data)[node] > 1;
    for (int i = 0; i < countChildren(at) && !isShared; ++i)
    {
        isShared = swIsYamlShared(edits, getChild(at, i));
    }
    return isShared;
}

// Neither a collection whose end is not known, nor one that something else repeats.
static bool refuseShared(swYamlEdits* edits, int node)
{
    if (edits->result == SW_SUCCESS && swIsYamlShared(edits, node))
    {
        swRefuseYamlEdit(edits, getNode(edits, node), "& and * share a value between two places; write it out in both");
    }
    return edits->result != SW_SUCCESS;
}

// ---- scalars and pairs ----

void swReplaceYamlScalar(swYamlEdits* edits, int node, const char* text, bool isInLine)
{
    const yaml_node_t* at = getNode(edits, node);
    if (refuseShared(edits, node))
    {
        return;
    }
    yaml_scalar_style_t style = at->data.scalar.style;
    size_t from = edits->added.chars.count;
    swAddScalar(&edits->added, text,
                style == YAML_SINGLE_QUOTED_SCALAR_STYLE   ? SW_QUOTES_SINGLE
                : style == YAML_DOUBLE_QUOTED_SCALAR_STYLE ? SW_QUOTES_DOUBLE
                                                           : SW_QUOTES_NONE,
                isInLine);
    addEdit(edits, findBegin(edits, at), findEnd(edits, at), from);
}

void swReplaceYamlPair(swYamlEdits* edits, int mapping, int index, const swTree* tree, int node)
{
    const yaml_node_t* at = getNode(edits, mapping);
    yaml_node_pair_t pair = at->data.mapping.pairs.start[index];
    const yaml_node_t* key = getNode(edits, pair.key);
    if (refuseShared(edits, pair.value))
    {
        return;
    }
    size_t from = edits->added.chars.count;
    const char* name = swGetTreeNode(tree, node)->key;
    swAddText(&edits->added, name, strlen(name));
    addEdit(edits, findByte(edits, key->start_mark), findByte(edits, key->end_mark), from);
    swReplaceYamlScalar(edits, pair.value, swGetTreeText(tree, node), isInBrackets(at));
}

// ---- collections in brackets ----

static void removeInBrackets(swYamlEdits* edits, const yaml_node_t* node, const bool* isKept)
{
    int count = countChildren(node);
    bool hasKept = false;
    for (int i = 0; i < count; ++i)
    {
        size_t begin = findChildBegin(edits, node, i), end = findEnd(edits, getNode(edits, getChild(node, i)));
        if (isKept[i])
        {
            hasKept = true;
        }
        else if (hasKept)
        {
            addEdit(edits, findEnd(edits, getNode(edits, getChild(node, i - 1))), end, edits->added.chars.count);
        }
        else
        {
            addEdit(edits, begin, i + 1 < count ? findChildBegin(edits, node, i + 1) : end, edits->added.chars.count);
        }
    }
}

static void addInBrackets(swYamlEdits* edits, const yaml_node_t* node, const bool* isKept, const swYamlAdded* added)
{
    int count = countChildren(node), first = count;
    for (int i = count - 1; i >= 0; --i)
    {
        first = isKept[i] ? i : first;
    }
    size_t from = edits->added.chars.count, at = findByte(edits, node->start_mark) + 1;
    bool isMapping = node->type == YAML_MAPPING_NODE, isBefore = first < count && added->after < first;
    if (isBefore)
    {
        at = findChildBegin(edits, node, first);
    }
    else if (count > 0)
    {
        int behind = added->after >= 0 && first < count ? added->after : count - 1;
        at = findEnd(edits, getNode(edits, getChild(node, behind)));
    }
    const Edit* last = (const Edit*)edits->edits.data + edits->edits.count - 1;
    bool isFollowing = first == count && edits->edits.count > 0 && last->begin == at && last->end == at;
    swAddText(&edits->added, ", ", !isBefore && (first < count || isFollowing) ? 2 : 0);
    swAddTreeInLine(&edits->added, added->tree, added->node, isMapping);
    swAddText(&edits->added, ", ", isBefore ? 2 : 0);
    addEdit(edits, at, at, from);
}

// ---- collections in lines ----

// Where the dash before an item stands: on its line, or on one before it that holds nothing else but a comment.
static bool findDash(const swYamlEdits* edits, size_t item, size_t* dash)
{
    size_t line = findLine(edits, item), end = item;
    for (;;)
    {
        size_t at = line;
        while (at < end && edits->text[at] == ' ')
        {
            ++at;
        }
        bool isEmpty = at == end || edits->text[at] == '#' || isBreak(edits->text[at]);
        if (!isEmpty)
        {
            size_t next = at + 1;
            while (next < end && isSpace(edits->text[next]))
            {
                ++next;
            }
            *dash = at;
            return edits->text[at] == '-' && (next == end || edits->text[next] == '#' || isBreak(edits->text[next]));
        }
        if (line <= skipMark(edits->text, edits->size))
        {
            return false;
        }
        end = line;
        line = findLine(edits,
                        line - (line >= 2 && edits->text[line - 1] == '\n' && edits->text[line - 2] == '\r' ? 2 : 1));
    }
}

// Nothing but spaces before, nothing but a comment behind.
static bool standsAlone(const swYamlEdits* edits, size_t begin, size_t end)
{
    for (size_t i = findLine(edits, begin); i < begin; ++i)
    {
        if (edits->text[i] != ' ')
        {
            return false;
        }
    }
    while (end < edits->size && isSpace(edits->text[end]))
    {
        ++end;
    }
    return end >= edits->size || isBreak(edits->text[end]) || edits->text[end] == '#';
}

// Whether a line of its own between two places is a comment. One behind a value goes with it.
static bool hasCommentLine(const swYamlEdits* edits, size_t begin, size_t end)
{
    for (size_t at = findNextLine(edits, begin); at < end; at = findNextLine(edits, at))
    {
        size_t first = at;
        while (first < end && isSpace(edits->text[first]))
        {
            ++first;
        }
        if (first < end && edits->text[first] == '#')
        {
            return true;
        }
    }
    return false;
}

// The first pair of a list's item stands behind the dash. What is kept moves up to there, unless a comment lies
// between; if nothing is, a new pair takes the place. Returns how many pairs are dealt with, and whether the first new
// one is.
static int replaceFirstPairs(swYamlEdits* edits, const yaml_node_t* node, const bool* isKept, const swYamlAdded* added,
                             bool* usesAdded)
{
    int count = countChildren(node), kept = 0;
    size_t begin = findChildBegin(edits, node, 0), end = findEnd(edits, getNode(edits, getChild(node, 0)));
    while (kept < count && !isKept[kept])
    {
        ++kept;
    }
    *usesAdded = kept == count;
    if (kept < count)
    {
        size_t next = findChildBegin(edits, node, kept);
        bool hasComment = hasCommentLine(edits, end, next);
        addEdit(edits, begin, hasComment ? end : next, edits->added.chars.count);
        return hasComment ? 1 : kept;
    }
    if (added == NULL)
    {
        swRefuseYamlEdit(edits, node, "nothing would be left of it");
        return count;
    }
    size_t from = edits->added.chars.count;
    swAddTreePair(&edits->added, &edits->layout, added->tree, added->node, node->start_mark.column);
    edits->added.chars.count -= edits->added.isBroken ? 0 : strlen(edits->layout.lineEnd);
    addEdit(edits, begin, end, from);
    return 1;
}

static void removeLines(swYamlEdits* edits, const yaml_node_t* node, int index)
{
    size_t begin = findChildBegin(edits, node, index), end = findEnd(edits, getNode(edits, getChild(node, index)));
    if (node->type == YAML_SEQUENCE_NODE && !findDash(edits, begin, &begin))
    {
        swRefuseYamlEdit(edits, node, "the item shares its line with another");
    }
    else if (standsAlone(edits, begin, end))
    {
        addEdit(edits, findLine(edits, begin), findNextLine(edits, end), edits->added.chars.count);
    }
    else
    {
        swRefuseYamlEdit(edits, node, "it shares its line with something else");
    }
}

// Lines of their own at a place where a line begins, or at the end of a text whose last line has no end.
static void addLines(swYamlEdits* edits, size_t at, size_t indent, bool hasGap, const yaml_node_t* node,
                     const swYamlAdded* added)
{
    size_t from = edits->added.chars.count, lineEnd = strlen(edits->layout.lineEnd);
    bool isOpen = at > 0 && !isBreak(edits->text[at - 1]);
    swAddText(&edits->added, edits->layout.lineEnd, isOpen ? lineEnd : 0);
    swAddText(&edits->added, edits->layout.lineEnd, hasGap ? lineEnd : 0);
    swAddSpaces(&edits->added, indent);
    if (node->type == YAML_SEQUENCE_NODE)
    {
        swAddTreeItem(&edits->added, &edits->layout, added->tree, added->node, indent);
    }
    else
    {
        swAddTreePair(&edits->added, &edits->layout, added->tree, added->node, indent);
    }
    edits->added.chars.count -= isOpen && !edits->added.isBroken ? lineEnd : 0;
    addEdit(edits, at, at, from);
}

// Whether the sections of a text are parted by empty lines.
static bool hasGaps(const swYamlEdits* edits, const yaml_node_t* node)
{
    if (node != yaml_document_get_root_node(&edits->yaml->document) || countChildren(node) < 2)
    {
        return false;
    }
    for (int i = countChildren(node) - 1; i > 0; --i)
    {
        const yaml_node_t* value = getNode(edits, getChild(node, i));
        size_t line = findLine(edits, findChildBegin(edits, node, i));
        if (value->type != YAML_SCALAR_NODE && line >= 2)
        {
            return isBreak(edits->text[line - 2]) &&
                   (edits->text[line - 2] == edits->text[line - 1] || (line >= 3 && isBreak(edits->text[line - 3])));
        }
    }
    return false;
}

// The mapping whose value a collection is, and the key; NULL of what is no value.
static const yaml_node_t* findParent(const swYamlEdits* edits, const yaml_node_t* collection, const yaml_node_t** key)
{
    yaml_document_t* document = &edits->yaml->document;
    for (const yaml_node_t* node = document->nodes.start; node < document->nodes.top; ++node)
    {
        for (int i = 0; node->type == YAML_MAPPING_NODE && i < countChildren(node); ++i)
        {
            if (getNode(edits, getChild(node, i)) == collection)
            {
                *key = getNode(edits, node->data.mapping.pairs.start[i].key);
                return node;
            }
        }
    }
    return NULL;
}

// Behind the colon of a key.
static size_t findValuePlace(const swYamlEdits* edits, const yaml_node_t* key)
{
    size_t at = findByte(edits, key->end_mark);
    const char* colon = memchr(edits->text + at, ':', edits->size - at);
    return colon != NULL ? (size_t)(colon - edits->text) + 1 : at;
}

// "waves: []" becomes a list of lines. False if it stands in brackets itself.
static bool expandEmptyList(swYamlEdits* edits, const yaml_node_t* node, const swYamlAdded* added, int addedCount)
{
    const yaml_node_t* key = NULL;
    const yaml_node_t* parent = node->type == YAML_SEQUENCE_NODE ? findParent(edits, node, &key) : NULL;
    size_t end = findEnd(edits, node);
    if (parent == NULL || isInBrackets(parent) || findBegin(edits, node) != findByte(edits, node->start_mark))
    {
        return false;
    }
    for (int i = 0; i < addedCount; ++i)
    {
        addLines(edits, findNextLine(edits, end), key->start_mark.column + edits->layout.step, false, node, &added[i]);
    }
    addEdit(edits, findValuePlace(edits, key), end, edits->added.chars.count);
    return true;
}

static void arrangeLines(swYamlEdits* edits, const yaml_node_t* node, const bool* isKept, const swYamlAdded* added,
                         int addedCount)
{
    int count = countChildren(node), left = addedCount;
    size_t indent = node->start_mark.column;
    bool isList = node->type == YAML_SEQUENCE_NODE, hasGap = hasGaps(edits, node);
    size_t first = findChildBegin(edits, node, 0);
    if (isList && !findDash(edits, first, &first))
    {
        swRefuseYamlEdit(edits, node, "an item shares its line with another");
        return;
    }
    indent = isList ? first - findLine(edits, first) : indent;
    int done = 0;
    bool usesAdded = false;
    if (!isList && !isKept[0] && !standsAlone(edits, first, findEnd(edits, getNode(edits, getChild(node, 0)))))
    {
        done = replaceFirstPairs(edits, node, isKept, addedCount > 0 ? added : NULL, &usesAdded);
    }
    for (int i = usesAdded ? 1 : 0; i < addedCount; ++i)
    {
        int after = added[i].after < count ? added[i].after : count - 1;
        size_t at = after < 0 ? findLine(edits, first)
                              : findNextLine(edits, findEnd(edits, getNode(edits, getChild(node, after))));
        bool isSection = swGetTreeNode(added[i].tree, added[i].node)->type != SW_TREE_SCALAR;
        addLines(edits, at, indent, hasGap && isSection, node, &added[i]);
    }
    for (int i = 0; i < count; ++i)
    {
        left += isKept[i];
        if (!isKept[i] && i >= done)
        {
            removeLines(edits, node, i);
        }
    }
    if (left == 0) // the key stays, with an empty list
    {
        const yaml_node_t* key = NULL;
        size_t from = edits->added.chars.count;
        size_t at = findParent(edits, node, &key) != NULL ? findValuePlace(edits, key) : edits->size;
        swAddText(&edits->added, isList ? " []" : " {}", 3);
        addEdit(edits, at, at, from);
    }
}

void swArrangeYaml(swYamlEdits* edits, int collection, const bool* isKept, const swYamlAdded* added, int addedCount)
{
    const yaml_node_t* node = getNode(edits, collection);
    int count = countChildren(node);
    bool isChanged = addedCount > 0;
    for (int i = 0; i < count; ++i)
    {
        isChanged = isChanged || !isKept[i];
    }
    if (!isChanged || refuseShared(edits, collection))
    {
        return;
    }
    if (isInBrackets(node) && count == 0 && expandEmptyList(edits, node, added, addedCount))
    {
        return;
    }
    if (isInBrackets(node))
    {
        for (int i = 0; i < addedCount; ++i)
        {
            addInBrackets(edits, node, isKept, &added[i]);
        }
        removeInBrackets(edits, node, isKept);
    }
    else
    {
        arrangeLines(edits, node, isKept, added, addedCount);
    }
}

void swFillYaml(swYamlEdits* edits, const swTree* tree, int root)
{
    size_t from = edits->added.chars.count, lineEnd = strlen(edits->layout.lineEnd);
    bool isOpen = edits->size > 0 && !isBreak(edits->text[edits->size - 1]);
    swAddText(&edits->added, edits->layout.lineEnd, isOpen ? lineEnd : 0);
    bool isFirst = true;
    int child = swGetTreeNode(tree, root)->first;
    for (; child >= 0; child = swGetTreeNode(tree, child)->next)
    {
        if (!swIsTreeDefault(tree, child))
        {
            bool isSection = swGetTreeNode(tree, child)->type != SW_TREE_SCALAR;
            swAddText(&edits->added, edits->layout.lineEnd, isSection && !isFirst ? lineEnd : 0);
            swAddTreePair(&edits->added, &edits->layout, tree, child, 0);
            isFirst = false;
        }
    }
    addEdit(edits, edits->size, edits->size, from);
}
