// SPDX-License-Identifier: MIT
// The air between the camera and a point of the sea, over distance and the angle from the sun's azimuth: layer 0 the
// light that it adds, layer 1 what it lets through, layer 2 what haze adds, see Scattered. Where the table ends the sea
// has become the horizon's sky, so the two join without an edge.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/picture.h"
#include "lib/atmosphere.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Picture
{
    swPictureParams picture;
};
layout(binding = 1) uniform sampler2D transmittance;
layout(binding = 2) uniform sampler2D multiple;
layout(binding = 3, rgba16f) writeonly uniform image2DArray target;

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 x = vec2(texel) / float(SW_SKY_AIR_SIDE - 1);
    float height = max(picture.cameraHeight, 1.0) * 1e-3;
    float distance = height + x.y * x.y * airDistance(height);

    // From the camera to a point of the sea at that distance, beyond the horizon along its tangent.
    float radius = earthBottom + height;
    float muToSea =
        (earthBottom * earthBottom - radius * radius - distance * distance) / (2.0 * radius * max(distance, 1e-4));
    float mu = texel.y == 0 ? -1.0 : clamp(muToSea, -1.0, horizonCosine(radius));
    vec2 toSun = normalize(picture.sun.xz + vec2(1e-6, 0.0));
    float angle = x.x * pi;
    vec2 level = vec2(cos(angle) * toSun.x - sin(angle) * toSun.y, sin(angle) * toSun.x + cos(angle) * toSun.y);
    vec3 direction = vec3(level * sqrt(max(1.0 - mu * mu, 0.0)), mu).xzy;

    Scattered air = scatteredLight(transmittance, multiple, radius, direction, picture.sun, distance, picture.haze, 20);
    imageStore(target, ivec3(texel, 0), vec4(air.light * picture.sunLight, 1.0));
    imageStore(target, ivec3(texel, 1), vec4(air.passed, 1.0));
    imageStore(target, ivec3(texel, 2), vec4(air.haze * picture.sunLight, 1.0));
}
