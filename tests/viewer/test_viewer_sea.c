// SPDX-License-Identifier: MIT
// What the panel changes reaches the world over the transition, and what the world refuses leaves both as they were.

#include "support/cmocka_setup.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "picture.h"
#include "save.h"
#include "tuning.h"

static swGpu* s_gpu;
static swHost s_host;

static char s_message[400]; // the last one

static void Keep(void* context, swLogLevel level, const char* message)
{
    (void)context;
    (void)level;
    snprintf(s_message, sizeof(s_message), "%s", message);
}

static bool TryText(const char* text, Sea* sea)
{
    char path[] = "/tmp/seaway_view_XXXXXX";
    int file = mkstemp(path);
    assert_true(file >= 0);
    assert_int_equal(write(file, text, strlen(text)), (ssize_t)strlen(text));
    close(file);
    bool isOpen = OpenSea(sea, &s_host, s_gpu, 720, path);
    remove(path);
    return isOpen;
}

static Sea OpenText(const char* text)
{
    Sea sea;
    assert_true(TryText(text, &sea));
    return sea;
}

static void StepTo(Sea* sea, double time)
{
    assert_true(AdvanceSea(sea, time));
    assert_int_equal(swWorld_StepTo(sea->world, time), SW_SUCCESS);
}

static bool IsNear(float value, double expected)
{
    return fabs((double)value - expected) <= 0.01 * expected;
}

#define SMALL "view: {slice_count: 2, resolution: 64}\n"
#define BREEZE                                                                                                         \
    SMALL "waves:\n  - {spectrum: jonswap, significant_height_m: 2, peak_period_s: 6, resolution: 64, tile_waves: "    \
          "16}\n"

static void ASoftwareDeviceDrawsFewerPixelsThanTheWindowHas(void** state)
{
    (void)state;
    VkExtent2D window = {640, 360};
    assert_int_equal(DrawnExtent(window, false).width, 640);
    VkExtent2D drawn = DrawnExtent(window, true);
    assert_true(drawn.width * drawn.height <= 1.02 * SOFTWARE_PIXELS);
    assert_float_equal((float)drawn.width / (float)drawn.height, 640.0f / 360.0f, 0.02f);
    assert_int_equal(DrawnExtent((VkExtent2D){3840, 2160}, true).width, 1920); // half a side at least
    assert_int_equal(DrawnExtent((VkExtent2D){160, 90}, true).width, 160);
}

static void ChangesRunOverTheTransition(void** state)
{
    (void)state;
    Sea sea = OpenText(BREEZE);
    StepTo(&sea, 0.0);
    sea.transition = 4.0f;
    sea.waves[0].def.spectrum.significantHeight = 4.0f;
    sea.waves[0].hasChanged = true;
    ApplyChanges(&sea, false);
    assert_false(sea.waves[0].hasChanged);
    assert_true(IsNear(GetAskedHeight(&sea), 4.0));
    StepTo(&sea, 2.0);
    float between = GetCarriedHeight(&sea);
    assert_true(between > 2.5f && between < 3.8f);
    StepTo(&sea, 4.0);
    assert_true(IsNear(GetCarriedHeight(&sea), 4.0));
    CloseSea(&sea);
}

static void ABrokenSceneLeavesTheSeaBeforeIt(void** state)
{
    (void)state;
    Sea sea = OpenText(BREEZE), fresh;
    StepTo(&sea, 0.0);
    assert_false(TryText(BREEZE "bogus: 1\n", &fresh));
    assert_non_null(strstr(s_message, ":4: 'bogus'")); // with its line
    assert_null(fresh.world);
    StepTo(&sea, 1.0);
    assert_true(IsNear(GetCarriedHeight(&sea), 2.0));
    CloseSea(&sea);
}

static void FastChangesWaitTheirTurn(void** state)
{
    (void)state;
    Sea sea = OpenText(BREEZE);
    StepTo(&sea, 0.0);
    sea.transition = 2.0f;
    for (int i = 0; i < 120; i++) // a seed is dragged for four seconds: cross-fades
    {
        sea.waves[0].def.seed = (uint32_t)(100 + i);
        sea.waves[0].hasChanged = true;
        ApplyChanges(&sea, false);
        StepTo(&sea, i / 30.0);
    }
    for (int i = 120; i < 180; i++)
    {
        ApplyChanges(&sea, false);
        StepTo(&sea, i / 30.0);
    }
    assert_false(sea.waves[0].hasChanged);
    assert_int_equal(swWaveSystem_Get(sea.world, sea.waves[0].id).seed, 219);
    // While time stands still, at once.
    sea.waves[0].def.seed = 7;
    sea.waves[0].hasChanged = true;
    ApplyChanges(&sea, true);
    assert_int_equal(swWaveSystem_Get(sea.world, sea.waves[0].id).seed, 7);
    CloseSea(&sea);
}

static void RefusedChangesLeaveThePanelAsTheWorldIs(void** state)
{
    (void)state;
    Sea sea = OpenText(BREEZE);
    StepTo(&sea, 0.0);
    sea.waves[0].def.resolution = 63;
    sea.waves[0].hasChanged = true;
    ApplyChanges(&sea, false);
    assert_int_equal(sea.waves[0].def.resolution, 64);
    assert_true(IsNear(GetCarriedHeight(&sea), 2.0));
    CloseSea(&sea);
}

