// SPDX-License-Identifier: MIT
// Inputs by the public API and by the set behind it: shapes, blends and their derivatives, order, handles, what they do
// to waves, and what is refused.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/messages.h"
#include "support/scatter.h"

#include <math.h>
#include <string.h>

#include <seaway/seaway.h>

#include "core/input/sample_inputs.h"
#include "core/world/world.h"
#include "shared/input_shapes.h"

#define POINTS 256

// ---- worlds ----

static swWorld* MakeEmptyWorld(void)
{
    swHost host = MakeHost();
    swWorldDef def = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    return world;
}

static swWaveSystemId AddWaves(swWorld* world, bool isLocal)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 32;
    def.tileWaves = 8;
    def.isLocal = isLocal;
    def.seed = isLocal ? 7 : 1;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    return id;
}

static swInputDef MakeInput(swInputField field, swInputShape shape, float value)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = shape;
    def.value[0] = value;
    return def;
}

static swInputId Add(swWorld* world, const swInputDef* def)
{
    swInputId id;
    s_messages[0] = 0;
    if (swCreateInput(world, def, &id) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    return id;
}

static float LevelAt(const swWorld* world, double x, double z)
{
    float level;
    const swFieldSamples samples = {.level = &level};
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 1, &(swPosXZ){x, z}, &samples), 0);
    return level;
}

static float DepthAt(const swWorld* world, double x, double z)
{
    float depth;
    const swFieldSamples samples = {.depth = &depth};
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 1, &(swPosXZ){x, z}, &samples), 0);
    return depth;
}

static swRaster* MakeRaster(int width, int height, double x, double z, double spacing, int channels)
{
    static float values[64 * 64 * 4];
    uint32_t seed = 5;
    for (int i = 0; i < width * height * channels; ++i)
    {
        values[i] = (float)(-20.0 * NextPart(&seed) - 1.0);
    }
    swHost host = MakeHost();
    swRasterDef def = swDefaultRasterDef();
    def.width = width;
    def.height = height;
    def.x = x;
    def.z = z;
    def.spacingX = spacing;
    def.spacingZ = 1.5 * spacing;
    def.channels = channels;
    def.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    return raster;
}

// ---- shapes and blends ----

static void ShapesCoverWhatTheySay(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    swInputDef circle = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 2.0f);
    circle.position = (swPos){1000.0, 0.0, -300.0};
    circle.feather = 20.0f;
    Add(world, &circle);
    swInputDef box = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_RECTANGLE, 3.0f);
    box.position = (swPos){-500.0, 0.0, 0.0};
    box.size = (swVec3){200.0f, 0.0f, 20.0f};
    box.rotation.yaw = 0.5f * (float)SW_PI; // along z
    Add(world, &box);
    assert_float_equal(LevelAt(world, 1000.0, -300.0), 0.0f, 0.0f); // from the next step on
    swWorld_Step(world, 0.0);
    assert_float_equal(LevelAt(world, 1000.0, -300.0), 2.0f, 0.0f);
    assert_float_equal(LevelAt(world, 1029.0, -300.0), 2.0f, 0.0f);
    assert_float_equal(LevelAt(world, 1040.0, -300.0), 1.0f, 1e-5f); // in the middle of the feather
    assert_float_equal(LevelAt(world, 1050.1, -300.0), 0.0f, 0.0f);
    assert_float_equal(LevelAt(world, -500.0, 99.0), 3.0f, 0.0f);
    assert_float_equal(LevelAt(world, -500.0, 101.0), 0.0f, 0.0f);
    assert_float_equal(LevelAt(world, -489.0, 0.0), 0.0f, 0.0f);
    swDestroyWorld(world);
}

// Values near a point by central differences against the derivatives that are told.
static void CheckGradients(const swInputSet* set, int field, double x, double z, double reach, float tolerance)
{
    uint32_t seed = 11;
    for (int i = 0; i < POINTS; ++i)
    {
        const double step = 0.02;
        swPosXZ at = {x + reach * (2.0 * NextPart(&seed) - 1.0), z + reach * (2.0 * NextPart(&seed) - 1.0)};
        const swPosXZ points[5] = {
            at, {at.x + step, at.z}, {at.x - step, at.z}, {at.x, at.z + step}, {at.x, at.z - step}};
        swInputValue values[5];
        swFindInputValues(set, field, -1, 5, points, values);
        float alongX = (values[1].value.x - values[2].value.x) / (float)(2.0 * step);
        float alongZ = (values[3].value.x - values[4].value.x) / (float)(2.0 * step);
        // At a kink no derivative is right: look for one on either side.
        float left = (values[0].value.x - values[2].value.x) / (float)step;
        float north = (values[0].value.x - values[4].value.x) / (float)step;
        bool isKinked = fabsf(left - alongX) > 0.1f * (0.05f + fabsf(alongX)) ||
                        fabsf(north - alongZ) > 0.1f * (0.05f + fabsf(alongZ));
        if (!isKinked)
        {
            assert_float_equal(values[0].alongX.x, alongX, tolerance * (1.0f + fabsf(alongX)));
            assert_float_equal(values[0].alongZ.x, alongZ, tolerance * (1.0f + fabsf(alongZ)));
        }
    }
}

