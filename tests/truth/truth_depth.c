// SPDX-License-Identifier: MIT
// V30: what measured sea floors leave of waves. Okushiri, six charts of 450, 150 and 50 m in one nest, and the surf
// zone at Pyramid Rock, 2 m by 1 m; neither is part of the project, and where they are not there this says so.
//
//   - Heights of an octave of waves in bands of depth are those that the law asks for at these depths.
//   - On land there is no wave at all.
//   - The share never falls with depth, and has no step where a chart ends.
//   - What coarse texels make of a coast: the area of land of a surface through points of the floor, and through means.

#include "truth.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

#include "seaway/files.h"
#include "seaway/input.h"
#include "shared/depth_share.h"

#define FLOORS SW_SOURCE_DIR "/../shared/data/bathymetry/"
#define BANDS 6
#define POINTS 40000
#define SHORTEST 64.0
#define LONGEST 128.0

static const double Edges[BANDS + 1] = {0.5, 2.0, 5.0, 10.0, 20.0, 45.3, 4000.0};

typedef struct Place
{
    const char* name;
    swWorld* world;
    double x, z, width, height; // of what is known, m
    int times, points;          // of heights; small places need many times
} Place;

static double Law(double depth)
{
    float k = (float)(TURN / sqrt(SHORTEST * LONGEST));
    return (double)swFindDepthShare((swAttenuation){1.0f, 0.0f}, k, (float)depth).share;
}

static swPosXZ Scatter(const Place* place, int i)
{
    double x = 0.7548776662466927 * (i + 1), z = 0.5698402909980532 * (i + 1);
    return (swPosXZ){place->x + place->width * (x - floor(x)), place->z + place->height * (z - floor(z))};
}

static void FindDepths(const Place* place, int count, const swPosXZ* points, float* depths)
{
    const swFieldSamples samples = {.depth = depths};
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(place->world), count, points, &samples), 0);
}

// Heights in bands of depth against those of the open sea, and against the law.
static void MeasureBands(const Place* place, double deep)
{
    swPosXZ* points = malloc(POINTS * sizeof(swPosXZ));
    float* depths = malloc(POINTS * sizeof(float));
    swVec3* moved = malloc(POINTS * sizeof(swVec3));
    assert_true(points != NULL && depths != NULL && moved != NULL);
    double squares[BANDS] = {0.0}, asked[BANDS] = {0.0}, counts[BANDS] = {0.0};
    int land = 0, wet = 0;
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = Scatter(place, i);
    }
    swQueryDef def = swDefaultQueryDef();
    const swSurfaceSamples samples = {.displacement = moved};
    for (int time = 0; time < place->times; ++time)
    {
        assert_int_equal(swWorld_StepTo(place->world, 17.0 * (time + 1)), SW_SUCCESS);
        FindDepths(place, place->points, points, depths);
        swMoment_QuerySurface(swWorld_GetMoment(place->world), &def, place->points, points, &samples, NULL);
        for (int i = 0; i < place->points; ++i)
        {
            bool isLand = depths[i] <= 0.0f;
            land += isLand ? 1 : 0;
            wet += isLand && (moved[i].x != 0.0f || moved[i].y != 0.0f || moved[i].z != 0.0f) ? 1 : 0;
            for (int band = 0; band < BANDS; ++band)
            {
                if ((double)depths[i] >= Edges[band] && (double)depths[i] < Edges[band + 1])
                {
                    squares[band] += (double)moved[i].y * (double)moved[i].y;
                    asked[band] += Law((double)depths[i]) * Law((double)depths[i]);
                    counts[band] += 1.0;
                }
            }
        }
    }
    for (int band = 0; band < BANDS; ++band)
    {
        if (counts[band] < 2000.0)
        {
            continue;
        }
        char what[128];
        snprintf(what, sizeof(what), "share of waves of 64 to 128 m, %s, depth %g to %g m", place->name, Edges[band],
                 Edges[band + 1]);
        Finding finding = {"V30", what, "tanh(k d)", "", 3};
        FindWithin(&finding, sqrt(asked[band] / counts[band]), sqrt(squares[band] / counts[band]) / deep, 0.1);
    }
    char what[128];
    snprintf(what, sizeof(what), "places on land that move, %s", place->name);
    Finding finding = {"V30", what, "none", "", 0};
    assert_true(land > 100);
    FindBelow(&finding, 0.0, (double)wet);
    free(points);
    free(depths);
    free(moved);
}

