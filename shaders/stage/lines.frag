// SPDX-License-Identifier: MIT
// A line over the picture. Depth is reversed: what is near is large. The scene may have fewer pixels than the picture.
#version 460

layout(push_constant) uniform Push
{
    mat4 clip;
    vec2 perPixel;
};
layout(binding = 0) uniform sampler2D sceneDepth;
layout(location = 0) in vec3 tint;
layout(location = 0) out vec4 color;

void main()
{
    float scene = texture(sceneDepth, gl_FragCoord.xy * perPixel).r;
    bool isHidden = gl_FragCoord.z * 1.01 < scene; // a line on the surface itself is not
    color = vec4(tint, isHidden ? 0.2 : 1.0);
}