static void AnswerHills(void* context, double time, int count, const swPosXZ* points, swInputAnswer* answers)
{
    (void)context;
    for (int i = 0; i < count; ++i)
    {
        double x = points[i].x / 30.0, z = points[i].z / 40.0;
        answers[i].value[0] = (float)(5.0 * sin(x) * cos(z) + time);
        answers[i].valueAlongX[0] = (float)(5.0 * cos(x) * cos(z) / 30.0);
        answers[i].valueAlongZ[0] = (float)(-5.0 * sin(x) * sin(z) / 40.0);
        answers[i].share = 1.0f;
    }
}

static void DerivativesAreThoseOfTheValues(void** state)
{
    (void)state;
    const swInputShape shapes[] = {SW_SHAPE_CIRCLE,    SW_SHAPE_RECTANGLE, SW_SHAPE_RASTER,
                                   SW_SHAPE_PARTICLES, SW_SHAPE_FUNCTION,  SW_SHAPE_POLYGON};
    const swInputPoint corners[4] = {{-50.0f, -40.0f, 40.0f, 1.0f, {-3.0f}},
                                     {60.0f, -30.0f, 50.0f, 0.7f, {-9.0f}},
                                     {50.0f, 45.0f, 60.0f, 0.4f, {2.0f}},
                                     {-30.0f, 60.0f, 0.0f, 1.0f, {-1.0f}}};
    const swInputField fields[] = {SW_INPUT_LEVEL, SW_INPUT_FLOOR};
    swRaster* raster = MakeRaster(12, 9, -40.0, -50.0, 8.0, 1);
    for (int k = 0; k < 6 * 2 * SW_BLEND_COUNT; ++k)
    {
        swInputField field = fields[k % 2];
        swInputBlend blend = (swInputBlend)(k / 2 % SW_BLEND_COUNT);
        if (field == SW_INPUT_FLOOR && blend == SW_BLEND_MULTIPLY)
        {
            continue;
        }
        swWorld* world = MakeEmptyWorld();
        swInputDef below = MakeInput(field, SW_SHAPE_CIRCLE, -8.0f);
        below.size.x = 300.0f;
        below.feather = 140.0f;
        Add(world, &below);
        swInputDef def = MakeInput(field, shapes[k / 2 / SW_BLEND_COUNT], -12.0f);
        def.blend = blend;
        def.order = 1;
        def.feather = 30.0f;
        def.weight = 0.8f;
        def.rotation.yaw = 0.7f;
        def.raster = def.shape == SW_SHAPE_RASTER ? raster : NULL;
        def.function = def.shape == SW_SHAPE_FUNCTION ? AnswerHills : NULL;
        def.size = (swVec3){160.0f, 1.0f, 170.0f};
        bool hasPoints = def.shape == SW_SHAPE_PARTICLES || def.shape == SW_SHAPE_POLYGON;
        def.points = hasPoints ? corners : NULL;
        def.pointCount = hasPoints ? 4 : 0;
        def.value[0] = def.shape == SW_SHAPE_RASTER ? 0.0f : -12.0f;
        Add(world, &def);
        swWorld_Step(world, 0.0);
        CheckGradients(&world->inputs.arrays.set, (int)field, 0.0, 0.0, 90.0, 0.02f);
        swDestroyWorld(world);
    }
    swDestroyRaster(raster);
}

static void AFloorFadesIntoDeepWater(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    swInputDef shoal = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, -5.0f);
    shoal.size.x = 400.0f;
    shoal.feather = 100.0f;
    Add(world, &shoal);
    swWorld_Step(world, 0.0);
    assert_float_equal(DepthAt(world, 0.0, 0.0), 5.0f, 0.0f);
    assert_true(isinf(DepthAt(world, 201.0, 0.0)));
    float last = 5.0f;
    for (double x = 100.0; x < 200.0; x += 0.1)
    {
        float depth = DepthAt(world, x, 0.0);
        // The inverse, which waves feel, changes by little from one place to the next.
        assert_true(depth >= last && 1.0f / last - 1.0f / depth < 0.01f);
        last = depth;
    }
    assert_true(last > 1000.0f);
    swDestroyWorld(world);
}

static void InputsJoinInTheirOrder(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    swInputDef first = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_EVERYWHERE, 4.0f);
    swInputDef second = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 2.0f);
    second.blend = SW_BLEND_MULTIPLY;
    swInputId multiply = Add(world, &second); // made first, but
    second.order = 5;
    assert_int_equal(swInput_Set(world, multiply, &second), SW_SUCCESS);
    Add(world, &first);
    swInputDef third = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 1.0f);
    third.blend = SW_BLEND_ADD;
    third.order = 5; // as `second`, and made later
    Add(world, &third);
    swWorld_Step(world, 0.0);
    assert_float_equal(LevelAt(world, 0.0, 0.0), 4.0f * 2.0f + 1.0f, 0.0f);
    swInput_Enable(world, multiply, false);
    swWorld_Step(world, 0.0);
    assert_float_equal(LevelAt(world, 0.0, 0.0), 5.0f, 0.0f);
    swDestroyInput(world, multiply);
    assert_false(swInput_IsValid(world, multiply));
    swInputId again = Add(world, &second);
    assert_int_equal(again.index1, multiply.index1);
    assert_true(again.generation != multiply.generation && !swInput_IsValid(world, multiply));
    assert_int_equal(swWorld_GetInputCount(world), 3);
    swDestroyWorld(world);
}

