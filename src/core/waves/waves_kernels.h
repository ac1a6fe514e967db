// SPDX-License-Identifier: MIT
#pragma once

// What waves_kernels.inl makes of each instruction set.

#include "core/waves/waves_fft.h"
#include "core/waves/waves_sum.h"

struct swWaveKernels
{
    swIsa isa;
    void (*transformTiles)(const swTile* a, float* texelsA, const swTile* b, float* texelsB, int64_t ticks,
                           int derivative, void* scratch);
    void (*sampleTiles)(const swTileChoice* choice, int count, const swPosXZ* points, float* out, float* gradients);
    void (*addTile)(const swTile* tile, int field, int count, const swPosXZ* points, bool withSlopes,
                    swPointSums* sums);
    void (*addShapedTile)(const swTile* tile, int field, int count, const swPosXZ* points, const swTileShape* shape,
                          bool withSlopes, swPointSums* sums);
    void (*findDepthShares)(swAttenuation law, float k, int count, const float* depths, float* shares, float* slopes);
    void (*storeSums)(int count, const swPointSums* sums, float* out, float* gradients);
    void (*sampleRow)(const swTileChoice* choice, int count, const double* x, double z, float* out,
                      float (*gradients)[8]);
    void (*sumWaves)(const swWaveSumJob* job);
};

extern const swWaveKernels swWaveKernelsScalar;
#if defined(__x86_64__)
extern const swWaveKernels swWaveKernelsSse2;
extern const swWaveKernels swWaveKernelsAvx2;
extern const swWaveKernels swWaveKernelsAvx512;
#elif defined(__aarch64__)
extern const swWaveKernels swWaveKernelsNeon;
#endif

// Panels of eight waves that a first axis needs: bins 0 .. N/4 of z.
static inline int swGetPanelCount(int resolution)
{
    return (resolution / 4 + 1 + 7) / 8;
}
