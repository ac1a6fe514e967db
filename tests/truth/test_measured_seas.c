// SPDX-License-Identifier: MIT
// V22: a measured spectrum goes in, and buoys on the surface measure the same sea: significant height, period Tm02,
// mean direction and spread for eight seeds, each by itself, and the peak and its direction for all of them together.
// Where another bin holds more than 95 % of the highest density, either counts as the peak; where the energy at the
// peak goes in nearly all directions (r1 below 0.25) its direction is printed and not judged. Every file of others that
// lies beside the sources is taken, whatever its format.
//
// Seeds run side by side on all processors. The sea is made by transforms, or of Gerstner waves, 32 an octave, each of
// which stands for 1.1 % of frequency. Where a file's bins are not three times as wide, some hold half as many waves
// again as others, and a peak may be found two bins away. Where seas nearly cancel each other in the mean, so few waves
// leave it uncertain by some degrees, and the direction at the peak is that of a handful of waves.
//
// Files of others are measured at their first place, made by transforms, and two records of a month. With
// SEAWAY_TRUTH_FULL=1 in the environment more places, more records, and Gerstner waves are measured too, for half an
// hour.

#include "truth.h"

#include <dirent.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "seaway/files.h"

#define SEED_COUNT 8

#define OTHERS SW_SOURCE_DIR "/../shared/data"

static bool IsFull(void)
{
    const char* full = getenv("SEAWAY_TRUTH_FULL");
    return full != NULL && full[0] == '1';
}

// Places of a file, and records of a long one, that are measured.
#define MOST_PLACES (IsFull() ? 4 : 1)
#define MOST_RECORDS (IsFull() ? 12 : 2)

typedef struct MeasuredCase
{
    swMeasuredRecord record;
    swWaveMethod method;
    swSeaBins bins;
    swSeaState asked;
    double density[SW_MAX_SEA_BINS]; // m^2/Hz
    int askedPeak;                   // bin
    swSeaState states[SEED_COUNT];
    swSeaSums sums[SEED_COUNT];
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
    swSeaGauges gauges = {.area = 8000.0, .gaugeCount = 1024, .duration = 800.0};
    gauges.duration = fmax(gauges.duration, swGetTableDuration(&measured->record.table));
    gauges.area *= 8.0; // a few long waves, and those of parallel tiles, beat over tens of kilometres
    swSpectrumDef spectrum = MakeTableSpectrum(measured);
    double highest = 1.02 * measured->bins.high[measured->bins.count - 1]; // shorter waves are not measured
    swWaveSystemDef def =
        MakeWaves(&spectrum, swGetWavelength(highest, (double)INFINITY, 9.81), 4096.0, 1u + (uint32_t)seed);
    def.method = measured->method;
    def.componentsPerOctave = 32;
    swWorld* world = CreateTruthSea(&def);
    measured->isFine[seed] = swRecordSea(world, &gauges, &measured->bins, 1, &measured->sums[seed]) == SW_SUCCESS;
    swEstimateSeaState(&measured->bins, &measured->sums[seed], &measured->states[seed]);
    swDestroyWorld(world);
}

static double TurnBetween(float a, float b)
{
    return fabs(remainder((double)a - (double)b, 2.0 * SW_PI)) / DEGREE;
}

static void FindAskedPeak(MeasuredCase* measured)
{
    measured->askedPeak = 0;
    for (int i = 0; i < measured->bins.count; ++i)
    {
        double width = measured->bins.high[i] - measured->bins.low[i];
        measured->density[i] =
            (double)measured->record.energy[i] * (double)measured->record.table.bandwidths[i] / width;
        measured->askedPeak = measured->density[i] > measured->density[measured->askedPeak] ? i : measured->askedPeak;
    }
}

static bool IsPeak(const MeasuredCase* measured, int bin)
{
    return bin == measured->askedPeak || measured->density[bin] > 0.95 * measured->density[measured->askedPeak];
}

// Bins from the nearest one that counts as the peak.
static int FindPeakOffset(const MeasuredCase* measured, int bin)
{
    int nearest = abs(bin - measured->askedPeak);
    for (int i = 0; i < measured->bins.count; ++i)
    {
        nearest = IsPeak(measured, i) && abs(bin - i) < nearest ? abs(bin - i) : nearest;
    }
    return nearest;
}

