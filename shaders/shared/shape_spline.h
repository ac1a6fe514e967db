// SPDX-License-Identifier: MIT
// A ribbon along a spline: what a place beside the line says, and coordinates along and across it.
//
// A place P has a foot at c(a) on the line, a being the length along it, where it lies straight beside it:
// (P - c) . c' = 0, and where no place of the line near there is nearer. With the tangent T and the normal N to the
// left, P = c + n N, n being its distance to the side. Derivatives are exact: da = T / m, dn = N, where m = 1 - k n and
// k is the curvature, above 0 to the left. So what is a metre long on the line is m metres long beside it. Within a
// segment the foot is found by Newton's method; the line is smooth to its second derivative, so that a, n and their
// derivatives pass from segment to segment without a step.
//
// A place may have several feet: inside of bends that are narrower than the ribbon (m reaches 0 where feet appear), and
// where a line comes near itself. Values are then mixed by how far the feet are from the ribbon's edges and from the
// centres of their bends, both of which reach 0 where a foot appears, so that nothing jumps. Waves are those of one
// foot, and fade to nothing where another one is as good.
#ifndef SW_SHARED_SHAPE_SPLINE_H
#define SW_SHARED_SHAPE_SPLINE_H
#include "channels.h"
#include "input.h"

// ---- words ----

// Numbers of the whole, all floats; whole numbers are exact.
#define SW_RIBBON_SEGMENTS 0 // how many
#define SW_RIBBON_IS_CLOSED 1
#define SW_RIBBON_LEFT 2 // where the ribbon's edges are, as parts of its width there, m
#define SW_RIBBON_RIGHT 3
#define SW_RIBBON_START_RAMP 4 // m
#define SW_RIBBON_END_RAMP 5
#define SW_RIBBON_LENGTH 6
#define SW_RIBBON_GRID_X 7 // corner of the grid of cells, m
#define SW_RIBBON_GRID_Z 8
#define SW_RIBBON_CELL 9 // m
#define SW_RIBBON_COLUMNS 10
#define SW_RIBBON_ROWS 11
#define SW_RIBBON_SPANS 12 // first words of what follows
#define SW_RIBBON_KNOTS 13
#define SW_RIBBON_CELLS 14 // first word of each cell's list, and the end of the last one
#define SW_RIBBON_SEAM 15  // m from a closed line's first point on: there waves of its end fade into those of its start
#define SW_RIBBON_LENGTH_CELL 16 // the length once more: cells of SW_QUERY_CELL and the rest
#define SW_RIBBON_LENGTH_REST 17
#define SW_RIBBON_HEAD 18

// Of each knot: where a segment begins. One more stands at the end.
#define SW_KNOT_X 0
#define SW_KNOT_Z 1
#define SW_KNOT_TANGENT_X 2
#define SW_KNOT_TANGENT_Z 3
#define SW_KNOT_BEND_X 4 // second derivative, 1/m; linear along a segment
#define SW_KNOT_BEND_Z 5
#define SW_KNOT_SPAN 6
#define SW_KNOT_STEP 7     // length of its segment, m
#define SW_KNOT_ALONG 8    // where it begins, from its span's beginning, m
#define SW_KNOT_IS_TIGHT 9 // 1 where feet may appear within its segment
#define SW_KNOT_WORDS 10

// Of each span, from a point to the next. Of pairs, the second is at the span's end.
#define SW_SPAN_FIRST_KNOT 0
#define SW_SPAN_LENGTH 1
#define SW_SPAN_CELL 2 // how far along the line it begins: cells of SW_QUERY_CELL and the rest, m
#define SW_SPAN_REST 3
#define SW_SPAN_HEIGHT 4
#define SW_SPAN_SLOPE 6
#define SW_SPAN_WIDTH 8
#define SW_SPAN_WEIGHT 10
#define SW_SPAN_FLOW 12
#define SW_SPAN_FOAM 14
#define SW_SPAN_LEVEL 16
#define SW_SPAN_DEPTH 18
#define SW_SPAN_WORDS 20

// ---- feet ----

SW_PARAMS(swFoot)
{
    sw_uint span;
    float along;              // m, from the span's beginning
    float tangentX, tangentZ; // of length 1
    float curvature;          // 1/m
    float ahead;              // derivative of `along` by metres along the tangent
    swInputChannel aside;     // m, to the left
    swInputChannel stretch;   // m above: 1 on the line, 0 at the centre of a bend
};

