// SPDX-License-Identifier: MIT
// The sum of waves that their places shape. A look at waves, a copy, has a weight w and a way s: with a wave's
// displacement D, a particle that rests at x is displaced by w(x) D(x + s(x)); gradients follow by product and chain
// rule:
//   d/dx = w (dD/dx (1 + ds_x/dx) + dD/dz ds_z/dx) + dw/dx D,  and so along z.
// Where waves lie in coordinates of their own, their horizontal displacement is turned from there to the sea's axes, by
// an angle a(x): turned H = R(a) H has the gradient R dH + da R' H.
// Tiles are added one at a time, each with its shape, and free waves by octaves. Waves that are as they would be
// anywhere are added without a detour, and points of which all waves are so go the way of a sea without places. How a
// point's place changes with time makes no part of velocity and acceleration.

#include "core/surface/evaluate_shaped.h"

#include <string.h>

typedef swPointSums Sums[SW_PLACE_BLOCK];

// Points that are looked up together: as many as kernels work on at once, to spare the stack.
#define LOOK_BLOCK 8

// ---- one group of waves ----

// Horizontal displacement from a warp's axes to the sea's. Even and odd columns of texels are apart in the sums.
static void turn(const swWarp* warp, bool withSlopes, swPointSums* own)
{
    float c = warp->cosine, s = warp->sine;
    for (int x = 0; x < 8; x += 4)
    {
        int z = x + 2;
        float valueX = c * own->value[x] - s * own->value[z], valueZ = s * own->value[x] + c * own->value[z];
        own->value[x] = valueX;
        own->value[z] = valueZ;
        if (withSlopes)
        {
            float xx = c * own->alongX[x] - s * own->alongX[z], zx = s * own->alongX[x] + c * own->alongX[z];
            float xz = c * own->alongZ[x] - s * own->alongZ[z], zz = s * own->alongZ[x] + c * own->alongZ[z];
            own->alongX[x] = xx - warp->turnX * valueZ;
            own->alongX[z] = zx + warp->turnX * valueX;
            own->alongZ[x] = xz - warp->turnZ * valueZ;
            own->alongZ[z] = zz + warp->turnZ * valueX;
        }
    }
}

// Gradients by the source become those by the place at rest.
static void chain(const float way[4], swPointSums* own)
{
    for (int c = 0; c < 8; ++c)
    {
        float alongX = own->alongX[c] * (1.0f + way[0]) + own->alongZ[c] * way[2];
        own->alongZ[c] = own->alongX[c] * way[1] + own->alongZ[c] * (1.0f + way[3]);
        own->alongX[c] = alongX;
    }
}

// Add a look at waves to all, `own` and `all` being those of the block's point i.
static void addCopy(const swCopy* copy, int i, bool withSlopes, swPointSums* own, swPointSums* all)
{
    if (withSlopes && copy->hasWay)
    {
        chain(copy->way[i], own);
    }
    if (copy->warps != NULL)
    {
        turn(&copy->warps[i], withSlopes, own);
    }
    float weight = copy->weight[i];
    for (int c = 0; c < 8; ++c)
    {
        all->value[c] += weight * own->value[c];
    }
    for (int c = 0; c < 8 && withSlopes; ++c)
    {
        all->alongX[c] += weight * own->alongX[c] + copy->alongX[i] * own->value[c];
        all->alongZ[c] += weight * own->alongZ[c] + copy->alongZ[i] * own->value[c];
    }
}

