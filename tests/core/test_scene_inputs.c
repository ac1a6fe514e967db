// SPDX-License-Identifier: MIT
// Rasters and inputs in scene files: what they say is in the sea, and every mistake has its line and code.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "seaway/input.h"
#include "seaway/scene.h"

static void WriteText(const char* path, const char* text)
{
    FILE* file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static swResult ReadText(const char* text, swScene** scene)
{
    swHost host = MakeHost();
    return swReadSceneText(&host, text, strlen(text), "a.yaml", ".", scene);
}

static swWorld* OpenText(const char* text, swScene** scene)
{
    swWorld* world = NULL;
    swHost host = MakeHost();
    assert_int_equal(ReadText(text, scene), SW_SUCCESS);
    assert_int_equal(swCreateSceneWorld(&host, *scene, &world), SW_SUCCESS);
    return world;
}

static void InputsOfASceneAreInItsSea(void** state)
{
    (void)state;
    WriteText("floor.asc", "ncols 2\nnrows 2\nxllcenter -100\nyllcenter -100\ncellsize 200\n-10 -20\n-10 -20\n");
    static const char text[] = "rasters:\n"
                               "  - {name: bay, file: floor.asc, coordinates: metres}\n"
                               "inputs:\n"
                               "  - {field: floor, shape: raster, raster: bay}\n"
                               "  - {field: level, shape: circle, size_m: [20, 0, 20], value: 3, blend: replace}\n"
                               "  - {field: flow, value: [1, -2]}\n"
                               "waves:\n"
                               "  - beaufort: 2\n";
    swScene* scene = NULL;
    swWorld* world = OpenText(text, &scene);
    const swPosXZ points[2] = {{0.0, 0.0}, {50.0, 0.0}};
    float floors[2], depth[2], level[2];
    swVec2 flow[2];
    const swFieldSamples samples = {.floor = floors, .depth = depth, .level = level, .flow = flow};
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 2, points, &samples), 0);
    assert_float_equal(floors[0], -15.0f, 1e-4f);
    assert_float_equal(floors[1], -17.5f, 1e-4f);
    assert_float_equal(level[0], 3.0f, 0.0f);
    assert_float_equal(level[1], 0.0f, 0.0f);
    assert_float_equal(depth[0], 18.0f, 1e-4f);
    assert_float_equal(flow[1].x, 1.0f, 0.0f);
    assert_float_equal(flow[1].y, -2.0f, 0.0f);
    swDestroyScene(scene); // the world holds what its inputs use
    assert_int_equal(swWorld_Step(world, 0.1), SW_SUCCESS);
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(world), 2, points, &samples), 0);
    assert_float_equal(floors[0], -15.0f, 1e-4f);
    swDestroyWorld(world);
    remove("floor.asc");
}

static void ASplineOfASceneIsNamedByItsInputs(void** state)
{
    (void)state;
    static const char text[] = "inputs:\n"
                               "  - {field: level, shape: spline, spline: river, blend: replace}\n"
                               "splines:\n"
                               "  - name: river\n"
                               "    width_m: 10\n"
                               "    points: [{x_m: 0, y_m: 4}, {x_m: 100, y_m: 2, width: 2}]\n";
    swScene* scene = NULL;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    assert_non_null(scene->inputs[0].def.spline);
    assert_ptr_equal(scene->inputs[0].def.spline, scene->splines[0].spline);
    assert_float_equal(swSpline_GetInfo(scene->splines[0].spline).length, 100.0, 1e-3);
    assert_float_equal(scene->splines[0].points[1].width, 2.0f, 0.0f);
    swDestroyScene(scene);
}

static void ABodyOfWaterOfASceneIsInItsSea(void** state)
{
    (void)state;
    static const char text[] = "waves: [{beaufort: 4}, {beaufort: 1, seed: 2, is_local: true}]\n"
                               "water_bodies:\n"
                               "  - name: lake\n"
                               "    position_m: [1000, 40, 0]\n"
                               "    points: [[-50, -50], [50, -50], [50, 50], [-50, 50]]\n"
                               "    is_calm: true\n"
                               "    waves: 2\n";
    swScene* scene = NULL;
    swWorld* world = OpenText(text, &scene);
    assert_int_equal(swWorld_GetWaterBodyCount(world), 1);
    swWaterBodyId lake = swWorld_FindWaterBody(world, 1020.0, 10.0);
    assert_true(swWaterBody_IsValid(world, lake));
    assert_string_equal(swWaterBody_Get(world, lake).name, "lake");
    assert_false(swWaterBody_IsValid(world, swWorld_FindWaterBody(world, 900.0, 0.0)));
    double height = swMoment_GetHeight(swWorld_GetMoment(world), 1000.0, 0.0);
    assert_true(height > 39.0 && height < 41.0);
    swDestroyWorld(world);
    swDestroyScene(scene);
}

