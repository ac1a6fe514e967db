// SPDX-License-Identifier: MIT
// Numbers with their derivatives along x and z, and what is made of them by the rules of differentiation.
#ifndef SW_SHARED_CHANNELS_H
#define SW_SHARED_CHANNELS_H
#include "input.h"

SW_FORMULA swInputChannel swKeepChannel(float value)
{
    return swMakeChannel(value, 0.0f, 0.0f);
}

SW_FORMULA swInputChannel swAddChannels(swInputChannel a, swInputChannel b)
{
    return swMakeChannel(a.value + b.value, a.alongX + b.alongX, a.alongZ + b.alongZ);
}

SW_FORMULA swInputChannel swSubtractChannels(swInputChannel a, swInputChannel b)
{
    return swMakeChannel(a.value - b.value, a.alongX - b.alongX, a.alongZ - b.alongZ);
}

SW_FORMULA swInputChannel swScaleChannel(swInputChannel a, float factor)
{
    return swMakeChannel(a.value * factor, a.alongX * factor, a.alongZ * factor);
}

SW_FORMULA swInputChannel swMultiplyChannels(swInputChannel a, swInputChannel b)
{
    return swMakeChannel(a.value * b.value, a.alongX * b.value + a.value * b.alongX,
                         a.alongZ * b.value + a.value * b.alongZ);
}

// a / b, b not being 0.
SW_FORMULA swInputChannel swDivideChannels(swInputChannel a, swInputChannel b)
{
    float part = a.value / b.value;
    return swMakeChannel(part, (a.alongX - part * b.alongX) / b.value, (a.alongZ - part * b.alongZ) / b.value);
}

// f(a) by its value and its derivative.
SW_FORMULA swInputChannel swMapChannel(swInputChannel a, float value, float slope)
{
    return swMakeChannel(value, slope * a.alongX, slope * a.alongZ);
}

// From 0 at `low` and below to 1 at `high` and above: 3 t^2 - 2 t^3.
SW_FORMULA swInputChannel swRiseChannel(swInputChannel a, float low, float high)
{
    float t = (a.value - low) / (high - low);
    if (t <= 0.0f || t >= 1.0f)
    {
        return swKeepChannel(t <= 0.0f ? 0.0f : 1.0f);
    }
    return swMapChannel(a, t * t * (3.0f - 2.0f * t), 6.0f * t * (1.0f - t) / (high - low));
}
#endif
