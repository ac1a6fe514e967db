// SPDX-License-Identifier: MIT
#pragma once

// What the readers of NDBC's text files share: lines, tokens, dates, rows in order of time, and arrays that grow.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "seaway/base.h"

// Stands for a number that the buoy did not report.
#define SW_NDBC_MISSING (-1.0f)

#define SW_NDBC_MAX_ROWS 1000000
#define SW_NDBC_MAX_VALUES 1048576

// ---- memory ----

// A growing array of the host's memory. All zero is empty.
typedef struct swNdbcArray
{
    void* data;
    size_t count;
    size_t capacity;
} swNdbcArray;

// Room for `count` more items at the end, not cleared; NULL if there is no memory.
void* swAppendNdbcItems(const swHost* host, swNdbcArray* array, size_t count, size_t itemSize);
void swFreeNdbcItems(const swHost* host, swNdbcArray* array, size_t itemSize);

// ---- lines and tokens ----

// A text and the place in it.
typedef struct swNdbcText
{
    const swHost* host;
    const char* name; // for messages
    const char* next; // first character of the next line
    const char* end;
    int line; // of `at`, from 1
    const char* at;
    const char* lineEnd;
} swNdbcText;

typedef struct swNdbcToken
{
    const char* text;
    int size; // at most 80
} swNdbcToken;

swNdbcText swOpenNdbcText(const swHost* host, const char* text, size_t size, const char* name);

// To the next line that holds more than spaces; false at the end.
bool swNextNdbcLine(swNdbcText* text);

// The next character that is no space; '\0' at the end of the line.
char swPeekNdbcChar(swNdbcText* text);

// Empty at the end of the line. Parentheses stand alone.
swNdbcToken swNextNdbcToken(swNdbcText* text);

bool swIsNdbcToken(swNdbcToken token, const char* word);
bool swParseNdbcNumber(swNdbcToken token, double* value);

// Headings begin with '#' or, in old archives, with the label of the year.
bool swIsNdbcHeading(swNdbcText* text);

// ---- dates ----

// Minutes since 1970 of a UTC date, and back as "YYYY-MM-DD hh:mm" (20 bytes). Years 1900 to 2199.
int64_t swGetMinutes(int year, int month, int day, int hour, int minute);
void swPrintMinutes(int64_t minutes, char text[20]);
int swGetDaysInMonth(int year, int month);

// Year, month, day, hour and perhaps minute at the beginning of a line. SW_ERROR_FORMAT with a sentence in the log.
swResult swReadNdbcDate(swNdbcText* text, bool hasMinutes, int64_t* minutes);

// ---- rows ----

typedef struct swNdbcRow
{
    int64_t minutes; // since 1970, UTC
    size_t first;    // of its values
    int set;
    int line;
} swNdbcRow;

// SW_ERROR_FORMAT if there are too many rows.
swResult swAppendNdbcRow(const swNdbcText* text, swNdbcArray* rows, const swNdbcRow* row);

// Ascending in time. Of two rows of one time the first in the file stays, with a warning.
void swSortNdbcRows(const swNdbcText* text, swNdbcArray* rows);
