// SPDX-License-Identifier: MIT
// Tables between their nodes: every bin keeps its energy and its directions, in the spectrum and in the waves that are
// made of it, also where a peak is a single bin, seas oppose each other, or bins are unequal.

#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/host.h"
#include "core/math/random.h"
#include "core/math/scalar.h"
#include "core/spectra/compiled.h"
#include "core/spectra/spreading.h"
#include "core/waves/waves_fft.h"
#include "seaway/measured.h"
#include "seaway/waves.h"
#include "seaway/world.h"
#include "seaway/files.h"

#define TURN (2.0 * SW_PI)
#define DEGREE (SW_PI / 180.0)
#define MAX_FREQUENCIES 64
#define DIRECTIONS 36
#define OTHERS SW_SOURCE_DIR "/../shared/data"

// ---- synthetic tables ----

typedef struct Sample
{
    const char* name;
    int count;
    float frequencies[MAX_FREQUENCIES], widths[MAX_FREQUENCIES];
    float density[MAX_FREQUENCIES][DIRECTIONS];
} Sample;

static void FillWidths(Sample* sample)
{
    for (int i = 0; i < sample->count; ++i)
    {
        int below = i > 0 ? i - 1 : i, above = i + 1 < sample->count ? i + 1 : i;
        sample->widths[i] = (sample->frequencies[above] - sample->frequencies[below]) / (float)(above - below);
    }
}

// Energy of one bin, going to one direction as cos^2s.
static void AddRow(Sample* sample, int row, double energy, double direction, double exponent)
{
    double scale = swGetCosineSpreadScale(exponent);
    for (int j = 0; j < DIRECTIONS; ++j)
    {
        sample->density[row][j] +=
            (float)(energy * swGetCosineSpread(scale, exponent, TURN * j / DIRECTIONS - direction));
    }
}

static void FillEven(Sample* sample, int count, double first, double step)
{
    *sample = (Sample){.count = count};
    for (int i = 0; i < count; ++i)
    {
        sample->frequencies[i] = (float)(first + step * i);
    }
    FillWidths(sample);
}

static void FillSingleBin(Sample* sample, int row)
{
    FillEven(sample, 30, 0.03, 0.01);
    AddRow(sample, row, 20.0, 1.0, 30.0);
    sample->name = row == 0 ? "first bin" : row == 29 ? "last bin" : "single bin";
}

// Neighbours that go elsewhere.
static void FillOpposingBins(Sample* sample)
{
    FillEven(sample, 30, 0.03, 0.01);
    for (int i = 0; i < 30; ++i)
    {
        AddRow(sample, i, i == 6 ? 9.0 : 2.0 / (1.0 + fabs(i - 8.0)), i == 6 ? 0.5 : 0.5 + SW_PI, 20.0);
    }
    sample->name = "opposing bins";
}

static void FillTwoPeaks(Sample* sample)
{
    FillEven(sample, 46, 0.0325, 0.005);
    for (int i = 0; i < 46; ++i)
    {
        double a = (i - 7) / 1.2, b = (i - 16) / 2.5;
        AddRow(sample, i, 8.0 * exp(-0.5 * a * a), -2.0, 50.0);
        AddRow(sample, i, 7.5 * exp(-0.5 * b * b), 0.4, 6.0);
    }
    sample->name = "two peaks";
}

// Frequencies and energies by chance, bins without energy among them.
static void FillJittered(Sample* sample, int seed)
{
    *sample = (Sample){.count = 40};
    double frequency = 0.03;
    for (int i = 0; i < 40; ++i)
    {
        frequency += 0.002 + 0.012 * swHashToUnit(swHashWave(7, seed, i, 0, 0));
        sample->frequencies[i] = (float)frequency;
        double energy = swHashToUnit(swHashWave(7, seed, i, 0, 1)) - 0.3;
        if (energy > 0.0)
        {
            AddRow(sample, i, energy * energy * 10.0, TURN * swHashToUnit(swHashWave(7, seed, i, 0, 2)), 12.0);
        }
    }
    FillWidths(sample);
    sample->name = "jittered bins";
}

