// SPDX-License-Identifier: MIT
// V1: ask for a significant height and the surface has it. Heights over a wide area at times far apart are as good as
// independent, so that their variance over n samples scatters as chi squared with n degrees of freedom: no seed may leave
// the band that one in two thousand would, and the mean over the seeds has to be right within a percent.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#define SEED_COUNT 64
#define POINT_COUNT 256
#define TIME_COUNT 16
#define AREA 23000.0
// The standard normal's quantile that 1 in 2000 is beyond, above or below.
#define QUANTILE 3.48

typedef struct HeightCase
{
    swWaveSystemDef def;
    bool isSurface;             // heights above fixed places; else heave of particles
    double heights[SEED_COUNT]; // 4 times the deviation of each seed
} HeightCase;

static void PlacePoints(swPosXZ* points)
{
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        double x = 0.7548776662466927 * (i + 1), z = 0.5698402909980532 * (i + 1);
        points[i] = (swPosXZ){AREA * (x - floor(x)), AREA * (z - floor(z))};
    }
}

static void MeasureHeight(void* context, int seed)
{
    HeightCase* height = context;
    swWaveSystemDef def = height->def;
    def.seed = 1000u + (uint32_t)seed;
    swWorld* world = CreateTruthSea(&def);
    swPosXZ points[POINT_COUNT];
    float heights[POINT_COUNT];
    swVec3 displacement[POINT_COUNT];
    swQueryDef query = swDefaultQueryDef();
    double sum = 0.0, square = 0.0;
    PlacePoints(points);
    for (int time = 0; time < TIME_COUNT; ++time)
    {
        swWorld_SetTime(world, 61.0 * time);
        swWorld_Step(world, 0.0);
        swWorld_QuerySurface(world, &query, height->isSurface ? POINT_COUNT : 0, points,
                             &(swSurfaceSamples){.height = heights}, NULL);
        swWorld_QueryParticles(world, &query, height->isSurface ? 0 : POINT_COUNT, points,
                               &(swSurfaceSamples){.displacement = displacement}, NULL);
        for (int i = 0; i < POINT_COUNT; ++i)
        {
            double h = height->isSurface ? (double)heights[i] : (double)displacement[i].y;
            sum += h;
            square += h * h;
        }
    }
    swDestroyWorld(world);
    const double count = POINT_COUNT * TIME_COUNT;
    height->heights[seed] = 4.0 * sqrt(square / count - (sum / count) * (sum / count));
}

// A quantile of chi squared over its degrees of freedom [Wilson 1931].
static double FindQuantile(double degrees, double normal)
{
    double part = 2.0 / (9.0 * degrees), root = 1.0 - part + normal * sqrt(part);
    return root * root * root;
}

static void CheckHeights(const char* name, const swSpectrumDef* spectrum, swWaveSystemDef def, bool isSurface)
{
    HeightCase height = {.def = def, .isSurface = isSurface};
    int count = Seeds(SEED_COUNT);
    RunJobs(MeasureHeight, &height, count);
    double mean = 0.0, worst = 0.0, asked = (double)spectrum->significantHeight;
    double degrees = POINT_COUNT * TIME_COUNT - 1;
    double low = sqrt(FindQuantile(degrees, -QUANTILE)), high = sqrt(FindQuantile(degrees, QUANTILE));
    for (int i = 0; i < count; ++i)
    {
        double ratio = height.heights[i] / asked;
        mean += height.heights[i] / count;
        worst = fmax(worst, ratio > 1.0 ? (ratio - 1.0) / (high - 1.0) : (1.0 - ratio) / (1.0 - low));
    }
    char what[128];
    snprintf(what, sizeof(what), "Hs of %s, mean of 64 seeds", name);
    FindWithin(&(Finding){"V1", what, "4 std(h)", "m", 3}, asked, mean, 0.01);
    snprintf(what, sizeof(what), "Hs of %s, the seed farthest off, in widths of its \xcf\x87\xc2\xb2 band", name);
    FindBelow(&(Finding){"V1", what, "\xcf\x87\xc2\xb2, 1 in 2000", "", 2}, 1.0, worst);
}

static void AWindSeaHasTheHeightAskedFor(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.4, 8.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 1.0, 4096.0, 1);
    CheckHeights("a JONSWAP sea, particles", &spectrum, def, false);
    def.chop = 0.0f;
    CheckHeights("a JONSWAP sea without chop, surface", &spectrum, def, true);
}

static void ASwellHasTheHeightAskedFor(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 3.0, 14.0, 2.1, 75.0);
    spectrum.gamma = 8.0f;
    CheckHeights("a narrow swell, particles", &spectrum, MakeWaves(&spectrum, 16.0, 4096.0, 1), false);
}

static void AFullyDevelopedSeaHasTheHeightAskedFor(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_PIERSON_MOSKOWITZ, 5.0, 11.2, -1.0, 8.0);
    CheckHeights("a Pierson-Moskowitz sea, particles", &spectrum, MakeWaves(&spectrum, 2.0, 4096.0, 1), false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AWindSeaHasTheHeightAskedFor),
        cmocka_unit_test(ASwellHasTheHeightAskedFor),
        cmocka_unit_test(AFullyDevelopedSeaHasTheHeightAskedFor),
    };
    BeginTruth("truth_height");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
