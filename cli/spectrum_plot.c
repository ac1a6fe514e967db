// SPDX-License-Identifier: MIT
// Above, energy by frequency: the asked as an area, the measured as a line in a band of twice its standard error;
// vertical lines are the edges of the octaves of wavelength that the waves are made in. Below, density over frequency
// (radius) and bearing (north up), asked and measured on one scale, coloured by its square root so that weaker systems
// show beside the peak. Both charts end where all but one percent of the energy is in.

#include "spectrum_plot.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "output.h"
#include "svg.h"
#include "common.h"

#define WIDTH 800
#define HEIGHT 872
#define DEGREE (SW_PI / 180.0)

#define SECTORS 72
#define MOST_RINGS 48
#define LEVELS 40

typedef struct Rings
{
    int count;
    double low[MOST_RINGS], high[MOST_RINGS];
    double asked[MOST_RINGS][SECTORS], measured[MOST_RINGS][SECTORS]; // m^2/Hz/rad
    double most;                                                      // of both
} Rings;

typedef struct Polar
{
    double x, y;  // centre, pixels
    SvgAxis axis; // frequency to radius
} Polar;

// Asked over a bin, m^2/Hz.
static double AskBin(const SeaMeasurement* sea, int bin)
{
    double low = sea->bins.low[bin], high = sea->bins.high[bin], sum = 0.0;
    const int parts = 4;
    for (int i = 0; i < parts; ++i)
    {
        sum += AskDensity(sea, low + (high - low) * (i + 0.5) / parts) / parts;
    }
    return sum;
}

static double FindLastFrequency(const SeaMeasurement* sea)
{
    const swSeaBins* bins = &sea->bins;
    double total = swEstimateVariance(bins, &sea->sums, bins->low[0], bins->high[bins->count - 1]);
    int last = 0;
    while (last < bins->count - 1 &&
           swEstimateVariance(bins, &sea->sums, bins->low[0], bins->high[last]) < 0.99 * total)
    {
        last += 1;
    }
    return fmin(bins->high[bins->count - 1], 1.15 * bins->high[last]);
}

static void WriteNumbers(FILE* file, double y, const char* color, const swSeaState* state, const swSeaState* error)
{
    const double columns[5] = {298, 410, 522, 628, 728};
    const double numbers[5] = {(double)state->significantHeight, (double)state->peakPeriod, (double)state->periodTm02,
                               BearingFrom((double)state->meanDirection), (double)state->spread / DEGREE};
    const double errors[5] = {error != NULL ? (double)error->significantHeight : (double)NAN,
                              error != NULL ? (double)error->peakPeriod : (double)NAN,
                              error != NULL ? (double)error->periodTm02 : (double)NAN,
                              error != NULL ? (double)error->meanDirection / DEGREE : (double)NAN,
                              error != NULL ? (double)error->spread / DEGREE : (double)NAN};
    static const char* const units[5] = {" m", " s", " s", "\xc2\xb0", "\xc2\xb0"};
    for (int i = 0; i < 5; ++i)
    {
        char text[64], style[64];
        int digits = i < 3 ? 2 : 1, length = snprintf(text, sizeof(text), "%.*f", digits, numbers[i]);
        if (isfinite(errors[i]))
        {
            length += snprintf(text + length, sizeof(text) - (size_t)length, " \xc2\xb1 %.*f", digits, errors[i]);
        }
        snprintf(text + length, sizeof(text) - (size_t)length, "%s", units[i]);
        snprintf(style, sizeof(style), "text-anchor=\"middle\" fill=\"%s\"", color);
        WriteText(file, columns[i], y, style, text);
    }
}

