// SPDX-License-Identifier: MIT
// What a host may get wrong when it puts something into the sea: each is refused in one sentence that names the thing
// and says what would be right, and leaves nothing behind.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/messages.h"
#include "support/saved.h"

#include <math.h>
#include <stdio.h>

#include <seaway/seaway.h>

static CountingMemory s_memory;

static swHost MakeStrictHost(void)
{
    swHost host = MakeCountingHost(&s_memory);
    host.log = KeepMessages;
    s_messages[0] = '\0';
    return host;
}

static int CountLines(void)
{
    int count = 0;
    for (const char* at = s_messages; *at != '\0'; ++at)
    {
        count += *at == '\n' ? 1 : 0;
    }
    return count;
}

// One sentence was told since the last time, which has both words.
static void AssertSentence(const char* name, const char* remedy)
{
    if (CountLines() != 1 || strstr(s_messages, name) == NULL || strstr(s_messages, remedy) == NULL)
    {
        fail_msg("not one sentence with '%s' and '%s':\n%s", name, remedy, s_messages);
    }
    s_messages[0] = '\0';
}

static swWorld* MakeWorld(const swHost* host)
{
    swWorldDef def = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(host, &def, &world), SW_SUCCESS);
    return world;
}

static swInputDef MakeNamed(swInputField field, swInputShape shape)
{
    swInputDef def = swDefaultInputDef();
    snprintf(def.name, sizeof def.name, "the culprit");
    def.field = field;
    def.shape = shape;
    return def;
}

// The world is as it was before, to the byte.
static void RefuseInput(swWorld* world, const swInputDef* def, const char* remedy)
{
    long long bytes = atomic_load(&s_memory.bytes);
    int count = swWorld_GetInputCount(world);
    uint64_t digest = swWorld_GetDigest(world);
    swInputId id = {7, 7};
    s_messages[0] = '\0';
    assert_int_not_equal(swCreateInput(world, def, &id), SW_SUCCESS);
    assert_true(SW_IS_NULL(id));
    assert_int_equal(swWorld_GetInputCount(world), count);
    assert_true(atomic_load(&s_memory.bytes) == bytes);
    swWorld_Step(world, 0.0);
    assert_true(swWorld_GetDigest(world) == digest);
    AssertSentence(def->field == SW_INPUT_FIELD_COUNT ? "field" : "", remedy);
}

// ---- numbers ----

static void NumbersOutOfRangeAreNamedWithTheirRange(void** state)
{
    (void)state;
    swHost host = MakeStrictHost();
    swWorld* world = MakeWorld(&host);
    swWorld_Step(world, 1.0);
    const float odd[] = {-1.0f, 1e30f, NAN, INFINITY};
    for (int i = 0; i < 4; ++i)
    {
        swInputDef def = MakeNamed(SW_INPUT_FOAM, SW_SHAPE_CIRCLE);
        def.weight = odd[i];
        RefuseInput(world, &def, "weight");
        def = MakeNamed(SW_INPUT_FOAM, SW_SHAPE_CIRCLE);
        def.size.x = odd[i];
        RefuseInput(world, &def, "size");
        def = MakeNamed(SW_INPUT_FOAM, SW_SHAPE_CIRCLE);
        def.feather = odd[i];
        RefuseInput(world, &def, "feather");
        def = MakeNamed(SW_INPUT_FOAM, SW_SHAPE_CIRCLE);
        def.position.z = i == 0 ? 1.1e9 : (double)odd[i];
        RefuseInput(world, &def, "position");
        def = MakeNamed(SW_INPUT_LEVEL, SW_SHAPE_EVERYWHERE);
        def.value[0] = i == 0 ? 1.1e6f : odd[i];
        RefuseInput(world, &def, "value");
    }
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&s_memory.bytes), 0);
}

