// SPDX-License-Identifier: MIT
// Inputs of every shape in mapped moments, in saved worlds and back: the same answers, to the bit.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/hull_meshes.h"
#include "support/messages.h"
#include "support/saved.h"
#include "support/scatter.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <seaway/seaway.h>

#include "core/world/moment_inputs.h"
#include "core/world/world.h"

#define POINTS 400

// What inputs use, and which of it the host still has.
typedef struct Shelf
{
    swRaster *floor, *flow, *push;
    swMesh* mesh;
    swHull* hull;
    swSpline* spline;
    swResourceKind missing; // SW_RESOURCE_KIND_COUNT: nothing is
    swResourceKind wrong;   // another one is given; SW_RESOURCE_KIND_COUNT: of none
    swRaster* otherRaster;  // of another size
    swMesh* otherMesh;
    swHull* otherHull;
    swSpline* otherSpline;
} Shelf;

static swRaster* MakeRaster(const swHost* host, int channels, float scale)
{
    float values[3 * 3 * 2];
    for (int i = 0; i < 9 * channels; ++i)
    {
        values[i] = scale * (1.0f + (float)(i * 7 % 5));
    }
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = 3;
    def.channels = channels;
    def.x = def.z = -60.0;
    def.spacingX = def.spacingZ = 60.0;
    def.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(host, &def, &raster), SW_SUCCESS);
    return raster;
}

static swMesh* MakeMesh(const swHost* host, int vertexCount, const swVec3* vertices, int triangleCount,
                        const uint32_t* indices)
{
    swMeshDef def = swDefaultMeshDef();
    def.vertices = vertices;
    def.vertexCount = vertexCount;
    def.indices = indices;
    def.triangleCount = triangleCount;
    swMesh* mesh = NULL;
    assert_int_equal(swCreateMesh(host, &def, &mesh), SW_SUCCESS);
    return mesh;
}

// Of what was added to `mesh` alone.
static swHull* MakeHull(const swHost* host, const TestMesh* mesh, const char* name)
{
    swHullDef def = MakeHullDef(mesh, name);
    def.resolution = 8;
    swHull* hull = NULL;
    assert_int_equal(swCreateHull(host, &def, &hull), SW_SUCCESS);
    return hull;
}

static swMesh* MakeSlope(const swHost* host)
{
    const swVec3 vertices[5] = {{-80.0f, -9.0f, -80.0f},
                                {80.0f, -6.0f, -80.0f},
                                {80.0f, -4.0f, 80.0f},
                                {-80.0f, -7.0f, 80.0f},
                                {0.0f, -2.0f, 0.0f}};
    const uint32_t indices[12] = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
    return MakeMesh(host, 5, vertices, 4, indices);
}

static swHull* MakeDock(const swHost* host)
{
    static TestMesh mesh;
    mesh.vertexCount = mesh.triangleCount = 0;
    AddDock(&mesh);
    return MakeHull(host, &mesh, "dock");
}

static swSpline* MakeRiver(const swHost* host)
{
    const swSplinePoint points[4] = {swDefaultSplinePoint(-90.0, -20.0, 0.0), swDefaultSplinePoint(-20.0, 10.0, 0.0),
                                     swDefaultSplinePoint(30.0, -10.0, 0.0), swDefaultSplinePoint(90.0, 30.0, 0.0)};
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = 4;
    def.width = 30.0f;
    swSpline* spline = NULL;
    assert_int_equal(swCreateSpline(host, &def, &spline), SW_SUCCESS);
    return spline;
}

static Shelf FillShelf(const swHost* host)
{
    return (Shelf){
        .floor = MakeRaster(host, 1, -4.0f),
        .flow = MakeRaster(host, 2, 0.2f),
        .push = MakeRaster(host, 1, 0.1f),
        .mesh = MakeSlope(host),
        .hull = MakeDock(host),
        .spline = MakeRiver(host),
        .missing = SW_RESOURCE_KIND_COUNT,
        .wrong = SW_RESOURCE_KIND_COUNT,
    };
}