#define SAMPLES 12

static void FillSample(int index, Sample* sample)
{
    switch (index)
    {
    case 0:
        FillSingleBin(sample, 0);
        break;
    case 1:
        FillSingleBin(sample, 29);
        break;
    case 2:
        FillSingleBin(sample, 8);
        break;
    case 3:
        FillOpposingBins(sample);
        break;
    case 4:
        FillTwoPeaks(sample);
        break;
    default:
        FillJittered(sample, index);
        break;
    }
}

static swSpectrumTable GetTable(const Sample* sample)
{
    return (swSpectrumTable){.frequencyCount = sample->count,
                             .directionCount = DIRECTIONS,
                             .frequencies = sample->frequencies,
                             .bandwidths = sample->widths,
                             .density = sample->density[0]};
}

static swSpectrumDef MakeDef(const swSpectrumTable* table)
{
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_TABLE;
    def.table = table;
    def.extendTail = false;
    return def;
}

// ---- the spectrum ----

static void EveryCellOfATableKeepsItsEnergy(void** state)
{
    (void)state;
    enum
    {
        PARTS = 24
    };
    swHost host = swDefaultHost();
    double worst = 0.0;
    for (int s = 0; s < SAMPLES; ++s)
    {
        Sample sample;
        FillSample(s, &sample);
        swSpectrumTable table = GetTable(&sample);
        swSpectrumDef def = MakeDef(&table);
        swCompiledSpectrum* spectrum = NULL;
        assert_int_equal(swCompileSpectrum(&host, &def, 9.81, 7.4e-5, &spectrum), SW_SUCCESS);
        double edges[MAX_FREQUENCIES + 1];
        swSpectrumTable_GetEdges(&table, edges);
        double cell = TURN / DIRECTIONS, whole = swIntegrateCompiled(spectrum, 0.0, TURN * 2.0);
        for (int i = 0; i < sample.count * DIRECTIONS; ++i)
        {
            int row = i / DIRECTIONS, column = i % DIRECTIONS;
            double width = edges[row + 1] - edges[row], sum = 0.0;
            for (int j = 0; j < PARTS * PARTS; ++j)
            {
                double f = edges[row] + width * (j / PARTS + 0.5) / PARTS;
                double theta = cell * (column - 0.5 + (j % PARTS + 0.5) / PARTS);
                double density = TURN * swGetCompiledDensity2(spectrum, TURN * f, theta);
                assert_true(density >= 0.0);
                sum += density * width * cell / (PARTS * PARTS);
            }
            double asked = (double)sample.density[row][column] * (double)sample.widths[row] * cell;
            worst = fmax(worst, fabs(sum - asked) / whole);
        }
        swFreeCompiledSpectrum(&host, spectrum);
    }
    print_message("worst error of a cell: %.1e of the variance\n", worst);
    assert_true(worst < 1e-3); // of the sum that stands for the integral
}

