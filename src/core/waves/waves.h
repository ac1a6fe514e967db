// SPDX-License-Identifier: MIT
#pragma once

// The waves of a world: its systems, the sets of waves that they are made of, how they change, and the tiles and free
// waves that a frame has of them. Memory is allocated when a system is made or changed, never in a step. What a frame
// names stays valid until the next one, so sets that are replaced or removed stay in a list of retired ones until then.

#include "core/base/memory.h"
#include "core/base/stream.h"
#include "core/frame/frame.h"
#include "core/waves/mode_mix.h"
#include "core/waves/ramp.h"
#include "core/waves/tile_list.h"
#include "core/waves/wave_def.h"
#include "core/waves/waves_fft.h"
#include "shared/limits.h"

// The waves of one def: bands with their tiles, or free waves. All systems that ask for the same share one.
struct swWaveSet
{
    struct swWaveSet* nextRetired;
    int useCount; // parts, and mixes made of it
    uint32_t version;
    uint32_t likenessVersion; // for which the texels of likeness were made
    uint64_t hash;            // of its waves at weight 1, or of what a mix is made from; part of digests
    uint64_t identity;        // the same and all else that decides what the set answers; by it saved sets are known
    swWaveSystemDef def;      // its table and components are in `copies`
    swDrift drift;
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
    swAttenuation attenuationBefore; // of what a mix is made from, at its share 0
};

// When a replay shows the pair of records that a part is made of.
typedef struct swRecordClock
{
    bool isRunning;
    double startTime, startSeconds, speed; // seconds of records at a time of the world
    double first, last;                    // of the pair; infinite before the first record and after the last
} swRecordClock;

// A system is a stack of parts: the sea that was asked for on top, below it those that fade out. Waves that share
// their phases never need a second part: their set is a mix, whose share runs from 0 to 1.
typedef struct swWavePart
{
    swWaveSet* set;
    swRamp fade;           // weight, along a quarter of a sine so that energy stays
    swRamp share;          // of a mix
    bool isMixing;         // the share runs to 1, and then the mix is over
    bool isShared;         // the share is set from outside, by a replay
    swRecordClock records; // of a part that a replay shows
} swWavePart;

// Of a system that takes the world's wind: what its def says of its own.
typedef struct swOwnWind
{
    bool isReplaced;
    bool isKnown; // swSpectrumDef::hasWind
    float speed, direction;
} swOwnWind;

typedef struct swWaveSystem
{
    int partCount;                       // 0: the slot is empty
    swWavePart parts[SW_MAX_WAVE_PARTS]; // newest last
    swRamp weight;
    swOwnWind own;
} swWaveSystem;

typedef struct swWaves
{
    swMemory* memory;
    const swWaveKernels* kernels;
    float gravity, surfaceTension;
    bool hasTexels[SW_TEXELS_COUNT];

    int64_t ticks; // of the last step, from where changes begin
    swWaveSystem systems[SW_MAX_WAVE_SYSTEMS];
    swWaveSet* retired;
    bool isTileListStale;
    bool isChanged;       // systems or weights are other ones than in the last step
    uint32_t rewindCount; // systems may have other waves than a replay gave them
    uint32_t version;     // grows with every set and list of tiles

    void* scratch; // one part a worker
    size_t scratchSize;

    swTileList list; // of the last step
    int listedCount;
    swWaveSet* listed[SW_MAX_SHOWN_SETS];
} swWaves;

// waves.c
void swBeginWaves(swWaves* waves, swMemory* memory, const swWaveKernels* kernels, const swWorldDef* def);
void swEndWaves(swWaves* waves);
// What has a past: changes that are over by a time end. Nothing that a frame names is touched.
void swAdvanceWaves(swWaves* waves, int64_t ticks);
// The frame's tiles, free waves and wind, of the time that the systems are at; then spectra to texels.
void swDeriveWaves(swWaves* waves, swFrame* frame);
void swTransformWaves(swWaves* waves);
// What is seen at any time, past or future, by the changes that are under way.
void swFindShown(const swWaves* waves, double time, int64_t ticks, swShown* shown);

// Whether the core makes texels at all: without queries of its own only the likeness that the GPU wants.
static inline bool swHasAnyTexels(const swWaves* waves)
{
    return waves->hasTexels[SW_TEXELS_DISPLACEMENT] || waves->hasTexels[SW_TEXELS_LIKENESS];
}

// From now on tiles have their likeness: a flow that varies may carry the waves.
swResult swCarryWaves(swWaves* waves);

// wave_set.c
bool swAllocateTexels(swWaves* waves, swWaveSet* set); // those that it lacks, and scratch to make them
// One that is there, or a new one. A local system shares its waves with no other, since places weigh them apart: of
// such only those of the system at `slot` itself are taken; -1: a new one.
swResult swAcquireSet(swWaves* waves, int slot, const swWaveSystemDef* def, const swDrift* drift, swWaveSet** set);
// Of a set that nobody else uses.
void swTurnSet(swWaves* waves, swWaveSet* set, const swWaveSystemDef* def, const swDrift* drift);
swResult swMixSets(swWaves* waves, swWaveSet* from, float share, swWaveSet* to,
                   swWaveSet** mix); // SW_ERROR_UNSUPPORTED: phases differ
swResult swStreamMix(swWaves* waves, swStream* stream, swWaveSet* to, swWaveSet** set); // a mix that becomes `to`
void swShareMix(swWaveSet* set, float share);
swAttenuation swGetSetAttenuation(const swWaveSet* set, float share); // the share counts of a mix
void swReleaseSet(swWaves* waves, swWaveSet* set);                    // once unused, it goes with the next step
void swFreeRetiredSets(swWaves* waves);

// wave_system.c; systems are known by their slots.
swResult swAddSystem(swWaves* waves, int slot, const swWaveSystemDef* def);
void swRemoveSystem(swWaves* waves, int slot);
swResult swChangeSystem(swWaves* waves, int slot, const swWaveSystemDef* def, double seconds);
void swAdvanceSystems(swWaves* waves); // changes that are over end
void swFreeAllSystems(swWaves* waves);
void swRampWeight(swWaves* waves, int slot, float weight, double seconds);
swResult swShowSet(swWaves* waves, int slot, swWaveSet* set);                          // as the only part, at once
void swSharePart(swWaves* waves, int slot, float share, const swRecordClock* records); // by a replay
void swStopRecords(swWaves* waves, int slot); // a replay leaves the system as it is
// How the waves of a system are carried on under a def that it gets now.
swDrift swPlanDrift(const swWaves* waves, int slot, const swWaveSystemDef* def, double seconds);
const swWaveSystemDef* swGetSystemDef(const swWaveSystem* system); // what was asked for last
// Tiles and free waves of some systems; a sentence in the log if there are too many.
bool swIsWithinLimits(const swWaves* waves, const swWaveSystem systems[SW_MAX_WAVE_SYSTEMS]);

// wind_of_waves.c
float swFindWindOfWaves(const swWaves* waves, const swShown* shown);

// wave_hash.c
uint64_t swHashSet(const swWaveSet* set);
uint64_t swIdentifySet(const swWaveSet* set); // `hash` is there already
void swAddHashSystem(swHash* hash, const swWaveSystem* system, int64_t ticks);
void swAddHashFreeWave(swHash* hash, const swFreeWave* wave);
