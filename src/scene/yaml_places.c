// SPDX-License-Identifier: MIT
// libyaml's marks are exact for scalars and for what is in brackets; a collection of lines has its end mark at the next
// token, beyond comments, so its end is that of its last value.

#include "scene/yaml_places.h"

#include <stdint.h>
#include <string.h>

yaml_node_t* swGetYamlNodeAt(const swYamlPlaces* places, int node)
{
    return yaml_document_get_node(&places->yaml->document, node);
}

bool swIsYamlBreak(char c)
{
    return c == '\n' || c == '\r';
}

bool swIsYamlSpace(char c)
{
    return c == ' ' || c == '\t';
}

int swCountYamlChildren(const yaml_node_t* node)
{
    return node->type == YAML_SEQUENCE_NODE  ? (int)(node->data.sequence.items.top - node->data.sequence.items.start)
           : node->type == YAML_MAPPING_NODE ? (int)(node->data.mapping.pairs.top - node->data.mapping.pairs.start)
                                             : 0;
}

int swGetYamlChild(const yaml_node_t* node, int index)
{
    return node->type == YAML_SEQUENCE_NODE ? node->data.sequence.items.start[index]
                                            : node->data.mapping.pairs.start[index].value;
}

static size_t skipMark(const char* text, size_t size)
{
    return size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
}

