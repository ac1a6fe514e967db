// SPDX-License-Identifier: MIT
// One spectrum, by frequency and direction or as energies and moments by frequency, made into a record of a measured
// sea.
//
// Frequencies are put in ascending order, directions on the grid of core/records/direction_grid.h. Moments become the
// maximum-entropy distribution of core/spectra/spreading.h, which is never negative. What they lack is filled in: a
// frequency without direction takes its nearest neighbour's, second moments are those of cos^2s with the same r1, and
// a record without any direction spreads as cos^2s with s = 8 around east.

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/misuse.h"
#include "core/base/trial.h"
#include "core/math/scalar.h"
#include "core/records/direction_grid.h"
#include "core/records/measured.h"

#define DEF_COOKIE 0x4d53

static_assert(SW_GRID_MAX_DIRECTIONS == SW_SEA_MAX_DIRECTIONS, "a grid holds what a file may have");

typedef struct FrequencyOrder
{
    double frequency;
    int row; // of the def
} FrequencyOrder;

// Too large for a stack.
typedef struct Scratch
{
    int count;
    FrequencyOrder order[SW_SEA_MAX_FREQUENCIES + 1];
    swSeaMoments moments[SW_SEA_MAX_FREQUENCIES + 1];
    swDirectionGrid grid;
    double table[SW_SEA_MAX_DIRECTIONS];
} Scratch;

swMeasuredSpectrumDef swDefaultMeasuredSpectrumDef(void)
{
    return (swMeasuredSpectrumDef){.seconds = (double)NAN, .internalValue = DEF_COOKIE};
}

// ---- bands ----

void swFillBandwidths(int count, const float* frequencies, float* widths)
{
    for (int i = 0; i < count; ++i)
    {
        int below = i > 0 ? i - 1 : i;
        int above = i + 1 < count ? i + 1 : i;
        widths[i] = (frequencies[above] - frequencies[below]) / (float)(above - below);
    }
    if (widths[0] > 2.0f * frequencies[0])
    {
        widths[0] = 2.0f * frequencies[0];
    }
}

static int compareFrequencies(const void* a, const void* b)
{
    const FrequencyOrder* first = a;
    const FrequencyOrder* second = b;
    return (first->frequency > second->frequency) - (first->frequency < second->frequency);
}

// The def's frequencies but 0, ascending.
static swResult sortFrequencies(const swMeasuredSea* sea, const swMeasuredSpectrumDef* def, Scratch* scratch)
{
    scratch->count = 0;
    for (int i = 0; i < def->frequencyCount; ++i)
    {
        double frequency = def->frequencies[i];
        if (!(frequency >= 0.0 && frequency <= 100.0))
        {
            return swFail(&sea->host, SW_ERROR_FORMAT, "%s: frequency %d is %g Hz; it must be from 0 to 100.",
                          sea->name, i + 1, frequency);
        }
        if (frequency >= 1e-6)
        {
            scratch->order[scratch->count++] = (FrequencyOrder){frequency, i};
        }
    }
    if (scratch->count < 2 || scratch->count > SW_SEA_MAX_FREQUENCIES)
    {
        return swFail(&sea->host, SW_ERROR_FORMAT, "%s: a spectrum has %d frequencies above 0; it must have 2 to %d.",
                      sea->name, scratch->count, SW_SEA_MAX_FREQUENCIES);
    }
    qsort(scratch->order, (size_t)scratch->count, sizeof(FrequencyOrder), compareFrequencies);
    for (int i = 1; i < scratch->count; ++i)
    {
        if ((float)scratch->order[i].frequency <= (float)scratch->order[i - 1].frequency)
        {
            return swFail(&sea->host, SW_ERROR_FORMAT, "%s: the frequency %g Hz stands there twice.", sea->name,
                          scratch->order[i].frequency);
        }
    }
    return SW_SUCCESS;
}

