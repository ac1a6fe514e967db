// SPDX-License-Identifier: MIT
#pragma once

// What the water is like at a place, before any wave is added up: functions of position and time that shape the waves
// or lie under them. Whoever makes a query sets those that there are. With none, each wave is the same everywhere.
//
// Fields that shape waves (depth, weight, warp, flow) are read where particles rest. A field that describes a place
// (level) is read where particles are. Gradients are exact derivatives of the values, per metre along x and z: they end
// up in normals and in J.

#include "core/waves/waves_fft.h"

// Points whose places are found together. Few, because everything about them lies on the stack.
#define SW_PLACE_BLOCK 32

// Fields of swPlaces, as bits.
#define SW_TOUCHES_LEVEL 1u
#define SW_TOUCHES_DEPTH 2u
#define SW_TOUCHES_WEIGHT 4u
#define SW_TOUCHES_WARP 8u
#define SW_TOUCHES_FLOW 16u
#define SW_TOUCHES_ALL 31u

// The fields that may say something within `reach` metres of some of the points. Cheap, and on the safe side.
typedef uint32_t swFindTouched(const void* context, int64_t ticks, int count, const swPosXZ* points, double reach);

// Values at points in the sea, and their gradients. `system` is that of the waves in question, of `level` and `depth`
// -1.
typedef void swFindField(const void* context, int system, int64_t ticks, int count, const swPosXZ* points,
                         float* values, float (*gradients)[2]);

// Velocity of the water along x and z, m/s. Gradients are those of its x along x and z, then of its z.
typedef void swFindFlow(const void* context, int64_t ticks, int count, const swPosXZ* points, float (*velocities)[2],
                        float (*gradients)[4]);

// Most sets of coordinates that a system has at a point beside the sea's, such as along and across splines.
#define SW_MAX_WARPS 2

// Coordinates of a system's own: where its waves are looked up once more for a point, and how much of them counts.
typedef struct swWarp
{
    float weight;
    float alongX, alongZ; // of the weight
    swPosXZ source;
    float gradients[4]; // of source - point: of its x along x and z, then of its z
    float cosine, sine; // of the angle by which the own x axis is turned from the sea's x axis towards z
    float turnX, turnZ; // gradient of that angle, rad/m
} swWarp;

// How many of `warps` say something at any of the points; where one does not, its weight is 0 and its source is the
// point.
typedef int swFindWarps(const void* context, int system, int64_t ticks, int count, const swPosXZ* points,
                        swWarp (*warps)[SW_PLACE_BLOCK]);

typedef struct swWaveGroup swWaveGroup;

// The share of their amplitude that waves of a group keep over depths of 0 and more, and the derivative of that by the
// depth, which does not count where the depth is 0. Grows with the depth, and from half a wavelength on is exactly 1.
// All arrays have room for SW_PLACE_BLOCK, and so many depths are numbers.
typedef void swAttenuate(const void* context, const swWaveKernels* kernels, const swWaveGroup* group, int count,
                         const float* depths, float* shares, float* slopes);

// Each may be NULL.
typedef struct swPlaces
{
    const void* context;
    uint32_t localSystems;  // as bits: their weight is 0 where none is found, of the others it is 1
    swFindTouched* touched; // NULL: each field may say something everywhere
    swFindField* level;     // of still water above sea level, m
    swFindField* depth;     // of still water, m; with `attenuate`
    swFindField* weight;    // of each system's waves
    swFindWarps* warps;     // of each system's waves, beside those of `weight`
    swFindFlow* flow;       // carries waves, beside what carries all of them alike, see swEvenFlow
    swFindFlow* water;      // how the water moves, all of it; NULL: by `flow`
    swAttenuate* attenuate; // of waves of an octave by a wave number in its middle
} swPlaces;

// Waves of an octave that are shaped alike: a tile, or free waves.
struct swWaveGroup
{
    int system;
    float k;            // in its middle, rad/m
    const swTile* tile; // or NULL, and
    int waveCount;
    const swFreeWave* waves;
};