static void RastersKeepTheirBitsFarOutToo(void** state)
{
    (void)state;
    const double places[2] = {0.0, 1024.0 * 1024.0};
    for (int k = 0; k < 2; ++k)
    {
        swWorld* world = MakeEmptyWorld();
        swRaster* raster = MakeRaster(33, 20, places[k] + 64.0, -places[k], 4.0, 1);
        swInputDef def = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_RASTER, 0.0f);
        def.raster = raster;
        Add(world, &def);
        swDestroyRaster(raster); // the input keeps it
        swWorld_Step(world, 0.0);
        for (int i = 0; i < 33 * 20; ++i)
        {
            const swPosXZ point = {places[k] + 64.0 + 4.0 * (i % 33), -places[k] + 6.0 * (i / 33)};
            float height, sampled;
            const swFieldSamples samples = {.floor = &height};
            assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 1, &point, &samples), 0);
            assert_float_equal(height, swRaster_GetValues(raster)[i], 0.0f);
            const swPosXZ between = {point.x + 1.25, point.z + 2.0};
            swMoment_QueryFields(swWorld_GetMoment(world), 1, &between, &samples);
            swRaster_Sample(raster, 1, &between, &sampled);
            assert_true(isnan(sampled) ? isinf(height) : fabsf(height - sampled) < 1e-4f);
        }
        swDestroyWorld(world);
    }
}

// A share of some millionths is as exact as that of a disc: it is not what is left of nearly 1.
static void AParticleCoversLittleAsExactlyAsMuch(void** state)
{
    (void)state;
    const float words[2 * SW_PARTICLE_WORDS] = {0.0f, 0.0f, 30.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f,
                                                0.0f, 9.0f, 1.0f,  1.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    swInputRecord record = {.cosine = 1.0f, .weight = 1.0f, .feather = 10.0f, .blend = SW_JOIN_ALPHA, .extra0 = 2};
    record.size.x = 60.0f; // of the circle
    for (float x = 29.0f; x < 30.0f; x += 0.0371f)
    {
        swInputSample particle = swSampleParticles(words, record, x, 0.0f);
        swInputSample circle = swSampleCircle(record, x, 0.0f);
        assert_true(particle.share == circle.share);
        assert_float_equal(particle.shareX, circle.shareX, 1e-6f * fabsf(circle.shareX));
    }
}

static void ParticlesAddUpOrCoverEachOther(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    swInputPoint points[3] = {{0.0f, 0.0f, 10.0f, 1.0f, {2.0f}}, {5.0f, 0.0f, 10.0f, 0.5f, {4.0f}}};
    swInputDef def = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_PARTICLES, 1.0f);
    def.blend = SW_BLEND_ADD;
    def.points = points;
    def.pointCount = 2;
    def.pointCapacity = 3;
    swInputId id = Add(world, &def);
    swWorld_Step(world, 0.0);
    assert_float_equal(LevelAt(world, -7.0, 0.0), 3.0f, 1e-6f);              // the first alone: 2 + 1
    assert_float_equal(LevelAt(world, 2.0, 0.0), 3.0f + 0.5f * 5.0f, 1e-5f); // both
    def.blend = SW_BLEND_ALPHA;
    assert_int_equal(swInput_Set(world, id, &def), SW_SUCCESS);
    swWorld_Step(world, 0.0);
    assert_float_equal(LevelAt(world, 2.0, 0.0), (3.0f + 0.5f * 5.0f) / 1.5f, 1e-5f); // their mean, wholly
    assert_float_equal(LevelAt(world, 12.0, 0.0), 2.5f, 1e-5f);
    points[2] = (swInputPoint){500.0f, 0.0f, 0.0f, 1.0f, {7.0f}}; // half of size.x wide
    assert_int_equal(swInput_SetPoints(world, id, 3, points), SW_SUCCESS);
    assert_float_equal(LevelAt(world, 500.0, 0.0), 0.0f, 0.0f);
    swWorld_Step(world, 0.0);
    assert_float_equal(LevelAt(world, 549.0, 0.0), 8.0f, 1e-5f);
    s_messages[0] = 0;
    points[1].x = NAN;
    assert_int_equal(swInput_SetPoints(world, id, 3, points), SW_ERROR_INVALID);
    assert_non_null(strstr(s_messages, "point 1"));
    assert_int_equal(swInput_SetPoints(world, id, 4, points), SW_ERROR_INVALID);
    swDestroyWorld(world);
}

static void AnswerNonsense(void* context, double time, int count, const swPosXZ* points, swInputAnswer* answers)
{
    (void)context;
    (void)time;
    for (int i = 0; i < count; ++i)
    {
        answers[i].share = points[i].z > 0.0 ? 7.0f : 1.0f;
        answers[i].value[0] = points[i].x > 0.0 ? NAN : 2.0f;
    }
}

static void AFunctionThatSaysNonsenseSaysNothing(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    swInputDef def = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_FUNCTION, 0.0f);
    def.function = AnswerNonsense;
    Add(world, &def);
    swWorld_Step(world, 0.0);
    assert_float_equal(LevelAt(world, -10.0, -10.0), 2.0f, 0.0f);
    assert_float_equal(LevelAt(world, 10.0, -10.0), 0.0f, 0.0f);
    assert_float_equal(LevelAt(world, -10.0, 10.0), 0.0f, 0.0f);
    assert_float_equal(LevelAt(world, -60.0, -10.0), 0.0f, 0.0f); // beyond its size
    // A block that another process may map cannot hold it.
    swMomentDef momentDef = swDefaultMomentDef();
    swMoment *moment = NULL, *map = NULL;
    assert_int_equal(swCreateMoment(world, &momentDef, &moment), SW_SUCCESS);
    size_t size;
    const void* memory = swMoment_GetMemory(moment, &size);
    swHost host = MakeHost();
    assert_int_equal(swMapMoment(&host, memory, size, &map), SW_ERROR_FORMAT);
    swDestroyMoment(moment);
    swDestroyWorld(world);
}

