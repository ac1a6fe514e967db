// SPDX-License-Identifier: MIT
// Rasters and inputs in scene files: what they say is in the sea, and every mistake has its line and code.

#include "support/cmocka_setup.h"
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
    assert_int_equal(swPrintScene(scene, written, &size), SW_SUCCESS);
    written[size] = '\0';
    assert_string_equal(written, wanted);
}

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
    CheckPrinted(scene, "splines:\n"
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
        cmocka_unit_test(WritingLeavesInputsAsTheyStand),
        cmocka_unit_test(RemovedWavesAreNotWrittenUnderAnothersNumber),
        cmocka_unit_test(ChangedInputsAreWritten),
        cmocka_unit_test(EveryMistakeHasItsLineAndCode),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