static void WavesByHandAreTheirOwn(void** state)
{
    (void)state;
    Sea sea = OpenText(SMALL "waves:\n  - components: [{wavelength_m: 50, amplitude_m: 1, direction_from_deg: 270}]\n");
    StepTo(&sea, 0.0);
    assert_true(IsNear(GetAskedHeight(&sea), 4.0 / sqrt(2.0)) && IsNear(GetCarriedHeight(&sea), 4.0 / sqrt(2.0)));
    assert_ptr_not_equal(sea.waves[0].def.components, sea.scene->waves[0].components);
    sea.waves[0].hand->waves[0].amplitude = 2.0f;
    sea.waves[0].hasChanged = true;
    ApplyChanges(&sea, true);
    StepTo(&sea, 0.0);
    assert_true(IsNear(GetCarriedHeight(&sea), 8.0 / sqrt(2.0)));
    CloseSea(&sea);
}

static void ReplaysFollowTheClockAndTheirSpeed(void** state)
{
    (void)state;
    Sea sea = OpenText(SMALL "waves:\n"
                             "  - spectrum: file\n"
                             "    file: " SW_SOURCE_DIR "/scenes/data/passing_storm.csv\n"
                             "    replay: {speed: 3600}\n"
                             "    resolution: 64\n"
                             "    tile_waves: 16\n");
    StepTo(&sea, 0.0);
    float first = GetCarriedHeight(&sea);
    StepTo(&sea, 24.0);
    assert_true(first < 1.6f && GetCarriedHeight(&sea) > 4.2f);
    StepTo(&sea, 21.0); // half-way between records
    assert_true(IsNear(GetCarriedHeight(&sea), (double)GetAskedHeight(&sea)));
    double seconds = GetReplaySeconds(&sea, 0);
    ChangeReplay(&sea, 0, seconds, 0.0);
    ApplyChanges(&sea, false);
    StepTo(&sea, 48.0);
    assert_true(GetReplaySeconds(&sea, 0) == seconds && IsNear(GetCarriedHeight(&sea), (double)GetAskedHeight(&sea)));
    assert_true(GetCarriedHeight(&sea) > 4.0f);
    CloseSea(&sea);
}

// What a frame does with the world, recorded or not: views and their twins on the GPU follow.
static void SystemsComeAndGoOverTheTransition(void** state)
{
    (void)state;
    Sea sea = OpenText(BREEZE);
    StepTo(&sea, 0.0);
    sea.transition = 2.0f;
    for (NewWaves kind = NEW_WIND_SEA; kind < NEW_WAVES_COUNT; kind++)
    {
        float before = GetCarriedHeight(&sea);
        assert_true(AddWaves(&sea, kind));
        ApplyChanges(&sea, false);
        double start = swWorld_GetTime(sea.world);
        StepTo(&sea, start + 1.0 / 30.0);
        assert_true(GetCarriedHeight(&sea) < before * 1.2f + 0.1f); // without a jump
        StepTo(&sea, start + 3.0);
        ApplyChanges(&sea, false);
        StepTo(&sea, start + 6.0);
        assert_true(IsNear(GetCarriedHeight(&sea), (double)GetAskedHeight(&sea)));
        assert_true(GetCarriedHeight(&sea) > before);
        assert_int_equal(CountChanges(&sea), (int)kind + 1);
    }
    assert_int_equal(sea.wavesCount, 5);
    assert_int_equal(sea.waves[1].def.resolution, 64); // as the first one
    int serial = sea.waves[2].serial;
    RemoveWaves(&sea, 1);
    assert_int_equal(sea.wavesCount, 4);
    assert_int_equal(sea.waves[1].serial, serial);
    ApplyChanges(&sea, false);
    assert_int_equal(sea.leavingCount, 1);
    StepTo(&sea, swWorld_GetTime(sea.world) + 2.5);
    ApplyChanges(&sea, false);
    assert_int_equal(sea.leavingCount, 0);
    CloseSea(&sea);
}

static void ASystemOfTheFileComesBack(void** state)
{
    (void)state;
    Sea sea = OpenText(BREEZE);
    StepTo(&sea, 0.0);
    RemoveWaves(&sea, 0);
    StepTo(&sea, 2.0);
    ApplyChanges(&sea, false);
    StepTo(&sea, 2.1);
    assert_true(GetCarriedHeight(&sea) == 0.0f && GetAskedHeight(&sea) == 0.0f);
    assert_int_equal(CountChanges(&sea), 1);
    assert_true(BringBackWaves(&sea, 0));
    ApplyChanges(&sea, true);
    StepTo(&sea, 2.2);
    assert_true(IsNear(GetCarriedHeight(&sea), 2.0));
    assert_int_equal(CountChanges(&sea), 0);
    CloseSea(&sea);
}

