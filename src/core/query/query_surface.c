// SPDX-License-Identifier: MIT
#include "core/query/query_surface.h"

#include "core/input/sample_clip.h"
#include "core/query/answers.h"
#include "core/surface/search.h"

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
    if (samples->isClipped != NULL)
    {
        samples->isClipped[point] = false;
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
                         const float* levels, float (*gradients)[8], const float* residuals)
{
    writeVectors(samples->displacement, block, displacement);
    for (int i = 0; i < block->count; ++i)
    {
        int point = block->at[i];
        if (samples->height != NULL)
        {
            samples->height[point] = (float)(seaLevel + (double)levels[i] + (double)displacement[i][1]);
        }
        if (samples->residual != NULL)
        {
            samples->residual[point] = residuals != NULL ? residuals[i] : 0.0f;
        }
        if (gradients == NULL && samples->normal == NULL && samples->jacobian == NULL)
        {
            continue;
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

// Whether particles are in holes, where they are.
static void writeClips(const swQuery* query, const swSurfaceSamples* samples, const Block* block, const swPosXZ* rest,
                       float (*displacement)[4], const float* levels)
{
    for (int i = 0; i < block->count && samples->isClipped != NULL; ++i)
    {
        const swPosXZ place = {rest[i].x + (double)displacement[i][0], rest[i].z + (double)displacement[i][2]};
        samples->isClipped[block->at[i]] = swFindClip(query->clip, place, levels[i] + displacement[i][1]) < 0.0f;
    }
}

static bool wantsGradients(const swSurfaceSamples* samples)
{
    return samples->normal != NULL || samples->jacobian != NULL;
}

// How particles that rest at `rest`, and are at the block's places, move: by the waves, and with the flow there.
static void sampleMotion(const swQuery* query, const swSurfaceSamples* samples, const Block* block, const swPosXZ* rest,
                         const swPosXZ* places)
{
    float velocity[SW_QUERY_BLOCK][4];
    float acceleration[SW_QUERY_BLOCK][4];
    const swEvaluation evaluation = {
        .velocity = samples->velocity != NULL ? velocity : NULL,
        .acceleration = samples->acceleration != NULL ? acceleration : NULL,
    };
    swEvaluate(query, block->count, rest, &evaluation);
    if (samples->velocity != NULL)
    {
        swAddFlow(query->places, query->ticks, block->count, places, velocity);
    }
    writeVectors(samples->velocity, block, velocity);
    writeVectors(samples->acceleration, block, acceleration);
}

static void querySurfaceBlock(const swQuery* query, const Block* block, const swSurfaceSamples* samples,
                              swQueryStats* stats)
{
    float gradients[SW_QUERY_BLOCK][8];
    swSurfaceHint* hints[SW_QUERY_BLOCK];
    swFound found;
    found.gradients = wantsGradients(samples) ? gradients : NULL;
    for (int i = 0; i < block->count && samples->hints != NULL; ++i)
    {
        hints[i] = &samples->hints[block->at[i]];
    }
    swFindParticles(query, block->count, block->places, samples->hints != NULL ? hints : NULL, &found);
    writeSamples(samples, query->seaLevel, block, found.displacement, found.levels, found.gradients, found.residual);
    writeClips(query, samples, block, found.rest, found.displacement, found.levels);
    if (samples->velocity != NULL || samples->acceleration != NULL)
    {
        sampleMotion(query, samples, block, found.rest, block->places);
        found.evaluations += block->count;
    }
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

double swFindHeight(const swQuery* query, double x, double z)
{
    swPosXZ place;
    if (!swPlacePoint(query, x, z, &place))
    {
        return (double)NAN;
    }
    swFound found;
    found.gradients = NULL;
    swFindParticles(query, 1, &place, NULL, &found);
    return query->seaLevel + (double)found.levels[0] + (double)found.displacement[0][1];
}

static void queryParticleBlock(const swQuery* query, const Block* block, const swSurfaceSamples* samples,
                               swVec2* slopes)
{
    float displacement[SW_QUERY_BLOCK][4];
    float gradients[SW_QUERY_BLOCK][8];
    float levels[SW_QUERY_BLOCK];
    bool withGradients = wantsGradients(samples) || slopes != NULL;
    const swEvaluation evaluation = {
        .displacement = displacement, .levels = levels, .gradients = withGradients ? gradients : NULL};
    swEvaluate(query, block->count, block->places, &evaluation);
    writeSamples(samples, query->seaLevel, block, displacement, levels, withGradients ? gradients : NULL, NULL);
    writeClips(query, samples, block, block->places, displacement, levels);
    if (samples->velocity != NULL || samples->acceleration != NULL)
    {
        swPosXZ places[SW_QUERY_BLOCK];
        for (int i = 0; i < block->count; ++i)
        {
            places[i] = (swPosXZ){block->places[i].x + (double)displacement[i][0],
                                  block->places[i].z + (double)displacement[i][2]};
        }
        sampleMotion(query, samples, block, block->places, places);
    }
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
            Block block; // its places are the points first: none is written before it has been read
            for (int i = 0; i < count; ++i)
            {
                block.places[i].x = map->originX + map->spacing * (column + i);
                block.places[i].z = map->originZ + map->spacing * row;
            }
            float* stretch = heights + (size_t)row * (size_t)map->width + (size_t)column;
            const swSurfaceSamples samples = {.height = stretch};
            fillBlock(query, 0, count, block.places, &samples, NULL, &block, &total);
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
