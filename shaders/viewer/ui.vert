// SPDX-License-Identifier: MIT
// The panel's triangles, from window units to clip space. Colours stay as they are: the target is a UNORM view of an
// image that holds sRGB bytes, so blending happens on encoded values, as the widgets were designed for.
#version 460

layout(push_constant) uniform Params
{
    vec2 scale; // 2 / window size
};

layout(location = 0) in vec2 inPosition;
layout(location = 1) in vec2 inUv;
layout(location = 2) in vec4 inColor;
layout(location = 0) out vec2 outUv;
layout(location = 1) out vec4 outColor;

void main()
{
    outUv = inUv;
    outColor = inColor;
    gl_Position = vec4(inPosition * scale - 1.0, 0.0, 1.0);
}
