// SPDX-License-Identifier: MIT

#include "core/spectra/compiled.h"

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

bool swCheckSpectrumDef(swComplaint* complaint, const swSpectrumDef* def)
{
    return swFields_Check(&swSpectrumFields, def, complaint->text, sizeof(complaint->text)) &&
           (def->kind != SW_SPECTRUM_TABLE || checkTable(complaint, def->table));
}

swResult swCheckSpectrum(const swHost* host, const swSpectrumDef* def)
{
    swComplaint complaint;
    return swCheckSpectrumDef(&complaint, def) ? SW_SUCCESS : swFail(host, SW_ERROR_INVALID, "%s", complaint.text);
}

bool swIsSameTable(const swSpectrumDef* first, const swSpectrumDef* second)
{
    if (first->kind != SW_SPECTRUM_TABLE || second->kind != SW_SPECTRUM_TABLE)
    {
        return first->kind == second->kind;
    }
    const swSpectrumTable* a = first->table;
    const swSpectrumTable* b = second->table;
    size_t frequencies = (size_t)a->frequencyCount;
    size_t densities = frequencies * (size_t)a->directionCount;
    return a->frequencyCount == b->frequencyCount && a->directionCount == b->directionCount &&
           a->firstDirection == b->firstDirection &&
           memcmp(a->frequencies, b->frequencies, frequencies * sizeof(float)) == 0 &&
           memcmp(a->bandwidths, b->bandwidths, frequencies * sizeof(float)) == 0 &&
           memcmp(a->density, b->density, densities * sizeof(float)) == 0;
}
