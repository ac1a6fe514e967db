// SPDX-License-Identifier: MIT
// A tile holds spline coefficients; what a query reads from it is held here against the direct sum, in double, of the
// very waves that the tile was made of, band by band and for every instruction set of the machine, at the default
// resolution. Errors are relative to the band's own root mean square.
//
// A tile repeats. A swell would be seen to, whose energy is all in one octave: how much it does is its correlation with
// itself as far away as each of its tiles is wide, and twice as far.

#include "truth.h"

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/frame/frame.h"
#include "core/math/random.h"
#include "core/waves/waves_fft.h"

#define POINT_COUNT 400

// Sums of squares: error and truth, of height, of displacement sideways, of both slopes.
typedef struct Squares
{
    double error[3], truth[3];
} Squares;

static double Sinc4(double x)
{
    double s = x == 0.0 ? 1.0 : sin(SW_PI * x) / (SW_PI * x);
    return s * s * s * s;
}

// Height, displacement in x and z, slopes in x and z.
static void SumWaves(const swTile* tile, int64_t ticks, swPosXZ at, double sum[5])
{
    memset(sum, 0, 5 * sizeof(double));
    for (int i = 0; i < tile->modeCount; ++i)
    {
        const swMode* m = &tile->modes[i];
        double size = tile->resolution, response = Sinc4(m->qx / size) * Sinc4(m->qz / size);
        uint64_t frequency = ((uint64_t)m->frequencyHigh << 32) | m->frequencyLow;
        double angle = TURN * ldexp((double)(frequency * (uint64_t)swGetTileTicks(tile, ticks)), -64);
        double re = response * ((double)m->pr * cos(angle) + (double)m->qi * sin(angle));
        double im = response * ((double)m->pi * cos(angle) - (double)m->qr * sin(angle));
        double kx = TURN * m->qx / tile->side, kz = TURN * m->qz / tile->side;
        double along = kx * at.x + kz * at.z;
        double cosine = 2.0 * (re * cos(along) - im * sin(along));
        double sine = -2.0 * (re * sin(along) + im * cos(along)); // of the wave a quarter ahead
        sum[0] += cosine;
        sum[1] += (double)m->dx * sine;
        sum[2] += (double)m->dz * sine;
        sum[3] += kx * sine;
        sum[4] += kz * sine;
    }
}

static void MakeTile(const swBandModes* band, const swWaveSystemDef* def, float* texels, swTile* tile)
{
    *tile = (swTile){.band = band->band,
                     .resolution = def->resolution,
                     .maxBin = band->maxBin,
                     .side = band->side,
                     .loopTicks = band->loopTicks,
                     .weight = 1.0f,
                     .modeCount = band->modeCount,
                     .modes = band->modes,
                     .texels = texels};
}

static void CompareTile(const swWaveKernels* kernels, const swTile* tile, int64_t ticks, Squares* squares)
{
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        swPosXZ at = {6000.0 * swHashToUnit(swHashWave(11, 0, i, 0, 0)) - 3000.0,
                      6000.0 * swHashToUnit(swHashWave(11, 0, i, 0, 1)) - 3000.0};
        double truth[5];
        float value[4], gradient[8];
        SumWaves(tile, ticks, at, truth);
        swSampleTiles(kernels, 1, tile, 1, &at, value, gradient);
        double got[5] = {(double)value[1], (double)value[0], (double)value[2], (double)gradient[4],
                         (double)gradient[5]};
        for (int c = 0; c < 5; ++c)
        {
            int kind = (c + 1) / 2;
            squares->error[kind] += (got[c] - truth[c]) * (got[c] - truth[c]);
            squares->truth[kind] += truth[c] * truth[c];
        }
    }
}

// All instruction sets have to give the same bits, so the worst of them is that of each; it is measured all the same.
static void CheckBand(const swBandModes* band, const swWaveSystemDef* def, float* texels, void* scratch)
{
    double worst[3] = {0.0};
    int64_t ticks = (int64_t)(1234.5 * SW_TICKS_PER_SECOND);
    swTile tile;
    MakeTile(band, def, texels, &tile);
    for (int isa = SW_ISA_SCALAR; isa < SW_ISA_COUNT; ++isa)
    {
        const swWaveKernels* kernels = swGetWaveKernels((swIsa)isa);
        if (kernels == NULL)
        {
            continue;
        }
        Squares squares = {0};
        swTransformTiles(kernels, &tile, texels, NULL, NULL, ticks, 0, scratch);
        CompareTile(kernels, &tile, ticks, &squares);
        for (int kind = 0; kind < 3; ++kind)
        {
            double error = 100.0 * sqrt(squares.error[kind] / squares.truth[kind]);
            worst[kind] = fmax(worst[kind], error);
        }
        print_message("     %s: height %.4f %%, sideways %.4f %%, slopes %.4f %%\n", swIsa_GetName((swIsa)isa),
                      100.0 * sqrt(squares.error[0] / squares.truth[0]),
                      100.0 * sqrt(squares.error[1] / squares.truth[1]),
                      100.0 * sqrt(squares.error[2] / squares.truth[2]));
    }
    static const char* const names[3] = {"height", "displacement sideways", "slopes"};
    for (int kind = 0; kind < 3; ++kind)
    {
        char what[128];
        snprintf(what, sizeof(what), "Error of %s, waves of %g to %g m, every instruction set", names[kind],
                 (double)band->minWavelength, (double)band->maxWavelength);
        FindBelow(&(Finding){"Tile", what, "direct sum of the waves", "% RMS", 2}, kind == 2 ? 3.0 : 1.0, worst[kind]);
    }
}

