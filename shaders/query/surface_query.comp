// SPDX-License-Identifier: MIT
#version 460
#extension GL_GOOGLE_include_directive : require

// The surface above points of the plane: the GPU's twin of core/query/query_surface.c. The search is in
// surface_search.glsl.
//
// Velocity and acceleration are looked up once, where the search ended, in texels of their own. A query that wants
// neither has a pipeline without them.
//
// Measured on an H100, 100,000 points of a default sea: 145 us scattered over 10 km, 110 us on a grid of 0.5 m; points
// take 2.6 evaluations after the first guess, of which only the first looks up all tiles (surface_search.glsl): without
// that it took 186 and 124 us. Slower were: no first guess, lanes that take another point as soon as theirs is done,
// tiles in a storage buffer, all four weights along x in every lane, two tiles at a time, and workgroups of 64 and 128.

#include "shared/fields.h"
#include "shared/query.h"

const uint THREADS = SW_QUERY_LANES * SW_QUERY_POINTS;
layout(local_size_x = THREADS) in;
layout(constant_id = 0) const bool WITH_MOTION = false;
layout(constant_id = 1) const bool WITH_INPUTS = false;
layout(constant_id = 2) const bool WITH_FLOW = false;
layout(constant_id = 3) const bool WITH_DISPLACEMENT = false;
layout(constant_id = 4) const bool WITH_RIBBONS = false;
const bool WITH_HOLES = true;
const bool WITH_PLACE_FLOW = WITH_MOTION && WITH_FLOW;

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
    uint points[];
};
layout(std430, binding = 4) writeonly buffer Heights
{
    vec2 heights[]; // above sea level, residual
};
layout(std430, binding = 5) writeonly buffer Sideways
{
    vec2 sideways[];
};
layout(std430, binding = 6) writeonly buffer Normals
{
    vec4 normals[]; // and J
};
layout(std430, binding = 7) writeonly buffer Velocities
{
    vec4 velocities[]; // and 0
};
layout(std430, binding = 8) writeonly buffer Accelerations
{
    vec4 accelerations[]; // and 0
};
layout(std430, binding = 9) readonly buffer InputHead
{
    swInputHead inputHead;
};
layout(std430, binding = 10) readonly buffer InputRecords
{
    swInputRecord inputRecords[];
};
layout(std430, binding = 11) readonly buffer InputNodes
{
    swInputNode inputNodes[];
};
layout(std430, binding = 12) readonly buffer InputWords
{
    float inputWords[];
};
layout(std430, binding = 13) writeonly buffer Stills
{
    vec2 stills[]; // level of still water, distance to the edge of holes
};
layout(std430, binding = 14) readonly buffer Likeness
{
    float likeness[]; // of the tiles' texels, see surface_search.glsl
};
layout(push_constant) uniform Push
{
    swQueryParams params;
};

shared float shares[9][THREADS];
// What inputs say. Shared memory is taken from the cache that holds texels, so there is none without inputs.
const uint ASKED = WITH_INPUTS ? 6 + SW_LIMIT_SYSTEMS : 1;
shared vec3 placeValues[ASKED][SW_QUERY_POINTS];
// Looks at waves along splines, see keepLook().
const uint KEPT_LOOKS = WITH_RIBBONS ? 8 * SW_QUERY_RIBBON_SYSTEMS : 1;
shared vec4 keptLooks[KEPT_LOOKS][SW_QUERY_POINTS];
shared uint isBusy[2]; // whether a point goes on; in turns, so that one can be read while the other is cleared

#include "lib/turns.glsl"
#include "query/query_place.glsl"
#include "query/query_points.glsl"
#include "query/surface_search.glsl"

// ---- motion ----

// Velocity and acceleration of a particle. Of a lane: its share.
struct Motion
{
    vec3 velocity;
    vec3 acceleration;
};

