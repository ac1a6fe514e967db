// SPDX-License-Identifier: MIT
// Rays against the surface. Along a ray the gap to the water below is a function of distance; its first change of sign
// is looked for by marching, then closed in on by bisection with secants [Dowell and Jarratt 1971]. A step is as long
// as the gap allows where slopes stay below one, but at least a quarter of the shortest wave that counts.
//
// Far above or below there is nothing to meet: the march is confined to heights that six standard deviations of the sea
// can reach. Rays march together, so that each look at the surface is one batch.
//
// A ray that cannot be followed (NaN, an infinite or empty direction, a length out of range) is answered with NaN and
// counted; it has no part in the blocks of others.
//
// Where the water is cut away a ray goes on behind the crossing, on the other side.
//
// A sphere's gap is its centre's distance from the plane that touches the surface below it, less the radius.

#include "core/query/raycast.h"

#include <math.h>
#include <string.h>

#include "core/frame/asked.h"
#include "core/input/sample_clip.h"
#include "core/query/answers.h"
#include "core/surface/search.h"

#define RAY_BLOCK 24 // rays that march together
#define MAX_STEPS 100000
#define MAX_REFINEMENTS 60

typedef struct March
{
    const swRay* ray;
    double x, y, z;       // unit direction
    double end;           // distance where it leaves the heights that count
    double at;            // distance of the next look
    double before, after; // around the sign change
    float gapBefore, gapAfter;
    float side; // +1: began above, -1: below
    bool hasLooked, isRefining, isDone;
    int refinements;
    int index; // of the ray
} March;

typedef struct Look
{
    float gap;
    swVec3 normal;
    double height; // of the water, above still water
} Look;

static float findReach(const swQuery* query)
{
    float variance = 0.0f;
    float sum = 0.0f;
    for (int i = 0; i < query->tileCount; ++i)
    {
        variance += swIsTileAsked(query, &query->tiles[i]) ? query->tiles[i].variance : 0.0f;
    }
    for (int i = 0; i < query->waveCount; ++i)
    {
        sum += query->waves[i].amplitude;
    }
    float reach = 6.0f * sqrtf(variance) + sum;
    const swInputSet* inputs = query->inputs;
    return inputs == NULL ? reach : reach * inputs->weightReach + inputs->displacementReach;
}

static double findShortest(const swQuery* query)
{
    float shortest = INFINITY;
    for (int i = 0; i < query->tileCount; ++i)
    {
        const swTile* tile = &query->tiles[i];
        shortest = swIsTileAsked(query, tile) ? fminf(shortest, tile->minWavelength) : shortest;
    }
    if (query->waveCount > 0)
    {
        shortest = fminf(shortest, query->waves[query->waveCount - 1].wavelength);
    }
    return isinf(shortest) ? 1000.0 : (double)shortest;
}

// The part of the ray within `reach` of still water, wherever that may stand; false if there is none.
static bool clipRay(const swQuery* query, double reach, March* march)
{
    double y = march->ray->origin.y - query->seaLevel;
    double low = (double)query->lowestLevel - reach, high = (double)query->highestLevel + reach;
    double begin = 0.0;
    double end = (double)march->ray->maxDistance;
    if (march->y != 0.0)
    {
        double a = (low - y) / march->y;
        double b = (high - y) / march->y;
        begin = fmax(begin, fmin(a, b));
        end = fmin(end, fmax(a, b));
    }
    else if (y < low || y > high)
    {
        return false;
    }
    march->at = begin;
    march->end = end;
    return begin <= end;
}

static bool canCast(const swQuery* query, const swRay* ray)
{
    swPosXZ place;
    return swIsRayGood(ray) && swPlacePoint(query, ray->origin.x, ray->origin.z, &place);
}

static void beginMarch(const swQuery* query, const swRay* ray, float reach, March* march)
{
    memset(march, 0, sizeof *march);
    march->ray = ray;
    double length = swGetRayLength(ray);
    march->x = (double)ray->direction.x / length;
    march->y = (double)ray->direction.y / length;
    march->z = (double)ray->direction.z / length;
    // A hair more, so that a ray that ends on flat water meets it.
    march->isDone = !clipRay(query, (double)reach + (double)ray->radius + 0.001, march);
}

static swPosXZ getPlace(const swQuery* query, const March* march)
{
    return (swPosXZ){march->ray->origin.x + march->x * march->at + query->origin.x,
                     march->ray->origin.z + march->z * march->at + query->origin.z};
}

