// SPDX-License-Identifier: MIT
// What a place does to waves: the twin of core/surface/places.c with the places that inputs make.
//
// Before including: lib/inputs.glsl.
#ifndef SW_LIB_PLACES
#define SW_LIB_PLACES
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
#endif
