// SPDX-License-Identifier: MIT
// Waves by place: how much of a wave system there is where inputs of the field WAVES say so.
//
// An input that removes what is below it takes all waves away by the same share by which it brings its own. Waves of
// two systems are unrelated, so their energies add up: the two weights have squares whose sum is 1.
//
// A record may take a wind instead of a number: its raster holds the wind along x and z. The wave system behind it is
// made for one heading and one speed; of these there are several, and a place mixes the two nearest headings and the
// two nearest speeds, again with weights whose squares add up to 1. No angle is worked out: the wind is a sum of the
// two headings on either side of it, and its share of the second is that one's part of the sum.
#ifndef SW_SHARED_REGION_H
#define SW_SHARED_REGION_H
#include "channels.h"
#include "input.h"

// Winds below this have no heading to speak of, m/s: their waves are still there, and lower than any that are seen.
#define SW_LEAST_REGION_WIND 1e-3f

// Two weights from a share that runs from 0 to 1: the squares' sum is 1, and both have no slope where they are 1.
SW_PARAMS(swWeightPair)
{
    float first, firstSlope;   // 1 to 0
    float second, secondSlope; // 0 to 1
};

SW_FORMULA swWeightPair swPairWeights(float share)
{
    float c = share > 0.0f ? (share < 1.0f ? share : 1.0f) : 0.0f;
    float rest = 1.0f - c;
    float square = c * c + rest * rest;
    float length = SW_INPUT_SQRT(square);
    float cube = square * length;
    bool isBetween = share > 0.0f && share < 1.0f;
    swWeightPair pair;
    pair.first = rest / length;
    pair.second = c / length;
    pair.firstSlope = isBetween ? -c / cube : 0.0f;
    pair.secondSlope = isBetween ? rest / cube : 0.0f;
    return pair;
}

// The same from a share that is first made smooth at both ends, so that the weights have no slope there either.
SW_FORMULA swWeightPair swPairSmoothly(float share)
{
    float c = share > 0.0f ? (share < 1.0f ? share : 1.0f) : 0.0f;
    swWeightPair pair = swPairWeights(c * c * (3.0f - 2.0f * c));
    float slope = 6.0f * c * (1.0f - c);
    pair.firstSlope = pair.firstSlope * slope;
    pair.secondSlope = pair.secondSlope * slope;
    return pair;
}

// ---- winds ----

// Of a record that takes a wind: turn.x and turn.y are its heading (a unit vector), turn.z and turn.w cosine and sine
// of the angle to the next. size.x is its speed, size.y and size.z are those of the systems below and above it, 0 where
// there is none. value.z and value.w are the deviations of these systems' heights over its own; where there is none,
// how the deviation bends: (s/S) (1 + bend (s/S - 1)) of its own at a speed s instead of S.
SW_FORMULA swInputChannel swFindHeadingWeight(swInputRecord record, swInputChannel windX, swInputChannel windZ)
{
    float headX = record.turn.x;
    float headZ = record.turn.y;
    float along = headX * windX.value + headZ * windZ.value;
    float across = headX * windZ.value - headZ * windX.value; // above 0: towards the next heading
    float side = across < 0.0f ? -1.0f : 1.0f;
    // The wind is first * heading + second * neighbour, both times the sine of the angle between them.
    float second = side * across;
    float first = along * record.turn.w - second * record.turn.z;
    if (first <= 0.0f || along <= 0.0f)
    {
        return swMakeChannel(0.0f, 0.0f, 0.0f);
    }
    float secondX = side * (headX * windZ.alongX - headZ * windX.alongX);
    float secondZ = side * (headX * windZ.alongZ - headZ * windX.alongZ);
    float firstX = (headX * windX.alongX + headZ * windZ.alongX) * record.turn.w - secondX * record.turn.z;
    float firstZ = (headX * windX.alongZ + headZ * windZ.alongZ) * record.turn.w - secondZ * record.turn.z;
    float sum = first + second;
    float share = second / sum;
    swWeightPair pair = swPairSmoothly(share);
    float alongX = (secondX - share * (firstX + secondX)) / sum;
    float alongZ = (secondZ - share * (firstZ + secondZ)) / sum;
    return swMakeChannel(pair.first, pair.firstSlope * alongX, pair.firstSlope * alongZ);
}

// Beyond the last speed: by how much the waves of it are higher or lower, and the derivative by the speed.
SW_FORMULA sw_vec2 swBendAmplitude(float speed, float own, float bend)
{
    float ratio = speed / own;
    sw_vec2 factor;
    factor.x = ratio * (1.0f + bend * (ratio - 1.0f));
    factor.y = (1.0f + bend * (2.0f * ratio - 1.0f)) / own;
    if (factor.x < 0.0f)
    {
        factor.x = 0.0f;
        factor.y = 0.0f;
    }
    return factor;
}

