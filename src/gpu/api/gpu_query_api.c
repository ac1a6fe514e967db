// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/field.h"
#include "core/base/misuse.h"
#include "core/frame/asked.h"
#include "gpu/record/record.h"

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

static swResult checkDef(const swHost* host, const swGpuQueryDef* def)
{
    swResult result = swCheckDef(host, swGetGpuQueryFields(), def);
    if (result == SW_SUCCESS && (def->outputs & ~getKnownOutputs(def->kind)) != 0)
    {
        return swFail(host, SW_ERROR_INVALID, "swGpuQueryDef::outputs is %u; a query of its kind has %u at most.",
                      def->outputs, getKnownOutputs(def->kind));
    }
    return result;
}

static const swHost* findQueryHost(const swGpuQuery* query)
{
    return query != NULL ? &query->gpuWorld->gpu->host : NULL;
}

static bool refuse(const swGpuQuery* query, const char* call, const char* why)
{
    swTellMisuse(findQueryHost(query), "%s(): %s", call, why);
    SW_ASSERT(!"a call is refused; the host's log says why");
    return false;
}

static bool checkPoints(const swGpuQuery* query, const char* call, swGpuQueryKind kind, int count, const void* points)
{
    if (query == NULL)
    {
        return refuse(query, call, "the query is NULL");
    }
    if (query->def.kind != kind)
    {
        return refuse(query, call, "the query is of another kind");
    }
    if (count < 0 || count > query->def.capacity)
    {
        return refuse(query, call, "the count is below 0 or above the query's capacity");
    }
    return count == 0 || points != NULL || refuse(query, call, "the points are NULL");
}

swResult swCreateGpuQuery(swGpuWorld* gpuWorld, const swGpuQueryDef* def, swGpuQuery** query)
{
    if (query != NULL)
    {
        *query = NULL;
    }
    const swHost* host = gpuWorld != NULL ? &gpuWorld->gpu->host : NULL;
    SW_REQUIRE(gpuWorld != NULL && query != NULL, SW_ERROR_INVALID, host,
               "swCreateGpuQuery() needs a swGpuWorld and a place for the query");
    SW_REQUIRE(def != NULL, SW_ERROR_INVALID, host, "swCreateGpuQuery() needs a def");
    swResult result = checkDef(host, def);
    return result == SW_SUCCESS ? swMakeGpuQuery(gpuWorld, def, query) : result;
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
    if (checkPoints(query, "swGpuQuery_SetPoints", SW_GPU_QUERY_KIND_SURFACE, count, points))
    {
        swPlaceQueryPoints(query, count, points);
    }
}

void swGpuQuery_SetPlaces(swGpuQuery* query, int count, const swPos* places)
{
    if (checkPoints(query, "swGpuQuery_SetPlaces", SW_GPU_QUERY_KIND_VOLUME, count, places))
    {
        swPlaceVolumePoints(query, count, places);
    }
}

void swGpuQuery_SetRays(swGpuQuery* query, int count, const swRay* rays)
{
    if (checkPoints(query, "swGpuQuery_SetRays", SW_GPU_QUERY_KIND_RAYS, count, rays))
    {
        swPlaceQueryRays(query, count, rays);
    }
}

void swGpuQuery_SetPointBuffer(swGpuQuery* query, int count, VkBuffer buffer, VkDeviceSize offset, swPosXZ origin)
{
    const char* call = "swGpuQuery_SetPointBuffer";
    if (!checkPoints(query, call, query != NULL ? query->def.kind : SW_GPU_QUERY_KIND_SURFACE, count, "any"))
    {
        return;
    }
    bool isSurface = query->def.kind == SW_GPU_QUERY_KIND_SURFACE;
    if (buffer == VK_NULL_HANDLE || offset % (isSurface ? sizeof(swVec2) : sizeof(float)) != 0)
    {
        refuse(query, call, "the buffer is null, or the offset no multiple of 8 (of 4 unless it is about the surface)");
        return;
    }
    if (!swIsNear(origin.x) || !swIsNear(origin.z))
    {
        refuse(query, call, "the origin is NaN or beyond SW_FARTHEST_POINT");
        return;
    }
    swBindQueryPoints(query, count, buffer, offset, origin);
}

bool swGpuQuery_GetResults(const swGpuQuery* query, swGpuQueryResults* results)
{
    if (results != NULL)
    {
        *results = (swGpuQueryResults){0};
    }
    const char* call = "swGpuQuery_GetResults";
    if (query == NULL || results == NULL)
    {
        return refuse(query, call, "the query, or where its results go, is NULL");
    }
    if (!query->def.readBack)
    {
        return refuse(query, call, "the query was made without readBack");
    }
    const swGpuQuerySlot* slot = swFindQueryAnswers(query);
    if (slot != NULL)
    {
        swFillQueryResults(query, slot, results);
    }
    return slot != NULL;
}

// Results know no host that could be told.
static bool refuseResults(swQueryStats* stats)
{
    SW_ASSERT(!"results are NULL, or samples ask for what the query has no output for");
    if (stats != NULL)
    {
        *stats = (swQueryStats){0};
    }
    return false;
}

void swGpuQueryResults_Unpack(const swGpuQueryResults* results, const swSurfaceSamples* samples, swQueryStats* stats)
{
    bool isValid = results != NULL && samples != NULL && (samples->displacement == NULL || results->sideways != NULL) &&
                   (samples->isClipped == NULL || results->stills != NULL) &&
                   ((samples->normal == NULL && samples->jacobian == NULL) || results->normals != NULL) &&
                   (samples->velocity == NULL || results->velocities != NULL) &&
                   (samples->acceleration == NULL || results->accelerations != NULL);
    if (isValid || refuseResults(stats))
    {
        swUnpackQueryResults(results, samples, stats);
    }
}

void swGpuQueryResults_UnpackVolume(const swGpuQueryResults* results, const swVolumeSamples* samples,
                                    swQueryStats* stats)
{
    bool isValid = results != NULL && samples != NULL && results->depths != NULL &&
                   (samples->velocity == NULL || results->velocities != NULL) &&
                   (samples->acceleration == NULL || results->accelerations != NULL);
    if (isValid || refuseResults(stats))
    {
        swUnpackVolumeResults(results, samples, stats);
    }
}

void swGpuQueryResults_UnpackHits(const swGpuQueryResults* results, const swRay* rays, swRayHit* hits,
                                  swQueryStats* stats)
{
    bool isValid = results != NULL && rays != NULL && hits != NULL && results->hits != NULL && results->normals != NULL;
    if (isValid || refuseResults(stats))
    {
        swUnpackHits(results, rays, hits, stats);
    }
}

swGpuQueryBuffer swGpuQuery_GetBuffer(const swGpuQuery* query)
{
    return query != NULL || refuse(query, "swGpuQuery_GetBuffer", "the query is NULL") ? query->planes
                                                                                       : (swGpuQueryBuffer){0};
}
