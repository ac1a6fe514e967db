// SPDX-License-Identifier: MIT
// Inputs shape the same water on both halves: layers texel by texel, queries and rays point by point, around the view
// and 100 km away. Each kind of input is alone once, so that the error of each is seen.

#include "parity/parity.h"
#include "support/messages.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_OFF_M 1e-3
#define DERIVATIVE 4e-3 // half floats, see parity_slices.c
#define SLOPE 2e-3      // of depths, see CompareGrounds()
#define POINTS 3000
#define TOLERANCE 1e-4f // m: what a residual makes of heights is not all in the slope where waves are steep

static swPosXZ points[POINTS];

// A seabed of 8 to 20 m that is up to 40 cells wide, one cell of which is not known.
static swRaster* MakeSeabed(swPosXZ middle)
{
    enum
    {
        SIDE = 41
    };
    static float heights[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        heights[i] = -14.0f + 6.0f * (float)(sin(0.3 * (i % SIDE)) * cos(0.2 * (double)(i / SIDE)));
    }
    heights[20 * SIDE + 12] = NAN;
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = SIDE;
    def.spacingX = def.spacingZ = 20.0;
    def.x = middle.x - 0.5 * def.spacingX * (SIDE - 1);
    def.z = middle.z - 0.5 * def.spacingZ * (SIDE - 1);
    def.values = heights;
    swRaster* raster = NULL;
    swHost host = swDefaultHost();
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    return raster;
}

static swInputId AddInput(Parity* parity, const swInputDef* def)
{
    swInputId id;
    assert_int_equal(swCreateInput(parity->world, def, &id), SW_SUCCESS);
    return id;
}

static swInputDef At(swInputField field, swInputShape shape, swPosXZ middle, float size, float value)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = shape;
    def.position = (swPos){middle.x, 0.0, middle.z};
    def.size = (swVec3){size, 10.0f, 0.7f * size};
    def.feather = 0.2f * size;
    def.value[0] = value;
    return def;
}

// ---- kinds of inputs ----

typedef struct Feature
{
    const char* name;
    void (*add)(Parity* parity, swPosXZ middle);
} Feature;

static void AddFloors(Parity* parity, swPosXZ middle)
{
    swInputDef def = At(SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, middle, 300.0f, -4.0f);
    AddInput(parity, &def);
    def = At(SW_INPUT_FLOOR, SW_SHAPE_RECTANGLE, (swPosXZ){middle.x + 60.0, middle.z - 30.0}, 200.0f, 1.0f);
    def.rotation.yaw = 0.4f;
    def.blend = SW_BLEND_MAX;
    AddInput(parity, &def);
}

static void AddRaster(Parity* parity, swPosXZ middle)
{
    swRaster* raster = MakeSeabed(middle);
    swInputDef def = At(SW_INPUT_FLOOR, SW_SHAPE_RASTER, (swPosXZ){0.0, 0.0}, 1.0f, 0.0f);
    def.feather = 50.0f;
    def.raster = raster;
    AddInput(parity, &def);
    swDestroyRaster(raster);
}

static void AddLevel(Parity* parity, swPosXZ middle)
{
    swInputDef def = At(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, middle, 250.0f, 3.0f);
    AddInput(parity, &def);
    def = At(SW_INPUT_FLOOR, SW_SHAPE_EVERYWHERE, middle, 1.0f, -12.0f);
    AddInput(parity, &def);
}

static void AddWeights(Parity* parity, swPosXZ middle)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.seed = 77;
    def.spectrum.direction = 1.9f;
    def.isLocal = true;
    swWaveSystemId local;
    assert_int_equal(swCreateWaveSystem(parity->world, &def, &local), SW_SUCCESS);
    swInputDef weight = At(SW_INPUT_WAVES, SW_SHAPE_CIRCLE, middle, 220.0f, 1.0f);
    weight.system = local;
    AddInput(parity, &weight);
    def.isLocal = false;
    def.seed = 78;
    assert_int_equal(swCreateWaveSystem(parity->world, &def, &local), SW_SUCCESS);
    weight = At(SW_INPUT_WAVES, SW_SHAPE_RECTANGLE, middle, 260.0f, 0.2f);
    weight.system = local;
    AddInput(parity, &weight);
}

