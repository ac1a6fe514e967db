// SPDX-License-Identifier: MIT
// Authored fields at a place, from the inputs themselves: the twin of core/input. Shapes and how they join stand once,
// in shared.
//
// A place is a cell of the sea and a rest in it, see shared/input.h. Inputs of a field join in the order of their
// records; the index gives the next of those that may cover a place's cell.
//
// Before including: the buffers `swInputHead inputHead`, `swInputRecord inputRecords[]`, `swInputNode inputNodes[]` and
// `float inputWords[]`.
#ifndef SW_LIB_INPUTS
#define SW_LIB_INPUTS
#define SW_WORD(words, i) inputWords[(words) + (i)]
#include "shared/fields.h"
#include "shared/input_shapes.h"
#include "shared/region.h"

struct SeaPlace
{
    ivec2 cell;
    vec2 rest;
};

// With the rest within the cell.
SeaPlace seaPlaceOf(ivec2 cell, vec2 rest)
{
    vec2 whole = floor(rest / SW_QUERY_CELL);
    return SeaPlace(cell + ivec2(whole), rest - whole * SW_QUERY_CELL);
}

// The first record of a field, from record `from` on, whose cells meet those from `low` to `high`; SW_NO_RECORD.
uint findInput(uint field, ivec2 low, ivec2 high, uint from)
{
    swInputRange range = inputHead.ranges[field];
    uint found = SW_NO_RECORD;
    uint end = range.firstNode + range.nodeCount;
    for (uint i = range.firstNode; i < end;)
    {
        swInputNode node = inputNodes[i];
        bool isMet = node.lastRecord >= from && node.firstRecord < found && node.minX <= high.x && node.maxX >= low.x &&
                     node.minZ <= high.y && node.maxZ >= low.y;
        found = isMet && node.record != SW_NO_RECORD ? node.record : found;
        i = isMet ? i + 1 : node.skip;
    }
    return found;
}

bool touchesInputs(uint field, ivec2 low, ivec2 high)
{
    return findInput(field, low, high, 0) != SW_NO_RECORD;
}

bool isLocalSystem(uint system)
{
    return system < 32u && (inputHead.localSystems >> system & 1u) != 0;
}

// A field at a place, the twin of swFindInputValues(); of SW_FIELD_OF_WAVES only inputs of a system count. Compilers
// write out all shapes wherever this is called: call it in one place, in a loop over what is asked.
swInputValue fieldAt(uint field, uint system, SeaPlace place)
{
    swInputValue value = swGetFieldBelow(field);
    value.value.x = field == SW_FIELD_OF_WAVES && isLocalSystem(system) ? 0.0 : value.value.x;
    uint i = findInput(field, place.cell, place.cell, 0);
    while (i != SW_NO_RECORD)
    {
        swInputRecord record = inputRecords[i];
        if (swHasSay(record, system))
        {
            swInputSample s =
                swSampleInput(record.firstWord, record, place.cell.x, place.cell.y, place.rest.x, place.rest.y, 0.0);
            value = swJoinInput(record, system, value, s);
        }
        i = findInput(field, place.cell, place.cell, i + 1);
    }
    return value;
}

// A field of the water's own: inputs that follow the waves count where the water rests, the others where it is.
// `system` is none.
vec4 fieldOnWater(uint field, SeaPlace here, SeaPlace rest)
{
    swInputValue value = swGetFieldBelow(field);
    ivec2 low = min(here.cell, rest.cell);
    ivec2 high = max(here.cell, rest.cell);
    uint i = findInput(field, low, high, 0);
    while (i != SW_NO_RECORD)
    {
        swInputRecord record = inputRecords[i];
        SeaPlace place = here;
        if ((record.flags & SW_INPUT_FOLLOWS_WAVES) != 0)
        {
            place = rest;
        }
        swInputSample s =
            swSampleInput(record.firstWord, record, place.cell.x, place.cell.y, place.rest.x, place.rest.y, 0.0);
        value = swBlendInput(record, value, s);
        i = findInput(field, low, high, i + 1);
    }
    return value.value;
}
#endif
