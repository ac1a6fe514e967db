// SPDX-License-Identifier: MIT
// Heights from tiles that displace sideways too. The water above q belongs to the particle that rests at u with
// u + D(u) = q. With the offset d = u - q this is a root of r(d) = d + D(q + d), two equations in two unknowns, found
// by a quasi-Newton iteration: the Jacobian starts as the identity (which makes the first step the classic fixed-point
// one) and is corrected after each step by what the residual did [Broyden 1965]. That needs no gradients, which cost as
// much as the displacement itself. A step that made the residual worse is taken back and tried again shorter.
//
// Points run in blocks, and within a block the kernels see only points that are not yet done. A point's iteration
// depends on nothing but itself, so its bits do not depend on the batch that it came in.
//
// Offsets are float: they are metres at most. q + d is double, so the answer is as good far away as at the origin.

#include "core/surface/sample.h"

#include <math.h>
#include <string.h>

#include "core/frame/asked.h"
#include "shared/surface_normal.h"

typedef struct swSearch
{
    float dx, dz; // offset being tried
    float rx, rz; // its residual
    float bestX, bestZ;
    float bestRx, bestRz;
    float bestSquare;         // of the best residual
    float b00, b01, b10, b11; // inverse Jacobian
    float reach;              // share of the full step, below 1 after a bad one
} swSearch;

// Free waves of at least a length; they come longest first.
static int countLongWaves(const swFrame* frame, float minWavelength)
{
    int count = frame->waveCount;
    while (count > 0 && frame->waves[count - 1].wavelength < minWavelength)
    {
        count -= 1;
    }
    return count;
}

void swBeginQuery(swQuery* query, const swFrame* frame, const swWaveKernels* kernels, const swQueryDef* def,
                  swPosXZ origin)
{
    query->kernels = kernels;
    query->def = def;
    query->origin = origin;
    query->seaLevel = frame->seaLevel;
    bool isNow = def->time == SW_QUERY_NOW;
    query->ticks = isNow ? frame->ticks : (int64_t)floor(def->time * SW_TICKS_PER_SECOND + 0.5);
    query->isNow = query->ticks == frame->ticks;
    query->waves = frame->waves;
    query->waveCount = countLongWaves(frame, def->minWavelength);
    query->tiles = frame->tiles;
    // A world without queries has no texels: it answers sea level.
    query->tileCount = frame->tileCount > 0 && frame->tiles[0].texels != NULL ? frame->tileCount : 0;
}

bool swPlacePoint(const swQuery* query, double x, double z, swPosXZ* place)
{
    *place = (swPosXZ){x + query->origin.x, z + query->origin.z};
    return swIsNear(x) && swIsNear(z);
}

// ---- adding up waves ----

// Waves one by one, added to what is there.
static void sumOneByOne(const swQuery* query, bool withTiles, int count, const swPosXZ* rest, const swEvaluation* out)
{
    if (!withTiles && query->waveCount == 0)
    {
        return;
    }
    const swSurfaceSums sums = {out->displacement, out->gradients, out->velocity, out->acceleration};
    const swWaveSumJob job = {
        .tileCount = withTiles ? query->tileCount : 0,
        .tiles = query->tiles,
        .minWavelength = query->def->minWavelength,
        .waveCount = query->waveCount,
        .waves = query->waves,
        .ticks = query->ticks,
        .count = count,
        .points = rest,
        .surface = &sums,
    };
    swSumWaves(query->kernels, &job);
}

static bool hasField(const swQuery* query, bool isVelocity)
{
    const swTile* tile = &query->tiles[0];
    return query->tileCount == 0 || (isVelocity ? tile->velocity : tile->acceleration) != NULL;
}

static void sampleField(const swQuery* query, int field, int count, const swPosXZ* rest, float (*out)[4],
                        float (*gradients)[8])
{
    const swTileChoice choice = {query->tileCount, query->tiles, query->def->minWavelength, field};
    swSampleChosenTiles(query->kernels, &choice, count, rest, out[0], gradients != NULL ? gradients[0] : NULL);
}

