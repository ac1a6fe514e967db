// SPDX-License-Identifier: MIT
// Light that goes into the water and comes back out of it. Illuminance and radiance are in linear sRGB primaries, of
// any one unit.
#ifndef SW_LIB_WATER_OPTICS
#define SW_LIB_WATER_OPTICS
#include "shared/fresnel.h"

struct Water
{
    vec3 absorption; // 1/m
    vec3 scattering; // 1/m
    float index;     // of refraction
    float deviation; // of the sea's height, m
};

// Illuminance below a level surface, of sun and sky. It mirrors 0.066 of the light of an even sky.
vec3 enteringWater(Water water, vec3 sun, vec3 sunlight, vec3 skylight)
{
    float sunOnWater = max(sun.y, 0.0) * (1.0 - swFresnel(sun.y, water.index));
    return sunlight * sunOnWater + skylight * 0.934;
}

// Light scattered back by deep water, leaving it per unit of its own solid angle: R = 0.33 bb / a under the surface
// [Morel and Prieur 1977], 0.54 for both passages through it [Mobley 1994]. A fiftieth of what particles scatter goes
// backward [Petzold 1972]; bubbles scatter back white.
vec3 leavingWater(Water water, vec3 illuminance, float bubbles)
{
    vec3 back = 0.0183 * water.scattering + vec3(0.0006, 0.0009, 0.0019) + vec3(0.08 * bubbles);
    vec3 reflectance = 0.33 * back / (water.absorption + back);
    return illuminance * reflectance * (0.54 / 3.14159265);
}

// Sunlight that comes through a crest: once scattered, strongly forward, on a path as long as the crest is thick.
vec3 throughCrest(Water water, vec3 view, vec3 normal, float height, vec3 sun, vec3 sunlight, float illuminated)
{
    float deviation = max(water.deviation, 0.01);
    float crest = height / deviation;
    float thickness = 2.5 * deviation * exp2(-max(crest, 0.0));
    vec3 inward = refract(-view, normal, 1.0 / water.index);
    // The crest's far side leans towards the sun.
    vec3 back = normalize(vec3(0.4 * sun.x, 1.0, 0.4 * sun.z));
    vec3 travel = refract(-sun, back, 1.0 / water.index);
    float cosine = dot(travel, -inward);
    float phase = 0.0151 / pow(max(1.81 - 1.8 * cosine, 1e-3), 1.5) + 0.006;
    vec3 lost = water.absorption + 0.1 * water.scattering;
    float entering = max(dot(back, sun), 0.0) * (1.0 - swFresnel(dot(back, sun), water.index));
    return sunlight * water.scattering * phase * thickness * exp(-2.0 * lost * thickness) *
           (entering * illuminated * smoothstep(-0.2, 1.6, crest) / (water.index * water.index));
}
#endif
