// SPDX-License-Identifier: MIT
// What a GPU query reads. A place is a whole number of cells from an origin that the host chooses, and a rest in
// metres. Along an axis a tile repeats, so of a place only the fraction of a turn counts that it is into a tile (or a
// wave). What cells add to it are integers modulo 2^32, exact however many cells there are; only the rest, less than a
// cell, is floating point. So an answer is as good 1,000 km away as at the origin.
#ifndef SW_SHARED_QUERY_H
#define SW_SHARED_QUERY_H
#include "depth_share.h"
#include "limits.h"
#include "types.h"

// m. A power of two: splitting a float at it is exact.
#define SW_QUERY_CELL 128.0f

// Lanes that share a point: one for each column of a spline's window.
#define SW_QUERY_LANES 4
// Points of a workgroup.
#define SW_QUERY_POINTS 8
// Systems whose waves may run along splines: those of the lowest slots.
#define SW_QUERY_RIBBON_SYSTEMS 8

// Bits of swQueryParams::outputs, the same as swGpuQueryOutput.
#define SW_QUERY_WANTS_SIDEWAYS 1
#define SW_QUERY_WANTS_NORMAL 2
#define SW_QUERY_WANTS_VELOCITY 4
#define SW_QUERY_WANTS_ACCELERATION 8
// Level of still water, of the water below, too; and the distance to holes, of a surface with SW_QUERY_WANTS_SIDEWAYS.
#define SW_QUERY_WANTS_STILL 16

// Where a query's points lie.
SW_PARAMS(swQuerySource)
{
    sw_uint count;
    sw_uint firstWord; // of the bound buffer
    sw_uint pointWords;
    sw_uint isFloatPoint; // 1: points are two or three floats, m from the origin; 0: they are swQueryPoint
};
SW_PARAMS_SIZE(swQuerySource, 16);

// The waves that count, and how to search.
SW_PARAMS(swQueryWater)
{
    sw_uint tileCount;
    sw_uint longTileCount; // how many of the first tiles make the first guess; all of them: there is none
    sw_uint waveCount;
    sw_uint longWaveCount; // the same for free waves
    sw_uint maxIterations;
    float toleranceSquare; // m^2
    // How many of the first tiles need not be looked up again after a step of at most so many metres: after the first
    // evaluation, and after those that follow.
    sw_uint farTileCount, nearTileCount;
    float farReach, nearReach;
    float minWavelength; // m: shorter waves do not count
};
SW_PARAMS_SIZE(swQueryWater, 44);

// Where the query's origin lies in the sea, see shared/input.h.
SW_PARAMS(swQuerySea)
{
    sw_int cellX, cellZ;
    float restX, restZ;
};
SW_PARAMS_SIZE(swQuerySea, 16);

SW_PARAMS(swQueryParams)
{
    swQuerySource source;
    swQueryWater water;
    swQuerySea sea;
    sw_uint outputs;
    sw_uint velocityTexels; // from a tile's displacement to its velocity, in texels
    sw_uint accelerationTexels;
};
SW_PARAMS_SIZE(swQueryParams, 88);

SW_PARAMS(swQueryPoint)
{
    float x, z; // m, in [0, SW_QUERY_CELL)
    sw_int cellX, cellZ;
};
SW_PARAMS_SIZE(swQueryPoint, 16);

// In cellX, of a point that cannot be answered: its answers are NaN.
#define SW_QUERY_NOWHERE (-2147483647)

// Farthest that a point may be from the query's origin, m: cells must fit 32 bits.
#define SW_QUERY_FARTHEST 1e11f

