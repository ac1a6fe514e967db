// SPDX-License-Identifier: MIT
// V11 of measured seas: a buoy off Boston measured the waves, and the wind beside them, for six days. The foam of its
// seas, by the wind that the waves tell of, against the laws by the wind that was measured, 9 % more at 10 m than at
// the buoy's 4 m. Real seas lag behind their wind, so some hours lie outside; told of the wind, all lie within whose
// short waves stand for it at all.

#include "truth.h"

#include <math.h>
#include <stdlib.h>
#include <stdio.h>
#include <string.h>

#include "seaway/files.h"

#define FOLDER SW_SOURCE_DIR "/../shared/data/spectra/ndbc_44013_2022-05/"
#define RAISED 1.09

static double GetCover(const swMeasuredRecord* record, float wind)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWaveSystemDef def = swDefaultWaveSystemDef();
    worldDef.enableQueries = false;
    def.resolution = 32;
    def.tileWaves = 8;
    def.spectrum.kind = SW_SPECTRUM_TABLE;
    def.spectrum.table = &record->table;
    def.spectrum.hasWind = wind > 0.0f;
    def.spectrum.windSpeed = wind > 0.0f ? wind : def.spectrum.windSpeed;
    swWorld* world = NULL;
    swWaveSystemId id;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    double cover = (double)swWorld_GetFoamState(world).cover;
    swDestroyWorld(world);
    return cover;
}

static bool IsWithinTheLaws(double wind, double cover)
{
    double monahan = 3.84e-6 * pow(wind, 3.41);
    double callaghan = wind < 10.18 ? 3.18e-5 * pow(fmax(wind - 3.70, 0.0), 3.0) : 4.82e-6 * pow(wind + 1.98, 3.0);
    return cover >= fmin(monahan, callaghan) / 2.0 && cover <= 2.0 * fmax(monahan, callaghan);
}

typedef struct Hours
{
    int judged, within, told, calm, calmClear;
} Hours;

static void JudgeHour(const swMeasuredSea* sea, const char* hour, double wind, Hours* hours)
{
    for (int i = 0; i < swMeasuredSea_GetCount(sea); ++i)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, i);
        if (strncmp(record.time, hour, 13) != 0)
        {
            continue;
        }
        double cover = GetCover(&record, 0.0f);
        if (wind >= 5.0 && wind <= 20.0)
        {
            hours->judged += 1;
            hours->within += IsWithinTheLaws(wind, cover);
            hours->told += IsWithinTheLaws(wind, GetCover(&record, (float)wind));
        }
        else if (wind < 3.0)
        {
            hours->calm += 1;
            hours->calmClear += cover < 1e-4;
        }
        return;
    }
}

static void MeasuredSeasHaveTheFoamOfTheirWind(void** state)
{
    (void)state;
    FILE* file = fopen(FOLDER "44013.txt", "r");
    swHost host = swDefaultHost();
    swMeasuredSea* sea = NULL;
    if (file == NULL || swReadMeasuredSea(&host, FOLDER "44013.data_spec", &sea) != SW_SUCCESS)
    {
        printf("the buoy's data are absent: skipped\n");
        skip();
    }
    Hours hours = {0};
    char line[256], hour[16], year[8], month[4], day[4], clock[4], minute[4], direction[8], wind[8];
    while (fgets(line, sizeof(line), file) != NULL)
    {
        if (sscanf(line, "%7s %3s %3s %3s %3s %7s %7s", year, month, day, clock, minute, direction, wind) == 7 &&
            line[0] != '#' && strcmp(wind, "MM") != 0)
        {
            snprintf(hour, sizeof(hour), "%.4s-%.2s-%.2s %.2s", year, month, day, clock);
            JudgeHour(sea, hour, RAISED * atof(wind), &hours);
        }
    }
    fclose(file);
    swDestroyMeasuredSea(sea);
    MarkOptional(true);
    assert_true(hours.judged > 50);
    FindBetween(&(Finding){"V11",
                           "44013.data_spec, hours of 5 to 20 m/s whose foam is within twice the laws, by the waves",
                           "winds measured beside", "%", 0},
                65.0, 100.0, 100.0 * hours.within / hours.judged);
    FindBetween(&(Finding){"V11", "the same, told of the wind", "winds measured beside", "%", 0}, 97.0, 100.0,
                100.0 * hours.told / hours.judged);
    FindBetween(&(Finding){"V11", "the same, hours below 3 m/s without foam", "winds measured beside", "%", 0}, 90.0,
                100.0, hours.calm > 0 ? 100.0 * hours.calmClear / hours.calm : 100.0);
}

int main(void)
{
    BeginTruth("truth_measured_foam");
    const struct CMUnitTest tests[] = {cmocka_unit_test(MeasuredSeasHaveTheFoamOfTheirWind)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
