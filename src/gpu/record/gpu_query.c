// SPDX-License-Identifier: MIT
// Queries on the GPU, from the host's side: points go in, answers come back some frames later with the stamp of the frame
// that they belong to. Nothing here waits.
//
// A frame is known to be done when the host has said so, or when a later one is being recorded that the contract of
// swGpuDef::framesInFlight puts behind it. Points and copies of answers therefore lie in framesInFlight + 1 slots, used in
// turn: while the frames in flight have theirs, one more holds the newest answers that have arrived, or takes new points.

#include <math.h>
#include <string.h>

#include "gpu/pass/passes.h"
#include "gpu/record/record.h"

// Of a plane or a slot; suits any device's storage buffer offsets.
static VkDeviceSize alignPlane(VkDeviceSize size)
{
    return (size + 255) / 256 * 256;
}

// ---- making and freeing ----

#define PLANES 5

// What a query's buffer of answers may hold, in order; heights are always there.
typedef struct Plane
{
    uint32_t output; // 0: always
    size_t size;     // of one answer
    VkDeviceSize* at;
} Plane;

static void listPlanes(swGpuQueryBuffer* planes, Plane list[PLANES])
{
    list[0] = (Plane){0, sizeof(swGpuHeight), &planes->heights};
    list[1] = (Plane){SW_GPU_QUERY_SIDEWAYS, sizeof(swVec2), &planes->sideways};
    list[2] = (Plane){SW_GPU_QUERY_NORMAL, sizeof(swVec4), &planes->normals};
    list[3] = (Plane){SW_GPU_QUERY_VELOCITY, sizeof(swVec4), &planes->velocities};
    list[4] = (Plane){SW_GPU_QUERY_ACCELERATION, sizeof(swVec4), &planes->accelerations};
}

static bool isPlaneWanted(const swGpuQuery* query, const Plane* plane)
{
    return plane->output == 0 || (query->def.outputs & plane->output) != 0;
}

