// SPDX-License-Identifier: MIT
#pragma once

// NDBC tables of wave heights, periods and directions, read into rows.

#include "core/base/array.h"
#include "core/formats/ndbc_rows.h"

// What is kept of a line: heights in m, periods in s, directions that waves come from in degrees.
typedef enum swSummaryField
{
    SW_SUMMARY_HEIGHT,
    SW_SUMMARY_SWELL_HEIGHT,
    SW_SUMMARY_SWELL_PERIOD,
    SW_SUMMARY_SWELL_DIRECTION,
    SW_SUMMARY_WIND_HEIGHT,
    SW_SUMMARY_WIND_PERIOD,
    SW_SUMMARY_WIND_DIRECTION,
    SW_SUMMARY_DOMINANT_PERIOD,
    SW_SUMMARY_AVERAGE_PERIOD,
    SW_SUMMARY_MEAN_DIRECTION,
    SW_SUMMARY_FIELD_COUNT
} swSummaryField;

typedef struct swSummaryFile
{
    const char* name;
    swArray rows;   // swNdbcRow, ascending in time, each time once
    swArray values; // float [SW_SUMMARY_FIELD_COUNT] a row; SW_NDBC_MISSING where there is none
} swSummaryFile;

// Read a text. `file` needs swFreeSummaryFile() whatever the result.
swResult swReadSummaryFile(const swHost* host, const char* text, size_t size, const char* name, swSummaryFile* file);
void swFreeSummaryFile(const swHost* host, swSummaryFile* file);
