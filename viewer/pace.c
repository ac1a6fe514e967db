// SPDX-License-Identifier: MIT
#include "pace.h"

#include <math.h>

void MeasurePace(Pace* pace, double wall, double scale, double sea)
{
    pace->wall += wall;
    pace->sea += scale != 0.0 ? sea / scale : wall;
    pace->frameCount++;
    if (pace->wall >= PACE_SPAN && pace->frameCount > 1)
    {
        float ratio = (float)(pace->sea / pace->wall);
        float frameMs = (float)(1e3 * pace->wall / pace->frameCount);
        *pace = (Pace){.ratio = fmaxf(ratio, 1e-3f), .frameMs = frameMs};
    }
}

void ForgetPace(Pace* pace)
{
    *pace = (Pace){0};
}

bool IsSeaSlow(const Pace* pace)
{
    return pace->ratio > 0.0f && pace->ratio < 0.95f;
}
