// SPDX-License-Identifier: MIT
#pragma once

// The asked and the measured spectrum of a sea as SVG: energy over frequency, and over frequency and the bearing that
// waves come from.

#include <stdbool.h>

#include "sea_measure.h"

// `note`, may be NULL, stands below the charts. The sea has to be measured with directions. Complains and returns false
// if the file cannot be written.
bool PlotSea(const char* path, const char* title, const char* note, const SeaMeasurement* sea);