SW_FORMULA swFoot swBeginFoot(void)
{
    swFoot foot;
    foot.span = 0u;
    foot.along = 0.0f;
    foot.tangentX = 1.0f;
    foot.tangentZ = 0.0f;
    foot.curvature = 0.0f;
    foot.ahead = 1.0f;
    foot.aside = swKeepChannel(0.0f);
    foot.stretch = swKeepChannel(1.0f);
    return foot;
}

// How far a place is ahead of a knot.
SW_FORMULA float swPassKnot(SW_WORDS words, sw_uint knot, float x, float z)
{
    return (x - SW_WORD(words, knot + SW_KNOT_X)) * SW_WORD(words, knot + SW_KNOT_TANGENT_X) +
           (z - SW_WORD(words, knot + SW_KNOT_Z)) * SW_WORD(words, knot + SW_KNOT_TANGENT_Z);
}

// The first derivative of the squared distance from a place to the line, halved and the other way round, and its
// derivative, likewise: both at `a` metres from a knot. A foot is where the first passes from above 0 to below.
SW_PARAMS(swFootSearch)
{
    float pull;  // way to the place . c'
    float slope; // c' . c' - way . c'', m on the line
    float wayX, wayZ, dx, dz, ddx, ddz;
};

SW_FORMULA swFootSearch swSearchFoot(SW_WORDS words, sw_uint knot, float x, float z, float a)
{
    float step = SW_WORD(words, knot + SW_KNOT_STEP);
    float tx = SW_WORD(words, knot + SW_KNOT_TANGENT_X);
    float tz = SW_WORD(words, knot + SW_KNOT_TANGENT_Z);
    float bx = SW_WORD(words, knot + SW_KNOT_BEND_X);
    float bz = SW_WORD(words, knot + SW_KNOT_BEND_Z);
    float jx = (SW_WORD(words, knot + SW_KNOT_WORDS + SW_KNOT_BEND_X) - bx) / step;
    float jz = (SW_WORD(words, knot + SW_KNOT_WORDS + SW_KNOT_BEND_Z) - bz) / step;
    swFootSearch search;
    search.wayX = (x - SW_WORD(words, knot + SW_KNOT_X)) - a * (tx + a * (bx * 0.5f + a * jx * (1.0f / 6.0f)));
    search.wayZ = (z - SW_WORD(words, knot + SW_KNOT_Z)) - a * (tz + a * (bz * 0.5f + a * jz * (1.0f / 6.0f)));
    search.dx = tx + a * (bx + a * jx * 0.5f);
    search.dz = tz + a * (bz + a * jz * 0.5f);
    search.ddx = bx + a * jx;
    search.ddz = bz + a * jz;
    search.pull = search.wayX * search.dx + search.wayZ * search.dz;
    search.slope =
        search.dx * search.dx + search.dz * search.dz - (search.wayX * search.ddx + search.wayZ * search.ddz);
    return search;
}

// Where on a segment a foot may be, m from its knot; `from` is above `to` if there is none.
SW_PARAMS(swFootPlace)
{
    float from, guess, to;
};

SW_FORMULA swFootPlace swMakeFootPlace(float from, float guess, float to)
{
    swFootPlace place;
    place.from = from;
    place.guess = guess;
    place.to = to;
    return place;
}

// Within a tight segment, a foot and a farthest place may stand beside each other, between which the pull turns round.
SW_FORMULA swFootPlace swBracketNewFoot(SW_WORDS words, sw_uint knot, float x, float z, float ahead, float beyond)
{
    float step = SW_WORD(words, knot + SW_KNOT_STEP);
    float first = swSearchFoot(words, knot, x, z, 0.0f).slope;
    float last = swSearchFoot(words, knot, x, z, step).slope;
    bool rises = ahead < 0.0f && first < 0.0f && last > 0.0f;
    bool falls = ahead >= 0.0f && first > 0.0f && last < 0.0f;
    if (!rises && !falls)
    {
        return swMakeFootPlace(1.0f, 0.0f, 0.0f);
    }
    float low = 0.0f;
    float high = step;
    float turn = step * (first / (first - last));
    for (int i = 0; i < 3; ++i)
    {
        float slope = swSearchFoot(words, knot, x, z, turn).slope;
        if ((slope < 0.0f) == rises)
        {
            low = turn;
            first = slope;
        }
        else
        {
            high = turn;
            last = slope;
        }
        turn = low + (high - low) * (first / (first - last));
    }
    float pull = swSearchFoot(words, knot, x, z, turn).pull;
    if (rises && pull >= 0.0f)
    {
        return swMakeFootPlace(turn, turn + (step - turn) * SW_INPUT_SQRT(pull / (pull - beyond)), step);
    }
    if (falls && pull < 0.0f)
    {
        return swMakeFootPlace(0.0f, turn - turn * SW_INPUT_SQRT(pull / (pull - ahead)), turn);
    }
    return swMakeFootPlace(1.0f, 0.0f, 0.0f);
}

