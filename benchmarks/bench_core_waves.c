// SPDX-License-Identifier: MIT

// What a frame of waves costs on one core: 14 bands of 128 x 128, beside FFTW doing nothing but the transforms of the
// same three real fields a band, planned with FFTW_MEASURE, in the faster of in place and out of place; and what points
// of the surface cost. The two take turns within one run, each after touching its own data once; medians are compared.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef SW_HAVE_FFTW
#include <fftw3.h>
#endif

#include "core/base/host.h"
#include "core/math/random.h"
#include "core/waves/waves_fft.h"

enum
{
    BANDS = 14,
    ROUNDS = 101,
    POINTS = 4096
};

typedef struct Sea
{
    swHost host;
    swBandModes bands[SW_SET_TILES];
    int size;
    int tileCount;
    swTile tiles[SW_SET_TILES];
    float* texels[SW_SET_TILES];
    void* scratch;
} Sea;

// Processor time of this program, s: what else runs on the machine costs caches, but not the time it runs itself.
static double Now(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static int CompareDoubles(const void* a, const void* b)
{
    double x = *(const double*)a;
    double y = *(const double*)b;
    return (x > y) - (x < y);
}

static double Median(double* values, int count)
{
    qsort(values, (size_t)count, sizeof(double), CompareDoubles);
    return values[count / 2];
}

// A storm long enough that all of 6 cm to 1 km have energy.
static bool CreateSea(Sea* sea, int size)
{
    memset(sea, 0, sizeof *sea);
    sea->host = swDefaultHost();
    sea->size = size;
    swWaveSystemDef def = {0};
    def.spectrum = swDefaultSpectrumDef();
    def.spectrum.windSpeed = 20.0f;
    def.resolution = size;
    def.tileWaves = size / 4;
    def.minWavelength = 0.0625f;
    def.maxWavelength = 1024.0f;
    def.chop = 1.0f;
    def.weight = 1.0f;
    def.seed = 1;
    double start = Now();
    if (swBuildModes(&sea->host, &def, 9.81f, 7.4e-5f, sea->bands) != SW_SUCCESS)
    {
        return false;
    }
    printf("modes of all bands: %.1f ms\n", 1e3 * (Now() - start));
    sea->scratch = swAllocate(&sea->host, swGetTileScratchSize(size));
    size_t bytes = (size_t)(size + 3) * (size_t)(size + 3) * 16;
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        const swBandModes* band = &sea->bands[i];
        if (band->modes == NULL)
        {
            continue;
        }
        float* texels = swAllocateZero(&sea->host, bytes);
        sea->texels[sea->tileCount] = texels;
        sea->tiles[sea->tileCount++] = (swTile){.band = i,
                                                .resolution = size,
                                                .maxBin = band->maxBin,
                                                .side = band->side,
                                                .weight = 1.0f,
                                                .modeCount = band->modeCount,
                                                .modes = band->modes,
                                                .texels = texels};
    }
    return true;
}

static void DestroySea(Sea* sea)
{
    for (int i = 0; i < sea->tileCount; ++i)
    {
        swFree(&sea->host, sea->texels[i], (size_t)(sea->size + 3) * (size_t)(sea->size + 3) * 16);
    }
    swFree(&sea->host, sea->scratch, swGetTileScratchSize(sea->size));
    swFreeModes(&sea->host, sea->bands);
}

static double TimeFrame(Sea* sea, const swWaveKernels* kernels, int64_t ticks)
{
    double start = Now();
    for (int i = 0; i < sea->tileCount; i += 2)
    {
        bool single = i + 1 == sea->tileCount;
        swTransformTiles(kernels, &sea->tiles[i], sea->texels[i], single ? NULL : &sea->tiles[i + 1],
                         single ? NULL : sea->texels[i + 1], ticks, 0, sea->scratch);
    }
    return Now() - start;
}

#ifdef SW_HAVE_FFTW

// Transforms of `count` real fields with arrays of their own, as the tiles have.
typedef struct Fftw
{
    int count;
    size_t complexCount;
    fftwf_complex* spectra;
    float* fields; // NULL: in place
    fftwf_plan plan;
} Fftw;

static Fftw CreateFftw(int size, int count, bool inPlace)
{
    Fftw fftw = {.count = count, .complexCount = (size_t)size * (size_t)(size / 2 + 1)};
    fftw.spectra = fftwf_malloc(sizeof(fftwf_complex) * fftw.complexCount * (size_t)count);
    fftw.fields = inPlace ? NULL : fftwf_malloc(sizeof(float) * (size_t)(size * size) * (size_t)count);
    fftw.plan =
        fftwf_plan_dft_c2r_2d(size, size, fftw.spectra, inPlace ? (float*)fftw.spectra : fftw.fields, FFTW_MEASURE);
    return fftw;
}

static void DestroyFftw(Fftw* fftw)
{
    fftwf_destroy_plan(fftw->plan);
    fftwf_free(fftw->spectra);
    fftwf_free(fftw->fields);
}

