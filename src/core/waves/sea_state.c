// SPDX-License-Identifier: MIT
// Integral parameters: moments of the energy over frequency, and its first circular moment over direction.

#include <math.h>
#include <string.h>

#include "core/math/scalar.h"
#include "core/waves/compiled.h"
#include "core/base/misuse.h"

// Formulas are integrated up to this where no limit is asked for: waves of 6 cm, the shortest band.
#define MAX_FORMULA_FREQUENCY 5.0

// First circular moments of energy: integrals of S cos and S sin.
typedef struct Vector
{
    double x, y;
} Vector;

// Of one bin of a table, not scaled. Linear interpolation between directions keeps sinc^2(half a step) of the sums.
static Vector getRowVector(const swCompiledSpectrum* spectrum, int row)
{
    int count = spectrum->table.directionCount;
    const float* density = spectrum->table.density + (size_t)row * (size_t)count;
    double half = SW_PI / count;
    double sinc = swSin(half) / half;
    Vector sum = {0.0, 0.0};
    for (int i = 0; i < count; ++i)
    {
        double angle = 2.0 * half * i + (double)spectrum->table.firstDirection + spectrum->direction;
        sum.x += (double)density[i] * swCos(angle);
        sum.y += (double)density[i] * swSin(angle);
    }
    double scale = 2.0 * half * sinc * sinc;
    return (Vector){sum.x * scale, sum.y * scale};
}

// Of a table over a range of frequencies, calibrated. Linear between bins as the density is.
static Vector integrateVector(const swCompiledSpectrum* spectrum, double frequency0, double frequency1)
{
    const swSpectrumTable* table = &spectrum->table;
    Vector total = {0.0, 0.0};
    Vector tail = {0.0, 0.0};
    double tailEnergy = 0.0;
    for (int i = 0; i < table->frequencyCount; ++i)
    {
        Vector row = getRowVector(spectrum, i);
        if (i >= table->frequencyCount - swGetTailBins(table))
        {
            tail.x += row.x;
            tail.y += row.y;
            tailEnergy += spectrum->energy[i];
        }
        // The bin's share is the integral of its hat: 1 at its centre, 0 at its neighbours', 1 outside of the ends.
        double left = i > 0 ? (double)table->frequencies[i - 1] : spectrum->lowEdge;
        double centre = (double)table->frequencies[i];
        double right = i + 1 < table->frequencyCount ? (double)table->frequencies[i + 1] : spectrum->highEdge;
        double share = 0.0;
        double a = left > frequency0 ? left : frequency0;
        double b = centre < frequency1 ? centre : frequency1;
        if (b > a)
        {
            double climb = i > 0 ? (0.5 * (a + b) - left) / (centre - left) : 1.0;
            share += (b - a) * climb;
        }
        a = centre > frequency0 ? centre : frequency0;
        b = right < frequency1 ? right : frequency1;
        if (b > a)
        {
            double fall = i + 1 < table->frequencyCount ? (right - 0.5 * (a + b)) / (right - centre) : 1.0;
            share += (b - a) * fall;
        }
        total.x += spectrum->scale * share * row.x;
        total.y += spectrum->scale * share * row.y;
    }
    double begin = frequency0 > spectrum->highEdge ? frequency0 : spectrum->highEdge;
    if (frequency1 > begin && tailEnergy > 0.0)
    {
        double variance = swIntegrateCompiled(spectrum, SW_TURN * begin, SW_TURN * frequency1);
        total.x += variance * tail.x / tailEnergy;
        total.y += variance * tail.y / tailEnergy;
    }
    return total;
}

// Where in [frequency0, frequency1] the density is largest. Most formulas have one peak that is known; a table is linear
// between its bins and falls beyond them. Bins that are equal but for rounding tie, and the lowest frequency wins.
static double findPeak(const swCompiledSpectrum* spectrum, double frequency0, double frequency1)
{
    if (spectrum->kind == SW_SPECTRUM_TMA || spectrum->kind == SW_SPECTRUM_ELFOUHAILY ||
        spectrum->kind == SW_SPECTRUM_OCTAVES)
    {
        return swFindFormulaPeak(spectrum, SW_TURN * frequency0, SW_TURN * frequency1) / SW_TURN;
    }
    if (spectrum->kind != SW_SPECTRUM_TABLE)
    {
        double peak = spectrum->peakOmega / SW_TURN;
        return peak < frequency0 ? frequency0 : peak > frequency1 ? frequency1 : peak;
    }
    double best = frequency0;
    double largest = swGetTableDensity(spectrum, SW_TURN * frequency0);
    for (int i = 0; i < spectrum->table.frequencyCount; ++i)
    {
        double frequency = (double)spectrum->table.frequencies[i];
        double density = swGetTableDensity(spectrum, SW_TURN * frequency);
        if (frequency >= frequency0 && frequency <= frequency1 && density > largest * (1.0 + 1e-6))
        {
            best = frequency;
            largest = density;
        }
    }
    return swGetTableDensity(spectrum, SW_TURN * frequency1) > largest ? frequency1 : best;
}

