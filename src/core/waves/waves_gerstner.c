// SPDX-License-Identifier: MIT

// A sea of a few trochoidal waves [Gerstner 1802] [Fournier 1986], each with its exact wave vector, so that it never
// repeats and goes just where it should.
//
// Each octave is cut into componentsPerOctave strips of equal ratio of wavelength. A strip's wave has all of its
// energy, sits at a random place of it (as probable as the energy there) and goes in a direction of the spectrum's
// distribution. Few strips have most of a peak's energy, so directions drawn by chance alone would miss the mean
// direction by many degrees where seas cross. Two things keep them from that. Neighbours share out the distribution: of
// any two one goes to either half of it, of any four one to each quarter, and so on, in an order that is drawn anew at
// each halving (a scrambled net [Owen 1995]). And of many such draws the one is taken whose waves together come nearest
// to the spectrum's mean direction and spread: to energy times cos and sin of the direction and of twice the direction.
// Place and phase are drawn independently of that.
// Of a table, the waves whose places are in one of its bins are scaled to that bin's energy, as a strip may reach
// across edges.
//
// reverseWeight gives each wave a twin that runs the other way with that part of its height; the two share the energy.
//
// To first order the Jacobian of the horizontal displacement is 1 minus the sum of chop k a cos over all waves: a
// Gaussian of many waves, and never below 1 minus the sum of chop k a. Where that falls below leastJacobian at more
// than one place in ten thousand (3.72 deviations), all waves' chop is taken back alike. The second order adds a
// little, most where waves cross.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/math/random.h"
#include "core/math/scalar.h"
#include "core/waves/waves_bins.h"
#include "core/waves/waves_fft.h"

#define TURN (2.0 * SW_PI)

// Points of the circle at which the distribution of directions is summed.
#define DIRECTIONS 360
#define DIRECTION_STEP (TURN / DIRECTIONS)

// Draws of all directions, and what the best is chosen by: cos, sin, cos 2, sin 2.
#define DRAWS 64
#define MOMENTS 4

// Of the number of a strip: 16 octaves of 32 at most.
#define STRIP_BITS 9

// Deviations that a Gaussian is below at one place in ten thousand.
#define RARELY 3.72

// Waves lower than this are left out, m.
#define LEAST_AMPLITUDE 1e-6

// What a wave's random numbers are for.
enum
{
    STREAM_PLACE = 101,
    STREAM_DIRECTION,
    STREAM_ORDER,
    STREAM_PHASE
};

typedef struct Strip
{
    int band, index;
    double omega, energy;
    float directions[DRAWS]; // from the mean one, of each draw
} Strip;

typedef struct Builder
{
    const swWaveSystemDef* def;
    const swCompiledSpectrum* spectrum;
    swDispersion dispersion;
    int64_t loopTicks;
    int capacity;
    int count;
    swFreeWave* waves;
    double circle[DIRECTIONS][MOMENTS]; // of the points of the circle
    int stripCount;
    Strip* strips;              // longest first
    double off[DRAWS][MOMENTS]; // energy times what each draw's waves are off
} Builder;

// Directions of the waves of one omega: a table from the mean direction's opposite on, or evenly around the mean one.
typedef struct Spread
{
    double even; // half the angle; 0: by the table
    double total;
    double density[DIRECTIONS + 1];
    double moments[MOMENTS];
} Spread;

static double getUnit(const Builder* builder, int band, int index, uint32_t stream)
{
    return swHashToUnit(swHashWave(builder->def->seed, band, index, 0, stream));
}

static void addWave(Builder* builder, double k, double direction, double amplitude, double phase)
{
    if (builder->count == builder->capacity || !(amplitude > LEAST_AMPLITUDE))
    {
        return;
    }
    double x = swCos(direction);
    double z = swSin(direction);
    double ratio = swGetOrbitRatio(builder->spectrum, builder->def, k);
    double turns = phase / TURN;
    builder->waves[builder->count++] = (swFreeWave){
        .turnsX = k / TURN * x,
        .turnsZ = k / TURN * z,
        .frequency = swGetTurnsPerTick(swGetWaveOmega(builder->spectrum, k), builder->loopTicks),
        .loopTicks = builder->loopTicks,
        .phase = (uint32_t)(int64_t)floor((turns - floor(turns)) * 0x1p32),
        .amplitude = (float)amplitude,
        .dx = (float)(ratio * x),
        .dz = (float)(ratio * z),
        .wavelength = (float)(TURN / k),
        .depth = (float)builder->dispersion.depth,
    };
}

