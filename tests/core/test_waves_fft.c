// SPDX-License-Identifier: MIT

// Waves of a system's bands: energy, phases, and the tiles' splines against the plain sum of the same waves in double.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "core/base/hash.h"
#include "core/base/host.h"
#include "core/math/random.h"
#include "core/waves/waves_fft.h"

#define TURN (2.0 * SW_PI)

// A system's tiles at one time, as a world makes them.
typedef struct Sea
{
    swHost host;
    swWaveSystemDef def;
    swBandModes bands[SW_SET_TILES];
    int tileCount;
    swTile tiles[SW_SET_TILES];
    size_t texelBytes;
    float* texels[SW_SET_TILES];
} Sea;

static Sea* CreateSea(const swWaveSystemDef* def)
{
    Sea* sea = calloc(1, sizeof(Sea));
    sea->host = swDefaultHost();
    sea->def = *def;
    assert_int_equal(swBuildModes(&sea->host, def, 9.81f, 7.4e-5f, sea->bands), SW_SUCCESS);
    size_t side = (size_t)def->resolution + 3;
    sea->texelBytes = side * side * 4 * sizeof(float);
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        const swBandModes* band = &sea->bands[i];
        if (band->modes == NULL)
        {
            continue;
        }
        swTile* tile = &sea->tiles[sea->tileCount];
        tile->band = i;
        tile->resolution = def->resolution;
        tile->maxBin = band->maxBin;
        tile->side = band->side;
        tile->loopTicks = band->loopTicks;
        tile->weight = def->weight;
        tile->variance = band->variance;
        tile->slopeVarianceX = band->slopeVarianceX;
        tile->slopeVarianceZ = band->slopeVarianceZ;
        tile->modeCount = band->modeCount;
        tile->modes = band->modes;
        sea->texels[sea->tileCount] = swAllocateZero(&sea->host, sea->texelBytes);
        tile->texels = sea->texels[sea->tileCount];
        sea->tileCount += 1;
    }
    return sea;
}

static void DestroySea(Sea* sea)
{
    for (int i = 0; i < sea->tileCount; ++i)
    {
        swFree(&sea->host, sea->texels[i], sea->texelBytes);
    }
    swFreeModes(&sea->host, sea->bands);
    free(sea);
}

static void TransformSea(Sea* sea, swIsa isa, int64_t ticks)
{
    const swWaveKernels* kernels = swGetWaveKernels(isa);
    size_t size = swGetTileScratchSize(sea->def.resolution);
    void* scratch = swAllocate(&sea->host, size);
    for (int i = 0; i < sea->tileCount; i += 2)
    {
        bool single = i + 1 == sea->tileCount;
        swTransformTiles(kernels, &sea->tiles[i], sea->texels[i], single ? NULL : &sea->tiles[i + 1],
                         single ? NULL : sea->texels[i + 1], ticks, 0, scratch);
    }
    swFree(&sea->host, scratch, size);
}

static double Sinc4(double x)
{
    double s = x == 0.0 ? 1.0 : sin(SW_PI * x) / (SW_PI * x);
    return s * s * s * s;
}

// Displacement (x, y, z) and gradients in swSampleTiles' order, by summing a tile's waves in double with libm.
static void SumWaves(const swTile* tile, int64_t ticks, double x, double z, double sum[9])
{
    memset(sum, 0, 9 * sizeof(double));
    for (int i = 0; i < tile->modeCount; ++i)
    {
        const swMode* m = &tile->modes[i];
        double n = tile->resolution;
        double response = Sinc4(m->qx / n) * Sinc4(m->qz / n) * (double)tile->weight;
        uint64_t frequency = ((uint64_t)m->frequencyHigh << 32) | m->frequencyLow;
        uint64_t phase = frequency * (uint64_t)swGetTileTicks(tile, ticks);
        double theta = TURN * ldexp((double)phase, -64);
        double c = cos(theta);
        double s = sin(theta);
        double re = response * ((double)m->pr * c + (double)m->qi * s);
        double im = response * ((double)m->pi * c - (double)m->qr * s);
        double kx = TURN * m->qx / tile->side;
        double kz = TURN * m->qz / tile->side;
        double along = kx * x + kz * z;
        // 2 Re(H e) and 2 Re(i H e) with e = exp(i k x).
        double cosine = 2.0 * (re * cos(along) - im * sin(along));
        double sine = -2.0 * (re * sin(along) + im * cos(along));
        double dx = (double)m->dx;
        double dz = (double)m->dz;
        sum[0] += dx * sine;
        sum[1] += cosine;
        sum[2] += dz * sine;
        sum[3] -= dx * kx * cosine;
        sum[4] -= dx * kz * cosine;
        sum[5] -= dz * kx * cosine;
        sum[6] -= dz * kz * cosine;
        sum[7] += kx * sine;
        sum[8] += kz * sine;
    }
}

