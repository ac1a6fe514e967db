// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// Rays against the surface: the GPU's twin of core/query/raycast.c, which says how a march goes: steps as long as the
// gap to the water allows, at least a quarter of the shortest wave; then secants and bisection around the first change
// of sign. Each look at the surface is a search as surface_query.comp has it.
//
// Three things differ. Places along a ray are floats, so they are off by some 1e-7 of the way. A look begins its search
// with the particle of the look before. And far from the water a search ends early. Of a default sea a ray from above
// then takes 1.6 evaluations a look; it took 3.6 when each search began with a first guess and went to its end, 2.1
// without the last of the three.
//
// Four lanes share a ray, as they share a place in surface_search.glsl; a workgroup goes on until its last ray is done.
// A ray has a limit of looks, because a device that is busy for seconds is taken for dead.
//
// Floor: an evaluation a look, 3.6 kB of texels from caches for 14 tiles; a ray at 45 degrees takes 18 looks, one that
// grazes
// 130.

#include "shared/fields.h"
#include "shared/query.h"

const uint THREADS = SW_QUERY_LANES * SW_QUERY_POINTS;
layout(local_size_x = THREADS) in;
layout(constant_id = 0) const bool WITH_INPUTS = false;
layout(constant_id = 1) const bool WITH_FLOW = false;
layout(constant_id = 2) const bool WITH_DISPLACEMENT = false;
layout(constant_id = 3) const bool WITH_RIBBONS = false;
const bool WITH_HOLES = true;
const bool WITH_PLACE_FLOW = false;

layout(std140, binding = 0) uniform Tiles
{
    swQueryTile tiles[SW_LIMIT_TILES];
};
layout(std430, binding = 1) readonly buffer Waves
{
    swQueryWave waves[];
};
layout(std430, binding = 2) readonly buffer Texels
{
    vec4 texels[];
};
layout(std430, binding = 3) readonly buffer Points
{
    uint points[]; // swQueryRay, or eight floats: x, y, z, longest way, direction, radius
};
layout(std430, binding = 4) writeonly buffer Heights
{
    vec2 heights[]; // of the water at the hit, residual
};
layout(std430, binding = 5) writeonly buffer Hits
{
    vec2 hits[]; // distance; 1 from above, -1 from below, 0 without a hit
};
layout(std430, binding = 6) writeonly buffer Normals
{
    vec4 normals[]; // and J
};
layout(std430, binding = 7) readonly buffer InputHead
{
    swInputHead inputHead;
};
layout(std430, binding = 8) readonly buffer InputRecords
{
    swInputRecord inputRecords[];
};
layout(std430, binding = 9) readonly buffer InputNodes
{
    swInputNode inputNodes[];
};
layout(std430, binding = 10) readonly buffer InputWords
{
    float inputWords[];
};
layout(std430, binding = 11) readonly buffer Likeness
{
    float likeness[]; // of the tiles' texels, see surface_search.glsl
};
layout(push_constant) uniform Push
{
    swRayParams params;
};

shared float shares[9][THREADS];
// What inputs say. Shared memory is taken from the cache that holds texels, so there is none without inputs.
const uint ASKED = WITH_INPUTS ? 6 + SW_LIMIT_SYSTEMS : 1;
shared vec3 placeValues[ASKED][SW_QUERY_POINTS];
// Looks at waves along splines, see keepLook().
const uint KEPT_LOOKS = WITH_RIBBONS ? 8 * SW_QUERY_RIBBON_SYSTEMS : 1;
shared vec4 keptLooks[KEPT_LOOKS][SW_QUERY_POINTS];
shared uint isBusy[2]; // whether a ray goes on; in turns, so that one can be read while the other is cleared

#include "lib/turns.glsl"
#include "query/query_place.glsl"
#include "query/surface_search.glsl"

const uint MOST_REFINEMENTS = 60;

struct Ray
{
    Place place;
    float y;  // above sea level, m
    vec3 way; // of length one
    float longest, radius;
};

struct March
{
    float at, end;
    float before, after; // around the change of sign
    float gapBefore, gapAfter;
    float side; // where it began: 1 above, -1 below
    bool hasLooked, isRefining, isHit;
    uint looks, refinements;
};

