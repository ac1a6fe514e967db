// SPDX-License-Identifier: MIT
// An octave of waves from L to 2 L is seen on a square of 48 L with three samples a wave at least, eight times in two
// periods of the shortest. Shorter waves are left out of the query, so that nothing is aliased; longer ones are told
// apart by the window. Heave of particles, h(x, t), is multiplied by Hann windows in x, z and t and transformed: of a
// wave number k, time's negative frequencies are waves that go along k, the positive ones waves against it. The energy
// at k is shared out by what both hold; so no dispersion relation is assumed, and standing waves would be seen as such.

#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "measure/measure_transform.h"
#include "seaway/measure.h"

#define PATCH_TIMES 8
#define PATCH_POINTS (SW_PATCH_SIDE * SW_PATCH_SIDE)
#define PATCH_WAVES 48.0 // shortest waves along a side

static double getShortest(int octave)
{
    return ldexp(1.0, octave - 4);
}

struct swSeaPatches
{
    swHost host;
    int first, count; // octaves: o holds wavelengths [2^(o - 4), 2^(o - 3)) m, as bands do
    double weight;    // squares summed
    double* power;    // [count][SW_PATCH_SIDE][SW_PATCH_SIDE] by kz, kx, in the order of the transform; m^4
};

swResult swCreateSeaPatches(const swHost* host, double shortest, double longest, swSeaPatches** patches)
{
    SW_REQUIRE_PLACE(host, patches, "swCreateSeaPatches()");
    SW_REQUIRE(shortest > 0.0 && longest > shortest && isfinite(longest), SW_ERROR_INVALID, host,
               "swCreateSeaPatches() needs two wavelengths, the shorter one first");
    int first = (int)floor(log2(shortest * 1.0001)) + 4, last = (int)floor(log2(longest * 0.9999)) + 4;
    int count = last - first + 1;
    size_t powerSize = (size_t)count * PATCH_POINTS * sizeof(double);
    swSeaPatches* made = swAllocateZero(host, sizeof(*made));
    double* power = swAllocateZero(host, powerSize);
    if (made == NULL || power == NULL)
    {
        swFree(host, made, sizeof(*made));
        swFree(host, power, powerSize);
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for squares of %d octaves, %zu bytes.", count, powerSize);
    }
    *made = (swSeaPatches){.host = *host, .first = first, .count = count, .power = power};
    *patches = made;
    return SW_SUCCESS;
}

void swDestroySeaPatches(swSeaPatches* patches)
{
    if (patches != NULL)
    {
        swHost host = patches->host;
        swFree(&host, patches->power, (size_t)patches->count * PATCH_POINTS * sizeof(double));
        swFree(&host, patches, sizeof(*patches));
    }
}

typedef struct PatchSpace
{
    swPosXZ* points;
    swVec3* displacement;
    double* window; // [SW_PATCH_SIDE]
    swMeasureComplex *roots, *line;
    swMeasureComplex* spectra; // [PATCH_TIMES][PATCH_POINTS]
} PatchSpace;

static size_t getSpaceSize(void)
{
    size_t complexCount = SW_PATCH_SIDE / 2 + SW_PATCH_SIDE + (size_t)PATCH_TIMES * PATCH_POINTS;
    return complexCount * sizeof(swMeasureComplex) + SW_PATCH_SIDE * sizeof(double) + PATCH_POINTS * sizeof(swPosXZ) +
           PATCH_POINTS * sizeof(swVec3);
}

