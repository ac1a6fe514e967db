// SPDX-License-Identifier: MIT
#pragma once

// Formats of measured seas that need a library. Only what the build found is there.

#include <stddef.h>

#include "seaway/measured.h"

// Sofar Spotter's JSON, and spectra by name as MHKiT writes them. `text` is the whole file.
swResult swReadJsonSea(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);

// A netCDF file, classic or HDF5. `directions` other than SW_DIRECTIONS_BY_FORMAT is meant whatever the file says.
swResult swReadNetcdfSea(const swHost* host, const char* path, swDirectionMeaning directions, swMeasuredSea** sea);
