// SPDX-License-Identifier: MIT
// Queries on the GPU, from the host's side: points go in, answers come back some frames later with the stamp of the
// frame that they belong to. Nothing here waits.
//
// A frame is known to be done when the host has said so, or when a later one is being recorded that the contract of
// swGpuDef::framesInFlight puts behind it. Points and copies of answers therefore lie in framesInFlight + 1 slots, used
// in turn: while the frames in flight have theirs, one more holds the newest answers that have arrived, or takes new
// points.

#include <math.h>
#include <string.h>

#include "core/frame/asked.h"
#include "gpu/pass/passes.h"
#include "gpu/query/gpu_query.h"

// Of a plane or a slot; suits any device's storage buffer offsets.
static VkDeviceSize alignPlane(VkDeviceSize size)
{
    return (size + 255) / 256 * 256;
}

// ---- making and freeing ----

#define PLANES 8

// What a query's buffer of answers may hold, in order.
typedef struct Plane
{
    bool isWanted;
    size_t size; // of one answer
    VkDeviceSize* at;
} Plane;

static void listPlanes(swGpuQuery* query, Plane list[PLANES])
{
    uint32_t outputs = query->def.outputs;
    swGpuQueryBuffer* planes = &query->planes;
    list[0] = (Plane){true, sizeof(swGpuHeight), &planes->heights};
    list[1] = (Plane){query->def.kind == SW_GPU_QUERY_KIND_VOLUME, sizeof(swGpuDepth), &planes->depths};
    list[2] = (Plane){query->def.kind == SW_GPU_QUERY_KIND_RAYS, sizeof(swGpuHit), &planes->hits};
    list[3] = (Plane){(outputs & SW_GPU_QUERY_SIDEWAYS) != 0, sizeof(swVec2), &planes->sideways};
    list[4] = (Plane){list[1].isWanted || list[3].isWanted, sizeof(swGpuStill), &planes->stills};
    list[5] = (Plane){(outputs & SW_GPU_QUERY_NORMAL) != 0, sizeof(swVec4), &planes->normals};
    list[6] = (Plane){(outputs & SW_GPU_QUERY_VELOCITY) != 0, sizeof(swVec4), &planes->velocities};
    list[7] = (Plane){(outputs & SW_GPU_QUERY_ACCELERATION) != 0, sizeof(swVec4), &planes->accelerations};
}

static void layOutPlanes(swGpuQuery* query)
{
    Plane planes[PLANES];
    listPlanes(query, planes);
    for (int i = 0; i < PLANES; ++i)
    {
        if (planes[i].isWanted)
        {
            *planes[i].at = query->answerSize;
            query->answerSize += alignPlane((VkDeviceSize)query->def.capacity * planes[i].size);
        }
    }
}

static swResult createQueryBuffers(swGpuQuery* query)
{
    swGpu* gpu = query->gpuWorld->gpu;
    const VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    VkDeviceSize slots = (VkDeviceSize)query->slotCount;
    VkDeviceSize capacity = (VkDeviceSize)query->def.capacity;
    bool isRays = query->def.kind == SW_GPU_QUERY_KIND_RAYS;
    VkDeviceSize pointSize = alignPlane(capacity * (isRays ? sizeof(swQueryRay) : sizeof(swQueryPoint)));
    if (pointSize > gpu->properties.limits.maxStorageBufferRange)
    {
        return swFail(&gpu->host, SW_ERROR_LIMIT, "%s binds at most %.0f bytes at once, and %d points are %.0f",
                      gpu->properties.deviceName, (double)gpu->properties.limits.maxStorageBufferRange,
                      query->def.capacity, (double)pointSize);
    }
    if (query->def.kind == SW_GPU_QUERY_KIND_VOLUME)
    {
        query->levelsAt = pointSize;
        pointSize += alignPlane(capacity * sizeof(float));
    }
    swResult result = swCreateBuffer(gpu, slots * pointSize, storage, SW_MEMORY_UPLOAD, "query points", &query->points);
    if (result == SW_SUCCESS)
    {
        result = swCreateBuffer(gpu, query->answerSize, storage, SW_MEMORY_DEVICE, "query answers", &query->answers);
    }
    if (result == SW_SUCCESS && query->def.readBack)
    {
        result = swCreateBuffer(gpu, slots * query->answerSize, 0, SW_MEMORY_READBACK, "query answers for the host",
                                &query->copies);
    }
    query->planes.buffer = query->answers.handle;
    return result;
}