// Waves of a group one by one, in the form that tiles have, added to `own`; of at most LOOK_BLOCK points.
static void sumGroup(const swQuery* query, const swWaveGroup* group, int field, int count, const swPosXZ* points,
                     bool withSlopes, swPointSums* own)
{
    float values[LOOK_BLOCK][4] = {{0.0f}};
    float gradients[LOOK_BLOCK][8] = {{0.0f}};
    const swSurfaceSums sums = {
        .displacement = field == 0 ? values : NULL,
        .gradients = withSlopes ? gradients : NULL,
        .velocity = field == 1 ? values : NULL,
        .acceleration = field == 2 ? values : NULL,
    };
    const swWaveSumJob job = {
        .tileCount = group->tile != NULL ? 1 : 0,
        .tiles = group->tile,
        .waveCount = group->waveCount,
        .waves = group->waves,
        .ticks = query->ticks,
        .count = count,
        .points = points,
        .surface = &sums,
    };
    swSumWaves(query->kernels, &job);
    for (int i = 0; i < count; ++i)
    {
        const float* g = gradients[i];
        const float alongX[3] = {g[0], g[4], g[2]}, alongZ[3] = {g[1], g[5], g[3]};
        for (int c = 0; c < 3; ++c)
        {
            own[i].value[c] += values[i][c];
            own[i].alongX[c] += alongX[c];
            own[i].alongZ[c] += alongZ[c];
        }
    }
}

static void look(const swQuery* query, const swWaveGroup* group, int field, int count, const swPosXZ* points,
                 bool withSlopes, swPointSums* own)
{
    if (group->tile != NULL && swHasTexels(query, field))
    {
        swAddTile(query->kernels, group->tile, field, count, points, NULL, withSlopes, own);
    }
    else
    {
        sumGroup(query, group, field, count, points, withSlopes, own);
    }
}

static int countLook(const swPlaceBlock* block, int first)
{
    return block->count - first < LOOK_BLOCK ? block->count - first : LOOK_BLOCK;
}

// By points, as the kernel of shaped tiles does it. Not inlined: the stack that it needs is not there together with
// that kernel's.
__attribute__((noinline)) static void addLookByPoints(const swQuery* query, const swWaveGroup* group, int field,
                                                      bool withSlopes, const swPlaceBlock* block, const swCopy* copy,
                                                      swPointSums* all)
{
    for (int first = 0; first < block->count; first += LOOK_BLOCK)
    {
        swPointSums own[LOOK_BLOCK];
        int count = countLook(block, first);
        memset(own, 0, sizeof own);
        look(query, group, field, count, copy->source + first, withSlopes, own);
        for (int i = 0; i < count; ++i)
        {
            addCopy(copy, first + i, withSlopes, &own[i], &all[first + i]);
        }
    }
}

static void addLook(const swQuery* query, const swWaveGroup* group, int field, bool withSlopes,
                    const swPlaceBlock* block, const swCopy* copy, swPointSums* all)
{
    if (copy->warps != NULL || group->tile == NULL || !swHasTexels(query, field))
    {
        addLookByPoints(query, group, field, withSlopes, block, copy, all);
        return;
    }
    const swTileShape shape = {copy->weight, copy->alongX, copy->alongZ, copy->hasWay ? copy->way : NULL};
    swAddTile(query->kernels, group->tile, field, block->count, copy->source, &shape, withSlopes, all);
}

static void addGroup(const swQuery* query, const swWaveGroup* group, int field, bool withSlopes, swPlaceBlock* block,
                     swPointSums* all)
{
    if (block->areAllAsked && swIsGroupPlain(block, group))
    {
        for (int first = 0; first < block->count; first += LOOK_BLOCK)
        {
            look(query, group, field, countLook(block, first), block->rest + first, withSlopes, all + first);
        }
        return;
    }
    for (int i = 0; i < swCountLooks(block, group); ++i)
    {
        swLook found;
        swFindLook(block, group, i, withSlopes, &found);
        for (int c = 0; c < found.copyCount; ++c)
        {
            addLook(query, group, field, withSlopes, block, &found.copies[c], all);
        }
    }
}

// ---- all of them ----

// Goes through the groups of waves that an evaluation asks for: tiles, then free waves.
typedef struct Groups
{
    const swQuery* query;
    const swWaveSumJob* asked;
    int tile, wave;
    swWaveGroup group;
} Groups;

