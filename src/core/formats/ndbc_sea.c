// SPDX-License-Identifier: MIT
// Measured seas: the rows of NDBC's files joined by time and frequency, and made into directional spectra.
//
// NDBC prints, for each frequency, the energy density E, the mean direction alpha1 and the principal direction alpha2
// that waves come FROM in degrees clockwise from north, and the lengths r1 and r2 of the circular moments. Here the
// moments are c1 = r1 exp(i a1), c2 = r2 exp(2 i a2) with a1, a2 the directions waves go in radians (seaway/math.h),
// and S(f, theta) = E(f) D(theta) with the maximum-entropy D of core/spectra/spreading.h.
//
// r1 without a file is that of cos^2s with s = 8; measured_def.c fills in what else is missing. Frequencies are
// printed with three decimals in real time (0.033 is 0.0325); where all of them belong to the buoys' standard set
// [NDBC 2024], its true frequencies and bandwidths are taken, otherwise bands reach half-way to their neighbours.

#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "core/math/scalar.h"
#include "core/records/measured.h"
#include "core/formats/measured_readers.h"
#include "core/formats/ndbc.h"
#include "core/spectra/spreading.h"

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
    int index = 0, last = 0;
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
        // Bands of a set with gaps would not meet.
        if (index == STANDARD_COUNT || (i > 0 && index != last + 1))
        {
            return false;
        }
        last = index;
        frequencies[i] = (float)frequency;
        widths[i] = (float)width;
        ++index;
    }
    return true;
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

static swSeaMoments makeMoments(float alpha1, float alpha2, float r1, float r2)
{
    swSeaMoments result = {0};
    if (alpha1 < 0.0f)
    {
        return result;
    }
    double direction1 = (double)SW_DIRECTION_FROM_BEARING((double)alpha1);
    double length = r1 >= 0.0f ? (double)r1 : SW_SEA_DEFAULT_EXPONENT / (SW_SEA_DEFAULT_EXPONENT + 1.0);
    result.hasFirst = true;
    result.hasSpread = r1 >= 0.0f;
    result.moments.a1 = length * swCos(direction1);
    result.moments.b1 = length * swSin(direction1);
    if (r2 >= 0.0f && alpha2 >= 0.0f)
    {
        double direction2 = (double)SW_DIRECTION_FROM_BEARING((double)alpha2);
        result.hasSecond = true;
        result.moments.a2 = (double)r2 * swCos(2.0 * direction2);
        result.moments.b2 = (double)r2 * swSin(2.0 * direction2);
    }
    return result;
}

static void gatherMoments(const Files* files, const swNdbcRow* row, swSeaMoments* moments)
{
    const swNdbcSet* set = (const swNdbcSet*)files->energy.sets.data + row->set;
    const float* printed = (const float*)files->energy.frequencies.data + set->first;
    const swNdbcRow* alpha1 = swFindNdbcRow(&files->alpha1, row->minutes);
    const swNdbcRow* alpha2 = swFindNdbcRow(&files->alpha2, row->minutes);
    const swNdbcRow* r1 = swFindNdbcRow(&files->r1, row->minutes);
    const swNdbcRow* r2 = swFindNdbcRow(&files->r2, row->minutes);
    for (int i = 0; i < set->count; ++i)
    {
        moments[i] = makeMoments(findValue(&files->alpha1, alpha1, printed[i], i),
                                 findValue(&files->alpha2, alpha2, printed[i], i),
                                 findValue(&files->r1, r1, printed[i], i), findValue(&files->r2, r2, printed[i], i));
    }
}

static void fillRecord(const Files* files, const swNdbcRow* row, swSeaRecord* record, swSeaMoments* moments)
{
    const float* values = (const float*)files->energy.values.data + row->first;
    float* energy = swGetSeaRow(record, SW_SEA_ENERGY);
    record->hasTime = true;
    record->seconds = 60.0 * (double)row->minutes;
    for (int i = 0; i < record->frequencyCount; ++i)
    {
        energy[i] = values[i] >= 0.0f ? values[i] : (float)NAN;
    }
    swCloseSeaGaps(record);
    swSumSeaRecord(record);
    gatherMoments(files, row, moments);
    swFillSeaDirections(record, moments);
}

