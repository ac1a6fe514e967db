// SPDX-License-Identifier: MIT
// What moves in a scene by itself: inputs by a velocity, on an orbit, along a path; tides by a table.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/messages.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "seaway/input.h"
#include "seaway/scene.h"

typedef struct Opened
{
    swScene* scene;
    swWorld* world;
    swSceneSea sea;
} Opened;

static Opened Open(const char* text)
{
    Opened opened = {0};
    swHost host = MakeHost();
    assert_int_equal(swReadSceneText(&host, text, strlen(text), "a.yaml", ".", &opened.scene), SW_SUCCESS);
    assert_int_equal(swOpenScene(&host, opened.scene, &opened.world, &opened.sea), SW_SUCCESS);
    return opened;
}

static void Close(Opened* opened)
{
    swDestroySceneSea(&opened->sea);
    swDestroyWorld(opened->world);
    swDestroyScene(opened->scene);
}

static void GoTo(Opened* opened, double time)
{
    swWorld_SetTime(opened->world, time);
    assert_int_equal(swSceneSea_Advance(&opened->sea, time), SW_SUCCESS);
    assert_int_equal(swWorld_Step(opened->world, 0.0), SW_SUCCESS);
}

static float GetLevel(const Opened* opened, double x, double z)
{
    const swPosXZ place = {x, z};
    float level = NAN;
    const swFieldSamples samples = {.level = &level};
    swMoment_QueryFields(swWorld_GetMoment(opened->world), 1, &place, &samples);
    return level;
}

// A floating dock, 20 m by 20 m, sets out at 10 s and goes east by 2 m/s.
static void AnInputMovesWithItsVelocity(void** state)
{
    (void)state;
    Opened opened =
        Open("inputs:\n"
             "  - {field: level, value: 3, shape: rectangle, size_m: [20, 0, 20], position_m: [100, 0, 0],\n"
             "     motion: {start_s: 10, velocity_mps: [2, 0, 0]}}\n");
    assert_float_equal(GetLevel(&opened, 91.0, 0.0), 3.0f, 0.0f);
    GoTo(&opened, 10.0);
    assert_float_equal(GetLevel(&opened, 91.0, 0.0), 3.0f, 0.0f);
    GoTo(&opened, 60.0);
    assert_float_equal(GetLevel(&opened, 91.0, 0.0), 0.0f, 0.0f);
    assert_float_equal(GetLevel(&opened, 191.0, 0.0), 3.0f, 0.0f);
    assert_float_equal(GetLevel(&opened, 209.0, 0.0), 3.0f, 0.0f);
    GoTo(&opened, 5.0); // and back
    assert_float_equal(GetLevel(&opened, 91.0, 0.0), 3.0f, 0.0f);
    Close(&opened);
}

// The scene's time is the first that its world has.
static void AWorldBeginsWithEverythingInItsPlace(void** state)
{
    (void)state;
    Opened opened = Open("time_s: 60\n"
                         "inputs:\n"
                         "  - {field: level, value: 3, shape: circle, size_m: [20, 0, 20],\n"
                         "     motion: {velocity_mps: [0, 0, -5]}}\n"
                         "  - {field: flow, tide: [[0, 0, 0], [120, 4, -8]]}\n");
    assert_float_equal(GetLevel(&opened, 0.0, -300.0), 3.0f, 0.0f);
    const swPosXZ place = {0.0, 0.0};
    swVec2 flow;
    const swFieldSamples samples = {.flow = &flow};
    swMoment_QueryFields(swWorld_GetMoment(opened.world), 1, &place, &samples);
    assert_float_equal(flow.x, 2.0f, 1e-6f);
    assert_float_equal(flow.y, -4.0f, 1e-6f);
    Close(&opened);
}