// Whether and where a place has a foot on the segment that begins at a knot. It does if it is ahead of it and not of
// the next one.
SW_FORMULA swFootPlace swBracketFoot(SW_WORDS words, sw_uint knot, float x, float z)
{
    float ahead = swPassKnot(words, knot, x, z);
    float beyond = swPassKnot(words, knot + SW_KNOT_WORDS, x, z);
    if (ahead >= 0.0f && beyond < 0.0f)
    {
        float step = SW_WORD(words, knot + SW_KNOT_STEP);
        return swMakeFootPlace(0.0f, step * (ahead / (ahead - beyond)), step);
    }
    if (SW_WORD(words, knot + SW_KNOT_IS_TIGHT) > 0.0f && (ahead < 0.0f) == (beyond < 0.0f))
    {
        return swBracketNewFoot(words, knot, x, z, ahead, beyond);
    }
    return swMakeFootPlace(1.0f, 0.0f, 0.0f);
}

// The foot there, by Newton's method held within where it has to be.
SW_FORMULA swFoot swFindFoot(SW_WORDS words, sw_uint knot, float x, float z, swFootPlace place)
{
    float a = place.guess;
    float low = place.from;
    float high = place.to;
    swFootSearch search = swSearchFoot(words, knot, x, z, a);
    for (int i = 0; i < 5; ++i)
    {
        if (search.pull >= 0.0f)
        {
            low = a;
        }
        else
        {
            high = a;
        }
        float next = search.slope > 1e-3f ? a + search.pull / search.slope : low - 1.0f;
        if (!(next >= low && next <= high))
        {
            next = 0.5f * (low + high);
        }
        a = next;
        search = swSearchFoot(words, knot, x, z, a);
    }
    float step = SW_WORD(words, knot + SW_KNOT_STEP);
    float jx = (SW_WORD(words, knot + SW_KNOT_WORDS + SW_KNOT_BEND_X) - SW_WORD(words, knot + SW_KNOT_BEND_X)) / step;
    float jz = (SW_WORD(words, knot + SW_KNOT_WORDS + SW_KNOT_BEND_Z) - SW_WORD(words, knot + SW_KNOT_BEND_Z)) / step;
    float dx = search.dx;
    float dz = search.dz;
    float ddx = search.ddx;
    float ddz = search.ddz;
    float wayX = search.wayX;
    float wayZ = search.wayZ;
    float speed = SW_INPUT_SQRT(dx * dx + dz * dz);
    swFoot foot;
    foot.span = SW_UINT(SW_WORD(words, knot + SW_KNOT_SPAN));
    foot.tangentX = dx / speed;
    foot.tangentZ = dz / speed;
    // The normal to the left is (tangentZ, -tangentX).
    foot.aside.value = wayX * foot.tangentZ - wayZ * foot.tangentX;
    foot.aside.alongX = foot.tangentZ;
    foot.aside.alongZ = -foot.tangentX;
    foot.curvature = (ddx * foot.tangentZ - ddz * foot.tangentX) / (speed * speed);
    float turn = (jx * foot.tangentZ - jz * foot.tangentX) / (speed * speed) -
                 3.0f * foot.curvature * (ddx * foot.tangentX + ddz * foot.tangentZ) / speed; // of curvature, by a
    float stretch = 1.0f - foot.curvature * foot.aside.value;
    foot.ahead = 1.0f / (speed * (stretch > 0.02f ? stretch : 0.02f));
    foot.stretch.value = stretch;
    float alongTangent = -foot.aside.value * turn * foot.ahead;
    foot.stretch.alongX = alongTangent * foot.tangentX - foot.curvature * foot.aside.alongX;
    foot.stretch.alongZ = alongTangent * foot.tangentZ - foot.curvature * foot.aside.alongZ;
    foot.along = SW_WORD(words, knot + SW_KNOT_ALONG) + a;
    return foot;
}

// ---- numbers of points ----