static void WriteHead(FILE* file, const char* title, const SeaMeasurement* sea)
{
    static const char* const names[5] = {"Hs", "Tp", "Tm02", "from", "spread"};
    const double columns[5] = {298, 410, 522, 628, 728};
    WriteText(file, 24, 36, "font-size=\"19\" font-weight=\"bold\"", title);
    for (int i = 0; i < 5; ++i)
    {
        WriteText(file, columns[i], 64, "text-anchor=\"middle\" font-size=\"12\" fill=\"" SVG_PALE_INK "\"", names[i]);
    }
    fputs("<rect x=\"24\" y=\"73\" width=\"26\" height=\"11\" fill=\"" SVG_BLUE "\" fill-opacity=\"0.2\"/>"
          "<path d=\"M24 73h26\" stroke=\"" SVG_BLUE "\" stroke-width=\"2\"/>\n"
          "<rect x=\"24\" y=\"92\" width=\"26\" height=\"11\" fill=\"" SVG_ORANGE "\" fill-opacity=\"0.25\"/>"
          "<path d=\"M24 97.5h26\" stroke=\"" SVG_ORANGE "\" stroke-width=\"2\"/>\n",
          file);
    WriteText(file, 58, 84, "", "asked");
    WriteText(file, 58, 103, "", "measured on the surface");
    WriteNumbers(file, 84, SVG_INK, &sea->asked, NULL);
    WriteNumbers(file, 103, SVG_INK, &sea->measured, &sea->error);
}

static void WriteAxes(FILE* file, const SvgAxis* x, const SvgAxis* y)
{
    double ticks[32];
    char label[32];
    int count = FindTicks(y, 6, ticks);
    for (int i = 0; i < count; ++i)
    {
        double at = GetPlace(y, ticks[i]);
        fprintf(file, "<path d=\"M%.1f %.1fH%.1f\" stroke=\"" SVG_GRID "\"/>\n", x->begin, at, x->end);
        snprintf(label, sizeof(label), "%.4g", ticks[i]);
        WriteText(file, x->begin - 8, at + 4.5, "text-anchor=\"end\"", label);
    }
    count = FindTicks(x, 8, ticks);
    for (int i = 0; i < count; ++i)
    {
        double at = GetPlace(x, ticks[i]);
        fprintf(file, "<path d=\"M%.1f %.1fv5\" stroke=\"" SVG_PALE_INK "\"/>\n", at, y->begin);
        snprintf(label, sizeof(label), "%.4g", ticks[i]);
        WriteText(file, at, y->begin + 20, "text-anchor=\"middle\"", label);
    }
    fprintf(file, "<path d=\"M%.1f %.1fH%.1f\" stroke=\"" SVG_PALE_INK "\"/>\n", x->begin, y->begin, x->end);
    WriteText(file, 0.5 * (x->begin + x->end), y->begin + 40, "text-anchor=\"middle\"", "frequency, Hz");
    WriteText(file, 24, y->end - 26, "", "energy density, m\xc2\xb2/Hz");
}

// The edges of octaves, with the wavelength where there is room.
static void WriteOctaves(FILE* file, const SeaMeasurement* sea, const SvgAxis* x, const SvgAxis* y)
{
    double before = x->begin;
    for (int octave = 12; octave > -5; --octave)
    {
        double length = ldexp(1.0, octave);
        double frequency = swGetWaveFrequency(length, sea->depth, (double)sea->scene->world.gravity);
        if (frequency <= x->low || frequency >= x->high)
        {
            continue;
        }
        double at = GetPlace(x, frequency);
        fprintf(file,
                "<path d=\"M%.1f %.1fV%.1f\" stroke=\"" SVG_PALE_INK "\" stroke-opacity=\"0.45\" "
                "stroke-dasharray=\"1 3\"/>\n",
                at, y->begin, y->end);
        char label[32];
        snprintf(label, sizeof(label), "%.4g m", length);
        if (at - before > 46.0 && x->end - at > 24.0)
        {
            WriteText(file, at, y->end - 4, "text-anchor=\"middle\" font-size=\"11\" fill=\"" SVG_PALE_INK "\"", label);
            before = at;
        }
    }
}

static double Clamp(const SvgAxis* axis, double value)
{
    return fmin(fmax(value, axis->low), axis->high);
}

