// SPDX-License-Identifier: MIT
// Inputs that make the water flow and inputs that displace it do the same on both halves: layers texel by texel,
// queries and rays point by point, around the origin and 100 km away. All kinds are in one world, each at a spot of
// its own, so that the error of each is seen.

#include "parity/parity.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_OFF_M 1e-3
#define SLOPE 1e-3      // of the flow, in half floats
#define DERIVATIVE 5e-3 // likewise; steeper where the edge of an input is
#define POINTS 500
#define TOLERANCE 1e-4f // m
#define BETWEEN 2560.0  // m from spot to spot

// ---- inputs ----

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

static swInputDef MakeInput(swInputField field, swInputShape shape, swPosXZ middle, float size)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = shape;
    def.position = (swPos){middle.x, 0.0, middle.z};
    def.size = (swVec3){size, 10.0f, 0.7f * size};
    def.feather = 0.2f * size;
    return def;
}

static void AddStreamOf(Parity* parity, swPosXZ middle, float x, float z)
{
    swInputDef def = MakeInput(SW_INPUT_FLOW, SW_SHAPE_RECTANGLE, middle, 160.0f);
    def.rotation.yaw = 0.4f;
    def.value[0] = x;
    def.value[1] = z;
    AddInput(parity, &def);
}

static void AddSlowStream(Parity* parity, swPosXZ middle)
{
    AddStreamOf(parity, middle, 0.02f, -0.01f);
}

static void AddStream(Parity* parity, swPosXZ middle)
{
    AddStreamOf(parity, middle, 2.0f, -0.5f);
}

// A map of values, `channels` to a cell.
static swRaster* MakeMap(swPosXZ middle, int side, int channels, const float* values)
{
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = side;
    def.channels = channels;
    def.spacingX = def.spacingZ = 160.0 / (side - 1);
    def.x = middle.x - 80.0;
    def.z = middle.z - 80.0;
    def.values = values;
    swRaster* raster = NULL;
    swHost host = swDefaultHost();
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    return raster;
}

static void AddEddy(Parity* parity, swPosXZ middle)
{
    static float values[33 * 33][2];
    for (int i = 0; i < 33 * 33; ++i)
    {
        double x = (i % 33 - 16) / 16.0, z = ((double)(i / 33) - 16.0) / 16.0, fall = exp(-3.0 * (x * x + z * z));
        values[i][0] = (float)(-6.0 * z * fall);
        values[i][1] = (float)(6.0 * x * fall);
    }
    swInputDef def = MakeInput(SW_INPUT_FLOW, SW_SHAPE_RASTER, (swPosXZ){0.0, 0.0}, 1.0f);
    swRaster* map = MakeMap(middle, 33, 2, values[0]);
    def.raster = map;
    def.feather = 30.0f;
    AddInput(parity, &def);
    swDestroyRaster(map);
}

// Over a shoal, which takes some of the waves away.
static void AddShoal(Parity* parity, swPosXZ middle)
{
    swInputDef def = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, middle, 150.0f);
    def.value[0] = -4.0f;
    AddInput(parity, &def);
    AddEddy(parity, middle);
}

static swWaveSystemId freeWaves;

// Free waves that are there alone, in a stream.
static void AddFreeWaves(Parity* parity, swPosXZ middle)
{
    swInputDef def = MakeInput(SW_INPUT_WAVES, SW_SHAPE_CIRCLE, middle, 180.0f);
    def.system = freeWaves;
    def.value[0] = 1.0f;
    AddInput(parity, &def);
    AddStream(parity, middle);
}

static swInputDef MakePush(swInputShape shape, swInputBlend blend, swPosXZ middle, float size, float y)
{
    swInputDef def = MakeInput(SW_INPUT_DISPLACEMENT, shape, middle, size);
    def.blend = blend;
    def.value[1] = y;
    return def;
}

static void AddHullPush(Parity* parity, swPosXZ middle)
{
    swInputDef level = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, middle, 150.0f);
    level.value[0] = 1.5f;
    AddInput(parity, &level);
    swInputDef def = MakePush(SW_SHAPE_RECTANGLE, SW_BLEND_MIN, middle, 60.0f, 0.0f);
    def.feather = 6.0f;
    def.position.y = 1.2;
    AddInput(parity, &def);
}

