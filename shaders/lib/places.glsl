// SPDX-License-Identifier: MIT
// What a place does to waves: the twin of core/surface/places.c with the places that inputs make.
//
// Before including: lib/inputs.glsl.
#ifndef SW_LIB_PLACES
#define SW_LIB_PLACES
#include "shared/carry.h"
#include "shared/depth_share.h"

// Where a texel of a slice rests.
SeaPlace placeOfTexel(swFieldSlice slice, uint column, uint row)
{
    return seaPlaceOf(ivec2(slice.cellX, slice.cellZ),
                      vec2(slice.restX, slice.restZ) + slice.texel * vec2(column, row));
}

// Depth of still water and its gradient, and its level above sea level.
struct Ground
{
    float depth;
    vec2 slope;
    float level;
};

const Ground NO_GROUND = Ground(SW_NO_DEPTH, vec2(0.0), 0.0);

// Of a level and a height of the floor, each with its slopes along x and z.
Ground groundBetween(vec3 level, vec3 bottom)
{
    bool isThere = bottom.x > 0.5 * SW_NO_FLOOR;
    return Ground(isThere ? level.x - bottom.x : SW_NO_DEPTH, isThere ? level.yz - bottom.yz : vec2(0.0), level.x);
}

// The first of a field's numbers and its slopes.
vec3 firstOf(swInputValue value)
{
    return vec3(value.value.x, value.alongX.x, value.alongZ.x);
}

// The second.
vec3 secondOf(swInputValue value)
{
    return vec3(value.value.y, value.alongX.y, value.alongZ.y);
}

// A weight of waves and its gradient.
struct Shape
{
    float weight;
    vec2 slope;
};

// Product rule: a system's weight times what the depth leaves of a wave.
Shape attenuated(Shape shape, Ground ground, float k, swAttenuation attenuation)
{
    swDepthShare found = swFindDepthShare(attenuation, k, ground.depth);
    return Shape(shape.weight * found.share, shape.slope * found.share + shape.weight * found.slope * ground.slope);
}

// How the water flows along x and z, and the slopes of that: of the first along x and z, then of the second.
struct Flow
{
    vec2 velocity;
    vec4 slopes;
};

const Flow STILL = Flow(vec2(0.0), vec4(0.0));

Flow flowOf(swInputValue value)
{
    return Flow(value.value.xy, vec4(value.alongX.x, value.alongZ.x, value.alongX.y, value.alongZ.y));
}

// What carries copies of waves, beside the flow that carries all of them.
Flow besideEven(Flow flow)
{
    flow.velocity =
        vec2(swGetCarriedSpeed(flow.velocity.x, inputHead.evenX), swGetCarriedSpeed(flow.velocity.y, inputHead.evenZ));
    return flow;
}

bool isMoved(Flow flow)
{
    return flow.velocity != vec2(0.0) || flow.slopes != vec4(0.0);
}

// Two copies of waves that a flow carries, see shared/carry.h: what each counts, and from how many seconds' way against
// the flow it is.
struct Carry
{
    vec2 weights, seconds;
};

// `turns` is how far the first copy is in its period, a fraction of 2^32.
Carry carryOf(uint turns, float period)
{
    vec2 phases = vec2(turns >> 8, (turns + 0x80000000u) >> 8) * (1.0 / 16777216.0);
    float weight = swGetCarryWeight(phases.x);
    return Carry(vec2(weight, 1.0 - weight), (phases - 0.5) * period);
}

// What both copies have in common, once they are divided by the root of their variance. `rho` is the correlation at the
// way between them, that of `between` seconds, and its slopes by the way.
Shape carried(Shape shape, Carry carry, float between, Flow flow, vec3 rho)
{
    swCarryFactor factor = swGetCarryFactor(carry.weights.x, rho.x);
    vec2 slope = factor.slope * between * (rho.y * flow.slopes.xy + rho.z * flow.slopes.zw);
    return Shape(shape.weight * factor.value, shape.slope * factor.value + shape.weight * slope);
}
#endif
