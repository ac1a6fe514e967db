// SPDX-License-Identifier: MIT
// Foam of inputs and of shores agrees within 0.001 at every texel of every slice, over frames in which slices scroll,
// inputs move, come and go, and time jumps.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>

#define TOLERANCE 1e-3

static Parity MakeShore(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.spectrum.windSpeed = 6.0f;
    AddParitySea(&parity, &waves);
    AddParityView(&parity, 3, 64, (swPos){0.0, 2.0, 0.0});
    return parity;
}

static swInputId AddShoal(Parity* parity)
{
    swInputDef shoal = swDefaultInputDef();
    shoal.shape = SW_SHAPE_CIRCLE;
    shoal.size = (swVec3){60.0f, 0.0f, 60.0f};
    shoal.feather = 28.0f;
    shoal.value[0] = 3.0f;
    swInputId id;
    assert_int_equal(swCreateInput(parity->world, &shoal, &id), SW_SUCCESS);
    return id;
}

static swInputId AddMaker(Parity* parity, float size, bool followsWaves)
{
    swInputDef maker = swDefaultInputDef();
    maker.field = SW_INPUT_FOAM;
    maker.shape = SW_SHAPE_CIRCLE;
    maker.blend = SW_BLEND_ADD;
    maker.size = (swVec3){size, 0.0f, size};
    maker.feather = 1.0f;
    maker.value[0] = 1.5f;
    maker.followsWaves = followsWaves;
    swInputId id;
    assert_int_equal(swCreateInput(parity->world, &maker, &id), SW_SUCCESS);
    return id;
}

static void CheckLayer(Parity* parity, swLayer layer, const char* what)
{
    Difference difference = CompareLayer(parity, layer);
    PrintDifference(what, difference, "");
    assert_true(difference.worst < TOLERANCE);
    assert_true(difference.scale > 0.01); // there is foam at all
}

static void FoamOfMovingInputsAgrees(void** state)
{
    Parity parity = MakeShore(state);
    swInputId id = AddMaker(&parity, 8.0f, false);
    AddMaker(&parity, 5.0f, true);
    for (int i = 0; i < 40; ++i)
    {
        swInput_Move(parity.world, id, (swPos){0.15 * i, 0.0, -0.1 * i}, (swAngles){0});
        swView_SetViewpoint(parity.view, (swPos){0.11 * i, 2.0, 0.07 * i});
        StepParity(&parity, i % 7 == 0 ? 0.11 : 1.0 / 60.0);
    }
    CheckLayer(&parity, SW_LAYER_WAKE_FOAM, "40 frames, an input and the viewer moving");
    swDestroyInput(parity.world, id);
    StepParity(&parity, 0.5);
    CheckLayer(&parity, SW_LAYER_WAKE_FOAM, "half a second after it is gone");
    FreeParity(&parity);
}

// A stream past the view, strongest in its middle.
static void AddStream(Parity* parity, float size)
{
    swInputDef stream = swDefaultInputDef();
    stream.field = SW_INPUT_FLOW;
    stream.shape = SW_SHAPE_CIRCLE;
    stream.size = (swVec3){size, 0.0f, size};
    stream.feather = 0.5f * size;
    stream.value[0] = 2.5f;
    stream.value[1] = -1.0f;
    swInputId id;
    assert_int_equal(swCreateInput(parity->world, &stream, &id), SW_SUCCESS);
}

static void FoamThatWaterCarriesAgrees(void** state)
{
    Parity parity = MakeShore(state);
    swInputId id = AddMaker(&parity, 6.0f, false);
    AddShoal(&parity);
    AddStream(&parity, 25.0f);
    Difference difference = {0};
    for (int i = 0; i < 60; ++i)
    {
        if (i == 30)
        {
            swDestroyInput(parity.world, id);
        }
        swView_SetViewpoint(parity.view, (swPos){0.05 * i, 2.0, 0.03 * i});
        StepParity(&parity, i % 7 == 0 ? 0.21 : i % 5 == 0 ? 1.0 / 20.0 : 1.0 / 60.0);
        difference = MaxDifference(difference, CompareLayer(&parity, SW_LAYER_WAKE_FOAM));
    }
    PrintDifference("60 frames of foam in a stream", difference, "");
    assert_true(difference.worst < TOLERANCE && difference.scale > 0.01);
    CheckLayer(&parity, SW_LAYER_SHORE_FOAM, "foam of a shore in the stream");
    FreeParity(&parity);
}

static void FoamOfShoresAgrees(void** state)
{
    Parity parity = MakeShore(state);
    AddShoal(&parity);
    for (int i = 0; i < 20; ++i)
    {
        swView_SetViewpoint(parity.view, (swPos){0.2 * i, 2.0, 0.0});
        StepParity(&parity, 1.0 / 30.0);
    }
    CheckLayer(&parity, SW_LAYER_SHORE_FOAM, "20 frames at a shore");
    FreeParity(&parity);
}

static void LayersComeAndGoWithInputs(void** state)
{
    Parity parity = MakeShore(state);
    for (int i = 0; i < 24; ++i)
    {
        swInputId shoal = {0}, maker = {0};
        if (i % 8 == 2)
        {
            shoal = AddShoal(&parity);
            maker = AddMaker(&parity, 6.0f, false);
        }
        if (i % 8 == 5)
        {
            swWorld_SetTime(parity.world, 500.0 * i);
        }
        StepParity(&parity, 1.0 / 30.0);
        if (i % 8 == 2)
        {
            CheckLayer(&parity, SW_LAYER_SHORE_FOAM, "a shore that has just come");
            swDestroyInput(parity.world, shoal);
            swDestroyInput(parity.world, maker);
        }
    }
    assert_null(swView_GetShoreFoam(parity.view, 0));
    assert_null(swView_GetWakeFoam(parity.view, 0)); // time has jumped since
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(FoamOfMovingInputsAgrees),
        cmocka_unit_test(FoamOfShoresAgrees),
        cmocka_unit_test(FoamThatWaterCarriesAgrees),
        cmocka_unit_test(LayersComeAndGoWithInputs),
    };
    return cmocka_run_group_tests(tests, OpenParityGpu, CloseParityGpu);
}
