// SPDX-License-Identifier: MIT
#pragma once

// Sine and cosine of a phase in turns, a fraction of 2^32. The nearest quarter turn is taken off in integers, which is
// exact; what is left, at most an eighth of a turn, goes through Taylor's series to x^9 and x^8 (rest below 2^-25).
// swSinCosTurns and swSinCosTurnsW are the same operations in the same order, so they give the same bits.

#define SW_TURNS_TO_RADIANS 0x1.921fb6p-30f // 2 pi / 2^32

#define SW_SINE_9 (1.0f / 362880.0f)
#define SW_SINE_7 (1.0f / 5040.0f)
#define SW_SINE_5 (1.0f / 120.0f)
#define SW_SINE_3 (1.0f / 6.0f)
#define SW_COSINE_8 (1.0f / 40320.0f)
#define SW_COSINE_6 (1.0f / 720.0f)
#define SW_COSINE_4 (1.0f / 24.0f)
#define SW_COSINE_2 0.5f

#define SW_TURNS_SINE(x, x2)                                                                                           \
    ((x) - (x) * ((x2) * (SW_SINE_3 - (x2) * (SW_SINE_5 - (x2) * (SW_SINE_7 - (x2)*SW_SINE_9)))))
#define SW_TURNS_COSINE(x2)                                                                                            \
    (1.0f - (x2) * (SW_COSINE_2 - (x2) * (SW_COSINE_4 - (x2) * (SW_COSINE_6 - (x2)*SW_COSINE_8))))