static int CompareDepths(const void* a, const void* b)
{
    float x = *(const float*)a, y = *(const float*)b;
    return (x > y) - (x < y);
}

static void CheckMonotone(const Place* place)
{
    static float depths[POINTS];
    static swPosXZ points[POINTS];
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = Scatter(place, i);
    }
    FindDepths(place, POINTS, points, depths);
    qsort(depths, POINTS, sizeof(float), CompareDepths);
    int falls = 0;
    for (double length = 0.0625; length < 4000.0; length *= 2.0)
    {
        float last = 0.0f;
        for (int i = 0; i < POINTS; ++i)
        {
            float share =
                swFindDepthShare((swAttenuation){1.0f, 0.0f}, (float)(TURN / length / sqrt(2.0)), depths[i]).share;
            falls += share < last ? 1 : 0;
            last = share;
        }
    }
    char what[128];
    snprintf(what, sizeof(what), "shares of 16 octaves that fall with depth, %s", place->name);
    Finding finding = {"V30", what, "none", "", 0};
    FindBelow(&finding, 0.0, (double)falls);
}

// The largest change of the share within half a metre, along lines over all borders.
static void CheckJoins(const Place* place, double limit)
{
    double worst = 0.0;
    for (int line = 0; line < 24; ++line)
    {
        bool isAlongX = line % 2 == 0;
        double across = (line / 2 + 0.5) / 12.0;
        static swPosXZ points[60000];
        static float depths[60000];
        for (int i = 0; i < 60000; ++i)
        {
            double x = isAlongX ? place->x + 0.5 * i + 200.0 : place->x + across * place->width;
            double z = isAlongX ? place->z + across * place->height : place->z + 0.5 * i + 200.0;
            points[i] = (swPosXZ){x, z};
        }
        FindDepths(place, 60000, points, depths);
        for (int i = 1; i < 60000; ++i)
        {
            bool isIn = points[i].x < place->x + place->width && points[i].z < place->z + place->height;
            double change = fabs(Law((double)depths[i]) - Law((double)depths[i - 1]));
            worst = isIn ? fmax(worst, change) : worst;
        }
    }
    char what[128];
    snprintf(what, sizeof(what), "largest change of a share within 0.5 m, %s", place->name);
    Finding finding = {"V30", what, "no step at a border", "", 4};
    FindBelow(&finding, limit, worst);
}

static void AddWaves(swWorld* world)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.minWavelength = (float)SHORTEST;
    def.maxWavelength = (float)LONGEST;
    def.chop = 0.0f; // heights at a place are those of the particle there
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
}

static double MeasureDeep(void)
{
    swHost host = swDefaultHost();
    swWorldDef def = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    AddWaves(world);
    const Place place = {"open sea", world, 0.0, 0.0, 40000.0, 40000.0, 4, 10000};
    double squares = 0.0;
    for (int time = 0; time < 4; ++time)
    {
        assert_int_equal(swWorld_StepTo(world, 17.0 * (time + 1)), SW_SUCCESS);
        for (int i = 0; i < 10000; ++i)
        {
            swPosXZ p = Scatter(&place, i);
            double height = swMoment_GetHeight(swWorld_GetMoment(world), p.x, p.z);
            squares += height * height;
        }
    }
    swDestroyWorld(world);
    return sqrt(squares / 40000.0);
}

static swWorld* MakeWorld(int count, const swRaster* const* rasters)
{
    swHost host = swDefaultHost();
    swWorldDef def = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    AddWaves(world);
    swInputDef floor = swDefaultInputDef();
    swInputId ids[8];
    assert_int_equal(swCreateNest(world, &floor, count, rasters, ids), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(world, 1.0), SW_SUCCESS);
    return world;
}

// ---- coarse texels ----

static float SampleOne(const swRaster* raster, double x, double z)
{
    float value;
    swRaster_Sample(raster, 1, &(swPosXZ){x, z}, &value);
    return value;
}

// Heights on a lattice of `texel`: the floor there, or its mean over the texel.
static float LatticeHeight(const swRaster* raster, double x, double z, double texel, bool isMean)
{
    double sum = 0.0;
    int count = isMean ? 8 : 1;
    for (int i = 0; i < count * count; ++i)
    {
        double dx = isMean ? texel * ((i % count + 0.5) / count - 0.5) : 0.0;
        double dz = isMean ? texel * ((i / count + 0.5) / count - 0.5) : 0.0;
        sum += (double)SampleOne(raster, x + dx, z + dz);
    }
    return (float)(sum / (count * count));
}

