// SPDX-License-Identifier: MIT
// The digest: all that decides the sea from now on, and the sea as the last step left it.
//
// What decides it are the world's def, the clocks, and each system's layers: their waves, how they fade and how far
// their mixes have come. Waves are hashed once, when they are made; what a mix is made from as well, its share with the
// layer. A ramp that is over counts as the value that it ended with, so that a sea that was changed and is done with it
// is the same as one that was made so. A change that was ordered is part of all this at once.
//
// Tiles and free waves are there to notice a machine that works out other ones from the same. They are left out while a
// change waits for its step, because they are of the sea before it, which a world that was just restored never had.
//
// Not part of it are the origin, views and their foam, and handles: each machine has its own.
//
// The digest is made when it is asked for, not in every step: hashing 14 tiles of 128 x 128 takes about a third of the
// time that making them takes.

#include <string.h>

#include "core/base/hash.h"
#include "core/world/world.h"

// ---- waves ----

static void addFreeWave(swHash* hash, const swFreeWave* wave)
{
    swAddHashDouble(hash, wave->turnsX);
    swAddHashDouble(hash, wave->turnsZ);
    swAddHashDouble(hash, (double)wave->amplitude);
    swAddHashDouble(hash, (double)wave->dx);
    swAddHashDouble(hash, (double)wave->dz);
    swAddHash(hash, wave->frequency);
    swAddHash(hash, (uint64_t)wave->loopTicks);
    swAddHash(hash, wave->phase);
}

// Of a mix the amplitudes are those of its share, and no part of it.
static void addModes(swHash* hash, const swBandModes* band, bool isMix)
{
    swAddHash(hash, (uint64_t)band->modeCount);
    if (band->modeCount == 0)
    {
        return;
    }
    swAddHashDouble(hash, band->side);
    swAddHash(hash, (uint64_t)band->loopTicks);
    for (int i = 0; i < band->modeCount; ++i)
    {
        const swMode* mode = &band->modes[i];
        swAddHash(hash, (uint64_t)(uint16_t)mode->qx | (uint64_t)(uint16_t)mode->qz << 16);
        swAddHash(hash, mode->frequencyLow | (uint64_t)mode->frequencyHigh << 32);
        if (!isMix)
        {
            const float amplitudes[6] = {mode->dx, mode->dz, mode->pr, mode->pi, mode->qr, mode->qi};
            swAddHashFloats(hash, amplitudes, 6);
        }
    }
}

uint64_t swHashSet(const swWaveSet* set)
{
    swHash hash = swBeginHash();
    swAddHash(&hash, (uint64_t)set->def.method);
    if (set->def.method == SW_WAVES_FFT)
    {
        swAddHash(&hash, (uint64_t)set->def.resolution);
    }
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        addModes(&hash, &set->bands[i], set->mix != NULL);
    }
    for (int i = 0; i < set->waveCount; ++i)
    {
        addFreeWave(&hash, &set->waves[i]);
    }
    if (set->mix != NULL)
    {
        swAddHashMix(&hash, set->mix);
        swAddHash(&hash, set->to->hash);
    }
    return swEndHash(&hash);
}

static void addBand(swHash* hash, const swBandModes* band)
{
    const float bounds[] = {band->minWavelength, band->maxWavelength, band->depth};
    swAddHashFloats(hash, bounds, 3);
}

// Waves alone do not tell over what depth they run, which decides the motion below, nor from which wavelength on a
// query leaves their band out.
uint64_t swIdentifySet(const swWaveSet* set)
{
    swHash hash = swBeginHash();
    swAddHash(&hash, set->hash);
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        addBand(&hash, &set->bands[i]);
    }
    for (int i = 0; i < set->waveCount; ++i)
    {
        const float bounds[] = {set->waves[i].wavelength, set->waves[i].depth};
        swAddHashFloats(&hash, bounds, 2);
    }
    if (set->to != NULL)
    {
        swAddHash(&hash, set->to->identity);
    }
    return swEndHash(&hash);
}

// ---- systems ----

static void addRamp(swHash* hash, const swRamp* ramp, int64_t ticks)
{
    swRamp rest = *ramp;
    if (swIsRampOver(ramp, ticks))
    {
        rest = (swRamp){.from = ramp->to, .to = ramp->to};
    }
    swAddHashDouble(hash, (double)rest.from);
    swAddHashDouble(hash, (double)rest.to);
    swAddHash(hash, (uint64_t)rest.begin);
    swAddHash(hash, (uint64_t)rest.length);
}

static void addSystem(swHash* hash, const swWaveSystem* system, int64_t ticks)
{
    swAddHash(hash, (uint64_t)system->layerCount);
    addRamp(hash, &system->weight, ticks);
    for (int i = 0; i < system->layerCount; ++i)
    {
        const swWaveLayer* layer = &system->layers[i];
        swAddHash(hash, layer->set->hash);
        addRamp(hash, &layer->fade, ticks);
        if (layer->set->mix != NULL)
        {
            addRamp(hash, &layer->share, ticks);
            swAddHash(hash, (uint64_t)(layer->isMixing ? 1 : 0) | (uint64_t)(layer->isShared ? 2 : 0));
        }
    }
}

static void addDef(swHash* hash, const swWorldDef* def)
{
    swAddHashDouble(hash, (double)def->gravity);
    swAddHashDouble(hash, (double)def->surfaceTension);
    swAddHashDouble(hash, def->seaLevel);
    swAddHashDouble(hash, (double)def->foam.fadeRate);
    swAddHashDouble(hash, (double)def->foam.coverage);
    swAddHashDouble(hash, (double)def->foam.windSpeed);
    swAddHashDouble(hash, (double)def->foam.minWavelength);
    swAddHashDouble(hash, (double)def->foam.threshold);
}

// ---- the last step ----

static void addTile(swHash* hash, const swTile* tile)
{
    swAddHashDouble(hash, tile->side);
    swAddHashDouble(hash, (double)tile->weight);
    if (tile->texels != NULL)
    {
        size_t pitch = (size_t)tile->resolution + 3;
        swAddHashFloats(hash, tile->texels, pitch * pitch * 4);
    }
}

uint64_t swHashWorld(const swWorld* world)
{
    const swFrame* frame = &world->frame;
    swHash hash = swBeginHash();
    addDef(&hash, &world->def);
    swAddHash(&hash, (uint64_t)frame->ticks);
    swAddHashDouble(&hash, world->time);
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        addSystem(&hash, &world->systems[slot], frame->ticks);
    }
    for (int i = 0; i < frame->tileCount && !world->isChanged; ++i)
    {
        addTile(&hash, &frame->tiles[i]);
    }
    for (int i = 0; i < frame->waveCount && !world->isChanged; ++i)
    {
        addFreeWave(&hash, &frame->waves[i]);
    }
    return swEndHash(&hash);
}
