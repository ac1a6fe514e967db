// SPDX-License-Identifier: MIT
// Automatic exposure: the mean of log luminance over a grid of samples, the middle of the picture counting more, and an
// eye that follows it. One workgroup.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/picture.h"

layout(local_size_x = 256) in;
layout(binding = 0) uniform sampler2D hdr;
layout(std430, binding = 1) buffer Exposure
{
    swExposure exposure;
};
layout(push_constant) uniform Push
{
    float keep; // of the old exposure, exp(-dt / time)
};

shared vec2 sums[256];

void main()
{
    uint worker = gl_LocalInvocationIndex;
    vec2 sum = vec2(0.0);
    for (uint i = 0; i < 16; ++i)
    {
        uvec2 cell = uvec2(worker % 64, (worker / 64) * 16 + i);
        vec2 uv = (vec2(cell) + 0.5) / 64.0;
        vec3 c = textureLod(hdr, uv, 0.0).rgb;
        float luminance = dot(c, vec3(0.2126, 0.7152, 0.0722));
        vec2 middle = uv - vec2(0.5, 0.55);
        float weight = exp(-4.0 * dot(middle, middle));
        // Written so that a NaN does not get through.
        float level = luminance > 1e-7 ? log2(min(luminance, 4.0)) : log2(1e-7);
        sum += weight * vec2(level, 1.0);
    }
    sums[worker] = sum;
    barrier();
    for (uint reach = 128; reach > 0; reach /= 2)
    {
        if (worker < reach)
        {
            sums[worker] += sums[worker + reach];
        }
        barrier();
    }
    if (worker == 0)
    {
        float mean = sums[0].x / sums[0].y;
        float average = mean - log2(SW_PRE_EXPOSURE);
        // A dim scene is meant to look dim: the darker, the lower its middle grey.
        float key = 0.19 * clamp(exp2(0.13 * (average - 11.5)), 0.3, 1.0);
        bool isFirst = exposure.exposure <= 0.0;
        float wanted = log2(key) - mean;
        float now = isFirst ? wanted : mix(wanted, log2(exposure.exposure), keep);
        exposure.exposure = exp2(now);
        exposure.average = average;
    }
}
