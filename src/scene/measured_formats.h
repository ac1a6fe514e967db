// SPDX-License-Identifier: MIT
#pragma once

// Formats of measured seas that need a library. Only what the build found is there.

#include <stddef.h>

#include "seaway/measured.h"

// Sofar Spotter's JSON, and spectra by name as MHKiT writes them. `text` is the whole file.
swResult swReadJsonSea(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea);

// A netCDF file of WAVEWATCH III or ERA5; classic or HDF5.
swResult swReadNetcdfSea(const swHost* host, const char* path, swMeasuredSea** sea);