static float makeGap(const swQuery* query, const March* march, const Look* look)
{
    double y = march->ray->origin.y + march->y * march->at - query->seaLevel;
    return (float)((y - look->height) * (double)look->normal.y);
}

// The surface below each march's next look. Returns how often it was evaluated.
static int lookAtOnce(const swQuery* query, int count, March* const* marches, Look* looks)
{
    swPosXZ places[RAY_BLOCK] = {{0.0, 0.0}}; // compilers do not see that count is not 0
    bool needsNormals = false;
    for (int i = 0; i < count; ++i)
    {
        places[i] = getPlace(query, marches[i]);
        needsNormals = needsNormals || marches[i]->ray->radius > 0.0f || marches[i]->refinements > 0;
    }
    float gradients[RAY_BLOCK][8];
    swFound found;
    found.gradients = needsNormals ? gradients : NULL;
    swFindParticles(query, count, places, NULL, &found);
    for (int i = 0; i < count; ++i)
    {
        float jacobian;
        looks[i].height = (double)found.levels[i] + (double)found.displacement[i][1];
        looks[i].normal = needsNormals ? swMakeNormal(gradients[i], &jacobian) : (swVec3){0.0f, 1.0f, 0.0f};
        if (marches[i]->ray->radius == 0.0f)
        {
            looks[i].gap =
                (float)(marches[i]->ray->origin.y + marches[i]->y * marches[i]->at - query->seaLevel - looks[i].height);
        }
        else
        {
            looks[i].gap = makeGap(query, marches[i], &looks[i]);
        }
    }
    return found.evaluations;
}

// Rays whose way takes time look at different moments, one by one.
static int look(const swQuery* query, int count, March* const* marches, Look* looks)
{
    bool isStill = true;
    for (int i = 0; i < count; ++i)
    {
        isStill = isStill && marches[i]->ray->duration == 0.0f;
    }
    if (isStill)
    {
        return lookAtOnce(query, count, marches, looks);
    }
    int evaluations = 0;
    for (int i = 0; i < count; ++i)
    {
        const swRay* ray = marches[i]->ray;
        swQuery then = *query;
        double part = ray->maxDistance > 0.0f ? marches[i]->at / (double)ray->maxDistance : 0.0;
        then.ticks += (int64_t)floor(part * (double)ray->duration * SW_TICKS_PER_SECOND + 0.5);
        then.isNow = query->isNow && then.ticks == query->ticks;
        evaluations += lookAtOnce(&then, 1, &marches[i], &looks[i]);
    }
    return evaluations;
}

// Where the surface is crossed there is a hole: go on behind it. Of a sphere the place that it touches decides.
static bool passHole(const swQuery* query, March* march, const Look* look)
{
    double back = march->ray->radius > 0.0f ? (double)look->gap : 0.0;
    swPosXZ place = getPlace(query, march);
    place.x -= back * (double)look->normal.x;
    place.z -= back * (double)look->normal.z;
    if (query->clip == NULL || swFindClip(query->clip, place, (float)look->height) >= 0.0f)
    {
        return false;
    }
    // Farther than the crossing is exact, and than the sphere reaches.
    march->at += 4.0 * (double)query->def->tolerance + 2.0 * (double)march->ray->radius;
    march->hasLooked = march->isRefining = false;
    march->refinements = 0;
    march->isDone = march->at >= march->end;
    return true;
}

static void finishMarch(const swQuery* query, March* march, const Look* look, swRayHit* hit)
{
    const swRay* ray = march->ray;
    march->isDone = true;
    hit->isHit = true;
    hit->distance = (float)march->at;
    hit->position.x = ray->origin.x + march->x * march->at;
    hit->position.y = ray->origin.y + march->y * march->at;
    hit->position.z = ray->origin.z + march->z * march->at;
    hit->normal = look->normal;
    hit->fromBelow = march->side < 0.0f;
    double back = (double)look->gap;
    hit->point.x = hit->position.x - back * (double)look->normal.x;
    hit->point.y =
        ray->radius > 0.0f ? hit->position.y - back * (double)look->normal.y : query->seaLevel + look->height;
    hit->point.z = hit->position.z - back * (double)look->normal.z;
    if (ray->radius == 0.0f)
    {
        hit->point.x = hit->position.x;
        hit->point.z = hit->position.z;
    }
}

// The next look of a march that has a change of sign between two distances.
static void refine(March* march)
{
    double a = march->before, b = march->after;
    double fa = (double)march->gapBefore, fb = (double)march->gapAfter;
    double secant = fa - fb != 0.0 ? a + (b - a) * fa / (fa - fb) : 0.5 * (a + b);
    bool isInside = secant > a && secant < b;
    march->at = isInside && march->refinements % 3 != 2 ? secant : 0.5 * (a + b);
    march->refinements += 1;
}