static swResult fillBands(const swMeasuredSea* sea, const swMeasuredSpectrumDef* def, const Scratch* scratch,
                          swSeaRecord* record)
{
    float* frequencies = swGetSeaRow(record, SW_SEA_FREQUENCIES);
    float* widths = swGetSeaRow(record, SW_SEA_BANDWIDTHS);
    for (int i = 0; i < scratch->count; ++i)
    {
        frequencies[i] = (float)scratch->order[i].frequency;
    }
    swFillBandwidths(scratch->count, frequencies, widths);
    for (int i = 0; i < scratch->count && def->bandwidths != NULL; ++i)
    {
        double width = def->bandwidths[scratch->order[i].row];
        if (!(width >= 1e-9 && width <= 1000.0))
        {
            return swFail(&sea->host, SW_ERROR_FORMAT, "%s: the bandwidth at %g Hz is %g Hz; it must be above 0.",
                          sea->name, scratch->order[i].frequency, width);
        }
        widths[i] = (float)width;
    }
    widths[0] = widths[0] > 2.0f * frequencies[0] ? 2.0f * frequencies[0] : widths[0];
    return SW_SUCCESS;
}

// ---- moments ----

swMoments swCompleteMoments(const swSeaMoments* moments)
{
    swMoments result = moments->moments;
    if (!moments->hasSecond)
    {
        double r1 = sqrt(result.a1 * result.a1 + result.b1 * result.b1);
        double direction2 = 2.0 * swAtan2(result.b1, result.a1);
        double ignored = 0.0;
        double r2 = 0.0;
        swGetCosineMoments(r1 < 0.99 ? r1 / (1.0 - r1) : 99.0, &ignored, &r2);
        result.a2 = r2 * swCos(direction2);
        result.b2 = r2 * swSin(direction2);
    }
    return result;
}

swSeaMoments swMakeSeaMoments(double direction, double spread)
{
    swSeaMoments result = {0};
    if (direction == direction)
    {
        double r1 =
            spread == spread ? 1.0 - 0.5 * spread * spread : SW_SEA_DEFAULT_EXPONENT / (SW_SEA_DEFAULT_EXPONENT + 1.0);
        r1 = r1 < 0.0 ? 0.0 : r1;
        result.hasFirst = true;
        result.hasSpread = spread == spread;
        result.moments.a1 = r1 * swCos(direction);
        result.moments.b1 = r1 * swSin(direction);
    }
    return result;
}

// The index nearest to i that has a mean direction, or i if there is none at all.
static int findDirected(const swSeaMoments* moments, int count, int i)
{
    for (int distance = 0; distance < count; ++distance)
    {
        if (i - distance >= 0 && moments[i - distance].hasFirst)
        {
            return i - distance;
        }
        if (i + distance < count && moments[i + distance].hasFirst)
        {
            return i + distance;
        }
    }
    return i;
}

void swKeepSeaMoments(swSeaRecord* record, int i, const swMoments* moments, bool hasDirection, bool hasSpread)
{
    swGetSeaRow(record, SW_SEA_MEAN_DIRECTION)[i] = (float)swAtan2(moments->b1, moments->a1);
    swGetSeaRow(record, SW_SEA_R1)[i] = (float)sqrt(moments->a1 * moments->a1 + moments->b1 * moments->b1);
    swGetSeaRow(record, SW_SEA_DIRECTION2)[i] = (float)(0.5 * swAtan2(moments->b2, moments->a2));
    swGetSeaRow(record, SW_SEA_R2)[i] = (float)sqrt(moments->a2 * moments->a2 + moments->b2 * moments->b2);
    float unknown = (float)NAN;
    swGetSeaRow(record, SW_SEA_MEASURED_DIRECTION)[i] =
        hasDirection ? swGetSeaRow(record, SW_SEA_MEAN_DIRECTION)[i] : unknown;
    swGetSeaRow(record, SW_SEA_MEASURED_R1)[i] =
        hasDirection && hasSpread ? swGetSeaRow(record, SW_SEA_R1)[i] : unknown;
}

static void scaleRow(float* density, int count, float factor)
{
    for (int i = 0; i < count; ++i)
    {
        density[i] *= factor;
    }
}

static void fillWithoutDirections(swSeaRecord* record)
{
    float spread[SW_SEA_DIRECTIONS];
    const float* energy = swGetSeaRow(record, SW_SEA_ENERGY);
    float* density = swGetSeaRow(record, SW_SEA_TABLE);
    swFillCosineSpread(SW_SEA_DEFAULT_EXPONENT, 0.0, SW_SEA_DIRECTIONS, spread);
    for (int i = 0; i < record->frequencyCount; ++i, density += SW_SEA_DIRECTIONS)
    {
        memcpy(density, spread, sizeof(spread));
        scaleRow(density, SW_SEA_DIRECTIONS, energy[i]);
    }
}

