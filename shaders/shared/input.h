// SPDX-License-Identifier: MIT
// Inputs as both halves read them: flat records, an index of them, and how they join. See src/core/frame/input_set.h
// for how they lie together and src/core/input for how they are made.
//
// A place is a whole number of cells of SW_QUERY_CELL metres from the sea's origin, and a rest. A record's own origin
// is the same, so that a place's own coordinates are as good 1,000 km out as here: see swPlaceInInput().
#ifndef SW_SHARED_INPUT_H
#define SW_SHARED_INPUT_H
#include "query.h"
#include "types.h"

// Numbers as swInputField, swInputShape and swInputBlend have them.
#define SW_FIELD_OF_FLOOR 0u
#define SW_FIELD_OF_LEVEL 1u
#define SW_FIELD_OF_FLOW 2u
#define SW_FIELD_OF_WAVES 3u
#define SW_FIELD_OF_DISPLACEMENT 4u
#define SW_FIELD_OF_CLIP 5u
#define SW_FIELD_OF_FOAM 6u
#define SW_FIELD_OF_ALBEDO 7u
#define SW_FIELD_OF_WIND 8u
#define SW_FIELD_OF_SHADOW 9u
#define SW_FIELD_OF_BODY 10u
#define SW_FIELD_OF_COUNT 11u

#define SW_FORM_EVERYWHERE 0u
#define SW_FORM_CIRCLE 1u
#define SW_FORM_RECTANGLE 2u
#define SW_FORM_POLYGON 3u
#define SW_FORM_POLYLINE 4u
#define SW_FORM_SPLINE 5u
#define SW_FORM_MESH 6u
#define SW_FORM_RASTER 7u
#define SW_FORM_PARTICLES 8u
#define SW_FORM_FUNCTION 9u
#define SW_FORM_BOX 10u
#define SW_FORM_ELLIPSOID 11u
#define SW_FORM_CYLINDER 12u
#define SW_FORM_CAPSULE 13u
#define SW_FORM_HULL 14u

#define SW_JOIN_ADD 0u
#define SW_JOIN_ALPHA 1u
#define SW_JOIN_MULTIPLY 2u
#define SW_JOIN_MIN 3u
#define SW_JOIN_MAX 4u
#define SW_JOIN_REPLACE 5u

// Bits of swInputRecord::flags.
#define SW_INPUT_FOLLOWS_WAVES 1u
#define SW_INPUT_TURNS_VALUES 2u   // values x and z (of flow and wind x and y) lie along the record's own axes
#define SW_INPUT_IS_BOUNDLESS 4u   // it counts everywhere, also where cells do not fit 32 bits
#define SW_INPUT_ALONG_SPLINE 16u  // waves turn with the spline, see shape_spline.h
#define SW_INPUT_CHANGES 8u        // its value, gain or place is another in each step
#define SW_INPUT_REMOVES_WAVES 32u // of waves: what is below it of all systems goes by its share, see region.h
#define SW_INPUT_IS_HEIGHT 256u    // of displacement: its raster has one channel, the height
#define SW_INPUT_IS_BUMP 128u      // of circles and particles: see swCoverDisc()
#define SW_INPUT_TAKES_WIND 64u    // of waves: its raster is a wind, see swFindWindWeight()
#define SW_INPUT_IS_OF_BODY 128u   // it is a part of a body of water

SW_PARAMS(swInputRecord)
{
    sw_int cellX, cellZ; // where its own origin lies in the sea
    float restX, restZ;  // m, in [0, SW_QUERY_CELL)
    float cosine, sine;  // of its yaw: own x = cosine dx + sine dz, own z = cosine dz - sine dx
    float middleX, middleZ;
    float halfX, halfZ; // bounds in own coordinates: nothing is covered outside of middle -+ half
    float weight, feather;
    sw_vec4 value;
    sw_vec4 size; // x, y, z: full extents; w: height of its own origin above sea level, m
    sw_vec4 turn; // of a shape with a height: its pitch and roll as a quaternion x, y, z, w; the yaw comes after
    sw_uint field, shape, blend, flags;
    sw_uint system;               // of SW_FIELD_OF_WAVES: its slot, or SW_ALL_SYSTEMS
    sw_uint firstWord, wordCount; // of its data. On the CPU each record has a pointer of its own, and firstWord is 0
    sw_uint extra0;               // what its shape says they are
    sw_uint extra1, extra2, extra3, extra4;
    float gain; // of values that the shape brings
    float part0, part1, part2;
};
SW_PARAMS_SIZE(swInputRecord, 160);
SW_PARAMS_VEC3(swInputRecord, value);
SW_PARAMS_VEC3(swInputRecord, size);
SW_PARAMS_VEC3(swInputRecord, turn);

