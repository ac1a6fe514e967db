// SPDX-License-Identifier: MIT
// An octave of waves from L to 2 L is seen on a square of 48 L with three samples a wave at least, eight times in two
// periods of the shortest. Shorter waves are left out of the query, so that nothing is aliased; longer ones are told
// apart by the window. Heave of particles, h(x, t), is multiplied by Hann windows in x, z and t and transformed: of a
// wave number k, time's negative frequencies are waves that go along k, the positive ones waves against it. The energy
// at k is shared out by what both hold; so no dispersion relation is assumed, and standing waves would be seen as such.

#include "sea_patches.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sea_estimate.h"
#include "sea_transform.h"

#define PATCH_POINTS (PATCH_SIDE * PATCH_SIDE)
#define PATCH_WAVES 48.0 // shortest waves along a side

static double GetShortest(int octave)
{
    return ldexp(1.0, octave - 4);
}

bool CreatePatches(double shortest, double longest, SeaPatches* patches)
{
    int first = (int)floor(log2(shortest * 1.0001)) + 4, last = (int)floor(log2(longest * 0.9999)) + 4;
    *patches = (SeaPatches){.first = first, .count = last - first + 1};
    patches->power = calloc((size_t)patches->count * PATCH_POINTS, sizeof(double));
    return patches->power != NULL;
}

void DestroyPatches(SeaPatches* patches)
{
    free(patches->power);
    patches->power = NULL;
}

typedef struct PatchSpace
{
    swPosXZ* points;
    swVec3* displacement;
    double* window; // [PATCH_SIDE]
    SeaComplex *roots, *line;
    SeaComplex* spectra; // [PATCH_TIMES][PATCH_POINTS]
} PatchSpace;

static void* CreateSpace(PatchSpace* space)
{
    size_t complexCount = PATCH_SIDE / 2 + PATCH_SIDE + (size_t)PATCH_TIMES * PATCH_POINTS;
    size_t size = complexCount * sizeof(SeaComplex) + PATCH_SIDE * sizeof(double) + PATCH_POINTS * sizeof(swPosXZ) +
                  PATCH_POINTS * sizeof(swVec3);
    void* memory = malloc(size);
    if (memory == NULL)
    {
        return NULL;
    }
    space->roots = memory;
    space->line = space->roots + PATCH_SIDE / 2;
    space->spectra = space->line + PATCH_SIDE;
    space->window = (double*)(space->spectra + (size_t)PATCH_TIMES * PATCH_POINTS);
    space->points = (swPosXZ*)(space->window + PATCH_SIDE);
    space->displacement = (swVec3*)(space->points + PATCH_POINTS);
    FillRoots(PATCH_SIDE, space->roots);
    for (int i = 0; i < PATCH_SIDE; ++i)
    {
        // Scaled so that the mean of the square over both axes is 1: the expected variance stays.
        space->window[i] = sqrt(8.0 / 3.0) * (0.5 - 0.5 * cos(2.0 * SW_PI * i / PATCH_SIDE));
    }
    return memory;
}

// The square's spectra at all times.
static bool FillSpectra(swWorld* world, double begin, double dt, double shortest, PatchSpace* space)
{
    swQueryDef query = swDefaultQueryDef();
    query.minWavelength = (float)shortest;
    for (int time = 0; time < PATCH_TIMES; ++time)
    {
        SeaComplex* spectrum = space->spectra + (size_t)time * PATCH_POINTS;
        swWorld_SetTime(world, begin + dt * time);
        if (swWorld_Step(world, 0.0) != SW_SUCCESS)
        {
            return false;
        }
        swMoment_QueryParticles(swWorld_GetMoment(world), &query, PATCH_POINTS, space->points,
                                &(swSurfaceSamples){.displacement = space->displacement}, NULL, NULL);
        for (int i = 0; i < PATCH_POINTS; ++i)
        {
            double window = space->window[i % PATCH_SIDE] * space->window[i / PATCH_SIDE];
            spectrum[i] = (SeaComplex){window * (double)space->displacement[i].y, 0.0};
        }
        TransformSquare(spectrum, PATCH_SIDE, space->roots, space->line);
    }
    return true;
}

