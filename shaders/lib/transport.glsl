// SPDX-License-Identifier: MIT

// Layers with a past of one number that goes with the water: shared/transport.h has the formulas, and
// core/lod/transport.h is the CPU's twin.
//
// Before including: lib/past.glsl, `int resolution`, and the functions
//   swPastSource pastSource(int slice, int i)  where a slice's texels were, the i-th place to try
//   float pastAt(int slice, int x, int z)      the layer before the step
#include "shared/transport.h"

// Where a texel lies in a source that water carried it from; `away` is the way upstream in the slice's own texels.
PastTap findUpstreamTap(swPastSource source, ivec2 at, vec2 away)
{
    float scale = source.shift < 0 ? 1.0 / float(1 << -source.shift) : float(1 << source.shift);
    vec2 place = vec2(swLayerTapFraction(source.shift, source.restX, at.x),
                      swLayerTapFraction(source.shift, source.restZ, at.y)) -
                 away * scale;
    vec2 whole = floor(place);
    PastTap tap;
    tap.texel = ivec2(swLayerTap(source.shift, source.baseX, source.restX, at.x),
                      swLayerTap(source.shift, source.baseZ, source.restZ, at.y)) +
                ivec2(whole);
    tap.along = place - whole;
    ivec2 last = ivec2(resolution - (tap.along.x > 0.0 ? 2 : 1), resolution - (tap.along.y > 0.0 ? 2 : 1));
    tap.isHeld = all(greaterThanEqual(tap.texel, ivec2(0))) && all(lessThanEqual(tap.texel, last));
    return tap;
}

// Beyond the slice's edge, its last texels go on.
float sumUpstreamTaps(int slice, PastTap tap)
{
    float sum = 0.0;
    for (int k = 0; k < SW_TRANSPORT_TAPS; ++k)
    {
        int row = clamp(tap.texel.y + k - 2, 0, resolution - 1);
        float part = 0.0;
        for (int i = 0; i < SW_TRANSPORT_TAPS; ++i)
        {
            int column = clamp(tap.texel.x + i - 2, 0, resolution - 1);
            part += swTransportWeight(i, tap.along.x) * pastAt(slice, column, row);
        }
        sum += swTransportWeight(k, tap.along.y) * part;
    }
    return clamp(sum, 0.0, 1.0);
}

// How far upstream what is at a texel was a step before, in texels. `slopes` as SW_LAYER_FLOW_SLOPES.
vec2 findUpstream(vec2 velocity, vec4 slopes, float dt, float texel)
{
    vec2 change = vec2(dot(velocity, slopes.xy), dot(velocity, slopes.zw));
    float speed = sqrt(velocity.x * velocity.x + velocity.y * velocity.y);
    return vec2(swFindUpstream(velocity.x, change.x, speed, dt), swFindUpstream(velocity.y, change.y, speed, dt)) /
           texel;
}

// The layer before the step at a texel, or `away` of it upstream; false if no slice of the previous stack held it.
bool readPast(ivec3 at, vec2 away, out float value)
{
    bool isCarried = any(notEqual(away, vec2(0.0)));
    value = 0.0;
    for (int i = 0; i < SW_PAST_SOURCES; ++i)
    {
        swPastSource source = pastSource(at.z, i);
        if (source.slice < 0)
        {
            return false;
        }
        PastTap tap = findTap(source, at.xy, resolution);
        if (isCarried)
        {
            tap = findUpstreamTap(source, at.xy, away);
        }
        if (tap.isHeld && isCarried)
        {
            value = sumUpstreamTaps(source.slice, tap);
            return true;
        }
        if (tap.isHeld)
        {
            ivec2 next = nextTexel(tap);
            value = blend(pastAt(source.slice, tap.texel.x, tap.texel.y), pastAt(source.slice, next.x, tap.texel.y),
                          pastAt(source.slice, tap.texel.x, next.y), pastAt(source.slice, next.x, next.y), tap.along);
            return true;
        }
    }
    return false;
}
