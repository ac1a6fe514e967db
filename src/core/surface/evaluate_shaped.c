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
    if (withSlopes)
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
        swAddTile(query->kernels, group->tile, field, count, points, withSlopes, own);
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

static void addLook(const swQuery* query, const swWaveGroup* group, int field, bool withSlopes,
                    const swPlaceBlock* block, const swCopy* copy, swPointSums* all)
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

static void addGroup(const swQuery* query, const swWaveGroup* group, int field, bool withSlopes, swPlaceBlock* block,
                     swPointSums* all)
{
    bool isPlain = swIsGroupPlain(block, group);
    for (int first = 0; first < block->count && isPlain; first += LOOK_BLOCK)
    {
        look(query, group, field, countLook(block, first), block->rest + first, withSlopes, all + first);
    }
    if (isPlain)
    {
        return;
    }
    for (int i = 0; i < swCountLooks(block, group); ++i)
    {
        swLook found;
        swFindLook(block, group, i, &found);
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

// `gradients` may be NULL.
static void evaluateField(const swQuery* query, const swWaveSumJob* asked, int field, swPlaceBlock* block,
                          float (*out)[4], float (*gradients)[8])
{
    Sums all;
    memset(all, 0, sizeof all);
    Groups groups = {.query = query, .asked = asked};
    while (nextGroup(&groups))
    {
        addGroup(query, &groups.group, field, gradients != NULL, block, all);
    }
    swStorePointSums(query->kernels, block->count, all, out[0], gradients != NULL ? gradients[0] : NULL);
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

static void evaluateBlock(const swQuery* query, const swWaveSumJob* asked, swPlaceBlock* block, const swEvaluation* out)
{
    float(*const fields[3])[4] = {out->displacement, out->velocity, out->acceleration};
    for (int field = 0; field < 3; ++field)
    {
        if (fields[field] != NULL)
        {
            evaluateField(query, asked, field, block, fields[field], field == 0 ? out->gradients : NULL);
        }
    }
}

// Which points of a block have all waves as they would be anywhere. Returns whether all do.
static bool findPlainPoints(const swQuery* query, const swWaveSumJob* asked, swPlaceBlock* block, bool* isPlain)
{
    Groups groups = {.query = query, .asked = asked};
    bool areAll = true;
    memset(isPlain, true, (size_t)block->count * sizeof(bool));
    while (nextGroup(&groups))
    {
        if (!swIsGroupPlain(block, &groups.group))
        {
            areAll = swKeepPlainPoints(block, &groups.group, isPlain) && areAll;
        }
    }
    return areAll;
}

// Evaluates the points that are shaped, and says of all whether they are. Not inlined: what it needs shall not be on
// the stack together with what other points need.
__attribute__((noinline)) static void evaluateShapedPoints(const swQuery* query, int count, const swPosXZ* rest,
                                                           const swEvaluation* out, bool* isPlain)
{
    for (int first = 0; first < count; first += SW_PLACE_BLOCK)
    {
        int some = count - first < SW_PLACE_BLOCK ? count - first : SW_PLACE_BLOCK;
        const swWaveSumJob asked = swMakeSumJob(query, out, some, rest + first);
        swPlaceBlock block;
        swBeginPlaces(&block, query->places, query->kernels, query->ticks, some, rest + first);
        if (!findPlainPoints(query, &asked, &block, isPlain + first))
        {
            const swEvaluation own = skipPoints(out, first);
            evaluateBlock(query, &asked, &block, &own);
        }
    }
}

// Whether a point's waves are shaped depends on the point alone, so that its bits do not depend on its neighbours.
void swEvaluateShaped(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out)
{
    const swPlaces* places = query->places;
    if (places->localSystems == 0 &&
        (swFindTouchedFields(places, query->ticks, count, rest, 0.0) & ~SW_TOUCHES_LEVEL) == 0)
    {
        swEvaluatePlain(query, count, rest, out);
        return;
    }
    bool isPlain[SW_QUERY_BLOCK + 1];
    isPlain[count] = false;
    evaluateShapedPoints(query, count, rest, out, isPlain);
    for (int begin = 0; begin < count; ++begin)
    {
        int end = begin;
        while (isPlain[end])
        {
            end += 1;
        }
        if (end > begin)
        {
            const swEvaluation own = skipPoints(out, begin);
            swEvaluatePlain(query, end - begin, rest + begin, &own);
            begin = end;
        }
    }
}
