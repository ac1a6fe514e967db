// SPDX-License-Identifier: MIT
#pragma once

// The inputs of a world as a step leaves them: flat arrays that queries, slices, moments and the GPU read alike. Made
// by core/input/inputs.c, anew only where something changed.

#include "seaway/input.h"
#include "shared/input.h"

// Where floors, levels and flows have changed of late: copies of those fields need not be made anew elsewhere.
#define SW_MAX_CHANGES 64

typedef struct swInputChange
{
    uint32_t version;  // of the set that came with it
    swPosXZ low, high; // in the sea; both ends belong to it
} swInputChange;

typedef struct swInputChanges
{
    uint32_t from; // the version since which all changes are known
    int count;
    swInputChange changes[SW_MAX_CHANGES]; // in the order of versions
} swInputChanges;

typedef struct swInputSet
{
    // Grows whenever records or nodes change, and with wordsVersion whenever words do: the GPU uploads by them.
    uint32_t version, wordsVersion;
    const swInputChanges* changes; // NULL of a moment
    int recordCount, nodeCount;
    const swInputRecord* records; // by field, then in the order in which they join; only those that are enabled
    const swInputNode* nodes;
    const float* const* words;           // [recordCount]: each record's data, NULL of those without
    const swInputFunctionFcn* functions; // [recordCount], NULL of other shapes; or NULL altogether
    void* const* contexts;               // likewise
    swInputRange ranges[SW_INPUT_FIELD_COUNT];
    float lowestLevel, highestLevel;      // of still water above sea level, m: no place has more or less
    float weightReach, displacementReach; // no weight of waves is larger, nor a displacement by inputs, m
    double time;                          // s, of values that change with time
    uint32_t ribbonSystems;               // bit of each wave system's slot of which some waves run along splines
    // The flow that is the same everywhere, m/s: it carries all waves alike, see swEvenFlow, and only what other flows
    // are beside it carries copies of them, if there are any.
    float evenX, evenZ;
    bool hasEvenFlow, hasOtherFlows;
    uint32_t localSystems; // bit of each wave system's slot whose waves have no weight where no input gives them one
} swInputSet;

// Whether all changes since a set of `version` are known: those with a later one.
static inline bool swKnowsChanges(const swInputSet* set, uint32_t version)
{
    return set != NULL && set->changes != NULL && (int32_t)(version - set->changes->from) >= 0;
}

static inline bool swIsLaterChange(const swInputChange* change, uint32_t version)
{
    return (int32_t)(change->version - version) > 0;
}

static inline bool swHasInputs(const swInputSet* set, int field)
{
    return set != NULL && set->ranges[field].recordCount > 0;
}