static bool nextGroup(Groups* groups)
{
    const swQuery* query = groups->query;
    const swWaveSumJob* asked = groups->asked;
    while (groups->tile < query->tileCount)
    {
        const swTile* tile = &query->tiles[groups->tile++];
        if (swIsTileChosen(tile, asked->shortest, asked->longest))
        {
            groups->group = swGroupTile(tile);
            return true;
        }
    }
    if (groups->wave < asked->waveCount)
    {
        groups->group = swGroupFreeWaves(asked->waveCount - groups->wave, asked->waves + groups->wave);
        groups->wave += groups->group.waveCount;
        return true;
    }
    return false;
}

// Answers of the points that are asked for. `gradients` may be NULL.
static void evaluateField(const swQuery* query, const swWaveSumJob* asked, int field, swPlaceBlock* block,
                          float (*out)[4], float (*gradients)[8])
{
    Sums all;
    memset(all, 0, (size_t)block->count * sizeof all[0]);
    Groups groups = {.query = query, .asked = asked};
    while (nextGroup(&groups))
    {
        addGroup(query, &groups.group, field, gradients != NULL, block, all);
    }
    for (int i = 0; i < block->count; ++i)
    {
        float* g = gradients != NULL ? gradients[i] : NULL;
        if (block->isAsked[i])
        {
            swStorePointSums(query->kernels, 1, &all[i], out[i], g);
        }
        if (block->isAsked[i] && g != NULL)
        {
            g[6] = g[1] - g[2];
        }
    }
}

// Answers from point `first` on.
static swEvaluation skipPoints(const swEvaluation* out, int first)
{
    swEvaluation rest = *out;
    rest.displacement = out->displacement != NULL ? out->displacement + first : NULL;
    rest.gradients = out->gradients != NULL ? out->gradients + first : NULL;
    rest.velocity = out->velocity != NULL ? out->velocity + first : NULL;
    rest.acceleration = out->acceleration != NULL ? out->acceleration + first : NULL;
    return rest;
}

// Which points of a block have all waves as they would be anywhere.
static void findPlainPoints(const swQuery* query, const swWaveSumJob* asked, swPlaceBlock* block, bool* isPlain)
{
    Groups groups = {.query = query, .asked = asked};
    bool isAny = true;
    memset(isPlain, true, (size_t)block->count * sizeof(bool));
    while (isAny && nextGroup(&groups))
    {
        isAny = swIsGroupPlain(block, &groups.group) || swKeepPlainPoints(block, &groups.group, isPlain);
    }
}

// Evaluates the points of a block that are shaped, and says of all whether they are.
static void evaluateBlock(const swQuery* query, swPlaceBlock* block, const swEvaluation* out, bool* isPlain)
{
    const swWaveSumJob asked = swMakeSumJob(query, out, block->count, block->rest);
    float(*const fields[3])[4] = {out->displacement, out->velocity, out->acceleration};
    bool isShaped[SW_PLACE_BLOCK], isAny = false;
    findPlainPoints(query, &asked, block, isPlain);
    for (int i = 0; i < block->count; ++i)
    {
        isShaped[i] = !isPlain[i];
        isAny = isAny || isShaped[i];
    }
    swAskPoints(block, isShaped);
    for (int field = 0; field < 3 && isAny; ++field)
    {
        if (fields[field] != NULL)
        {
            evaluateField(query, &asked, field, block, fields[field], field == 0 ? out->gradients : NULL);
        }
    }
}

// Not inlined: what it needs shall not be on the stack together with what other points need.
__attribute__((noinline)) static void evaluateShapedPoints(const swQuery* query, int count, const swPosXZ* rest,
                                                           const swEvaluation* out, bool* isPlain)
{
    swPlaceBlock block;
    swWarp warps[SW_MAX_WARPS][SW_PLACE_BLOCK];
    for (int first = 0; first < count; first += SW_PLACE_BLOCK)
    {
        int some = count - first < SW_PLACE_BLOCK ? count - first : SW_PLACE_BLOCK;
        const swEvaluation own = skipPoints(out, first);
        swBeginPlaces(&block, query->places, warps, query->kernels, query->ticks, some, rest + first);
        evaluateBlock(query, &block, &own, isPlain + first);
    }
}