static void EveryBinKeepsItsEnergy(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    for (int s = 0; s < SAMPLES; ++s)
    {
        Sample sample;
        FillSample(s, &sample);
        swSpectrumTable table = GetTable(&sample);
        swSpectrumDef def = MakeDef(&table);
        swCompiledSpectrum* spectrum = NULL;
        assert_int_equal(swCompileSpectrum(&host, &def, 9.81, 7.4e-5, &spectrum), SW_SUCCESS);
        double edges[MAX_FREQUENCIES + 1], wanted[SW_MAX_SPECTRUM_BINS];
        swSpectrumTable_GetEdges(&table, edges);
        double whole = swIntegrateCompiled(spectrum, 0.0, TURN * 2.0);
        assert_int_equal(swGetCompiledBins(spectrum, 0.0, TURN * 2.0, wanted), sample.count + 2);
        for (int i = 0; i < sample.count; ++i)
        {
            double asked = 0.0;
            for (int j = 0; j < DIRECTIONS; ++j)
            {
                asked += (double)sample.density[i][j] * (double)sample.widths[i] * TURN / DIRECTIONS;
            }
            double found = swIntegrateCompiled(spectrum, TURN * edges[i], TURN * edges[i + 1]);
            assert_true(fabs(found - asked) < 1e-9 * whole);
            assert_true(fabs(wanted[i + 1] - asked) < 1e-9 * whole);
            // Continuous at the edge.
            double below = swGetCompiledDensity(spectrum, TURN * edges[i] * (1.0 - 1e-9));
            double above = swGetCompiledDensity(spectrum, TURN * edges[i] * (1.0 + 1e-9));
            assert_true(i == 0 || fabs(below - above) < 1e-6 * whole / (edges[i + 1] - edges[i]));
        }
        // Halves of a bin add up to it.
        double halves[2][SW_MAX_SPECTRUM_BINS];
        swGetCompiledBins(spectrum, 0.0, TURN * 0.1234, halves[0]);
        swGetCompiledBins(spectrum, TURN * 0.1234, TURN * 2.0, halves[1]);
        for (int i = 0; i < sample.count + 2; ++i)
        {
            assert_true(fabs(halves[0][i] + halves[1][i] - wanted[i]) < 1e-9 * whole);
        }
        swFreeCompiledSpectrum(&host, spectrum);
    }
}

static void BinsMeetWhereTheirWidthsSay(void** state)
{
    (void)state;
    // Around their frequencies: 0.005 Hz wide up to 0.1 Hz, then 0.01 Hz, as of buoys.
    const float frequencies[4] = {0.0925f, 0.0975f, 0.105f, 0.115f}, widths[4] = {0.005f, 0.005f, 0.01f, 0.01f};
    const double around[5] = {0.09, 0.095, 0.1, 0.11, 0.12};
    const float density[4][4] = {{0}};
    swSpectrumTable table = {4, 4, frequencies, widths, density[0], 0.0f};
    double edges[MAX_FREQUENCIES + 1];
    swSpectrumTable_GetEdges(&table, edges);
    for (int i = 0; i < 5; ++i)
    {
        assert_true(fabs(edges[i] - around[i]) < 1e-8);
    }
    // Half-way to the neighbours, as where a file has none.
    Sample sample;
    FillJittered(&sample, 3);
    table = GetTable(&sample);
    swSpectrumTable_GetEdges(&table, edges);
    for (int i = 1; i < sample.count; ++i)
    {
        double middle = 0.5 * ((double)sample.frequencies[i - 1] + (double)sample.frequencies[i]);
        assert_true(fabs(edges[i] - middle) < 1e-6);
    }
    // Widths that do not fit: every frequency still has its own bin.
    for (int i = 0; i < sample.count; ++i)
    {
        sample.widths[i] = i % 3 == 0 ? 0.0001f : 0.05f;
    }
    swSpectrumTable_GetEdges(&table, edges);
    for (int i = 0; i < sample.count; ++i)
    {
        assert_true(edges[i] < (double)sample.frequencies[i] && (double)sample.frequencies[i] < edges[i + 1]);
    }
}

// ---- the waves ----

// Energy of the waves in each bin, and times cos and sin of their directions.
typedef struct WaveSums
{
    double energy[SW_MAX_SPECTRUM_BINS], x[SW_MAX_SPECTRUM_BINS], z[SW_MAX_SPECTRUM_BINS];
} WaveSums;

static double GetSpline(int q, int resolution)
{
    double x = SW_PI * q / resolution;
    return q == 0 ? 1.0 : pow(sin(x) / x, 4.0);
}

