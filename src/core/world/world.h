// SPDX-License-Identifier: MIT
#pragma once

// Owns everything and orders it. Memory is allocated when something is created, never in a step: a new wave system brings
// its tiles, a new view its layers. What a step leaves (the frame) stays valid until the next one, so a wave system that
// is destroyed or gets another spectrum keeps its old bands alive in a list of retired ones until then.

#include <stdatomic.h>

#include "core/base/id_pool.h"
#include "core/frame/frame.h"
#include "core/lod/stack.h"
#include "core/sim/foam.h"
#include "core/waves/waves_fft.h"

// The bands of one spectrum, and their tiles.
typedef struct swBandSet
{
    struct swBandSet* nextRetired;
    uint32_t version;
    int resolution;
    int tileCount;
    swBandModes bands[SW_MAX_BANDS];
    float* texels[SW_MAX_BANDS]; // NULL where a band has no energy, and without queries
} swBandSet;

typedef struct swWaveSystem
{
    swWaveSystemDef def; // its table is not kept
    swBandSet* set;
} swWaveSystem;

struct swView
{
    swWorld* world;
    swViewDef def;
    uint32_t version;
    swPos viewpoint;
    swStack stack;
    swFoamState foamState;
    float* displacement; // NULL without CPU layers
    float* derivatives;
    float* foam[2];
    int foamIndex; // of the foam that is current
};

// Two tiles that are transformed together; second is -1 for a single one.
typedef struct swTilePair
{
    int first, second;
} swTilePair;

struct swWorld
{
    swHost host;          // the caller's
    swHost countedHost;   // the same with memory counted; everything but the world itself comes from it
    atomic_size_t memory; // bytes held; workers allocate too
    swWorldDef def;
    const swWaveKernels* kernels;

    double time;
    bool hasStepped;

    swIdPool systemIds;
    swWaveSystem systems[SW_MAX_WAVE_SYSTEMS];
    swBandSet* retired;
    bool isTileListStale;
    uint32_t version; // grows with every band set, list of tiles and view

    void* scratch; // one part a worker
    size_t scratchSize;

    swTile tiles[SW_MAX_TILES];
    float* tileTexels[SW_MAX_TILES];
    swTilePair pairs[SW_MAX_TILES];
    int pairCount;

    swView* views[SW_MAX_VIEWS];
    int viewCount;
    swViewFrame viewFrames[SW_MAX_VIEWS];

    swFrame frame;
};

// world.c
swResult swMakeWorld(const swHost* host, const swWorldDef* def, const swWaveKernels* kernels, swWorld** world);
void swFreeWorld(swWorld* world);

// system.c
swResult swAddSystem(swWorld* world, const swWaveSystemDef* def, swId* id);
void swRemoveSystem(swWorld* world, swId id);
swResult swReplaceSpectrum(swWorld* world, swWaveSystem* system, const swSpectrumDef* spectrum);
void swFreeRetiredSets(swWorld* world);
void swFreeAllSystems(swWorld* world);
void swListTiles(swWorld* world); // systems and weights to the frame's tiles

// view.c
swResult swAddView(swWorld* world, const swViewDef* def, swView** view);
void swRemoveView(swView* view);
void swPlaceViews(swWorld* world, int64_t elapsedTicks); // viewpoints to the frame's views
void swStepLayers(swWorld* world);
swViewFrame* swFindViewFrame(const swView* view); // NULL before its first step

// step.c
void swStepWorld(swWorld* world, double dt);

// digest.c
uint64_t swHashWorld(const swWorld* world);
