// SPDX-License-Identifier: MIT
// Layers in false colours: their names, and that a picture holds what the view holds.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <seaway/seaway.h>
#include <seaway/sheet.h>
#include <seaway/stage.h>

#include "support/cmocka_setup.h"
#include "support/counting_host.h"

#define SIDE 64
#define SLICES 3

static CountingMemory s_memory;
static swHost s_host;
static swStage* s_stage;
static swWorld* s_world;
static swView* s_view;
static swGpuWorld* s_gpuWorld;
static swSheet* s_sheet;

static void OpenSea(void)
{
    const swWorldDef worldDef = swDefaultWorldDef();
    const swWaveSystemDef waves = swDefaultWaveSystemDef();
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = SLICES;
    viewDef.resolution = SIDE;
    viewDef.enableCpuLayers = true;
    swWaveSystemId system;
    swInputId input;
    assert_int_equal(swCreateWorld(&s_host, &worldDef, &s_world), SW_SUCCESS);
    assert_int_equal(swCreateWaveSystem(s_world, &waves, &system), SW_SUCCESS);
    assert_int_equal(swCreateView(s_world, &viewDef, &s_view), SW_SUCCESS);
    swInputDef shoal = swDefaultInputDef(); // on a part of the finest slice
    shoal.shape = SW_SHAPE_RECTANGLE;
    shoal.size = (swVec3){2.0f, 0.0f, 3.0f};
    shoal.value[0] = -5.0f;
    assert_int_equal(swCreateInput(s_world, &shoal, &input), SW_SUCCESS);
    swView_SetViewpoint(s_view, (swPos){0.0, 2.0, 0.0});
    assert_int_equal(swWorld_Step(s_world, 0.1), SW_SUCCESS);
}

static void RunFrame(void)
{
    swStageFrame frame;
    assert_int_equal(swStage_BeginFrame(s_stage, &frame), SW_SUCCESS);
    assert_int_equal(swGpuWorld_Record(s_gpuWorld, frame.commands, frame.index), SW_SUCCESS);
    assert_int_equal(swStage_SubmitFrame(s_stage, &frame, NULL), SW_SUCCESS);
    assert_int_equal(swStage_Wait(s_stage), SW_SUCCESS);
}

static int Open(void** state)
{
    (void)state;
    s_host = MakeCountingHost(&s_memory);
    swGpuDef def = swDefaultGpuDef();
    def.choice = SW_DEVICE_SOFTWARE;
    def.enableValidation = true;
    if (swCreateStage(&s_host, &def, &s_stage) != SW_SUCCESS)
    {
        exit(77);
    }
    OpenSea();
    assert_int_equal(swCreateGpuWorld(swStage_GetGpu(s_stage), s_world, &s_gpuWorld), SW_SUCCESS);
    assert_int_equal(swCreateSheet(&s_host, &s_sheet), SW_SUCCESS);
    RunFrame();
    return 0;
}

static int Close(void** state)
{
    (void)state;
    swDestroySheet(s_sheet);
    swDestroyGpuWorld(s_gpuWorld);
    swDestroyView(s_view);
    swDestroyWorld(s_world);
    assert_int_equal(swGpu_GetValidationCount(swStage_GetGpu(s_stage)), 0);
    swDestroyStage(s_stage);
    assert_int_equal(s_memory.bytes, 0);
    return 0;
}

static swSheetDef Parse(const char* text)
{
    swSheetDef def = swDefaultSheetDef();
    assert_true(swParseSheet(text, &def, NULL, 0));
    return def;
}

