// SPDX-License-Identifier: MIT
// Rasters in files: made here, and those of the measured sea floors where they are there.
#include "support/cmocka_setup.h"
#include "support/messages.h"
#if SW_HAS_NETCDF
#include "support/netcdf_maker.h"
#endif

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <seaway/files.h>

#define FLOORS SW_SOURCE_DIR "/../shared/data/bathymetry/"

static char s_path[64];

static int MakePath(void** state)
{
    (void)state;
    snprintf(s_path, sizeof(s_path), "raster_%ld.tmp", (long)getpid());
    return 0;
}

static int RemovePath(void** state)
{
    (void)state;
    remove(s_path);
    return 0;
}

static swResult ReadAs(const char* text, const swRasterFileDef* def, swRaster** raster)
{
    FILE* file = fopen(s_path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, strlen(text), file), strlen(text));
    fclose(file);
    swHost host = MakeHost();
    return swReadRaster(&host, s_path, def, raster);
}

static swRaster* Read(const char* text, const swRasterFileDef* def)
{
    swRaster* raster = NULL;
    swResult result = ReadAs(text, def, &raster);
    if (result != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    return raster;
}

static float SampleAt(const swRaster* raster, double x, double z)
{
    float value = 0.0f;
    swRaster_Sample(raster, 1, &(swPosXZ){x, z}, &value);
    return value;
}

static void CornersAndMiddlesOfCellsAreHalfACellApart(void** state)
{
    (void)state;
    swRaster* raster = Read("ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\nNODATA_value -9999\n"
                            "1 2 3\n4 5 -9999\n",
                            NULL);
    swRasterInfo info = swRaster_GetInfo(raster);
    assert_true(info.x == 105.0 && info.z == -215.0 && info.spacingX == 10.0 && info.spacingZ == 10.0);
    assert_true(SampleAt(raster, 105.0, -215.0) == 1.0f && SampleAt(raster, 115.0, -205.0) == 5.0f);
    assert_int_equal(info.unknownCount, 1);
    swDestroyRaster(raster);
    raster = Read("NCOLS 3\r\nNROWS 2\r\nXLLCENTER 100\r\nYLLCENTER 200\r\nDX 10\r\nDY 5\r\n1 2 3 4\r\n5 6", NULL);
    info = swRaster_GetInfo(raster);
    assert_true(info.x == 100.0 && info.z == -205.0 && info.spacingZ == 5.0);
    assert_true(SampleAt(raster, 100.0, -205.0) == 1.0f && SampleAt(raster, 120.0, -200.0) == 6.0f);
    swDestroyRaster(raster);
}

static void PointsInAnyOrderMakeTheirLattice(void** state)
{
    (void)state;
    swRaster* raster = Read("# x y z\n20,0,3\n0,0,1\n10,0,2\n0,5,4\n20,5,6\n", NULL);
    swRasterInfo info = swRaster_GetInfo(raster);
    assert_int_equal(info.width, 3);
    assert_int_equal(info.height, 2);
    assert_true(info.z == -5.0 && info.spacingX == 10.0 && info.spacingZ == 5.0);
    assert_true(SampleAt(raster, 20.0, 0.0) == 3.0f && SampleAt(raster, 0.0, -5.0) == 4.0f);
    assert_int_equal(info.unknownCount, 1); // nobody measured at (10, 5)
    swDestroyRaster(raster);
}

static void DegreesBecomeMetresAboutTheOrigin(void** state)
{
    (void)state;
    const char* text = "ncols 3\nnrows 3\nxllcenter 4.99\nyllcenter 51.99\ncellsize 0.01\n1 2 3\n4 5 6\n7 8 9\n";
    swRasterFileDef def = swDefaultRasterFileDef();
    def.originEast = 5.0;
    def.originNorth = 52.0;
    swRaster* raster = Read(text, &def);
    assert_non_null(strstr(s_messages, "taken for degrees"));
    swRasterInfo info = swRaster_GetInfo(raster);
    // A degree of longitude and one of latitude at 52 degrees north are 68,677.6 m and 111,267.0 m (WGS 84).
    assert_true(fabs(info.spacingX - 686.776) < 0.01 && fabs(info.spacingZ - 1112.670) < 0.02);
    assert_true(fabs(info.x + info.spacingX) < 1e-6 && fabs(info.z + info.spacingZ) < 1e-6);
    assert_true(fabsf(SampleAt(raster, 0.0, 0.0) - 5.0f) < 1e-4f);
    swDestroyRaster(raster);
    def.originEast = 365.0; // the same place, counted otherwise
    def.coordinates = SW_RASTER_DEGREES;
    raster = Read(text, &def);
    assert_true(fabs(swRaster_GetInfo(raster).x - info.x) < 1e-6);
    assert_string_equal(s_messages, "");
    swDestroyRaster(raster);
    def = swDefaultRasterFileDef();
    def.coordinates = SW_RASTER_METRES;
    raster = Read(text, &def);
    assert_true(swRaster_GetInfo(raster).spacingX == 0.01);
    swDestroyRaster(raster);
}

static void CroppedRastersAreThePartOfTheWhole(void** state)
{
    (void)state;
    const char* text = "ncols 4\nnrows 4\nxllcenter 0\nyllcenter 0\ncellsize 10\n"
                       "1 2 3 4\n5 6 7 8\n9 10 11 12\n13 14 15 16\n";
    swRasterFileDef def = swDefaultRasterFileDef();
    def.west = 5.0;
    def.east = 20.0;
    def.north = -21.0;
    def.south = -5.0;
    swRaster *whole = Read(text, NULL), *part = Read(text, &def);
    swRasterInfo info = swRaster_GetInfo(part);
    assert_true(info.width == 2 && info.height == 2 && info.x == 10.0 && info.z == -20.0);
    assert_true(SampleAt(part, 10.0, -20.0) == SampleAt(whole, 10.0, -20.0));
    assert_true(SampleAt(part, 20.0, -10.0) == 11.0f);
    swDestroyRaster(whole);
    swDestroyRaster(part);
}

// Marks and ends of lines as other systems write them, and no end at all.
static void LinesMayEndAsOnAnySystem(void** state)
{
    (void)state;
    const char* const texts[] = {
        "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\n1 2\n3 4\n",
        "ncols 2\r\nnrows 2\r\nxllcorner 0\r\nyllcorner 0\r\ncellsize 2\r\n1 2\r\n3 4\r\n",
        "\xef\xbb\xbfncols 2\r\nnrows 2\r\nxllcorner 0\r\nyllcorner 0\r\ncellsize 2\r\n1 2\r\n3 4",
        ("\xef\xbb\xbf"
         "1 1 3\n3 1 4\n1 3 1\n3 3 2"),
        "1 1 3\r\n3 1 4\r\n1 3 1\r\n3 3 2",
    };
    for (size_t i = 0; i < sizeof(texts) / sizeof(texts[0]); ++i)
    {
        swRaster* raster = Read(texts[i], NULL);
        swRasterInfo info = swRaster_GetInfo(raster);
        assert_true(info.width == 2 && info.height == 2 && info.x == 1.0 && info.z == -3.0);
        for (int k = 0; k < 4; ++k)
        {
            assert_true(swRaster_GetValues(raster)[k] == (float)(k + 1));
        }
        swDestroyRaster(raster);
    }
}

// A degree has one length all over a raster, which is told where that is far off.
static void WideLatitudesAreTold(void** state)
{
    (void)state;
    swRasterFileDef def = swDefaultRasterFileDef();
    def.coordinates = SW_RASTER_DEGREES;
    swDestroyRaster(Read("10 40 1\n10.5 40 2\n10 40.5 3\n10.5 40.5 4\n", &def));
    assert_null(strstr(s_messages, "warning"));
    swDestroyRaster(Read("10 80 1\n11 80 2\n10 81 3\n11 81 4\n", &def));
    assert_non_null(strstr(s_messages, "warning: "));
    assert_non_null(strstr(s_messages, "80 to 81 degrees north"));
    s_messages[0] = '\0';
    swDestroyRaster(Read("0 40 1\n8 40 2\n0 48 3\n8 48 4\n", &def));
    assert_non_null(strstr(s_messages, "up to 7 %")); // cos 48 over cos 44
    swRaster* raster = NULL;
    assert_int_equal(ReadAs("0 89.5 1\n1 89.5 2\n0 90 3\n1 90 4\n", &def, &raster), SW_ERROR_FORMAT);
    assert_null(raster);
}

// The largest that is, as a file with a hole in it: what is kept of it fits a small budget, the whole does not.
static void TheLargestRasterIsCroppedWhileItIsRead(void** state)
{
    (void)state;
    const int side = 16384;
    FILE* file = fopen(s_path, "wb");
    assert_non_null(file);
    assert_int_equal(fseek(file, 2L * side * side - 2, SEEK_SET), 0);
    const uint8_t last[2] = {7, 0};
    assert_int_equal(fwrite(last, 1, 2, file), 2);
    fclose(file);
    swRasterFileDef def = swDefaultRasterFileDef();
    def.rawWidth = def.rawHeight = side;
    def.numbers = SW_RASTER_INT16;
    def.offset = -5.0;
    def.imageEast = def.imageNorth = 0.0;
    def.memoryLimit = 1 << 20;
    swHost host = MakeHost();
    swRaster* raster = NULL;
    assert_int_equal(swReadRaster(&host, s_path, &def, &raster), SW_ERROR_LIMIT);
    assert_null(raster);
    assert_non_null(strstr(s_messages, "1073741824 bytes"));
    def.west = def.north = side - 200.5;
    assert_int_equal(swReadRaster(&host, s_path, &def, &raster), SW_SUCCESS);
    swRasterInfo info = swRaster_GetInfo(raster);
    assert_true(info.width == 200 && info.height == 200 && info.memory < 1 << 20);
    assert_true(swRaster_GetValues(raster)[0] == -5.0f && swRaster_GetValues(raster)[200 * 200 - 1] == 2.0f);
    swDestroyRaster(raster);
}

static void WrongFilesAreNamedWithTheirLineAndRemedy(void** state)
{
    (void)state;
    const char* heading = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    char cut[256], long_[256], word[256];
    snprintf(cut, sizeof(cut), "%s1 2\n3\n", heading);
    snprintf(long_, sizeof(long_), "%s1 2\n3 4 5\n", heading);
    snprintf(word, sizeof(word), "%s1 2\nx 4\n", heading);
    const struct
    {
        const char *text, *words;
    } cases[] = {
        {"", "holds no points"},
        {"# nothing\n", "holds no points"},
        {"1 2\n", ":1: the value should be a number"},
        {"0 0 1\n1 0 2\n0.4 0 3\n", "is on no lattice"},
        {"0 0 1\n1 0 1\n0 1 1\n1000 0 1\n", ":2: the point at 1, 0 is in the cell of that at 0, 0 on line 1"},
        {"ncols 2.5\nnrows 2\n", ":1: ncols is 2.5; it must be a whole number"},
        {"1 2 3 4 5\n2 3 4 5 6\n", "needs the heading"},
        {cut, ":7: the file ends where more heights should follow"},
        {long_, ":7: there are more heights than the 2 x 2"},
        {word, ":7: 'x' should be a height"},
        {"ncols 2\nnrows 2\ncellsize 1\n1 2\n3 4\n", "lacks xllcorner"},
        {"ncols 1\nnrows 1\nxllcorner 0\nxllcenter 5\nyllcorner 0\ncellsize 1\n1\n", "tells the place a second time"},
        {"ncols 0\nnrows 2\n", "must be from 1"},
        {"ncols 1e9\nnrows 1e9\n", ":1: ncols is 1e+09; it must be from 1 to 1e+06"},
        {"ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize -1\n1 2 3 4\n", "must be above 0"},
        {"ncols 2\nwidth 3\n", "'width' is no key of an Esri ASCII grid"},
        {"ncols 20000\nnrows 20000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1\n", "Crop it"},
        {"ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1e30\n", "values are at most"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swRaster* raster = NULL;
        swResult result = ReadAs(cases[i].text, NULL, &raster);
        assert_true(result == SW_ERROR_FORMAT || result == SW_ERROR_LIMIT);
        assert_null(raster);
        if (strstr(s_messages, cases[i].words) == NULL)
        {
            fail_msg("\"%s\" does not say \"%s\"", s_messages, cases[i].words);
        }
    }
    swHost host = MakeHost();
    swRaster* raster = NULL;
    assert_int_equal(swReadRaster(&host, "absent.asc", NULL, &raster), SW_ERROR_FILE);
    assert_non_null(strstr(s_messages, "absent.asc"));
}

// A file of the measured sea floors, or NULL with a message.
static swRaster* ReadFloor(const char* name, const swRasterFileDef* def)
{
    char path[512];
    snprintf(path, sizeof(path), "%s%s", FLOORS, name);
    FILE* file = fopen(path, "rb");
    if (file == NULL)
    {
        print_message("skipped: %s is absent\n", path);
        return NULL;
    }
    fclose(file);
    swHost host = MakeHost();
    swRaster* raster = NULL;
    assert_int_equal(swReadRaster(&host, path, def, &raster), SW_SUCCESS);
    return raster;
}

static void MeasuredSeaFloorsAreRead(void** state)
{
    (void)state;
    swRaster* hawaii = ReadFloor("hawaii/hawaii_2arcmin.asc", NULL);
    if (hawaii != NULL)
    {
        swRasterInfo info = swRaster_GetInfo(hawaii);
        assert_non_null(strstr(s_messages, "taken for degrees"));
        assert_true(info.width == 299 && info.height == 209);
        assert_true(info.least == -6134.0f && info.most == 4000.0f && info.unknownCount == 0);
        assert_true(fabs(info.spacingZ - 3687.0) < 5.0 && fabs(info.spacingX - 3474.0) < 10.0);
        assert_true(swRaster_GetValues(hawaii)[0] == -4694.0f);
        swDestroyRaster(hawaii);
    }
    swRaster* coarse = ReadFloor("okushiri/okushiri_450m.asc", NULL);
    swRaster* fine = ReadFloor("okushiri/okushiri_aonae_50m.asc", NULL);
    if (coarse != NULL && fine != NULL)
    {
        // Nested grids of one place agree where both know it, but for what the coarse one cannot have.
        swRasterInfo info = swRaster_GetInfo(fine);
        double sum = 0.0;
        int count = 0;
        for (int j = 0; j < info.height; ++j)
        {
            for (int i = 0; i < info.width; ++i)
            {
                double x = info.x + info.spacingX * i, z = info.z + info.spacingZ * j;
                float a = SampleAt(fine, x, z), b = SampleAt(coarse, x, z);
                if (a < 0.0f && b < 0.0f)
                {
                    sum += (double)a - (double)b;
                    count += 1;
                }
            }
        }
        assert_true(count > 1000);
        print_message("Aonae minus its surroundings: %.2f m over %d cells\n", sum / count, count);
        assert_true(fabs(sum / count) < 10.0); // of a floor that falls by 100 m a cell
    }
    swDestroyRaster(coarse);
    swDestroyRaster(fine);
    char path[512];
    snprintf(path, sizeof(path), "%spyramid_rock/pyramid_rock_2x1m.txt.gz", FLOORS);
    swHost host = MakeHost();
    swRaster* raster = NULL;
    swResult result = swReadRaster(&host, path, NULL, &raster);
    assert_true(result == SW_ERROR_FORMAT || result == SW_ERROR_FILE); // a table without places
}

#if SW_HAS_NETCDF
// Heights 100 north + east of the place in degrees, in either order of axes, each running either way.
static void WriteGrid(bool isEastFirst, bool isEastFalling, bool isNorthFalling, const char* unit, const char* name)
{
    int file = MakeNetcdf(s_path, NC_NETCDF4);
    int east = AddDimension(file, "lon", 5), north = AddDimension(file, "lat", 4);
    int eastAxis = AddVariable(file, "lon", NC_DOUBLE, 1, &east);
    int northAxis = AddVariable(file, "lat", NC_DOUBLE, 1, &north);
    AddText(file, eastAxis, "units", unit);
    const int dimensions[2] = {isEastFirst ? east : north, isEastFirst ? north : east};
    int heights = AddVariable(file, name, NC_FLOAT, 2, dimensions);
    CheckNetcdf(nc_enddef(file));
    double easts[5], norths[4], values[20];
    for (int i = 0; i < 5; ++i)
    {
        easts[i] = 10.0 + 0.5 * (isEastFalling ? 4 - i : i);
    }
    for (int j = 0; j < 4; ++j)
    {
        norths[j] = 40.0 + 0.25 * (isNorthFalling ? 3 - j : j);
    }
    for (int i = 0; i < 5; ++i)
    {
        for (int j = 0; j < 4; ++j)
        {
            values[isEastFirst ? 4 * i + j : 5 * j + i] = 100.0 * norths[j] + easts[i];
        }
    }
    PutNumbers(file, eastAxis, easts);
    PutNumbers(file, northAxis, norths);
    PutNumbers(file, heights, values);
    CheckNetcdf(nc_close(file));
}

static void NetcdfIsReadInAnyOrderOfAxes(void** state)
{
    (void)state;
    swRasterFileDef def = swDefaultRasterFileDef();
    def.originEast = 10.0;
    def.originNorth = 40.0;
    uint64_t hash = 0;
    for (int way = 0; way < 8; ++way)
    {
        WriteGrid((way & 1) != 0, (way & 2) != 0, (way & 4) != 0, "degrees_east", "elevation");
        swHost host = MakeHost();
        swRaster* raster = NULL;
        assert_int_equal(swReadRaster(&host, s_path, &def, &raster), SW_SUCCESS);
        assert_string_equal(s_messages, "");
        swRasterInfo info = swRaster_GetInfo(raster);
        assert_true(info.width == 5 && info.height == 4);
        assert_true(swRaster_GetValues(raster)[0] == 4085.0f); // north-west: 40.75 and 10
        assert_true(fabsf(SampleAt(raster, 0.0, 0.0) - 4010.0f) < 0.01f);
        hash = way == 0 ? info.hash : hash;
        assert_int_equal(info.hash, hash);
        swDestroyRaster(raster);
    }
}

static void CroppedNetcdfIsThePartOfTheWhole(void** state)
{
    (void)state;
    for (int way = 0; way < 8; ++way)
    {
        WriteGrid((way & 1) != 0, (way & 2) != 0, (way & 4) != 0, "degrees_east", "z");
        swRasterFileDef def = swDefaultRasterFileDef();
        def.originEast = 10.0;
        def.originNorth = 40.0;
        def.west = 30e3; // a degree of longitude is 85 km
        def.east = 140e3;
        def.north = -60e3;
        def.south = -20e3;
        swHost host = MakeHost();
        swRaster* raster = NULL;
        assert_int_equal(swReadRaster(&host, s_path, &def, &raster), SW_SUCCESS);
        swRasterInfo info = swRaster_GetInfo(raster);
        assert_true(info.width == 3 && info.height == 2);
        assert_true(swRaster_GetValues(raster)[0] == 4060.5f); // 40.5 north, 10.5 east
        swDestroyRaster(raster);
    }
}

static void NetcdfThatIsNoGridIsRefused(void** state)
{
    (void)state;
    int file = MakeNetcdf(s_path, NC_NETCDF4);
    int east = AddDimension(file, "x", 3);
    int axis = AddVariable(file, "x", NC_DOUBLE, 1, &east);
    CheckNetcdf(nc_enddef(file));
    PutNumbers(file, axis, (double[]){0.0, 1.0, 2.0});
    CheckNetcdf(nc_close(file));
    swHost host = MakeHost();
    swRaster* raster = NULL;
    assert_int_equal(swReadRaster(&host, s_path, NULL, &raster), SW_ERROR_FORMAT);
    assert_null(raster);
    assert_non_null(strstr(s_messages, "there is no variable over an axis of x"));
    WriteGrid(false, false, false, "m", "elevation");
    swRasterFileDef def = swDefaultRasterFileDef();
    def.variable = "ice";
    s_messages[0] = '\0';
    assert_int_equal(swReadRaster(&host, s_path, &def, &raster), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "no variable ice"));
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(LinesMayEndAsOnAnySystem),
        cmocka_unit_test(WideLatitudesAreTold),
        cmocka_unit_test(TheLargestRasterIsCroppedWhileItIsRead),
        cmocka_unit_test(CornersAndMiddlesOfCellsAreHalfACellApart),
        cmocka_unit_test(PointsInAnyOrderMakeTheirLattice),
        cmocka_unit_test(DegreesBecomeMetresAboutTheOrigin),
        cmocka_unit_test(CroppedRastersAreThePartOfTheWhole),
        cmocka_unit_test(WrongFilesAreNamedWithTheirLineAndRemedy),
        cmocka_unit_test(MeasuredSeaFloorsAreRead),
#if SW_HAS_NETCDF
        cmocka_unit_test(NetcdfIsReadInAnyOrderOfAxes),
        cmocka_unit_test(CroppedNetcdfIsThePartOfTheWhole),
        cmocka_unit_test(NetcdfThatIsNoGridIsRefused),
#endif
    };
    return cmocka_run_group_tests(tests, MakePath, RemovePath);
}