static void EmptyShelf(Shelf* shelf)
{
    swDestroyRaster(shelf->floor);
    swDestroyRaster(shelf->flow);
    swDestroyRaster(shelf->push);
    swDestroyMesh(shelf->mesh);
    swDestroyHull(shelf->hull);
    swDestroySpline(shelf->spline);
}

// ---- worlds ----

static swInputDef MakeInput(swInputField field, swInputShape shape, float value)
{
    swInputDef def = swDefaultInputDef();
    snprintf(def.name, sizeof def.name, "input of shape %d", (int)shape);
    def.field = field;
    def.shape = shape;
    def.value[0] = value;
    def.value[1] = 0.5f * value;
    def.blend = SW_BLEND_ADD;
    return def;
}

static void Add(swWorld* world, const swInputDef* def)
{
    swInputId id;
    if (swCreateInput(world, def, &id) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
}

static void AddSolids(swWorld* world, const Shelf* shelf)
{
    for (int shape = SW_SHAPE_BOX; shape <= SW_SHAPE_HULL; ++shape)
    {
        swInputDef solid = MakeInput(SW_INPUT_CLIP, (swInputShape)shape, 1.0f);
        solid.blend = SW_BLEND_ALPHA;
        solid.position = (swPos){30.0 * (shape - SW_SHAPE_BOX) - 60.0, 0.0, 40.0};
        solid.size = (swVec3){20.0f, 30.0f, 25.0f};
        solid.rotation = (swAngles){0.3f, 0.1f, -0.2f};
        solid.hull = shape == SW_SHAPE_HULL ? shelf->hull : NULL;
        Add(world, &solid);
    }
}

static void AddResources(swWorld* world, const Shelf* shelf, swWaveSystemId waves)
{
    swInputDef def = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_RASTER, 0.0f);
    def.blend = SW_BLEND_ALPHA;
    def.raster = shelf->floor;
    Add(world, &def);
    def = MakeInput(SW_INPUT_FLOOR, SW_SHAPE_MESH, 0.0f);
    def.blend = SW_BLEND_ALPHA;
    def.mesh = shelf->mesh;
    Add(world, &def);
    def = MakeInput(SW_INPUT_FLOW, SW_SHAPE_RASTER, 0.0f);
    def.raster = shelf->flow;
    Add(world, &def);
    def = MakeInput(SW_INPUT_FLOW, SW_SHAPE_SPLINE, 0.0f);
    def.spline = shelf->spline;
    Add(world, &def);
    def = MakeInput(SW_INPUT_WAVES, SW_SHAPE_SPLINE, 1.0f);
    def.blend = SW_BLEND_ALPHA;
    def.system = waves;
    def.spline = shelf->spline;
    def.alongSpline = true;
    Add(world, &def);
    def = MakeInput(SW_INPUT_DISPLACEMENT, SW_SHAPE_RASTER, 0.0f); // one channel: heights
    def.raster = shelf->push;
    Add(world, &def);
    def = MakeInput(SW_INPUT_WAVES, SW_SHAPE_RASTER, 1.0f); // two channels: the wind
    def.system = waves;
    def.raster = shelf->flow;
    def.windWeight.isUsed = true;
    def.windWeight.speed = 0.5f;
    Add(world, &def);
}