void addTileMotion(swQueryTile tile, ivec2 cell, vec2 rest, uint lane, vec4 cubic, inout Motion motion)
{
    Column column = findColumn(tile, cell, rest, lane);
    float valueX = weightAlongX(column, cubic);
    vec4 valueZ = swSplineWeights(column.fractionZ);
    if (params.velocityTexels != 0)
    {
        uint field = params.velocityTexels;
        motion.velocity += valueX * weigh(valueZ, texelOf(column, field, 0), texelOf(column, field, 1),
                                          texelOf(column, field, 2), texelOf(column, field, 3));
    }
    if (params.accelerationTexels != 0)
    {
        uint field = params.accelerationTexels;
        motion.acceleration += valueX * weigh(valueZ, texelOf(column, field, 0), texelOf(column, field, 1),
                                              texelOf(column, field, 2), texelOf(column, field, 3));
    }
}

void addWaveMotion(swQueryWave wave, ivec2 cell, vec2 rest, inout Motion motion)
{
    vec2 rate = wave.rate * swingOf(wave, cell, rest);
    motion.velocity += vec3(wave.dx * rate.x, rate.y, wave.dz * rate.x);
    motion.acceleration += wave.rate * vec3(wave.dx * rate.y, -rate.x, wave.dz * rate.y);
}

const Motion NO_MOTION = Motion(vec3(0.0), vec3(0.0));

Motion addMotion(ivec2 cell, vec2 rest, uint lane)
{
    vec4 cubic = splineCubic(lane);
    Motion motion = NO_MOTION;
    for (uint i = 0; i < params.water.tileCount; ++i)
    {
        addTileMotion(tiles[i], cell, rest, lane, cubic, motion);
    }
    for (uint i = lane; i < params.water.waveCount; i += SW_QUERY_LANES)
    {
        addWaveMotion(waves[i], cell, rest, motion);
    }
    return motion;
}

void addMotionCopy(float weight, Motion own, inout Motion motion)
{
    motion.velocity += weight * own.velocity;
    motion.acceleration += weight * own.acceleration;
}

// A lane's share of a tile's copies, see carriedTile().
Motion carriedTileMotion(swQueryTile tile, Flow flow, ivec2 cell, vec2 rest, uint lane, vec4 cubic, inout Shape shape)
{
    Carry carry = carryOf(tile.carryTurns, tile.carryPeriod);
    float between = 0.5 * tile.carryPeriod;
    shape = carried(shape, carry, between, flow, likenessOf(tile, between * flow.velocity));
    Motion motion = NO_MOTION;
    for (uint c = 0; c < 2; ++c)
    {
        Motion own = NO_MOTION;
        addTileMotion(tile, cell, rest - carry.seconds[c] * flow.velocity, lane, cubic, own);
        addMotionCopy(carry.weights[c], own, motion);
    }
    return motion;
}

void addCarriedWavesMotion(Shaper shaper, ivec2 cell, vec2 rest, uint lane, inout Motion motion)
{
    uint turn = 0, waveCount = params.water.waveCount;
    for (uint first = 0; first < waveCount; ++turn)
    {
        uint end = min(waves[first].groupEnd, waveCount);
        Carry carry = carryOf(waves[first].carryTurns, waves[first].carryPeriod);
        float between = 0.5 * waves[first].carryPeriod;
        if (turn % SW_QUERY_LANES == lane)
        {
            Shape shape = shapeOf(shaper, waves[first].system, waves[first].waveNumber, waves[first].attenuation);
            shape = carried(shape, carry, between, shaper.flow, likenessOf(first, end, between * shaper.flow.velocity));
            for (uint c = 0; c < 2; ++c)
            {
                Motion own = NO_MOTION;
                for (uint i = first; i < end; ++i)
                {
                    addWaveMotion(waves[i], cell, rest - carry.seconds[c] * shaper.flow.velocity, own);
                }
                addMotionCopy(shape.weight * carry.weights[c], own, motion);
            }
        }
        first = end;
    }
}

