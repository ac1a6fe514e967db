// SPDX-License-Identifier: MIT
#pragma once

// The water at one time, as queries see it, and moments with memory of their own. See moment.c.

#include "core/frame/frame.h"
#include "core/input/inputs.h"
#include "core/waves/waves.h"
#include "seaway/moment.h"

// Farthest that the host's origin may be from the sea's, m.
#define SW_FARTHEST_ORIGIN 1e9

// All that queries look at.
struct swMoment
{
    const swHost* host; // for messages
    const swWaveKernels* kernels;
    const swFrame* frame;
    const swPosXZ* origin; // of the host's coordinates, in the sea
    bool isHeld;
    bool isOwn; // an swOwnMoment; else it is part of a world
};

typedef struct swOwnMoment
{
    swMoment moment;
    swHost host; // copied: the world may go
    swFrame frame;
    swPosXZ origin;

    void* memory; // the block
    size_t memorySize;
    size_t usedSize;
    bool isAllocated; // by the moment
    bool isMapped;    // and only read

    swInputArrays inputs; // its words are in the block
    swEvenFlow evenFlow;

    void* scratch;
    size_t scratchSize;
    swBandModes bands[SW_SET_TILES]; // of the set that is being listed
    swTileList list;
} swOwnMoment;

// At most so many bytes, whatever the time.
size_t swFindMomentSize(const swWaves* waves, const swInputs* inputs);

// What a moment is made of. `frame` is the world's, for all but the waves and the time.
typedef struct swMomentSource
{
    const swHost* host;
    const swWaves* waves;
    const swInputs* inputs;
    const swFrame* frame;
    swPosXZ origin;
    uint32_t localSystems; // see swInputSet
} swMomentSource;

swResult swMakeMoment(const swMomentSource* source, const swMomentDef* def, swOwnMoment** moment);
swResult swSetMoment(swOwnMoment* moment, const swMomentSource* source, double time);
swResult swMapMomentBlock(const swHost* host, const void* memory, size_t size, swOwnMoment** moment);
void swFreeMoment(swOwnMoment* moment);
// Bring the hash of a block's head up to date.
void swSignMoment(void* block);