static void AddWaveParticles(Parity* parity, swPosXZ middle)
{
    const swInputPoint particles[] = {{-30.0f, -20.0f, 30.0f, 1.0f, {0.0f, 0.7f, 0.0f}},
                                      {10.0f, -25.0f, 50.0f, 0.7f, {0.4f, -0.5f, 0.2f}},
                                      {20.0f, 10.0f, 40.0f, 0.9f, {0.0f, 1.0f, 0.3f}}};
    swInputDef def = MakePush(SW_SHAPE_PARTICLES, SW_BLEND_ADD, middle, 60.0f, 0.0f);
    def.isBump = true;
    def.rotation.yaw = 0.7f;
    def.points = particles;
    def.pointCount = 3;
    def.followsWaves = true;
    AddInput(parity, &def);
}

// Waves that are lower, and then a hump that stays put.
static void AddCalm(Parity* parity, swPosXZ middle)
{
    swInputDef def = MakePush(SW_SHAPE_CIRCLE, SW_BLEND_MULTIPLY, middle, 120.0f, 0.3f);
    def.value[0] = def.value[2] = 0.3f;
    def.followsWaves = true;
    AddInput(parity, &def);
    def = MakePush(SW_SHAPE_CIRCLE, SW_BLEND_ADD, (swPosXZ){middle.x + 40.0, middle.z}, 50.0f, 0.8f);
    def.isBump = true;
    AddInput(parity, &def);
}

static void AddSetHeight(Parity* parity, swPosXZ middle)
{
    swInputDef def = MakePush(SW_SHAPE_CIRCLE, SW_BLEND_ALPHA, middle, 100.0f, 0.25f);
    AddInput(parity, &def);
    def.followsWaves = true;
    def.position.x += 70.0;
    def.weight = 0.6f;
    AddInput(parity, &def);
}

// Baked waves of 12 m: slices of longer waves leave them out.
static void AddBakedWaves(Parity* parity, swPosXZ middle)
{
    static float values[65 * 65][3];
    for (int i = 0; i < 65 * 65; ++i)
    {
        double phase = 2.0 * 3.14159265 * (2.5 * (i % 65) + 1.0 * (double)(i / 65)) / 12.0;
        values[i][0] = (float)(-0.3 * sin(phase));
        values[i][1] = (float)(0.3 * cos(phase));
        values[i][2] = (float)(-0.1 * sin(phase));
    }
    swInputDef def = MakeInput(SW_INPUT_DISPLACEMENT, SW_SHAPE_RASTER, (swPosXZ){0.0, 0.0}, 1.0f);
    swRaster* map = MakeMap(middle, 65, 3, values[0]);
    def.raster = map;
    def.feather = 30.0f;
    def.blend = SW_BLEND_ADD;
    def.followsWaves = true;
    def.wavelength = 12.0f;
    AddInput(parity, &def);
    swDestroyRaster(map);
}

static void AddAll(Parity* parity, swPosXZ middle)
{
    AddFreeWaves(parity, middle);
    AddWaveParticles(parity, middle);
    AddHullPush(parity, middle);
}

static const Feature features[] = {
    {"a stream of 0.02 m/s", AddSlowStream},
    {"a stream of 2 m/s", AddStream},
    {"an eddy by a map", AddEddy},
    {"an eddy over a shoal", AddShoal},
    {"free waves in a stream", AddFreeWaves},
    {"a push under a hull", AddHullPush},
    {"wave particles", AddWaveParticles},
    {"calmed waves, a hump", AddCalm},
    {"heights that are set", AddSetHeight},
    {"baked waves", AddBakedWaves},
    {"free waves, all of it", AddAll},
};
#define FEATURES (int)(sizeof(features) / sizeof(features[0]))
#define SPOTS (2 * FEATURES)

