// SPDX-License-Identifier: MIT
// Plans and makes the layers of views and zones, in the order of layers.inl.

#include "core/world/world.h"

#define SW_LAYER(NAME, name, Maker, ...)                                                                               \
    swPlanLayerFcn swPlan##Maker;                                                                                      \
    swStepLayerFcn swStep##Maker;
#include "core/frame/layers.inl"
#undef SW_LAYER

typedef struct Maker
{
    swPlanLayerFcn* plan;
    swStepLayerFcn* step;
} Maker;

static const Maker makers[SW_LAYERS] = {
#define SW_LAYER(NAME, name, Maker, ...) {swPlan##Maker, swStep##Maker},
#include "core/frame/layers.inl"
#undef SW_LAYER
};

// How many layers from `first` on are made together.
static int countTogether(int first)
{
    int count = 1;
    while (first + count < SW_LAYERS && makers[first + count].step == makers[first].step)
    {
        count += 1;
    }
    return count;
}

void swPlanLayers(const swWorld* world, const swLayerStack* layers, swStackFrame* stack)
{
    const swLayerPlan plan = {.def = &world->def, .frame = &world->frame, .stack = stack};
    for (int i = 0; i < SW_LAYERS; i += countTogether(i))
    {
        if (swHasLayer(layers, i))
        {
            makers[i].plan(&plan);
        }
    }
}

void swMakeFrameLayers(const swWorld* world, swLayerStack* layers, swStackFrame* stack)
{
    swLayerStep step = {.host = &world->host, .kernels = world->kernels, .frame = &world->frame, .stack = stack};
    for (int i = 0; i < SW_LAYERS; i += countTogether(i))
    {
        if (swHasLayer(layers, i))
        {
            swStepLayers(layers, i, countTogether(i), makers[i].step, &step, stack);
        }
    }
}
