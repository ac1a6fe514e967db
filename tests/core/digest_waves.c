// SPDX-License-Identifier: MIT

// Prints one digest for each instruction set that this machine has, over the tiles and samples of a small sea. Built
// alone and run by qemu, it tells whether another architecture makes the same water. Exit code 1 if two lines differ.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/hash.h"
#include "core/base/host.h"
#include "core/waves/waves_fft.h"

enum
{
    SIZE = 64,
    PITCH = SIZE + 3,
    POINTS = 100
};

static const size_t TEXEL_BYTES = sizeof(float) * 4 * PITCH * PITCH;

static int ListTiles(const swBandModes* bands, float** texels, swTile* tiles)
{
    int count = 0;
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        const swBandModes* band = &bands[i];
        if (band->modes != NULL)
        {
            tiles[count] = (swTile){.band = i,
                                    .resolution = SIZE,
                                    .maxBin = band->maxBin,
                                    .side = band->side,
                                    .weight = 1.0f,
                                    .modeCount = band->modeCount,
                                    .modes = band->modes,
                                    .texels = texels[count]};
            count += 1;
        }
    }
    return count;
}

static uint64_t HashSea(const swWaveKernels* kernels, int count, const swTile* tiles, float** texels, void* scratch)
{
    swHash hash = swBeginHash();
    for (int step = 0; step < 5; ++step)
    {
        int64_t ticks = (int64_t)(1000.7 * step * SW_TICKS_PER_SECOND) - 123456789;
        for (int i = 0; i + 1 < count; i += 2)
        {
            swTransformTiles(kernels, &tiles[i], texels[i], &tiles[i + 1], texels[i + 1], ticks, 0, scratch);
        }
        if (count % 2 != 0)
        {
            swTransformTiles(kernels, &tiles[count - 1], texels[count - 1], NULL, NULL, ticks, 0, scratch);
        }
        for (int i = 0; i < count; ++i)
        {
            swAddHashFloats(&hash, texels[i], TEXEL_BYTES / sizeof(float));
        }
        swPosXZ points[POINTS];
        float values[POINTS * 4], gradients[POINTS * 8];
        for (int i = 0; i < POINTS; ++i)
        {
            points[i] = (swPosXZ){1.375 * i * i - 3000.0, 500.0 - 7.0625 * i};
        }
        swSampleTiles(kernels, count, tiles, POINTS, points, values, gradients);
        swAddHashFloats(&hash, values, POINTS * 4);
        swAddHashFloats(&hash, gradients, POINTS * 8);
    }
    return swEndHash(&hash);
}

int main(void)
{
    swHost host = swDefaultHost();
    swWaveSystemDef def = {.spectrum = swDefaultSpectrumDef(),
                           .resolution = SIZE,
                           .tileWaves = 16,
                           .minWavelength = 0.0625f,
                           .maxWavelength = 4096.0f,
                           .chop = 1.0f,
                           .weight = 1.0f,
                           .seed = 3};
    def.spectrum.depth = 60.0f;
    static swBandModes bands[SW_SET_TILES];
    if (swBuildModes(&host, &def, 9.81f, 7.4e-5f, bands) != SW_SUCCESS)
    {
        return 2;
    }
    float* texels[SW_SET_TILES];
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        texels[i] = swAllocateZero(&host, TEXEL_BYTES);
    }
    static swTile tiles[SW_SET_TILES];
    int count = ListTiles(bands, texels, tiles);
    void* scratch = swAllocate(&host, swGetTileScratchSize(SIZE));
    uint64_t first = 0;
    int result = 0;
    for (int isa = SW_ISA_SCALAR; isa < SW_ISA_COUNT; ++isa)
    {
        const swWaveKernels* kernels = swGetWaveKernels((swIsa)isa);
        if (kernels == NULL)
        {
            continue;
        }
        uint64_t hash = HashSea(kernels, count, tiles, texels, scratch);
        first = isa == SW_ISA_SCALAR ? hash : first;
        result = hash == first ? result : 1;
        printf("%-8s %016llx\n", swIsa_GetName((swIsa)isa), (unsigned long long)hash);
    }
    swFree(&host, scratch, swGetTileScratchSize(SIZE));
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        swFree(&host, texels[i], TEXEL_BYTES);
    }
    swFreeModes(&host, bands);
    return result;
}