// The omega below which a part of the strip's energy lies.
static double findPlace(const Builder* builder, double low, double high, double wanted)
{
    double begin = low;
    for (int i = 0; i < 40; ++i)
    {
        double middle = 0.5 * (low + high);
        if (swIntegrateCompiled(builder->spectrum, begin, middle) < wanted)
        {
            low = middle;
        }
        else
        {
            high = middle;
        }
    }
    return 0.5 * (low + high);
}

// ---- directions, counted from the mean one ----

static void fillMoments(double angle, double moments[MOMENTS])
{
    double cosine = swCos(angle), sine = swSin(angle);
    moments[0] = cosine;
    moments[1] = sine;
    moments[2] = cosine * cosine - sine * sine;
    moments[3] = 2.0 * sine * cosine;
}

static void fillEvenSpread(double half, Spread* spread)
{
    *spread = (Spread){.even = half};
    spread->moments[0] = swSin(half) / half;
    spread->moments[2] = 0.5 * swSin(2.0 * half) / half;
}

static void fillSpread(const Builder* builder, double omega, Spread* spread)
{
    if (builder->def->directionVariance > 0.0f)
    {
        fillEvenSpread((double)builder->def->directionVariance, spread);
        return;
    }
    double mean = (double)builder->def->spectrum.direction;
    *spread = (Spread){.total = 0.0};
    for (int i = 0; i <= DIRECTIONS; ++i)
    {
        spread->density[i] = swGetCompiledDensity2(builder->spectrum, omega, mean - SW_PI + i * DIRECTION_STEP);
        spread->total += i > 0 ? 0.5 * (spread->density[i - 1] + spread->density[i]) : 0.0;
    }
    for (int i = 0; i < DIRECTIONS && spread->total > 0.0; ++i)
    {
        for (int m = 0; m < MOMENTS; ++m)
        {
            spread->moments[m] += spread->density[i] / spread->total * builder->circle[i][m];
        }
    }
}

// The direction below which a part of the waves go.
static double findDirection(const Spread* spread, double part)
{
    if (spread->even > 0.0)
    {
        return (2.0 * part - 1.0) * spread->even;
    }
    double wanted = part * spread->total;
    for (int i = 0; i < DIRECTIONS; ++i)
    {
        double left = spread->density[i], right = spread->density[i + 1];
        double piece = 0.5 * (left + right);
        if (wanted <= piece || i == DIRECTIONS - 1)
        {
            // Within a piece the density is linear: solve slope t^2 / 2 + left t = wanted.
            double root = sqrt(fmax(left * left + 2.0 * (right - left) * wanted, 0.0));
            double along = left + root > 0.0 ? 2.0 * wanted / (left + root) : 0.5;
            return -SW_PI + (i + fmin(along, 1.0)) * DIRECTION_STEP;
        }
        wanted -= piece;
    }
    return 0.0;
}

// Where in the distribution strip `number` goes, in (0, 1): the number's bits in reverse order, each turned over or not
// by a hash of the bits before it, and a random place within what they leave.
static double getDirectionPart(const Builder* builder, uint32_t number, int draw)
{
    uint32_t prefix = 1; // a one in front tells how many bits there are
    double part = 0.0, weight = 1.0;
    for (int bit = 0; bit < STRIP_BITS; ++bit)
    {
        uint32_t digit = number >> bit & 1;
        uint64_t hash = swHashWave(builder->def->seed, draw, (int)prefix, 0, STREAM_ORDER);
        weight *= 0.5;
        part += (digit ^ (uint32_t)(hash >> 63)) != 0 ? weight : 0.0;
        prefix = prefix << 1 | digit;
    }
    return part + weight * swHashToUnit(swHashWave(builder->def->seed, draw, (int)number, 0, STREAM_DIRECTION));
}

// The strip's direction by each draw, and what that is off.
static void drawDirections(Builder* builder, const Spread* spread, Strip* strip)
{
    uint32_t number = (uint32_t)(strip->band * builder->def->componentsPerOctave + strip->index);
    for (int draw = 0; draw < DRAWS; ++draw)
    {
        double direction = findDirection(spread, getDirectionPart(builder, number, draw)), moments[MOMENTS];
        strip->directions[draw] = (float)direction;
        fillMoments(direction, moments);
        for (int m = 0; m < MOMENTS; ++m)
        {
            builder->off[draw][m] += strip->energy * (moments[m] - spread->moments[m]);
        }
    }
}