static void layOutPlanes(swGpuQuery* query)
{
    Plane planes[PLANES];
    listPlanes(&query->planes, planes);
    for (int i = 0; i < PLANES; ++i)
    {
        if (isPlaneWanted(query, &planes[i]))
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
    VkDeviceSize pointSize = alignPlane((VkDeviceSize)query->def.capacity * sizeof(swQueryPoint));
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
    swResult result = swCreateSurfaceQuery(gpu, def->outputs, &gpuWorld->passes);
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

void swPlaceQueryPoints(swGpuQuery* query, int count, const swPosXZ* points)
{
    if (query->isPointSlotUsed)
    {
        query->pointSlot = (query->pointSlot + 1) % query->slotCount;
        query->isPointSlotUsed = false;
    }
    query->count = count;
    query->pointsVersion += 1;
    query->hostPoints = VK_NULL_HANDLE;
    query->origin = count > 0 ? chooseOrigin(points[0]) : (swPosXZ){0.0, 0.0};
    size_t slotSize = (size_t)query->points.size / (size_t)query->slotCount;
    swQueryPoint* to = (swQueryPoint*)((uint8_t*)query->points.mapped + slotSize * (size_t)query->pointSlot);
    for (int i = 0; i < count; ++i)
    {
        swQueryPoint point;
        splitPlace(points[i].x - query->origin.x, &point.x, &point.cellX);
        splitPlace(points[i].z - query->origin.z, &point.z, &point.cellZ);
        to[i] = point;
    }
}

void swBindQueryPoints(swGpuQuery* query, int count, VkBuffer buffer, VkDeviceSize offset, swPosXZ origin)
{
    query->count = count;
    query->pointsVersion += 1;
    query->hostPoints = buffer;
    query->hostOffset = offset;
    query->origin = origin;
}

// ---- parameters of a frame ----

// A fraction of 2^32, to the nearest.
static uint32_t toTurns(double turns)
{
    return (uint32_t)(uint64_t)floor((turns - floor(turns)) * 0x1p32 + 0.5);
}

static swQueryTile makeQueryTile(const swTile* tile, uint32_t firstTexel, swPosXZ origin)
{
    return (swQueryTile){
        .turnsX = toTurns(origin.x / tile->side),
        .turnsZ = toTurns(origin.z / tile->side),
        .cellTurns = toTurns((double)SW_QUERY_CELL / tile->side),
        .turnsPerMetre = (float)(1.0 / tile->side),
        .texelsPerMetre = (float)(tile->resolution / tile->side),
        .firstTexel = firstTexel,
        .resolutionBits = 4u + (uint32_t)swTileSizeIndex(tile->resolution),
    };
}

static swQueryWave makeQueryWave(const swFreeWave* wave, int64_t ticks, swPosXZ origin)
{
    uint32_t moved = (uint32_t)((wave->frequency * (uint64_t)swGetFreeWaveTicks(wave, ticks)) >> 32);
    return (swQueryWave){
        .phase = toTurns(wave->turnsX * origin.x + wave->turnsZ * origin.z) + wave->phase - moved,
        .cellTurnsX = toTurns(wave->turnsX * (double)SW_QUERY_CELL),
        .cellTurnsZ = toTurns(wave->turnsZ * (double)SW_QUERY_CELL),
        .amplitude = wave->amplitude,
        .dx = wave->dx,
        .dz = wave->dz,
        .turnsX = (float)wave->turnsX,
        .turnsZ = (float)wave->turnsZ,
        .rate = (float)((double)wave->frequency * (SW_TICKS_PER_SECOND * 2.0 * SW_PI * 0x1p-64)),
    };
}

// Tiles that count, the longest first. Returns how many.
static int chooseTiles(const swFrame* frame, float minWavelength, int* chosen)
{
    int count = 0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        const swTile* tile = &frame->tiles[i];
        if (tile->maxWavelength <= minWavelength)
        {
            continue;
        }
        int at = count++;
        for (; at > 0 && frame->tiles[chosen[at - 1]].minWavelength < tile->minWavelength; --at)
        {
            chosen[at] = chosen[at - 1];
        }
        chosen[at] = i;
    }
    return count;
}

// The way from a point to its particle is about the deviation of the waves' displacement. Waves shorter than some four
// times that are left out of the first guess.
static float findShortestOfGuess(const swFrame* frame, float minWavelength)
{
    double variance = 0.0;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        variance += frame->tiles[i].maxWavelength > minWavelength ? (double)frame->tiles[i].variance : 0.0;
    }
    for (int i = 0; i < frame->waveCount; ++i)
    {
        double amplitude = (double)frame->waves[i].amplitude;
        variance += frame->waves[i].wavelength >= minWavelength ? 0.5 * amplitude * amplitude : 0.0;
    }
    return (float)(4.0 * sqrt(variance));
}

static swPosXZ originInSea(const swGpuQuery* query)
{
    swPosXZ origin = swGetWorldOrigin(query->gpuWorld->world);
    return (swPosXZ){query->origin.x + origin.x, query->origin.z + origin.z};
}

static swResult uploadQueryTiles(swGpuQuery* query, const swFrame* frame, float shortest)
{
    swPosXZ origin = originInSea(query);
    int chosen[SW_MAX_TILES];
    int count = chooseTiles(frame, query->def.minWavelength, chosen);
    swResult result = swReserveUpload(query->gpuWorld->gpu, SW_MAX_TILES * sizeof(swQueryTile), &query->tiles);
    swQueryParams* params = &query->params;
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        const swTile* tile = &frame->tiles[chosen[i]];
        ((swQueryTile*)query->tiles.data)[i] =
            makeQueryTile(tile, query->gpuWorld->params[chosen[i]].firstTexel, origin);
        params->longTileCount += tile->minWavelength >= shortest ? 1 : 0;
    }
    params->tileCount = (uint32_t)count;
    return result;
}

static swResult uploadQueryWaves(swGpuQuery* query, const swFrame* frame, float shortest)
{
    swPosXZ origin = originInSea(query);
    int count = 0;
    while (count < frame->waveCount && frame->waves[count].wavelength >= query->def.minWavelength)
    {
        count += 1;
    }
    swResult result = swReserveUpload(query->gpuWorld->gpu, (VkDeviceSize)(count > 0 ? count : 1) * sizeof(swQueryWave),
                                      &query->waves);
    swQueryParams* params = &query->params;
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        const swFreeWave* wave = &frame->waves[i];
        ((swQueryWave*)query->waves.data)[i] = makeQueryWave(wave, frame->ticks, origin);
        params->longWaveCount += wave->wavelength >= shortest ? 1 : 0;
    }
    params->waveCount = (uint32_t)count;
    return result;
}