// The floor where there is none, m.
#define SW_NO_FLOOR (-1e30f)

#define SW_NO_RECORD 0xffffffffu
#define SW_ALL_SYSTEMS 0xffffffffu

// A box of cells. Nodes of a field stand in depth-first order: below one stands its first child, at `skip` what comes
// after the last one.
SW_PARAMS(swInputNode)
{
    sw_int minX, minZ, maxX, maxZ; // cells, both ends belong to it
    sw_uint skip;
    sw_uint record;                  // of a leaf, else SW_NO_RECORD
    sw_uint firstRecord, lastRecord; // the least and the greatest of all below
};
SW_PARAMS_SIZE(swInputNode, 32);

// Where a field's records and nodes stand. Records are in the order in which they join.
SW_PARAMS(swInputRange)
{
    sw_uint firstRecord, recordCount;
    sw_uint firstNode, nodeCount;
};
SW_PARAMS_SIZE(swInputRange, 16);

// What a record says at a place: values, how much of them counts (cover times feather times weight), and the exact
// derivatives of both, per metre.
SW_PARAMS(swInputSample)
{
    sw_vec4 value, valueX, valueZ;
    float share, shareX, shareZ;
};

// A field's value at a place and its derivatives.
SW_PARAMS(swInputValue)
{
    sw_vec4 value, alongX, alongZ;
};

// Data of a shape: floats, some of which hold the bits of whole numbers. In C a pointer to the record's first word, in
// GLSL the number of that word in a buffer; whoever includes this there defines SW_WORD.
#ifdef __STDC__
#define SW_WORDS const float*
#define SW_WORD(words, i) ((words)[i])
#define SW_INPUT_SQRT sqrtf
#define SW_INPUT_ABS fabsf
#define SW_INPUT_FLOOR_OF floorf
#include <math.h>
#else
#define SW_WORDS uint
#define SW_INPUT_SQRT sqrt
#define SW_INPUT_ABS abs
#define SW_INPUT_FLOOR_OF floor
#endif

// A place in a record's own coordinates.
SW_FORMULA sw_vec2 swPlaceInInput(swInputRecord record, sw_int cellX, sw_int cellZ, float restX, float restZ)
{
    float dx = SW_FLOAT(cellX - record.cellX) * SW_QUERY_CELL + (restX - record.restX);
    float dz = SW_FLOAT(cellZ - record.cellZ) * SW_QUERY_CELL + (restZ - record.restZ);
    sw_vec2 own;
    own.x = record.cosine * dx + record.sine * dz;
    own.y = record.cosine * dz - record.sine * dx;
    return own;
}

// ---- helpers of shapes ----

SW_FORMULA sw_vec4 swNoValue(void)
{
    sw_vec4 v;
    v.x = 0.0f;
    v.y = 0.0f;
    v.z = 0.0f;
    v.w = 0.0f;
    return v;
}

// Numbers that a field has.
SW_FORMULA sw_uint swCountInputNumbers(sw_uint field)
{
    if (field == SW_FIELD_OF_ALBEDO)
    {
        return 4u;
    }
    if (field == SW_FIELD_OF_DISPLACEMENT)
    {
        return 3u;
    }
    return field == SW_FIELD_OF_FLOW || field == SW_FIELD_OF_WIND ? 2u : 1u;
}

// Numbers that a record's shape brings.
SW_FORMULA sw_uint swCountRecordNumbers(swInputRecord record)
{
    if ((record.flags & SW_INPUT_IS_HEIGHT) != 0u)
    {
        return 1u;
    }
    return (record.flags & SW_INPUT_TAKES_WIND) != 0u ? 2u : swCountInputNumbers(record.field);
}

// What a field is below all inputs; of waves that of systems that are everywhere.
SW_FORMULA swInputValue swGetFieldBelow(sw_uint field)
{
    swInputValue below;
    below.value = swNoValue();
    below.alongX = swNoValue();
    below.alongZ = swNoValue();
    if (field == SW_FIELD_OF_FLOOR)
    {
        below.value.x = SW_NO_FLOOR;
    }
    if (field == SW_FIELD_OF_WAVES || field == SW_FIELD_OF_SHADOW)
    {
        below.value.x = 1.0f;
    }
    if (field == SW_FIELD_OF_BODY)
    {
        below.value.x = -1.0f;
    }
    return below;
}

// The record's own value, everywhere.
SW_FORMULA swInputSample swBeginInputSample(swInputRecord record)
{
    swInputSample s;
    s.value = record.value;
    s.valueX = swNoValue();
    s.valueZ = swNoValue();
    s.share = 1.0f;
    s.shareX = 0.0f;
    s.shareZ = 0.0f;
    return s;
}

