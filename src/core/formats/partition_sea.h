// SPDX-License-Identifier: MIT
#pragma once

// Seas from partitions: systems of waves by height, period and direction.

#include "core/records/measured.h"

typedef struct swSeaPartition
{
    int location;
    bool hasTime;
    double seconds; // since 1970, UTC
    int order;      // in the file
    double total;   // height of the whole sea, m; NAN: as its partitions make it
    double height;  // significant, m; 0: the time is told, but no waves
    double peak;    // Hz
    double bearing; // degrees clockwise from north, where waves come from; NAN
    double spread;  // radians; NAN
    double gamma;   // NAN
    bool isWindSea;
} swSeaPartition;

// Sorts the partitions and adds a record for each place and time.
swResult swAddPartitions(swMeasuredSea* sea, swSeaPartition* partitions, size_t count);