static void UnknownCellsAreNotCovered(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    const float values[6] = {1.0f, 2.0f, 3.0f, 4.0f, NAN, 6.0f};
    swHost host = MakeHost();
    swRasterDef rasterDef = swDefaultRasterDef();
    rasterDef.width = 3;
    rasterDef.height = 2;
    rasterDef.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &rasterDef, &raster), SW_SUCCESS);
    swInputDef def = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_RASTER, 0.0f);
    def.raster = raster;
    Add(world, &def);
    swDestroyRaster(raster);
    swWorld_Step(world, 0.0);
    assert_float_equal(LevelAt(world, 1.0, 0.0), 2.0f, 0.0f);
    assert_float_equal(LevelAt(world, 1.0, 1.0), 0.0f, 0.0f);
    assert_float_equal(LevelAt(world, 1.0, 0.5), 1.0f, 1e-6f); // half of 2
    swDestroyWorld(world);
}

// ---- the index ----

static void TheIndexFindsWhatALoopFinds(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    uint32_t seed = 17;
    for (int i = 0; i < 400; ++i)
    {
        swInputDef def = MakeInput(SW_INPUT_LEVEL, i % 40 == 0 ? SW_SHAPE_EVERYWHERE : SW_SHAPE_RECTANGLE, 1.0f + i);
        def.blend = i % 3 == 0 ? SW_BLEND_ADD : i % 3 == 1 ? SW_BLEND_ALPHA : SW_BLEND_MAX;
        def.order = (int)(10.0 * NextPart(&seed));
        def.position = (swPos){4000.0 * NextPart(&seed) - 2000.0, 0.0, 4000.0 * NextPart(&seed) - 2000.0};
        def.size = (swVec3){(float)(1.0 + 2000.0 * NextPart(&seed)), 0.0f, (float)(1.0 + 500.0 * NextPart(&seed))};
        def.rotation.yaw = (float)(6.0 * NextPart(&seed));
        def.feather = 10.0f;
        Add(world, &def);
    }
    swWorld_Step(world, 0.0);
    const swInputSet* set = &world->inputs.arrays.set;
    int found = 0;
    for (int i = 0; i < 2000; ++i)
    {
        swPosXZ point = {6000.0 * NextPart(&seed) - 3000.0, 6000.0 * NextPart(&seed) - 3000.0};
        swInputValue indexed, looped = swGetFieldBelow(SW_FIELD_OF_LEVEL);
        swFindInputValues(set, SW_INPUT_LEVEL, -1, 1, &point, &indexed);
        int32_t cellX, cellZ;
        float restX, restZ;
        swFindCell(point.x, &cellX, &restX);
        swFindCell(point.z, &cellZ, &restZ);
        for (int r = 0; r < set->recordCount; ++r)
        {
            looped = swBlendInput(set->records[r], looped,
                                  swSampleInput(set->words[r], set->records[r], cellX, cellZ, restX, restZ, 0.0f));
        }
        assert_memory_equal(&indexed, &looped, sizeof indexed);
        found += looped.value.x != 400.0f ? 1 : 0;
    }
    assert_true(found > 500);
    swDestroyWorld(world);
}

// ---- waves ----

static void QueryHeights(const swWorld* world, const swPosXZ* points, float* heights, swVec3* normals)
{
    swQueryDef def = swDefaultQueryDef();
    const swSurfaceSamples samples = {.height = heights, .normal = normals};
    swMoment_QuerySurface(swWorld_GetMoment(world), &def, POINTS, points, &samples, NULL);
}

static void WaterThatNoInputTouchesKeepsItsBits(void** state)
{
    (void)state;
    static swPosXZ points[POINTS];
    static float plain[POINTS], beside[POINTS];
    static swVec3 plainNormals[POINTS], besideNormals[POINTS];
    swWorld* world = MakeEmptyWorld();
    AddWaves(world, false);
    swWorld_Step(world, 3.0);
    ScatterPoints(points, POINTS, 0.0, 0.0, 400.0);
    QueryHeights(world, points, plain, plainNormals);
    swInputDef shoal = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, -2.0f);
    shoal.position.x = 5000.0;
    Add(world, &shoal);
    shoal.position.x = 250.0; // among the points
    shoal.size.x = 200.0f;
    swInputId near = Add(world, &shoal);
    swWorld_Step(world, 0.0);
    QueryHeights(world, points, beside, besideNormals);
    int same = 0;
    for (int i = 0; i < POINTS; ++i)
    {
        bool isSame = plain[i] == beside[i] && memcmp(&plainNormals[i], &besideNormals[i], sizeof(swVec3)) == 0;
        double distance = hypot(points[i].x - 250.0, points[i].z);
        assert_true(isSame || distance < 110.0);
        assert_true(!isSame || distance > 90.0);
        same += isSame ? 1 : 0;
    }
    assert_in_range(same, POINTS / 2, POINTS - 5);
    swDestroyInput(world, near);
    swWorld_Step(world, 0.0);
    QueryHeights(world, points, beside, besideNormals);
    assert_memory_equal(plain, beside, sizeof plain);
    swDestroyWorld(world);
}

