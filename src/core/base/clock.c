// SPDX-License-Identifier: MIT
// A slewing clock adds at most slewRate of the time that passes, forwards or backwards; since that is below one, time
// that runs forwards never runs back.

#include "seaway/clock.h"

#include <math.h>

#include "core/base/assert.h"
#include "core/base/host.h"

swClock swDefaultClock(void)
{
    return (swClock){
        .scale = 1.0,
        .maxSteps = 8,
        .slewRate = 0.05,
        .jumpThreshold = 1.0,
        .internalValue = SW_DEF_COOKIE,
    };
}

static bool isValid(const swClock* clock)
{
    return clock != NULL && clock->internalValue == SW_DEF_COOKIE && fabs(clock->time) < 1e12 &&
           fabs(clock->scale) <= 1000.0 && clock->fixedStep >= 0.0 && clock->fixedStep <= 1.0 && clock->maxSteps >= 1 &&
           clock->maxSteps <= 1000 && clock->slewRate >= 0.0 && clock->slewRate <= 0.9 && clock->jumpThreshold > 0.0;
}

// The part of what is behind that this much passing time may make up for.
static double takeSlew(swClock* clock, double passed)
{
    double most = clock->slewRate * fabs(passed);
    double slew = fmax(-most, fmin(most, clock->behind));
    clock->behind -= slew;
    return slew;
}

static void advanceInSteps(swClock* clock, double passed)
{
    double direction = passed < 0.0 ? -1.0 : 1.0;
    clock->rest += fabs(passed);
    double steps = floor(clock->rest / clock->fixedStep);
    clock->rest -= steps * clock->fixedStep;
    steps = fmin(steps, clock->maxSteps);
    // A whole number of steps from zero, so that machines that started apart meet.
    double whole = floor(clock->time / clock->fixedStep + 0.5);
    clock->time = steps > 0.0 ? (whole + direction * steps) * clock->fixedStep : clock->time;
}

double swClock_Advance(swClock* clock, double hostDt)
{
    bool isFine = isValid(clock) && hostDt >= 0.0 && hostDt <= 3600.0;
    SW_ASSERT(isFine);
    if (!isFine)
    {
        return clock != NULL ? clock->time : 0.0;
    }
    if (clock->isPaused)
    {
        return clock->time;
    }
    double passed = hostDt * clock->scale;
    passed += takeSlew(clock, passed);
    if (clock->fixedStep > 0.0)
    {
        advanceInSteps(clock, passed);
    }
    else
    {
        clock->time += passed;
    }
    return clock->time;
}

double swClock_StepOnce(swClock* clock)
{
    SW_ASSERT(isValid(clock));
    if (isValid(clock))
    {
        double step = clock->fixedStep > 0.0 ? clock->fixedStep : 1.0 / 60.0;
        clock->time = (floor(clock->time / step + 0.5) + (clock->scale < 0.0 ? -1.0 : 1.0)) * step;
    }
    return clock != NULL ? clock->time : 0.0;
}

void swClock_Follow(swClock* clock, double serverTime)
{
    bool isFine = isValid(clock) && fabs(serverTime) < 1e12;
    SW_ASSERT(isFine);
    if (!isFine)
    {
        return;
    }
    double difference = serverTime - (clock->time + clock->rest);
    if (clock->isPaused || fabs(difference) > clock->jumpThreshold)
    {
        clock->time = serverTime;
        clock->rest = 0.0;
        clock->behind = 0.0;
        return;
    }
    clock->behind = difference;
}