static swWaveSystemDef MakeWindSea(void)
{
    swWaveSystemDef def = {0};
    def.spectrum = swDefaultSpectrumDef();
    def.resolution = 128;
    def.tileWaves = 32;
    def.minWavelength = 0.0625f;
    def.maxWavelength = 4096.0f;
    def.chop = 1.0f;
    def.weight = 1.0f;
    def.seed = 1;
    return def;
}

// A point of the plane by number, some kilometres wide.
static swPosXZ GetPoint(int index)
{
    swPosXZ point;
    point.x = 6000.0 * swHashToUnit(swHashWave(7, 0, index, 0, 0)) - 3000.0;
    point.z = 6000.0 * swHashToUnit(swHashWave(7, 0, index, 0, 1)) - 3000.0;
    return point;
}

static void SplineAgreesWithTheSumOfItsWaves(void** state)
{
    (void)state;
    enum
    {
        POINTS = 300
    };
    swWaveSystemDef def = MakeWindSea();
    def.weight = 1.25f;
    def.chop = 0.9f;
    Sea* sea = CreateSea(&def);
    int64_t ticks = (int64_t)(1234.5 * SW_TICKS_PER_SECOND);
    TransformSea(sea, SW_ISA_BEST, ticks);
    // Squares of error and of truth: displacement, height, slope, and of all bands together.
    double totals[6] = {0};
    static double allTruth[POINTS][9];
    memset(allTruth, 0, sizeof allTruth);
    assert_in_range(sea->tileCount, 8, SW_SET_TILES);
    for (int t = 0; t < sea->tileCount; ++t)
    {
        double sums[6] = {0};
        for (int i = 0; i < POINTS; ++i)
        {
            swPosXZ point = GetPoint(i);
            double truth[9];
            SumWaves(&sea->tiles[t], ticks, point.x, point.z, truth);
            float value[4], gradient[8];
            swSampleTiles(swGetWaveKernels(SW_ISA_BEST), 1, &sea->tiles[t], 1, &point, value, gradient);
            for (int c = 0; c < 9; ++c)
            {
                double got = (double)(c < 3 ? value[c] : gradient[c - 3]);
                int kind = c == 1 ? 1 : (c < 3 ? 0 : 2);
                sums[kind] += (got - truth[c]) * (got - truth[c]);
                sums[3 + kind] += truth[c] * truth[c];
                allTruth[i][c] += truth[c];
            }
        }
        double displacement = sqrt(sums[0] / sums[3]);
        double height = sqrt(sums[1] / sums[4]);
        double slope = sqrt(sums[2] / sums[5]);
        print_message("band %2d, %4d waves: error of displacement %.3f %%, height %.3f %%, slopes %.3f %%\n",
                      sea->tiles[t].band, sea->tiles[t].modeCount, 100.0 * displacement, 100.0 * height, 100.0 * slope);
        assert_true(displacement < 0.01 && height < 0.01 && slope < 0.03);
    }
    for (int i = 0; i < POINTS; ++i)
    {
        swPosXZ point = GetPoint(i);
        float value[4], gradient[8];
        swSampleTiles(swGetWaveKernels(SW_ISA_BEST), sea->tileCount, sea->tiles, 1, &point, value, gradient);
        for (int c = 0; c < 9; ++c)
        {
            double got = (double)(c < 3 ? value[c] : gradient[c - 3]);
            int kind = c == 1 ? 1 : (c < 3 ? 0 : 2);
            totals[kind] += (got - allTruth[i][c]) * (got - allTruth[i][c]);
            totals[3 + kind] += allTruth[i][c] * allTruth[i][c];
        }
    }
    print_message("all bands: error of displacement %.3f %%, height %.3f %%, slopes %.3f %%\n",
                  100.0 * sqrt(totals[0] / totals[3]), 100.0 * sqrt(totals[1] / totals[4]),
                  100.0 * sqrt(totals[2] / totals[5]));
    assert_true(totals[1] < 1e-4 * totals[4] && totals[2] < 9e-4 * totals[5]);
    DestroySea(sea);
}

