// SPDX-License-Identifier: MIT
// What a raster's file says of its numbers, and that a raster of the whole earth has no edge at its seam. Each of these
// would be a wrong sea floor without a word.
#include "support/cmocka_setup.h"
#include "support/raster_file.h"
#if SW_HAS_NETCDF
#include "support/netcdf_maker.h"
#endif

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <unistd.h>
#if SW_HAS_TIFF
#include <tiffio.h>
#endif

#include <seaway/files.h>

#define DEGREE 111319.490793 // m, of longitude on the equator

static void CheckTold(const char* words)
{
    if (strstr(s_messages, words) == NULL)
    {
        fail_msg("\"%s\" does not say \"%s\"", s_messages, words);
    }
}

static float SampleAt(const swRaster* raster, double x, double z)
{
    float value = 0.0f;
    swRaster_Sample(raster, 1, &(swPosXZ){x, z}, &value);
    return value;
}

static void WriteLines(const char* text)
{
    FILE* file = fopen(s_path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, strlen(text), file), strlen(text));
    fclose(file);
}

// ---- text ----

static void TheHeadingOfAGridHasOneNumberALine(void** state)
{
    (void)state;
    WriteLines("ncols 2\nnrows 1\nxllcorner 99,5\nyllcorner 0\ncellsize 1\n1 2\n");
    CheckRefused(NULL, SW_ERROR_FORMAT, "follow a point, not a comma");
    WriteLines("ncols 2 \t\r\nnrows 1\r\nxllcorner 99.5\nyllcorner 0\ncellsize 1\n1 2\n");
    swRaster* raster = Read(NULL);
    assert_true(swRaster_GetInfo(raster).x == 100.0);
    swDestroyRaster(raster);
}

static void MissingNumbersAreKnownAsTheyArePrinted(void** state)
{
    (void)state;
    const char* const texts[] = {
        "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value nan\nnan 2\n",
        "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -3.4028234663852886e+38\n"
        "-3.40282346638529e+38 2\n",
    };
    for (int i = 0; i < 2; ++i)
    {
        WriteLines(texts[i]);
        swRaster* raster = Read(NULL);
        assert_int_equal(swRaster_GetInfo(raster).unknownCount, 1);
        assert_true(swRaster_GetValues(raster)[1] == 2.0f);
        swDestroyRaster(raster);
    }
}

static void ChannelsThatAreNotThereAreRefused(void** state)
{
    (void)state;
    const char* const texts[] = {"ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n",
                                 "0 0 1\n1 0 2\n0 1 3\n1 1 4\n"};
    swRasterFileDef def = swDefaultRasterFileDef();
    def.variable = "G";
    for (int i = 0; i < 2; ++i)
    {
        WriteLines(texts[i]);
        CheckRefused(&def, SW_ERROR_FORMAT, "no variable or channel 'G'");
    }
    def.rawWidth = def.rawHeight = 1;
    CheckRefused(&def, SW_ERROR_FORMAT, "no variable or channel 'G'");
}

static void PipesAndDevicesAreRefused(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swRaster* raster = NULL;
    assert_int_equal(swReadRaster(&host, "/dev/zero", NULL, &raster), SW_ERROR_FILE);
    CheckTold("a pipe or a device");
}

// Heights -1000 - 100 cos(longitude) - 50 sin(longitude) all round the equator, each half degree.
static double GetRingHeight(double longitude)
{
    double angle = longitude * SW_PI / 180.0;
    return -1000.0 - 100.0 * cos(angle) - 50.0 * sin(angle);
}

static void CheckRing(double origin, double reach)
{
    swRasterFileDef def = swDefaultRasterFileDef();
    def.coordinates = SW_RASTER_DEGREES;
    def.originEast = origin;
    def.originNorth = 0.0;
    if (reach > 0.0)
    {
        def.west = -reach;
        def.east = reach;
    }
    swRaster* raster = Read(&def);
    double most = reach > 0.0 ? reach - 0.5 * DEGREE : 179.0 * DEGREE;
    for (int i = -20; i <= 20; ++i)
    {
        double x = most * i / 20.0;
        double off = (double)SampleAt(raster, x, 0.0) - GetRingHeight(origin + x / DEGREE);
        if (!(fabs(off) < 0.01))
        {
            fail_msg("about %g at x = %g m: off by %g m", origin, x, off);
        }
    }
    assert_int_equal(swRaster_GetInfo(raster).unknownCount, 0);
    swDestroyRaster(raster);
}

