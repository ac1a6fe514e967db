// SPDX-License-Identifier: MIT
// On the device, copies of authored fields in slices that move are, to the bit, those of a view that was not there
// before, and so are the waves that they shape. Views of one world share its inputs: they are brought once.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RESOLUTION 64
#define SLICES 3

static swInputId Add(Parity* parity, swInputField field, swInputShape shape, swPos position, float size, float value)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = shape;
    def.position = position;
    def.size = (swVec3){size, 0.0f, 0.7f * size};
    def.feather = shape == SW_SHAPE_EVERYWHERE ? 0.0f : 0.2f * size;
    def.value[0] = value;
    swInputId id;
    assert_int_equal(swCreateInput(parity->world, &def, &id), SW_SUCCESS);
    return id;
}

static swView* MakeView(Parity* parity, swPos viewpoint)
{
    swViewDef def = swDefaultViewDef();
    def.sliceCount = SLICES;
    def.resolution = RESOLUTION;
    def.finestTexel = 0.25f;
    swView* view = NULL;
    assert_int_equal(swCreateView(parity->world, &def, &view), SW_SUCCESS);
    swView_SetViewpoint(view, viewpoint);
    return view;
}

static void Read(Parity* parity, const swView* view, swLayer layer, int slice, float* texels)
{
    assert_int_equal(swGpuWorld_ReadLayer(parity->gpuWorld, view, layer, slice, texels), SW_SUCCESS);
}

static void CheckAgainstAFreshView(Parity* parity, const swView* view, swPos viewpoint)
{
    static float moved[RESOLUTION * RESOLUTION * 4], made[RESOLUTION * RESOLUTION * 4];
    const swLayer layers[4] = {SW_LAYER_PLACES, SW_LAYER_FLOW, SW_LAYER_FLOW_SLOPES, SW_LAYER_DISPLACEMENT};
    swView* fresh = MakeView(parity, viewpoint);
    StepParity(parity, 0.0);
    for (int i = 0; i < 4 * SLICES; ++i)
    {
        Read(parity, view, layers[i / SLICES], i % SLICES, moved);
        Read(parity, fresh, layers[i / SLICES], i % SLICES, made);
        assert_memory_equal(moved, made, sizeof moved);
    }
    swDestroyView(fresh);
}

static void AViewThatMovesHasWhatAFreshOneHas(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    AddParitySea(&parity, &waves);
    Add(&parity, SW_INPUT_FLOOR, SW_SHAPE_EVERYWHERE, (swPos){0.0, -9.0, 0.0}, 1.0f, -9.0f);
    Add(&parity, SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, (swPos){20.0, 0.0, 5.0}, 30.0f, 2.0f);
    Add(&parity, SW_INPUT_FLOW, SW_SHAPE_CIRCLE, (swPos){-5.0, 0.0, 3.0}, 12.0f, 1.0f);
    swInputId shoal = Add(&parity, SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, (swPos){0.0, 0.0, 0.0}, 5.0f, -1.0f);
    swInputId lock = Add(&parity, SW_INPUT_LEVEL, SW_SHAPE_RECTANGLE, (swPos){9.0, 0.0, -4.0}, 6.0f, 1.5f);
    swInputId calm = Add(&parity, SW_INPUT_WAVES, SW_SHAPE_CIRCLE, (swPos){-9.0, 0.0, 1.0}, 6.0f, 0.2f);
    swView* view = MakeView(&parity, (swPos){0.0, 1.5, 0.0});
    for (int step = 0; step < 100; ++step)
    {
        swPos viewpoint = {-9.0 + 0.13 * step, step > 70 ? 30.0 : 1.5, 6.0 * sin(0.08 * step)};
        swView_SetViewpoint(view, viewpoint);
        swInput_Move(parity.world, shoal, (swPos){0.11 * step, 0.0, -0.07 * step}, (swAngles){0});
        if (step % 10 == 3)
        {
            swInput_Enable(parity.world, lock, step % 20 == 3);
            swInput_Move(parity.world, calm, (swPos){0.2 * step - 9.0, 0.0, 1.0}, (swAngles){0});
        }
        assert_int_equal(swWorld_Step(parity.world, 0.05), SW_SUCCESS); // one that this device does not see
        StepParity(&parity, 0.05);
        if (step % 20 == 9 || step == 99)
        {
            CheckAgainstAFreshView(&parity, view, viewpoint);
        }
    }
    FreeParity(&parity);
}

// ---- what is brought ----

static PFN_vkCmdCopyBuffer s_copy;
static VkBuffer s_targets[64];
static int s_copies;

static VKAPI_ATTR void VKAPI_CALL NoteCopy(VkCommandBuffer commands, VkBuffer from, VkBuffer to, uint32_t count,
                                           const VkBufferCopy* regions)
{
    s_targets[s_copies++ % 64] = to;
    s_copy(commands, from, to, count, regions);
}

// How often inputs are brought in a frame: of each buffer.
static void CheckBrought(Parity* parity, int wanted)
{
    s_copies = 0;
    StepParity(parity, 0.1);
    const swGpuInputs* inputs = &parity->gpuWorld->inputs;
    const VkBuffer buffers[3] = {inputs->records.handle, inputs->nodes.handle, inputs->words.handle};
    for (int b = 0; b < 3; ++b)
    {
        int found = 0;
        for (int i = 0; i < s_copies; ++i)
        {
            found += s_targets[i] == buffers[b] ? 1 : 0;
        }
        assert_int_equal(found, wanted);
    }
}

static void ViewsShareTheInputs(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    AddParitySea(&parity, &waves);
    const swInputPoint corners[3] = {{.x = -9.0f, .z = -9.0f}, {.x = 9.0f, .z = -9.0f}, {.x = 0.0f, .z = 9.0f}};
    swInputDef def = swDefaultInputDef();
    def.shape = SW_SHAPE_POLYGON;
    def.points = corners;
    def.pointCount = 3;
    def.value[0] = -3.0f;
    swInputId id;
    assert_int_equal(swCreateInput(parity.world, &def, &id), SW_SUCCESS);
    for (int i = 0; i < 3; ++i)
    {
        MakeView(&parity, (swPos){5.0 * i, 2.0, 0.0});
    }
    s_copy = parity.gpu->vk.CmdCopyBuffer;
    parity.gpu->vk.CmdCopyBuffer = NoteCopy;
    CheckBrought(&parity, 1); // for three views
    CheckBrought(&parity, 0);
    MakeView(&parity, (swPos){0.0, 2.0, 9.0});
    CheckBrought(&parity, 0); // a view more wants no more of them
    swInput_Move(parity.world, id, (swPos){1.0, 0.0, 0.0}, (swAngles){0});
    s_copies = 0;
    StepParity(&parity, 0.1);
    assert_true(s_copies > 0);
    parity.gpu->vk.CmdCopyBuffer = s_copy;
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AViewThatMovesHasWhatAFreshOneHas),
        cmocka_unit_test(ViewsShareTheInputs),
    };
    return cmocka_run_group_tests(tests, OpenParityGpu, CloseParityGpu);
}
