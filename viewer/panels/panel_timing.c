// SPDX-License-Identifier: MIT
// Where time and memory go, and the digest.

#include "panels.h"

#define MAX_PASSES 48
#define MEBI (1.0 / (1024.0 * 1024.0))

static void DrawFrameTimes(const FrameTimes* times)
{
    float sum = 0.0f, worst = 0.0f;
    int count = 0;
    for (int i = 0; i < FRAME_TIME_COUNT; i++)
    {
        float time = times->milliseconds[i];
        sum += time;
        worst = time > worst ? time : worst;
        count += time > 0.0f;
    }
    float mean = count > 0 ? sum / (float)count : 0.0f;
    UiWrapped("frame %.1f ms, worst %.1f, %.3g /s", (double)mean, (double)worst,
              mean > 0.0f ? 1e3 / (double)mean : 0.0);
    UiGraph(times->milliseconds, FRAME_TIME_COUNT, times->next, worst > 33.4f ? worst : 33.4f);
}

static void DrawPasses(const swGpu* gpu)
{
    static const UiColumn columns[] = {{"GPU pass", 0.0f}, {"ms", 8.0f}};
    swPassTime times[MAX_PASSES];
    int count = swGpu_GetPassTimes(gpu, times, MAX_PASSES);
    float sum = 0.0f;
    if (count == 0)
    {
        UiFaint("this device has no timestamps, or none yet");
        return;
    }
    if (!BeginUiTable("passes", 2, columns))
    {
        return;
    }
    for (int i = 0; i < count; i++)
    {
        UiCell("%s", times[i].name);
        UiCell("%.3f", (double)times[i].milliseconds);
        sum += times[i].milliseconds;
    }
    UiCell("all");
    UiCell("%.3f", (double)sum);
    EndUiTable();
}

void DrawTimingPanel(App* app)
{
    const Sea* sea = &app->sea;
    if (!BeginUiSection("Timing and memory", true))
    {
        return;
    }
    DrawFrameTimes(&app->frameTimes);
    DrawPasses(app->gpu);
    UiWrapped("%s%s", swGpu_GetDeviceName(app->gpu), swGpu_IsSoftware(app->gpu) ? " (software)" : "");
    UiText("core: %s, %.1f MiB", swIsa_GetName(swWorld_GetIsa(sea->world)),
           (double)swWorld_GetMemory(sea->world) * MEBI);
    UiText("device: %.1f MiB", (double)swGpuWorld_GetMemory(sea->gpuWorld) * MEBI);
    UiText("digest %016llx", (unsigned long long)swWorld_GetDigest(sea->world));
    UiTip("Equal on two machines exactly if their surfaces are");
}