static void AWorldThatIsFullSaysSo(void** state)
{
    (void)state;
    Sea sea = OpenText(SMALL "waves:\n  - components: [{wavelength_m: 50, amplitude_m: 1, direction_from_deg: 270}]\n");
    StepTo(&sea, 0.0);
    while (sea.wavesCount < SW_MAX_WAVE_SYSTEMS)
    {
        assert_true(AddWaves(&sea, NEW_BY_HAND));
    }
    assert_false(AddWaves(&sea, NEW_BY_HAND));
    assert_int_equal(sea.wavesCount, SW_MAX_WAVE_SYSTEMS);
    RemoveWaves(&sea, 0);
    sea.transition = 0.0f;
    ApplyChanges(&sea, true);
    assert_true(AddWaves(&sea, NEW_BY_HAND));
    assert_false(BringBackWaves(&sea, 0));
    assert_true(sea.waves[0].isRemoved);
    CloseSea(&sea);
}

#define ROWS                                                                                                           \
    SMALL "waves:\n  - components: [{wavelength_m: 50, amplitude_m: 1, direction_from_deg: 270}, {wavelength_m: 20, "  \
          "amplitude_m: 0.3, direction_from_deg: 250}]\n"

static void RowsComeAndGo(void** state)
{
    (void)state;
    Sea sea = OpenText(ROWS);
    StepTo(&sea, 0.0);
    SeaWaves* waves = &sea.waves[0];
    assert_true(AddRow(&sea, 0, 0));
    assert_int_equal(waves->def.componentCount, 3);
    assert_true(waves->hand->waves[1].wavelength == 50.0f && waves->hand->waves[2].wavelength == 20.0f);
    assert_int_equal(CountChanges(&sea), 1);
    ApplyChanges(&sea, true);
    assert_int_equal(swWaveSystem_Get(sea.world, waves->id).componentCount, 3);
    assert_true(RemoveRow(&sea, 0, 0) && RemoveRow(&sea, 0, 1)); // both of the file; the new one stays
    assert_false(RemoveRow(&sea, 0, 0));
    assert_int_equal(CountMissingRows(waves), 2);
    assert_int_equal(CountChanges(&sea), 3);
    BringBackRows(&sea, 0);
    assert_int_equal(CountChanges(&sea), 1);
    ResetWaves(waves);
    assert_int_equal(CountChanges(&sea), 0);
    ApplyChanges(&sea, true);
    StepTo(&sea, 0.1);
    assert_int_equal(swWaveSystem_Get(sea.world, waves->id).componentCount, 2);
    CloseSea(&sea);
}

static void RowsHaveALimit(void** state)
{
    (void)state;
    Sea sea = OpenText(ROWS);
    StepTo(&sea, 0.0);
    while (sea.waves[0].def.componentCount < SW_MAX_FREE_WAVES)
    {
        assert_true(AddRow(&sea, 0, 1));
    }
    assert_false(AddRow(&sea, 0, 1));
    ApplyChanges(&sea, true);
    assert_int_equal(swWaveSystem_Get(sea.world, sea.waves[0].id).componentCount, SW_MAX_FREE_WAVES);
    CloseSea(&sea);
}

static void RefusedRowsLeaveTheirMarks(void** state)
{
    (void)state;
    Sea sea = OpenText(ROWS);
    StepTo(&sea, 0.0);
    assert_true(RemoveRow(&sea, 0, 0));
    sea.waves[0].hand->waves[0].amplitude = -1.0f; // which no world takes
    ApplyChanges(&sea, true);
    assert_int_equal(sea.waves[0].def.componentCount, 2);
    assert_int_equal(CountChanges(&sea), 0);
    CloseSea(&sea);
}

static void EverythingGoesBackToTheFile(void** state)
{
    (void)state;
    Sea sea = OpenText(BREEZE);
    StepTo(&sea, 0.0);
    sea.look.sky.haze = 3.0f;
    sea.look.foam.coverage *= 2.0f;
    sea.waves[0].def.weight = 0.5f;
    sea.waves[0].hasChanged = true;
    assert_true(AddWaves(&sea, NEW_SWELL));
    ApplyChanges(&sea, true);
    assert_int_equal(CountChanges(&sea), 4);
    assert_true(ResetChanges(&sea));
    ApplyChanges(&sea, true);
    StepTo(&sea, 0.1);
    assert_int_equal(CountChanges(&sea), 0);
    assert_int_equal(sea.wavesCount, 1);
    assert_true(swWaveSystem_Get(sea.world, sea.waves[0].id).weight == 1.0f);
    CloseSea(&sea);
}