static swPosXZ GetSpot(int i)
{
    double along = BETWEEN * (i / 2) + 20.0;
    return i % 2 == 0 ? (swPosXZ){along, -30.0} : (swPosXZ){1e5 + 17.3 + along, -1e5 - 40.6};
}

static const char* GetName(int i)
{
    return i % 2 == 0 ? features[i / 2].name : "  100 km away";
}

static Parity MakeSea(void** state, bool enableQueries)
{
    swWorldDef def = swDefaultWorldDef();
    def.enableQueries = enableQueries;
    def.enableVelocity = def.enableAcceleration = enableQueries; // as the device has them, from texels
    Parity parity = MakeParityOf(state, &def);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    AddParitySea(&parity, &sea);
    return parity;
}

// A tidal stream in which all of it is: it carries the waves by its path, and the other flows only beside it.
static void AddTidalStream(Parity* parity)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_FLOW;
    def.shape = SW_SHAPE_EVERYWHERE;
    def.order = -1;
    def.value[0] = 1.7f;
    def.value[1] = -0.6f;
    def.tide[0] = (swTideConstituent){
        .speed = 0.05f, .amplitude = 0.9f, .phase = 0.4f, .amplitudeAcross = 0.3f, .phaseAcross = 2.0f};
    AddInput(parity, &def);
}

static Parity MakeWater(void** state)
{
    Parity parity = MakeSea(state, true);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.method = SW_WAVES_GERSTNER;
    sea.seed = 5;
    sea.isLocal = true;
    assert_int_equal(swCreateWaveSystem(parity.world, &sea, &freeWaves), SW_SUCCESS);
    for (int i = 0; i < SPOTS; ++i)
    {
        features[i / 2].add(&parity, GetSpot(i));
    }
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
        const float* cpu =
            layer == SW_LAYER_FLOW ? swView_GetFlow(parity->view, slice) : swView_GetFlowSlopes(parity->view, slice);
        assert_non_null(cpu);
        assert_int_equal(swGpuWorld_ReadLayer(parity->gpuWorld, parity->view, layer, slice, gpu), SW_SUCCESS);
        difference = MaxDifference(difference, Compare(cpu, gpu, count, 4, 4));
    }
    free(gpu);
    return difference;
}

static void CompareLayers(void** state, bool isTidal)
{
    Parity parity = MakeWater(state);
    if (isTidal)
    {
        AddTidalStream(&parity);
    }
    AddParityView(&parity, 4, 64, (swPos){0.0, 8.0, 0.0});
    int wrong = 0;
    for (int i = isTidal ? 2 : 0; i < (isTidal ? 6 : SPOTS); ++i) // in the tide a stream and an eddy do
    {
        swPosXZ spot = GetSpot(i);
        swView_SetViewpoint(parity.view, (swPos){spot.x, 8.0, spot.z});
        StepParity(&parity, 1.3);
        Difference displacement = CompareLayer(&parity, SW_LAYER_DISPLACEMENT);
        Difference derivatives = CompareLayer(&parity, SW_LAYER_DERIVATIVES);
        Difference flow = CompareFlow(&parity, SW_LAYER_FLOW);
        Difference slopes = CompareFlow(&parity, SW_LAYER_FLOW_SLOPES);
        bool isRight = displacement.worst < MOST_OFF_M && derivatives.worst < DERIVATIVE && flow.worst < MOST_OFF_M &&
                       slopes.worst < SLOPE;
        wrong += isRight ? 0 : 1;
        printf("  %-24s displacement %.2g m, derivatives %.2g, flow %.2g of %.2g m/s, slopes %.2g of %.2g 1/s%s\n",
               GetName(i), displacement.worst, derivatives.worst, flow.worst, flow.scale, slopes.worst, slopes.scale,
               isRight ? "" : ": WRONG");
    }
    FreeParity(&parity);
    assert_int_equal(wrong, 0);
}

static void LayersAgree(void** state)
{
    CompareLayers(state, false);
}

static void LayersAgreeInATidalStream(void** state)
{
    CompareLayers(state, true);
}

// ---- queries ----