// A circle of 1e-30 m lies nowhere, one at the end of the world answers there, and both leave other water alone.
static void TheSmallestAndTheFarthestDoNoHarm(void** state)
{
    (void)state;
    swHost host = MakeStrictHost();
    swWorld* world = MakeWorld(&host);
    swInputId id;
    swInputDef def = MakeNamed(SW_INPUT_LEVEL, SW_SHAPE_CIRCLE);
    def.size.x = 1e-30f;
    def.value[0] = 5.0f;
    assert_int_equal(swCreateInput(world, &def, &id), SW_SUCCESS);
    def.size.x = 1000.0f;
    def.feather = 1e6f;
    def.position = (swPos){1e9, 0.0, -1e9};
    assert_int_equal(swCreateInput(world, &def, &id), SW_SUCCESS);
    def.feather = 100.0f;
    def.position.x = -1e9;
    assert_int_equal(swCreateInput(world, &def, &id), SW_SUCCESS);
    swWorld_Step(world, 1.0);
    const swPosXZ points[] = {{0.0, 0.0}, {1.0, 0.0}, {-1e9, -1e9}, {1e9 + 600.0, -1e9}, {1e12, 1e12}};
    float level[5];
    const swFieldSamples samples = {.level = level};
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 5, points, &samples), 0);
    assert_true(isfinite(level[0]) && level[1] == 0.0f && level[3] == 0.0f && level[4] == 0.0f);
    assert_float_equal(level[2], 5.0f, 1e-6f);
    assert_int_equal(CountLines(), 0);
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&s_memory.bytes), 0);
}

// ---- speeds ----

static swMesh* MakeFastMesh(const swHost* host, float speed)
{
    const swVec3 vertices[3] = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 50.0f}, {50.0f, 0.0f, 0.0f}};
    const uint32_t indices[3] = {0, 1, 2};
    const float values[6] = {1.0f, 0.0f, -speed, 0.0f, 1.0f, 1.0f};
    swMeshDef def = swDefaultMeshDef();
    def.vertices = vertices;
    def.vertexCount = 3;
    def.indices = indices;
    def.triangleCount = 1;
    def.values = values;
    def.channelCount = 2;
    swMesh* mesh = NULL;
    assert_int_equal(swCreateMesh(host, &def, &mesh), SW_SUCCESS);
    return mesh;
}

static swRaster* MakeFastRaster(const swHost* host, float speed)
{
    const float values[8] = {0.0f, 1.0f, NAN, NAN, 2.0f, -speed, 0.0f, 0.0f};
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = def.channels = 2;
    def.spacingX = def.spacingZ = 30.0;
    def.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(host, &def, &raster), SW_SUCCESS);
    return raster;
}

static void NoShapeBringsAFlowOfAMillionMetresPerSecond(void** state)
{
    (void)state;
    swHost host = MakeStrictHost();
    swWorld* world = MakeWorld(&host);
    swWorld_Step(world, 1.0);
    swMesh *fastMesh = MakeFastMesh(&host, 1e6f), *mesh = MakeFastMesh(&host, 60.0f);
    swRaster *fastRaster = MakeFastRaster(&host, 1e6f), *raster = MakeFastRaster(&host, 60.0f);
    swInputDef def = MakeNamed(SW_INPUT_FLOW, SW_SHAPE_CIRCLE);
    def.value[1] = -1e6f;
    RefuseInput(world, &def, "m/s");
    def = MakeNamed(SW_INPUT_FLOW, SW_SHAPE_MESH);
    def.mesh = fastMesh;
    RefuseInput(world, &def, "at most 100");
    def.mesh = mesh;
    def.gain = 2.0f;
    RefuseInput(world, &def, "at most 100");
    def = MakeNamed(SW_INPUT_FLOW, SW_SHAPE_RASTER);
    def.raster = fastRaster;
    RefuseInput(world, &def, "at most 100");
    def.raster = raster;
    def.value[0] = 50.0f;
    RefuseInput(world, &def, "at most 100");
    def = MakeNamed(SW_INPUT_WIND, SW_SHAPE_CIRCLE);
    def.value[0] = 60.0f;
    def.blend = SW_BLEND_ADD;
    def.weight = 2.0f;
    RefuseInput(world, &def, "at most 100");
    // What is taken cannot be made too fast later.
    swInputId id;
    def.weight = 1.0f;
    assert_int_equal(swCreateInput(world, &def, &id), SW_SUCCESS);
    swInput_SetWeight(world, id, 2.0f);
    AssertSentence("the culprit", "at most 100");
    swInput_SetValue(world, id, (const float[4]){0.0f, 1e6f, 0.0f, 0.0f});
    s_messages[0] = '\0'; // by the table or as a speed
    assert_true(swInput_Get(world, id).weight == 1.0f && swInput_Get(world, id).value[0] == 60.0f);
    swDestroyMesh(fastMesh);
    swDestroyMesh(mesh);
    swDestroyRaster(fastRaster);
    swDestroyRaster(raster);
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&s_memory.bytes), 0);
}

typedef struct Answerer
{
    float value, derivative, share;
} Answerer;