static void LevelsLiftTheWaterAndTiltIt(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    swInputDef lake = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 10.0f);
    lake.size.x = 200.0f;
    lake.feather = 50.0f;
    Add(world, &lake);
    swWorld_Step(world, 0.0);
    static swPosXZ points[POINTS];
    static float heights[POINTS];
    static swVec3 normals[POINTS];
    ScatterPoints(points, POINTS, 0.0, 0.0, 110.0);
    QueryHeights(world, points, heights, normals);
    for (int i = 0; i < POINTS; ++i)
    {
        assert_float_equal(heights[i], LevelAt(world, points[i].x, points[i].z), 1e-5f);
        float slope =
            (LevelAt(world, points[i].x + 0.05, points[i].z) - LevelAt(world, points[i].x - 0.05, points[i].z)) / 0.1f;
        assert_float_equal(-normals[i].x / normals[i].y, slope, 0.002f);
    }
    swDestroyWorld(world);
}

static float MeasureHeight(const swWorld* world, double x, double z)
{
    static swPosXZ points[POINTS];
    static float heights[POINTS];
    static swVec3 normals[POINTS];
    ScatterPoints(points, POINTS, x, z, 30.0);
    QueryHeights(world, points, heights, normals);
    double sum = 0.0;
    for (int i = 0; i < POINTS; ++i)
    {
        sum += (double)heights[i] * (double)heights[i];
    }
    return (float)sqrt(sum / POINTS);
}

static void WavesEndWhereAnInputTakesTheirWeight(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    swWaveSystemId everywhere = AddWaves(world, false);
    swInputDef calm = MakeInput(SW_INPUT_WAVES, SW_SHAPE_CIRCLE, 0.0f);
    calm.system = everywhere;
    Add(world, &calm);
    swWorld_Step(world, 1.0);
    assert_true(MeasureHeight(world, 0.0, 0.0) < 1e-6f);
    assert_true(MeasureHeight(world, 1000.0, 0.0) > 0.1f);
    // A local system is the other way round.
    swWaveSystemId local = AddWaves(world, true);
    swInputDef patch = MakeInput(SW_INPUT_WAVES, SW_SHAPE_CIRCLE, 1.0f);
    patch.system = local;
    patch.position.x = 3000.0;
    Add(world, &patch);
    swDestroyWaveSystem(world, everywhere);
    swWorld_Step(world, 1.0);
    assert_true(MeasureHeight(world, 3000.0, 0.0) > 0.1f);
    assert_true(MeasureHeight(world, 0.0, 0.0) < 1e-6f); // its input weighs a system that is gone
    assert_true(MeasureHeight(world, 4000.0, 0.0) < 1e-6f);
    swDestroyWorld(world);
}

static void WavesDieOutOverAFloor(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    AddWaves(world, false);
    swInputDef beach = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, 1.0f);
    beach.position.x = 1000.0;
    Add(world, &beach);
    swInputDef shelf = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, -1.0f);
    shelf.position.x = 2000.0;
    Add(world, &shelf);
    swWorld_Step(world, 1.0);
    float deep = MeasureHeight(world, 0.0, 0.0);
    assert_true(MeasureHeight(world, 1000.0, 0.0) < 1e-6f); // on land
    float shallow = MeasureHeight(world, 2000.0, 0.0);
    assert_true(shallow > 0.05f * deep && shallow < 0.7f * deep);
    swDestroyWorld(world);
}

// Just below the surface the water moves as the surface does, however its place shapes it.
static void TheWaterBelowIsShapedAsItsSurfaceIs(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    AddWaves(world, false);
    swInputDef shelf = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, -1.0f);
    shelf.size.x = 400.0f;
    shelf.feather = 150.0f;
    Add(world, &shelf);
    swInputDef set = MakeInput(SW_INPUT_FLOW, SW_SHAPE_CIRCLE, 0.0f);
    set.position.x = 1000.0;
    set.value[1] = 1.5f;
    Add(world, &set);
    swWorld_Step(world, 1.0);
    const double places[4] = {0.0, 90.0, 150.0, 600.0};
    swQueryDef def = swDefaultQueryDef();
    for (int i = 0; i < 4; ++i)
    {
        const swPosXZ point = {places[i], 7.0};
        swVec3 above, below;
        float height;
        swMoment_QuerySurface(swWorld_GetMoment(world), &def, 1, &point, &(swSurfaceSamples){.height = &height}, NULL);
        // Waves there, looked up at the same place: not where the particle above it rests.
        swMoment_QueryParticles(swWorld_GetMoment(world), &def, 1, &point, &(swSurfaceSamples){.velocity = &above},
                                NULL, NULL);
        const swPos place = {point.x, (double)height - 1e-4, point.z};
        swMoment_QueryVolume(swWorld_GetMoment(world), &def, 1, &place, &(swVolumeSamples){.velocity = &below}, NULL);
        float speed = sqrtf(above.x * above.x + above.y * above.y + above.z * above.z);
        assert_float_equal(below.x, above.x, 0.01f * speed + 0.005f);
        assert_float_equal(below.y, above.y, 0.01f * speed + 0.005f);
        assert_float_equal(below.z, above.z, 0.01f * speed + 0.005f);
    }
    swPos deep = {1000.0, -2.0, 0.0};
    swVec3 below;
    swMoment_QueryVolume(swWorld_GetMoment(world), &def, 1, &deep, &(swVolumeSamples){.velocity = &below}, NULL);
    assert_float_equal(below.z, 1.5f, 0.6f); // the current, and waves on it
    swDestroyWorld(world);
}

// ---- places, origins and time ----

