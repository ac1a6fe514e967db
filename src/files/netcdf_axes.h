// SPDX-License-Identifier: MIT
#pragma once

// What spectra in netCDF files are arranged by: time, place, frequency and perhaps direction, whatever a writer names
// them.

#include "files/netcdf_file.h"
#include "seaway/measured.h"

#define SW_NETCDF_MAX_FREQUENCIES 1025
#define SW_NETCDF_MAX_DIRECTIONS 720

typedef enum swNetcdfRole
{
    SW_NETCDF_TIME,
    SW_NETCDF_FREQUENCY,
    SW_NETCDF_DIRECTION,
    SW_NETCDF_PLACE // any other dimension
} swNetcdfRole;

// Too large for a stack.
typedef struct swNetcdfAxes
{
    swNetcdfFile file;
    swNetcdfVariable main; // the densities
    swNetcdfRole roles[SW_NETCDF_MAX_DIMENSIONS];
    size_t lengths[SW_NETCDF_MAX_DIMENSIONS];
    int timeAt, frequencyAt, directionAt; // indices of dimensions; -1: there is none
    size_t timeCount, placeCount, frequencyCount, directionCount;
    bool hasTime;
    swNetcdfVariable time;
    double timeFactor; // s
    double timeOrigin; // s since 1970
    bool isAngular;    // the file's frequencies are radians a second
    bool hasBands;
    double frequencies[SW_NETCDF_MAX_FREQUENCIES];
    double bandwidths[SW_NETCDF_MAX_FREQUENCIES];
} swNetcdfAxes;

// Whether axes->main has a dimension of this kind.
bool swHasNetcdfRole(const swNetcdfAxes* axes, swNetcdfRole role);

// Which dimension of axes->main is which, and whether their lengths can be read.
swResult swFindNetcdfAxes(swNetcdfAxes* axes);

// False if there is no coordinate of that length.
bool swFindNetcdfFrequencies(const swNetcdfAxes* axes, swNetcdfVariable* variable);
bool swFindNetcdfDirectionValues(const swNetcdfAxes* axes, swNetcdfVariable* variable);

// The frequencies in Hz, and the widths of their bands where the file has them.
swResult swReadNetcdfFrequencies(swNetcdfAxes* axes);

swResult swReadNetcdfTimeUnit(swNetcdfAxes* axes);

// Seconds since 1970, NAN if the file has no times. False if this one is missing or out of range.
bool swReadNetcdfTime(const swNetcdfAxes* axes, size_t index, double* seconds);

// The indices of a place: those of dimensions that tell places apart; the others are 0.
void swFindNetcdfPlace(const swNetcdfAxes* axes, size_t place, size_t start[SW_NETCDF_MAX_DIMENSIONS]);

// Add the places with their names and where they lie.
swResult swAddNetcdfPlaces(const swNetcdfAxes* axes, swMeasuredSea* sea);

// Of a variable over some of the main variable's dimensions the value at these indices; NAN if it is missing.
double swReadNetcdfAt(const swNetcdfAxes* axes, const swNetcdfVariable* variable, const size_t* start);

// The variable's values over the frequencies at these indices of the main variable; NAN where they are missing. False
// if it is not over the frequencies.
bool swReadNetcdfRow(const swNetcdfAxes* axes, const swNetcdfVariable* variable, const size_t* start, double* values);

// "days since 1990-01-01 00:00:00" to a length in s and an origin in s since 1970. Calendars: standard ones and none.
bool swParseNetcdfTimeUnit(const char* text, const char* calendar, double* factor, double* origin);

// What goes wrong with records, told once when all are read.
typedef struct swNetcdfLosses
{
    int emptyCount;                  // all values are missing
    int timeCount;                   // the time is
    int beyondCount;                 // densities that no sea has
    int flaggedCount, doubtfulCount; // by the file's own flags: bad, questionable (kept)
} swNetcdfLosses;

void swReportNetcdfLosses(const swNetcdfFile* file, const swNetcdfLosses* losses, size_t recordCount);
