// SPDX-License-Identifier: MIT
// Sea floors in a world: meshes, nests of rasters, and what they leave of the waves.
#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <math.h>
#include <stdlib.h>

#include <seaway/seaway.h>

static swWorld* MakeWorld(double seaLevel)
{
    swHost host = MakeHost();
    swWorldDef def = swDefaultWorldDef();
    def.seaLevel = seaLevel;
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    return world;
}

static swInputId Add(swWorld* world, const swInputDef* def)
{
    swInputId id;
    if (swCreateInput(world, def, &id) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    return id;
}

static void Step(swWorld* world)
{
    assert_int_equal(swWorld_Step(world, 0.1), SW_SUCCESS);
}

static float FloorAt(const swWorld* world, double x, double z)
{
    float height;
    const swFieldSamples samples = {.floor = &height};
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 1, &(swPosXZ){x, z}, &samples), 0);
    return height;
}

static float DepthAt(const swWorld* world, double x, double z)
{
    float depth;
    const swFieldSamples samples = {.depth = &depth};
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 1, &(swPosXZ){x, z}, &samples), 0);
    return depth;
}

// ---- meshes ----

// A block 100 x 40 m, its top at 2 m and, on its western half, a deck at 10 m.
static swMesh* MakeBlock(float highest)
{
    static const swVec3 vertices[] = {{-50.0f, 2.0f, -20.0f}, {50.0f, 2.0f, -20.0f}, {-50.0f, 2.0f, 20.0f},
                                      {50.0f, 2.0f, 20.0f},   {0.0f, 10.0f, -20.0f}, {-50.0f, 10.0f, -20.0f},
                                      {0.0f, 10.0f, 20.0f},   {-50.0f, 10.0f, 20.0f}};
    static const uint32_t faces[] = {0, 1, 2, 1, 3, 2, 4, 5, 6, 5, 7, 6};
    swHost host = MakeHost();
    swMeshDef def = swDefaultMeshDef();
    def.vertices = vertices;
    def.vertexCount = 8;
    def.indices = faces;
    def.triangleCount = 4;
    def.highest = highest;
    swMesh* mesh = NULL;
    assert_int_equal(swCreateMesh(&host, &def, &mesh), SW_SUCCESS);
    return mesh;
}

static swInputDef MakeMeshInput(const swMesh* mesh, swPos position)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_FLOOR;
    def.shape = SW_SHAPE_MESH;
    def.mesh = mesh;
    def.blend = SW_BLEND_MAX;
    def.position = position;
    return def;
}

static void AMeshIsAFloorWhereItLies(void** state)
{
    (void)state;
    const double levels[] = {0.0, 350.0};
    for (int i = 0; i < 2; ++i)
    {
        swWorld* world = MakeWorld(levels[i]);
        swMesh* mesh = MakeBlock(1e6f);
        swInputDef def = MakeMeshInput(mesh, (swPos){1000.0, levels[i] - 12.0, -500.0});
        def.rotation.yaw = 0.5f * (float)SW_PI; // its length along z
        Add(world, &def);
        swDestroyMesh(mesh); // the input keeps it
        Step(world);
        assert_float_equal(FloorAt(world, 1000.0, -460.0), (float)levels[i] - 10.0f, 1e-4f);
        assert_float_equal(FloorAt(world, 1000.0, -540.0), (float)levels[i] - 2.0f, 1e-4f);
        assert_float_equal(DepthAt(world, 1000.0, -460.0), 10.0f, 1e-4f);
        assert_true(isinf(FloorAt(world, 1040.0, -500.0)) && isinf(DepthAt(world, 1000.0, -551.0)));
        swDestroyWorld(world);
    }
}

static void WhatLiesAboveAHeightIsNoFloor(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(0.0);
    swMesh* mesh = MakeBlock(5.0f);
    swInputDef def = MakeMeshInput(mesh, (swPos){0.0, -12.0, 0.0});
    Add(world, &def);
    Step(world);
    assert_float_equal(FloorAt(world, -25.0, 0.0), -10.0f, 1e-4f);
    swDestroyMesh(mesh);
    swDestroyWorld(world);
}

