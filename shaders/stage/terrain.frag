// SPDX-License-Identifier: MIT
// The colour of the land: wet and dry sand, grass and rock by height and slope, in the picture's light and air.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/picture.h"
#include "shared/terrain.h"
#include "lib/atmosphere.glsl"
#include "lib/noise.glsl"

layout(std430, binding = 0) readonly buffer Picture
{
    swPictureParams picture;
};
layout(std430, binding = 1) readonly buffer Light
{
    swSkyLight light;
};
layout(binding = 2) uniform sampler2DArray air;
layout(push_constant) uniform Push
{
    swTerrainPush push;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 slopes;
layout(location = 2) in float known;

layout(location = 0) out vec4 color;

const vec3 sand = vec3(0.60, 0.52, 0.39);
const vec3 grass = vec3(0.068, 0.105, 0.034);
const vec3 scrub = vec3(0.15, 0.135, 0.065);
const vec3 rock = vec3(0.25, 0.23, 0.205);

// Noise by place, of octaves from `wavelength` down to what a pixel shows, and its slopes.
vec3 noiseAt(vec2 place, float wavelength, float pixel)
{
    vec3 noise = fractalNoiseSlopes(place / wavelength, 6, 1.5 * pixel / wavelength);
    return vec3(noise.x, noise.yz / wavelength);
}

// What wet ground sends back: light is caught in the film of water, so that it is seen darker [Lekner 1988].
vec3 wetted(vec3 albedo)
{
    return albedo * 0.55 / (1.0 - 0.45 * albedo);
}

// Noise of the ground at a place: patches of some ten metres, and what is between them, with their slopes.
struct Relief
{
    float patches, tufts, grain;
    vec2 tuftSlopes, grainSlopes;
};

Relief reliefAt(vec2 place, float pixel)
{
    vec3 tufts = noiseAt(place.yx + 7.0, 9.0, pixel), grain = noiseAt(place + 3.0, 1.1, pixel);
    return Relief(noiseAt(place, 45.0, pixel).x, tufts.x, grain.x, tufts.zy, grain.yz);
}

// How much grows at a height above where waves reach, on a slope.
float growthAt(Relief relief, float height, float steepness)
{
    float begins = height - 2.2 + 3.0 * relief.patches + 2.2 * relief.tufts;
    return smoothstep(-0.4, 0.6, begins) * (1.0 - smoothstep(0.55, 0.8, steepness));
}

vec3 groundAlbedo(Relief relief, float height, float steepness)
{
    float wet = 1.0 - smoothstep(0.55, 1.0, height + 0.4 * relief.patches + 0.15 * relief.tufts);
    vec3 bare = sand * (1.0 + 0.12 * relief.patches + 0.10 * relief.tufts + 0.14 * relief.grain);
    bare = mix(bare, wetted(bare), wet);
    float dry = smoothstep(-0.25, 0.35, relief.patches + 0.8 * relief.tufts);
    vec3 green = mix(grass, scrub, dry) * (1.0 + 0.9 * relief.tufts + 0.5 * relief.grain);
    vec3 stone = rock * (1.0 + 0.5 * relief.patches + 0.9 * relief.tufts + 0.5 * relief.grain);
    stone = mix(stone, wetted(stone), wet);
    float bed = smoothstep(0.5, 0.75, steepness + 0.25 * relief.patches + 0.25 * relief.tufts);
    return clamp(mix(mix(bare, green, growthAt(relief, height, steepness)), stone, bed), 0.0, 1.0);
}

// Slopes of the ground's own relief, which is finer than what is drawn: tufts, stones, ripples of sand.
// Sand that waves reach is even.
vec2 reliefSlopes(Relief relief, float growth, float height, float steepness)
{
    float stone = smoothstep(0.4, 0.75, steepness);
    vec2 bare = (0.05 * relief.tuftSlopes + 0.03 * relief.grainSlopes) * smoothstep(1.0, 2.0, height);
    vec2 green = 0.55 * relief.tuftSlopes + 0.16 * relief.grainSlopes;
    return mix(mix(bare, green, growth), 1.3 * relief.tuftSlopes + 0.30 * relief.grainSlopes, stone);
}

void main()
{
    if (known < 0.999) // interpolation rounds
    {
        discard; // no floor is known here
    }
    float range = length(position);
    float pixel = range * picture.pixel;
    vec3 view = -position / range;
    vec2 place = position.xz + vec2(push.placeX, push.placeZ);
    float height = position.y - picture.seaY;
    float footprint = pixel / max(dot(view, normalize(vec3(-slopes.x, 1.0, -slopes.y))), 0.25);
    Relief relief = reliefAt(place, footprint);
    float steepness = length(slopes);
    float rise = height / push.wetHeight;
    vec3 albedo = groundAlbedo(relief, rise, steepness);
    float growth = growthAt(relief, rise, steepness);
    vec2 fine = slopes + reliefSlopes(relief, growth, rise, steepness);
    vec3 normal = normalize(vec3(-fine.x, 1.0, -fine.y));
    // Between tufts there is less light.
    float open = (0.5 + 0.5 * normal.y) * mix(1.0, clamp(0.8 + 0.9 * relief.tufts, 0.4, 1.0), growth);
    vec3 level = light.sun.rgb * max(picture.sun.y, 0.0) + light.sky.rgb;
    vec3 illuminance = light.sun.rgb * max(dot(normal, picture.sun), 0.0) * smoothstep(-0.02, 0.05, picture.sun.y) +
                       light.sky.rgb * open + 0.25 * level * (1.0 - open);
    vec3 radiance = albedo * illuminance / 3.14159265;
    radiance = behindAir(air, radiance, -view, picture.sun, range * 1e-3, picture.cameraHeight * 1e-3);
    color = vec4(min(radiance, vec3(60000.0)), 1.0);
}
