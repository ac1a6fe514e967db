// SPDX-License-Identifier: MIT
// Heights from tiles that displace sideways too. The water above q belongs to the particle that rests at u with
// u + D(u) = q. With the offset d = u - q this is a root of r(d) = d + D(q + d), two equations in two unknowns.
//
// It begins with a guess: long waves first. They are evaluated with gradients, where the point is, and Newton's step
// says where they would have the particle; there waves of an eighth of the length come, and so on. Waves that have been
// evaluated count from then on by their tangent planes, so that each is evaluated once, at a place that those longer
// than it have made good to a share of its own length. Before the last step the waves of the middle, whose tangents the
// shorter ones have moved most on, are evaluated once more. A point that was asked about in the step before (a hint)
// begins where its particle should have gone by now instead.
//
// From there all waves are evaluated until the residual is within the tolerance, as a rule once or twice, by a
// quasi-Newton iteration: the inverse Jacobian starts as the tangents' (of a hint as the identity, since its residual
// is small) and is corrected after each step by what the residual did [Broyden 1965]. That needs no gradients, which
// cost half as much again. A step that made the residual worse is taken back and tried again shorter.
//
// Points run in blocks, and within a block the kernels see only points that are not yet done. A point's iteration
// depends on nothing but itself and its hint, so its bits do not depend on the batch that it came in.
//
// Offsets are float: they are metres at most. q + d is double, so the answer is as good far away as at the origin.

#include "core/surface/search.h"

#include "core/surface/displace.h"

#include <math.h>
#include <string.h>

// ---- the guess ----

// Points that are guessed together: fewer than a block's, to spare the stack.
#define GUESS_BLOCK 32

// Displacement of some waves near the offsets being tried, as planes.
typedef struct Tangents
{
    float x[GUESS_BLOCK], z[GUESS_BLOCK]; // at the offsets
    float xx[GUESS_BLOCK], xz[GUESS_BLOCK], zx[GUESS_BLOCK], zz[GUESS_BLOCK];
} Tangents;

typedef struct Guess
{
    int count;
    swPosXZ points[GUESS_BLOCK];
    float dx[GUESS_BLOCK], dz[GUESS_BLOCK];                                       // offsets
    float b00[GUESS_BLOCK], b01[GUESS_BLOCK], b10[GUESS_BLOCK], b11[GUESS_BLOCK]; // inverse Jacobian
    Tangents middle; // of waves that will be evaluated once more
    Tangents others;
    swPlaceBlock* places; // of the points, moved along, or NULL
} Guess;

// Wavelengths that part the passes. The first holds waves so long that the horizontal displacement of all, by which
// their tangents are off at first, bends them little; measured in seas from a breeze to a gale.
#define LONG_WAVES 72.0f // in root mean squares of the displacement
#define PASS_RATIO 0.125f
#define PASSES 4

// Waves shorter than this many tolerances displace by less than one.
#define NEGLIGIBLE 100.0f

static void placeGuess(const Guess* guess, swPosXZ* tried)
{
    for (int i = 0; i < guess->count; ++i)
    {
        tried[i].x = guess->points[i].x + (double)guess->dx[i];
        tried[i].z = guess->points[i].z + (double)guess->dz[i];
    }
}

static bool hasWaves(const swQuery* query, float shortest, float longest)
{
    for (int i = 0; i < query->tileCount; ++i)
    {
        if (swIsTileAsked(query, &query->tiles[i]) && swIsTileChosen(&query->tiles[i], shortest, longest))
        {
            return true;
        }
    }
    for (int i = 0; i < query->waveCount; ++i)
    {
        float wavelength = query->waves[i].wavelength;
        if (wavelength >= shortest && (longest <= 0.0f || wavelength < longest))
        {
            return true;
        }
    }
    return false;
}

// Add waves in (shortest, longest] to tangents, at the offsets. Returns whether there are any.
static bool addTangents(const swQuery* query, const Guess* guess, float shortest, float longest, Tangents* tangents)
{
    if (!hasWaves(query, shortest, longest))
    {
        return false;
    }
    swPosXZ tried[GUESS_BLOCK];
    float displacement[GUESS_BLOCK][4];
    float gradients[GUESS_BLOCK][8];
    const swEvaluation evaluation = {.displacement = displacement,
                                     .gradients = gradients,
                                     .shortest = shortest,
                                     .longest = longest,
                                     .places = guess->places};
    placeGuess(guess, tried);
    swEvaluate(query, guess->count, tried, &evaluation);
    for (int i = 0; i < guess->count; ++i)
    {
        tangents->x[i] += displacement[i][0];
        tangents->z[i] += displacement[i][2];
        tangents->xx[i] += gradients[i][0];
        tangents->xz[i] += gradients[i][1];
        tangents->zx[i] += gradients[i][2];
        tangents->zz[i] += gradients[i][3];
    }
    return true;
}

