// SPDX-License-Identifier: MIT
#pragma once

// Waves summed one by one: exact at any time and depth, some hundred times slower than a tile. What tiles are held
// against, and what answers where there are none: other times than the last step's, the water below, and free waves.

#include "core/frame/frame.h"

// The tables of one instruction set, see waves_fft.h.
typedef struct swWaveKernels swWaveKernels;

// The surface at points, added to what is there: arrays of as many elements as points, or NULL.
typedef struct swSurfaceSums
{
    float (*displacement)[4]; // x, y, z, 0
    float (*gradients)[8];    // dDx/dx, dDx/dz, dDz/dx, dDz/dz, dh/dx, dh/dz, 0, 0
    float (*velocity)[4];     // of the particle: x, y, z, 0
    float (*acceleration)[4];
} swSurfaceSums;

// The water below by linear theory [Dean and Dalrymple 1991], added to what is there.
typedef struct swDepthSums
{
    float (*velocity)[4];     // x, y, z, 0
    float (*acceleration)[4]; // local, of the fluid at the place
    float* head;              // dynamic pressure over density and gravity, m
} swDepthSums;

typedef struct swWaveSumJob
{
    int tileCount;
    const swTile* tiles;     // their modes; texels are not read
    float shortest, longest; // tiles whose longest wave is in (shortest, longest] count, m; 0 is no bound
    int waveCount;
    const swFreeWave* waves;
    int64_t ticks;
    int count;
    const swPosXZ* points; // at rest

    // m above the resting water, for `below`. Above 0 counts as 0, below a wave's bottom as its bottom. Waves that are
    // too short to reach a height are left out of its sums; to minus infinity none reaches.
    const float* heights;

    // One of them; the other is NULL.
    const swSurfaceSums* surface;
    const swDepthSums* below;
} swWaveSumJob;

// Order of summation: waves in order in eight interleaved sums, which are added at the end.
void swSumWaves(const swWaveKernels* kernels, const swWaveSumJob* job);

// Waves that have faded to exp(-20) do not count.
#define SW_FADED 20.0f

// Waves of at most this length are too short to reach a height, m.
static inline float swGetFadedWavelength(float height)
{
    return -height * 6.2831853f / SW_FADED;
}

// Where a height counts for waves over a bottom.
static inline float swClampHeight(float height, float depth)
{
    float below = height < 0.0f ? height : 0.0f;
    return below > -depth ? below : -depth;
}