// The rates of a tile's waves as a look sees them, a lane's share.
void addLookedTileMotion(Look look, Flow flow, Ground ground, swQueryTile tile, uint lane, vec4 cubic,
                         inout Motion motion)
{
    Shape shape = attenuated(look.shape, ground, tile.waveNumber, attenuationOf(tile));
    Carry carry = carriedCopies(tile, flow, shape);
    for (uint c = 0; c < copyCount(carry); ++c)
    {
        Motion own = NO_MOTION;
        addTileMotion(tile, queryCellOf(look.at), queryRestOf(look.at) - carry.seconds[c] * flow.velocity, lane, cubic,
                      own);
        addMotionCopy(shape.weight * carry.weights[c],
                      Motion(turnByLook(look, own.velocity), turnByLook(look, own.acceleration)), motion);
    }
}

void addLookedWavesMotion(Look look, Flow flow, Ground ground, uint first, uint end, inout Motion motion)
{
    Shape shape = attenuated(look.shape, ground, waves[first].waveNumber, waves[first].attenuation);
    Carry carry = carriedCopies(first, end, flow, shape);
    for (uint c = 0; c < copyCount(carry); ++c)
    {
        Motion own = NO_MOTION;
        for (uint i = first; i < end; ++i)
        {
            addWaveMotion(waves[i], queryCellOf(look.at), queryRestOf(look.at) - carry.seconds[c] * flow.velocity, own);
        }
        addMotionCopy(shape.weight * carry.weights[c],
                      Motion(turnByLook(look, own.velocity), turnByLook(look, own.acceleration)), motion);
    }
}

// Adds the motion by waves along splines, see addRibbonWater().
void addRibbonMotion(Shaper shaper, uint lane, vec4 cubic, inout Motion motion)
{
    uint tileCount = params.water.tileCount, waveCount = params.water.waveCount;
    uint systems = ribbonSystemsOf(shaper);
    for (; systems != 0; systems &= systems - 1)
    {
        uint system = findLSB(systems);
        for (uint l = 0; l < 2; ++l)
        {
            Look look = askedLook(system, l);
            Flow flow = turnFlowByLook(look, shaper.flow);
            for (uint i = 0; i < tileCount && isLookThere(look); ++i)
            {
                if (tiles[i].system == system)
                {
                    addLookedTileMotion(look, flow, shaper.ground, tiles[i], lane, cubic, motion);
                }
            }
            uint turn = 0;
            for (uint first = 0; first < waveCount && isLookThere(look); ++turn)
            {
                uint end = min(waves[first].groupEnd, waveCount);
                if (waves[first].system == system && turn % SW_QUERY_LANES == lane)
                {
                    addLookedWavesMotion(look, flow, shaper.ground, first, end, motion);
                }
                first = end;
            }
        }
    }
}

// The same where inputs shape waves. How a particle's place changes makes no part of how it moves.
Motion addShapedMotion(Shaper shaper, ivec2 cell, vec2 rest, uint lane)
{
    vec4 cubic = splineCubic(lane);
    Motion motion = NO_MOTION;
    for (uint i = 0; i < params.water.tileCount; ++i)
    {
        Motion own = NO_MOTION;
        Shape shape = shapeOf(shaper, tiles[i].system, tiles[i].waveNumber, attenuationOf(tiles[i]));
        if (doesCarry(shaper) && tiles[i].carryPeriod > 0.0)
        {
            own = carriedTileMotion(tiles[i], shaper.flow, cell, rest, lane, cubic, shape);
        }
        else
        {
            addTileMotion(tiles[i], cell, rest, lane, cubic, own);
        }
        addMotionCopy(shape.weight, own, motion);
    }
    if (WITH_RIBBONS && shaper.ribbonSystems != 0)
    {
        addRibbonMotion(shaper, lane, cubic, motion);
    }
    if (doesCarry(shaper))
    {
        addCarriedWavesMotion(shaper, cell, rest, lane, motion);
        return motion;
    }
    for (uint i = lane; i < params.water.waveCount; i += SW_QUERY_LANES)
    {
        Motion own = NO_MOTION;
        addWaveMotion(waves[i], cell, rest, own);
        Shape shape = shapeOf(shaper, waves[i].system, waves[i].waveNumber, waves[i].attenuation);
        addMotionCopy(shape.weight, own, motion);
    }
    return motion;
}