// Bring tangents through the waves at the offsets; their slopes stay. Not inlined, for the sake of the stack.
__attribute__((noinline)) static void touchAgain(const swQuery* query, const Guess* guess, float shortest,
                                                 float longest, Tangents* tangents)
{
    swPosXZ tried[GUESS_BLOCK];
    float displacement[GUESS_BLOCK][4];
    const swEvaluation evaluation = {
        .displacement = displacement, .shortest = shortest, .longest = longest, .places = guess->places};
    placeGuess(guess, tried);
    swEvaluate(query, guess->count, tried, &evaluation);
    for (int i = 0; i < guess->count; ++i)
    {
        tangents->x[i] = displacement[i][0];
        tangents->z[i] = displacement[i][2];
    }
}

static void moveTangents(Tangents* t, int i, float stepX, float stepZ)
{
    t->x[i] += t->xx[i] * stepX + t->xz[i] * stepZ;
    t->z[i] += t->zx[i] * stepX + t->zz[i] * stepZ;
}

// Newton's step on the tangents. Where the surface nearly folds its gradient has no meaning, and the step is the
// fixed-point iteration's.
static void stepGuess(Guess* guess)
{
    const Tangents* m = &guess->middle;
    const Tangents* o = &guess->others;
    for (int i = 0; i < guess->count; ++i)
    {
        float a = 1.0f + (m->xx[i] + o->xx[i]), b = m->xz[i] + o->xz[i];
        float c = m->zx[i] + o->zx[i], d = 1.0f + (m->zz[i] + o->zz[i]);
        float jacobian = a * d - b * c;
        bool isSafe = jacobian > 0.25f;
        float inverse = 1.0f / (isSafe ? jacobian : 1.0f);
        guess->b00[i] = isSafe ? d * inverse : 1.0f;
        guess->b01[i] = isSafe ? -b * inverse : 0.0f;
        guess->b10[i] = isSafe ? -c * inverse : 0.0f;
        guess->b11[i] = isSafe ? a * inverse : 1.0f;
        float rx = guess->dx[i] + m->x[i] + o->x[i];
        float rz = guess->dz[i] + m->z[i] + o->z[i];
        float stepX = -(guess->b00[i] * rx + guess->b01[i] * rz);
        float stepZ = -(guess->b10[i] * rx + guess->b11[i] * rz);
        guess->dx[i] += stepX;
        guess->dz[i] += stepZ;
        moveTangents(&guess->middle, i, stepX, stepZ);
        moveTangents(&guess->others, i, stepX, stepZ);
    }
}

// Returns how often all waves were evaluated, more or less.
static int makeGuess(const swQuery* query, Guess* guess)
{
    memset(&guess->middle, 0, sizeof guess->middle);
    memset(&guess->others, 0, sizeof guess->others);
    float tolerance = query->def->tolerance;
    if (query->sideways <= tolerance)
    {
        return 0;
    }
    float first = LONG_WAVES * query->sideways;
    float middle[2] = {first * PASS_RATIO, first * 2.0f}; // waves of the first two passes
    float shortest = first;
    float longest = middle[1];
    float top = query->waveCount == 0 ? query->longestFelt : 0.0f;
    addTangents(query, guess, longest, top, &guess->others);
    for (int pass = 0; pass < PASSES && longest > NEGLIGIBLE * tolerance; ++pass)
    {
        bool isLast = pass == PASSES - 1;
        bool isMiddle = pass < 2;
        bool isNew =
            addTangents(query, guess, isLast ? 0.0f : shortest, longest, isMiddle ? &guess->middle : &guess->others);
        if (isLast)
        {
            touchAgain(query, guess, middle[0], middle[1], &guess->middle);
        }
        if (isNew || isLast || pass == 0)
        {
            stepGuess(guess);
        }
        longest = shortest;
        shortest *= PASS_RATIO;
    }
    return 1;
}

// ---- the search ----

typedef struct swSearch
{
    float dx, dz; // offset being tried
    float rx, rz; // its residual
    float bestX, bestZ;
    float bestRx, bestRz;
    float bestSquare;         // of the best residual
    float b00, b01, b10, b11; // inverse Jacobian
    float reach;              // share of the full step, below 1 after a bad one
    bool isWarm;              // began where its hint said
} swSearch;
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

// Go on from the best place without what steps have told of the Jacobian: at the edge of an input that shapes waves it
// jumps, and what was learnt on one side leads astray on the other.
static void beginAnew(swSearch* search)
{
    search->b00 = search->b11 = 1.0f;
    search->b01 = search->b10 = 0.0f;
    search->reach = 1.0f;
    search->dx = search->bestX - search->bestRx;
    search->dz = search->bestZ - search->bestRz;
}

