// SPDX-License-Identifier: MIT
#pragma once

// The two kinds of spectra in netCDF files: by direction, and energies with circular moments.

#include "files/netcdf_axes.h"
#include "files/netcdf_directions.h"

// Whether the file has such spectra; then axes->main is their variable.
bool swFindNetcdfSpectra(swNetcdfAxes* axes);
bool swFindNetcdfMoments(swNetcdfAxes* axes);

// Read them all into a sea and finish it.
swResult swReadNetcdfSpectra(swNetcdfAxes* axes, swDirectionMeaning asked, swMeasuredSea* sea);
swResult swReadNetcdfMoments(swNetcdfAxes* axes, swDirectionMeaning asked, swMeasuredSea* sea);

// ---- what both share ----

// To m2/Hz from the unit of axes->main and of its frequencies; `unit` is in lower case, as attributes are for words.
double swFindNetcdfUnit(const swNetcdfAxes* axes, const char* unit);

// Tell what was left out, and finish the sea.
swResult swFinishNetcdfSea(const swNetcdfAxes* axes, swNetcdfLosses* losses, swMeasuredSea* sea);
