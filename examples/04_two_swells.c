// SPDX-License-Identifier: MIT
// A sea by its names: a fresh breeze, Beaufort 5, over the swells of two storms. Links the core alone.
#include <seaway/seaway.h>

#include <math.h>
#include <stdio.h>

static void PrintSystem(const char* name, const swSpectrumDef* spectrum)
{
    swSeaState state;
    if (swSpectrum_GetSeaState(spectrum, 0.0f, 0.0f, &state) == SW_SUCCESS)
    {
        printf("%-12s Hs %.2f m, Tp %5.2f s, spread %2.0f degrees\n", name, (double)state.significantHeight,
               (double)state.peakPeriod, (double)state.spread * 180.0 / SW_PI);
    }
}

// 4 times the standard deviation of heights, over ten kilometres.
static double MeasureHeight(swWorld* world)
{
    enum
    {
        SIDE = 64
    };
    static swPosXZ points[SIDE * SIDE];
    static float heights[SIDE * SIDE];
    double square = 0.0;
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        points[i] = (swPosXZ){1e4 / SIDE * (i % SIDE), 1e4 / SIDE * (i / SIDE)};
    }
    swQueryDef query = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = heights};
    swMoment_QuerySurface(swWorld_GetMoment(world), &query, SIDE * SIDE, points, &samples, NULL);
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        square += (double)heights[i] * (double)heights[i] / (SIDE * SIDE);
    }
    return 4.0 * sqrt(square);
}

int main(void)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    if (swCreateWorld(&host, &worldDef, &world) != SW_SUCCESS)
    {
        return 1; // the host's log has said why
    }

    // [sea]
    swSeaDef def = swDefaultSeaDef();
    def.windSea.spectrum = swMakeBeaufortSpectrum(5.0f, SW_DIRECTION_FROM_BEARING(200.0));
    def.swellCount = 2;
    def.swells[0] = swMakeSwellSpectrum(1.6f, 15.0f, SW_DIRECTION_FROM_BEARING(240.0), 0.16f);
    def.swells[1] = swMakeSwellSpectrum(1.1f, 10.0f, SW_DIRECTION_FROM_BEARING(310.0), 0.25f);
    swSea sea;
    swResult result = swCreateSea(world, &def, &sea);
    // [/sea]

    result = result == SW_SUCCESS ? swWorld_Step(world, 0.0) : result;
    if (result == SW_SUCCESS)
    {
        PrintSystem("wind sea", &def.windSea.spectrum);
        PrintSystem("long swell", &def.swells[0]);
        PrintSystem("short swell", &def.swells[1]);
        printf("Together Hs %.2f m, measured over ten kilometres: %.2f m\n", sqrt(2.0 * 2.0 + 1.6 * 1.6 + 1.1 * 1.1),
               MeasureHeight(world));
        swDestroySea(world, &sea);
    }
    swDestroyWorld(world);
    return result == SW_SUCCESS ? 0 : 1;
}