// The origin of coordinates moves, the sea stays.
static void AMovedOriginLeavesInputsInTheSea(void** state)
{
    (void)state;
    Opened opened = Open("inputs:\n"
                         "  - {field: level, value: 3, shape: circle, size_m: [20, 0, 20],\n"
                         "     motion: {velocity_mps: [10, 0, 0]}}\n");
    swWorld_SetOrigin(opened.world, (swPosXZ){500.0, -200.0});
    GoTo(&opened, 100.0);
    assert_float_equal(GetLevel(&opened, 1000.0 - 500.0, 200.0), 3.0f, 0.0f);
    Close(&opened);
}

static swSceneInput ReadMotion(const char* motion, swScene** scene)
{
    char text[512];
    swHost host = MakeHost();
    snprintf(text, sizeof(text), "inputs: [{field: level, shape: circle, position_m: [7, 0, 9], motion: %s}]\n",
             motion);
    assert_int_equal(swReadSceneText(&host, text, strlen(text), "a.yaml", ".", scene), SW_SUCCESS);
    return (*scene)->inputs[0];
}

static void CheckPlace(const swSceneInput* input, double time, double x, double z, float yaw, double within)
{
    swPos position;
    swAngles rotation;
    swSceneInput_GetPlace(input, time, &position, &rotation);
    if (!(fabs(position.x - x) <= within && fabs(position.z - z) <= within && fabsf(rotation.yaw - yaw) <= 1e-5f))
    {
        fail_msg("at %g s: (%.9g, %.9g) and %g, not (%g, %g) and %g", time, position.x, position.z,
                 (double)rotation.yaw, x, z, (double)yaw);
    }
}

static void AnOrbitClosesAfterItsPeriod(void** state)
{
    (void)state;
    swScene* scene = NULL;
    swSceneInput input = ReadMotion("{orbit_radius_m: 50, orbit_period_s: 80}", &scene);
    CheckPlace(&input, 0.0, 57.0, 9.0, 0.0f, 1e-5);
    CheckPlace(&input, 20.0, 7.0, 59.0, 0.0f, 1e-5);
    CheckPlace(&input, 40.0, -43.0, 9.0, 0.0f, 1e-5);
    CheckPlace(&input, 80e9 + 20.0, 7.0, 59.0, 0.0f, 1e-3); // two thousand years later
    swDestroyScene(scene);
    input = ReadMotion("{orbit_radius_m: 50, orbit_period_s: -80, orbit_from_deg: 90}", &scene);
    CheckPlace(&input, 0.0, 7.0, 59.0, 0.0f, 1e-5);
    CheckPlace(&input, 20.0, 57.0, 9.0, 0.0f, 1e-5);
    swDestroyScene(scene);
}

// The gate of a lock opens in 30 s, stands for 60 s, and closes.
static void APathIsFollowed(void** state)
{
    (void)state;
    static const char path[] = "path: [{time_s: 10}, {time_s: 40, moved_m: [30, 0, 0], turned_deg: [90, 0, 0]},\n"
                               "  {time_s: 100, moved_m: [30, 0, 0]}, {time_s: 130}]";
    char text[400];
    swScene* scene = NULL;
    snprintf(text, sizeof(text), "{%s}", path);
    swSceneInput input = ReadMotion(text, &scene);
    CheckPlace(&input, -5.0, 7.0, 9.0, 0.0f, 0.0);
    CheckPlace(&input, 25.0, 22.0, 9.0, 0.7853982f, 1e-5);
    CheckPlace(&input, 17.5, 14.5, 9.0, 0.39269909f, 1e-5);
    CheckPlace(&input, 40.0, 37.0, 9.0, 1.5707964f, 0.0);
    CheckPlace(&input, 500.0, 7.0, 9.0, 0.0f, 0.0);
    assert_float_equal(swSceneMotion_GetSpeed(&input.motion), 1.0f, 1e-6f);
    swDestroyScene(scene);
    snprintf(text, sizeof(text), "{%s, loops: true, is_smooth: true}", path);
    input = ReadMotion(text, &scene);
    CheckPlace(&input, 25.0, 22.0, 9.0, 0.7853982f, 1e-5);
    CheckPlace(&input, 17.5, 7.0 + 30.0 * 0.15625, 9.0, 1.5707964f * 0.15625f, 1e-5); // a quarter of the time
    CheckPlace(&input, 5.0, 7.0, 9.0, 0.0f, 0.0);
    CheckPlace(&input, 25.0 + 120.0 * 1000.0, 22.0, 9.0, 0.7853982f, 1e-5);
    assert_float_equal(swSceneMotion_GetSpeed(&input.motion), 1.5f, 1e-6f);
    swDestroyScene(scene);
}

