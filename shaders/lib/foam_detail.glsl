// SPDX-License-Identifier: MIT
// From the smooth amount of foam to foam with holes. The texture's channels are patterns whose values are spread evenly
// over 0 .. 1, so a threshold of 1 - amount leaves exactly that amount covered: laces at two scales decide where foam
// is, bubbles how thick. The pattern rests on the water, drifts with it, and is renewed bit by bit: two copies with
// different offsets take turns. Where a pixel is wider than the pattern, the amount itself is the answer.

struct FoamDetail
{
    float cover;     // of the pixel by foam, [0, 1]
    float thickness; // of the foam that is there, [0, 1]
};

const float foamPeriod = 16.0; // m; offsets of the anchor are taken modulo this

// Turned and scaled by whole numbers, so that the pattern still closes after a period.
vec2 foamTurn(vec2 p, vec2 turn)
{
    return vec2(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y) / foamPeriod;
}

vec2 foamJump(float seed)
{
    return fract(vec2(0.7548777, 0.5698403) * seed);
}

float foamPattern(sampler2D pattern, vec2 p, float lod, float seed)
{
    vec2 jump = foamJump(seed);
    vec2 wide = vec2(1.0, 0.0);
    vec2 narrow = vec2(3.0, 2.0);
    float a = textureLod(pattern, foamTurn(p, wide) + jump, lod).r;
    float b = textureLod(pattern, foamTurn(p, narrow) - jump.yx, lod + 1.85).g;
    // Weights of 0.8 and 0.6 keep the spread of the sum that of one pattern.
    return 0.8 * (a - 0.5) + 0.6 * (b - 0.5);
}

FoamDetail foamDetailAt(sampler2D pattern, vec2 p, Footprint footprint, float amount, float phase, float seed)
{
    FoamDetail foam;
    foam.cover = 0.0;
    foam.thickness = 0.0;
    if (amount < 0.004)
    {
        return foam;
    }
    // Between blurred across and jagged along: the footprint's middle size.
    float pixel = sqrt(footprint.longest * footprint.shortest);
    float lod = log2(max(pixel * float(SW_FOAM_TEXTURE_SIDE) / foamPeriod, 1e-3));
    float turn = smoothstep(0.0, 1.0, abs(2.0 * phase - 1.0));
    float first = foamPattern(pattern, p, lod, seed + (phase > 0.5 ? 1.0 : 0.0) * 2.0);
    float second = foamPattern(pattern, p, lod, seed + 1.0);
    float value = mix(second, first, turn) * inversesqrt(turn * turn + (1.0 - turn) * (1.0 - turn)) + 0.5;

    float seen = 1.0 - smoothstep(0.25, 2.5, pixel);
    float soft = 0.12 + 0.25 * smoothstep(0.02, 1.0, pixel);
    // Even the densest foam keeps some holes.
    float edge = 1.0 - amount * (1.0 - 0.18 * amount);
    float holes = smoothstep(edge - soft, edge + soft, value);
    foam.cover = mix(amount, holes, seen);

    vec2 fine = vec2(12.0, 5.0);
    float bubbles = textureLod(pattern, foamTurn(p, fine) + foamJump(seed + 0.5), lod + 3.7).b;
    float depth = clamp((value - edge) * 1.7, 0.0, 1.0);
    foam.thickness = clamp(mix(0.6, 0.22 + 0.75 * depth + (bubbles - 0.5) * 0.55, seen), 0.05, 1.0);
    return foam;
}