void swFillSeaDirections(swSeaRecord* record, const swSeaMoments* moments)
{
    int count = record->frequencyCount;
    const float* energy = swGetSeaRow(record, SW_SEA_ENERGY);
    float* density = swGetSeaRow(record, SW_SEA_TABLE);
    record->hasDirections = moments[findDirected(moments, count, 0)].hasFirst;
    if (!record->hasDirections)
    {
        fillWithoutDirections(record);
        return;
    }
    for (int i = 0; i < count; ++i, density += SW_SEA_DIRECTIONS)
    {
        swMoments whole = swCompleteMoments(&moments[findDirected(moments, count, i)]);
        record->correctedCount += swCorrectMoments(&whole) && moments[i].hasFirst ? 1 : 0;
        swKeepSeaMoments(record, i, &whole, moments[i].hasFirst, moments[i].hasSpread);
        if (energy[i] > 0.0f)
        {
            swFillMaximumEntropy(&whole, SW_SEA_DIRECTIONS, density);
            scaleRow(density, SW_SEA_DIRECTIONS, energy[i]);
        }
    }
}

// ---- records ----

static bool isKnown(const double* values, int row)
{
    return values != NULL && values[row] == values[row] && fabs(values[row]) <= 1e6;
}

// Cosine and sine moments of an angle and a length.
static bool setPair(const double* angles, const double* lengths, int row, double order, double* a, double* b)
{
    if (!isKnown(angles, row) || !isKnown(lengths, row))
    {
        return false;
    }
    *a = lengths[row] * swCos(order * angles[row]);
    *b = lengths[row] * swSin(order * angles[row]);
    return true;
}

static void gatherPolar(const swMeasuredSpectrumDef* def, int row, swSeaMoments* moments)
{
    if (!isKnown(def->r1, row) && isKnown(def->meanDirection, row))
    {
        *moments = swMakeSeaMoments(def->meanDirection[row], (double)NAN);
        return;
    }
    moments->hasFirst = setPair(def->meanDirection, def->r1, row, 1.0, &moments->moments.a1, &moments->moments.b1);
    moments->hasSpread = moments->hasFirst;
    moments->hasSecond =
        moments->hasFirst && setPair(def->direction2, def->r2, row, 2.0, &moments->moments.a2, &moments->moments.b2);
}

static void gatherMoments(const swMeasuredSpectrumDef* def, Scratch* scratch)
{
    for (int i = 0; i < scratch->count; ++i)
    {
        int row = scratch->order[i].row;
        swSeaMoments* moments = &scratch->moments[i];
        *moments = (swSeaMoments){0};
        if (!isKnown(def->a1, row) || !isKnown(def->b1, row))
        {
            gatherPolar(def, row, moments);
            continue;
        }
        moments->hasFirst = moments->hasSpread = true;
        moments->moments.a1 = def->a1[row];
        moments->moments.b1 = def->b1[row];
        if (isKnown(def->a2, row) && isKnown(def->b2, row))
        {
            moments->hasSecond = true;
            moments->moments.a2 = def->a2[row];
            moments->moments.b2 = def->b2[row];
        }
    }
}

static swResult failDensity(const swMeasuredSea* sea, double frequency, double value, double most, const char* unit)
{
    return swFail(&sea->host, SW_ERROR_FORMAT, "%s: the density at %g Hz is %g %s; at most %g is read.", sea->name,
                  frequency, value, unit, most);
}

static swResult fillFromMoments(const swMeasuredSea* sea, const swMeasuredSpectrumDef* def, Scratch* scratch,
                                swSeaRecord* record)
{
    float* energy = swGetSeaRow(record, SW_SEA_ENERGY);
    const float* widths = swGetSeaRow(record, SW_SEA_BANDWIDTHS);
    double least = swFindLeastDensity(def->energy, (size_t)def->frequencyCount);
    for (int i = 0; i < scratch->count; ++i)
    {
        double value = def->energy[scratch->order[i].row];
        if (value > SW_SEA_MAX_ENERGY)
        {
            return failDensity(sea, scratch->order[i].frequency, value, SW_SEA_MAX_ENERGY, "m^2/Hz");
        }
        record->negativeCount += value < 0.0 ? 1 : 0;
        bool isMissing = !(value >= least);
        swClipSeaRow(record, least, (double)widths[i], 1, &value);
        energy[i] = isMissing ? (float)NAN : (float)value;
    }
    swCloseSeaGaps(record);
    swSumSeaRecord(record);
    gatherMoments(def, scratch);
    swFillSeaDirections(record, scratch->moments);
    return SW_SUCCESS;
}