// Plain points that are evaluated together where others are between them, to spare the stack.
#define PLAIN_BLOCK 8

static void putRows(const int* which, int count, float (*from)[4], float (*to)[4])
{
    for (int i = 0; i < count && to != NULL; ++i)
    {
        memcpy(to[which[i]], from[i], sizeof from[i]);
    }
}

__attribute__((noinline)) static void evaluatePlainPoints(const swQuery* query, int count, const int* which,
                                                          const swPosXZ* rest, const swEvaluation* out)
{
    swPosXZ points[PLAIN_BLOCK] = {{0.0, 0.0}};
    float rows[3][PLAIN_BLOCK][4], gradients[PLAIN_BLOCK][8];
    swEvaluation own = *out;
    own.displacement = out->displacement != NULL ? rows[0] : NULL;
    own.velocity = out->velocity != NULL ? rows[1] : NULL;
    own.acceleration = out->acceleration != NULL ? rows[2] : NULL;
    own.gradients = out->gradients != NULL ? gradients : NULL;
    for (int i = 0; i < count; ++i)
    {
        points[i] = rest[which[i]];
    }
    swEvaluatePlain(query, count, points, &own);
    putRows(which, count, rows[0], out->displacement);
    putRows(which, count, rows[1], out->velocity);
    putRows(which, count, rows[2], out->acceleration);
    for (int i = 0; i < count && out->gradients != NULL; ++i)
    {
        memcpy(out->gradients[which[i]], gradients[i], sizeof gradients[i]);
    }
}

static void evaluatePlainOnes(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out,
                              const bool* isPlain)
{
    int which[PLAIN_BLOCK], some = 0;
    for (int i = 0; i < count; ++i)
    {
        which[some] = i;
        some += isPlain[i] ? 1 : 0;
        if (some == PLAIN_BLOCK || (some > 0 && i == count - 1))
        {
            evaluatePlainPoints(query, some, which, rest, out);
            some = 0;
        }
    }
}

// Sums wave by wave take less of the stack for a few points, and a guess is deep in it.
static void evaluateAllPlain(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    int most = query->isNow || out->places == NULL ? count : PLAIN_BLOCK;
    for (int first = 0; first < count; first += most)
    {
        const swEvaluation own = skipPoints(out, first);
        swEvaluatePlain(query, count - first < most ? count - first : most, rest + first, &own);
    }
}

// Whether a point's waves are shaped depends on the point alone, so that its bits do not depend on its neighbours.
void swEvaluateShaped(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    const swPlaces* places = query->places;
    uint32_t touched =
        out->places != NULL ? out->places->touched : swFindTouchedFields(places, query->ticks, count, rest, 0.0);
    if (places->localSystems == 0 && (touched & ~SW_TOUCHES_LEVEL) == 0)
    {
        evaluateAllPlain(query, count, rest, out);
        return;
    }
    bool isPlain[SW_QUERY_BLOCK];
    if (out->places != NULL)
    {
        swMovePlaces(out->places, rest);
        evaluateBlock(query, out->places, out, isPlain);
    }
    else
    {
        evaluateShapedPoints(query, count, rest, out, isPlain);
    }
    int plainCount = 0;
    for (int i = 0; i < count; ++i)
    {
        plainCount += isPlain[i] ? 1 : 0;
    }
    if (plainCount == count)
    {
        evaluateAllPlain(query, count, rest, out);
    }
    else if (plainCount > 0)
    {
        evaluatePlainOnes(query, count, rest, out, isPlain);
    }
}
