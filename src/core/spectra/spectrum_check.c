// SPDX-License-Identifier: MIT

#include "core/spectra/compiled.h"

#include <math.h>
#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define MIN_FREQUENCIES 2
#define MIN_DIRECTIONS 4
#define MAX_DIRECTIONS 720

bool swComplain(swComplaint* complaint, const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(complaint->text, sizeof(complaint->text), format, arguments);
    va_end(arguments);
    return false;
}

static bool checkRange(swComplaint* complaint, const char* field, float value, double low, double high, bool openLow)
{
    double x = (double)value;
    if ((openLow ? x > low : x >= low) && x <= high)
    {
        return true; // false for NaN
    }
    return swComplain(complaint, "The spectrum's %s is %g; its range is %s%g, %g].", field, x, openLow ? "(" : "[", low,
                      high);
}

static bool checkFrequencies(swComplaint* complaint, const swSpectrumTable* table)
{
    for (int i = 0; i < table->frequencyCount; ++i)
    {
        double frequency = (double)table->frequencies[i];
        double before = i > 0 ? (double)table->frequencies[i - 1] : 0.0;
        if (!(frequency > before && frequency <= 1000.0))
        {
            return swComplain(complaint,
                              "The spectrum table's frequency %d is %g Hz; it must be above %g and at most 1000.", i,
                              frequency, before);
        }
        double width = (double)table->bandwidths[i];
        double widest = i == 0 ? 2.0 * frequency : 1000.0; // the first bin begins at 0 or above
        if (!(width > 0.0 && width <= widest))
        {
            return swComplain(complaint, "The spectrum table's bandwidth %d is %g Hz; its range is (0, %g].", i, width,
                              widest);
        }
    }
    return true;
}

static bool checkTable(swComplaint* complaint, const swSpectrumTable* table)
{
    if (table == NULL || table->frequencies == NULL || table->bandwidths == NULL || table->density == NULL)
    {
        return swComplain(complaint, "The spectrum is a table, but its table or one of the table's arrays is NULL.");
    }
    if (table->frequencyCount < MIN_FREQUENCIES || table->frequencyCount > SW_MAX_TABLE_FREQUENCIES)
    {
        return swComplain(complaint, "The spectrum table has %d frequencies; its range is [%d, %d].",
                          table->frequencyCount, MIN_FREQUENCIES, SW_MAX_TABLE_FREQUENCIES);
    }
    if (table->directionCount < MIN_DIRECTIONS || table->directionCount > MAX_DIRECTIONS)
    {
        return swComplain(complaint, "The spectrum table has %d directions; its range is [%d, %d].",
                          table->directionCount, MIN_DIRECTIONS, MAX_DIRECTIONS);
    }
    if (!checkFrequencies(complaint, table) ||
        !checkRange(complaint, "table's firstDirection", table->firstDirection, -SW_TURN, SW_TURN, false))
    {
        return false;
    }
    int count = table->frequencyCount * table->directionCount;
    for (int i = 0; i < count; ++i)
    {
        if (!(table->density[i] >= 0.0f && table->density[i] <= 1e6f))
        {
            return swComplain(
                complaint,
                "The spectrum table's density at frequency %d, direction %d is %g m^2/Hz/rad; its range is "
                "[0, 1e6].",
                i / table->directionCount, i % table->directionCount, (double)table->density[i]);
        }
    }
    return true;
}

static bool checkOctaves(swComplaint* complaint, const swOctaves* octaves)
{
    if (!checkRange(complaint, "octaves' multiplier", octaves->multiplier, 0.0, 10.0, false) ||
        !checkRange(complaint, "octaves' chop", octaves->chop, 0.0, 4.0, false) ||
        !checkRange(complaint, "octaves' gravityScale", octaves->gravityScale, 0.0, 25.0, false))
    {
        return false;
    }
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        const swOctave* octave = &octaves->octaves[i];
        char name[40];
        snprintf(name, sizeof(name), "octave %d, its power,", i);
        bool isFine = checkRange(complaint, name, octave->power, -10.0, 5.0, false);
        snprintf(name, sizeof(name), "octave %d, its chop,", i);
        isFine = isFine && checkRange(complaint, name, octave->chop, 0.0, 4.0, false);
        snprintf(name, sizeof(name), "octave %d, its gravityScale,", i);
        if (!isFine || !checkRange(complaint, name, octave->gravityScale, 0.0, 4.0, false))
        {
            return false;
        }
    }
    return true;
}

static bool checkDirections(swComplaint* complaint, const swSpectrumDef* def)
{
    if ((int)def->spreading < 0 || def->spreading >= SW_SPREADING_KIND_COUNT)
    {
        return swComplain(complaint, "The spectrum's spreading is %d; its range is [0, %d].", (int)def->spreading,
                          SW_SPREADING_KIND_COUNT - 1);
    }
    return checkRange(complaint, "spreadExponent", def->spreadExponent, 0.0, 200.0, false) &&
           checkRange(complaint, "turbulence", def->turbulence, 0.0, 1.0, false) &&
           checkRange(complaint, "swell", def->swell, 0.0, 1.0, false);
}

