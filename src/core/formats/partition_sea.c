// SPDX-License-Identifier: MIT
// Each partition becomes a JONSWAP spectrum [Hasselmann 1973] of its height with its peak at its period, spread as
// cos^2s around its direction, and a record is the sum of those of its place and time. What a file does not tell is
// assumed as of buoys' summaries (core/formats/summary_sea.c): gamma 3.3, for wind sea 2; s = 25 at the peak, for wind
// sea 10, falling off on both sides [Mitsuyasu 1975]. A spread that is told gives the same s = r1 / (1 - r1) at all
// frequencies, with r1 = 1 - spread^2 / 2, so that the partition as a whole has it.

#include "core/formats/partition_sea.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/host.h"
#include "core/math/scalar.h"
#include "core/spectra/compiled.h"

#define FREQUENCIES 96
#define FIRST_OF_PEAK 0.55
#define LAST_OF_PEAK 1.25
#define LAST_FREQUENCY 0.485
#define MAX_EXPONENT 200.0

static int comparePartitions(const void* a, const void* b)
{
    const swSeaPartition* first = a;
    const swSeaPartition* second = b;
    if (first->location != second->location)
    {
        return first->location < second->location ? -1 : 1;
    }
    if (first->seconds != second->seconds)
    {
        return first->seconds < second->seconds ? -1 : 1;
    }
    return (first->order > second->order) - (first->order < second->order);
}

// Equal ratios, but where a peak is near it is a frequency, so that periods of peaks are those told.
static void fillFrequencies(const swSeaPartition* partitions, int count, swSeaRecord* record)
{
    float* frequencies = swGetSeaRow(record, SW_SEA_FREQUENCIES);
    double low = 0.1, high = 0.1;
    bool isFirst = true;
    for (int i = 0; i < count; ++i)
    {
        if (partitions[i].height > 0.0)
        {
            low = isFirst || partitions[i].peak < low ? partitions[i].peak : low;
            high = isFirst || partitions[i].peak > high ? partitions[i].peak : high;
            isFirst = false;
        }
    }
    double begin = FIRST_OF_PEAK * low;
    double end = LAST_OF_PEAK * high > LAST_FREQUENCY ? LAST_OF_PEAK * high : LAST_FREQUENCY;
    double step = swLn(end / begin) / (FREQUENCIES - 1);
    bool isTaken[FREQUENCIES] = {false};
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        frequencies[i] = (float)(begin * swExp(step * i));
    }
    for (int i = 0; i < count; ++i)
    {
        int nearest = partitions[i].height > 0.0 ? (int)floor(swLn(partitions[i].peak / begin) / step + 0.5) : 0;
        if (nearest > 0 && nearest < FREQUENCIES - 1 && !isTaken[nearest])
        {
            frequencies[nearest] = (float)partitions[i].peak;
            isTaken[nearest] = true;
        }
    }
    swFillBandwidths(FREQUENCIES, frequencies, swGetSeaRow(record, SW_SEA_BANDWIDTHS));
}

// A JONSWAP of a height, as the sum over the record's bins.
static void fillEnergy(const swSeaPartition* partition, double height, const swSeaRecord* record, double* energy)
{
    const float* frequencies = swGetSeaRow(record, SW_SEA_FREQUENCIES);
    const float* widths = swGetSeaRow(record, SW_SEA_BANDWIDTHS);
    swCompiledSpectrum shape;
    memset(&shape, 0, sizeof(shape));
    shape.level = 1.0;
    shape.peakOmega = SW_TURN * partition->peak;
    bool hasGamma = partition->gamma == partition->gamma;
    shape.gamma = hasGamma ? partition->gamma : partition->isWindSea ? 2.0 : 3.3;
    double variance = 0.0;
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        energy[i] = swGetFormulaDensity(&shape, SW_TURN * (double)frequencies[i]);
        variance += energy[i] * (double)widths[i];
    }
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        energy[i] *= height * height / (16.0 * variance);
    }
}

static double getExponent(const swSeaPartition* partition, double frequency)
{
    if (partition->spread == partition->spread)
    {
        double r1 = 1.0 - 0.5 * partition->spread * partition->spread;
        double exponent = r1 < 0.995 ? r1 / (1.0 - r1) : MAX_EXPONENT;
        return exponent > 0.0 ? exponent : 0.0;
    }
    double ratio = frequency / partition->peak;
    double square = ratio * ratio;
    double decay = ratio < 1.0 ? square * square * ratio : 1.0 / (square * sqrt(ratio));
    return (partition->isWindSea ? 10.0 : 25.0) * decay;
}

