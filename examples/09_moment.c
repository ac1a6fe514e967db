// SPDX-License-Identifier: MIT
// A helicopter is to land on a ship: when will the deck lie still? A job of its own looks ten seconds ahead, at its own
// pace, while the world steps on. Links the core alone; POSIX threads.
#include <seaway/seaway.h>

#include <math.h>
#include <pthread.h>
#include <stdio.h>

enum
{
    PROBES = 9
};

// [ahead]
// The job owns its moment. The world may step, change or be destroyed meanwhile.
typedef struct Forecast
{
    swMoment* now; // of the frame in which the job began
    swMoment* later[10];
    int bestSecond;
    double bestHeave;
} Forecast;

// How far the water under the ship stands from still water, m.
static double FindHeave(const swMoment* moment)
{
    swQueryDef query = swDefaultQueryDef();
    query.minWavelength = 16.0f; // the ship does not feel shorter waves
    swPosXZ probes[PROBES];
    float heights[PROBES];
    for (int i = 0; i < PROBES; ++i)
    {
        probes[i] = (swPosXZ){10.0 * (i - PROBES / 2), 0.0};
    }
    swMoment_QuerySurface(moment, &query, PROBES, probes, &(swSurfaceSamples){.height = heights}, NULL);
    double sum = 0.0;
    for (int i = 0; i < PROBES; ++i)
    {
        sum += (double)heights[i] / PROBES;
    }
    return fabs(sum);
}

static void* LookAhead(void* context)
{
    Forecast* forecast = context;
    forecast->bestHeave = FindHeave(forecast->now);
    for (int second = 1; second <= 10; ++second)
    {
        double heave = FindHeave(forecast->later[second - 1]);
        if (heave < forecast->bestHeave)
        {
            forecast->bestHeave = heave;
            forecast->bestSecond = second;
        }
    }
    return NULL;
}

// Half a millisecond each: a step's transforms. Made while nobody steps the world.
static bool BeginForecast(const swWorld* world, Forecast* forecast)
{
    swMomentDef def = swDefaultMomentDef();
    def.time = swWorld_GetTime(world);
    bool isFine = swCreateMoment(world, &def, &forecast->now) == SW_SUCCESS;
    for (int i = 0; i < 10 && isFine; ++i)
    {
        def.time += 1.0;
        isFine = swCreateMoment(world, &def, &forecast->later[i]) == SW_SUCCESS;
    }
    return isFine;
}
// [/ahead]

static void EndForecast(Forecast* forecast)
{
    swDestroyMoment(forecast->now);
    for (int i = 0; i < 10; ++i)
    {
        swDestroyMoment(forecast->later[i]);
    }
}

int main(void)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    swWaveSystemId id;
    Forecast forecast = {0};
    if (swCreateWorld(&host, &worldDef, &world) != SW_SUCCESS || swCreateWaveSystem(world, &waves, &id) != SW_SUCCESS ||
        swWorld_Step(world, 100.0) != SW_SUCCESS || !BeginForecast(world, &forecast))
    {
        return 1; // the host's log has said why
    }
    pthread_t job;
    if (pthread_create(&job, NULL, LookAhead, &forecast) != 0)
    {
        return 1;
    }
    double asked = swWorld_GetTime(world);
    for (int frame = 0; frame < 600; ++frame)
    {
        swWorld_Step(world, 1.0 / 60.0);
    }
    pthread_join(job, NULL);
    printf("at %.0f s the deck was expected to stand stillest in %d s, %.2f m from still water\n", asked,
           forecast.bestSecond, forecast.bestHeave);
    EndForecast(&forecast);
    swDestroyWorld(world);
    return 0;
}
