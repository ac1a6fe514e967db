// SPDX-License-Identifier: MIT
// One mip from the one before: averages of 2 x 2 texels.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) readonly uniform image2D source;
layout(binding = 1, rgba16f) writeonly uniform image2D target;

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(target))))
    {
        return;
    }
    ivec2 first = 2 * texel;
    vec4 sum = imageLoad(source, first) + imageLoad(source, first + ivec2(1, 0)) +
               imageLoad(source, first + ivec2(0, 1)) + imageLoad(source, first + ivec2(1, 1));
    imageStore(target, texel, 0.25 * sum);
}
