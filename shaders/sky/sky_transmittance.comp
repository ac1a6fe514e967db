// SPDX-License-Identifier: MIT
// Transmittance from any height to the top of the air, over height and angle.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/picture.h"
#include "lib/atmosphere.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Picture
{
    swPictureParams picture;
};
layout(binding = 1, rgba16f) writeonly uniform image2D target;

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 size = vec2(SW_SKY_TRANSMITTANCE_WIDTH, SW_SKY_TRANSMITTANCE_HEIGHT);
    float radius, mu;
    transmittanceOf(vec2(texel) / (size - 1.0), radius, mu);
    const int steps = 48;
    float length = distanceToSphere(radius, mu, earthTop);
    float stepLength = length / float(steps);
    vec3 depth = vec3(0.0);
    for (int i = 0; i < steps; ++i)
    {
        float t = (float(i) + 0.5) * stepLength;
        float r = sqrt(radius * radius + t * t + 2.0 * radius * mu * t);
        depth += airAt(r, picture.haze).extinction * stepLength;
    }
    imageStore(target, texel, vec4(exp(-depth), 1.0));
}
