// SPDX-License-Identifier: MIT
#pragma once

// The sum of the water: where particles of the surface are that rest at given points, how the surface stands there and
// how they move. Tiles first, then free waves.

#include "core/waves/waves_fft.h"
#include "core/waves/waves_sum.h"
#include "seaway/query.h"

// Points worked on together; everything about a block lives on the stack.
#define SW_QUERY_BLOCK 64

// The waves that count for a query, and how to add them up.
typedef struct swQuery
{
    const swWaveKernels* kernels;
    const swQueryDef* def;
    swPosXZ origin; // of the caller's coordinates, in the sea
    double seaLevel;
    int64_t ticks;
    bool isNow; // the tiles' texels are of that time
    int waveCount;
    const swFreeWave* waves;
    int tileCount;
    const swTile* tiles; // of the frame; see swIsTileAsked()
    int64_t tileTicks;   // of their texels

    // A later frame, or NULL: up to its time the surface runs linearly from the one's to the other's.
    const swFrame* after;
} swQuery;

// Whether a tile of the query's has waves of at least the shortest length that was asked for.
static inline bool swIsTileAsked(const swQuery* query, const swTile* tile)
{
    return swIsTileChosen(tile, query->def->minWavelength);
}

void swBeginQuery(swQuery* query, const swFrame* frame, const swWaveKernels* kernels, const swQueryDef* def,
                  swPosXZ origin);
void swBlendQuery(swQuery* query, const swFrame* after);

// What is asked of a block of rest points (in the sea). What is not asked for is NULL; gradients come with
// displacement.
typedef struct swEvaluation
{
    float (*displacement)[4];
    float (*gradients)[8];
    float (*velocity)[4];
    float (*acceleration)[4];
} swEvaluation;

// At most SW_QUERY_BLOCK points.
void swEvaluate(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out);

// The upward unit normal of gradients as swEvaluation has them; the underside of a fold is turned over.
swVec3 swMakeNormal(const float gradients[8], float* jacobian);