// Of the bits of a float: a number from 0 to `most`; -0 is one.
bool isLength(uint bits, float most)
{
    return bits <= floatBitsToUint(most) || bits == 0x80000000u;
}

// The direction, of length one; 0 of one that is none. The largest part is made 1 first, so that no square overflows.
vec3 unitOfBits(uvec3 bits)
{
    const float most = 3.4e38;
    bool isGood = isNumber(bits.x, most) && isNumber(bits.y, most) && isNumber(bits.z, most);
    vec3 way = isGood ? uintBitsToFloat(bits) : vec3(0.0);
    float largest = max(max(abs(way.x), abs(way.y)), abs(way.z));
    return largest > 1.2e-38 ? normalize(way / largest) : vec3(0.0);
}

Ray readRay(uint point)
{
    uint at = params.source.firstWord + point * params.source.pointWords;
    Ray ray;
    if (params.source.isFloatPoint != 0)
    {
        ray.place = placeOfBits(uvec2(points[at], points[at + 2]));
        ray.y = uintBitsToFloat(points[at + 1]);
        ray.longest = uintBitsToFloat(points[at + 3]);
        ray.way = unitOfBits(uvec3(points[at + 4], points[at + 5], points[at + 6]));
        ray.radius = uintBitsToFloat(points[at + 7]);
        bool isGood = isNumber(points[at + 1], SW_QUERY_HIGHEST) && isLength(points[at + 3], 1e5) &&
                      isLength(points[at + 7], 100.0) && ray.way != vec3(0.0);
        ray.place.isBad = ray.place.isBad || !isGood;
    }
    else
    {
        ivec2 cell = ivec2(points[at + 2], points[at + 3]);
        ray.place = Place(cell, uintBitsToFloat(uvec2(points[at], points[at + 1])), cell.x == SW_QUERY_NOWHERE);
        ray.y = uintBitsToFloat(points[at + 4]);
        ray.way = uintBitsToFloat(uvec3(points[at + 5], points[at + 6], points[at + 7]));
        ray.longest = uintBitsToFloat(points[at + 8]);
        ray.radius = uintBitsToFloat(points[at + 9]);
    }
    ray.y += params.level;
    return ray;
}

// ---- the march ----

// Confined to heights that the sea can reach; false if the ray never comes there.
bool beginMarch(Ray ray, out March march)
{
    march = March(0.0, ray.longest, 0.0, 0.0, 0.0, 0.0, 0.0, false, false, false, 0, 0);
    float more = ray.radius + 0.001; // a hair more, so that a ray that ends on flat water meets it
    if (ray.way.y == 0.0)
    {
        return ray.y >= params.low - more && ray.y <= params.high + more;
    }
    float a = (params.low - more - ray.y) / ray.way.y;
    float b = (params.high + more - ray.y) / ray.way.y;
    march.at = max(0.0, min(a, b));
    march.end = min(ray.longest, max(a, b));
    return march.at <= march.end;
}

Place placeAt(Ray ray, float distance)
{
    Place place = placeOf(ray.place.rest + ray.way.xz * distance);
    place.cell += ray.place.cell;
    return place;
}

// How far the centre is above the water; of a sphere, from the plane that touches the water.
float gapOf(Ray ray, float at, Sum surface)
{
    float gap = ray.y + ray.way.y * at - surface.value.y;
    return ray.radius > 0.0 ? gap * normalOf(surface).y : gap;
}

void refine(inout March march)
{
    float width = march.after - march.before;
    float secant = march.before + width * march.gapBefore / (march.gapBefore - march.gapAfter);
    bool isInside = secant > march.before && secant < march.after;
    march.at = isInside && march.refinements % 3 != 2 ? secant : march.before + 0.5 * width;
    march.refinements += 1;
}

bool closeIn(float gap, inout March march)
{
    // As near as floats can tell.
    bool isNarrow = march.after - march.before <= 2.5e-7 * march.after + 1e-7;
    march.isHit = abs(gap) <= params.tolerance || isNarrow || march.refinements >= MOST_REFINEMENTS;
    if (march.isHit)
    {
        return false;
    }
    if (gap > 0.0)
    {
        march.before = march.at;
        march.gapBefore = gap;
    }
    else
    {
        march.after = march.at;
        march.gapAfter = gap;
    }
    refine(march);
    return true;
}