static void AReplayGoesBackToTheFile(void** state)
{
    (void)state;
    Sea sea = OpenText(SMALL "waves:\n"
                             "  - spectrum: file\n"
                             "    file: " SW_SOURCE_DIR "/scenes/data/passing_storm.csv\n"
                             "    replay: {speed: 3600}\n"
                             "    resolution: 64\n"
                             "    tile_waves: 16\n");
    StepTo(&sea, 0.0);
    double filed = GetReplaySeconds(&sea, 0);
    ChangeReplay(&sea, 0, filed + 7200.0, -60.0);
    assert_int_equal(CountChanges(&sea), 1);
    ApplyChanges(&sea, true);
    StepTo(&sea, 1.0);
    assert_true(GetReplaySeconds(&sea, 0) == filed + 7140.0);
    assert_true(HasReplayChanged(&sea.waves[0]));
    ChangeReplay(&sea, 0, GetReplaySeconds(&sea, 0), 3600.0); // its speed back, then its moment
    assert_int_equal(CountChanges(&sea), 1);
    ResetReplayMoment(&sea, 0);
    assert_int_equal(CountChanges(&sea), 0);
    assert_true(GetReplaySeconds(&sea, 0) == filed + 3600.0);
    ChangeReplay(&sea, 0, filed, 7.0);
    ResetWaves(&sea.waves[0]);
    ApplyChanges(&sea, true);
    StepTo(&sea, 1.0);
    assert_true(GetReplaySeconds(&sea, 0) == filed + 3600.0);
    assert_int_equal(CountChanges(&sea), 0);
    // Its system may go like any other.
    RemoveWaves(&sea, 0);
    StepTo(&sea, 4.0);
    ApplyChanges(&sea, false);
    StepTo(&sea, 4.1);
    assert_true(BringBackWaves(&sea, 0));
    ApplyChanges(&sea, true);
    StepTo(&sea, 4.2);
    assert_true(GetCarriedHeight(&sea) > 0.5f);
    CloseSea(&sea);
}

#define TWO_SEAS                                                                                                       \
    "# kept\nname: two seas # kept\nview: {slice_count: 2, resolution: 64}\nwaves:\n"                                  \
    "  - spectrum: 'jonswap' # kept\n    wind_speed_mps: 8\n    resolution: 64\n    tile_waves: 16\n"                  \
    "  - method: gerstner\n    components: # kept\n      - {wavelength_m: 30, amplitude_m: 0.5, direction_from_deg: "  \
    "90, phase_deg: 0}\n      - {wavelength_m: 20, amplitude_m: 0.25, direction_from_deg: 80, phase_deg: 10}\n"

// Every number that counts to another one in its range.
static void TurnAll(const swFields* fields, void* def)
{
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        bool isNumber = field->type == SW_FIELD_FLOAT || field->type == SW_FIELD_FLOATS || field->type == SW_FIELD_BOOL;
        for (int k = 0; isNumber && k < field->count && swFields_Counts(fields, field, def); k++)
        {
            double part = 0.3 + 0.1 * k, span = field->knobHigh - field->knobLow;
            swField_SetNumber(field, def, k,
                              field->type == SW_FIELD_BOOL ? 1.0 - swField_GetNumber(field, def, k)
                                                           : swField_Read(field, field->knobLow + part * span));
        }
    }
}

static void WhatIsSavedReadsBackAsThePanelHadIt(void** state)
{
    (void)state;
    char path[] = "/tmp/seaway_save_XXXXXX";
    int file = mkstemp(path);
    assert_int_equal(write(file, TWO_SEAS, strlen(TWO_SEAS)), (ssize_t)strlen(TWO_SEAS));
    close(file);
    Sea sea;
    assert_true(OpenSea(&sea, &s_host, s_gpu, 720, path));
    TurnAll(swGetSkyFields(), &sea.look.sky);
    TurnAll(swGetWaterFields(), &sea.look.water);
    TurnAll(swGetFoamFields(), &sea.look.foam);
    sea.look.exposureEv = 1.5f;
    TurnAll(swGetSpectrumFields(), &sea.waves[0].def.spectrum);
    sea.waves[0].def.spectrum.peakPeriod = 9.0f;
    sea.waves[0].def.chop = 0.75f;
    sea.waves[0].def.seed = 12;
    assert_true(AddRow(&sea, 1, 0));
    sea.waves[1].hand->waves[1].wavelength = 25.0f;
    assert_true(AddWaves(&sea, NEW_SWELL));
    if (SaveSea(&sea, path, path) != SW_SUCCESS)
    {
        fail_msg("%s", s_message);
    }
    swScene* scene = NULL;
    assert_int_equal(swReadScene(&s_host, path, &scene), SW_SUCCESS);
    assert_true(swFields_AreEqual(swGetSkyFields(), &scene->sky, &sea.look.sky));
    assert_true(swFields_AreEqual(swGetWaterFields(), &scene->water, &sea.look.water));
    assert_true(swFields_AreEqual(swGetFoamFields(), &scene->world.foam, &sea.look.foam));
    assert_true(scene->exposureEv == 1.5f);
    assert_int_equal(scene->wavesCount, 3);
    for (int i = 0; i < 3; i++)
    {
        swWaveSystemDef other = sea.waves[i].def;
        other.spectrum.table = scene->waves[i].def.spectrum.table;
        assert_true(swFields_AreEqual(swGetWaveSystemFields(), &scene->waves[i].def, &other));
    }
    assert_int_equal(scene->waves[1].componentCount, 3);
    assert_true(scene->waves[1].components[1].wavelength == 25.0f);
    swDestroyScene(scene);
    CloseSea(&sea);
    // Comments and quotes of what was not changed are where they were.
    char text[4096] = "";
    FILE* read = fopen(path, "rb");
    assert_non_null(read);
    assert_true(fread(text, 1, sizeof(text) - 1, read) > 0);
    fclose(read);
    int kept = 0;
    for (const char* at = text; (at = strstr(at, "# kept")) != NULL; at++)
    {
        kept++;
    }
    assert_int_equal(kept, 4);
    assert_non_null(strstr(text, "spectrum: 'jonswap' # kept"));
    remove(path);
}