static void InputsStayWhereTheyAreWhenTheOriginMoves(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    swInputDef def = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 2.0f);
    def.position.x = 700.0;
    swInputId id = Add(world, &def);
    swWorld_Step(world, 0.0);
    swWorld_SetOrigin(world, (swPosXZ){4096.0, -128.0});
    assert_float_equal(LevelAt(world, 700.0 - 4096.0, 128.0), 2.0f, 0.0f);
    assert_true(swInput_Get(world, id).position.x == 700.0 - 4096.0);
    swInput_Move(world, id, (swPos){0.0, 0.0, 0.0}, (swAngles){0.0f, 0.0f, 0.0f});
    swWorld_Step(world, 0.0);
    assert_float_equal(LevelAt(world, 0.0, 0.0), 2.0f, 0.0f);
    swDestroyWorld(world);
}

static void SequencesOfRastersPlayAndLoop(void** state)
{
    (void)state;
    const float values[3 * 4] = {0.0f, 0.0f, 0.0f, 0.0f, 10.0f, 10.0f, 10.0f, 10.0f, 40.0f, 40.0f, 40.0f, 40.0f};
    swHost host = MakeHost();
    swRasterDef rasterDef = swDefaultRasterDef();
    rasterDef.width = rasterDef.height = 2;
    rasterDef.frames = 3;
    rasterDef.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &rasterDef, &raster), SW_SUCCESS);
    swWorld* world = MakeEmptyWorld();
    swInputDef def = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_RASTER, 0.0f);
    def.raster = raster;
    def.framesPerSecond = 2.0f;
    def.startTime = 1.0;
    swInputId id = Add(world, &def);
    const double times[] = {1.0, 1.25, 1.5, 2.0, 2.25, 2.5, 2.75, 0.5};
    const float looped[] = {0.0f, 5.0f, 10.0f, 40.0f, 20.0f, 0.0f, 5.0f, 40.0f};
    const float once[] = {0.0f, 5.0f, 10.0f, 40.0f, 40.0f, 40.0f, 40.0f, 0.0f};
    for (int loops = 1; loops >= 0; --loops)
    {
        def.loops = loops == 1;
        assert_int_equal(swInput_Set(world, id, &def), SW_SUCCESS);
        for (int i = 0; i < 8; ++i)
        {
            swWorld_StepTo(world, times[i]);
            assert_float_equal(LevelAt(world, 0.5, 0.5), loops == 1 ? looped[i] : once[i], 1e-5f);
        }
    }
    swDestroyRaster(raster);
    swDestroyWorld(world);
}

// One of each shape, among waves.
static void FillWorld(swWorld* world)
{
    swWaveSystemId waves = AddWaves(world, false);
    const float frames[2 * 9] = {-1.0f, -3.0f, -2.0f, -4.0f, -5.0f, -3.0f, -2.0f, -9.0f, -1.0f,
                                 -2.0f, -1.0f, -2.0f, -7.0f, -4.0f, -1.0f, -5.0f, -2.0f, -3.0f};
    swHost host = MakeHost();
    swRasterDef rasterDef = swDefaultRasterDef();
    rasterDef.width = rasterDef.height = 3;
    rasterDef.spacingX = rasterDef.spacingZ = 20.0;
    rasterDef.frames = 2;
    rasterDef.values = frames;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &rasterDef, &raster), SW_SUCCESS);
    swInputDef floor = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_RASTER, 0.0f);
    floor.raster = raster;
    floor.framesPerSecond = 0.7f;
    Add(world, &floor);
    swDestroyRaster(raster);
    swInputDef lake = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 3.0f);
    lake.feather = 30.0f;
    Add(world, &lake);
    swInputDef calm = MakeInput(SW_INPUT_WAVES, SW_SHAPE_RECTANGLE, 0.2f);
    calm.system = waves;
    calm.position.x = -40.0;
    calm.feather = 10.0f;
    Add(world, &calm);
}

static void MomentsHoldTheInputsOfTheirTime(void** state)
{
    (void)state;
    static swPosXZ points[POINTS];
    static float heights[POINTS], held[POINTS], mapped[POINTS];
    static swVec3 normals[POINTS];
    swWorld* world = MakeEmptyWorld();
    FillWorld(world); // no step yet
    swMomentDef def = swDefaultMomentDef();
    def.time = 2.3;
    swMoment *moment = NULL, *map = NULL;
    assert_int_equal(swCreateMoment(world, &def, &moment), SW_SUCCESS);
    size_t size;
    const void* memory = swMoment_GetMemory(moment, &size);
    assert_true(size <= swWorld_GetMomentSize(world));
    void* copy = aligned_alloc(64, (size + 63) / 64 * 64);
    memcpy(copy, memory, size);
    swWorld_StepTo(world, 2.3);
    ScatterPoints(points, POINTS, 20.0, 20.0, 150.0);
    QueryHeights(world, points, heights, normals);
    swDestroyWorld(world);
    swHost host = MakeHost();
    assert_int_equal(swMapMoment(&host, copy, size, &map), SW_SUCCESS);
    swQueryDef queryDef = swDefaultQueryDef();
    swMoment_QuerySurface(moment, &queryDef, POINTS, points, &(swSurfaceSamples){.height = held}, NULL);
    swMoment_QuerySurface(map, &queryDef, POINTS, points, &(swSurfaceSamples){.height = mapped}, NULL);
    assert_memory_equal(heights, held, sizeof heights);
    assert_memory_equal(heights, mapped, sizeof heights);
    swDestroyMoment(moment);
    swDestroyMoment(map);
    free(copy);
}

