// SPDX-License-Identifier: MIT
// Measured seas: the rows of NDBC's files joined by time and frequency, and made into directional spectra.
//
// NDBC prints, for each frequency, the energy density E, the mean direction alpha1 and the principal direction alpha2
// that waves come FROM in degrees clockwise from north, and the lengths r1 and r2 of the circular moments. Here the
// moments are c1 = r1 exp(i a1), c2 = r2 exp(2 i a2) with a1, a2 the directions waves go in radians (seaway/math.h), and
// S(f, theta) = E(f) D(theta) with the maximum-entropy D of core/waves/spreading.h.
//
// What is missing is filled in: a frequency without direction takes its nearest neighbour's, r1 without a file is that
// of cos^2s with s = 8, and second moments those of cos^2s with the same r1. Frequencies are printed with three decimals
// in real time (0.033 is 0.0325); where all of them belong to the buoys' standard set [NDBC 2024], its true frequencies
// and bandwidths are taken, otherwise bands reach half-way to their neighbours.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/math/scalar.h"
#include "core/waves/measured.h"
#include "core/waves/ndbc.h"
#include "core/waves/spreading.h"

// Two printed frequencies are the same if they differ by less: rounding to three decimals on both sides.
#define PRINTED_TOLERANCE 0.00051

typedef struct Files
{
    swNdbcFile energy, alpha1, alpha2, r1, r2;
} Files;

// ---- bands ----

#define STANDARD_COUNT 47

// The set of NDBC's 3 m and 6 m buoys since 1996: 0.02 Hz, 0.0325 to 0.0925, 0.1 to 0.35, 0.365 to 0.485.
static void getStandardBand(int index, double* frequency, double* width)
{
    if (index == 0)
    {
        *frequency = 0.02;
        *width = 0.01;
    }
    else if (index < 14)
    {
        *frequency = 0.0325 + 0.005 * (index - 1);
        *width = 0.005;
    }
    else if (index < 40)
    {
        *frequency = 0.1 + 0.01 * (index - 14);
        *width = 0.01;
    }
    else
    {
        *frequency = 0.365 + 0.02 * (index - 40);
        *width = 0.02;
    }
}

static bool takeStandardBands(int count, const float* printed, float* frequencies, float* widths)
{
    int index = 0;
    for (int i = 0; i < count; ++i)
    {
        double frequency = 0.0;
        double width = 0.0;
        for (; index < STANDARD_COUNT; ++index)
        {
            getStandardBand(index, &frequency, &width);
            if (fabs(frequency - (double)printed[i]) < PRINTED_TOLERANCE)
            {
                break;
            }
        }
        if (index == STANDARD_COUNT)
        {
            return false;
        }
        frequencies[i] = (float)frequency;
        widths[i] = (float)width;
        ++index;
    }
    return true;
}

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

static void fillBands(int count, const float* printed, float* frequencies, float* widths)
{
    if (takeStandardBands(count, printed, frequencies, widths))
    {
        return;
    }
    memcpy(frequencies, printed, (size_t)count * sizeof(float));
    swFillBandwidths(count, frequencies, widths);
}

// ---- records ----

// The value of another file at a time and a printed frequency.
static float findValue(const swNdbcFile* file, const swNdbcRow* row, float frequency, int guess)
{
    if (row == NULL)
    {
        return SW_NDBC_MISSING;
    }
    const swNdbcSet* set = (const swNdbcSet*)file->sets.data + row->set;
    const float* frequencies = (const float*)file->frequencies.data + set->first;
    const float* values = (const float*)file->values.data + row->first;
    // Lists nearly always match index by index.
    if (guess < set->count && frequencies[guess] == frequency)
    {
        return values[guess];
    }
    int best = 0;
    for (int i = 1; i < set->count; ++i)
    {
        best = fabsf(frequencies[i] - frequency) < fabsf(frequencies[best] - frequency) ? i : best;
    }
    bool isSame = fabs((double)frequencies[best] - (double)frequency) < PRINTED_TOLERANCE;
    return isSame ? values[best] : SW_NDBC_MISSING;
}