static Vector getPeakVector(const swCompiledSpectrum* spectrum, double frequency)
{
    swTablePlace place = swFindTablePlace(&spectrum->table, frequency);
    Vector a = getRowVector(spectrum, place.index);
    Vector b = getRowVector(spectrum, place.index + 1);
    double keep = 1.0 - place.fraction;
    return (Vector){keep * a.x + place.fraction * b.x, keep * a.y + place.fraction * b.y};
}

static void sumBins(const swCompiledSpectrum* spectrum, swSpectrumMoments* moments, Vector* vector)
{
    for (int i = 0; i < spectrum->table.frequencyCount; ++i)
    {
        double width = spectrum->binScale * (double)spectrum->table.bandwidths[i];
        Vector row = getRowVector(spectrum, i);
        swAddSpectrumMoments(moments, spectrum, SW_TURN * (double)spectrum->table.frequencies[i],
                             width * spectrum->energy[i]);
        vector->x += width * row.x;
        vector->y += width * row.y;
    }
}

swResult swSpectrum_GetSeaState(const swSpectrumDef* def, float minFrequency, float maxFrequency, swSeaState* seaState)
{
    if (seaState != NULL)
    {
        memset(seaState, 0, sizeof(*seaState));
    }
    SW_REQUIRE(def != NULL && seaState != NULL, SW_ERROR_INVALID, NULL,
               "swSpectrum_GetSeaState() needs a def and a place for the sea state");
    swCompiledSpectrum spectrum;
    swComplaint complaint;
    if (!(minFrequency >= 0.0f && maxFrequency >= minFrequency && maxFrequency <= 1000.0f) ||
        !swPrepareSpectrum(&spectrum, def, SW_STANDARD_GRAVITY, SW_STANDARD_SURFACE_TENSION, &complaint))
    {
        return SW_ERROR_INVALID;
    }

    bool isTable = def->kind == SW_SPECTRUM_TABLE;
    bool isWhole = maxFrequency == 0.0f;
    double low = (double)minFrequency;
    double high = isWhole ? (isTable ? spectrum.highEdge : MAX_FORMULA_FREQUENCY) : (double)maxFrequency;
    swSpectrumMoments moments = {.isFull = true};
    Vector vector = {0.0, 0.0};
    if (isTable && isWhole)
    {
        sumBins(&spectrum, &moments, &vector);
    }
    else
    {
        swIntegrateMoments(&spectrum, SW_TURN * low, SW_TURN * high, &moments);
        vector = isTable ? integrateVector(&spectrum, low, high) : vector;
    }
    double m0 = moments.zero;
    if (!(m0 > 1e-20))
    {
        return SW_ERROR_INVALID;
    }

    double r1 = moments.r1 / m0;
    double peak = findPeak(&spectrum, low, high);
    double meanDirection = spectrum.direction;
    double peakDirection = spectrum.direction;
    if (isTable)
    {
        Vector peakVector = getPeakVector(&spectrum, peak);
        r1 = sqrt(vector.x * vector.x + vector.y * vector.y) / m0;
        meanDirection = swAtan2(vector.y, vector.x);
        peakDirection = swAtan2(peakVector.y, peakVector.x);
    }
    seaState->significantHeight = (float)(4.0 * sqrt(m0));
    seaState->peakPeriod = (float)(1.0 / peak);
    seaState->periodTm01 = (float)(SW_TURN * m0 / moments.one);
    seaState->periodTm02 = (float)(SW_TURN * sqrt(m0 / moments.two));
    seaState->energyPeriod = (float)(SW_TURN * moments.minusOne / m0);
    seaState->meanDirection = (float)meanDirection;
    seaState->peakDirection = (float)peakDirection;
    seaState->spread = (float)sqrt(2.0 * (r1 < 1.0 ? 1.0 - r1 : 0.0));
    seaState->meanSquareSlope = (float)moments.slope;
    return SW_SUCCESS;
}