// Where a hint says that the particle should be by now: along a parabola through the last three searches.
#define HINT_SECONDS 0.25
#define FARTHEST_HINT 1e4f // m

static void followHint(const swSurfaceHint* hint, double time, swSearch* search)
{
    double step = time - hint->time;
    if (hint->searchCount <= 0 || !(fabs(step) <= HINT_SECONDS))
    {
        return;
    }
    float t = (float)step;
    float rate = hint->searchCount > 1 ? t : 0.0f;
    float bend = hint->searchCount > 2 ? t * (t + hint->lastStep) : 0.0f;
    float x = hint->offsetX + rate * hint->rateX + bend * hint->bendX;
    float z = hint->offsetZ + rate * hint->rateZ + bend * hint->bendZ;
    search->isWarm = fabsf(x) < FARTHEST_HINT && fabsf(z) < FARTHEST_HINT; // and no NaN
    search->dx = search->isWarm ? x : 0.0f;
    search->dz = search->isWarm ? z : 0.0f;
}

// The offset that the last residual says, a step farther than the answer: differences of answers would be rough.
static void writeHint(const swSearch* search, double time, swSurfaceHint* hint)
{
    float x = search->bestX - (search->b00 * search->bestRx + search->b01 * search->bestRz);
    float z = search->bestZ - (search->b10 * search->bestRx + search->b11 * search->bestRz);
    double step = time - hint->time;
    if (!search->isWarm)
    {
        *hint = (swSurfaceHint){.time = time, .offsetX = x, .offsetZ = z, .searchCount = 1};
        return;
    }
    if (step != 0.0)
    {
        float rateX = (x - hint->offsetX) / (float)step;
        float rateZ = (z - hint->offsetZ) / (float)step;
        float both = (float)step + hint->lastStep;
        bool canBend = hint->searchCount > 1 && both != 0.0f;
        hint->bendX = canBend ? (rateX - hint->rateX) / both : 0.0f;
        hint->bendZ = canBend ? (rateZ - hint->rateZ) / both : 0.0f;
        hint->rateX = rateX;
        hint->rateZ = rateZ;
        hint->lastStep = (float)step;
        hint->time = time;
        hint->searchCount = canBend ? 3 : 2;
    }
    hint->offsetX = x;
    hint->offsetZ = z;
}

// Guess where the particles above some of a block's points are, for their searches to begin there. Returns how often
// all waves were evaluated. Not inlined: what it needs shall not be on the stack together with what the search needs.
__attribute__((noinline)) static int guessSome(const swQuery* query, int count, const int* cold, const swPosXZ* points,
                                               swPlaceBlock* places, swSearch* searches)
{
    Guess guess;
    guess.count = count;
    guess.places = places;
    for (int i = 0; i < count; ++i)
    {
        guess.points[i] = points[cold[i]];
        guess.dx[i] = guess.dz[i] = 0.0f;
    }
    int evaluations = makeGuess(query, &guess);
    for (int i = 0; i < count && evaluations > 0; ++i)
    {
        swSearch* search = &searches[cold[i]];
        search->dx = guess.dx[i];
        search->dz = guess.dz[i];
        search->b00 = guess.b00[i];
        search->b01 = guess.b01[i];
        search->b10 = guess.b10[i];
        search->b11 = guess.b11[i];
    }
    return evaluations * count;
}

// Not inlined, for the sake of the stack.
__attribute__((noinline)) static void beginPlaces(const swQuery* query, int count, const int* cold,
                                                  const swPosXZ* points, swPlaceBlock* places)
{
    swPosXZ own[SW_PLACE_BLOCK];
    for (int i = 0; i < count; ++i)
    {
        own[i] = points[cold[i]];
    }
    swBeginPlaces(places, query->places, NULL, query->kernels, query->ticks, count, own);
}

// The same where waves are shaped by their places: those are looked up once, unless waves have coordinates of their
// own.
__attribute__((noinline)) static int guessShaped(const swQuery* query, int count, const int* cold,
                                                 const swPosXZ* points, swSearch* searches)
{
    swPlaceBlock places;
    beginPlaces(query, count, cold, points, &places);
    return guessSome(query, count, cold, points, &places, searches);
}