// A line through the bins' centres up to the axis's end, as path data; backwards to close a band.
static void WriteLine(FILE* file, const SeaMeasurement* sea, const double* values, const SvgAxis* x, const SvgAxis* y,
                      bool isBackwards, char command)
{
    int count = 0;
    while (count < sea->bins.count && sea->bins.center[count] <= x->high)
    {
        count += 1;
    }
    for (int i = 0; i < count; ++i)
    {
        int bin = isBackwards ? count - 1 - i : i;
        fprintf(file, "%c%.1f %.1f", command, GetPlace(x, Clamp(x, sea->bins.center[bin])),
                GetPlace(y, Clamp(y, values[bin])));
        command = 'L';
    }
}

static void WriteCurves(FILE* file, const SeaMeasurement* sea, const double* asked, const SvgAxis* x, const SvgAxis* y)
{
    double low[SW_MAX_SEA_BINS], high[SW_MAX_SEA_BINS], ground[SW_MAX_SEA_BINS];
    for (int i = 0; i < sea->bins.count; ++i)
    {
        double error = isfinite(sea->densityError[i]) ? 2.0 * sea->densityError[i] : 0.0;
        low[i] = sea->density[i] - error;
        high[i] = sea->density[i] + error;
        ground[i] = y->low;
    }
    fputs("<path fill=\"" SVG_BLUE "\" fill-opacity=\"0.2\" d=\"", file);
    WriteLine(file, sea, asked, x, y, false, 'M');
    WriteLine(file, sea, ground, x, y, true, 'L');
    fputs("Z\"/>\n<path fill=\"none\" stroke=\"" SVG_BLUE "\" stroke-width=\"2.6\" d=\"", file);
    WriteLine(file, sea, asked, x, y, false, 'M');
    fputs("\"/>\n<path fill=\"" SVG_ORANGE "\" fill-opacity=\"0.25\" d=\"", file);
    WriteLine(file, sea, high, x, y, false, 'M');
    WriteLine(file, sea, low, x, y, true, 'L');
    fputs("Z\"/>\n<path fill=\"none\" stroke=\"" SVG_ORANGE "\" stroke-width=\"1.4\" stroke-linejoin=\"round\" d=\"",
          file);
    WriteLine(file, sea, sea->density, x, y, false, 'M');
    fputs("\"/>\n", file);
}

// Logarithmic where the energy reaches over more than a factor of six in frequency above its peak.
static SvgAxis FindFrequencyAxis(const SeaMeasurement* sea)
{
    double last = FindLastFrequency(sea);
    bool isWide = last > 6.0 * sea->bins.center[swFindPeakBin(&sea->bins, &sea->sums)];
    return (SvgAxis){.low = isWide ? sea->bins.low[0] : 0.0, .high = last, .isLogarithmic = isWide};
}

static void WriteEnergy(FILE* file, const SeaMeasurement* sea, SvgAxis x)
{
    double asked[SW_MAX_SEA_BINS], most = 0.0;
    for (int i = 0; i < sea->bins.count; ++i)
    {
        asked[i] = AskBin(sea, i);
        most = fmax(most, fmax(asked[i], sea->density[i]));
    }
    bool isWide = x.isLogarithmic;
    x.begin = 72;
    x.end = 776;
    SvgAxis y = {.low = isWide ? 1e-4 * most : 0.0,
                 .high = (isWide ? 1.5 : 1.08) * most,
                 .begin = 400,
                 .end = 170,
                 .isLogarithmic = isWide};
    WriteAxes(file, &x, &y);
    WriteOctaves(file, sea, &x, &y);
    WriteCurves(file, sea, asked, &x, &y);
}

