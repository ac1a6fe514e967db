// SPDX-License-Identifier: MIT
#pragma once

// A 64-bit hash of numbers for digests: the same on every machine, whatever its byte order. Not for secrets.
// Words go round four lanes, each a multiply and rotate, so that hashing a tile runs at the speed of memory.

#include <stddef.h>
#include <stdint.h>

typedef struct swHash
{
    uint64_t lanes[4];
    uint64_t count; // of 64-bit words added
} swHash;

swHash swBeginHash(void);
void swAddHash(swHash* hash, uint64_t word);
void swAddHashDouble(swHash* hash, double value);
// The bits of floats, two a word; an odd last one stands alone.
void swAddHashFloats(swHash* hash, const float* values, size_t count);
uint64_t swEndHash(const swHash* hash);
