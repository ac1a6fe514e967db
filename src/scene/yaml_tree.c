// SPDX-License-Identifier: MIT

#include "scene/yaml_tree.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "core/base/host.h"

static swTreeNode* getNodes(const swTree* tree)
{
    return tree->nodes.data;
}

int swAddTreeNode(swTree* tree, int parent, swTreeType type, const char* key)
{
    int index = (int)tree->nodes.count;
    swTreeNode* node = tree->isBroken ? NULL : swAppendItems(tree->host, &tree->nodes, 1, sizeof(swTreeNode));
    if (node == NULL)
    {
        tree->isBroken = true;
        return -1;
    }
    *node = (swTreeNode){.type = type, .key = key, .item = -1, .first = -1, .last = -1, .next = -1};
    if (parent >= 0)
    {
        swTreeNode* above = &getNodes(tree)[parent];
        if (above->last >= 0)
        {
            getNodes(tree)[above->last].next = index;
        }
        above->first = above->first < 0 ? index : above->first;
        above->last = index;
    }
    return index;
}

swTree swBeginTree(const swHost* host, swTreeType root)
{
    swTree tree = {.host = host};
    swAddTreeNode(&tree, -1, root, NULL);
    return tree;
}

void swFreeTree(swTree* tree)
{
    if (tree->host != NULL)
    {
        swFreeItems(tree->host, &tree->nodes, sizeof(swTreeNode));
        swFreeItems(tree->host, &tree->chars, 1);
    }
}

int swAddTreeText(swTree* tree, int parent, const char* key, const char* text, bool isDefault)
{
    size_t size = strlen(text) + 1, begin = tree->chars.count;
    int node = swAddTreeNode(tree, parent, SW_TREE_SCALAR, key);
    char* room = node >= 0 ? swAppendItems(tree->host, &tree->chars, size, 1) : NULL;
    if (room == NULL)
    {
        tree->isBroken = true;
        return -1;
    }
    memcpy(room, text, size);
    getNodes(tree)[node].text = begin;
    getNodes(tree)[node].isDefault = isDefault;
    return node;
}

void swSetTreeDefault(swTree* tree, int node, bool isDefault)
{
    if (node >= 0)
    {
        getNodes(tree)[node].isDefault = isDefault;
    }
}

void swSetTreeMain(swTree* tree, int node)
{
    if (node >= 0)
    {
        getNodes(tree)[node].isMain = true;
        getNodes(tree)[node].isDefault = false;
    }
}

void swSetTreeItem(swTree* tree, int node, int item, bool isLine)
{
    if (node >= 0)
    {
        getNodes(tree)[node].item = item;
        getNodes(tree)[node].isLine = isLine;
    }
}

void swSetTreeMatched(swTree* tree, int list)
{
    if (list >= 0)
    {
        getNodes(tree)[list].isMatched = true;
    }
}

const swTreeNode* swGetTreeNode(const swTree* tree, int node)
{
    return &getNodes(tree)[node];
}

const char* swGetTreeText(const swTree* tree, int node)
{
    return (const char*)tree->chars.data + getNodes(tree)[node].text;
}

int swFindTreeKey(const swTree* tree, int mapping, const char* key, size_t size)
{
    int child = mapping >= 0 ? swGetTreeNode(tree, mapping)->first : -1;
    for (; child >= 0; child = swGetTreeNode(tree, child)->next)
    {
        const char* other = swGetTreeNode(tree, child)->key;
        if (strlen(other) == size && memcmp(other, key, size) == 0)
        {
            return child;
        }
    }
    return -1;
}

bool swIsTreeDefault(const swTree* tree, int node)
{
    const swTreeNode* at = swGetTreeNode(tree, node);
    if (at->type == SW_TREE_SCALAR)
    {
        return at->isDefault;
    }
    bool isDefault = at->type == SW_TREE_MAPPING || at->first < 0 || at->isDefault;
    if (at->type == SW_TREE_LIST)
    {
        return isDefault;
    }
    for (int child = at->first; child >= 0 && isDefault; child = swGetTreeNode(tree, child)->next)
    {
        isDefault = swIsTreeDefault(tree, child);
    }
    return isDefault;
}

static bool hasAll(const swTree* a, int nodeA, const swTree* b, int nodeB, bool comparesValues)
{
    int child = swGetTreeNode(a, nodeA)->first;
    for (; child >= 0; child = swGetTreeNode(a, child)->next)
    {
        const char* key = swGetTreeNode(a, child)->key;
        int other = swFindTreeKey(b, nodeB, key, strlen(key));
        if (other < 0 ? !swIsTreeDefault(a, child) : comparesValues && !swAreTreesEqual(a, child, b, other))
        {
            return false;
        }
    }
    return true;
}

