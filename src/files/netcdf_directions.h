// SPDX-License-Identifier: MIT
#pragma once

// What the directions of a netCDF file mean.

#include "files/netcdf_file.h"
#include "seaway/measured.h"

// What a text says of directions: SW_DIRECTIONS_BY_FORMAT where it says nothing, or one thing and its contrary. In
// lower case, '_' and '-' as spaces.
swDirectionMeaning swFindDirectionWords(const char* text);

// A direction where waves go as the world has it, radians from east towards south.
double swTurnDirection(swDirectionMeaning meaning, double degrees);

// Means of cos and sin of an angle that `meaning` counts, `order` times, as those of the direction where waves go.
void swTurnMoments(swDirectionMeaning meaning, int order, double* a, double* b);

// Who writes such files, and what they mean where the file says nothing.
typedef struct swNetcdfWriter
{
    const char* name;
    swDirectionMeaning meaning;
    bool isCertain;   // the writer's own source or manual lays it down
    bool isFromXAxis; // where waves go is counted counterclockwise from the x-axis
} swNetcdfWriter;

// By the attributes of the variable of directions, of the densities (-1: there is none) and of the file. With `asked`
// other than SW_DIRECTIONS_BY_FORMAT that is taken. Where nothing tells, the writer's meaning is assumed with a
// warning.
swMeasuredDirections swFindNetcdfDirections(const swNetcdfFile* file, int directions, int densities,
                                            const swNetcdfWriter* writer, swDirectionMeaning asked);
