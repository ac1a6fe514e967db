// SPDX-License-Identifier: MIT

#include "svg.h"

#include <math.h>

#include "text.h"

void BeginSvg(FILE* file, int width, int height)
{
    fprintf(file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
            "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"" SVG_INK "\">\n"
            "<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>\n",
            width, height, width, height, width, height);
}

void EndSvg(FILE* file)
{
    fputs("</svg>\n", file);
}

void WriteText(FILE* file, double x, double y, const char* style, const char* text)
{
    fprintf(file, "<text x=\"%.1f\" y=\"%.1f\" %s>", x, y, style);
    for (const char* c = text; *c != 0;)
    {
        size_t size = MeasureCharacter(c);
        if (size != 1)
        {
            fwrite(size > 0 ? c : "?", size > 0 ? size : 1, 1, file); // XML takes no control characters
            c += size > 0 ? size : 1;
            continue;
        }
        switch (*c++)
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
            fputc(c[-1], file);
        }
    }
    fputs("</text>\n", file);
}

void WriteLevelColor(FILE* file, int level, int levelCount)
{
    static const double stops[6][3] = {{240, 246, 248}, {183, 216, 226}, {108, 173, 199},
                                       {47, 118, 163},  {20, 67, 112},   {8, 28, 58}};
    double at = 5.0 * (level + 0.5) / levelCount;
    int i = at < 5.0 ? (int)at : 4;
    double part = at - i;
    fprintf(file, "#%02x%02x%02x", (unsigned)lround(stops[i][0] + (stops[i + 1][0] - stops[i][0]) * part),
            (unsigned)lround(stops[i][1] + (stops[i + 1][1] - stops[i][1]) * part),
            (unsigned)lround(stops[i][2] + (stops[i + 1][2] - stops[i][2]) * part));
}

double GetPlace(const SvgAxis* axis, double value)
{
    double part = axis->isLogarithmic ? log(value / axis->low) / log(axis->high / axis->low)
                                      : (value - axis->low) / (axis->high - axis->low);
    return axis->begin + (axis->end - axis->begin) * part;
}

static int FindLinearTicks(const SvgAxis* axis, int mostCount, double* ticks)
{
    double raw = (axis->high - axis->low) / mostCount, power = pow(10.0, floor(log10(raw))), lead = raw / power;
    double step = power * (lead <= 1.0 ? 1.0 : lead <= 2.0 ? 2.0 : lead <= 5.0 ? 5.0 : 10.0);
    int count = 0;
    for (double i = ceil(axis->low / step - 1e-6); i * step <= axis->high * (1.0 + 1e-9) && count < mostCount + 1;
         i += 1.0)
    {
        ticks[count++] = i * step + 0.0; // no minus zero
    }
    return count;
}

// Powers of ten; 1, 2, 5 times these where there is room.
static int FindLogarithmicTicks(const SvgAxis* axis, int mostCount, double* ticks)
{
    static const double leads[3] = {1.0, 2.0, 5.0};
    double decades = log10(axis->high / axis->low);
    int leadCount = 3.0 * decades <= mostCount ? 3 : 1, count = 0;
    double skip = fmax(1.0, ceil(decades / mostCount));
    for (double power = floor(log10(axis->low)); power <= ceil(log10(axis->high)); power += skip)
    {
        for (int i = 0; i < leadCount; ++i)
        {
            double tick = leads[i] * pow(10.0, power);
            if (tick >= axis->low * (1.0 - 1e-9) && tick <= axis->high * (1.0 + 1e-9) && count < mostCount + 1)
            {
                ticks[count++] = tick;
            }
        }
    }
    return count;
}

int FindTicks(const SvgAxis* axis, int mostCount, double* ticks)
{
    return axis->isLogarithmic ? FindLogarithmicTicks(axis, mostCount, ticks) : FindLinearTicks(axis, mostCount, ticks);
}