bool swAreTreesEqual(const swTree* a, int nodeA, const swTree* b, int nodeB)
{
    const swTreeNode *left = swGetTreeNode(a, nodeA), *right = swGetTreeNode(b, nodeB);
    if (left->type != right->type)
    {
        return false;
    }
    if (left->type == SW_TREE_SCALAR)
    {
        return strcmp(swGetTreeText(a, nodeA), swGetTreeText(b, nodeB)) == 0;
    }
    if (left->type == SW_TREE_MAPPING)
    {
        return hasAll(a, nodeA, b, nodeB, true) && hasAll(b, nodeB, a, nodeA, false);
    }
    int i = left->first, j = right->first;
    while (i >= 0 && j >= 0 && swAreTreesEqual(a, i, b, j))
    {
        i = swGetTreeNode(a, i)->next;
        j = swGetTreeNode(b, j)->next;
    }
    return i < 0 && j < 0;
}

static const char* findMissing(const swTree* a, int nodeA, const swTree* b, int nodeB)
{
    int child = swGetTreeNode(a, nodeA)->first;
    for (; child >= 0; child = swGetTreeNode(a, child)->next)
    {
        const char* key = swGetTreeNode(a, child)->key;
        int other = swFindTreeKey(b, nodeB, key, strlen(key));
        if (other < 0 ? !swIsTreeDefault(a, child) : !swAreTreesEqual(a, child, b, other))
        {
            const char* inner = other < 0 ? "" : swFindTreeDifference(a, child, b, other);
            return inner[0] != '\0' ? inner : key;
        }
    }
    return "";
}

const char* swFindTreeDifference(const swTree* a, int nodeA, const swTree* b, int nodeB)
{
    const swTreeNode *left = swGetTreeNode(a, nodeA), *right = swGetTreeNode(b, nodeB);
    if (left->type != right->type || left->type == SW_TREE_SCALAR)
    {
        return "";
    }
    if (left->type == SW_TREE_MAPPING)
    {
        const char* key = findMissing(a, nodeA, b, nodeB);
        return key[0] != '\0' ? key : findMissing(b, nodeB, a, nodeA);
    }
    int i = left->first, j = right->first;
    while (i >= 0 && j >= 0 && swAreTreesEqual(a, i, b, j))
    {
        i = swGetTreeNode(a, i)->next;
        j = swGetTreeNode(b, j)->next;
    }
    return i >= 0 && j >= 0 ? swFindTreeDifference(a, i, b, j) : "";
}

// ---- scalars ----

void swAddText(swTextBuffer* buffer, const char* text, size_t size)
{
    char* room = buffer->isBroken || size == 0 ? NULL : swAppendItems(buffer->host, &buffer->chars, size, 1);
    buffer->isBroken = buffer->isBroken || (room == NULL && size > 0);
    if (room != NULL)
    {
        memcpy(room, text, size);
    }
}

static void addWord(swTextBuffer* buffer, const char* word)
{
    swAddText(buffer, word, strlen(word));
}

void swAddSpaces(swTextBuffer* buffer, size_t count)
{
    for (; count > 0; --count)
    {
        swAddText(buffer, " ", 1);
    }
}

// Control characters, and what YAML takes for the end of a line or does not print: U+0085, U+2028, U+2029, U+FEFF and
// others are rare enough to be escaped with their neighbours.
static bool needsEscapes(const char* text)
{
    for (const unsigned char* c = (const unsigned char*)text; *c != 0; ++c)
    {
        bool isRare = (c[0] == 0xC2 && c[1] < 0xA0) || (c[0] == 0xE2 && c[1] == 0x80) || c[0] == 0xEF;
        if (*c < 0x20 || *c == 0x7F || isRare)
        {
            return true;
        }
    }
    return false;
}

static bool isPlain(const char* text, bool isInLine)
{
    size_t size = strlen(text);
    bool isNumber = text[0] == '-' && size > 1 && text[1] != ' ' && text[1] != '-';
    if (size == 0 || needsEscapes(text) || text[0] == ' ' || text[size - 1] == ' ' || text[size - 1] == ':' ||
        (strchr("-?:,[]{}#&*!|>'\"%@`=~<.", text[0]) != NULL && !isNumber) || strstr(text, ": ") != NULL ||
        strstr(text, " #") != NULL)
    {
        return false;
    }
    return !isInLine || strpbrk(text, ",[]{}:") == NULL;
}

static uint32_t decode(const unsigned char* c, int* size)
{
    *size = c[0] < 0x80 ? 1 : c[0] < 0xE0 ? 2 : c[0] < 0xF0 ? 3 : 4;
    uint32_t code = *size == 1 ? c[0] : c[0] & (0xFFu >> (*size + 1));
    for (int i = 1; i < *size && c[i] != 0; ++i)
    {
        code = code << 6 | (c[i] & 0x3Fu);
    }
    return code;
}

