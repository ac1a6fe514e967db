// SPDX-License-Identifier: MIT
// What the wave passes read on the GPU: tiles, and the part of a tile that a slice sees.
//
// A tile's texels on the GPU are vec4 (x, y, z, 0), N rows of N + 3 columns: texel (i, j), at first + j (N + 3) + i,
// holds the spline coefficient of sample (i - 1, j - 1) modulo N. The window of spline coordinate s begins at floor(s)
// along either axis; columns repeat, so that it never wraps along x, and row indices are taken modulo N.
#ifndef SW_SHARED_WAVES_H
#define SW_SHARED_WAVES_H
#include "depth_share.h"
#include "limits.h"
#include "types.h"

SW_PARAMS(swTileParams)
{
    sw_uint firstRow;   // entry of the row table that holds where row 0's modes begin; maxBin + 2 entries
    sw_uint firstLine;  // of what the rows pass leaves, in complex numbers; see waves_rows.comp
    sw_uint firstTexel; // of the texels, in vec4
    sw_uint resolution;
    sw_uint maxBin;
    sw_uint ticksLow; // the tile's ticks, 64 bits
    sw_uint ticksHigh;
    float weight;
    float side;          // m
    float minWavelength; // m
    float maxWavelength;
    float slopeVarianceX; // E[(dh/dx)^2], with weight
    float slopeVarianceZ;
    float depth;       // m, of the waves' dispersion
    sw_uint firstMode; // of all tiles' modes
    sw_uint modeCount;
};
SW_PARAMS_SIZE(swTileParams, 64);

// Of one dispatch of the wave passes: the tiles of a resolution, once for each field asked for. A field is the waves'
// displacement derived by time: 0 times, and for queries once (velocity) and twice (acceleration).
SW_PARAMS(swWavesParams)
{
    sw_uint firstOrder;
    sw_uint derivatives; // two bits for each field, the first field's lowest
    sw_uint fieldLines;  // from one field to the next, of what the rows pass leaves
    sw_uint fieldTexels; // the same of the texels
};
SW_PARAMS_SIZE(swWavesParams, 16);

#define SW_NO_TEXEL 0xffffffffu

// A tile in a slice, or two of different systems that lie alike and are shaped alike. Spline coordinate of column c:
// fraction + c * step, counted from texel column baseX. What a block of texels lays out of it in shared memory has
// places of its own, see slices.comp.
SW_PARAMS(swSliceTile)
{
    float fractionX, fractionZ; // in [0, 1)
    float step;                 // spline units a texel
    float perMetre;             // spline units a metre: resolution / side
    sw_uint base;               // baseX in the low half, baseZ in the high one; in [0, resolution)
    sw_uint firstTexel;
    sw_uint secondTexel; // of the second tile; SW_NO_TEXEL: there is none
    sw_uint resolution;
    sw_uint columnCount; // the most that a block touches
    sw_uint firstColumn; // among those of its batch
    sw_uint firstOfAll;  // among those of all tiles
    sw_uint batchEnd;    // of the tiles that are laid out together: one past the last
    sw_uint firstJump;
    // Likewise among what slices_shaped.comp lays out, from the last tile on.
    sw_uint shapedColumns; // as columnCount; 0: it is added texel by texel
    sw_uint firstShaped;
    sw_uint shapedBegin; // of the tiles that are laid out together: the first, counted from the list's
    float texelsPerUnit; // 1 / step
    float waveNumber;    // in the middle of the tile's waves, rad/m
    sw_uint system;
    swAttenuation attenuation;
    sw_uint cellTurns;  // how far a cell of SW_QUERY_CELL takes one through the tile, a fraction of 2^32 of a turn
    sw_uint carryTurns; // of copies that a flow carries, see swQueryTile
    float carryPeriod;
};
SW_PARAMS_SIZE(swSliceTile, 96);

// A free wave in a slice. Its phase at texel (column, row) is phase + column stepX + row stepZ, in fractions of 2^32 of
// a turn, exact as integers are.
SW_PARAMS(swSliceWave)
{
    sw_uint phase;
    sw_uint stepX, stepZ;
    float amplitude;  // m
    float dx, dz;     // chop k / |k|
    float kx, kz;     // rad/m
    float cosZ, sinZ; // of stepZ
    float waveNumber; // of its octave, rad/m
    sw_uint system;
    swAttenuation attenuation;
    sw_uint cellTurnsX, cellTurnsZ; // likewise
    sw_uint groupEnd; // of those that are carried together, counted from the slice's first wave: one past the last
    sw_uint carryTurns;
    float carryPeriod;
};
SW_PARAMS_SIZE(swSliceWave, 76);

// The waves of a slice: tiles[first .. first + count) as cubics, windowCount tiles behind them texel by texel, and
// waves[firstWave .. firstWave + waveCount).
SW_PARAMS(swSliceList)
{
    sw_uint first;
    sw_uint count;
    sw_uint windowCount;
    sw_uint firstWave;
    sw_uint waveCount;
    float texelsPerMetre;
    sw_uint groupRows;   // rows of texels whose knots are laid out together
    float minWavelength; // m: shorter waves do not count
};
SW_PARAMS_SIZE(swSliceList, 32);
#endif
