// SPDX-License-Identifier: MIT
#pragma once

// A measured spectrum as SVG: energy over frequency, and over frequency and bearing on a polar chart.

#include <stdbool.h>

#include "seaway/spectrum.h"

// Complains and returns false if the file cannot be written.
bool PlotSpectrum(const char* path, const char* source, const swMeasuredRecord* record, const swSeaState* state);
