// SPDX-License-Identifier: MIT
#pragma once

// What a YAML text shall say: a tree of keys and values, and how it is written where nothing stands yet.

#include <stdbool.h>
#include <stddef.h>

#include "core/base/array.h"

typedef enum swTreeType
{
    SW_TREE_SCALAR,
    SW_TREE_LIST,
    SW_TREE_MAPPING
} swTreeType;

// Nodes are indices; -1 is none.
typedef struct swTreeNode
{
    swTreeType type;
    const char* key; // of a mapping's value; outlives the tree
    size_t text;     // scalar: where in `chars` its text begins, ended by a zero
    bool isDefault;  // scalar, list: a text without it says the same, so it need not be written
    bool isMain;     // what a mapping is about: it takes the place of the main value that it replaces
    bool isLine;     // written in one line, as in {a: 1, b: 2}
    bool isMatched;  // list: which of the text's items each is shows in what they say
    int item;        // of a list's item: which of the text's list it is, from 0 on; -1: new
    int first, last, next;
} swTreeNode;

// The root is node 0. Once memory has run out, functions do nothing, and isBroken says so.
typedef struct swTree
{
    const swHost* host;
    swArray nodes, chars;
    bool isBroken;
} swTree;

swTree swBeginTree(const swHost* host, swTreeType root);
void swFreeTree(swTree* tree);

// -1 if there is no memory.
int swAddTreeNode(swTree* tree, int parent, swTreeType type, const char* key);
int swAddTreeText(swTree* tree, int parent, const char* key, const char* text, bool isDefault);

// What a node is beside its value, see swTreeNode. Node -1 is passed over.
void swSetTreeDefault(swTree* tree, int node, bool isDefault);
void swSetTreeMain(swTree* tree, int node);
void swSetTreeItem(swTree* tree, int node, int item, bool isLine);
void swSetTreeMatched(swTree* tree, int list);

const swTreeNode* swGetTreeNode(const swTree* tree, int node);
const char* swGetTreeText(const swTree* tree, int node);
int swFindTreeKey(const swTree* tree, int mapping, const char* key, size_t size);

// Nothing in it has to be written.
bool swIsTreeDefault(const swTree* tree, int node);

// Whether two say the same: what only one of them has must be a default. Items are compared in order.
bool swAreTreesEqual(const swTree* a, int nodeA, const swTree* b, int nodeB);

// The innermost key at which two differ.
const char* swFindTreeDifference(const swTree* a, int nodeA, const swTree* b, int nodeB);

// ---- text ----

// Text that grows; isBroken once memory has run out.
typedef struct swTextBuffer
{
    const swHost* host;
    swArray chars;
    bool isBroken;
} swTextBuffer;

void swAddText(swTextBuffer* buffer, const char* text, size_t size);
void swAddSpaces(swTextBuffer* buffer, size_t count);

// How a scalar stands in a text.
typedef enum swQuotes
{
    SW_QUOTES_NONE, // double ones all the same where it needs some
    SW_QUOTES_SINGLE,
    SW_QUOTES_DOUBLE
} swQuotes;

void swAddScalar(swTextBuffer* buffer, const char* text, swQuotes quotes, bool isInLine);

// How new lines are written.
typedef struct swLayout
{
    const char* lineEnd;
    size_t step; // of indentation
} swLayout;

// "a: 1" and what lies below it, one line each with its line end. The first line is not indented.
void swAddTreePair(swTextBuffer* buffer, const swLayout* layout, const swTree* tree, int node, size_t indent);

// "- a: 1" likewise; `indent` is that of the dash.
void swAddTreeItem(swTextBuffer* buffer, const swLayout* layout, const swTree* tree, int node, size_t indent);

// The same within a line, without its end: "a: 1", "{a: 1, b: 2}".
void swAddTreeInLine(swTextBuffer* buffer, const swTree* tree, int node, bool withKey);
