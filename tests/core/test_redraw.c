// SPDX-License-Identifier: MIT
// Copies of authored fields in slices that move are, to the bit, what they would be if they were made anew, and only
// what is new or has changed is made.

#include "support/cmocka_setup.h"

#include <math.h>
#include <string.h>

#include "core/lod/redraw.h"
#include "core/world/world.h"
#include "seaway/input.h"
#include "seaway/save.h"

#define RESOLUTION 64
#define SLICES 4
#define TEXELS (SLICES * RESOLUTION * RESOLUTION)

typedef struct Bay
{
    swWorld* world;
    swView* view;
    swInputId shoal, lock, stream;
} Bay;

static swViewDef MakeViewDef(float finestTexel)
{
    swViewDef def = swDefaultViewDef();
    def.sliceCount = SLICES;
    def.resolution = RESOLUTION;
    def.finestTexel = finestTexel;
    def.enableCpuLayers = true;
    return def;
}

static swInputId AddInput(swWorld* world, swInputField field, swInputShape shape, swPos position, float size,
                          float value)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = shape;
    def.position = position;
    def.size = (swVec3){size, 0.0f, 0.7f * size};
    def.feather = shape == SW_SHAPE_EVERYWHERE ? 0.0f : 0.2f * size;
    def.value[0] = value;
    def.value[1] = 0.3f * value;
    swInputId id;
    assert_int_equal(swCreateInput(world, &def, &id), SW_SUCCESS);
    return id;
}

static Bay MakeBay(float finestTexel)
{
    Bay bay;
    swHost host = swDefaultHost();
    swWorldDef def = swDefaultWorldDef();
    assert_int_equal(swCreateWorld(&host, &def, &bay.world), SW_SUCCESS);
    swViewDef viewDef = MakeViewDef(finestTexel);
    assert_int_equal(swCreateView(bay.world, &viewDef, &bay.view), SW_SUCCESS);
    AddInput(bay.world, SW_INPUT_FLOOR, SW_SHAPE_EVERYWHERE, (swPos){0.0, -20.0, 0.0}, 1.0f, -20.0f);
    AddInput(bay.world, SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, (swPos){20.0, 0.0, 5.0}, 30.0f, 2.0f);
    bay.shoal = AddInput(bay.world, SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, (swPos){0.0, 0.0, 0.0}, 5.0f, -1.0f);
    bay.lock = AddInput(bay.world, SW_INPUT_LEVEL, SW_SHAPE_RECTANGLE, (swPos){9.0, 0.0, -4.0}, 6.0f, 1.5f);
    bay.stream = AddInput(bay.world, SW_INPUT_FLOW, SW_SHAPE_CIRCLE, (swPos){-5.0, 0.0, 3.0}, 12.0f, 1.0f);
    return bay;
}

static void Step(Bay* bay, double dt)
{
    assert_int_equal(swWorld_Step(bay->world, dt), SW_SUCCESS);
}

static int CountMade(const Bay* bay)
{
    return bay->view->layers.states[SW_LAYER_PLACES].note.made;
}

// Against a view that was not there before.
static void CheckAgainstAFreshView(Bay* bay, swPos viewpoint)
{
    swViewDef def = bay->view->def;
    swView* fresh = NULL;
    assert_int_equal(swCreateView(bay->world, &def, &fresh), SW_SUCCESS);
    swView_SetViewpoint(fresh, viewpoint);
    Step(bay, 0.0);
    assert_int_equal(fresh->layers.states[SW_LAYER_PLACES].note.made, TEXELS);
    for (int slice = 0; slice < SLICES; ++slice)
    {
        size_t size = (size_t)RESOLUTION * RESOLUTION * 4 * sizeof(float);
        assert_memory_equal(swView_GetPlaces(bay->view, slice), swView_GetPlaces(fresh, slice), size);
        assert_memory_equal(swView_GetFlow(bay->view, slice), swView_GetFlow(fresh, slice), size);
        assert_memory_equal(swView_GetFlowSlopes(bay->view, slice), swView_GetFlowSlopes(fresh, slice), size);
    }
    swDestroyView(fresh);
}

