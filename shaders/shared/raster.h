// SPDX-License-Identifier: MIT
// Between four cells of a raster. Raw depth is answered bilinearly, as splines overshoot at quays.
#ifndef SW_SHARED_RASTER_H
#define SW_SHARED_RASTER_H

#include "types.h"

// Between two cells; at the cells themselves their values to the bit.
SW_FORMULA float swMixCells(float a, float b, float part)
{
    return part <= SW_FLOAT(0.0) ? a : part >= SW_FLOAT(1.0) ? b : a + (b - a) * part;
}

SW_FORMULA float swMixFourCells(float northWest, float northEast, float southWest, float southEast, float east,
                                float south)
{
    return swMixCells(swMixCells(northWest, northEast, east), swMixCells(southWest, southEast, east), south);
}

#endif
