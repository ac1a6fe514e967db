// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/assert.h"
#include "core/base/host.h"
#include "core/query/sample.h"
#include "core/world/world.h"

swQueryDef swDefaultQueryDef(void)
{
    return (swQueryDef){.tolerance = 0.0005f, .maxIterations = 24, .internalValue = SW_DEF_COOKIE};
}

// Points beyond this have a spacing of doubles above 0.1 mm.
#define SW_FARTHEST_POINT 1e12

static bool areArgumentsValid(const swWorld* world, const swQueryDef* def, int count, const swPosXZ* points,
                              const swSurfaceSamples* samples)
{
    if (world == NULL || def == NULL || def->internalValue != SW_DEF_COOKIE || samples == NULL || count < 0 ||
        (points == NULL && count > 0))
    {
        return false;
    }
    if (!(def->minWavelength >= 0.0f && def->tolerance > 0.0f) || def->maxIterations < 1 || def->maxIterations > 64)
    {
        return false;
    }
    for (int i = 0; i < count; ++i)
    {
        if (!(fabs(points[i].x) <= SW_FARTHEST_POINT && fabs(points[i].z) <= SW_FARTHEST_POINT))
        {
            return false;
        }
    }
    return true;
}

void swWorld_QuerySurface(const swWorld* world, const swQueryDef* def, int count, const swPosXZ* points,
                          const swSurfaceSamples* samples, swQueryStats* stats)
{
    bool isValid = areArgumentsValid(world, def, count, points, samples);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swQuerySurface(&world->frame, world->kernels, def, count, points, samples, stats);
    }
}

double swWorld_GetHeight(const swWorld* world, double x, double z)
{
    swQueryDef def = swDefaultQueryDef();
    swPosXZ point = {x, z};
    swVec3 displacement = {0.0f, 0.0f, 0.0f};
    swSurfaceSamples samples = {.displacement = &displacement};
    swWorld_QuerySurface(world, &def, 1, &point, &samples, NULL);
    return world->def.seaLevel + (double)displacement.y;
}

void swWorld_QueryParticles(const swWorld* world, const swQueryDef* def, int count, const swPosXZ* points,
                            const swSurfaceSamples* samples, swVec2* slopes)
{
    bool isValid = areArgumentsValid(world, def, count, points, samples);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swQueryParticles(&world->frame, world->kernels, def, count, points, samples, slopes);
    }
}
