// SPDX-License-Identifier: MIT
// The clear sky above the horizon, without the sun's disc: layer 0 from the camera, layer 1 from the sea, which is what
// waves reflect; layers 2 and 3 what haze adds to them, see Scattered.
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
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    float height = texel.z == 0 ? max(picture.cameraHeight, 1.0) * 1e-3 : 1e-3;
    float radius = earthBottom + height;
    vec3 direction = skyViewDirection(texel.xy, asin(horizonCosine(radius)));
    Scattered air = scatteredLight(transmittance, multiple, radius, direction, picture.sun,
                                   distanceToSphere(radius, direction.y, earthTop), picture.haze, 32);
    imageStore(target, texel, vec4(air.light * picture.sunLight, 1.0));
    imageStore(target, ivec3(texel.xy, texel.z + 2), vec4(air.haze * picture.sunLight, 1.0));
}
