// SPDX-License-Identifier: MIT
#pragma once

// The wide float and the FFT of each instruction set, behind functions that a test can call.

#include <stdbool.h>
#include <stdint.h>

#include "seaway/world.h"

enum
{
    PROBE_OPERATIONS = 26,
    PROBE_LANES = 8
};

typedef struct WideProbe
{
    swIsa isa;
    int width;
    // Each operation on eight lanes of a, b (floats) and m, n (integers): out[PROBE_OPERATIONS][PROBE_LANES].
    void (*runOperations)(const float* a, const float* b, const uint32_t* m, const uint32_t* n, float* out);
    void (*sinCosTurns)(const uint32_t* phases, int count, float* sines, float* cosines);
    void (*transpose8)(const float* from, int fromStride, float* to, int toStride);
    // A panel of `size` rows of eight real and eight imaginary parts. With `pruned`, `from` has size / 2 + 1 rows.
    void (*transform)(int size, bool pruned, const float* from, float* work, float* out);
} WideProbe;

extern const WideProbe wideProbeScalar;
#if defined(__x86_64__)
extern const WideProbe wideProbeSse2;
extern const WideProbe wideProbeAvx2;
extern const WideProbe wideProbeAvx512;
#elif defined(__aarch64__)
extern const WideProbe wideProbeNeon;
#endif

// Probes that this machine can run, the scalar one first. Returns their number.
int ListWideProbes(const WideProbe** probes);