static void AWaveSystemIsNamedByItsNumber(void** state)
{
    (void)state;
    static const char text[] = "inputs:\n"
                               "  - {field: waves, waves: 2, shape: polygon, value: 0.25,\n"
                               "     points: [[-50, -50], [50, -50], {x_m: 50, z_m: 50}, [-50, 50]]}\n"
                               "waves:\n"
                               "  - beaufort: 2\n"
                               "  - {beaufort: 4, seed: 2}\n";
    swScene* scene = NULL;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    assert_int_equal(scene->inputCount, 1);
    assert_int_equal(scene->inputs[0].waves, 1);
    assert_int_equal(scene->inputs[0].pointCount, 4);
    assert_float_equal(scene->inputs[0].points[2].x, 50.0f, 0.0f);
    swDestroyScene(scene);
}

static void CheckPrinted(const swScene* scene, const char* wanted)
{
    char written[2048] = "";
    size_t size = sizeof(written) - 1;
    if (swPrintScene(scene, written, &size) != SW_SUCCESS)
    {
        fail_msg("not printed: %s", s_messages);
    }
    written[size] = '\0';
    assert_string_equal(written, wanted);
}

// ---- keys ----

// Members of a def that a scene file tells by a key of its own, or not at all because a file cannot have them.
static const struct
{
    const char *member, *key;
} s_others[] = {
    {"name", "name"},
    {"system", "waves"},
    {"waves", "waves"},
    {"raster", "raster"},
    {"mesh", "mesh"},
    {"hull", "hull"},
    {"spline", "spline"},
    {"points", "points"},
    {"pointCount", "points"},
    {"pointCapacity", NULL},
    {"function", NULL},
    {"functionContext", NULL},
    {"functionFingerprint", NULL},
};

// Whether a key of the list is known: whatever is wrong with its value, it is not the key.
static bool IsKey(const char* list, const char* rest, const char* key)
{
    char text[256];
    swScene* scene = NULL;
    snprintf(text, sizeof(text), "%s: [{%s%s: {nonsense: 1}}]\n", list, rest, key);
    s_messages[0] = '\0';
    assert_int_equal(ReadText(text, &scene), SW_ERROR_FORMAT);
    char wanted[64];
    snprintf(wanted, sizeof(wanted), "'%s' is no key", key);
    return strstr(s_messages, wanted) == NULL;
}

static void CheckKeys(const swFields* fields, const char* list, const char* rest)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        const char* key = field->key;
        for (size_t k = 0; k < sizeof(s_others) / sizeof(s_others[0]); ++k)
        {
            bool isOther = key == NULL && strcmp(field->member, s_others[k].member) == 0;
            key = isOther && s_others[k].key != NULL ? s_others[k].key : isOther ? "" : key;
        }
        if (field->type == SW_FIELD_DEF && key == NULL)
        {
            CheckKeys(field->fields, list, rest);
        }
        else if (key == NULL || (key[0] != '\0' && !IsKey(list, rest, key)))
        {
            fail_msg("%s of %s has no key in the list %s:\n%s", field->member, fields->name, list, s_messages);
        }
    }
}

static void EveryMemberOfAnInputHasAKey(void** state)
{
    (void)state;
    assert_false(IsKey("inputs", "field: level, ", "colour_of_the_fish"));
    CheckKeys(swGetInputFields(), "inputs", "field: level, ");
    CheckKeys(swGetWaterBodyFields(), "water_bodies", "");
    CheckKeys(swGetSplineFields(), "splines", "");
    CheckKeys(swGetWindSeaFields(), "wind_seas", "");
}

static void ATideIsToldByItsConstituents(void** state)
{
    (void)state;
    static const char text[] =
        "time_s: 5000\n"
        "inputs:\n"
        "  - {field: level, value: 1, tide: [{constituent: M2, amplitude: 2, phase_deg: 30},\n"
        "                                    {speed_rad_s: 1e-4, amplitude: 0.5}]}\n"
        "  - {field: flow, tide: [{constituent: K1, amplitude: 1, amplitude_across_m_s: 2, phase_across_deg: 90}]}\n";
    swScene* scene = NULL;
    swWorld* world = OpenText(text, &scene);
    const swInputDef *level = &scene->inputs[0].def, *flow = &scene->inputs[1].def;
    assert_float_equal(level->tide[0].speed, 1.4051890e-4f, 1e-9f); // 28.9841042 degrees an hour
    assert_float_equal(level->tide[0].phase, 0.5235988f, 1e-6f);
    assert_float_equal(level->tide[1].speed, 1e-4f, 0.0f);
    const swPosXZ place = {10.0, 20.0};
    float found = 0.0f, wanted = 0.0f, none = 0.0f;
    swVec2 stream, wantedStream;
    const swFieldSamples samples = {.level = &found, .flow = &stream};
    swMoment_QueryFields(swWorld_GetMoment(world), 1, &place, &samples);
    swGetTide(2, level->tide, 5000.0, &wanted, &none);
    swGetTide(1, flow->tide, 5000.0, &wantedStream.x, &wantedStream.y);
    assert_float_equal(found, 1.0f + wanted, 1e-6f);
    assert_float_equal(stream.x, wantedStream.x, 1e-6f);
    assert_float_equal(stream.y, wantedStream.y, 1e-6f);
    assert_true(fabsf(stream.y) > 0.1f && fabsf(wanted) > 0.1f);
    swDestroyWorld(world);
    swDestroyScene(scene);
}

