// SPDX-License-Identifier: MIT
// Frequency bins, and the waves that belong to a frequency.

#include <math.h>

#include "core/base/misuse.h"
#include "seaway/measure.h"

// Over density, m^3/s^2: what swDefaultWorldDef() has.
#define SURFACE_TENSION 7.4e-5

void swMakeTableBins(const swSpectrumTable* table, swSeaBins* bins)
{
    SW_REQUIRE_VOID(table != NULL && bins != NULL, NULL, "swMakeTableBins() needs a table and a place for its bins");
    bins->count = table->frequencyCount < SW_MAX_SEA_BINS ? table->frequencyCount : SW_MAX_SEA_BINS;
    double edges[SW_MAX_SEA_BINS + 1];
    swSpectrumTable_GetEdges(table, edges);
    for (int i = 0; i < bins->count; ++i)
    {
        bins->center[i] = (double)table->frequencies[i];
        bins->low[i] = edges[i];
        bins->high[i] = edges[i + 1];
    }
}

static double sumTableRow(const swSpectrumTable* table, int row)
{
    double sum = 0.0;
    for (int i = 0; i < table->directionCount; ++i)
    {
        sum += (double)table->density[(size_t)row * (size_t)table->directionCount + (size_t)i];
    }
    return sum;
}

double swGetTableDuration(const swSpectrumTable* table)
{
    SW_REQUIRE(table != NULL, SW_LONGEST_TABLE_RECORD, NULL, "swGetTableDuration() needs a table");
    swSeaBins bins;
    swMakeTableBins(table, &bins);
    double most = 0.0, narrowest = (double)INFINITY;
    for (int i = 0; i < bins.count; ++i)
    {
        most = fmax(most, sumTableRow(table, i));
    }
    for (int i = 0; i < bins.count; ++i)
    {
        bool holdsMuch = sumTableRow(table, i) >= 0.25 * most;
        narrowest = holdsMuch ? fmin(narrowest, bins.high[i] - bins.low[i]) : narrowest;
    }
    return fmin(8.0 / narrowest, SW_LONGEST_TABLE_RECORD);
}

void swMakeEqualBins(double low, double high, int count, swSeaBins* bins)
{
    SW_REQUIRE_VOID(bins != NULL && count > 0 && low >= 0.0 && high > low && isfinite(high), NULL,
                    "swMakeEqualBins() needs 0 <= low < high, at least one bin, and a place for them");
    bins->count = count < SW_MAX_SEA_BINS ? count : SW_MAX_SEA_BINS;
    double width = (high - low) / bins->count;
    for (int i = 0; i < bins->count; ++i)
    {
        bins->low[i] = low + width * i;
        bins->high[i] = low + width * (i + 1);
        bins->center[i] = low + width * (i + 0.5);
    }
}

void swMakeGrowingBins(double low, double high, double width, double part, swSeaBins* bins)
{
    SW_REQUIRE_VOID(bins != NULL && low >= 0.0 && high > low && isfinite(high) && width > 0.0 && isfinite(width) &&
                        part >= 0.0 && isfinite(part),
                    NULL, "swMakeGrowingBins() needs 0 <= low < high, a width above 0, and a place for the bins");
    bins->count = 0;
    while (low < high * (1.0 - 1e-9) && bins->count < SW_MAX_SEA_BINS)
    {
        int i = bins->count++;
        bins->low[i] = low;
        bins->high[i] = fmin(low + fmax(width, part * low), high);
        bins->center[i] = 0.5 * (bins->low[i] + bins->high[i]);
        low = bins->high[i];
    }
}

static bool isWater(double depth, double gravity)
{
    return depth > 0.0 && gravity > 0.0 && isfinite(gravity);
}

double swGetWaveFrequency(double wavelength, double depth, double gravity)
{
    if (!(wavelength > 0.0) || !isWater(depth, gravity))
    {
        return (double)NAN;
    }
    double k = 2.0 * SW_PI / wavelength;
    double omega2 = (gravity * k + SURFACE_TENSION * k * k * k) * (isfinite(depth) ? tanh(k * depth) : 1.0);
    return sqrt(omega2) / (2.0 * SW_PI);
}

double swGetWavelength(double frequency, double depth, double gravity)
{
    if (!(frequency >= 0.0) || !isWater(depth, gravity))
    {
        return (double)NAN;
    }
    double shortest = 1e-4, longest = 1e7; // the frequency falls with the length
    for (int i = 0; i < 80; ++i)
    {
        double middle = sqrt(shortest * longest);
        if (swGetWaveFrequency(middle, depth, gravity) > frequency)
        {
            shortest = middle;
        }
        else
        {
            longest = middle;
        }
    }
    return longest;
}
