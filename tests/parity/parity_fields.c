// SPDX-License-Identifier: MIT
// Inputs shape the same water on both halves: layers texel by texel, queries and rays point by point, around the view
// and 100 km away. Each kind of input is alone once, so that the error of each is seen.

#include "parity/parity.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_OFF_M 1e-3
#define DERIVATIVE 4e-3 // half floats, see parity_slices.c
#define SLOPE 2e-3      // of depths, see CompareGrounds()
#define POINTS 3000

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

static void AddAll(Parity* parity, swPosXZ middle)
{
    AddRaster(parity, middle);
    AddFreeWaves(parity, middle);
    AddLevel(parity, middle);
    AddWeights(parity, middle);
}

static const Feature features[] = {
    {"floors: circle, rectangle", AddFloors},  {"floor: raster", AddRaster},
    {"level over a floor", AddLevel},          {"weights of systems", AddWeights},
    {"floors under free waves", AddFreeWaves}, {"all together", AddAll},
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
static swVec3 gpuNormal[POINTS], cpuNormal[POINTS], gpuWay[POINTS], cpuWay[POINTS];

// Heights and normals of the particles that both halves found; how many points have another one.
static void CheckQuery(Parity* parity, const char* what, swPosXZ middle)
{
    swGpuQuery* query = MakeQuery(parity, SW_GPU_QUERY_KIND_SURFACE);
    ScatterPoints(points, POINTS, middle.x, middle.z, 500.0);
    swGpuQuery_SetPoints(query, POINTS, points);
    StepParity(parity, 0.7);
    swGpuQueryResults results = FetchResults(parity, query);
    const swSurfaceSamples gpu = {
        .height = gpuHeight, .normal = gpuNormal, .displacement = gpuWay, .residual = gpuResidual};
    const swSurfaceSamples cpu = {
        .height = cpuHeight, .normal = cpuNormal, .displacement = cpuWay, .residual = cpuResidual};
    swGpuQueryResults_Unpack(&results, &gpu, NULL);
    swQueryDef def = swDefaultQueryDef();
    swMoment_QuerySurface(swWorld_GetMoment(parity->world), &def, POINTS, points, &cpu, NULL);
    int others = 0;
    double worst = 0.0, normals = 0.0;
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
        normals = fmax(normals, fabs((double)(gpuNormal[i].y - cpuNormal[i].y)));
    }
    printf("  %-28s heights %.2g m, normals %.2g; %d of %d have another particle\n", what, worst, normals, others,
           POINTS);
    assert_true(worst < MOST_OFF_M);
    assert_true(normals < 0.05); // of particles a residual apart
    assert_true(others <= POINTS / 1000);
    swDestroyGpuQuery(query);
}

static void QueriesAgree(void** state)
{
    for (int i = 0; i < FEATURES; ++i)
    {
        const swPosXZ here = {20.0, -30.0}, away = {1e5 + 17.3, -1e5 - 40.6};
        Parity parity = MakeShore(state, &features[i], here);
        CheckQuery(&parity, features[i].name, here);
        FreeParity(&parity);
        parity = MakeShore(state, &features[i], away);
        CheckQuery(&parity, "  100 km away", away);
        FreeParity(&parity);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(LayersAgree),
        cmocka_unit_test(QueriesAgree),
    };
    return cmocka_run_group_tests_name("authored fields: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