// A function of the place along the line by its derivative by metres of the line.
SW_FORMULA swInputChannel swRunAlong(swFoot foot, float value, float slope)
{
    float ahead = slope * foot.ahead;
    return swMakeChannel(value, ahead * foot.tangentX, ahead * foot.tangentZ);
}

// One of the pairs of a span, blended.
SW_FORMULA swInputChannel swReadAlong(SW_WORDS words, swFoot foot, sw_uint pair)
{
    sw_uint span = SW_UINT(SW_WORD(words, SW_RIBBON_SPANS)) + foot.span * SW_SPAN_WORDS;
    float length = SW_WORD(words, span + SW_SPAN_LENGTH);
    float from = SW_WORD(words, span + pair);
    float way = SW_WORD(words, span + pair + 1u) - from;
    float t = foot.along / length;
    t = t < 1.0f ? t : 1.0f;
    return swRunAlong(foot, from + way * (t * t * (3.0f - 2.0f * t)), way * 6.0f * t * (1.0f - t) / length);
}

// Height of the line: a cubic by its heights and slopes at both ends of the span.
SW_FORMULA swInputChannel swReadHeightAlong(SW_WORDS words, swFoot foot)
{
    sw_uint span = SW_UINT(SW_WORD(words, SW_RIBBON_SPANS)) + foot.span * SW_SPAN_WORDS;
    float length = SW_WORD(words, span + SW_SPAN_LENGTH);
    float from = SW_WORD(words, span + SW_SPAN_HEIGHT);
    float way = SW_WORD(words, span + SW_SPAN_HEIGHT + 1u) - from;
    float leaves = SW_WORD(words, span + SW_SPAN_SLOPE) * length;
    float reaches = SW_WORD(words, span + SW_SPAN_SLOPE + 1u) * length;
    float t = foot.along / length;
    t = t < 1.0f ? t : 1.0f;
    float s = 1.0f - t;
    float height = from + way * (t * t * (3.0f - 2.0f * t)) + (leaves * s - reaches * t) * (s * t);
    float slope = way * 6.0f * t * s + leaves * s * (1.0f - 3.0f * t) + reaches * t * (3.0f * t - 2.0f);
    return swRunAlong(foot, height, slope / length);
}

// How far along all of the line, m.
SW_FORMULA swInputChannel swMeasureAlong(SW_WORDS words, swFoot foot)
{
    sw_uint span = SW_UINT(SW_WORD(words, SW_RIBBON_SPANS)) + foot.span * SW_SPAN_WORDS;
    float start = SW_WORD(words, span + SW_SPAN_CELL) * SW_QUERY_CELL + SW_WORD(words, span + SW_SPAN_REST);
    return swRunAlong(foot, start + foot.along, 1.0f);
}

// ---- the ribbon ----

// What counts of a foot.
SW_PARAMS(swRibbon)
{
    swInputChannel cover; // 0 outside of the ribbon, 1 within the feather
    swInputChannel count; // how good a foot it is among several
};

SW_FORMULA swInputChannel swFeatherChannel(swInputChannel inside, float feather)
{
    sw_vec2 share = swFeatherInput(inside.value, feather);
    return swMapChannel(inside, share.x, share.y);
}

// At the ends of an open line a ramp, and feet that appear there do not count yet.
SW_FORMULA swRibbon swEndRibbon(SW_WORDS words, swFoot foot, swRibbon ribbon, float width)
{
    swInputChannel fromStart = swMeasureAlong(words, foot);
    swInputChannel toEnd = swSubtractChannels(swKeepChannel(SW_WORD(words, SW_RIBBON_LENGTH)), fromStart);
    float startRamp = SW_WORD(words, SW_RIBBON_START_RAMP);
    float endRamp = SW_WORD(words, SW_RIBBON_END_RAMP);
    if (startRamp > 0.0f)
    {
        ribbon.cover = swMultiplyChannels(ribbon.cover, swFeatherChannel(fromStart, startRamp));
    }
    if (endRamp > 0.0f)
    {
        ribbon.cover = swMultiplyChannels(ribbon.cover, swFeatherChannel(toEnd, endRamp));
    }
    ribbon.count = swMultiplyChannels(ribbon.count, swRiseChannel(fromStart, 0.0f, 0.25f * width));
    ribbon.count = swMultiplyChannels(ribbon.count, swRiseChannel(toEnd, 0.0f, 0.25f * width));
    return ribbon;
}

