// SPDX-License-Identifier: MIT

#include "core/waves/waves_kernels.h"

#define SW_WIDE_ISA SW_WIDE_NEON
#include "core/math/wide.h"

#include "core/waves/waves_kernels.inl"
#include "core/waves/waves_row.inl"
#include "core/waves/waves_shaped.inl"
#include "core/waves/waves_sum.inl"

const swWaveKernels swWaveKernelsNeon = {SW_ISA_NEON,     transformTiles, sampleTiles, addOneTile, addShapedTile,
                                         findDepthShares, storeAllSums,   sampleRow,   sumWaves};
