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

// Comparisons are written so that NaN fails them.
static bool isDefValid(const swGpuQueryDef* def)
{
    const uint32_t known =
        SW_GPU_QUERY_SIDEWAYS | SW_GPU_QUERY_NORMAL | SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION;
    return def != NULL && def->internalValue == SW_DEF_COOKIE && def->capacity >= 1 &&
           def->capacity <= SW_MAX_QUERY_POINTS && (def->outputs & ~known) == 0 && def->minWavelength >= 0.0f &&
           def->tolerance >= 1e-5f && def->maxIterations >= 1 && def->maxIterations <= 64;
}

static bool isPlaceValid(swPosXZ place)
{
    return fabs(place.x) <= SW_FARTHEST_POINT && fabs(place.z) <= SW_FARTHEST_POINT;
}

// Near enough to the first, too: cells are counted in 32 bits.
static bool arePointsValid(const swGpuQuery* query, int count, const swPosXZ* points)
{
    const double farthest = 1e11;
    bool isValid = query != NULL && count >= 0 && count <= query->def.capacity && (count == 0 || points != NULL);
    for (int i = 0; i < count && isValid; ++i)
    {
        isValid = isPlaceValid(points[i]) && fabs(points[i].x - points[0].x) < farthest &&
                  fabs(points[i].z - points[0].z) < farthest;
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

void swGpuQuery_SetPointBuffer(swGpuQuery* query, int count, VkBuffer buffer, VkDeviceSize offset, swPosXZ origin)
{
    bool isValid = query != NULL && count >= 0 && count <= query->def.capacity && buffer != VK_NULL_HANDLE &&
                   offset % sizeof(swVec2) == 0 && isPlaceValid(origin);
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

swGpuQueryBuffer swGpuQuery_GetBuffer(const swGpuQuery* query)
{
    SW_ASSERT(query != NULL);
    return query != NULL ? query->planes : (swGpuQueryBuffer){0};
}