static void AddFreeWaves(Parity* parity, swPosXZ middle)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.seed = 5;
    AddParitySea(parity, &def);
    AddFloors(parity, middle);
}

// Corners of a polygon, points of a line, or particles.
static void AddPoints(Parity* parity, swInputField field, swInputShape shape, swPosXZ middle, float value)
{
    const swInputPoint shapePoints[] = {{-90.0f, -60.0f, 30.0f, 1.0f, {0.0f}},
                                        {80.0f, -75.0f, 50.0f, 0.7f, {-1.5f}},
                                        {40.0f, 10.0f, 40.0f, 0.9f, {1.0f}},
                                        {95.0f, 85.0f, 60.0f, 0.5f, {-2.0f}},
                                        {-70.0f, 60.0f, 35.0f, 1.0f, {0.5f}}};
    swInputDef def = At(field, shape, middle, 60.0f, value);
    def.rotation.yaw = 0.7f;
    def.feather = 25.0f;
    def.points = shapePoints;
    def.pointCount = 5;
    AddInput(parity, &def);
}

static void AddPolygons(Parity* parity, swPosXZ middle)
{
    AddPoints(parity, SW_INPUT_FLOOR, SW_SHAPE_POLYGON, middle, -6.0f);
    AddPoints(parity, SW_INPUT_LEVEL, SW_SHAPE_POLYGON, (swPosXZ){middle.x + 40.0, middle.z - 25.0}, 2.0f);
}

static void AddPolylines(Parity* parity, swPosXZ middle)
{
    AddPoints(parity, SW_INPUT_FLOOR, SW_SHAPE_POLYLINE, middle, -6.0f);
    AddPoints(parity, SW_INPUT_LEVEL, SW_SHAPE_POLYLINE, (swPosXZ){middle.x + 40.0, middle.z - 25.0}, 2.0f);
}

static void AddParticles(Parity* parity, swPosXZ middle)
{
    AddPoints(parity, SW_INPUT_FLOOR, SW_SHAPE_PARTICLES, middle, -6.0f);
    AddPoints(parity, SW_INPUT_LEVEL, SW_SHAPE_PARTICLES, (swPosXZ){middle.x + 40.0, middle.z - 25.0}, 2.0f);
}

// A reef with two flanks; the level stands a part of its heights higher.
static void AddMeshes(Parity* parity, swPosXZ middle)
{
    static const swVec3 vertices[] = {{-120.0f, 0.0f, -90.0f}, {120.0f, 0.0f, -90.0f}, {-120.0f, 0.0f, 90.0f},
                                      {120.0f, 0.0f, 90.0f},   {-70.0f, 7.0f, 5.0f},   {60.0f, 4.0f, -10.0f}};
    static const uint32_t faces[] = {0, 1, 5, 0, 5, 4, 0, 4, 2, 2, 4, 3, 4, 5, 3, 5, 1, 3};
    static const float values[] = {0.2f, 0.1f, 0.0f, 0.3f, 1.0f, 0.6f};
    swHost host = swDefaultHost();
    swMeshDef meshDef = swDefaultMeshDef();
    meshDef.vertices = vertices;
    meshDef.vertexCount = 6;
    meshDef.indices = faces;
    meshDef.triangleCount = 6;
    meshDef.values = values;
    meshDef.channelCount = 1;
    swMesh* mesh = NULL;
    assert_int_equal(swCreateMesh(&host, &meshDef, &mesh), SW_SUCCESS);
    for (int i = 0; i < 2; ++i)
    {
        swInputDef def = At(i == 0 ? SW_INPUT_FLOOR : SW_INPUT_LEVEL, SW_SHAPE_MESH, middle, 1.0f, 0.0f);
        def.mesh = mesh;
        def.position.y = i == 0 ? -9.0 : 0.0;
        def.rotation.yaw = 0.3f;
        def.feather = 30.0f;
        AddInput(parity, &def);
    }
    swDestroyMesh(mesh);
}