// Inputs move, change, come and go, each in its time.
static void ChangeInputs(Bay* bay, int step)
{
    swInput_Move(bay->world, bay->shoal, (swPos){0.11 * step, 0.0, -0.07 * step}, (swAngles){0});
    if (step % 10 == 3)
    {
        swInput_Enable(bay->world, bay->lock, step % 20 == 3);
    }
    if (step % 10 == 6)
    {
        swInput_SetValue(bay->world, bay->stream, (float[4]){0.1f * (float)step, 1.0f});
    }
    if (step % 25 == 12)
    {
        swDestroyInput(bay->world, bay->lock);
        bay->lock = AddInput(bay->world, SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, (swPos){0.1 * step, 0.0, 1.0}, 4.0f, 0.5f);
    }
}

static void AViewThatMovesHasWhatAFreshOneHas(void** state)
{
    (void)state;
    const float texels[2] = {0.25f, 0.0625f};
    for (int k = 0; k < 2; ++k)
    {
        Bay bay = MakeBay(texels[k]);
        double made = 0.0;
        for (int step = 0; step < 100; ++step)
        {
            swPos viewpoint = {0.13 * step, 1.5, 6.0 * sin(0.08 * step)};
            swView_SetViewpoint(bay.view, viewpoint);
            ChangeInputs(&bay, step);
            Step(&bay, 0.05);
            made += step > 0 ? (double)CountMade(&bay) / TEXELS / 99.0 : 0.0;
            if (step % 9 == 0)
            {
                CheckAgainstAFreshView(&bay, viewpoint);
            }
        }
        print_message("texels of %g m: a step makes %.1f %% of them\n", (double)texels[k], 100.0 * made);
        assert_true(made < (k == 0 ? 0.25 : 0.9));
        swDestroyWorld(bay.world);
    }
}

// The camera's speed over the texels of a slice says how much of it is new.
static void ACameraAloneMakesOnlyStrips(void** state)
{
    (void)state;
    Bay bay = MakeBay(0.25f);
    double made = 0.0;
    for (int step = 0; step < 120; ++step)
    {
        swView_SetViewpoint(bay.view, (swPos){5.0 * step / 60.0, 1.5, 2.0 * step / 60.0});
        Step(&bay, 1.0 / 60.0);
        made += step > 0 ? (double)CountMade(&bay) / TEXELS / 119.0 : 0.0;
    }
    print_message("at 5.4 m/s and 60 frames a second: a step makes %.2f %% of the texels\n", 100.0 * made);
    assert_true(made > 0.0 && made < 0.02);
    Step(&bay, 1.0 / 60.0);
    assert_int_equal(CountMade(&bay), 0); // nothing has moved
    CheckAgainstAFreshView(&bay, (swPos){5.0 * 119 / 60.0, 1.5, 2.0 * 119 / 60.0});
    swDestroyWorld(bay.world);
}

static void JumpsAndScalesMakeAllAnew(void** state)
{
    (void)state;
    Bay bay = MakeBay(0.25f);
    const swPos places[5] = {{0.0, 1.5, 0.0}, {2000.0, 1.5, 0.0}, {1.0, 1.5, 1.0}, {1.0, 40.0, 1.0}, {3.0, 1.5, 1.0}};
    for (int i = 0; i < 5; ++i)
    {
        swView_SetViewpoint(bay.view, places[i]);
        Step(&bay, 0.05);
        CheckAgainstAFreshView(&bay, places[i]);
    }
    swDestroyWorld(bay.world);
}

static void RiseWithTime(void* context, double time, int count, const swPosXZ* points, swInputAnswer* answers)
{
    (void)context;
    (void)points;
    for (int i = 0; i < count; ++i)
    {
        answers[i] = (swInputAnswer){.share = 1.0f, .value = {(float)(0.1 * time)}};
    }
}