// Angles stay within what inputs may have, however long they grow.
static void ATurningInputTurnsForYears(void** state)
{
    (void)state;
    swScene* scene = NULL;
    swSceneInput input = ReadMotion("{turn_rate_deg_per_s: [90, 0, 0]}", &scene);
    CheckPlace(&input, 1.0, 7.0, 9.0, 1.5707964f, 0.0);
    CheckPlace(&input, 41.0, 7.0, 9.0, 1.5707964f, 0.0);
    swDestroyScene(scene);
    Opened opened = Open("inputs: [{field: clip, shape: box, motion: {turn_rate_deg_per_s: [90, 45, 10]}}]\n");
    GoTo(&opened, 4e8);
    Close(&opened);
}

// No sentence is worth more than the place where it was.
static void WhatLeavesTheSeaIsTold(void** state)
{
    (void)state;
    Opened opened = Open("inputs:\n  - {field: level, value: 1, shape: circle, motion: {velocity_mps: [10, 0, 0]}}\n");
    s_messages[0] = '\0';
    assert_int_equal(swSceneSea_Advance(&opened.sea, 2e8), SW_ERROR_INVALID);
    assert_non_null(strstr(s_messages, "a.yaml:2: the motion of input 1 has brought it beyond 1e9 m"));
    GoTo(&opened, 1.0);
    Close(&opened);
}

// Bits, not only numbers: all machines have this dock in this place.
static void PlacesAreTheSameOnEveryMachine(void** state)
{
    (void)state;
    swScene* scene = NULL;
    swSceneInput input =
        ReadMotion("{velocity_mps: [0.1, 0, 0.3], turn_rate_deg_per_s: [7, 0, 0], orbit_radius_m: 11,\n"
                   "orbit_period_s: 13, path: [{}, {time_s: 9, moved_m: [1, 2, 3]}], is_smooth: true,\n"
                   "loops: true}",
                   &scene);
    uint64_t hash = 14695981039346656037u;
    for (int i = 0; i < 1000; ++i)
    {
        swPos position;
        swAngles rotation;
        unsigned char bytes[sizeof(position) + sizeof(rotation)];
        swSceneInput_GetPlace(&input, 0.37 * i * i, &position, &rotation);
        memcpy(bytes, &position, sizeof(position));
        memcpy(bytes + sizeof(position), &rotation, sizeof(rotation));
        for (size_t k = 0; k < sizeof(bytes); ++k)
        {
            hash = (hash ^ bytes[k]) * 1099511628211u;
        }
    }
    print_message("places of a motion: %016llx\n", (unsigned long long)hash);
    assert_true(hash == 0x6d11876b152fe9a9u);
    swDestroyScene(scene);
}