static void SayIt(void* context, double time, int count, const swPosXZ* points, swInputAnswer* answers)
{
    const Answerer* answerer = context;
    (void)time;
    (void)points;
    for (int i = 0; i < count; ++i)
    {
        answers[i].value[0] = answerer->value;
        answers[i].value[1] = -answerer->value; // their sum is 0
        answers[i].valueAlongX[0] = answerer->derivative;
        answers[i].valueAlongX[1] = -answerer->derivative;
        answers[i].share = answerer->share;
    }
}

static void AFunctionThatExaggeratesCoversNothing(void** state)
{
    (void)state;
    static const Answerer odd[] = {{1e6f, 0.0f, 1.0f}, {101.0f, 0.0f, 1.0f}, {1e30f, 0.0f, 1.0f}, {1.0f, 1e30f, 1.0f},
                                   {1.0f, 0.0f, 1.5f}, {NAN, 0.0f, 1.0f},    {2.0f, 0.0f, 1.0f}};
    swHost host = MakeStrictHost();
    swWorld* world = MakeWorld(&host);
    Answerer answerer = {0};
    swInputDef def = MakeNamed(SW_INPUT_FLOW, SW_SHAPE_FUNCTION);
    def.function = SayIt;
    def.functionContext = &answerer;
    def.functionFingerprint = 1;
    swInputId id;
    assert_int_equal(swCreateInput(world, &def, &id), SW_SUCCESS);
    swWorld_Step(world, 1.0);
    for (int i = 0; i < (int)(sizeof odd / sizeof odd[0]); ++i)
    {
        bool isLast = i == (int)(sizeof odd / sizeof odd[0]) - 1;
        answerer = odd[i];
        swVec2 flow = {9.0f, 9.0f};
        const swFieldSamples samples = {.flow = &flow};
        swMoment_QueryFields(swWorld_GetMoment(world), 1, &(swPosXZ){1.0, 2.0}, &samples);
        assert_float_equal(flow.x, isLast ? 2.0f : 0.0f, 0.0f);
        assert_float_equal(flow.y, isLast ? -2.0f : 0.0f, 0.0f);
    }
    swDestroyWorld(world);
}

// ---- points ----

static void TooManyAndCrossingPointsAreRefused(void** state)
{
    (void)state;
    swHost host = MakeStrictHost();
    swWorld* world = MakeWorld(&host);
    swWorld_Step(world, 1.0);
    enum
    {
        MANY = 1 << 20
    };
    swInputPoint* points = calloc(MANY, sizeof *points);
    assert_non_null(points);
    for (int i = 0; i < MANY; ++i)
    {
        double turn = 6.283185307179586 * i / 100000.0;
        points[i] = (swInputPoint){.x = (float)(4e5 * cos(turn)), .z = (float)(4e5 * sin(turn)), .weight = 1.0f};
    }
    swInputDef def = MakeNamed(SW_INPUT_FOAM, SW_SHAPE_PARTICLES);
    def.points = points;
    def.pointCount = MANY;
    RefuseInput(world, &def, "0 to 65536");
    def.shape = SW_SHAPE_POLYGON;
    def.pointCount = 100000;
    RefuseInput(world, &def, "3 to");
    const swInputPoint eight[4] = {
        {.x = -10.0f, .z = -10.0f}, {.x = 10.0f, .z = 10.0f}, {.x = 10.0f, .z = -10.0f}, {.x = -10.0f, .z = 10.0f}};
    def.points = eight;
    def.pointCount = 4;
    RefuseInput(world, &def, "crosses itself");
    def.pointCount = -4;
    RefuseInput(world, &def, "has -4 points");
    def.points = NULL;
    def.pointCount = 4;
    RefuseInput(world, &def, "has no points");
    def.shape = SW_SHAPE_POLYLINE;
    RefuseInput(world, &def, "fewer than two points");
    free(points);
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&s_memory.bytes), 0);
}

