// SPDX-License-Identifier: MIT
// Integral parameters: moments of the energy over frequency, and its first circular moment over direction.

#include <math.h>
#include <string.h>

#include "core/math/scalar.h"
#include "core/spectra/compiled.h"
#include "core/base/misuse.h"

// Formulas are integrated up to this where no limit is asked for: waves of 6 cm, the shortest band.
#define MAX_FORMULA_FREQUENCY 5.0

// First circular moments of energy: integrals of S cos and S sin.
typedef struct Vector
{
    double x, y;
} Vector;

static Vector getRowVector(const swCompiledSpectrum* spectrum, int row)
{
    Vector vector;
    swGetBinVector(spectrum, row, &vector.x, &vector.y);
    return vector;
}

// Of a table over a range of frequencies, calibrated. Of a part of a bin the directions are those of the bin.
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
        double width = spectrum->edges[i + 1] - spectrum->edges[i];
        double share = spectrum->scale * width * swGetBinPart(spectrum, i, frequency0, frequency1);
        total.x += share * row.x;
        total.y += share * row.y;
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

// Where in [frequency0, frequency1] the density is largest. Most formulas have one peak that is known; of a table it is
// the frequency of the bin whose mean is largest, or an end of the range. Bins that are equal but for rounding tie, and
// the lowest frequency wins.
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
    double largest = SW_TURN * swGetTableDensity(spectrum, SW_TURN * frequency0);
    for (int i = 0; i < spectrum->table.frequencyCount; ++i)
    {
        double frequency = (double)spectrum->table.frequencies[i];
        double density = spectrum->scale * spectrum->energy[i];
        if (frequency >= frequency0 && frequency <= frequency1 && density > largest * (1.0 + 1e-6))
        {
            best = frequency;
            largest = density;
        }
    }
    return SW_TURN * swGetTableDensity(spectrum, SW_TURN * frequency1) > largest * (1.0 + 1e-6) ? frequency1 : best;
}

static Vector getPeakVector(const swCompiledSpectrum* spectrum, double frequency)
{
    int bin = swFindTableBin(spectrum, frequency), last = spectrum->table.frequencyCount - 1;
    return getRowVector(spectrum, bin < 0 ? 0 : bin > last ? last : bin);
}

static void sumBins(const swCompiledSpectrum* spectrum, swSpectrumMoments* moments, Vector* vector)
{
    for (int i = 0; i < spectrum->table.frequencyCount; ++i)
    {
        double width = spectrum->scale * (spectrum->edges[i + 1] - spectrum->edges[i]);
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
