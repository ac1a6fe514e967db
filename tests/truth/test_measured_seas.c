// SPDX-License-Identifier: MIT
// V22: a measured spectrum goes in, and buoys on the surface measure the same sea: significant height, periods, mean
// direction and spread, for sixteen seeds, each by itself. Seeds run side by side on all processors. The sea is made by
// transforms, or of Gerstner waves, 32 an octave, each of which stands for 1.1 % of frequency. Where a file's bins are not
// three times as wide, some hold half as many waves again as others, and a peak may be found two bins away. Where seas nearly
// cancel each other in the mean, so few waves leave it uncertain by some degrees.

#include "truth.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "seaway/scene.h"

#define SEED_COUNT 16

typedef struct MeasuredCase
{
    swMeasuredRecord record;
    swWaveMethod method;
    SeaBins bins;
    swSeaState asked;
    int askedPeak; // bin
    swSeaState states[SEED_COUNT];
    int peaks[SEED_COUNT];
    SeaSums sums[SEED_COUNT];
    bool isFine[SEED_COUNT];
} MeasuredCase;

static swSpectrumDef MakeTableSpectrum(const MeasuredCase* measured)
{
    swSpectrumDef spectrum = swDefaultSpectrumDef();
    spectrum.kind = SW_SPECTRUM_TABLE;
    spectrum.table = &measured->record.table;
    spectrum.direction = 0.0f;
    return spectrum;
}

static void MeasureSeed(void* context, int seed)
{
    MeasuredCase* measured = context;
    SeaGauges gauges = {.area = 8000.0, .gaugeCount = 256, .duration = 800.0};
    if (measured->method == SW_WAVES_GERSTNER)
    {
        gauges.area *= 8.0; // a few long waves beat over tens of kilometres
    }
    swSpectrumDef spectrum = MakeTableSpectrum(measured);
    double highest = 1.02 * measured->bins.high[measured->bins.count - 1]; // shorter waves are not measured
    swWaveSystemDef def =
        MakeWaves(&spectrum, FindWavelength(highest, (double)INFINITY, 9.81), 4096.0, 1u + (uint32_t)seed);
    def.method = measured->method;
    def.componentsPerOctave = 32;
    swWorld* world = CreateTruthSea(&def);
    measured->isFine[seed] = RecordSea(world, &gauges, &measured->bins, 1, &measured->sums[seed]);
    FindSeaState(&measured->bins, &measured->sums[seed], &measured->states[seed]);
    measured->peaks[seed] = FindPeakBin(&measured->bins, &measured->sums[seed]);
    swDestroyWorld(world);
}

static double TurnBetween(float a, float b)
{
    return fabs(remainder((double)a - (double)b, 2.0 * SW_PI)) / DEGREE;
}

static int FindAskedPeak(const MeasuredCase* measured)
{
    int peak = 0;
    for (int i = 1; i < measured->bins.count; ++i)
    {
        peak = measured->record.energy[i] > measured->record.energy[peak] ? i : peak;
    }
    return peak;
}

// How far the seeds are off: the mean of them, and the worst.
typedef struct Offsets
{
    double height, period, direction, spread; // parts of one, degrees
    int peak;                                 // bins
} Offsets;

static Offsets FindWorst(const MeasuredCase* measured, int count)
{
    const swSeaState* asked = &measured->asked;
    Offsets worst = {0};
    for (int i = 0; i < count; ++i)
    {
        assert_true(measured->isFine[i]);
        const swSeaState* state = &measured->states[i];
        double height = (double)state->significantHeight / (double)asked->significantHeight - 1.0;
        double period = (double)state->periodTm02 / (double)asked->periodTm02 - 1.0;
        int peak = abs(measured->peaks[i] - measured->askedPeak);
        worst.height = fmax(worst.height, fabs(height));
        worst.period = fmax(worst.period, fabs(period));
        worst.direction = fmax(worst.direction, TurnBetween(state->meanDirection, asked->meanDirection));
        worst.spread = fmax(worst.spread, fabs((double)state->spread - (double)asked->spread) / DEGREE);
        worst.peak = peak > worst.peak ? peak : worst.peak;
    }
    return worst;
}

static double FindPeakLimit(const MeasuredCase* measured)
{
    const SeaBins* bins = &measured->bins;
    double width = bins->high[measured->askedPeak] / bins->low[measured->askedPeak] - 1.0;
    return measured->method == SW_WAVES_GERSTNER && width < 3.0 * (exp2(0.5 / 32.0) - 1.0) ? 2.0 : 1.0;
}

