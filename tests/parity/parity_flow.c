// SPDX-License-Identifier: MIT
// Flow that differs from place to place is the same on both halves: its layers texel by texel, around the view and
// 100 km away.

#include "parity/parity.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_OFF_M 1e-3
#define SLOPE 1e-3 // of the flow, in half floats
#define POINTS 2000
#define TOLERANCE 1e-4f // m

static swPosXZ points[POINTS];

// ---- flows ----

typedef struct Feature
{
    const char* name;
    void (*add)(Parity* parity, swPosXZ middle);
} Feature;

static void AddInput(Parity* parity, const swInputDef* def)
{
    swInputId id;
    assert_int_equal(swCreateInput(parity->world, def, &id), SW_SUCCESS);
}

static swInputDef MakeFlow(swInputShape shape, swPosXZ middle, float size, float x, float z)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_FLOW;
    def.shape = shape;
    def.position = (swPos){middle.x, 0.0, middle.z};
    def.size = (swVec3){size, 10.0f, 0.7f * size};
    def.feather = 0.2f * size;
    def.value[0] = x;
    def.value[1] = z;
    return def;
}

static void AddSlow(Parity* parity, swPosXZ middle)
{
    swInputDef def = MakeFlow(SW_SHAPE_CIRCLE, middle, 300.0f, 0.02f, -0.01f);
    AddInput(parity, &def);
}

static void AddStream(Parity* parity, swPosXZ middle)
{
    swInputDef def = MakeFlow(SW_SHAPE_RECTANGLE, middle, 240.0f, 2.0f, -0.5f);
    def.rotation.yaw = 0.4f;
    AddInput(parity, &def);
}

// A map of an eddy.
static void AddMap(Parity* parity, swPosXZ middle)
{
    enum
    {
        SIDE = 33
    };
    static float values[SIDE * SIDE][2];
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        double x = (i % SIDE - 16) / 16.0, z = ((double)(i / SIDE) - 16.0) / 16.0, fall = exp(-3.0 * (x * x + z * z));
        values[i][0] = (float)(-6.0 * z * fall);
        values[i][1] = (float)(6.0 * x * fall);
    }
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = SIDE;
    def.channels = 2;
    def.spacingX = def.spacingZ = 10.0;
    def.x = middle.x - 160.0;
    def.z = middle.z - 160.0;
    def.values = values[0];
    swRaster* raster = NULL;
    swHost host = swDefaultHost();
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    swInputDef map = MakeFlow(SW_SHAPE_RASTER, (swPosXZ){0.0, 0.0}, 1.0f, 0.0f, 0.0f);
    map.raster = raster;
    map.feather = 30.0f;
    AddInput(parity, &map);
    swDestroyRaster(raster);
}

static void AddFreeWaves(Parity* parity, swPosXZ middle)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.seed = 5;
    AddParitySea(parity, &def);
    AddStream(parity, middle);
}

// Over a shoal, which takes some of the waves away.
static void AddShoal(Parity* parity, swPosXZ middle)
{
    swInputDef def = MakeFlow(SW_SHAPE_CIRCLE, middle, 200.0f, -4.0f, 0.0f);
    def.field = SW_INPUT_FLOOR;
    AddInput(parity, &def);
    AddMap(parity, middle);
}

static const Feature features[] = {
    {"0.02 m/s", AddSlow},
    {"a stream of 2 m/s", AddStream},
    {"a map of an eddy", AddMap},
    {"free waves", AddFreeWaves},
    {"an eddy over a shoal", AddShoal},
};
#define FEATURES (int)(sizeof(features) / sizeof(features[0]))

static Parity MakeWater(void** state, const Feature* feature, swPosXZ middle)
{
    swWorldDef def = swDefaultWorldDef();
    def.enableVelocity = def.enableAcceleration = true; // as the device has them, from texels
    Parity parity = MakeParityOf(state, &def);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    feature->add(&parity, middle);
    return parity;
}

// ---- layers ----

static Difference CompareFlow(Parity* parity, swLayer layer)
{
    size_t count = (size_t)parity->resolution * (size_t)parity->resolution;
    float* gpu = malloc(count * 4 * sizeof(float));
    assert_non_null(gpu);
    Difference difference = {0};
    for (int slice = 0; slice < parity->sliceCount; ++slice)
    {
        const float* cpu = layer == SW_LAYER_FLOW ? swView_GetFlow(parity->view, slice)
                                                  : swView_GetFlowSlopes(parity->view, slice);
        assert_non_null(cpu);
        assert_int_equal(swGpuWorld_ReadLayer(parity->gpuWorld, parity->view, layer, slice, gpu), SW_SUCCESS);
        difference = MaxDifference(difference, Compare(cpu, gpu, count, 4, 4));
    }
    free(gpu);
    return difference;
}