static swResult createPipelines(swGpuWorld* gpuWorld, const swGpuQueryDef* def)
{
    switch (def->kind)
    {
    case SW_GPU_QUERY_KIND_RAYS:
        return swCreatePass(gpuWorld, SW_PASS_RAY_QUERY);
    case SW_GPU_QUERY_KIND_SURFACE:
        return swCreatePass(gpuWorld, SW_PASS_SURFACE_QUERY);
    case SW_GPU_QUERY_KIND_VOLUME:
        break;
    }
    swResult result = swCreatePass(gpuWorld, SW_PASS_SURFACE_QUERY);
    result = result == SW_SUCCESS ? swCreatePass(gpuWorld, SW_PASS_VOLUME_WAVES) : result;
    return result == SW_SUCCESS ? swCreatePass(gpuWorld, SW_PASS_VOLUME_QUERY) : result;
}

static void linkQuery(swGpuQuery* query)
{
    swGpuWorld* gpuWorld = query->gpuWorld;
    query->next = gpuWorld->firstQuery;
    if (query->next != NULL)
    {
        query->next->previous = query;
    }
    gpuWorld->firstQuery = query;
}

static void unlinkQuery(swGpuQuery* query)
{
    if (query->next != NULL)
    {
        query->next->previous = query->previous;
    }
    if (query->previous != NULL)
    {
        query->previous->next = query->next;
    }
    else
    {
        query->gpuWorld->firstQuery = query->next;
    }
}

swResult swMakeGpuQuery(swGpuWorld* gpuWorld, const swGpuQueryDef* def, swGpuQuery** out)
{
    swGpu* gpu = gpuWorld->gpu;
    swGpuQuery* query = swAllocateZero(&gpu->host, sizeof(swGpuQuery));
    if (query == NULL)
    {
        return swFail(&gpu->host, SW_ERROR_NO_MEMORY, "no memory for a swGpuQuery");
    }
    query->gpuWorld = gpuWorld;
    query->def = *def;
    query->slotCount = gpu->framesInFlight + 1;
    linkQuery(query);
    layOutPlanes(query);
    swResult result = createPipelines(gpuWorld, def);
    result = result == SW_SUCCESS ? createQueryBuffers(query) : result;
    if (result != SW_SUCCESS)
    {
        swFreeGpuQuery(query);
        return result;
    }
    *out = query;
    return SW_SUCCESS;
}

void swFreeGpuQuery(swGpuQuery* query)
{
    swGpu* gpu = query->gpuWorld->gpu;
    unlinkQuery(query);
    swRetireBuffer(gpu, &query->points);
    swRetireBuffer(gpu, &query->answers);
    swRetireBuffer(gpu, &query->copies);
    swFree(&gpu->host, query, sizeof(swGpuQuery));
}

size_t swGetQueryMemory(const swGpuQuery* query)
{
    return (size_t)(query->points.memory.size + query->answers.memory.size + query->copies.memory.size);
}

// ---- points ----

// Cells count from a corner of a cell near the first point, so that their numbers stay small.
static swPosXZ chooseOrigin(swPosXZ point)
{
    const double cell = (double)SW_QUERY_CELL;
    return (swPosXZ){floor(point.x / cell) * cell, floor(point.z / cell) * cell};
}

static void splitPlace(double metres, float* rest, int32_t* cell)
{
    const double side = (double)SW_QUERY_CELL;
    double whole = floor(metres / side);
    *rest = (float)(metres - whole * side); // may round up to a whole cell: the shader does not mind
    *cell = (int32_t)whole;
}

// Cells are counted in 32 bits: a point must be near the first one, too. Comparisons are written so that NaN fails
// them.
static bool canPlace(const swGpuQuery* query, double x, double z)
{
    return swIsNear(x) && swIsNear(z) && fabs(x - query->origin.x) <= (double)SW_QUERY_FARTHEST &&
           fabs(z - query->origin.z) <= (double)SW_QUERY_FARTHEST;
}

static swQueryPoint placePoint(const swGpuQuery* query, double x, double z)
{
    if (!canPlace(query, x, z))
    {
        return (swQueryPoint){.cellX = SW_QUERY_NOWHERE};
    }
    swQueryPoint point;
    splitPlace(x - query->origin.x, &point.x, &point.cellX);
    splitPlace(z - query->origin.z, &point.z, &point.cellZ);
    return point;
}