static void CheckRings(void)
{
    const double origins[] = {180.0, -180.0, 179.8, -179.8, 0.0, 0.3, 359.9, -0.1, 12.0, 90.0};
    for (size_t i = 0; i < sizeof(origins) / sizeof(origins[0]); ++i)
    {
        CheckRing(origins[i], 0.0);
        CheckRing(origins[i], 300e3);
    }
}

static void WriteRingOfPoints(double first, int count)
{
    FILE* file = fopen(s_path, "wb");
    assert_non_null(file);
    for (int row = -1; row <= 1; ++row)
    {
        for (int i = 0; i < count; ++i)
        {
            double longitude = first + 0.5 * i;
            fprintf(file, "%.2f %.1f %.9g\n", longitude, 0.5 * row, GetRingHeight(longitude));
        }
    }
    fclose(file);
}

static void PointsAllRoundTheEarthHaveNoEdge(void** state)
{
    (void)state;
    WriteRingOfPoints(-179.75, 720);
    CheckRings();
    WriteRingOfPoints(0.0, 721); // 0 and 360 stand twice
    CheckRings();
}

static void WhatEndsSomewhereIsNotTurned(void** state)
{
    (void)state;
    WriteRingOfPoints(-170.0, 600);
    swRasterFileDef def = swDefaultRasterFileDef();
    def.coordinates = SW_RASTER_DEGREES;
    def.originEast = -169.0;
    def.originNorth = 0.0;
    swRaster* raster = Read(&def);
    assert_true(isnan(SampleAt(raster, -2.0 * DEGREE, 0.0)) && !isnan(SampleAt(raster, -0.5 * DEGREE, 0.0)));
    swDestroyRaster(raster);
}

// ---- netCDF ----

#if SW_HAS_NETCDF
typedef struct Grid
{
    const char *axisUnit, *unit;
    nc_type type;
    double scale;
    double range[2]; // 0, 0: none
    nc_type rangeType;
    bool hasTime;
    int timeCount; // 0: one
} Grid;