static int chooseDraw(const Builder* builder)
{
    int best = 0;
    double least = (double)INFINITY;
    for (int draw = 0; draw < DRAWS; ++draw)
    {
        double square = 0.0;
        for (int m = 0; m < MOMENTS; ++m)
        {
            square += builder->off[draw][m] * builder->off[draw][m];
        }
        best = square < least ? draw : best;
        least = fmin(square, least);
    }
    return best;
}

// ---- strips ----

// A strip with energy, and a random place in it for its wave.
static void addStrip(Builder* builder, int band, int index, double k0, double k1)
{
    double omega0 = swGetOmega(&builder->dispersion, k0);
    double omega1 = swGetOmega(&builder->dispersion, k1);
    double energy = swIntegrateCompiled(builder->spectrum, omega0, omega1);
    if (!(energy > 0.0))
    {
        return;
    }
    double place = getUnit(builder, band, index, STREAM_PLACE);
    Strip* strip = &builder->strips[builder->stripCount++];
    strip->band = band;
    strip->index = index;
    strip->energy = energy;
    strip->omega = findPlace(builder, omega0, omega1, place * energy);
}

// Strips come longest first, so that bins come in ascending order. A bin without a strip's place leaves its energy to
// the next.
static void keepBins(Builder* builder)
{
    double wanted[SW_MAX_SPECTRUM_BINS], rest = 0.0;
    const swWaveSystemDef* def = builder->def;
    double first = swGetOmega(&builder->dispersion, TURN / (double)def->maxWavelength);
    double last = swGetOmega(&builder->dispersion, TURN / (double)def->minWavelength);
    int binCount = swGetCompiledBins(builder->spectrum, first, last, wanted);
    int bin = 0;
    for (int begin = 0, end = 0; begin < builder->stripCount && binCount > 1; begin = end)
    {
        int own = swFindCompiledBin(builder->spectrum, builder->strips[begin].omega);
        double found = 0.0;
        for (; end < builder->stripCount && swFindCompiledBin(builder->spectrum, builder->strips[end].omega) == own;
             ++end)
        {
            found += builder->strips[end].energy;
        }
        int lastBin = end == builder->stripCount ? binCount - 1 : own;
        for (rest = 0.0; bin <= lastBin; ++bin)
        {
            rest += wanted[bin];
        }
        for (int i = begin; i < end; ++i)
        {
            builder->strips[i].energy *= rest / found;
        }
    }
}

static void addWaves(Builder* builder, const Strip* strip, int draw)
{
    const swWaveSystemDef* def = builder->def;
    double direction = (double)def->spectrum.direction + (double)strip->directions[draw];
    double k = swGetWaveNumber(&builder->dispersion, strip->omega);
    double reverse = (double)def->reverseWeight;
    double amplitude = sqrt(2.0 * strip->energy / (1.0 + reverse * reverse));
    int twin = strip->index + def->componentsPerOctave;
    addWave(builder, k, direction, amplitude, TURN * getUnit(builder, strip->band, strip->index, STREAM_PHASE));
    addWave(builder, k, direction + SW_PI, reverse * amplitude,
            TURN * getUnit(builder, strip->band, twin, STREAM_PHASE));
}

// Shortest strips last, so that waves come longest first but for their places within a strip.
static void addStrips(Builder* builder)
{
    const swWaveSystemDef* def = builder->def;
    int count = def->componentsPerOctave;
    for (int band = SW_MAX_BANDS - 1; band >= 0; --band)
    {
        double longest = ldexp(1.0, band - 3);
        double ratio = swExp(-0.69314718055994530942 / count);
        for (int index = 0; index < count; ++index)
        {
            double shortest = index == count - 1 ? ldexp(1.0, band - 4) : longest * ratio;
            double high = fmin(longest, (double)def->maxWavelength);
            double low = fmax(shortest, (double)def->minWavelength);
            if (low < high)
            {
                addStrip(builder, band, index, TURN / high, TURN / low);
            }
            longest = shortest;
        }
    }
}

