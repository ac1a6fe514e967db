// SPDX-License-Identifier: MIT
// From the smooth amount of foam to foam with holes. The texture's channels are patterns whose values are spread evenly
// over 0 .. 1, so that a threshold can leave just that amount covered, see foamEdge(): laces at two scales decide where
// foam is, bubbles how thick. The pattern rests on the water, drifts with it, and is renewed bit by bit: two copies
// with different offsets take turns. A copy is in its own place when it counts most, and is carried to there and on, so
// that no copy is drawn out for long where the flow differs from place to place. Where a pixel is wider than the
// pattern, the amount itself is the answer.
#ifndef SW_LIB_FOAM_LOOK
#define SW_LIB_FOAM_LOOK
#include "lib/surface_sample.glsl"

struct FoamDetail
{
    float cover;     // of the pixel by foam, [0, 1]
    float thickness; // of the foam that is there, [0, 1]
};

const float foamPeriod = 1024.0;      // m; offsets of the anchor are taken modulo this
const float foamFarthest = 4.0;       // m that a pixel covers where no pattern is seen any more
const float foamMeanThickness = 0.37; // of foam whose pattern is not seen

// Turned and scaled by whole numbers, so that the pattern still closes after a period.
vec2 foamTurn(vec2 p, vec2 turn)
{
    return vec2(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y) / foamPeriod;
}

vec2 foamJump(float seed)
{
    return fract(vec2(0.7548777, 0.5698403) * seed);
}

// What a level of the pattern's pyramid keeps of the values' spread, fitted to the two laces' levels within 0.03.
// Without it far foam, whose values lie closer to their mean, would pass the edge too seldom and cover less than its
// amount.
float foamSpread(float lod, float middle, float power)
{
    return 1.0 / (1.0 + pow(exp2(max(lod, 0.0)) / middle, power));
}

// Two laces, turned against each other so that they line up again only after the whole period. `first` and `second` are
// their turns, see foamTurn(); `lod` is that of one pattern a period.
float foamLaces(sampler2D pattern, vec2 p, float lod, vec2 first, vec2 second, float seed)
{
    vec2 jump = foamJump(seed);
    float levelA = lod + log2(length(first));
    float levelB = lod + log2(length(second));
    float a = textureLod(pattern, foamTurn(p, first) + jump, levelA).r;
    float b = textureLod(pattern, foamTurn(p, second) - jump.yx, levelB).g;
    // Weights of 0.8 and 0.6 keep the spread of the sum that of one pattern.
    float kept = length(vec2(0.8 * foamSpread(levelA, 40.0, 1.1), 0.6 * foamSpread(levelB, 18.0, 1.15)));
    return (0.8 * (a - 0.5) + 0.6 * (b - 0.5)) / max(kept, 0.3);
}

// The patterns are bent by a slow one, so that rows of equal patches do not show from a height.
vec2 foamBend(sampler2D pattern, vec2 p)
{
    vec2 slow = textureLod(pattern, foamTurn(p, vec2(2.0, -1.0)), 6.0).rg;
    return p + 110.0 * (slow - 0.5);
}

// Value that the sum of two laces, plus 1/2, exceeds in a share of places: the quantile of 0.8 and 0.6 times even
// numbers.
float foamEdge(float share)
{
    float few = sqrt(0.96 * min(share, 1.0 - share));
    float rare = min(few, 0.6) - 0.2;
    return abs(share - 0.5) < 0.125 ? 0.9 - 0.8 * share : share < 0.5 ? 1.0 - rare : rare;
}

// Blend that keeps the spread.
float blendEven(float a, float b, float t)
{
    return mix(a, b, t) * inversesqrt(t * t + (1.0 - t) * (1.0 - t));
}

// Laces of streaks some metres long from afar, of bubbles' rafts from nearby.
float foamValue(sampler2D pattern, vec2 p, float lod, float pixel, float seed)
{
    float far = smoothstep(0.15, 1.0, pixel);
    float value = 0.0;
    if (far < 1.0)
    {
        value = foamLaces(pattern, p, lod, vec2(56.0, 31.0), vec2(184.0, 136.0), seed);
    }
    if (far > 0.0)
    {
        value = blendEven(value, foamLaces(pattern, p, lod, vec2(13.0, 8.0), vec2(43.0, 31.0), seed + 0.37), far);
    }
    return value;
}

