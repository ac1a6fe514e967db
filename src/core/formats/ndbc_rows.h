// SPDX-License-Identifier: MIT
#pragma once

// What the readers of the National Data Buoy Center's files share: headings, dates, and rows in order of time.

#include "core/base/array.h"
#include "core/base/text.h"

// Stands for a number that the buoy did not report.
#define SW_NDBC_MISSING (-1.0f)

#define SW_NDBC_MAX_ROWS 1000000
#define SW_NDBC_MAX_VALUES 1048576

// Headings begin with '#' or, in old archives, with the label of the year.
bool swIsNdbcHeading(swText* text);

// Year, month, day, hour and perhaps minute at the beginning of a line. SW_ERROR_FORMAT with a sentence in the log.
swResult swReadNdbcDate(swText* text, bool hasMinutes, int64_t* minutes);

typedef struct swNdbcRow
{
    int64_t minutes; // since 1970, UTC
    size_t first;    // of its values
    int set;
    int line;
} swNdbcRow;

// SW_ERROR_FORMAT if a file holds too much for another row: it is refused as a whole.
swResult swCheckNdbcRoom(const swText* text, size_t rowCount, size_t valueCount);

// SW_ERROR_NO_MEMORY if there is no room.
swResult swAppendNdbcRow(const swText* text, swArray* rows, const swNdbcRow* row);

// Ascending in time. Of two rows of one time the first in the file stays, with a warning.
void swSortNdbcRows(const swText* text, swArray* rows);
