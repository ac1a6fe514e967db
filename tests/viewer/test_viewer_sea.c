// SPDX-License-Identifier: MIT
// What the panel changes reaches the world over the transition, and what the world refuses leaves both as they were.

#include "support/cmocka_setup.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sea.h"

static swGpu* s_gpu;
static swHost s_host;

static void Ignore(void* context, swLogLevel level, const char* message)
{
    (void)context;
    (void)level;
    (void)message;
}

static Sea OpenText(const char* text)
{
    char path[] = "/tmp/seaway_view_XXXXXX";
    int file = mkstemp(path);
    assert_true(file >= 0);
    assert_int_equal(write(file, text, strlen(text)), (ssize_t)strlen(text));
    close(file);
    Sea sea;
    bool isOpen = OpenSea(&sea, &s_host, s_gpu, path);
    remove(path);
    assert_true(isOpen);
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
    assert_ptr_not_equal(sea.waves[0].components, sea.scene->waves[0].components);
    sea.waves[0].components[0].amplitude = 2.0f;
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

int main(void)
{
    s_host = swDefaultHost();
    s_host.log = Ignore;
    swGpuDef def = swDefaultGpuDef();
    def.choice = SW_DEVICE_SOFTWARE;
    if (swCreateGpu(&s_host, &def, &s_gpu) != SW_SUCCESS)
    {
        printf("skipped: there is no software device\n");
        return 77;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ChangesRunOverTheTransition),
        cmocka_unit_test(FastChangesWaitTheirTurn),
        cmocka_unit_test(RefusedChangesLeaveThePanelAsTheWorldIs),
        cmocka_unit_test(WavesByHandAreTheirOwn),
        cmocka_unit_test(ReplaysFollowTheClockAndTheirSpeed),
    };
    int failures = cmocka_run_group_tests(tests, NULL, NULL);
    swDestroyGpu(s_gpu);
    return failures;
}
