// SPDX-License-Identifier: MIT

// Amplitudes are mixed linearly, A = c ((1 - s) A0 + s A1). Where both seas have energy at a wave, its phase is the
// same in both, so that the mixture has it too. Where only one has, energies would add up to less on the way ((1 - s)^2
// + s^2); the factor c makes up for that for each band as a whole: with V0, V1 the band's variances and C their
// covariance,
//   c^2 = ((1 - s) V0 + s V1) / ((1 - s)^2 V0 + s^2 V1 + 2 s (1 - s) C).
// Parallel tiles of a band have one factor: a tile that only one of the seas has begins with the amplitudes of a part
// s, not with those of an energy s, which would be a jump.

#include "core/waves/mode_mix.h"

#include <math.h>
#include <string.h>

#include "core/base/host.h"

// What is mixed of a mode: dx dz pr pi qr qi.
#define MIXED 6

typedef struct Pair
{
    float from[MIXED], to[MIXED];
} Pair;

typedef struct BandMix
{
    int count;
    Pair* pairs;          // beside the band's modes
    swBandModes from, to; // without modes: variances
    double variance0, variance1, covariance;
} BandMix;

struct swModeMix
{
    BandMix bands[SW_SET_TILES];
};

static int compareModes(const swMode* a, const swMode* b)
{
    if (a->qz != b->qz)
    {
        return a->qz < b->qz ? -1 : 1;
    }
    return a->qx == b->qx ? 0 : a->qx < b->qx ? -1 : 1;
}

// The next mode of either list, in order; the other is NULL where only one has it.
static void takeNext(const swBandModes* from, const swBandModes* to, int* i, int* j, const swMode** a, const swMode** b)
{
    *a = *i < from->modeCount ? from->modes + *i : NULL;
    *b = *j < to->modeCount ? to->modes + *j : NULL;
    if (*a != NULL && *b != NULL)
    {
        int order = compareModes(*a, *b);
        *a = order <= 0 ? *a : NULL;
        *b = order >= 0 ? *b : NULL;
    }
    *i += *a != NULL ? 1 : 0;
    *j += *b != NULL ? 1 : 0;
}

// The number of modes of both together; -1 if they cannot be mixed.
static int countModes(const swBandModes* from, const swBandModes* to)
{
    int count = 0;
    for (int i = 0, j = 0; i < from->modeCount || j < to->modeCount; ++count)
    {
        const swMode *a, *b;
        takeNext(from, to, &i, &j, &a, &b);
        if (a != NULL && b != NULL && (a->frequencyLow != b->frequencyLow || a->frequencyHigh != b->frequencyHigh))
        {
            return -1;
        }
    }
    return count;
}

static void copyMixed(const swMode* mode, const swMode* other, float mixed[MIXED])
{
    const swMode* direction = mode != NULL ? mode : other;
    memset(mixed, 0, MIXED * sizeof(float));
    mixed[0] = direction->dx;
    mixed[1] = direction->dz;
    if (mode != NULL)
    {
        memcpy(mixed + 2, &mode->pr, 4 * sizeof(float));
    }
}

static void addCovariances(BandMix* band, const Pair* pair, double square)
{
    for (int c = 2; c < MIXED; ++c)
    {
        band->variance0 += square * (double)pair->from[c] * (double)pair->from[c];
        band->variance1 += square * (double)pair->to[c] * (double)pair->to[c];
        band->covariance += square * (double)pair->from[c] * (double)pair->to[c];
    }
}

static void fillPairs(const swBandModes* from, const swBandModes* to, const float* response, BandMix* band,
                      swBandModes* out)
{
    for (int i = 0, j = 0, n = 0; n < band->count; ++n)
    {
        const swMode *a, *b;
        takeNext(from, to, &i, &j, &a, &b);
        out->modes[n] = a != NULL ? *a : *b;
        copyMixed(a, b, band->pairs[n].from);
        copyMixed(b, a, band->pairs[n].to);
        int qx = out->modes[n].qx < 0 ? -out->modes[n].qx : out->modes[n].qx;
        double damping = (double)response[qx] * (double)response[out->modes[n].qz];
        addCovariances(band, &band->pairs[n], damping * damping);
    }
}