static void LayersAreNamedAsTheirTableHasThem(void** state)
{
    (void)state;
    for (int i = 0; i < SW_LAYER_COUNT; ++i)
    {
        const char* name = swLayer_GetName((swLayer)i);
        char text[128];
        swSheetDef def = Parse(name);
        assert_true(def.layer == (swLayer)i && def.slice == -1);
        for (int channel = 0; swLayer_GetChannelName((swLayer)i, channel) != NULL; ++channel)
        {
            snprintf(text, sizeof(text), "%s.%s:%d", name, swLayer_GetChannelName((swLayer)i, channel), i);
            def = Parse(text);
            assert_true(def.layer == (swLayer)i && def.channel == channel && def.slice == i);
        }
    }
    assert_int_equal(Parse("displacement").channel, 1); // the height
    assert_null(swLayer_GetName(SW_LAYER_COUNT));
}

static void AnUnknownNameListsTheKnownOnes(void** state)
{
    (void)state;
    swSheetDef def = swDefaultSheetDef();
    char problem[512];
    static const char* const wrong[] = {
        "depth", "", "places.", "places.w", "foam:", "foam:15", "foam:-1", "foam:1x", "foam.amount.x", "Foam"};
    for (size_t i = 0; i < sizeof(wrong) / sizeof(wrong[0]); ++i)
    {
        problem[0] = '\0';
        assert_false(swParseSheet(wrong[i], &def, problem, sizeof(problem)));
        assert_true(strlen(problem) > 10);
    }
    assert_false(swParseSheet("depth", &def, problem, sizeof(problem)));
    for (int i = 0; i < SW_LAYER_COUNT; ++i)
    {
        assert_non_null(strstr(problem, swLayer_GetName((swLayer)i)));
    }
    assert_false(swParseSheet("places.w", &def, problem, sizeof(problem)));
    assert_non_null(strstr(problem, "slope_z"));
    assert_true(def.layer == SW_LAYER_DISPLACEMENT); // as it was
}

// Numbers of the picture against those of the view, texel by texel.
static void CheckValues(const char* text, const float* (*getTexels)(const swView*, int), int step, int channel)
{
    swSheetDef def = Parse(text);
    int width = 0, height = 0;
    static float rgb[3 * (4 * SIDE + 64) * (4 * SIDE + 64)];
    assert_int_equal(swSheet_Read(s_sheet, s_gpuWorld, s_view, &def), SW_SUCCESS);
    swSheetInfo info = swSheet_GetInfo(s_sheet);
    swFindSheetSize(info.sliceCount, info.resolution, &width, &height);
    swSheet_DrawValues(s_sheet, width, height, rgb);
    int seen = 0;
    float least = INFINITY, greatest = -INFINITY;
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            swSheetPick pick;
            const float* shown = &rgb[3 * (y * width + x)];
            if (!swSheet_Pick(s_sheet, width, height, x, y, &pick))
            {
                assert_true(isnan(shown[0]));
                continue;
            }
            const float* texels = getTexels(s_view, pick.slice);
            float value = texels[step * (pick.row * SIDE + pick.column) + channel];
            value = value > 1e29f ? NAN : value;
            assert_true(memcmp(&value, &shown[0], sizeof(float)) == 0 || (isnan(value) && isnan(shown[0])));
            assert_true(shown[1] == shown[0] || isnan(shown[0]));
            assert_true(pick.value == shown[0] || isnan(shown[0]));
            least = value < least ? value : least;
            greatest = value > greatest ? value : greatest;
            ++seen;
        }
    }
    assert_int_equal(seen, info.sliceCount * SIDE * SIDE); // each texel once
    assert_true(info.least == least && info.greatest == greatest && info.low == least && info.high == greatest);
}

static void APictureHoldsWhatTheViewHolds(void** state)
{
    (void)state;
    CheckValues("displacement", swView_GetDisplacement, 4, 1);
    CheckValues("displacement.z:2", swView_GetDisplacement, 4, 2);
    CheckValues("foam:1", swView_GetFoam, 1, 0);
    CheckValues("places.depth:0", swView_GetPlaces, 4, 0);
    swSheetInfo info = swSheet_GetInfo(s_sheet);
    assert_true(info.unknownCount > 0 && info.unknownCount < SIDE * SIDE); // no floor beside the shoal
    assert_float_equal(info.least, 5.0f, 1e-5f);
}