// A flow map has a file for each of its numbers, or a variable of one.
static void ARasterMayHaveSeveralChannelsAndFrames(void** state)
{
    (void)state;
    WriteText("u.asc", "ncols 2\nnrows 4\nxllcenter 0\nyllcenter 0\ncellsize 100\n1 1\n1 1\n3 3\n3 3\n");
    WriteText("v.asc", "ncols 2\nnrows 4\nxllcenter 0\nyllcenter 0\ncellsize 100\n5 5\n5 5\n7 7\n7 7\n");
    static const char text[] = "time_s: 2\n"
                               "rasters: [{name: map, files: [u.asc, v.asc], coordinates: metres, frames: 2}]\n"
                               "inputs: [{field: flow, shape: raster, raster: map, frames_per_s: 0.5, loops: false}]\n";
    swScene* scene = NULL;
    swWorld* world = OpenText(text, &scene);
    swRasterInfo info = swRaster_GetInfo(scene->rasters[0].raster);
    assert_int_equal(info.channels, 2);
    assert_int_equal(info.frames, 2);
    assert_int_equal(info.height, 2);
    const swPosXZ place = {50.0, -250.0};
    swVec2 flow;
    const swFieldSamples samples = {.flow = &flow};
    swMoment_QueryFields(swWorld_GetMoment(world), 1, &place, &samples);
    assert_float_equal(flow.x, 3.0f, 1e-6f);
    assert_float_equal(flow.y, 7.0f, 1e-6f);
    swDestroyWorld(world);
    swDestroyScene(scene);
    remove("u.asc");
    remove("v.asc");
}

static void ANestIsOneInputOfSeveralRasters(void** state)
{
    (void)state;
    WriteText("far.asc", "ncols 5\nnrows 5\nxllcenter -400\nyllcenter -400\ncellsize 200\n"
                         "-90 -90 -90 -90 -90\n-90 -90 -90 -90 -90\n-90 -90 -90 -90 -90\n-90 -90 -90 -90 -90\n"
                         "-90 -90 -90 -90 -90\n");
    WriteText("near.asc", "ncols 5\nnrows 5\nxllcenter -40\nyllcenter -40\ncellsize 20\n"
                          "-5 -5 -5 -5 -5\n-5 -5 -5 -5 -5\n-5 -5 -5 -5 -5\n-5 -5 -5 -5 -5\n-5 -5 -5 -5 -5\n");
    static const char text[] = "rasters:\n"
                               "  - {name: near, file: near.asc, coordinates: metres}\n"
                               "  - {name: far, file: far.asc, coordinates: metres}\n"
                               "  - {name: none, file: none.asc, is_optional: true}\n"
                               "inputs: [{name: chart, field: floor, shape: raster, nest: [near, none, far]}]\n";
    swScene* scene = NULL;
    swHost host = MakeHost();
    swWorld* world = NULL;
    swSceneSea sea;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    assert_int_equal(scene->inputs[0].nestCount, 2);
    assert_int_equal(swOpenScene(&host, scene, &world, &sea), SW_SUCCESS);
    assert_int_equal(sea.nestedCount, 1);
    assert_true(swInput_IsValid(world, sea.inputs[0]) && swInput_IsValid(world, sea.nested[0]));
    const swPosXZ places[2] = {{0.0, 0.0}, {200.0, 100.0}};
    float floors[2];
    const swFieldSamples samples = {.floor = floors};
    swMoment_QueryFields(swWorld_GetMoment(world), 2, places, &samples);
    assert_float_equal(floors[0], -5.0f, 1e-4f);
    assert_float_equal(floors[1], -90.0f, 1e-4f);
    swDestroySceneSea(&sea);
    swDestroyWorld(world);
    swDestroyScene(scene);
    remove("near.asc");
    remove("far.asc");
}