static swPosXZ points[SPOTS * POINTS];
static float gpuHeight[SPOTS * POINTS], cpuHeight[SPOTS * POINTS];
static float gpuResidual[SPOTS * POINTS], cpuResidual[SPOTS * POINTS];
static swVec3 gpuNormal[SPOTS * POINTS], cpuNormal[SPOTS * POINTS];
static swVec3 gpuWay[SPOTS * POINTS], cpuWay[SPOTS * POINTS];
static swVec3 gpuVelocity[SPOTS * POINTS], cpuVelocity[SPOTS * POINTS];
static swVec3 gpuAcceleration[SPOTS * POINTS], cpuAcceleration[SPOTS * POINTS];

static const swSurfaceSamples gpuSamples = {.height = gpuHeight,
                                            .normal = gpuNormal,
                                            .displacement = gpuWay,
                                            .residual = gpuResidual,
                                            .velocity = gpuVelocity,
                                            .acceleration = gpuAcceleration};
static const swSurfaceSamples cpuSamples = {.height = cpuHeight,
                                            .normal = cpuNormal,
                                            .displacement = cpuWay,
                                            .residual = cpuResidual,
                                            .velocity = cpuVelocity,
                                            .acceleration = cpuAcceleration};

static double Apart(swVec3 a, swVec3 b)
{
    return sqrt(pow((double)(a.x - b.x), 2.0) + pow((double)(a.y - b.y), 2.0) + pow((double)(a.z - b.z), 2.0));
}

// Of the particles that both halves found at a spot; few points have another one.
static bool CompareQueries(int spot)
{
    int others = 0;
    double height = 0.0, normal = 0.0, velocity = 0.0, acceleration = 0.0;
    for (int i = spot * POINTS; i < (spot + 1) * POINTS; ++i)
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
    // All but heights are of particles a residual apart.
    bool isRight =
        height < MOST_OFF_M && normal < 0.02 && velocity < 0.01 && acceleration < 0.1 && others <= POINTS / 500;
    printf("  %-24s heights %.2g m, normals %.2g, velocities %.2g m/s, accelerations %.2g m/s2; %d of %d have "
           "another particle%s\n",
           GetName(spot), height, normal, velocity, acceleration, others, POINTS, isRight ? "" : ": WRONG");
    return isRight;
}

static void CompareAllQueries(void** state, bool isTidal)
{
    Parity parity = MakeWater(state);
    if (isTidal)
    {
        AddTidalStream(&parity);
    }
    swGpuQueryDef gpuDef = swDefaultGpuQueryDef();
    gpuDef.capacity = SPOTS * POINTS;
    gpuDef.tolerance = TOLERANCE;
    gpuDef.outputs = SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL | SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &gpuDef, &query), SW_SUCCESS);
    for (int i = 0; i < SPOTS; ++i)
    {
        ScatterPoints(points + i * POINTS, POINTS, GetSpot(i).x, GetSpot(i).z, 100.0);
    }
    swGpuQuery_SetPoints(query, SPOTS * POINTS, points);
    StepParity(&parity, 0.7);
    swGpuQueryResults results;
    swGpu_SetFinishedFrame(parity.gpu, parity.gpu->frameIndex);
    assert_true(swGpuQuery_GetResults(query, &results));
    swGpuQueryResults_Unpack(&results, &gpuSamples, NULL);
    swQueryDef def = swDefaultQueryDef();
    def.tolerance = TOLERANCE;
    swMoment_QuerySurface(swWorld_GetMoment(parity.world), &def, SPOTS * POINTS, points, &cpuSamples, NULL);
    int wrong = 0;
    for (int i = 0; i < SPOTS; ++i)
    {
        wrong += CompareQueries(i) ? 0 : 1;
    }
    swDestroyGpuQuery(query);
    FreeParity(&parity);
    assert_int_equal(wrong, 0);
}

static void QueriesAgree(void** state)
{
    CompareAllQueries(state, false);
}

static void QueriesAgreeInATidalStream(void** state)
{
    CompareAllQueries(state, true);
}

