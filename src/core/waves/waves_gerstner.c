// SPDX-License-Identifier: MIT

// A sea of a few trochoidal waves [Gerstner 1802] [Fournier 1986], each with its exact wave vector, so that it never
// repeats and goes just where it should.
//
// Each octave is cut into componentsPerOctave strips of equal ratio of wavelength. A strip's wave has all of its energy,
// sits at a random place of it (as probable as the energy there) and goes in a direction of the spectrum's distribution:
// the circle is cut into as many parts of equal probability as the octave has waves, and each wave gets one of them.
// Which one, where in the strip, and with which phase are drawn independently of each other.
//
// reverseWeight gives each wave a twin that runs the other way with that part of its height; the two share the energy.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/math/random.h"
#include "core/math/scalar.h"
#include "core/waves/waves_fft.h"

#define TURN (2.0 * SW_PI)

// Points of the circle at which the distribution of directions is summed.
#define DIRECTIONS 360

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

typedef struct Builder
{
    const swWaveSystemDef* def;
    const swCompiledSpectrum* spectrum;
    swDispersion dispersion;
    int64_t loopTicks;
    int capacity;
    int count;
    swFreeWave* waves;
} Builder;

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

// The direction below which a part of the waves of omega go, counted from the mean direction's opposite.
static double findDirection(const Builder* builder, double omega, double part)
{
    const swWaveSystemDef* def = builder->def;
    double mean = (double)def->spectrum.direction;
    if (def->directionVariance > 0.0f)
    {
        return mean + (2.0 * part - 1.0) * (double)def->directionVariance;
    }
    double density[DIRECTIONS + 1];
    double total = 0.0;
    double step = TURN / DIRECTIONS;
    for (int i = 0; i <= DIRECTIONS; ++i)
    {
        density[i] = swGetCompiledDensity2(builder->spectrum, omega, mean - SW_PI + i * step);
        total += i > 0 ? 0.5 * (density[i - 1] + density[i]) : 0.0;
    }
    double wanted = part * total;
    for (int i = 0; i < DIRECTIONS; ++i)
    {
        double piece = 0.5 * (density[i] + density[i + 1]);
        if (wanted <= piece || i == DIRECTIONS - 1)
        {
            // Within a piece the density is linear: solve a t^2 / 2 + density t = wanted.
            double slope = density[i + 1] - density[i];
            double root = sqrt(fmax(density[i] * density[i] + 2.0 * slope * wanted, 0.0));
            double along = density[i] + root > 0.0 ? 2.0 * wanted / (density[i] + root) : 0.5;
            return mean - SW_PI + (i + fmin(along, 1.0)) * step;
        }
        wanted -= piece;
    }
    return mean;
}

// The place of `index` in a random order of `count` things.
static int getShuffled(const Builder* builder, int band, int index, int count)
{
    uint64_t own = swHashWave(builder->def->seed, band, index, 0, STREAM_ORDER);
    int place = 0;
    for (int i = 0; i < count; ++i)
    {
        uint64_t other = swHashWave(builder->def->seed, band, i, 0, STREAM_ORDER);
        place += other < own || (other == own && i < index) ? 1 : 0;
    }
    return place;
}

static void addComponent(Builder* builder, int band, int index, double k0, double k1)
{
    const swWaveSystemDef* def = builder->def;
    double omega0 = swGetOmega(&builder->dispersion, k0);
    double omega1 = swGetOmega(&builder->dispersion, k1);
    double energy = swIntegrateCompiled(builder->spectrum, omega0, omega1);
    if (!(energy > 0.0))
    {
        return;
    }
    double place = getUnit(builder, band, index, STREAM_PLACE);
    double omega = findPlace(builder, omega0, omega1, place * energy);
    double k = swGetWaveNumber(&builder->dispersion, omega);
    int count = def->componentsPerOctave;
    double part = (getShuffled(builder, band, index, count) + getUnit(builder, band, index, STREAM_DIRECTION)) / count;
    double direction = findDirection(builder, omega, part);
    double reverse = (double)def->reverseWeight;
    double amplitude = sqrt(2.0 * energy / (1.0 + reverse * reverse));
    addWave(builder, k, direction, amplitude, TURN * getUnit(builder, band, index, STREAM_PHASE));
    addWave(builder, k, direction + SW_PI, reverse * amplitude,
            TURN * getUnit(builder, band, index + count, STREAM_PHASE));
}

// Shortest strips last, so that waves come longest first but for their places within a strip.
static void addOctaves(Builder* builder)
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
                addComponent(builder, band, index, TURN / high, TURN / low);
            }
            longest = shortest;
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
                          swFreeWave** waves, int* waveCount)
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
    builder.loopTicks = swGetLoopTicks(def);
    bool isGiven = def->componentCount > 0;
    builder.capacity = isGiven ? def->componentCount : 2 * SW_MAX_BANDS * def->componentsPerOctave;
    size_t size = (size_t)builder.capacity * sizeof(swFreeWave);
    builder.waves = swAllocate(host, size);
    if (builder.waves != NULL)
    {
        (isGiven ? addGivenWaves : addOctaves)(&builder);
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
    else
    {
        result = SW_ERROR_NO_MEMORY;
    }
    swFree(host, builder.waves, size);
    swFreeCompiledSpectrum(host, spectrum);
    return result;
}