static void AWindSeaOfASceneIsInItsSea(void** state)
{
    (void)state;
    WriteText("u.asc", "ncols 2\nnrows 2\nxllcenter -2000\nyllcenter -2000\ncellsize 4000\n14 6\n14 6\n");
    WriteText("v.asc", "ncols 2\nnrows 2\nxllcenter -2000\nyllcenter -2000\ncellsize 4000\n0 0\n0 0\n");
    static const char text[] = "rasters: [{name: winds, files: [u.asc, v.asc], coordinates: metres}]\n"
                               "wind_seas:\n"
                               "  - raster: winds\n"
                               "    heading_count: 4\n"
                               "    speed_count: 1\n"
                               "    waves: {spectrum: jonswap, fetch_m: 100000, min_wavelength_m: 8}\n";
    swScene* scene = NULL;
    swHost host = MakeHost();
    swWorld* world = NULL;
    swSceneSea sea;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    assert_float_equal(scene->windSeas[0].def.waves.spectrum.fetch, 1e5f, 0.0f);
    assert_int_equal(swOpenScene(&host, scene, &world, &sea), SW_SUCCESS);
    assert_int_equal(sea.windSeaCount, 1);
    assert_true(sea.windSeas[0].count >= 1);
    float weights[2];
    const swPosXZ places[2] = {{-1900.0, 0.0}, {1900.0, 0.0}};
    const swFieldSamples samples = {.weight = weights, .system = sea.windSeas[0].systems[0]};
    swMoment_QueryFields(swWorld_GetMoment(world), 2, places, &samples);
    assert_true(weights[0] > 2.0f * weights[1] && weights[1] > 0.0f); // less wind in the east
    swDestroySceneSea(&sea);
    swDestroyWorld(world);
    swDestroyScene(scene);
    remove("u.asc");
    remove("v.asc");
}

static void ABodyOfWaterHasALookOfTheScene(void** state)
{
    (void)state;
    static const char text[] = "looks: [{absorption_per_m: [1, 2, 3]}, {scattering_per_m: [0.5, 0.5, 0.5]}]\n"
                               "water_bodies: [{points: [[0, 0], [9, 0], [0, 9]], look: 2}]\n";
    swScene* scene = NULL;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    assert_int_equal(scene->lookCount, 2);
    assert_float_equal(scene->looks[0].absorption.y, 2.0f, 0.0f);
    assert_float_equal(scene->looks[1].scattering.x, 0.5f, 0.0f);
    assert_int_equal(scene->waterBodies[0].def.look, 2);
    swDestroyScene(scene);
}

static void FailingMemoryLeavesNothingBehind(void** state)
{
    (void)state;
    WriteText("u.asc", "ncols 2\nnrows 2\nxllcenter -2000\nyllcenter -2000\ncellsize 4000\n14 6\n14 6\n");
    static const char text[] =
        "rasters:\n"
        "  - {name: winds, files: [u.asc, u.asc], coordinates: metres}\n"
        "  - {name: chart, file: u.asc, coordinates: metres}\n"
        "  - {name: frames, file: u.asc, coordinates: metres, frames: 2}\n"
        "looks: [{absorption_per_m: [1, 2, 3]}]\n"
        "wind_seas: [{raster: winds, waves: {components: [{wavelength_m: 9, amplitude_m: 1,\n"
        "  direction_from_deg: 0}]}}]\n"
        "inputs:\n"
        "  - {field: floor, shape: raster, nest: [chart, chart]}\n"
        "  - {field: level, shape: raster, raster: frames, tide: [{constituent: M2, amplitude: 1}]}\n";
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swScene* scene = NULL;
    assert_int_equal(swReadSceneText(&host, text, strlen(text), "a.yaml", ".", &scene), SW_SUCCESS);
    swDestroyScene(scene);
    assert_int_equal(atomic_load(&memory.bytes), 0);
    long long allocations = atomic_load(&memory.allocations);
    assert_true(allocations > 15);
    for (long long i = 0; i < allocations; ++i)
    {
        atomic_store(&memory.allocations, 0);
        atomic_store(&memory.failAt, i);
        assert_int_equal(swReadSceneText(&host, text, strlen(text), "a.yaml", ".", &scene), SW_ERROR_NO_MEMORY);
        assert_null(scene);
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
    remove("u.asc");
}

#if SW_HAS_ASSIMP
static void AHullOfASceneCutsWater(void** state)
{
    (void)state;
    WriteText("box.obj", "v -10 -5 -4\nv 10 -5 -4\nv 10 -5 4\nv -10 -5 4\n"
                         "v -10 5 -4\nv 10 5 -4\nv 10 5 4\nv -10 5 4\n"
                         "f 1 2 3\nf 1 3 4\nf 5 7 6\nf 5 8 7\nf 1 5 6\nf 1 6 2\n"
                         "f 2 6 7\nf 2 7 3\nf 3 7 8\nf 3 8 4\nf 4 8 5\nf 4 5 1\n");
    static const char text[] = "hulls: [{name: box, file: box.obj, resolution: 32}]\n"
                               "inputs: [{field: clip, shape: hull, hull: box, value: 1, scale: [2, 1, 1]}]\n";
    swScene* scene = NULL;
    swWorld* world = OpenText(text, &scene);
    const swPosXZ places[3] = {{18.0, 3.0}, {22.0, 0.0}, {0.0, 5.0}};
    float clip[3];
    const swFieldSamples samples = {.clip = clip};
    swMoment_QueryFields(swWorld_GetMoment(world), 3, places, &samples);
    assert_true(clip[0] > 0.5f && clip[1] < 0.5f && clip[2] < 0.5f);
    swDestroyWorld(world);
    swDestroyScene(scene);
    static const char open[] = "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n";
    WriteText("box.obj", open);
    s_messages[0] = '\0';
    assert_int_equal(ReadText("hulls:\n  - {name: box, file: box.obj}\n", &scene), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "a.yaml:2: the hull 'box' cannot be made of box.obj"));
    remove("box.obj");
}
#endif

