// SPDX-License-Identifier: MIT
// The sea's clock: run, halt, step, scale, fixed steps, and a timeline to pull.

#include <math.h>
#include <stdio.h>
#include <time.h>

#include "panels.h"

#define PAGE 600.0 // s of a timeline without records

void WriteUtc(double seconds, char text[20])
{
    time_t whole = (time_t)seconds;
    struct tm utc;
    snprintf(text, 20, "?");
    if (gmtime_r(&whole, &utc) != NULL)
    {
        strftime(text, 20, "%Y-%m-%d %H:%M", &utc);
    }
}

// A replay's timeline is as long as its records; else time goes page by page.
static void FindTimeline(const Sea* sea, double time, double* low, double* high)
{
    *low = floor(time / PAGE) * PAGE;
    *high = *low + PAGE;
    for (int i = 0; i < sea->wavesCount; i++)
    {
        const swSeaReplayDef* replay = &sea->waves[i].replayDef;
        if (sea->waves[i].replay != NULL && replay->speed != 0.0)
        {
            swMeasuredLocation place = swMeasuredSea_GetLocation(replay->sea, replay->location);
            double first = swMeasuredSea_GetRecord(replay->sea, place.firstRecord).seconds;
            double last = swMeasuredSea_GetRecord(replay->sea, place.firstRecord + place.recordCount - 1).seconds;
            double a = replay->startTime + (first - replay->startSeconds) / replay->speed;
            double b = replay->startTime + (last - replay->startSeconds) / replay->speed;
            *low = fmin(a, b);
            *high = fmax(a, b);
            return;
        }
    }
}

static void DrawTimeline(App* app)
{
    swClock* clock = &app->clock;
    double low = 0.0, high = 0.0, time = clock->time;
    FindTimeline(&app->sea, time, &low, &high);
    if (UiDoubleSlider("timeline", &time, low, high, "%.1f s"))
    {
        clock->time = time;
        clock->rest = 0.0;
    }
    UiTip("Pull to go to another time; waves are a function of time alone");
}

static void DrawScale(swClock* clock)
{
    float scale = (float)fabs(clock->scale);
    bool isBackwards = clock->scale < 0.0;
    bool hasChanged = UiLogSlider("speed", &scale, 1.0f / 16.0f, 1000.0f, "x %.3g");
    hasChanged |= UiCheckbox("backwards", &isBackwards);
    if (hasChanged)
    {
        clock->scale = isBackwards ? -(double)scale : (double)scale;
    }
}

static void DrawFixedSteps(swClock* clock)
{
    bool isFixed = clock->fixedStep > 0.0;
    UiSameLine();
    if (UiCheckbox("fixed steps", &isFixed))
    {
        clock->fixedStep = isFixed ? 1.0 / 60.0 : 0.0;
        clock->rest = 0.0;
    }
    UiTip("Time goes on by whole steps, as it does on machines that run in lockstep");
    if (isFixed)
    {
        int perSecond = (int)lround(1.0 / clock->fixedStep);
        clock->fixedStep = UiSliderInt("steps", &perSecond, 5, 240, "%d /s") ? 1.0 / perSecond : clock->fixedStep;
    }
}

void DrawTimePanel(App* app)
{
    swClock* clock = &app->clock;
    if (!BeginUiSection("Time", true))
    {
        return;
    }
    if (UiButton(clock->isPaused ? "run" : "pause"))
    {
        clock->isPaused = !clock->isPaused;
    }
    UiSameLine();
    if (UiButton("step"))
    {
        clock->isPaused = app->stepOnce = true;
    }
    UiSameLine();
    if (UiButton("x 1"))
    {
        clock->scale = 1.0;
    }
    UiSameLine();
    UiText("%.2f s%s", swWorld_GetTime(app->sea.world), clock->isPaused ? ", paused" : "");
    DrawTimeline(app);
    DrawScale(clock);
    DrawFixedSteps(clock);
}