// How far the seeds are off: the mean of them, and the worst.
typedef struct Offsets
{
    double height, period, direction, spread; // parts of one, degrees
    double peakDirection;                     // degrees; negative where it is not judged
    int peak;                                 // bins
} Offsets;

// The peak of all seeds together: bins that it is off, and degrees of its direction, negative where that is not judged.
static void FindPeak(const MeasuredCase* measured, Offsets* worst)
{
    swSeaSums* all = calloc(1, sizeof(swSeaSums));
    assert_non_null(all);
    for (int i = 0; i < Seeds(SEED_COUNT); ++i)
    {
        swAddSeaSums(&measured->sums[i], all);
    }
    int peak = swFindPeakBin(&measured->bins, all);
    int asked = IsPeak(measured, peak) ? peak : measured->askedPeak;
    swDirectionMoments moments = swEstimateMoments(all, peak);
    free(all);
    bool isJudged = measured->record.meanDirection != NULL && (double)measured->record.r1[asked] >= 0.25;
    worst->peak = FindPeakOffset(measured, peak);
    worst->peakDirection = -1.0;
    if (isJudged)
    {
        float direction = (float)atan2(moments.b1, moments.a1);
        worst->peakDirection = TurnBetween(direction, measured->record.meanDirection[asked]);
    }
}

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
        worst.height = fmax(worst.height, fabs(height));
        worst.period = fmax(worst.period, fabs(period));
        worst.direction = fmax(worst.direction, TurnBetween(state->meanDirection, asked->meanDirection));
        worst.spread = fmax(worst.spread, fabs((double)state->spread - (double)asked->spread) / DEGREE);
    }
    FindPeak(measured, &worst);
    return worst;
}

static double FindPeakLimit(const MeasuredCase* measured)
{
    const swSeaBins* bins = &measured->bins;
    double width = bins->high[measured->askedPeak] / bins->low[measured->askedPeak] - 1.0;
    return measured->method == SW_WAVES_GERSTNER && width < 3.0 * (exp2(0.5 / 32.0) - 1.0) ? 2.0 : 1.0;
}

static void Check(const char* sea, const Offsets* worst, double peakLimit, double directionLimit)
{
    struct
    {
        const char *what, *unit;
        int digits;
        double limit, value;
    } rows[6] = {{"Hs, worst of 8 seeds", "%", 2, 2.0, 100.0 * worst->height},
                 {"Tp, 8 seeds together", "bins", 0, peakLimit, worst->peak},
                 {"Tm02, worst of 8 seeds", "%", 2, 2.0, 100.0 * worst->period},
                 {"mean direction, worst of 8 seeds", "\xc2\xb0", 2, directionLimit, worst->direction},
                 {"spread, worst of 8 seeds", "\xc2\xb0", 2, 3.0, worst->spread},
                 {"direction at the peak, 8 seeds together", "\xc2\xb0", 2, 3.0, worst->peakDirection}};
    for (int i = 0; i < 6; ++i)
    {
        char what[512];
        snprintf(what, sizeof(what), "%s: %s", sea, rows[i].what);
        if (rows[i].value >= 0.0)
        {
            FindBelow(&(Finding){"V22", what, "file to surface to spectrum", rows[i].unit, rows[i].digits},
                      rows[i].limit, rows[i].value);
        }
    }
}

static void CheckCase(const char* name, const MeasuredCase* measured)
{
    Offsets worst = FindWorst(measured, Seeds(SEED_COUNT));
    bool isGerstner = measured->method == SW_WAVES_GERSTNER;
    bool isVague = isGerstner && (double)measured->asked.spread > 60.0 * DEGREE;
    char sea[384];
    snprintf(sea, sizeof(sea), "%s%s%s, Hs %.2f m, Tp %.1f s%s", name, measured->record.time[0] != 0 ? ", " : "",
             measured->record.time, (double)measured->asked.significantHeight, (double)measured->asked.peakPeriod,
             isGerstner ? ", Gerstner waves" : "");
    if (!isGerstner && worst.peakDirection < 0.0 && measured->record.meanDirection != NULL)
    {
        printf("%s: waves of the peak go in nearly all directions, which is not judged\n", sea);
    }
    worst.peakDirection = isGerstner ? -1.0 : worst.peakDirection;
    Check(sea, &worst, FindPeakLimit(measured), isVague ? 5.0 : 3.0);
}