// Where waves are looked up, and how much of them counts.
typedef struct swCopy
{
    const swWarp* warps; // by which sideways displacement is turned, or NULL
    swPosXZ source[SW_PLACE_BLOCK];
    bool hasWay;
    float way[SW_PLACE_BLOCK][4]; // gradients of source - rest, where there are any
    float weight[SW_PLACE_BLOCK];
    float alongX[SW_PLACE_BLOCK], alongZ[SW_PLACE_BLOCK]; // of the weight
} swCopy;

// Waves as they lie in the sea's coordinates or in a warp's: two copies where a flow carries them.
typedef struct swLook
{
    int copyCount;
    swCopy copies[2];
} swLook;

// Begin with the points (at most SW_PLACE_BLOCK), then ask for one look after another.
typedef struct swPlaceBlock
{
    const swPlaces* places;
    const swWaveKernels* kernels;
    int64_t ticks;
    int count;
    swPosXZ rest[SW_PLACE_BLOCK];
    bool areAllAsked, isAsked[SW_PLACE_BLOCK];
    uint32_t touched;
    float depth[SW_PLACE_BLOCK];
    float depthGradients[SW_PLACE_BLOCK][2];
    const void* sharedWaves; // the group of waves of which the depth's shares were found last
    bool isShared;           // it takes some of them
    float share[SW_PLACE_BLOCK], shareSlope[SW_PLACE_BLOCK];
    bool isMoving[SW_PLACE_BLOCK]; // where the block has a flow: not still, or not all around
    float flow[SW_PLACE_BLOCK][2];
    float flowGradients[SW_PLACE_BLOCK][4];
    // Of a system that was asked about last.
    int system;
    bool isGone, isWeighted; // of the waves without warps
    int warpCount;
    float weight[SW_PLACE_BLOCK];
    float weightGradients[SW_PLACE_BLOCK][2];
    swWarp (*warps)[SW_PLACE_BLOCK];
} swPlaceBlock;

// `warps` is room for SW_MAX_WARPS, needed where places have any and kept as long as the block.
void swBeginPlaces(swPlaceBlock* block, const swPlaces* places, swWarp (*warps)[SW_PLACE_BLOCK],
                   const swWaveKernels* kernels, int64_t ticks, int count, const swPosXZ* rest);

// Take the points of a block a few metres on, by the tangents of what is there: for guesses. Not of places with warps.
void swMovePlaces(swPlaceBlock* block, const swPosXZ* rest);

// Fields that may say something at any number of points.
uint32_t swFindTouchedFields(const swPlaces* places, int64_t ticks, int count, const swPosXZ* points, double reach);

// Whether all waves of a group are as they would be with no places; a group that is nowhere near is not.
bool swIsGroupPlain(swPlaceBlock* block, const swWaveGroup* group);
// Leave isPlain[] of points where they are, and set it to false of all others. Returns whether it is still true of any.
bool swKeepPlainPoints(swPlaceBlock* block, const swWaveGroup* group, bool* isPlain);
// Looks count only points that are asked for; at first they are all.
void swAskPoints(swPlaceBlock* block, const bool* isAsked);
// Looks at a group of waves: plainly, unless none are there so, and by each warp. One by one, to spare the stack.
// Without slopes the gradients of places and weights are not found.
int swCountLooks(swPlaceBlock* block, const swWaveGroup* group);
void swFindLook(swPlaceBlock* block, const swWaveGroup* group, int index, bool withSlopes, swLook* look);

// Free waves from the first on that are shaped alike.
swWaveGroup swGroupFreeWaves(int count, const swFreeWave* waves);
swWaveGroup swGroupTile(const swTile* tile);

// Levels where particles are, and, where there are gradients of the surface by rest position, the level's part added to
// them. `places` may be NULL: levels are 0.
void swFindLevels(const swPlaces* places, int64_t ticks, int count, const swPosXZ* rest, float (*displacement)[4],
                  float* levels, float (*gradients)[8]);

// Velocity of the flow at points, added to that of the waves. `places` may be NULL.
void swAddFlow(const swPlaces* places, int64_t ticks, int count, const swPosXZ* points, float (*velocities)[4]);