SW_FORMULA swRibbon swCoverRibbon(SW_WORDS words, swFoot foot, float feather)
{
    swInputChannel factor = swReadAlong(words, foot, SW_SPAN_WIDTH);
    swInputChannel left = swSubtractChannels(swScaleChannel(factor, SW_WORD(words, SW_RIBBON_LEFT)), foot.aside);
    swInputChannel right = swAddChannels(swScaleChannel(factor, SW_WORD(words, SW_RIBBON_RIGHT)), foot.aside);
    swRibbon ribbon;
    ribbon.cover = swKeepChannel(0.0f);
    ribbon.count = swKeepChannel(0.0f);
    swInputChannel width = swAddChannels(left, right);
    if (left.value < 0.0f || right.value < 0.0f || width.value < 1e-4f)
    {
        return ribbon;
    }
    ribbon.cover = swMultiplyChannels(swFeatherChannel(left, feather), swFeatherChannel(right, feather));
    // 1 in the middle of the ribbon, 0 at its edges.
    swInputChannel middle =
        swMultiplyChannels(swDivideChannels(swScaleChannel(left, 4.0f), width), swDivideChannels(right, width));
    ribbon.count = swMultiplyChannels(middle, middle);
    if (SW_WORD(words, SW_RIBBON_IS_CLOSED) == 0.0f)
    {
        ribbon = swEndRibbon(words, foot, ribbon, width.value);
    }
    ribbon.count = swMultiplyChannels(ribbon.count, ribbon.cover);
    return ribbon;
}

// ---- cells ----

// Lists of segments whose ribbon may reach a cell. Words of the first segment and behind the last one.
SW_PARAMS(swSegmentList)
{
    sw_uint first, end;
};

SW_FORMULA swSegmentList swListSegments(SW_WORDS words, float x, float z)
{
    float column = (x - SW_WORD(words, SW_RIBBON_GRID_X)) / SW_WORD(words, SW_RIBBON_CELL);
    float row = (z - SW_WORD(words, SW_RIBBON_GRID_Z)) / SW_WORD(words, SW_RIBBON_CELL);
    swSegmentList list;
    list.first = 0u;
    list.end = 0u;
    if (column >= 0.0f && row >= 0.0f && column < SW_WORD(words, SW_RIBBON_COLUMNS) &&
        row < SW_WORD(words, SW_RIBBON_ROWS))
    {
        sw_uint cell = SW_UINT(SW_WORD(words, SW_RIBBON_CELLS)) +
                       SW_UINT(row) * SW_UINT(SW_WORD(words, SW_RIBBON_COLUMNS)) + SW_UINT(column);
        list.first = SW_UINT(SW_WORD(words, cell));
        list.end = SW_UINT(SW_WORD(words, cell + 1u));
    }
    return list;
}

// The knot where a listed segment begins.
SW_FORMULA sw_uint swGetKnot(SW_WORDS words, sw_uint listed)
{
    return SW_UINT(SW_WORD(words, SW_RIBBON_KNOTS)) + SW_UINT(SW_WORD(words, listed)) * SW_KNOT_WORDS;
}

// ---- what a ribbon says ----

// What one foot or several say together.
SW_PARAMS(swRibbonMix)
{
    swInputChannel value, other; // of flow its x and z, else `other` is not used
    swInputChannel weight;
    swInputChannel count;
    swInputChannel mostCover; // among feet that have grown up
    swInputChannel nearCover; // of the nearest place of the line, be it a foot or an end
    swInputChannel near;      // its distance, m
};

SW_FORMULA swRibbonMix swBeginRibbonMix(void)
{
    swRibbonMix mix;
    mix.value = swKeepChannel(0.0f);
    mix.other = mix.value;
    mix.weight = mix.value;
    mix.count = mix.value;
    mix.mostCover = mix.value;
    mix.nearCover = mix.value;
    mix.near = swKeepChannel(1e9f);
    return mix;
}