// A scene is written with its inputs as they stand.
static void WritingLeavesInputsAsTheyStand(void** state)
{
    (void)state;
    static const char text[] = "name: a\n"
                               "inputs: # all of them\n"
                               "  - {field: level, value: 1.50} # a metre and a half\n"
                               "waves:\n"
                               "  - beaufort: 2\n";
    swScene* scene = NULL;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    snprintf(scene->name, sizeof(scene->name), "b");
    char written[1024] = "";
    size_t size = sizeof(written);
    assert_int_equal(swPrintScene(scene, written, &size), SW_SUCCESS);
    assert_int_equal(size, strlen(text));
    assert_memory_equal(written + 8, text + 8, size - 8);
    assert_int_equal(written[6], 'b');
    swDestroyScene(scene);
}

// Numbers of waves follow, and what weighed the removed waves goes with them.
static void RemovedWavesAreNotWrittenUnderAnothersNumber(void** state)
{
    (void)state;
    static const char text[] = "waves: [{beaufort: 2}, {beaufort: 4, seed: 2}, {beaufort: 5, seed: 3}]\n"
                               "water_bodies: [{waves: 1, points: [[0, 0], [1, 0], [0, 1]]}]\n"
                               "inputs: [{field: waves, waves: 3, value: 0.5}, {field: waves, waves: 1, value: 0.5}]\n";
    swScene* scene = NULL;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    swScene_RemoveWaves(scene, 0);
    assert_int_equal(scene->inputs[0].waves, 1);
    assert_false(scene->inputs[0].isLeftOut);
    assert_true(scene->inputs[1].isLeftOut);
    CheckPrinted(scene, "waves: [{beaufort: 4, seed: 2}, {beaufort: 5, seed: 3}]\n"
                        "water_bodies: [{points: [[0, 0], [1, 0], [0, 1]]}]\n"
                        "inputs: [{field: waves, waves: 2, value: 0.5}]\n");
    swDestroyScene(scene);
}

// Every line but those of what was changed keeps its bytes, also keys that the tables do not tell of.
static void ChangedInputsAreWritten(void** state)
{
    (void)state;
    static const char text[] = "splines:\n"
                               "  - {name: s, points: [{x_m: 0, z_m: 0}, {x_m: 9, z_m: 0}]}\n"
                               "inputs: # all of them\n"
                               "  - field: level # a lake\n"
                               "    value: 1.50 # a metre and a half\n"
                               "    shape: polygon\n"
                               "    points: [[0, 0], [9, 0], {x_m: 0, z_m: 9}] # its shore\n"
                               "  - {field: flow, value: [1, 2.0], shape: spline, spline: s}\n"
                               "  - field: foam\n"
                               "    is_enabled: false\n"
                               "\n"
                               "water_bodies:\n"
                               "  - {name: 'pond', points: [[0, 0], [1, 0], [0, 1]]}\n";
    swScene* scene = NULL;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    CheckPrinted(scene, text);
    scene->inputs[0].def.value[0] = 2.25f;
    scene->inputs[0].def.position.y = 3.0;
    scene->inputs[1].def.value[0] = 0.0f;
    scene->inputs[1].def.weight = 0.5f;
    scene->inputs[2].def.isEnabled = true;
    scene->inputs[2].def.value[0] = 0.75f;
    scene->inputs[2].def.blend = SW_BLEND_MAX;
    scene->waterBodies[0].def.position.y = -1.0;
    scene->waterBodies[0].def.isCalm = true;
    CheckPrinted(scene,
                 "splines:\n"
                 "  - {name: s, points: [{x_m: 0, z_m: 0}, {x_m: 9, z_m: 0}]}\n"
                 "inputs: # all of them\n"
                 "  - field: level # a lake\n"
                 "    value: 2.25 # a metre and a half\n"
                 "    shape: polygon\n"
                 "    points: [[0, 0], [9, 0], {x_m: 0, z_m: 9}] # its shore\n"
                 "    position_m: [0, 3, 0]\n"
                 "  - {field: flow, value: [0, 2.0], shape: spline, spline: s, weight: 0.5}\n"
                 "  - field: foam\n"
                 "    is_enabled: true\n"
                 "    blend: max\n"
                 "    value: 0.75\n"
                 "\n"
                 "water_bodies:\n"
                 "  - {name: 'pond', points: [[0, 0], [1, 0], [0, 1]], position_m: [0, -1, 0], is_calm: true}\n");
    scene->inputs[0].def.weight = -1.0f;
    size_t size = 0;
    assert_int_equal(swPrintScene(scene, NULL, &size), SW_ERROR_INVALID);
    swDestroyScene(scene);
}

