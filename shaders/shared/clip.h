// SPDX-License-Identifier: MIT
// Holes in the water. The field CLIP is the signed distance to the edge of the holes, m: above 0 there is water, below
// 0 none. It is evaluated where the surface is: at the displaced point, at its height.
//
// Below all inputs there is water everywhere, or none. Inputs join by order: one that cuts takes the least of the
// distance so far and its own, one that leaves water takes the greatest of the distance so far and its own turned
// round. So where each distance is metric, the edge of all of them is where its edges are, and near it the distance is
// metric again. Neither weight nor feather soften an edge: what counts is whether the value times the weight is above
// 0.5.
#ifndef SW_SHARED_CLIP_H
#define SW_SHARED_CLIP_H
#include "input_shapes.h"
#include "shape_hull.h"
#include "shape_polygon.h"
#include "shape_solids.h"

// Farther than any edge, m.
#define SW_CLIP_FAR 1e6f

// What the sea is below all inputs.
SW_FORMULA float swBeginClip(bool isDry)
{
    return isDry ? -SW_CLIP_FAR : SW_CLIP_FAR;
}

// From a hull that may be scaled: a distance along the gradient, which is exact for a plane.
SW_FORMULA float swScaledHullDistance(SW_WORDS words, swInputRecord record, float x, float y, float z)
{
    sw_vec4 own = swHullDistance(words, record.extra0, record.extra1, record.extra2, x / record.size.x,
                                 y / record.size.y, z / record.size.z);
    float steep = swSolidLength(own.x / record.size.x, own.y / record.size.y, own.z / record.size.z);
    float even = swSolidLength(own.x, own.y, own.z);
    return steep > 0.0f ? own.w * (even / steep) : own.w * record.size.x;
}

// Distance from a shape with a height, in own coordinates turned by the yaw; y from its origin.
SW_FORMULA float swSolidDistance(SW_WORDS words, swInputRecord record, float atX, float atY, float atZ)
{
    sw_vec3 own = swTurnBack(record.turn, atX, atY, atZ);
    float halfX = 0.5f * record.size.x, halfY = 0.5f * record.size.y, halfZ = 0.5f * record.size.z;
    if (record.shape == SW_FORM_BOX)
    {
        return swBoxDistance(own.x, own.y, own.z, halfX, halfY, halfZ, record.part0);
    }
    if (record.shape == SW_FORM_ELLIPSOID)
    {
        return swEllipsoidDistance(own.x, own.y, own.z, halfX, halfY, halfZ);
    }
    if (record.shape == SW_FORM_CYLINDER)
    {
        return swCylinderDistance(own.x, own.y, own.z, halfX, halfY, halfZ, record.part0);
    }
    if (record.shape == SW_FORM_CAPSULE)
    {
        return swCapsuleDistance(own.x, own.y, own.z, halfX, halfY);
    }
    return swScaledHullDistance(words, record, own.x, own.y, own.z);
}

// Distance from where a value and its share pass a half, to first order; of the values that rasters and the like bring.
// Values above 0.5 cut, values below -0.5 leave water.
SW_FORMULA float swValueDistance(swInputSample s, float sign)
{
    float value = sign * s.value.x * s.share;
    float alongX = s.valueX.x * s.share + s.value.x * s.shareX;
    float alongZ = s.valueZ.x * s.share + s.value.x * s.shareZ;
    float steep = SW_INPUT_SQRT(alongX * alongX + alongZ * alongZ);
    float distance = (0.5f - value) / (steep > 1e-6f ? steep : 1e-6f);
    return distance < -SW_CLIP_FAR ? -SW_CLIP_FAR : (distance > SW_CLIP_FAR ? SW_CLIP_FAR : distance);
}

SW_FORMULA bool swHasClipEdge(sw_uint shape)
{
    return shape == SW_FORM_EVERYWHERE || shape == SW_FORM_CIRCLE || shape == SW_FORM_RECTANGLE ||
           shape == SW_FORM_POLYGON || shape >= SW_FORM_BOX;
}

// Of shapes with an edge of their own.
SW_FORMULA float swClipEdgeDistance(SW_WORDS words, swInputRecord record, float x, float y, float z)
{
    if (record.shape == SW_FORM_CIRCLE)
    {
        return swSolidLength(x, 0.0f, z) - 0.5f * record.size.x;
    }
    if (record.shape == SW_FORM_RECTANGLE)
    {
        return swCornerDistance(swSolidAway(x) - 0.5f * record.size.x, swSolidAway(z) - 0.5f * record.size.z, -1e30f);
    }
    if (record.shape == SW_FORM_POLYGON)
    {
        return swPolygonDistance(words, record.extra0, x, z).x;
    }
    if (record.shape == SW_FORM_EVERYWHERE)
    {
        return -SW_CLIP_FAR;
    }
    return swSolidDistance(words, record, x, y - record.size.w, z);
}

// What the distance is once a record has joined it whose shape has an edge of its own. `x` and `z` are own coordinates,
// `y` is the height of the surface above sea level.
SW_FORMULA float swJoinClipEdge(float below, SW_WORDS words, swInputRecord record, float x, float y, float z)
{
    if (record.weight <= 0.5f)
    {
        return below;
    }
    float distance = swClipEdgeDistance(words, record, x, y, z);
    return record.value.x * record.weight > 0.5f ? swSolidLeast(below, distance) : swSolidMost(below, -distance);
}

// The same of any other shape, by what swSampleShape() says there.
SW_FORMULA float swJoinClipValue(float below, swInputRecord record, float x, float z, swInputSample s)
{
    s.share = s.share * record.weight;
    s.shareX = s.shareX * record.weight;
    s.shareZ = s.shareZ * record.weight;
    float cuts = swValueDistance(s, 1.0f), leaves = swValueDistance(s, -1.0f);
    if (record.shape == SW_FORM_RASTER) // it ends at its rim
    {
        float rim = swCornerDistance(swSolidAway(x - record.middleX) - record.halfX,
                                     swSolidAway(z - record.middleZ) - record.halfZ, -1e30f);
        cuts = swSolidMost(cuts, rim);
        leaves = swSolidMost(leaves, rim);
    }
    return s.value.x > 0.0f ? swSolidLeast(below, cuts) : swSolidMost(below, -leaves);
}

// Of all shapes.
SW_FORMULA float swJoinClip(float below, SW_WORDS words, swInputRecord record, float x, float y, float z)
{
    if (swHasClipEdge(record.shape))
    {
        return swJoinClipEdge(below, words, record, x, y, z);
    }
    sw_vec3 own;
    own.x = x;
    own.y = y - record.size.w;
    own.z = z;
    return swJoinClipValue(below, record, x, z, swSampleShape(words, record, own));
}
#endif