// Numbers 1 to 6 on an axis of 0, 2, 4 and one of 0, 3.
static void WriteGrid(const Grid* kind)
{
    int file = MakeNetcdf(s_path, NC_NETCDF4);
    int time = AddDimension(file, "time", kind->timeCount > 0 ? (size_t)kind->timeCount : 1),
        east = AddDimension(file, "x", 3), north = AddDimension(file, "y", 2);
    int eastAxis = AddVariable(file, "x", NC_DOUBLE, 1, &east),
        northAxis = AddVariable(file, "y", NC_DOUBLE, 1, &north);
    AddText(file, eastAxis, "units", kind->axisUnit);
    AddText(file, northAxis, "units", kind->axisUnit);
    const int dimensions[3] = {time, north, east};
    int heights = AddVariable(file, "z", kind->type, kind->hasTime ? 3 : 2, dimensions + (kind->hasTime ? 0 : 1));
    AddText(file, heights, "units", kind->unit);
    if (kind->scale != 0.0)
    {
        AddNumber(file, heights, "scale_factor", NC_DOUBLE, kind->scale);
    }
    if (kind->range[1] != 0.0)
    {
        CheckNetcdf(nc_put_att_double(file, heights, "valid_range", kind->rangeType, 2, kind->range));
    }
    CheckNetcdf(nc_enddef(file));
    PutNumbers(file, eastAxis, (double[]){0, 2, 4});
    PutNumbers(file, northAxis, (double[]){0, 3});
    PutNumbers(file, heights, (double[]){1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    CheckNetcdf(nc_close(file));
}

static void UnitsBecomeMetres(void** state)
{
    (void)state;
    const struct
    {
        const char* unit;
        float expected;
    } units[] = {{"m", 1.0f},        {"meters", 1.0f}, {NULL, 1.0f},
                 {"cm", 0.01f},      {"km", 1000.0f},  {"ft", 0.3048f},
                 {"m s-1", 1.0f},    {"cm/s", 0.01f},  {"Metres above mean sea level", 1.0f},
                 {"fathom", 1.8288f}};
    for (size_t i = 0; i < sizeof(units) / sizeof(units[0]); ++i)
    {
        WriteGrid(&(Grid){.axisUnit = "m", .unit = units[i].unit, .type = NC_FLOAT});
        swRaster* raster = Read(NULL);
        assert_true(fabsf(swRaster_GetValues(raster)[3] / units[i].expected - 1.0f) < 1e-6f);
        assert_null(strstr(s_messages, "warning"));
        swDestroyRaster(raster);
    }
    WriteGrid(&(Grid){.axisUnit = "m", .unit = "dbar", .type = NC_FLOAT});
    swRaster* raster = Read(NULL);
    CheckTold("warning: ");
    CheckTold("in 'dbar', which is not known here");
    swDestroyRaster(raster);
    WriteGrid(&(Grid){.axisUnit = "m", .unit = "cm", .type = NC_FLOAT});
    swRasterFileDef def = swDefaultRasterFileDef();
    def.scale = 0.5; // the host has looked
    raster = Read(&def);
    assert_true(swRaster_GetValues(raster)[3] == 0.5f);
    swDestroyRaster(raster);
}

// Of a variable v over an axis of 0, 2, 4 and one of 0, 3.
static void WriteNorthward(const char* attribute, const char* text, const char* unit)
{
    int file = MakeNetcdf(s_path, NC_NETCDF4);
    int east = AddDimension(file, "x", 3), north = AddDimension(file, "y", 2);
    int eastAxis = AddVariable(file, "x", NC_DOUBLE, 1, &east),
        northAxis = AddVariable(file, "y", NC_DOUBLE, 1, &north);
    int v = AddVariable(file, "v", NC_FLOAT, 2, (int[]){north, east});
    AddText(file, v, "units", unit);
    if (attribute != NULL)
    {
        AddText(file, v, attribute, text);
    }
    CheckNetcdf(nc_enddef(file));
    PutNumbers(file, eastAxis, (double[]){0, 2, 4});
    PutNumbers(file, northAxis, (double[]){0, 3});
    PutNumbers(file, v, (double[]){1, 2, 3, 4, 5, 6});
    CheckNetcdf(nc_close(file));
}

static void WhatCountsNorthwardsIsTurned(void** state)
{
    (void)state;
    WriteNorthward("standard_name", "northward_sea_water_velocity", "cm s-1");
    swRaster* raster = Read(NULL);
    assert_true(fabsf(swRaster_GetValues(raster)[0] + 0.04f) < 1e-7f);
    assert_null(strstr(s_messages, "warning"));
    swDestroyRaster(raster);
    swRasterFileDef def = swDefaultRasterFileDef();
    def.scale = -1.0; // the host has looked
    raster = Read(&def);
    assert_true(swRaster_GetValues(raster)[0] == -4.0f);
    swDestroyRaster(raster);
    WriteNorthward("long_name", "Meridional wind at 10 m", "m/s");
    raster = Read(NULL);
    assert_true(swRaster_GetValues(raster)[0] == -4.0f);
    swDestroyRaster(raster);
    WriteNorthward("standard_name", "eastward_wind", "m/s");
    raster = Read(NULL);
    assert_true(swRaster_GetValues(raster)[0] == 4.0f);
    assert_null(strstr(s_messages, "warning"));
    swDestroyRaster(raster);
    WriteNorthward(NULL, NULL, "m/s"); // nobody knows
    raster = Read(NULL);
    assert_true(swRaster_GetValues(raster)[0] == 4.0f);
    CheckTold("warning: ");
    CheckTold("does not say which way v counts");
    swDestroyRaster(raster);
}

static void AxesMayCountKilometres(void** state)
{
    (void)state;
    WriteGrid(&(Grid){.axisUnit = "km", .type = NC_FLOAT});
    swRaster* raster = Read(NULL);
    assert_true(swRaster_GetInfo(raster).spacingX == 2000.0 && swRaster_GetInfo(raster).z == -3000.0);
    swDestroyRaster(raster);
    WriteGrid(&(Grid){.axisUnit = "chains", .type = NC_FLOAT});
    CheckRefused(NULL, SW_ERROR_FORMAT, "counts in 'chains'");
    swRasterFileDef def = swDefaultRasterFileDef();
    def.coordinates = SW_RASTER_METRES;
    raster = Read(&def);
    assert_true(swRaster_GetInfo(raster).spacingX == 2.0);
    swDestroyRaster(raster);
}

static void WhatIsOutsideTheValidRangeIsUnknown(void** state)
{
    (void)state;
    const struct
    {
        Grid grid;
        size_t unknown;
    } cases[] = {
        {{.type = NC_FLOAT, .range = {2, 5}, .rangeType = NC_FLOAT}, 2},
        {{.type = NC_SHORT, .scale = 10.0, .range = {2, 5}, .rangeType = NC_SHORT}, 2},   // as stored
        {{.type = NC_SHORT, .scale = 10.0, .range = {25, 45}, .rangeType = NC_FLOAT}, 4}, // as meant
        {{.type = NC_SHORT, .scale = -1.0, .range = {2, 9}, .rangeType = NC_SHORT}, 1},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        Grid grid = cases[i].grid;
        grid.axisUnit = "m";
        WriteGrid(&grid);
        swRaster* raster = Read(NULL);
        assert_int_equal(swRaster_GetInfo(raster).unknownCount, cases[i].unknown);
        swDestroyRaster(raster);
    }
}

static void ATimeOfOnePlaceDoesNotMatter(void** state)
{
    (void)state;
    WriteGrid(&(Grid){.axisUnit = "m", .type = NC_FLOAT, .hasTime = true});
    swRaster* raster = Read(NULL);
    const float expected[6] = {4, 5, 6, 1, 2, 3};
    assert_memory_equal(swRaster_GetValues(raster), expected, sizeof(expected));
    swDestroyRaster(raster);
    WriteGrid(&(Grid){.axisUnit = "m", .type = NC_FLOAT, .hasTime = true, .timeCount = 2});
    CheckRefused(NULL, SW_ERROR_FORMAT, "have several times or depths; take one of them out");
}

static void NetcdfAllRoundTheEarthHasNoEdge(void** state)
{
    (void)state;
    for (int way = 0; way < 4; ++way)
    {
        bool isFalling = (way & 1) != 0;
        size_t count = (way & 2) != 0 ? 721 : 720;
        double places[721], heights[2 * 721];
        for (size_t i = 0; i < count; ++i)
        {
            places[i] = -180.0 + 0.5 * (double)(isFalling ? count - 1 - i : i);
            heights[i] = heights[count + i] = GetRingHeight(places[i]);
        }
        int file = MakeNetcdf(s_path, NC_NETCDF4);
        int east = AddDimension(file, "lon", count), north = AddDimension(file, "lat", 2);
        int eastAxis = AddVariable(file, "lon", NC_DOUBLE, 1, &east),
            northAxis = AddVariable(file, "lat", NC_DOUBLE, 1, &north);
        int z = AddVariable(file, "z", NC_FLOAT, 2, (int[]){north, east});
        CheckNetcdf(nc_enddef(file));
        PutNumbers(file, eastAxis, places);
        PutNumbers(file, northAxis, (double[]){-0.25, 0.25});
        PutNumbers(file, z, heights);
        CheckNetcdf(nc_close(file));
        CheckRings();
    }
}
#endif

// ---- TIFF ----

#if SW_HAS_TIFF
static const TIFFFieldInfo GeoTags[] = {
    {33550, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, (char*)(uintptr_t) "ModelPixelScale"},
    {33922, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, (char*)(uintptr_t) "ModelTiepoint"},
    {34264, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, (char*)(uintptr_t) "ModelTransformation"},
    {34735, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1, (char*)(uintptr_t) "GeoKeyDirectory"},
    {42112, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, (char*)(uintptr_t) "GDALMetadata"},
};

typedef struct Image
{
    const char* metadata;
    int projection;
    bool isSouthFirst, isTiled, hasMask;
} Image;

static void WritePixels(TIFF* tiff, bool isTiled, int first)
{
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 3);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 18);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    float values[256] = {0.0f};
    if (isTiled)
    {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
    }
    for (int row = 0; row < 18; row += isTiled ? 16 : 1)
    {
        for (int i = 0; i < 256; ++i)
        {
            values[i] = isTiled ? (float)(first + 3 * (row + i / 16) + i % 16) : (float)(first + 3 * row + i);
        }
        assert_true(isTiled ? TIFFWriteTile(tiff, values, 0, (uint32_t)row, 0, 0) > 0
                            : TIFFWriteScanline(tiff, values, (uint32_t)row, 0) == 1);
    }
}

