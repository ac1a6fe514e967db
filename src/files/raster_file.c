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
                             .scale = 1.0,
                             .missing = (double)NAN,
                             .spacingEast = (double)NAN,
                             .spacingNorth = (double)NAN,
                             .imageEast = (double)NAN,
                             .imageNorth = (double)NAN,
                             .memoryLimit = (size_t)1 << 30,
                             .internalValue = SW_DEF_COOKIE};
}

typedef swResult swReadGridFile(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster);

// A format that is known by its first bytes and read by a library.
typedef struct GridFormat
{
    const char* name;
    const char* package;
    const char* marks[4];
    int markSizes[4];
    swReadGridFile* read; // NULL: without its library
} GridFormat;

static const GridFormat s_formats[] = {
    {"netCDF",
     "libnetcdf-dev",
     {"CDF", "\x89HDF"},
     {3, 4},
#if SW_HAS_NETCDF
     swReadNetcdfGrid
#else
     NULL
#endif
    },
    {"a PNG image",
     "libpng-dev",
     {"\x89PNG\r\n\x1a\n"},
     {8},
#if SW_HAS_PNG
     swReadPngGrid
#else
     NULL
#endif
    },
    {"an EXR image",
     "libopenexr-dev",
     {"\x76\x2f\x31\x01"},
     {4},
#if SW_HAS_EXR
     swReadExrGrid
#else
     NULL
#endif
    },
    {"a TIFF image",
     "libtiff-dev",
     {"II*\0", "MM\0*", "II+\0", "MM\0+"},
     {4, 4, 4, 4},
#if SW_HAS_TIFF
     swReadTiffGrid
#else
     NULL
#endif
    },
};

static const GridFormat* findFormat(const char* path)
{
    char bytes[8] = {0};
    FILE* file = fopen(path, "rb");
    size_t size = file != NULL ? fread(bytes, 1, sizeof(bytes), file) : 0;
    if (file != NULL)
    {
        fclose(file);
    }
    for (size_t i = 0; i < sizeof(s_formats) / sizeof(s_formats[0]); ++i)
    {
        for (int k = 0; k < 4 && s_formats[i].marks[k] != NULL; ++k)
        {
            size_t markSize = (size_t)s_formats[i].markSizes[k];
            if (size >= markSize && memcmp(bytes, s_formats[i].marks[k], markSize) == 0)
            {
                return &s_formats[i];
            }
        }
    }
    return NULL;
}

static swResult readFormat(const swHost* host, const GridFormat* format, const char* path, const swRasterFileDef* def,
                           swRaster** raster)
{
    if (format->read == NULL)
    {
        return swFail(host, SW_ERROR_UNSUPPORTED,
                      "%s is %s, which this build does not read: configure with %s "
                      "installed.",
                      path, format->name, format->package);
    }
    return format->read(host, path, def, raster);
}

static bool isSpacing(double spacing)
{
    return isnan(spacing) || (spacing > 0.0 && spacing <= 1e6);
}

static bool isWithin(double number, double most)
{
    return number >= -most && number <= most;
}

static swResult checkFileDef(const swHost* host, const swRasterFileDef* def)
{
    SW_REQUIRE((unsigned)def->coordinates < SW_RASTER_COORDINATES_COUNT, SW_ERROR_INVALID, host,
               "swRasterFileDef::coordinates is %d; there are %d", (int)def->coordinates, SW_RASTER_COORDINATES_COUNT);
    SW_REQUIRE((unsigned)def->numbers < SW_RASTER_NUMBERS_COUNT, SW_ERROR_INVALID, host,
               "swRasterFileDef::numbers is %d; there are %d", (int)def->numbers, SW_RASTER_NUMBERS_COUNT);
    SW_REQUIRE(!isinf(def->originEast) && !isinf(def->originNorth) && !isnan(def->west) && !isnan(def->east) &&
                   !isnan(def->north) && !isnan(def->south),
               SW_ERROR_INVALID, host, "swRasterFileDef has an origin or an edge that is no number");
    SW_REQUIRE(isWithin(def->offset, 1e6) && isWithin(def->scale, 1e6), SW_ERROR_INVALID, host,
               "swRasterFileDef has offset %g and scale %g; both are within 1e6 of 0", def->offset, def->scale);
    SW_REQUIRE(isSpacing(def->spacingEast) && isSpacing(def->spacingNorth), SW_ERROR_INVALID, host,
               "swRasterFileDef has spacings %g and %g; they are above 0 and at most 1e6, or NaN", def->spacingEast,
               def->spacingNorth);
    SW_REQUIRE(!isinf(def->imageEast) && !isinf(def->imageNorth), SW_ERROR_INVALID, host,
               "swRasterFileDef has an infinite place of the image");
    SW_REQUIRE(def->rawWidth >= 0 && def->rawHeight >= 0 && (def->rawWidth > 0) == (def->rawHeight > 0),
               SW_ERROR_INVALID, host, "swRasterFileDef has rawWidth %d and rawHeight %d; both are above 0, or both 0",
               def->rawWidth, def->rawHeight);
    return SW_SUCCESS;
}

// Text and numbers without a heading hold one number a cell.
static swResult refuseVariable(const swHost* host, const char* path, const swRasterFileDef* def)
{
    return def->variable == NULL
               ? SW_SUCCESS
               : swFail(host, SW_ERROR_FORMAT,
                        "%s holds one number a cell, and no variable or channel '%s'; leave out "
                        "swRasterFileDef::variable (in scenes variable), and name a file for each channel.",
                        path, def->variable);
}

swResult swReadRaster(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster)
{
    SW_REQUIRE_PLACE(host, raster, "swReadRaster()");
    swRasterFileDef usual = swDefaultRasterFileDef();
    def = def != NULL ? def : &usual;
    SW_REQUIRE(path != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, host,
               "swReadRaster() needs a path, and a def made by swDefaultRasterFileDef()");
    swResult result = checkFileDef(host, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (swIsDevice(path))
    {
        return swFail(host, SW_ERROR_FILE, "Cannot read %s: it is a pipe or a device, and no file.", path);
    }
    const GridFormat* format = def->rawWidth > 0 ? NULL : findFormat(path);
    if (format != NULL)
    {
        return readFormat(host, format, path, def, raster);
    }
    result = refuseVariable(host, path, def);
    if (result != SW_SUCCESS || def->rawWidth > 0)
    {
        return result != SW_SUCCESS ? result : swReadRawGrid(host, path, def, raster);
    }
    swFileText text = {0};
    result = swReadText(host, path, MOST_BYTES, &text);
    if (result == SW_SUCCESS)
    {
        result = swIsEsriGrid(&text) ? swReadEsriGrid(host, &text, path, def, raster)
                                     : swReadXyzGrid(host, &text, path, def, raster);
    }
    swFreeText(host, &text);
    return result;
}
