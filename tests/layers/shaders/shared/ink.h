// SPDX-License-Identifier: MIT
// Made up for tests: ink that spreads through a zone and settles. One step at a fixed rate takes each texel toward the
// mean of its four neighbours, and a share away. Level by level, so that each is a field of its own.
#ifndef SW_SHARED_INK_H
#define SW_SHARED_INK_H
#include "shared/types.h"

#define SW_INK_SPREAD 0.2f  // toward the neighbours' mean, a step
#define SW_INK_KEPT 0.98f   // a step
#define SW_INK_POUR_STEPS 8 // steps from one drop to the next

SW_FORMULA float swInkStep(float here, float left, float right, float below, float above)
{
    float mean = 0.25f * ((left + right) + (below + above));
    return SW_INK_KEPT * (here + SW_INK_SPREAD * (mean - here));
}
#endif
