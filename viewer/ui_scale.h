// SPDX-License-Identifier: MIT
#pragma once

// How large letters and panel are, and where handles lie. Lengths in the window's own units.

#include <stdbool.h>

// Factor on letters of 13 units: 1 in windows from 1280 x 720 to 1920 x 1080, smaller in small ones as long as one can
// read it, larger in large ones. `density` is the units in a pixel of an ordinary screen (2 on many laptops), `factor`
// the user's wish, 1 for none.
float ChooseUiScale(float width, float height, float density, float factor);

// The next wish, larger or smaller, in steps that one sees.
#define LEAST_UI_FACTOR 0.5f
#define LARGEST_UI_FACTOR 4.0f
float StepUiFactor(float factor, int step);

// Width of the panel beside a picture: enough for its widgets, and of a small window not more than two fifths unless
// its letters do not fit otherwise.
float ChoosePanelWidth(float width, float letterSize);

// How far along its line a slider's handle is, 0 to 1; evenly by the value, or by its logarithm.
double FindSliderPlace(double value, double low, double high, bool isLogarithmic);