static void* createSpace(const swHost* host, PatchSpace* space)
{
    void* memory = swAllocate(host, getSpaceSize());
    if (memory == NULL)
    {
        return NULL;
    }
    space->roots = memory;
    space->line = space->roots + SW_PATCH_SIDE / 2;
    space->spectra = space->line + SW_PATCH_SIDE;
    space->window = (double*)(space->spectra + (size_t)PATCH_TIMES * PATCH_POINTS);
    space->points = (swPosXZ*)(space->window + SW_PATCH_SIDE);
    space->displacement = (swVec3*)(space->points + PATCH_POINTS);
    swFillRoots(SW_PATCH_SIDE, space->roots);
    for (int i = 0; i < SW_PATCH_SIDE; ++i)
    {
        // Scaled so that the mean of the square over both axes is 1: the expected variance stays.
        space->window[i] = sqrt(8.0 / 3.0) * (0.5 - 0.5 * cos(2.0 * SW_PI * i / SW_PATCH_SIDE));
    }
    return memory;
}

// The square's spectra at all times.
static swResult fillSpectra(swWorld* world, double begin, double dt, double shortest, PatchSpace* space)
{
    swQueryDef query = swDefaultQueryDef();
    query.minWavelength = (float)shortest;
    for (int time = 0; time < PATCH_TIMES; ++time)
    {
        swMeasureComplex* spectrum = space->spectra + (size_t)time * PATCH_POINTS;
        swWorld_SetTime(world, begin + dt * time);
        swResult result = swWorld_Step(world, 0.0);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        swMoment_QueryParticles(swWorld_GetMoment(world), &query, PATCH_POINTS, space->points,
                                &(swSurfaceSamples){.displacement = space->displacement}, NULL, NULL);
        for (int i = 0; i < PATCH_POINTS; ++i)
        {
            double window = space->window[i % SW_PATCH_SIDE] * space->window[i / SW_PATCH_SIDE];
            spectrum[i] = (swMeasureComplex){window * (double)space->displacement[i].y, 0.0};
        }
        swTransformSquare(spectrum, SW_PATCH_SIDE, space->roots, space->line);
    }
    return SW_SUCCESS;
}

// Energy at a wave number, and the share of it that goes along the wave number.
static double shareOut(const swMeasureComplex* spectra, int index, double* share)
{
    double along = 0.0, against = 0.0, total = 0.0;
    for (int j = 0; j < PATCH_TIMES; ++j)
    {
        swMeasureComplex sum = {0.0, 0.0};
        for (int time = 0; time < PATCH_TIMES; ++time)
        {
            double window = 0.5 - 0.5 * cos(2.0 * SW_PI * (time + 0.5) / PATCH_TIMES);
            double angle = -2.0 * SW_PI * j * time / PATCH_TIMES, c = window * cos(angle), s = window * sin(angle);
            swMeasureComplex value = spectra[(size_t)time * PATCH_POINTS + (size_t)index];
            sum.re += c * value.re - s * value.im;
            sum.im += c * value.im + s * value.re;
        }
        double power = sum.re * sum.re + sum.im * sum.im;
        against += j > 0 && j < PATCH_TIMES / 2 ? power : 0.0;
        along += j > PATCH_TIMES / 2 ? power : 0.0;
    }
    for (int time = 0; time < PATCH_TIMES; ++time)
    {
        swMeasureComplex value = spectra[(size_t)time * PATCH_POINTS + (size_t)index];
        total += (value.re * value.re + value.im * value.im) / PATCH_TIMES;
    }
    *share = along + against > 0.0 ? along / (along + against) : 0.5;
    return total;
}

static swResult lookAtOctave(swWorld* world, double begin, double depth, int octave, int index, PatchSpace* space,
                             double* power)
{
    double shortest = getShortest(octave), side = PATCH_WAVES * shortest, step = side / SW_PATCH_SIDE;
    double dt = 0.25 / swGetWaveFrequency(shortest, depth, (double)swWorld_GetGravity(world));
    double dk = 2.0 * SW_PI / side, scale = 1.0 / ((double)PATCH_POINTS * PATCH_POINTS * dk * dk);
    double x = 911.3 * side * index, z = 577.7 * side * index;
    for (int i = 0; i < PATCH_POINTS; ++i)
    {
        space->points[i] = (swPosXZ){x + step * (i % SW_PATCH_SIDE), z + step * (i / SW_PATCH_SIDE)};
    }
    swResult result = fillSpectra(world, begin, dt, shortest, space);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    for (int i = 0; i < PATCH_POINTS; ++i)
    {
        double share = 0.0, energy = shareOut(space->spectra, i, &share);
        power[i] += 2.0 * scale * energy * share; // a real field says everything twice
    }
    return SW_SUCCESS;
}

