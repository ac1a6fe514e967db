// SPDX-License-Identifier: MIT
#pragma once

// The index of a set's records: for each field a tree of boxes of cells, in depth-first order. See input_index.c.

#include "core/frame/input_set.h"

// A box of cells, both ends belong to it.
typedef struct swCellBox
{
    int32_t minX, minZ, maxX, maxZ;
} swCellBox;

// A record on its way into the tree.
typedef struct swIndexItem
{
    uint64_t key; // by which neighbours come together
    uint32_t record;
    swCellBox box;
} swIndexItem;

// Nodes of `count` records at most.
#define SW_INDEX_NODES(count) (2 * (count))

// Make the trees of all fields. `boxes` are those of the set's records; `items` and `scratch` have room for as many,
// `nodes` for SW_INDEX_NODES of them. Returns how many nodes there are.
int swBuildInputIndex(swInputSet* set, const swCellBox* boxes, swIndexItem* items, swIndexItem* scratch,
                      swInputNode* nodes);

// The least record of a field that is at least `from` and whose box meets `box`; SW_NO_RECORD if there is none.
uint32_t swFindNextInput(const swInputSet* set, int field, const swCellBox* box, uint32_t from);

// Whether any record of the fields in `mask` (a bit each) meets a box.
bool swTouchesInputs(const swInputSet* set, uint32_t mask, const swCellBox* box);

// Records of a field that meet a box, in ascending order. Returns how many there are; only the first `room` are there.
int swCollectInputs(const swInputSet* set, int field, const swCellBox* box, uint32_t* records, int room);
