// SPDX-License-Identifier: MIT
// What a still picture of the surface tells, and its foam.

#include <math.h>

#include "core/base/misuse.h"
#include "measure/measure_space.h"
#include "seaway/measure.h"

// Looked at together.
#define BLOCK 256

swResult swLookAtSurface(const swWorld* world, double area, int count, swSurfaceSums* sums)
{
    SW_REQUIRE(world != NULL && sums != NULL && count > 0 && area > 0.0 && area <= SW_FARTHEST_POINT, SW_ERROR_INVALID,
               swFindHost(world),
               "swLookAtSurface() needs a world, an area and a count above 0, and a place for the sums");
    swPosXZ points[BLOCK];
    float height[BLOCK];
    swVec3 normal[BLOCK];
    swVec2 slopes[BLOCK];
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = height, .normal = normal};
    double seaLevel = swWorld_GetSeaLevel(world);
    for (int first = 0; first < count; first += BLOCK)
    {
        int size = count - first < BLOCK ? count - first : BLOCK;
        for (int i = 0; i < size; ++i)
        {
            points[i] = swPlaceGauge(area, first + i);
        }
        swMoment_QuerySurface(swWorld_GetMoment(world), &def, size, points, &samples, NULL);
        swMoment_QueryParticles(swWorld_GetMoment(world), &def, size, points, &(swSurfaceSamples){0}, slopes, NULL);
        for (int i = 0; i < size; ++i)
        {
            double h = (double)height[i] - seaLevel;
            double x = (double)normal[i].x, y = (double)normal[i].y, z = (double)normal[i].z;
            double slopeX = (double)slopes[i].x, slopeZ = (double)slopes[i].y;
            sums->count += 1.0;
            sums->height += h;
            sums->heightSquare += h * h;
            sums->slopeSquare += y > 0.0 ? (x * x + z * z) / (y * y) : 0.0;
            sums->particleSlopeSquare += slopeX * slopeX + slopeZ * slopeZ;
        }
    }
    return SW_SUCCESS;
}

// Slices of texels of 0.5 m to 16 m: 64 m to 2 km.
#define FOAM_RESOLUTION 128
#define FOAM_SLICES 6

// Foam is looked at every second after the first ones, the mean being right from the start.
#define FOAM_WARM_UP 4
#define FOAM_LOOKS 8
#define FOAM_STEPS 10 // a second

static double getMeanFoam(const swView* view)
{
    double sum = 0.0;
    for (int slice = 0; slice < FOAM_SLICES; ++slice)
    {
        const float* foam = swView_GetFoam(view, slice);
        for (int i = 0; i < FOAM_RESOLUTION * FOAM_RESOLUTION; ++i)
        {
            sum += (double)foam[i];
        }
    }
    return sum / (FOAM_SLICES * FOAM_RESOLUTION * FOAM_RESOLUTION);
}

double swMeasureFoam(swWorld* world, double x, double z)
{
    SW_REQUIRE(world != NULL && isfinite(x) && isfinite(z), (double)NAN, swFindHost(world),
               "swMeasureFoam() needs a world and a place in it");
    swViewDef def = swDefaultViewDef();
    def.resolution = FOAM_RESOLUTION;
    def.sliceCount = FOAM_SLICES;
    def.finestTexel = 0.5f;
    def.enableCpuLayers = true;
    swView* view = NULL;
    if (swCreateView(world, &def, &view) != SW_SUCCESS)
    {
        return (double)NAN;
    }
    swView_SetViewpoint(view, (swPos){x, swWorld_GetSeaLevel(world), z});
    double sum = 0.0;
    bool isFine = true;
    for (int step = 0; step <= (FOAM_WARM_UP + FOAM_LOOKS) * FOAM_STEPS && isFine; ++step)
    {
        isFine = swWorld_Step(world, step == 0 ? 0.0 : 1.0 / FOAM_STEPS) == SW_SUCCESS;
        bool isLook = step > FOAM_WARM_UP * FOAM_STEPS && step % FOAM_STEPS == 0;
        sum += isFine && isLook ? getMeanFoam(view) / FOAM_LOOKS : 0.0;
    }
    swDestroyView(view);
    return isFine ? sum : (double)NAN;
}
