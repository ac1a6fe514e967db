// SPDX-License-Identifier: MIT
// The sky that the sea mirrors: an average over the facets that a viewer sees, slopes along the line of sight, weighted
// by how large each facet appears. That is what lifts the mean reflection above the horizon on a rough sea
// [Bruneton 2010]. Across the line of sight the sky's blurred copies do: `skyMap` is laid out as skyViewUv() says, mip
// n blurred by 2^n / 32 of slope. `leaving` is the radiance that comes out of the water, `index` that of refraction.
#ifndef SW_LIB_WATER_REFLECTION
#define SW_LIB_WATER_REFLECTION
#include "lib/atmosphere.glsl"
#include "lib/surface_sample.glsl"
#include "lib/water_brdf.glsl"

// Radiance that reaches the water along `direction`; near and below the horizon other waves stand in the way, which
// themselves mirror the sky at a grazing angle over the water's own colour.
vec3 surroundings(sampler2D skyMap, vec3 direction, float blur, vec3 leaving, float index)
{
    vec3 up = vec3(direction.x, abs(direction.y), direction.z);
    vec3 sky = textureLod(skyMap, skyViewUv(up, 0.0), blur).rgb;
    float open = smoothstep(-0.10, 0.06, direction.y);
    float mirror = swFresnel(up.y + 0.12, index);
    return mix(mix(leaving, sky, mirror), sky, open);
}

// Sky reflected by facets whose slopes differ from the mean in one direction, weighted by how large each appears; xyz
// is radiance times reflectance, w the mean Fresnel reflectance. The sky's blurred copies stand for the other
// direction.
vec4 skyOfFacets(sampler2D skyMap, vec3 view, Slopes slopes, vec2 direction, vec3 leaving, float index)
{
    vec2 across = vec2(-direction.y, direction.x);
    float level = dot(view.xz, direction);
    float deviation = sqrt(dot(direction * direction, slopes.variance));
    float blur = log2(max(2.0 * sqrt(dot(across * across, slopes.variance)), 1e-3) * 32.0);

    const int facets = 5;
    float highest = clamp((view.y - dot(view.xz, slopes.mean)) / max(level * deviation, 1e-4), -6.0, 2.4);
    float lowest = min(-2.4, highest - 2.4);
    vec4 sum = vec4(0.0);
    float total = 1e-9;
    for (int i = 0; i < facets; ++i)
    {
        float x = mix(lowest, highest, (float(i) + 0.5) / float(facets));
        vec3 normal = facetNormal(slopes.mean + direction * (x * deviation));
        float cosine = dot(view, normal);
        float weight = exp(-0.5 * x * x) * max(cosine, 1e-4) / normal.y;
        float f = swFresnel(cosine, index);
        sum += weight * f * vec4(surroundings(skyMap, reflect(-view, normal), max(blur, 0.0), leaving, index), 1.0);
        total += weight;
    }
    return sum / total;
}

// Reflected sky; returns the mean Fresnel reflectance in `reflectance`. Seen from above no direction is along the line
// of sight: there facets of both directions count, or the sky's brighter side would show as a wedge under the viewer.
vec3 reflectedSky(sampler2D skyMap, vec3 view, Slopes slopes, vec3 leaving, float index, out float reflectance)
{
    vec2 along = view.xz * inversesqrt(max(dot(view.xz, view.xz), 1e-8));
    along = dot(along, along) > 0.5 ? along : vec2(1.0, 0.0);
    vec4 sky = skyOfFacets(skyMap, view, slopes, along, leaving, index);
    float both = 0.5 - 0.5 * smoothstep(0.1, 0.7, length(view.xz));
    if (both > 0.0)
    {
        sky = mix(sky, skyOfFacets(skyMap, view, slopes, vec2(-along.y, along.x), leaving, index), both);
    }
    reflectance = sky.w;
    return sky.rgb;
}
#endif
