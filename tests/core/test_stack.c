// SPDX-License-Identifier: MIT
// Slices follow the viewer in whole texels of lattices that are fixed to the world, wherever the viewer is, and the
// stack's scale follows the height without a jump in what is seen.

#include "support/cmocka_setup.h"

#include <math.h>

#include "core/lod/stack.h"

static swStack MakeDefaultStack(void)
{
    swViewDef def = {.sliceCount = 7, .resolution = 384, .finestTexel = 1.0f / 16.0f, .maxScaleLevel = 10};
    return swMakeStack(&def);
}

// A number in [0, 1) from a counter.
static double Random(uint64_t* counter)
{
    uint64_t x = (*counter += 0x9E3779B97F4A7C15u);
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return (double)((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

static void CheckStack(const swStack* stack, swPos viewpoint)
{
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        const swSlice* slice = &stack->slices[i];
        double texel = stack->finestTexel * exp2(stack->scaleLevel + i);
        assert_true(slice->texel == texel);
        assert_int_equal(slice->level, stack->scaleLevel + i);
        assert_true(slice->minWavelength == (float)(8.0 * texel));
        // The viewer is within the texel in the middle.
        double fromX = viewpoint.x - (double)(slice->firstX + stack->resolution / 2) * texel;
        double fromZ = viewpoint.z - (double)(slice->firstZ + stack->resolution / 2) * texel;
        assert_true(fromX >= 0.0 && fromX < texel && fromZ >= 0.0 && fromZ < texel);
    }
    for (int i = 1; i < stack->sliceCount; ++i)
    {
        // A slice lies within the next one, a quarter of whose texels it covers, give or take one.
        const swSlice* fine = &stack->slices[i - 1];
        const swSlice* coarse = &stack->slices[i];
        int64_t offset = fine->firstX - 2 * coarse->firstX;
        assert_true(offset == stack->resolution / 2 || offset == stack->resolution / 2 + 1);
    }
}

static void RandomViewersGetCentredNestedSlices(void** state)
{
    (void)state;
    uint64_t counter = 1;
    for (int i = 0; i < 10000; ++i)
    {
        swStack stack = MakeDefaultStack();
        double reach = pow(10.0, 7.0 * Random(&counter));
        swPos viewpoint = {
            .x = reach * (2.0 * Random(&counter) - 1.0),
            .y = pow(10.0, 5.0 * Random(&counter) - 1.0),
            .z = reach * (2.0 * Random(&counter) - 1.0),
        };
        swPlaceStack(&stack, viewpoint, 0.0);
        CheckStack(&stack, viewpoint);
    }
}

static void AThousandKilometresAwayIsAsTheOrigin(void** state)
{
    (void)state;
    const double far = 1048576.0; // a multiple of every texel
    for (int i = 0; i < 1000; ++i)
    {
        swStack here = MakeDefaultStack();
        swStack there = MakeDefaultStack();
        swPos viewpoint = {0.013 * i, 3.0 + i, -0.0371 * i};
        swPlaceStack(&here, viewpoint, 0.0);
        // 0.013 i is not exact in double near 2^20; take what is there.
        swPos moved = {viewpoint.x + far, viewpoint.y, viewpoint.z - far};
        viewpoint.x = moved.x - far;
        viewpoint.z = moved.z + far;
        swPlaceStack(&here, viewpoint, 0.0);
        swPlaceStack(&there, moved, 0.0);
        for (int s = 0; s < here.sliceCount; ++s)
        {
            int64_t texels = (int64_t)(far / here.slices[s].texel);
            assert_int_equal(there.slices[s].firstX - here.slices[s].firstX, texels);
            assert_int_equal(there.slices[s].firstZ - here.slices[s].firstZ, -texels);
        }
        assert_true(here.fade == there.fade && here.scaleLevel == there.scaleLevel);
    }
}

// What is seen: the level plus how far it has turned into the next.
static double SeenLevel(const swStack* stack)
{
    return stack->scaleLevel + (double)stack->fade;
}

static void ClimbAndDescend(double from, double to, double factor)
{
    swStack stack = MakeDefaultStack();
    double height = from;
    swPlaceStack(&stack, (swPos){0.0, height, 0.0}, 0.0);
    double seen = SeenLevel(&stack);
    while (factor > 1.0 ? height < to : height > to)
    {
        height *= factor;
        swPlaceStack(&stack, (swPos){0.0, height, 0.0}, 0.0);
        double now = SeenLevel(&stack);
        // log2(factor) / (1 - 2 delta) at most, and never backwards.
        double most = fabs(log2(factor)) / (1.0 - 2.0 * SW_SCALE_HYSTERESIS) + 1e-6;
        double change = factor > 1.0 ? now - seen : seen - now;
        assert_true(change >= 0.0 && change <= most);
        seen = now;
    }
}

static void ScaleChangesContinuouslyWithHeight(void** state)
{
    (void)state;
    ClimbAndDescend(0.5, 2e5, 1.001);
    ClimbAndDescend(2e5, 0.5, 0.999);
}

static void Bob(swStack stack, double boundary, int level)
{
    for (int i = 0; i < 100; ++i)
    {
        double height = boundary * (1.0 + 0.05 * sin(i));
        swPlaceStack(&stack, (swPos){0.0, height, 0.0}, 0.0);
        assert_int_equal(stack.scaleLevel, level);
    }
}

static void BobbingAtABoundaryChangesNoLevel(void** state)
{
    (void)state;
    for (int level = 1; level < 9; ++level)
    {
        swStack stack = MakeDefaultStack();
        double boundary = 6.0 * exp2(level); // a quarter of the finest slice's side is 6 m
        swPlaceStack(&stack, (swPos){0.0, boundary * 0.999, 0.0}, 0.0);
        Bob(stack, boundary, level - 1);
        stack = MakeDefaultStack();
        swPlaceStack(&stack, (swPos){0.0, boundary * 1.001, 0.0}, 0.0);
        Bob(stack, boundary, level);
    }
}

static void LevelStaysWithinItsRange(void** state)
{
    (void)state;
    swStack stack = MakeDefaultStack();
    swPlaceStack(&stack, (swPos){0.0, 0.0, 0.0}, 0.0);
    assert_int_equal(stack.scaleLevel, 0);
    assert_true(stack.fade == 0.0f);
    swPlaceStack(&stack, (swPos){0.0, 1e9, 0.0}, 0.0);
    assert_int_equal(stack.scaleLevel, 10);
    assert_true(stack.fade == 0.0f);
    swPlaceStack(&stack, (swPos){0.0, -40.0, 0.0}, 100.0); // height is counted from the sea, up or down
    assert_int_equal(stack.scaleLevel, 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(RandomViewersGetCentredNestedSlices),
        cmocka_unit_test(AThousandKilometresAwayIsAsTheOrigin),
        cmocka_unit_test(ScaleChangesContinuouslyWithHeight),
        cmocka_unit_test(BobbingAtABoundaryChangesNoLevel),
        cmocka_unit_test(LevelStaysWithinItsRange),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