// ---- saving ----

static const swRaster* s_raster; // that the host still has

static bool FindResource(void* context, swResourceKind kind, uint64_t hash, const char* name, swResource* resource)
{
    (void)context;
    (void)name;
    resource->raster = s_raster;
    return kind == SW_RESOURCE_RASTER && s_raster != NULL && swRaster_GetInfo(s_raster).hash == hash;
}

static size_t Save(const swWorld* world, void* bytes, size_t room)
{
    size_t size = room;
    assert_int_equal(swWorld_Save(world, bytes, &size), SW_SUCCESS);
    return size;
}

static void SavedWorldsNameTheirRasters(void** state)
{
    (void)state;
    static uint8_t bytes[1 << 20], again[1 << 20];
    static swPosXZ points[POINTS];
    static float heights[POINTS], restoredHeights[POINTS];
    static swVec3 normals[POINTS];
    swWorld* world = MakeEmptyWorld();
    FillWorld(world);
    swInputId last = swWorld_GetInput(world, 2);
    swWorld_Step(world, 1.3);
    ScatterPoints(points, POINTS, 20.0, 20.0, 150.0);
    QueryHeights(world, points, heights, normals);
    size_t size = Save(world, bytes, sizeof bytes);
    s_raster = swInput_Get(world, swWorld_GetInput(world, 0)).raster;

    swHost host = MakeHost();
    swRestoreDef def = swDefaultRestoreDef();
    swWorld* restored = NULL;
    assert_int_equal(swRestoreWorld(&host, bytes, size, &def, &restored), SW_ERROR_UNSUPPORTED);
    assert_null(restored);
    assert_non_null(strstr(s_messages, "raster with the hash"));
    def.findResource = FindResource;
    assert_int_equal(swRestoreWorld(&host, bytes, size, &def, &restored), SW_SUCCESS);
    assert_true(swWorld_GetDigest(restored) == swWorld_GetDigest(world));
    assert_true(swInput_IsValid(restored, last));
    QueryHeights(restored, points, restoredHeights, normals);
    assert_memory_equal(heights, restoredHeights, sizeof heights);
    assert_int_equal(Save(restored, again, sizeof again), size);
    assert_memory_equal(bytes, again, size);

    // Each input has a part in the digest.
    uint64_t digest = swWorld_GetDigest(restored);
    for (int i = 0; i < swWorld_GetInputCount(restored); ++i)
    {
        swInputId id = swWorld_GetInput(restored, i);
        swInput_SetWeight(restored, id, 0.75f);
        assert_true(swWorld_GetDigest(restored) != digest);
        swInput_SetWeight(restored, id, 1.0f);
        assert_true(swWorld_GetDigest(restored) == digest);
    }
    swDestroyWorld(restored);
    swDestroyWorld(world);
}

static void AWorldGoesBackOverWhatMovedAndWasMade(void** state)
{
    (void)state;
    static uint8_t bytes[1 << 20];
    swWorld* world = MakeEmptyWorld();
    FillWorld(world);
    swWorld_Step(world, 1.0);
    size_t size = Save(world, bytes, sizeof bytes);
    uint64_t digest = swWorld_GetDigest(world);
    swInputId lake = swWorld_GetInput(world, 1);
    assert_float_equal(LevelAt(world, 0.0, 0.0), 3.0f, 0.0f);
    swInput_Move(world, lake, (swPos){500.0, 0.0, 0.0}, (swAngles){1.0f, 0.0f, 0.0f});
    swInput_SetWeight(world, lake, 0.5f);
    swInputDef more = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_EVERYWHERE, 9.0f);
    swInputId made = Add(world, &more);
    swWorld_Step(world, 1.0);
    assert_float_equal(LevelAt(world, 0.0, 0.0), 9.0f, 0.0f);
    assert_int_equal(swWorld_Rewind(world, bytes, size), SW_SUCCESS);
    assert_false(swInput_IsValid(world, made));
    assert_float_equal(LevelAt(world, 0.0, 0.0), 3.0f, 0.0f);
    assert_true(swWorld_GetDigest(world) == digest);
    // Not over what was destroyed; then nothing changes.
    swDestroyInput(world, lake);
    swWorld_Step(world, 1.0);
    digest = swWorld_GetDigest(world);
    assert_int_equal(swWorld_Rewind(world, bytes, size), SW_ERROR_UNSUPPORTED);
    assert_true(swWorld_GetDigest(world) == digest);
    swDestroyWorld(world);
}