static MeasuredCase* MeasureCase(swWaveMethod method, const swMeasuredSea* sea, int index)
{
    MeasuredCase* measured = calloc(1, sizeof(MeasuredCase));
    assert_non_null(measured);
    measured->method = method;
    measured->record = swMeasuredSea_GetRecord(sea, index);
    swMakeTableBins(&measured->record.table, &measured->bins);
    FindAskedPeak(measured);
    swSpectrumDef spectrum = MakeTableSpectrum(measured);
    assert_int_equal(swSpectrum_GetSeaState(&spectrum, 0.0f, 0.0f, &measured->asked), SW_SUCCESS);
    RunJobs(MeasureSeed, measured, Seeds(SEED_COUNT));
    return measured;
}

static void MeasureRecordBy(swWaveMethod method, const char* name, const swMeasuredSea* sea, int index)
{
    MeasuredCase* measured = MeasureCase(method, sea, index);
    CheckCase(name, measured);
    free(measured);
}

static void MeasureRecord(const char* name, const swMeasuredSea* sea, int index, bool withGerstner)
{
    MeasureRecordBy(SW_WAVES_FFT, name, sea, index);
    if (withGerstner)
    {
        MeasureRecordBy(SW_WAVES_GERSTNER, name, sea, index);
    }
}

static swMeasuredSea* ReadSea(const char* path)
{
    swHost host = swDefaultHost();
    swMeasuredSea* sea = NULL;
    return swReadMeasuredSea(&host, path, &sea) == SW_SUCCESS ? sea : NULL;
}

// The highest record of each place.
static void MeasureFile(const char* path, const swMeasuredSea* sea, bool withGerstner)
{
    for (int i = 0; i < swMeasuredSea_GetLocationCount(sea) && i < MOST_PLACES; ++i)
    {
        char name[256];
        snprintf(name, sizeof(name), "%s%s%s", strrchr(path, '/') + 1,
                 swMeasuredSea_GetLocation(sea, i).name[0] != 0 ? " " : "", swMeasuredSea_GetLocation(sea, i).name);
        int index = swMeasuredSea_FindRecord(sea, i, NULL);
        if (index >= 0)
        {
            MeasureRecord(name, sea, index, withGerstner);
        }
    }
}

static void OurOwnBuoyIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    const char* path = SW_SOURCE_DIR "/scenes/data/harbour_storm.data_spec";
    swMeasuredSea* sea = ReadSea(path);
    assert_non_null(sea);
    MarkOptional(false);
    MeasureFile(path, sea, true);
    swDestroyMeasuredSea(sea);
}

// ---- files of others ----

// Parts of a set that is named by another file, and what was worked out from the files.
static bool IsSea(const char* name)
{
    static const char* const others[] = {".swdir", ".swdir2", ".swr1", ".swr2", "expected.csv", ".md", "README"};
    for (size_t i = 0; i < sizeof(others) / sizeof(others[0]); ++i)
    {
        size_t length = strlen(name), end = strlen(others[i]);
        if (name[0] == '.' || (length >= end && strcmp(name + length - end, others[i]) == 0))
        {
            return false;
        }
    }
    return true;
}

static int MeasureFolder(const char* folder)
{
    struct dirent** entries = NULL;
    int count = scandir(folder, &entries, NULL, alphasort), measured = 0;
    for (int i = 0; i < count; ++i)
    {
        char path[2048];
        snprintf(path, sizeof(path), "%s/%s", folder, entries[i]->d_name);
        swMeasuredSea* sea = IsSea(entries[i]->d_name) ? ReadSea(path) : NULL;
        if (sea != NULL)
        {
            MarkOptional(true); // data that is not part of the project
            MeasureFile(path, sea, IsFull());
            measured += 1;
        }
        else
        {
            printf("%s is no sea that is read\n", entries[i]->d_name);
        }
        swDestroyMeasuredSea(sea);
        free(entries[i]);
    }
    free(entries);
    return measured;
}