// What a field is told by a foot, without the record's own value.
SW_FORMULA swRibbonMix swReadRibbon(SW_WORDS words, swInputRecord record, swFoot foot, swRibbon ribbon)
{
    swRibbonMix mix;
    swInputChannel grown = swRiseChannel(foot.stretch, 0.05f, 0.4f);
    mix.value = swKeepChannel(1.0f);
    mix.other = swKeepChannel(0.0f);
    mix.weight = swReadAlong(words, foot, SW_SPAN_WEIGHT);
    // Where all feet are near the centres of their bends, one of them still has to be the best.
    mix.count = swMultiplyChannels(ribbon.count, swAddChannels(grown, swKeepChannel(1e-3f)));
    mix.mostCover = swMultiplyChannels(ribbon.cover, grown);
    mix.nearCover = ribbon.cover;
    mix.near = swScaleChannel(foot.aside, foot.aside.value < 0.0f ? -1.0f : 1.0f);
    if (record.field == SW_FIELD_OF_LEVEL)
    {
        mix.value = swAddChannels(swReadHeightAlong(words, foot), swReadAlong(words, foot, SW_SPAN_LEVEL));
    }
    else if (record.field == SW_FIELD_OF_FLOOR)
    {
        mix.value = swSubtractChannels(swReadHeightAlong(words, foot), swReadAlong(words, foot, SW_SPAN_DEPTH));
    }
    else if (record.field == SW_FIELD_OF_FOAM)
    {
        mix.value = swReadAlong(words, foot, SW_SPAN_FOAM);
    }
    else if (record.field == SW_FIELD_OF_FLOW)
    {
        // The tangent turns by the curvature: dT = k N ds.
        swInputChannel flow = swReadAlong(words, foot, SW_SPAN_FLOW);
        swInputChannel tangentX = swRunAlong(foot, foot.tangentX, foot.curvature * foot.tangentZ);
        swInputChannel tangentZ = swRunAlong(foot, foot.tangentZ, -foot.curvature * foot.tangentX);
        mix.value = swMultiplyChannels(flow, tangentX);
        mix.other = swMultiplyChannels(flow, tangentZ);
        // About the centre of a bend it has no direction.
        mix.weight = swMultiplyChannels(mix.weight, grown);
    }
    return mix;
}

// The nearest place's cover, mixed where another one is nearly as near.
SW_FORMULA swRibbonMix swMixNear(swRibbonMix mix, swInputChannel cover, swInputChannel near)
{
    bool isNearer = near.value < mix.near.value;
    swInputChannel nearer = mix.near;
    swInputChannel farther = near;
    swInputChannel nearerCover = mix.nearCover;
    swInputChannel fartherCover = cover;
    if (isNearer)
    {
        nearer = near;
        farther = mix.near;
        nearerCover = cover;
        fartherCover = mix.nearCover;
    }
    swInputChannel way = swSubtractChannels(farther, nearer);
    swInputChannel size = swAddChannels(nearer, swKeepChannel(0.01f));
    swInputChannel share = swRiseChannel(swDivideChannels(way, size), -0.25f, 0.25f);
    share = swSubtractChannels(swKeepChannel(1.0f), share);
    mix.near = nearer;
    mix.nearCover = swMixChannels(nearerCover, fartherCover, share);
    return mix;
}

SW_FORMULA swRibbonMix swMixRibbons(swRibbonMix a, swRibbonMix b)
{
    swRibbonMix mix = swMixNear(a, b.nearCover, b.near);
    mix.count = swAddChannels(a.count, b.count);
    if (mix.count.value > 1e-12f)
    {
        swInputChannel share = swDivideChannels(b.count, mix.count);
        mix.value = swMixChannels(a.value, b.value, share);
        mix.other = swMixChannels(a.other, b.other, share);
        mix.weight = swMixChannels(a.weight, b.weight, share);
    }
    if (b.mostCover.value > a.mostCover.value)
    {
        mix.mostCover = b.mostCover;
    }
    return mix;
}

// An end of an open line is a place of it where nothing is covered.
SW_FORMULA swRibbonMix swMixEnd(SW_WORDS words, swRibbonMix mix, sw_uint knot, float x, float z)
{
    float wayX = x - SW_WORD(words, knot + SW_KNOT_X);
    float wayZ = z - SW_WORD(words, knot + SW_KNOT_Z);
    float way = SW_INPUT_SQRT(wayX * wayX + wayZ * wayZ) + 1e-6f;
    return swMixNear(mix, swKeepChannel(0.0f), swMakeChannel(way, wayX / way, wayZ / way));
}