static void AskHeights(Parity* parity, float* heights)
{
    swGpuQueryDef def = swDefaultGpuQueryDef();
    def.capacity = POINTS;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity->gpuWorld, &def, &query), SW_SUCCESS);
    swGpuQuery_SetPoints(query, POINTS, points);
    StepParity(parity, 2.7);
    swGpuQueryResults results;
    swGpu_SetFinishedFrame(parity->gpu, parity->gpu->frameIndex);
    assert_true(swGpuQuery_GetResults(query, &results));
    const swSurfaceSamples samples = {.height = heights};
    swGpuQueryResults_Unpack(&results, &samples, NULL);
    swDestroyGpuQuery(query);
}

// What the copies are divided by comes from the core, which makes it also where it answers nothing itself.
static void AWorldWithoutQueriesOfItsOwnCarriesWavesToo(void** state)
{
    ScatterPoints(points, POINTS, 0.0, 0.0, 60.0);
    float* heights[] = {gpuHeight, cpuHeight};
    for (int i = 0; i < 2; ++i)
    {
        Parity parity = MakeSea(state, i == 0);
        AddStream(&parity, (swPosXZ){0.0, 0.0});
        AskHeights(&parity, heights[i]);
        FreeParity(&parity);
    }
    for (int i = 0; i < POINTS; ++i)
    {
        assert_true(gpuHeight[i] == cpuHeight[i]);
    }
}

// ---- rays ----

#define RAYS 30
static swRay rays[SPOTS * RAYS];
static swRayHit gpuHits[SPOTS * RAYS], cpuHits[SPOTS * RAYS];

static void RaysAgree(void** state)
{
    Parity parity = MakeWater(state);
    swGpuQueryDef gpuDef = swDefaultGpuQueryDef();
    gpuDef.kind = SW_GPU_QUERY_KIND_RAYS;
    gpuDef.capacity = SPOTS * RAYS;
    gpuDef.outputs = SW_GPU_QUERY_NORMAL;
    swGpuQuery* query = NULL;
    assert_int_equal(swCreateGpuQuery(parity.gpuWorld, &gpuDef, &query), SW_SUCCESS);
    for (int i = 0; i < SPOTS; ++i)
    {
        ScatterPoints(points, RAYS, GetSpot(i).x, GetSpot(i).z, 60.0);
        for (int k = 0; k < RAYS; ++k)
        {
            rays[i * RAYS + k] = swDefaultRay((swPos){points[k].x, 12.0, points[k].z}, (swVec3){0.4f, -1.0f, 0.3f});
        }
    }
    swGpuQuery_SetRays(query, SPOTS * RAYS, rays);
    StepParity(&parity, 0.7);
    swGpuQueryResults results;
    swGpu_SetFinishedFrame(parity.gpu, parity.gpu->frameIndex);
    assert_true(swGpuQuery_GetResults(query, &results));
    swGpuQueryResults_UnpackHits(&results, rays, gpuHits, NULL);
    swQueryDef def = swDefaultQueryDef();
    swMoment_CastRays(swWorld_GetMoment(parity.world), &def, SPOTS * RAYS, rays, cpuHits, NULL);
    int wrong = 0;
    for (int i = 0; i < SPOTS; ++i)
    {
        double worst = 0.0;
        for (int k = i * RAYS; k < (i + 1) * RAYS; ++k)
        {
            worst = fmax(worst, fabs((double)gpuHits[k].distance - (double)cpuHits[k].distance));
        }
        bool isRight = worst < 3e-3; // twice the tolerance, by the slope
        wrong += isRight ? 0 : 1;
        printf("  %-24s rays %.2g m%s\n", GetName(i), worst, isRight ? "" : ": WRONG");
    }
    swDestroyGpuQuery(query);
    FreeParity(&parity);
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(LayersAgree),  cmocka_unit_test(LayersAgreeInATidalStream),
        cmocka_unit_test(QueriesAgree), cmocka_unit_test(QueriesAgreeInATidalStream),
        cmocka_unit_test(RaysAgree),    cmocka_unit_test(AWorldWithoutQueriesOfItsOwnCarriesWavesToo),
    };
    return cmocka_run_group_tests_name("flow and displacement: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