static void PointsAndTidesAreWritten(void** state)
{
    (void)state;
    static const char text[] =
        "inputs:\n"
        "  - field: foam\n"
        "    shape: particles\n"
        "    points:\n"
        "      - [0, 0] # first\n"
        "      - [5, 5]\n"
        "      - {x_m: 9, z_m: 9, value: 2} # last\n"
        "  - {field: level, tide: [{constituent: M2, amplitude: 1.0}, {speed_rad_s: 1e-4, amplitude: 2}]}\n"
        "water_bodies:\n"
        "  - {points: [[0, 0], [9, 0], [0, 9.0]], tide: [{constituent: K1, amplitude: 1}]}\n";
    swScene* scene = NULL;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    CheckPrinted(scene, text);
    scene->inputs[0].points[0].x = 1.5f;
    scene->inputs[0].points[1].radius = 3.0f; // no pair any more
    scene->inputs[0].points[2].value[0] = 4.0f;
    scene->inputs[1].def.tide[0].phase = 0.52359878f;
    swSetTideConstituent("S2", 0.5f, 0.0f, &scene->inputs[1].def.tide[2]);
    scene->waterBodies[0].points[1].x = 8.0f;
    scene->waterBodies[0].def.tide[0] = (swTideConstituent){0};
    CheckPrinted(scene, "inputs:\n"
                        "  - field: foam\n"
                        "    shape: particles\n"
                        "    points:\n"
                        "      - [1.5, 0] # first\n"
                        "      - {x_m: 5, z_m: 5, radius_m: 3}\n"
                        "      - {x_m: 9, z_m: 9, value: 4} # last\n"
                        "  - {field: level, tide: [{constituent: M2, amplitude: 1.0, phase_deg: 30}, {speed_rad_s: "
                        "1e-4, amplitude: 2}, "
                        "{constituent: S2, amplitude: 0.5}]}\n"
                        "water_bodies:\n"
                        "  - {points: [[0, 0], [8, 0], [0, 9.0]], tide: []}\n");
    const swInputPoint points[2] = {{.x = 5.0f, .z = 5.0f, .radius = 3.0f, .weight = 1.0f},
                                    {.x = 7.0f, .z = 7.0f, .weight = 1.0f}};
    assert_int_equal(swScene_SetInputPoints(scene, 0, 2, points), SW_SUCCESS);
    char written[2048] = "";
    size_t size = sizeof(written) - 1;
    assert_int_equal(swPrintScene(scene, written, &size), SW_SUCCESS);
    assert_non_null(strstr(written, "    points:\n      - {x_m: 5, z_m: 5, radius_m: 3}\n      - [7, 7]"));
    swDestroyScene(scene);
}

// What is made anew says all that it needs, also the names of what it uses.
static void InputsComeAndGo(void** state)
{
    (void)state;
    static const char text[] = "splines: [{name: river, points: [{x_m: 0}, {x_m: 9}]}]\n"
                               "waves: [{beaufort: 2}]\n"
                               "inputs:\n"
                               "  - {field: level, value: 1}\n"
                               "  - {field: foam, value: 2} # a patch\n";
    static const swInputPoint shore[3] = {{.x = 0.0f}, {.x = 9.0f}, {.z = 9.0f}};
    swScene* scene = NULL;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    swInputDef def = swDefaultInputDef();
    snprintf(def.name, sizeof(def.name), "bed");
    def.shape = SW_SHAPE_SPLINE;
    def.spline = scene->splines[0].spline;
    def.value[0] = -3.0f;
    assert_int_equal(swScene_AddInput(scene, &def, -1), SW_SUCCESS);
    def = swDefaultInputDef();
    def.field = SW_INPUT_WAVES;
    def.shape = SW_SHAPE_POLYGON;
    def.value[0] = 0.5f;
    def.points = shore;
    def.pointCount = 3;
    assert_int_equal(swScene_AddInput(scene, &def, 0), SW_SUCCESS);
    swScene_RemoveInput(scene, 0);
    assert_int_equal(scene->inputCount, 3);
    static const char wanted[] =
        "splines: [{name: river, points: [{x_m: 0}, {x_m: 9}]}]\n"
        "waves: [{beaufort: 2}]\n"
        "inputs:\n"
        "  - {field: foam, value: 2} # a patch\n"
        "  - name: bed\n"
        "    field: floor\n"
        "    shape: spline\n"
        "    value: -3\n"
        "    spline: river\n"
        "  - field: waves\n"
        "    shape: polygon\n"
        "    value: 0.5\n"
        "    waves: 1\n"
        "    points: [{x_m: 0, z_m: 0, weight: 0}, {x_m: 9, z_m: 0, weight: 0}, {x_m: 0, z_m: 9, weight: 0}]\n";
    CheckPrinted(scene, wanted);
    def.shape = SW_SHAPE_FUNCTION;
    assert_int_equal(swScene_AddInput(scene, &def, -1), SW_ERROR_UNSUPPORTED);
    def = swDefaultInputDef();
    assert_int_equal(swScene_AddInput(scene, &def, 1), SW_ERROR_INVALID); // no such waves
    def.shape = SW_SHAPE_SPLINE;
    assert_int_equal(swScene_AddInput(scene, &def, -1), SW_ERROR_INVALID); // no spline of the scene
    def = swDefaultInputDef();
    def.weight = -1.0f;
    assert_int_equal(swScene_AddInput(scene, &def, -1), SW_ERROR_INVALID);
    assert_int_equal(scene->inputCount, 3);
    swDestroyScene(scene);
    assert_int_equal(ReadText(wanted, &scene), SW_SUCCESS);
    swDestroyScene(scene);
}

