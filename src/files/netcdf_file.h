// SPDX-License-Identifier: MIT
#pragma once

// What is asked of a netCDF file, by way of libnetcdf: variables, texts, and numbers with their scale and gaps.

#include <stdbool.h>
#include <stddef.h>

#include "seaway/base.h"

#define SW_NETCDF_MAX_DIMENSIONS 8

typedef struct swNetcdfFile
{
    const swHost* host;
    const char* name; // for messages
    int id;
} swNetcdfFile;

// Numbers mean value * scale + offset unless they are a gap.
typedef struct swNetcdfVariable
{
    int id;
    int dimensionCount;
    int dimensions[SW_NETCDF_MAX_DIMENSIONS];
    double scale, offset;
    bool hasFill[2];
    double fill[2]; // as stored: _FillValue or what netCDF writes without one, missing_value
} swNetcdfVariable;

// Opens a file whose `host` and `name` are set. The header of a classic file is looked through first, because libnetcdf
// believes it. SW_ERROR_FORMAT or SW_ERROR_FILE with a sentence; then `id` is -1 and nothing is to be closed.
swResult swOpenNetcdfFile(swNetcdfFile* file);
void swCloseNetcdfFile(swNetcdfFile* file);

// False if there is no variable of that name, or none of at most SW_NETCDF_MAX_DIMENSIONS numbers wide.
bool swFindNetcdfVariable(const swNetcdfFile* file, const char* name, swNetcdfVariable* variable);

// The same by index, for a loop over all variables.
bool swGetNetcdfVariable(const swNetcdfFile* file, int id, swNetcdfVariable* variable);

// A variable of one dimension, over this one, whose name in lower case is among the names; the dimension's own name
// first.
bool swFindNetcdfCoordinate(const swNetcdfFile* file, int dimension, const char* const* names,
                            swNetcdfVariable* variable);

// Whether a text in lower case is among texts that end with NULL.
bool swIsOneOf(const char* text, const char* const* texts);

// An attribute's text, of a variable or NC_GLOBAL; empty if there is none. With `isPlain` in lower case, '_' and '-' as
// spaces, for words to be found in it.
void swGetNetcdfText(const swNetcdfFile* file, int variable, const char* attribute, bool isPlain, char* text,
                     size_t size);

// Length and name of a dimension.
size_t swGetNetcdfLength(const swNetcdfFile* file, int dimension);
void swGetNetcdfName(const swNetcdfFile* file, int dimension, char name[257]);

// A variable's name in lower case.
void swGetNetcdfVariableName(const swNetcdfFile* file, int variable, char name[257]);

// A block of numbers; gaps and what is not finite become NAN. SW_ERROR_FORMAT with a sentence in the log.
swResult swReadNetcdfBlock(const swNetcdfFile* file, const swNetcdfVariable* variable, const size_t* start,
                           const size_t* count, double* values);
