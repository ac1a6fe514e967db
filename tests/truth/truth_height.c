// SPDX-License-Identifier: MIT
// V1, V4: ask for a significant height and the surface has it. Heights over a wide area at times far apart are as good
// as independent, so that their variance over n samples scatters as chi squared with n degrees of freedom: no seed may
// leave the band that one in two thousand would, and the mean over the seeds has to be right within a percent.

#include "truth.h"

#include <math.h>
#include <stdlib.h>

#define SEED_COUNT 64
// The standard normal's quantile that 1 in 2000 is beyond, above or below.
#define QUANTILE 3.48

// A quantile of chi squared over its degrees of freedom [Wilson 1931].
static double FindQuantile(double degrees, double normal)
{
    double part = 2.0 / (9.0 * degrees), root = 1.0 - part + normal * sqrt(part);
    return root * root * root;
}

static void CheckHeights(const char* name, double asked, const swWaveSystemDef* def, bool isSurface)
{
    double heights[SEED_COUNT], mean = 0.0, worst = 0.0, degrees = HEIGHT_SAMPLES - 1;
    int count = Seeds(SEED_COUNT);
    MeasureHeights(def, isSurface, count, heights);
    double low = sqrt(FindQuantile(degrees, -QUANTILE)), high = sqrt(FindQuantile(degrees, QUANTILE));
    for (int i = 0; i < count; ++i)
    {
        double ratio = heights[i] / asked;
        mean += heights[i] / count;
        worst = fmax(worst, ratio > 1.0 ? (ratio - 1.0) / (high - 1.0) : (1.0 - ratio) / (1.0 - low));
    }
    char what[128];
    snprintf(what, sizeof(what), "Hs of %s, mean of 64 seeds", name);
    FindWithin(&(Finding){"V1", what, "4 std(h)", "m", 3}, asked, mean, 0.01);
    snprintf(what, sizeof(what), "Hs of %s, the seed farthest off, in widths of its \xcf\x87\xc2\xb2 band", name);
    FindBelow(&(Finding){"V1", what, "\xcf\x87\xc2\xb2, 1 in 2000", "", 2}, 1.0, worst);
}

static void CheckMean(const char* number, const char* what, const char* source, double asked,
                      const swWaveSystemDef* def, int seeds)
{
    double heights[SEED_COUNT], mean = 0.0;
    int count = Seeds(seeds);
    MeasureHeights(def, false, count, heights);
    for (int i = 0; i < count; ++i)
    {
        mean += heights[i] / count;
    }
    FindWithin(&(Finding){number, what, source, "m", 3}, asked, mean, Loosen(0.01));
}

static void AWindSeaHasTheHeightAskedFor(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 2.0, 8.0, 0.4, 8.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 1.0, 4096.0, 1);
    CheckHeights("a JONSWAP sea, particles", 2.0, &def, false);
    def.chop = 0.0f;
    CheckHeights("a JONSWAP sea without chop, surface", 2.0, &def, true);
    def.method = SW_WAVES_GERSTNER;
    CheckHeights("a JONSWAP sea of Gerstner waves without chop, surface", 2.0, &def, true);
}

static void ASwellHasTheHeightAskedFor(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_JONSWAP, 3.0, 14.0, 2.1, 75.0);
    spectrum.gamma = 8.0f;
    swWaveSystemDef def = MakeWaves(&spectrum, 16.0, 4096.0, 1);
    CheckHeights("a narrow swell, particles", 3.0, &def, false);
    def.method = SW_WAVES_GERSTNER;
    CheckHeights("a narrow swell of Gerstner waves, particles", 3.0, &def, false);
    // Standing waves are high or low everywhere at once, so that heights of one time are not independent.
    def.reverseWeight = 0.5f;
    CheckMean("V1", "Hs of the same with a twin of each wave running back, mean of 64 seeds", "4 std(h)", 3.0, &def,
              SEED_COUNT);
}

static void AFullyDevelopedSeaHasTheHeightAskedFor(void** state)
{
    (void)state;
    swSpectrumDef spectrum = MakeSpectrum(SW_SPECTRUM_PIERSON_MOSKOWITZ, 5.0, 11.2, -1.0, 8.0);
    swWaveSystemDef def = MakeWaves(&spectrum, 2.0, 4096.0, 1);
    CheckHeights("a Pierson-Moskowitz sea, particles", 5.0, &def, false);
    def.method = SW_WAVES_GERSTNER;
    CheckHeights("a Pierson-Moskowitz sea of Gerstner waves, particles", 5.0, &def, false);
}

// Significant heights and peaks of the deep sea of wind and fetch over a sea floor, worked out elsewhere.
static void CheckDepths(double wind, double period, const double depths[7], const double heights[7])
{
    for (int i = 0; i < 7; ++i)
    {
        swSpectrumDef spectrum = swDefaultSpectrumDef();
        spectrum.kind = SW_SPECTRUM_TMA;
        spectrum.windSpeed = (float)wind;
        spectrum.peakPeriod = (float)period;
        spectrum.depth = (float)depths[i];
        swWaveSystemDef def = MakeWaves(&spectrum, 2.0, 4096.0, 1);
        char what[128];
        snprintf(what, sizeof(what), "Hs, U10 %.0f m/s over 300 km, peak at %.2f s, %g m deep", wind, period,
                 depths[i]);
        CheckMean("V4", what, "[Bouws 1985], exact depth factor", heights[i], &def, 24);
    }
}

static void SeasOverASeaFloorHaveTheirHeights(void** state)
{
    (void)state;
    static const double depths[7] = {5.0, 10.0, 20.0, 30.0, 50.0, 100.0, 1000.0};
    static const double gale[7] = {2.099, 2.870, 3.799, 4.359, 4.948, 5.278, 5.306};
    static const double storm[7] = {2.481, 3.413, 4.568, 5.301, 6.153, 6.785, 6.874};
    CheckDepths(15.0, 9.973, depths, gale);
    CheckDepths(20.0, 10.998, depths, storm);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AWindSeaHasTheHeightAskedFor),
        cmocka_unit_test(ASwellHasTheHeightAskedFor),
        cmocka_unit_test(AFullyDevelopedSeaHasTheHeightAskedFor),
        cmocka_unit_test(SeasOverASeaFloorHaveTheirHeights),
    };
    BeginTruth("truth_height");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
