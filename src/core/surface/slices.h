// SPDX-License-Identifier: MIT
#pragma once

// The waves on a view's slices: displacement and derivatives at each texel's rest point, from the tiles whose waves the
// slice can carry. The GPU's twin is shaders/waves/slices.comp.

#include "core/waves/waves_fft.h"

// displacement: [slice][R][R][4] x, y, z, 0. derivatives: [slice][R][R][4] gx, gz, J, 0, see swView_GetDerivatives().
void swSampleSlices(const swHost* host, const swWaveKernels* kernels, const swFrame* frame, const swViewFrame* view,
                    float* displacement, float* derivatives);

// Copy the tiles that have texels and whose waves are all at least minWavelength long; `out` has room for SW_MAX_TILES.
int swSelectSliceTiles(const swFrame* frame, float minWavelength, swTile* out);