static void RemovedSystemsLeaveTheFile(void** state)
{
    (void)state;
    char path[] = "/tmp/seaway_save_XXXXXX";
    int file = mkstemp(path);
    assert_int_equal(write(file, TWO_SEAS, strlen(TWO_SEAS)), (ssize_t)strlen(TWO_SEAS));
    close(file);
    Sea sea;
    assert_true(OpenSea(&sea, &s_host, s_gpu, 720, path));
    RemoveWaves(&sea, 0);
    assert_int_equal(SaveSea(&sea, path, path), SW_SUCCESS);
    swScene* scene = NULL;
    assert_int_equal(swReadScene(&s_host, path, &scene), SW_SUCCESS);
    assert_int_equal(scene->wavesCount, 1);
    assert_int_equal(scene->waves[0].componentCount, 2);
    swDestroyScene(scene);
    CloseSea(&sea);
    remove(path);
}

// What the panel changes of inputs and bodies is in the sea with the next step, and goes into the file.
#define LAKES                                                                                                          \
    SMALL "inputs: # two\n"                                                                                            \
          "  - {field: level, value: 1.5} # everywhere\n"                                                              \
          "  - {field: waves, waves: 1, value: 0.5}\n"                                                                 \
          "  - {field: flow, shape: circle, value: [1, 0]}\n"                                                          \
          "water_bodies:\n"                                                                                            \
          "  - {name: pond, order: 1, waves: 1, position_m: [500, 3, 0], points: [[-9, -9], [9, -9], [0, 9]]}\n"       \
          "waves:\n"                                                                                                   \
          "  - {beaufort: 3, resolution: 64, tile_waves: 16}\n"                                                        \
          "  - {beaufort: 2, resolution: 64, tile_waves: 16, seed: 2}\n"

static float FindLevel(const Sea* sea, double x, float* weight)
{
    const swPosXZ origin = swWorld_GetOrigin(sea->world), point = {x - origin.x, -origin.z};
    float level = 0.0f;
    const swFieldSamples samples = {.level = &level, .weight = weight, .system = sea->waves[0].id};
    assert_int_equal(swMoment_QueryFields(swWorld_GetMoment(sea->world), 1, &point, &samples), 0);
    return level;
}

static void InputsFollowThePanel(void** state)
{
    (void)state;
    Sea sea = OpenText(LAKES);
    float weight = 0.0f;
    StepTo(&sea, 0.0);
    assert_float_equal(FindLevel(&sea, 0.0, &weight), 1.5f, 0.0f);
    assert_float_equal(weight, 0.5f, 1e-6f);
    assert_float_equal(FindLevel(&sea, 500.0, &weight), 3.0f, 1e-6f);
    assert_int_equal(CountChanges(&sea), 0);
    swWorld_SetOrigin(sea.world, (swPosXZ){4096.0, 512.0}); // the panel's coordinates are the file's
    sea.inputs[0].def.value[0] = 2.5f;
    sea.inputs[1].def.value[0] = 0.25f;
    sea.bodies[0].def.position.y = 4.0;
    sea.inputs[0].hasChanged = sea.inputs[1].hasChanged = sea.bodies[0].hasChanged = true;
    ApplyChanges(&sea, false);
    StepTo(&sea, 0.1);
    assert_float_equal(FindLevel(&sea, 0.0, &weight), 2.5f, 0.0f);
    assert_float_equal(weight, 0.25f, 1e-6f);
    assert_float_equal(FindLevel(&sea, 500.0, &weight), 4.0f, 1e-6f);
    assert_int_equal(CountChanges(&sea), 3);
    sea.inputs[0].def.weight = 2.0f; // which only sums may have: what was taken before stays
    sea.inputs[0].hasChanged = true;
    ApplyChanges(&sea, false);
    assert_true(sea.inputs[0].def.weight == 1.0f && sea.inputs[0].def.value[0] == 2.5f);
    assert_non_null(strstr(s_message, "weight above 1"));
    assert_true(ResetChanges(&sea));
    ApplyChanges(&sea, false);
    StepTo(&sea, 0.2);
    assert_float_equal(FindLevel(&sea, 0.0, &weight), 1.5f, 0.0f);
    CloseSea(&sea);
}

static float GetLevelAt(const Sea* sea, double x, double z)
{
    const swPosXZ place = {x, z};
    float level = NAN;
    const swFieldSamples samples = {.level = &level};
    swMoment_QueryFields(swWorld_GetMoment(sea->world), 1, &place, &samples);
    return level;
}