// Between two speeds: the weight of the system of one, and its derivative by the speed. The deviation of the waves'
// height over the speed runs evenly from one to the other; it is the same for both where heights grow with the speed,
// and is met exactly where they grow with its square. `other` is the deviation of the other's heights over its own.
SW_FORMULA sw_vec2 swMixAmplitudes(float speed, float own, float neighbour, float other)
{
    float way = (speed - own) / (neighbour - own);
    float perWay = 1.0f / (neighbour - own);
    swWeightPair pair = swPairSmoothly(way);
    float ratio = 1.0f / own + way * (other / neighbour - 1.0f / own);
    float ratioSlope = perWay * (other / neighbour - 1.0f / own);
    float asked = speed * ratio; // the deviation, over its own
    float askedSlope = ratio + speed * ratioSlope;
    float square = pair.first * pair.first + pair.second * pair.second * other * other;
    float squareSlope = 2.0f * perWay * (pair.first * pair.firstSlope + pair.second * pair.secondSlope * other * other);
    float length = SW_INPUT_SQRT(square);
    sw_vec2 weight;
    weight.x = pair.first * asked / length;
    weight.y =
        (perWay * pair.firstSlope * asked + pair.first * askedSlope) / length - 0.5f * weight.x * squareSlope / square;
    return weight;
}

SW_FORMULA sw_vec2 swFindSpeedWeight(swInputRecord record, float speed)
{
    float own = record.size.x;
    bool isAbove = speed > own;
    float neighbour = isAbove ? record.size.z : record.size.y;
    float other = isAbove ? record.value.w : record.value.z;
    if (neighbour <= 0.0f)
    {
        return swBendAmplitude(speed, own, other);
    }
    sw_vec2 weight;
    weight.x = 0.0f;
    weight.y = 0.0f;
    bool isBeyond = isAbove ? speed >= neighbour : speed <= neighbour;
    return isBeyond ? weight : swMixAmplitudes(speed, own, neighbour, other);
}

// How much of a record's system there is under a wind.
SW_FORMULA swInputChannel swFindWindWeight(swInputRecord record, swInputChannel windX, swInputChannel windZ)
{
    float square = windX.value * windX.value + windZ.value * windZ.value;
    if (square < SW_LEAST_REGION_WIND * SW_LEAST_REGION_WIND)
    {
        return swMakeChannel(0.0f, 0.0f, 0.0f);
    }
    float speed = SW_INPUT_SQRT(square);
    sw_vec2 weight = swFindSpeedWeight(record, speed);
    float slope = weight.y / speed;
    swInputChannel bySpeed = swMakeChannel(weight.x, slope * (windX.value * windX.alongX + windZ.value * windZ.alongX),
                                           slope * (windX.value * windX.alongZ + windZ.value * windZ.alongZ));
    return swMultiplyChannels(bySpeed, swFindHeadingWeight(record, windX, windZ));
}

// ---- joining ----

// Whether a record of waves weighs a system's.
SW_FORMULA bool swIsOfSystem(swInputRecord record, sw_uint system)
{
    return record.system == system || record.system == SW_ALL_SYSTEMS;
}

// Whether a record has a say in its field, of waves in the weight of a system.
SW_FORMULA bool swHasSay(swInputRecord record, sw_uint system)
{
    return record.field != SW_FIELD_OF_WAVES || swIsOfSystem(record, system) ||
           (record.flags & SW_INPUT_REMOVES_WAVES) != 0u;
}

// The weight of a system's waves once a record of the field WAVES, which has a say in it, has joined it.
SW_FORMULA swInputChannel swJoinWaves(swInputRecord record, sw_uint system, swInputChannel below, swInputSample s)
{
    swInputChannel own = swMakeChannel(s.value.x, s.valueX.x, s.valueZ.x);
    swInputChannel share = swMakeChannel(s.share, s.shareX, s.shareZ);
    if ((record.flags & SW_INPUT_TAKES_WIND) != 0u)
    {
        own = swFindWindWeight(record, own, swMakeChannel(s.value.y, s.valueX.y, s.valueZ.y));
    }
    if ((record.flags & (SW_INPUT_REMOVES_WAVES | SW_INPUT_TAKES_WIND)) == 0u)
    {
        return swBlendChannel(record, below, own, share);
    }
    swWeightPair pair = swPairWeights(share.value);
    swInputChannel left = below;
    if ((record.flags & SW_INPUT_REMOVES_WAVES) != 0u)
    {
        left = swMultiplyChannels(below, swMapChannel(share, pair.first, pair.firstSlope));
    }
    if (!swIsOfSystem(record, system))
    {
        return left;
    }
    return swAddChannels(left, swMultiplyChannels(own, swMapChannel(share, pair.second, pair.secondSlope)));
}

// What a field is once a record that has a say in it has joined it; `system` of waves.
SW_FORMULA swInputValue swJoinInput(swInputRecord record, sw_uint system, swInputValue below, swInputSample s)
{
    if (record.field != SW_FIELD_OF_WAVES)
    {
        return swBlendInput(record, below, s);
    }
    swInputValue joined = below;
    swInputChannel weight =
        swJoinWaves(record, system, swMakeChannel(below.value.x, below.alongX.x, below.alongZ.x), s);
    joined.value.x = weight.value;
    joined.alongX.x = weight.alongX;
    joined.alongZ.x = weight.alongZ;
    return joined;
}
#endif
