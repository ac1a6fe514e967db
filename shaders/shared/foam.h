// SPDX-License-Identifier: MIT
// Foam is born where the surface folds and fades with time: df/dt = gain max(threshold - J, 0) - fadeRate f, kept within
// [0, 1]. Over one step with J constant the solution is exact, so that the result does not depend on the rate.
#ifndef SW_SHARED_FOAM_H
#define SW_SHARED_FOAM_H
#include "types.h"

// keep = exp(-fadeRate dt); grow = gain (1 - keep) / fadeRate.
SW_FORMULA float swFoamStep(float foam, float jacobian, float threshold, float keep, float grow)
{
    float fold = threshold - jacobian;
    fold = fold > 0.0f ? fold : 0.0f;
    float next = foam * keep + fold * grow;
    return next < 1.0f ? next : 1.0f;
}
#endif
