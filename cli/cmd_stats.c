// SPDX-License-Identifier: MIT
// `seaway stats`: the sea state that a scene's surface has, beside the one that was asked for.

#include <math.h>
#include <string.h>

#include "args.h"
#include "output.h"
#include "sea_calm.h"
#include "sea_measure.h"
#include "spectrum_plot.h"
#include "verbs.h"

// The error is left out where it is not known.
static void PrintLine(const char* name, const char* unit, int digits, double asked, double measured, double error)
{
    char left[32] = "-", middle[32] = "-", right[32] = "";
    if (isfinite(measured))
    {
        snprintf(middle, sizeof(middle), "%.*f", digits, measured);
    }
    if (isfinite(asked))
    {
        snprintf(left, sizeof(left), "%.*f", digits, asked);
    }
    if (isfinite(error))
    {
        snprintf(right, sizeof(right), "+- %.*f", digits, error);
    }
    printf("%-18s %9s  %9s  %-10s %s\n", name, left, middle, right, unit);
}

static double ToDegrees(float radians)
{
    return (double)radians * 180.0 / SW_PI;
}

// Variance by octave of wavelength, as the bands have it, where the bins reach.
static void PrintOctaves(const SeaMeasurement* sea)
{
    double gravity = (double)sea->scene->world.gravity;
    double first = sea->bins.low[0], last = sea->bins.high[sea->bins.count - 1];
    double total = AskVariance(sea, first, last);
    printf("\n%-18s %9s  %9s\n", "share of variance", "asked", "measured");
    for (int octave = 16; octave > -5; --octave)
    {
        double shortest = ldexp(1.0, octave - 1), longest = ldexp(1.0, octave);
        double low = fmax(swGetWaveFrequency(longest, sea->depth, gravity), first);
        double high = fmin(swGetWaveFrequency(shortest, sea->depth, gravity), last);
        double asked = low < high ? AskVariance(sea, low, high) : 0.0;
        if (asked > 1e-4 * total)
        {
            char name[64];
            snprintf(name, sizeof(name), "%.4g to %.4g m", shortest, longest);
            printf("%-18s %8.2f%%  %8.2f%%\n", name, 100.0 * asked / total,
                   100.0 * swEstimateVariance(&sea->bins, &sea->sums, low, high) / total);
        }
    }
}

static void PrintReport(const SeaMeasurement* sea)
{
    const swSeaState *a = &sea->asked, *m = &sea->measured, *e = &sea->error;
    printf("%-18s %9s  %9s\n", "", "asked", "measured");
    PrintLine("Hs", "m", 3, (double)a->significantHeight, (double)m->significantHeight, (double)e->significantHeight);
    PrintLine("Tp", "s", 2, (double)a->peakPeriod, (double)m->peakPeriod, (double)e->peakPeriod);
    PrintLine("Tm01", "s", 2, (double)a->periodTm01, (double)m->periodTm01, (double)e->periodTm01);
    PrintLine("Tm02", "s", 2, (double)a->periodTm02, (double)m->periodTm02, (double)e->periodTm02);
    PrintLine("Te", "s", 2, (double)a->energyPeriod, (double)m->energyPeriod, (double)e->energyPeriod);
    PrintLine("from, mean", "deg", 1, BearingFrom((double)a->meanDirection), BearingFrom((double)m->meanDirection),
              ToDegrees(e->meanDirection));
    PrintLine("from, at the peak", "deg", 1, BearingFrom((double)a->peakDirection),
              BearingFrom((double)m->peakDirection), ToDegrees(e->peakDirection));
    PrintLine("spread", "deg", 1, ToDegrees(a->spread), ToDegrees(m->spread), ToDegrees(e->spread));
    PrintLine("mean square slope", "all waves", 5, (double)a->meanSquareSlope, (double)m->meanSquareSlope, (double)NAN);
    PrintLine("whitecap cover", "of the area", 5, sea->askedWhitecaps, sea->whitecaps, (double)NAN);
    printf("Whitecaps are those of a wind of %.1f m/s, %s.\n", sea->foamWind,
           sea->scene->world.foam.windSpeed > 0.0f ? "which the scene gives them" : "which its waves tell of");
    if (sea->bins.count == 0)
    {
        printf(
            "\nThe sea has no energy: no system of waves has a height and a weight. It is flat, and has no periods.\n");
        return;
    }
    PrintOctaves(sea);
    printf("\nThe surface itself: 4 sigma %.3f m, mean square slope %.5f\n", sea->surfaceHeight, sea->surfaceSlope);
    printf("%.4g to %.4g Hz, %d seeds, Hs %.3f m from seed to seed; %d gauges over %.0f m, %.0f s\n", sea->bins.low[0],
           sea->bins.high[sea->bins.count - 1], sea->options.seeds, sea->heightDeviation, sea->gauges.gaugeCount,
           sea->gauges.area, sea->gauges.duration);
}

