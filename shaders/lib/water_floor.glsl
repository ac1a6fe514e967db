// SPDX-License-Identifier: MIT
// What stands in the water, seen through its surface: where a bent line of sight meets it in the host's images, and
// what the water in between takes and adds.
//
// A line of sight that goes into the water is bent by the slope of the surface. Where it ends is found on the screen:
// the bottom under the pixel gives a first guess of its depth, the bent line is followed to that depth, and the image
// is looked up where that place is seen. The light is that of [Lee 1998]: downwards it fades along the sun's path in
// the water, upwards along the line of sight, and what the column scatters back saturates alike.
#ifndef SW_LIB_WATER_FLOOR
#define SW_LIB_WATER_FLOOR
#include "lib/water_optics.glsl"

// How a camera's image is laid out: columns of clip space, and the ray through a place of it.
struct Lens
{
    vec4 clipX, clipY, clipZ, clipW; // columns: metres from the camera to clip space
    vec3 forward, rayX, rayY;        // a ray of depth 1 is forward + x rayX + y rayY
};

// What is seen through a pixel of the surface.
struct Sunken
{
    vec3 radiance; // of the host's image, as if there were no water
    float depth;   // below the surface's point, m
    float way;     // length of the line of sight in the water, m
    bool isThere;  // false: the water has no end there
};

vec2 screenOf(Lens lens, vec3 position)
{
    vec4 c = lens.clipX * position.x + lens.clipY * position.y + lens.clipZ * position.z + lens.clipW;
    return clamp(0.5 + 0.5 * c.xy / max(c.w, 1e-6), 0.0, 1.0);
}

// The place that the host's depth tells of at `uv`; false where nothing was drawn.
bool opaqueAt(Lens lens, sampler2D depthImage, vec2 uv, out vec3 position)
{
    float depth = textureLod(depthImage, uv, 0.0).r;
    vec2 clip = 2.0 * uv - 1.0;
    vec3 ray = lens.forward + clip.x * lens.rayX + clip.y * lens.rayY;
    // Along the ray clip z is (z columns . ray) t + clipW.z, and clip w is t.
    float perDistance = depth - dot(vec3(lens.clipX.z, lens.clipY.z, lens.clipZ.z), ray);
    float t = lens.clipW.z / max(perDistance, 1e-12);
    position = ray * t;
    return depth > 0.0;
}

// How deep the bottom is where the image shows a place of the bent line, m; without end where it shows none, or what
// stands in front of the surface, such as the dry side of a dam. Beyond the image's edge the bottom goes on as it is
// there.
float depthShown(Lens lens, sampler2D depthImage, vec2 uv, vec3 surface, vec3 view)
{
    vec3 found;
    bool isThere = opaqueAt(lens, depthImage, uv, found);
    bool isInFront = dot(found - surface, view) > 0.0;
    return isThere && !isInFront ? max(surface.y - found.y, 0.0) : 1e9;
}

// Where the bent line is hidden on the screen: what stands right behind the surface, but the line gets there by a
// shorter way. Where `known`, the depth that is known otherwise, is much less, that is another place, and the ground in
// front has the colour of what is hidden by it.
Sunken seenStraight(Lens lens, sampler2D colorImage, sampler2D depthImage, vec3 surface, vec3 bent, float known)
{
    vec2 uv = screenOf(lens, surface);
    vec3 found;
    bool isThere = opaqueAt(lens, depthImage, uv, found);
    float depth = max(surface.y - found.y, 0.0);
    vec3 radiance = textureLod(colorImage, uv, 0.0).rgb;
    if (known < 1e9 && (!isThere || known < depth))
    {
        float isSame = isThere ? smoothstep(0.5, 0.85, max(known, 0.0) / max(depth, 1e-3)) : 0.0;
        depth = max(known, 0.0);
        vec3 front = textureLod(colorImage, screenOf(lens, surface + bent * depth), 0.0).rgb;
        radiance = mix(front, radiance, isSame);
        isThere = true;
    }
    return Sunken(radiance, depth, depth * length(bent), isThere);
}

const float shallowestStep = 0.25; // m; twice as deep with each
const int depthSteps = 9;          // the last at 64 m, where a sixtieth of clear water's bluest light comes back
const int depthCuts = 4;

// `surface` is the place of the water's surface, `view` the unit vector from it to the camera, `normal` the surface's;
// `known` is the depth of the water there as far as it is known otherwise, see seenStraight().
Sunken seenThrough(Lens lens, sampler2D colorImage, sampler2D depthImage, vec3 surface, vec3 view, vec3 normal,
                   float index, float known)
{
    vec3 bent = refract(-view, normal, 1.0 / index);
    bent /= max(-bent.y, 0.05); // by one metre of depth
    float above = 0.0, below = shallowestStep;
    Sunken sunken = Sunken(vec3(0.0), 0.0, 0.0, false);
    for (int i = 0; i < depthSteps && !sunken.isThere; ++i)
    {
        vec2 uv = screenOf(lens, surface + bent * below);
        sunken.isThere = depthShown(lens, depthImage, uv, surface, view) < below;
        above = sunken.isThere ? above : below;
        below = sunken.isThere ? below : 2.0 * below;
    }
    if (!sunken.isThere)
    {
        return seenStraight(lens, colorImage, depthImage, surface, bent, known);
    }
    for (int i = 0; i < depthCuts; ++i)
    {
        float middle = 0.5 * (above + below);
        vec2 uv = screenOf(lens, surface + bent * middle);
        float shown = depthShown(lens, depthImage, uv, surface, view);
        above = shown < middle ? max(above, min(shown, middle)) : middle;
        below = shown < middle ? middle : below;
    }
    vec2 uv = screenOf(lens, surface + bent * below);
    sunken.depth = clamp(depthShown(lens, depthImage, uv, surface, view), above, below);
    sunken.way = sunken.depth * length(bent);
    sunken.radiance = textureLod(colorImage, uv, 0.0).rgb;
    return sunken;
}

// How much of the light from the bottom arrives, and how much of deep water's light the column already has.
struct Column
{
    vec3 bottom;
    vec3 water;
};

// `depth` is that of the bottom below the surface, `way` the length of the line of sight in the water, m.
Column columnOf(Water water, float depth, float way, float sunHeight)
{
    vec3 back = 0.0183 * water.scattering + vec3(0.0006, 0.0009, 0.0019);
    vec3 lost = water.absorption + back;
    vec3 share = back / lost;
    float sine = (1.0 - sunHeight * sunHeight) / (water.index * water.index);
    float down = depth * inversesqrt(1.0 - sine);
    Column column;
    column.bottom = exp(-lost * (down + way * 1.04 * sqrt(1.0 + 5.4 * share)));
    column.water = 1.0 - exp(-lost * (down + way * 1.03 * sqrt(1.0 + 2.4 * share)));
    return column;
}
#endif