// An input of each shape but functions, which are of one process, among waves that a flow carries.
static swWorld* MakeWorld(const swHost* host, const Shelf* shelf)
{
    static const swInputPoint points[4] = {{-50.0f, -40.0f, 6.0f, 1.0f, {0.2f, 0.0f, 0.0f, 0.0f}},
                                           {40.0f, -50.0f, 8.0f, 0.7f, {0.1f, 0.0f, 0.0f, 0.0f}},
                                           {60.0f, 30.0f, 5.0f, 0.9f, {0.3f, 0.0f, 0.0f, 0.0f}},
                                           {-30.0f, 50.0f, 7.0f, 1.0f, {0.0f, 0.0f, 0.0f, 0.0f}}};
    static const swInputField fields[] = {
        [SW_SHAPE_EVERYWHERE] = SW_INPUT_LEVEL, [SW_SHAPE_CIRCLE] = SW_INPUT_WAVES,
        [SW_SHAPE_RECTANGLE] = SW_INPUT_ALBEDO, [SW_SHAPE_POLYGON] = SW_INPUT_LEVEL,
        [SW_SHAPE_POLYLINE] = SW_INPUT_FOAM,    [SW_SHAPE_PARTICLES] = SW_INPUT_FOAM,
    };
    static const swInputShape shapes[] = {SW_SHAPE_EVERYWHERE, SW_SHAPE_CIRCLE,   SW_SHAPE_RECTANGLE,
                                          SW_SHAPE_POLYGON,    SW_SHAPE_POLYLINE, SW_SHAPE_PARTICLES};
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableVelocity = true;
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef wavesDef = swDefaultWaveSystemDef();
    wavesDef.resolution = 32;
    wavesDef.tileWaves = 8;
    swWaveSystemId waves;
    assert_int_equal(swCreateWaveSystem(world, &wavesDef, &waves), SW_SUCCESS);
    for (int i = 0; i < (int)(sizeof shapes / sizeof shapes[0]); ++i)
    {
        swInputDef def = MakeInput(fields[shapes[i]], shapes[i], 0.25f);
        bool hasPoints = fields[shapes[i]] == SW_INPUT_FOAM || shapes[i] == SW_SHAPE_POLYGON;
        def.points = hasPoints ? points : NULL;
        def.pointCount = hasPoints ? 4 : 0;
        def.feather = 4.0f;
        def.rotation.yaw = shapes[i] != SW_SHAPE_EVERYWHERE ? 0.4f : 0.0f;
        if (shapes[i] == SW_SHAPE_EVERYWHERE)
        {
            assert_true(swSetTideConstituent("M2", 1.5f, 0.4f, &def.tide[0]));
        }
        Add(world, &def);
    }
    AddResources(world, shelf, waves);
    AddSolids(world, shelf);
    return world;
}

// ---- what is asked ----

typedef struct Answers
{
    float depth[POINTS], floor[POINTS], level[POINTS], clip[POINTS], foam[POINTS], height[POINTS];
    swVec2 flow[POINTS];
    swVec3 displacement[POINTS], normal[POINTS], velocity[POINTS];
    swVec4 albedo[POINTS];
    bool isClipped[POINTS];
} Answers;

static void Ask(const swMoment* moment, int count, Answers* answers)
{
    static swPosXZ points[POINTS];
    ScatterPoints(points, POINTS, 0.0, 0.0, 190.0);
    memset(answers, 0, sizeof *answers);
    const swFieldSamples fields = {.depth = answers->depth,
                                   .floor = answers->floor,
                                   .level = answers->level,
                                   .flow = answers->flow,
                                   .clip = answers->clip,
                                   .foam = answers->foam,
                                   .albedo = answers->albedo,
                                   .displacement = answers->displacement};
    swMoment_QueryFields(moment, count, points, &fields);
    swQueryDef def = swDefaultQueryDef();
    def.maxIterations = count < POINTS ? 2 : def.maxIterations;
    const swSurfaceSamples surface = {.height = answers->height,
                                      .normal = answers->normal,
                                      .velocity = answers->velocity,
                                      .isClipped = answers->isClipped};
    swMoment_QuerySurface(moment, &def, count, points, &surface, NULL);
}

static int CountOther(const float* values, float below)
{
    int count = 0;
    for (int i = 0; i < POINTS; ++i)
    {
        count += values[i] != below ? 1 : 0;
    }
    return count;
}

