// SPDX-License-Identifier: MIT
// Inputs that displace the water: how a record of the field DISPLACEMENT joins what the waves do.
//
// Those that follow the waves are read where particles rest and join the sum of the waves there, all three numbers of
// it: they are added, mixed in, or scale what there is. The others are read where particles are, and change the height
// alone, so that no water stands above a hull wherever the waves have brought it from. Heights that are set, or that
// are not to be exceeded, are those of the record's own origin and value, not counted from still water.
//
// A record has the length of the waves that it is like. A slice or a query whose shortest wave is longer leaves it out,
// as it leaves out a band of waves: so it counts once, and in no slice that cannot hold it.
#ifndef SW_SHARED_DISPLACE_H
#define SW_SHARED_DISPLACE_H
#include "channels.h"
#include "input_shapes.h"

// The waves that are asked for, m. `shortest` 0: all. Of `longest`, which a search has that sums up waves in parts, 0
// is no bound; what adds to the waves counts in one part only, what scales them in each.
SW_PARAMS(swDisplaceRange)
{
    float least;             // of the slice or the query: shorter records are left out
    float shortest, longest; // of the part
};

SW_FORMULA bool swIsDisplacing(swInputRecord record, swDisplaceRange range, bool isAtRest)
{
    bool follows = (record.flags & SW_INPUT_FOLLOWS_WAVES) != 0u;
    float length = record.value.w;
    return follows == isAtRest && (length <= 0.0f || length >= range.least);
}

// Whether a record's own displacement counts in this part of the waves.
SW_FORMULA bool swIsOfPart(swInputRecord record, swDisplaceRange range)
{
    float length = record.value.w;
    return (range.shortest <= 0.0f || length > range.shortest) && (range.longest <= 0.0f || length <= range.longest);
}

// At rest: whether a record joins this part of the waves. Which of two is greater is for the whole to say.
SW_FORMULA bool swDoesJoinPart(swInputRecord record, swDisplaceRange range)
{
    bool isPart = range.shortest > 0.0f || range.longest > 0.0f;
    return !isPart || (record.blend != SW_JOIN_MIN && record.blend != SW_JOIN_MAX);
}

// What of it joins.
SW_FORMULA swInputSample swSampleOfPart(swInputRecord record, swDisplaceRange range, swInputSample s)
{
    if (!swIsOfPart(record, range) && record.blend != SW_JOIN_MULTIPLY)
    {
        s.value = swNoValue();
        s.valueX = swNoValue();
        s.valueZ = swNoValue();
    }
    return s;
}

// The waves' displacement and its derivatives, once a record has joined them at rest.
SW_FORMULA swInputValue swDisplaceAtRest(swInputRecord record, swDisplaceRange range, swInputValue waves,
                                         swInputSample s)
{
    if (!swDoesJoinPart(record, range))
    {
        return waves;
    }
    return swBlendInput(record, waves, swSampleOfPart(record, range, s));
}

// Where a particle is: its height above still water, once a record has joined it. `level` is that of still water there,
// m above sea level. Derivatives are by the place.
SW_FORMULA swInputChannel swDisplaceHeight(swInputRecord record, swInputChannel height, swInputChannel level,
                                           swInputSample s)
{
    swInputChannel own = swMakeChannel(s.value.y, s.valueX.y, s.valueZ.y);
    swInputChannel share = swMakeChannel(s.share, s.shareX, s.shareZ);
    if (record.blend != SW_JOIN_ADD && record.blend != SW_JOIN_MULTIPLY)
    {
        own = swSubtractChannels(swAddChannels(own, swKeepChannel(record.size.w)), level);
    }
    return swBlendChannel(record, height, own, share);
}
#endif
