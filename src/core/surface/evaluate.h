// SPDX-License-Identifier: MIT
#pragma once

// The sum of the water: where particles of the surface are that rest at given points, how the surface stands there and
// how they move. For a block of points first what their places are like (places.h), then tiles, then free waves.
// Queries of any time and slices all add up here. The GPU's twins are shaders/query/surface_search.glsl and
// shaders/waves/slices.comp and slices_shaped.comp.

#include "core/surface/places.h"
#include "core/waves/waves_sum.h"
#include "seaway/query.h"

// Points worked on together; everything about a block lives on the stack.
#define SW_QUERY_BLOCK 64

// The waves that count for a query, and how to add them up.
typedef struct swQuery
{
    const swWaveKernels* kernels;
    const swQueryDef* def;
    const swPlaces* places;   // NULL: waves are the same everywhere
    const swInputSet* inputs; // of the frame, or NULL
    swPlaces inputPlaces;     // of the frame's inputs; `places` points to it unless a caller has others
    swPosXZ origin;           // of the caller's coordinates, in the sea
    double seaLevel;
    int64_t ticks;
    bool isNow; // the tiles' texels are of that time
    int waveCount;
    const swFreeWave* waves;
    int tileCount;
    const swTile* tiles;             // of the frame; see swIsTileAsked()
    int64_t tileTicks;               // of their texels
    float lowestLevel, highestLevel; // of still water above sea level, m, wherever it is
    const swInputSet* clip;          // inputs that cut holes, NULL if there are none
    float sideways;                  // root mean square of the particles' horizontal displacement, m
    float longestFelt; // of tiles that displace by a tolerance's tenth or more, the longest wave, m; 0: none do

    // A later frame, or NULL: up to its time the surface runs linearly from the one's to the other's.
    const swFrame* after;
} swQuery;

// Whether a tile of the query's has waves of at least the shortest length that was asked for.
static inline bool swIsTileAsked(const swQuery* query, const swTile* tile)
{
    return swIsTileChosen(tile, query->def->minWavelength, 0.0f);
}

void swBeginQuery(swQuery* query, const swFrame* frame, const swWaveKernels* kernels, const swQueryDef* def,
                  swPosXZ origin);
void swBlendQuery(swQuery* query, const swFrame* after);

// What is asked of a block of rest points (in the sea). What is not asked for is NULL; gradients come with
// displacement, and so do levels.
typedef struct swEvaluation
{
    float (*displacement)[4]; // by waves
    float* levels;            // of still water above sea level
    float (*gradients)[8];    // as swSampleTiles() has them; with the level's slope where levels are asked for. The
                              // seventh is dDx/dz - dDz/dx: 0 where waves lie as they would anywhere
    float (*velocity)[4];
    float (*acceleration)[4];
    bool withHeights;        // inputs that stay put change heights, as they do where levels are asked for
    float shortest, longest; // only waves between, m: tiles by their longest, see swTileChoice; 0 is no bound
    swPlaceBlock* places;    // for a guess: of the points a few metres away, to be moved here by its tangents; or NULL
} swEvaluation;

// At most SW_QUERY_BLOCK points. Points of one z whose x ascend are a row of a grid, and cheaper, for the same bits.
void swEvaluate(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out);

// The upward unit normal of gradients as swEvaluation has them; the underside of a fold is turned over.
swVec3 swMakeNormal(const float gradients[8], float* jacobian);