// Foam from afar comes in clumps of tens of metres: the crests and groups of waves that the slice does not carry, of
// which `amount` holds the mean alone. A factor of mean 1, of which most places have less and some much more. Without
// it even foam would be wherever the laces have their peaks, once a pattern.
float foamClumps(sampler2D pattern, vec2 p, float lod, float seed)
{
    vec2 jump = foamJump(seed + 0.11);
    float sum = textureLod(pattern, foamTurn(p, vec2(5.0, -3.0)) + jump, max(lod + 2.5, 2.0)).r +
                textureLod(pattern, foamTurn(p, vec2(-7.0, 9.0)) - jump, max(lod + 3.5, 2.0)).g +
                textureLod(pattern, foamTurn(p, vec2(15.0, 16.0)) + jump.yx, max(lod + 4.5, 2.0)).r;
    return 2.0 * sum - 3.0; // a sum of three even numbers is nearly normal, with deviation 1/2
}

float foamClumping(float normal, float spread)
{
    return exp(spread * (normal - 0.5 * spread));
}

float foamBubbles(sampler2D pattern, vec2 p, float lod, float seed)
{
    return textureLod(pattern, foamTurn(p, vec2(768.0, 320.0)) + foamJump(seed + 0.5), lod + 9.7).b;
}

// `drift` is how far the water goes while a pattern lasts, m.
FoamDetail foamDetailAt(sampler2D pattern, vec2 p, vec2 drift, Footprint footprint, float amount, float phase,
                        float seed)
{
    FoamDetail foam;
    foam.cover = 0.0;
    foam.thickness = 0.0;
    if (amount < 1e-5)
    {
        return foam;
    }
    // Between blurred across and jagged along: the footprint's middle size.
    float pixel = sqrt(footprint.longest * footprint.shortest);
    if (pixel >= foamFarthest)
    {
        foam.cover = amount;
        foam.thickness = foamMeanThickness;
        return foam;
    }
    bool isCarried = drift != vec2(0.0);
    vec2 firstPlace = foamBend(pattern, p - drift * (phase > 0.5 ? phase - 1.0 : phase));
    vec2 secondPlace = isCarried ? foamBend(pattern, p - drift * (phase - 0.5)) : firstPlace;
    float lod = log2(max(pixel * float(SW_FOAM_TEXTURE_SIDE) / foamPeriod, 1e-3));
    float turn = smoothstep(0.0, 1.0, abs(2.0 * phase - 1.0));
    float first = foamValue(pattern, firstPlace, lod, pixel, seed + (phase > 0.5 ? 2.0 : 0.0));
    float second = foamValue(pattern, secondPlace, lod, pixel, seed + 1.0);
    float value = blendEven(second, first, turn) + 0.5;
    // Nearby the laces themselves are seen; far off their and the clumps' periods would be.
    float spread = 1.1 * smoothstep(0.02, 0.15, pixel) * (1.0 - smoothstep(0.5, 3.5, pixel));
    if (spread > 0.0)
    {
        float clumps = blendEven(foamClumps(pattern, secondPlace, lod, seed + 1.0),
                                 foamClumps(pattern, firstPlace, lod, seed + (phase > 0.5 ? 2.0 : 0.0)), turn);
        amount = min(amount * foamClumping(clumps, spread), 1.0);
    }

    float seen = 1.0 - smoothstep(0.5, foamFarthest, pixel);
    if (amount < 0.004) // less than a pattern's highest peaks cover
    {
        foam.cover = amount * (1.0 - seen);
        foam.thickness = foamMeanThickness;
        return foam;
    }
    // Even the densest foam keeps some holes.
    float edge = foamEdge(amount * (1.0 - 0.18 * amount));
    float soft = min(0.12 + 0.12 * smoothstep(0.02, 1.0, pixel), 0.8 * (1.2 - edge));
    float holes = smoothstep(edge - soft, edge + soft, value);
    foam.cover = mix(amount, holes, seen);

    float bubbles = foamBubbles(pattern, firstPlace, lod, seed);
    bubbles = isCarried ? mix(foamBubbles(pattern, secondPlace, lod, seed), bubbles, turn) : bubbles;
    float depth = clamp((value - edge) * 1.7, 0.0, 1.0);
    foam.thickness = clamp(mix(foamMeanThickness, 0.22 + 0.75 * depth + (bubbles - 0.5) * 0.55, seen), 0.05, 1.0);
    return foam;
}

// Radiance of foam, matt and lit from all around.
vec3 foamRadiance(vec3 albedo, vec3 normal, vec3 sun, vec3 sunlight, vec3 skylight)
{
    float lambert = max(0.85 * dot(normal, sun) + 0.15, 0.0);
    vec3 foamLight = (sunlight * lambert * smoothstep(-0.02, 0.05, sun.y) + skylight) / 3.14159265;
    return foamLight * albedo;
}
#endif
