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
    vec3 sky = withHaze(texelFetch(skyView, ivec3(texel, 1), 0).rgb, texelFetch(skyView, ivec3(texel, 3), 0).rgb,
                        direction, picture.sun);
    CloudOrigin clouds = CloudOrigin(vec2(picture.cloudX, picture.cloudZ), vec2(picture.cloudWayX, picture.cloudWayZ));
    vec4 cover = cloudsAlong(direction, earthBottom + 1e-3, clouds, picture.sun, light, picture.clouds, 0.02);
    imageStore(target, texel, vec4(sky * (1.0 - cover.a) + cover.rgb, 1.0));
}