typedef struct Lack
{
    size_t directions, lengths; // records without those of their time and frequencies, of files that are there
} Lack;

static void countLacks(const Files* files, const swNdbcRow* row, const swSeaRecord* record, Lack* lack)
{
    lack->directions += files->alpha1.rows.count > 0 && !record->hasDirections ? 1 : 0;
    lack->lengths +=
        files->r1.rows.count > 0 && record->hasDirections && swFindNdbcRow(&files->r1, row->minutes) == NULL ? 1 : 0;
}

static void warnOfLacks(const swHost* host, const Files* files, const swMeasuredSea* sea, const Lack* lack)
{
    if (lack->directions > 0)
    {
        swLog(host, SW_LOG_WARNING,
              "%s: %zu of %zu records find no directions of their time and frequencies in %s; they have none.",
              files->energy.name, lack->directions, sea->records.count, files->alpha1.name);
    }
    if (lack->lengths > 0)
    {
        swLog(host, SW_LOG_WARNING,
              "%s: %zu of %zu records find no line of their time in %s; what it would tell is taken from a cos^2s "
              "spread around the mean direction.",
              files->energy.name, lack->lengths, sea->records.count, files->r1.name);
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

static swResult addRecord(const Files* files, const swNdbcRow* row, swMeasuredSea* sea, swSeaMoments* moments,
                          Lack* lack)
{
    const swNdbcSet* set = (const swNdbcSet*)files->energy.sets.data + row->set;
    const float* printed = (const float*)files->energy.frequencies.data + set->first;
    swSeaRecord* record = NULL;
    swResult result = swAddSeaRecord(sea, set->count, SW_SEA_DIRECTIONS, &record);
    if (result == SW_SUCCESS)
    {
        fillBands(set->count, printed, swGetSeaRow(record, SW_SEA_FREQUENCIES), swGetSeaRow(record, SW_SEA_BANDWIDTHS));
        fillRecord(files, row, record, moments);
        countLacks(files, row, record, lack);
    }
    return result;
}

static swResult fillSea(const swHost* host, const void* context, swMeasuredSea* sea)
{
    const Files* files = context;
    const swNdbcFile* energy = &files->energy;
    const swNdbcRow* rows = energy->rows.data;
    size_t momentsSize = SW_NDBC_MAX_FREQUENCIES * sizeof(swSeaMoments); // too large for a stack
    swSeaMoments* moments = swAllocate(host, momentsSize);
    if (moments == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for the directions of %s.", energy->name);
    }
    swResult result = SW_SUCCESS;
    size_t emptyCount = 0;
    Lack lack = {0};
    for (size_t i = 0; i < energy->rows.count && result == SW_SUCCESS; ++i)
    {
        bool isThere = hasEnergy(energy, &rows[i]);
        emptyCount += isThere ? 0 : 1;
        result = isThere ? addRecord(files, &rows[i], sea, moments, &lack) : SW_SUCCESS;
    }
    swFree(host, moments, momentsSize);
    warnOfLacks(host, files, sea, &lack);
    if (emptyCount > 0 && sea->records.count > 0)
    {
        swLog(host, SW_LOG_WARNING,
              "%s: %zu of %zu records have no energies, all being marked as missing, and are left out.", energy->name,
              emptyCount, energy->rows.count);
    }
    if (result == SW_SUCCESS && sea->records.count == 0)
    {
        result =
            swFail(host, SW_ERROR_FORMAT, "%s:%d: every energy in the file is missing.", energy->name, rows[0].line);
    }
    return result;
}

static swResult readFiles(const swHost* host, const swNdbcTexts* texts, Files* files)
{
    const struct
    {
        const char *text, *name, *fallback;
        size_t size;
        swNdbcFile* file;
    } sources[SW_NDBC_QUANTITY_COUNT] = {
        [SW_NDBC_ENERGY] = {texts->energy, texts->energyName, "energy", texts->energySize, &files->energy},
        [SW_NDBC_ALPHA1] = {texts->alpha1, texts->alpha1Name, "alpha1", texts->alpha1Size, &files->alpha1},
        [SW_NDBC_ALPHA2] = {texts->alpha2, texts->alpha2Name, "alpha2", texts->alpha2Size, &files->alpha2},
        [SW_NDBC_R1] = {texts->r1, texts->r1Name, "r1", texts->r1Size, &files->r1},
        [SW_NDBC_R2] = {texts->r2, texts->r2Name, "r2", texts->r2Size, &files->r2},
    };
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_NDBC_QUANTITY_COUNT && result == SW_SUCCESS; ++i)
    {
        const char* name = sources[i].name != NULL ? sources[i].name : sources[i].fallback;
        result = sources[i].text != NULL
                     ? swReadNdbcFile(host, sources[i].text, sources[i].size, name, (swNdbcQuantity)i, sources[i].file)
                     : SW_SUCCESS;
    }
    return result;
}

// Mean square slope of the waves that a row would have. The steepest seas have 0.1 up to half a hertz.
static double getSlope(const swNdbcFile* energy, const swNdbcRow* row)
{
    const swNdbcSet* set = (const swNdbcSet*)energy->sets.data + row->set;
    const float* frequencies = (const float*)energy->frequencies.data + set->first;
    const float* values = (const float*)energy->values.data + row->first;
    double slope = 0.0;
    for (int i = 1; i < set->count; ++i)
    {
        double omega = 2.0 * SW_PI * (double)frequencies[i];
        double width = (double)frequencies[i] - (double)frequencies[i - 1];
        slope += values[i] > 0.0f ? (double)values[i] * width * omega * omega * omega * omega / (9.81 * 9.81) : 0.0;
    }
    return slope;
}

// Archives do not say what they hold. Directions and lengths times 100, taken for energies, make waves that would be
// steeper than any by a factor of ten and more.
static swResult checkSlopes(const swHost* host, const swNdbcFile* energy)
{
    const swNdbcRow* rows = energy->rows.data;
    size_t steepCount = 0;
    for (size_t i = 0; i < energy->rows.count; ++i)
    {
        steepCount += getSlope(energy, &rows[i]) > 1.0 ? 1 : 0;
    }
    if (2 * steepCount <= energy->rows.count)
    {
        return SW_SUCCESS;
    }
    return swFail(
        host, SW_ERROR_FORMAT,
        "%s:%d: these can be no energies: waves of such densities would be ten times as steep as any. Is it a "
        "file of directions or moments? Name the file of energies that belongs to it, such as 44013w2021.txt "
        "for 44013d2021.txt.",
        energy->name, rows[0].line);
}

swResult swParseNdbc(const swHost* host, const swNdbcTexts* texts, swMeasuredSea** sea)
{
    SW_REQUIRE_PLACE(host, sea, "swParseNdbc()");
    if (texts == NULL || texts->energy == NULL)
    {
        return swFail(host, SW_ERROR_INVALID, "swParseNdbc() needs the text of an energy file.");
    }
    Files files;
    memset(&files, 0, sizeof(files));
    swResult result = readFiles(host, texts, &files);
    result = result == SW_SUCCESS ? checkSlopes(host, &files.energy) : result;
    result = result == SW_SUCCESS ? swMakeFilledSea(host, files.energy.name, fillSea, &files, sea) : result;
    swFreeNdbcFile(host, &files.energy);
    swFreeNdbcFile(host, &files.alpha1);
    swFreeNdbcFile(host, &files.alpha2);
    swFreeNdbcFile(host, &files.r1);
    swFreeNdbcFile(host, &files.r2);
    return result;
}