static void addEscaped(swTextBuffer* buffer, const char* text)
{
    addWord(buffer, "\"");
    for (const unsigned char* c = (const unsigned char*)text; *c != 0;)
    {
        int size = 1;
        uint32_t code = decode(c, &size);
        char escaped[16] = "";
        if (code == '"' || code == '\\')
        {
            snprintf(escaped, sizeof(escaped), "\\%c", (char)code);
        }
        else if (code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029 || code == 0xFEFF)
        {
            snprintf(escaped, sizeof(escaped), "\\u%04X", (unsigned)code);
        }
        if (escaped[0] != '\0')
        {
            addWord(buffer, escaped);
        }
        else
        {
            swAddText(buffer, (const char*)c, (size_t)size);
        }
        c += size;
    }
    addWord(buffer, "\"");
}

void swAddScalar(swTextBuffer* buffer, const char* text, swQuotes quotes, bool isInLine)
{
    if (quotes == SW_QUOTES_NONE && isPlain(text, isInLine))
    {
        addWord(buffer, text);
    }
    else if (quotes == SW_QUOTES_SINGLE && !needsEscapes(text))
    {
        addWord(buffer, "'");
        for (; *text != '\0'; ++text)
        {
            swAddText(buffer, text, 1);
            swAddText(buffer, "'", *text == '\'' ? 1 : 0);
        }
        addWord(buffer, "'");
    }
    else
    {
        addEscaped(buffer, text);
    }
}

// ---- what stands nowhere yet ----

void swAddTreeInLine(swTextBuffer* buffer, const swTree* tree, int node, bool withKey)
{
    const swTreeNode* at = swGetTreeNode(tree, node);
    if (withKey)
    {
        addWord(buffer, at->key);
        addWord(buffer, ": ");
    }
    if (at->type == SW_TREE_SCALAR)
    {
        swAddScalar(buffer, swGetTreeText(tree, node), SW_QUOTES_NONE, true);
        return;
    }
    bool isMapping = at->type == SW_TREE_MAPPING, isFirst = true;
    addWord(buffer, isMapping ? "{" : "[");
    for (int child = at->first; child >= 0; child = swGetTreeNode(tree, child)->next)
    {
        if (!isMapping || !swIsTreeDefault(tree, child))
        {
            addWord(buffer, isFirst ? "" : ", ");
            swAddTreeInLine(buffer, tree, child, isMapping);
            isFirst = false;
        }
    }
    addWord(buffer, isMapping ? "}" : "]");
}

// The pairs of a mapping; the first line is not indented.
static void addPairs(swTextBuffer* buffer, const swLayout* layout, const swTree* tree, int node, size_t indent)
{
    bool isFirst = true;
    int child = swGetTreeNode(tree, node)->first;
    for (; child >= 0; child = swGetTreeNode(tree, child)->next)
    {
        if (!swIsTreeDefault(tree, child))
        {
            swAddSpaces(buffer, isFirst ? 0 : indent);
            swAddTreePair(buffer, layout, tree, child, indent);
            isFirst = false;
        }
    }
    if (isFirst)
    {
        addWord(buffer, "{}");
        addWord(buffer, layout->lineEnd);
    }
}

void swAddTreePair(swTextBuffer* buffer, const swLayout* layout, const swTree* tree, int node, size_t indent)
{
    const swTreeNode* at = swGetTreeNode(tree, node);
    addWord(buffer, at->key);
    addWord(buffer, ":");
    if (at->type == SW_TREE_SCALAR || at->isLine || at->first < 0)
    {
        addWord(buffer, " ");
        if (at->type == SW_TREE_SCALAR)
        {
            swAddScalar(buffer, swGetTreeText(tree, node), SW_QUOTES_NONE, false);
        }
        else
        {
            swAddTreeInLine(buffer, tree, node, false);
        }
        addWord(buffer, layout->lineEnd);
        return;
    }
    addWord(buffer, layout->lineEnd);
    if (at->type == SW_TREE_MAPPING)
    {
        swAddSpaces(buffer, indent + layout->step);
        addPairs(buffer, layout, tree, node, indent + layout->step);
        return;
    }
    for (int child = at->first; child >= 0; child = swGetTreeNode(tree, child)->next)
    {
        swAddSpaces(buffer, indent + layout->step);
        swAddTreeItem(buffer, layout, tree, child, indent + layout->step);
    }
}

void swAddTreeItem(swTextBuffer* buffer, const swLayout* layout, const swTree* tree, int node, size_t indent)
{
    const swTreeNode* at = swGetTreeNode(tree, node);
    addWord(buffer, "- ");
    if (at->type == SW_TREE_SCALAR)
    {
        swAddScalar(buffer, swGetTreeText(tree, node), SW_QUOTES_NONE, false);
        addWord(buffer, layout->lineEnd);
    }
    else if (at->type == SW_TREE_LIST || at->isLine)
    {
        swAddTreeInLine(buffer, tree, node, false);
        addWord(buffer, layout->lineEnd);
    }
    else
    {
        addPairs(buffer, layout, tree, node, indent + 2);
    }
}
