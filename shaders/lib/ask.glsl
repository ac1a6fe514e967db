// SPDX-License-Identifier: MIT
// What inputs say, asked for in one place. Compilers write out all shapes wherever an input is sampled, and those are
// most of a shader's code. So a shader that wants several things of inputs asks for one after the other in a loop, in
// which answer() stands once: an Ask says what it is about, where, and what the answers join.
//
// Before including: what lib/inputs.glsl wants, and the constants `bool WITH_DISPLACEMENT` (inputs may displace the
// water), WITH_RIBBONS (some waves run along splines) and WITH_HOLES (it asks about holes, too).
#ifndef SW_LIB_ASK
#define SW_LIB_ASK
#include "lib/inputs.glsl" // it says how words are read

#include "lib/places.glsl"
#include "lib/ribbons.glsl"
#include "shared/clip.h"
#include "shared/displace.h"

#define ASK_WAVES 0u  // what follows the waves joins their sum at rest
#define ASK_RATE 1u   // the same of a rate of displacement: inputs stand still, so only what scales the waves counts
#define ASK_HEIGHT 2u // what stays put changes the height where that has brought the particle
#define ASK_HOLE 3u   // how far the edge of holes is
#define ASK_FIELD 4u  // a field's value; from here on what the asker takes it for

struct Ask
{
    uint what, field, system;
    SeaPlace place;
    swDisplaceRange range;
    swInputChannel level; // of still water, for ASK_HEIGHT
    float y;              // of the surface, m above sea level, for ASK_HOLE
    swWaveLooks said;     // so far; of a height or a distance the first number
};

Ask beginAsk(uint what, uint field, SeaPlace place)
{
    Ask ask;
    ask.what = what;
    ask.field = field;
    ask.system = SW_ALL_SYSTEMS;
    ask.place = place;
    ask.range = swDisplaceRange(0.0, 0.0, 0.0);
    ask.level = swKeepChannel(0.0);
    ask.y = 0.0;
    ask.said = swWaveLooks(swInputValue(vec4(0.0), vec4(0.0), vec4(0.0)), swBeginLooks());
    return ask;
}

// `system` of waves.
Ask askField(uint what, uint field, uint system, SeaPlace place)
{
    Ask ask = beginAsk(what, field, place);
    ask.system = system;
    ask.said.plain = swGetFieldBelow(field);
    bool isLocal = field == SW_FIELD_OF_WAVES && isLocalSystem(system);
    ask.said.plain.value.x = isLocal ? 0.0 : ask.said.plain.value.x;
    return ask;
}

// The sum of the waves at a rest place; shorter records than `least` are left out.
Ask askWaves(SeaPlace rest, float least, swInputValue waves)
{
    Ask ask = beginAsk(ASK_WAVES, SW_FIELD_OF_DISPLACEMENT, rest);
    ask.range.least = least;
    ask.said.plain = waves;
    return ask;
}

// A rate of it. None of the inputs' own displacement is of this part of the waves.
Ask askRate(SeaPlace rest, float least, vec3 rate)
{
    Ask ask = beginAsk(ASK_RATE, SW_FIELD_OF_DISPLACEMENT, rest);
    ask.range = swDisplaceRange(least, 3e38, 0.0);
    ask.said.plain.value.xyz = rate;
    return ask;
}

// The height of a particle at a place, and its derivatives by that.
Ask askHeight(SeaPlace place, float least, swInputChannel level, swInputChannel height)
{
    Ask ask = beginAsk(ASK_HEIGHT, SW_FIELD_OF_DISPLACEMENT, place);
    ask.range.least = least;
    ask.level = level;
    ask.said.plain.value.x = height.value;
    ask.said.plain.alongX.x = height.alongX;
    ask.said.plain.alongZ.x = height.alongZ;
    return ask;
}

// The signed distance to the edge of holes; `y` is the height of the surface above sea level.
Ask askHole(SeaPlace place, float y)
{
    Ask ask = beginAsk(ASK_HOLE, SW_FIELD_OF_CLIP, place);
    ask.y = y;
    ask.said.plain.value.x = SW_CLIP_FAR;
    return ask;
}

// The first number and its slopes.
swInputChannel channelOf(Ask ask)
{
    return swMakeChannel(ask.said.plain.value.x, ask.said.plain.alongX.x, ask.said.plain.alongZ.x);
}

bool hasSay(Ask ask, swInputRecord record)
{
    if (WITH_DISPLACEMENT && ask.field == SW_FIELD_OF_DISPLACEMENT)
    {
        return swIsDisplacing(record, ask.range, ask.what != ASK_HEIGHT) && swDoesJoinPart(record, ask.range);
    }
    return swHasSay(record, ask.system);
}

// What a record says in its own coordinates, but for its weight; of one whose waves run along its spline their foot.
swLookSay sayOf(swInputRecord record, vec2 own)
{
    swLookSay say;
    say.waves.foot = swBeginFoot();
    say.waves.share = swKeepChannel(0.0);
    if (WITH_RIBBONS && swRunsAlong(record))
    {
        say.waves = swFindRibbonWaves(record.firstWord, record, own.x, own.y);
        say.says = swSayRibbonWaves(record, say.waves);
    }
    else
    {
        say.says = swSampleShape(record.firstWord, record, vec3(own.x, -record.size.w, own.y));
    }
    return say;
}

void join(inout Ask ask, swInputRecord record)
{
    vec2 own = swPlaceInInput(record, ask.place.cell.x, ask.place.cell.y, ask.place.rest.x, ask.place.rest.y);
    if (WITH_HOLES && ask.what == ASK_HOLE && swHasClipEdge(record.shape))
    {
        ask.said.plain.value.x = swJoinClipEdge(ask.said.plain.value.x, record.firstWord, record, own.x, ask.y, own.y);
        return;
    }
    swLookSay say = sayOf(record, own);
    if (WITH_HOLES && ask.what == ASK_HOLE)
    {
        ask.said.plain.value.x = swJoinClipValue(ask.said.plain.value.x, record, own.x, own.y, say.says);
        return;
    }
    say.says = swFinishInputSample(record, say.says);
    if (WITH_DISPLACEMENT && ask.what == ASK_HEIGHT)
    {
        swInputChannel height = swDisplaceHeight(record, channelOf(ask), ask.level, say.says);
        ask.said.plain.value.x = height.value;
        ask.said.plain.alongX.x = height.alongX;
        ask.said.plain.alongZ.x = height.alongZ;
        return;
    }
    if (WITH_DISPLACEMENT && ask.field == SW_FIELD_OF_DISPLACEMENT)
    {
        say.says = swSampleOfPart(record, ask.range, say.says);
    }
    ask.said = swJoinLooks(record.firstWord, record, ask.system, ask.said, say);
}

// The one place where inputs are sampled.
void answer(inout Ask ask)
{
    uint i = findInput(ask.field, ask.place.cell, ask.place.cell, 0);
    while (i != SW_NO_RECORD)
    {
        swInputRecord record = inputRecords[i];
        if (hasSay(ask, record))
        {
            join(ask, record);
        }
        i = findInput(ask.field, ask.place.cell, ask.place.cell, i + 1);
    }
}
#endif