// Numbers 1, 2, 3 in the first row, 4, 5, 6 in the second and so on; pixels of 10 x 20 m whose corner is at 0, 0.
static void WriteImage(const Image* kind)
{
    TIFF* tiff = TIFFOpen(s_path, "w");
    assert_non_null(tiff);
    TIFFMergeFieldInfo(tiff, GeoTags, 5);
    double up = kind->isSouthFirst ? 20.0 : -20.0;
    double turn[16] = {10.0, 0.0, 0.0, 0.0, 0.0, up, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    uint16_t keys[] = {1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, (uint16_t)kind->projection};
    TIFFSetField(tiff, 34264, 16, turn);
    TIFFSetField(tiff, 34735, 16, keys);
    if (kind->metadata != NULL)
    {
        TIFFSetField(tiff, 42112, kind->metadata);
    }
    WritePixels(tiff, kind->isTiled, 1);
    if (kind->hasMask)
    {
        assert_int_equal(TIFFWriteDirectory(tiff), 1);
        TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, FILETYPE_MASK);
        WritePixels(tiff, false, 0);
    }
    TIFFClose(tiff);
}

static void RowsOfTiffMayRunNorthwards(void** state)
{
    (void)state;
    for (int isTiled = 0; isTiled < 2; ++isTiled)
    {
        WriteImage(&(Image){.isSouthFirst = true, .isTiled = isTiled != 0, .projection = 32654});
        swRaster* raster = Read(NULL);
        swRasterInfo info = swRaster_GetInfo(raster);
        assert_true(info.x == 5.0 && info.z == -350.0 && info.spacingZ == 20.0);
        assert_true(swRaster_GetValues(raster)[0] == 52.0f && swRaster_GetValues(raster)[53] == 3.0f);
        assert_true(fabsf(SampleAt(raster, 15.0, -30.0) - 5.0f) < 1e-5f);
        swDestroyRaster(raster);
        swRasterFileDef def = swDefaultRasterFileDef();
        def.north = -40.0; // the two rows in the south
        raster = Read(&def);
        assert_true(swRaster_GetInfo(raster).height == 2 && swRaster_GetValues(raster)[0] == 4.0f);
        swDestroyRaster(raster);
    }
}

