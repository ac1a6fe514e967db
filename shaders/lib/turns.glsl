// SPDX-License-Identifier: MIT
// Phases as fractions of 2^32 of a turn: exact integers, so that a sea has the same waves after a month as at the
// start.

// The top 32 bits of the low 64 bits of a * b, 64-bit factors in halves.
uint phaseOf(uint aLow, uint aHigh, uint bLow, uint bHigh)
{
    uint high, low;
    umulExtended(aLow, bLow, high, low);
    return high + aLow * bHigh + aHigh * bLow;
}

// rad/s of turns a tick in fractions of 2^64; a second has 2^24 ticks.
float omegaOf(uint low, uint high)
{
    return fma(float(low), 1.0 / 4294967296.0, float(high)) * (6.28318530718 / 256.0);
}

// A fraction of 2^32. The nearest whole turn is taken off first, so that the integer cannot overflow.
uint toTurns(float turns)
{
    return uint(int((turns - round(turns)) * 2147483648.0)) << 1;
}

// (cosine, sine), good to about 2^-24: the nearest quarter turn is taken off in integers and Taylor's series does the
// rest. sin() and cos() of GLSL need not be better than 2^-11.
vec2 unitOf(uint phase)
{
    uint quarter = (phase + 0x20000000u) >> 30;
    float x = float(int(phase - (quarter << 30))) * (6.28318530718 / 4294967296.0);
    float x2 = x * x;
    float sine = x - x * (x2 * (1.0 / 6.0 - x2 * (1.0 / 120.0 - x2 * (1.0 / 5040.0 - x2 * (1.0 / 362880.0)))));
    float cosine = 1.0 - x2 * (0.5 - x2 * (1.0 / 24.0 - x2 * (1.0 / 720.0 - x2 * (1.0 / 40320.0))));
    vec2 unit = (quarter & 1u) != 0u ? vec2(-sine, cosine) : vec2(cosine, sine);
    return (quarter & 2u) != 0u ? -unit : unit;
}
