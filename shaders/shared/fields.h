// SPDX-License-Identifier: MIT
// Authored fields on the slices of a view: what the pass that makes them is told, and what it tells the pass that adds
// up waves of each block of texels.
#ifndef SW_SHARED_FIELDS_H
#define SW_SHARED_FIELDS_H
#include "input.h"
#include "limits.h"
#include "types.h"

// Depth where there is no floor, m.
#define SW_NO_DEPTH (-SW_NO_FLOOR)

// What stands before the records of inputs.
SW_PARAMS(swInputHead)
{
    swInputRange ranges[SW_FIELD_OF_COUNT];
    sw_uint localSystems, ribbonSystems; // see swInputSet
    float evenX, evenZ;                  // m/s, of the flow that carries all waves alike
};
SW_PARAMS_SIZE(swInputHead, 192);

// Where the texels of a slice lie: the first one's cell (see shared/input.h) and its place in it, m. Texels are powers
// of two, so that a place is the same, to the bit, while its slice moves.
SW_PARAMS(swFieldSlice)
{
    sw_int cellX, cellZ;
    float restX, restZ;
    float texel; // m
    float unused0, unused1, unused2;
};
SW_PARAMS_SIZE(swFieldSlice, 32);

// Most rectangles of texels of a slice that are made.
#define SW_MAX_FIELD_RECTS 16

// What a slice needs: core/lod/redraw.h. What is in none of the rectangles, each columns and rows [first, end), is
// kept: it was (shiftX, shiftZ) columns and rows further on.
SW_PARAMS(swFieldRedraw)
{
    sw_int shiftX, shiftZ;
    sw_uint isStill; // 1: all of it is kept where it is, and no input has changed
    sw_uint count;
    sw_int rects[4 * SW_MAX_FIELD_RECTS]; // first column, first row, column behind, row behind
};
SW_PARAMS_SIZE(swFieldRedraw, 272);

#define SW_BLOCK_FLOWS 1u     // the water flows somewhere in it
#define SW_BLOCK_DISPLACED 2u // inputs may displace the water there

#define SW_BLOCK_MAKES_FOAM 1u   // inputs may make foam in it
#define SW_BLOCK_CARRIES_FOAM 2u // the water flows somewhere in it, evenly perhaps

// A block of SW_SLICE_WIDTH x SW_SLICE_HEIGHT texels: what shapes waves there, and what makes foam.
SW_PARAMS(swFieldBlock)
{
    float leastDepth; // m, at least 0
    sw_uint systems;  // bit of each wave system, modulo 32, that has a weight of its own there
    sw_uint flags;    // SW_BLOCK_...
    float leastShore; // m from the water's edge to the texel that is nearest to it, see swFindShoreDistance()
    sw_uint foam;     // SW_BLOCK_..._FOAM
};
SW_PARAMS_SIZE(swFieldBlock, 20);
#endif
