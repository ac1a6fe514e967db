// SPDX-License-Identifier: MIT
#include "core/frame/frame.h"

#include "core/math/scalar.h"
#include "shared/carry.h"

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

// ---- a flow that is the same everywhere ----

// What one wave of a tide adds to the path between two times: the integrals of cos and sin, as products, which are as
// good over a short way as over a long one.
static void addSwing(const swEvenSwing* swing, double from, double to, swPosXZ* path)
{
    double half = swSin(0.5 * swing->speed * (to - from)) * 2.0 / swing->speed;
    double middle = 0.5 * swing->speed * (from + to);
    double cosine = half * swCos(middle), sine = half * swSin(middle);
    path->x += (double)swing->cosineX * cosine + (double)swing->sineX * sine;
    path->z += (double)swing->cosineZ * cosine + (double)swing->sineZ * sine;
}

swPosXZ swIntegrateEvenFlow(const swEvenFlow* flow, int64_t ticks)
{
    double from = (double)flow->begin / SW_TICKS_PER_SECOND, to = (double)ticks / SW_TICKS_PER_SECOND;
    swPosXZ path = {flow->x + (double)flow->velocityX * (to - from), flow->z + (double)flow->velocityZ * (to - from)};
    for (int i = 0; i < flow->swingCount; ++i)
    {
        addSwing(&flow->swings[i], from, to, &path);
    }
    return path;
}

// ---- copies of waves in a flow ----

// Octaves begin anew at different times: none of them is seen to.
#define OCTAVE_TURNS 0x9e3779b9u // of 2^32: the golden section

uint32_t swGetCarryPhase(float k, int64_t loopTicks, int64_t ticks, float* period)
{
    *period = swGetCarryPeriod(k);
    int exponent;
    frexpf(k, &exponent);
    uint32_t begin = (uint32_t)exponent * OCTAVE_TURNS;
    if (loopTicks > 0)
    {
        double loop = (double)loopTicks / SW_TICKS_PER_SECOND;
        double count = fmax(floor(loop / (double)*period + 0.5), 1.0); // whole periods a loop
        *period = (float)(loop / count);
        return begin + swGetFractionOfTurn(count * ((double)(ticks % loopTicks) / (double)loopTicks));
    }
    int64_t periodTicks = (int64_t)((double)*period * SW_TICKS_PER_SECOND); // below 2^32
    int64_t rest = ticks % periodTicks;
    rest += rest < 0 ? periodTicks : 0;
    return begin + (uint32_t)(((uint64_t)rest << 32) / (uint64_t)periodTicks);
}

int swFindCarriedEnd(const swFreeWave* waves, int first, int count)
{
    float k = swGetOctaveWaveNumber(waves[first].wavelength);
    int end = first + 1;
    while (end < count && waves[end].system == waves[first].system && swGetOctaveWaveNumber(waves[end].wavelength) == k)
    {
        end += 1;
    }
    return end;
}
