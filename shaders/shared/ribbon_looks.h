// SPDX-License-Identifier: MIT
// How a system's waves are looked up at a place where some of them run along splines: plainly, and in the coordinates
// of ribbons. Records join in their order; what lies above takes away from all below, as it does from any field.
#ifndef SW_SHARED_RIBBON_LOOKS_H
#define SW_SHARED_RIBBON_LOOKS_H
#include "input_shapes.h"
#include "region.h"

// Waves in the coordinates of a ribbon.
SW_PARAMS(swRibbonLook)
{
    swInputChannel weight; // by x and z of the sea
    swRibbonSource source;
};

// Where more than two overlap, the two of the most weight count. Those that are not there have no weight.
SW_PARAMS(swRibbonLooks)
{
    swRibbonLook first, second;
};

SW_FORMULA swRibbonLook swBeginLook(void)
{
    swRibbonLook look;
    look.weight = swKeepChannel(0.0f);
    look.source.cellX = 0;
    look.source.cellZ = 0;
    look.source.restX = 0.0f;
    look.source.restZ = 0.0f;
    look.source.way = swNoValue();
    look.source.cosine = 1.0f;
    look.source.sine = 0.0f;
    look.source.turnX = 0.0f;
    look.source.turnZ = 0.0f;
    return look;
}

SW_FORMULA swRibbonLooks swBeginLooks(void)
{
    swRibbonLooks looks;
    looks.first = swBeginLook();
    looks.second = swBeginLook();
    return looks;
}

SW_FORMULA swRibbonLooks swAddLook(swRibbonLooks looks, swRibbonLook look)
{
    if (look.weight.value > looks.first.weight.value)
    {
        looks.second = looks.first;
        looks.first = look;
    }
    else if (look.weight.value > looks.second.weight.value)
    {
        looks.second = look;
    }
    return looks;
}

// What a record leaves of waves below it that are not its own to change.
SW_FORMULA swInputChannel swLeaveBelow(swInputRecord record, swInputSample s)
{
    swInputChannel one = swKeepChannel(1.0f);
    swInputChannel share = swMakeChannel(s.share, s.shareX, s.shareZ);
    if ((record.flags & SW_INPUT_REMOVES_WAVES) != 0u)
    {
        swWeightPair pair = swPairWeights(s.share);
        return swMapChannel(share, pair.first, pair.firstSlope);
    }
    if (record.blend == SW_JOIN_ALPHA)
    {
        return swMixChannels(one, swKeepChannel(0.0f), share);
    }
    if (record.blend == SW_JOIN_MULTIPLY)
    {
        return swMixChannels(one, swMakeChannel(s.value.x, s.valueX.x, s.valueZ.x), share);
    }
    if (record.blend == SW_JOIN_REPLACE && s.share > 0.0f)
    {
        return swKeepChannel(0.0f);
    }
    return one;
}

// Waves of a record that run along its spline.
SW_FORMULA swRibbonLooks swLookAlong(SW_WORDS words, swInputRecord record, swRibbonLooks looks, swRibbonWaves waves)
{
    if (waves.share.value <= 0.0f)
    {
        return looks;
    }
    swInputChannel share = swScaleChannel(waves.share, record.weight);
    if ((record.flags & SW_INPUT_REMOVES_WAVES) != 0u)
    {
        swWeightPair pair = swPairWeights(share.value);
        share = swMapChannel(share, pair.second, pair.secondSlope);
    }
    swInputChannel weight = swScaleChannel(share, record.value.x + record.gain);
    float seam = SW_WORD(words, SW_RIBBON_SEAM);
    bool isSeam = seam > 0.0f && swMeasureAlong(words, waves.foot).value < seam;
    for (int lap = 0; lap < (isSeam ? 2 : 1); ++lap)
    {
        swRibbonLook look;
        look.weight = weight;
        if (isSeam)
        {
            look.weight = swMultiplyChannels(weight, swCrossSeam(words, waves.foot, lap == 1));
        }
        sw_vec2 turned = swTurnInputGradient(record, look.weight.alongX, look.weight.alongZ);
        look.weight.alongX = turned.x;
        look.weight.alongZ = turned.y;
        look.source = swPlaceRibbonWaves(words, record, waves.foot, record.part0, record.part1, SW_FLOAT(lap));
        looks = swAddLook(looks, look);
    }
    return looks;
}

// A system's waves at a place: the weight of those that lie as ever, and the others.
SW_PARAMS(swWaveLooks)
{
    swInputValue plain;
    swRibbonLooks ribbons;
};

// What a record says at a place: finished, and of one whose waves run along its spline the foot that counts, found once
// for what is taken from below and for what is added.
SW_PARAMS(swLookSay)
{
    swInputSample says;
    swRibbonWaves waves;
};

SW_FORMULA swLookSay swSampleLook(SW_WORDS words, swInputRecord record, sw_int cellX, sw_int cellZ, float restX,
                                  float restZ)
{
    sw_vec2 across = swPlaceInInput(record, cellX, cellZ, restX, restZ);
    swLookSay say;
    say.waves.foot = swBeginFoot();
    say.waves.share = swKeepChannel(0.0f);
    if (swRunsAlong(record))
    {
        say.waves = swFindRibbonWaves(words, record, across.x, across.y);
        say.says = swSayRibbonWaves(record, say.waves);
    }
    else
    {
        sw_vec3 own;
        own.x = across.x;
        own.y = -record.size.w;
        own.z = across.y;
        say.says = swSampleShape(words, record, own);
    }
    say.says = swFinishInputSample(record, say.says);
    return say;
}

// A record that has a say in a field, of waves in those of a system, joins what is below it.
SW_FORMULA swWaveLooks swJoinLooks(SW_WORDS words, swInputRecord record, sw_uint system, swWaveLooks looks,
                                   swLookSay say)
{
    bool isAlong = swRunsAlong(record);
    swInputSample s = say.says;
    if (s.share <= 0.0f)
    {
        return looks;
    }
    swInputChannel left = swLeaveBelow(record, s);
    looks.ribbons.first.weight = swMultiplyChannels(looks.ribbons.first.weight, left);
    looks.ribbons.second.weight = swMultiplyChannels(looks.ribbons.second.weight, left);
    if (!isAlong)
    {
        looks.plain = swJoinInput(record, system, looks.plain, s);
        return looks;
    }
    swInputChannel plain =
        swMultiplyChannels(swMakeChannel(looks.plain.value.x, looks.plain.alongX.x, looks.plain.alongZ.x), left);
    looks.plain.value.x = plain.value;
    looks.plain.alongX.x = plain.alongX;
    looks.plain.alongZ.x = plain.alongZ;
    if (!swIsOfSystem(record, system))
    {
        return looks;
    }
    looks.ribbons = swLookAlong(words, record, looks.ribbons, say.waves);
    return looks;
}
#endif