// What tiles have no texels for: motion of tiles wave by wave.
static void sumTileMotion(const swQuery* query, int count, const swPosXZ* rest, float (*velocity)[4],
                          float (*acceleration)[4])
{
    const swSurfaceSums sums = {.velocity = velocity, .acceleration = acceleration};
    const swWaveSumJob job = {
        .tileCount = query->tileCount,
        .tiles = query->tiles,
        .minWavelength = query->def->minWavelength,
        .ticks = query->ticks,
        .count = count,
        .points = rest,
        .surface = &sums,
    };
    swSumWaves(query->kernels, &job);
}

static void evaluateMotion(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    bool needsVelocity = out->velocity != NULL && !hasField(query, true);
    bool needsAcceleration = out->acceleration != NULL && !hasField(query, false);
    if (needsVelocity || needsAcceleration)
    {
        sumTileMotion(query, count, rest, needsVelocity ? out->velocity : NULL,
                      needsAcceleration ? out->acceleration : NULL);
    }
    if (out->velocity != NULL && !needsVelocity)
    {
        sampleField(query, 1, count, rest, out->velocity, NULL);
    }
    if (out->acceleration != NULL && !needsAcceleration)
    {
        sampleField(query, 2, count, rest, out->acceleration, NULL);
    }
}

void swEvaluate(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    size_t rows = (size_t)count * 4 * sizeof(float);
    if (out->velocity != NULL)
    {
        memset(out->velocity, 0, rows);
    }
    if (out->acceleration != NULL)
    {
        memset(out->acceleration, 0, rows);
    }
    if (query->isNow)
    {
        if (out->displacement != NULL)
        {
            sampleField(query, 0, count, rest, out->displacement, out->gradients);
        }
        evaluateMotion(query, count, rest, out);
    }
    else
    {
        if (out->displacement != NULL)
        {
            memset(out->displacement, 0, rows);
        }
        if (out->gradients != NULL)
        {
            memset(out->gradients, 0, 2 * rows);
        }
    }
    sumOneByOne(query, !query->isNow, count, rest, out);
}

// ---- finding particles ----

// Good Broyden update of the inverse Jacobian for a step (sx, sz) that changed the residual by (yx, yz).
static void correctJacobian(swSearch* search, float sx, float sz, float yx, float yz)
{
    float byX = search->b00 * yx + search->b01 * yz;
    float byZ = search->b10 * yx + search->b11 * yz;
    float scale = sx * byX + sz * byZ;
    float square = sx * sx + sz * sz;
    if (fabsf(scale) <= 1e-3f * square)
    {
        return; // the update would blow up; the old Jacobian is the better guess
    }
    float ux = (sx - byX) / scale;
    float uz = (sz - byZ) / scale;
    float rowX = sx * search->b00 + sz * search->b10;
    float rowZ = sx * search->b01 + sz * search->b11;
    search->b00 += ux * rowX;
    search->b01 += ux * rowZ;
    search->b10 += uz * rowX;
    search->b11 += uz * rowZ;
}

// Take in the displacement at the tried offset and choose the next. False when done.
static bool advanceSearch(swSearch* search, const float* displacement, float toleranceSquare)
{
    search->rx = search->dx + displacement[0];
    search->rz = search->dz + displacement[2];
    float square = search->rx * search->rx + search->rz * search->rz;
    float sx = search->dx - search->bestX;
    float sz = search->dz - search->bestZ;
    if (sx != 0.0f || sz != 0.0f)
    {
        correctJacobian(search, sx, sz, search->rx - search->bestRx, search->rz - search->bestRz);
    }
    if (square < search->bestSquare)
    {
        search->bestX = search->dx;
        search->bestZ = search->dz;
        search->bestRx = search->rx;
        search->bestRz = search->rz;
        search->bestSquare = square;
        search->reach = 1.0f;
    }
    else
    {
        search->reach *= 0.5f;
    }
    if (search->bestSquare <= toleranceSquare)
    {
        return false;
    }
    search->dx = search->bestX - search->reach * (search->b00 * search->bestRx + search->b01 * search->bestRz);
    search->dz = search->bestZ - search->reach * (search->b10 * search->bestRx + search->b11 * search->bestRz);
    return true;
}