// Another field or another shape takes what only the old one has out of the text.
static void AnotherFieldOrShapeIsWritten(void** state)
{
    (void)state;
    static const char text[] = "inputs:\n"
                               "  - {field: level, value: 1, shape: circle, feather_m: 3, size_m: [9, 0, 9]} # a pond\n"
                               "  - field: flow\n"
                               "    value: [1, 2]\n";
    swScene* scene = NULL;
    assert_int_equal(ReadText(text, &scene), SW_SUCCESS);
    scene->inputs[0].def.shape = SW_SHAPE_EVERYWHERE;
    scene->inputs[1].def.field = SW_INPUT_FOAM;
    CheckPrinted(scene, "inputs:\n"
                        "  - {field: level, value: 1, shape: everywhere} # a pond\n"
                        "  - field: foam\n"
                        "    value: 1\n");
    scene->inputs[0].def.shape = SW_SHAPE_RECTANGLE;
    scene->inputs[1].def.field = SW_INPUT_DISPLACEMENT;
    scene->inputs[1].def.value[2] = 3.0f;
    CheckPrinted(scene, "inputs:\n"
                        "  - {field: level, value: 1, shape: rectangle, feather_m: 3, size_m: [9, 0, 9]} # a pond\n"
                        "  - field: displacement\n"
                        "    value: [1, 2, 3]\n");
    swDestroyScene(scene);
}