static void EveryFileOfOthersIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    struct dirent** entries = NULL;
    int count = scandir(OTHERS "/spectra", &entries, NULL, alphasort), measured = 0;
    for (int i = 0; i < count; ++i)
    {
        char folder[1024];
        snprintf(folder, sizeof(folder), "%s/spectra/%s", OTHERS, entries[i]->d_name);
        measured += entries[i]->d_name[0] != '.' ? MeasureFolder(folder) : 0;
        free(entries[i]);
    }
    free(entries);
    printf("%d files of others were measured\n", measured);
    if (count < 0)
    {
        printf("the folder of files of others is absent: skipped\n");
        skip();
    }
    assert_true(measured >= 10);
}

// Neighbouring bins with a third of the density, another direction, and a second peak nearly as high.
static void ANarrowPeakIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    const char* path = OTHERS "/faults/narrow_peak.data_spec";
    if (access(path, R_OK) != 0)
    {
        printf("the narrow peak is absent: skipped\n");
        skip();
    }
    swMeasuredSea* sea = ReadSea(path);
    assert_non_null(sea);
    MarkOptional(true);
    MeasureFile(path, sea, IsFull());
    swDestroyMeasuredSea(sea);
}

// Records spread evenly over a month, made by transforms: the worst of them all.
static void MeasureMonth(const char* path)
{
    if (access(path, R_OK) != 0)
    {
        printf("%s is absent: skipped\n", path);
        skip();
    }
    swMeasuredSea* sea = ReadSea(path);
    assert_non_null(sea);
    MarkOptional(true);
    int count = swMeasuredSea_GetCount(sea), unjudged = 0;
    Offsets worst = {.peakDirection = -1.0};
    for (int i = 0; i < MOST_RECORDS; ++i)
    {
        MeasuredCase* measured = MeasureCase(SW_WAVES_FFT, sea, (2 * i + 1) * count / (2 * MOST_RECORDS));
        Offsets own = FindWorst(measured, Seeds(SEED_COUNT));
        worst.height = fmax(worst.height, own.height);
        worst.period = fmax(worst.period, own.period);
        worst.direction = fmax(worst.direction, own.direction);
        worst.spread = fmax(worst.spread, own.spread);
        worst.peakDirection = fmax(worst.peakDirection, own.peakDirection);
        worst.peak = own.peak > worst.peak ? own.peak : worst.peak;
        unjudged += own.peakDirection < 0.0 ? 1 : 0;
        free(measured);
    }
    char name[256];
    snprintf(name, sizeof(name), "%s, %d of %d records", strrchr(path, '/') + 1, MOST_RECORDS, count);
    printf("%s: %d peaks that go in nearly all directions are not judged\n", name, unjudged);
    Check(name, &worst, 1.0, 3.0);
    swDestroyMeasuredSea(sea);
}

static void AMonthOffBostonIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureMonth(OTHERS "/spectra/ndbc_44013_2022-05/44013.data_spec");
}

static void AMonthOffCanaveralIsMeasuredOnTheSurface(void** state)
{
    (void)state;
    MeasureMonth(OTHERS "/spectra/ndbc_41010_2020-06/41010.data_spec");
}

// ---- files of the same formats that nobody has ----

static void MeasureText(const char* name, const char* text)
{
    swHost host = swDefaultHost();
    swMeasuredSea* sea = NULL;
    assert_int_equal(swParseMeasuredSea(&host, text, strlen(text), name, &sea), SW_SUCCESS);
    MarkOptional(false);
    MeasureRecord(name, sea, 0, IsFull());
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
        cmocka_unit_test(EveryFileOfOthersIsMeasuredOnTheSurface),
        cmocka_unit_test(ANarrowPeakIsMeasuredOnTheSurface),
        cmocka_unit_test(AMonthOffBostonIsMeasuredOnTheSurface),
        cmocka_unit_test(AMonthOffCanaveralIsMeasuredOnTheSurface),
        cmocka_unit_test(SeasThatRunAgainstEachOtherAreMeasuredOnTheSurface),
        cmocka_unit_test(UnequalDirectionsAreMeasuredOnTheSurface),
    };
    BeginTruth("test_measured_seas");
    return cmocka_run_group_tests(tests, NULL, NULL);
}