// Moments of a row of the table. Of one without energy those of a flat distribution.
static swMoments sumMoments(const swSeaRecord* record, const double* table, double energy)
{
    swMoments moments = {0};
    double step = 2.0 * SW_PI / record->directionCount;
    for (int i = 0; i < record->directionCount && energy > 0.0; ++i)
    {
        double angle = (double)record->firstDirection + step * i;
        double share = table[i] * step / energy;
        moments.a1 += share * swCos(angle);
        moments.b1 += share * swSin(angle);
        moments.a2 += share * swCos(2.0 * angle);
        moments.b2 += share * swSin(2.0 * angle);
    }
    return moments;
}

static swResult fillFromDensity(const swMeasuredSea* sea, const swMeasuredSpectrumDef* def, Scratch* scratch,
                                swSeaRecord* record)
{
    double columns[SW_SEA_MAX_DIRECTIONS];
    float* energy = swGetSeaRow(record, SW_SEA_ENERGY);
    const float* widths = swGetSeaRow(record, SW_SEA_BANDWIDTHS);
    float* table = swGetSeaRow(record, SW_SEA_TABLE);
    double step = 2.0 * SW_PI / record->directionCount;
    size_t cells = (size_t)def->frequencyCount * (size_t)def->directionCount;
    double least = swFindLeastDensity(def->density, cells);
    double largest = 0.0;
    for (size_t i = 0; i < cells; ++i)
    {
        largest = def->density[i] > largest ? def->density[i] : largest; // false for NaN
    }
    for (int i = 0; i < scratch->count; ++i, table += record->directionCount)
    {
        const double* density = def->density + (size_t)scratch->order[i].row * (size_t)def->directionCount;
        int missingCount = 0;
        for (int j = 0; j < def->directionCount; ++j)
        {
            if (density[j] > SW_SEA_MAX_DENSITY)
            {
                return failDensity(sea, scratch->order[i].frequency, density[j], SW_SEA_MAX_DENSITY, "m^2/Hz/rad");
            }
            // What marks a missing value must not spread to its neighbours on the grid.
            bool isMissing = !(density[j] >= least);
            record->negativeCount += density[j] < 0.0 ? 1 : 0;
            missingCount += isMissing ? 1 : 0;
            columns[j] = isMissing ? (double)NAN : density[j];
        }
        bool isWhole = missingCount < def->directionCount;
        record->missingCount += isWhole ? swCountSeaGaps(columns, def->directionCount, largest) : 0;
        for (int j = 0; j < def->directionCount; ++j)
        {
            columns[j] = columns[j] == columns[j] ? columns[j] : 0.0;
        }
        swSpreadOnGrid(&scratch->grid, columns, scratch->table);
        swClipSeaRow(record, (double)-INFINITY, step * (double)widths[i], record->directionCount, scratch->table);
        double sum = 0.0;
        for (int j = 0; j < record->directionCount; ++j)
        {
            table[j] = (float)scratch->table[j];
            sum += scratch->table[j] * step;
        }
        energy[i] = isWhole ? (float)sum : (float)NAN;
        swMoments moments = sumMoments(record, scratch->table, sum);
        swKeepSeaMoments(record, i, &moments, sum > 0.0, sum > 0.0);
    }
    record->hasDirections = true;
    swCloseSeaGaps(record);
    swSumSeaRecord(record);
    return SW_SUCCESS;
}