// A slot for new points, which begin near `first`.
static uint8_t* beginPoints(swGpuQuery* query, int count, swPosXZ first)
{
    if (query->isPointSlotUsed)
    {
        query->pointSlot = (query->pointSlot + 1) % query->slotCount;
        query->isPointSlotUsed = false;
    }
    query->count = count;
    query->pointsVersion += 1;
    query->hostPoints = VK_NULL_HANDLE;
    query->origin = chooseOrigin(first);
    size_t slotSize = (size_t)query->points.size / (size_t)query->slotCount;
    return (uint8_t*)query->points.mapped + slotSize * (size_t)query->pointSlot;
}

void swPlaceQueryPoints(swGpuQuery* query, int count, const swPosXZ* points)
{
    swPosXZ first = {0.0, 0.0};
    for (int i = count - 1; i >= 0; --i)
    {
        first = swIsNear(points[i].x) && swIsNear(points[i].z) ? points[i] : first;
    }
    swQueryPoint* to = (swQueryPoint*)beginPoints(query, count, first);
    for (int i = 0; i < count; ++i)
    {
        to[i] = placePoint(query, points[i].x, points[i].z);
    }
}

static bool isPlaceNear(swPos place)
{
    return swIsNear(place.x) && swIsNear(place.y) && swIsNear(place.z);
}

void swPlaceVolumePoints(swGpuQuery* query, int count, const swPos* places)
{
    swPos first = {0.0, 0.0, 0.0};
    for (int i = count - 1; i >= 0; --i)
    {
        first = isPlaceNear(places[i]) ? places[i] : first;
    }
    uint8_t* slot = beginPoints(query, count, (swPosXZ){first.x, first.z});
    swQueryPoint* points = (swQueryPoint*)slot;
    float* levels = (float*)(slot + query->levelsAt);
    query->level = floor(first.y);
    for (int i = 0; i < count; ++i)
    {
        double y = places[i].y;
        points[i] = placePoint(query, swIsNear(y) ? places[i].x : (double)NAN, places[i].z);
        levels[i] = swIsNear(y) ? (float)(y - query->level) : 0.0f;
    }
}

// Of a surface that stands still.
static bool isRayGood(const swRay* ray)
{
    return swIsRayGood(ray) && ray->duration == 0.0f;
}

static swQueryRay placeRay(const swGpuQuery* query, const swRay* ray)
{
    if (!isRayGood(ray))
    {
        return (swQueryRay){.cellX = SW_QUERY_NOWHERE};
    }
    swQueryPoint point = placePoint(query, ray->origin.x, ray->origin.z);
    double x = (double)ray->direction.x, y = (double)ray->direction.y, z = (double)ray->direction.z;
    double length = swGetRayLength(ray);
    return (swQueryRay){
        .x = point.x,
        .z = point.z,
        .cellX = point.cellX,
        .cellZ = point.cellZ,
        .y = (float)(ray->origin.y - query->level),
        .wayX = (float)(x / length),
        .wayY = (float)(y / length),
        .wayZ = (float)(z / length),
        .longest = ray->maxDistance,
        .radius = ray->radius,
    };
}

void swPlaceQueryRays(swGpuQuery* query, int count, const swRay* rays)
{
    swPos first = {0.0, 0.0, 0.0};
    for (int i = count - 1; i >= 0; --i)
    {
        first = isRayGood(&rays[i]) ? rays[i].origin : first;
    }
    swQueryRay* to = (swQueryRay*)beginPoints(query, count, (swPosXZ){first.x, first.z});
    query->level = floor(first.y);
    for (int i = 0; i < count; ++i)
    {
        to[i] = placeRay(query, &rays[i]);
    }
}

void swBindQueryPoints(swGpuQuery* query, int count, VkBuffer buffer, VkDeviceSize offset, swPosXZ origin)
{
    query->count = count;
    query->pointsVersion += 1;
    query->hostPoints = buffer;
    query->hostOffset = offset;
    query->level = 0.0;
    query->origin = origin;
}

// ---- answers ----

static int findNextSlot(const swGpuQuery* query)
{
    return (query->answerSlot + 1) % query->slotCount;
}

// To the slot that swCommitQueries() takes.
static void copyAnswers(swGpuQuery* query, VkCommandBuffer commands)
{
    swGpu* gpu = query->gpuWorld->gpu;
    VkDeviceSize to = query->answerSize * (VkDeviceSize)findNextSlot(query);
    Plane planes[PLANES];
    listPlanes(query, planes);
    VkBufferCopy copies[PLANES];
    uint32_t count = 0;
    for (int i = 0; i < PLANES; ++i)
    {
        if (planes[i].isWanted)
        {
            VkDeviceSize at = *planes[i].at;
            copies[count++] = (VkBufferCopy){at, to + at, (VkDeviceSize)query->count * planes[i].size};
        }
    }
    gpu->vk.CmdCopyBuffer(commands, query->answers.handle, query->copies.handle, count, copies);
}