// Each text has one mistake.
static void EveryMistakeHasItsLineAndCode(void** state)
{
    (void)state;
    static const struct
    {
        const char* text;
        int line;
        const char* code;
    } cases[] = {
        {"inputs:\n  - {value: 3}\n", 2, "missing_key"},
        {"inputs:\n  - {field: levl}\n", 2, "unknown_word"},
        {"inputs:\n  - {field: level, shape: raster}\n", 2, "missing_key"},
        {"inputs:\n  - field: level\n    raster: a\n", 3, "no_effect"},
        {"inputs:\n  - field: level\n    shape: raster\n    raster: a\n", 4, "unknown_word"},
        {"inputs:\n  - field: level\n    value: [1, 2]\n", 3, "wrong_form"},
        {"inputs:\n  - field: flow\n    value: 1\n", 3, "wrong_form"},
        {"inputs:\n  - field: level\n    value: 1e9\n", 3, "out_of_range"},
        {"inputs:\n  - field: level\n    feather_m: 3\n", 3, "no_effect"},
        {"inputs:\n  - field: level\n    waves: 1\n", 3, "no_effect"},
        {"inputs:\n  - field: waves\n    waves: 1\n", 3, "out_of_range"},
        {"inputs:\n  - field: level\n    shape: polygon\n    points: [[1, 2, 3], [1, 2], [0, 3]]\n", 4, "wrong_form"},
        {"inputs:\n  - field: level\n    shape: polygon\n    points: [[0, 0], [1, 2], {x: 3}]\n", 4, "unknown_key"},
        {"inputs:\n  - 3\n", 2, "wrong_form"},
        {"splines:\n  - {name: a}\n", 2, "missing_key"},
        {"splines:\n  - {points: [{x_m: 1}, {x_m: 9}]}\n", 2, "missing_key"},
        {"splines:\n  - {name: a, points: [{x_m: 1}]}\n", 2, "out_of_range"},
        {"splines:\n  - name: a\n    points: [{x_m: 1}, {x_m: 9, heat: 3}]\n", 3, "unknown_key"},
        {"splines:\n  - {name: a, points: [{x_m: 1}, {x_m: 9}]}\n  - {name: a, points: [{x_m: 1}, {x_m: 9}]}\n", 3,
         "repeated"},
        {"water_bodies:\n  - {name: a}\n", 2, "missing_key"},
        {"water_bodies:\n  - points: [[0, 0], [9, 0], [0, 9]]\n    waves: 1\n", 3, "out_of_range"},
        {"inputs:\n  - {field: level, shape: function}\n", 2, "unknown_word"},
        {"inputs:\n  - {field: clip, shape: hull}\n", 2, "missing_key"},
        {"inputs:\n  - field: clip\n    shape: hull\n    hull: none\n", 4, "unknown_word"},
        {"inputs:\n  - field: foam\n    tide: [{constituent: M2}]\n", 3, "no_effect"},
        {"inputs:\n  - field: level\n    tide: [{constituent: M17}]\n", 3, "unknown_word"},
        {"inputs:\n  - field: level\n    tide: [{amplitude: 1}]\n", 3, "missing_key"},
        {"inputs:\n  - field: level\n    tide:\n      - {constituent: M2, speed_rad_s: 1e-4}\n", 4, "conflict"},
        {"inputs:\n  - field: level\n    tide: [{constituent: M2, amplitude_across_m_s: 1}]\n", 3, "no_effect"},
        {"inputs:\n  - field: level\n    nest: [a]\n", 3, "no_effect"},
        {"inputs:\n  - field: level\n    shape: raster\n    nest: [a]\n", 4, "unknown_word"},
        {"inputs:\n  - field: level\n    shape: raster\n    nest: []\n", 4, "missing_key"},
        {"hulls:\n  - {name: a}\n", 2, "missing_key"},
        {"hulls:\n  - name: a\n    file: none.obj\n", 3, "bad_file"},
        {"looks:\n  - {colour: blue}\n", 2, "unknown_key"},
        {"water_bodies:\n  - points: [[0, 0], [9, 0], [0, 9]]\n    look: 1\n", 3, "out_of_range"},
        {"wind_seas:\n  - {gain: 1}\n", 2, "missing_key"},
        {"wind_seas:\n  - {raster: a}\n", 2, "unknown_word"},
        {"rasters:\n  - name: a\n    files: [a.asc, b.asc]\n    variables: [u, v]\n", 4, "conflict"},
        {"rasters:\n  - name: a\n    file: a.asc\n    files: [b.asc]\n", 3, "conflict"},
        {"rasters:\n  - {file: a.asc}\n", 2, "missing_key"},
        {"rasters:\n  - {name: a}\n", 2, "missing_key"},
        {"rasters:\n  - name: a\n    file: none.asc\n", 3, "bad_file"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swScene* scene = NULL;
        char wanted[64];
        s_messages[0] = '\0';
        assert_int_equal(ReadText(cases[i].text, &scene), SW_ERROR_FORMAT);
        assert_null(scene);
        snprintf(wanted, sizeof(wanted), "a.yaml:%d: ", cases[i].line);
        const char* message = strstr(s_messages, wanted);
        if (message == NULL || strstr(message, cases[i].code) == NULL)
        {
            fail_msg("case %d: wanted line %d [%s], found:\n%s", (int)i, cases[i].line, cases[i].code, s_messages);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(InputsOfASceneAreInItsSea),
        cmocka_unit_test(ASplineOfASceneIsNamedByItsInputs),
        cmocka_unit_test(ABodyOfWaterOfASceneIsInItsSea),
        cmocka_unit_test(AWaveSystemIsNamedByItsNumber),
        cmocka_unit_test(EveryMemberOfAnInputHasAKey),
        cmocka_unit_test(ATideIsToldByItsConstituents),
        cmocka_unit_test(ARasterMayHaveSeveralChannelsAndFrames),
        cmocka_unit_test(ANestIsOneInputOfSeveralRasters),
        cmocka_unit_test(AWindSeaOfASceneIsInItsSea),
        cmocka_unit_test(ABodyOfWaterHasALookOfTheScene),
        cmocka_unit_test(FailingMemoryLeavesNothingBehind),
#if SW_HAS_ASSIMP
        cmocka_unit_test(AHullOfASceneCutsWater),
#endif
        cmocka_unit_test(WritingLeavesInputsAsTheyStand),
        cmocka_unit_test(RemovedWavesAreNotWrittenUnderAnothersNumber),
        cmocka_unit_test(ChangedInputsAreWritten),
        cmocka_unit_test(PointsAndTidesAreWritten),
        cmocka_unit_test(InputsComeAndGo),
        cmocka_unit_test(AnotherFieldOrShapeIsWritten),
        cmocka_unit_test(EveryMistakeHasItsLineAndCode),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