static void WriteText(const char* path, const char* text)
{
    FILE* file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

#define TABLE "[[0, 1], [20000, 3.5], [43000, 0.5], [65000, 3.25]]"

static void ATideByATableRunsThroughItsLines(void** state)
{
    (void)state;
    static const swTideLevel table[] = {{0.0, 1.0f}, {20000.0, 3.5f}, {43000.0, 0.5f}, {65000.0, 3.25f}};
    WriteText("tide.csv", "# Port of call\ntime_s,level_m\n0,1\r\n20000, 3.5\n\n43000;0.5\n65000\t3.25");
    Opened opened = Open("inputs:\n"
                         "  - {field: level, value: 0.25, shape: circle, size_m: [10, 0, 10], tide: " TABLE "}\n"
                         "  - {field: level, shape: circle, size_m: [10, 0, 10], position_m: [100, 0, 0],\n"
                         "     tide: {file: tide.csv}}\n"
                         "water_bodies:\n"
                         "  - {position_m: [300, 40, 0], points: [[-5, -5], [5, -5], [0, 5]], tide: " TABLE "}\n");
    for (int i = 0; i < 14; ++i)
    {
        double time = 5000.0 * i;
        float wanted = swGetTideOfTable(4, table, time);
        GoTo(&opened, time);
        assert_float_equal(GetLevel(&opened, 0.0, 0.0), 0.25f + wanted, 1e-6f);
        assert_float_equal(GetLevel(&opened, 100.0, 0.0), wanted, 1e-6f);
        assert_float_equal(GetLevel(&opened, 300.0, 0.0), 40.0f + wanted, 1e-5f);
    }
    Close(&opened);
    remove("tide.csv");
}

// A scene is written with its motions and tables as they stand.
static void WritingLeavesThemAsTheyStand(void** state)
{
    (void)state;
    static const char text[] = "name: a\n"
                               "inputs:\n"
                               "  - {field: level, value: 1.50, shape: circle, tide: " TABLE ", # high and low\n"
                               "     motion: {velocity_mps: [1, 0, 0]}}\n";
    static const char wanted[] = "name: a\n"
                                 "inputs:\n"
                                 "  - {field: level, value: 2, shape: circle, tide: " TABLE ", # high and low\n"
                                 "     motion: {velocity_mps: [1, 0, 0]}}\n";
    char written[1024] = "";
    size_t size = sizeof(written) - 1;
    Opened opened = Open(text);
    GoTo(&opened, 30000.0);
    opened.scene->inputs[0].def.value[0] = 2.0f;
    assert_int_equal(swPrintScene(opened.scene, written, &size), SW_SUCCESS);
    written[size] = '\0';
    assert_string_equal(written, wanted);
    Close(&opened);
}

static void EveryMistakeHasItsLineAndCode(void** state)
{
    (void)state;
    WriteText("bad.csv", "0 1\n1 2\n1 3\n");
    WriteText("words.csv", "0 1\nhigh water\n");
    WriteText("empty.csv", "# nothing\n");
#define MOVING "inputs:\n  - field: level\n    shape: circle\n"
    static const struct
    {
        const char* text;
        int line;
        const char* code;
    } cases[] = {
        {"inputs:\n  - field: level\n    motion: {}\n", 3, "no_effect"},
        {MOVING "    motion: 3\n", 4, "wrong_form"},
        {MOVING "    motion: {speed: 3}\n", 4, "unknown_key"},
        {MOVING "    motion: {velocity_mps: [1e4, 0, 0]}\n", 4, "out_of_range"},
        {MOVING "    motion: {velocity_mps: 3}\n", 4, "wrong_form"},
        {MOVING "    motion: {orbit_radius_m: 3}\n", 4, "missing_key"},
        {MOVING "    motion: {orbit_period_s: 3}\n", 4, "no_effect"},
        {MOVING "    motion: {orbit_radius_m: 3, orbit_period_s: 0}\n", 4, "out_of_range"},
        {MOVING "    motion: {loops: true}\n", 4, "no_effect"},
        {MOVING "    motion: {path: []}\n", 4, "missing_key"},
        {MOVING "    motion: {path: [3]}\n", 4, "wrong_form"},
        {MOVING "    motion:\n      path:\n        - {time_s: 3}\n        - {time_s: 3}\n", 7, "out_of_range"},
        {"inputs:\n  - field: foam\n    tide: [[0, 1]]\n", 3, "no_effect"},
        {"inputs:\n  - field: level\n    tide: [[0, 1], [0, 2]]\n", 3, "out_of_range"},
        {"inputs:\n  - field: level\n    tide: [[0, 1, 2]]\n", 3, "out_of_range"},
        {"inputs:\n  - field: flow\n    tide: [[0, 1]]\n", 3, "out_of_range"},
        {"inputs:\n  - field: flow\n    tide: [[0, 1, 200]]\n", 3, "out_of_range"},
        {"inputs:\n  - field: flow\n    value: [90, 0]\n    tide: [[0, 20, 0]]\n", 4, "out_of_range"},
        {"inputs:\n  - field: level\n    tide: [[0, .nan]]\n", 3, "wrong_form"},
        {"inputs:\n  - field: level\n    tide: [[0, 1], {constituent: M2}]\n", 3, "wrong_form"},
        {"inputs:\n  - field: level\n    tide: {}\n", 3, "missing_key"},
        {"inputs:\n  - field: level\n    tide: {file: none.csv}\n", 3, "bad_file"},
        {"inputs:\n  - field: level\n    tide: {file: bad.csv}\n", 3, "bad_file"},
        {"inputs:\n  - field: level\n    tide: {file: words.csv}\n", 3, "bad_file"},
        {"inputs:\n  - field: level\n    tide: {file: empty.csv}\n", 3, "bad_file"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swScene* scene = NULL;
        char wanted[64];
        swHost host = MakeHost();
        swResult result = swReadSceneText(&host, cases[i].text, strlen(cases[i].text), "a.yaml", ".", &scene);
        snprintf(wanted, sizeof(wanted), "a.yaml:%d: ", cases[i].line);
        const char* message = strstr(s_messages, wanted);
        if (result != SW_ERROR_FORMAT || message == NULL || strstr(message, cases[i].code) == NULL)
        {
            fail_msg("case %d: wanted line %d [%s], found:\n%s", (int)i, cases[i].line, cases[i].code, s_messages);
        }
        assert_null(scene);
    }
    remove("bad.csv");
    remove("words.csv");
    remove("empty.csv");
}

static void FailingMemoryLeavesNothingBehind(void** state)
{
    (void)state;
    static const char text[] = "inputs:\n"
                               "  - {field: flow, tide: [[0, 1, 2], [3, 4, 5]]}\n"
                               "  - {field: level, shape: circle, tide: {file: tide.csv}, motion: {path: [{}]}}\n"
                               "water_bodies: [{points: [[0, 0], [9, 0], [0, 9]], tide: [[0, 1]]}]\n";
    WriteText("tide.csv", "0 1\n9 2\n");
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swScene* scene = NULL;
    assert_int_equal(swReadSceneText(&host, text, strlen(text), "a.yaml", ".", &scene), SW_SUCCESS);
    swDestroyScene(scene);
    assert_int_equal(atomic_load(&memory.bytes), 0);
    long long allocations = atomic_load(&memory.allocations);
    for (long long i = 0; i < allocations; ++i)
    {
        atomic_store(&memory.allocations, 0);
        atomic_store(&memory.failAt, i);
        assert_int_equal(swReadSceneText(&host, text, strlen(text), "a.yaml", ".", &scene), SW_ERROR_NO_MEMORY);
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
    remove("tide.csv");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AnInputMovesWithItsVelocity),
        cmocka_unit_test(AWorldBeginsWithEverythingInItsPlace),
        cmocka_unit_test(AMovedOriginLeavesInputsInTheSea),
        cmocka_unit_test(AnOrbitClosesAfterItsPeriod),
        cmocka_unit_test(APathIsFollowed),
        cmocka_unit_test(ATurningInputTurnsForYears),
        cmocka_unit_test(WhatLeavesTheSeaIsTold),
        cmocka_unit_test(PlacesAreTheSameOnEveryMachine),
        cmocka_unit_test(ATideByATableRunsThroughItsLines),
        cmocka_unit_test(WritingLeavesThemAsTheyStand),
        cmocka_unit_test(EveryMistakeHasItsLineAndCode),
        cmocka_unit_test(FailingMemoryLeavesNothingBehind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