// Solids, an area and a polygon, where the level stands higher.
static void AddHoles(Parity* parity, swPosXZ middle)
{
    const swInputShape shapes[] = {SW_SHAPE_BOX, SW_SHAPE_ELLIPSOID, SW_SHAPE_CYLINDER, SW_SHAPE_CIRCLE};
    for (int i = 0; i < 4; ++i)
    {
        swPosXZ place = {middle.x + 60.0 * (i % 2) - 40.0, middle.z + 50.0 * (double)(i / 2) - 30.0};
        swInputDef def = At(SW_INPUT_CLIP, shapes[i], place, 50.0f, 1.0f);
        def.size.y = 3.0f; // waves leave and enter it
        def.position.y = 1.0;
        def.rotation.yaw = 0.4f;
        def.feather = 0.0f;
        AddInput(parity, &def);
    }
    AddPoints(parity, SW_INPUT_CLIP, SW_SHAPE_POLYGON, (swPosXZ){middle.x + 150.0, middle.z}, 1.0f);
    swInputDef level = At(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, middle, 150.0f, 1.5f);
    AddInput(parity, &level);
}

// A closed line around the middle, so that each place of a view is near it.
static swSpline* MakeRing(swPosXZ middle)
{
    swSplinePoint line[5];
    for (int i = 0; i < 5; ++i)
    {
        double angle = 2.0 * SW_PI * i / 5.0;
        line[i] = swDefaultSplinePoint(middle.x + 70.0 * cos(angle), 1.0, middle.z + 60.0 * sin(angle));
        line[i].weight = 0.6f + 0.08f * (float)i;
        line[i].depth = 4.0f + (float)i;
        line[i].level = 0.2f * (float)i;
    }
    swSplineDef def = swDefaultSplineDef();
    def.points = line;
    def.pointCount = 5;
    def.isClosed = true;
    def.width = 70.0f;
    swSpline* spline = NULL;
    swHost host = swDefaultHost();
    assert_int_equal(swCreateSpline(&host, &def, &spline), SW_SUCCESS);
    return spline;
}

// Level, floor, a hole and the weight of the waves by splines.
static void AddSplines(Parity* parity, swPosXZ middle)
{
    swSpline* spline = MakeRing(middle);
    const swInputField fields[] = {SW_INPUT_LEVEL, SW_INPUT_FLOOR, SW_INPUT_CLIP, SW_INPUT_WAVES};
    for (int i = 0; i < 4; ++i)
    {
        swInputDef def = swDefaultInputDef();
        def.field = fields[i];
        def.shape = SW_SHAPE_SPLINE;
        def.spline = spline;
        def.feather = fields[i] == SW_INPUT_CLIP ? 0.0f : 20.0f;
        def.value[0] = fields[i] == SW_INPUT_WAVES ? -0.6f : 0.0f;
        def.position = fields[i] == SW_INPUT_CLIP ? (swPos){150.0, 0.0, 60.0} : (swPos){0.0, 0.0, 0.0};
        AddInput(parity, &def);
    }
    swDestroySpline(spline);
}

// Systems of tiles and of free waves, the one nowhere else, the other taken away where it runs along the line.
static void AddRibbons(Parity* parity, swPosXZ middle)
{
    swSpline* spline = MakeRing(middle);
    for (int method = 0; method < 2; ++method)
    {
        swWaveSystemDef def = swDefaultWaveSystemDef();
        def.method = method == 0 ? SW_WAVES_FFT : SW_WAVES_GERSTNER;
        def.seed = 91u + (uint32_t)method;
        def.isLocal = method == 0;
        def.spectrum.windSpeed = 6.0f;
        swWaveSystemId id;
        assert_int_equal(swCreateWaveSystem(parity->world, &def, &id), SW_SUCCESS);
        swInputDef along = swDefaultInputDef();
        along.field = SW_INPUT_WAVES;
        along.shape = SW_SHAPE_SPLINE;
        along.spline = spline;
        along.alongSpline = true;
        along.heading = method == 0 ? 0.5f : 1.2f;
        along.feather = 15.0f;
        along.system = id;
        AddInput(parity, &along);
    }
    swDestroySpline(spline);
}