// Add one partition to the table and, times their energies, to the moments.
static void addPartition(const swSeaPartition* partition, const double* energy, double bearing, swSeaRecord* record,
                         swMoments* moments)
{
    float spread[SW_SEA_DIRECTIONS];
    const float* frequencies = swGetSeaRow(record, SW_SEA_FREQUENCIES);
    float* energies = swGetSeaRow(record, SW_SEA_ENERGY);
    float* density = swGetSeaRow(record, SW_SEA_TABLE);
    double direction = record->hasDirections ? (double)SW_DIRECTION_FROM_BEARING(bearing) : 0.0;
    for (int i = 0; i < FREQUENCIES; ++i, density += SW_SEA_DIRECTIONS)
    {
        double exponent =
            record->hasDirections ? getExponent(partition, (double)frequencies[i]) : SW_SEA_DEFAULT_EXPONENT;
        double r1 = 0.0, r2 = 0.0;
        swGetCosineMoments(exponent, &r1, &r2);
        moments[i].a1 += energy[i] * r1 * swCos(direction);
        moments[i].b1 += energy[i] * r1 * swSin(direction);
        moments[i].a2 += energy[i] * r2 * swCos(2.0 * direction);
        moments[i].b2 += energy[i] * r2 * swSin(2.0 * direction);
        energies[i] += (float)energy[i];
        swFillCosineSpread(exponent, direction, SW_SEA_DIRECTIONS, spread);
        for (int j = 0; j < SW_SEA_DIRECTIONS; ++j)
        {
            density[j] += (float)(energy[i] * (double)spread[j]);
        }
    }
}

// A partition without direction goes where the largest that has one goes; NAN if none has.
static double findBearing(const swSeaPartition* partitions, int count)
{
    double bearing = (double)NAN, height = 0.0;
    for (int i = 0; i < count; ++i)
    {
        if (partitions[i].bearing == partitions[i].bearing && partitions[i].height > height)
        {
            bearing = partitions[i].bearing;
            height = partitions[i].height;
        }
    }
    return bearing;
}

// Returns how many partitions took the direction of another.
static size_t fillRecord(const swSeaPartition* partitions, int count, swSeaRecord* record)
{
    size_t borrowed = 0;
    swMoments moments[FREQUENCIES] = {{0}};
    double energy[FREQUENCIES], square = 0.0;
    double bearing = findBearing(partitions, count);
    fillFrequencies(partitions, count, record);
    record->hasDirections = bearing == bearing;
    for (int i = 0; i < count; ++i)
    {
        square += partitions[i].height * partitions[i].height;
    }
    bool hasSpreads = true; // each is told
    for (int i = 0; i < count; ++i)
    {
        hasSpreads = hasSpreads && (partitions[i].spread == partitions[i].spread || !(partitions[i].height > 0.0));
    }
    double total = partitions[0].total;
    double scale = total == total && square > 0.0 ? total / sqrt(square) : 1.0;
    for (int i = 0; i < count; ++i)
    {
        if (partitions[i].height > 0.0)
        {
            bool hasBearing = partitions[i].bearing == partitions[i].bearing;
            borrowed += !hasBearing && record->hasDirections ? 1 : 0;
            fillEnergy(&partitions[i], scale * partitions[i].height, record, energy);
            addPartition(&partitions[i], energy, hasBearing ? partitions[i].bearing : bearing, record, moments);
            ++record->partitionCount;
        }
    }
    const float* energies = swGetSeaRow(record, SW_SEA_ENERGY);
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        double share = energies[i] > 0.0f ? 1.0 / (double)energies[i] : 0.0;
        swMoments mean = {share * moments[i].a1, share * moments[i].b1, share * moments[i].a2, share * moments[i].b2};
        swKeepSeaMoments(record, i, &mean, true, hasSpreads);
    }
    swSumSeaRecord(record);
    return borrowed;
}

swResult swAddPartitions(swMeasuredSea* sea, swSeaPartition* partitions, size_t count)
{
    swResult result = SW_SUCCESS;
    size_t borrowed = 0;
    if (count > 0)
    {
        qsort(partitions, count, sizeof(swSeaPartition), comparePartitions);
    }
    for (size_t i = 0, end = 0; i < count && result == SW_SUCCESS; i = end)
    {
        for (end = i + 1; end < count && partitions[end].location == partitions[i].location &&
                          partitions[end].seconds == partitions[i].seconds;)
        {
            ++end;
        }
        swSeaRecord* record = NULL;
        result = swAddSeaRecord(sea, FREQUENCIES, SW_SEA_DIRECTIONS, &record);
        if (result == SW_SUCCESS)
        {
            record->location = partitions[i].location;
            record->hasTime = partitions[i].hasTime;
            record->seconds = partitions[i].seconds;
            borrowed += fillRecord(partitions + i, (int)(end - i), record);
        }
    }
    if (borrowed > 0)
    {
        swLog(&sea->host, SW_LOG_WARNING,
              "%s: %zu partitions have no direction and take that of the largest one of their hour.", sea->name,
              borrowed);
    }
    return result;
}