static void EveryBandHasItsEnergy(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    Sea* sea = CreateSea(&def);
    swCompiledSpectrum* spectrum = NULL;
    assert_int_equal(swCompileSpectrum(&sea->host, &def.spectrum, (double)9.81f, (double)7.4e-5f, &spectrum),
                     SW_SUCCESS);
    double total = 0.0;
    for (int t = 0; t < sea->tileCount; ++t)
    {
        const swBandModes* band = &sea->bands[sea->tiles[t].band];
        double k0 = TURN / (double)band->maxWavelength;
        double k1 = TURN / (double)band->minWavelength;
        double sigma = (double)7.4e-5f;
        double wanted = swIntegrateCompiled(spectrum, sqrt((double)9.81f * k0 + sigma * k0 * k0 * k0),
                                            sqrt((double)9.81f * k1 + sigma * k1 * k1 * k1));
        double sum = 0.0;
        for (int i = 0; i < band->modeCount; ++i)
        {
            const swMode* m = &band->modes[i];
            double r = Sinc4(m->qx / 128.0) * Sinc4(m->qz / 128.0);
            // |a(k)|^2 + |a(-k)|^2 = 2 (|p|^2 + |q|^2); half of it is variance.
            double pr = (double)m->pr, pi = (double)m->pi, qr = (double)m->qr, qi = (double)m->qi;
            sum += r * r * (pr * pr + pi * pi + qr * qr + qi * qi);
        }
        assert_true(fabs(sum / wanted - 1.0) < 1e-5);
        assert_true(fabs((double)band->variance / wanted - 1.0) < 1e-6);
        total += wanted;
    }
    // The sea of a 10 m/s wind over 300 km.
    print_message("Hs %.4f m in %d bands\n", 4.0 * sqrt(total), sea->tileCount);
    swFreeCompiledSpectrum(&sea->host, spectrum);
    DestroySea(sea);
}

// Mean over time of a tile's variance over its own area.
static void TilesHaveTheirVarianceAndSlope(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    Sea* sea = CreateSea(&def);
    enum
    {
        TIMES = 24
    };
    double variance[SW_SET_TILES] = {0};
    double slopes[SW_SET_TILES] = {0};
    for (int time = 0; time < TIMES; ++time)
    {
        TransformSea(sea, SW_ISA_BEST, (int64_t)(7.31 * time * SW_TICKS_PER_SECOND));
        for (int t = 0; t < sea->tileCount; ++t)
        {
            for (int i = 0; i < 400; ++i)
            {
                // A jittered grid over the tile.
                double u = (i % 20 + swHashToUnit(swHashWave(3, t, i, time, 0))) / 20.0;
                double v = (i / 20 + swHashToUnit(swHashWave(3, t, i, time, 1))) / 20.0;
                swPosXZ point = {u * sea->tiles[t].side, v * sea->tiles[t].side};
                float value[4], gradient[8];
                swSampleTiles(swGetWaveKernels(SW_ISA_BEST), 1, &sea->tiles[t], 1, &point, value, gradient);
                variance[t] += (double)value[1] * (double)value[1] / (400.0 * TIMES);
                slopes[t] += ((double)gradient[4] * (double)gradient[4] + (double)gradient[5] * (double)gradient[5]) /
                             (400.0 * TIMES);
            }
        }
    }
    for (int t = 0; t < sea->tileCount; ++t)
    {
        const swTile* tile = &sea->tiles[t];
        double slope = (double)tile->slopeVarianceX + (double)tile->slopeVarianceZ;
        print_message("band %2d: variance %.4f and mean square slope %.4f of what was asked\n", tile->band,
                      variance[t] / (double)tile->variance, slopes[t] / slope);
        assert_true(fabs(variance[t] / (double)tile->variance - 1.0) < 0.06);
        assert_true(fabs(slopes[t] / slope - 1.0) < 0.06);
    }
    DestroySea(sea);
}

