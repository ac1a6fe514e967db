// SPDX-License-Identifier: MIT
// The left chart holds the energy of each frequency bin, the right one the density over frequency (radius) and the
// bearing that waves come from (north up), coloured by its square root so that weaker systems show beside the peak.

#include "spectrum_plot.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "output.h"
#include "verbs.h"

#define WIDTH 1040
#define HEIGHT 500
#define DEGREE (SW_PI / 180.0)

typedef struct Chart
{
    double left, top, width, height;
    double maxX, maxY;
} Chart;

typedef struct Polar
{
    double x, y, radius; // centre and outer radius, pixels
    double maxFrequency; // at the outer radius, Hz
    double maxDensity;
} Polar;

// 1, 2 or 5 times a power of ten, so that about `count` steps make `range`.
static double FindTick(double range, int count)
{
    double raw = range / count;
    double power = pow(10.0, floor(log10(raw)));
    double lead = raw / power;
    return power * (lead <= 1.0 ? 1.0 : lead <= 2.0 ? 2.0 : lead <= 5.0 ? 5.0 : 10.0);
}

// The frequency below which all but two percent of the energy lie, with a margin: where both charts end.
static double FindLastFrequency(const swMeasuredRecord* record)
{
    const swSpectrumTable* table = &record->table;
    double total = 0.0, sum = 0.0;
    for (int i = 0; i < table->frequencyCount; ++i)
    {
        total += (double)record->energy[i] * (double)table->bandwidths[i];
    }
    int last = table->frequencyCount - 1;
    for (int i = 0; i < table->frequencyCount; ++i)
    {
        sum += (double)record->energy[i] * (double)table->bandwidths[i];
        if (sum > 0.98 * total)
        {
            last = i;
            break;
        }
    }
    double end = (double)table->frequencies[table->frequencyCount - 1];
    return fmin(end, 1.25 * (double)table->frequencies[last]);
}

// Dark where there is most, along one line through lightness. `t` in [0, 1].
static void WriteColor(FILE* file, double t)
{
    static const double stops[6][3] = {{240, 246, 248}, {183, 216, 226}, {108, 173, 199},
                                       {47, 118, 163},  {20, 67, 112},   {8, 28, 58}};
    double at = fmin(fmax(t, 0.0), 1.0) * 5.0;
    int i = at < 5.0 ? (int)at : 4;
    double part = at - i;
    fprintf(file, "#%02x%02x%02x", (unsigned)lround(stops[i][0] + (stops[i + 1][0] - stops[i][0]) * part),
            (unsigned)lround(stops[i][1] + (stops[i + 1][1] - stops[i][1]) * part),
            (unsigned)lround(stops[i][2] + (stops[i + 1][2] - stops[i][2]) * part));
}

static void WriteText(FILE* file, double x, double y, const char* style, const char* text)
{
    fprintf(file, "<text x=\"%.1f\" y=\"%.1f\" %s>", x, y, style);
    for (const char* c = text; *c != 0; ++c)
    {
        switch (*c)
        {
        case '<':
            fputs("&lt;", file);
            break;
        case '>':
            fputs("&gt;", file);
            break;
        case '&':
            fputs("&amp;", file);
            break;
        default:
            fputc(*c, file);
        }
    }
    fputs("</text>\n", file);
}

static void WriteHead(FILE* file, const char* source, const swMeasuredRecord* record, const swSeaState* state)
{
    const char* slash = strrchr(source, '/');
    char line[256];
    fprintf(file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
            "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\" fill=\"#24303a\">\n"
            "<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>\n",
            WIDTH, HEIGHT, WIDTH, HEIGHT, WIDTH, HEIGHT);
    snprintf(line, sizeof(line), "%s, %s UTC", slash != NULL ? slash + 1 : source, record->time);
    WriteText(file, 70, 34, "font-size=\"18\" font-weight=\"bold\"", line);
    snprintf(line, sizeof(line), "Hs %.2f m    Tp %.1f s    Tm02 %.1f s    from %.0f\xc2\xb0    spread %.0f\xc2\xb0",
             (double)state->significantHeight, (double)state->peakPeriod, (double)state->periodTm02,
             BearingFrom((double)state->meanDirection), (double)state->spread / DEGREE);
    WriteText(file, 70, 56, "fill=\"#5a6874\" xml:space=\"preserve\"", line);
}

static double ChartX(const Chart* chart, double frequency)
{
    return chart->left + chart->width * frequency / chart->maxX;
}

