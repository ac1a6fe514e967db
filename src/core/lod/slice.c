// SPDX-License-Identifier: MIT
#include "core/lod/slice.h"

#include <math.h>

swSlice swSnapSlice(double finestTexel, int level, int resolution, double x, double z)
{
    double texel = finestTexel * (double)((int64_t)1 << level); // a power of two: exact
    return (swSlice){
        .texel = texel,
        .firstX = (int64_t)floor(x / texel) - resolution / 2,
        .firstZ = (int64_t)floor(z / texel) - resolution / 2,
        .level = level,
        .minWavelength = (float)(SW_TEXELS_PER_WAVE * texel),
    };
}