swResult swLookAtPatches(swWorld* world, double begin, double depth, int index, swSeaPatches* patches)
{
    const swHost* told = patches != NULL ? &patches->host : swFindHost(world);
    SW_REQUIRE(patches != NULL && world != NULL && fabs(begin) <= SW_LARGEST_TIME && depth > 0.0, SW_ERROR_INVALID,
               told, "swLookAtPatches() needs a world, patches, a time and a depth above 0");
    PatchSpace space;
    void* memory = createSpace(&patches->host, &space);
    if (memory == NULL)
    {
        return swFail(&patches->host, SW_ERROR_NO_MEMORY, "No memory to look at a square of the sea, %zu bytes.",
                      getSpaceSize());
    }
    swResult result = SW_SUCCESS;
    for (int i = 0; i < patches->count && result == SW_SUCCESS; ++i)
    {
        result = lookAtOctave(world, begin, depth, patches->first + i, index, &space,
                              patches->power + (size_t)i * PATCH_POINTS);
    }
    patches->weight += 1.0;
    swFree(&patches->host, memory, getSpaceSize());
    return result;
}

void swAddSeaPatches(const swSeaPatches* from, swSeaPatches* to)
{
    const swHost* host = to != NULL ? &to->host : from != NULL ? &from->host : NULL;
    SW_REQUIRE_VOID(from != NULL && to != NULL && from->first == to->first && from->count == to->count, host,
                    "swAddSeaPatches() needs two patches of the same wavelengths");
    to->weight += from->weight;
    for (size_t i = 0; i < (size_t)to->count * PATCH_POINTS; ++i)
    {
        to->power[i] += from->power[i];
    }
}

// Energy at a place between four wave numbers, in bins.
static double interpolate(const double* power, double x, double z)
{
    double floorX = floor(x), floorZ = floor(z), sum = 0.0;
    for (int j = 0; j < 2; ++j)
    {
        for (int i = 0; i < 2; ++i)
        {
            int column = ((int)floorX + i + SW_PATCH_SIDE) % SW_PATCH_SIDE,
                row = ((int)floorZ + j + SW_PATCH_SIDE) % SW_PATCH_SIDE;
            double weight = (i == 1 ? x - floorX : 1.0 - x + floorX) * (j == 1 ? z - floorZ : 1.0 - z + floorZ);
            sum += weight * power[row * SW_PATCH_SIDE + column];
        }
    }
    return sum;
}

double swEstimatePatchDensity(const swSeaPatches* patches, double frequency, double theta, double depth, double gravity)
{
    SW_REQUIRE(patches != NULL, (double)NAN, NULL, "swEstimatePatchDensity() needs patches");
    if (!isfinite(frequency) || !isfinite(theta) || !(depth > 0.0) || !isfinite(gravity))
    {
        return (double)NAN;
    }
    double length = swGetWavelength(frequency, depth, gravity), k = 2.0 * SW_PI / length;
    int octave = (int)floor(log2(length)) + 4 - patches->first;
    if (octave < 0 || octave >= patches->count || !(patches->weight > 0.0))
    {
        return 0.0;
    }
    // S(k) k dk dtheta = S(f, theta) df dtheta.
    double above = 2.0 * SW_PI / swGetWavelength(frequency * 1.001, depth, gravity);
    double slope = (above - k) / (frequency * 0.001);
    double bins = k * PATCH_WAVES * getShortest(octave + patches->first) / (2.0 * SW_PI);
    const double* power = patches->power + (size_t)octave * PATCH_POINTS;
    return interpolate(power, bins * cos(theta), bins * sin(theta)) * k * slope / patches->weight;
}
