// SPDX-License-Identifier: MIT
// Tiles and free waves of a frame, in the order of the sets that are shown. Tiles of one set are paired in order of
// their bands: a tile's bits depend on its partner, so the pairing depends on nothing but the set. Sets without weight
// are not listed.

#include "core/waves/tile_list.h"

#include <string.h>

#include "core/waves/waves.h"

void swClearTileList(swTileList* list)
{
    list->tileCount = 0;
    list->pairCount = 0;
    list->waveCount = 0;
}

static void addTile(swTileList* list, const swShownSet* shown, const swBandModes* bands, int index, int64_t ticks)
{
    const swWaveSet* set = shown->set;
    const swBandModes* band = &bands[index];
    float square = shown->weight * shown->weight;
    swTile* tile = &list->tiles[list->tileCount];
    *tile = (swTile){
        .system = shown->system,
        .band = band->band,
        .resolution = set->def.resolution,
        .maxBin = band->maxBin,
        .side = band->side,
        .loopTicks = band->loopTicks,
        .minWavelength = band->minWavelength,
        .maxWavelength = band->maxWavelength,
        .weight = shown->weight,
        .variance = band->variance * square,
        .slopeVarianceX = band->slopeVarianceX * square,
        .slopeVarianceZ = band->slopeVarianceZ * square,
        .strain = band->strain,
        .depth = band->depth,
        .drift = set->drift,
        .evenFlow = list->evenFlow,
        .attenuation = swGetSetAttenuation(set, shown->share),
        .modeCount = band->modeCount,
        .modes = band->modes,
        .spectrumVersion = set->version,
        .response = set->response,
        .texels = set->texels[SW_TEXELS_DISPLACEMENT][index],
        .velocity = set->texels[SW_TEXELS_VELOCITY][index],
        .acceleration = set->texels[SW_TEXELS_ACCELERATION][index],
        .likeness = set->texels[SW_TEXELS_LIKENESS][index],
    };
    swScaleStrain(&tile->strain, square);
    swPosXZ shift = swGetTileShift(tile, ticks);
    tile->shiftX = shift.x;
    tile->shiftZ = shift.z;
    for (int field = 0; field < SW_TEXELS_COUNT; ++field)
    {
        list->texels[list->tileCount][field] = set->texels[field][index];
    }
    list->isLikenessMade[list->tileCount] = set->likenessVersion == set->version;
    list->tileCount += 1;
}

static void listTiles(swTileList* list, const swShownSet* shown, const swBandModes* bands, int64_t ticks)
{
    int first = list->tileCount;
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        int tile = i % SW_BAND_TILES * SW_MAX_BANDS + i / SW_BAND_TILES; // band by band
        if (bands[tile].modeCount > 0)
        {
            addTile(list, shown, bands, tile, ticks);
        }
    }
    for (int tile = first; tile < list->tileCount; tile += 2)
    {
        int second = tile + 1 < list->tileCount ? tile + 1 : -1;
        list->pairs[list->pairCount++] = (swTilePair){tile, second};
    }
}

// Merge: waves of a set are in order already.
static void listWaves(swTileList* list, const swShownSet* shown)
{
    const swWaveSet* set = shown->set;
    int total = list->waveCount + set->waveCount;
    int old = list->waveCount - 1;
    int added = set->waveCount - 1;
    for (int at = total - 1; added >= 0; --at)
    {
        if (old >= 0 && list->waves[old].wavelength < set->waves[added].wavelength)
        {
            list->waves[at] = list->waves[old];
            old -= 1;
            continue;
        }
        list->waves[at] = set->waves[added];
        list->waves[at].amplitude = set->waves[added].amplitude * shown->weight;
        list->waves[at].attenuation = swGetSetAttenuation(set, shown->share);
        list->waves[at].system = shown->system;
        list->waves[at].drift = set->drift;
        list->waves[at].evenFlow = list->evenFlow;
        added -= 1;
    }
    list->waveCount = total;
}

void swListSet(swTileList* list, const swShownSet* shown, const swBandModes* bands, int64_t ticks)
{
    if (shown->weight != 0.0f)
    {
        listTiles(list, shown, bands, ticks);
        listWaves(list, shown);
    }
}

// A tile whose texels, as swTransformTiles() makes them with SW_LIKENESS, are 1 at no way.
static swTile scaleToLikeness(const swTile* tile)
{
    swTile scaled = *tile;
    double sum = swSumTilePowers(tile);
    scaled.weight = sum > 0.0 ? (float)(0.5 / sum) : 0.0f;
    return scaled;
}

// The spline through a correlation is up to 0.7 % above it where it is sampled best, which is at no way: so that copies
// that lie together are as high as one, the table is divided by what it says there.
static void normaliseLikeness(int resolution, float* texels)
{
    static const double parts[3] = {1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
    size_t pitch = (size_t)resolution + 3;
    double atNone = 0.0;
    for (size_t j = 0; j < 3; ++j)
    {
        for (size_t i = 0; i < 3; ++i)
        {
            atNone += parts[i] * parts[j] * (double)texels[(j * pitch + i) * 4 + 1];
        }
    }
    float factor = atNone > 0.5 ? (float)(1.0 / atNone) : 1.0f; // of no waves it is 0
    for (size_t i = 0; i < pitch * pitch; ++i)
    {
        texels[4 * i + 1] *= factor;
    }
}

static void transformLikeness(const swTileList* list, const swWaveKernels* kernels, const swTilePair* pair,
                              void* scratch)
{
    bool isPair = pair->second >= 0;
    swTile first = scaleToLikeness(&list->tiles[pair->first]);
    swTile second = scaleToLikeness(&list->tiles[isPair ? pair->second : pair->first]);
    swTransformTiles(kernels, &first, list->texels[pair->first][SW_TEXELS_LIKENESS], isPair ? &second : NULL,
                     isPair ? list->texels[pair->second][SW_TEXELS_LIKENESS] : NULL, 0, SW_LIKENESS, scratch);
    normaliseLikeness(first.resolution, list->texels[pair->first][SW_TEXELS_LIKENESS]);
    if (isPair)
    {
        normaliseLikeness(second.resolution, list->texels[pair->second][SW_TEXELS_LIKENESS]);
    }
}

// Field index % SW_TEXELS_COUNT of a pair.
void swTransformListed(const swTileList* list, const swWaveKernels* kernels, int64_t ticks, int index, void* scratch)
{
    const swTilePair* pair = &list->pairs[index / SW_TEXELS_COUNT];
    int field = index % SW_TEXELS_COUNT;
    float* first = list->texels[pair->first][field];
    if (first == NULL)
    {
        return;
    }
    if (field == SW_TEXELS_LIKENESS)
    {
        if (!list->isLikenessMade[pair->first])
        {
            transformLikeness(list, kernels, pair, scratch);
        }
        return;
    }
    bool isPair = pair->second >= 0;
    swTransformTiles(kernels, &list->tiles[pair->first], first, isPair ? &list->tiles[pair->second] : NULL,
                     isPair ? list->texels[pair->second][field] : NULL, ticks, field, scratch);
}
