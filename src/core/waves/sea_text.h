// SPDX-License-Identifier: MIT
#pragma once

// What the readers of measured seas share: lines, tokens, numbers, dates, rows in order of time, and arrays that grow.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/base/number.h"
#include "seaway/base.h"

// Stands for a number that the buoy did not report.
#define SW_NDBC_MISSING (-1.0f)

#define SW_NDBC_MAX_ROWS 1000000
#define SW_NDBC_MAX_VALUES 1048576

// ---- memory ----

// A growing array of the host's memory. All zero is empty.
typedef struct swSeaArray
{
    void* data;
    size_t count;
    size_t capacity;
} swSeaArray;

// Room for `count` more items at the end, not cleared; NULL if there is no memory.
void* swAppendSeaItems(const swHost* host, swSeaArray* array, size_t count, size_t itemSize);
void swFreeSeaItems(const swHost* host, swSeaArray* array, size_t itemSize);

// ---- lines and tokens ----

// A text and the place in it.
typedef struct swSeaText
{
    const swHost* host;
    const char* name; // for messages
    const char* next; // first character of the next line
    const char* end;
    int line; // of `at`, from 1
    const char* lineBegin;
    const char* at;
    const char* lineEnd;
    char separator; // of fields: ',' unless a heading shows another
} swSeaText;

typedef struct swSeaToken
{
    const char* text;
    int size; // at most 80
} swSeaToken;

// Passes over the byte order mark that some editors write. Lines end in LF, CR LF or CR; the last may lack its end.
swSeaText swOpenSeaText(const swHost* host, const char* text, size_t size, const char* name);

// To the next line that holds more than spaces; false at the end.
bool swNextSeaLine(swSeaText* text);

// The next character that is no space; '\0' at the end of the line.
char swPeekSeaChar(swSeaText* text);

// Empty at the end of the line. Parentheses stand alone.
swSeaToken swNextSeaToken(swSeaText* text);

// The next field of a line with commas, or another separator, without the spaces and quotes around it; false behind the
// last.
bool swNextSeaField(swSeaText* text, swSeaToken* field);

// Whether a field says that nothing is known: empty, NaN, MM, N/A, null, or -9, -99, -999, ...
bool swIsSeaMissing(swSeaToken token);

bool swIsSeaToken(swSeaToken token, const char* word);
bool swParseSeaNumber(swSeaToken token, double* value);

// Whether the rest of the line begins with a word; spaces are passed over.
bool swHasSeaPrefix(swSeaText* text, const char* word);

// The next number of a text that is wrapped at will: across lines, after spaces or commas. It ends where the next
// begins, even if a sign is all that parts them, as Fortran writes. "0.261-100", an exponent that has pushed its
// letter out, is small enough to be 0 where `isWide` says that exponents are written; 1e60 is the largest. Fails with
// line and name.
swResult swReadSeaNumber(swSeaText* text, const char* what, bool isWide, double* value);

// The same, refused outside of [low, high].
swResult swReadSeaRange(swSeaText* text, const char* what, double low, double high, double* value);
swResult swReadSeaCount(swSeaText* text, const char* what, int low, int high, int* value);

// To the next line that holds something; fails if the text ends, saying what is missing.
swResult swNeedSeaLine(swSeaText* text, const char* what);

// Headings begin with '#' or, in old archives, with the label of the year.
bool swIsNdbcHeading(swSeaText* text);

// ---- dates ----

// Minutes since 1970 of a UTC date, and back as "YYYY-MM-DD hh:mm" (20 bytes). Years 1900 to 2199.
int64_t swGetMinutes(int year, int month, int day, int hour, int minute);
void swPrintMinutes(int64_t minutes, char text[20]);
int swGetDaysInMonth(int year, int month);

// Seconds since 1970; false if there is no such date.
bool swMakeSeconds(int year, int month, int day, int hour, int minute, double second, double* seconds);

// 1 to 12 by the first English name of a month, or its first three letters, in text[0 .. size); 0 if there is none.
int swFindSeaMonth(const char* text, int size);

// yyyymmdd and hhmmss as numbers; false if there is no such date.
bool swMakePackedSeconds(double date, double time, double* seconds);

// Year, month, day, hour and perhaps minute at the beginning of a line. SW_ERROR_FORMAT with a sentence in the log.
swResult swReadNdbcDate(swSeaText* text, bool hasMinutes, int64_t* minutes);

// ---- rows ----

typedef struct swNdbcRow
{
    int64_t minutes; // since 1970, UTC
    size_t first;    // of its values
    int set;
    int line;
} swNdbcRow;

// SW_ERROR_FORMAT if a file holds too much for another row: it is refused as a whole.
swResult swCheckNdbcRoom(const swSeaText* text, size_t rowCount, size_t valueCount);

// SW_ERROR_NO_MEMORY if there is no room.
swResult swAppendNdbcRow(const swSeaText* text, swSeaArray* rows, const swNdbcRow* row);

// Ascending in time. Of two rows of one time the first in the file stays, with a warning.
void swSortNdbcRows(const swSeaText* text, swSeaArray* rows);