// The share so many metres inside an edge, and its derivative: 3 t^2 - 2 t^3, smooth at both ends.
SW_FORMULA sw_vec2 swFeatherInput(float inside, float feather)
{
    sw_vec2 share;
    share.x = inside >= 0.0f ? 1.0f : 0.0f;
    share.y = 0.0f;
    if (inside > 0.0f && inside < feather)
    {
        float t = inside / feather;
        share.x = t * t * (3.0f - 2.0f * t);
        share.y = 6.0f * t * (1.0f - t) / feather;
    }
    if (inside <= 0.0f && feather > 0.0f)
    {
        share.x = 0.0f;
    }
    return share;
}

// The share of a disc so far from its middle, and its derivative: by the feather, or a bump (1 - r^2)^2.
SW_FORMULA sw_vec2 swCoverDisc(swInputRecord record, float distance, float radius)
{
    if ((record.flags & SW_INPUT_IS_BUMP) == 0u)
    {
        sw_vec2 cover = swFeatherInput(radius - distance, record.feather);
        cover.y = -cover.y;
        return cover;
    }
    float r = radius > 0.0f ? distance / radius : 1.0f;
    float rest = r < 1.0f ? 1.0f - r * r : 0.0f;
    sw_vec2 bump;
    bump.x = rest * rest;
    bump.y = radius > 0.0f ? -4.0f * rest * r / radius : 0.0f;
    return bump;
}

// The share within a rectangle about (0, 0): both axes' feathers multiplied, so that it has no crease in the corners.
SW_FORMULA swInputSample swCoverRectangle(swInputSample s, float x, float z, float halfX, float halfZ, float feather)
{
    sw_vec2 acrossX = swFeatherInput(halfX - SW_INPUT_ABS(x), feather);
    sw_vec2 acrossZ = swFeatherInput(halfZ - SW_INPUT_ABS(z), feather);
    float cover = acrossX.x * acrossZ.x;
    s.shareX = s.shareX * cover + s.share * (x > 0.0f ? -acrossX.y : acrossX.y) * acrossZ.x;
    s.shareZ = s.shareZ * cover + s.share * (z > 0.0f ? -acrossZ.y : acrossZ.y) * acrossX.x;
    s.share = s.share * cover;
    return s;
}

// ---- joining ----

// Floors that are mixed: below so many metres under the sea level by the inverse of their depth, so that a floor fades
// into none at all. Waves feel the inverse more evenly than the depth, too.
#define SW_DEEP_FLOOR 50.0f

SW_FORMULA float swRaiseFloor(float floorHeight)
{
    return floorHeight >= -SW_DEEP_FLOOR ? floorHeight + 2.0f * SW_DEEP_FLOOR
                                         : SW_DEEP_FLOOR * SW_DEEP_FLOOR / -floorHeight;
}

SW_FORMULA float swRaiseFloorSlope(float floorHeight)
{
    return floorHeight >= -SW_DEEP_FLOOR ? 1.0f : SW_DEEP_FLOOR * SW_DEEP_FLOOR / floorHeight / floorHeight;
}

SW_FORMULA float swLowerFloor(float raised)
{
    return raised >= SW_DEEP_FLOOR ? raised - 2.0f * SW_DEEP_FLOOR
                                   : -SW_DEEP_FLOOR * SW_DEEP_FLOOR / (raised > 1e-27f ? raised : 1e-27f);
}

SW_FORMULA float swLowerFloorSlope(float raised)
{
    float square = raised > 1e-15f ? raised * raised : 1e-30f;
    return raised >= SW_DEEP_FLOOR ? 1.0f : SW_DEEP_FLOOR * SW_DEEP_FLOOR / square;
}

// One number with its derivatives along x and z.
SW_PARAMS(swInputChannel)
{
    float value, alongX, alongZ;
};

SW_FORMULA swInputChannel swMakeChannel(float value, float alongX, float alongZ)
{
    swInputChannel c;
    c.value = value;
    c.alongX = alongX;
    c.alongZ = alongZ;
    return c;
}

// From a to b; at the ends those to the bit.
SW_FORMULA swInputChannel swMixChannels(swInputChannel a, swInputChannel b, swInputChannel share)
{
    if (share.value <= 0.0f)
    {
        return a;
    }
    swInputChannel c = b;
    float way = b.value - a.value;
    if (share.value < 1.0f)
    {
        c.value = a.value + share.value * way;
        c.alongX = a.alongX + share.value * (b.alongX - a.alongX) + share.alongX * way;
        c.alongZ = a.alongZ + share.value * (b.alongZ - a.alongZ) + share.alongZ * way;
    }
    return c;
}

