// SPDX-License-Identifier: MIT
// A line's end, m from the camera.
#version 460

layout(push_constant) uniform Push
{
    mat4 clip;     // from metres from the camera to clip space
    vec2 perPixel; // of the picture
};
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color;
layout(location = 0) out vec3 tint;

void main()
{
    gl_Position = clip * vec4(position, 1.0);
    tint = color.rgb;
}
