// SPDX-License-Identifier: MIT
// Seas from summaries. A buoy's spectrum was cut in two at some frequency, and of each part height, period of the peak
// and direction were printed. Here each part becomes a whole spectrum again,
//   S(f, theta) = sum over parts of  E_part(f) D_part(theta),
// with E the JONSWAP shape [Hasselmann 1973] and D = cos^2s [Longuet-Higgins 1963], and the sum is scaled so that its
// height is that of the whole sea, which is printed too (the parts' squares add up to it but for their rounding).
//
// A summary says nothing of the shapes but the average period, APD, which is Tm02. Where it is there, the shape is
// chosen that has it (core/records/summary_shape.h). Where it is not, the usual gamma is 3.3 for swell and 2 for wind
// sea: of 1, 2, 3.3, 5, 6, 7 and 10 those that misplaced the least energy in the 287 records of two buoys (44013 in
// May 2022, 41010 in June 2020) whose spectra are known as well. (2 lies between the growing and the grown sea; a
// swell's 5 to 10 after a long way is washed out by the buoy's bins.) Spreading is narrowest at the peak, s = s_max
// (f / f_peak)^5 below and s_max (f / f_peak)^-2.5 above [Mitsuyasu 1975], with s_max = 25 for swell that has not
// come far and 10 for wind sea [Goda 1985].
//
// Directions of parts are rounded to a point of the compass. The mean direction is that at the peak, in degrees: the
// part with the higher peak takes it if it lies within its point's sector (in 273 of the 287 records it does).

#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "core/math/scalar.h"
#include "core/records/measured.h"
#include "core/spectra/spreading.h"
#include "core/formats/measured_readers.h"
#include "core/formats/summary.h"
#include "core/records/summary_shape.h"

#define SWELL_GAMMA 3.3
#define SWELL_SHARPNESS 25.0
#define WIND_GAMMA 2.0
#define WIND_SHARPNESS 10.0

#define FREQUENCIES SW_SHAPE_FREQUENCIES
#define MAX_RECORDS (SW_NDBC_MAX_VALUES / FREQUENCIES)

// Where buoys end. Tables go on to 1.25 peak frequencies where that is more.
#define LAST_FREQUENCY 0.485
#define LAST_OF_PEAK 1.25
#define FIRST_OF_PEAK 0.55  // below, JONSWAP has 1e-7 of its energy
#define FIRST_OF_SHELF 0.33 // where a shelf of longer waves is needed

// Half a sector of 16 points, and half a degree of the printed mean direction.
#define HALF_SECTOR 11.75

// Average periods that differ by less are the same: half of a buoy's last digit at 5 s.
#define SAME_PERIOD 0.01

typedef struct Partition
{
    double direction;             // degrees, where waves come from; SW_NDBC_MISSING
    double sharpness;             // s at the peak
    double exponent[FREQUENCIES]; // s
} Partition;

typedef struct Sea
{
    int count; // 0 where it is calm
    double height;
    bool isMissed; // no shape has the average period
    swShape shapes[2];
    Partition partitions[2];
} Sea;

// ---- partitions ----

static bool hasWaves(float height)
{
    return height > 0.0f;
}

// Heights of parts whose periods are missing cannot be placed.
static bool canSplit(const float* values)
{
    bool hasSwell = hasWaves(values[SW_SUMMARY_SWELL_HEIGHT]);
    bool hasWind = hasWaves(values[SW_SUMMARY_WIND_HEIGHT]);
    return (hasSwell || hasWind) && !(hasSwell && values[SW_SUMMARY_SWELL_PERIOD] < 0.0f) &&
           !(hasWind && values[SW_SUMMARY_WIND_PERIOD] < 0.0f);
}

static bool hasHeight(const float* values)
{
    return values[SW_SUMMARY_HEIGHT] >= 0.0f || hasWaves(values[SW_SUMMARY_SWELL_HEIGHT]) ||
           hasWaves(values[SW_SUMMARY_WIND_HEIGHT]);
}