// Values of one record as the files have them.
typedef struct Raw
{
    float alpha1[SW_NDBC_MAX_FREQUENCIES];
    float alpha2[SW_NDBC_MAX_FREQUENCIES];
    float r1[SW_NDBC_MAX_FREQUENCIES];
    float r2[SW_NDBC_MAX_FREQUENCIES];
} Raw;

static bool gatherDirections(const Files* files, const swNdbcRow* row, Raw* raw)
{
    const swNdbcSet* set = (const swNdbcSet*)files->energy.sets.data + row->set;
    const float* printed = (const float*)files->energy.frequencies.data + set->first;
    const swNdbcRow* alpha1 = swFindNdbcRow(&files->alpha1, row->minutes);
    const swNdbcRow* alpha2 = swFindNdbcRow(&files->alpha2, row->minutes);
    const swNdbcRow* r1 = swFindNdbcRow(&files->r1, row->minutes);
    const swNdbcRow* r2 = swFindNdbcRow(&files->r2, row->minutes);
    bool hasDirections = false;
    for (int i = 0; i < set->count; ++i)
    {
        raw->alpha1[i] = findValue(&files->alpha1, alpha1, printed[i], i);
        raw->alpha2[i] = findValue(&files->alpha2, alpha2, printed[i], i);
        raw->r1[i] = findValue(&files->r1, r1, printed[i], i);
        raw->r2[i] = findValue(&files->r2, r2, printed[i], i);
        hasDirections = hasDirections || raw->alpha1[i] >= 0.0f;
    }
    return hasDirections;
}

// The index nearest to i that has a mean direction; there is one.
static int findDirected(const Raw* raw, int count, int i)
{
    for (int distance = 0; distance < count; ++distance)
    {
        if (i - distance >= 0 && raw->alpha1[i - distance] >= 0.0f)
        {
            return i - distance;
        }
        if (i + distance < count && raw->alpha1[i + distance] >= 0.0f)
        {
            return i + distance;
        }
    }
    return i;
}

static swMoments getMoments(const Raw* raw, int i)
{
    double direction1 = (double)SW_DIRECTION_FROM_BEARING((double)raw->alpha1[i]);
    double direction2 = direction1;
    double r1 = (double)raw->r1[i];
    double r2 = (double)raw->r2[i];
    if (r1 < 0.0)
    {
        r1 = SW_SEA_DEFAULT_EXPONENT / (SW_SEA_DEFAULT_EXPONENT + 1.0);
    }
    if (r2 < 0.0 || raw->alpha2[i] < 0.0f)
    {
        double ignored = 0.0;
        swGetCosineMoments(r1 < 0.99 ? r1 / (1.0 - r1) : 99.0, &ignored, &r2);
    }
    else
    {
        direction2 = (double)SW_DIRECTION_FROM_BEARING((double)raw->alpha2[i]);
    }
    return (swMoments){r1 * swCos(direction1), r1 * swSin(direction1), r2 * swCos(2.0 * direction2),
                       r2 * swSin(2.0 * direction2)};
}

static void fillDirections(swSeaRecord* record, const Raw* raw)
{
    int count = record->frequencyCount;
    float* meanDirection = record->energy + count;
    float* r1 = meanDirection + count;
    float* direction2 = r1 + count;
    float* r2 = direction2 + count;
    float* density = r2 + count;
    for (int i = 0; i < count; ++i, density += SW_SEA_DIRECTIONS)
    {
        swMoments moments = getMoments(raw, findDirected(raw, count, i));
        record->correctedCount += swCorrectMoments(&moments) && raw->alpha1[i] >= 0.0f ? 1 : 0;
        meanDirection[i] = (float)swAtan2(moments.b1, moments.a1);
        r1[i] = (float)sqrt(moments.a1 * moments.a1 + moments.b1 * moments.b1);
        direction2[i] = (float)(0.5 * swAtan2(moments.b2, moments.a2));
        r2[i] = (float)sqrt(moments.a2 * moments.a2 + moments.b2 * moments.b2);
        if (record->energy[i] > 0.0f)
        {
            swFillMaximumEntropy(&moments, SW_SEA_DIRECTIONS, density);
        }
    }
}

