// SPDX-License-Identifier: MIT
// All shapes of inputs: what a record says at a place. Each shape has a header of its own, shape_x.h, in which it
// answers in the record's own coordinates.
#ifndef SW_SHARED_INPUT_SHAPES_H
#define SW_SHARED_INPUT_SHAPES_H
#include "input.h"
#include "shape_mesh.h"
#include "shape_particles.h"
#include "shape_plain.h"
#include "shape_polygon.h"
#include "shape_polyline.h"
#include "shape_raster.h"
#include "shape_spline.h"

// At a place in own coordinates, before the record's weight; but for waves along splines.
SW_FORMULA swInputSample swSampleShape(SW_WORDS words, swInputRecord record, sw_vec3 own)
{
    if (record.shape == SW_FORM_CIRCLE)
    {
        return swSampleCircle(record, own.x, own.z);
    }
    if (record.shape == SW_FORM_RECTANGLE)
    {
        return swSampleRectangle(record, own.x, own.z);
    }
    if (record.shape == SW_FORM_MESH)
    {
        return swSampleMeshInput(words, record, own.x, own.z);
    }
    if (record.shape == SW_FORM_POLYGON)
    {
        return swSamplePolygon(words, record, own.x, own.z);
    }
    if (record.shape == SW_FORM_RASTER)
    {
        return swSampleRasterInput(words, record, own.x, own.z);
    }
    if (record.shape == SW_FORM_POLYLINE)
    {
        return swSamplePolyline(words, record, own.x, own.z);
    }
    if (record.shape == SW_FORM_SPLINE)
    {
        return swSampleSpline(words, record, own.x, own.z);
    }
    if (record.shape == SW_FORM_PARTICLES)
    {
        return swSampleParticles(words, record, own.x, own.z);
    }
    swInputSample s = swBeginInputSample(record);
    s.share = record.shape == SW_FORM_EVERYWHERE ? 1.0f : 0.0f; // solids and functions are looked at elsewhere
    return s;
}

// From own coordinates to the sea's: a gradient.
SW_FORMULA sw_vec2 swTurnInputGradient(swInputRecord record, float alongX, float alongZ)
{
    sw_vec2 turned;
    turned.x = record.cosine * alongX - record.sine * alongZ;
    turned.y = record.sine * alongX + record.cosine * alongZ;
    return turned;
}

// Weight, and the turn of derivatives and of vectors.
SW_FORMULA swInputSample swFinishInputSample(swInputRecord record, swInputSample s)
{
    s.share = s.share * record.weight;
    if (record.sine == 0.0f && record.cosine == 1.0f)
    {
        s.shareX = s.shareX * record.weight;
        s.shareZ = s.shareZ * record.weight;
        return s;
    }
    sw_vec2 g = swTurnInputGradient(record, s.shareX * record.weight, s.shareZ * record.weight);
    s.shareX = g.x;
    s.shareZ = g.y;
    g = swTurnInputGradient(record, s.valueX.x, s.valueZ.x);
    s.valueX.x = g.x;
    s.valueZ.x = g.y;
    g = swTurnInputGradient(record, s.valueX.y, s.valueZ.y);
    s.valueX.y = g.x;
    s.valueZ.y = g.y;
    g = swTurnInputGradient(record, s.valueX.z, s.valueZ.z);
    s.valueX.z = g.x;
    s.valueZ.z = g.y;
    g = swTurnInputGradient(record, s.valueX.w, s.valueZ.w);
    s.valueX.w = g.x;
    s.valueZ.w = g.y;
    if ((record.flags & SW_INPUT_TURNS_VALUES) == 0u)
    {
        return s;
    }
    if (record.field == SW_FIELD_OF_DISPLACEMENT)
    {
        g = swTurnInputGradient(record, s.value.x, s.value.z);
        s.value.x = g.x;
        s.value.z = g.y;
        g = swTurnInputGradient(record, s.valueX.x, s.valueX.z);
        s.valueX.x = g.x;
        s.valueX.z = g.y;
        g = swTurnInputGradient(record, s.valueZ.x, s.valueZ.z);
        s.valueZ.x = g.x;
        s.valueZ.z = g.y;
        return s;
    }
    g = swTurnInputGradient(record, s.value.x, s.value.y);
    s.value.x = g.x;
    s.value.y = g.y;
    g = swTurnInputGradient(record, s.valueX.x, s.valueX.y);
    s.valueX.x = g.x;
    s.valueX.y = g.y;
    g = swTurnInputGradient(record, s.valueZ.x, s.valueZ.y);
    s.valueZ.x = g.x;
    s.valueZ.y = g.y;
    return s;
}

// Whether a record makes waves run along its spline. Those are found by swFindRibbonWaves(), which swSampleShape()
// leaves out so that shaders hold it no more often than they need.
SW_FORMULA bool swRunsAlong(swInputRecord record)
{
    return record.shape == SW_FORM_SPLINE && (record.flags & SW_INPUT_ALONG_SPLINE) != 0u;
}

// What a record says at a place in cells, `height` m above sea level.
SW_FORMULA swInputSample swSampleInput(SW_WORDS words, swInputRecord record, sw_int cellX, sw_int cellZ, float restX,
                                       float restZ, float height)
{
    sw_vec2 across = swPlaceInInput(record, cellX, cellZ, restX, restZ);
    sw_vec3 own;
    own.x = across.x;
    own.y = height - record.size.w;
    own.z = across.y;
    if (swRunsAlong(record))
    {
        return swFinishInputSample(record, swSayRibbonWaves(record, swFindRibbonWaves(words, record, own.x, own.z)));
    }
    return swFinishInputSample(record, swSampleShape(words, record, own));
}
#endif
