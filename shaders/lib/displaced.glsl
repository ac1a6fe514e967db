// SPDX-License-Identifier: MIT
// Inputs that displace the water: the twin of core/surface/displace.c. Formulas stand once, in shared/displace.h.
//
// Before including: lib/inputs.glsl.
#ifndef SW_LIB_DISPLACED
#define SW_LIB_DISPLACED
#include "shared/displace.h"

swInputSample sampleAt(swInputRecord record, SeaPlace place)
{
    return swSampleInput(record.firstWord, record, place.cell.x, place.cell.y, place.rest.x, place.rest.y, 0.0);
}

// Derivatives by the place of a height whose derivatives along rest are given: `x` and `z` are those of sideways
// displacement along x and z. Where the surface folds they have none.
swInputChannel heightByPlace(float height, vec2 along, vec2 x, vec2 z)
{
    float jacobian = (1.0 + x.x) * (1.0 + z.y) - z.x * x.y;
    float inverse = abs(jacobian) > 1e-3 ? 1.0 / jacobian : 0.0;
    return swMakeChannel(height, ((1.0 + z.y) * along.x - x.y * along.y) * inverse,
                         ((1.0 + x.x) * along.y - z.x * along.x) * inverse);
}

// What a change of those derivatives adds to the ones along rest.
vec2 slopeByRest(swInputChannel before, swInputChannel after, vec2 x, vec2 z)
{
    vec2 along = vec2(after.alongX - before.alongX, after.alongZ - before.alongZ);
    return vec2(along.x * (1.0 + x.x) + along.y * x.y, along.x * z.x + along.y * (1.0 + z.y));
}

// All of it for a particle: what follows the waves joins them, then what stays put changes the height where that has
// brought it. Inputs are sampled in one place, because compilers write out all shapes there.
swInputValue displacedWater(SeaPlace rest, swDisplaceRange range, swInputValue waves)
{
    SeaPlace place = rest;
    swInputValue level = swGetFieldBelow(SW_FIELD_OF_LEVEL);
    swInputChannel before = swKeepChannel(0.0), height = before;
    vec2 x = vec2(0.0), z = vec2(0.0);
    for (uint part = 0; part < 3; ++part) // the waves, the level of still water, the height
    {
        uint field = part == 1 ? SW_FIELD_OF_LEVEL : SW_FIELD_OF_DISPLACEMENT;
        uint i = findInput(field, place.cell, place.cell, 0);
        while (i != SW_NO_RECORD)
        {
            swInputRecord record = inputRecords[i];
            if (part == 1 || swIsDisplacing(record, range, part == 0))
            {
                swInputSample s = sampleAt(record, place);
                if (part == 0)
                {
                    waves = swDisplaceAtRest(record, range, waves, s);
                }
                else if (part == 1)
                {
                    level = swBlendInput(record, level, s);
                }
                else
                {
                    height = swDisplaceHeight(record, height,
                                              swMakeChannel(level.value.x, level.alongX.x, level.alongZ.x), s);
                }
            }
            i = findInput(field, place.cell, place.cell, i + 1);
        }
        if (part == 0)
        {
            place = seaPlaceOf(rest.cell, rest.rest + waves.value.xz);
            x = waves.alongX.xz;
            z = vec2(waves.alongX.z, waves.alongZ.z);
            before = heightByPlace(waves.value.y, vec2(waves.alongX.y, waves.alongZ.y), x, z);
            height = before;
        }
    }
    vec2 slope = slopeByRest(before, height, x, z);
    waves.value.y = height.value;
    waves.alongX.y += slope.x;
    waves.alongZ.y += slope.y;
    return waves;
}
#endif