static void AddMode(const swMode* mode, int resolution, const double* edges, int count, WaveSums* sums)
{
    double scale = 0.5 / (GetSpline(mode->qx, resolution) * GetSpline(mode->qz, resolution));
    double ar = 0.5 * ((double)mode->pr + (double)mode->qr) / scale;
    double ai = 0.5 * ((double)mode->qi + (double)mode->pi) / scale;
    double br = 0.5 * ((double)mode->pr - (double)mode->qr) / scale;
    double bi = 0.5 * ((double)mode->qi - (double)mode->pi) / scale;
    double forth = 0.5 * (ar * ar + ai * ai), back = 0.5 * (br * br + bi * bi);
    double turns = ldexp((double)mode->frequencyHigh * 0x1p32 + (double)mode->frequencyLow, -64);
    double frequency = turns * SW_TICKS_PER_SECOND, length = hypot(mode->qx, mode->qz);
    for (int i = 0; i < count; ++i)
    {
        if (frequency >= edges[i] && frequency < edges[i + 1])
        {
            sums->energy[i] += forth + back;
            sums->x[i] += (forth - back) * mode->qx / length;
            sums->z[i] += (forth - back) * mode->qz / length;
        }
    }
}

static WaveSums* SumWaves(const swSpectrumTable* table, const double* edges)
{
    swHost host = swDefaultHost();
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum = MakeDef(table);
    def.minWavelength = (float)(9.81 / (TURN * pow(1.05 * edges[table->frequencyCount], 2.0)));
    def.maxWavelength = 4096.0f;
    swBandModes bands[SW_SET_TILES];
    assert_int_equal(swBuildModes(&host, &def, 9.81f, 7.4e-5f, bands), SW_SUCCESS);
    WaveSums* sums = calloc(1, sizeof(WaveSums));
    assert_non_null(sums);
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        for (int j = 0; j < bands[i].modeCount; ++j)
        {
            AddMode(&bands[i].modes[j], def.resolution, edges, table->frequencyCount, sums);
        }
    }
    swFreeModes(&host, bands);
    return sums;
}

// How far the waves are from the table: of the largest density, and in degrees at the peak.
typedef struct WaveErrors
{
    double density, direction, spread; // spread as r1
} WaveErrors;

static WaveErrors FindErrors(const swSpectrumTable* table)
{
    double edges[SW_MAX_TABLE_FREQUENCIES + 1], most = 0.0;
    swSpectrumTable_GetEdges(table, edges);
    WaveSums* sums = SumWaves(table, edges);
    WaveErrors errors = {0};
    for (int pass = 0; pass < 2; ++pass)
    {
        for (int i = 0; i < table->frequencyCount; ++i)
        {
            double energy = 0.0, x = 0.0, z = 0.0, cell = TURN / table->directionCount;
            double width = edges[i + 1] - edges[i];
            for (int j = 0; j < table->directionCount; ++j)
            {
                double part =
                    (double)table->density[i * table->directionCount + j] * cell * (double)table->bandwidths[i] / width;
                energy += part;
                x += part * cos(j * cell + (double)table->firstDirection);
                z += part * sin(j * cell + (double)table->firstDirection);
            }
            if (pass == 0)
            {
                most = fmax(most, energy);
                continue;
            }
            errors.density = fmax(errors.density, fabs(sums->energy[i] / width - energy) / most);
            if (energy >= 0.95 * most && hypot(x, z) > 0.25 * energy)
            {
                double off = fabs(remainder(atan2(sums->z[i], sums->x[i]) - atan2(z, x), TURN)) / DEGREE;
                double r1 = hypot(sums->x[i], sums->z[i]) / sums->energy[i];
                errors.direction = fmax(errors.direction, off);
                errors.spread = fmax(errors.spread, fabs(r1 - hypot(x, z) / energy));
            }
        }
    }
    free(sums);
    return errors;
}

static void WavesOfABinHaveItsEnergyAndDirection(void** state)
{
    (void)state;
    for (int s = 0; s < SAMPLES; ++s)
    {
        Sample sample;
        FillSample(s, &sample);
        swSpectrumTable table = GetTable(&sample);
        WaveErrors errors = FindErrors(&table);
        print_message("%s: density %.1e of the peak's, direction %.2f degrees, r1 %.1e\n", sample.name, errors.density,
                      errors.direction, errors.spread);
        assert_true(errors.density < 1e-5);
        assert_true(errors.direction < 0.5 && errors.spread < 0.01);
    }
}

