// SPDX-License-Identifier: MIT
#include "core/surface/input_places.h"

#include <math.h>
#include <string.h>

#include "core/input/sample_inputs.h"
#include "shared/carry.h"
#include "shared/depth_share.h"

// The fields of inputs behind each of the places'.
static uint32_t findFields(uint32_t touches)
{
    return ((touches & SW_TOUCHES_LEVEL) != 0 ? SW_FIELD_BIT(SW_INPUT_LEVEL) : 0) |
           ((touches & SW_TOUCHES_DEPTH) != 0 ? SW_FIELD_BIT(SW_INPUT_FLOOR) : 0) |
           ((touches & (SW_TOUCHES_WEIGHT | SW_TOUCHES_WARP)) != 0 ? SW_FIELD_BIT(SW_INPUT_WAVES) : 0);
}

static const uint32_t allTouches[3] = {SW_TOUCHES_LEVEL, SW_TOUCHES_DEPTH, SW_TOUCHES_WEIGHT | SW_TOUCHES_WARP};

// Flows beside that which carries all waves alike.
static bool touchesOtherFlows(const swInputSet* set, const swCellBox* box)
{
    bool isFound = false;
    uint32_t next = set->hasOtherFlows ? swFindNextInput(set, SW_INPUT_FLOW, box, 0) : SW_NO_RECORD;
    while (next != SW_NO_RECORD && !isFound)
    {
        isFound = !set->hasEvenFlow || set->records[next].shape != SW_FORM_EVERYWHERE;
        next = swFindNextInput(set, SW_INPUT_FLOW, box, next + 1);
    }
    return isFound;
}

static uint32_t findTouched(const void* context, int64_t ticks, int count, const swPosXZ* points, double around)
{
    (void)ticks;
    double minX = points[0].x, maxX = points[0].x, minZ = points[0].z, maxZ = points[0].z;
    for (int i = 1; i < count; ++i)
    {
        minX = points[i].x < minX ? points[i].x : minX;
        maxX = points[i].x > maxX ? points[i].x : maxX;
        minZ = points[i].z < minZ ? points[i].z : minZ;
        maxZ = points[i].z > maxZ ? points[i].z : maxZ;
    }
    const swPosXZ middle = {0.5 * (minX + maxX), 0.5 * (minZ + maxZ)};
    double reach = fmax(maxX - middle.x, maxZ - middle.z) + around;
    swCellBox box;
    if (!swFindCellBox(middle, reach, &box))
    {
        return SW_TOUCHES_ALL;
    }
    uint32_t touched = touchesOtherFlows(context, &box) ? SW_TOUCHES_FLOW : 0;
    for (int i = 0; i < 3; ++i)
    {
        touched |= swTouchesInputs(context, findFields(allTouches[i]), &box) ? allTouches[i] : 0;
    }
    return touched;
}

// One number of a field.
static void findNumbers(const swInputSet* set, int field, int system, int count, const swPosXZ* points, float* numbers,
                        float (*gradients)[2])
{
    swInputValue values[SW_PLACE_BLOCK];
    for (int first = 0; first < count; first += SW_PLACE_BLOCK)
    {
        int some = count - first < SW_PLACE_BLOCK ? count - first : SW_PLACE_BLOCK;
        swFindInputValues(set, field, system, some, points + first, values);
        for (int i = 0; i < some; ++i)
        {
            numbers[first + i] = values[i].value.x;
            gradients[first + i][0] = values[i].alongX.x;
            gradients[first + i][1] = values[i].alongZ.x;
        }
    }
}

static void findLevel(const void* context, int system, int64_t ticks, int count, const swPosXZ* points, float* values,
                      float (*gradients)[2])
{
    (void)system;
    (void)ticks;
    findNumbers(context, SW_INPUT_LEVEL, -1, count, points, values, gradients);
}

void swFindInputDepths(const swInputSet* set, int count, const swPosXZ* points, float* depths, float (*gradients)[2])
{
    float floors[SW_PLACE_BLOCK], slopes[SW_PLACE_BLOCK][2];
    bool hasLevel = swHasInputs(set, SW_INPUT_LEVEL);
    memset(depths, 0, (size_t)count * sizeof *depths);
    memset(gradients, 0, (size_t)count * sizeof *gradients);
    for (int first = 0; first < count; first += SW_PLACE_BLOCK)
    {
        int some = count - first < SW_PLACE_BLOCK ? count - first : SW_PLACE_BLOCK;
        findNumbers(set, SW_INPUT_FLOOR, -1, some, points + first, floors, slopes);
        if (hasLevel)
        {
            findNumbers(set, SW_INPUT_LEVEL, -1, some, points + first, depths + first, gradients + first);
        }
        for (int i = 0; i < some; ++i)
        {
            bool isThere = floors[i] > 0.5f * SW_NO_FLOOR;
            depths[first + i] = isThere ? depths[first + i] - floors[i] : INFINITY;
            gradients[first + i][0] = isThere ? gradients[first + i][0] - slopes[i][0] : 0.0f;
            gradients[first + i][1] = isThere ? gradients[first + i][1] - slopes[i][1] : 0.0f;
        }
    }
}

static void findDepth(const void* context, int system, int64_t ticks, int count, const swPosXZ* points, float* values,
                      float (*gradients)[2])
{
    (void)system;
    (void)ticks;
    swFindInputDepths(context, count, points, values, gradients);
}