// ---- answers ----

// One lane for each output. `hole` is how far from holes the particle is that was found.
void store(uint point, Search search, float hole, uint lane)
{
    if (lane == 0)
    {
        heights[point] = vec2(surfaceOf(search).value.y, sqrt(search.bestSquare));
    }
    else if (lane == 1 && (params.outputs & SW_QUERY_WANTS_SIDEWAYS) != 0)
    {
        sideways[point] = search.best.value.xz;
    }
    else if (lane == 2 && (params.outputs & SW_QUERY_WANTS_NORMAL) != 0)
    {
        normals[point] = normalOf(surfaceOf(search));
    }
    else if (lane == 3 && (params.outputs & SW_QUERY_WANTS_STILL) != 0)
    {
        stills[point] = vec2(WITH_INPUTS ? askedOf(ASKED_PLACE_LEVEL).x : 0.0, hole);
    }
}

// A point that cannot be answered.
void storeBad(uint point, uint lane)
{
    float none = noNumber();
    if (lane == 0)
    {
        heights[point] = vec2(none);
    }
    else if (lane == 1 && (params.outputs & SW_QUERY_WANTS_SIDEWAYS) != 0)
    {
        sideways[point] = vec2(none);
    }
    else if (lane == 2 && (params.outputs & SW_QUERY_WANTS_NORMAL) != 0)
    {
        normals[point] = vec4(none);
    }
    else if (lane == 3 && (params.outputs & SW_QUERY_WANTS_STILL) != 0)
    {
        stills[point] = vec2(none);
    }
}

Motion findMotion(ivec2 cell, vec2 rest, uint lane)
{
    if (WITH_INPUTS)
    {
        Shaper shaper = shaperAt(seaPlaceAt(cell, rest));
        if (doesShape(shaper))
        {
            return addShapedMotion(shaper, cell, rest, lane);
        }
    }
    return addMotion(cell, rest, lane);
}

// How the particle that was found moves. `rate` is that of its displacement, of lane 0 the velocity, of lane 1 the
// acceleration.
void storeMotion(uint point, bool isBad, vec3 rate, uint lane)
{
    if (lane == 0 && (params.outputs & SW_QUERY_WANTS_VELOCITY) != 0)
    {
        vec2 flow = WITH_PLACE_FLOW ? askedOf(ASKED_PLACE_FLOW).xy : vec2(0.0);
        velocities[point] = isBad ? vec4(noNumber()) : vec4(rate.x + flow.x, rate.y, rate.z + flow.y, 0.0);
    }
    else if (lane == 1 && (params.outputs & SW_QUERY_WANTS_ACCELERATION) != 0)
    {
        accelerations[point] = isBad ? vec4(noNumber()) : vec4(rate, 0.0);
    }
}

// ---- a turn ----

// What a turn begins with.
#define BEGINS_WITH_NOTHING 0u // nothing is known yet
#define BEGINS_WITH_WAVES 1u   // the waves at the tried offset
#define BEGINS_WITH_MOTION 2u  // how the particle that was found moves

bool wantsHole(uint lane)
{
    return lane == 3 && (params.outputs & SW_QUERY_WANTS_STILL) != 0 && (params.outputs & SW_QUERY_WANTS_SIDEWAYS) != 0;
}

Ask askFor(uint what, Search search, Sum sum, vec3 rate)
{
    switch (what)
    {
    case ASK_WAVES:
        return askTried(search, sum);
    case ASK_RATE:
        return askRate(seaPlaceAt(search.cell, search.place + search.bestOffset), params.water.minWavelength, rate);
    case ASK_HEIGHT:
        return askFound(search);
    case ASK_HOLE:
        return askHole(foundPlace(search), surfaceOf(search).value.y);
    default:
        return askElement(search, what);
    }
}

// Whether there is anything to ask.
bool isAnything(uint what, uint lane)
{
    return WITH_INPUTS && (what >= ASK_FIELD || (what == ASK_HOLE ? wantsHole(lane) : WITH_DISPLACEMENT));
}

