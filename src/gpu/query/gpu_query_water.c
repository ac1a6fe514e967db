// SPDX-License-Identifier: MIT
// What a frame's queries see of the water: the tiles and free waves that count, from where each query's points begin.

#include <math.h>

#include "gpu/query/gpu_query.h"

// For shaders, which need not know infinity: depth of deep water, m.
#define DEEP 1e30f

// A fraction of 2^32, to the nearest.
static uint32_t toTurns(double turns)
{
    return (uint32_t)(uint64_t)floor((turns - floor(turns)) * 0x1p32 + 0.5);
}

static swQueryTile makeQueryTile(const swTile* tile, uint32_t firstTexel, swPosXZ origin)
{
    return (swQueryTile){
        .turnsX = toTurns((origin.x - tile->shiftX) / tile->side),
        .turnsZ = toTurns((origin.z - tile->shiftZ) / tile->side),
        .cellTurns = toTurns((double)SW_QUERY_CELL / tile->side),
        .turnsPerMetre = (float)(1.0 / tile->side),
        .texelsPerMetre = (float)(tile->resolution / tile->side),
        .firstTexel = firstTexel,
        .resolutionBits = 4u + (uint32_t)swTileSizeIndex(tile->resolution),
        .waveNumber = swGetTileWaveNumber(tile),
        .system = (uint32_t)tile->system,
        .strength = tile->attenuation.strength,
        .perFreeDepth = tile->attenuation.perFreeDepth,
    };
}

static void carryTile(const swTile* tile, int64_t ticks, swQueryTile* seen)
{
    seen->carryTurns = swGetCarryPhase(seen->waveNumber, tile->loopTicks, ticks, &seen->carryPeriod);
}

static swQueryWave makeQueryWave(const swFreeWave* wave, int64_t ticks, swPosXZ origin)
{
    return (swQueryWave){
        .phase =
            toTurns(wave->turnsX * origin.x + wave->turnsZ * origin.z) + wave->phase - swGetPassedTurns(wave, ticks),
        .cellTurnsX = toTurns(wave->turnsX * (double)SW_QUERY_CELL),
        .cellTurnsZ = toTurns(wave->turnsZ * (double)SW_QUERY_CELL),
        .amplitude = wave->amplitude,
        .dx = wave->dx,
        .dz = wave->dz,
        .turnsX = (float)wave->turnsX,
        .turnsZ = (float)wave->turnsZ,
        .rate = (float)((double)wave->frequency * (SW_TICKS_PER_SECOND * 2.0 * SW_PI * 0x1p-64)),
        .depth = fminf(wave->depth, DEEP),
        .waveNumber = swGetOctaveWaveNumber(wave->wavelength),
        .system = (uint32_t)wave->system,
        .attenuation = wave->attenuation,
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

// Steps after the first evaluation of all waves, and after those that follow, by the length that findShortestOfGuess()
// finds: 99 of 100 are shorter, in a breeze as in a gale.
#define FAR_WAY 0.045f
#define NEAR_WAY 0.0048f

// What derivatives up to the second leave out: displacement is off by a sixth of the third derivative times the cube of
// the way, its slopes by half of it times the square. Four standard deviations of it count.
#define MOST_OFF_M 2e-5
#define MOST_SLOPE_OFF 5e-4

// How far tiles carry whose third derivatives have that variance, m.
static float findReach(const swGpuQuery* query, double variance)
{
    double most = fmin(MOST_OFF_M, 0.05 * (double)query->def.tolerance);
    double third = 4.0 * sqrt(variance) + 1e-20;
    return (float)fmin(cbrt(6.0 * most / third), sqrt(2.0 * MOST_SLOPE_OFF / third));
}

// Of the first tiles, those that carry over `way`; how far they do.
static uint32_t findSmoothTiles(const swGpuQuery* query, const swFrame* frame, int count, const int* chosen, float way,
                                float* reach)
{
    double variance = 0.0;
    *reach = 0.0f;
    for (int i = 0; i < count; ++i)
    {
        const swTile* tile = &frame->tiles[chosen[i]];
        double k = 2.0 * SW_PI / (double)tile->minWavelength;
        variance += ((double)tile->slopeVarianceX + (double)tile->slopeVarianceZ) * k * k * k * k;
        float next = findReach(query, variance);
        if (next < way)
        {
            return (uint32_t)i;
        }
        *reach = next;
    }
    return (uint32_t)count;
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
    swQueryWater* water = &query->params.water;
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        const swTile* tile = &frame->tiles[chosen[i]];
        swQueryTile seen = makeQueryTile(tile, query->gpuWorld->tiles.params[chosen[i]].firstTexel, origin);
        if (query->gpuWorld->tiles.isCarried)
        {
            carryTile(tile, frame->ticks, &seen);
        }
        ((swQueryTile*)query->tiles.data)[i] = seen;
        water->longTileCount += tile->minWavelength >= shortest ? 1 : 0;
    }
    water->tileCount = (uint32_t)count;
    water->farTileCount = findSmoothTiles(query, frame, count, chosen, FAR_WAY * shortest, &water->farReach);
    water->nearTileCount = findSmoothTiles(query, frame, count, chosen, NEAR_WAY * shortest, &water->nearReach);
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
    swQueryWater* water = &query->params.water;
    int groupEnd = 0;
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        const swFreeWave* wave = &frame->waves[i];
        swQueryWave seen = makeQueryWave(wave, frame->ticks, origin);
        groupEnd = i == groupEnd ? swFindCarriedEnd(frame->waves, i, count) : groupEnd;
        seen.groupEnd = (uint32_t)groupEnd;
        seen.carryTurns = swGetCarryPhase(seen.waveNumber, wave->loopTicks, frame->ticks, &seen.carryPeriod);
        ((swQueryWave*)query->waves.data)[i] = seen;
        water->longWaveCount += wave->wavelength >= shortest ? 1 : 0;
    }
    water->waveCount = (uint32_t)count;
    return result;
}