static swResult addOctaves(Builder* builder, const swHost* host)
{
    size_t size = (size_t)SW_MAX_BANDS * (size_t)builder->def->componentsPerOctave * sizeof(Strip);
    builder->strips = swAllocate(host, size);
    if (builder->strips == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    for (int i = 0; i < DIRECTIONS; ++i)
    {
        fillMoments(-SW_PI + i * DIRECTION_STEP, builder->circle[i]);
    }
    addStrips(builder);
    keepBins(builder);
    for (int i = 0; i < builder->stripCount; ++i)
    {
        Spread spread;
        fillSpread(builder, builder->strips[i].omega, &spread);
        drawDirections(builder, &spread, &builder->strips[i]);
    }
    int draw = chooseDraw(builder);
    for (int i = 0; i < builder->stripCount; ++i)
    {
        addWaves(builder, &builder->strips[i], draw);
    }
    swFree(host, builder->strips, size);
    return SW_SUCCESS;
}

static void holdChopBack(Builder* builder)
{
    double variance = 0.0, sum = 0.0;
    for (int i = 0; i < builder->count; ++i)
    {
        swStrain waveStrain = {0};
        swAddFreeWaveStrain(&waveStrain, &builder->waves[i]);
        double strain = (double)swGetStrainVariance(&waveStrain);
        variance += strain;
        sum += sqrt(2.0 * strain);
    }
    double deepest = fmin(RARELY * sqrt(variance), sum);
    double most = 1.0 - (double)builder->def->leastJacobian;
    if (deepest > most)
    {
        for (int i = 0; i < builder->count; ++i)
        {
            builder->waves[i].dx *= (float)(most / deepest);
            builder->waves[i].dz *= (float)(most / deepest);
        }
    }
}

static void addGivenWaves(Builder* builder)
{
    const swWaveSystemDef* def = builder->def;
    for (int i = 0; i < def->componentCount; ++i)
    {
        const swWaveComponent* component = &def->components[i];
        addWave(builder, TURN / (double)component->wavelength, (double)component->direction,
                (double)component->amplitude, (double)component->phase);
    }
}

static void sortWaves(swFreeWave* waves, int count)
{
    for (int i = 1; i < count; ++i)
    {
        swFreeWave wave = waves[i];
        int at = i;
        for (; at > 0 && waves[at - 1].wavelength < wave.wavelength; --at)
        {
            waves[at] = waves[at - 1];
        }
        waves[at] = wave;
    }
}

swResult swBuildFreeWaves(const swHost* host, const swWaveSystemDef* def, float gravity, float surfaceTension,
                          swFreeWave** waves, int* waveCount, swBandModes* bands)
{
    *waves = NULL;
    *waveCount = 0;
    swCompiledSpectrum* spectrum = NULL;
    swResult result = swCompileSpectrum(host, &def->spectrum, (double)gravity, (double)surfaceTension, &spectrum);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    Builder builder = {.def = def, .spectrum = spectrum, .dispersion = swGetCompiledDispersion(spectrum)};
    swWarnOfLongWaves(host, def, spectrum);
    builder.loopTicks = swGetLoopTicks(def);
    bool isGiven = def->componentCount > 0;
    builder.capacity = isGiven ? def->componentCount : 2 * SW_MAX_BANDS * def->componentsPerOctave;
    size_t size = (size_t)builder.capacity * sizeof(swFreeWave);
    builder.waves = swAllocate(host, size);
    result = builder.waves != NULL ? SW_SUCCESS : SW_ERROR_NO_MEMORY;
    if (result == SW_SUCCESS && isGiven)
    {
        addGivenWaves(&builder);
    }
    else if (result == SW_SUCCESS)
    {
        swFillWindLevels(spectrum, &def->spectrum, bands);
        result = addOctaves(&builder, host);
        holdChopBack(&builder);
    }
    if (result == SW_SUCCESS)
    {
        sortWaves(builder.waves, builder.count);
        size_t used = (size_t)builder.count * sizeof(swFreeWave);
        *waves = swAllocate(host, used);
        if (*waves != NULL)
        {
            memcpy(*waves, builder.waves, used);
            *waveCount = builder.count;
        }
        result = *waves != NULL || used == 0 ? SW_SUCCESS : SW_ERROR_NO_MEMORY;
    }
    swFree(host, builder.waves, size);
    swFreeCompiledSpectrum(host, spectrum);
    return result;
}
