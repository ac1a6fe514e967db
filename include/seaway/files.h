// SPDX-License-Identifier: MIT
#pragma once

#include "measured.h"
#include "mesh.h"
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

/// What the numbers of a file without a heading are.
typedef enum swRasterNumbers
{
    SW_RASTER_FLOAT32,
    SW_RASTER_INT16,
    SW_RASTER_UINT16,
    SW_RASTER_NUMBERS_COUNT
} swRasterNumbers;

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
    /// or topo. Of an EXR or PNG image: the channel, such as "R". Default NULL: the only one, or Y, or Z, or R.
    /// Of a GeoTIFF: "1", "2" and so on, or R, G, B, A. Default NULL: the first. Formats of one number a cell are
    /// refused with it.
    const char* variable;

    /// A number n of the file is `offset` + `scale` n metres: of a PNG image of 16 bits, n is 0 to 65535; of netCDF and
    /// GeoTIFF n has the scale and offset that the file tells already. A scale other than 1 counts instead of what the
    /// file tells of a unit, such as cm, and of a variable that counts northwards, which is turned to count along z.
    /// Ranges [-1e6, 1e6]. Default 0 and 1.
    double offset, scale;

    /// The number by which the file means that nothing is known, beside what it says itself. Default NaN: none.
    double missing;

    /// Of images and files without a heading: from cell to cell eastwards and southwards, in the file's coordinates.
    /// Above 0. Default NaN: what the file says, else 1, which the log tells.
    double spacingEast, spacingNorth;

    /// Of the same: where the middle of the north-western cell lies, in the file's coordinates. Default NaN: what the
    /// file says, else so that the middle of the image is at (0, 0), which the log tells.
    double imageEast, imageNorth;

    /// Read a file without a heading: so many numbers along its rows, which run from west to east, and so many rows,
    /// from north to south; each of the kind `numbers`, lowest byte first. The file must be as long as that. Default 0:
    /// a file with a heading.
    int rawWidth, rawHeight;
    swRasterNumbers numbers;

    /// The numbers count depth downwards; the raster has heights. Default false; a netCDF variable that says so
    /// (positive: down) is turned without it.
    bool isDepth;

    /// Most memory that values may take, bytes. Larger rasters are refused; crop them. While a file is read, twice as
    /// much is held, and of a text the text itself. Default 1 GiB, 16384 x 16384 cells.
    size_t memoryLimit;

    /// Set by swDefaultRasterFileDef().
    int internalValue;
} swRasterFileDef;

SW_API swRasterFileDef swDefaultRasterFileDef(void);

/// Read a raster: an Esri ASCII grid, lines of x, y and value (XYZ), netCDF with an axis for each direction, such as
/// GEBCO and ETOPO, or as GMT 3 wrote it, a GeoTIFF, an EXR or PNG image, or numbers without a heading. The first two
/// plain or gzip. The format is known by the contents, but for the last. Grids whose cells are named by a corner and
/// those named by their middle are both read as what they are. Longitudes may run across 180 or 360 degrees. Where a
/// file has float32 values, they are kept to the bit. See docs/depth.md. `def` may be NULL: the default.
/// @return SW_ERROR_FILE, SW_ERROR_FORMAT (file, line and remedy in the host's log), SW_ERROR_LIMIT (too large),
///         SW_ERROR_NO_MEMORY, SW_ERROR_UNSUPPORTED (a format whose library was not there when this was built)
SW_API swResult swReadRaster(const swHost* host, const char* path, const swRasterFileDef* def, swRaster** raster);

/// Write a raster as an EXR image of one channel, Y, of 32-bit floats; swReadRaster() reads the same bits at the same
/// place, and anything that knows EXR reads its numbers. The header says where the cells lie, and what the raster was
/// made from: a text (NULL for none) and a hash, of which swReadRasterSource() tells. The file that was there stays
/// whole until the new one is.
/// @return SW_ERROR_INVALID, SW_ERROR_FILE, SW_ERROR_NO_MEMORY, SW_ERROR_UNSUPPORTED (built without OpenEXR)
SW_API swResult swWriteRaster(const swHost* host, const char* path, const swRaster* raster, const char* madeFrom,
                              uint64_t sourceHash);

/// Room for the text of what a raster was made from, with its zero.
#define SW_MAX_RASTER_SOURCE 1024

/// What a file of swWriteRaster() says it was made from. A hash other than that of what it would be made from now, on
/// the same lattice, says that it is stale (see swWorld_HashFloor()).
typedef struct swRasterSource
{
    char text[SW_MAX_RASTER_SOURCE]; ///< empty if the file says none
    uint64_t hash;
    int width, height; ///< the lattice, as of swRasterDef
    double x, z;
    double spacingX, spacingZ;
} swRasterSource;

/// @return SW_ERROR_FILE, SW_ERROR_FORMAT (no EXR image, or one that does not say), SW_ERROR_UNSUPPORTED
SW_API swResult swReadRasterSource(const swHost* host, const char* path, swRasterSource* source);

/// Which way is up in a mesh's file.
typedef enum swMeshUp
{
    SW_MESH_Y_UP, ///< as glTF has it, and here
    SW_MESH_Z_UP, ///< as drawings and most STL have it: x stays, y becomes -z
    SW_MESH_UP_COUNT
} swMeshUp;

/// How a mesh's file becomes metres. Must be initialized with swDefaultMeshFileDef().
typedef struct swMeshFileDef
{
    /// Default SW_MESH_Y_UP.
    swMeshUp up;

    /// Metres of one of the file's lengths. Range [1e-6, 1e6]. Default 1.
    float scale;

    /// See swMeshDef::highest; m, after scaling. Range [-1e6, 1e6]. Default 1e6.
    float highest;

    /// Set by swDefaultMeshFileDef().
    int internalValue;
} swMeshFileDef;

SW_API swMeshFileDef swDefaultMeshFileDef(void);

/// Read a mesh: OBJ, glTF (gltf, glb), STL or PLY, which is known by the end of the file's name. All triangles of all
/// nodes, each where its node puts it; lines and points are left out. Colours of corners become the mesh's values (red,
/// green, blue, cover) if every part has them. `def` may be NULL: the default.
/// @return SW_ERROR_FILE, SW_ERROR_FORMAT (what is wrong in the host's log), SW_ERROR_LIMIT (too many triangles),
///         SW_ERROR_NO_MEMORY, SW_ERROR_UNSUPPORTED (another format, or built without Assimp)
SW_API swResult swReadMesh(const swHost* host, const char* path, const swMeshFileDef* def, swMesh** mesh);
