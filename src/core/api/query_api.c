// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/assert.h"
#include "core/base/host.h"
#include "core/query/raycast.h"
#include "core/query/sample.h"
#include "core/query/volume.h"
#include "core/world/world.h"

swQueryDef swDefaultQueryDef(void)
{
    return (swQueryDef){
        .tolerance = 0.0005f,
        .maxIterations = 24,
        .time = SW_QUERY_NOW,
        .stretching = SW_STRETCHING_WHEELER,
        .internalValue = SW_DEF_COOKIE,
    };
}

// Points beyond this have a spacing of doubles above 0.1 mm.
#define SW_FARTHEST_POINT 1e12

// Comparisons are written so that NaN fails them.
static bool isNear(double x)
{
    return fabs(x) <= SW_FARTHEST_POINT;
}

static bool isDefValid(const swWorld* world, const swQueryDef* def)
{
    return world != NULL && def != NULL && def->internalValue == SW_DEF_COOKIE && def->minWavelength >= 0.0f &&
           def->tolerance >= 1e-6f && def->maxIterations >= 1 && def->maxIterations <= 64 &&
           (def->time == SW_QUERY_NOW || fabs(def->time) <= SW_LARGEST_TIME) &&
           (def->stretching == SW_STRETCHING_WHEELER || def->stretching == SW_STRETCHING_LINEAR);
}

static bool arePointsValid(int count, const swPosXZ* points)
{
    bool isValid = count == 0 || (count > 0 && points != NULL);
    for (int i = 0; i < count && isValid; ++i)
    {
        isValid = isNear(points[i].x) && isNear(points[i].z);
    }
    return isValid;
}

static void beginQuery(const swWorld* world, const swQueryDef* def, swQuery* query)
{
    swBeginQuery(query, &world->frame, world->kernels, def, world->origin);
}

void swWorld_QuerySurface(const swWorld* world, const swQueryDef* def, int count, const swPosXZ* points,
                          const swSurfaceSamples* samples, swQueryStats* stats)
{
    bool isValid = isDefValid(world, def) && samples != NULL && arePointsValid(count, points);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swQuery query;
        beginQuery(world, def, &query);
        swQuerySurface(&query, count, points, samples, stats);
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
    bool isValid = isDefValid(world, def) && samples != NULL && arePointsValid(count, points);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swQuery query;
        beginQuery(world, def, &query);
        swQueryParticles(&query, count, points, samples, slopes);
    }
}

void swWorld_QueryHeightMap(const swWorld* world, const swQueryDef* def, const swHeightMapDef* map, float* heights,
                            swQueryStats* stats)
{
    bool isValid = isDefValid(world, def) && map != NULL && heights != NULL && isNear(map->originX) &&
                   isNear(map->originZ) && map->spacing > 0.0 && map->width >= 1 && map->height >= 1 &&
                   isNear(map->spacing * map->width) && isNear(map->spacing * map->height);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swQuery query;
        beginQuery(world, def, &query);
        swQueryHeightMap(&query, map, heights, stats);
    }
}

void swWorld_QueryVolume(const swWorld* world, const swQueryDef* def, int count, const swPos* points,
                         const swVolumeSamples* samples)
{
    bool isValid = isDefValid(world, def) && samples != NULL && (count == 0 || (count > 0 && points != NULL));
    for (int i = 0; i < count && isValid; ++i)
    {
        isValid = isNear(points[i].x) && isNear(points[i].y) && isNear(points[i].z);
    }
    SW_ASSERT(isValid);
    if (isValid)
    {
        swQuery query;
        beginQuery(world, def, &query);
        swQueryVolume(&query, count, points, samples);
    }
}

swVec2 swWorld_GetStokesDrift(const swWorld* world, double depthBelow)
{
    bool isValid = world != NULL && depthBelow >= 0.0;
    SW_ASSERT(isValid);
    if (!isValid)
    {
        return (swVec2){0.0f, 0.0f};
    }
    swQueryDef def = swDefaultQueryDef();
    swQuery query;
    beginQuery(world, &def, &query);
    return swFindStokesDrift(&query, depthBelow);
}

swRay swDefaultRay(swPos origin, swVec3 direction)
{
    return (swRay){.origin = origin, .direction = direction, .maxDistance = 1000.0f, .internalValue = SW_DEF_COOKIE};
}

static bool isRayValid(const swRay* ray)
{
    const swVec3* d = &ray->direction;
    float square = d->x * d->x + d->y * d->y + d->z * d->z;
    return ray->internalValue == SW_DEF_COOKIE && isNear(ray->origin.x) && isNear(ray->origin.y) &&
           isNear(ray->origin.z) && square > 0.0f && square < INFINITY && ray->maxDistance >= 0.0f &&
           ray->maxDistance <= 1e5f && ray->radius >= 0.0f && ray->radius <= 100.0f && ray->duration >= 0.0f &&
           ray->duration <= 3600.0f;
}

void swWorld_CastRays(const swWorld* world, const swQueryDef* def, int count, const swRay* rays, swRayHit* hits)
{
    bool isValid = isDefValid(world, def) && (count == 0 || (count > 0 && rays != NULL && hits != NULL));
    for (int i = 0; i < count && isValid; ++i)
    {
        isValid = isRayValid(&rays[i]);
    }
    SW_ASSERT(isValid);
    if (isValid)
    {
        swQuery query;
        beginQuery(world, def, &query);
        swCastRays(&query, count, rays, hits);
    }
}