// What the spline brings is added to the record's own value.
SW_FORMULA swInputSample swFinishRibbon(swInputRecord record, swRibbonMix mix)
{
    swInputSample s = swBeginInputSample(record);
    swInputChannel cover = mix.nearCover;
    if (mix.mostCover.value > cover.value)
    {
        cover = mix.mostCover;
    }
    swInputChannel share = swMultiplyChannels(cover, mix.weight);
    s.share = share.value;
    s.shareX = share.alongX;
    s.shareZ = share.alongZ;
    bool brings = record.field == SW_FIELD_OF_LEVEL || record.field == SW_FIELD_OF_FLOOR ||
                  record.field == SW_FIELD_OF_FOAM || record.field == SW_FIELD_OF_FLOW ||
                  record.field == SW_FIELD_OF_WAVES || record.field == SW_FIELD_OF_CLIP;
    if (brings)
    {
        s.value.x = s.value.x + record.gain * mix.value.value;
        s.valueX.x = record.gain * mix.value.alongX;
        s.valueZ.x = record.gain * mix.value.alongZ;
        s.value.y = s.value.y + record.gain * mix.other.value;
        s.valueX.y = record.gain * mix.other.alongX;
        s.valueZ.y = record.gain * mix.other.alongZ;
    }
    return s;
}

// ---- waves along a spline ----

// Waves are looked up in coordinates of the ribbon's own: metres to the left and metres along, turned by a heading, 0
// for waves that run from right to left. The wavelength is exact on the line and m times as long beside it.
//
// The heading's cosine and sine are rounded to 1 / SW_HEADING_PARTS, so that cells times them are exact floats: a
// source is as good at the end of a long line as at its start.
#define SW_HEADING_PARTS 16384.0f
#define SW_LEAST_STRETCH 0.15f // nearer to the centre of a bend there are no waves
#define SW_FULL_STRETCH 0.5f
#define SW_CLEAR_FOOT 0.5f // a second foot is no matter if it counts so much less

// The foot whose waves count at a place, and how much, without the record's weight and value.
SW_PARAMS(swRibbonWaves)
{
    swFoot foot;
    swInputChannel share; // in the record's own axes
};

SW_FORMULA swRibbonWaves swFindRibbonWaves(SW_WORDS words, swInputRecord record, float x, float z)
{
    swSegmentList list = swListSegments(words, x, z);
    swRibbonWaves best;
    best.foot = swBeginFoot();
    best.share = swKeepChannel(0.0f);
    swInputChannel most = swKeepChannel(0.0f);
    swInputChannel second = swKeepChannel(0.0f);
    for (sw_uint i = list.first; i < list.end; ++i)
    {
        sw_uint knot = swGetKnot(words, i);
        swFootPlace place = swBracketFoot(words, knot, x, z);
        if (place.from > place.to)
        {
            continue;
        }
        swFoot foot = swFindFoot(words, knot, x, z, place);
        swRibbon ribbon = swCoverRibbon(words, foot, record.feather);
        swInputChannel grown = swRiseChannel(foot.stretch, SW_LEAST_STRETCH, SW_FULL_STRETCH);
        swInputChannel count = swMultiplyChannels(ribbon.count, grown);
        if (count.value > most.value)
        {
            second = most;
            most = count;
            best.foot = foot;
            best.share = swMultiplyChannels(ribbon.cover, grown);
        }
        else if (count.value > second.value)
        {
            second = count;
        }
    }
    if (most.value > 0.0f)
    {
        swInputChannel clear = swSubtractChannels(swKeepChannel(1.0f), swDivideChannels(second, most));
        best.share = swMultiplyChannels(best.share, swRiseChannel(clear, 0.0f, SW_CLEAR_FOOT));
        best.share = swMultiplyChannels(best.share, swReadAlong(words, best.foot, SW_SPAN_WEIGHT));
    }
    return best;
}

// Where a foot's waves are looked up in the sea, and how what is found there is turned into the sea's axes.
SW_PARAMS(swRibbonSource)
{
    sw_int cellX, cellZ; // cells of SW_QUERY_CELL, and the rest, m
    float restX, restZ;
    sw_vec4 way;        // derivatives of source - place: of its x along x and z, then of its z
    float cosine, sine; // of the angle from the sea's x axis to the source's, towards z
    float turnX, turnZ; // derivatives of that angle
};

// Metres in whole cells and a rest.
SW_FORMULA sw_vec2 swSplitCells(float cells, float rest)
{
    float whole = SW_INPUT_FLOOR_OF(cells);
    float more = (cells - whole) * SW_QUERY_CELL + rest;
    float carried = SW_INPUT_FLOOR_OF(more / SW_QUERY_CELL);
    sw_vec2 parts;
    parts.x = whole + carried;
    parts.y = more - carried * SW_QUERY_CELL;
    return parts;
}

