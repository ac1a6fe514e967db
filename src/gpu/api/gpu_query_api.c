// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/assert.h"
#include "gpu/record/record.h"

#define SW_MAX_QUERY_POINTS (1 << 22)

// As in query_api.c.
#define SW_FARTHEST_POINT 1e12

swGpuQueryDef swDefaultGpuQueryDef(void)
{
    return (swGpuQueryDef){
        .capacity = 1024,
        .tolerance = 0.0005f,
        .maxIterations = 24,
        .readBack = true,
        .internalValue = SW_DEF_COOKIE,
    };
}

static uint32_t getKnownOutputs(swGpuQueryKind kind)
{
    const uint32_t motion = SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION;
    const uint32_t known[] = {
        [SW_GPU_QUERY_KIND_SURFACE] = SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL | motion,
        [SW_GPU_QUERY_KIND_VOLUME] = motion,
        [SW_GPU_QUERY_KIND_RAYS] = SW_GPU_QUERY_NORMAL,
    };
    return known[kind];
}

// Comparisons are written so that NaN fails them.
static bool isDefValid(const swGpuQueryDef* def)
{
    return def != NULL && def->internalValue == SW_DEF_COOKIE && def->capacity >= 1 &&
           def->capacity <= SW_MAX_QUERY_POINTS && def->kind <= SW_GPU_QUERY_KIND_RAYS &&
           (def->outputs & ~getKnownOutputs(def->kind)) == 0 && def->stretching <= SW_STRETCHING_LINEAR &&
           def->minWavelength >= 0.0f && def->tolerance >= 1e-5f && def->maxIterations >= 1 && def->maxIterations <= 64;
}

static bool isPlaceValid(swPosXZ place)
{
    return fabs(place.x) <= SW_FARTHEST_POINT && fabs(place.z) <= SW_FARTHEST_POINT;
}

static bool isCountValid(const swGpuQuery* query, swGpuQueryKind kind, int count)
{
    return query != NULL && query->def.kind == kind && count >= 0 && count <= query->def.capacity;
}

// Near enough to the first, too: cells are counted in 32 bits.
static bool isNearFirst(swPosXZ place, swPosXZ first)
{
    const double farthest = 1e11;
    return isPlaceValid(place) && fabs(place.x - first.x) < farthest && fabs(place.z - first.z) < farthest;
}

static bool arePointsValid(const swGpuQuery* query, int count, const swPosXZ* points)
{
    bool isValid = isCountValid(query, SW_GPU_QUERY_KIND_SURFACE, count) && (count == 0 || points != NULL);
    for (int i = 0; i < count && isValid; ++i)
    {
        isValid = isNearFirst(points[i], points[0]);
    }
    return isValid;
}

static bool arePlacesValid(const swGpuQuery* query, int count, const swPos* places)
{
    bool isValid = isCountValid(query, SW_GPU_QUERY_KIND_VOLUME, count) && (count == 0 || places != NULL);
    for (int i = 0; i < count && isValid; ++i)
    {
        isValid = fabs(places[i].y) <= SW_FARTHEST_POINT &&
                  isNearFirst((swPosXZ){places[i].x, places[i].z}, (swPosXZ){places[0].x, places[0].z});
    }
    return isValid;
}

// As isRayValid() in query_api.c, of a surface that stands still.
static bool isRayValid(const swRay* ray)
{
    const swVec3* d = &ray->direction;
    float square = d->x * d->x + d->y * d->y + d->z * d->z;
    return ray->internalValue == SW_DEF_COOKIE && fabs(ray->origin.y) <= SW_FARTHEST_POINT && square > 0.0f &&
           square < INFINITY && ray->maxDistance >= 0.0f && ray->maxDistance <= 1e5f && ray->radius >= 0.0f &&
           ray->radius <= 100.0f && ray->duration == 0.0f;
}

