// SPDX-License-Identifier: MIT
// New lines go behind the line in which a collection's last value stands, and its comment; a pair or an item that goes
// takes its lines along. In brackets, commas go with what they part.

#include "scene/yaml_edit.h"

#include <stdlib.h>
#include <string.h>

typedef struct Edit
{
    size_t begin, end; // bytes that go
    size_t text, textSize;
    int order;
} Edit;

swResult swBeginYamlEdits(swYaml* yaml, const char* text, size_t size, swYamlEdits* edits)
{
    *edits = (swYamlEdits){.added = {.host = yaml->host}};
    edits->result = swBeginYamlPlaces(yaml, text, size, &edits->places);
    if (edits->result == SW_SUCCESS)
    {
        edits->layout = swFindYamlLayout(&edits->places);
    }
    return edits->result;
}

void swEndYamlEdits(swYamlEdits* edits)
{
    const swHost* host = edits->places.yaml->host;
    swFreeItems(host, &edits->edits, sizeof(Edit));
    swFreeItems(host, &edits->added.chars, 1);
    swEndYamlPlaces(&edits->places);
}

swResult swRefuseYamlEdit(swYamlEdits* edits, const yaml_node_t* node, const char* why)
{
    if (edits->result == SW_SUCCESS)
    {
        edits->result = SW_ERROR_FORMAT;
        swFail(edits->places.yaml->host, SW_ERROR_FORMAT,
               "%s:%d: this cannot be written without touching what stands beside "
               "it: %s. Nothing was written.",
               edits->places.yaml->name, (int)node->start_mark.line + 1, why);
    }
    return edits->result;
}

// ---- changes ----