static void AddAll(Parity* parity, swPosXZ middle)
{
    AddRaster(parity, middle);
    AddFreeWaves(parity, middle);
    AddLevel(parity, middle);
    AddWeights(parity, middle);
}

static const Feature features[] = {
    {"floors: circle, rectangle", AddFloors},
    {"floor: raster", AddRaster},
    {"level over a floor", AddLevel},
    {"weights of systems", AddWeights},
    {"floors under free waves", AddFreeWaves},
    {"all together", AddAll},
    {"polygons", AddPolygons},
    {"polylines", AddPolylines},
    {"particles", AddParticles},
    {"meshes", AddMeshes},
    {"holes", AddHoles},
    {"splines", AddSplines},
    {"waves along a spline", AddRibbons},
};
#define FEATURES (int)(sizeof(features) / sizeof(features[0]))

static Parity MakeShore(void** state, const Feature* feature, swPosXZ middle)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    feature->add(&parity, middle);
    return parity;
}

// ---- layers ----

// Depths by metres, and by parts where there is hardly a floor any more: a floor that fades into none is mixed by the
// inverse of its depth, whose error grows with the depth's square.
static double CompareGrounds(Parity* parity, double* slopes)
{
    size_t count = (size_t)parity->resolution * (size_t)parity->resolution;
    float* gpu = malloc(count * 4 * sizeof(float));
    assert_non_null(gpu);
    double worst = 0.0;
    *slopes = 0.0;
    for (int slice = 0; slice < parity->sliceCount; ++slice)
    {
        const float* cpu = swView_GetPlaces(parity->view, slice);
        assert_int_equal(swGpuWorld_ReadLayer(parity->gpuWorld, parity->view, SW_LAYER_PLACES, slice, gpu), SW_SUCCESS);
        for (size_t i = 0; i < 4 * count; i += 4)
        {
            const float rest[4] = {1e30f, 0.0f, 0.0f, 0.0f};
            const float* texel = cpu != NULL ? cpu + i : rest;
            double scale = fmax(fabs((double)texel[0]) / 100.0, 1.0);
            double depth = fabs((double)texel[0] - (double)gpu[i]) / scale / scale;
            double level = fabs((double)texel[3] - (double)gpu[i + 3]);
            double slope =
                fmax(fabs((double)texel[1] - (double)gpu[i + 1]), fabs((double)texel[2] - (double)gpu[i + 2]));
            worst = fmax(worst, fmax(depth, level));
            *slopes = fmax(*slopes, slope / scale / scale);
        }
    }
    free(gpu);
    return worst;
}

static void LayersAgree(void** state)
{
    for (int i = 0; i < FEATURES; ++i)
    {
        const swPosXZ middles[] = {{20.0, -30.0}, {1e5 + 17.3, -1e5 - 40.6}};
        for (int m = 0; m < 2; ++m)
        {
            Parity parity = MakeShore(state, &features[i], middles[m]);
            AddParityView(&parity, 4, 128, (swPos){middles[m].x, 8.0, middles[m].z});
            StepParity(&parity, 1.0);
            Difference displacement = CompareLayer(&parity, SW_LAYER_DISPLACEMENT);
            Difference derivatives = CompareLayer(&parity, SW_LAYER_DERIVATIVES);
            double slopes;
            double grounds = CompareGrounds(&parity, &slopes);
            printf("  %-28s %s displacement %.2g m, derivatives %.2g, depth and level %.2g m, slopes %.2g\n",
                   features[i].name, m == 0 ? "here:  " : "100 km:", displacement.worst, derivatives.worst, grounds,
                   slopes);
            assert_true(displacement.worst < MOST_OFF_M);
            assert_true(derivatives.worst < DERIVATIVE);
            assert_true(grounds < MOST_OFF_M);
            assert_true(slopes < SLOPE);
            FreeParity(&parity);
        }
    }
}

