// SPDX-License-Identifier: MIT
// The sky behind everything: air, clouds, and the sun's disc, darker towards its limb [Hestroffer and Magnan 1998].
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/picture.h"
#include "lib/atmosphere.glsl"
#include "lib/noise.glsl"
#include "lib/clouds.glsl"

layout(std430, binding = 0) readonly buffer Picture
{
    swPictureParams picture;
};
layout(std430, binding = 1) readonly buffer Light
{
    swSkyLight light;
};
layout(binding = 2) uniform sampler2DArray skyView;
layout(binding = 3) uniform sampler2D transmittance;

layout(location = 0) in vec2 clip;
layout(location = 0) out vec4 color;

// `sky` is what is seen beside it. The disc is so much brighter that a pixel with a hundredth of it would be as white
// as the rest: a pixel at its edge gets a few times the sky's brightness instead, or the disc would be drawn in steps.
vec3 sunDisc(vec3 direction, float radius, vec3 sky)
{
    const vec3 limbPower = vec3(0.397, 0.503, 0.652);
    const float sunAngle = 0.004654;
    float angle = acos(clamp(dot(direction, picture.sun), -1.0, 1.0));
    // At least a pixel wide at its edge, so that it does not shimmer.
    float edge = clamp((sunAngle - angle) / max(picture.pixel, 1e-5) + 0.5, 0.0, 1.0);
    if (edge <= 0.0)
    {
        return vec3(0.0);
    }
    float x = min(angle / sunAngle, 1.0);
    vec3 limb = pow(vec3(max(1.0 - x * x, 1e-3)), 0.5 * limbPower);
    vec3 mean = 2.0 / (limbPower + 2.0);
    vec3 through = textureLod(transmittance, transmittanceUv(radius, direction.y), 0.0).rgb;
    vec3 radiance = picture.sunLight / (pi * sunAngle * sunAngle) * limb / mean * through;
    vec3 rim = 2.0 * sky * (edge / max(1.0 - edge, 1e-6));
    return min(min(edge * radiance, rim), vec3(60000.0));
}

void main()
{
    vec3 direction = normalize(picture.forward + clip.x * picture.rayX + clip.y * picture.rayY);
    float radius = earthBottom + max(picture.cameraHeight, 1.0) * 1e-3;
    float horizon = asin(horizonCosine(radius));
    vec2 uv = skyViewUv(direction, horizon);
    vec3 sky = withHaze(textureLod(skyView, vec3(uv, 0.0), 0.0).rgb, textureLod(skyView, vec3(uv, 2.0), 0.0).rgb,
                        direction, picture.sun);
    CloudOrigin clouds = CloudOrigin(vec2(picture.cloudX, picture.cloudZ), vec2(picture.cloudWayX, picture.cloudWayZ));
    vec4 cover = cloudsAlong(direction, radius, clouds, picture.sun, light, picture.clouds, picture.pixel);
    float above = smoothstep(horizon - 0.5 * picture.pixel, horizon + 0.5 * picture.pixel, asin(direction.y));
    sky += above * sunDisc(direction, radius, sky);
    color = vec4(sky * (1.0 - cover.a) + cover.rgb, 1.0);
}