void swFindParticles(const swQuery* query, int count, const swPosXZ* points, swFound* found)
{
    swSearch searches[SW_QUERY_BLOCK];
    swPosXZ tried[SW_QUERY_BLOCK];
    float displacement[SW_QUERY_BLOCK][4];
    int active[SW_QUERY_BLOCK];
    int activeCount = count;
    float toleranceSquare = query->def->tolerance * query->def->tolerance;
    for (int i = 0; i < count; ++i)
    {
        searches[i] = (swSearch){.b00 = 1.0f, .b11 = 1.0f, .bestSquare = INFINITY, .reach = 1.0f};
        active[i] = i;
    }
    found->evaluations = 0;
    const swEvaluation evaluation = {.displacement = displacement};
    for (int iteration = 0; iteration < query->def->maxIterations && activeCount > 0; ++iteration)
    {
        for (int i = 0; i < activeCount; ++i)
        {
            const swSearch* search = &searches[active[i]];
            tried[i].x = points[active[i]].x + (double)search->dx;
            tried[i].z = points[active[i]].z + (double)search->dz;
        }
        swEvaluate(query, activeCount, tried, &evaluation);
        found->evaluations += activeCount;
        int stillActive = 0;
        for (int i = 0; i < activeCount; ++i)
        {
            int point = active[i];
            float before = searches[point].bestSquare;
            bool isDone = !advanceSearch(&searches[point], displacement[i], toleranceSquare);
            if (searches[point].bestSquare < before)
            {
                memcpy(found->displacement[point], displacement[i], sizeof displacement[i]);
            }
            active[stillActive] = point;
            stillActive += isDone ? 0 : 1;
        }
        activeCount = stillActive;
    }
    for (int i = 0; i < count; ++i)
    {
        found->rest[i].x = points[i].x + (double)searches[i].bestX;
        found->rest[i].z = points[i].z + (double)searches[i].bestZ;
        found->residual[i] = sqrtf(searches[i].bestSquare);
    }
}

// ---- answers ----

swVec3 swMakeNormal(const float g[8], float* jacobian)
{
    *jacobian = swSurfaceJacobian(g[0], g[2], g[3]);
    float x = swSurfaceNormalX(g[2], g[3], g[4], g[5]);
    float z = swSurfaceNormalZ(g[0], g[2], g[4], g[5]);
    float length = sqrtf(x * x + *jacobian * *jacobian + z * z);
    if (length < 1e-20f)
    {
        return (swVec3){0.0f, 1.0f, 0.0f};
    }
    float scale = (*jacobian < 0.0f ? -1.0f : 1.0f) / length;
    return (swVec3){-x * scale, *jacobian * scale, -z * scale};
}

// The next points that can be answered: `at` says which they are.
typedef struct Block
{
    int count;
    int at[SW_QUERY_BLOCK];
    swPosXZ places[SW_QUERY_BLOCK]; // in the sea
} Block;

static void markBad(const swSurfaceSamples* samples, swVec2* slopes, int point)
{
    swVec3* vectors[] = {samples->displacement, samples->normal, samples->velocity, samples->acceleration};
    float* numbers[] = {samples->height, samples->jacobian, samples->residual};
    for (int i = 0; i < 4; ++i)
    {
        if (vectors[i] != NULL)
        {
            vectors[i][point] = SW_NO_VECTOR;
        }
    }
    for (int i = 0; i < 3; ++i)
    {
        if (numbers[i] != NULL)
        {
            numbers[i][point] = SW_NO_NUMBER;
        }
    }
    if (slopes != NULL)
    {
        slopes[point] = (swVec2){SW_NO_NUMBER, SW_NO_NUMBER};
    }
}