// Part of a tile's variance that both seas have in common.
static double findSharedPart(const swBandModes* from, const swBandModes* to, const float* response)
{
    BandMix sums = {0};
    for (int i = 0, j = 0; i < from->modeCount || j < to->modeCount;)
    {
        const swMode *a, *b;
        takeNext(from, to, &i, &j, &a, &b);
        Pair pair;
        copyMixed(a, b, pair.from);
        copyMixed(b, a, pair.to);
        const swMode* mode = a != NULL ? a : b;
        double damping = (double)response[mode->qx < 0 ? -mode->qx : mode->qx] * (double)response[mode->qz];
        addCovariances(&sums, &pair, damping * damping);
    }
    double all = sums.variance0 + sums.variance1;
    return all > 0.0 ? 2.0 * sums.covariance / all : 0.0;
}

double swFindSharedVariance(const swBandModes* a, const swBandModes* b, const float* response)
{
    double all = 0.0, shared = 0.0;
    for (int tile = 0; tile < SW_SET_TILES; ++tile)
    {
        double variance = (double)a[tile].variance + (double)b[tile].variance;
        all += variance;
        if (a[tile].modeCount > 0 && b[tile].modeCount > 0 && a[tile].side == b[tile].side)
        {
            shared += variance * findSharedPart(&a[tile], &b[tile], response);
        }
    }
    return all > 0.0 ? shared / all : 0.0;
}

static swResult mixBand(const swHost* host, const swBandModes* from, const swBandModes* to, const float* response,
                        BandMix* band, swBandModes* out)
{
    *out = from->modeCount > 0 ? *from : *to;
    out->modes = NULL;
    out->modeCount = 0;
    if (from->modeCount > 0 && to->modeCount > 0)
    {
        if (from->side != to->side || from->loopTicks != to->loopTicks || from->depth != to->depth)
        {
            return SW_ERROR_UNSUPPORTED;
        }
        out->minWavelength = fminf(from->minWavelength, to->minWavelength);
        out->maxWavelength = fmaxf(from->maxWavelength, to->maxWavelength);
        out->maxBin = from->maxBin > to->maxBin ? from->maxBin : to->maxBin;
    }
    band->from = *from;
    band->to = *to;
    int count = countModes(from, to);
    if (count <= 0)
    {
        return count < 0 ? SW_ERROR_UNSUPPORTED : SW_SUCCESS;
    }
    out->modes = swAllocate(host, (size_t)count * sizeof(swMode));
    out->modeCount = out->modes != NULL ? count : 0;
    band->pairs = swAllocate(host, (size_t)count * sizeof(Pair));
    if (out->modes == NULL || band->pairs == NULL)
    {
        band->count = band->pairs != NULL ? count : 0;
        return SW_ERROR_NO_MEMORY;
    }
    band->count = count;
    fillPairs(from, to, response, band, out);
    return SW_SUCCESS;
}

swResult swMakeModeMix(const swHost* host, const swBandModes* from, const swBandModes* to, const float* response,
                       swBandModes* bands, swModeMix** mixOut)
{
    *mixOut = NULL;
    memset(bands, 0, SW_SET_TILES * sizeof(swBandModes));
    swModeMix* mix = swAllocateZero(host, sizeof *mix);
    if (mix == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        swResult result = mixBand(host, &from[i], &to[i], response, &mix->bands[i], &bands[i]);
        if (result != SW_SUCCESS)
        {
            swFreeModes(host, bands);
            swFreeModeMix(host, mix);
            return result;
        }
    }
    swApplyModeMix(mix, 0.0f, bands);
    *mixOut = mix;
    return SW_SUCCESS;
}

void swFreeModeMix(const swHost* host, swModeMix* mix)
{
    if (mix == NULL)
    {
        return;
    }
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        swFree(host, mix->bands[i].pairs, (size_t)mix->bands[i].count * sizeof(Pair));
    }
    swFree(host, mix, sizeof *mix);
}

// Variance of a tile at a share, without the factor.
static double getMixedVariance(const BandMix* band, double s)
{
    return (1.0 - s) * (1.0 - s) * band->variance0 + s * s * band->variance1 + 2.0 * s * (1.0 - s) * band->covariance;
}

