// SPDX-License-Identifier: MIT
// What a moored buoy records: 20 minutes of its motion as CSV, at 2 Hz. Links the core alone.
#include <seaway/seaway.h>

#include <math.h>
#include <stdio.h>

enum
{
    SAMPLES = 2400
};

// The water particle that rests at the mooring, now.
static bool SampleBuoy(swWorld* world, double time, swVec3* moved, swVec3* acceleration, swVec2* slope)
{
    if (swWorld_StepTo(world, time) != SW_SUCCESS)
    {
        return false;
    }
    const swPosXZ mooring = {0.0, 0.0};
    swQueryDef query = swDefaultQueryDef();
    query.minWavelength = 2.0f; // a buoy a metre across does not feel shorter waves
    swSurfaceSamples samples = {.displacement = moved, .acceleration = acceleration};
    swMoment_QueryParticles(swWorld_GetMoment(world), &query, 1, &mooring, &samples, slope, NULL);
    return true;
}

int main(void)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableAcceleration = true; // one by one would do as well, for one buoy
    swWorld* world;
    if (swCreateWorld(&host, &worldDef, &world) != SW_SUCCESS)
    {
        return 1; // the host's log has said why
    }
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.spectrum = swMakeWindSeaSpectrum(12.0f, 80e3f, 6.0f * 3600.0f, SW_DIRECTION_FROM_BEARING(60.0));
    waves.resolution = 64;
    waves.tileWaves = 16;
    swWaveSystemId sea;
    swResult result = swCreateWaveSystem(world, &waves, &sea);

    double squares = 0.0;
    puts("t_s,east_m,north_m,heave_m,slope_east,slope_north,vertical_acceleration_mps2");
    for (int i = 0; i < SAMPLES && result == SW_SUCCESS; ++i)
    {
        swVec3 moved, acceleration;
        swVec2 slope;
        if (!SampleBuoy(world, 0.5 * i, &moved, &acceleration, &slope))
        {
            result = SW_ERROR_INVALID;
            break;
        }
        squares += (double)moved.y * (double)moved.y / SAMPLES;
        printf("%.1f,%.4f,%.4f,%.4f,%.5f,%.5f,%.4f\n", 0.5 * i, (double)moved.x, (double)-moved.z, (double)moved.y,
               (double)slope.x, (double)-slope.y, (double)acceleration.y);
    }
    swSeaState asked;
    if (result == SW_SUCCESS && swSpectrum_GetSeaState(&waves.spectrum, 0.0f, 0.0f, &asked) == SW_SUCCESS)
    {
        fprintf(stderr, "Hs %.2f m in these 20 minutes, %.2f m asked for\n", 4.0 * sqrt(squares),
                (double)asked.significantHeight);
    }
    swDestroyWorld(world);
    return result == SW_SUCCESS ? 0 : 1;
}