static void* CopyMoment(const swMoment* moment, size_t* size)
{
    const void* memory = swMoment_GetMemory(moment, size);
    void* copy = aligned_alloc(64, (*size + 63) / 64 * 64);
    assert_non_null(copy);
    return memcpy(copy, memory, *size);
}

// ---- mapped moments ----

static void AMappedMomentHasEveryShape(void** state)
{
    (void)state;
    static Answers expected, found;
    swHost host = MakeHost();
    Shelf shelf = FillShelf(&host);
    swWorld* world = MakeWorld(&host, &shelf);
    swWorld_StepTo(world, 4000.0);
    Ask(swWorld_GetMoment(world), POINTS, &expected);
    // Each kind of answer has something to tell.
    assert_true(CountOther(expected.floor, -INFINITY) > 100 && CountOther(expected.clip, 0.0f) > 10);
    assert_true(CountOther(expected.foam, 0.0f) > 10 && CountOther(&expected.displacement[0].y, 0.0f) > 50);
    swMomentDef def = swDefaultMomentDef();
    def.time = 4000.0;
    swMoment *moment = NULL, *map = NULL;
    assert_int_equal(swCreateMoment(world, &def, &moment), SW_SUCCESS);
    size_t size;
    void* copy = CopyMoment(moment, &size);
    swDestroyMoment(moment);
    swDestroyWorld(world);
    EmptyShelf(&shelf);
    assert_int_equal(swMapMoment(&host, copy, size, &map), SW_SUCCESS);
    Ask(map, POINTS, &found);
    assert_memory_equal(&found, &expected, sizeof found);
    swDestroyMoment(map);
    free(copy);
}

