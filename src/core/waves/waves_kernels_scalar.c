// SPDX-License-Identifier: MIT

#include "core/waves/waves_kernels.h"

#define SW_WIDE_ISA SW_WIDE_SCALAR
#include "core/math/wide.h"

#include "core/waves/waves_kernels.inl"
#include "core/waves/waves_row.inl"
#include "core/waves/waves_shaped.inl"
#include "core/waves/waves_sum.inl"

const swWaveKernels swWaveKernelsScalar = {SW_ISA_SCALAR,   transformTiles, sampleTiles, addOneTile, addShapedTile,
                                           findDepthShares, storeAllSums,   sampleRow,   sumWaves};