// Bins and densities, for those who plot themselves.
static void WriteSpectra(Json* json, const SeaMeasurement* sea)
{
    float numbers[5][SW_MAX_SEA_BINS];
    for (int i = 0; i < sea->bins.count; ++i)
    {
        double width = sea->bins.high[i] - sea->bins.low[i];
        numbers[0][i] = (float)sea->bins.center[i];
        numbers[1][i] = (float)width;
        numbers[2][i] = (float)(AskVariance(sea, sea->bins.low[i], sea->bins.high[i]) / width);
        numbers[3][i] = (float)sea->density[i];
        numbers[4][i] = (float)sea->densityError[i];
    }
    static const char* const keys[5] = {"frequency_hz", "bandwidth_hz", "asked_m2_per_hz", "measured_m2_per_hz",
                                        "standard_error_m2_per_hz"};
    for (int i = 0; i < 5; ++i)
    {
        JsonFloats(json, keys[i], numbers[i], sea->bins.count);
    }
}

static void PrintReportJson(const SeaMeasurement* sea, const char* path)
{
    Json json = OpenJson(stdout);
    JsonOpenObject(&json, NULL);
    JsonText(&json, "scene", path);
    JsonOpenObject(&json, "asked");
    WriteSeaState(&json, &sea->asked);
    JsonNumber(&json, "whitecap_fraction", sea->askedWhitecaps);
    JsonCloseObject(&json);
    JsonOpenObject(&json, "measured");
    WriteSeaState(&json, &sea->measured);
    JsonNumber(&json, "whitecap_fraction", sea->whitecaps);
    JsonCloseObject(&json);
    JsonNumber(&json, "whitecap_wind_mps", sea->foamWind);
    JsonOpenObject(&json, "standard_error");
    JsonNumber(&json, "hs_m", (double)sea->error.significantHeight);
    JsonNumber(&json, "tp_s", (double)sea->error.peakPeriod);
    JsonNumber(&json, "tm01_s", (double)sea->error.periodTm01);
    JsonNumber(&json, "tm02_s", (double)sea->error.periodTm02);
    JsonNumber(&json, "te_s", (double)sea->error.energyPeriod);
    JsonNumber(&json, "mean_direction_from_deg", ToDegrees(sea->error.meanDirection));
    JsonNumber(&json, "peak_direction_from_deg", ToDegrees(sea->error.peakDirection));
    JsonNumber(&json, "spread_deg", ToDegrees(sea->error.spread));
    JsonCloseObject(&json);
    JsonOpenObject(&json, "surface");
    JsonNumber(&json, "hs_m", sea->surfaceHeight);
    JsonNumber(&json, "mean_square_slope", sea->surfaceSlope);
    JsonCloseObject(&json);
    WriteSpectra(&json, sea);
    int binCount = sea->bins.count;
    JsonNumber(&json, "min_frequency_hz", binCount > 0 ? sea->bins.low[0] : (double)NAN);
    JsonNumber(&json, "max_frequency_hz", binCount > 0 ? sea->bins.high[binCount - 1] : (double)NAN);
    JsonInteger(&json, "seed_count", sea->options.seeds);
    JsonNumber(&json, "hs_deviation_m", sea->heightDeviation);
    JsonInteger(&json, "gauge_count", sea->gauges.gaugeCount);
    JsonNumber(&json, "area_m", binCount > 0 ? sea->gauges.area : (double)NAN);
    JsonNumber(&json, "duration_s", binCount > 0 ? sea->gauges.duration : (double)NAN);
    JsonCloseObject(&json);
}