static bool areRaysValid(const swGpuQuery* query, int count, const swRay* rays)
{
    bool isValid = isCountValid(query, SW_GPU_QUERY_KIND_RAYS, count) && (count == 0 || rays != NULL);
    for (int i = 0; i < count && isValid; ++i)
    {
        swPosXZ first = {rays[0].origin.x, rays[0].origin.z};
        isValid = isRayValid(&rays[i]) && isNearFirst((swPosXZ){rays[i].origin.x, rays[i].origin.z}, first);
    }
    return isValid;
}

swResult swCreateGpuQuery(swGpuWorld* gpuWorld, const swGpuQueryDef* def, swGpuQuery** query)
{
    bool isValid = gpuWorld != NULL && query != NULL && isDefValid(def);
    SW_ASSERT(isValid);
    if (query != NULL)
    {
        *query = NULL;
    }
    return isValid ? swMakeGpuQuery(gpuWorld, def, query) : SW_ERROR_INVALID;
}

void swDestroyGpuQuery(swGpuQuery* query)
{
    if (query != NULL)
    {
        swFreeGpuQuery(query);
    }
}

void swGpuQuery_SetPoints(swGpuQuery* query, int count, const swPosXZ* points)
{
    bool isValid = arePointsValid(query, count, points);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swPlaceQueryPoints(query, count, points);
    }
}

void swGpuQuery_SetPlaces(swGpuQuery* query, int count, const swPos* places)
{
    bool isValid = arePlacesValid(query, count, places);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swPlaceVolumePoints(query, count, places);
    }
}

void swGpuQuery_SetRays(swGpuQuery* query, int count, const swRay* rays)
{
    bool isValid = areRaysValid(query, count, rays);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swPlaceQueryRays(query, count, rays);
    }
}

void swGpuQuery_SetPointBuffer(swGpuQuery* query, int count, VkBuffer buffer, VkDeviceSize offset, swPosXZ origin)
{
    bool isValid = query != NULL && count >= 0 && count <= query->def.capacity && buffer != VK_NULL_HANDLE &&
                   offset % (query->def.kind == SW_GPU_QUERY_KIND_SURFACE ? sizeof(swVec2) : sizeof(float)) == 0 &&
                   isPlaceValid(origin);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swBindQueryPoints(query, count, buffer, offset, origin);
    }
}

bool swGpuQuery_GetResults(const swGpuQuery* query, swGpuQueryResults* results)
{
    bool isValid = query != NULL && results != NULL && query->def.readBack;
    SW_ASSERT(isValid);
    const swGpuQuerySlot* slot = isValid ? swFindQueryAnswers(query) : NULL;
    if (slot != NULL)
    {
        swFillQueryResults(query, slot, results);
    }
    return slot != NULL;
}

void swGpuQueryResults_Unpack(const swGpuQueryResults* results, const swSurfaceSamples* samples, swQueryStats* stats)
{
    bool isValid = results != NULL && samples != NULL && (samples->displacement == NULL || results->sideways != NULL) &&
                   ((samples->normal == NULL && samples->jacobian == NULL) || results->normals != NULL) &&
                   (samples->velocity == NULL || results->velocities != NULL) &&
                   (samples->acceleration == NULL || results->accelerations != NULL);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swUnpackQueryResults(results, samples, stats);
    }
}

void swGpuQueryResults_UnpackVolume(const swGpuQueryResults* results, const swVolumeSamples* samples)
{
    bool isValid = results != NULL && samples != NULL && results->depths != NULL &&
                   (samples->velocity == NULL || results->velocities != NULL) &&
                   (samples->acceleration == NULL || results->accelerations != NULL);
    SW_ASSERT(isValid);
    if (isValid)
    {
        swUnpackVolumeResults(results, samples);
    }
}

void swGpuQueryResults_UnpackHits(const swGpuQueryResults* results, const swRay* rays, swRayHit* hits)
{
    bool isValid = results != NULL && rays != NULL && hits != NULL && results->hits != NULL && results->normals != NULL;
    SW_ASSERT(isValid);
    if (isValid)
    {
        swUnpackHits(results, rays, hits);
    }
}

swGpuQueryBuffer swGpuQuery_GetBuffer(const swGpuQuery* query)
{
    SW_ASSERT(query != NULL);
    return query != NULL ? query->planes : (swGpuQueryBuffer){0};
}