// A lock's gate that rises out of a channel of 10 m, and a floating dock that comes and goes.
static void FloorsMayMoveWhileTheSeaRuns(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(0.0);
    swInputDef bed = swDefaultInputDef();
    bed.value[0] = -10.0f;
    Add(world, &bed);
    swMesh* mesh = MakeBlock(5.0f);
    swInputDef def = MakeMeshInput(mesh, (swPos){0.0, -20.0, 0.0});
    def.order = 1;
    swInputId gate = Add(world, &def);
    swDestroyMesh(mesh);
    Step(world);
    assert_float_equal(DepthAt(world, 25.0, 0.0), 10.0f, 1e-5f);
    for (int i = 0; i < 20; ++i)
    {
        double y = -12.0 + 0.5 * i;
        swInput_Move(world, gate, (swPos){5.0 * i, y, 0.0}, (swAngles){0});
        Step(world);
        assert_float_equal(DepthAt(world, 5.0 * i, 0.0), (float)fmin(10.0, -2.0 - y), 1e-4f);
        assert_float_equal(DepthAt(world, 5.0 * i + 51.0, 0.0), 10.0f, 1e-5f);
    }
    swInput_Enable(world, gate, false);
    Step(world);
    assert_float_equal(DepthAt(world, 95.0, 0.0), 10.0f, 1e-5f);
    swDestroyWorld(world);
}

static void WritersRaiseLowerAndReplace(void** state)
{
    (void)state;
    const swInputBlend blends[] = {SW_BLEND_MAX, SW_BLEND_MIN, SW_BLEND_REPLACE, SW_BLEND_ADD};
    const float shoals[] = {-4.0f, -10.0f, -4.0f, -14.0f}; // a shoal of -4 on a bed of -10
    const float trenches[] = {-10.0f, -30.0f, -30.0f, -40.0f};
    for (int i = 0; i < 4; ++i)
    {
        swWorld* world = MakeWorld(0.0);
        swInputDef bed = swDefaultInputDef();
        bed.value[0] = -10.0f;
        Add(world, &bed);
        swInputDef def = swDefaultInputDef();
        def.shape = SW_SHAPE_RECTANGLE;
        def.size = (swVec3){100.0f, 0.0f, 100.0f};
        def.order = 1;
        def.blend = blends[i];
        def.value[0] = -4.0f;
        Add(world, &def);
        def.position.x = 500.0;
        def.value[0] = -30.0f;
        Add(world, &def);
        Step(world);
        assert_float_equal(FloorAt(world, 0.0, 0.0), shoals[i], 1e-4f);
        assert_float_equal(FloorAt(world, 500.0, 0.0), trenches[i], 1e-4f);
        assert_float_equal(FloorAt(world, 250.0, 0.0), -10.0f, 1e-4f);
        swDestroyWorld(world);
    }
}

// ---- nests ----

static float Hills(double x, double z, double bias)
{
    return (float)(-30.0 + bias + 10.0 * sin(x / 130.0) * cos(z / 110.0));
}

static swRaster* MakeRaster(int side, double x, double z, double spacing, double bias)
{
    float* values = malloc((size_t)side * (size_t)side * sizeof(float));
    assert_non_null(values);
    for (int i = 0; i < side * side; ++i)
    {
        values[i] = Hills(x + spacing * (i % side), z + spacing * (i / side), bias);
    }
    swHost host = MakeHost();
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = side;
    def.x = x;
    def.z = z;
    def.spacingX = def.spacingZ = spacing;
    def.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    free(values);
    return raster;
}