static void fillWithoutDirections(swSeaRecord* record)
{
    int count = record->frequencyCount;
    float* density = record->energy + 5 * count;
    float* first = density;
    for (int i = 0; i < count; ++i, density += SW_SEA_DIRECTIONS)
    {
        if (i == 0)
        {
            swFillCosineSpread(SW_SEA_DEFAULT_EXPONENT, 0.0, SW_SEA_DIRECTIONS, first);
        }
        else
        {
            memcpy(density, first, SW_SEA_DIRECTIONS * sizeof(float));
        }
    }
}

static void fillRecord(const Files* files, const swNdbcRow* row, swSeaRecord* record, Raw* raw)
{
    int count = record->frequencyCount;
    const float* values = (const float*)files->energy.values.data + row->first;
    record->minutes = row->minutes;
    for (int i = 0; i < count; ++i)
    {
        record->energy[i] = values[i] > 0.0f ? values[i] : 0.0f;
        record->variance += (double)record->energy[i] * (double)record->bandwidths[i];
    }
    record->hasDirections = gatherDirections(files, row, raw);
    if (record->hasDirections)
    {
        fillDirections(record, raw);
    }
    else
    {
        fillWithoutDirections(record);
    }
    float* density = record->energy + 5 * count;
    for (int i = 0; i < count * SW_SEA_DIRECTIONS; ++i)
    {
        density[i] *= record->energy[i / SW_SEA_DIRECTIONS];
    }
}

// A record whose energies are all missing tells nothing.
static bool hasEnergy(const swNdbcFile* energy, const swNdbcRow* row)
{
    const swNdbcSet* set = (const swNdbcSet*)energy->sets.data + row->set;
    const float* values = (const float*)energy->values.data + row->first;
    for (int i = 0; i < set->count; ++i)
    {
        if (values[i] >= 0.0f)
        {
            return true;
        }
    }
    return false;
}

// ---- the sea ----

swResult swAllocateMeasuredSea(const swHost* host, const char* name, size_t recordCount, size_t frequencyCount,
                               size_t bandCount, swMeasuredSea** result)
{
    swMeasuredSea* sea = swAllocateZero(host, sizeof(*sea));
    if (sea == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for a measured sea.");
    }
    *result = sea;
    sea->host = *host;
    sea->count = (int)recordCount;
    sea->recordsSize = recordCount * sizeof(swSeaRecord);
    sea->floatsSize = frequencyCount * SW_SEA_FLOATS * sizeof(float);
    sea->bandsSize = bandCount * sizeof(float);
    sea->records = swAllocateZero(host, sea->recordsSize);
    sea->floats = swAllocateZero(host, sea->floatsSize);
    sea->bands = swAllocateZero(host, sea->bandsSize);
    if (sea->records == NULL || sea->floats == NULL || sea->bands == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for %s: %zu records need %zu bytes.", name, recordCount,
                      sea->recordsSize + sea->floatsSize + sea->bandsSize);
    }
    return SW_SUCCESS;
}

static swResult allocateSea(const swHost* host, const swNdbcFile* energy, swMeasuredSea** sea)
{
    const swNdbcRow* rows = energy->rows.data;
    const swNdbcSet* sets = energy->sets.data;
    size_t recordCount = 0;
    size_t frequencyCount = 0;
    for (size_t i = 0; i < energy->rows.count; ++i)
    {
        bool isKept = hasEnergy(energy, &rows[i]);
        recordCount += isKept ? 1 : 0;
        frequencyCount += isKept ? (size_t)sets[rows[i].set].count : 0;
    }
    if (recordCount == 0)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:%d: every energy in the file is missing.", energy->name, rows[0].line);
    }
    return swAllocateMeasuredSea(host, energy->name, recordCount, frequencyCount, 2 * energy->frequencies.count, sea);
}