bool stepOn(Ray ray, float gap, inout March march)
{
    march.hasLooked = true;
    march.before = march.at;
    march.gapBefore = gap;
    if (march.at >= march.end || march.looks >= params.mostLooks)
    {
        return false;
    }
    float sideways = length(ray.way.xz);
    float least = 0.25 * params.shortest / max(sideways, 0.25);
    march.at = min(march.at + max(0.7 * gap / (abs(ray.way.y) + sideways), least), march.end);
    return true;
}

// Takes in a look and chooses the next. False when done.
bool advanceMarch(Ray ray, Sum surface, inout March march)
{
    float above = gapOf(ray, march.at, surface);
    march.looks += 1;
    march.side = march.hasLooked ? march.side : above >= 0.0 ? 1.0 : -1.0;
    float gap = march.side * above - ray.radius;
    if (march.isRefining)
    {
        return closeIn(gap, march);
    }
    if (gap > 0.0)
    {
        return stepOn(ray, gap, march);
    }
    if (!march.hasLooked) // it began there
    {
        march.isHit = true;
        return false;
    }
    march.after = march.at;
    march.gapAfter = gap;
    march.isRefining = true;
    refine(march);
    return true;
}

// Whether the water is cut away where the ray met it; of a sphere, where it touches.
Ask askHoleOfHit(Ray ray, March march, Sum surface)
{
    Place place = placeAt(ray, march.at);
    float back = ray.radius > 0.0 ? gapOf(ray, march.at, surface) : 0.0;
    vec2 rest = place.rest - back * normalOf(surface).xz;
    return askHole(seaPlaceAt(place.cell, rest), surface.value.y);
}

// Goes on behind a crossing in a hole, on the other side: farther than the crossing is exact, and than a sphere
// reaches. False if that is behind its end, or it has looked often enough.
bool passHole(Ray ray, inout March march)
{
    march.at += 4.0 * params.tolerance + 2.0 * ray.radius;
    march.hasLooked = march.isRefining = march.isHit = false;
    march.refinements = 0;
    return march.at < march.end && march.looks < params.mostLooks;
}

// Whether a search may end before its tolerance: far from the water a step needs no more than the gap's second digit.
bool isNearEnough(Ray ray, March march, Search search)
{
    return march.hasLooked && !march.isRefining &&
           sqrt(search.bestSquare) < 0.02 * abs(march.side * gapOf(ray, march.at, surfaceOf(search)) - ray.radius);
}

// The search of the next look begins with the particle that the last one found and takes the step from there that
// Newton's iteration takes, whose gradients are known.
Search searchAgain(Ray ray, March march, float from, Search last)
{
    Search search = beginSearch(placeAt(ray, march.at));
    vec2 way = ray.way.xz * (march.at - from);
    search.iteration = 1; // no first guess
    search.offset = last.bestOffset - way - newtonStep(last.bestOffset + last.best.value.xz - way, last.best);
    return search;
}

// ---- answers ----

void storeBad(uint point, uint lane)
{
    float none = noNumber();
    if (lane == 0)
    {
        heights[point] = vec2(none);
    }
    else if (lane == 1)
    {
        hits[point] = vec2(none);
    }
    else if (lane == 2 && (params.outputs & SW_QUERY_WANTS_NORMAL) != 0)
    {
        normals[point] = vec4(none);
    }
}

// One lane for each output. Without a hit the distance is the whole way, or how far it was looked along.
void store(uint point, Ray ray, March march, Search search, uint lane)
{
    if (ray.place.isBad)
    {
        storeBad(point, lane);
    }
    else if (lane == 0)
    {
        heights[point] = march.isHit ? vec2(surfaceOf(search).value.y, sqrt(search.bestSquare)) : vec2(0.0);
    }
    else if (lane == 1)
    {
        bool isGivenUp = march.looks >= params.mostLooks && march.at < march.end;
        float missed = isGivenUp ? march.at : ray.longest;
        hits[point] = march.isHit ? vec2(march.at, march.side) : vec2(missed, 0.0);
    }
    else if (lane == 2 && (params.outputs & SW_QUERY_WANTS_NORMAL) != 0)
    {
        normals[point] = march.isHit ? normalOf(surfaceOf(search)) : vec4(0.0);
    }
}

