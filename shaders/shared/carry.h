// SPDX-License-Identifier: MIT
// Waves in a flow that differs from place to place. A pattern that is carried with the water wherever it goes would be
// torn apart in time; so it is carried for a period, and then begins anew. Two copies of it do so half a period apart,
// and each counts by a weight that is 0 when it begins anew and 1 half a period later [Vlachos 2010]. A copy that is at
// `phase` of its period is looked up (phase - 1/2) periods' way against the flow.
//
// Two copies of a Gaussian sea with the weights v and w have the variance v^2 + w^2 + 2 v w rho, where rho is the
// correlation of its heights at the way between them; dividing by the root of it leaves every height's distribution as
// it was [Heitz 2018] for rho 0. In slow water rho is 1 and nothing happens; in fast water it is 0. The way
// between the copies is half a period's, at all times, so rho and the variance are smooth in place and time.
#ifndef SW_SHARED_CARRY_H
#define SW_SHARED_CARRY_H
#include "types.h"

#ifdef __STDC__
#include <math.h>
#define SW_CARRY_SQRT sqrtf
#define SW_CARRY_ABS fabsf
#else
#define SW_CARRY_SQRT sqrt
#define SW_CARRY_ABS abs
#endif

// Of a speed of the water, what it is beside that of the flow that is the same everywhere and carries all waves. Where
// nothing else flows it is 0, also where the sum was rounded in another way.
SW_FORMULA float swGetCarriedSpeed(float speed, float even)
{
    float beside = speed - even;
    return SW_CARRY_ABS(beside) <= 1e-6f * SW_CARRY_ABS(even) ? 0.0f : beside;
}

// Periods of the waves in a period of the copies: copies are half a wavelength apart where the flow has a quarter of
// the waves' speed, beyond which waves cannot run against it.
#define SW_CARRY_WAVES 4.0f

// Where copies nearly cancel each other, as those of a single wave do, this is the least variance that counts.
#define SW_LEAST_CARRY_VARIANCE 0.02f

// Seconds, for waves of wave number k, rad/m, in deep water.
SW_FORMULA float swGetCarryPeriod(float k)
{
    return SW_CARRY_WAVES * 6.2831853f / SW_CARRY_SQRT(9.81f * k);
}

SW_FORMULA float swGetCarryWeight(float phase)
{
    return 1.0f - SW_CARRY_ABS(2.0f * phase - 1.0f);
}

// By the weight of either copy.
SW_FORMULA float swGetCarryVariance(float weight, float rho)
{
    float other = 1.0f - weight;
    return weight * weight + other * other + 2.0f * weight * other * rho;
}

// By which both copies are multiplied so that the variance is that of one, and the derivative of it by rho.
SW_PARAMS(swCarryFactor)
{
    float value, slope;
};

SW_FORMULA swCarryFactor swGetCarryFactor(float weight, float rho)
{
    float variance = swGetCarryVariance(weight, rho);
    bool isLeast = !(variance > SW_LEAST_CARRY_VARIANCE);
    variance = isLeast ? SW_LEAST_CARRY_VARIANCE : variance;
    swCarryFactor factor;
    factor.value = 1.0f / SW_CARRY_SQRT(variance);
    factor.slope = isLeast ? 0.0f : -weight * (1.0f - weight) * factor.value / variance;
    return factor;
}
#endif