// The factor that keeps a band's energy, all of its tiles together.
static double getEnergyFactor(const swModeMix* mix, int band, double s)
{
    double wanted = 0.0, mixed = 0.0;
    for (int i = band; i < SW_SET_TILES; i += SW_MAX_BANDS)
    {
        const BandMix* tile = &mix->bands[i];
        wanted += (1.0 - s) * tile->variance0 + s * tile->variance1;
        mixed += getMixedVariance(tile, s);
    }
    return mixed > 0.0 ? sqrt(wanted / mixed) : 1.0;
}

static void applyBand(const BandMix* band, double factor, float share, swBandModes* out)
{
    float keep = 1.0f - share;
    float keepFactor = keep * (float)factor;
    float shareFactor = share * (float)factor;
    for (int i = 0; i < band->count; ++i)
    {
        const Pair* pair = &band->pairs[i];
        swMode* mode = &out->modes[i];
        mode->dx = keep * pair->from[0] + share * pair->to[0];
        mode->dz = keep * pair->from[1] + share * pair->to[1];
        mode->pr = keepFactor * pair->from[2] + shareFactor * pair->to[2];
        mode->pi = keepFactor * pair->from[3] + shareFactor * pair->to[3];
        mode->qr = keepFactor * pair->from[4] + shareFactor * pair->to[4];
        mode->qi = keepFactor * pair->from[5] + shareFactor * pair->to[5];
    }
    // Of a tile alone the part is 1.
    double wanted = (1.0 - (double)share) * band->variance0 + (double)share * band->variance1;
    double mixed = factor * factor * getMixedVariance(band, (double)share);
    float part = wanted > 0.0 && mixed > 0.0 ? (float)(mixed / wanted) : 1.0f;
    out->variance = part * (keep * band->from.variance + share * band->to.variance);
    out->slopeVarianceX = part * (keep * band->from.slopeVarianceX + share * band->to.slopeVarianceX);
    out->slopeVarianceZ = part * (keep * band->from.slopeVarianceZ + share * band->to.slopeVarianceZ);
    const float* fromStrain = &band->from.strain.cccc;
    const float* toStrain = &band->to.strain.cccc;
    float* strain = &out->strain.cccc;
    for (int i = 0; i < 5; ++i)
    {
        strain[i] = part * (keep * fromStrain[i] + share * toStrain[i]);
    }
    for (int i = 0; i < SW_WIND_STEPS; ++i)
    {
        out->wind[i] = keep * band->from.wind[i] + share * band->to.wind[i];
    }
    out->knownWind = keep * band->from.knownWind + share * band->to.knownWind;
}

void swApplyModeMix(const swModeMix* mix, float share, swBandModes* bands)
{
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        applyBand(&mix->bands[i], getEnergyFactor(mix, i % SW_MAX_BANDS, (double)share), share, &bands[i]);
    }
}

void swAddHashMix(swHash* hash, const swModeMix* mix)
{
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        const BandMix* band = &mix->bands[i];
        swAddHash(hash, (uint64_t)band->count);
        swAddHashDouble(hash, band->variance0);
        swAddHashDouble(hash, band->variance1);
        swAddHashDouble(hash, band->covariance);
        for (int k = 0; k < band->count; ++k)
        {
            swAddHashFloats(hash, band->pairs[k].from, MIXED);
            swAddHashFloats(hash, band->pairs[k].to, MIXED);
        }
    }
}

// ---- as bytes ----

// Of a mode and its pair: bins, frequency, and what is mixed.
#define MODE_BYTES (16 + 2 * MIXED * sizeof(float))

// No water is as high or as steep as this.
#define LARGEST_AMPLITUDE 1e6f

static void streamFinite(swStream* stream, float* values, int count)
{
    swStreamFloats(stream, values, (size_t)count);
    for (int i = 0; i < count; ++i)
    {
        stream->isBroken = stream->isBroken || !(fabsf(values[i]) <= LARGEST_AMPLITUDE); // NaN as well
    }
}

static void streamPositive(swStream* stream, float* value)
{
    streamFinite(stream, value, 1);
    stream->isBroken = stream->isBroken || *value < 0.0f;
}

static void streamDouble(swStream* stream, double* value)
{
    swStreamF64(stream, value);
    stream->isBroken = stream->isBroken || !(fabs(*value) <= 1e12);
}