static uint64_t HashSea(const Sea* sea)
{
    swHash hash = swBeginHash();
    for (int i = 0; i < sea->tileCount; ++i)
    {
        swAddHashFloats(&hash, sea->texels[i], sea->texelBytes / sizeof(float));
    }
    return swEndHash(&hash);
}

static uint64_t HashSamples(const Sea* sea, swIsa isa)
{
    enum
    {
        POINTS = 333
    };
    static swPosXZ points[POINTS];
    static float values[POINTS * 4];
    static float gradients[POINTS * 8];
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = GetPoint(i);
    }
    swHash hash = swBeginHash();
    swSampleTiles(swGetWaveKernels(isa), sea->tileCount, sea->tiles, POINTS, points, values, gradients);
    swAddHashFloats(&hash, values, POINTS * 4);
    swAddHashFloats(&hash, gradients, POINTS * 8);
    swSampleTiles(swGetWaveKernels(isa), sea->tileCount, sea->tiles, POINTS, points, values, NULL);
    swAddHashFloats(&hash, values, POINTS * 4);
    return swEndHash(&hash);
}

static void EveryInstructionSetGivesTheSameBits(void** state)
{
    (void)state;
    for (int resolution = 16; resolution <= 512; resolution *= 2)
    {
        swWaveSystemDef def = MakeWindSea();
        def.resolution = resolution;
        def.tileWaves = resolution / 4;
        def.minWavelength = 0.5f;
        def.maxWavelength = resolution < 512 ? 64.0f : 4.0f;
        Sea* sea = CreateSea(&def);
        uint64_t texels = 0;
        uint64_t samples = 0;
        for (int isa = SW_ISA_SCALAR; isa < SW_ISA_COUNT; ++isa)
        {
            if (swGetWaveKernels((swIsa)isa) == NULL)
            {
                continue;
            }
            assert_int_equal(swGetWaveKernelsIsa(swGetWaveKernels((swIsa)isa)), isa);
            TransformSea(sea, (swIsa)isa, -987654321);
            uint64_t hash = HashSea(sea);
            uint64_t sampleHash = HashSamples(sea, (swIsa)isa);
            if (isa == SW_ISA_SCALAR)
            {
                texels = hash;
                samples = sampleHash;
                print_message("N = %3d: tiles %016llx, samples %016llx\n", resolution, (unsigned long long)hash,
                              (unsigned long long)sampleHash);
            }
            assert_true(hash == texels);
            assert_true(sampleHash == samples);
        }
        DestroySea(sea);
    }
}

static void TilesWrapByTheirPadding(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    def.resolution = 64;
    def.tileWaves = 16;
    Sea* sea = CreateSea(&def);
    TransformSea(sea, SW_ISA_BEST, 5000000);
    const int n = def.resolution;
    const int pitch = n + 3;
    for (int t = 0; t < sea->tileCount; ++t)
    {
        const float* texels = sea->texels[t];
        for (int j = 0; j < pitch; ++j)
        {
            for (int i = 0; i < pitch; ++i)
            {
                const float* texel = texels + (j * pitch + i) * 4;
                const float* same = texels + ((j % n) * pitch + i % n) * 4;
                assert_memory_equal(texel, same, 4 * sizeof(float));
                assert_true(texel[3] == 0.0f);
            }
        }
    }
    DestroySea(sea);
}

