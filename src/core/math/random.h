// SPDX-License-Identifier: MIT
#pragma once

// Random numbers by hashing: a number depends on what it is for (seed, band, wave, stream) and on nothing else, neither
// on the order of calls nor on a tile's resolution. The mixer is the finalizer of SplitMix64 [Steele 2014].

#include <stdint.h>

static inline uint64_t swMix64(uint64_t x)
{
    x ^= x >> 30;
    x *= 0xbf58476d1ce4e5b9u;
    x ^= x >> 27;
    x *= 0x94d049bb133111ebu;
    x ^= x >> 31;
    return x;
}

// A hash of one wave's number `stream`.
static inline uint64_t swHashWave(uint32_t seed, int band, int qx, int qz, uint32_t stream)
{
    uint64_t h = swMix64(0x9e3779b97f4a7c15u + seed);
    h = swMix64(h ^ (((uint64_t)(uint32_t)band << 32) | stream));
    return swMix64(h ^ (((uint64_t)(uint32_t)qx << 32) | (uint32_t)qz));
}

// The middle of one of 2^52 equal parts of (0, 1): never 0, never 1.
static inline double swHashToUnit(uint64_t hash)
{
    return ((double)(hash >> 12) + 0.5) * 0x1p-52;
}