static void streamBand(swStream* stream, int maxBin, swBandModes* band)
{
    swStreamRange(stream, &band->maxBin, 0, maxBin);
    swStreamI64(stream, &band->loopTicks);
    stream->isBroken = stream->isBroken || band->loopTicks < 0;
    streamPositive(stream, &band->minWavelength);
    streamPositive(stream, &band->maxWavelength);
    streamPositive(stream, &band->variance);
    streamPositive(stream, &band->slopeVarianceX);
    streamPositive(stream, &band->slopeVarianceZ);
    streamFinite(stream, &band->strain.cccc, 5);
    for (int i = 0; i < SW_WIND_STEPS; ++i)
    {
        streamPositive(stream, &band->wind[i]);
    }
    streamPositive(stream, &band->knownWind);
    swStreamF32(stream, &band->depth);
    stream->isBroken = stream->isBroken || !(band->depth >= 0.0f); // infinite over deep water
}

// Bins within the tile's lattice, the half plane only, in order.
static void streamMode(swStream* stream, int maxBin, const swMode* before, swMode* mode)
{
    int qx = mode->qx, qz = mode->qz;
    swStreamRange(stream, &qx, -maxBin, maxBin);
    swStreamRange(stream, &qz, 0, maxBin);
    if (swIsReading(stream))
    {
        mode->qx = (int16_t)qx;
        mode->qz = (int16_t)qz;
    }
    bool isInHalf = qz > 0 || qx > 0;
    if (!isInHalf || (before != NULL && compareModes(before, mode) >= 0))
    {
        stream->isBroken = true;
    }
    swStreamU32(stream, &mode->frequencyLow);
    swStreamU32(stream, &mode->frequencyHigh);
}

static swResult streamBandMix(swStream* stream, const swHost* host, int most, int maxBin, BandMix* mix,
                              swBandModes* band)
{
    int count = mix->count;
    swStreamRange(stream, &count, 0, most);
    streamBand(stream, maxBin, &mix->from);
    streamBand(stream, maxBin, &mix->to);
    streamBand(stream, maxBin, band);
    streamDouble(stream, &mix->variance0);
    streamDouble(stream, &mix->variance1);
    streamDouble(stream, &mix->covariance);
    if (swIsReading(stream) && swStreamHasLeft(stream, (size_t)count, MODE_BYTES) && count > 0)
    {
        band->modes = swAllocateZero(host, (size_t)count * sizeof(swMode));
        band->modeCount = band->modes != NULL ? count : 0;
        mix->pairs = swAllocateZero(host, (size_t)count * sizeof(Pair));
        mix->count = mix->pairs != NULL ? count : 0;
        if (band->modes == NULL || mix->pairs == NULL)
        {
            return SW_ERROR_NO_MEMORY;
        }
    }
    for (int i = 0; i < mix->count && !stream->isBroken; ++i)
    {
        streamMode(stream, maxBin, i > 0 ? &band->modes[i - 1] : NULL, &band->modes[i]);
        streamFinite(stream, mix->pairs[i].from, MIXED);
        streamFinite(stream, mix->pairs[i].to, MIXED);
    }
    return SW_SUCCESS;
}

swResult swStreamModeMix(swStream* stream, const swHost* host, int tileWaves, int resolution, swBandModes* bands,
                         swModeMix** mixPointer)
{
    swModeMix* mix = *mixPointer;
    if (swIsReading(stream))
    {
        memset(bands, 0, SW_SET_TILES * sizeof(swBandModes));
        mix = swAllocateZero(host, sizeof *mix);
        *mixPointer = mix;
        if (mix == NULL)
        {
            return SW_ERROR_NO_MEMORY;
        }
    }
    int maxBin = tileWaves < resolution / 4 ? tileWaves : resolution / 4;
    int most = (2 * maxBin + 1) * (maxBin + 1);
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_SET_TILES && result == SW_SUCCESS && !stream->isBroken; ++i)
    {
        result = streamBandMix(stream, host, most, maxBin, &mix->bands[i], &bands[i]);
        if (swIsReading(stream))
        {
            bands[i].band = i % SW_MAX_BANDS;
            bands[i].side = swGetTileSide(i, tileWaves);
        }
    }
    result = result == SW_SUCCESS && stream->isBroken ? SW_ERROR_FORMAT : result;
    if (result != SW_SUCCESS && swIsReading(stream))
    {
        swFreeModes(host, bands);
        swFreeModeMix(host, mix);
        *mixPointer = NULL;
    }
    return result;
}
