// SPDX-License-Identifier: MIT
// What the wave passes read on the GPU: tiles, and the part of a tile that a slice sees.
//
// Tile texels on the GPU are vec4 (x, y, z, 0) at texels[first + row * (resolution + 3) + column], laid out as in
// core/frame/frame.h: the window of spline coordinate s begins at floor(s), columns repeat so that it never wraps.
#ifndef SW_SHARED_WAVES_H
#define SW_SHARED_WAVES_H
#include "limits.h"
#include "types.h"

SW_PARAMS(swTileParams)
{
    sw_uint firstRow;   // entry of the row table that holds where row 0's modes begin; maxBin + 2 entries
    sw_uint firstLine;  // of the intermediate rows, in complex numbers
    sw_uint firstTexel; // of the texels, in vec4
    sw_uint resolution;
    sw_uint maxBin;
    sw_uint phaseLow; // the step's ticks, 64 bits
    sw_uint phaseHigh;
    float weight;
    float side;          // m
    float minWavelength; // m
    float maxWavelength;
    float slopeVarianceX; // E[(dh/dx)^2], with weight
    float slopeVarianceZ;
    float unused0, unused1, unused2;
};
SW_PARAMS_SIZE(swTileParams, 64);

// A tile in a slice. Spline coordinate of column c: fraction + c * step, counted from texel column `base`.
SW_PARAMS(swSliceTile)
{
    float fractionX, fractionZ; // in [0, 1)
    float step;                 // spline units a texel
    float perMetre;             // spline units a metre: resolution / side
    sw_uint baseX, baseZ;       // in [0, resolution)
    sw_uint firstTexel;
    sw_uint resolution;
};
SW_PARAMS_SIZE(swSliceTile, 32);

// The tiles of a slice: tiles[first .. first + count).
SW_PARAMS(swSliceList)
{
    sw_uint first;
    sw_uint count;
};
SW_PARAMS_SIZE(swSliceList, 8);

SW_PARAMS(swFoamSliceParams)
{
    float deviation; // of J, from waves that the slice does not carry
    float keep, grow, ceiling;
    float threshold;
    sw_uint reset; // 1: start from the steady state
    sw_uint unused0, unused1;
};
SW_PARAMS_SIZE(swFoamSliceParams, 32);
#endif
