// SPDX-License-Identifier: MIT
#pragma once

// What the readers of measured seas fill and swMeasuredSea_GetRecord() hands out.

#include <stdbool.h>
#include <stdint.h>

#include "core/base/array.h"
#include "core/spectra/spreading.h"
#include "seaway/measured.h"

// Of tables that are made from moments or formulas.
#define SW_SEA_DIRECTIONS 72

// Spreading of waves whose file holds no directions, around east.
#define SW_SEA_DEFAULT_EXPONENT 8.0

#define SW_SEA_MAX_FREQUENCIES 1024
#define SW_SEA_MAX_DIRECTIONS 720
#define SW_SEA_MAX_DENSITY 1e6 // m^2/Hz/rad
#define SW_SEA_MAX_ENERGY 5e4  // m^2/Hz: less, as all of it may go one way
#define SW_SEA_MAX_FLOATS ((size_t)1 << 27)

// A record owns its floats: rows of [frequencyCount] as swSeaRow names them, then the table.
typedef struct swSeaRecord
{
    bool hasTime;
    double seconds; // since 1970, UTC
    int location;
    int order; // in which it was added
    int frequencyCount;
    int directionCount;
    float firstDirection;
    int correctedCount;
    int partitionCount;
    float averagePeriod, gamma, tailExponent; // see swMeasuredRecord
    int missingCount;                         // see swMeasuredRecord
    int negativeCount;
    double negativeVariance; // taken away by negative densities, m^2
    double addedVariance;    // which the record has more than the file, m^2
    bool hasDirections;
    double variance;
    size_t floatsSize;
    float* floats;
} swSeaRecord;

struct swMeasuredSea
{
    swHost host;
    char name[256];    // for messages
    swArray records;   // swSeaRecord
    swArray locations; // swMeasuredLocation
    swMeasuredDirections directions;
    swArray places; // finds them, see sea_places.c
    size_t floatCount;
    bool isFull; // another record was refused because there are too many: no fault of that record
};

typedef enum swSeaRow
{
    SW_SEA_FREQUENCIES,
    SW_SEA_BANDWIDTHS,
    SW_SEA_ENERGY,
    SW_SEA_MEAN_DIRECTION,
    SW_SEA_R1,
    SW_SEA_DIRECTION2,
    SW_SEA_R2,
    SW_SEA_MEASURED_DIRECTION, // NAN where it was filled in
    SW_SEA_MEASURED_R1,
    SW_SEA_TABLE
} swSeaRow;

static inline float* swGetSeaRow(const swSeaRecord* record, swSeaRow row)
{
    return record->floats + (size_t)row * (size_t)record->frequencyCount;
}

// A record to fill, cleared, of directions from 0 on; valid until the next is added. SW_ERROR_FORMAT if the sea grows
// too large.
swResult swAddSeaRecord(swMeasuredSea* sea, int frequencyCount, int directionCount, swSeaRecord** record);

// Makes the last place findable; false if there is no memory. swMeasuredSea_AddLocation() does it.
bool swIndexSeaPlace(swMeasuredSea* sea, int location);
void swFreeSeaPlaces(swMeasuredSea* sea);

// Index of the first place of this name and position, NAN where not known; -1 if there is none.
int swFindSeaPlace(const swMeasuredSea* sea, const char* name, double longitude, double latitude);

// The place of a point by its name, looked for first where it stands in a block; a new one is added.
swResult swFindSeaPoint(swMeasuredSea* sea, bool isNew, int index, const char* name, double longitude, double latitude,
                        int* location);

// Energies that are missing (NAN) become none. Those between others that matter are counted in missingCount.
void swCloseSeaGaps(swSeaRecord* record);

// How many NAN in a row of densities by direction lie between others that matter, beside the record's largest.
int swCountSeaGaps(const double* row, int count, double largest);

// After the energies: sums the record's variance.
void swSumSeaRecord(swSeaRecord* record);

// The rule for negative densities, which swMeasuredRecord::negativeCount tells. `least` is the smallest density that
// can be one: smaller numbers mark what is missing.
double swFindLeastDensity(const double* densities, size_t count);

// Make the row of one frequency a row without negative densities, of the same sum if that is positive, else of zeros.
// NAN counts as none. `cell`: the variance of a density of one, m^2.
void swClipSeaRow(swSeaRecord* record, double least, double cell, int count, double* row);

// Circular moments of a frequency, as far as the file tells them.
typedef struct swSeaMoments
{
    bool hasFirst, hasSecond;
    bool hasSpread; // the length of the first is told, not assumed
    swMoments moments;
} swSeaMoments;

// The table of a record of SW_SEA_DIRECTIONS whose frequencies, bandwidths and energies are there, from the moments by
// frequency. Fills gaps and corrects what is impossible; without any first moments spreads around east.
void swFillSeaDirections(swSeaRecord* record, const swSeaMoments* moments);

// Keep the moments of frequency i, those of a distribution that integrates to one, and whether its mean direction and
// r1 were told by the file.
void swKeepSeaMoments(swSeaRecord* record, int i, const swMoments* moments, bool hasDirection, bool hasSpread);

// The moments of cos^2s stand in for second moments that are missing.
swMoments swCompleteMoments(const swSeaMoments* moments);

// A mean direction where waves go, radians, and the spread sqrt(2 (1 - r1)), radians; NAN: not known.
swSeaMoments swMakeSeaMoments(double direction, double spread);

// Bandwidths that reach half-way to the neighbours, at the ends as far outwards as inwards but not below zero.
void swFillBandwidths(int count, const float* frequencies, float* widths);
