// SPDX-License-Identifier: MIT
#pragma once

#include "measured.h"

/// @file
/// Files whose formats need a library: measured seas as text, gzip, JSON and netCDF. Part of the scene library.

/// Read a measured sea: any text that swParseMeasuredSea() reads; an NDBC energy file, the direction files beside it
/// being found by their names; and, where their libraries were there when this was built, JSON and netCDF. The format
/// is known by the contents, plain or gzip (netCDF: plain).
/// @return SW_ERROR_FILE, SW_ERROR_FORMAT (file, line and remedy in the host's log), SW_ERROR_NO_MEMORY
SW_API swResult swReadMeasuredSea(const swHost* host, const char* path, swMeasuredSea** sea);

/// How a file of measured seas is read. Must be initialized with swDefaultMeasuredFileDef().
typedef struct swMeasuredFileDef
{
    /// What the directions in a netCDF file mean, whatever it says itself: SW_DIRECTIONS_FROM or SW_DIRECTIONS_TO.
    /// Formats that lay down what directions mean are refused with it. Default SW_DIRECTIONS_BY_FORMAT: what the file
    /// says and, where it says nothing, what others who write such files mean, with a warning.
    swDirectionMeaning directions;

    /// Set by swDefaultMeasuredFileDef().
    int internalValue;
} swMeasuredFileDef;

SW_API swMeasuredFileDef swDefaultMeasuredFileDef(void);

/// swReadMeasuredSea() with a def.
/// @return as swReadMeasuredSea(); SW_ERROR_INVALID if the def was not initialized
SW_API swResult swReadMeasuredFile(const swHost* host, const char* path, const swMeasuredFileDef* def,
                                   swMeasuredSea** sea);

/// Index of a place by its name or, if none has it, by its number from 1 on; -1 if there is none.
SW_API int swFindMeasuredPlace(const swMeasuredSea* sea, const char* text);
