// SPDX-License-Identifier: MIT
#pragma once

// The waves on a view's slices: displacement and derivatives at each texel's rest point, from the tiles whose waves the
// slice can carry. The GPU's twin is shaders/waves/slices.comp.

#include "core/lod/layer_stack.h"
#include "core/waves/waves_fft.h"

// Displacement x, y, z, 0 and derivatives gx, gz, J, 0, see swView_GetDerivatives(). They take nothing from a frame but
// the waves.
void swPlanSlices(const swLayerPlan* plan);
void swStepSlices(const swLayerStep* step);

// Copy the tiles that have texels and whose waves are all at least minWavelength long; `out` has room for SW_MAX_TILES.
int swSelectSliceTiles(const swFrame* frame, float minWavelength, swTile* out);