// Whether a line tells enough for a record. A calm needs no period.
static bool isWhole(const float* values)
{
    return values[SW_SUMMARY_HEIGHT] == 0.0f || canSplit(values) ||
           (hasWaves(values[SW_SUMMARY_HEIGHT]) &&
            (values[SW_SUMMARY_DOMINANT_PERIOD] > 0.0f || values[SW_SUMMARY_AVERAGE_PERIOD] > 0.0f));
}

static void addPartition(Sea* sea, const float* values, swSummaryField height, double gamma, double sharpness)
{
    if (hasWaves(values[height]))
    {
        swShape* shape = &sea->shapes[sea->count];
        Partition* partition = &sea->partitions[sea->count++];
        shape->height = (double)values[height];
        shape->peak = 1.0 / (double)values[height + 1];
        shape->usualGamma = gamma;
        partition->direction = (double)values[height + 2];
        partition->sharpness = sharpness;
    }
}

static void splitSea(Sea* sea, const float* values)
{
    addPartition(sea, values, SW_SUMMARY_SWELL_HEIGHT, SWELL_GAMMA, SWELL_SHARPNESS);
    addPartition(sea, values, SW_SUMMARY_WIND_HEIGHT, WIND_GAMMA, WIND_SHARPNESS);
    double square = 0.0;
    for (int i = 0; i < sea->count; ++i)
    {
        square += sea->shapes[i].height * sea->shapes[i].height;
    }
    sea->height = values[SW_SUMMARY_HEIGHT] < 0.0f ? sqrt(square) : (double)values[SW_SUMMARY_HEIGHT];
    for (int i = 0; i < sea->count; ++i)
    {
        sea->shapes[i].height *= sea->height / sqrt(square);
    }
}

// ---- frequencies ----

// From low to high in `steps` equal ratios, without the last.
static int fillSteps(double low, double high, int steps, float* frequencies)
{
    double span = swLn(high / low);
    for (int i = 0; i < steps; ++i)
    {
        frequencies[i] = i == 0 ? (float)low : (float)(low * swExp(span * i / steps));
    }
    return steps;
}

static int countSteps(double low, double high, double step)
{
    int steps = (int)floor(swLn(high / low) / step + 0.5);
    return steps > 1 ? steps : 1;
}

// About equal ratios, with a frequency at each peak: the period of the table's peak is then the printed one.
static void fillFrequencies(const Sea* sea, double firstOfPeak, float* frequencies)
{
    double low = sea->count > 0 ? sea->shapes[0].peak : 0.1;
    double high = low;
    for (int i = 1; i < sea->count; ++i)
    {
        double peak = sea->shapes[i].peak;
        low = peak < low ? peak : low;
        high = peak > high ? peak : high;
    }
    double begin = firstOfPeak * low;
    double end = LAST_OF_PEAK * high > LAST_FREQUENCY ? LAST_OF_PEAK * high : LAST_FREQUENCY;
    double step = swLn(end / begin) / (FREQUENCIES - 1);
    int used = fillSteps(begin, low, countSteps(begin, low, step), frequencies);
    if (swLn(high / low) > 0.5 * step) // closer peaks share a frequency
    {
        used += fillSteps(low, high, countSteps(low, high, step), frequencies + used);
        low = high;
    }
    used += fillSteps(low, end, FREQUENCIES - 1 - used, frequencies + used);
    frequencies[used] = (float)end;
}

// ---- energy ----

// With the shapes that are usual.
static void fillPartitions(Sea* sea, double firstOfPeak, float* frequencies, float* widths)
{
    fillFrequencies(sea, firstOfPeak, frequencies);
    swFillBandwidths(FREQUENCIES, frequencies, widths);
    for (int i = 0; i < sea->count; ++i)
    {
        swPrepareShape(&sea->shapes[i], frequencies);
    }
    swFillShapes(sea->shapes, sea->count, 0.0, widths);
}

