// SPDX-License-Identifier: MIT
// Light that the air has scattered twice or more, per unit of scattering coefficient and sunlight: the second order is
// integrated over the sphere, and higher ones follow as a geometric series [Hillaire 2020].
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
layout(binding = 2, rgba16f) writeonly uniform image2D target;

// Second order along one ray, and the part of an isotropic light that the ray scatters once more.
void integrateRay(float radius, vec3 direction, vec3 sun, inout vec3 second, inout vec3 factor)
{
    const int steps = 20;
    bool hits = hitsEarth(radius, direction.y);
    float length = hits ? distanceToEarth(radius, direction.y) : distanceToSphere(radius, direction.y, earthTop);
    float stepLength = length / float(steps);
    vec3 passed = vec3(1.0);
    for (int i = 0; i < steps; ++i)
    {
        vec3 position = vec3(0.0, radius, 0.0) + direction * ((float(i) + 0.5) * stepLength);
        float r = sqrt(dot(position, position));
        Air air = airAt(r, picture.haze);
        vec3 scattering = air.rayleigh + air.mie;
        vec3 through = exp(-air.extinction * stepLength);
        vec3 part = passed * (1.0 - through) / max(air.extinction, vec3(1e-7));
        second += part * scattering * sunTransmittance(transmittance, r, dot(position, sun) / r) / (4.0 * pi);
        factor += part * scattering;
        passed *= through;
    }
    if (hits)
    {
        second += passed * seaAlbedo / pi * max(sun.y, 0.0) * sunTransmittance(transmittance, earthBottom, sun.y);
    }
}

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 x = vec2(texel) / float(SW_SKY_MULTIPLE_SIDE - 1);
    float mu = x.x * 2.0 - 1.0;
    vec3 sun = vec3(sqrt(max(1.0 - mu * mu, 0.0)), mu, 0.0);
    float radius = earthBottom + max(x.y * (earthTop - earthBottom), 0.01);

    const int rays = 64;
    vec3 second = vec3(0.0);
    vec3 factor = vec3(0.0);
    for (int i = 0; i < rays; ++i)
    {
        // Spherical Fibonacci points.
        float y = 1.0 - (2.0 * float(i) + 1.0) / float(rays);
        float angle = 2.39996323 * float(i);
        float level = sqrt(1.0 - y * y);
        integrateRay(radius, vec3(cos(angle) * level, y, sin(angle) * level), sun, second, factor);
    }
    second /= float(rays);
    factor /= float(rays);
    imageStore(target, texel, vec4(second / (1.0 - factor), 1.0));
}