// ---- queries ----

static swGpuQuery* MakeQuery(Parity* parity, swGpuQueryKind kind)
{
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.kind = kind;
    def.capacity = POINTS;
    def.tolerance = TOLERANCE;
    def.outputs = kind == SW_GPU_QUERY_KIND_RAYS ? SW_GPU_QUERY_NORMAL : SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity->gpuWorld, &def, &query), SW_SUCCESS);
    return query;
}

static swGpuQueryResults FetchResults(Parity* parity, const swGpuQuery* query)
{
    swGpuQueryResults results;
    swGpu_SetFinishedFrame(parity->gpu, parity->gpu->frameIndex);
    assert_true(swGpuQuery_GetResults(query, &results));
    return results;
}

static float gpuHeight[POINTS], cpuHeight[POINTS], gpuResidual[POINTS], cpuResidual[POINTS];
static bool gpuClipped[POINTS], cpuClipped[POINTS];
static swVec3 gpuNormal[POINTS], cpuNormal[POINTS], gpuWay[POINTS], cpuWay[POINTS];

// Heights, displacements and normals of the particles that both halves found, and whether they are in holes; how many
// points have another one.
static void CheckQuery(Parity* parity, const char* what, swPosXZ middle, bool hasHoles)
{
    swGpuQuery* query = MakeQuery(parity, SW_GPU_QUERY_KIND_SURFACE);
    ScatterPoints(points, POINTS, middle.x, middle.z, 500.0);
    swGpuQuery_SetPoints(query, POINTS, points);
    StepParity(parity, 0.7);
    swGpuQueryResults results = FetchResults(parity, query);
    const swSurfaceSamples gpu = {.height = gpuHeight,
                                  .normal = gpuNormal,
                                  .displacement = gpuWay,
                                  .residual = gpuResidual,
                                  .isClipped = gpuClipped};
    const swSurfaceSamples cpu = {.height = cpuHeight,
                                  .normal = cpuNormal,
                                  .displacement = cpuWay,
                                  .residual = cpuResidual,
                                  .isClipped = cpuClipped};
    swGpuQueryResults_Unpack(&results, &gpu, NULL);
    swQueryDef def = swDefaultQueryDef();
    def.tolerance = TOLERANCE;
    swMoment_QuerySurface(swWorld_GetMoment(parity->world), &def, POINTS, points, &cpu, NULL);
    int others = 0, clipped = 0, otherwiseClipped = 0;
    double worst = 0.0, upward = 0.0, normals = 0.0;
    for (int i = 0; i < POINTS; ++i)
    {
        double residuals = (double)gpuResidual[i] + (double)cpuResidual[i];
        double apart = hypot((double)(gpuWay[i].x - cpuWay[i].x), (double)(gpuWay[i].z - cpuWay[i].z));
        if (apart > 0.02 + residuals)
        {
            others += 1;
            continue;
        }
        double slope = hypot((double)cpuNormal[i].x, (double)cpuNormal[i].z) / fmax((double)cpuNormal[i].y, 1e-6);
        double off = fabs((double)gpuHeight[i] - (double)cpuHeight[i]) - slope * residuals;
        worst = fmax(worst, off);
        upward = fmax(upward, fabs((double)(gpuWay[i].y - cpuWay[i].y)) - slope * residuals);
        clipped += cpuClipped[i] ? 1 : 0;
        otherwiseClipped += cpuClipped[i] != gpuClipped[i] ? 1 : 0;
        normals = fmax(normals, fabs((double)(gpuNormal[i].y - cpuNormal[i].y)));
    }
    printf(
        "  %-28s heights %.2g m, displacement %.2g m, normals %.2g; %d of %d have another particle, %d are in holes, "
        "%d of them for one half only\n",
        what, worst, upward, normals, others, POINTS, clipped, otherwiseClipped);
    assert_true(worst < MOST_OFF_M);
    assert_true(upward < MOST_OFF_M);
    assert_true(hasHoles ? clipped > POINTS / 50 : clipped == 0);
    assert_true(otherwiseClipped <= (hasHoles ? 2 : 0)); // at an edge
    assert_true(normals < 0.05);                         // of particles a residual apart
    assert_true(others <= POINTS / 1000);
    swDestroyGpuQuery(query);
}

