// SPDX-License-Identifier: MIT
#pragma once

// Whether the header of a classic netCDF file may be believed.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "seaway/base.h"

// The beginning of a file of `fileSize` bytes.
bool swCheckNetcdfHeader(const unsigned char* header, size_t size, uint64_t fileSize);

// SW_ERROR_FORMAT with a sentence in the log if the file is classic netCDF and damaged. HDF5 is not looked into.
swResult swCheckNetcdfFile(const swHost* host, const char* path);