// Both densities over a ring's sectors: the asked at its middle, the measured as means.
static void FillRing(const SeaMeasurement* sea, Rings* rings, int ring)
{
    const int parts = 3;
    double gravity = (double)sea->scene->world.gravity, low = rings->low[ring], high = rings->high[ring];
    AskDirections(sea, 0.5 * (low + high), SECTORS, rings->asked[ring]);
    for (int i = 0; i < SECTORS * parts * parts; ++i)
    {
        int sector = i / (parts * parts);
        double theta = 2.0 * SW_PI * (sector + (i % parts + 0.5) / parts - 0.5) / SECTORS;
        double f = low + (high - low) * (i / parts % parts + 0.5) / parts;
        rings->measured[ring][sector] +=
            swEstimatePatchDensity(sea->patches, f, theta, sea->depth, gravity) / (parts * parts);
    }
    for (int i = 0; i < SECTORS; ++i)
    {
        rings->most = fmax(rings->most, fmax(rings->asked[ring][i], rings->measured[ring][i]));
    }
}

// A ring is one bin, or a few where they are many.
static void FillRings(const SeaMeasurement* sea, double last, Rings* rings)
{
    int shown = 0;
    while (shown < sea->bins.count && sea->bins.center[shown] <= last)
    {
        shown += 1;
    }
    int each = (shown + MOST_RINGS - 1) / MOST_RINGS;
    for (int i = 0; i < shown; i += each)
    {
        int end = i + each < shown ? i + each : shown;
        rings->low[rings->count] = sea->bins.low[i];
        rings->high[rings->count] = sea->bins.high[end - 1];
        FillRing(sea, rings, rings->count);
        rings->count += 1;
    }
}

static void WritePoint(FILE* file, const Polar* polar, char command, double frequency, double bearing)
{
    double radius = GetPlace(&polar->axis, fmin(fmax(frequency, polar->axis.low), polar->axis.high));
    fprintf(file, "%c%.1f %.1f", command, polar->x + radius * sin(bearing), polar->y - radius * cos(bearing));
}

static int GetLevel(double share)
{
    int level = (int)(sqrt(fmax(share, 0.0)) * LEVELS);
    return level < LEVELS ? level : LEVELS - 1;
}

// All cells of one colour are one path. The palest are left white.
static void WriteCells(FILE* file, const Polar* polar, const Rings* rings, const double (*values)[SECTORS])
{
    const double width = 2.0 * SW_PI / SECTORS, half = 0.51 * width; // no gap between neighbours
    for (int level = 2; level < LEVELS; ++level)
    {
        bool isEmpty = true;
        for (int i = 0; i < rings->count * SECTORS; ++i)
        {
            int ring = i / SECTORS, sector = i % SECTORS;
            if (GetLevel(values[ring][sector] / rings->most) != level)
            {
                continue;
            }
            if (isEmpty)
            {
                fputs("<path fill=\"", file);
                WriteLevelColor(file, level, LEVELS);
                fputs("\" d=\"", file);
                isEmpty = false;
            }
            double bearing = BearingFrom(width * sector) * DEGREE;
            WritePoint(file, polar, 'M', rings->low[ring], bearing - half);
            WritePoint(file, polar, 'L', rings->high[ring], bearing - half);
            WritePoint(file, polar, 'L', rings->high[ring], bearing + half);
            WritePoint(file, polar, 'L', rings->low[ring], bearing + half);
            fputc('Z', file);
        }
        fputs(isEmpty ? "" : "\"/>\n", file);
    }
}

static void WriteCompass(FILE* file, const Polar* polar)
{
    static const char* const points[8] = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
    double ticks[16];
    int count = FindTicks(&polar->axis, polar->axis.isLogarithmic ? 6 : 4, ticks);
    for (int i = 0; i < count; ++i)
    {
        double radius = GetPlace(&polar->axis, ticks[i]);
        if (radius < 20.0 || radius > 0.97 * polar->axis.end)
        {
            continue; // no room in the middle; the rim is a ring already
        }
        fprintf(file,
                "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"none\" stroke=\"" SVG_INK "\" "
                "stroke-opacity=\"0.3\" stroke-dasharray=\"2 3\"/>\n",
                polar->x, polar->y, radius);
        char label[32];
        snprintf(label, sizeof(label), "%.3g Hz", ticks[i]);
        if (radius < 0.93 * polar->axis.end)
        {
            WriteText(
                file, polar->x + 0.5 * radius, polar->y + 0.866 * radius + 4.0,
                "text-anchor=\"middle\" font-size=\"11\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"",
                label);
        }
    }
    fprintf(file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"none\" stroke=\"" SVG_PALE_INK "\"/>\n", polar->x,
            polar->y, polar->axis.end);
    for (int i = 0; i < 8; ++i)
    {
        double angle = i * SW_PI / 4.0, at = polar->axis.end + 13.0;
        WriteText(file, polar->x + at * sin(angle), polar->y - at * cos(angle) + 4.5,
                  i % 2 == 0 ? "text-anchor=\"middle\" font-weight=\"bold\""
                             : "text-anchor=\"middle\" font-size=\"11\" fill=\"" SVG_PALE_INK "\"",
                  points[i]);
    }
}

