// SPDX-License-Identifier: MIT
#include "core/world/moment_inputs.h"

#include <string.h>

#define ALIGNMENT 64

typedef struct Stored
{
    uint64_t size; // of all
    uint32_t recordSize, nodeSize;
    int32_t recordCount, nodeCount;
    swInputRange ranges[SW_INPUT_FIELD_COUNT];
    float lowestLevel, highestLevel, weightReach, displacementReach;
    uint32_t localSystems, ribbonSystems, unused;
    double time;
} Stored;

static size_t roundUp(size_t size)
{
    return (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
}

static size_t getHeadSize(int recordCount, int nodeCount)
{
    return roundUp(sizeof(Stored)) + roundUp((size_t)recordCount * sizeof(swInputRecord)) +
           roundUp((size_t)nodeCount * sizeof(swInputNode));
}

static size_t getWordsSize(size_t count)
{
    return roundUp(count * sizeof(float));
}

size_t swFindStoredInputsSize(const swInputs* inputs)
{
    size_t size =
        inputs->count > 0 ? getHeadSize(inputs->count, SW_INDEX_NODES(inputs->count)) : roundUp(sizeof(Stored));
    for (int i = 0; i < inputs->count; ++i)
    {
        int count = 0;
        const swInputData* data = swGetInputAt(inputs, i)->data;
        swGetInputWords(data, &count);
        size += getWordsSize((size_t)count);
    }
    return size;
}

size_t swGetStoredInputsSize(const swInputSet* set)
{
    size_t size = getHeadSize(set->recordCount, set->nodeCount);
    for (int i = 0; i < set->recordCount; ++i)
    {
        size += getWordsSize(set->records[i].wordCount);
    }
    return size;
}

// A set without inputs has no arrays, and memcpy() wants one.
static void copy(void* to, const void* from, size_t size)
{
    if (size > 0)
    {
        memcpy(to, from, size);
    }
}

// Returns the place behind the copied bytes.
static char* store(char* at, const void* bytes, size_t size)
{
    copy(at, bytes, size);
    return at + roundUp(size);
}

static const char* fetch(const char* at, void* bytes, size_t size)
{
    copy(bytes, at, size);
    return at + roundUp(size);
}

void swStoreInputs(swInputArrays* arrays, void* place)
{
    const swInputSet* set = &arrays->set;
    Stored head = {
        .size = swGetStoredInputsSize(set),
        .recordSize = sizeof(swInputRecord),
        .nodeSize = sizeof(swInputNode),
        .recordCount = set->recordCount,
        .nodeCount = set->nodeCount,
        .lowestLevel = set->lowestLevel,
        .highestLevel = set->highestLevel,
        .weightReach = set->weightReach,
        .displacementReach = set->displacementReach,
        .localSystems = set->localSystems,
        .ribbonSystems = set->ribbonSystems,
        .time = set->time,
    };
    memcpy(head.ranges, set->ranges, sizeof head.ranges);
    char* at = place;
    memcpy(at, &head, sizeof head);
    at += roundUp(sizeof head);
    at = store(at, set->records, (size_t)set->recordCount * sizeof(swInputRecord));
    at = store(at, set->nodes, (size_t)set->nodeCount * sizeof(swInputNode));
    for (int i = 0; i < set->recordCount; ++i)
    {
        size_t count = set->records[i].wordCount;
        if (count > 0)
        {
            arrays->words[i] = memcpy(at, arrays->words[i], count * sizeof(float));
        }
        at += getWordsSize(count);
    }
}

// ---- reading ----

static bool areNodesGood(const swInputNode* nodes, const swInputRange* range)
{
    uint32_t end = range->firstNode + range->nodeCount;
    for (uint32_t i = range->firstNode; i < end; ++i)
    {
        const swInputNode* node = &nodes[i];
        // A leaf names one record of its field, three times: a search that goes on behind it comes to an end.
        bool isLeaf = node->record != SW_NO_RECORD;
        bool isRecord = node->record >= range->firstRecord && node->record - range->firstRecord < range->recordCount &&
                        node->firstRecord == node->record && node->lastRecord == node->record;
        if (node->skip <= i || node->skip > end || (isLeaf && !isRecord))
        {
            return false;
        }
    }
    return true;
}

static bool areRangesGood(const Stored* head, const swInputRecord* records, const swInputNode* nodes)
{
    for (int field = 0; field < SW_INPUT_FIELD_COUNT; ++field)
    {
        const swInputRange* range = &head->ranges[field];
        uint32_t recordCount = (uint32_t)head->recordCount, nodeCount = (uint32_t)head->nodeCount;
        if (range->firstRecord > recordCount || range->recordCount > recordCount - range->firstRecord ||
            range->firstNode > nodeCount || range->nodeCount > nodeCount - range->firstNode ||
            !areNodesGood(nodes, range))
        {
            return false;
        }
        for (uint32_t i = range->firstRecord; i < range->firstRecord + range->recordCount; ++i)
        {
            if (records[i].field != (sw_uint)field)
            {
                return false;
            }
        }
    }
    return true;
}

bool swCheckStoredInputs(const void* place, size_t size, int* recordCount)
{
    Stored head;
    if (size < sizeof head)
    {
        return false;
    }
    memcpy(&head, place, sizeof head);
    bool isFine = head.size <= size && head.recordSize == sizeof(swInputRecord) &&
                  head.nodeSize == sizeof(swInputNode) && head.recordCount >= 0 && head.recordCount <= SW_MAX_INPUTS &&
                  head.nodeCount >= 0 && head.nodeCount <= SW_INDEX_NODES(SW_MAX_INPUTS) &&
                  getHeadSize(head.recordCount, head.nodeCount) <= head.size;
    if (!isFine)
    {
        return false;
    }
    const swInputRecord* records = (const void*)((const char*)place + roundUp(sizeof head));
    const swInputNode* nodes =
        (const void*)((const char*)records + roundUp((size_t)head.recordCount * sizeof(swInputRecord)));
    size_t used = getHeadSize(head.recordCount, head.nodeCount);
    for (int i = 0; i < head.recordCount; ++i)
    {
        size_t words = getWordsSize(records[i].wordCount);
        const float* first = (const void*)((const char*)place + used);
        if (words > head.size - used || !swIsInputRecordGood(&records[i], first))
        {
            return false;
        }
        used += words;
    }
    *recordCount = head.recordCount;
    return areRangesGood(&head, records, nodes);
}

void swMapStoredInputs(const void* place, swInputArrays* arrays)
{
    Stored head;
    memcpy(&head, place, sizeof head);
    const char* at = (const char*)place + roundUp(sizeof head);
    swInputSet* set = &arrays->set;
    at = fetch(at, arrays->records, (size_t)head.recordCount * sizeof(swInputRecord));
    at = fetch(at, arrays->nodes, (size_t)head.nodeCount * sizeof(swInputNode));
    for (int i = 0; i < head.recordCount; ++i)
    {
        arrays->words[i] = arrays->records[i].wordCount > 0 ? (const float*)(const void*)at : NULL;
        at += getWordsSize(arrays->records[i].wordCount);
    }
    memcpy(set->ranges, head.ranges, sizeof head.ranges);
    set->recordCount = head.recordCount;
    set->nodeCount = head.nodeCount;
    set->lowestLevel = head.lowestLevel;
    set->highestLevel = head.highestLevel;
    set->weightReach = head.weightReach;
    set->displacementReach = head.displacementReach;
    set->localSystems = head.localSystems;
    set->ribbonSystems = head.ribbonSystems;
    set->time = head.time;
    swFindSetFlow(set);
}