// Points without a hint get a guess.
static int beginSearches(const swQuery* query, int count, const swPosXZ* points, swSurfaceHint* const* hints,
                         swSearch* searches)
{
    int cold[SW_QUERY_BLOCK];
    int coldCount = 0;
    double time = (double)query->ticks / SW_TICKS_PER_SECOND;
    for (int i = 0; i < count; ++i)
    {
        searches[i] = (swSearch){.b00 = 1.0f, .b11 = 1.0f, .bestSquare = INFINITY, .reach = 1.0f};
        if (hints != NULL)
        {
            followHint(hints[i], time, &searches[i]);
        }
        cold[coldCount] = i;
        coldCount += searches[i].isWarm ? 0 : 1;
    }
    int evaluations = 0;
    bool holdsPlaces = query->places != NULL && query->places->warps == NULL;
    int most = holdsPlaces ? SW_PLACE_BLOCK : GUESS_BLOCK;
    for (int first = 0; first < coldCount; first += most)
    {
        int some = coldCount - first < most ? coldCount - first : most;
        evaluations += holdsPlaces ? guessShaped(query, some, cold + first, points, searches)
                                   : guessSome(query, some, cold + first, points, NULL, searches);
    }
    return evaluations;
}

// Evaluate all waves until each point is done.
__attribute__((noinline)) static int runSearches(const swQuery* query, int count, const swPosXZ* points,
                                                 swSearch* searches, swFound* found)
{
    swPosXZ tried[SW_QUERY_BLOCK];
    float displacement[SW_QUERY_BLOCK][4];
    float gradients[SW_QUERY_BLOCK][8];
    int active[SW_QUERY_BLOCK];
    int activeCount = count;
    int evaluations = 0;
    float toleranceSquare = query->def->tolerance * query->def->tolerance;
    for (int i = 0; i < count; ++i)
    {
        active[i] = i;
        searches[i].bestX = searches[i].dx;
        searches[i].bestZ = searches[i].dz;
    }
    const swEvaluation evaluation = {.displacement = displacement,
                                     .gradients = found->gradients != NULL ? gradients : NULL};
    for (int iteration = 0; iteration < query->def->maxIterations && activeCount > 0; ++iteration)
    {
        for (int i = 0; i < activeCount; ++i)
        {
            const swSearch* search = &searches[active[i]];
            tried[i].x = points[active[i]].x + (double)search->dx;
            tried[i].z = points[active[i]].z + (double)search->dz;
        }
        swEvaluate(query, activeCount, tried, &evaluation);
        evaluations += activeCount;
        bool isAnew = query->places != NULL && iteration == query->def->maxIterations / 2;
        int stillActive = 0;
        for (int i = 0; i < activeCount; ++i)
        {
            int point = active[i];
            float before = searches[point].bestSquare;
            bool isDone = !advanceSearch(&searches[point], displacement[i], toleranceSquare);
            if (isAnew && !isDone)
            {
                beginAnew(&searches[point]);
            }
            if (searches[point].bestSquare < before)
            {
                memcpy(found->displacement[point], displacement[i], sizeof displacement[i]);
                if (found->gradients != NULL)
                {
                    memcpy(found->gradients[point], gradients[i], sizeof gradients[i]);
                }
            }
            active[stillActive] = point;
            stillActive += isDone ? 0 : 1;
        }
        activeCount = stillActive;
    }
    return evaluations;
}

// Whether nothing shapes the water as far around a block as its searches may come: it is then found out once, instead
// of at each of the places that they try. Water that nothing shapes has the same bits either way.
static bool isPlainAround(const swQuery* query, int count, const swPosXZ* points)
{
    const swPlaces* places = query->places;
    double reach = 256.0 + 16.0 * (double)query->sideways;
    return places->localSystems == 0 && swFindTouchedFields(places, query->ticks, count, points, reach) == 0;
}

void swFindParticles(const swQuery* query, int count, const swPosXZ* points, swSurfaceHint* const* hints,
                     swFound* found)
{
    swQuery plain;
    if (query->places != NULL && isPlainAround(query, count, points))
    {
        plain = *query;
        plain.places = NULL;
        query = &plain;
    }
    swSearch searches[SW_QUERY_BLOCK];
    found->evaluations = beginSearches(query, count, points, hints, searches);
    found->evaluations += runSearches(query, count, points, searches, found);
    double time = (double)query->ticks / SW_TICKS_PER_SECOND;
    for (int i = 0; i < count; ++i)
    {
        found->rest[i].x = points[i].x + (double)searches[i].bestX;
        found->rest[i].z = points[i].z + (double)searches[i].bestZ;
        found->residual[i] = sqrtf(searches[i].bestSquare);
        if (hints != NULL)
        {
            writeHint(&searches[i], time, hints[i]);
        }
    }
    swDisplaceHeights(query, count, found->rest, found->displacement, found->gradients);
    swFindLevels(query->places, query->ticks, count, found->rest, found->displacement, found->levels, found->gradients);
}