static void TilesAreTheDirectSumOfTheirWaves(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWaveSystemDef def = swDefaultWaveSystemDef();
    swBandModes bands[SW_SET_TILES];
    assert_int_equal(def.resolution, 128);
    assert_int_equal(def.tileWaves, 32);
    assert_int_equal(swBuildModes(&host, &def, 9.81f, 7.4e-5f, bands), SW_SUCCESS);
    size_t side = (size_t)def.resolution + 3, bytes = side * side * 4 * sizeof(float);
    size_t scratchBytes = swGetTileScratchSize(def.resolution);
    float* texels = swAllocateZero(&host, bytes);
    void* scratch = swAllocate(&host, scratchBytes);
    int count = 0;
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        if (bands[i].modes != NULL)
        {
            CheckBand(&bands[i], &def, texels, scratch);
            count += 1;
        }
    }
    assert_in_range(count, 10, SW_MAX_BANDS);
    swFree(&host, scratch, scratchBytes);
    swFree(&host, texels, bytes);
    swFreeModes(&host, bands);
}

// Of heights of particles at many places, and as far from them.
static double FindCorrelation(const swWorld* world, double x, double z)
{
    enum
    {
        PLACES = 20000
    };
    static swPosXZ places[PLACES];
    static float heights[2][PLACES];
    double products = 0.0, squares[2] = {0.0, 0.0};
    swQueryDef query = swDefaultQueryDef();
    for (int k = 0; k < 2; ++k)
    {
        ScatterPoints(40e3, 5, PLACES, places);
        for (int i = 0; i < PLACES && k == 1; ++i)
        {
            places[i] = (swPosXZ){places[i].x + x, places[i].z + z};
        }
        swSurfaceSamples samples = {.height = heights[k]};
        swMoment_QueryParticles(swWorld_GetMoment(world), &query, PLACES, places, &samples, NULL, NULL);
    }
    for (int i = 0; i < PLACES; ++i)
    {
        double a = (double)heights[0][i], b = (double)heights[1][i];
        products += a * b;
        squares[0] += a * a;
        squares[1] += b * b;
    }
    return products / sqrt(squares[0] * squares[1]);
}

// The largest correlation with the sea one and two tiles away, of any of the tiles that matter.
static double FindRepetition(const swSpectrumDef* spectrum)
{
    swWaveSystemDef def = MakeWaves(spectrum, 16.0, 4096.0, 1);
    swWorld* world = CreateTruthSea(&def);
    const swFrame* frame = swGetWorldFrame(world);
    double worst = 0.0, height = (double)spectrum->significantHeight, total = height * height / 16.0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        for (int times = 1; times <= 2 && (double)frame->tiles[i].variance > 0.1 * total; ++times)
        {
            double away = times * frame->tiles[i].side;
            worst = fmax(worst, fabs(FindCorrelation(world, away, 0.0)));
            worst = fmax(worst, fabs(FindCorrelation(world, 0.0, away)));
        }
    }
    swDestroyWorld(world);
    return worst;
}

static void NarrowSwellsHardlyRepeat(void** state)
{
    (void)state;
    static const double rows[][2] = {{8.0, 0.1}, {10.0, 0.1}, {14.0, 0.1}, {10.0, 0.15}, {18.0, 0.15}, {10.0, 0.25}};
    for (int i = 0; i < (int)(sizeof(rows) / sizeof(rows[0])); ++i)
    {
        swSpectrumDef spectrum = swMakeSwellSpectrum(2.0f, (float)rows[i][0], 0.4f, (float)rows[i][1]);
        char what[128];
        snprintf(what, sizeof(what), "Correlation one and two tiles away, swell of %.0f s that spreads by %.2f rad",
                 rows[i][0], rows[i][1]);
        FindBelow(&(Finding){"Tile", what, "one tile alone has 0.7 to 0.8", "", 2}, 0.4, FindRepetition(&spectrum));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TilesAreTheDirectSumOfTheirWaves),
        cmocka_unit_test(NarrowSwellsHardlyRepeat),
    };
    BeginTruth("truth_tiles");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
