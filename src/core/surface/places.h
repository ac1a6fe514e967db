// SPDX-License-Identifier: MIT
#pragma once

// What the water is like at a place, before any wave is added up: functions of position and time that shape the waves
// or lie under them. Whoever makes a query sets those that there are. With none, each wave is the same everywhere.
//
// Fields that shape waves (depth, weight, warp) are read where particles rest. A field that describes a place (level)
// is read where particles are. Gradients are exact derivatives of the values, per metre along x and z: they end up in
// normals and in J.

#include "core/waves/waves_fft.h"

// Values at points in the sea, and their gradients. `system` is that of the waves in question, of `level` and `depth`
// -1.
typedef void swFindField(const void* context, int system, int64_t ticks, int count, const swPosXZ* points,
                         float* values, float (*gradients)[2]);

// How far the waves at points have been carried there: a wave at x is the one that would be at x + way without.
// Gradients are those of the way's x along x and z, then of its z.
typedef void swFindWarp(const void* context, int system, int64_t ticks, int count, const swPosXZ* points,
                        float (*ways)[2], float (*gradients)[4]);

// The share of its amplitude that a wave keeps where k times the depth is `kd`, and the derivative of that by kd.
typedef float swAttenuate(float kd, float* slope);

// Each may be NULL.
typedef struct swPlaces
{
    const void* context;
    swFindField* level;     // of still water above sea level, m
    swFindField* depth;     // of still water, m; with `attenuate`
    swFindField* weight;    // of each system's waves
    swFindWarp* warp;       // of each system's waves
    swAttenuate* attenuate; // of a tile by a wave number in its middle, of a free wave by its own
} swPlaces;

// Points whose places are found together. Few, because everything about them lies on the stack.
#define SW_PLACE_BLOCK 16

// What shapes waves at some points.
typedef struct swShape
{
    float weight[SW_PLACE_BLOCK];
    float alongX[SW_PLACE_BLOCK], alongZ[SW_PLACE_BLOCK]; // of the weight
    swPosXZ source[SW_PLACE_BLOCK];                       // where the waves are looked up
    float warp[SW_PLACE_BLOCK][4];                        // gradients of the way there
} swShape;

// Begin with the points (at most SW_PLACE_BLOCK), then ask for one shape after another.
typedef struct swPlaceBlock
{
    const swPlaces* places;
    int64_t ticks;
    int count;
    const swPosXZ* rest;
    float depth[SW_PLACE_BLOCK];
    float depthGradients[SW_PLACE_BLOCK][2];
    int system; // that `shape` was found for, without attenuation
    swShape shape;
} swPlaceBlock;

void swBeginPlaces(swPlaceBlock* block, const swPlaces* places, int64_t ticks, int count, const swPosXZ* rest);

// For waves of a system with wave number k, rad/m.
void swFindShape(swPlaceBlock* block, int system, float k, swShape* shape);

// Levels where particles are, and, where there are gradients of the surface by rest position, the level's part added to
// them. `places` may be NULL: levels are 0.
void swFindLevels(const swPlaces* places, int64_t ticks, int count, const swPosXZ* rest, float (*displacement)[4],
                  float* levels, float (*gradients)[8]);