static void TidesAndFunctionsAreNeverKept(void** state)
{
    (void)state;
    Bay bay = MakeBay(0.25f);
    swInputDef tide = swDefaultInputDef();
    tide.field = SW_INPUT_LEVEL;
    tide.blend = SW_BLEND_ADD;
    tide.shape = SW_SHAPE_CIRCLE;
    tide.size = (swVec3){8.0f, 0.0f, 8.0f};
    tide.tide[0] = (swTideConstituent){.amplitude = 1.0f, .speed = 0.1f};
    swInputId id;
    assert_int_equal(swCreateInput(bay.world, &tide, &id), SW_SUCCESS);
    swInputDef function = swDefaultInputDef();
    function.field = SW_INPUT_FLOOR;
    function.shape = SW_SHAPE_FUNCTION;
    function.function = RiseWithTime;
    function.size = (swVec3){3.0f, 0.0f, 3.0f};
    function.position = (swPos){-6.0, 0.0, -5.0};
    assert_int_equal(swCreateInput(bay.world, &function, &id), SW_SUCCESS);
    Step(&bay, 0.05);
    for (int step = 0; step < 10; ++step)
    {
        Step(&bay, 0.5);
        assert_true(CountMade(&bay) > 0 && CountMade(&bay) < TEXELS / 2);
        CheckAgainstAFreshView(&bay, (swPos){0.0, 0.0, 0.0});
    }
    swDestroyWorld(bay.world);
}

// More changes than are kept: all is made anew rather than something left out.
static void ManyChangesAtOnceAreNotLost(void** state)
{
    (void)state;
    Bay bay = MakeBay(0.25f);
    swInputId ids[70];
    for (int i = 0; i < 70; ++i)
    {
        ids[i] = AddInput(bay.world, SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, (swPos){0.2 * i - 7.0, 0.0, 3.0}, 1.5f, -0.5f);
    }
    Step(&bay, 0.05);
    for (int step = 0; step < 6; ++step)
    {
        for (int i = 0; i < 70; i += 1 + 5 * (step % 2))
        {
            swInput_Move(bay.world, ids[i], (swPos){0.2 * i - 7.0 + 0.1 * step, 0.0, 3.0 - 0.2 * step}, (swAngles){0});
        }
        Step(&bay, 0.05);
        CheckAgainstAFreshView(&bay, (swPos){0.0, 0.0, 0.0});
    }
    swDestroyWorld(bay.world);
}

static void AWorldThatGoesBackMakesAllAnew(void** state)
{
    (void)state;
    Bay bay = MakeBay(0.25f);
    swView_SetViewpoint(bay.view, (swPos){1.0, 1.5, 0.0});
    Step(&bay, 0.05);
    static unsigned char bytes[4 << 20];
    size_t size = sizeof bytes;
    assert_int_equal(swWorld_Save(bay.world, bytes, &size), SW_SUCCESS);
    for (int step = 1; step < 20; ++step)
    {
        swView_SetViewpoint(bay.view, (swPos){1.0 + 0.1 * step, 1.5, 0.0});
        swInput_Move(bay.world, bay.shoal, (swPos){0.2 * step, 0.0, 0.0}, (swAngles){0});
        Step(&bay, 0.05);
    }
    assert_int_equal(swWorld_Rewind(bay.world, bytes, size), SW_SUCCESS);
    CheckAgainstAFreshView(&bay, (swPos){1.0, 1.5, 0.0});
    swView_SetViewpoint(bay.view, (swPos){1.4, 1.5, 0.0});
    Step(&bay, 0.05);
    CheckAgainstAFreshView(&bay, (swPos){1.4, 1.5, 0.0});
    swDestroyWorld(bay.world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AViewThatMovesHasWhatAFreshOneHas), cmocka_unit_test(ACameraAloneMakesOnlyStrips),
        cmocka_unit_test(JumpsAndScalesMakeAllAnew),         cmocka_unit_test(TidesAndFunctionsAreNeverKept),
        cmocka_unit_test(ManyChangesAtOnceAreNotLost),       cmocka_unit_test(AWorldThatGoesBackMakesAllAnew),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