static void LayersAgree(void** state)
{
    for (int i = 0; i < FEATURES; ++i)
    {
        const swPosXZ middles[] = {{20.0, -30.0}, {1e5 + 17.3, -1e5 - 40.6}};
        for (int m = 0; m < 2; ++m)
        {
            Parity parity = MakeWater(state, &features[i], middles[m]);
            AddParityView(&parity, 3, 64, (swPos){middles[m].x, 8.0, middles[m].z});
            StepParity(&parity, 1.0);
            Difference flow = CompareFlow(&parity, SW_LAYER_FLOW);
            Difference slopes = CompareFlow(&parity, SW_LAYER_FLOW_SLOPES);
            printf("  %-28s %s flow %.2g of %.2g m/s, slopes %.2g of %.2g 1/s\n", features[i].name,
                   m == 0 ? "here:  " : "100 km:", flow.worst, flow.scale, slopes.worst, slopes.scale);
            assert_true(flow.scale > 1e-3 && slopes.scale > 1e-8);
            assert_true(flow.worst < MOST_OFF_M);
            assert_true(slopes.worst < SLOPE);
            FreeParity(&parity);
        }
    }
}

// ---- queries ----

static float gpuHeight[POINTS], cpuHeight[POINTS], gpuResidual[POINTS], cpuResidual[POINTS];
static swVec3 gpuNormal[POINTS], cpuNormal[POINTS], gpuWay[POINTS], cpuWay[POINTS], gpuVelocity[POINTS],
    cpuVelocity[POINTS], gpuAcceleration[POINTS], cpuAcceleration[POINTS];

static const swSurfaceSamples gpu = {.height = gpuHeight,
                                     .normal = gpuNormal,
                                     .displacement = gpuWay,
                                     .residual = gpuResidual,
                                     .velocity = gpuVelocity,
                                     .acceleration = gpuAcceleration};
static const swSurfaceSamples cpu = {.height = cpuHeight,
                                     .normal = cpuNormal,
                                     .displacement = cpuWay,
                                     .residual = cpuResidual,
                                     .velocity = cpuVelocity,
                                     .acceleration = cpuAcceleration};

static double Apart(swVec3 a, swVec3 b)
{
    return sqrt(pow((double)(a.x - b.x), 2.0) + pow((double)(a.y - b.y), 2.0) + pow((double)(a.z - b.z), 2.0));
}

// Of the particles that both halves found; few points have another one.
static void CompareQueries(const char* name, const char* where)
{
    int others = 0;
    double height = 0.0, normal = 0.0, velocity = 0.0, acceleration = 0.0;
    for (int i = 0; i < POINTS; ++i)
    {
        double residuals = (double)gpuResidual[i] + (double)cpuResidual[i];
        if (hypot((double)(gpuWay[i].x - cpuWay[i].x), (double)(gpuWay[i].z - cpuWay[i].z)) > 0.02 + residuals)
        {
            others += 1;
            continue;
        }
        double slope = hypot((double)cpuNormal[i].x, (double)cpuNormal[i].z) / fmax((double)cpuNormal[i].y, 1e-6);
        height = fmax(height, fabs((double)gpuHeight[i] - (double)cpuHeight[i]) - slope * residuals);
        normal = fmax(normal, Apart(gpuNormal[i], cpuNormal[i]));
        velocity = fmax(velocity, Apart(gpuVelocity[i], cpuVelocity[i]));
        acceleration = fmax(acceleration, Apart(gpuAcceleration[i], cpuAcceleration[i]));
    }
    printf("  %-28s %s heights %.2g m, normals %.2g, velocities %.2g m/s, accelerations %.2g m/s2; %d of %d have "
           "another particle\n",
           name, where, height, normal, velocity, acceleration, others, POINTS);
    assert_true(height < MOST_OFF_M);
    assert_true(normal < 0.05); // of particles a residual apart, like the next
    assert_true(velocity < 0.02);
    assert_true(acceleration < 0.1);
    assert_true(others <= POINTS / 1000);
}

static void AskBoth(Parity* parity, swPosXZ middle)
{
    swGpuQueryDef gpuDef = swDefaultGpuQueryDef();
    gpuDef.capacity = POINTS;
    gpuDef.tolerance = TOLERANCE;
    gpuDef.outputs =
        SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL | SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity->gpuWorld, &gpuDef, &query), SW_SUCCESS);
    ScatterPoints(points, POINTS, middle.x, middle.z, 300.0);
    swGpuQuery_SetPoints(query, POINTS, points);
    StepParity(parity, 0.7);
    swGpuQueryResults results;
    swGpu_SetFinishedFrame(parity->gpu, parity->gpu->frameIndex);
    assert_true(swGpuQuery_GetResults(query, &results));
    swGpuQueryResults_Unpack(&results, &gpu, NULL);
    swQueryDef def = swDefaultQueryDef();
    def.tolerance = TOLERANCE;
    swMoment_QuerySurface(swWorld_GetMoment(parity->world), &def, POINTS, points, &cpu, NULL);
    swDestroyGpuQuery(query);
}

static void QueriesAgree(void** state)
{
    for (int i = 0; i < FEATURES; ++i)
    {
        const swPosXZ middles[] = {{20.0, -30.0}, {1e5 + 17.3, -1e5 - 40.6}};
        for (int m = 0; m < 2; ++m)
        {
            Parity parity = MakeWater(state, &features[i], middles[m]);
            AskBoth(&parity, middles[m]);
            CompareQueries(features[i].name, m == 0 ? "here:  " : "100 km:");
            FreeParity(&parity);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(LayersAgree),
        cmocka_unit_test(QueriesAgree),
    };
    return cmocka_run_group_tests_name("flow: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