// Words of inputs are not signed: whatever they say, a moment is refused or answers something, and reads nothing beyond
// its memory, which sanitizers watch.
static void WordsThatAreWrongLeadNowhere(void** state)
{
    (void)state;
    static Answers answers;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    Shelf shelf = FillShelf(&host);
    swWorld* world = MakeWorld(&host, &shelf);
    swWorld_Step(world, 1.0);
    swMomentDef def = swDefaultMomentDef();
    swMoment *moment = NULL, *map = NULL;
    assert_int_equal(swCreateMoment(world, &def, &moment), SW_SUCCESS);
    size_t size;
    uint8_t* copy = CopyMoment(moment, &size);
    // The inputs are at the end.
    size_t inputs = swFindStoredInputsSize(&world->inputs);
    swDestroyMoment(moment);
    swDestroyWorld(world);
    EmptyShelf(&shelf);
    const uint32_t wrong[] = {0, 1, 0x7fc00000u, 0xffffffffu, 0x4b800000u, 0x3fc00000u, 0xbf800000u, 70000};
    int refused = 0, answered = 0;
    // Heads, records and nodes lie in the first 8 KB. Each word is replaced by three others.
    for (size_t pass = 0; pass < 3; ++pass)
    {
        for (size_t at = size - inputs; at + 4 <= size; at += at < size - inputs + 8192 ? 4 : 68)
        {
            uint32_t kept;
            memcpy(&kept, copy + at, sizeof kept);
            const uint32_t* value = &wrong[(at / 4 + 3 * pass) % (sizeof wrong / sizeof wrong[0])];
            memcpy(copy + at, value, sizeof kept);
            swResult result = swMapMoment(&host, copy, size, &map);
            assert_true(result == SW_SUCCESS || result == SW_ERROR_FORMAT);
            if (result == SW_SUCCESS)
            {
                Ask(map, 24, &answers);
                swDestroyMoment(map);
            }
            refused += result == SW_SUCCESS ? 0 : 1;
            answered += result == SW_SUCCESS ? 1 : 0;
            memcpy(copy + at, &kept, sizeof kept);
        }
    }
    print_message("%d moments with a wrong word were refused, %d answered\n", refused, answered);
    assert_true(refused > 100 && answered > 1000);
    free(copy);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

// ---- saved worlds ----

static bool FindResource(void* context, swResourceKind kind, uint64_t hash, const char* name, swResource* resource)
{
    const Shelf* shelf = context;
    assert_memory_equal(name, "input of shape", 14);
    const swRaster* const rasters[] = {shelf->floor, shelf->flow, shelf->push};
    for (int i = 0; i < 3; ++i)
    {
        resource->raster = swRaster_GetInfo(rasters[i]).hash == hash ? rasters[i] : resource->raster;
    }
    resource->mesh = swMesh_GetInfo(shelf->mesh).hash == hash ? shelf->mesh : NULL;
    resource->hull = swHull_GetInfo(shelf->hull).hash == hash ? shelf->hull : NULL;
    resource->spline = swSpline_GetInfo(shelf->spline).hash == hash ? shelf->spline : NULL;
    if (kind == shelf->wrong)
    {
        *resource = (swResource){.raster = shelf->otherRaster,
                                 .mesh = shelf->otherMesh,
                                 .hull = shelf->otherHull,
                                 .spline = shelf->otherSpline};
    }
    return kind != shelf->missing;
}

static void ARestoredWorldHasEveryShape(void** state)
{
    (void)state;
    static Answers expected, found;
    swHost host = MakeHost();
    Shelf shelf = FillShelf(&host);
    swWorld* world = MakeWorld(&host, &shelf);
    swWorld_StepTo(world, 4000.0);
    Saved saved = Save(world);
    swRestoreDef def = swDefaultRestoreDef();
    def.findResource = FindResource;
    def.resourceContext = &shelf;
    swWorld* restored = NULL;
    assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &def, &restored), SW_SUCCESS);
    Saved again = Save(restored);
    assert_int_equal(again.size, saved.size);
    assert_memory_equal(again.data, saved.data, saved.size);
    assert_string_equal(swInput_Get(restored, swWorld_GetInput(restored, 0)).name,
                        swInput_Get(world, swWorld_GetInput(world, 0)).name);
    // At once, and after steps: carried waves begin anew at the same times in both.
    for (int step = 0; step < 4; ++step)
    {
        assert_true(swWorld_GetDigest(restored) == swWorld_GetDigest(world));
        Ask(swWorld_GetMoment(world), POINTS, &expected);
        Ask(swWorld_GetMoment(restored), POINTS, &found);
        assert_memory_equal(&found, &expected, sizeof found);
        swWorld_Step(world, 2.7);
        swWorld_Step(restored, 2.7);
    }
    // And back.
    assert_int_equal(swWorld_Rewind(restored, saved.data, saved.size), SW_SUCCESS);
    assert_int_equal(swWorld_Rewind(world, saved.data, saved.size), SW_SUCCESS);
    Ask(swWorld_GetMoment(world), POINTS, &expected);
    Ask(swWorld_GetMoment(restored), POINTS, &found);
    assert_memory_equal(&found, &expected, sizeof found);
    swDestroyWorld(restored);
    swDestroyWorld(world);
    free(saved.data);
    free(again.data);
    EmptyShelf(&shelf);
}

static void WhatIsMissingIsNamed(void** state)
{
    (void)state;
    static const char* const sentences[] = {
        [SW_RESOURCE_RASTER] = "the saved input 'input of shape 7' uses a raster with the hash ",
        [SW_RESOURCE_HULL] = "the saved input 'input of shape 14' uses a hull with the hash ",
        [SW_RESOURCE_MESH] = "the saved input 'input of shape 6' uses a mesh with the hash ",
        [SW_RESOURCE_SPLINE] = "the saved input 'input of shape 5' uses a spline with the hash ",
    };
    swHost host = MakeHost();
    Shelf shelf = FillShelf(&host);
    swWorld* world = MakeWorld(&host, &shelf);
    swWorld_Step(world, 1.0);
    Saved saved = Save(world);
    swDestroyWorld(world);
    swRestoreDef def = swDefaultRestoreDef();
    def.findResource = FindResource;
    def.resourceContext = &shelf;
    for (int kind = SW_RESOURCE_RASTER; kind <= SW_RESOURCE_SPLINE; ++kind)
    {
        shelf.missing = (swResourceKind)kind;
        s_messages[0] = '\0';
        assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &def, &world), SW_ERROR_UNSUPPORTED);
        assert_null(world);
        print_message("%s", s_messages);
        assert_non_null(strstr(s_messages, sentences[kind]));
    }
    free(saved.data);
    EmptyShelf(&shelf);
}