static double ChartY(const Chart* chart, double energy)
{
    return chart->top + chart->height * (1.0 - energy / chart->maxY);
}

static void WriteAxes(FILE* file, const Chart* chart)
{
    char label[32];
    double stepX = FindTick(chart->maxX, 6), stepY = FindTick(chart->maxY, 5);
    for (double y = 0.0; y <= chart->maxY * 1.0001; y += stepY)
    {
        double at = ChartY(chart, y);
        fprintf(file, "<path d=\"M%.1f %.1fH%.1f\" stroke=\"%s\"/>\n", chart->left, at, chart->left + chart->width,
                y == 0.0 ? "#5a6874" : "#e3e8ec");
        snprintf(label, sizeof(label), "%.4g", y);
        WriteText(file, chart->left - 8, at + 4, "text-anchor=\"end\"", label);
    }
    for (double x = 0.0; x <= chart->maxX * 1.0001; x += stepX)
    {
        double at = ChartX(chart, x), bottom = chart->top + chart->height;
        fprintf(file, "<path d=\"M%.1f %.1fv5\" stroke=\"#5a6874\"/>\n", at, bottom);
        snprintf(label, sizeof(label), "%.4g", x);
        WriteText(file, at, bottom + 19, "text-anchor=\"middle\"", label);
    }
    WriteText(file, chart->left + chart->width / 2.0, chart->top + chart->height + 40, "text-anchor=\"middle\"",
              "frequency, Hz");
    WriteText(file, chart->left, chart->top - 12, "", "energy density, m\xc2\xb2/Hz");
}

static void WriteEnergy(FILE* file, const swMeasuredRecord* record, const swSeaState* state, double lastFrequency)
{
    const swSpectrumTable* table = &record->table;
    Chart chart = {70, 104, 420, 320, lastFrequency, 0.0};
    for (int i = 0; i < table->frequencyCount; ++i)
    {
        chart.maxY = fmax(chart.maxY, (double)record->energy[i] * 1.08);
    }
    WriteAxes(file, &chart);
    char path[2][24] = {"#2f76a3", "none"};
    for (int pass = 0; pass < 2; ++pass) // the area, then its outline
    {
        double x = ChartX(&chart, (double)table->frequencies[0]);
        fprintf(file, "<path fill=\"%s\" %s d=\"M%.1f %.1f", path[pass],
                pass == 0 ? "fill-opacity=\"0.22\" stroke=\"none\"" : "stroke=\"#14436f\" stroke-width=\"1.8\"", x,
                pass == 0 ? ChartY(&chart, 0.0) : ChartY(&chart, (double)record->energy[0]));
        for (int i = 0; i < table->frequencyCount && (double)table->frequencies[i] <= lastFrequency; ++i)
        {
            x = ChartX(&chart, (double)table->frequencies[i]);
            fprintf(file, "L%.1f %.1f", x, ChartY(&chart, (double)record->energy[i]));
        }
        fprintf(file, pass == 0 ? "L%.1f %.1fZ\"/>\n" : "\" />\n", x, ChartY(&chart, 0.0));
    }
    double peak = ChartX(&chart, 1.0 / (double)state->peakPeriod);
    char label[32];
    snprintf(label, sizeof(label), "Tp %.1f s", (double)state->peakPeriod);
    fprintf(file, "<path d=\"M%.1f %.1fV%.1f\" stroke=\"#c2571a\" stroke-dasharray=\"4 3\"/>\n", peak, chart.top,
            chart.top + chart.height);
    WriteText(file, peak + 6, chart.top + 12, "fill=\"#c2571a\"", label);
}

// A point of the polar chart: waves that come from `bearing` (radians clockwise from north, which is up).
static void WritePoint(FILE* file, const Polar* polar, char command, double frequency, double bearing)
{
    double radius = polar->radius * frequency / polar->maxFrequency;
    fprintf(file, "%c%.1f %.1f", command, polar->x + radius * sin(bearing), polar->y - radius * cos(bearing));
}

