// SPDX-License-Identifier: MIT
// The detail layers hold the slopes of the core's splines, and their mips the means of slopes and of squares. The
// oracle here evaluates the core's tiles in double.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "shared/spline.h"

static double Component(sw_vec4 v, int i)
{
    const float values[4] = {v.x, v.y, v.z, v.w};
    return (double)values[i];
}

// Slope of the tile's height at detail texel (x, z) of `side`.
static void SlopeAt(const swTile* tile, int side, int x, int z, double* slopeX, double* slopeZ)
{
    double sx = (double)x * tile->resolution / side, sz = (double)z * tile->resolution / side;
    int column = (int)floor(sx), row = (int)floor(sz);
    sw_vec4 valueX = swSplineWeights((float)(sx - column)), dX = swSplineSlopes((float)(sx - column));
    sw_vec4 valueZ = swSplineWeights((float)(sz - row)), dZ = swSplineSlopes((float)(sz - row));
    *slopeX = *slopeZ = 0.0;
    for (int j = 0; j < 4; ++j)
    {
        for (int i = 0; i < 4; ++i)
        {
            double h = (double)tile->texels[((row + j) * (tile->resolution + 3) + column + i) * 4 + 1];
            *slopeX += h * Component(dX, i) * Component(valueZ, j);
            *slopeZ += h * Component(valueX, i) * Component(dZ, j);
        }
    }
    *slopeX *= tile->resolution / tile->side;
    *slopeZ *= tile->resolution / tile->side;
}

// [side][side][4] moments of mip 0, then halved in place for each further mip.
static void FillOracle(const swTile* tile, int side, float* moments)
{
    for (int z = 0; z < side; ++z)
    {
        for (int x = 0; x < side; ++x)
        {
            double sx, sz;
            SlopeAt(tile, side, x, z, &sx, &sz);
            float* texel = moments + (size_t)(z * side + x) * 4;
            texel[0] = (float)sx;
            texel[1] = (float)sz;
            texel[2] = (float)(sx * sx);
            texel[3] = (float)(sz * sz);
        }
    }
}

static void HalveOracle(int side, float* moments)
{
    for (int z = 0; z < side / 2; ++z)
    {
        for (int x = 0; x < side / 2; ++x)
        {
            for (int c = 0; c < 4; ++c)
            {
                const float* from = moments + (size_t)((2 * z) * side + 2 * x) * 4 + c;
                moments[(size_t)(z * (side / 2) + x) * 4 + (size_t)c] =
                    0.25f * (from[0] + from[4] + from[4 * side] + from[4 * side + 4]);
            }
        }
    }
}

static void CheckDetail(Parity* parity, const char* what)
{
    const swFrame* frame = swGetWorldFrame(parity->world);
    int side = (int)swGetDetailImage(parity->gpuWorld)->width;
    float* oracle = malloc((size_t)side * (size_t)side * 4 * sizeof(float));
    float* texels = malloc((size_t)side * (size_t)side * 4 * sizeof(float));
    Difference total = {0};
    for (int i = 0; i < frame->tileCount; ++i)
    {
        FillOracle(&frame->tiles[i], side, oracle);
        int width = side;
        for (uint32_t mip = 0; mip < SW_DETAIL_MIPS; ++mip, width /= 2)
        {
            assert_int_equal(swReadDetail(parity->gpuWorld, i, mip, texels), SW_SUCCESS);
            total = MaxDifference(total, Compare(oracle, texels, (size_t)width * (size_t)width, 4, 4));
            HalveOracle(width, oracle);
        }
    }
    free(oracle);
    free(texels);
    PrintDifference(what, total, "");
    assert_true(total.worst < 1.5e-3); // slopes below 2 in half floats
    assert_true(total.scale > 1e-3);
}

static void SlopesAndMipsAgree(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    AddParitySea(&parity, &def);
    StepParity(&parity, 3.0);
    CheckDetail(&parity, "14 tiles, N = 128");
    FreeParity(&parity);
}

static void TilesOfOtherResolutionsAreResampled(void** state)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 32;
    def.tileWaves = 8;
    def.minWavelength = 4.0f;
    AddParitySea(&parity, &def);
    def.resolution = 512;
    def.tileWaves = 16;
    def.minWavelength = 64.0f;
    AddParitySea(&parity, &def);
    StepParity(&parity, 3.0);
    assert_int_equal(swGetDetailImage(parity.gpuWorld)->width, SW_DETAIL_MAX);
    CheckDetail(&parity, "N = 32 and 512 on 256 texels");
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(SlopesAndMipsAgree),
        cmocka_unit_test(TilesOfOtherResolutionsAreResampled),
    };
    return cmocka_run_group_tests_name("detail: CPU and GPU", tests, OpenParityGpu, CloseParityGpu);
}
