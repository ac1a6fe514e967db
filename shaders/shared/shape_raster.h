// SPDX-License-Identifier: MIT
// Rasters as inputs: bilinear between the middles of cells, with the derivatives of that. A record's own origin is the
// middle of the first cell. Its words are [frame][height][width][channels]; extra0 is the width, extra1 the height,
// extra2 the channels, extra3 and extra4 the first words of the two frames that are mixed; part0 and part1 are the
// spacings along x and z, part2 the share of the second frame.
//
// A cell that is not known is not covered: next to it the share falls to 0 within one spacing, and the value there is
// the mean of those that are known.
#ifndef SW_SHARED_SHAPE_RASTER_H
#define SW_SHARED_SHAPE_RASTER_H
#include "input.h"
#include "raster.h"

// Known values are at most so much either way; NaN, or whatever stands for it, is not.
#define SW_LARGEST_RASTER_VALUE 1e6f

// The four cells about a place.
SW_PARAMS(swRasterCells)
{
    sw_uint northWest, northEast, southWest, southEast; // words
    float east, south;                                  // fractions
    bool isInside;
};

// `at` is in cells from the first.
SW_FORMULA sw_uint swFindRasterCell(float at, sw_uint count)
{
    sw_uint last = count > 1u ? count - 2u : 0u;
    sw_uint cell = at > 0.0f ? SW_UINT(at) : 0u;
    return cell < last ? cell : last;
}

SW_FORMULA swRasterCells swFindRasterCells(swInputRecord record, float x, float z)
{
    swRasterCells cells;
    float atX = x / record.part0;
    float atZ = z / record.part1;
    cells.isInside =
        atX >= 0.0f && atZ >= 0.0f && atX <= SW_FLOAT(record.extra0 - 1u) && atZ <= SW_FLOAT(record.extra1 - 1u);
    sw_uint column = swFindRasterCell(cells.isInside ? atX : 0.0f, record.extra0);
    sw_uint row = swFindRasterCell(cells.isInside ? atZ : 0.0f, record.extra1);
    sw_uint right = record.extra0 > 1u ? record.extra2 : 0u;
    sw_uint down = record.extra1 > 1u ? record.extra0 * record.extra2 : 0u;
    cells.northWest = (row * record.extra0 + column) * record.extra2;
    cells.northEast = cells.northWest + right;
    cells.southWest = cells.northWest + down;
    cells.southEast = cells.southWest + right;
    cells.east = atX - SW_FLOAT(column);
    cells.south = atZ - SW_FLOAT(row);
    return cells;
}

SW_FORMULA bool swIsRasterValue(float value)
{
    return SW_INPUT_ABS(value) <= SW_LARGEST_RASTER_VALUE;
}

// The value, and its derivatives by cell, of one channel of a frame; the share that is known in `share`, of the first
// channel.
SW_FORMULA swInputChannel swMixKnownCells(SW_WORDS words, swRasterCells cells, sw_uint channel)
{
    float a = SW_WORD(words, cells.northWest + channel);
    float b = SW_WORD(words, cells.northEast + channel);
    float c = SW_WORD(words, cells.southWest + channel);
    float d = SW_WORD(words, cells.southEast + channel);
    return swMakeChannel(swMixFourCells(a, b, c, d, cells.east, cells.south), swMixCells(b - a, d - c, cells.south),
                         swMixCells(c - a, d - b, cells.east));
}

// The same as a sum of what is known: 1 where `ones`, to have the share.
SW_FORMULA swInputChannel swSumKnownCells(SW_WORDS words, swRasterCells cells, sw_uint channel, bool ones)
{
    float a = SW_WORD(words, cells.northWest + channel);
    float b = SW_WORD(words, cells.northEast + channel);
    float c = SW_WORD(words, cells.southWest + channel);
    float d = SW_WORD(words, cells.southEast + channel);
    a = swIsRasterValue(a) ? (ones ? 1.0f : a) : 0.0f;
    b = swIsRasterValue(b) ? (ones ? 1.0f : b) : 0.0f;
    c = swIsRasterValue(c) ? (ones ? 1.0f : c) : 0.0f;
    d = swIsRasterValue(d) ? (ones ? 1.0f : d) : 0.0f;
    return swMakeChannel(swMixFourCells(a, b, c, d, cells.east, cells.south), swMixCells(b - a, d - c, cells.south),
                         swMixCells(c - a, d - b, cells.east));
}

SW_FORMULA bool swAreCellsKnown(SW_WORDS words, swRasterCells cells, sw_uint channel)
{
    return swIsRasterValue(SW_WORD(words, cells.northWest + channel)) &&
           swIsRasterValue(SW_WORD(words, cells.northEast + channel)) &&
           swIsRasterValue(SW_WORD(words, cells.southWest + channel)) &&
           swIsRasterValue(SW_WORD(words, cells.southEast + channel));
}