static void findWeight(const void* context, int system, int64_t ticks, int count, const swPosXZ* points, float* values,
                       float (*gradients)[2])
{
    (void)ticks;
    const swInputSet* set = context;
    if ((set->ribbonSystems >> system & 1u) == 0)
    {
        findNumbers(set, SW_INPUT_WAVES, system, count, points, values, gradients);
        return;
    }
    for (int i = 0; i < count; ++i)
    {
        swWaveLooks looks;
        swFindWaveLooks(set, system, 1, &points[i], &looks);
        values[i] = looks.plain.value.x;
        gradients[i][0] = looks.plain.alongX.x;
        gradients[i][1] = looks.plain.alongZ.x;
    }
}

static swWarp makeWarp(const swRibbonLook* look, swPosXZ point)
{
    if (look->weight.value == 0.0f && look->weight.alongX == 0.0f && look->weight.alongZ == 0.0f)
    {
        return (swWarp){.source = point, .cosine = 1.0f};
    }
    const swRibbonSource* from = &look->source;
    return (swWarp){
        .weight = look->weight.value,
        .alongX = look->weight.alongX,
        .alongZ = look->weight.alongZ,
        .source = {(double)from->cellX * (double)SW_QUERY_CELL + (double)from->restX,
                   (double)from->cellZ * (double)SW_QUERY_CELL + (double)from->restZ},
        .gradients = {from->way.x, from->way.y, from->way.z, from->way.w},
        .cosine = from->cosine,
        .sine = from->sine,
        .turnX = from->turnX,
        .turnZ = from->turnZ,
    };
}

static int findWarps(const void* context, int system, int64_t ticks, int count, const swPosXZ* points,
                     swWarp (*warps)[SW_PLACE_BLOCK])
{
    (void)ticks;
    const swInputSet* set = context;
    if ((set->ribbonSystems >> system & 1u) == 0)
    {
        return 0;
    }
    int warpCount = 0;
    for (int i = 0; i < count; ++i)
    {
        swWaveLooks looks;
        swFindWaveLooks(set, system, 1, &points[i], &looks);
        warps[0][i] = makeWarp(&looks.ribbons.first, points[i]);
        warps[1][i] = makeWarp(&looks.ribbons.second, points[i]);
        warpCount = warps[0][i].weight != 0.0f && warpCount < 1 ? 1 : warpCount;
        warpCount = warps[1][i].weight != 0.0f ? 2 : warpCount;
    }
    return warpCount;
}

static void findWater(const void* context, int64_t ticks, int count, const swPosXZ* points, float (*velocities)[2],
                      float (*gradients)[4])
{
    (void)ticks;
    swInputValue values[SW_PLACE_BLOCK];
    for (int first = 0; first < count; first += SW_PLACE_BLOCK)
    {
        int some = count - first < SW_PLACE_BLOCK ? count - first : SW_PLACE_BLOCK;
        swFindInputValues(context, SW_INPUT_FLOW, -1, some, points + first, values);
        for (int i = 0; i < some; ++i)
        {
            const swInputValue* v = &values[i];
            velocities[first + i][0] = v->value.x;
            velocities[first + i][1] = v->value.y;
            gradients[first + i][0] = v->alongX.x;
            gradients[first + i][1] = v->alongZ.x;
            gradients[first + i][2] = v->alongX.y;
            gradients[first + i][3] = v->alongZ.y;
        }
    }
}

// What carries copies of waves: how the water moves beside the flow that carries all of them.
static void findFlow(const void* context, int64_t ticks, int count, const swPosXZ* points, float (*velocities)[2],
                     float (*gradients)[4])
{
    const swInputSet* set = context;
    findWater(context, ticks, count, points, velocities, gradients);
    for (int i = 0; i < count; ++i)
    {
        velocities[i][0] = swGetCarriedSpeed(velocities[i][0], set->evenX);
        velocities[i][1] = swGetCarriedSpeed(velocities[i][1], set->evenZ);
    }
}

static void attenuate(const void* context, const swWaveKernels* kernels, const swWaveGroup* group, int count,
                      const float* depths, float* shares, float* slopes)
{
    (void)context;
    float least = depths[0];
    for (int i = 1; i < count; ++i)
    {
        least = depths[i] < least ? depths[i] : least;
    }
    if (group->k * least >= SW_DEEP_KD) // where the law says exactly that
    {
        for (int i = 0; i < count; ++i)
        {
            shares[i] = 1.0f;
            slopes[i] = 0.0f;
        }
        return;
    }
    swAttenuation law = group->tile != NULL ? group->tile->attenuation : group->waves[0].attenuation;
    swFindDepthShares(kernels, law, group->k, count, depths, shares, slopes);
}

bool swMakeInputPlaces(const swInputSet* set, swPlaces* places)
{
    *places = (swPlaces){.context = set};
    if (set == NULL)
    {
        return false;
    }
    bool hasFloor = swHasInputs(set, SW_INPUT_FLOOR);
    places->touched = findTouched;
    places->localSystems = set->localSystems;
    places->level = swHasInputs(set, SW_INPUT_LEVEL) ? findLevel : NULL;
    places->depth = hasFloor ? findDepth : NULL;
    places->attenuate = hasFloor ? attenuate : NULL;
    places->weight = swHasInputs(set, SW_INPUT_WAVES) ? findWeight : NULL;
    places->warps = set->ribbonSystems != 0 ? findWarps : NULL;
    places->water = swHasInputs(set, SW_INPUT_FLOW) ? findWater : NULL;
    places->flow = places->water != NULL && set->hasOtherFlows ? findFlow : NULL;
    return places->level != NULL || hasFloor || places->weight != NULL || places->water != NULL ||
           set->localSystems != 0;
}