// ---- a turn ----

Ask askFor(uint what, Ray ray, March march, Search search, Sum sum)
{
    switch (what)
    {
    case ASK_WAVES:
        return askTried(search, sum);
    case ASK_HEIGHT:
        return askFound(search);
    case ASK_HOLE:
        return askHoleOfHit(ray, march, surfaceOf(search));
    default:
        return askElement(search, what);
    }
}

// A lane's part of a turn: takes in what was summed up, goes on along the ray once a search is done, and asks for what
// inputs say where the search goes next. `isFirst`: nothing was summed up yet. Returns whether the ray goes on.
bool takeTurn(bool isFirst, Ray ray, inout March march, inout Search search, uint lane)
{
    bool isMarching = true, isSearching = true;
    float from = march.at; // where the ray has looked last
    Sum sum = NO_WATER;
    uint systems = 0, what = ASK_WAVES;
    if (!isFirst)
    {
        sum = gatherSum();
    }
    else if (WITH_INPUTS)
    {
        systems = weighedSystems(search);
        what = nextElement(search, systems, ASK_FIELD + lane);
    }
    else
    {
        what = ASK_END;
    }
    while (what != ASK_END)
    {
        Ask ask;
        bool isAnything = WITH_INPUTS && (what >= ASK_HOLE || WITH_DISPLACEMENT);
        if (isAnything)
        {
            ask = askFor(what, ray, march, search, sum);
            answer(ask);
        }
        uint done = what;
        bool looksAgain = false, begins = false;
        what = ASK_END;
        if (done == ASK_WAVES)
        {
            if (WITH_DISPLACEMENT)
            {
                sum = sumOf(ask);
            }
            search.hasPlace = true;
            isSearching = advance(search, sum);
            what = ASK_HEIGHT;
        }
        else if (done == ASK_HEIGHT)
        {
            if (WITH_DISPLACEMENT)
            {
                search.raised = raisedBy(ask, search.best);
            }
            if (!isSearching || isNearEnough(ray, march, search))
            {
                isMarching = advanceMarch(ray, surfaceOf(search), march);
                looksAgain = isMarching;
                what = WITH_INPUTS && march.isHit ? ASK_HOLE : ASK_END;
            }
            else
            {
                begins = true;
            }
        }
        else if (done == ASK_HOLE)
        {
            isMarching = ask.said.plain.value.x < 0.0 && passHole(ray, march);
            looksAgain = isMarching;
        }
        else if (WITH_INPUTS)
        {
            keepElement(ask);
            what = nextElement(search, systems, done + SW_QUERY_LANES);
        }
        if (looksAgain)
        {
            search = searchAgain(ray, march, from, search);
            begins = true;
        }
        if (WITH_INPUTS && begins)
        {
            systems = weighedSystems(search);
            what = nextElement(search, systems, ASK_FIELD + lane);
        }
    }
    return isMarching;
}

void main()
{
    uint lane = gl_LocalInvocationIndex % SW_QUERY_LANES;
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint point = group * SW_QUERY_POINTS + gl_LocalInvocationIndex / SW_QUERY_LANES;
    Ray ray = readRay(min(point, params.source.count - 1));
    March march;
    bool isMarching = beginMarch(ray, march) && !ray.place.isBad && point < params.source.count;
    Search search = beginSearch(placeAt(ray, march.at));
    querySystems = WITH_INPUTS ? systemsOfQuery() : 0u;
    if (gl_LocalInvocationIndex == 0)
    {
        isBusy[0] = 0;
    }
    barrier();
    bool isFirst = true;
    for (uint turn = 0;; turn ^= 1)
    {
        if (isMarching)
        {
            isMarching = takeTurn(isFirst, ray, march, search, lane);
        }
        isFirst = false;
        if (isMarching)
        {
            isBusy[turn] = 1;
        }
        barrier();
        if (isBusy[turn] == 0)
        {
            break;
        }
        if (isMarching)
        {
            share(addSearched(search, lane));
        }
        if (gl_LocalInvocationIndex == 0)
        {
            isBusy[turn ^ 1] = 0;
        }
        barrier();
    }
    if (point < params.source.count)
    {
        store(point, ray, march, search, lane);
    }
}