static void ChannelsOfTiffAreChosen(void** state)
{
    (void)state;
    TIFF* tiff = TIFFOpen(s_path, "w");
    assert_non_null(tiff);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 2);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 2);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    float values[4] = {1.0f, 10.0f, 2.0f, 20.0f};
    assert_int_equal(TIFFWriteScanline(tiff, values, 0, 0), 1);
    TIFFClose(tiff);
    const char* const names[] = {NULL, "R", "1", "G", "2"};
    const float expected[] = {2.0f, 2.0f, 2.0f, 20.0f, 20.0f};
    swRasterFileDef def = swDefaultRasterFileDef();
    for (int i = 0; i < 5; ++i)
    {
        def.variable = names[i];
        swRaster* raster = Read(&def);
        assert_true(swRaster_GetValues(raster)[1] == expected[i]);
        assert_true((strstr(s_messages, "has 2 channels, of which the first is read") != NULL) == (i == 0));
        swDestroyRaster(raster);
    }
    const char* const wrong[] = {"B", "3", "0", "-1", "", "depth"};
    for (int i = 0; i < 6; ++i)
    {
        def.variable = wrong[i];
        CheckRefused(&def, SW_ERROR_FORMAT, "it has 2, which are named by their numbers");
    }
}

static void GdalsScaleAndUnitCount(void** state)
{
    (void)state;
    WriteImage(&(Image){.projection = 32654,
                        .metadata = "<GDALMetadata>\n<Item name=\"OFFSET\" sample=\"0\" role=\"offset\">5</Item>\n"
                                    "<Item name=\"SCALE\" sample=\"1\" role=\"scale\">7</Item>\n"
                                    "<Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.25</Item>\n</GDALMetadata>"});
    swRaster* raster = Read(NULL);
    assert_true(swRaster_GetValues(raster)[3] == 6.0f);
    swDestroyRaster(raster);
    WriteImage(&(Image){.projection = 32654,
                        .metadata = "<GDALMetadata>\n<Item name=\"UNITTYPE\" sample=\"0\" role=\"unittype\">US survey "
                                    "foot</Item>\n</GDALMetadata>"});
    raster = Read(NULL);
    assert_true(fabsf(swRaster_GetValues(raster)[0] - 0.30480061f) < 1e-7f);
    swDestroyRaster(raster);
    WriteImage(
        &(Image){.projection = 32654, .metadata = "<GDALMetadata><Item name=\"SCALE\" sample=\"0\" role=\"scale"});
    raster = Read(NULL); // cut off
    assert_true(swRaster_GetValues(raster)[0] == 1.0f);
    swDestroyRaster(raster);
}