// What a shape does not look at may be anything: it is neither read nor kept.
static void WhatAShapeDoesNotLookAtIsNotKept(void** state)
{
    (void)state;
    swHost host = MakeStrictHost();
    swWorld* world = MakeWorld(&host);
    swRaster* raster = MakeFastRaster(&host, 3.0f);
    swInputDef def = MakeNamed(SW_INPUT_LEVEL, SW_SHAPE_EVERYWHERE);
    def.pointCount = 1000000000; // and no points
    def.position.x = (double)NAN;
    def.raster = raster;
    def.value[0] = 2.0f;
    swInputId id;
    assert_int_equal(swCreateInput(world, &def, &id), SW_SUCCESS);
    assert_int_equal(swInput_Set(world, id, &def), SW_SUCCESS);
    assert_null(swInput_Get(world, id).raster);
    assert_int_equal(swInput_Get(world, id).pointCount, 0);
    swWorld_Step(world, 1.0);
    float level = 0.0f;
    swMoment_QueryFields(swWorld_GetMoment(world), 1, &(swPosXZ){1.0, 2.0}, &(swFieldSamples){.level = &level});
    assert_float_equal(level, 2.0f, 0.0f);
    // Nobody is asked for the raster, and the place is a number.
    Saved saved = Save(world);
    swWorld* restored = NULL;
    swRestoreDef restore = swDefaultRestoreDef();
    assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &restore, &restored), SW_SUCCESS);
    swDestroyWorld(restored);
    free(saved.data);
    swDestroyRaster(raster);
    swDestroyWorld(world);
    assert_int_equal(CountLines(), 0);
    assert_int_equal(atomic_load(&s_memory.bytes), 0);
}

// ---- what means nothing ----

static void NumbersOfBodiesAreThoseOfBodies(void** state)
{
    (void)state;
    swHost host = MakeStrictHost();
    swWorld* world = MakeWorld(&host);
    swWorld_Step(world, 1.0);
    const float odd[] = {-2.0f, 0.5f, 1024.0f};
    for (int i = 0; i < 3; ++i)
    {
        swInputDef def = MakeNamed(SW_INPUT_BODY, SW_SHAPE_CIRCLE);
        def.blend = SW_BLEND_REPLACE;
        def.value[0] = odd[i];
        RefuseInput(world, &def, "whole");
    }
    swRaster* raster = MakeFastRaster(&host, 3.0f);
    swInputDef def = MakeNamed(SW_INPUT_BODY, SW_SHAPE_RASTER);
    def.blend = SW_BLEND_REPLACE;
    def.raster = raster;
    RefuseInput(world, &def, "polygon");
    swDestroyRaster(raster);
    swDestroyWorld(world);
}

static void APushThatStaysPutIsNotTurnedSidewaysLater(void** state)
{
    (void)state;
    swHost host = MakeStrictHost();
    swWorld* world = MakeWorld(&host);
    swInputDef def = MakeNamed(SW_INPUT_DISPLACEMENT, SW_SHAPE_CIRCLE);
    def.blend = SW_BLEND_ADD;
    def.value[1] = -1.0f;
    swInputId id;
    assert_int_equal(swCreateInput(world, &def, &id), SW_SUCCESS);
    swInput_SetValue(world, id, (const float[4]){1.0f, -1.0f, 0.0f, 0.0f});
    AssertSentence("the culprit", "followsWaves");
    assert_true(swInput_Get(world, id).value[0] == 0.0f);
    swDestroyWorld(world);
}

// ---- resources ----

static void RefuseRaster(const swHost* host, const swRasterDef* def, const char* remedy)
{
    swRaster* raster = (swRaster*)(void*)&raster;
    s_messages[0] = '\0';
    assert_int_not_equal(swCreateRaster(host, def, &raster), SW_SUCCESS);
    assert_null(raster);
    AssertSentence("", remedy);
}

static void RastersWithoutCellsOrOfTooManyAreRefused(void** state)
{
    (void)state;
    swHost host = MakeStrictHost();
    float value = 1.0f;
    swRasterDef def = swDefaultRasterDef();
    def.name = "the culprit";
    def.values = &value;
    def.width = 0;
    def.height = 0;
    RefuseRaster(&host, &def, "width");
    def.width = def.height = 31623; // 10^9 cells
    RefuseRaster(&host, &def, "16384");
    def.width = def.height = 16384;
    def.channels = 4; // 2^30 values are the most
    def.frames = 2;
    RefuseRaster(&host, &def, "the culprit");
    def = swDefaultRasterDef();
    def.values = &value;
    def.spacingX = 0.0;
    RefuseRaster(&host, &def, "spacing");
    value = 1e30f;
    def = swDefaultRasterDef();
    def.name = "the culprit";
    def.values = &value;
    RefuseRaster(&host, &def, "the culprit");
    assert_int_equal(atomic_load(&s_memory.bytes), 0);
}