static void stampQuery(swGpuQuery* query, const swFrame* frame)
{
    query->isPointSlotUsed = query->isPointSlotUsed || query->hostPoints == VK_NULL_HANDLE;
    query->answerSlot = findNextSlot(query);
    query->slots[query->answerSlot] = (swGpuQuerySlot){
        .isRecorded = true,
        .frameIndex = query->gpuWorld->gpu->frameIndex,
        .time = frame->time,
        .seaLevel = frame->seaLevel,
        .pointsVersion = query->pointsVersion,
        .count = query->count,
    };
}

static bool hasAnswers(const swGpuQuery* query)
{
    return query->count > 0 && query->def.readBack;
}

bool swHasAnswers(const swGpuWorld* gpuWorld)
{
    const swGpuQuery* query = gpuWorld->firstQuery;
    while (query != NULL && !hasAnswers(query))
    {
        query = query->next;
    }
    return query != NULL;
}

void swCopyAnswers(swGpuWorld* gpuWorld, VkCommandBuffer commands)
{
    for (swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        if (hasAnswers(query))
        {
            copyAnswers(query, commands);
        }
    }
}

void swCommitQueries(swGpuWorld* gpuWorld, const swFrame* frame)
{
    for (swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        if (query->count > 0)
        {
            stampQuery(query, frame);
        }
    }
}

void swDiscardQueries(swGpuWorld* gpuWorld, uint64_t frameIndex)
{
    for (swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        for (int i = 0; i < query->slotCount; ++i)
        {
            query->slots[i].isRecorded = query->slots[i].isRecorded && query->slots[i].frameIndex < frameIndex;
        }
    }
}

static bool isFinished(const swGpu* gpu, uint64_t frameIndex)
{
    return (gpu->hasFinished && frameIndex <= gpu->finishedFrame) ||
           frameIndex + (uint64_t)gpu->framesInFlight <= gpu->frameIndex;
}

const swGpuQuerySlot* swFindQueryAnswers(const swGpuQuery* query)
{
    for (int back = 0; back < query->slotCount; ++back)
    {
        const swGpuQuerySlot* slot = &query->slots[(query->answerSlot + query->slotCount - back) % query->slotCount];
        if (slot->isRecorded && isFinished(query->gpuWorld->gpu, slot->frameIndex))
        {
            return slot;
        }
    }
    return NULL;
}

void swFillQueryResults(const swGpuQuery* query, const swGpuQuerySlot* slot, swGpuQueryResults* results)
{
    const uint8_t* data = (const uint8_t*)query->copies.mapped + query->answerSize * (size_t)(slot - query->slots);
    const swGpuQueryBuffer* planes = &query->planes;
    *results = (swGpuQueryResults){
        .frameIndex = slot->frameIndex,
        .time = slot->time,
        .seaLevel = slot->seaLevel,
        .pointsVersion = slot->pointsVersion,
        .count = slot->count,
        .tolerance = query->def.tolerance,
        .heights = (const swGpuHeight*)(data + planes->heights),
        .depths = planes->depths != 0 ? (const swGpuDepth*)(data + planes->depths) : NULL,
        .hits = planes->hits != 0 ? (const swGpuHit*)(data + planes->hits) : NULL,
        .sideways = planes->sideways != 0 ? (const swVec2*)(data + planes->sideways) : NULL,
        .stills = planes->stills != 0 ? (const swGpuStill*)(data + planes->stills) : NULL,
        .normals = planes->normals != 0 ? (const swVec4*)(data + planes->normals) : NULL,
        .velocities = planes->velocities != 0 ? (const swVec4*)(data + planes->velocities) : NULL,
        .accelerations = planes->accelerations != 0 ? (const swVec4*)(data + planes->accelerations) : NULL,
    };
}

static swVec3 takeVector(swVec4 v)
{
    return (swVec3){v.x, v.y, v.z};
}

