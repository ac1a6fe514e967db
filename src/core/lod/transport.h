// SPDX-License-Identifier: MIT
#pragma once

// Layers with a past of one number that goes with the water. The formulas are those of shared/transport.h; the GPU's
// twin of the reading is shaders/lib/transport.glsl.

#include <math.h>

#include "core/lod/scroll.h"
#include "shared/transport.h"

// What carries the texels of one slice over one step.
typedef struct swTransport
{
    const float *flow, *slopes; // of the slice, as SW_LAYER_FLOW and SW_LAYER_FLOW_SLOPES; NULL: no input has a flow
    float currentX, currentZ;   // m/s, everywhere
    float texel;                // m
    float dt;                   // s
} swTransport;

static inline swTransport swMakeTransport(const swFrame* frame, const swStackFrame* stack, int slice, float dt)
{
    const float* flow = stack->layers[SW_LAYER_FLOW].texels;
    const float* slopes = stack->layers[SW_LAYER_FLOW_SLOPES].texels;
    size_t first = 4 * (size_t)slice * (size_t)stack->resolution * (size_t)stack->resolution;
    return (swTransport){
        .flow = flow != NULL ? flow + first : NULL,
        .slopes = flow != NULL ? slopes + first : NULL,
        .currentX = frame->foamLaw.currentX,
        .currentZ = frame->foamLaw.currentZ,
        .texel = (float)stack->slices[slice].texel,
        .dt = dt,
    };
}

// How far upstream what is at a texel was, in texels along x and z. The current comes with the flow, but not with its
// slopes, which it runs through as the flow does.
static inline void swFindTexelUpstream(const swTransport* transport, size_t at, float* awayX, float* awayZ)
{
    float x = transport->currentX, z = transport->currentZ;
    float changeX = 0.0f, changeZ = 0.0f;
    if (transport->flow != NULL)
    {
        const float* flow = transport->flow + 4 * at;
        const float* slopes = transport->slopes + 4 * at;
        x += flow[0];
        z += flow[1];
        changeX = x * slopes[0] + z * slopes[1];
        changeZ = x * slopes[2] + z * slopes[3];
    }
    float speed = sqrtf(x * x + z * z);
    *awayX = swFindUpstream(x, changeX, speed, transport->dt) / transport->texel;
    *awayZ = swFindUpstream(z, changeZ, speed, transport->dt) / transport->texel;
}

// A place along one axis of a source: the texel at or below it, and the way to the next.
typedef struct swTransportTap
{
    int texel;
    float along;
} swTransportTap;

static inline swTransportTap swFindTransportTap(const swPastSource* source, int base, int rest, int index, float away)
{
    float scale = source->shift < 0 ? 1.0f / (float)(1 << -source->shift) : (float)(1 << source->shift);
    float place = swLayerTapFraction(source->shift, rest, index) - away * scale;
    float whole = floorf(place);
    return (swTransportTap){swLayerTap(source->shift, base, rest, index) + (int)whole, place - whole};
}

static inline bool swIsTransportTapHeld(swTransportTap tap, int resolution)
{
    return tap.texel >= 0 && tap.texel < resolution - (tap.along > 0.0f ? 1 : 0);
}

// Beyond the slice's edge, its last texels go on.
static inline float swSumTransportTaps(const float* texels, int resolution, swTransportTap x, swTransportTap z)
{
    float sum = 0.0f;
    int columns[SW_TRANSPORT_TAPS];
    float weights[SW_TRANSPORT_TAPS];
    for (int i = 0; i < SW_TRANSPORT_TAPS; ++i)
    {
        int column = x.texel + i - 2;
        columns[i] = column < 0 ? 0 : column >= resolution ? resolution - 1 : column;
        weights[i] = swTransportWeight(i, x.along);
    }
    for (int k = 0; k < SW_TRANSPORT_TAPS; ++k)
    {
        int row = z.texel + k - 2;
        row = row < 0 ? 0 : row >= resolution ? resolution - 1 : row;
        const float* line = texels + (size_t)row * (size_t)resolution;
        float part = 0.0f;
        for (int i = 0; i < SW_TRANSPORT_TAPS; ++i)
        {
            part += weights[i] * line[columns[i]];
        }
        sum += swTransportWeight(k, z.along) * part;
    }
    return sum < 0.0f ? 0.0f : sum > 1.0f ? 1.0f : sum;
}

// A texel's value of the step before, (awayX, awayZ) texels upstream; false if no slice of the previous stack held it.
static inline bool swReadUpstream(const swPastSource* sources, const float* previous, int resolution, int column,
                                  int row, float awayX, float awayZ, float* value)
{
    size_t sliceSize = (size_t)resolution * (size_t)resolution;
    for (int i = 0; i < SW_PAST_SOURCES && sources[i].slice >= 0; ++i)
    {
        const swPastSource* source = &sources[i];
        swTransportTap x = swFindTransportTap(source, source->baseX, source->restX, column, awayX);
        swTransportTap z = swFindTransportTap(source, source->baseZ, source->restZ, row, awayZ);
        if (swIsTransportTapHeld(x, resolution) && swIsTransportTapHeld(z, resolution))
        {
            *value = swSumTransportTaps(previous + (size_t)source->slice * sliceSize, resolution, x, z);
            return true;
        }
    }
    return false;
}

// A texel's value of the step before, from where water has carried it. Where none flows, to the bit what lies there.
static inline bool swReadCarried(const swTransport* transport, const swPastSource* sources, const float* previous,
                                 int resolution, int column, int row, float* value)
{
    float awayX, awayZ;
    swFindTexelUpstream(transport, (size_t)row * (size_t)resolution + (size_t)column, &awayX, &awayZ);
    if (awayX == 0.0f && awayZ == 0.0f)
    {
        return swReadPast(sources, previous, 1, resolution, column, row, value);
    }
    return swReadUpstream(sources, previous, resolution, column, row, awayX, awayZ, value);
}
