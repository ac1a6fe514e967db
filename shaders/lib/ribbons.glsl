// SPDX-License-Identifier: MIT
// Waves of systems of which some run along splines: the twin of swFindWaveLooks() in core/input and of what
// core/surface/evaluate_shaped.c makes of its answers.
//
// Before including: lib/inputs.glsl and lib/places.glsl.
#ifndef SW_LIB_RIBBONS
#define SW_LIB_RIBBONS
#include "shared/ribbon_looks.h"

// Bits of the systems of which some waves run along splines near a place.
uint ribbonSystemsAt(SeaPlace place)
{
    return touchesInputs(SW_FIELD_OF_WAVES, place.cell, place.cell) ? inputHead.ribbonSystems : 0u;
}

// Where waves along a spline are looked up in the sea, how much of them counts, and how they are turned.
struct Look
{
    Shape shape;
    SeaPlace at;
    swRibbonSource source;
};

Look lookOf(swRibbonLook ribbon)
{
    swRibbonSource source = ribbon.source;
    SeaPlace at = SeaPlace(ivec2(source.cellX, source.cellZ), vec2(source.restX, source.restZ));
    return Look(Shape(ribbon.weight.value, vec2(ribbon.weight.alongX, ribbon.weight.alongZ)), at, source);
}

// Whether it adds anything.
bool isLookThere(Look look)
{
    return look.shape.weight != 0.0 || look.shape.slope != vec2(0.0);
}

// A vector from a look's axes to the sea's.
vec3 turnByLook(Look look, vec3 v)
{
    float c = look.source.cosine, s = look.source.sine;
    return vec3(c * v.x - s * v.z, v.y, s * v.x + c * v.z);
}

// A flow from the sea's axes to a look's. Its slopes stay those along the sea's axes.
Flow turnFlowByLook(Look look, Flow flow)
{
    float c = look.source.cosine, s = look.source.sine;
    vec2 velocity = vec2(c * flow.velocity.x + s * flow.velocity.y, c * flow.velocity.y - s * flow.velocity.x);
    vec2 turns = vec2(look.source.turnX, look.source.turnZ); // of the axes, from place to place
    vec2 x = c * flow.slopes.xy + s * flow.slopes.zw + turns * velocity.y;
    vec2 z = c * flow.slopes.zw - s * flow.slopes.xy - turns * velocity.x;
    return Flow(velocity, vec4(x, z));
}

// Displacement with its derivatives from a look's coordinates to the sea's. `way` has the slopes of where it is looked
// up less where that is: of x along x and z, then of z. `skew` is dDx/dz less dDz/dx.
void turnWaterByLook(Look look, vec4 way, inout vec3 value, inout vec3 alongX, inout vec2 alongZ, inout float skew)
{
    vec3 ownZ = vec3(alongX.z + skew, alongZ);
    vec3 x = turnByLook(look, alongX * (1.0 + way.x) + ownZ * way.z);
    vec3 z = turnByLook(look, alongX * way.y + ownZ * (1.0 + way.w));
    value = turnByLook(look, value);
    // The axes turn from place to place.
    x.xz += look.source.turnX * vec2(-value.z, value.x);
    z.xz += look.source.turnZ * vec2(-value.z, value.x);
    alongX = x;
    alongZ = z.yz;
    skew = z.x - x.z;
}
#endif
