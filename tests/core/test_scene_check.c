// SPDX-License-Identifier: MIT
// Every remark of src/scene/remarks.inl has a scene that it is made of, on the right line, and no other remark is.

#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <stdio.h>
#include <string.h>

#include "seaway/files.h"
#include "seaway/scene.h"

static void WriteText(const char* path, const char* text)
{
    FILE* file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

// A spectrum without directions beside it.
#define BUOY                                                                                                           \
    "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) spec_3 (freq_3) ... >\n"                             \
    "2024 11 16 06 50 0.117 0.209 (0.063) 1.996 (0.078) 3.001 (0.100) 6.906 (0.130) 1.311 (0.170) 0.795 (0.200)\n"

#define VIEWS "views: [{name: a}]\n"
#define WAVES "waves: [{beaufort: 4}]\n"
#define FINE VIEWS WAVES // two lines

static const struct
{
    const char* code;
    int line;
    const char* text;
} scenes[] = {
    {"no_views", 1, WAVES},
    {"no_views", 2, WAVES "views: []\n"},
    {"flat", 1, VIEWS},
    {"flat", 2, VIEWS "waves: []\n"},
    {"flat", 2, VIEWS "waves: [{spectrum: jonswap, weight: 0}]\n"},
    {"no_region", 3, VIEWS "waves:\n  - {beaufort: 4, is_local: true}\n"},
    {"other_wind", 4, VIEWS "wind: {speed_mps: 20}\nwaves:\n  - {beaufort: 4}\n"},
    {"foam_filter", 2, VIEWS "foam: {min_wavelength_m: 900}\nwaves: [{beaufort: 4, max_wavelength_m: 512}]\n"},
    {"coarse_view", 3, FINE "view: {resolution: 64}\n"},
    {"view_in_floor", 3, WAVES "views:\n  - {name: a, position_m: [0, 2, 0]}\ninputs: [{field: floor, value: 5}]\n"},
    {"disabled_input", 4, FINE "inputs:\n  - {field: level, value: 1, is_enabled: false}\n"},
    {"empty_input", 4, FINE "inputs:\n  - {field: level, value: 1, weight: 0}\n"},
    {"empty_input", 4, FINE "inputs:\n  - {field: level, blend: add}\n"},
    {"tilted_input", 4, FINE "inputs:\n  - {field: level, value: 1, shape: circle, rotation_deg: [0, 10, 0]}\n"},
    {"covered_input", 4,
     FINE "inputs:\n  - {field: level, value: 1, shape: circle}\n  - {field: level, value: 2, blend: replace}\n"},
    {"fast_flow", 4, FINE "inputs:\n  - {field: flow, value: [20, 0]}\n"},
    {"tilted_input", 4,
     FINE "inputs:\n  - {field: level, value: 1, shape: circle, motion: {turn_rate_deg_per_s: [0, 10, 0]}}\n"},
    {"fast_motion", 4,
     FINE "inputs:\n  - {field: level, value: 1, shape: circle, motion: {velocity_mps: [60, 0, 0]}}\n"},
    {"fast_motion", 4,
     FINE "inputs:\n  - {field: level, value: 1, shape: circle,\n"
          "     motion: {path: [{}, {time_s: 1, moved_m: [0, 0, 40]}], is_smooth: true}}\n"},
    {NULL, 0,
     FINE "inputs:\n  - {field: level, value: 1, shape: circle,\n"
          "     motion: {path: [{}, {time_s: 1, moved_m: [0, 0, 40]}]}}\n"},
    {"wind_of_queries", 4, FINE "inputs:\n  - {field: wind, value: [3, 0], shape: circle}\n"},
    {"spare_channels", 5,
     FINE "rasters: [{name: a, files: [fine.asc, fine.asc], coordinates: metres}]\n"
          "inputs:\n  - {field: level, shape: raster, raster: a}\n"},
    {NULL, 0,
     FINE "rasters: [{name: a, files: [fine.asc, fine.asc], coordinates: metres}]\n"
          "inputs:\n  - {field: flow, shape: raster, raster: a}\n"},
    {"standing_frames", 5,
     FINE "rasters: [{name: a, file: frames.asc, frames: 2, coordinates: metres}]\n"
          "inputs:\n  - {field: level, shape: raster, raster: a}\n"},
    {NULL, 0,
     FINE "rasters: [{name: a, file: frames.asc, frames: 2, coordinates: metres}]\n"
          "inputs:\n  - {field: level, shape: raster, raster: a, frames_per_s: 1}\n"},
    {"tiny_floor", 5,
     FINE "rasters: [{name: a, file: tiny.asc, coordinates: metres}]\n"
          "inputs:\n  - {field: floor, shape: raster, raster: a}\n"},
    {"small_body", 4, FINE "water_bodies:\n  - {points: [[0, 0], [1.5, 0], [0, 1.5]]}\n"},
    {"unused_look", 3, FINE "looks: [{}]\nwater_bodies: [{points: [[0, 0], [9, 0], [0, 9]]}]\n"},
    {NULL, 0, FINE "looks: [{}]\nwater_bodies: [{points: [[0, 0], [9, 0], [0, 9]], look: 1}]\n"},
    {"left_out", 4,
     FINE "rasters:\n  - {name: a, file: none.asc, is_optional: true}\n"
          "inputs: [{field: floor, shape: raster, raster: a}]\n"},
    {"no_directions", 3, VIEWS "waves:\n  - {spectrum: file, file: buoy.data_spec}\n"},
#if SW_HAS_ASSIMP
    {"upright_mesh", 4,
     FINE "meshes:\n  - {name: a, file: wall.obj}\ninputs: [{field: floor, shape: mesh, mesh: a}]\n"},
    {"upright_mesh", 4,
     FINE "meshes:\n  - {name: a, file: box.obj, highest_m: -9}\ninputs: [{field: floor, shape: mesh, mesh: a}]\n"},
    {"unused_mesh", 4, FINE "meshes:\n  - {name: a, file: box.obj}\n"},
    {"unused_hull", 4, FINE "hulls:\n  - {name: a, file: box.obj, resolution: 8}\n"},
    {NULL, 0,
     FINE "meshes: [{name: a, file: box.obj}]\nhulls: [{name: a, file: box.obj, resolution: 8}]\n"
          "inputs: [{field: clip, shape: hull, hull: a, value: 1}, {field: floor, shape: mesh, mesh: a}]\n"},
#endif
    {"small_raster", 4,
     FINE "rasters:\n  - {name: a, file: small.asc, coordinates: metres}\n"
          "inputs: [{field: floor, shape: raster, raster: a}]\n"},
    {"unknown_raster", 4,
     FINE "rasters:\n  - {name: a, file: unknown.asc, coordinates: metres}\n"
          "inputs: [{field: floor, shape: raster, raster: a}]\n"},
    {"stale_raster", 4,
     FINE "rasters:\n  - {name: a, file: fine.asc, coordinates: metres, made_from: none.yaml}\n"
          "inputs: [{field: floor, shape: raster, raster: a}]\n"},
    {"level_over_body", 5,
     FINE "water_bodies: [{points: [[0, 0], [9, 0], [0, 9]]}]\n"
          "inputs:\n  - {field: level, blend: add, tide: [{constituent: M2, amplitude: 1}]}\n"},
    {NULL, 0,
     FINE "water_bodies: [{points: [[0, 0], [9, 0], [0, 9]], order: 1}]\n"
          "inputs:\n  - {field: level, blend: add, tide: [{constituent: M2, amplitude: 1}]}\n"},
    {"unused_raster", 4, FINE "rasters:\n  - {name: a, file: fine.asc, coordinates: metres}\n"},
    {"unused_spline", 4, FINE "splines:\n  - {name: a, points: [{x_m: 0}, {x_m: 500}]}\n"},
    {"narrow_bend", 4,
     FINE "splines:\n  - {name: a, width_m: 90, points: [{x_m: 0}, {x_m: 50}, {x_m: 50, z_m: 50}, {x_m: 0, z_m: 50}]}\n"
          "inputs: [{field: level, shape: spline, spline: a}]\n"},
    {"narrow_bend", 4,
     FINE "splines:\n  - {name: a, width_m: 90, offset: right, points: [{x_m: 0}, {x_m: 50}, {x_m: 50, z_m: 50}]}\n"
          "inputs: [{field: level, shape: spline, spline: a}]\n"},
    {NULL, 0,
     FINE "splines:\n  - {name: a, width_m: 90, offset: left, points: [{x_m: 0}, {x_m: 50}, {x_m: 50, z_m: 50}]}\n"
          "inputs: [{field: level, shape: spline, spline: a}]\n"},
    {NULL, 0, FINE},
    {NULL, 0,
     VIEWS "waves: [{beaufort: 4}, {beaufort: 2, seed: 2, is_local: true}]\n"
           "water_bodies: [{points: [[0, 0], [9, 0], [0, 9]], waves: 2}]\n"},
    {NULL, 0,
     VIEWS "rasters: [{name: a, files: [fine.asc, fine.asc], coordinates: metres}]\n"
           "wind_seas: [{raster: a, heading_count: 4, speed_count: 1}]\n"},
    {NULL, 0,
     FINE "rasters: [{name: a, file: fine.asc, coordinates: metres}]\n"
          "inputs: [{field: floor, shape: raster, nest: [a]},\n"
          "  {field: level, blend: add, tide: [{constituent: M2, amplitude: 1}]}]\n"},
    {NULL, 0, FINE "inputs: [{field: level, value: 1}, {field: waves, waves: 1, value: 0.5}]\n"},
};

static void WriteFiles(void)
{
    WriteText("tiny.asc", "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 0.25\n"
                          "-9 -9 -9 -9\n-9 -8 -9 -9\n-9 -9 -7 -9\n-9 -9 -9 -9\n");
    WriteText("frames.asc", "ncols 4\nnrows 8\nxllcorner 0\nyllcorner 0\ncellsize 10\n"
                            "1 1 1 1\n1 1 1 1\n1 1 1 1\n1 1 1 1\n2 2 2 2\n2 2 2 2\n2 2 2 2\n2 2 2 2\n");
    WriteText("box.obj", "v -10 -5 -4\nv 10 -5 -4\nv 10 -5 4\nv -10 -5 4\n"
                         "v -10 5 -4\nv 10 5 -4\nv 10 5 4\nv -10 5 4\n"
                         "f 1 2 3\nf 1 3 4\nf 5 7 6\nf 5 8 7\nf 1 5 6\nf 1 6 2\n"
                         "f 2 6 7\nf 2 7 3\nf 3 7 8\nf 3 8 4\nf 4 8 5\nf 4 5 1\n");
    WriteText("wall.obj", "v 0 0 0\nv 0 9 0\nv 0 9 9\nf 1 2 3\n");
    WriteText("buoy.data_spec", BUOY);
    WriteText("small.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n-9 -9\n-9 -9\n");
    WriteText("unknown.asc", "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9\n"
                             "-9 -9 -9 -9\n-9 -9 -9 -9\n-9 -9 -9 -9\n-9 -9 -9 -9\n");
    WriteText("fine.asc", "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 10\n"
                          "-9 -9 -9 -9\n-9 -8 -9 -9\n-9 -9 -7 -9\n-9 -9 -9 -9\n");
}

static void RemoveFiles(void)
{
    static const char* const files[] = {"tiny.asc",  "frames.asc",     "box.obj",     "wall.obj",
                                        "small.asc", "buoy.data_spec", "unknown.asc", "fine.asc"};
    for (size_t i = 0; i < sizeof(files) / sizeof(files[0]); ++i)
    {
        remove(files[i]);
    }
}

static void EveryRemarkIsMadeOfItsScene(void** state)
{
    (void)state;
    WriteFiles();
    for (size_t i = 0; i < sizeof(scenes) / sizeof(scenes[0]); ++i)
    {
        swHost host = MakeHost();
        swScene* scene = NULL;
        swWorld* world = NULL;
        swSceneRemark remarks[4];
        swResult result = swReadSceneText(&host, scenes[i].text, strlen(scenes[i].text), "a.yaml", ".", &scene);
        result = result == SW_SUCCESS ? swCreateSceneWorld(&host, scene, &world) : result;
        if (result != SW_SUCCESS)
        {
            fail_msg("scene %d cannot be opened:\n%s", (int)i, s_messages);
        }
        int count = swScene_Check(scene, world, 4, remarks);
        bool isRight = scenes[i].code == NULL ? count == 0
                                              : count == 1 && strcmp(remarks[0].code, scenes[i].code) == 0 &&
                                                    remarks[0].line == scenes[i].line;
        for (int k = 0; k < count && k < 4 && !isRight; ++k)
        {
            print_message("  line %d: %s [%s]\n", remarks[k].line, remarks[k].text, remarks[k].code);
        }
        if (!isRight)
        {
            fail_msg("scene %d: wanted [%s] on line %d alone, found %d", (int)i,
                     scenes[i].code != NULL ? scenes[i].code : "nothing", scenes[i].line, count);
        }
        assert_int_equal(swScene_Check(scene, world, 0, NULL), count);
        swDestroyWorld(world);
        swDestroyScene(scene);
    }
    RemoveFiles();
}

#define GROUND "views: [{name: a}]\nwaves: [{beaufort: 4}]\ninputs: [{field: floor, shape: circle, "
#define CHART                                                                                                          \
    FINE "rasters:\n  - {name: a, file: baked.exr, made_from: ground.yaml}\ninputs: [{field: floor, shape: raster, "   \
         "raster: a}]\n"

static int CountStale(void)
{
    swHost host = MakeHost();
    swScene* scene = NULL;
    swSceneRemark remarks[4];
    assert_int_equal(swReadSceneText(&host, CHART, strlen(CHART), "a.yaml", ".", &scene), SW_SUCCESS);
    int count = swScene_Check(scene, NULL, 4, remarks);
    int stale = 0;
    for (int i = 0; i < count && i < 4; ++i)
    {
        stale += strcmp(remarks[i].code, "stale_raster") == 0 ? 1 : 0;
    }
    assert_int_equal(count, stale); // and no other
    swDestroyScene(scene);
    return stale;
}

// Bakes ground.yaml on a lattice that is no round number.
static swResult Bake(void)
{
    swHost host = MakeHost();
    swScene* scene = NULL;
    swWorld* world = NULL;
    swRaster* raster = NULL;
    assert_int_equal(swReadScene(&host, "ground.yaml", &scene), SW_SUCCESS);
    assert_int_equal(swCreateSceneWorld(&host, scene, &world), SW_SUCCESS);
    swRasterDef lattice = swDefaultRasterDef();
    lattice.width = 9;
    lattice.height = 7;
    lattice.x = -10.1;
    lattice.z = 1.0 / 3.0;
    lattice.spacingX = 3.3;
    lattice.spacingZ = 1.7;
    assert_int_equal(swBakeFloor(world, &lattice, &raster), SW_SUCCESS);
    swResult result = swWriteRaster(&host, "baked.exr", raster, "ground.yaml", swWorld_HashFloor(world, &lattice));
    swDestroyRaster(raster);
    swDestroyWorld(world);
    swDestroyScene(scene);
    return result;
}

static void ABakedRasterIsStaleOnceItsSceneHasAnotherFloor(void** state)
{
    (void)state;
    WriteText("ground.yaml", GROUND "value: -9}]\n");
    if (Bake() == SW_ERROR_UNSUPPORTED)
    {
        print_message("built without OpenEXR\n");
        remove("ground.yaml");
        skip();
    }
    assert_int_equal(CountStale(), 0);
    WriteText("ground.yaml", "time_s: 5\n" GROUND "value: -9}, {field: foam, value: 1}]\n"); // not its floor
    assert_int_equal(CountStale(), 0);
    WriteText("ground.yaml", GROUND "value: -8}]\n");
    assert_int_equal(CountStale(), 1);
    assert_int_equal(Bake(), SW_SUCCESS);
    assert_int_equal(CountStale(), 0);
    remove("ground.yaml");
    assert_int_equal(CountStale(), 1); // nothing is known
    remove("baked.exr");
}

static void NoRemarkIsWithoutAScene(void** state)
{
    (void)state;
    static const char* const codes[] = {
#define SW_REMARK(name, code, severity, found, remedy) code,
#include "scene/remarks.inl"
#undef SW_REMARK
    };
    for (size_t i = 0; i < sizeof(codes) / sizeof(codes[0]); ++i)
    {
        // Meshes need a reader.
        bool isThere = !SW_HAS_ASSIMP && (strstr(codes[i], "_mesh") != NULL || strstr(codes[i], "_hull") != NULL);
        for (size_t k = 0; k < sizeof(scenes) / sizeof(scenes[0]); ++k)
        {
            isThere = isThere || (scenes[k].code != NULL && strcmp(scenes[k].code, codes[i]) == 0);
        }
        if (!isThere)
        {
            fail_msg("[%s] has no scene", codes[i]);
        }
    }
}

// What a scene, or its world, is refused for.
static const struct
{
    const char* code;
    int line;
    const char* text;
} refused[] = {
    {"not_yaml", 3, "waves: []\nviews: [\n"},
    {"not_yaml", 3, "waves: []\n---\nwaves: []\n"},
    {"too_large", 1, "[[[[[[[[[[[[[[[[[[[[\n"},
    {"wrong_form", 1, "waves: 3\n"},
    {"unknown_key", 1, "layer: water\n"},
    {"missing_key", 3, FINE "inputs: [{field: level, shape: mesh}]\n"},
    {"missing_key", 3, FINE "inputs: [{field: clip, shape: hull}]\n"},
    {"missing_key", 3, FINE "inputs: [{field: floor, shape: raster}]\n"},
    {"repeated", 1, "views: [{name: a}, {name: a}]\n"},
    {"out_of_range", 3, FINE "view: {resolution: 100}\n"},
    {"out_of_range", 4, FINE "splines:\n  - {name: a, points: [{x_m: 0}]}\n"},
    {"out_of_range", 4, FINE "splines:\n  - {name: a, closed: true, points: [{x_m: 0}, {x_m: 9}]}\n"},
    {"unknown_word", 3, FINE "inputs: [{field: floor, shape: raster, raster: none}]\n"},
    {"no_effect", 3, FINE "inputs: [{field: floor, points: [[0, 0]]}]\n"},
    {"conflict", 1, "waves: [{beaufort: 4, sea_state: 3}]\n"},
    {"no_energy", 1, "waves: [{spectrum: octaves, multiplier: 0}]\n"},
    {"bad_file", 2, "waves:\n  - {spectrum: file, file: none.spec}\n"},
    {"bad_file", 4, FINE "rasters:\n  - {name: a, file: none.asc}\n"},
    {"no_record", 2, "waves:\n  - {spectrum: file, file: buoy.data_spec, at: '1999-01-01'}\n"},
    {"refused", 4, FINE "water_bodies:\n  - {points: [[0, 0], [9, 9], [9, 0], [0, 9]]}\n"},
    {"refused", 4, FINE "inputs:\n  - {field: level, value: 1, shape: box}\n"},
    {"refused", 4, FINE "inputs:\n  - {field: floor, blend: multiply}\n"},
    {"refused", 5,
     FINE "rasters: [{name: a, file: fine.asc, coordinates: metres}]\n"
          "inputs:\n  - {field: flow, shape: raster, raster: a}\n"},
    {"refused", 5,
     FINE "splines: [{name: a, points: [{x_m: 0}, {x_m: 9}]}]\n"
          "inputs:\n  - {field: waves, shape: spline, spline: a, along_spline: true, blend: max}\n"},
    {"refused", 5, FINE "inputs:\n  - {field: level}\n  - {field: foam, weight: 2}\n"},
    {"refused", 6, // also behind a body that is refused
     FINE "water_bodies:\n  - {points: [[0, 0], [9, 9], [9, 0], [0, 9]]}\ninputs:\n  - {field: level, shape: box}\n"},
};

static void EveryMistakeIsToldOfItsScene(void** state)
{
    (void)state;
    int wrong = 0;
    WriteFiles();
    for (size_t i = 0; i < sizeof(refused) / sizeof(refused[0]); ++i)
    {
        swHost host = MakeHost();
        swScene* scene = NULL;
        swWorld* world = NULL;
        char wanted[64], code[64];
        swResult result = swReadSceneText(&host, refused[i].text, strlen(refused[i].text), "a.yaml", ".", &scene);
        result = result == SW_SUCCESS ? swCreateSceneWorld(&host, scene, &world) : result;
        snprintf(wanted, sizeof(wanted), "a.yaml:%d: ", refused[i].line);
        snprintf(code, sizeof(code), "[%s]\n", refused[i].code);
        const char* line = strstr(s_messages, wanted);
        if (result == SW_SUCCESS || line == NULL || strstr(line, code) == NULL)
        {
            print_message("scene %d: wanted line %d [%s], found:\n%s", (int)i, refused[i].line, refused[i].code,
                          s_messages);
            wrong += 1;
        }
        swDestroyWorld(world);
        swDestroyScene(scene);
    }
    RemoveFiles();
    assert_int_equal(wrong, 0);
}

static void NoMistakeIsWithoutAScene(void** state)
{
    (void)state;
    static const char* const codes[] = {
#define SW_MISTAKE(name, code, meaning, remedy) code,
#include "scene/mistakes.inl"
#undef SW_MISTAKE
    };
    for (size_t i = 0; i < sizeof(codes) / sizeof(codes[0]); ++i)
    {
        size_t k = 0;
        while (k < sizeof(refused) / sizeof(refused[0]) && strcmp(refused[k].code, codes[i]) != 0)
        {
            ++k;
        }
        if (k == sizeof(refused) / sizeof(refused[0]))
        {
            fail_msg("[%s] has no scene", codes[i]);
        }
    }
}

// One that is refused does not hide the next.
static void EveryRefusedInputIsTold(void** state)
{
    (void)state;
    static const char text[] = "water_bodies:\n"
                               "  - {points: [[0, 0], [9, 9], [9, 0], [0, 9]]}\n"
                               "  - {points: [[0, 0], [9, 0], [0, 9]]}\n"
                               "  - {points: [[0, 0], [5, 5], [9, 9]]}\n"
                               "waves: [{beaufort: 3}]\n";
    static const char inputs[] = "inputs:\n"
                                 "  - {field: floor, blend: multiply}\n"
                                 "  - {field: level, value: 1}\n"
                                 "  - {field: level, shape: box}\n";
    const struct
    {
        const char *text, *lines[2];
    } cases[] = {{text, {"a.yaml:2: body of water 1 ", "a.yaml:4: body of water 3 "}},
                 {inputs, {"a.yaml:2: input 1 ", "a.yaml:4: input 3 "}}};
    for (int i = 0; i < 2; ++i)
    {
        swHost host = MakeHost();
        swScene* scene = NULL;
        swWorld* world = NULL;
        assert_int_equal(swReadSceneText(&host, cases[i].text, strlen(cases[i].text), "a.yaml", ".", &scene),
                         SW_SUCCESS);
        assert_int_not_equal(swCreateSceneWorld(&host, scene, &world), SW_SUCCESS);
        assert_non_null(strstr(s_messages, cases[i].lines[0]));
        assert_non_null(strstr(s_messages, cases[i].lines[1]));
        assert_null(world);
        swDestroyScene(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryRemarkIsMadeOfItsScene), cmocka_unit_test(ABakedRasterIsStaleOnceItsSceneHasAnotherFloor),
        cmocka_unit_test(NoRemarkIsWithoutAScene),     cmocka_unit_test(EveryMistakeIsToldOfItsScene),
        cmocka_unit_test(NoMistakeIsWithoutAScene),    cmocka_unit_test(EveryRefusedInputIsTold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