static void CheckCase(const char* name, const MeasuredCase* measured)
{
    Offsets worst = FindWorst(measured, Seeds(SEED_COUNT));
    char what[512], sea[384];
    snprintf(sea, sizeof(sea), "%s%s%s, Hs %.2f m, Tp %.1f s%s", name, measured->record.time[0] != 0 ? ", " : "",
             measured->record.time, (double)measured->asked.significantHeight, (double)measured->asked.peakPeriod,
             measured->method == SW_WAVES_GERSTNER ? ", Gerstner waves" : "");
    snprintf(what, sizeof(what), "%s: Hs, worst of 16 seeds", sea);
    FindBelow(&(Finding){"V22", what, "file to surface to spectrum", "%", 2}, 2.0, 100.0 * worst.height);
    snprintf(what, sizeof(what), "%s: Tp, worst of 16 seeds", sea);
    FindBelow(&(Finding){"V22", what, "file to surface to spectrum", "bins", 0}, FindPeakLimit(measured), worst.peak);
    snprintf(what, sizeof(what), "%s: Tm02, worst of 16 seeds", sea);
    FindBelow(&(Finding){"V22", what, "file to surface to spectrum", "%", 2}, 2.0, 100.0 * worst.period);
    snprintf(what, sizeof(what), "%s: mean direction, worst of 16 seeds", sea);
    bool isVague = measured->method == SW_WAVES_GERSTNER && (double)measured->asked.spread > 60.0 * DEGREE;
    FindBelow(&(Finding){"V22", what, "file to surface to spectrum", "\xc2\xb0", 2}, isVague ? 5.0 : 3.0,
              worst.direction);
    snprintf(what, sizeof(what), "%s: spread, worst of 16 seeds", sea);
    FindBelow(&(Finding){"V22", what, "file to surface to spectrum", "\xc2\xb0", 2}, 3.0, worst.spread);
}

static void MeasureRecordBy(swWaveMethod method, const char* name, const swMeasuredSea* sea, int index)
{
    MeasuredCase* measured = calloc(1, sizeof(MeasuredCase));
    assert_non_null(measured);
    measured->method = method;
    measured->record = swMeasuredSea_GetRecord(sea, index);
    UseTableBins(&measured->record.table, &measured->bins);
    measured->askedPeak = FindAskedPeak(measured);
    swSpectrumDef spectrum = MakeTableSpectrum(measured);
    assert_int_equal(swSpectrum_GetSeaState(&spectrum, 0.0f, 0.0f, &measured->asked), SW_SUCCESS);

    RunJobs(MeasureSeed, measured, Seeds(SEED_COUNT));
    CheckCase(name, measured);
    free(measured);
}

static void MeasureRecord(const char* name, const swMeasuredSea* sea, int index)
{
    MeasureRecordBy(SW_WAVES_FFT, name, sea, index);
    MeasureRecordBy(SW_WAVES_GERSTNER, name, sea, index);
}

static void MeasureFile(const char* path)
{
    char full[1024];
    snprintf(full, sizeof(full), "%s/%s", SW_SOURCE_DIR, path);
    if (access(full, R_OK) != 0)
    {
        printf("%s is absent: skipped\n", path);
        skip();
    }
    swHost host = swDefaultHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(swReadMeasuredSea(&host, full, &sea), SW_SUCCESS);
    const char* slash = strrchr(path, '/');
    MarkOptional(strncmp(path, "scenes/", 7) != 0); // data that is not part of the project
    for (int i = 0; i < swMeasuredSea_GetLocationCount(sea); ++i)
    {
        char name[256];
        snprintf(name, sizeof(name), "%s%s%s", slash + 1, swMeasuredSea_GetLocation(sea, i).name[0] != 0 ? " " : "",
                 swMeasuredSea_GetLocation(sea, i).name);
        MeasureRecord(name, sea, swMeasuredSea_FindRecord(sea, i, NULL));
    }
    swDestroyMeasuredSea(sea);
}

static void OurOwnBuoyIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("scenes/data/harbour_storm.data_spec");
}

static void BostonsGaleIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("../shared/data/spectra/ndbc_44013_2022-05/44013.data_spec");
}

static void CanaveralsSeaIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("../shared/data/spectra/ndbc_41010_2020-06/41010.data_spec");
}

static void AnArchivedSeaWithoutDirectionsIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("../shared/data/spectra/ndbc_44004_2000_old_format/44004w2000.txt");
}

static void ABuoysSummaryIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("../shared/data/spectra/ndbc_44013_2022-05/44013.spec");
}

static void ASpottersSeaIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("../shared/data/spectra/spotter_southern_ocean_2018-02/spotter_20180214.json");
}

static void ATriaxysSeaByDirectionIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("../shared/data/spectra/triaxys_2018-01/triaxys.DIRSPEC");
}

static void ATriaxysSeaWithoutDirectionsIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("../shared/data/spectra/triaxys_2018-01/triaxys.NONDIRSPEC");
}