static swResult fillSea(const swHost* host, const Files* files, swMeasuredSea* sea)
{
    const swNdbcFile* energy = &files->energy;
    const swNdbcRow* rows = energy->rows.data;
    const swNdbcSet* sets = energy->sets.data;
    const float* printed = energy->frequencies.data;
    float* frequencies = sea->bands;
    float* bandwidths = sea->bands + energy->frequencies.count;
    for (size_t i = 0; i < energy->sets.count; ++i)
    {
        fillBands(sets[i].count, printed + sets[i].first, frequencies + sets[i].first, bandwidths + sets[i].first);
    }

    Raw* raw = swAllocate(host, sizeof(*raw)); // too large for a stack
    if (raw == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for the directions of %s.", energy->name);
    }
    swSeaRecord* record = sea->records;
    float* floats = sea->floats;
    for (size_t i = 0; i < energy->rows.count; ++i)
    {
        if (!hasEnergy(energy, &rows[i]))
        {
            continue;
        }
        const swNdbcSet* set = &sets[rows[i].set];
        record->frequencyCount = set->count;
        record->frequencies = frequencies + set->first;
        record->bandwidths = bandwidths + set->first;
        record->energy = floats;
        fillRecord(files, &rows[i], record, raw);
        floats += (size_t)set->count * SW_SEA_FLOATS;
        ++record;
    }
    swFree(host, raw, sizeof(*raw));
    return SW_SUCCESS;
}

static swResult readFiles(const swHost* host, const swNdbcTexts* texts, Files* files)
{
    swResult result =
        swReadNdbcFile(host, texts->energy, texts->energySize, texts->energyName != NULL ? texts->energyName : "energy",
                       SW_NDBC_ENERGY, &files->energy);
    if (result == SW_SUCCESS && texts->alpha1 != NULL)
    {
        result =
            swReadNdbcFile(host, texts->alpha1, texts->alpha1Size,
                           texts->alpha1Name != NULL ? texts->alpha1Name : "alpha1", SW_NDBC_DIRECTION, &files->alpha1);
    }
    if (result == SW_SUCCESS && texts->alpha2 != NULL)
    {
        result =
            swReadNdbcFile(host, texts->alpha2, texts->alpha2Size,
                           texts->alpha2Name != NULL ? texts->alpha2Name : "alpha2", SW_NDBC_DIRECTION, &files->alpha2);
    }
    if (result == SW_SUCCESS && texts->r1 != NULL)
    {
        result = swReadNdbcFile(host, texts->r1, texts->r1Size, texts->r1Name != NULL ? texts->r1Name : "r1",
                                SW_NDBC_RATIO, &files->r1);
    }
    if (result == SW_SUCCESS && texts->r2 != NULL)
    {
        result = swReadNdbcFile(host, texts->r2, texts->r2Size, texts->r2Name != NULL ? texts->r2Name : "r2",
                                SW_NDBC_RATIO, &files->r2);
    }
    return result;
}

swResult swParseNdbc(const swHost* host, const swNdbcTexts* texts, swMeasuredSea** sea)
{
    *sea = NULL;
    if (texts->energy == NULL)
    {
        return swFail(host, SW_ERROR_INVALID, "swParseNdbc() needs the text of an energy file.");
    }
    Files files;
    memset(&files, 0, sizeof(files));
    swMeasuredSea* made = NULL;
    swResult result = readFiles(host, texts, &files);
    if (result == SW_SUCCESS)
    {
        result = allocateSea(host, &files.energy, &made);
    }
    if (result == SW_SUCCESS)
    {
        result = fillSea(host, &files, made);
    }
    swFreeNdbcFile(host, &files.energy);
    swFreeNdbcFile(host, &files.alpha1);
    swFreeNdbcFile(host, &files.alpha2);
    swFreeNdbcFile(host, &files.r1);
    swFreeNdbcFile(host, &files.r2);
    if (result != SW_SUCCESS)
    {
        swDestroyMeasuredSea(made);
        return result;
    }
    *sea = made;
    return SW_SUCCESS;
}

