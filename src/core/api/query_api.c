// SPDX-License-Identifier: MIT
// A query that is refused as a whole answers NaN for every point; so does a point that cannot be answered.

#include <math.h>

#include "core/base/misuse.h"
#include "core/frame/asked.h"
#include "core/query/answers.h"
#include "core/query/query_def.h"
#include "core/query/query_surface.h"
#include "core/query/raycast.h"
#include "core/query/volume.h"
#include "core/world/moment.h"

static bool refuse(const swMoment* moment, const char* call, const char* why)
{
    swTellMisuse(moment != NULL ? moment->host : NULL, "%s(): %s", call, why);
    SW_ASSERT(!"a query is refused; the host's log says why");
    return false;
}

static bool checkDef(const swMoment* moment, const char* call, const swQueryDef* def)
{
    if (moment == NULL || def == NULL)
    {
        return refuse(moment, call, moment == NULL ? "the moment is NULL" : "the def is NULL");
    }
    char why[320];
    if (!swFields_Check(&swQueryFields, def, why, sizeof(why)))
    {
        swTellMisuse(moment->host, "%s(): %s", call, why); // numbers may come from a file: builds with asserts go on
        return false;
    }
    bool isLater = def->after == NULL || def->after->frame->ticks > moment->frame->ticks;
    return isLater || refuse(moment, call, "the def's later moment is not later");
}

static bool checkBatch(const swMoment* moment, const char* call, const swQueryDef* def, int count, bool hasArrays)
{
    if (!checkDef(moment, call, def))
    {
        return false;
    }
    if (count < 0)
    {
        return refuse(moment, call, "the count of points is below 0");
    }
    return count == 0 || hasArrays || refuse(moment, call, "the points, or where their answers go, are NULL");
}

static void beginQuery(const swMoment* moment, const swQueryDef* def, swQuery* query)
{
    swBeginQuery(query, moment->frame, moment->kernels, def, *moment->origin);
    if (def->after != NULL)
    {
        swBlendQuery(query, def->after->frame);
    }
}

void swMoment_QuerySurface(const swMoment* moment, const swQueryDef* def, int count, const swPosXZ* points,
                           const swSurfaceSamples* samples, swQueryStats* stats)
{
    if (!checkBatch(moment, "swMoment_QuerySurface", def, count, points != NULL && samples != NULL))
    {
        swRefuseSurface(count, samples, NULL, stats);
        return;
    }
    swQuery query;
    beginQuery(moment, def, &query);
    swQuerySurface(&query, count, points, samples, stats);
}

double swMoment_GetHeight(const swMoment* moment, double x, double z)
{
    swQueryDef def = swDefaultQueryDef();
    SW_REQUIRE(moment != NULL, (double)NAN, NULL, "swMoment_GetHeight() needs a moment");
    swQuery query;
    beginQuery(moment, &def, &query);
    return swFindHeight(&query, x, z);
}

void swMoment_QueryParticles(const swMoment* moment, const swQueryDef* def, int count, const swPosXZ* points,
                             const swSurfaceSamples* samples, swVec2* slopes, swQueryStats* stats)
{
    if (!checkBatch(moment, "swMoment_QueryParticles", def, count, points != NULL && samples != NULL))
    {
        swRefuseSurface(count, samples, slopes, stats);
        return;
    }
    swQuery query;
    beginQuery(moment, def, &query);
    swQueryParticles(&query, count, points, samples, slopes, stats);
}

// Points are bad one by one; a map has a size and a spacing, though.
static bool checkMap(const swMoment* moment, const swHeightMapDef* map, const float* heights)
{
    const char* call = "swMoment_QueryHeightMap";
    if (map == NULL || heights == NULL)
    {
        return refuse(moment, call, "the map, or where its heights go, is NULL");
    }
    if (map->width < 1 || map->height < 1 || map->width > INT32_MAX / map->height)
    {
        return refuse(moment, call, "the map's width or height is below 1, or it has more than 2^31 points");
    }
    return !(map->spacing <= 0.0) || refuse(moment, call, "the map's spacing is not above 0");
}

static void refuseMap(const swHeightMapDef* map, float* heights, swQueryStats* stats)
{
    bool hasSize = map != NULL && map->width >= 1 && map->height >= 1 && map->width <= INT32_MAX / map->height;
    const swSurfaceSamples samples = {.height = heights};
    swRefuseSurface(hasSize ? map->width * map->height : 0, &samples, NULL, stats);
}

void swMoment_QueryHeightMap(const swMoment* moment, const swQueryDef* def, const swHeightMapDef* map, float* heights,
                             swQueryStats* stats)
{
    if (!checkDef(moment, "swMoment_QueryHeightMap", def) || !checkMap(moment, map, heights))
    {
        refuseMap(map, heights, stats);
        return;
    }
    swQuery query;
    beginQuery(moment, def, &query);
    swQueryHeightMap(&query, map, heights, stats);
}

void swMoment_QueryVolume(const swMoment* moment, const swQueryDef* def, int count, const swPos* points,
                          const swVolumeSamples* samples, swQueryStats* stats)
{
    if (!checkBatch(moment, "swMoment_QueryVolume", def, count, points != NULL && samples != NULL))
    {
        swRefuseVolume(count, samples, stats);
        return;
    }
    swQuery query;
    beginQuery(moment, def, &query);
    swQueryVolume(&query, count, points, samples, stats);
}

swVec2 swMoment_GetStokesDrift(const swMoment* moment, double depthBelow)
{
    swQueryDef def = swDefaultQueryDef();
    if (!checkDef(moment, "swMoment_GetStokesDrift", &def) || !(depthBelow >= 0.0))
    {
        return (swVec2){SW_NO_NUMBER, SW_NO_NUMBER};
    }
    swQuery query;
    beginQuery(moment, &def, &query);
    return swFindStokesDrift(&query, depthBelow);
}

void swMoment_CastRays(const swMoment* moment, const swQueryDef* def, int count, const swRay* rays, swRayHit* hits,
                       swQueryStats* stats)
{
    if (!checkBatch(moment, "swMoment_CastRays", def, count, rays != NULL && hits != NULL))
    {
        swRefuseRays(count, hits, stats);
        return;
    }
    swQuery query;
    beginQuery(moment, def, &query);
    swCastRays(&query, count, rays, hits, stats);
}