// `cosine` and `sine` are the heading's. `laps` is 1 for a closed line's waves from before its first point, else 0.
SW_FORMULA swRibbonSource swPlaceRibbonWaves(SW_WORDS words, swInputRecord record, swFoot foot, float cosine,
                                             float sine, float laps)
{
    sw_uint span = SW_UINT(SW_WORD(words, SW_RIBBON_SPANS)) + foot.span * SW_SPAN_WORDS;
    float cells = SW_WORD(words, span + SW_SPAN_CELL) + laps * SW_WORD(words, SW_RIBBON_LENGTH_CELL);
    float rest = SW_WORD(words, span + SW_SPAN_REST) + laps * SW_WORD(words, SW_RIBBON_LENGTH_REST) + foot.along;
    sw_vec2 x = swSplitCells(sine * cells, cosine * foot.aside.value + sine * rest);
    sw_vec2 z = swSplitCells(cosine * cells, cosine * rest - sine * foot.aside.value);
    swRibbonSource source;
    source.cellX = SW_INT(x.x);
    source.restX = x.y;
    source.cellZ = SW_INT(z.x);
    source.restZ = z.y;
    // Tangent and normal in the sea's axes.
    float tx = record.cosine * foot.tangentX - record.sine * foot.tangentZ;
    float tz = record.sine * foot.tangentX + record.cosine * foot.tangentZ;
    source.cosine = cosine * tz + sine * tx;
    source.sine = sine * tz - cosine * tx;
    source.turnX = -foot.curvature * foot.ahead * tx;
    source.turnZ = -foot.curvature * foot.ahead * tz;
    source.way.x = cosine * tz + sine * foot.ahead * tx - 1.0f;
    source.way.y = -cosine * tx + sine * foot.ahead * tz;
    source.way.z = -sine * tz + cosine * foot.ahead * tx;
    source.way.w = sine * tx + cosine * foot.ahead * tz - 1.0f;
    return source;
}

// Within the seam of a closed line, the share of its start's own waves; its end's, one lap on, have the rest. The
// squares of the two sum up to 1, for they are not alike. 1 elsewhere.
SW_FORMULA swInputChannel swCrossSeam(SW_WORDS words, swFoot foot, bool isNext)
{
    swInputChannel one = swRiseChannel(swMeasureAlong(words, foot), 0.0f, SW_WORD(words, SW_RIBBON_SEAM));
    swInputChannel other = swSubtractChannels(swKeepChannel(1.0f), one);
    swInputChannel square = swAddChannels(swMultiplyChannels(one, one), swMultiplyChannels(other, other));
    float size = SW_INPUT_SQRT(square.value);
    swInputChannel root = swMapChannel(square, size, 0.5f / size);
    if (isNext)
    {
        return swDivideChannels(other, root);
    }
    return swDivideChannels(one, root);
}

// What a spline's records say of waves that run along it, as of any other.
SW_FORMULA swInputSample swSayRibbonWaves(swInputRecord record, swRibbonWaves waves)
{
    swInputSample s = swBeginInputSample(record);
    s.value.x = s.value.x + record.gain;
    s.share = waves.share.value;
    s.shareX = waves.share.alongX;
    s.shareZ = waves.share.alongZ;
    return s;
}

// ---- what an input says ----

SW_FORMULA swInputSample swSampleSpline(SW_WORDS words, swInputRecord record, float x, float z)
{
    swSegmentList list = swListSegments(words, x, z);
    swRibbonMix mix = swBeginRibbonMix();
    bool isThere = false;
    for (sw_uint i = list.first; i < list.end; ++i)
    {
        sw_uint knot = swGetKnot(words, i);
        swFootPlace place = swBracketFoot(words, knot, x, z);
        if (place.from > place.to)
        {
            continue;
        }
        swFoot foot = swFindFoot(words, knot, x, z, place);
        swRibbon ribbon = swCoverRibbon(words, foot, record.feather);
        swRibbonMix one = swReadRibbon(words, record, foot, ribbon);
        if (isThere)
        {
            one = swMixRibbons(mix, one);
        }
        mix = one;
        isThere = true;
    }
    if (!isThere)
    {
        swInputSample nothing = swBeginInputSample(record);
        nothing.share = 0.0f;
        return nothing;
    }
    if (SW_WORD(words, SW_RIBBON_IS_CLOSED) == 0.0f)
    {
        sw_uint first = SW_UINT(SW_WORD(words, SW_RIBBON_KNOTS));
        mix = swMixEnd(words, mix, first, x, z);
        mix = swMixEnd(words, mix, first + SW_UINT(SW_WORD(words, SW_RIBBON_SEGMENTS)) * SW_KNOT_WORDS, x, z);
    }
    return swFinishRibbon(record, mix);
}
#endif
