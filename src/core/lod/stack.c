// SPDX-License-Identifier: MIT
#include "core/lod/stack.h"

#include <math.h>

#include "core/math/scalar.h"

#define LN2 0.69314718055994530942

swStack swMakeStack(const swViewDef* def)
{
    return (swStack){
        .sliceCount = def->sliceCount,
        .resolution = def->resolution,
        .maxScaleLevel = def->maxScaleLevel,
        .finestTexel = (double)def->finestTexel,
    };
}

// Doublings of the viewer's height above the one up to which the stack is at its finest; below 0 counts as far below.
static double measureLevel(const swStack* stack, double height)
{
    double finestHeight = stack->finestTexel * stack->resolution / 4.0;
    double ratio = height / finestHeight;
    return ratio > 0.5 ? swLn(ratio) / LN2 : -1.0;
}

static int chooseLevel(const swStack* stack, double measured)
{
    int level = stack->scaleLevel;
    double margin = stack->isPlaced ? SW_SCALE_HYSTERESIS : 0.0;
    while (level < stack->maxScaleLevel && measured >= level + 1 + margin)
    {
        level += 1;
    }
    while (level > 0 && measured < level - margin)
    {
        level -= 1;
    }
    return level;
}

// 0 at the top level: there is nothing to fade into.
static float chooseFade(const swStack* stack, double measured)
{
    if (stack->scaleLevel >= stack->maxScaleLevel)
    {
        return 0.0f;
    }
    double along = (measured - stack->scaleLevel - SW_SCALE_HYSTERESIS) / (1.0 - 2.0 * SW_SCALE_HYSTERESIS);
    return (float)(along < 0.0 ? 0.0 : along > 1.0 ? 1.0 : along);
}

void swPlaceStack(swStack* stack, swPos viewpoint, double seaLevel)
{
    double measured = measureLevel(stack, fabs(viewpoint.y - seaLevel));
    stack->scaleLevel = chooseLevel(stack, measured);
    stack->fade = chooseFade(stack, measured);
    stack->isPlaced = true;
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        stack->slices[i] =
            swSnapSlice(stack->finestTexel, stack->scaleLevel + i, stack->resolution, viewpoint.x, viewpoint.z);
    }
}
