// SPDX-License-Identifier: MIT

// Where a texel of a layer with a past lay in the stack of the step before: shared/layers.h has the rule, and
// core/lod/scroll.h is the CPU's twin.

#include "shared/layers.h"

// The texel at or below the place in a source, the way to the next, and whether the source holds it.
struct PastTap
{
    ivec2 texel;
    vec2 along;
    bool isHeld;
};

PastTap findTap(swPastSource source, ivec2 at, int resolution)
{
    PastTap tap;
    tap.texel.x = swLayerTap(source.shift, source.baseX, source.restX, at.x);
    tap.texel.y = swLayerTap(source.shift, source.baseZ, source.restZ, at.y);
    tap.along.x = swLayerTapFraction(source.shift, source.restX, at.x);
    tap.along.y = swLayerTapFraction(source.shift, source.restZ, at.y);
    ivec2 last = ivec2(resolution - (tap.along.x > 0.0 ? 2 : 1), resolution - (tap.along.y > 0.0 ? 2 : 1));
    tap.isHeld = all(greaterThanEqual(tap.texel, ivec2(0))) && all(lessThanEqual(tap.texel, last));
    return tap;
}

// The texel beyond; the same one on an axis where the place is exact.
ivec2 nextTexel(PastTap tap)
{
    return tap.texel + ivec2(greaterThan(tap.along, vec2(0.0)));
}

// Linear between four texels, whose corner may be exact on either axis.
float blend(float a, float b, float c, float d, vec2 along)
{
    a += (b - a) * along.x;
    c += (d - c) * along.x;
    return a + (c - a) * along.y;
}