static void WhatOfATiffIsNotReadIsTold(void** state)
{
    (void)state;
    WriteImage(&(Image){.projection = 32654});
    swDestroyRaster(Read(NULL));
    assert_string_equal(s_messages, "");
    WriteImage(&(Image){.projection = 32654, .hasMask = true});
    swRaster* raster = Read(NULL);
    assert_true(swRaster_GetValues(raster)[0] == 1.0f); // of the first image
    CheckTold("warning: ");
    CheckTold("has a mask of the pixels that are known");
    swDestroyRaster(raster);
    WriteImage(&(Image){.projection = 3857});
    swDestroyRaster(Read(NULL));
    CheckTold("Web Mercator (EPSG 3857)");
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TheHeadingOfAGridHasOneNumberALine),
        cmocka_unit_test(MissingNumbersAreKnownAsTheyArePrinted),
        cmocka_unit_test(ChannelsThatAreNotThereAreRefused),
        cmocka_unit_test(PipesAndDevicesAreRefused),
        cmocka_unit_test(PointsAllRoundTheEarthHaveNoEdge),
        cmocka_unit_test(WhatEndsSomewhereIsNotTurned),
#if SW_HAS_NETCDF
        cmocka_unit_test(UnitsBecomeMetres),
        cmocka_unit_test(WhatCountsNorthwardsIsTurned),
        cmocka_unit_test(AxesMayCountKilometres),
        cmocka_unit_test(WhatIsOutsideTheValidRangeIsUnknown),
        cmocka_unit_test(ATimeOfOnePlaceDoesNotMatter),
        cmocka_unit_test(NetcdfAllRoundTheEarthHasNoEdge),
#endif
#if SW_HAS_TIFF
        cmocka_unit_test(RowsOfTiffMayRunNorthwards),
        cmocka_unit_test(ChannelsOfTiffAreChosen),
        cmocka_unit_test(GdalsScaleAndUnitCount),
        cmocka_unit_test(WhatOfATiffIsNotReadIsTold),
#endif
    };
    return cmocka_run_group_tests(tests, MakePath, RemovePath);
}