static void CdipsSeasAreMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("../shared/data/spectra/cdip_mhkit/ValData2_CDiP.json");
}

static void AWavewatchSeaIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("../shared/data/spectra/ww3_44097_2022-09/ww3station.spec");
}

static void ASwanSeaIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureFile("../shared/data/spectra/swan_raglan_2016-10/swanfile.spec");
}

// ---- files of the same formats that nobody has ----

static void MeasureText(const char* name, const char* text)
{
    swHost host = swDefaultHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseMeasuredSea(&host, text, strlen(text), name, &sea), SW_SUCCESS);
    MarkOptional(false);
    MeasureRecord(name, sea, 0);
    swDestroyMeasuredSea(sea);
}

static void SeasThatRunAgainstEachOtherAreMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureText("opposed.csv", "time,hs_m,tp_s,direction_from_deg,spread_deg,gamma\n"
                               "2020-01-01 00:00,1.8,13.0,200,14,5\n"
                               "2020-01-01 00:00,1.2,9.0,330,18,3.3\n"
                               "2020-01-01 00:00,2.1,5.5,40,30,1.5\n");
}

// m^2/Hz/degree: a sea from 115 degrees that turns to 160 at high frequencies.
static double FindSyntheticDensity(double frequency, double bearing)
{
    double x = 0.11 / frequency, mean = 115.0 + 45.0 * fmax(0.0, 1.0 - x);
    double half = 0.5 * (bearing - mean) * DEGREE;
    return 0.0008 * pow(frequency, -5.0) * exp(-1.25 * pow(x, 4.0)) * 2e-4 * pow(cos(half) * cos(half), 9.0);
}

static void UnequalDirectionsAreMeasuredOnTheSurface(void** state)
{
    (void)state;
    enum
    {
        FREQUENCIES = 26,
        DIRECTIONS = 31,
        SIZE = 65536
    };
    char* text = calloc(1, SIZE);
    assert_non_null(text);
    int used = snprintf(text, SIZE, "SWAN 1\nLONLAT\n1\n3.5 56.2\nAFREQ\n%d\n", FREQUENCIES);
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        used += snprintf(text + used, (size_t)(SIZE - used), "%.5f\n", 0.05 * pow(1.1, i));
    }
    used += snprintf(text + used, (size_t)(SIZE - used), "NDIR\n%d\n", DIRECTIONS);
    for (int j = 0; j < DIRECTIONS; ++j)
    {
        used += snprintf(text + used, (size_t)(SIZE - used), "%.2f\n", 360.0 - 12.0 * j + 2.0 * sin(1.0 * j));
    }
    used += snprintf(text + used, (size_t)(SIZE - used), "QUANT\n1\nVaDens\nm2/Hz/degr\n-99\nFACTOR\n1e-6\n");
    for (int i = 0; i < FREQUENCIES * DIRECTIONS; ++i)
    {
        double bearing = 360.0 - 12.0 * (i % DIRECTIONS) + 2.0 * sin(1.0 * (i % DIRECTIONS));
        double density = FindSyntheticDensity(0.05 * pow(1.1, i / DIRECTIONS), bearing);
        used += snprintf(text + used, (size_t)(SIZE - used), i % DIRECTIONS == DIRECTIONS - 1 ? "%ld\n" : "%ld ",
                         lround(1e6 * density));
    }
    assert_true(used < SIZE - 1);
    MeasureText("unequal.spec", text);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(OurOwnBuoyIsMeasuredOnTheSurface),
        cmocka_unit_test(BostonsGaleIsMeasuredOnTheSurface),
        cmocka_unit_test(CanaveralsSeaIsMeasuredOnTheSurface),
        cmocka_unit_test(AnArchivedSeaWithoutDirectionsIsMeasuredOnTheSurface),
        cmocka_unit_test(ABuoysSummaryIsMeasuredOnTheSurface),
        cmocka_unit_test(ASpottersSeaIsMeasuredOnTheSurface),
        cmocka_unit_test(ATriaxysSeaByDirectionIsMeasuredOnTheSurface),
        cmocka_unit_test(ATriaxysSeaWithoutDirectionsIsMeasuredOnTheSurface),
        cmocka_unit_test(CdipsSeasAreMeasuredOnTheSurface),
        cmocka_unit_test(AWavewatchSeaIsMeasuredOnTheSurface),
        cmocka_unit_test(ASwanSeaIsMeasuredOnTheSurface),
        cmocka_unit_test(SeasThatRunAgainstEachOtherAreMeasuredOnTheSurface),
        cmocka_unit_test(UnequalDirectionsAreMeasuredOnTheSurface),
    };
    BeginTruth("test_measured_seas");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