static void LoneTileIsTheSameWaterAsAPairedOne(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    Sea* sea = CreateSea(&def);
    TransformSea(sea, SW_ISA_BEST, 12345);
    swPosXZ point = {12.0, -7.0};
    float paired[4], lone[4];
    swSampleTiles(swGetWaveKernels(SW_ISA_BEST), 1, &sea->tiles[5], 1, &point, paired, NULL);
    size_t size = swGetTileScratchSize(128);
    void* scratch = swAllocate(&sea->host, size);
    swTransformTiles(swGetWaveKernels(SW_ISA_BEST), &sea->tiles[5], sea->texels[5], NULL, NULL, 12345, 0, scratch);
    swSampleTiles(swGetWaveKernels(SW_ISA_BEST), 1, &sea->tiles[5], 1, &point, lone, NULL);
    for (int i = 0; i < 3; ++i)
    {
        assert_float_equal(paired[i], lone[i], 1e-5f);
    }
    swFree(&sea->host, scratch, size);
    DestroySea(sea);
}

static void LoopRepeatsToTheBit(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    def.loopPeriod = 37.7f;
    Sea* sea = CreateSea(&def);
    int64_t loop = sea->tiles[0].loopTicks;
    assert_true(loop == (int64_t)floor((double)37.7f * SW_TICKS_PER_SECOND + 0.5));
    TransformSea(sea, SW_ISA_BEST, 333333);
    uint64_t first = HashSea(sea);
    TransformSea(sea, SW_ISA_BEST, 333333 + 1000 * loop);
    assert_true(HashSea(sea) == first);
    TransformSea(sea, SW_ISA_BEST, 333333 - 1000 * loop);
    assert_true(HashSea(sea) == first);
    TransformSea(sea, SW_ISA_BEST, 333333 + loop / 2);
    assert_false(HashSea(sea) == first);
    // No jump where the loop closes: one tick earlier is as near as one tick later.
    for (int t = 0; t < sea->tileCount; ++t)
    {
        for (int i = 0; i < sea->tiles[t].modeCount; ++i)
        {
            const swMode* m = &sea->tiles[t].modes[i];
            uint64_t frequency = ((uint64_t)m->frequencyHigh << 32) | m->frequencyLow;
            int64_t rest = (int64_t)(frequency * (uint64_t)loop);
            assert_true(fabs(ldexp((double)rest, -64)) < 1e-9);
        }
    }
    DestroySea(sea);
}

static void SeaDoesNotDependOnResolution(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    Sea* coarse = CreateSea(&def);
    def.resolution = 256;
    Sea* fine = CreateSea(&def);
    assert_int_equal(coarse->tileCount, fine->tileCount);
    TransformSea(coarse, SW_ISA_BEST, 777777777);
    TransformSea(fine, SW_ISA_BEST, 777777777);
    double error = 0.0;
    double square = 0.0;
    for (int i = 0; i < 2000; ++i)
    {
        swPosXZ point = GetPoint(i);
        float a[4], b[4];
        swSampleTiles(swGetWaveKernels(SW_ISA_BEST), coarse->tileCount, coarse->tiles, 1, &point, a, NULL);
        swSampleTiles(swGetWaveKernels(SW_ISA_BEST), fine->tileCount, fine->tiles, 1, &point, b, NULL);
        error += ((double)a[1] - (double)b[1]) * ((double)a[1] - (double)b[1]);
        square += (double)b[1] * (double)b[1];
    }
    print_message("N = 128 against N = 256: %.3f %% of height\n", 100.0 * sqrt(error / square));
    assert_true(error < 1e-4 * square);
    DestroySea(coarse);
    DestroySea(fine);
}