// Without the dominant period a peak is sought whose usual spectrum, cut off where the buoy's is, has the average
// period; each round brings the two closer by half or more.
static void findPeak(Sea* sea, double average, float* frequencies, float* widths)
{
    swShape* shape = &sea->shapes[0];
    for (int round = 0; round < 12; ++round)
    {
        double period = average / (shape->peak * swGetAveragePeriod(shape, 1, frequencies, widths));
        period = period < 1.0 ? 1.0 : period > 60.0 ? 60.0 : period;
        shape->peak = 1.0 / period;
        fillPartitions(sea, FIRST_OF_PEAK, frequencies, widths);
    }
}

// Shapes that give the sea the average period that the buoy printed, perhaps with longer waves beside the peak.
static void fitPeriod(Sea* sea, double average, float* frequencies, float* widths)
{
    double found = swFitShapes(sea->shapes, sea->count, average, 1.0, frequencies, widths);
    if (found < average * (1.0 - SAME_PERIOD))
    {
        fillPartitions(sea, FIRST_OF_SHELF, frequencies, widths);
        found = swFitShapes(sea->shapes, sea->count, average, SW_SHAPE_MOST, frequencies, widths);
    }
    sea->isMissed = fabs(found / average - 1.0) > SAME_PERIOD;
}

// One system where the line does not tell swell from wind sea.
static void makeSingle(Sea* sea, const float* values)
{
    double dominant = (double)values[SW_SUMMARY_DOMINANT_PERIOD];
    sea->count = 1;
    sea->height = sea->shapes[0].height = (double)values[SW_SUMMARY_HEIGHT];
    sea->shapes[0].peak = 1.0 / (dominant > 0.0 ? dominant : 1.3 * (double)values[SW_SUMMARY_AVERAGE_PERIOD]);
    sea->shapes[0].usualGamma = WIND_GAMMA;
    sea->partitions[0].direction = (double)values[SW_SUMMARY_MEAN_DIRECTION];
    sea->partitions[0].sharpness = WIND_SHARPNESS;
}

// ---- directions ----

static double getLargest(const double* energy)
{
    double largest = 0.0;
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        largest = energy[i] > largest ? energy[i] : largest;
    }
    return largest;
}

static bool isInSector(double direction, double point)
{
    double difference = fabs(direction - point);
    difference = difference > 180.0 ? 360.0 - difference : difference;
    return difference <= HALF_SECTOR;
}

// Refines the higher partition's direction and fills in what is missing. False if there is none at all.
static bool findDirections(Sea* sea, double meanDirection)
{
    Partition* first = &sea->partitions[0];
    Partition* second = &sea->partitions[1];
    bool isFirstHigher = sea->count < 2 || getLargest(sea->shapes[0].energy) >= getLargest(sea->shapes[1].energy);
    Partition* higher = isFirstHigher ? first : second;
    if (meanDirection >= 0.0 && (higher->direction < 0.0 || isInSector(meanDirection, higher->direction)))
    {
        higher->direction = meanDirection;
    }
    if (sea->count == 2)
    {
        Partition* lower = isFirstHigher ? second : first;
        lower->direction = lower->direction < 0.0 ? higher->direction : lower->direction;
        higher->direction = higher->direction < 0.0 ? lower->direction : higher->direction;
    }
    return higher->direction >= 0.0;
}

// Parts without direction spread alike at all frequencies, as other files without directions do.
static void fillExponents(Sea* sea, bool hasDirections, const float* frequencies)
{
    for (int i = 0; i < sea->count; ++i)
    {
        Partition* partition = &sea->partitions[i];
        for (int j = 0; j < FREQUENCIES; ++j)
        {
            double ratio = (double)frequencies[j] / sea->shapes[i].peak;
            double square = ratio * ratio;
            double decay = ratio < 1.0 ? square * square * ratio : 1.0 / (square * sqrt(ratio));
            partition->exponent[j] = hasDirections ? partition->sharpness * decay : SW_SEA_DEFAULT_EXPONENT;
        }
    }
}

