// SPDX-License-Identifier: MIT
// A netCDF file of waves: which kind of spectra it holds, and what the readers of both kinds share.

#include "files/netcdf_sea.h"

#include <string.h>

#include "core/base/host.h"
#include "files/measured_formats.h"

#define WATER_WEIGHT (1025.0 * 9.81) // J/m3: of what SWAN calls energy

double swFindNetcdfUnit(const swNetcdfAxes* axes, const char* unit)
{
    double factor = strncmp(unit, "cm", 2) == 0   ? 1e-4
                    : strncmp(unit, "mm", 2) == 0 ? 1e-6
                    : strncmp(unit, "j", 1) == 0  ? 1.0 / WATER_WEIGHT
                                                  : 1.0;
    return factor * (axes->isAngular && strstr(unit, "hz") == NULL ? 2.0 * SW_PI : 1.0);
}

swResult swFinishNetcdfSea(const swNetcdfAxes* axes, swNetcdfLosses* losses, swMeasuredSea* sea)
{
    swResult result = swMeasuredSea_Finish(sea);
    if (result != SW_SUCCESS)
    {
        swReportNetcdfLosses(&axes->file, losses, axes->timeCount * axes->placeCount);
        return result;
    }
    int dryCount = 0; // places without any record
    for (int i = 0; i < swMeasuredSea_GetLocationCount(sea); ++i)
    {
        dryCount += swMeasuredSea_GetLocation(sea, i).recordCount == 0 ? 1 : 0;
    }
    int dryRecords = dryCount * (int)axes->timeCount;
    losses->emptyCount -= dryRecords < losses->emptyCount ? dryRecords : losses->emptyCount;
    if (dryCount > 0)
    {
        swLog(axes->file.host, SW_LOG_INFO, "%s: %d of %d places have no spectra, as on land.", axes->file.name,
              dryCount, swMeasuredSea_GetLocationCount(sea));
    }
    swReportNetcdfLosses(&axes->file, losses, axes->timeCount * axes->placeCount);
    return SW_SUCCESS;
}

// ---- the file ----

static swResult read(swNetcdfAxes* axes, swDirectionMeaning asked, swMeasuredSea* sea)
{
    if (swFindNetcdfSpectra(axes))
    {
        return swReadNetcdfSpectra(axes, asked, sea);
    }
    if (swFindNetcdfMoments(axes))
    {
        return swReadNetcdfMoments(axes, asked, sea);
    }
    return swFail(
        axes->file.host, SW_ERROR_FORMAT,
        "%s: it holds no variable of spectra: none that WAVEWATCH III (efth, ef), ECMWF (d2fd), SWAN (density, "
        "energy_1d), WWM (AC), NDBC (spectral_wave_density), CDIP (waveEnergyDensity), Sofar (variance_density), "
        "Copernicus (VSPEC1D), MET Norway (SPEC) or MHKiT (spectral_density) write, and none of standard_name "
        "sea_surface_wave_directional_variance_spectral_density or sea_surface_wave_variance_spectral_density.",
        axes->file.name);
}

swResult swReadNetcdfSea(const swHost* host, const char* path, swDirectionMeaning asked, swMeasuredSea** sea)
{
    *sea = NULL;
    swNetcdfAxes* axes = swAllocateZero(host, sizeof(*axes));
    if (axes == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", path);
    }
    axes->file = (swNetcdfFile){host, path, -1};
    swMeasuredSea* made = NULL;
    swResult result = swOpenNetcdfFile(&axes->file);
    result = result == SW_SUCCESS ? swCreateMeasuredSea(host, path, &made) : result;
    result = result == SW_SUCCESS ? read(axes, asked, made) : result;
    swCloseNetcdfFile(&axes->file);
    if (result == SW_SUCCESS)
    {
        *sea = made;
    }
    else
    {
        swDestroyMeasuredSea(made);
    }
    swFree(host, axes, sizeof(*axes));
    return result;
}