static swResult findBytes(swYamlPlaces* places)
{
    size_t begin = skipMark(places->text, places->size);
    uint32_t* bytes = swAppendItems(places->yaml->host, &places->bytes, places->size - begin + 1, sizeof(uint32_t));
    if (bytes == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    size_t count = 0;
    for (size_t i = begin; i < places->size; ++i)
    {
        if (((unsigned char)places->text[i] & 0xC0) != 0x80)
        {
            bytes[count++] = (uint32_t)i;
        }
    }
    bytes[count++] = (uint32_t)places->size;
    places->bytes.count = count;
    return SW_SUCCESS;
}

// How often each node is used, twice if what holds it is. A node stands before what it holds.
static swResult countShares(swYamlPlaces* places)
{
    yaml_document_t* document = &places->yaml->document;
    int count = (int)(document->nodes.top - document->nodes.start);
    int* shares = swAppendItems(places->yaml->host, &places->shares, (size_t)count + 1, sizeof(int));
    if (shares == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    memset(shares, 0, ((size_t)count + 1) * sizeof(int));
    for (int i = 1; i <= count; ++i)
    {
        const yaml_node_t* node = swGetYamlNodeAt(places, i);
        for (int j = 0; j < swCountYamlChildren(node); ++j)
        {
            shares[swGetYamlChild(node, j)] += shares[i] > 1 ? 2 : 1;
        }
    }
    return SW_SUCCESS;
}

size_t swFindYamlByte(const swYamlPlaces* places, yaml_mark_t mark)
{
    const uint32_t* bytes = places->bytes.data;
    return bytes[mark.index < places->bytes.count ? mark.index : places->bytes.count - 1];
}

// Behind anchors and tags.
size_t swFindYamlBegin(const swYamlPlaces* places, const yaml_node_t* node)
{
    size_t at = swFindYamlByte(places, node->start_mark), end = swFindYamlByte(places, node->end_mark);
    while (at < end && (places->text[at] == '&' || places->text[at] == '!'))
    {
        while (at < end && !swIsYamlSpace(places->text[at]) && !swIsYamlBreak(places->text[at]))
        {
            ++at;
        }
        while (at < end && (swIsYamlSpace(places->text[at]) || swIsYamlBreak(places->text[at])))
        {
            ++at;
        }
    }
    return at;
}

bool swIsInYamlBrackets(const yaml_node_t* node)
{
    return node->type == YAML_SEQUENCE_NODE  ? node->data.sequence.style == YAML_FLOW_SEQUENCE_STYLE
           : node->type == YAML_MAPPING_NODE ? node->data.mapping.style == YAML_FLOW_MAPPING_STYLE
                                             : false;
}

size_t swFindYamlChildBegin(const swYamlPlaces* places, const yaml_node_t* node, int index)
{
    int child = node->type == YAML_SEQUENCE_NODE ? node->data.sequence.items.start[index]
                                                 : node->data.mapping.pairs.start[index].key;
    return swFindYamlByte(places, swGetYamlNodeAt(places, child)->start_mark);
}

// Behind the last character of a value.
size_t swFindYamlEnd(const swYamlPlaces* places, const yaml_node_t* node)
{
    while (node->type != YAML_SCALAR_NODE && !swIsInYamlBrackets(node) && swCountYamlChildren(node) > 0)
    {
        node = swGetYamlNodeAt(places, swGetYamlChild(node, swCountYamlChildren(node) - 1));
    }
    size_t end = swFindYamlByte(places, node->end_mark), begin = swFindYamlByte(places, node->start_mark);
    while (end > begin && (swIsYamlBreak(places->text[end - 1]) || swIsYamlSpace(places->text[end - 1])))
    {
        --end; // of a text in lines of its own, behind | or >
    }
    return end;
}

size_t swFindYamlLine(const swYamlPlaces* places, size_t at)
{
    size_t least = skipMark(places->text, places->size);
    while (at > least && !swIsYamlBreak(places->text[at - 1]))
    {
        --at;
    }
    return at;
}

size_t swFindNextYamlLine(const swYamlPlaces* places, size_t at)
{
    while (at < places->size && !swIsYamlBreak(places->text[at]))
    {
        ++at;
    }
    if (at + 1 < places->size && places->text[at] == '\r' && places->text[at + 1] == '\n')
    {
        ++at;
    }
    return at < places->size ? at + 1 : at;
}

bool swIsYamlShared(const swYamlPlaces* places, int node)
{
    const yaml_node_t* at = swGetYamlNodeAt(places, node);
    bool isShared = ((const int*)places->shares.data)[node] > 1;
    for (int i = 0; i < swCountYamlChildren(at) && !isShared; ++i)
    {
        isShared = swIsYamlShared(places, swGetYamlChild(at, i));
    }
    return isShared;
}

// The line ends of the text, and how far its sections are indented.
swLayout swFindYamlLayout(const swYamlPlaces* places)
{
    swLayout layout = {"\n", 2};
    for (size_t i = 0; i < places->size; ++i)
    {
        if (swIsYamlBreak(places->text[i]))
        {
            bool isPair = places->text[i] == '\r' && i + 1 < places->size && places->text[i + 1] == '\n';
            layout.lineEnd = isPair ? "\r\n" : places->text[i] == '\r' ? "\r" : "\n";
            break;
        }
    }
    const yaml_node_t* root = yaml_document_get_root_node(&places->yaml->document);
    if (root == NULL || root->type != YAML_MAPPING_NODE)
    {
        return layout;
    }
    for (yaml_node_pair_t* pair = root->data.mapping.pairs.start; pair < root->data.mapping.pairs.top; ++pair)
    {
        const yaml_node_t* value = swGetYamlNodeAt(places, pair->value);
        if (value->type == YAML_MAPPING_NODE && value->data.mapping.style != YAML_FLOW_MAPPING_STYLE &&
            value->start_mark.column > 0 && value->start_mark.column <= 8)
        {
            layout.step = value->start_mark.column;
            break;
        }
    }
    return layout;
}

// Where the dash before an item stands: on its line, or on one before it that holds nothing else but a comment.
bool swFindYamlDash(const swYamlPlaces* places, size_t item, size_t* dash)
{
    size_t line = swFindYamlLine(places, item), end = item;
    for (;;)
    {
        size_t at = line;
        while (at < end && places->text[at] == ' ')
        {
            ++at;
        }
        bool isEmpty = at == end || places->text[at] == '#' || swIsYamlBreak(places->text[at]);
        if (!isEmpty)
        {
            size_t next = at + 1;
            while (next < end && swIsYamlSpace(places->text[next]))
            {
                ++next;
            }
            *dash = at;
            return places->text[at] == '-' &&
                   (next == end || places->text[next] == '#' || swIsYamlBreak(places->text[next]));
        }
        if (line <= skipMark(places->text, places->size))
        {
            return false;
        }
        end = line;
        line = swFindYamlLine(
            places, line - (line >= 2 && places->text[line - 1] == '\n' && places->text[line - 2] == '\r' ? 2 : 1));
    }
}

// Nothing but spaces before, nothing but a comment behind.
bool swStandsAlone(const swYamlPlaces* places, size_t begin, size_t end)
{
    for (size_t i = swFindYamlLine(places, begin); i < begin; ++i)
    {
        if (places->text[i] != ' ')
        {
            return false;
        }
    }
    while (end < places->size && swIsYamlSpace(places->text[end]))
    {
        ++end;
    }
    return end >= places->size || swIsYamlBreak(places->text[end]) || places->text[end] == '#';
}

// Whether a line of its own between two places is a comment. One behind a value goes with it.
bool swHasYamlComment(const swYamlPlaces* places, size_t begin, size_t end)
{
    for (size_t at = swFindNextYamlLine(places, begin); at < end; at = swFindNextYamlLine(places, at))
    {
        size_t first = at;
        while (first < end && swIsYamlSpace(places->text[first]))
        {
            ++first;
        }
        if (first < end && places->text[first] == '#')
        {
            return true;
        }
    }
    return false;
}

// Whether the sections of a text are parted by empty lines.
bool swHasYamlGaps(const swYamlPlaces* places, const yaml_node_t* node)
{
    if (node != yaml_document_get_root_node(&places->yaml->document) || swCountYamlChildren(node) < 2)
    {
        return false;
    }
    for (int i = swCountYamlChildren(node) - 1; i > 0; --i)
    {
        const yaml_node_t* value = swGetYamlNodeAt(places, swGetYamlChild(node, i));
        size_t line = swFindYamlLine(places, swFindYamlChildBegin(places, node, i));
        if (value->type != YAML_SCALAR_NODE && line >= 2)
        {
            return swIsYamlBreak(places->text[line - 2]) && (places->text[line - 2] == places->text[line - 1] ||
                                                             (line >= 3 && swIsYamlBreak(places->text[line - 3])));
        }
    }
    return false;
}

// The mapping whose value a collection is, and the key; NULL of what is no value.
const yaml_node_t* swFindYamlParent(const swYamlPlaces* places, const yaml_node_t* collection, const yaml_node_t** key)
{
    yaml_document_t* document = &places->yaml->document;
    for (const yaml_node_t* node = document->nodes.start; node < document->nodes.top; ++node)
    {
        for (int i = 0; node->type == YAML_MAPPING_NODE && i < swCountYamlChildren(node); ++i)
        {
            if (swGetYamlNodeAt(places, swGetYamlChild(node, i)) == collection)
            {
                *key = swGetYamlNodeAt(places, node->data.mapping.pairs.start[i].key);
                return node;
            }
        }
    }
    return NULL;
}

// Behind the colon of a key.
size_t swFindYamlValue(const swYamlPlaces* places, const yaml_node_t* key)
{
    size_t at = swFindYamlByte(places, key->end_mark);
    const char* colon = memchr(places->text + at, ':', places->size - at);
    return colon != NULL ? (size_t)(colon - places->text) + 1 : at;
}

swResult swBeginYamlPlaces(swYaml* yaml, const char* text, size_t size, swYamlPlaces* places)
{
    *places = (swYamlPlaces){.yaml = yaml, .text = text, .size = size};
    swResult result = findBytes(places);
    result = result == SW_SUCCESS ? countShares(places) : result;
    return result == SW_SUCCESS ? result : swFail(yaml->host, result, "No memory to write %s.", yaml->name);
}

void swEndYamlPlaces(swYamlPlaces* places)
{
    swFreeItems(places->yaml->host, &places->bytes, sizeof(uint32_t));
    swFreeItems(places->yaml->host, &places->shares, sizeof(int));
}