static void ColoursFollowTheRange(void** state)
{
    (void)state;
    enum
    {
        W = SIDE,
        H = SIDE + 20
    };
    static uint8_t rgba[4 * W * H];
    swSheetDef def = Parse("displacement.y:2");
    def.hasRange = true;
    def.low = 100.0f; // all is below
    def.high = 200.0f;
    assert_int_equal(swSheet_Read(s_sheet, s_gpuWorld, s_view, &def), SW_SUCCESS);
    swSheet_Draw(s_sheet, W, H, rgba);
    const uint8_t* bar = &rgba[4 * W * (H - 1)];
    assert_memory_equal(rgba, bar, 4);                                      // the first colour of the bar
    assert_memory_not_equal(rgba, bar + 4 * (W - 1), 4);                    // the last is another
    assert_memory_equal(rgba, &rgba[4 * (W * (SIDE - 1) + (SIDE - 1))], 4); // everywhere
    def.low = -200.0f;
    def.high = -100.0f; // all is above
    assert_int_equal(swSheet_Read(s_sheet, s_gpuWorld, s_view, &def), SW_SUCCESS);
    swSheet_Draw(s_sheet, W, H, rgba);
    assert_memory_equal(rgba, bar + 4 * (W - 1), 4);
}

static void ASliceThatIsNotThereIsRefused(void** state)
{
    (void)state;
    swSheetDef def = Parse("foam:3");
    int before = s_memory.messages;
    assert_int_equal(swSheet_Read(s_sheet, s_gpuWorld, s_view, &def), SW_ERROR_INVALID);
    assert_int_equal(s_memory.messages, before + 1);
}

static void APictureOfAnySizeIsDrawn(void** state)
{
    (void)state;
    static uint8_t rgba[4 * 300 * 300];
    swSheetDef def = Parse("foam");
    assert_int_equal(swSheet_Read(s_sheet, s_gpuWorld, s_view, &def), SW_SUCCESS);
    for (int size = 1; size <= 300; size += 23)
    {
        swSheetPick pick;
        swSheet_Draw(s_sheet, size, 301 - size, rgba);
        assert_false(swSheet_Pick(s_sheet, size, 301 - size, size, 0, &pick));
        assert_false(swSheet_Pick(s_sheet, size, 301 - size, -1, -1, &pick));
    }
}

static void AFloorThatFadesIntoNoneLeavesColoursForTheShallows(void** state)
{
    (void)state;
    swInputDef shoal = swDefaultInputDef();
    swInputId input;
    shoal.shape = SW_SHAPE_CIRCLE;
    shoal.size.x = 8.0f;
    shoal.feather = 3.99f;
    shoal.value[0] = -2.0f;
    assert_int_equal(swCreateInput(s_world, &shoal, &input), SW_SUCCESS);
    assert_int_equal(swWorld_Step(s_world, 0.1), SW_SUCCESS);
    RunFrame();
    swSheetDef def = Parse("places.depth:0");
    assert_int_equal(swSheet_Read(s_sheet, s_gpuWorld, s_view, &def), SW_SUCCESS);
    swSheetInfo info = swSheet_GetInfo(s_sheet);
    assert_true(info.greatest > 5000.0f && info.high <= 1000.0f && info.high > 50.0f && info.low == info.least);
    swDestroyInput(s_world, input);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(LayersAreNamedAsTheirTableHasThem),
        cmocka_unit_test(AnUnknownNameListsTheKnownOnes),
        cmocka_unit_test(APictureHoldsWhatTheViewHolds),
        cmocka_unit_test(ColoursFollowTheRange),
        cmocka_unit_test(ASliceThatIsNotThereIsRefused),
        cmocka_unit_test(APictureOfAnySizeIsDrawn),
        cmocka_unit_test(AFloorThatFadesIntoNoneLeavesColoursForTheShallows),
    };
    return cmocka_run_group_tests(tests, Open, Close);
}
