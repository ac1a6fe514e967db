// SPDX-License-Identifier: MIT
// Units of what rasters hold, as netCDF and GDAL name them.

#include <math.h>
#include <string.h>

#include "files/raster_grid.h"

typedef struct Unit
{
    const char* name; // lower case, spaces for '_' and '-'
    double size;
} Unit;

static const Unit s_units[] = {
    {"", 1.0},
    {"1", 1.0},
    {"m", 1.0},
    {"meter", 1.0},
    {"meters", 1.0},
    {"metre", 1.0},
    {"metres", 1.0},
    {"km", 1000.0},
    {"kilometer", 1e3},
    {"kilometers", 1e3},
    {"kilometre", 1e3},
    {"kilometres", 1e3},
    {"dm", 0.1},
    {"cm", 0.01},
    {"centimeter", 0.01},
    {"centimeters", .01},
    {"centimetre", .01},
    {"centimetres", .01},
    {"mm", 0.001},
    {"millimeter", 0.001},
    {"millimeters", 1e-3},
    {"millimetre", 1e-3},
    {"millimetres", 1e-3},
    {"ft", 0.3048},
    {"foot", 0.3048},
    {"feet", 0.3048},
    {"us survey foot", 1200.0 / 3937.0},
    {"fathom", 1.8288},
    {"fathoms", 1.8288},
    {"m/s", 1.0},
    {"m s 1", 1.0},
    {"m s**1", 1.0},
    {"m s^1", 1.0},
    {"ms 1", 1.0},
    {"m.s 1", 1.0},
    {"meter/sec", 1.0},
    {"meters/second", 1.0},
    {"meter second 1", 1.0},
    {"metre second 1", 1.0},
    {"cm/s", 0.01},
    {"cm s 1", 0.01},
    {"km/h", 1.0 / 3.6},
    {"km h 1", 1.0 / 3.6},
    {"kt", 1852.0 / 3600.0},
    {"kts", 1852.0 / 3600.0},
    {"kn", 1852.0 / 3600.0},
    {"knot", 1852.0 / 3600.0},
    {"knots", 1852.0 / 3600.0},
};

double swFindRasterUnit(const char* text)
{
    for (size_t i = 0; i < sizeof(s_units) / sizeof(s_units[0]); ++i)
    {
        if (strcmp(text, s_units[i].name) == 0)
        {
            return s_units[i].size;
        }
    }
    return strncmp(text, "meter", 5) == 0 || strncmp(text, "metre", 5) == 0 ? 1.0 : (double)NAN; // "meters above ..."
}

double swKnowRasterUnit(const swRasterGrid* grid, const char* text)
{
    double size = swFindRasterUnit(text);
    if (grid->def->scale != 1.0)
    {
        return 1.0;
    }
    if (!(size > 0.0))
    {
        swLog(grid->host, SW_LOG_WARNING,
              "%s says that its numbers are in '%s', which is not known here; they are taken as they are. "
              "swRasterFileDef::scale (in scenes scale_m) makes metres of them.",
              grid->name, text);
        return 1.0;
    }
    if (size != 1.0)
    {
        swLog(grid->host, SW_LOG_INFO, "%s has numbers in '%s'; each is %g of what is read.", grid->name, text, size);
    }
    return size;
}
