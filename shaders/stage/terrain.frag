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
const vec3 grass = vec3(0.105, 0.145, 0.045);
const vec3 scrub = vec3(0.20, 0.19, 0.085);
const vec3 rock = vec3(0.25, 0.23, 0.205);

// Noise by place, of octaves from `wavelength` down to what a pixel shows.
float noiseAt(vec2 place, float wavelength, float pixel)
{
    return fractalNoise(place / wavelength, 8, 2.0 * pixel / wavelength);
}

// What wet ground sends back: light is caught in the film of water, so that it is seen darker [Lekner 1988].
vec3 wetted(vec3 albedo)
{
    return albedo * 0.55 / (1.0 - 0.45 * albedo);
}

vec3 groundAlbedo(vec2 place, float height, float steepness, float pixel)
{
    float patches = noiseAt(place, 40.0, pixel);
    float grain = noiseAt(place.yx + 7.0, 5.0, pixel);
    vec3 bare = sand * (1.0 + 0.25 * grain + 0.12 * patches);
    float wet = 1.0 - smoothstep(0.6, 1.0, height / push.wetHeight + 0.5 * patches + 0.2 * grain);
    bare = mix(bare, wetted(bare), wet);
    vec3 green = mix(grass, scrub, smoothstep(-0.2, 0.4, patches + 0.6 * grain)) * (1.0 + 0.8 * grain);
    float grown = smoothstep(1.6, 2.8, height / push.wetHeight + 2.2 * patches + 1.2 * grain);
    vec3 stone = rock * (1.0 + 0.9 * grain + 0.5 * patches);
    stone = mix(stone, wetted(stone), wet);
    float bed = smoothstep(0.5, 0.75, steepness + 0.3 * patches + 0.25 * grain);
    return clamp(mix(mix(bare, green, grown), stone, bed), 0.0, 1.0);
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
    float footprint = pixel / max(view.y, 0.15);
    vec3 albedo = groundAlbedo(place, height, length(slopes), footprint);
    vec3 normal = normalize(vec3(-slopes.x, 1.0, -slopes.y));
    float open = 0.5 + 0.5 * normal.y;
    vec3 level = light.sun.rgb * max(picture.sun.y, 0.0) + light.sky.rgb;
    vec3 illuminance = light.sun.rgb * max(dot(normal, picture.sun), 0.0) * smoothstep(-0.02, 0.05, picture.sun.y) +
                       light.sky.rgb * open + 0.25 * level * (1.0 - open);
    vec3 radiance = albedo * illuminance / 3.14159265;
    radiance = behindAir(air, radiance, -view, picture.sun, range * 1e-3, picture.cameraHeight * 1e-3);
    color = vec4(min(radiance, vec3(60000.0)), 1.0);
}
