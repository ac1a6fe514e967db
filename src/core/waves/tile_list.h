// SPDX-License-Identifier: MIT
#pragma once

// What is seen of a world's waves at a time: sets with their weights, and their tiles and free waves. See tile_list.c.

#include "core/waves/waves_fft.h"

typedef struct swWaveSet swWaveSet;

#define SW_MAX_WAVE_PARTS 4
#define SW_MAX_SHOWN_SETS (SW_MAX_WAVE_SYSTEMS * SW_MAX_WAVE_PARTS)

// Fields of a tile on the CPU: displacement and its derivatives by time, and what swTile::likeness is.
enum
{
    SW_TEXELS_DISPLACEMENT,
    SW_TEXELS_VELOCITY,
    SW_TEXELS_ACCELERATION,
    SW_TEXELS_LIKENESS,
    SW_TEXELS_COUNT
};

// A set, once, however many systems and parts show it.
typedef struct swShownSet
{
    swWaveSet* set;
    float weight; // of all systems and parts together
    int system;   // slot of the first of them that has weight
    float share;  // of a mix
} swShownSet;

// In order of systems and parts. Sets without weight are among them.
typedef struct swShown
{
    int count;
    swShownSet sets[SW_MAX_SHOWN_SETS];
    bool isHeld; // a replay does not know the records of that time: the nearest that it has stand in
} swShown;

// Two tiles that are transformed together; second is -1 for a single one.
typedef struct swTilePair
{
    int first, second;
} swTilePair;

typedef struct swTileList
{
    const swEvenFlow* evenFlow; // that carries all of them
    int tileCount;
    swTile tiles[SW_MAX_TILES];
    float* texels[SW_MAX_TILES][SW_TEXELS_COUNT]; // of the tiles, to write; NULL where there are none
    bool isLikenessMade[SW_MAX_TILES];            // of an earlier time, and still good
    int pairCount;
    swTilePair pairs[SW_MAX_TILES];
    int waveCount;
    swFreeWave waves[SW_MAX_FREE_WAVES];
} swTileList;

void swClearTileList(swTileList* list);
// For a time: a set's tiles, of `bands` (its own, or a copy at another share of its mix), and its free waves.
void swListSet(swTileList* list, const swShownSet* shown, const swBandModes* bands, int64_t ticks);

static inline int swCountTransforms(const swTileList* list)
{
    return list->pairCount * SW_TEXELS_COUNT;
}

// Spectra to texels: transform `index` is one field of one pair.
void swTransformListed(const swTileList* list, const swWaveKernels* kernels, int64_t ticks, int index, void* scratch);
