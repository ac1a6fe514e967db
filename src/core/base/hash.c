// SPDX-License-Identifier: MIT
#include "core/base/hash.h"

#include <string.h>

// Odd multipliers of the fractional bits of the golden ratio and of sqrt(2).
#define GOLDEN 0x9E3779B97F4A7C15u
#define ROOT2 0x6A09E667F3BCC909u

static uint64_t rotate(uint64_t x, int bits)
{
    return (x << bits) | (x >> (64 - bits));
}

static uint64_t mixWord(uint64_t lane, uint64_t word)
{
    return rotate(lane ^ (word * ROOT2), 29) * GOLDEN;
}

// Every input bit reaches every output bit: the finalizer of SplitMix64 [Steele 2014].
static uint64_t finish(uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

swHash swBeginHash(void)
{
    return (swHash){.lanes = {GOLDEN, ROOT2, GOLDEN ^ ROOT2, GOLDEN + ROOT2}};
}

void swAddHash(swHash* hash, uint64_t word)
{
    uint64_t* lane = &hash->lanes[hash->count & 3];
    *lane = mixWord(*lane, word);
    hash->count += 1;
}

void swAddHashDouble(swHash* hash, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    swAddHash(hash, bits);
}

static uint64_t loadPair(const float* values)
{
    uint32_t low, high;
    memcpy(&low, values, sizeof low);
    memcpy(&high, values + 1, sizeof high);
    return low | (uint64_t)high << 32;
}

void swAddHashFloats(swHash* hash, const float* values, size_t count)
{
    size_t i = 0;
    for (; i + 2 <= count && (hash->count & 3) != 0; i += 2)
    {
        swAddHash(hash, loadPair(values + i));
    }
    uint64_t a = hash->lanes[0], b = hash->lanes[1], c = hash->lanes[2], d = hash->lanes[3];
    for (; i + 8 <= count; i += 8)
    {
        a = mixWord(a, loadPair(values + i));
        b = mixWord(b, loadPair(values + i + 2));
        c = mixWord(c, loadPair(values + i + 4));
        d = mixWord(d, loadPair(values + i + 6));
        hash->count += 4;
    }
    hash->lanes[0] = a;
    hash->lanes[1] = b;
    hash->lanes[2] = c;
    hash->lanes[3] = d;
    for (; i + 2 <= count; i += 2)
    {
        swAddHash(hash, loadPair(values + i));
    }
    if (i < count)
    {
        uint32_t last;
        memcpy(&last, values + i, sizeof last);
        swAddHash(hash, last);
    }
}

uint64_t swEndHash(const swHash* hash)
{
    uint64_t x = finish(hash->count + GOLDEN);
    for (int i = 0; i < 4; ++i)
    {
        x = finish(x ^ hash->lanes[i]) + GOLDEN;
    }
    return finish(x);
}
