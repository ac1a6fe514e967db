// SPDX-License-Identifier: MIT
#pragma once

// One text file of the US National Data Buoy Center with a number per frequency and time, read into rows.

#include <stddef.h>
#include <stdint.h>

#include "seaway/base.h"

// What a file holds decides which numbers it may have.
typedef enum swNdbcQuantity
{
    SW_NDBC_ENERGY,    // m^2/Hz
    SW_NDBC_DIRECTION, // degrees
    SW_NDBC_RATIO      // r1 and r2: 0 to 1, or 0 to 100 in archives; read as 0 to 1
} swNdbcQuantity;

// Stands for a number that the buoy did not report.
#define SW_NDBC_MISSING (-1.0f)

#define SW_NDBC_MAX_FREQUENCIES 1024
#define SW_NDBC_MAX_ROWS 1000000
#define SW_NDBC_MAX_VALUES 1048576

// Frequencies as printed, Hz; `first` indexes swNdbcFile::frequencies.
typedef struct swNdbcSet
{
    size_t first;
    int count;
} swNdbcSet;

typedef struct swNdbcRow
{
    int64_t minutes; // since 1970, UTC
    size_t first;    // of its values, as many as the set has frequencies
    int set;
    int line;
} swNdbcRow;

// A growing array of the host's memory.
typedef struct swNdbcArray
{
    void* data;
    size_t count;
    size_t capacity;
} swNdbcArray;

typedef struct swNdbcFile
{
    const char* name;
    swNdbcArray frequencies; // float
    swNdbcArray sets;        // swNdbcSet
    swNdbcArray rows;        // swNdbcRow, ascending in time, each time once
    swNdbcArray values;      // float
} swNdbcFile;

// Read a text. `file` needs swFreeNdbcFile() whatever the result.
swResult swReadNdbcFile(const swHost* host, const char* text, size_t size, const char* name, swNdbcQuantity quantity,
                        swNdbcFile* file);
void swFreeNdbcFile(const swHost* host, swNdbcFile* file);

// The row at a time, or NULL.
const swNdbcRow* swFindNdbcRow(const swNdbcFile* file, int64_t minutes);

// Minutes since 1970 of a UTC date, and back as "YYYY-MM-DD hh:mm" (20 bytes). Years 1900 to 2199.
int64_t swGetMinutes(int year, int month, int day, int hour, int minute);
void swPrintMinutes(int64_t minutes, char text[20]);
int swGetDaysInMonth(int year, int month);
