// SPDX-License-Identifier: MIT
// Exposure and the tone curve: a sigmoid in log exposure, y = x^c / (x^c + g) [Naka and Rushton 1966], which keeps
// middle grey, on primaries moved a little inwards, so that bright colours turn pale as film's do instead of clipping
// [Sobotka 2022]; then noise of one step, so that skies do not band.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/picture.h"

layout(constant_id = 0) const uint targetEncodes = 1; // the target's format converts to sRGB itself

layout(binding = 0) uniform sampler2D hdr;
layout(std430, binding = 1) readonly buffer Exposure
{
    swExposure exposure;
};
layout(push_constant) uniform Push
{
    float seed;
    float stops;
    float raw; // 1: show the colours as they are
};

layout(location = 0) in vec2 clip;
layout(location = 0) out vec4 color;

const vec3 luma = vec3(0.2126, 0.7152, 0.0722);

vec3 toneCurve(vec3 x)
{
    const float contrast = 1.35;
    const float grey = 0.18;
    const float white = 6.0; // what becomes 1
    float g = pow(grey, contrast) * (1.0 - grey) / grey;
    float w = pow(white, contrast);
    vec3 p = pow(max(x, vec3(0.0)), vec3(contrast));
    return p / (p + g) * ((w + g) / w);
}

vec3 encode(vec3 c)
{
    return mix(1.055 * pow(max(c, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThan(c, vec3(0.0031308)));
}

vec3 decode(vec3 c)
{
    return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThan(c, vec3(0.04045)));
}

float hashed(uvec2 p, uint salt)
{
    uint h = p.x * 0x8da6b343u + p.y * 0xd8163841u + salt * 0xcb1ab31fu;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return float(h >> 8) / 16777216.0;
}

void main()
{
    vec2 uv = 0.5 * clip + 0.5;
    vec3 c = textureLod(hdr, uv, 0.0).rgb;
    if (raw == 0.0)
    {
        const float inset = 0.09;
        c *= exposure.exposure > 0.0 ? exposure.exposure * exp2(stops) : 1.0;
        c = mix(c, vec3(dot(c, luma)), inset);
        c = toneCurve(c);
        // Part of the way back out.
        c = max(mix(vec3(dot(c, luma)), c, 1.0 / (1.0 - 0.8 * inset)), vec3(0.0));
    }

    vec3 shown = encode(min(c, vec3(1.0)));
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint salt = floatBitsToUint(seed);
    float noise = hashed(pixel, salt) + hashed(pixel, salt + 1u) - 1.0;
    shown = clamp(shown + noise / 255.0, 0.0, 1.0);
    color = vec4(targetEncodes != 0 ? decode(shown) : shown, 1.0);
}