static void WriteCells(FILE* file, const swMeasuredRecord* record, const Polar* polar)
{
    const swSpectrumTable* table = &record->table;
    double width = 2.0 * SW_PI / table->directionCount;
    for (int i = 0; i < table->frequencyCount; ++i)
    {
        double low = (double)table->frequencies[i] - 0.5 * (double)table->bandwidths[i];
        double high = fmin((double)table->frequencies[i] + 0.5 * (double)table->bandwidths[i], polar->maxFrequency);
        for (int j = 0; j < table->directionCount && low < polar->maxFrequency; ++j)
        {
            double share = (double)table->density[i * table->directionCount + j] / polar->maxDensity;
            if (share < 0.002)
            {
                continue;
            }
            double bearing = BearingFrom(width * j) * DEGREE;
            fputs("<path d=\"", file);
            WritePoint(file, polar, 'M', low, bearing - 0.52 * width); // 0.52: no gap between neighbours
            WritePoint(file, polar, 'L', high, bearing - 0.52 * width);
            WritePoint(file, polar, 'L', high, bearing + 0.52 * width);
            WritePoint(file, polar, 'L', low, bearing + 0.52 * width);
            fputs("Z\" fill=\"", file);
            WriteColor(file, sqrt(share));
            fputs("\"/>\n", file);
        }
    }
}

static void WriteCompass(FILE* file, const Polar* polar)
{
    static const char* const points[8] = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
    double step = FindTick(polar->maxFrequency, 4);
    for (double f = step; f < polar->maxFrequency * 0.999; f += step)
    {
        double radius = polar->radius * f / polar->maxFrequency;
        char label[32];
        fprintf(file,
                "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"none\" stroke=\"#24303a\" "
                "stroke-opacity=\"0.25\" stroke-dasharray=\"2 3\"/>\n",
                polar->x, polar->y, radius);
        snprintf(label, sizeof(label), "%.3g Hz", f);
        WriteText(file, polar->x + 3 + radius * 0.707, polar->y - radius * 0.707 - 3,
                  "font-size=\"10\" fill=\"#3c4a55\" stroke=\"#ffffff\" stroke-width=\"2.5\" paint-order=\"stroke\"",
                  label);
    }
    fprintf(file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"none\" stroke=\"#5a6874\"/>\n", polar->x, polar->y,
            polar->radius);
    for (int i = 0; i < 8; ++i)
    {
        double angle = i * SW_PI / 4.0, at = polar->radius + 14.0;
        WriteText(file, polar->x + at * sin(angle), polar->y - at * cos(angle) + 4.0,
                  i % 2 == 0 ? "text-anchor=\"middle\" font-weight=\"bold\""
                             : "text-anchor=\"middle\" font-size=\"10\"",
                  points[i]);
    }
}

static void WriteScale(FILE* file, const Polar* polar)
{
    const double left = 950, top = 124, height = 280;
    const int stepCount = 56;
    for (int i = 0; i < stepCount; ++i)
    {
        double t = 1.0 - (i + 0.5) / stepCount;
        fprintf(file, "<rect x=\"%.1f\" y=\"%.1f\" width=\"14\" height=\"%.1f\" fill=\"", left,
                top + height * i / stepCount, height / stepCount + 0.4);
        WriteColor(file, t);
        fputs("\"/>\n", file);
    }
    for (int i = 0; i <= 4; ++i)
    {
        double t = i / 4.0;
        char label[32];
        snprintf(label, sizeof(label), "%.3g", polar->maxDensity * t * t * DEGREE);
        WriteText(file, left + 20, top + height * (1.0 - t) + 4.0, "font-size=\"11\"", label);
    }
    WriteText(file, left - 40, top - 32, "", "density,");
    WriteText(file, left - 40, top - 16, "", "m\xc2\xb2/Hz/degree");
}

static void WriteDirections(FILE* file, const swMeasuredRecord* record, double lastFrequency)
{
    const swSpectrumTable* table = &record->table;
    Polar polar = {730, 264, 168, lastFrequency, 0.0};
    for (int i = 0; i < table->frequencyCount * table->directionCount; ++i)
    {
        polar.maxDensity = fmax(polar.maxDensity, (double)table->density[i]);
    }
    WriteCells(file, record, &polar);
    WriteCompass(file, &polar);
    WriteScale(file, &polar);
    WriteText(file, polar.x, 466, "text-anchor=\"middle\"",
              record->meanDirection != NULL ? "where waves come from"
                                            : "no directions measured: spread around the west");
}

bool PlotSpectrum(const char* path, const char* source, const swMeasuredRecord* record, const swSeaState* state)
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
        double lastFrequency = FindLastFrequency(record);
        WriteHead(file, source, record, state);
        WriteEnergy(file, record, state, lastFrequency);
        WriteDirections(file, record, lastFrequency);
        fputs("</svg>\n", file);
        isWritten = !ferror(file);
        isWritten = fclose(file) == 0 && isWritten;
    }
    if (!isWritten)
    {
        Complain("cannot write %s: %s", path, strerror(errno));
    }
    return EndOutput(&output, isWritten);
}
