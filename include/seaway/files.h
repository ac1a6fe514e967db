// SPDX-License-Identifier: MIT
#pragma once

#include "measured.h"
#include "raster.h"

/// @file
/// Files whose formats need a library: measured seas as text, gzip, JSON and netCDF. Part of the scene library.

/// Read a measured sea: any text that swParseMeasuredSea() reads; an NDBC energy file, the direction files beside it
/// being found by their names; and, where their libraries were there when this was built, JSON and netCDF. The format
/// is known by the contents, plain or gzip (netCDF: plain).
/// @return SW_ERROR_FILE, SW_ERROR_FORMAT (file, line and remedy in the host's log), SW_ERROR_NO_MEMORY
SW_API swResult swReadMeasuredSea(const swHost* host, const char* path, swMeasuredSea** sea);

/// How a file of measured seas is read. Must be initialized with swDefaultMeasuredFileDef().
typedef struct swMeasuredFileDef
{
    /// What the directions in a netCDF file mean, whatever it says itself: SW_DIRECTIONS_FROM or SW_DIRECTIONS_TO.
    /// Formats that lay down what directions mean are refused with it. Default SW_DIRECTIONS_BY_FORMAT: what the file
    /// says and, where it says nothing, what others who write such files mean, with a warning.
    swDirectionMeaning directions;

    /// Set by swDefaultMeasuredFileDef().
    int internalValue;
} swMeasuredFileDef;

SW_API swMeasuredFileDef swDefaultMeasuredFileDef(void);

/// swReadMeasuredSea() with a def.
/// @return as swReadMeasuredSea(); SW_ERROR_INVALID if the def was not initialized
SW_API swResult swReadMeasuredFile(const swHost* host, const char* path, const swMeasuredFileDef* def,
                                   swMeasuredSea** sea);

/// Index of a place by its name or, if none has it, by its number from 1 on; -1 if there is none.
SW_API int swFindMeasuredPlace(const swMeasuredSea* sea, const char* text);

/// What the coordinates of a raster's file are.
typedef enum swRasterCoordinates
{
    /// What the file says or, where it says nothing, what its numbers can only be; told as a warning.
    SW_RASTER_BY_FILE,
    /// Metres east and north.
    SW_RASTER_METRES,
    /// Degrees of longitude and latitude.
    SW_RASTER_DEGREES,
    SW_RASTER_COORDINATES_COUNT
} swRasterCoordinates;

/// How a raster's file becomes metres of the world: east is +x, north is -z. Must be initialized with
/// swDefaultRasterFileDef().
typedef struct swRasterFileDef
{
    /// Default SW_RASTER_BY_FILE.
    swRasterCoordinates coordinates;

    /// The place of the file that is the world's (0, 0): metres east and north, or degrees of longitude and latitude.
    /// Default NaN: metres as they are, and of degrees the middle of the file, which the log tells. Degrees become
    /// metres on the tangent plane of the WGS 84 ellipsoid there: a degree has the same length all over the raster,
    /// which far north or south of the place is off by the cosines' ratio.
    double originEast, originNorth;

    /// Only cells whose middles lie within these metres of the world are kept: from (west, north) to (east, south), z
    /// being south. Default: no limit.
    double west, east, north, south;

    /// Of netCDF: the variable. Default NULL: the only one over both axes, or the one called elevation, z, Band1, depth
    /// or topo.
    const char* variable;

    /// The numbers count depth downwards; the raster has heights. Default false; a netCDF variable that says so
    /// (positive: down) is turned without it.
    bool isDepth;

    /// Most memory that values may take, bytes. Larger rasters are refused; crop them. Default 1 GiB.
    size_t memoryLimit;

    /// Set by swDefaultRasterFileDef().
    int internalValue;
} swRasterFileDef;

SW_API swRasterFileDef swDefaultRasterFileDef(void);

/// Read a raster: an Esri ASCII grid, lines of x, y and value (XYZ), or netCDF with an axis for each direction, such as
/// GEBCO and ETOPO. The first two plain or gzip. The format is known by the contents. Grids whose cells are named by a
/// corner and those named by their middle are both read as what they are. `def` may be NULL: the default.
/// @return SW_ERROR_FILE, SW_ERROR_FORMAT (file, line and remedy in the host's log), SW_ERROR_LIMIT (too large),
///         SW_ERROR_NO_MEMORY, SW_ERROR_UNSUPPORTED (netCDF without its library)
SW_API swResult swReadRaster(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster);
