// SPDX-License-Identifier: MIT
#include "ui_scale.h"

#include <math.h>

#define LEAST_SCALE 0.85f // letters of 11 units
#define STEP 1.15f

float ChooseUiScale(float width, float height, float density, float factor)
{
    float fit = fminf(width / 1280.0f, height / 720.0f) / density;
    float scale = fit < 1.0f ? fmaxf(fit, LEAST_SCALE) : fmaxf(fit / 1.5f, 1.0f);
    return scale * density * factor;
}

float StepUiFactor(float factor, int step)
{
    float next = factor * powf(STEP, (float)step);
    next = fabsf(next - 1.0f) < 0.05f ? 1.0f : next;
    return fminf(fmaxf(next, LEAST_UI_FACTOR), LARGEST_UI_FACTOR);
}

float ChoosePanelWidth(float width, float letterSize)
{
    float wanted = fminf(fmaxf(0.4f * width, 23.0f * letterSize), 30.0f * letterSize);
    return fminf(wanted, width - 20.0f);
}

double FindSliderPlace(double value, double low, double high, bool isLogarithmic)
{
    double place = isLogarithmic ? log(value / low) / log(high / low) : (value - low) / (high - low);
    return place > 0.0 ? (place < 1.0 ? place : 1.0) : 0.0; // also of a value that has no logarithm
}