static void AWarmStepAllocatesNothing(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swInputId ids[100];
    swInputDef def = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 1.0f);
    for (int i = 0; i < 100; ++i)
    {
        def.position.x = 300.0 * i;
        assert_int_equal(swCreateInput(world, &def, &ids[i]), SW_SUCCESS);
    }
    long long before = atomic_load(&memory.allocations);
    for (int step = 0; step < 5; ++step)
    {
        for (int i = 0; i < 100; ++i)
        {
            swInput_Move(world, ids[i], (swPos){300.0 * i, 0.0, 10.0 * step}, (swAngles){0.1f * (float)i, 0.0f, 0.0f});
            swInput_Enable(world, ids[i], (i + step) % 3 != 0);
        }
        swWorld_Step(world, 0.1);
    }
    assert_int_equal(atomic_load(&memory.allocations), before);
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void EveryAllocationMayFail(void** state)
{
    (void)state;
    CountingMemory memory;
    for (long long failAt = 0; failAt < 400; ++failAt)
    {
        swHost host = MakeCountingHost(&memory);
        swWorldDef worldDef = swDefaultWorldDef();
        swWorld* world = NULL;
        assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
        atomic_store(&memory.failAt, atomic_load(&memory.allocations) + failAt);
        swInputDef def = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 1.0f);
        int made = 0;
        bool hasFailed = false;
        for (int i = 0; i < 40; ++i)
        {
            swInputId id;
            swResult result = swCreateInput(world, &def, &id);
            assert_true(result == SW_SUCCESS || (result == SW_ERROR_NO_MEMORY && SW_IS_NULL(id)));
            made += result == SW_SUCCESS ? 1 : 0;
            hasFailed = hasFailed || result != SW_SUCCESS;
        }
        assert_int_equal(swWorld_GetInputCount(world), made);
        swWorld_Step(world, 0.0);
        swDestroyWorld(world);
        assert_int_equal(atomic_load(&memory.bytes), 0);
        if (!hasFailed)
        {
            print_message("%lld allocations failed once each\n", failAt);
            return;
        }
    }
    fail();
}

// ---- what is refused ----

static void CheckRefused(swWorld* world, const swInputDef* def, swResult expected, const char* says)
{
    swInputId id = {1, 1};
    s_messages[0] = 0;
    assert_int_equal(swCreateInput(world, def, &id), expected);
    assert_true(SW_IS_NULL(id));
    if (strstr(s_messages, says) == NULL)
    {
        fail_msg("'%s' does not say '%s'", s_messages, says);
    }
}

static void WhatCannotBeIsRefusedInASentence(void** state)
{
    (void)state;
    swWorld* world = MakeEmptyWorld();
    swInputDef def = MakeInput(SW_INPUT_FLOW, SW_SHAPE_EVERYWHERE, 1e6f);
    strcpy(def.name, "gulf stream");
    CheckRefused(world, &def, SW_ERROR_INVALID, "gulf stream");
    def.value[0] = NAN;
    CheckRefused(world, &def, SW_ERROR_INVALID, "value");
    def = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, 0.0f);
    def.feather = NAN;
    CheckRefused(world, &def, SW_ERROR_INVALID, "feather");
    def = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_RECTANGLE, 0.0f);
    def.size.z = 0.0f;
    CheckRefused(world, &def, SW_ERROR_INVALID, "extent");
    def = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_RASTER, 0.0f);
    CheckRefused(world, &def, SW_ERROR_INVALID, "no raster");
    swRaster* raster = MakeRaster(4, 4, 0.0, 0.0, 1.0, 1);
    def.field = SW_INPUT_FLOW;
    def.raster = raster;
    CheckRefused(world, &def, SW_ERROR_INVALID, "1 channels");
    swDestroyRaster(raster);
    def = MakeInput(SW_INPUT_WAVES, SW_SHAPE_CIRCLE, 0.0f);
    swWaveSystemId gone = AddWaves(world, false);
    swDestroyWaveSystem(world, gone);
    def.system = gone;
    CheckRefused(world, &def, SW_ERROR_INVALID, "not there");
    def = MakeInput(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 1.0f);
    def.weight = 2.0f;
    CheckRefused(world, &def, SW_ERROR_INVALID, "weight");
    def = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, 1.0f);
    def.blend = SW_BLEND_MULTIPLY;
    CheckRefused(world, &def, SW_ERROR_UNSUPPORTED, "multiplies");
    def = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, 1.0f);
    def.followsWaves = true;
    CheckRefused(world, &def, SW_ERROR_UNSUPPORTED, "follows");
    assert_int_equal(swWorld_GetInputCount(world), 0);
    swDestroyWorld(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ShapesCoverWhatTheySay),
        cmocka_unit_test(DerivativesAreThoseOfTheValues),
        cmocka_unit_test(AFloorFadesIntoDeepWater),
        cmocka_unit_test(InputsJoinInTheirOrder),
        cmocka_unit_test(RastersKeepTheirBitsFarOutToo),
        cmocka_unit_test(AParticleCoversLittleAsExactlyAsMuch),
        cmocka_unit_test(ParticlesAddUpOrCoverEachOther),
        cmocka_unit_test(AFunctionThatSaysNonsenseSaysNothing),
        cmocka_unit_test(UnknownCellsAreNotCovered),
        cmocka_unit_test(TheIndexFindsWhatALoopFinds),
        cmocka_unit_test(WaterThatNoInputTouchesKeepsItsBits),
        cmocka_unit_test(LevelsLiftTheWaterAndTiltIt),
        cmocka_unit_test(WavesEndWhereAnInputTakesTheirWeight),
        cmocka_unit_test(WavesDieOutOverAFloor),
        cmocka_unit_test(TheWaterBelowIsShapedAsItsSurfaceIs),
        cmocka_unit_test(InputsStayWhereTheyAreWhenTheOriginMoves),
        cmocka_unit_test(SequencesOfRastersPlayAndLoop),
        cmocka_unit_test(MomentsHoldTheInputsOfTheirTime),
        cmocka_unit_test(SavedWorldsNameTheirRasters),
        cmocka_unit_test(AWorldGoesBackOverWhatMovedAndWasMade),
        cmocka_unit_test(AWarmStepAllocatesNothing),
        cmocka_unit_test(EveryAllocationMayFail),
        cmocka_unit_test(WhatCannotBeIsRefusedInASentence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