static void QueriesAgree(void** state)
{
    for (int i = 0; i < FEATURES; ++i)
    {
        const swPosXZ here = {20.0, -30.0}, away = {1e5 + 17.3, -1e5 - 40.6};
        Parity parity = MakeShore(state, &features[i], here);
        bool hasHoles = features[i].add == AddHoles || features[i].add == AddSplines;
        CheckQuery(&parity, features[i].name, here, hasHoles);
        FreeParity(&parity);
        parity = MakeShore(state, &features[i], away);
        CheckQuery(&parity, "  100 km away", away, hasHoles);
        FreeParity(&parity);
    }
}

// ---- what is left out ----

static void AnswerNothing(void* context, double time, int count, const swPosXZ* asked, swInputAnswer* answers)
{
    (void)context;
    (void)time;
    (void)count;
    (void)asked;
    (void)answers;
}

static int CountMessages(const char* text)
{
    int count = 0;
    for (const char* at = strstr(s_messages, text); at != NULL; at = strstr(at + 1, text))
    {
        count += 1;
    }
    return count;
}

static const char* const told[] = {"functions of the host", "what a floor does", "what weights", "the flow there"};
#define TOLD (int)(sizeof(told) / sizeof(told[0]))

// Of what is left out everywhere, and of what only queries of the water below leave out.
static void CheckTold(int everywhere, int below)
{
    for (int i = 0; i < TOLD; ++i)
    {
        assert_int_equal(CountMessages(told[i]), i < 1 ? everywhere : below);
    }
}

static void WhatIsLeftOutIsSaidOnceOfEachKind(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swGpuDef gpuDef = swDefaultGpuDef();
    swGpu* gpu = NULL;
    assert_int_equal(swCreateGpu(&host, &gpuDef, &gpu), SW_SUCCESS);
    void* opened = gpu;
    Parity parity = MakeParity(&opened);
    s_messages[0] = '\0';
    const swPosXZ middle = {0.0, 0.0};
    AddFloors(&parity, middle); // which only the motion below is told of
    StepParity(&parity, 0.1);
    CheckTold(0, 0);
    swInputDef def = At(SW_INPUT_FLOW, SW_SHAPE_CIRCLE, middle, 80.0f, 1.0f); // likewise
    AddInput(&parity, &def);
    def = At(SW_INPUT_WAVES, SW_SHAPE_CIRCLE, middle, 80.0f, 0.5f);
    AddInput(&parity, &def);
    StepParity(&parity, 0.1);
    CheckTold(0, 0);
    def = At(SW_INPUT_LEVEL, SW_SHAPE_FUNCTION, middle, 80.0f, 0.5f);
    def.function = AnswerNothing;
    AddInput(&parity, &def);
    StepParity(&parity, 0.1);
    CheckTold(1, 0);
    swGpuQueryDef queryDef = swDefaultGpuQueryDef();
    queryDef.kind = SW_GPU_QUERY_KIND_VOLUME;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &queryDef, &query), SW_SUCCESS);
    swGpuQuery_SetPlaces(query, 1, &(swPos){0.0, -1.0, 0.0});
    for (int i = 0; i < 3; ++i)
    {
        AddFloors(&parity, middle);
        StepParity(&parity, 0.1);
        CheckTold(1, 1);
    }
    printf("%s", s_messages);
    FreeParity(&parity);
    swDestroyGpu(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(LayersAgree),
        cmocka_unit_test(QueriesAgree),
        cmocka_unit_test(WhatIsLeftOutIsSaidOnceOfEachKind),
    };
    return cmocka_run_group_tests_name("authored fields: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