// A lane's part of a turn: takes in what was summed up, and asks for what inputs say where the search goes next, or
// about what it has found. Returns whether the point goes on.
bool takeTurn(uint beginning, inout Search search, uint point, bool isBad, uint lane)
{
    bool isSearching = true;
    Sum sum = NO_WATER;
    vec3 rate = vec3(0.0);
    uint systems = 0, what = ASK_WAVES;
    if (beginning == BEGINS_WITH_WAVES)
    {
        sum = gatherSum();
    }
    else if (WITH_MOTION && beginning == BEGINS_WITH_MOTION)
    {
        what = ASK_RATE;
        rate = gatherVector(lane == 1 ? 3 : 0);
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
        if (isAnything(what, lane))
        {
            ask = askFor(what, search, sum, rate);
            answer(ask);
        }
        uint done = what;
        what = ASK_END;
        if (done == ASK_WAVES)
        {
            if (WITH_DISPLACEMENT)
            {
                sum = sumOf(ask);
            }
            isSearching = advance(search, sum);
            what = isSearching ? ASK_END : ASK_HEIGHT;
        }
        else if (WITH_MOTION && done == ASK_RATE)
        {
            storeMotion(point, isBad, WITH_DISPLACEMENT ? ask.said.plain.value.xyz : rate, lane);
        }
        else if (done == ASK_HEIGHT)
        {
            if (WITH_DISPLACEMENT)
            {
                search.raised = raisedBy(ask, search.best);
            }
            what = ASK_HOLE;
        }
        else if (done == ASK_HOLE)
        {
            store(point, search, WITH_INPUTS && wantsHole(lane) ? ask.said.plain.value.x : SW_CLIP_FAR, lane);
        }
        else if (WITH_INPUTS)
        {
            keepElement(ask);
            what = nextElement(search, systems, done + SW_QUERY_LANES);
        }
        // What was tried last may be another place than the best one, of which the motion is.
        bool begins = done == ASK_WAVES ? isSearching : WITH_MOTION && done == ASK_HOLE && search.reach < 1.0;
        if (WITH_INPUTS && begins)
        {
            search.hasPlace = true;
            search.offset = isSearching ? search.offset : search.bestOffset;
            systems = weighedSystems(search);
            what = nextElement(search, systems, ASK_FIELD + lane);
        }
    }
    return isSearching;
}

void main()
{
    uint lane = gl_LocalInvocationIndex % SW_QUERY_LANES;
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint point = group * SW_QUERY_POINTS + gl_LocalInvocationIndex / SW_QUERY_LANES;
    Place place = readPlace(min(point, params.source.count - 1));
    bool isThere = point < params.source.count, isSearching = isThere && !place.isBad;
    if (isThere && place.isBad)
    {
        storeBad(point, lane);
    }
    Search search = beginSearch(place);
    querySystems = WITH_INPUTS ? systemsOfQuery() : 0u;
    if (gl_LocalInvocationIndex == 0)
    {
        isBusy[0] = 0;
    }
    barrier();
    uint beginning = BEGINS_WITH_NOTHING;
    for (uint turn = 0;; turn ^= 1)
    {
        bool isMoving = WITH_MOTION && beginning == BEGINS_WITH_MOTION;
        if (isMoving ? isThere : isSearching)
        {
            isSearching = takeTurn(beginning, search, point, place.isBad, lane);
        }
        if (isMoving)
        {
            break;
        }
        if (isSearching)
        {
            isBusy[turn] = 1;
        }
        barrier();
        beginning = BEGINS_WITH_WAVES;
        if (isBusy[turn] == 0)
        {
            if (!WITH_MOTION)
            {
                break;
            }
            beginning = BEGINS_WITH_MOTION;
            Motion motion = findMotion(search.cell, search.place + search.bestOffset, lane);
            shareVector(0, motion.velocity);
            shareVector(3, motion.acceleration);
        }
        else if (isSearching)
        {
            share(addSearched(search, lane));
        }
        if (gl_LocalInvocationIndex == 0)
        {
            isBusy[turn ^ 1] = 0;
        }
        barrier();
    }
}
