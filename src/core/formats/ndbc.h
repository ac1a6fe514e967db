// SPDX-License-Identifier: MIT
#pragma once

// One text file of the US National Data Buoy Center with a number per frequency and time, read into rows.

#include "core/base/array.h"
#include "core/formats/ndbc_rows.h"

// What a file holds decides which numbers it may have. Real-time files say in their heading what they hold.
typedef enum swNdbcQuantity
{
    SW_NDBC_ENERGY, // m^2/Hz
    SW_NDBC_ALPHA1, // degrees
    SW_NDBC_ALPHA2,
    SW_NDBC_R1, // 0 to 1, or 0 to 100 in archives; read as 0 to 1
    SW_NDBC_R2,
    SW_NDBC_QUANTITY_COUNT
} swNdbcQuantity;

#define SW_NDBC_MAX_FREQUENCIES 1024

// Frequencies as printed, Hz; `first` indexes swNdbcFile::frequencies.
typedef struct swNdbcSet
{
    size_t first;
    int count;
    bool isCut; // a longer list begins as this one: its lines are cut off
} swNdbcSet;

typedef struct swNdbcFile
{
    const char* name;
    swArray frequencies; // float
    swArray sets;        // swNdbcSet
    swArray rows;        // swNdbcRow, ascending in time, each time once
    swArray values;      // float; a row has as many as its set has frequencies
} swNdbcFile;

// Read a text. `file` needs swFreeNdbcFile() whatever the result.
swResult swReadNdbcFile(const swHost* host, const char* text, size_t size, const char* name, swNdbcQuantity quantity,
                        swNdbcFile* file);
void swFreeNdbcFile(const swHost* host, swNdbcFile* file);

// The row at a time, or NULL.
const swNdbcRow* swFindNdbcRow(const swNdbcFile* file, int64_t minutes);
