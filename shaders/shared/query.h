// SPDX-License-Identifier: MIT
// What a GPU query reads. A place is a whole number of cells from an origin that the host chooses, and a rest in metres.
// Along an axis a tile repeats, so of a place only the fraction of a turn counts that it is into a tile (or a wave). What
// cells add to it are integers modulo 2^32, exact however many cells there are; only the rest, less than a cell, is
// floating point. So an answer is as good 1,000 km away as at the origin.
#ifndef SW_SHARED_QUERY_H
#define SW_SHARED_QUERY_H
#include "limits.h"
#include "types.h"

// m. A power of two: splitting a float at it is exact.
#define SW_QUERY_CELL 128.0f

// Lanes that share a point: one for each column of a spline's window.
#define SW_QUERY_LANES 4
// Points of a workgroup.
#define SW_QUERY_POINTS 16

// Bits of swQueryParams::outputs, the same as swGpuQueryOutput.
#define SW_QUERY_WANTS_SIDEWAYS 1
#define SW_QUERY_WANTS_NORMAL 2
#define SW_QUERY_WANTS_VELOCITY 4
#define SW_QUERY_WANTS_ACCELERATION 8

SW_PARAMS(swQueryParams)
{
    sw_uint pointCount;
    sw_uint firstPoint;   // of the bound buffer
    sw_uint isFloatPoint; // 1: points are two floats, m from the origin; 0: they are swQueryPoint
    sw_uint outputs;
    sw_uint tileCount;
    sw_uint longTileCount; // how many of the first tiles make the first guess; all of them: there is none
    sw_uint waveCount;
    sw_uint longWaveCount; // the same for free waves
    sw_uint maxIterations;
    float toleranceSquare;  // m^2
    sw_uint velocityTexels; // from a tile's displacement to its velocity, in texels
    sw_uint accelerationTexels;
};
SW_PARAMS_SIZE(swQueryParams, 48);

SW_PARAMS(swQueryPoint)
{
    float x, z; // m, in [0, SW_QUERY_CELL)
    sw_int cellX, cellZ;
};
SW_PARAMS_SIZE(swQueryPoint, 16);

// A tile as seen from the origin; the longest come first. Turns are fractions of 2^32.
SW_PARAMS(swQueryTile)
{
    sw_uint turnsX, turnsZ; // where the origin is in the tile
    sw_uint cellTurns;      // of a cell
    float turnsPerMetre;
    float texelsPerMetre;
    sw_uint firstTexel;
    sw_uint resolutionBits; // log2 of the resolution
    sw_uint unused0;
};
SW_PARAMS_SIZE(swQueryTile, 32);

// A free wave as seen from the origin, see swFreeWave; the longest come first.
SW_PARAMS(swQueryWave)
{
    sw_uint phase; // at the origin, now
    sw_uint cellTurnsX, cellTurnsZ;
    float amplitude; // m
    float dx, dz;
    float turnsX, turnsZ; // turns a metre
    float rate;           // rad/s
};
SW_PARAMS_SIZE(swQueryWave, 36);
#endif