// The phase as the transform has it, from a rounded amplitude, is not to be seen; so look at the integers themselves.
static void PhasesStayExactForAMonth(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    Sea* sea = CreateSea(&def);
    const double month = 30.0 * 86400.0;
    const int64_t ticks = (int64_t)(month * SW_TICKS_PER_SECOND);
    long double worst = 0.0L;
    for (int t = 0; t < sea->tileCount; ++t)
    {
        for (int i = 0; i < sea->tiles[t].modeCount; i += 7)
        {
            const swMode* m = &sea->tiles[t].modes[i];
            uint64_t frequency = ((uint64_t)m->frequencyHigh << 32) | m->frequencyLow;
            long double q = sqrtl((long double)(m->qx * m->qx + m->qz * m->qz));
            long double k = 2.0L * 3.14159265358979323846264L * q / (long double)sea->tiles[t].side;
            long double omega = sqrtl((long double)9.81f * k + (long double)7.4e-5f * k * k * k);
            long double turns = omega / (2.0L * 3.14159265358979323846264L) * (long double)month;
            long double phase = ldexpl((long double)(frequency * (uint64_t)ticks), -64);
            long double error = phase - (turns - floorl(turns));
            error -= roundl(error);
            worst = fabsl(error) > worst ? fabsl(error) : worst;
        }
    }
    print_message("worst phase after 30 days: %.2e turns from omega t\n", (double)worst);
    assert_true(worst < 4e-6L);
    DestroySea(sea);
}

static void TimeRunsBackwardsAsWell(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    Sea* sea = CreateSea(&def);
    int64_t ticks = (int64_t)(-55.25 * SW_TICKS_PER_SECOND);
    TransformSea(sea, SW_ISA_BEST, ticks);
    const swTile* tile = &sea->tiles[6];
    for (int i = 0; i < 50; ++i)
    {
        swPosXZ point = GetPoint(i);
        double truth[9];
        float value[4];
        SumWaves(tile, ticks, point.x, point.z, truth);
        swSampleTiles(swGetWaveKernels(SW_ISA_BEST), 1, tile, 1, &point, value, NULL);
        assert_true(fabs((double)value[1] - truth[1]) < 0.05 * sqrt((double)tile->variance));
    }
    DestroySea(sea);
}

static void WavesGoWhereTheSpectrumSays(void** state)
{
    (void)state;
    for (int seed = 1; seed <= 2; ++seed)
    {
        swWaveSystemDef def = MakeWindSea();
        def.seed = (uint32_t)seed;
        def.spectrum.spreadExponent = 75.0f;
        def.spectrum.gamma = 7.0f;
        def.spectrum.direction = 0.7f;
        Sea* sea = CreateSea(&def);
        double x = 0.0;
        double z = 0.0;
        double total = 0.0;
        for (int t = 0; t < sea->tileCount; ++t)
        {
            const swTile* tile = &sea->tiles[t];
            for (int i = 0; i < tile->modeCount; ++i)
            {
                const swMode* m = &tile->modes[i];
                double pr = (double)m->pr, pi = (double)m->pi, qr = (double)m->qr, qi = (double)m->qi;
                double r = Sinc4(m->qx / 128.0) * Sinc4(m->qz / 128.0);
                // a(k) = p + q, conj a(-k) = p - q.
                double there = 0.5 * r * r * ((pr + qr) * (pr + qr) + (pi + qi) * (pi + qi));
                double back = 0.5 * r * r * ((pr - qr) * (pr - qr) + (pi - qi) * (pi - qi));
                x += (there - back) * (double)m->dx;
                z += (there - back) * (double)m->dz;
                total += there + back;
            }
        }
        double direction = atan2(z, x);
        double r1 = sqrt(x * x + z * z) / total;
        // r1 of cos^2s(theta / 2) is s / (s + 1).
        print_message("seed %d: direction %.4f (0.7), r1 %.4f (%.4f), Hs %.4f\n", seed, direction, r1, 75.0 / 76.0,
                      4.0 * sqrt(total));
        assert_true(fabs(direction - 0.7) < 0.005);
        assert_true(fabs(r1 - 75.0 / 76.0) < 0.004);
        DestroySea(sea);
    }
}