static void addEdit(swYamlEdits* edits, size_t begin, size_t end, size_t addedFrom)
{
    Edit* edit = swAppendItems(edits->places.yaml->host, &edits->edits, 1, sizeof(Edit));
    if (edit == NULL || edits->added.isBroken)
    {
        if (edits->result == SW_SUCCESS)
        {
            edits->result = swFail(edits->places.yaml->host, SW_ERROR_NO_MEMORY, "No memory to write %s.",
                                   edits->places.yaml->name);
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
    size_t total = edits->places.size, at = 0, to = 0;
    for (size_t i = 0; i < edits->edits.count; ++i)
    {
        if (list[i].begin < at || list[i].end < list[i].begin)
        {
            return swFail(edits->places.yaml->host, SW_ERROR_FORMAT,
                          "%s: two changes meet in one place, so nothing was written.", edits->places.yaml->name);
        }
        at = list[i].end;
        total += list[i].textSize - (list[i].end - list[i].begin);
    }
    char* made = swAllocate(edits->places.yaml->host, total + 1);
    if (made == NULL)
    {
        return swFail(edits->places.yaml->host, SW_ERROR_NO_MEMORY, "No memory to write %s.", edits->places.yaml->name);
    }
    at = 0;
    for (size_t i = 0; i < edits->edits.count; ++i)
    {
        memcpy(made + to, edits->places.text + at, list[i].begin - at);
        to += list[i].begin - at;
        if (list[i].textSize > 0)
        {
            memcpy(made + to, (const char*)edits->added.chars.data + list[i].text, list[i].textSize);
        }
        to += list[i].textSize;
        at = list[i].end;
    }
    memcpy(made + to, edits->places.text + at, edits->places.size - at);
    made[total] = '\0';
    *text = made;
    *size = total;
    return SW_SUCCESS;
}

// Neither a collection whose end is not known, nor one that something else repeats.
static bool refuseShared(swYamlEdits* edits, int node)
{
    if (edits->result == SW_SUCCESS && swIsYamlShared(&edits->places, node))
    {
        swRefuseYamlEdit(edits, swGetYamlNodeAt(&edits->places, node),
                         "& and * share a value between two places; write it out in both");
    }
    return edits->result != SW_SUCCESS;
}

// ---- scalars and pairs ----

void swReplaceYamlScalar(swYamlEdits* edits, int node, const char* text, bool isInLine)
{
    const yaml_node_t* at = swGetYamlNodeAt(&edits->places, node);
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
    addEdit(edits, swFindYamlBegin(&edits->places, at), swFindYamlEnd(&edits->places, at), from);
}

void swReplaceYamlPair(swYamlEdits* edits, int mapping, int index, const swTree* tree, int node)
{
    const yaml_node_t* at = swGetYamlNodeAt(&edits->places, mapping);
    yaml_node_pair_t pair = at->data.mapping.pairs.start[index];
    const yaml_node_t* key = swGetYamlNodeAt(&edits->places, pair.key);
    if (refuseShared(edits, pair.value))
    {
        return;
    }
    size_t from = edits->added.chars.count;
    const char* name = swGetTreeNode(tree, node)->key;
    swAddText(&edits->added, name, strlen(name));
    addEdit(edits, swFindYamlByte(&edits->places, key->start_mark), swFindYamlByte(&edits->places, key->end_mark),
            from);
    swReplaceYamlScalar(edits, pair.value, swGetTreeText(tree, node), swIsInYamlBrackets(at));
}

// ---- collections in brackets ----

static void removeInBrackets(swYamlEdits* edits, const yaml_node_t* node, const bool* isKept)
{
    int count = swCountYamlChildren(node);
    bool hasKept = false;
    for (int i = 0; i < count; ++i)
    {
        size_t begin = swFindYamlChildBegin(&edits->places, node, i),
               end = swFindYamlEnd(&edits->places, swGetYamlNodeAt(&edits->places, swGetYamlChild(node, i)));
        if (isKept[i])
        {
            hasKept = true;
        }
        else if (hasKept)
        {
            addEdit(edits, swFindYamlEnd(&edits->places, swGetYamlNodeAt(&edits->places, swGetYamlChild(node, i - 1))),
                    end, edits->added.chars.count);
        }
        else
        {
            addEdit(edits, begin, i + 1 < count ? swFindYamlChildBegin(&edits->places, node, i + 1) : end,
                    edits->added.chars.count);
        }
    }
}

static void addInBrackets(swYamlEdits* edits, const yaml_node_t* node, const bool* isKept, const swYamlAdded* added)
{
    int count = swCountYamlChildren(node), first = count;
    for (int i = count - 1; i >= 0; --i)
    {
        first = isKept[i] ? i : first;
    }
    size_t from = edits->added.chars.count, at = swFindYamlByte(&edits->places, node->start_mark) + 1;
    bool isMapping = node->type == YAML_MAPPING_NODE, isBefore = first < count && added->after < first;
    if (isBefore)
    {
        at = swFindYamlChildBegin(&edits->places, node, first);
    }
    else if (count > 0)
    {
        int behind = added->after >= 0 && first < count ? added->after : count - 1;
        at = swFindYamlEnd(&edits->places, swGetYamlNodeAt(&edits->places, swGetYamlChild(node, behind)));
    }
    size_t editCount = edits->edits.count;
    const Edit* last = editCount > 0 ? (const Edit*)edits->edits.data + editCount - 1 : NULL;
    bool isFollowing = first == count && last != NULL && last->begin == at && last->end == at;
    swAddText(&edits->added, ", ", !isBefore && (first < count || isFollowing) ? 2 : 0);
    swAddTreeInLine(&edits->added, added->tree, added->node, isMapping);
    swAddText(&edits->added, ", ", isBefore ? 2 : 0);
    addEdit(edits, at, at, from);
}

// ---- collections in lines ----

// The first pair of a list's item stands behind the dash. What is kept moves up to there, unless a comment lies
// between; if nothing is, a new pair takes the place. Returns how many pairs are dealt with, and whether the first new
// one is.
static int replaceFirstPairs(swYamlEdits* edits, const yaml_node_t* node, const bool* isKept, const swYamlAdded* added,
                             bool* usesAdded)
{
    int count = swCountYamlChildren(node), kept = 0;
    size_t begin = swFindYamlChildBegin(&edits->places, node, 0),
           end = swFindYamlEnd(&edits->places, swGetYamlNodeAt(&edits->places, swGetYamlChild(node, 0)));
    while (kept < count && !isKept[kept])
    {
        ++kept;
    }
    *usesAdded = kept == count;
    if (kept < count)
    {
        size_t next = swFindYamlChildBegin(&edits->places, node, kept);
        bool hasComment = swHasYamlComment(&edits->places, end, next);
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
    size_t begin = swFindYamlChildBegin(&edits->places, node, index),
           end = swFindYamlEnd(&edits->places, swGetYamlNodeAt(&edits->places, swGetYamlChild(node, index)));
    if (node->type == YAML_SEQUENCE_NODE && !swFindYamlDash(&edits->places, begin, &begin))
    {
        swRefuseYamlEdit(edits, node, "the item shares its line with another");
    }
    else if (swStandsAlone(&edits->places, begin, end))
    {
        addEdit(edits, swFindYamlLine(&edits->places, begin), swFindNextYamlLine(&edits->places, end),
                edits->added.chars.count);
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
    bool isOpen = at > 0 && !swIsYamlBreak(edits->places.text[at - 1]);
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

// "waves: []" becomes a list of lines. False if it stands in brackets itself.
static bool expandEmptyList(swYamlEdits* edits, const yaml_node_t* node, const swYamlAdded* added, int addedCount)
{
    const yaml_node_t* key = NULL;
    const yaml_node_t* parent = node->type == YAML_SEQUENCE_NODE ? swFindYamlParent(&edits->places, node, &key) : NULL;
    size_t end = swFindYamlEnd(&edits->places, node);
    if (parent == NULL || swIsInYamlBrackets(parent) ||
        swFindYamlBegin(&edits->places, node) != swFindYamlByte(&edits->places, node->start_mark))
    {
        return false;
    }
    for (int i = 0; i < addedCount; ++i)
    {
        addLines(edits, swFindNextYamlLine(&edits->places, end), key->start_mark.column + edits->layout.step, false,
                 node, &added[i]);
    }
    addEdit(edits, swFindYamlValue(&edits->places, key), end, edits->added.chars.count);
    return true;
}

static void arrangeLines(swYamlEdits* edits, const yaml_node_t* node, const bool* isKept, const swYamlAdded* added,
                         int addedCount)
{
    int count = swCountYamlChildren(node), left = addedCount;
    size_t indent = node->start_mark.column;
    bool isList = node->type == YAML_SEQUENCE_NODE, hasGap = swHasYamlGaps(&edits->places, node);
    size_t first = swFindYamlChildBegin(&edits->places, node, 0);
    if (isList && !swFindYamlDash(&edits->places, first, &first))
    {
        swRefuseYamlEdit(edits, node, "an item shares its line with another");
        return;
    }
    indent = isList ? first - swFindYamlLine(&edits->places, first) : indent;
    int done = 0;
    bool usesAdded = false;
    if (!isList && !isKept[0] &&
        !swStandsAlone(&edits->places, first,
                       swFindYamlEnd(&edits->places, swGetYamlNodeAt(&edits->places, swGetYamlChild(node, 0)))))
    {
        done = replaceFirstPairs(edits, node, isKept, addedCount > 0 ? added : NULL, &usesAdded);
    }
    for (int i = usesAdded ? 1 : 0; i < addedCount; ++i)
    {
        int after = added[i].after < count ? added[i].after : count - 1;
        size_t at =
            after < 0 ? swFindYamlLine(&edits->places, first)
                      : swFindNextYamlLine(&edits->places,
                                           swFindYamlEnd(&edits->places,
                                                         swGetYamlNodeAt(&edits->places, swGetYamlChild(node, after))));
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
        size_t at = swFindYamlParent(&edits->places, node, &key) != NULL ? swFindYamlValue(&edits->places, key)
                                                                         : edits->places.size;
        swAddText(&edits->added, isList ? " []" : " {}", 3);
        addEdit(edits, at, at, from);
    }
}

void swArrangeYaml(swYamlEdits* edits, int collection, const bool* isKept, const swYamlAdded* added, int addedCount)
{
    const yaml_node_t* node = swGetYamlNodeAt(&edits->places, collection);
    int count = swCountYamlChildren(node);
    bool isChanged = addedCount > 0;
    for (int i = 0; i < count; ++i)
    {
        isChanged = isChanged || !isKept[i];
    }
    if (!isChanged || refuseShared(edits, collection))
    {
        return;
    }
    if (swIsInYamlBrackets(node) && count == 0 && expandEmptyList(edits, node, added, addedCount))
    {
        return;
    }
    if (swIsInYamlBrackets(node))
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
    bool isOpen = edits->places.size > 0 && !swIsYamlBreak(edits->places.text[edits->places.size - 1]);
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
    addEdit(edits, edits->places.size, edits->places.size, from);
}
