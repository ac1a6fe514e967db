// SPDX-License-Identifier: MIT
#pragma once

// Copies of authored fields in slices that move: texels whose places have been in the slice before and where nothing
// has changed are moved on, the others are made. Both halves do so by the same plan.

#include "core/frame/frame.h"

// Columns and rows [first, end).
typedef struct swTexelRect
{
    int firstX, firstZ, endX, endZ;
} swTexelRect;

#define SW_MAX_REDRAWS 16

typedef struct swRedraw
{
    int shiftX, shiftZ; // a texel that is kept was so many columns and rows further on
    int count;
    swTexelRect rects[SW_MAX_REDRAWS]; // to be made; they may overlap
} swRedraw;

SW_SEAM_BEGIN

// What a slice needs after it was at `before`. `version` is of the inputs that its texels are of.
void swPlanRedraw(const swSlice* now, const swSlice* before, int resolution, const swInputSet* inputs, uint32_t version,
                  swRedraw* redraw);
void swRedrawAll(int resolution, swRedraw* redraw);
// What lies between two points in the sea is made, too.
void swAddRedraw(const swSlice* slice, int resolution, swPosXZ low, swPosXZ high, swRedraw* redraw);
int swCountRedrawn(const swRedraw* redraw); // texels, those of overlaps more than once

SW_SEAM_END