void swDestroyMeasuredSea(swMeasuredSea* sea)
{
    if (sea != NULL)
    {
        swHost host = sea->host;
        swFree(&host, sea->records, sea->recordsSize);
        swFree(&host, sea->floats, sea->floatsSize);
        swFree(&host, sea->bands, sea->bandsSize);
        swFree(&host, sea, sizeof(*sea));
    }
}

int swMeasuredSea_GetCount(const swMeasuredSea* sea)
{
    return sea->count;
}

swMeasuredRecord swMeasuredSea_GetRecord(const swMeasuredSea* sea, int index)
{
    swMeasuredRecord result;
    memset(&result, 0, sizeof(result));
    if (index < 0 || index >= sea->count)
    {
        return result;
    }
    const swSeaRecord* record = &sea->records[index];
    int count = record->frequencyCount;
    swPrintMinutes(record->minutes, result.time);
    result.table.frequencyCount = count;
    result.table.directionCount = SW_SEA_DIRECTIONS;
    result.table.frequencies = record->frequencies;
    result.table.bandwidths = record->bandwidths;
    result.table.density = record->energy + 5 * count;
    result.energy = record->energy;
    result.correctedCount = record->correctedCount;
    result.partitionCount = record->partitionCount;
    if (record->hasDirections)
    {
        result.meanDirection = record->energy + count;
        result.r1 = record->energy + 2 * count;
        result.direction2 = record->energy + 3 * count;
        result.r2 = record->energy + 4 * count;
    }
    return result;
}

int swMeasuredSea_FindLargest(const swMeasuredSea* sea)
{
    int largest = 0;
    for (int i = 1; i < sea->count; ++i)
    {
        largest = sea->records[i].variance > sea->records[largest].variance ? i : largest;
    }
    return largest;
}

// "YYYY-MM-DD hh:mm", or with a T between.
static bool parseTime(const char* text, int64_t* minutes)
{
    static const char pattern[] = "0000-00-00 00:00";
    int parts[5] = {0};
    int part = 0;
    for (int i = 0; i < 17; ++i)
    {
        char c = text[i];
        if (pattern[i] == '0')
        {
            if (c < '0' || c > '9')
            {
                return false;
            }
            parts[part] = 10 * parts[part] + (c - '0');
            continue;
        }
        if (c != pattern[i] && !(i == 10 && c == 'T'))
        {
            return false;
        }
        ++part;
    }
    if (parts[0] < 1900 || parts[0] > 2199 || parts[1] < 1 || parts[1] > 12 || parts[2] < 1 ||
        parts[2] > swGetDaysInMonth(parts[0], parts[1]) || parts[3] > 23 || parts[4] > 59)
    {
        return false;
    }
    *minutes = swGetMinutes(parts[0], parts[1], parts[2], parts[3], parts[4]);
    return true;
}

int swMeasuredSea_FindTime(const swMeasuredSea* sea, const char* time)
{
    int64_t minutes = 0;
    if (time == NULL || !parseTime(time, &minutes))
    {
        return -1;
    }
    int best = 0;
    for (int i = 1; i < sea->count; ++i)
    {
        int64_t distance = sea->records[i].minutes - minutes;
        int64_t nearest = sea->records[best].minutes - minutes;
        distance = distance < 0 ? -distance : distance;
        nearest = nearest < 0 ? -nearest : nearest;
        best = distance < nearest ? i : best;
    }
    return best;
}