// How far a field's texels lie from displacement's; 0 if the query does not want it.
static uint32_t findFieldTexels(const swGpuQuery* query, swGpuQueryOutput output, uint32_t field)
{
    return (query->def.outputs & output) != 0 ? field * query->gpuWorld->tiles.fields.texels : 0;
}

static void fillParams(swGpuQuery* query)
{
    const swTileFields* fields = &query->gpuWorld->tiles.fields;
    query->params = (swQueryParams){
        .water.maxIterations = (uint32_t)query->def.maxIterations,
        .water.toleranceSquare = query->def.tolerance * query->def.tolerance,
        .water.minWavelength = query->def.minWavelength,
    };
    swPosXZ origin = originInSea(query);
    swSplitSeaPlace(origin.x, &query->params.sea.cellX, &query->params.sea.restX);
    swSplitSeaPlace(origin.z, &query->params.sea.cellZ, &query->params.sea.restZ);
    if (query->def.kind == SW_GPU_QUERY_KIND_SURFACE)
    {
        query->params.outputs = query->def.outputs;
        query->params.velocityTexels = findFieldTexels(query, SW_GPU_QUERY_VELOCITY, fields->velocity);
        query->params.accelerationTexels = findFieldTexels(query, SW_GPU_QUERY_ACCELERATION, fields->acceleration);
    }
    query->params.outputs |= query->planes.stills != 0 ? SW_QUERY_WANTS_STILL : 0;
}

// ---- the water below ----

// The shallowest bottom under the waves that count, as findBottom() in core/query/volume.c.
static float findBottom(const swGpuQuery* query, const swFrame* frame, int tileCount, const int* tiles)
{
    float bottom = DEEP;
    for (int i = 0; i < tileCount; ++i)
    {
        bottom = fminf(bottom, frame->tiles[tiles[i]].depth);
    }
    for (uint32_t i = 0; i < query->params.water.waveCount; ++i)
    {
        bottom = fminf(bottom, frame->waves[i].depth);
    }
    return bottom;
}

static swVolumeTile makeVolumeTile(const swTile* tile, const swTileParams* params, swPosXZ origin)
{
    swQueryTile seen = makeQueryTile(tile, 0, origin);
    return (swVolumeTile){
        .turnsX = seen.turnsX,
        .turnsZ = seen.turnsZ,
        .cellTurns = seen.cellTurns,
        .turnsPerMetre = seen.turnsPerMetre,
        .firstWave = params->firstMode,
        .waveCount = params->modeCount,
        .maxWavelength = tile->maxWavelength,
        .depth = fminf(tile->depth, DEEP),
    };
}