// Of three levels the finer ones lie 2 and 5 m higher, so that one sees which counts.
static void InANestTheFinestCountsAndJoinsAreSmooth(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(0.0);
    swRaster* rasters[3] = {MakeRaster(121, -300.0, -300.0, 5.0, 5.0), MakeRaster(81, -4000.0, -4000.0, 100.0, 0.0),
                            MakeRaster(101, -1000.0, -1000.0, 20.0, 2.0)};
    swInputDef def = swDefaultInputDef();
    swInputId ids[3];
    assert_int_equal(swCreateNest(world, &def, 3, (const swRaster* const*)rasters, ids), SW_SUCCESS);
    assert_true(swInput_Get(world, ids[0]).order == 2 && swInput_Get(world, ids[1]).order == 0);
    assert_true(swInput_Get(world, ids[0]).feather == 60.0f && swInput_Get(world, ids[2]).feather == 300.0f);
    for (int i = 0; i < 3; ++i)
    {
        swDestroyRaster(rasters[i]);
    }
    Step(world);
    assert_float_equal(FloorAt(world, 100.0, 50.0), Hills(100.0, 50.0, 5.0), 0.05f);
    assert_float_equal(FloorAt(world, 600.0, -500.0), Hills(600.0, -500.0, 2.0), 0.1f);
    assert_float_equal(FloorAt(world, 2000.0, 2000.0), Hills(2000.0, 2000.0, 0.0), 0.05f);
    assert_true(isinf(FloorAt(world, 4100.0, 0.0)) && FloorAt(world, 3999.0, 0.0) < -1000.0f);
    float last = FloorAt(world, 3000.0, 5.0);
    for (double x = 3000.0; x > -100.0; x -= 1.0) // across all joins, no step: 5 m in 60 m, hills of 1:13, and both
    {
        float height = FloorAt(world, x, 5.0);
        assert_true(fabsf(height - last) < 0.25f);
        last = height;
    }
    swDestroyWorld(world);
}

static void ANestThatFailsLeavesNothing(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(0.0);
    swRaster* rasters[2] = {MakeRaster(11, 0.0, 0.0, 10.0, 0.0), MakeRaster(11, 0.0, 0.0, 5.0, 0.0)};
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_FLOW; // has two numbers
    swInputId ids[2];
    assert_int_equal(swCreateNest(world, &def, 2, (const swRaster* const*)rasters, ids), SW_ERROR_INVALID);
    assert_int_equal(swWorld_GetInputCount(world), 0);
    assert_true(ids[0].index1 == 0 && ids[1].index1 == 0);
    swDestroyRaster(rasters[0]);
    swDestroyRaster(rasters[1]);
    swDestroyWorld(world);
}

// ---- waves ----

// Of every octave on a flat floor: the share of its height, and that sideways motion ends with it.
static void WavesHaveTheirShareInAllDirections(void** state)
{
    (void)state;
    enum
    {
        COUNT = 64
    };
    swWorld* world = MakeWorld(0.0);
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.spectrum.depth = 30.0f; // sideways motion is wider than in deep water
    waves.minWavelength = 64.0f;
    waves.maxWavelength = 128.0f;
    swWaveSystemId system;
    assert_int_equal(swCreateWaveSystem(world, &waves, &system), SW_SUCCESS);
    swInputDef bed = swDefaultInputDef();
    swInputId id = Add(world, &bed);
    swPosXZ points[COUNT];
    swVec3 moved[COUNT];
    for (int i = 0; i < COUNT; ++i)
    {
        points[i] = (swPosXZ){37.0 * i, 11.0 * i * i};
    }
    swQueryDef query = swDefaultQueryDef();
    query.tolerance = 1e-3f;
    const swSurfaceSamples samples = {.displacement = moved};
    const float depths[] = {1000.0f, 45.3f, 20.0f, 8.0f, 2.0f, 0.2f, 0.0f, -3.0f};
    double before = 1e9, ratio = 0.0;
    for (int i = 0; i < 8; ++i)
    {
        swInput_SetValue(world, id, (const float[4]){-depths[i], 0.0f, 0.0f, 0.0f});
        assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
        swMoment_QuerySurface(swWorld_GetMoment(world), &query, COUNT, points, &samples, NULL);
        double up = 0.0, sideways = 0.0;
        for (int k = 0; k < COUNT; ++k)
        {
            up += (double)(moved[k].y * moved[k].y);
            sideways += (double)(moved[k].x * moved[k].x + moved[k].z * moved[k].z);
        }
        up = sqrt(up / COUNT);
        sideways = sqrt(sideways / COUNT);
        ratio = i == 0 ? sideways / up : ratio;
        print_message("%6.1f m: %.4f m up, %.4f m sideways\n", (double)depths[i], up, sideways);
        assert_true(i <= 1 ? up == before || i == 0 : up < before || up == 0.0); // 45.3 m is half of the middle length
        assert_true(up < 1e-3 || fabs(sideways / up / ratio - 1.0) < 0.15);
        assert_true(depths[i] > 0.0f || (up == 0.0 && sideways == 0.0));
        before = up;
    }
    swDestroyWorld(world);
}

