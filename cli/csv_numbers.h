// SPDX-License-Identifier: MIT
#pragma once

// Columns of numbers out of a CSV file. A header line names the columns, in any order and with others between them;
// without one a line has the known columns in their order, with or without the optional one.

#include <stdbool.h>

#define MAX_CSV_COLUMNS 32

typedef struct CsvColumn
{
    const char* name;
    const char* nameWithUnit; // also known by this; NULL: there is none
    double min, max;          // equal: any number
    bool isOptional;          // one of a format at most; 0 where a file has none
} CsvColumn;

typedef struct CsvFormat
{
    const char* rows; // what a line is, in the plural: "points"
    const CsvColumn* columns;
    int columnCount;

    // NULL, or what is wrong with the numbers of a row together.
    const char* (*check)(const double* row);
} CsvFormat;

typedef struct CsvNumbers
{
    const CsvFormat* format;
    double* values; // [count][format->columnCount]
    int count, capacity;
    int unknownCount; // rows with a NAN, which the file calls "nan"
    bool hasOptional;
} CsvNumbers;

// `numbers` is empty before, and the format outlives it. "-" is standard input. At least one row, or a complaint that
// names the line.
bool ReadCsvNumbers(const char* path, const CsvFormat* format, CsvNumbers* numbers);

const double* GetCsvRow(const CsvNumbers* numbers, int row);

void FreeCsvNumbers(CsvNumbers* numbers);