static void WriteScale(FILE* file, const Rings* rings)
{
    const double left = 722, top = 536, height = 240;
    for (int i = 0; i < LEVELS; ++i)
    {
        fprintf(file, "<rect x=\"%.1f\" y=\"%.1f\" width=\"14\" height=\"%.1f\" fill=\"", left,
                top + height * (LEVELS - 1 - i) / LEVELS, height / LEVELS + 0.4);
        WriteLevelColor(file, i, LEVELS);
        fputs("\"/>\n", file);
    }
    for (int i = 0; i <= 4; ++i)
    {
        double t = i / 4.0;
        char label[32];
        snprintf(label, sizeof(label), "%.2g", rings->most * t * t * DEGREE);
        WriteText(file, left + 20, top + height * (1.0 - t) + 4.5, "font-size=\"12\"", label);
    }
    WriteText(file, 776, top - 34, "text-anchor=\"end\" font-size=\"12\"", "density,");
    WriteText(file, 776, top - 18, "text-anchor=\"end\" font-size=\"12\"", "m\xc2\xb2/Hz/\xc2\xb0");
}

static bool WriteDirections(FILE* file, const SeaMeasurement* sea, SvgAxis axis, const char* note)
{
    Rings* rings = calloc(1, sizeof(Rings));
    if (rings == NULL)
    {
        return false;
    }
    FillRings(sea, axis.high, rings);
    axis.begin = 0;
    axis.end = 144;
    Polar polar = {.x = 190, .y = 656, .axis = axis};
    WriteText(file, polar.x, 480, "text-anchor=\"middle\" font-weight=\"bold\" fill=\"" SVG_BLUE "\"", "asked");
    WriteCells(file, &polar, rings, (const double(*)[SECTORS])rings->asked);
    WriteCompass(file, &polar);
    polar.x = 526;
    WriteText(file, polar.x, 480, "text-anchor=\"middle\" font-weight=\"bold\" fill=\"" SVG_ORANGE "\"", "measured");
    WriteCells(file, &polar, rings, (const double(*)[SECTORS])rings->measured);
    WriteCompass(file, &polar);
    WriteScale(file, rings);
    char text[256];
    snprintf(text, sizeof(text), "where waves come from%s%s", note != NULL ? "; " : "", note != NULL ? note : "");
    WriteText(file, 358, 846, "text-anchor=\"middle\"", text);
    free(rings);
    return true;
}

bool PlotSea(const char* path, const char* title, const char* note, const SeaMeasurement* sea)
{
    OutputFile output;
    if (!BeginOutput(&output, path))
    {
        return false;
    }
    FILE* file = fopen(output.path, "w");
    bool isWritten = file != NULL;
    if (isWritten)
    {
        SvgAxis axis = FindFrequencyAxis(sea);
        BeginSvg(file, WIDTH, HEIGHT);
        WriteHead(file, title, sea);
        WriteEnergy(file, sea, axis);
        isWritten = WriteDirections(file, sea, axis, note);
        EndSvg(file);
        isWritten = !ferror(file) && isWritten;
        isWritten = fclose(file) == 0 && isWritten;
    }
    if (!isWritten)
    {
        Complain("cannot write %s: %s", path, strerror(errno));
    }
    return EndOutput(&output, isWritten);
}