// The same of two floors.
SW_FORMULA swInputChannel swMixFloors(swInputChannel a, swInputChannel b, swInputChannel share)
{
    if (share.value <= 0.0f || share.value >= 1.0f)
    {
        return share.value <= 0.0f ? a : b;
    }
    float slopeA = swRaiseFloorSlope(a.value);
    float slopeB = swRaiseFloorSlope(b.value);
    swInputChannel raised =
        swMixChannels(swMakeChannel(swRaiseFloor(a.value), a.alongX * slopeA, a.alongZ * slopeA),
                      swMakeChannel(swRaiseFloor(b.value), b.alongX * slopeB, b.alongZ * slopeB), share);
    float slope = swLowerFloorSlope(raised.value);
    return swMakeChannel(swLowerFloor(raised.value), raised.alongX * slope, raised.alongZ * slope);
}

SW_FORMULA swInputChannel swBlendChannel(swInputRecord record, swInputChannel below, swInputChannel own,
                                         swInputChannel share)
{
    if (record.blend == SW_JOIN_ADD)
    {
        return swMakeChannel(below.value + share.value * own.value,
                             below.alongX + share.value * own.alongX + share.alongX * own.value,
                             below.alongZ + share.value * own.alongZ + share.alongZ * own.value);
    }
    if (record.blend == SW_JOIN_MULTIPLY)
    {
        swInputChannel factor = swMixChannels(swMakeChannel(1.0f, 0.0f, 0.0f), own, share);
        return swMakeChannel(below.value * factor.value, below.alongX * factor.value + below.value * factor.alongX,
                             below.alongZ * factor.value + below.value * factor.alongZ);
    }
    if (record.blend == SW_JOIN_REPLACE)
    {
        if (share.value > 0.0f)
        {
            return own;
        }
        return below;
    }
    bool keeps = (record.blend == SW_JOIN_MIN && below.value <= own.value) ||
                 (record.blend == SW_JOIN_MAX && below.value >= own.value);
    if (keeps)
    {
        return below;
    }
    if (record.field == SW_FIELD_OF_FLOOR)
    {
        return swMixFloors(below, own, share);
    }
    return swMixChannels(below, own, share);
}

// What a field is once a record has joined it.
SW_FORMULA swInputValue swBlendInput(swInputRecord record, swInputValue below, swInputSample s)
{
    swInputChannel share = swMakeChannel(s.share, s.shareX, s.shareZ);
    if (record.field == SW_FIELD_OF_ALBEDO && record.blend != SW_JOIN_ADD)
    {
        // A colour counts by its own cover as well, and the cover runs to 1.
        share = swMakeChannel(s.share * s.value.w, s.shareX * s.value.w + s.share * s.valueX.w,
                              s.shareZ * s.value.w + s.share * s.valueZ.w);
        s.value.w = 1.0f;
        s.valueX.w = 0.0f;
        s.valueZ.w = 0.0f;
    }
    swInputChannel x = swBlendChannel(record, swMakeChannel(below.value.x, below.alongX.x, below.alongZ.x),
                                      swMakeChannel(s.value.x, s.valueX.x, s.valueZ.x), share);
    if (swCountInputNumbers(record.field) == 1u)
    {
        below.value.x = x.value;
        below.alongX.x = x.alongX;
        below.alongZ.x = x.alongZ;
        return below;
    }
    swInputChannel y = swBlendChannel(record, swMakeChannel(below.value.y, below.alongX.y, below.alongZ.y),
                                      swMakeChannel(s.value.y, s.valueX.y, s.valueZ.y), share);
    swInputChannel z = swBlendChannel(record, swMakeChannel(below.value.z, below.alongX.z, below.alongZ.z),
                                      swMakeChannel(s.value.z, s.valueX.z, s.valueZ.z), share);
    swInputChannel w = swBlendChannel(record, swMakeChannel(below.value.w, below.alongX.w, below.alongZ.w),
                                      swMakeChannel(s.value.w, s.valueX.w, s.valueZ.w), share);
    swInputValue joined;
    joined.value.x = x.value;
    joined.value.y = y.value;
    joined.value.z = z.value;
    joined.value.w = w.value;
    joined.alongX.x = x.alongX;
    joined.alongX.y = y.alongX;
    joined.alongX.z = z.alongX;
    joined.alongX.w = w.alongX;
    joined.alongZ.x = x.alongZ;
    joined.alongZ.y = y.alongZ;
    joined.alongZ.z = z.alongZ;
    joined.alongZ.w = w.alongZ;
    return joined;
}
#endif