static swResult checkDef(const swMeasuredSea* sea, const swMeasuredSpectrumDef* def, Scratch* scratch)
{
    bool hasGrid = def->directionCount > 0;
    if (def->frequencyCount < 1 || def->frequencyCount > SW_SEA_MAX_FREQUENCIES + 1)
    {
        return swFail(&sea->host, SW_ERROR_FORMAT, "%s: a spectrum has %d frequencies; it must have 2 to %d.",
                      sea->name, def->frequencyCount, SW_SEA_MAX_FREQUENCIES);
    }
    if (def->directionCount < 0 || def->directionCount > SW_SEA_MAX_DIRECTIONS ||
        (hasGrid && !swMakeDirectionGrid(def->directions, def->directionCount, &scratch->grid)))
    {
        return swFail(&sea->host, SW_ERROR_FORMAT,
                      "%s: a spectrum has %d directions; it must have at least 3 different ones and at most %d.",
                      sea->name, def->directionCount, SW_SEA_MAX_DIRECTIONS);
    }
    int locationCount = (int)sea->locations.count;
    if (def->location < 0 || def->location >= (locationCount > 0 ? locationCount : 1))
    {
        return swFail(&sea->host, SW_ERROR_INVALID, "%s: a spectrum is of place %d of %d.", sea->name, def->location,
                      locationCount);
    }
    if (def->seconds == def->seconds && !(def->seconds >= -2208988800.0 && def->seconds < 7258118400.0))
    {
        return swFail(&sea->host, SW_ERROR_FORMAT,
                      "%s: a spectrum is of a time %g seconds after 1970; years 1900 to 2199 are read.", sea->name,
                      def->seconds);
    }
    return sortFrequencies(sea, def, scratch);
}

static void dropLast(swMeasuredSea* sea)
{
    swSeaRecord* records = sea->records.data;
    swSeaRecord* last = &records[--sea->records.count];
    sea->floatCount -= last->floatsSize / sizeof(float);
    swFree(&sea->host, last->floats, last->floatsSize);
}

static swResult addSpectrum(swMeasuredSea* sea, const swMeasuredSpectrumDef* def, Scratch* scratch)
{
    swSeaRecord* record = NULL;
    swResult result = checkDef(sea, def, scratch);
    if (result == SW_SUCCESS)
    {
        int directions = def->directionCount > 0 ? scratch->grid.count : SW_SEA_DIRECTIONS;
        result = swAddSeaRecord(sea, scratch->count, directions, &record);
    }
    if (result != SW_SUCCESS)
    {
        return result;
    }
    record->hasTime = def->seconds == def->seconds;
    record->seconds = record->hasTime ? def->seconds : 0.0;
    record->location = def->location;
    record->firstDirection = def->directionCount > 0 ? (float)scratch->grid.first : 0.0f;
    result = fillBands(sea, def, scratch, record);
    if (result == SW_SUCCESS)
    {
        result = def->directionCount > 0 ? fillFromDensity(sea, def, scratch, record)
                                         : fillFromMoments(sea, def, scratch, record);
    }
    if (result != SW_SUCCESS)
    {
        dropLast(sea);
    }
    return result;
}

swResult swMeasuredSea_AddSpectrum(swMeasuredSea* sea, const swMeasuredSpectrumDef* def)
{
    SW_REQUIRE(sea != NULL && def != NULL, SW_ERROR_INVALID, sea != NULL ? &sea->host : NULL,
               "swMeasuredSea_AddSpectrum() needs a sea and a spectrum");
    SW_ASSERT(def->internalValue == DEF_COOKIE);
    if (def->internalValue != DEF_COOKIE || def->frequencies == NULL ||
        (def->directionCount > 0 ? def->directions == NULL || def->density == NULL : def->energy == NULL))
    {
        return swFail(&sea->host, SW_ERROR_INVALID,
                      "%s: a spectrum was not initialized with swDefaultMeasuredSpectrumDef(), or lacks an array.",
                      sea->name);
    }
    Scratch* scratch = swAllocate(&sea->host, sizeof(*scratch));
    if (scratch == NULL)
    {
        return swFail(&sea->host, SW_ERROR_NO_MEMORY, "No memory for a spectrum of %s.", sea->name);
    }
    swHost host = sea->host;
    swTrial trial;
    swBeginTrial(&trial, &host);
    sea->host = trial.host;
    swResult result = addSpectrum(sea, def, scratch);
    sea->host = host;
    swFree(&host, scratch, sizeof(*scratch));
    if (result == SW_ERROR_FORMAT && def->warnOnly)
    {
        swLog(&host, SW_LOG_WARNING, "%s", trial.message);
        return result;
    }
    return swEndTrial(&trial, result);
}