// Energy at a wave number, and the share of it that goes along the wave number.
static double ShareOut(const SeaComplex* spectra, int index, double* share)
{
    double along = 0.0, against = 0.0, total = 0.0;
    for (int j = 0; j < PATCH_TIMES; ++j)
    {
        SeaComplex sum = {0.0, 0.0};
        for (int time = 0; time < PATCH_TIMES; ++time)
        {
            double window = 0.5 - 0.5 * cos(2.0 * SW_PI * (time + 0.5) / PATCH_TIMES);
            double angle = -2.0 * SW_PI * j * time / PATCH_TIMES, c = window * cos(angle), s = window * sin(angle);
            SeaComplex value = spectra[(size_t)time * PATCH_POINTS + (size_t)index];
            sum.re += c * value.re - s * value.im;
            sum.im += c * value.im + s * value.re;
        }
        double power = sum.re * sum.re + sum.im * sum.im;
        against += j > 0 && j < PATCH_TIMES / 2 ? power : 0.0;
        along += j > PATCH_TIMES / 2 ? power : 0.0;
    }
    for (int time = 0; time < PATCH_TIMES; ++time)
    {
        SeaComplex value = spectra[(size_t)time * PATCH_POINTS + (size_t)index];
        total += (value.re * value.re + value.im * value.im) / PATCH_TIMES;
    }
    *share = along + against > 0.0 ? along / (along + against) : 0.5;
    return total;
}

static bool LookAtOctave(swWorld* world, double begin, double depth, int octave, int index, PatchSpace* space,
                         double* power)
{
    double shortest = GetShortest(octave), side = PATCH_WAVES * shortest, step = side / PATCH_SIDE;
    double dt = 0.25 / FindFrequency(shortest, depth, (double)swWorld_GetGravity(world));
    double dk = 2.0 * SW_PI / side, scale = 1.0 / ((double)PATCH_POINTS * PATCH_POINTS * dk * dk);
    double x = 911.3 * side * index, z = 577.7 * side * index;
    for (int i = 0; i < PATCH_POINTS; ++i)
    {
        space->points[i] = (swPosXZ){x + step * (i % PATCH_SIDE), z + step * (i / PATCH_SIDE)};
    }
    if (!FillSpectra(world, begin, dt, shortest, space))
    {
        return false;
    }
    for (int i = 0; i < PATCH_POINTS; ++i)
    {
        double share = 0.0, energy = ShareOut(space->spectra, i, &share);
        power[i] += 2.0 * scale * energy * share; // a real field says everything twice
    }
    return true;
}

bool LookAtPatches(swWorld* world, double begin, double depth, int index, SeaPatches* patches)
{
    PatchSpace space;
    void* memory = CreateSpace(&space);
    bool isFine = memory != NULL;
    for (int i = 0; i < patches->count && isFine; ++i)
    {
        isFine = LookAtOctave(world, begin, depth, patches->first + i, index, &space,
                              patches->power + (size_t)i * PATCH_POINTS);
    }
    patches->weight += 1.0;
    free(memory);
    return isFine;
}

void AddPatches(const SeaPatches* from, SeaPatches* to)
{
    to->weight += from->weight;
    for (size_t i = 0; i < (size_t)to->count * PATCH_POINTS; ++i)
    {
        to->power[i] += from->power[i];
    }
}

// Energy at a place between four wave numbers, in bins.
static double Interpolate(const double* power, double x, double z)
{
    double floorX = floor(x), floorZ = floor(z), sum = 0.0;
    for (int j = 0; j < 2; ++j)
    {
        for (int i = 0; i < 2; ++i)
        {
            int column = ((int)floorX + i + PATCH_SIDE) % PATCH_SIDE, row = ((int)floorZ + j + PATCH_SIDE) % PATCH_SIDE;
            double weight = (i == 1 ? x - floorX : 1.0 - x + floorX) * (j == 1 ? z - floorZ : 1.0 - z + floorZ);
            sum += weight * power[row * PATCH_SIDE + column];
        }
    }
    return sum;
}

double FindPatchDensity(const SeaPatches* patches, double frequency, double theta, double depth, double gravity)
{
    double length = FindWavelength(frequency, depth, gravity), k = 2.0 * SW_PI / length;
    int octave = (int)floor(log2(length)) + 4 - patches->first;
    if (octave < 0 || octave >= patches->count || !(patches->weight > 0.0))
    {
        return 0.0;
    }
    // S(k) k dk dtheta = S(f, theta) df dtheta.
    double above = 2.0 * SW_PI / FindWavelength(frequency * 1.001, depth, gravity);
    double slope = (above - k) / (frequency * 0.001);
    double bins = k * PATCH_WAVES * GetShortest(octave + patches->first) / (2.0 * SW_PI);
    const double* power = patches->power + (size_t)octave * PATCH_POINTS;
    return Interpolate(power, bins * cos(theta), bins * sin(theta)) * k * slope / patches->weight;
}
