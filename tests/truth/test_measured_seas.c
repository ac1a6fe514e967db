// SPDX-License-Identifier: MIT
// A measured spectrum goes in, and buoys on the surface measure the same sea: significant height, peak period and mean
// direction, for sixteen seeds, each by itself. Prints what was measured. Seeds run side by side on all processors.

#include "support/cmocka_setup.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sea_estimate.h"
#include "seaway/scene.h"

#define SEED_COUNT 16
#define DEGREE (SW_PI / 180.0)

typedef struct MeasuredCase
{
    swMeasuredRecord record;
    SeaBins bins;
    swSeaState asked;
    int askedPeak; // bin
    swSeaState states[SEED_COUNT];
    int peaks[SEED_COUNT];
    SeaSums sums[SEED_COUNT];
    bool isFine[SEED_COUNT];
} MeasuredCase;

static swSpectrumDef MakeSpectrum(const MeasuredCase* measured)
{
    swSpectrumDef spectrum = swDefaultSpectrumDef();
    spectrum.kind = SW_SPECTRUM_TABLE;
    spectrum.table = &measured->record.table;
    spectrum.direction = 0.0f;
    return spectrum;
}

static void MeasureSeeds(void* context, int begin, int end, int worker)
{
    (void)worker;
    MeasuredCase* measured = context;
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    SeaGauges gauges = {.area = 8000.0, .gaugeCount = 256, .duration = 800.0};
    for (int i = begin; i < end; ++i)
    {
        swWorld* world = NULL;
        swWaveSystemId id;
        swWaveSystemDef def = swDefaultWaveSystemDef();
        def.spectrum = MakeSpectrum(measured);
        def.seed = 1u + (uint32_t)i;
        double highest = 1.02 * measured->bins.high[measured->bins.count - 1];
        def.minWavelength = (float)FindWavelength(highest, (double)INFINITY, 9.81); // shorter ones are not measured
        measured->isFine[i] = swCreateWorld(&host, &worldDef, &world) == SW_SUCCESS &&
                              swCreateWaveSystem(world, &def, &id) == SW_SUCCESS &&
                              RecordSea(world, &gauges, &measured->bins, &measured->sums[i]);
        FindSeaState(&measured->bins, &measured->sums[i], &measured->states[i]);
        measured->peaks[i] = FindPeakBin(&measured->bins, &measured->sums[i]);
        swDestroyWorld(world);
    }
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

static void CheckCase(const char* name, const MeasuredCase* measured)
{
    const swSeaState* asked = &measured->asked;
    double worstHeight = 0.0, worstTurn = 0.0, meanHeight = 0.0;
    int worstPeak = 0;
    for (int i = 0; i < SEED_COUNT; ++i)
    {
        assert_true(measured->isFine[i]);
        const swSeaState* state = &measured->states[i];
        double ratio = (double)state->significantHeight / (double)asked->significantHeight;
        worstHeight = fmax(worstHeight, fabs(ratio - 1.0));
        worstTurn = fmax(worstTurn, TurnBetween(state->meanDirection, asked->meanDirection));
        meanHeight += (double)state->significantHeight / SEED_COUNT;
        int off = abs(measured->peaks[i] - measured->askedPeak);
        worstPeak = off > worstPeak ? off : worstPeak;
    }
    printf("%s at %s: Hs %.3f m, measured %.3f m, worst seed off by %.2f %%; Tp %.2f s, worst off by %d bins; "
           "direction, worst off by %.2f degrees\n",
           name, measured->record.time, (double)asked->significantHeight, meanHeight, 100.0 * worstHeight,
           (double)asked->peakPeriod, worstPeak, worstTurn);
    assert_true(worstHeight < 0.02);
    assert_true(worstPeak <= 1);
    assert_true(worstTurn < 3.0);
}

static void MeasureRecord(const char* name, const swMeasuredSea* sea, int index)
{
    MeasuredCase* measured = calloc(1, sizeof(MeasuredCase));
    assert_non_null(measured);
    measured->record = swMeasuredSea_GetRecord(sea, index);
    UseTableBins(&measured->record.table, &measured->bins);
    measured->askedPeak = FindAskedPeak(measured);
    swSpectrumDef spectrum = MakeSpectrum(measured);
    assert_int_equal(swSpectrum_GetSeaState(&spectrum, 0.0f, 0.0f, &measured->asked), SW_SUCCESS);

    swHost host = swDefaultHost();
    swTaskPool* pool = NULL;
    assert_int_equal(swCreateTaskPool(&host, (int)sysconf(_SC_NPROCESSORS_ONLN) - 1, &pool), SW_SUCCESS);
    swTaskPool_Attach(pool, &host);
    host.parallelFor(host.taskContext, MeasureSeeds, measured, SEED_COUNT, 1);
    swDestroyTaskPool(pool);
    CheckCase(name, measured);
    free(measured);
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
    MeasureRecord(slash + 1, sea, swMeasuredSea_FindLargest(sea));
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(OurOwnBuoyIsMeasuredOnTheSurface),
        cmocka_unit_test(BostonsGaleIsMeasuredOnTheSurface),
        cmocka_unit_test(CanaveralsSeaIsMeasuredOnTheSurface),
        cmocka_unit_test(AnArchivedSeaWithoutDirectionsIsMeasuredOnTheSurface),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