// ---- records ----

// Circular moments of one frequency times its energy.
static void addMoments(swMoments* moments, const Partition* partition, double energy, int index)
{
    double r1 = 0.0;
    double r2 = 0.0;
    double direction = (double)SW_DIRECTION_FROM_BEARING(partition->direction);
    swGetCosineMoments(partition->exponent[index], &r1, &r2);
    moments->a1 += energy * r1 * swCos(direction);
    moments->b1 += energy * r1 * swSin(direction);
    moments->a2 += energy * r2 * swCos(2.0 * direction);
    moments->b2 += energy * r2 * swSin(2.0 * direction);
}

static void fillMoments(const Sea* sea, swSeaRecord* record)
{
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        double energy = 0.0;
        swMoments sum = {0};
        for (int j = 0; j < sea->count; ++j)
        {
            energy += sea->shapes[j].energy[i];
            addMoments(&sum, &sea->partitions[j], sea->shapes[j].energy[i], i);
        }
        swMoments mean = {sum.a1 / energy, sum.b1 / energy, sum.a2 / energy, sum.b2 / energy};
        swKeepSeaMoments(record, i, &mean, true, false); // spreads are assumed
    }
}

static void fillTable(const Sea* sea, bool hasDirections, swSeaRecord* record)
{
    float spread[SW_SEA_DIRECTIONS];
    float* energies = swGetSeaRow(record, SW_SEA_ENERGY);
    float* density = swGetSeaRow(record, SW_SEA_TABLE);
    for (int i = 0; i < FREQUENCIES; ++i, density += SW_SEA_DIRECTIONS)
    {
        double energy = 0.0;
        for (int j = 0; j < sea->count; ++j)
        {
            const Partition* partition = &sea->partitions[j];
            double direction = hasDirections ? (double)SW_DIRECTION_FROM_BEARING(partition->direction) : 0.0;
            energy += sea->shapes[j].energy[i];
            swFillCosineSpread(partition->exponent[i], direction, SW_SEA_DIRECTIONS, spread);
            for (int k = 0; k < SW_SEA_DIRECTIONS; ++k)
            {
                density[k] += (float)(sea->shapes[j].energy[i] * (double)spread[k]);
            }
        }
        energies[i] = (float)energy;
    }
    swSumSeaRecord(record);
}

static void fillEnergies(const float* values, Sea* sea, float* frequencies, float* widths)
{
    bool isSplit = canSplit(values);
    double average = (double)values[SW_SUMMARY_AVERAGE_PERIOD];
    memset(sea, 0, sizeof(*sea));
    if (values[SW_SUMMARY_HEIGHT] == 0.0f)
    {
        fillPartitions(sea, FIRST_OF_PEAK, frequencies, widths);
        return;
    }
    if (isSplit)
    {
        splitSea(sea, values);
    }
    else
    {
        makeSingle(sea, values);
    }
    fillPartitions(sea, FIRST_OF_PEAK, frequencies, widths);
    if (!isSplit && values[SW_SUMMARY_DOMINANT_PERIOD] < 0.0f)
    {
        findPeak(sea, average, frequencies, widths);
    }
    else if (average > 0.0)
    {
        fitPeriod(sea, average, frequencies, widths);
    }
}

// What was told and what was assumed, of the larger system.
static void keepShape(const float* values, const Sea* sea, swSeaRecord* record)
{
    const swShape* shape = &sea->shapes[sea->count > 1 && sea->shapes[1].height > sea->shapes[0].height ? 1 : 0];
    record->partitionCount = sea->count;
    record->gamma = sea->count > 0 ? (float)shape->gamma : 0.0f;
    record->tailExponent = sea->count > 0 ? (float)shape->tail : 0.0f;
    bool isTold = sea->count > 0 && values[SW_SUMMARY_AVERAGE_PERIOD] > 0.0f;
    record->averagePeriod = isTold ? values[SW_SUMMARY_AVERAGE_PERIOD] : 0.0f;
}