// ---- baking ----

static void ABakedFloorIsTheFloorAndKnowsWhenItIsStale(void** state)
{
    (void)state;
    swWorld* world = MakeWorld(3.0);
    swMesh* mesh = MakeBlock(5.0f);
    swInputDef def = MakeMeshInput(mesh, (swPos){0.0, -12.0, 0.0});
    swInputId id = Add(world, &def);
    Step(world);
    swRasterDef lattice = swDefaultRasterDef();
    lattice.width = 31;
    lattice.height = 17;
    lattice.x = -60.0;
    lattice.z = -32.0;
    lattice.spacingX = lattice.spacingZ = 4.0;
    swRaster* raster = NULL;
    assert_int_equal(swBakeFloor(world, &lattice, &raster), SW_SUCCESS);
    const float* heights = swRaster_GetValues(raster);
    for (int i = 0; i < 31 * 17; ++i)
    {
        float height = FloorAt(world, -60.0 + 4.0 * (i % 31), -32.0 + 4.0 * (i / 31));
        assert_true(isinf(height) ? isnan(heights[i]) : heights[i] == height);
    }
    swDestroyRaster(raster);
    uint64_t hash = swWorld_HashFloor(world, &lattice);
    swInputDef foam = swDefaultInputDef();
    foam.field = SW_INPUT_FOAM;
    Add(world, &foam);
    assert_true(swWorld_HashFloor(world, &lattice) == hash); // foam is no floor
    swInput_Move(world, id, (swPos){0.0, -11.0, 0.0}, (swAngles){0});
    assert_true(swWorld_HashFloor(world, &lattice) != hash);
    swInput_Move(world, id, (swPos){0.0, -12.0, 0.0}, (swAngles){0});
    assert_true(swWorld_HashFloor(world, &lattice) == hash);
    swMesh* other = MakeBlock(20.0f);
    def.mesh = other;
    assert_int_equal(swInput_Set(world, id, &def), SW_SUCCESS);
    assert_true(swWorld_HashFloor(world, &lattice) != hash);
    lattice.x = -61.0;
    def.mesh = mesh;
    assert_int_equal(swInput_Set(world, id, &def), SW_SUCCESS);
    assert_true(swWorld_HashFloor(world, &lattice) != hash);
    swDestroyMesh(mesh);
    swDestroyMesh(other);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AMeshIsAFloorWhereItLies),
        cmocka_unit_test(WhatLiesAboveAHeightIsNoFloor),
        cmocka_unit_test(FloorsMayMoveWhileTheSeaRuns),
        cmocka_unit_test(WritersRaiseLowerAndReplace),
        cmocka_unit_test(InANestTheFinestCountsAndJoinsAreSmooth),
        cmocka_unit_test(ANestThatFailsLeavesNothing),
        cmocka_unit_test(WavesHaveTheirShareInAllDirections),
        cmocka_unit_test(ABakedFloorIsTheFloorAndKnowsWhenItIsStale),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
