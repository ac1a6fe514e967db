// SPDX-License-Identifier: MIT
#pragma once

// Rasters in netCDF that have no axes.

#include "files/netcdf_file.h"
#include "seaway/files.h"

bool swIsGmtGrid(const swNetcdfFile* file);
swResult swReadGmtGrid(const swNetcdfFile* file, const swRasterFileDef* def, swRaster** raster);