bool swCheckSpectrumDef(swComplaint* complaint, const swSpectrumDef* def)
{
    if ((int)def->kind < 0 || def->kind >= SW_SPECTRUM_KIND_COUNT)
    {
        return swComplain(complaint, "The spectrum's kind is %d; its range is [0, %d].", (int)def->kind,
                          SW_SPECTRUM_KIND_COUNT - 1);
    }
    if (!checkRange(complaint, "significantHeight", def->significantHeight, 0.0, 40.0, false) ||
        !checkRange(complaint, "direction", def->direction, -1000.0, 1000.0, false) ||
        !checkRange(complaint, "depth", def->depth, 0.001, (double)INFINITY, false))
    {
        return false;
    }
    if (def->kind == SW_SPECTRUM_TABLE)
    {
        return (!def->hasWind || checkRange(complaint, "windSpeed", def->windSpeed, 0.0, 100.0, true)) &&
               checkTable(complaint, def->table);
    }
    if (!checkRange(complaint, "windSpeed", def->windSpeed, 0.0, 100.0, true) ||
        !checkRange(complaint, "peakPeriod", def->peakPeriod, 0.0, 60.0, false) || !checkDirections(complaint, def))
    {
        return false;
    }
    bool hasGamma = def->kind == SW_SPECTRUM_JONSWAP || def->kind == SW_SPECTRUM_TMA;
    bool hasFetch = hasGamma || def->kind == SW_SPECTRUM_ELFOUHAILY;
    if (hasGamma && ((int)def->growth < 0 || def->growth >= SW_GROWTH_LAW_COUNT))
    {
        return swComplain(complaint, "The spectrum's growth is %d; its range is [0, %d].", (int)def->growth,
                          SW_GROWTH_LAW_COUNT - 1);
    }
    return (!hasFetch || checkRange(complaint, "fetch", def->fetch, 1e3, 1e7, false)) &&
           (!hasGamma || checkRange(complaint, "gamma", def->gamma, 1.0, 10.0, false)) &&
           (def->kind != SW_SPECTRUM_OCTAVES || checkOctaves(complaint, &def->octaves));
}

swResult swCheckSpectrum(const swHost* host, const swSpectrumDef* def)
{
    swComplaint complaint;
    if (def->internalValue != SW_SPECTRUM_COOKIE)
    {
        return swFail(host, SW_ERROR_INVALID, "The spectrum was not initialized with swDefaultSpectrumDef().");
    }
    return swCheckSpectrumDef(&complaint, def) ? SW_SUCCESS : swFail(host, SW_ERROR_INVALID, "%s", complaint.text);
}

static bool isSameTable(const swSpectrumTable* a, const swSpectrumTable* b)
{
    size_t frequencies = (size_t)a->frequencyCount;
    size_t densities = frequencies * (size_t)a->directionCount;
    return a->frequencyCount == b->frequencyCount && a->directionCount == b->directionCount &&
           a->firstDirection == b->firstDirection &&
           memcmp(a->frequencies, b->frequencies, frequencies * sizeof(float)) == 0 &&
           memcmp(a->bandwidths, b->bandwidths, frequencies * sizeof(float)) == 0 &&
           memcmp(a->density, b->density, densities * sizeof(float)) == 0;
}

static bool areSameOctaves(const swOctaves* a, const swOctaves* b)
{
    bool isSame = a->multiplier == b->multiplier && a->chop == b->chop && a->gravityScale == b->gravityScale &&
                  a->limitByWind == b->limitByWind;
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        const swOctave* x = &a->octaves[i];
        const swOctave* y = &b->octaves[i];
        isSame = isSame && x->power == y->power && x->isEnabled == y->isEnabled && x->chop == y->chop &&
                 x->gravityScale == y->gravityScale;
    }
    return isSame;
}

bool swIsSameSpectrum(const swSpectrumDef* a, const swSpectrumDef* b)
{
    static_assert(sizeof(void*) != 8 || sizeof(swSpectrumDef) == 312, "compare what is new in swSpectrumDef");
    if (a->kind != b->kind || a->windSpeed != b->windSpeed || a->hasWind != b->hasWind || a->fetch != b->fetch ||
        a->growth != b->growth || a->gamma != b->gamma || a->significantHeight != b->significantHeight ||
        a->peakPeriod != b->peakPeriod || a->direction != b->direction || a->spreading != b->spreading ||
        a->spreadExponent != b->spreadExponent || a->turbulence != b->turbulence || a->swell != b->swell ||
        a->depth != b->depth || a->extendTail != b->extendTail)
    {
        return false;
    }
    if (a->kind == SW_SPECTRUM_OCTAVES && !areSameOctaves(&a->octaves, &b->octaves))
    {
        return false;
    }
    return a->kind != SW_SPECTRUM_TABLE || isSameTable(a->table, b->table);
}
