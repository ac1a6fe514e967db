// SPDX-License-Identifier: MIT
#pragma once

// Owns everything and orders it. Memory is allocated when something is created or changed, never in a step: a new wave
// system brings its tiles, a new view its layers. What a step leaves (the frame) stays valid until the next one, so
// waves that are replaced or removed stay alive in a list of retired ones until then.

#include <stdatomic.h>

#include "core/base/id_pool.h"
#include "core/base/stream.h"
#include "core/frame/frame.h"
#include "core/lod/stack.h"
#include "core/sim/foam.h"
#include "core/sim/whitecaps.h"
#include "core/waves/mode_mix.h"
#include "core/waves/wave_system_fields.h"
#include "core/waves/waves_fft.h"
#include "shared/limits.h"

// Fields of a tile on the CPU: displacement and its derivatives by time.
enum
{
    SW_TEXELS_DISPLACEMENT,
    SW_TEXELS_VELOCITY,
    SW_TEXELS_ACCELERATION,
    SW_TEXELS_COUNT
};

// The waves of one def: bands with their tiles, or free waves. All systems that ask for the same share one.
typedef struct swWaveSet
{
    struct swWaveSet* nextRetired;
    int useCount; // layers, and mixes made of it
    uint32_t version;
    uint64_t hash;       // of its waves at weight 1, or of what a mix is made from; part of digests
    uint64_t identity;   // the same and all else that decides what the set answers; by it saved sets are known
    swWaveSystemDef def; // its table and components are in `copies`
    void* copies;
    size_t copiesSize;

    int tileCount;
    float response[SW_LIMIT_RESOLUTION / 4 + 1];
    swBandModes bands[SW_SET_TILES];
    float* texels[SW_TEXELS_COUNT][SW_SET_TILES]; // NULL where a band has no energy, or the world no such field

    int waveCount;
    swFreeWave* waves; // at weight 1, longest first

    // Of a set that turns from one sea into another: what it is to be, and what its modes are mixed from.
    struct swWaveSet* to;
    swModeMix* mix;

    float weight; // of all systems and layers together, in this step
    int system;   // slot of the first of them
    bool isListed;
    bool isCounted; // in the wind's levels
} swWaveSet;

// A value that runs from one number to another over a time.
typedef struct swRamp
{
    float from, to;
    int64_t begin, length; // ticks
} swRamp;

// A system is a stack of layers: the sea that was asked for on top, below it those that fade out. Waves that share
// their phases never need a second layer: their set is a mix, whose share runs from 0 to 1.
typedef struct swWaveLayer
{
    swWaveSet* set;
    swRamp fade;   // weight, along a quarter of a sine so that energy stays
    swRamp share;  // of a mix
    bool isMixing; // the share runs to 1, and then the mix is over
    bool isShared; // the share is set from outside, by a replay
    float weight;  // the system's times the fade, in this step
} swWaveLayer;

#define SW_MAX_WAVE_LAYERS 4

// Farthest that a viewpoint may be from the host's origin, and the host's origin from the sea's, m.
#define SW_FARTHEST_VIEWPOINT 1e12
#define SW_FARTHEST_ORIGIN 1e9

typedef struct swWaveSystem
{
    int layerCount;
    swWaveLayer layers[SW_MAX_WAVE_LAYERS]; // newest last
    swRamp weight;
} swWaveSystem;

struct swView
{
    swWorld* world;
    swViewDef def;
    uint32_t version;
    swPos viewpoint; // in the sea: the host's place plus the world's origin
    swStack stack;
    swFoamClock foamState;
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

// Where a tile or a free wave of the frame comes from.
typedef struct swWaveSource
{
    swWaveSet* set;
    int index; // of its bands, or waves
} swWaveSource;

struct swWorld
{
    swHost host;          // the caller's
    swHost countedHost;   // the same with memory counted; everything but the world itself comes from it
    atomic_size_t memory; // bytes held; workers allocate too
    size_t memoryBudget;  // of bytes held while a saved world is read; 0: none
    atomic_bool isOverBudget;
    swWorldDef def;
    const swWaveKernels* kernels;

    double time;
    swPosXZ origin; // of the host's coordinates, in the sea