static void unpackOne(const swGpuQueryResults* results, int i, const swSurfaceSamples* samples)
{
    swGpuHeight height = results->heights[i];
    if (samples->height != NULL)
    {
        samples->height[i] = (float)(results->seaLevel + (double)height.height);
    }
    if (samples->residual != NULL)
    {
        samples->residual[i] = height.residual;
    }
    if (samples->displacement != NULL)
    {
        float y = height.height - results->stills[i].level;
        samples->displacement[i] = (swVec3){results->sideways[i].x, y, results->sideways[i].y};
    }
    if (samples->isClipped != NULL)
    {
        samples->isClipped[i] = results->stills[i].hole < 0.0f; // not of a bad point
    }
    if (samples->normal != NULL)
    {
        samples->normal[i] = takeVector(results->normals[i]);
    }
    if (samples->jacobian != NULL)
    {
        samples->jacobian[i] = results->normals[i].w;
    }
    if (samples->velocity != NULL)
    {
        samples->velocity[i] = takeVector(results->velocities[i]);
    }
    if (samples->acceleration != NULL)
    {
        samples->acceleration[i] = takeVector(results->accelerations[i]);
    }
}

// Bad points are told by their answers, which are NaN.
static void tellAnswers(const swGpuQueryResults* results, swQueryStats* stats)
{
    swQueryStats total = {0};
    for (int i = 0; i < results->count; ++i)
    {
        float residual = results->heights[i].residual;
        total.badCount += isnan(residual) ? 1 : 0;
        total.convergedCount += residual <= results->tolerance ? 1 : 0;
        total.worstResidual = residual > total.worstResidual ? residual : total.worstResidual;
    }
    if (stats != NULL)
    {
        *stats = total;
    }
}

void swUnpackQueryResults(const swGpuQueryResults* results, const swSurfaceSamples* samples, swQueryStats* stats)
{
    for (int i = 0; i < results->count; ++i)
    {
        unpackOne(results, i, samples);
    }
    tellAnswers(results, stats);
}

void swUnpackVolumeResults(const swGpuQueryResults* results, const swVolumeSamples* samples, swQueryStats* stats)
{
    tellAnswers(results, stats);
    for (int i = 0; i < results->count; ++i)
    {
        if (samples->depth != NULL)
        {
            samples->depth[i] = results->depths[i].depth;
        }
        if (samples->pressureHead != NULL)
        {
            samples->pressureHead[i] = results->depths[i].pressureHead;
        }
        if (samples->velocity != NULL)
        {
            samples->velocity[i] = takeVector(results->velocities[i]);
        }
        if (samples->acceleration != NULL)
        {
            samples->acceleration[i] = takeVector(results->accelerations[i]);
        }
    }
}

// As finishMarch() in core/query/raycast.c does it.
static swRayHit unpackHit(const swGpuQueryResults* results, int i, const swRay* ray)
{
    swGpuHit found = results->hits[i];
    if (isnan(found.distance))
    {
        const swPos nowhere = {(double)NAN, (double)NAN, (double)NAN};
        return (swRayHit){.distance = NAN, .position = nowhere, .point = nowhere, .normal = {NAN, NAN, NAN}};
    }
    if (found.side == 0.0f)
    {
        return (swRayHit){.distance = found.distance};
    }
    double x = (double)ray->direction.x, y = (double)ray->direction.y, z = (double)ray->direction.z;
    double way = (double)found.distance / swGetRayLength(ray);
    swRayHit hit = {
        .isHit = true,
        .distance = found.distance,
        .position = {ray->origin.x + x * way, ray->origin.y + y * way, ray->origin.z + z * way},
        .normal = takeVector(results->normals[i]),
        .fromBelow = found.side < 0.0f,
    };
    double water = results->seaLevel + (double)results->heights[i].height;
    hit.point = (swPos){hit.position.x, water, hit.position.z};
    if (ray->radius > 0.0f)
    {
        double back = (hit.position.y - water) * (double)hit.normal.y;
        hit.point.x = hit.position.x - back * (double)hit.normal.x;
        hit.point.y = hit.position.y - back * (double)hit.normal.y;
        hit.point.z = hit.position.z - back * (double)hit.normal.z;
    }
    return hit;
}

void swUnpackHits(const swGpuQueryResults* results, const swRay* rays, swRayHit* hits, swQueryStats* stats)
{
    swQueryStats total = {0};
    for (int i = 0; i < results->count; ++i)
    {
        hits[i] = unpackHit(results, i, &rays[i]);
        total.badCount += isnan(hits[i].distance) ? 1 : 0;
        total.convergedCount += hits[i].isHit || hits[i].distance >= rays[i].maxDistance ? 1 : 0;
    }
    if (stats != NULL)
    {
        *stats = total;
    }
}
