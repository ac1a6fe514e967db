// SPDX-License-Identifier: MIT
#pragma once

// What the readers of measured seas fill and swMeasuredSea_GetRecord() hands out.

#include <stdbool.h>
#include <stdint.h>

#include "seaway/spectrum.h"

// Of every table.
#define SW_SEA_DIRECTIONS 72

// Spreading of waves whose file holds no directions, around east.
#define SW_SEA_DEFAULT_EXPONENT 8.0

// Floats of one record and frequency: energy, four moments, the table.
#define SW_SEA_FLOATS (5 + SW_SEA_DIRECTIONS)

typedef struct swSeaRecord
{
    int64_t minutes; // since 1970, UTC
    int frequencyCount;
    int correctedCount;
    int partitionCount;
    bool hasDirections;
    double variance;
    const float* frequencies;
    const float* bandwidths;
    float* energy; // then meanDirection, r1, direction2, r2, each [frequencyCount], then the table
} swSeaRecord;

struct swMeasuredSea
{
    swHost host;
    int count;
    size_t recordsSize;
    swSeaRecord* records;
    size_t floatsSize;
    float* floats; // of all records, SW_SEA_FLOATS for each frequency
    size_t bandsSize;
    float* bands; // frequencies and bandwidths
};

// A sea of records to fill, cleared. `sea` needs swDestroyMeasuredSea() whatever the result.
swResult swAllocateMeasuredSea(const swHost* host, const char* name, size_t recordCount, size_t frequencyCount,
                               size_t bandCount, swMeasuredSea** sea);

// Bandwidths that reach half-way to the neighbours, at the ends as far outwards as inwards but not below zero.
void swFillBandwidths(int count, const float* frequencies, float* widths);