static double MeasureLand(const swRaster* raster, double texel, bool isMean)
{
    swRasterInfo info = swRaster_GetInfo(raster);
    double x0 = info.x + 450.0, z0 = info.z + 450.0; // 4400 by 3600 m, whole texels of all sizes
    int columns = (int)(4400.0 / texel), rows = (int)(3600.0 / texel);
    double land = 0.0;
    for (int row = 0; row < rows; ++row)
    {
        for (int column = 0; column < columns; ++column)
        {
            float h[4];
            for (int k = 0; k < 4; ++k)
            {
                h[k] = LatticeHeight(raster, x0 + texel * (column + k % 2), z0 + texel * (row + k / 2), texel, isMean);
            }
            for (int i = 0; i < 64; ++i)
            {
                float u = ((float)(i % 8) + 0.5f) / 8.0f, v = ((float)(i / 8) + 0.5f) / 8.0f;
                float height = (h[0] + (h[1] - h[0]) * u) * (1.0f - v) + (h[2] + (h[3] - h[2]) * u) * v;
                land += height > 0.0f ? 1.0 / 64.0 : 0.0;
            }
        }
    }
    return land / ((double)columns * (double)rows);
}

static void MeasureCoasts(const swRaster* raster)
{
    double truth = MeasureLand(raster, 12.5, false);
    const double texels[] = {100.0, 200.0, 400.0};
    for (int i = 0; i < 3; ++i)
    {
        double points = MeasureLand(raster, texels[i], false), means = MeasureLand(raster, texels[i], true);
        print_message("land with texels of %g m, cells of 50 m: %.4f by points, %.4f by means, %.4f in truth\n",
                      texels[i], points, means, truth);
    }
}

// ---- places ----

static void OkushirisCharts(void** state)
{
    (void)state;
    static const char* const names[] = {"450m",           "south_150m", "northeast_150m",
                                        "northwest_150m", "aonae_50m",  "monai_50m"};
    swHost host = swDefaultHost();
    swRaster* rasters[6] = {NULL};
    for (int i = 0; i < 6; ++i)
    {
        char path[512];
        snprintf(path, sizeof(path), FLOORS "okushiri/okushiri_%s.asc", names[i]);
        if (access(path, R_OK) != 0)
        {
            print_message("%s is not here\n", path);
            return;
        }
        assert_int_equal(swReadRaster(&host, path, NULL, &rasters[i]), SW_SUCCESS);
    }
    MeasureCoasts(rasters[4]);
    swWorld* world = MakeWorld(6, (const swRaster* const*)rasters);
    const Place place = {"Okushiri", world, 72500.0, -195500.0, 24500.0, 32500.0, 4, POINTS};
    MeasureBands(&place, MeasureDeep());
    CheckMonotone(&place);
    CheckJoins(&place, 0.02);
    swDestroyWorld(world);
    for (int i = 0; i < 6; ++i)
    {
        swDestroyRaster(rasters[i]);
    }
}

static void PyramidRock(void** state)
{
    (void)state;
    enum
    {
        WIDTH = 401,
        HEIGHT = 601
    };
    gzFile file = gzopen(FLOORS "pyramid_rock/pyramid_rock_2x1m.txt.gz", "rb");
    if (file == NULL)
    {
        print_message("the chart of Pyramid Rock is not here\n");
        return;
    }
    static char text[8 << 20];
    static float values[WIDTH * HEIGHT];
    int size = gzread(file, text, sizeof(text) - 1);
    gzclose(file);
    assert_true(size > 0);
    char* at = text;
    for (int i = 0; i < WIDTH * HEIGHT; ++i)
    {
        values[i] = strtof(at, &at);
    }
    swHost host = swDefaultHost();
    swRasterDef def = swDefaultRasterDef();
    def.width = WIDTH;
    def.height = HEIGHT;
    def.spacingX = 2.0;
    def.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    swWorld* world = MakeWorld(1, (const swRaster* const*)&raster);
    const Place place = {"Pyramid Rock", world, 60.0, 60.0, 680.0, 480.0, 80, POINTS / 20};
    CheckMonotone(&place);
    CheckJoins(&place, 0.06); // of its rocks, 1 m apart
    MeasureBands(&place, MeasureDeep());
    swDestroyWorld(world);
    swDestroyRaster(raster);
}

int main(void)
{
    BeginTruth("truth_depth");
    MarkOptional(true);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(OkushirisCharts),
        cmocka_unit_test(PyramidRock),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
