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

#define VIEWS "views: [{name: a}]\n"
#define WAVES "waves: [{beaufort: 4}]\n"
#define FINE VIEWS WAVES // two lines

static const struct
{
    const char* code;
    int line;
    const char* text;
} scenes[] = {
    {"no_views", 0, WAVES},
    {"flat", 0, VIEWS "waves: []\n"},
    {"flat", 0, VIEWS "waves: [{spectrum: jonswap, weight: 0}]\n"},
    {"no_region", 3, VIEWS "waves:\n  - {beaufort: 4, is_local: true}\n"},
    {"other_wind", 4, VIEWS "wind: {speed_mps: 20}\nwaves:\n  - {beaufort: 4}\n"},
    {"foam_filter", 0, VIEWS "foam: {min_wavelength_m: 900}\nwaves: [{beaufort: 4, max_wavelength_m: 512}]\n"},
    {"coarse_view", 0, FINE "view: {resolution: 64}\n"},
    {"view_in_floor", 3, WAVES "views:\n  - {name: a, position_m: [0, 2, 0]}\ninputs: [{field: floor, value: 5}]\n"},
    {"disabled_input", 4, FINE "inputs:\n  - {field: level, value: 1, is_enabled: false}\n"},
    {"empty_input", 4, FINE "inputs:\n  - {field: level, value: 1, weight: 0}\n"},
    {"empty_input", 4, FINE "inputs:\n  - {field: level, blend: add}\n"},
    {"tilted_input", 4, FINE "inputs:\n  - {field: level, value: 1, shape: circle, rotation_deg: [0, 10, 0]}\n"},
    {"covered_input", 4,
     FINE "inputs:\n  - {field: level, value: 1, shape: circle}\n  - {field: level, value: 2, blend: replace}\n"},
    {"fast_flow", 4, FINE "inputs:\n  - {field: flow, value: [20, 0]}\n"},
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

static void EveryRemarkIsMadeOfItsScene(void** state)
{
    (void)state;
    WriteText("small.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n-9 -9\n-9 -9\n");
    WriteText("unknown.asc", "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9\n"
                             "-9 -9 -9 -9\n-9 -9 -9 -9\n-9 -9 -9 -9\n-9 -9 -9 -9\n");
    WriteText("fine.asc", "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 10\n"
                          "-9 -9 -9 -9\n-9 -8 -9 -9\n-9 -9 -7 -9\n-9 -9 -9 -9\n");
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
    remove("small.asc");
    remove("unknown.asc");
    remove("fine.asc");
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
        bool isThere = false;
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryRemarkIsMadeOfItsScene),
        cmocka_unit_test(ABakedRasterIsStaleOnceItsSceneHasAnotherFloor),
        cmocka_unit_test(NoRemarkIsWithoutAScene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