void swRefuseSurface(int count, const swSurfaceSamples* samples, swVec2* slopes, swQueryStats* stats)
{
    const swSurfaceSamples none = {0};
    for (int i = 0; i < count; ++i)
    {
        markBad(samples != NULL ? samples : &none, slopes, i);
    }
    swRefuseStats(count, stats);
}

void swRefuseStats(int count, swQueryStats* stats)
{
    if (stats != NULL)
    {
        *stats = (swQueryStats){.badCount = count > 0 ? count : 0};
    }
}

// Fill a block from point `first` on. Points on the way that cannot be answered are marked and counted.
// Returns the point to go on with.
static int fillBlock(const swQuery* query, int first, int count, const swPosXZ* points, const swSurfaceSamples* samples,
                     swVec2* slopes, Block* block, swQueryStats* stats)
{
    block->count = 0;
    int point = first;
    for (; point < count && block->count < SW_QUERY_BLOCK; ++point)
    {
        block->at[block->count] = point;
        if (swPlacePoint(query, points[point].x, points[point].z, &block->places[block->count]))
        {
            block->count += 1;
        }
        else
        {
            markBad(samples, slopes, point);
            stats->badCount += 1;
        }
    }
    return point;
}

static void writeVectors(swVec3* to, const Block* block, float (*rows)[4])
{
    for (int i = 0; i < block->count && to != NULL; ++i)
    {
        to[block->at[i]] = (swVec3){rows[i][0], rows[i][1], rows[i][2]};
    }
}

// Gradients may be NULL if neither normals nor Jacobians are wanted, residuals where nothing was searched.
static void writeSamples(const swSurfaceSamples* samples, double seaLevel, const Block* block, float (*displacement)[4],
                         float (*gradients)[8], const float* residuals)
{
    writeVectors(samples->displacement, block, displacement);
    for (int i = 0; i < block->count; ++i)
    {
        int point = block->at[i];
        if (samples->height != NULL)
        {
            samples->height[point] = (float)(seaLevel + (double)displacement[i][1]);
        }
        if (samples->residual != NULL)
        {
            samples->residual[point] = residuals != NULL ? residuals[i] : 0.0f;
        }
        float jacobian = 1.0f;
        swVec3 normal = gradients != NULL ? swMakeNormal(gradients[i], &jacobian) : (swVec3){0.0f, 1.0f, 0.0f};
        if (samples->normal != NULL)
        {
            samples->normal[point] = normal;
        }
        if (samples->jacobian != NULL)
        {
            samples->jacobian[point] = jacobian;
        }
    }
}

void swCountFound(swQueryStats* stats, const swFound* found, int count, float tolerance)
{
    stats->iterationCount += found->evaluations;
    for (int i = 0; i < count; ++i)
    {
        float residual = found->residual[i];
        stats->convergedCount += residual <= tolerance ? 1 : 0;
        stats->worstResidual = residual > stats->worstResidual ? residual : stats->worstResidual;
    }
}

static bool wantsGradients(const swSurfaceSamples* samples)
{
    return samples->normal != NULL || samples->jacobian != NULL;
}

static bool wantsMore(const swSurfaceSamples* samples)
{
    return wantsGradients(samples) || samples->velocity != NULL || samples->acceleration != NULL;
}

static void sampleParticles(const swQuery* query, const swSurfaceSamples* samples, const Block* block,
                            const swPosXZ* rest, float (*displacement)[4], float (*gradients)[8])
{
    float velocity[SW_QUERY_BLOCK][4];
    float acceleration[SW_QUERY_BLOCK][4];
    const swEvaluation evaluation = {
        .displacement = displacement,
        .gradients = gradients,
        .velocity = samples->velocity != NULL ? velocity : NULL,
        .acceleration = samples->acceleration != NULL ? acceleration : NULL,
    };
    swEvaluate(query, block->count, rest, &evaluation);
    writeVectors(samples->velocity, block, velocity);
    writeVectors(samples->acceleration, block, acceleration);
}

