// SPDX-License-Identifier: MIT
#pragma once

#include <math.h>

#include "seaway/math.h"

// Points spread evenly however many there are: fractions of two irrational numbers, the plane's golden ratio.
static inline swPosXZ swPlaceGauge(double area, int index)
{
    double x = 0.7548776662466927 * (index + 1), z = 0.5698402909980532 * (index + 1);
    return (swPosXZ){area * (x - floor(x) - 0.5), area * (z - floor(z) - 0.5)};
}
