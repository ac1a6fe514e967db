// SPDX-License-Identifier: MIT
#include "sea_calm.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"

#define SIDE 64            // points along each side of a square
#define SPACING 3.7        // m
#define LEAST_HEIGHT 1e-6f // m; waves lower than that are none

static bool HasSystemWaves(const swScene* scene, const swWaveSystemDef* def)
{
    if (def->componentCount > 0)
    {
        float largest = 0.0f;
        for (int i = 0; i < def->componentCount; ++i)
        {
            largest = fmaxf(largest, def->components[i].amplitude);
        }
        return def->weight * largest > LEAST_HEIGHT;
    }
    double gravity = (double)scene->world.gravity, depth = (double)def->spectrum.depth;
    float low = (float)swGetWaveFrequency((double)def->maxWavelength, depth, gravity);
    float high = (float)swGetWaveFrequency((double)def->minWavelength, depth, gravity);
    swSeaState state;
    return def->weight > 0.0f && swSpectrum_GetSeaState(&def->spectrum, low, high, &state) == SW_SUCCESS &&
           def->weight * state.significantHeight > LEAST_HEIGHT;
}

bool HasWaves(const swScene* scene)
{
    bool hasWaves = false;
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        hasWaves |= HasSystemWaves(scene, &scene->waves[i].def);
    }
    return hasWaves;
}

static swSeaState MakeFlatState(double height, double slope)
{
    return (swSeaState){.significantHeight = (float)height,
                        .peakPeriod = NAN,
                        .periodTm01 = NAN,
                        .periodTm02 = NAN,
                        .energyPeriod = NAN,
                        .meanDirection = NAN,
                        .peakDirection = NAN,
                        .spread = NAN,
                        .meanSquareSlope = (float)slope};
}

static void MeasureSurface(const swWorld* world, SeaMeasurement* sea)
{
    static swPosXZ points[SIDE * SIDE];
    static float heights[SIDE * SIDE];
    static swVec3 normals[SIDE * SIDE];
    double sum = 0.0, square = 0.0, slope = 0.0, count = SIDE * SIDE;
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        points[i] = (swPosXZ){SPACING * (i % SIDE), SPACING * (i / SIDE)};
    }
    const swSurfaceSamples samples = {.height = heights, .normal = normals};
    const swQueryDef def = swDefaultQueryDef();
    swMoment_QuerySurface(swWorld_GetMoment(world), &def, SIDE * SIDE, points, &samples, NULL);
    double level = swWorld_GetSeaLevel(world);
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        double height = (double)heights[i] - level, up = (double)normals[i].y;
        sum += height;
        square += height * height;
        slope += (1.0 - up * up) / (up * up);
    }
    sea->surfaceHeight = 4.0 * sqrt(fmax(square / count - sum / count * sum / count, 0.0));
    sea->surfaceSlope = slope / count;
}

SeaMeasurement* MeasureCalm(const swScene* scene, const MeasureOptions* options)
{
    swHost host = MakeHost();
    swWorld* world = NULL;
    swResult result = swCreateSceneWorld(&host, scene, &world);
    SeaMeasurement* sea = result == SW_SUCCESS ? calloc(1, sizeof(SeaMeasurement)) : NULL;
    if (sea == NULL)
    {
        ComplainAboutResult(result == SW_SUCCESS ? SW_ERROR_NO_MEMORY : result, "the sea could not be made");
        swDestroyWorld(world);
        return NULL;
    }
    sea->scene = scene;
    sea->options = *options;
    MeasureSurface(world, sea);
    sea->asked = MakeFlatState(0.0, 0.0);
    sea->measured = MakeFlatState(sea->surfaceHeight, sea->surfaceSlope);
    sea->error = MakeFlatState((double)NAN, (double)NAN);
    sea->heightDeviation = (double)NAN;
    swDestroyWorld(world);
    return sea;
}
