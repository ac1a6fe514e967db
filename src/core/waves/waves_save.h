// SPDX-License-Identifier: MIT
#pragma once

// Waves as bytes, read or written by the same functions. See waves_save.c.

#include "core/base/stream.h"
#include "core/waves/waves.h"

#define SW_MAX_SETS (2 * SW_MAX_WAVE_SYSTEMS * SW_MAX_WAVE_PARTS)

typedef struct swSetList
{
    int count;
    swWaveSet* sets[SW_MAX_SETS];
    int tileCount; // of all that were read
} swSetList;

// Every set of all parts, and what mixes become ahead of the mixes.
void swListSets(const swWaves* waves, swSetList* list);

// Sets that are read belong to the list until they are released.
swResult swStreamSets(swWaves* waves, swStream* stream, swSetList* list);

// The sets of a stream among those that there are. SW_ERROR_UNSUPPORTED if one is not.
swResult swFindSets(const swWaves* waves, swStream* stream, swSetList* found);

// Parts that are read do not yet count as users of their sets.
void swStreamSystem(swStream* stream, const swSetList* list, swWaveSystem* system);
void swUseLayers(const swWaveSystem systems[SW_MAX_WAVE_SYSTEMS]);
void swUnuseLayers(swWaves* waves, const swWaveSystem systems[SW_MAX_WAVE_SYSTEMS]);
