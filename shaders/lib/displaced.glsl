// SPDX-License-Identifier: MIT
// Heights that inputs displace where particles are: the twin of core/surface/displace.c. What inputs say is asked for
// by lib/ask.glsl.
#ifndef SW_LIB_DISPLACED
#define SW_LIB_DISPLACED
#include "shared/channels.h"

// Derivatives by the place of a height whose derivatives along rest are given: `x` and `z` are those of sideways
// displacement along x and z. Where the surface folds they have none.
swInputChannel heightByPlace(float height, vec2 along, vec2 x, vec2 z)
{
    float jacobian = (1.0 + x.x) * (1.0 + z.y) - z.x * x.y;
    float inverse = abs(jacobian) > 1e-3 ? 1.0 / jacobian : 0.0;
    return swMakeChannel(height, ((1.0 + z.y) * along.x - x.y * along.y) * inverse,
                         ((1.0 + x.x) * along.y - z.x * along.x) * inverse);
}

// What a change of those derivatives adds to the ones along rest.
vec2 slopeByRest(swInputChannel before, swInputChannel after, vec2 x, vec2 z)
{
    vec2 along = vec2(after.alongX - before.alongX, after.alongZ - before.alongZ);
    return vec2(along.x * (1.0 + x.x) + along.y * x.y, along.x * z.x + along.y * (1.0 + z.y));
}
#endif
