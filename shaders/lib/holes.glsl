// SPDX-License-Identifier: MIT
// Holes in the water at a place, from the inputs themselves: the twin of core/input/sample_clip.c. How they join stands
// once, in shared/clip.h. Needs lib/inputs.glsl.
#ifndef SW_LIB_HOLES
#define SW_LIB_HOLES
#include "lib/inputs.glsl" // it says how words are read

#include "shared/clip.h"

// The signed distance to the edge of the holes, m: below 0 there is no water. `y` is the height of the surface above
// sea level.
float clipAt(SeaPlace place, float y)
{
    float distance = SW_CLIP_FAR;
    uint i = findInput(SW_FIELD_OF_CLIP, place.cell, place.cell, 0);
    while (i != SW_NO_RECORD)
    {
        swInputRecord record = inputRecords[i];
        vec2 own = swPlaceInInput(record, place.cell.x, place.cell.y, place.rest.x, place.rest.y);
        distance = swJoinClip(distance, record.firstWord, record, own.x, y, own.y);
        i = findInput(SW_FIELD_OF_CLIP, place.cell, place.cell, i + 1);
    }
    return distance;
}

// The number of the body of water at a place, -1 where there is none. Bodies are polygons.
int bodyAt(SeaPlace place)
{
    int number = -1;
    uint i = findInput(SW_FIELD_OF_BODY, place.cell, place.cell, 0);
    while (i != SW_NO_RECORD)
    {
        swInputRecord record = inputRecords[i];
        if (record.shape == SW_FORM_POLYGON)
        {
            vec2 own = swPlaceInInput(record, place.cell.x, place.cell.y, place.rest.x, place.rest.y);
            number = swSamplePolygon(record.firstWord, record, own.x, own.y).share > 0.0 ? int(record.value.x) : number;
        }
        i = findInput(SW_FIELD_OF_BODY, place.cell, place.cell, i + 1);
    }
    return number;
}

// The level of still water above sea level and its slope (y, z), by all inputs but those of bodies of water.
vec3 levelBetweenBodies(SeaPlace place)
{
    swInputValue value = swGetFieldBelow(SW_FIELD_OF_LEVEL);
    uint i = findInput(SW_FIELD_OF_LEVEL, place.cell, place.cell, 0);
    while (i != SW_NO_RECORD)
    {
        swInputRecord record = inputRecords[i];
        if ((record.flags & SW_INPUT_IS_OF_BODY) == 0)
        {
            swInputSample s =
                swSampleInput(record.firstWord, record, place.cell.x, place.cell.y, place.rest.x, place.rest.y, 0.0);
            value = swBlendInput(record, value, s);
        }
        i = findInput(SW_FIELD_OF_LEVEL, place.cell, place.cell, i + 1);
    }
    return vec3(value.value.x, value.alongX.x, value.alongZ.x);
}
#endif
