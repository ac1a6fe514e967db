// SPDX-License-Identifier: MIT
#pragma once

// Pieces of pictures as SVG: text, axes, colours.

#include <stdbool.h>
#include <stdio.h>

// Colours that people with any kind of colour vision tell apart, on white.
#define SVG_INK "#24303a"
#define SVG_PALE_INK "#5a6874"
#define SVG_GRID "#e3e8ec"
#define SVG_BLUE "#0072b2"
#define SVG_ORANGE "#d55e00"

void BeginSvg(FILE* file, int width, int height);
void EndSvg(FILE* file);

// `style`: attributes, such as "text-anchor=\"middle\"".
void WriteText(FILE* file, double x, double y, const char* style, const char* text);

// A colour of one hue, the darker the more; `level` in [0, levelCount).
void WriteLevelColor(FILE* file, int level, int levelCount);

typedef struct SvgAxis
{
    double low, high;   // values at the ends
    double begin, end;  // pixels at the ends
    bool isLogarithmic; // then `low` is above 0
} SvgAxis;

double GetPlace(const SvgAxis* axis, double value);

// Round values along the axis, at most `mostCount` of them, into ticks; returns how many.
int FindTicks(const SvgAxis* axis, int mostCount, double* ticks);