static void querySurfaceBlock(const swQuery* query, const Block* block, const swSurfaceSamples* samples,
                              swQueryStats* stats)
{
    float gradients[SW_QUERY_BLOCK][8];
    swFound found;
    swFindParticles(query, block->count, block->places, &found);
    bool withGradients = wantsGradients(samples);
    if (wantsMore(samples))
    {
        float again[SW_QUERY_BLOCK][4];
        sampleParticles(query, samples, block, found.rest, withGradients ? again : NULL,
                        withGradients ? gradients : NULL);
        found.evaluations += block->count;
    }
    writeSamples(samples, query->seaLevel, block, found.displacement, withGradients ? gradients : NULL, found.residual);
    swCountFound(stats, &found, block->count, query->def->tolerance);
}

void swQuerySurface(const swQuery* query, int count, const swPosXZ* points, const swSurfaceSamples* samples,
                    swQueryStats* stats)
{
    swQueryStats total = {0};
    Block block;
    for (int next = 0; next < count;)
    {
        next = fillBlock(query, next, count, points, samples, NULL, &block, &total);
        if (block.count > 0)
        {
            querySurfaceBlock(query, &block, samples, &total);
        }
    }
    if (stats != NULL)
    {
        *stats = total;
    }
}

static void queryParticleBlock(const swQuery* query, const Block* block, const swSurfaceSamples* samples,
                               swVec2* slopes)
{
    float displacement[SW_QUERY_BLOCK][4];
    float gradients[SW_QUERY_BLOCK][8];
    bool withGradients = wantsGradients(samples) || slopes != NULL;
    sampleParticles(query, samples, block, block->places, displacement, withGradients ? gradients : NULL);
    writeSamples(samples, query->seaLevel, block, displacement, withGradients ? gradients : NULL, NULL);
    for (int i = 0; i < block->count && slopes != NULL; ++i)
    {
        slopes[block->at[i]] = (swVec2){gradients[i][4], gradients[i][5]};
    }
}

void swQueryParticles(const swQuery* query, int count, const swPosXZ* points, const swSurfaceSamples* samples,
                      swVec2* slopes, swQueryStats* stats)
{
    swQueryStats total = {0};
    Block block;
    for (int next = 0; next < count;)
    {
        next = fillBlock(query, next, count, points, samples, slopes, &block, &total);
        if (block.count > 0)
        {
            queryParticleBlock(query, &block, samples, slopes);
        }
        total.convergedCount += block.count;
        total.iterationCount += block.count;
    }
    if (stats != NULL)
    {
        *stats = total;
    }
}

// ---- height maps ----

// A stretch of a row at a time. To begin each search where the neighbour's ended was tried: it saves one evaluation in
// seventy on half a metre's spacing and costs one in five on seven metres'.
void swQueryHeightMap(const swQuery* query, const swHeightMapDef* map, float* heights, swQueryStats* stats)
{
    swQueryStats total = {0};
    for (int column = 0; column < map->width; column += SW_QUERY_BLOCK)
    {
        int count = map->width - column < SW_QUERY_BLOCK ? map->width - column : SW_QUERY_BLOCK;
        for (int row = 0; row < map->height; ++row)
        {
            swPosXZ points[SW_QUERY_BLOCK];
            for (int i = 0; i < count; ++i)
            {
                points[i].x = map->originX + map->spacing * (column + i);
                points[i].z = map->originZ + map->spacing * row;
            }
            float* stretch = heights + (size_t)row * (size_t)map->width + (size_t)column;
            const swSurfaceSamples samples = {.height = stretch};
            Block block;
            fillBlock(query, 0, count, points, &samples, NULL, &block, &total);
            if (block.count > 0)
            {
                querySurfaceBlock(query, &block, &samples, &total);
            }
        }
    }
    if (stats != NULL)
    {
        *stats = total;
    }
}
