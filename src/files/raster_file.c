// SPDX-License-Identifier: MIT
// Which format a raster's file has.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/misuse.h"
#include "files/raster_grid.h"

#define MOST_BYTES ((size_t)4 << 30)

swRasterFileDef swDefaultRasterFileDef(void)
{
    return (swRasterFileDef){.originEast = (double)NAN,
                             .originNorth = (double)NAN,
                             .west = -(double)INFINITY,
                             .east = (double)INFINITY,
                             .north = -(double)INFINITY,
                             .south = (double)INFINITY,
                             .memoryLimit = (size_t)1 << 30,
                             .internalValue = SW_DEF_COOKIE};
}

static bool isNetcdf(const char* path)
{
    unsigned char bytes[8] = {0};
    FILE* file = fopen(path, "rb");
    size_t count = file != NULL ? fread(bytes, 1, sizeof(bytes), file) : 0;
    if (file != NULL)
    {
        fclose(file);
    }
    return count == sizeof(bytes) && (memcmp(bytes, "CDF", 3) == 0 || memcmp(bytes, "\x89HDF", 4) == 0);
}

static swResult readNetcdf(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster)
{
#if SW_HAS_NETCDF
    return swReadNetcdfGrid(host, path, def, raster);
#else
    (void)def;
    (void)raster;
    return swFail(host, SW_ERROR_UNSUPPORTED,
                  "%s is netCDF, which this build does not read: configure with libnetcdf-dev installed.", path);
#endif
}

swResult swReadRaster(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster)
{
    SW_REQUIRE_PLACE(host, raster, "swReadRaster()");
    swRasterFileDef usual = swDefaultRasterFileDef();
    def = def != NULL ? def : &usual;
    SW_REQUIRE(path != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, host,
               "swReadRaster() needs a path, and a def made by swDefaultRasterFileDef()");
    SW_REQUIRE((unsigned)def->coordinates < SW_RASTER_COORDINATES_COUNT, SW_ERROR_INVALID, host,
               "swRasterFileDef::coordinates is %d; there are %d", (int)def->coordinates, SW_RASTER_COORDINATES_COUNT);
    SW_REQUIRE(!isinf(def->originEast) && !isinf(def->originNorth) && !isnan(def->west) && !isnan(def->east) &&
                   !isnan(def->north) && !isnan(def->south),
               SW_ERROR_INVALID, host, "swRasterFileDef has an origin or an edge that is no number");
    if (isNetcdf(path))
    {
        return readNetcdf(host, path, def, raster);
    }
    swFileText text = {0};
    swResult result = swReadText(host, path, MOST_BYTES, &text);
    if (result == SW_SUCCESS)
    {
        result = swIsEsriGrid(&text) ? swReadEsriGrid(host, &text, path, def, raster)
                                     : swReadXyzGrid(host, &text, path, def, raster);
    }
    swFreeText(host, &text);
    return result;
}