static int MeasureScene(MeasureOptions options, const char* path, const char* plotPath, bool asJson)
{
    if (plotPath != NULL && !ProbeOutput(plotPath))
    {
        return EXIT_PROBLEM;
    }
    swHost host = MakeHost();
    swScene* scene = NULL;
    swResult result = swReadScene(&host, path, &scene);
    if (result != SW_SUCCESS)
    {
        ComplainAboutResult(result, path);
        return EXIT_PROBLEM;
    }
    options.withDirections = plotPath != NULL;
    bool hasWaves = HasWaves(scene);
    SeaMeasurement* sea = hasWaves ? MeasureSea(scene, &options) : MeasureCalm(scene, &options);
    bool isFine = sea != NULL;
    if (isFine && asJson)
    {
        PrintReportJson(sea, path);
    }
    else if (isFine)
    {
        PrintReport(sea);
    }
    isFine = FinishOutput() && isFine;
    if (isFine && plotPath != NULL && !hasWaves)
    {
        Complain("%s has no waves to plot", path);
        isFine = false;
    }
    else if (isFine && plotPath != NULL)
    {
        isFine = PlotSea(plotPath, scene->name[0] != 0 ? scene->name : path, NULL, sea);
    }
    DestroyMeasurement(sea);
    swDestroyScene(scene);
    return isFine ? EXIT_FINE : EXIT_PROBLEM;
}

int RunStats(int argumentCount, char** arguments)
{
    const char* path = NULL;
    const char* plotPath = NULL;
    bool asJson = false;
    MeasureOptions stats = {.seeds = 4};
    static const char* const plotEndings[] = {".svg", NULL};
    const Option options[] = {
        {.name = "area",
         .kind = OPTION_NUMBER,
         .value = &stats.area,
         .placeholder = "L",
         .help = "side of the square with gauges, m (default: 40 wavelengths of the peak)",
         .min = 1,
         .max = 1e6},
        {.name = "seeds",
         .kind = OPTION_INT,
         .value = &stats.seeds,
         .placeholder = "N",
         .help = "seas of the same statistics to average (default 4)",
         .min = 1,
         .max = MEASURE_MAX_SEEDS},
        {.name = "duration",
         .kind = OPTION_NUMBER,
         .value = &stats.duration,
         .placeholder = "S",
         .help = "of a record, s (default: 40 periods of the peak; more for narrow bins of a measured sea)",
         .min = 10,
         .max = 1e5},
        {.name = "plot",
         .kind = OPTION_OUTPUT,
         .value = &plotPath,
         .placeholder = "FILE.svg",
         .choices = plotEndings,
         .help = "draw the asked and the measured spectrum, by frequency and by direction"},
        {.name = "json", .kind = OPTION_FLAG, .value = &asJson, .help = "print JSON"},
    };
    const Verb verb = {
        .name = "stats",
        .synopsis = "SCENE [--area L] [--seeds N] [--duration S] [--plot FILE.svg] [--json]",
        .text =
            "Measure the sea of a scene as moored buoys would, beside what its spectra ask for: significant height,\n"
            "periods, direction, spread, slope and whitecaps, each with its standard error. A measured sea is measured "
            "in\n"
            "its own frequency bins.",
        .options = options,
        .optionCount = sizeof(options) / sizeof(options[0]),
        .positionalMin = 1,
        .positionalMax = 1,
        .positionalName = "a scene file",
        .positionals = &path};
    ParseResult parsed = ParseArguments(&verb, argumentCount, arguments);
    if (parsed != PARSE_FINE)
    {
        return GetParseExit(parsed);
    }
    return MeasureScene(stats, path, plotPath, asJson);
}