    swIdPool systemIds;
    swWaveSystem systems[SW_MAX_WAVE_SYSTEMS];
    swWaveSet* retired;
    float windLevels[SW_MAX_BANDS * SW_WIND_STEPS];
    swWhitecaps whitecaps;
    bool isTileListStale;
    bool isChanged;       // systems or weights are other ones than in the last step
    uint32_t rewindCount; // systems may have other waves than a replay gave them
    uint32_t version;     // grows with every wave set, list of tiles and view

    void* scratch; // one part a worker
    size_t scratchSize;

    swTile tiles[SW_MAX_TILES];
    swWaveSource tileSources[SW_MAX_TILES];
    swTilePair pairs[SW_MAX_TILES];
    int pairCount;
    swFreeWave waves[SW_MAX_FREE_WAVES];
    swWaveSource waveSources[SW_MAX_FREE_WAVES];

    swView* views[SW_MAX_VIEWS];
    int viewCount;
    swViewFrame viewFrames[SW_MAX_VIEWS];

    swFrame frame;
};

// world.c
swResult swMakeWorld(const swHost* host, const swWorldDef* def, const swWaveKernels* kernels, swWorld** world);
void swFreeWorld(swWorld* world);
// The world got no memory for something; SW_ERROR_LIMIT if that was because of its budget. A sentence in the log.
swResult swFailMemory(const swWorld* world, const char* what);

// wave_set.c
swResult swAcquireSet(swWorld* world, const swWaveSystemDef* def, swWaveSet** set); // one that is there, or a new one
swResult swMixSets(swWorld* world, swWaveSet* from, swWaveSet* to,
                   swWaveSet** mix); // SW_ERROR_UNSUPPORTED: phases differ
swResult swStreamMix(swWorld* world, swStream* stream, swWaveSet* to, swWaveSet** set); // a mix that becomes `to`
void swShareMix(swWaveSet* set, float share);
void swReleaseSet(swWorld* world, swWaveSet* set); // once unused, it goes with the next step
void swFreeRetiredSets(swWorld* world);

// system.c
swResult swAddSystem(swWorld* world, const swWaveSystemDef* def, swId* id);
void swRemoveSystem(swWorld* world, swId id);
swResult swChangeSystem(swWorld* world, swWaveSystem* system, const swWaveSystemDef* def, double seconds);
void swAdvanceSystems(swWorld* world); // layers and mixes to the frame's time, weights to sets
void swFreeAllSystems(swWorld* world);
void swRampWeight(swWorld* world, swWaveSystem* system, float weight, double seconds);
swResult swShowSet(swWorld* world, swWaveSystem* system, swWaveSet* set); // as the only layer, at once
void swShareLayer(swWorld* world, swWaveSystem* system, float share);     // of a mix that does not run by itself
const swWaveSystemDef* swGetSystemDef(const swWaveSystem* system);        // what was asked for last
float swGetRamp(const swRamp* ramp, int64_t ticks);
bool swIsRampOver(const swRamp* ramp, int64_t ticks);

// tile_list.c
void swListTiles(swWorld* world); // systems and weights to the frame's tiles and free waves

// What defs must hold; SW_ERROR_INVALID and a sentence in the log otherwise. Implemented beside the calls that take
// them.
extern const swFields swWorldFields;
swResult swCheckViewDef(const swWorld* world, const swViewDef* def);

// view.c
swResult swAddView(swWorld* world, const swViewDef* def, swView** view);
void swRemoveView(swView* view);
void swPlaceViews(swWorld* world, int64_t elapsedTicks); // viewpoints to the frame's views
void swStepLayers(swWorld* world);
swViewFrame* swFindViewFrame(const swView* view); // NULL before its first step

// step.c
void swStepWorld(swWorld* world, double dt);
void swStepWorldTo(swWorld* world, double time);

// Tiles and free waves of the world's systems, or of such as it may get; a sentence in the log if there are too many.
bool swIsWithinLimits(const swWorld* world, const swWaveSystem systems[SW_MAX_WAVE_SYSTEMS]);

// save.c
void swStreamWorldDef(swStream* stream, swWorldDef* def);
swResult swStreamState(swWorld* world, swStream* stream); // everything but the def
swResult swRewindState(swWorld* world, swStream* stream); // the same, read into a world that has all of the waves

// digest.c
uint64_t swHashWorld(const swWorld* world);
uint64_t swHashSet(const swWaveSet* set);
uint64_t swIdentifySet(const swWaveSet* set); // `hash` is there already
