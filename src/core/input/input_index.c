// SPDX-License-Identifier: MIT
// Trees of boxes. Records are sorted along a curve that keeps neighbours together and halved again and
// again. What is everywhere stands before the tree, so that it makes no other box larger. Which records are found
// depends on their boxes alone, never on the tree's form.

#include "core/input/input_index.h"

#include <string.h>

static uint64_t spread(uint32_t x)
{
    uint64_t v = x;
    v = (v | v << 16) & 0x0000ffff0000ffffull;
    v = (v | v << 8) & 0x00ff00ff00ff00ffull;
    v = (v | v << 4) & 0x0f0f0f0f0f0f0f0full;
    v = (v | v << 2) & 0x3333333333333333ull;
    return (v | v << 1) & 0x5555555555555555ull;
}

static uint64_t makeKey(const swCellBox* box)
{
    int64_t x = ((int64_t)box->minX + box->maxX) / 2;
    int64_t z = ((int64_t)box->minZ + box->maxZ) / 2;
    return spread((uint32_t)(x + INT32_MAX)) | spread((uint32_t)(z + INT32_MAX)) << 1;
}

static bool isBefore(const swIndexItem* a, const swIndexItem* b)
{
    return a->key < b->key || (a->key == b->key && a->record < b->record);
}

// Merge sort: stable, and without memory of its own.
static void sortItems(swIndexItem* items, swIndexItem* scratch, int count)
{
    for (int width = 1; width < count; width *= 2)
    {
        for (int first = 0; first < count; first += 2 * width)
        {
            int middle = first + width < count ? first + width : count;
            int end = middle + width < count ? middle + width : count;
            int a = first, b = middle;
            for (int at = first; at < end; ++at)
            {
                bool takesA = a < middle && (b >= end || !isBefore(&items[b], &items[a]));
                scratch[at] = takesA ? items[a++] : items[b++];
            }
        }
        memcpy(items, scratch, (size_t)count * sizeof *items);
    }
}

static void growNode(swInputNode* node, const swInputNode* by)
{
    node->minX = by->minX < node->minX ? by->minX : node->minX;
    node->minZ = by->minZ < node->minZ ? by->minZ : node->minZ;
    node->maxX = by->maxX > node->maxX ? by->maxX : node->maxX;
    node->maxZ = by->maxZ > node->maxZ ? by->maxZ : node->maxZ;
    node->firstRecord = by->firstRecord < node->firstRecord ? by->firstRecord : node->firstRecord;
    node->lastRecord = by->lastRecord > node->lastRecord ? by->lastRecord : node->lastRecord;
}

// The nodes of [first, end) from node `at` on; returns the node after them. As deep as the count has bits.
static int buildNodes(const swIndexItem* items, int first, int end, swInputNode* nodes, int at)
{
    if (end - first == 1)
    {
        const swIndexItem* item = &items[first];
        nodes[at] = (swInputNode){item->box.minX,   item->box.minZ, item->box.maxX, item->box.maxZ,
                                  (uint32_t)at + 1, item->record,   item->record,   item->record};
        return at + 1;
    }
    int middle = first + (end - first) / 2;
    int right = buildNodes(items, first, middle, nodes, at + 1);
    int after = buildNodes(items, middle, end, nodes, right);
    nodes[at] = nodes[at + 1];
    growNode(&nodes[at], &nodes[right]);
    nodes[at].skip = (uint32_t)after;
    nodes[at].record = SW_NO_RECORD;
    return after;
}

static int buildField(const swInputSet* set, const swInputRange* range, const swCellBox* boxes, swIndexItem* items,
                      swIndexItem* scratch, swInputNode* nodes, int at)
{
    int count = 0;
    for (uint32_t i = 0; i < range->recordCount; ++i)
    {
        uint32_t record = range->firstRecord + i;
        swIndexItem item = {makeKey(&boxes[record]), record, boxes[record]};
        if ((set->records[record].flags & SW_INPUT_IS_BOUNDLESS) != 0)
        {
            at = buildNodes(&item, 0, 1, nodes, at);
            continue;
        }
        items[count++] = item;
    }
    sortItems(items, scratch, count);
    return count > 0 ? buildNodes(items, 0, count, nodes, at) : at;
}

int swBuildInputIndex(swInputSet* set, const swCellBox* boxes, swIndexItem* items, swIndexItem* scratch,
                      swInputNode* nodes)
{
    int at = 0;
    for (int field = 0; field < SW_INPUT_FIELD_COUNT; ++field)
    {
        swInputRange* range = &set->ranges[field];
        range->firstNode = (uint32_t)at;
        at = buildField(set, range, boxes, items, scratch, nodes, at);
        range->nodeCount = (uint32_t)at - range->firstNode;
    }
    return at;
}

static bool isMet(const swInputNode* node, const swCellBox* box)
{
    return node->minX <= box->maxX && node->maxX >= box->minX && node->minZ <= box->maxZ && node->maxZ >= box->minZ;
}

uint32_t swFindNextInput(const swInputSet* set, int field, const swCellBox* box, uint32_t from)
{
    const swInputRange* range = &set->ranges[field];
    uint32_t end = range->firstNode + range->nodeCount;
    uint32_t best = SW_NO_RECORD;
    for (uint32_t at = range->firstNode; at < end;)
    {
        const swInputNode* node = &set->nodes[at];
        if (node->lastRecord < from || node->firstRecord >= best || !isMet(node, box))
        {
            at = node->skip;
            continue;
        }
        if (node->record != SW_NO_RECORD)
        {
            best = node->record;
        }
        at += 1;
    }
    return best;
}

static bool touchesField(const swInputSet* set, const swInputRange* range, const swCellBox* box)
{
    uint32_t end = range->firstNode + range->nodeCount;
    for (uint32_t at = range->firstNode; at < end;)
    {
        const swInputNode* node = &set->nodes[at];
        if (!isMet(node, box))
        {
            at = node->skip;
            continue;
        }
        if (node->record != SW_NO_RECORD)
        {
            return true;
        }
        at += 1;
    }
    return false;
}

bool swTouchesInputs(const swInputSet* set, uint32_t mask, const swCellBox* box)
{
    for (int field = 0; field < SW_INPUT_FIELD_COUNT; ++field)
    {
        if ((mask >> field & 1) != 0 && touchesField(set, &set->ranges[field], box))
        {
            return true;
        }
    }
    return false;
}

int swCollectInputs(const swInputSet* set, int field, const swCellBox* box, uint32_t* records, int room)
{
    const swInputRange* range = &set->ranges[field];
    uint32_t end = range->firstNode + range->nodeCount;
    int count = 0;
    for (uint32_t at = range->firstNode; at < end;)
    {
        const swInputNode* node = &set->nodes[at];
        if (!isMet(node, box))
        {
            at = node->skip;
            continue;
        }
        if (node->record != SW_NO_RECORD)
        {
            int place = count < room ? count : room - 1;
            bool keeps = count < room || node->record < records[room - 1];
            for (; keeps && place > 0 && records[place - 1] > node->record; --place)
            {
                records[place] = records[place - 1];
            }
            if (keeps)
            {
                records[place] = node->record;
            }
            count += 1;
        }
        at += 1;
    }
    return count;
}