static void WavesThatAreTooLongAreToldOf(void** state)
{
    (void)state;
    for (int method = 0; method < 2; ++method)
    {
        for (int lost = 0; lost < 2; ++lost)
        {
            Sample sample;
            FillEven(&sample, 30, 0.005, 0.01);
            AddRow(&sample, 8, 10.0, 1.0, 20.0);
            AddRow(&sample, lost != 0 ? 0 : 12, 1.0, 1.0, 20.0);
            swSpectrumTable table = GetTable(&sample);
            swHost host = swDefaultHost();
            host.log = KeepMessages;
            s_messages[0] = '\0';
            swWaveSystemDef def = swDefaultWaveSystemDef();
            def.spectrum = MakeDef(&table);
            def.method = method == 0 ? SW_WAVES_FFT : SW_WAVES_GERSTNER;
            swWorldDef worldDef = swDefaultWorldDef();
            swWorld* world = NULL;
            swWaveSystemId id;
            assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
            assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
            swDestroyWorld(world);
            assert_true((strstr(s_messages, "9.1 % of a measured sea's variance") != NULL) == (lost != 0));
        }
    }
}

// ---- buoys ----

static void CheckFile(const char* path, WaveErrors* worst)
{
    swHost host = swDefaultHost();
    swMeasuredSea* sea = NULL;
    if (access(path, R_OK) != 0)
    {
        print_message("%s is absent\n", path);
        return;
    }
    swResult result = swReadMeasuredSea(&host, path, &sea);
    if (result == SW_ERROR_UNSUPPORTED)
    {
        print_message("%s is no format of this build\n", path);
        return;
    }
    assert_int_equal(result, SW_SUCCESS);
    int count = swMeasuredSea_GetCount(sea);
    for (int i = 0; i < count; ++i)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, i);
        WaveErrors errors = FindErrors(&record.table);
        worst->density = fmax(worst->density, errors.density);
        worst->direction = fmax(worst->direction, errors.direction);
        worst->spread = fmax(worst->spread, errors.spread);
    }
    print_message("%s, %d records: density %.1e of the peak's, direction at the peak %.2f degrees, r1 %.1e\n",
                  strrchr(path, '/') + 1, count, worst->density, worst->direction, worst->spread);
    swDestroyMeasuredSea(sea);
}

static void EveryRecordOfABuoyKeepsItsPeak(void** state)
{
    (void)state;
    static const char* const paths[] = {SW_SOURCE_DIR "/scenes/data/harbour_storm.data_spec",
                                        OTHERS "/faults/narrow_peak.data_spec",
                                        OTHERS "/spectra/ndbc_44013_2022-05/44013.data_spec",
                                        OTHERS "/spectra/ndbc_41010_2020-06/41010.data_spec",
                                        OTHERS "/spectra/spotter_southern_ocean_2018-02/spotter_20180214.json",
                                        OTHERS "/spectra/ww3_44097_2022-09/ww3station.spec",
                                        OTHERS "/spectra/swan_raglan_2016-10/swanfile.spec",
                                        OTHERS "/spectra/triaxys_2018-01/triaxys.DIRSPEC"};
    for (size_t i = 0; i < sizeof(paths) / sizeof(paths[0]); ++i)
    {
        WaveErrors worst = {0};
        CheckFile(paths[i], &worst);
        assert_true(worst.density < 1e-4);
        assert_true(worst.direction < 3.0 && worst.spread < 0.05);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryCellOfATableKeepsItsEnergy), cmocka_unit_test(EveryBinKeepsItsEnergy),
        cmocka_unit_test(BinsMeetWhereTheirWidthsSay),     cmocka_unit_test(WavesOfABinHaveItsEnergyAndDirection),
        cmocka_unit_test(WavesThatAreTooLongAreToldOf),    cmocka_unit_test(EveryRecordOfABuoyKeepsItsPeak),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
