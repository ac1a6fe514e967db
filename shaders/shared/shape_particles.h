// SPDX-License-Identifier: MIT
// A disc about each of many points, with a value of its own. Words of each: x, z, radius, weight, four values; extra0
// is their number. Where discs lie over one another the value is the mean by their shares. What is added adds up there;
// what is mixed covers as discs one over another do.
#ifndef SW_SHARED_SHAPE_PARTICLES_H
#define SW_SHARED_SHAPE_PARTICLES_H
#include "input.h"

#define SW_PARTICLE_WORDS 8u

SW_PARAMS(swParticleSum)
{
    sw_vec4 value, valueX, valueZ; // of share times value
    swInputChannel share;          // of shares
    swInputChannel covered;        // of the water, by all together: each covers its share of what the others leave open
};

SW_FORMULA swInputChannel swAddPart(swInputChannel share, float value)
{
    return swMakeChannel(share.value * value, share.alongX * value, share.alongZ * value);
}

SW_FORMULA swParticleSum swAddParticle(SW_WORDS words, swInputRecord record, sw_uint at, float x, float z,
                                       swParticleSum sum)
{
    float dx = x - SW_WORD(words, at), dz = z - SW_WORD(words, at + 1u);
    float radius = SW_WORD(words, at + 2u);
    float square = dx * dx + dz * dz;
    if (square > radius * radius)
    {
        return sum;
    }
    float distance = SW_INPUT_SQRT(square);
    float weight = SW_WORD(words, at + 3u);
    sw_vec2 cover = swCoverDisc(record, distance, radius);
    float slope = distance > 0.0f ? weight * cover.y / distance : 0.0f;
    swInputChannel share = swMakeChannel(weight * cover.x, slope * dx, slope * dz);
    swInputChannel part = swAddPart(share, SW_WORD(words, at + 4u));
    sum.value.x = sum.value.x + part.value;
    sum.valueX.x = sum.valueX.x + part.alongX;
    sum.valueZ.x = sum.valueZ.x + part.alongZ;
    part = swAddPart(share, SW_WORD(words, at + 5u));
    sum.value.y = sum.value.y + part.value;
    sum.valueX.y = sum.valueX.y + part.alongX;
    sum.valueZ.y = sum.valueZ.y + part.alongZ;
    part = swAddPart(share, SW_WORD(words, at + 6u));
    sum.value.z = sum.value.z + part.value;
    sum.valueX.z = sum.valueX.z + part.alongX;
    sum.valueZ.z = sum.valueZ.z + part.alongZ;
    part = swAddPart(share, SW_WORD(words, at + 7u));
    sum.value.w = sum.value.w + part.value;
    sum.valueX.w = sum.valueX.w + part.alongX;
    sum.valueZ.w = sum.valueZ.w + part.alongZ;
    sum.share =
        swMakeChannel(sum.share.value + share.value, sum.share.alongX + share.alongX, sum.share.alongZ + share.alongZ);
    // Added to what is covered rather than taken from what is open: near an edge that is the difference of two numbers
    // that are nearly 1.
    float open = 1.0f - sum.covered.value, left = 1.0f - share.value;
    sum.covered = swMakeChannel(sum.covered.value + share.value * open, sum.covered.alongX * left + share.alongX * open,
                                sum.covered.alongZ * left + share.alongZ * open);
    return sum;
}

SW_FORMULA swInputSample swSampleParticles(SW_WORDS words, swInputRecord record, float x, float z)
{
    swInputSample s = swBeginInputSample(record);
    swParticleSum sum;
    sum.value = swNoValue();
    sum.valueX = swNoValue();
    sum.valueZ = swNoValue();
    sum.share = swMakeChannel(0.0f, 0.0f, 0.0f);
    sum.covered = sum.share;
    for (sw_uint i = 0u; i < record.extra0; ++i)
    {
        sum = swAddParticle(words, record, i * SW_PARTICLE_WORDS, x, z, sum);
    }
    s.share = 0.0f;
    if (sum.share.value <= 0.0f)
    {
        return s;
    }
    // The quotient of sums, and its derivatives.
    float scale = 1.0f / sum.share.value;
    float meanX = sum.value.x * scale, meanY = sum.value.y * scale;
    float meanZ = sum.value.z * scale, meanW = sum.value.w * scale;
    s.value.x = s.value.x + meanX;
    s.value.y = s.value.y + meanY;
    s.value.z = s.value.z + meanZ;
    s.value.w = s.value.w + meanW;
    s.valueX.x = (sum.valueX.x - meanX * sum.share.alongX) * scale;
    s.valueX.y = (sum.valueX.y - meanY * sum.share.alongX) * scale;
    s.valueX.z = (sum.valueX.z - meanZ * sum.share.alongX) * scale;
    s.valueX.w = (sum.valueX.w - meanW * sum.share.alongX) * scale;
    s.valueZ.x = (sum.valueZ.x - meanX * sum.share.alongZ) * scale;
    s.valueZ.y = (sum.valueZ.y - meanY * sum.share.alongZ) * scale;
    s.valueZ.z = (sum.valueZ.z - meanZ * sum.share.alongZ) * scale;
    s.valueZ.w = (sum.valueZ.w - meanW * sum.share.alongZ) * scale;
    bool adds = record.blend == SW_JOIN_ADD;
    swInputChannel share = sum.covered;
    if (adds)
    {
        share = sum.share;
    }
    s.share = share.value;
    s.shareX = share.alongX;
    s.shareZ = share.alongZ;
    return s;
}
#endif
