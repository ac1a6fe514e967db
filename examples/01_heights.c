// SPDX-License-Identifier: MIT
// Heights of a wind sea on the CPU: what a game server or a robot simulator needs. Links the core alone.
#include <seaway/seaway.h>

#include <math.h>
#include <stdio.h>

// A buoy bobs for `seconds`; 4 times the standard deviation of its height is the significant wave height.
static double MeasureSignificantHeight(swWorld* world, double seconds)
{
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (double t = 0.0; t < seconds; t += 0.5)
    {
        if (swWorld_Step(world, 0.5) != SW_SUCCESS)
        {
            return 0.0;
        }
        double height = swMoment_GetHeight(swWorld_GetMoment(world), 0.0, 0.0);
        sum += height;
        squares += height * height;
        ++count;
    }
    double mean = sum / count;
    return 4.0 * sqrt(squares / count - mean * mean);
}

int main(void)
{
    // [readme]
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    if (swCreateWorld(&host, &worldDef, &world) != SW_SUCCESS)
    {
        return 1; // the host's log has said why
    }

    swWaveSystemDef waves = swDefaultWaveSystemDef(); // a JONSWAP sea
    waves.spectrum.windSpeed = 12.0f;                 // m/s
    waves.spectrum.fetch = 200e3f;                    // m
    waves.spectrum.direction = SW_DIRECTION_FROM_BEARING(240.0);
    swWaveSystemId sea;
    swResult result = swCreateWaveSystem(world, &waves, &sea);

    for (int frame = 0; frame < 60 && result == SW_SUCCESS; ++frame)
    {
        result = swWorld_Step(world, 1.0 / 60.0);
    }
    printf("height at (10, 20): %.2f m\n", swMoment_GetHeight(swWorld_GetMoment(world), 10.0, 20.0));
    // [/readme]

    // Many points at once, with normals; the answer says how far each search was off.
    swPosXZ points[5] = {{0.0, 0.0}, {10.0, 20.0}, {-300.0, 5.5}, {1.0e6, -2.0e6}, {42.0, 42.0}};
    float heights[5];
    swVec3 normals[5];
    swSurfaceSamples samples = {.height = heights, .normal = normals};
    swQueryDef query = swDefaultQueryDef();
    swQueryStats stats;
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, 5, points, &samples, &stats);
    for (int i = 0; i < 5; ++i)
    {
        printf("(%10.1f, %10.1f)  height %6.2f m  normal (%5.2f, %4.2f, %5.2f)\n", points[i].x, points[i].z,
               (double)heights[i], (double)normals[i].x, (double)normals[i].y, (double)normals[i].z);
    }
    printf("%d of 5 found, the worst %.2g m beside its point\n", stats.convergedCount, (double)stats.worstResidual);

    swSeaState asked;
    if (result == SW_SUCCESS)
    {
        result = swSpectrum_GetSeaState(&waves.spectrum, 0.0f, 0.0f, &asked);
    }
    double measured = MeasureSignificantHeight(world, 1200.0);
    swDestroyWorld(world);
    if (result != SW_SUCCESS || measured <= 0.0)
    {
        fprintf(stderr, "01_heights: %s\n", swResult_GetText(result));
        return 1;
    }
    printf("Hs asked for: %.2f m; of twenty minutes at one point: %.2f m\n", (double)asked.significantHeight, measured);
    return 0;
}