// A tile as seen from the origin; the longest come first. Turns are fractions of 2^32.
SW_PARAMS(swQueryTile)
{
    sw_uint turnsX, turnsZ; // where the origin is in the tile
    sw_uint cellTurns;      // of a cell
    float turnsPerMetre;
    float texelsPerMetre;
    sw_uint firstTexel;
    sw_uint resolutionBits; // log2 of the resolution
    float waveNumber;       // in the middle of the tile's waves, rad/m
    sw_uint system;
    float strength, perFreeDepth; // of swAttenuation, which as a struct would lie elsewhere in a uniform block
    // Of copies that a flow carries, see shared/carry.h: how far the first is in its period, a fraction of 2^32, and
    // the period, s; 0: a flow does not carry the tile.
    sw_uint carryTurns;
    float carryPeriod;
    sw_uint unused0, unused1, unused2;
};
SW_PARAMS_SIZE(swQueryTile, 64);

// A free wave as seen from the origin, see swFreeWave; the longest come first.
SW_PARAMS(swQueryWave)
{
    sw_uint phase; // at the origin, now
    sw_uint cellTurnsX, cellTurnsZ;
    float amplitude; // m
    float dx, dz;
    float turnsX, turnsZ; // turns a metre
    float rate;           // rad/s
    float depth;          // m
    float waveNumber;     // of its octave, rad/m
    sw_uint system;
    swAttenuation attenuation;
    sw_uint groupEnd; // one past the last of those that are carried together
    sw_uint carryTurns;
    float carryPeriod;
};
SW_PARAMS_SIZE(swQueryWave, 68);

// ---- the water below ----

// Places of a workgroup, and waves that it holds at once.
#define SW_VOLUME_POINTS 64
#define SW_VOLUME_CHUNK 256
// Modes that a workgroup makes waves of.
#define SW_VOLUME_MODES 64

// Highest and lowest level of a place, m.
#define SW_QUERY_HIGHEST 1e12f

// Waves fade with depth as exp(-k y); they are left out where that is below exp(-20).
#define SW_VOLUME_FADED 20.0f

SW_PARAMS(swVolumeParams)
{
    swQuerySource source;
    sw_uint outputs;
    sw_uint tileCount;
    sw_uint waveCount; // free waves
    sw_uint isWheeler; // heights count from the moving surface [Wheeler 1970]
    float bottom;      // m below still water, 1e30 for deep water
    float level;       // of the places' own zero above sea level, m
};
SW_PARAMS_SIZE(swVolumeParams, 40);

// A tile whose waves are summed one by one, as seen from the origin; the longest come first.
SW_PARAMS(swVolumeTile)
{
    sw_uint turnsX, turnsZ; // as swQueryTile has them
    sw_uint cellTurns;
    float turnsPerMetre;
    sw_uint firstWave; // its waves are those of its modes
    sw_uint waveCount;
    float maxWavelength; // m
    float depth;         // m
};
SW_PARAMS_SIZE(swVolumeTile, 32);

// A pair of opposite waves at a time. With theta = 2 pi q x / side the height is re cos theta - im sin theta.
SW_PARAMS(swVolumeWave)
{
    float re, im;             // m
    float rateRe, rateIm;     // m/s
    float k;                  // rad/m
    float square;             // of the angular frequency
    float unitX, unitZ;       // of the wave vector
    sw_uint binX, binZ;       // q, modulo 2^32
    float overSinh, overCosh; // 1 / (1 -+ exp(-2 k depth))
};
SW_PARAMS_SIZE(swVolumeWave, 48);

// ---- rays ----

SW_PARAMS(swRayParams)
{
    swQuerySource source;
    swQueryWater water;
    swQuerySea sea;
    sw_uint outputs;
    float level;       // of the rays' own zero above sea level, m
    float low, high;   // between which all water is, m above sea level
    float shortest;    // wave that counts, m
    float tolerance;   // m
    sw_uint mostLooks; // of a ray
};
SW_PARAMS_SIZE(swRayParams, 104);

// A ray, or a sphere along one. Begins as swQueryPoint does.
SW_PARAMS(swQueryRay)
{
    float x, z;
    sw_int cellX, cellZ;
    float y;                // m above the rays' own zero
    float wayX, wayY, wayZ; // of length one
    float longest;          // m
    float radius;           // m
};
SW_PARAMS_SIZE(swQueryRay, 40);
#endif