static swResult uploadVolume(swGpuQuery* query, const swFrame* frame)
{
    int chosen[SW_MAX_TILES];
    int count = chooseTiles(frame, query->def.minWavelength, chosen);
    query->volume = (swVolumeParams){
        .outputs = query->def.outputs,
        .tileCount = (uint32_t)count,
        .waveCount = query->params.water.waveCount,
        .isWheeler = query->def.stretching == SW_STRETCHING_WHEELER ? 1 : 0,
        .bottom = findBottom(query, frame, count, chosen),
        .level = (float)(query->level - frame->seaLevel),
    };
    swPosXZ origin = originInSea(query);
    const swGpuWorld* gpuWorld = query->gpuWorld;
    swResult result = swReserveUpload(gpuWorld->gpu, SW_MAX_TILES * sizeof(swVolumeTile), &query->volumeTiles);
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        ((swVolumeTile*)query->volumeTiles.data)[i] =
            makeVolumeTile(&frame->tiles[chosen[i]], &gpuWorld->tiles.params[chosen[i]], origin);
    }
    return result;
}

// ---- rays ----

// As findReach() and findShortest() in core/query/raycast.c.
static void measureWaves(const swGpuQuery* query, const swFrame* frame, float* reach, float* shortest)
{
    int chosen[SW_MAX_TILES];
    int count = chooseTiles(frame, query->def.minWavelength, chosen);
    float variance = 0.0f;
    float sum = 0.0f;
    *shortest = 1000.0f;
    for (int i = 0; i < count; ++i)
    {
        variance += frame->tiles[chosen[i]].variance;
        *shortest = fminf(*shortest, frame->tiles[chosen[i]].minWavelength);
    }
    for (uint32_t i = 0; i < query->params.water.waveCount; ++i)
    {
        sum += frame->waves[i].amplitude;
        *shortest = fminf(*shortest, frame->waves[i].wavelength);
    }
    *reach = 6.0f * sqrtf(variance) + sum;
}

// Looks of a ray. At two evaluations each that is a tenth of a second where a busy device does a hundred in a
// millisecond.
#define MOST_LOOKS 4096

static void fillRays(swGpuQuery* query, const swFrame* frame)
{
    query->rays = (swRayParams){
        .water = query->params.water,
        .sea = query->params.sea,
        .outputs = query->def.outputs,
        .level = (float)(query->level - frame->seaLevel),
        .tolerance = query->def.tolerance,
        .mostLooks = MOST_LOOKS,
    };
    float reach;
    measureWaves(query, frame, &reach, &query->rays.shortest);
    const swInputSet* inputs = frame->inputs;
    reach = inputs != NULL ? reach * inputs->weightReach + inputs->displacementReach : reach;
    query->rays.low = (inputs != NULL ? inputs->lowestLevel : 0.0f) - reach;
    query->rays.high = (inputs != NULL ? inputs->highestLevel : 0.0f) + reach;
}

// ---- all queries ----

static swResult uploadQuery(swGpuQuery* query, const swFrame* frame)
{
    fillParams(query);
    float shortest = findShortestOfGuess(frame, query->def.minWavelength);
    swResult result = uploadQueryTiles(query, frame, shortest);
    result = result == SW_SUCCESS ? uploadQueryWaves(query, frame, shortest) : result;
    if (result == SW_SUCCESS && query->def.kind == SW_GPU_QUERY_KIND_VOLUME)
    {
        result = uploadVolume(query, frame);
    }
    if (result == SW_SUCCESS && query->def.kind == SW_GPU_QUERY_KIND_RAYS)
    {
        fillRays(query, frame);
    }
    return result;
}

swResult swUploadQueries(swGpuWorld* gpuWorld, const swFrame* frame)
{
    swResult result = SW_SUCCESS;
    for (swGpuQuery* query = gpuWorld->firstQuery; query != NULL && result == SW_SUCCESS; query = query->next)
    {
        result = query->count > 0 ? uploadQuery(query, frame) : SW_SUCCESS;
    }
    return result;
}
