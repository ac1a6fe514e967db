// SPDX-License-Identifier: MIT
#include "core/lod/layer_clock.h"

#include "core/lod/scroll.h"

void swAdvanceLayerClock(swLayerClock* clock, const swLayerInfo* info, int64_t elapsedTicks, swLayerFrame* frame)
{
    const int64_t tick = (int64_t)SW_TICKS_PER_SECOND;
    bool isJump = elapsedTicks < 0 || elapsedTicks > (int64_t)(info->longestGap * SW_TICKS_PER_SECOND);
    frame->isReset = isJump || !clock->isRunning;
    int64_t steps = 0;
    if (frame->isReset)
    {
        clock->isRunning = true;
        clock->remainder = 0;
        clock->resetCount += 1;
    }
    else
    {
        int64_t total = clock->remainder + elapsedTicks * info->rate;
        steps = total / tick;
        clock->remainder = total - steps * tick;
        clock->clock += steps;
    }
    frame->steps = steps < info->mostSteps ? (int)steps : info->mostSteps;
    frame->stepDt = frame->steps == 0 ? 0.0f : (float)steps / (float)info->rate / (float)frame->steps;
    frame->due = steps;
    frame->clock = clock->clock;
    frame->resetCount = clock->resetCount;
}

swCarriedSteps swFindCarriedSteps(const swLayerInfo* info, int64_t due)
{
    int count = due < SW_MOST_CARRIED_STEPS ? (int)due : SW_MOST_CARRIED_STEPS;
    float each = due > count ? (float)due / (float)count : 1.0f;
    return (swCarriedSteps){.count = count, .dt = each / (float)info->rate};
}

swLayerCatchUp swFindCatchUp(const swLayerMark* mark, int layer, const swStackFrame* stack)
{
    const swLayerFrame* frame = &stack->layers[layer];
    int64_t passed = frame->clock - mark->clock;
    bool isReset = !mark->hasPast || mark->resetCount != frame->resetCount || passed < -swGetLayerInfo(layer)->rate;
    int64_t steps = isReset || passed < 0 ? 0 : passed; // a world that went back a little meets its past again
    return (swLayerCatchUp){
        .isReset = isReset,
        .steps = steps,
        .isDue = isReset || steps != 0 || swHasStackMoved(stack, mark->slices),
    };
}

void swMoveMark(swLayerMark* mark, int layer, const swStackFrame* stack)
{
    const swLayerFrame* frame = &stack->layers[layer];
    bool isBehind = mark->resetCount == frame->resetCount && mark->clock > frame->clock &&
                    mark->clock - frame->clock <= swGetLayerInfo(layer)->rate;
    mark->hasPast = true;
    mark->clock = isBehind ? mark->clock : frame->clock;
    mark->resetCount = frame->resetCount;
    memcpy(mark->slices, stack->slices, sizeof mark->slices);
}