// Rows of which a part is unknown cover what is known, and no more.
static void ARasterUnknownInPartCoversTheRest(void** state)
{
    (void)state;
    swHost host = MakeStrictHost();
    float values[25];
    for (int i = 0; i < 25; ++i)
    {
        values[i] = i % 5 >= 3 || i / 5 == 4 ? NAN : -10.0f;
    }
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = 5;
    def.spacingX = def.spacingZ = 10.0;
    def.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(&host, &def, &raster), SW_SUCCESS);
    swWorld* world = MakeWorld(&host);
    swInputDef floor = MakeNamed(SW_INPUT_FLOOR, SW_SHAPE_RASTER);
    floor.raster = raster;
    floor.feather = 5.0f;
    swInputId id;
    assert_int_equal(swCreateInput(world, &floor, &id), SW_SUCCESS);
    swWorld_Step(world, 1.0);
    const swPosXZ points[] = {{10.0, 10.0}, {19.0, 29.0}, {30.5, 10.0}, {10.0, 40.0}, {35.0, 35.0}};
    float depth[5];
    swMoment_QueryFields(swWorld_GetMoment(world), 5, points, &(swFieldSamples){.depth = depth});
    assert_float_equal(depth[0], 10.0f, 1e-5f);
    assert_true(depth[1] >= 10.0f && isfinite(depth[1]));
    assert_true(isinf(depth[2]) && isinf(depth[3]) && isinf(depth[4]));
    swDestroyRaster(raster);
    swDestroyWorld(world);
    assert_int_equal(atomic_load(&s_memory.bytes), 0);
}

static void MeshesAndSplinesThatCannotBeAreNamed(void** state)
{
    (void)state;
    swHost host = MakeStrictHost();
    const swVec3 vertices[3] = {{0.0f, 0.0f, 0.0f}, {0.0f, NAN, 50.0f}, {50.0f, 0.0f, 0.0f}};
    const uint32_t indices[3] = {0, 1, 2};
    swMeshDef mesh = swDefaultMeshDef();
    mesh.name = "the culprit";
    mesh.vertices = vertices;
    mesh.vertexCount = 3;
    mesh.indices = indices;
    mesh.triangleCount = 1;
    swMesh* madeMesh = NULL;
    assert_int_equal(swCreateMesh(&host, &mesh, &madeMesh), SW_ERROR_INVALID);
    assert_null(madeMesh);
    AssertSentence("the culprit", "vertex 1");
    swHullDef hull = swDefaultHullDef();
    hull.name = "the culprit";
    hull.vertices = vertices;
    hull.vertexCount = 3;
    hull.indices = indices;
    hull.triangleCount = 1;
    swHull* madeHull = NULL;
    assert_int_equal(swCreateHull(&host, &hull, &madeHull), SW_ERROR_INVALID);
    assert_null(madeHull);
    AssertSentence("the culprit", "vertex 1");
    swSplinePoint points[3] = {swDefaultSplinePoint(0.0, 0.0, 0.0), swDefaultSplinePoint(0.0, 0.0, 0.0),
                               swDefaultSplinePoint(9.0, 0.0, 0.0)};
    swSplineDef spline = swDefaultSplineDef();
    spline.name = "the culprit";
    spline.points = points;
    spline.pointCount = 1;
    swSpline* madeSpline = NULL;
    assert_int_equal(swCreateSpline(&host, &spline, &madeSpline), SW_ERROR_INVALID);
    AssertSentence("the culprit", "2");
    spline.pointCount = 3;
    assert_int_equal(swCreateSpline(&host, &spline, &madeSpline), SW_ERROR_INVALID);
    AssertSentence("the culprit", "Take one away");
    points[1].x = (double)NAN;
    assert_int_equal(swCreateSpline(&host, &spline, &madeSpline), SW_ERROR_INVALID);
    AssertSentence("the culprit", "1");
    assert_null(madeSpline);
    assert_int_equal(atomic_load(&s_memory.bytes), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(NumbersOutOfRangeAreNamedWithTheirRange),
        cmocka_unit_test(TheSmallestAndTheFarthestDoNoHarm),
        cmocka_unit_test(NoShapeBringsAFlowOfAMillionMetresPerSecond),
        cmocka_unit_test(AFunctionThatExaggeratesCoversNothing),
        cmocka_unit_test(TooManyAndCrossingPointsAreRefused),
        cmocka_unit_test(WhatAShapeDoesNotLookAtIsNotKept),
        cmocka_unit_test(NumbersOfBodiesAreThoseOfBodies),
        cmocka_unit_test(APushThatStaysPutIsNotTurnedSidewaysLater),
        cmocka_unit_test(RastersWithoutCellsOrOfTooManyAreRefused),
        cmocka_unit_test(ARasterUnknownInPartCoversTheRest),
        cmocka_unit_test(MeshesAndSplinesThatCannotBeAreNamed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