// Take in a look. `gap` is how far the sphere is from touching, positive on the side where it began.
static void advanceMarch(const swQuery* query, double shortest, March* march, const Look* look, swRayHit* hit)
{
    float radius = march->ray->radius;
    if (!march->hasLooked)
    {
        march->side = look->gap >= 0.0f ? 1.0f : -1.0f;
    }
    float gap = march->side * look->gap - radius;
    if (march->isRefining)
    {
        double width = march->after - march->before;
        if (fabsf(gap) <= query->def->tolerance || width < 1e-9 || march->refinements >= MAX_REFINEMENTS)
        {
            if (!passHole(query, march, look))
            {
                finishMarch(query, march, look, hit);
            }
            return;
        }
        *(gap > 0.0f ? &march->before : &march->after) = march->at;
        *(gap > 0.0f ? &march->gapBefore : &march->gapAfter) = gap;
        refine(march);
        return;
    }
    if (gap <= 0.0f)
    {
        march->after = march->at;
        march->gapAfter = gap;
        march->isRefining = true;
        if (!march->hasLooked) // it began there; look again for the normal
        {
            march->before = march->at;
            march->gapBefore = gap;
            march->refinements = MAX_REFINEMENTS;
            return;
        }
        refine(march);
        return;
    }
    march->hasLooked = true;
    march->before = march->at;
    march->gapBefore = gap;
    double sideways = sqrt(march->x * march->x + march->z * march->z);
    double step = 0.7 * (double)gap / (fabs(march->y) + sideways);
    double least = 0.25 * shortest / (sideways > 0.25 ? sideways : 0.25);
    step = step > least ? step : least;
    if (march->at >= march->end)
    {
        march->isDone = true;
        return;
    }
    march->at = fmin(march->at + step, march->end);
}

// Cast rays that have all begun. One that is not at its end when the looks are used up says how far it came.
static void castBlock(const swQuery* query, double shortest, int count, March* marches, swRayHit* hits,
                      swQueryStats* stats)
{
    for (int step = 0; step < MAX_STEPS; ++step)
    {
        March* active[RAY_BLOCK];
        int activeCount = 0;
        for (int i = 0; i < count; ++i)
        {
            active[activeCount] = &marches[i];
            activeCount += marches[i].isDone ? 0 : 1;
        }
        if (activeCount == 0)
        {
            break;
        }
        Look looks[RAY_BLOCK];
        stats->iterationCount += look(query, activeCount, active, looks);
        for (int i = 0; i < activeCount; ++i)
        {
            advanceMarch(query, shortest, active[i], &looks[i], &hits[active[i]->index]);
        }
    }
    for (int i = 0; i < count; ++i)
    {
        stats->convergedCount += marches[i].isDone ? 1 : 0;
        if (!marches[i].isDone)
        {
            hits[marches[i].index].distance = (float)marches[i].at;
        }
    }
}

static swRayHit makeBadHit(void)
{
    const swPos nowhere = {(double)NAN, (double)NAN, (double)NAN};
    return (swRayHit){.distance = SW_NO_NUMBER, .position = nowhere, .point = nowhere, .normal = SW_NO_VECTOR};
}

void swRefuseRays(int count, swRayHit* hits, swQueryStats* stats)
{
    for (int i = 0; i < count && hits != NULL; ++i)
    {
        hits[i] = makeBadHit();
    }
    swRefuseStats(count, stats);
}

void swCastRays(const swQuery* query, int count, const swRay* rays, swRayHit* hits, swQueryStats* stats)
{
    swQueryStats total = {0};
    float reach = findReach(query);
    double shortest = findShortest(query);
    March marches[RAY_BLOCK];
    int blockCount = 0;
    for (int i = 0; i < count; ++i)
    {
        if (!canCast(query, &rays[i]))
        {
            hits[i] = makeBadHit();
            total.badCount += 1;
        }
        else
        {
            hits[i] = (swRayHit){.distance = rays[i].maxDistance};
            beginMarch(query, &rays[i], reach, &marches[blockCount]);
            marches[blockCount++].index = i;
        }
        if (blockCount == RAY_BLOCK || i + 1 == count)
        {
            castBlock(query, shortest, blockCount, marches, hits, &total);
            blockCount = 0;
        }
    }
    if (stats != NULL)
    {
        *stats = total;
    }
}