// A quotient and its derivatives.
SW_FORMULA swInputChannel swDivideChannel(swInputChannel a, swInputChannel b)
{
    float value = a.value / b.value;
    return swMakeChannel(value, (a.alongX - value * b.alongX) / b.value, (a.alongZ - value * b.alongZ) / b.value);
}

// One channel per metre, with the record's gain.
SW_FORMULA swInputChannel swScaleRasterChannel(swInputRecord record, swInputChannel c)
{
    return swMakeChannel(record.gain * c.value, record.gain * c.alongX / record.part0,
                         record.gain * c.alongZ / record.part1);
}

SW_FORMULA swInputChannel swSampleRasterChannel(SW_WORDS words, swInputRecord record, swRasterCells cells,
                                                sw_uint channel)
{
    if (swAreCellsKnown(words, cells, channel))
    {
        return swScaleRasterChannel(record, swMixKnownCells(words, cells, channel));
    }
    swInputChannel known = swSumKnownCells(words, cells, channel, true);
    if (known.value <= 0.0f)
    {
        return swMakeChannel(0.0f, 0.0f, 0.0f);
    }
    return swScaleRasterChannel(record, swDivideChannel(swSumKnownCells(words, cells, channel, false), known));
}

// How much is known, by the first channel.
SW_FORMULA swInputChannel swSampleRasterShare(SW_WORDS words, swInputRecord record, swRasterCells cells)
{
    if (swAreCellsKnown(words, cells, 0u))
    {
        return swMakeChannel(1.0f, 0.0f, 0.0f);
    }
    swInputChannel known = swSumKnownCells(words, cells, 0u, true);
    return swMakeChannel(known.value, known.alongX / record.part0, known.alongZ / record.part1);
}

SW_FORMULA swInputChannel swSampleRasterFrames(SW_WORDS words, swInputRecord record, swRasterCells cells,
                                               sw_uint channel)
{
    swInputChannel first = swSampleRasterChannel(words + record.extra3, record, cells, channel);
    if (record.part2 <= 0.0f)
    {
        return first;
    }
    return swMixChannels(first, swSampleRasterChannel(words + record.extra4, record, cells, channel),
                         swMakeChannel(record.part2, 0.0f, 0.0f));
}

// Adds a channel to one of a sample's numbers.
SW_FORMULA swInputSample swAddRasterChannel(swInputSample s, sw_uint number, swInputChannel c)
{
    if (number == 0u)
    {
        s.value.x = s.value.x + c.value;
        s.valueX.x = c.alongX;
        s.valueZ.x = c.alongZ;
    }
    else if (number == 1u)
    {
        s.value.y = s.value.y + c.value;
        s.valueX.y = c.alongX;
        s.valueZ.y = c.alongZ;
    }
    else if (number == 2u)
    {
        s.value.z = s.value.z + c.value;
        s.valueX.z = c.alongX;
        s.valueZ.z = c.alongZ;
    }
    else
    {
        s.value.w = s.value.w + c.value;
        s.valueX.w = c.alongX;
        s.valueZ.w = c.alongZ;
    }
    return s;
}

SW_FORMULA swInputSample swSampleRasterInput(SW_WORDS words, swInputRecord record, float x, float z)
{
    swInputSample s = swBeginInputSample(record);
    swRasterCells cells = swFindRasterCells(record, x, z);
    if (!cells.isInside)
    {
        s.share = 0.0f;
        return s;
    }
    swInputChannel share = swSampleRasterShare(words + record.extra3, record, cells);
    if (record.part2 > 0.0f)
    {
        share = swMixChannels(share, swSampleRasterShare(words + record.extra4, record, cells),
                              swMakeChannel(record.part2, 0.0f, 0.0f));
    }
    s.share = share.value;
    s.shareX = share.alongX;
    s.shareZ = share.alongZ;
    if (share.value <= 0.0f)
    {
        return s;
    }
    // A loop: compilers of shaders write out what stands four times four times.
    sw_uint numbers = swCountRecordNumbers(record);
    for (sw_uint channel = 0u; channel < numbers; ++channel)
    {
        sw_uint number = (record.flags & SW_INPUT_IS_HEIGHT) != 0u ? channel + 1u : channel;
        s = swAddRasterChannel(s, number, swSampleRasterFrames(words, record, cells, channel));
    }
    return swCoverRectangle(s, x - record.middleX, z - record.middleZ, record.halfX, record.halfZ, record.feather);
}
#endif