static swRaster* MakeOtherRaster(const swHost* host)
{
    const float values[6] = {-4.0f, -5.0f, -6.0f, -4.0f, -5.0f, -6.0f};
    swRasterDef def = swDefaultRasterDef();
    def.width = 3;
    def.height = 2;
    def.values = values;
    swRaster* raster = NULL;
    assert_int_equal(swCreateRaster(host, &def, &raster), SW_SUCCESS);
    return raster;
}

static swSpline* MakeOtherSpline(const swHost* host)
{
    const swSplinePoint points[2] = {swDefaultSplinePoint(-90.0, 0.0, -20.0), swDefaultSplinePoint(90.0, 0.0, 30.0)};
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = 2;
    swSpline* spline = NULL;
    assert_int_equal(swCreateSpline(host, &def, &spline), SW_SUCCESS);
    return spline;
}

static swMesh* MakeOtherMesh(const swHost* host)
{
    const swVec3 vertices[3] = {{-80.0f, -9.0f, -80.0f}, {80.0f, -6.0f, -80.0f}, {80.0f, -4.0f, 80.0f}};
    const uint32_t indices[3] = {0, 1, 2};
    return MakeMesh(host, 3, vertices, 1, indices);
}

static swHull* MakeOtherHull(const swHost* host)
{
    static TestMesh mesh;
    mesh.vertexCount = mesh.triangleCount = 0;
    AddBox(&mesh, (swVec3){-5.0f, -1.0f, -2.0f}, (swVec3){5.0f, 1.0f, 2.0f});
    return MakeHull(host, &mesh, "box");
}

// Another one than was saved, of another size, is as good as none, and the log says that it is another one.
static void WhatIsAnotherOneIsRefused(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    host.log = KeepMessages;
    Shelf shelf = FillShelf(&host);
    swWorld* world = MakeWorld(&host, &shelf);
    swWorld_Step(world, 1.0);
    Saved saved = Save(world);
    swDestroyWorld(world);
    shelf.otherRaster = MakeOtherRaster(&host);
    shelf.otherMesh = MakeOtherMesh(&host);
    shelf.otherHull = MakeOtherHull(&host);
    shelf.otherSpline = MakeOtherSpline(&host);
    swRestoreDef def = swDefaultRestoreDef();
    def.findResource = FindResource;
    def.resourceContext = &shelf;
    long long held = atomic_load(&memory.bytes);
    for (int kind = SW_RESOURCE_RASTER; kind <= SW_RESOURCE_SPLINE; ++kind)
    {
        shelf.wrong = (swResourceKind)kind;
        s_messages[0] = '\0';
        assert_int_equal(swRestoreWorld(&host, saved.data, saved.size, &def, &world), SW_ERROR_UNSUPPORTED);
        assert_null(world);
        assert_non_null(strstr(s_messages, "gave another one"));
        assert_true(atomic_load(&memory.bytes) == held); // nothing half-made
    }
    swDestroyRaster(shelf.otherRaster);
    swDestroyMesh(shelf.otherMesh);
    swDestroyHull(shelf.otherHull);
    swDestroySpline(shelf.otherSpline);
    EmptyShelf(&shelf);
    free(saved.data);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AMappedMomentHasEveryShape),  cmocka_unit_test(WordsThatAreWrongLeadNowhere),
        cmocka_unit_test(ARestoredWorldHasEveryShape), cmocka_unit_test(WhatIsMissingIsNamed),
        cmocka_unit_test(WhatIsAnotherOneIsRefused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
