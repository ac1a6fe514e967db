// SPDX-License-Identifier: MIT
// Illuminance at sea level: the sun's through the air, and the sky's on a level surface, one workgroup over the sky
// table.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/picture.h"
#include "lib/atmosphere.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Picture
{
    swPictureParams picture;
};
layout(binding = 1) uniform sampler2D transmittance;
layout(binding = 2) uniform sampler2DArray skyView;
layout(std430, binding = 3) writeonly buffer Light
{
    swSkyLight light;
};

shared vec3 sums[64];

void main()
{
    uint worker = gl_LocalInvocationIndex;
    vec3 sum = vec3(0.0);
    const int rings = 32;
    for (int ring = 0; ring < rings; ++ring)
    {
        // Rings of equal projected solid angle: each sample stands for pi / (rings * 64).
        float s = (float(ring) + 0.5) / float(rings);
        float level = sqrt(s);
        float angle = 2.0 * pi * (float(worker) + 0.5) / 64.0;
        vec3 direction = vec3(cos(angle) * level, sqrt(1.0 - s), sin(angle) * level);
        vec2 uv = skyViewUv(direction, 0.0);
        sum += withHaze(textureLod(skyView, vec3(uv, 1.0), 0.0).rgb, textureLod(skyView, vec3(uv, 3.0), 0.0).rgb,
                        direction, picture.sun);
    }
    sums[worker] = sum;
    barrier();
    for (uint reach = 32; reach > 0; reach /= 2)
    {
        if (worker < reach)
        {
            sums[worker] += sums[worker + reach];
        }
        barrier();
    }
    if (worker == 0)
    {
        float sunY = picture.sun.y;
        vec3 atSea = sunTransmittance(transmittance, earthBottom + 1e-3, sunY);
        vec3 atClouds = sunTransmittance(transmittance, earthBottom + 8.0, sunY);
        light.sun = vec4(atSea * picture.sunLight, 1.0);
        light.high = vec4(atClouds * picture.sunLight, 1.0);
        light.sky = vec4(sums[0] * (pi / float(rings * 64)), 1.0);
    }
}
