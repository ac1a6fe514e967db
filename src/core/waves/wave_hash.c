// SPDX-License-Identifier: MIT
// Hashes of waves and of systems, for digests and for knowing the sets of a saved world; see world/digest.c.

#include "core/base/hash.h"
#include "core/waves/waves.h"

// ---- waves ----

void swAddHashFreeWave(swHash* hash, const swFreeWave* wave)
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

// Of nature's law nothing: a sea keeps the digest that it had before there were floors.
static void addAttenuation(swHash* hash, swAttenuation attenuation)
{
    if (attenuation.strength != 1.0f || attenuation.perFreeDepth != 0.0f)
    {
        swAddHashDouble(hash, (double)attenuation.strength);
        swAddHashDouble(hash, (double)attenuation.perFreeDepth);
    }
}

// Of still water nothing, likewise.
static void addDrift(swHash* hash, const swDrift* drift)
{
    if (!swIsDriftStill(drift))
    {
        const float speeds[4] = {drift->fromX, drift->fromZ, drift->toX, drift->toZ};
        swAddHash(hash, (uint64_t)drift->begin);
        swAddHash(hash, (uint64_t)drift->length);
        swAddHashDouble(hash, drift->x);
        swAddHashDouble(hash, drift->z);
        swAddHashFloats(hash, speeds, 4);
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
        swAddHashFreeWave(&hash, &set->waves[i]);
    }
    addAttenuation(&hash, swGetSetAttenuation(set, 1.0f));
    addDrift(&hash, &set->drift);
    if (set->mix != NULL)
    {
        addAttenuation(&hash, set->attenuationBefore);
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

void swAddHashSystem(swHash* hash, const swWaveSystem* system, int64_t ticks)
{
    swAddHash(hash, (uint64_t)system->partCount);
    addRamp(hash, &system->weight, ticks);
    if (system->own.isReplaced) // a new wind will change it
    {
        swAddHash(hash, system->own.isKnown ? 2 : 1);
        swAddHashDouble(hash, (double)system->own.speed);
        swAddHashDouble(hash, (double)system->own.direction);
    }
    for (int i = 0; i < system->partCount; ++i)
    {
        const swWavePart* part = &system->parts[i];
        swAddHash(hash, part->set->hash);
        addRamp(hash, &part->fade, ticks);
        if (part->set->mix != NULL)
        {
            addRamp(hash, &part->share, ticks);
            swAddHash(hash, (uint64_t)(part->isMixing ? 1 : 0) | (uint64_t)(part->isShared ? 2 : 0));
        }
    }
}