uint32_t swFindWantedFields(const swGpuWorld* gpuWorld)
{
    uint32_t wanted = 0;
    for (const swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        wanted |= query->count > 0 ? query->def.outputs : 0;
    }
    return wanted & (SW_GPU_QUERY_VELOCITY | SW_GPU_QUERY_ACCELERATION);
}

// How far a field's texels lie from displacement's; 0 if the query does not want it.
static uint32_t findFieldTexels(const swGpuQuery* query, swGpuQueryOutput output, uint32_t field)
{
    return (query->def.outputs & output) != 0 ? field * query->gpuWorld->fields.texels : 0;
}

swResult swUploadQueries(swGpuWorld* gpuWorld, const swFrame* frame)
{
    swResult result = SW_SUCCESS;
    for (swGpuQuery* query = gpuWorld->firstQuery; query != NULL && result == SW_SUCCESS; query = query->next)
    {
        if (query->count == 0)
        {
            continue;
        }
        query->params = (swQueryParams){
            .pointCount = (uint32_t)query->count,
            .outputs = query->def.outputs,
            .maxIterations = (uint32_t)query->def.maxIterations,
            .toleranceSquare = query->def.tolerance * query->def.tolerance,
            .velocityTexels = findFieldTexels(query, SW_GPU_QUERY_VELOCITY, gpuWorld->fields.velocity),
            .accelerationTexels = findFieldTexels(query, SW_GPU_QUERY_ACCELERATION, gpuWorld->fields.acceleration),
        };
        float shortest = findShortestOfGuess(frame, query->def.minWavelength);
        result = uploadQueryTiles(query, frame, shortest);
        result = result == SW_SUCCESS ? uploadQueryWaves(query, frame, shortest) : result;
    }
    return result;
}

// ---- answers ----

static void recordCopy(swGpuQuery* query, VkCommandBuffer commands)
{
    swGpu* gpu = query->gpuWorld->gpu;
    VkDeviceSize to = query->answerSize * (VkDeviceSize)query->answerSlot;
    Plane planes[PLANES];
    listPlanes(&query->planes, planes);
    VkBufferCopy copies[PLANES];
    uint32_t count = 0;
    for (int i = 0; i < PLANES; ++i)
    {
        if (isPlaneWanted(query, &planes[i]))
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
    query->answerSlot = (query->answerSlot + 1) % query->slotCount;
    query->slots[query->answerSlot] = (swGpuQuerySlot){
        .isRecorded = true,
        .frameIndex = query->gpuWorld->gpu->frameIndex,
        .time = frame->time,
        .seaLevel = frame->seaLevel,
        .pointsVersion = query->pointsVersion,
        .count = query->count,
    };
}

void swRecordQueryCopies(swGpuWorld* gpuWorld, VkCommandBuffer commands, const swFrame* frame)
{
    swGpu* gpu = gpuWorld->gpu;
    bool hasCopies = false;
    for (swGpuQuery* query = gpuWorld->firstQuery; query != NULL; query = query->next)
    {
        if (query->count == 0)
        {
            continue;
        }
        stampQuery(query, frame);
        if (query->def.readBack)
        {
            if (!hasCopies)
            {
                swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                          VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
            }
            recordCopy(query, commands);
            hasCopies = true;
        }
    }
    if (hasCopies)
    {
        swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
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
        .sideways = planes->sideways != 0 ? (const swVec2*)(data + planes->sideways) : NULL,
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
        samples->displacement[i] = (swVec3){results->sideways[i].x, height.height, results->sideways[i].y};
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

void swUnpackQueryResults(const swGpuQueryResults* results, const swSurfaceSamples* samples, swQueryStats* stats)
{
    swQueryStats total = {0};
    for (int i = 0; i < results->count; ++i)
    {
        float residual = results->heights[i].residual;
        unpackOne(results, i, samples);
        total.convergedCount += residual <= results->tolerance ? 1 : 0;
        total.worstResidual = residual > total.worstResidual ? residual : total.worstResidual;
    }
    if (stats != NULL)
    {
        *stats = total;
    }
}
