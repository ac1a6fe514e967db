// SPDX-License-Identifier: MIT
#pragma once

// Bytes of a fuzzer as choices and numbers. Behind the last byte all are 0.

#include <math.h>
#include <string.h>

#include "fuzz.h"

typedef struct Bytes
{
    const uint8_t* data;
    size_t size, at;
} Bytes;

static inline int TakeByte(Bytes* bytes)
{
    return bytes->at < bytes->size ? bytes->data[bytes->at++] : 0;
}

static inline int TakeChoice(Bytes* bytes, int count)
{
    return TakeByte(bytes) % count;
}

// Small numbers, those at which things break, or any.
static inline float TakeNumber(Bytes* bytes)
{
    static const float odd[] = {NAN,     INFINITY, -INFINITY, 1e30f,  -1e30f,  1e-30f, 1e9f,
                                -1e9f,   1e6f,     -1e6f,     0.5f,   1e-3f,   1e-6f,  100.0f,
                                -100.0f, 1000.0f,  0.999f,    1.001f, 127.99f, 128.0f, -128.0f};
    int kind = TakeByte(bytes);
    if (kind < 128)
    {
        return (float)(kind - 64);
    }
    if (kind < 192)
    {
        return odd[(size_t)kind % (sizeof odd / sizeof odd[0])];
    }
    uint32_t word = 0;
    for (int i = 0; i < 4; ++i)
    {
        word = word << 8 | (uint32_t)TakeByte(bytes);
    }
    float value;
    memcpy(&value, &word, sizeof value);
    return value;
}