// A dock goes east by 1 m/s, on a tide by a table; changing its place moves where it sets out.
static void WhatMovesByItselfMovesInTheViewer(void** state)
{
    (void)state;
    Sea sea = OpenText(BREEZE "inputs:\n"
                              "  - {field: level, value: 1, shape: circle, size_m: [10, 0, 10],\n"
                              "     tide: [[0, 0], [100, 2]], motion: {velocity_mps: [1, 0, 0]}}\n"
                              "  - {field: floor, value: -9, shape: circle, motion: {velocity_mps: [1, 0, 0]}}\n"
                              "water_bodies: [{position_m: [0, 5, 400], points: [[-9, -9], [9, -9], [0, 9]],\n"
                              "  tide: [[0, 0], [100, 2]]}]\n");
    StepTo(&sea, 0.0);
    assert_float_equal(GetLevelAt(&sea, 0.0, 0.0), 1.0f, 1e-6f);
    StepTo(&sea, 50.0);
    assert_true(sea.movesFloor);
    assert_float_equal(GetLevelAt(&sea, 50.0, 0.0), 2.0f, 1e-6f);
    assert_float_equal(GetLevelAt(&sea, 0.0, 400.0), 6.0f, 1e-6f);
    sea.inputs[0].def.position.z = 100.0;
    sea.inputs[0].hasChanged = true;
    swWorld_SetOrigin(sea.world, (swPosXZ){10.0, 20.0});
    ApplyChanges(&sea, true);
    assert_true(AdvanceSea(&sea, 50.0));
    assert_int_equal(swWorld_Step(sea.world, 0.0), SW_SUCCESS);
    assert_float_equal(GetLevelAt(&sea, 40.0, 80.0), 2.0f, 1e-6f);
    CloseSea(&sea);
}

static void InputsOfRemovedWavesAreNotThere(void** state)
{
    (void)state;
    Sea sea = OpenText(LAKES);
    float weight = 0.0f;
    StepTo(&sea, 0.0);
    RemoveWaves(&sea, 0);
    ApplyChanges(&sea, true);
    StepTo(&sea, 1.0);
    const swPosXZ point = {0.0, 0.0};
    const swFieldSamples samples = {.weight = &weight, .system = sea.waves[1].id};
    swMoment_QueryFields(swWorld_GetMoment(sea.world), 1, &point, &samples);
    assert_float_equal(weight, 1.0f, 0.0f); // not those of all systems
    assert_true(BringBackWaves(&sea, 0));
    ApplyChanges(&sea, true);
    StepTo(&sea, 2.0);
    FindLevel(&sea, 0.0, &weight);
    assert_float_equal(weight, 0.5f, 1e-6f);
    CloseSea(&sea);
}

static void ChangedInputsAreSaved(void** state)
{
    (void)state;
    char path[] = "/tmp/seaway_view_XXXXXX", text[2048] = "";
    int file = mkstemp(path);
    assert_true(write(file, LAKES, strlen(LAKES)) == (ssize_t)strlen(LAKES));
    close(file);
    Sea sea;
    assert_true(OpenSea(&sea, &s_host, s_gpu, 720, path));
    sea.inputs[0].def.value[0] = -0.5f;
    sea.inputs[2].def.isEnabled = false;
    sea.bodies[0].def.isCalm = true;
    assert_int_equal(SaveSea(&sea, path, path), SW_SUCCESS);
    CloseSea(&sea);
    FILE* read = fopen(path, "rb");
    assert_true(fread(text, 1, sizeof(text) - 1, read) > 0);
    fclose(read);
    remove(path);
    assert_non_null(strstr(text, "  - {field: level, value: -0.5} # everywhere\n"));
    assert_non_null(strstr(text, "  - {field: flow, shape: circle, value: [1, 0], is_enabled: false}\n"));
    assert_non_null(strstr(text, "points: [[-9, -9], [9, -9], [0, 9]], is_calm: true}\n"));
    assert_non_null(strstr(text, "inputs: # two\n"));
}

#define POND                                                                                                           \
    BREEZE "inputs:\n"                                                                                                 \
           "  - {field: level, value: 2, shape: polygon, points: [[-9, -9], [9, -9], [9, 9], [-9, 9]]} # a pond\n"     \
           "  - {field: level, blend: add, tide: [{constituent: M2, amplitude: 0.0}]}\n"                               \
           "  - {field: foam, value: 1}\n"

static void StepAfterChange(Sea* sea)
{
    ApplyChanges(sea, true);
    assert_true(AdvanceSea(sea, 0.0));
    assert_int_equal(swWorld_Step(sea->world, 0.0), SW_SUCCESS);
}

