// SPDX-License-Identifier: MIT
#pragma once

// The hash at the end of a saved world, which would keep a fuzzer out: it is made right.

#include "core/base/hash.h"

// Of `size` bytes, into the eight behind them.
static inline void FixHash(uint8_t* data, size_t size)
{
    swHash hash = swBeginHash();
    for (size_t i = 0; i < size; i += 8)
    {
        uint64_t word = 0;
        for (size_t k = 0; k < 8 && i + k < size; ++k)
        {
            word |= (uint64_t)data[i + k] << (8 * k);
        }
        swAddHash(&hash, word);
    }
    swAddHash(&hash, size);
    uint64_t value = swEndHash(&hash);
    for (int k = 0; k < 8; ++k)
    {
        data[size + (size_t)k] = (uint8_t)(value >> (8 * k));
    }
}
