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

swInputValue nothingBelow(vec4 value)
{
    return swInputValue(value, vec4(0.0), vec4(0.0));
}

// Level of still water above sea level, and its slopes.
vec3 levelAt(SeaPlace place)
{
    swInputValue level = joinInputs(SW_FIELD_OF_LEVEL, 0, place, nothingBelow(vec4(0.0)));
    return vec3(level.value.x, level.alongX.x, level.alongZ.x);
}

Ground groundAt(SeaPlace place)
{
    vec3 level = levelAt(place);
    swInputValue ground = joinInputs(SW_FIELD_OF_FLOOR, 0, place, nothingBelow(vec4(SW_NO_FLOOR, 0.0, 0.0, 0.0)));
    return Ground(level.x - ground.value.x, level.yz - vec2(ground.alongX.x, ground.alongZ.x), level.x);
}

// A weight of waves and its gradient.
struct Shape
{
    float weight;
    vec2 slope;
};

bool isLocalSystem(uint system)
{
    return system < 32u && (inputHead.localSystems >> system & 1u) != 0;
}

Shape systemWeightAt(uint system, SeaPlace place)
{
    float below = isLocalSystem(system) ? 0.0 : 1.0;
    swInputValue weight = joinInputs(SW_FIELD_OF_WAVES, system, place, nothingBelow(vec4(below, 0.0, 0.0, 0.0)));
    return Shape(weight.value.x, vec2(weight.alongX.x, weight.alongZ.x));
}

// Product rule: a system's weight times what the depth leaves of a wave.
Shape attenuated(Shape shape, Ground ground, float k, swAttenuation attenuation)
{
    swDepthShare found = swFindDepthShare(attenuation, k, ground.depth);
    return Shape(shape.weight * found.share,
                 shape.slope * found.share + shape.weight * found.slope * ground.slope);
}
#endif
