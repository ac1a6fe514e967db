// SPDX-License-Identifier: MIT
// What waves reflect: the sky as the sea sees it, with its clouds. Blurred copies follow in the mips.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/picture.h"
#include "lib/atmosphere.glsl"
#include "lib/noise.glsl"
#include "lib/clouds.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Picture
{
    swPictureParams picture;
};
layout(std430, binding = 1) readonly buffer Light
{
    swSkyLight light;
};
layout(binding = 2) uniform sampler2DArray skyView;
layout(binding = 3, rgba16f) writeonly uniform image2D target;

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec3 direction = skyViewDirection(texel, 0.0);
    vec3 sky = texelFetch(skyView, ivec3(texel, 1), 0).rgb;
    vec4 clouds = cloudsAlong(direction, earthBottom + 1e-3, vec2(picture.cloudX, picture.cloudZ), picture.sun.xyz,
                              light, picture.foamAlbedo.w, 0.02);
    imageStore(target, texel, vec4(sky * (1.0 - clouds.a) + clouds.rgb, 1.0));
}