// Spectra are filled anew before the clock runs, as transforms to real destroy them.
static double TimeFftw(Fftw* fftw, int size)
{
    float* values = (float*)fftw->spectra;
    for (size_t i = 0; i < 2 * fftw->complexCount * (size_t)fftw->count; ++i)
    {
        values[i] = (float)(i % 1013) * 1e-3f - 0.5f;
    }
    double start = Now();
    for (int i = 0; i < fftw->count; ++i)
    {
        fftwf_complex* spectrum = fftw->spectra + (size_t)i * fftw->complexCount;
        float* field = fftw->fields ? fftw->fields + (size_t)i * (size_t)(size * size) : (float*)spectrum;
        fftwf_execute_dft_c2r(fftw->plan, spectrum, field);
    }
    return Now() - start;
}

static void CompareWithFftw(Sea* sea, const swWaveKernels* kernels)
{
    int fieldCount = 3 * sea->tileCount;
    Fftw fftw[2] = {CreateFftw(sea->size, fieldCount, false), CreateFftw(sea->size, fieldCount, true)};
    double ours[ROUNDS], theirs[2][ROUNDS];
    for (int round = 0; round < ROUNDS; ++round)
    {
        TimeFrame(sea, kernels, 0);
        ours[round] = TimeFrame(sea, kernels, 1000000 * (int64_t)round);
        theirs[0][round] = TimeFftw(&fftw[0], sea->size);
        theirs[1][round] = TimeFftw(&fftw[1], sea->size);
    }
    double our = Median(ours, ROUNDS);
    double outOfPlace = Median(theirs[0], ROUNDS);
    double inPlace = Median(theirs[1], ROUNDS);
    double their = fmin(outOfPlace, inPlace);
    printf("FFTW alone, %d real fields: %.3f ms (out of place %.3f, in place %.3f)\n", fieldCount, 1e3 * their,
           1e3 * outOfPlace, 1e3 * inPlace);
    printf("frame / FFTW: %.3f  (%.3f ms)\n", our / their, 1e3 * our);
    DestroyFftw(&fftw[0]);
    DestroyFftw(&fftw[1]);
}

#endif

static void PrintFloors(const Sea* sea)
{
    double n = sea->size;
    double waves = 0.0;
    for (int i = 0; i < sea->tileCount; ++i)
    {
        waves += sea->tiles[i].modeCount;
    }
    // Of the textbook's 5 N log2 N a transform: a quarter of the columns of three real fields, then one and a half
    // complex.
    double transforms = sea->tileCount * (3.0 * n / 4.0 + 1.5 * n);
    double flops = transforms * 5.0 * n * log2(n);
    double written = sea->tileCount * (n + 3.0) * (n + 3.0) * 16.0;
    printf("floors: %.0f waves read %.2f MB; %.1f Mflop of transforms (5 N log2 N, before pruning); "
           "%.2f MB of texels written\n",
           waves, waves * sizeof(swMode) * 1e-6, flops * 1e-6, written * 1e-6);
}

static void TimeSamples(const Sea* sea, const swWaveKernels* kernels, double width, bool withGradients)
{
    static swPosXZ points[POINTS];
    static float values[POINTS * 4];
    static float gradients[POINTS * 8];
    for (int i = 0; i < POINTS; ++i)
    {
        points[i].x = width * swHashToUnit(swHashWave(1, 0, i, 0, 0));
        points[i].z = width * swHashToUnit(swHashWave(1, 0, i, 0, 1));
    }
    double times[ROUNDS];
    for (int round = 0; round < ROUNDS; ++round)
    {
        double start = Now();
        swSampleTiles(kernels, sea->tileCount, sea->tiles, POINTS, points, values, withGradients ? gradients : NULL);
        times[round] = Now() - start;
    }
    double median = Median(times, ROUNDS);
    printf("%d bands at points in %.0f m%s: %.2f million/s, %.1f ns a point\n", sea->tileCount, width,
           withGradients ? " with gradients" : "", 1e-6 * POINTS / median, 1e9 * median / POINTS);
}

int main(void)
{
    for (int isa = SW_ISA_SCALAR; isa < SW_ISA_COUNT; ++isa)
    {
        const swWaveKernels* kernels = swGetWaveKernels((swIsa)isa);
        if (kernels == NULL)
        {
            continue;
        }
        Sea sea;
        printf("\n%s\n", swIsa_GetName((swIsa)isa));
        if (!CreateSea(&sea, 128))
        {
            return 1;
        }
        if (sea.tileCount != BANDS)
        {
            fprintf(stderr, "The benchmark's sea has %d bands instead of %d.\n", sea.tileCount, (int)BANDS);
            return 1;
        }
        PrintFloors(&sea);
        double times[ROUNDS];
        for (int round = 0; round < ROUNDS; ++round)
        {
            times[round] = TimeFrame(&sea, kernels, 1000000 * (int64_t)round);
        }
        printf("frame of %d bands at N = %d: %.3f ms\n", sea.tileCount, sea.size, 1e3 * Median(times, ROUNDS));
#ifdef SW_HAVE_FFTW
        CompareWithFftw(&sea, kernels);
#endif
        TimeSamples(&sea, kernels, 2000.0, false);
        TimeSamples(&sea, kernels, 2000.0, true);
        TimeSamples(&sea, kernels, 20.0, false);
        DestroySea(&sea);
    }
    return 0;
}