// What the panel makes of inputs is in the sea, and goes back to the file's.
static void InputsAreMadeAndReshaped(void** state)
{
    (void)state;
    Sea sea = OpenText(POND);
    StepTo(&sea, 0.0);
    assert_float_equal(GetLevelAt(&sea, 20.0, 0.0), 0.0f, 0.0f);
    sea.inputs[0].points[1].x = sea.inputs[0].points[2].x = 30.0f;
    sea.inputs[0].hasChanged = true;
    StepAfterChange(&sea);
    assert_float_equal(GetLevelAt(&sea, 20.0, 0.0), 2.0f, 0.0f);
    assert_int_equal(CountChanges(&sea), 2);
    assert_true(AddInputPoint(&sea.inputs[0], 0));
    assert_int_equal(sea.inputs[0].def.pointCount, 5);
    RemoveInputPoint(&sea.inputs[0], 1);
    sea.inputs[0].points[2].x = -30.0f; // crosses itself now: refused, as it was
    StepAfterChange(&sea);
    assert_float_equal(sea.inputs[0].points[2].x, 30.0f, 0.0f);
    assert_true(AddInput(&sea, SW_INPUT_LEVEL, (swPos){500.0, 0.0, 0.0}));
    StepAfterChange(&sea);
    assert_float_equal(GetLevelAt(&sea, 500.0, 0.0), 1.0f, 0.0f);
    assert_true(ChangeInputShape(&sea.inputs[3], SW_SHAPE_POLYLINE));
    sea.inputs[3].def.size.x = 4.0f;
    sea.inputs[3].def.feather = 0.0f;
    StepAfterChange(&sea);
    assert_float_equal(GetLevelAt(&sea, 500.0, 0.0), 0.0f, 0.0f);
    assert_float_equal(GetLevelAt(&sea, 500.0, -50.0), 1.0f, 0.0f); // along the square's edge
    ChangeInputField(&sea.inputs[3], SW_INPUT_FOAM);
    StepAfterChange(&sea);
    assert_float_equal(GetLevelAt(&sea, 500.0, -50.0), 0.0f, 0.0f);
    AddConstituent(sea.inputs[1].def.tide);
    sea.inputs[1].hasChanged = true;
    assert_int_equal(CountTide(sea.inputs[1].def.tide), 2);
    RemoveInput(&sea, 0);
    StepAfterChange(&sea);
    assert_float_equal(GetLevelAt(&sea, 20.0, 0.0), 1.0f, 1e-6f); // the tide alone
    BringBackInput(&sea, 0);
    StepAfterChange(&sea);
    assert_float_equal(GetLevelAt(&sea, 20.0, 0.0), 3.0f, 1e-6f);
    assert_true(ResetChanges(&sea));
    StepAfterChange(&sea);
    assert_int_equal(sea.scene->inputCount, 3);
    assert_int_equal(CountChanges(&sea), 0);
    assert_float_equal(GetLevelAt(&sea, 20.0, 0.0), 0.0f, 0.0f);
    CloseSea(&sea);
}

#define LAKE                                                                                                           \
    BREEZE "water_bodies:\n"                                                                                           \
           "  - {name: lake, position_m: [0, 5, 0], points: [[-9, -9], [9, -9], [9, 9], [-9, 9]]}\n"

static void AShoreIsChangedAndSaved(void** state)
{
    (void)state;
    char path[] = "/tmp/seaway_view_XXXXXX", text[2048] = "";
    int file = mkstemp(path);
    assert_true(write(file, LAKE, strlen(LAKE)) == (ssize_t)strlen(LAKE));
    close(file);
    Sea sea;
    assert_true(OpenSea(&sea, &s_host, s_gpu, 720, path));
    StepTo(&sea, 0.0);
    assert_float_equal(GetLevelAt(&sea, 12.0, 0.0), 0.0f, 0.0f);
    assert_true(AddShorePoint(&sea.bodies[0], 1));
    sea.bodies[0].points[2].x = 20.0f;
    AddConstituent(sea.bodies[0].def.tide);
    StepAfterChange(&sea);
    assert_float_equal(GetLevelAt(&sea, 12.0, 0.0), 6.0f, 1e-6f);
    sea.bodies[0].points[2].x = -30.0f; // crosses itself: refused, as it was
    sea.bodies[0].hasChanged = true;
    StepAfterChange(&sea);
    assert_float_equal(sea.bodies[0].points[2].x, 20.0f, 0.0f);
    assert_int_equal(SaveSea(&sea, path, path), SW_SUCCESS);
    FILE* saved = fopen(path, "rb");
    size_t size = fread(text, 1, sizeof(text) - 1, saved);
    fclose(saved);
    text[size] = '\0';
    assert_string_equal(text + strlen(BREEZE),
                        "water_bodies:\n"
                        "  - {name: lake, position_m: [0, 5, 0], points: [[-9, -9], [9, -9], [20, "
                        "0], [9, 9], [-9, 9]], tide: [{constituent: M2, amplitude: 1}]}\n");
    RemoveShorePoint(&sea.bodies[0], 2);
    assert_true(ResetChanges(&sea));
    StepAfterChange(&sea);
    assert_int_equal(CountChanges(&sea), 0);
    assert_float_equal(GetLevelAt(&sea, 12.0, 0.0), 0.0f, 0.0f);
    CloseSea(&sea);
    remove(path);
}

