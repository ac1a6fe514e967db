// SPDX-License-Identifier: MIT
#include "core/frame/frame.h"

static const swLayerInfo layers[SW_LAYERS] = {
#define SW_LAYER(NAME, layerName, Maker, ...) {.name = #layerName, __VA_ARGS__},
#include "core/frame/layers.inl"
#undef SW_LAYER
};

const swLayerInfo* swGetLayerInfo(int layer)
{
    return &layers[layer];
}

swFoamSliceParams swGetFoamParams(const swFrame* frame, const swStackFrame* stack, int i, float seconds, bool isSteady)
{
    swFoamBirth birth = swGetFoamBirth(stack, i);
    return (swFoamSliceParams){
        .rest = birth.rest,
        .threshold = frame->foamLaw.threshold,
        .growth = birth.growth,
        .fadeRate = frame->foam.fadeRate,
        .dt = seconds,
        .start = frame->foamLaw.cover,
        .isSteady = isSteady ? 1 : 0,
        .texel = (float)stack->slices[i].texel,
        .currentX = frame->foamLaw.currentX,
        .currentZ = frame->foamLaw.currentZ,
    };
}

swMadeFoamParams swGetMadeFoamParams(const swFrame* frame, int layer, float seconds, bool isSteady)
{
    const swFoamDef* foam = &frame->foam;
    return (swMadeFoamParams){
        .wakeFadeRate = foam->wakeFadeRate,
        .shoreFadeRate = foam->shoreFadeRate,
        .shoreWidth = foam->shoreWidth,
        .shoreRate = foam->shoreRate,
        .dt = seconds,
        .isSteady = isSteady ? 1 : 0,
        .isWake = layer == SW_LAYER_WAKE_FOAM ? 1 : 0,
        .currentX = frame->foamLaw.currentX,
        .currentZ = frame->foamLaw.currentZ,
    };
}