static void fillRecord(const float* values, Sea* sea, swSeaRecord* record)
{
    float* frequencies = swGetSeaRow(record, SW_SEA_FREQUENCIES);
    fillEnergies(values, sea, frequencies, swGetSeaRow(record, SW_SEA_BANDWIDTHS));
    keepShape(values, sea, record);
    record->hasDirections = sea->count > 0 && findDirections(sea, (double)values[SW_SUMMARY_MEAN_DIRECTION]);
    fillExponents(sea, record->hasDirections, frequencies);
    if (record->hasDirections)
    {
        fillMoments(sea, record);
    }
    fillTable(sea, record->hasDirections, record);
}

// ---- the sea ----

static swResult checkCount(const swHost* host, const swSummaryFile* file)
{
    const swNdbcRow* rows = file->rows.data;
    size_t count = 0;
    size_t leftOut = 0;
    for (size_t i = 0; i < file->rows.count; ++i)
    {
        const float* values = (const float*)file->values.data + rows[i].first;
        count += isWhole(values) ? 1 : 0;
        leftOut += hasHeight(values) && !isWhole(values) ? 1 : 0;
    }
    if (leftOut > 0)
    {
        swLog(host, SW_LOG_WARNING, "%s: %zu records have a wave height but no period and are left out.", file->name,
              leftOut);
    }
    if (count == 0)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:%d: no line of the file has both a wave height and a period.",
                      file->name, rows[0].line);
    }
    if (count > MAX_RECORDS)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:%d: more than %d records; cut the file in time.", file->name,
                      rows[0].line, MAX_RECORDS);
    }
    return SW_SUCCESS;
}

static swResult fillSea(const swHost* host, const void* context, swMeasuredSea* sea)
{
    const swSummaryFile* file = context;
    Sea* scratch = swAllocate(host, sizeof(*scratch));
    if (scratch == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for the waves of %s.", file->name);
    }
    const swNdbcRow* rows = file->rows.data;
    swResult result = SW_SUCCESS;
    size_t missedCount = 0;
    int firstMissed = 0;
    for (size_t i = 0; i < file->rows.count && result == SW_SUCCESS; ++i)
    {
        const float* values = (const float*)file->values.data + rows[i].first;
        if (!isWhole(values))
        {
            continue;
        }
        swSeaRecord* record = NULL;
        result = swAddSeaRecord(sea, FREQUENCIES, SW_SEA_DIRECTIONS, &record);
        if (result == SW_SUCCESS)
        {
            record->hasTime = true;
            record->seconds = 60.0 * (double)rows[i].minutes;
            fillRecord(values, scratch, record);
            firstMissed = scratch->isMissed && missedCount == 0 ? rows[i].line : firstMissed;
            missedCount += scratch->isMissed ? 1 : 0;
        }
    }
    swFree(host, scratch, sizeof(*scratch));
    if (missedCount > 0)
    {
        swLog(
            host, SW_LOG_WARNING,
            "%s:%d: %zu of %zu records have an average period (APD) that no shape with their peak and height has; they "
            "come as near as one can. This line is the first.",
            file->name, firstMissed, missedCount, sea->records.count);
    }
    return result;
}

swResult swParseNdbcSummary(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    SW_REQUIRE_PLACE(host, sea, "swParseNdbcSummary()");
    if (text == NULL)
    {
        return swFail(host, SW_ERROR_INVALID, "swParseNdbcSummary() needs the text of a summary.");
    }
    swSummaryFile file;
    swResult result = swReadSummaryFile(host, text, size, name != NULL ? name : "summary", &file);
    result = result == SW_SUCCESS ? checkCount(host, &file) : result;
    result = result == SW_SUCCESS ? swMakeFilledSea(host, file.name, fillSea, &file, sea) : result;
    swFreeSummaryFile(host, &file);
    return result;
}
