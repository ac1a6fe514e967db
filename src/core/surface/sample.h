// SPDX-License-Identifier: MIT
#pragma once

// The surface above points of the horizontal plane: find the particle that is there, then say where it is. See
// sample.c.

#include <math.h>

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
} swQuery;

// Whether a tile of the query's has waves of at least the shortest length that was asked for.
static inline bool swIsTileAsked(const swQuery* query, const swTile* tile)
{
    return swIsTileChosen(tile, query->def->minWavelength);
}

void swBeginQuery(swQuery* query, const swFrame* frame, const swWaveKernels* kernels, const swQueryDef* def,
                  swPosXZ origin);

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

// What the search for the particles above a block of points found.
typedef struct swFound
{
    swPosXZ rest[SW_QUERY_BLOCK]; // in the sea
    float displacement[SW_QUERY_BLOCK][4];
    float residual[SW_QUERY_BLOCK];
    int evaluations;
} swFound;

// Find the particles above at most SW_QUERY_BLOCK points in the sea.
void swFindParticles(const swQuery* query, int count, const swPosXZ* points, swFound* found);

// NaN, for what cannot be answered.
#define SW_NO_NUMBER ((float)NAN)
#define SW_NO_VECTOR ((swVec3){SW_NO_NUMBER, SW_NO_NUMBER, SW_NO_NUMBER})

// Where a point of the host's is in the sea. False for one that cannot be answered: NaN, infinite or too far out.
bool swPlacePoint(const swQuery* query, double x, double z, swPosXZ* place);

// Add a block's search to a batch's.
void swCountFound(swQueryStats* stats, const swFound* found, int count, float tolerance);

// The upward unit normal of gradients as swEvaluation has them; the underside of a fold is turned over.
swVec3 swMakeNormal(const float gradients[8], float* jacobian);

// Every point of a query that is refused as a whole is bad.
void swRefuseSurface(int count, const swSurfaceSamples* samples, swVec2* slopes, swQueryStats* stats);
void swRefuseStats(int count, swQueryStats* stats);

void swQuerySurface(const swQuery* query, int count, const swPosXZ* points, const swSurfaceSamples* samples,
                    swQueryStats* stats);
void swQueryParticles(const swQuery* query, int count, const swPosXZ* points, const swSurfaceSamples* samples,
                      swVec2* slopes, swQueryStats* stats);
void swQueryHeightMap(const swQuery* query, const swHeightMapDef* map, float* heights, swQueryStats* stats);
