// SPDX-License-Identifier: MIT
// Wave systems and waves by hand that come and go while the sea runs.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sea.h"

// The first system that is there: a new one runs as it does, with its tiles.
static const SeaWaves* FindModel(const Sea* sea)
{
    for (int i = 0; i < sea->wavesCount; i++)
    {
        if (!sea->waves[i].isRemoved)
        {
            return &sea->waves[i];
        }
    }
    return NULL;
}

// A seed that no system has: two of the same spectrum and seed would be the same waves.
static uint32_t FindFreeSeed(const Sea* sea)
{
    uint32_t seed = 1;
    for (int i = 0; i < sea->wavesCount; i++)
    {
        seed = sea->waves[i].def.seed >= seed ? sea->waves[i].def.seed + 1 : seed;
    }
    return seed;
}

static swSpectrumDef MakeNewSpectrum(NewWaves kind, float direction)
{
    swSpectrumDef spectrum = swMakeBeaufortSpectrum(4.0f, direction);
    if (kind == NEW_SWELL)
    {
        spectrum = swMakeSwellSpectrum(1.5f, 12.0f, direction, 0.157f);
    }
    else if (kind == NEW_EQUALISER)
    {
        spectrum = swMakeOctaveSpectrum(&spectrum);
    }
    return spectrum;
}

static bool TakeFirstRow(SeaWaves* waves, float direction)
{
    waves->hand = calloc(1, sizeof(HandWaves));
    if (waves->hand == NULL)
    {
        return false;
    }
    waves->hand->waves[0] = (swWaveComponent){.wavelength = 60.0f, .direction = direction, .amplitude = 0.5f};
    waves->hand->filedRows[0] = waves->hand->appliedRows[0] = -1;
    waves->def.method = SW_WAVES_GERSTNER;
    waves->def.components = waves->hand->waves;
    waves->def.componentCount = 1;
    return true;
}

bool AddWaves(Sea* sea, NewWaves kind)
{
    const SeaWaves* model = FindModel(sea);
    float direction = model != NULL ? model->def.spectrum.direction : 0.0f;
    SeaWaves waves = {.serial = sea->lastSerial++, .def = swDefaultWaveSystemDef(), .file = "", .isAdded = true};
    if (model != NULL && model->def.method == SW_WAVES_FFT)
    {
        waves.def.resolution = model->def.resolution;
        waves.def.tileWaves = model->def.tileWaves;
    }
    waves.def.seed = FindFreeSeed(sea);
    waves.def.spectrum = MakeNewSpectrum(kind, direction);
    if (sea->wavesCount == MAX_SEA_WAVES || (kind == NEW_BY_HAND && !TakeFirstRow(&waves, direction)) ||
        RaiseWaves(sea, &waves) != SW_SUCCESS)
    {
        SayInSea(sea, "no wave system was added: the world has no room for another; remove one first");
        free(waves.hand);
        return false;
    }
    sea->waves[sea->wavesCount++] = waves;
    return true;
}

// From now on nobody drives the system; its waves run down.
static void LetGo(Sea* sea, SeaWaves* waves)
{
    double now = swWorld_GetTime(sea->world), seconds = (double)sea->transition;
    swDestroySeaReplay(waves->replay);
    waves->replay = NULL;
    waves->hasChanged = false;
    if (sea->leavingCount == SW_MAX_WAVE_SYSTEMS || seconds <= 0.0)
    {
        swDestroyWaveSystem(sea->world, waves->id);
    }
    else
    {
        swWaveSystem_FadeWeight(sea->world, waves->id, 0.0f, seconds);
        sea->leaving[sea->leavingCount++] = (LeavingWaves){waves->id, now, now + seconds};
    }
    waves->id = (swWaveSystemId){0};
}

void RemoveWaves(Sea* sea, int index)
{
    SeaWaves* waves = &sea->waves[index];
    if (!waves->isAdded)
    {
        waves->isRemoved = true;
        FollowWaves(sea, index);
    }
    LetGo(sea, waves);
    if (waves->isAdded)
    {
        free(waves->hand);
        sea->wavesCount--;
        memmove(waves, waves + 1, (size_t)(sea->wavesCount - index) * sizeof(SeaWaves));
    }
}

bool BringBackWaves(Sea* sea, int index)
{
    SeaWaves* waves = &sea->waves[index];
    if (!waves->isRemoved || RaiseWaves(sea, waves) != SW_SUCCESS)
    {
        SayInSea(sea, "the wave system was not brought back: the world has no room for another; remove one first");
        return false;
    }
    waves->isRemoved = false;
    FollowWaves(sea, index);
    return true;
}

void ClearLeavingWaves(Sea* sea, bool isPaused)
{
    double now = swWorld_GetTime(sea->world);
    int kept = 0;
    for (int i = 0; i < sea->leavingCount; i++)
    {
        LeavingWaves leaving = sea->leaving[i];
        if (isPaused || now >= leaving.end || now < leaving.start) // or time was set back
        {
            swDestroyWaveSystem(sea->world, leaving.id);
        }
        else
        {
            sea->leaving[kept++] = leaving;
        }
    }
    sea->leavingCount = kept;
}

// Free waves of all systems together have a limit, which the world checks only when it gets them.
static bool HasRoomForRow(const Sea* sea)
{
    int count = 0;
    for (int i = 0; i < sea->wavesCount; i++)
    {
        count += sea->waves[i].isRemoved ? 0 : sea->waves[i].def.componentCount;
    }
    return count < SW_MAX_FREE_WAVES;
}

bool AddRow(Sea* sea, int index, int row)
{
    SeaWaves* waves = &sea->waves[index];
    HandWaves* hand = waves->hand;
    if (!HasRoomForRow(sea))
    {
        SayInSea(sea, "no wave was added: a world has 1,024 waves by hand at most");
        return false;
    }
    size_t behind = (size_t)(waves->def.componentCount - row - 1);
    memmove(hand->waves + row + 2, hand->waves + row + 1, behind * sizeof(swWaveComponent));
    memmove(hand->filedRows + row + 2, hand->filedRows + row + 1, behind * sizeof(int));
    hand->waves[row + 1] = hand->waves[row];
    hand->filedRows[row + 1] = -1;
    waves->def.componentCount++;
    waves->hasChanged = true;
    return true;
}

bool RemoveRow(Sea* sea, int index, int row)
{
    SeaWaves* waves = &sea->waves[index];
    HandWaves* hand = waves->hand;
    if (waves->def.componentCount < 2)
    {
        return false; // without a row the waves would be those of the spectrum
    }
    waves->def.componentCount--;
    size_t behind = (size_t)(waves->def.componentCount - row);
    memmove(hand->waves + row, hand->waves + row + 1, behind * sizeof(swWaveComponent));
    memmove(hand->filedRows + row, hand->filedRows + row + 1, behind * sizeof(int));
    waves->hasChanged = true;
    return true;
}

static bool HasFiledRow(const SeaWaves* waves, int filedRow)
{
    for (int i = 0; i < waves->def.componentCount; i++)
    {
        if (waves->hand->filedRows[i] == filedRow)
        {
            return true;
        }
    }
    return false;
}

void BringBackRows(Sea* sea, int index)
{
    SeaWaves* waves = &sea->waves[index];
    for (int row = 0; row < waves->hand->filedCount && HasRoomForRow(sea); row++)
    {
        if (!HasFiledRow(waves, row))
        {
            int last = waves->def.componentCount++;
            waves->hand->waves[last] = waves->hand->filed[row];
            waves->hand->filedRows[last] = row;
            waves->hasChanged = true;
        }
    }
}