static void ShallowWaterSlowsLongWaves(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    def.spectrum.depth = 5.0f;
    Sea* sea = CreateSea(&def);
    for (int t = 0; t < sea->tileCount; ++t)
    {
        const swTile* tile = &sea->tiles[t];
        const swMode* m = &tile->modes[tile->modeCount / 2];
        double k = TURN * hypot(m->qx, m->qz) / tile->side;
        double omega = sqrt(((double)9.81f * k + (double)7.4e-5f * k * k * k) * tanh(k * 5.0));
        double got = TURN * ldexp((double)m->frequencyHigh, 32 - 64) * SW_TICKS_PER_SECOND;
        got += TURN * ldexp((double)m->frequencyLow, -64) * SW_TICKS_PER_SECOND;
        assert_true(fabs(got / omega - 1.0) < 1e-10);
    }
    DestroySea(sea);
}

static void FarAwayIsAsGoodAsNear(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    Sea* sea = CreateSea(&def);
    TransformSea(sea, SW_ISA_BEST, 4242);
    const swTile* tile = &sea->tiles[0];
    // A million metres off by whole tiles: the same water.
    double far = 1e6 / tile->side;
    far = floor(far) * tile->side;
    for (int i = 0; i < 100; ++i)
    {
        swPosXZ near = GetPoint(i);
        swPosXZ there = {near.x + far, near.z - far};
        float a[4], b[4];
        swSampleTiles(swGetWaveKernels(SW_ISA_BEST), 1, tile, 1, &near, a, NULL);
        swSampleTiles(swGetWaveKernels(SW_ISA_BEST), 1, tile, 1, &there, b, NULL);
        assert_true(fabsf(a[1] - b[1]) < 1e-5f * sqrtf(tile->variance));
    }
    // Whatever comes in, no read is out of bounds (run with the address sanitizer).
    swPosXZ wild[4] = {{(double)NAN, 0.0}, {(double)INFINITY, -(double)INFINITY}, {1e300, -1e300}, {-1e-320, 0x1p51}};
    float out[16];
    swSampleTiles(swGetWaveKernels(SW_ISA_BEST), sea->tileCount, sea->tiles, 4, wild, out, NULL);
    DestroySea(sea);
}

static void BatchesAnswerAsSinglePointsDo(void** state)
{
    (void)state;
    swWaveSystemDef def = MakeWindSea();
    Sea* sea = CreateSea(&def);
    TransformSea(sea, SW_ISA_BEST, 4242);
    enum
    {
        POINTS = 391
    };
    static swPosXZ points[POINTS];
    static float batch[POINTS][4];
    for (int i = 0; i < POINTS; ++i)
    {
        points[i] = GetPoint(i);
    }
    swSampleTiles(swGetWaveKernels(SW_ISA_BEST), sea->tileCount, sea->tiles, POINTS, points, batch[0], NULL);
    for (int i = 0; i < POINTS; ++i)
    {
        float value[4], gradient[8];
        swSampleTiles(swGetWaveKernels(SW_ISA_BEST), sea->tileCount, sea->tiles, 1, &points[i], value, gradient);
        assert_memory_equal(value, batch[i], sizeof value);
    }
    DestroySea(sea);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(SplineAgreesWithTheSumOfItsWaves),
        cmocka_unit_test(EveryBandHasItsEnergy),
        cmocka_unit_test(TilesHaveTheirVarianceAndSlope),
        cmocka_unit_test(EveryInstructionSetGivesTheSameBits),
        cmocka_unit_test(TilesWrapByTheirPadding),
        cmocka_unit_test(LoneTileIsTheSameWaterAsAPairedOne),
        cmocka_unit_test(LoopRepeatsToTheBit),
        cmocka_unit_test(SeaDoesNotDependOnResolution),
        cmocka_unit_test(PhasesStayExactForAMonth),
        cmocka_unit_test(TimeRunsBackwardsAsWell),
        cmocka_unit_test(WavesGoWhereTheSpectrumSays),
        cmocka_unit_test(ShallowWaterSlowsLongWaves),
        cmocka_unit_test(FarAwayIsAsGoodAsNear),
        cmocka_unit_test(BatchesAnswerAsSinglePointsDo),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