static void MadeAndRemovedInputsAreSaved(void** state)
{
    (void)state;
    char path[] = "/tmp/seaway_view_XXXXXX", text[2048] = "";
    int file = mkstemp(path);
    assert_true(write(file, POND, strlen(POND)) == (ssize_t)strlen(POND));
    close(file);
    Sea sea;
    assert_true(OpenSea(&sea, &s_host, s_gpu, 720, path));
    assert_true(AddInput(&sea, SW_INPUT_CLIP, (swPos){10.0, 0.0, 20.0}));
    assert_true(ChangeInputShape(&sea.inputs[3], SW_SHAPE_BOX));
    RemoveInput(&sea, 2);
    AddConstituent(sea.inputs[1].def.tide);
    sea.inputs[1].hasChanged = true;
    sea.inputs[1].def.tide[1].speed = swGetTideSpeed("S2");
    assert_true(AddInputPoint(&sea.inputs[0], 3));
    ApplyChanges(&sea, true);
    assert_int_equal(SaveSea(&sea, path, path), SW_SUCCESS);
    CloseSea(&sea);
    FILE* saved = fopen(path, "rb");
    size_t size = fread(text, 1, sizeof(text) - 1, saved);
    fclose(saved);
    text[size] = '\0';
    assert_string_equal(
        text + strlen(BREEZE),
        "inputs:\n"
        "  - {field: level, value: 2, shape: polygon, points: [[-9, -9], [9, -9], [9, 9], [-9, 9], [-9, "
        "0]]} # a pond\n"
        "  - {field: level, blend: add, tide: [{constituent: M2, amplitude: 0.0}, {constituent: S2, "
        "amplitude: 1}]}\n"
        "  - field: clip\n"
        "    shape: box\n"
        "    feather_m: 10\n"
        "    position_m: [10, 0, 20]\n"
        "    value: 1\n");
    assert_true(OpenSea(&sea, &s_host, s_gpu, 720, path));
    CloseSea(&sea);
    remove(path);
}

static void AnOpenSeaWithoutAFileIsSavedAsANewScene(void** state)
{
    (void)state;
    char path[] = "/tmp/seaway_save_XXXXXX";
    close(mkstemp(path));
    Sea sea;
    assert_true(OpenSea(&sea, &s_host, s_gpu, 720, NULL));
    sea.waves[0].def.spectrum.windSpeed = 17.0f;
    assert_int_equal(SaveSea(&sea, NULL, path), SW_SUCCESS);
    swScene* scene = NULL;
    assert_int_equal(swReadScene(&s_host, path, &scene), SW_SUCCESS);
    assert_int_equal(scene->wavesCount, 1);
    assert_true(scene->waves[0].def.spectrum.windSpeed == 17.0f);
    swDestroyScene(scene);
    CloseSea(&sea);
    remove(path);
}

static void WhatCannotBeSavedLeavesTheFile(void** state)
{
    (void)state;
    Sea sea = OpenText(BREEZE);
    s_message[0] = '\0';
    assert_int_not_equal(SaveSea(&sea, NULL, "/nowhere/at/all.yaml"), SW_SUCCESS);
    assert_non_null(strstr(s_message, "/nowhere/at/all.yaml"));
    CloseSea(&sea);
}

int main(void)
{
    s_host = swDefaultHost();
    s_host.log = Keep;
    swGpuDef def = swDefaultGpuDef();
    def.choice = SW_DEVICE_SOFTWARE;
    if (swCreateGpu(&s_host, &def, &s_gpu) != SW_SUCCESS)
    {
        printf("skipped: there is no software device\n");
        return 77;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(WhatIsSavedReadsBackAsThePanelHadIt),
        cmocka_unit_test(RemovedSystemsLeaveTheFile),
        cmocka_unit_test(AnOpenSeaWithoutAFileIsSavedAsANewScene),
        cmocka_unit_test(InputsFollowThePanel),
        cmocka_unit_test(WhatMovesByItselfMovesInTheViewer),
        cmocka_unit_test(InputsOfRemovedWavesAreNotThere),
        cmocka_unit_test(InputsAreMadeAndReshaped),
        cmocka_unit_test(AShoreIsChangedAndSaved),
        cmocka_unit_test(MadeAndRemovedInputsAreSaved),
        cmocka_unit_test(ChangedInputsAreSaved),
        cmocka_unit_test(WhatCannotBeSavedLeavesTheFile),
        cmocka_unit_test(ASoftwareDeviceDrawsFewerPixelsThanTheWindowHas),
        cmocka_unit_test(ChangesRunOverTheTransition),
        cmocka_unit_test(ABrokenSceneLeavesTheSeaBeforeIt),
        cmocka_unit_test(FastChangesWaitTheirTurn),
        cmocka_unit_test(RefusedChangesLeaveThePanelAsTheWorldIs),
        cmocka_unit_test(WavesByHandAreTheirOwn),
        cmocka_unit_test(ReplaysFollowTheClockAndTheirSpeed),
        cmocka_unit_test(SystemsComeAndGoOverTheTransition),
        cmocka_unit_test(ASystemOfTheFileComesBack),
        cmocka_unit_test(AWorldThatIsFullSaysSo),
        cmocka_unit_test(RowsComeAndGo),
        cmocka_unit_test(RowsHaveALimit),
        cmocka_unit_test(RefusedRowsLeaveTheirMarks),
        cmocka_unit_test(EverythingGoesBackToTheFile),
        cmocka_unit_test(AReplayGoesBackToTheFile),
    };
    int failures = cmocka_run_group_tests(tests, NULL, NULL);
    swDestroyGpu(s_gpu);
    return failures;
}
