// SPDX-License-Identifier: MIT

#include "core/waves/waves_kernels.h"

#define SW_WIDE_ISA SW_WIDE_SSE2
#include "core/math/wide.h"

#include "core/waves/waves_kernels.inl"
#include "core/waves/waves_row.inl"
#include "core/waves/waves_shaped.inl"
#include "core/waves/waves_sum.inl"

const swWaveKernels swWaveKernelsSse2 = {SW_ISA_SSE2,     transformTiles, sampleTiles, addOneTile, addShapedTile,
                                         findDepthShares, storeAllSums,   sampleRow,   sumWaves};
