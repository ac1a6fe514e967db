// SPDX-License-Identifier: MIT
#include "core/lod/redraw.h"

#include <math.h>

void swRedrawAll(int resolution, swRedraw* redraw)
{
    *redraw = (swRedraw){.count = 1, .rects = {{0, 0, resolution, resolution}}};
}

static void addRect(swRedraw* redraw, swTexelRect rect)
{
    if (rect.firstX >= rect.endX || rect.firstZ >= rect.endZ)
    {
        return;
    }
    if (redraw->count < SW_MAX_REDRAWS)
    {
        redraw->rects[redraw->count++] = rect;
        return;
    }
    swTexelRect* last = &redraw->rects[SW_MAX_REDRAWS - 1]; // one that holds both
    last->firstX = rect.firstX < last->firstX ? rect.firstX : last->firstX;
    last->firstZ = rect.firstZ < last->firstZ ? rect.firstZ : last->firstZ;
    last->endX = rect.endX > last->endX ? rect.endX : last->endX;
    last->endZ = rect.endZ > last->endZ ? rect.endZ : last->endZ;
}

// Of a coordinate that may be infinite, the column or row at or below it, within [0, resolution].
static int findIndex(double place, int64_t first, double texel, int resolution)
{
    double index = floor(place / texel) - (double)first;
    return index <= 0.0 ? 0 : index >= (double)resolution ? resolution : (int)index;
}

void swAddRedraw(const swSlice* slice, int resolution, swPosXZ low, swPosXZ high, swRedraw* redraw)
{
    int endX = findIndex(high.x, slice->firstX - 1, slice->texel, resolution);
    int endZ = findIndex(high.z, slice->firstZ - 1, slice->texel, resolution);
    addRect(redraw, (swTexelRect){findIndex(low.x, slice->firstX, slice->texel, resolution),
                                  findIndex(low.z, slice->firstZ, slice->texel, resolution), endX, endZ});
}

void swPlanRedraw(const swSlice* now, const swSlice* before, int resolution, const swInputSet* inputs, uint32_t version,
                  swRedraw* redraw)
{
    int64_t shiftX = now->firstX - before->firstX, shiftZ = now->firstZ - before->firstZ;
    bool isNear = shiftX < resolution && -shiftX < resolution && shiftZ < resolution && -shiftZ < resolution;
    if (now->texel != before->texel || !isNear || !swKnowsChanges(inputs, version))
    {
        swRedrawAll(resolution, redraw);
        return;
    }
    *redraw = (swRedraw){.shiftX = (int)shiftX, .shiftZ = (int)shiftZ};
    int columns = shiftX < 0 ? (int)-shiftX : (int)shiftX, rows = shiftZ < 0 ? (int)-shiftZ : (int)shiftZ;
    int newX = shiftX < 0 ? 0 : resolution - columns, newZ = shiftZ < 0 ? 0 : resolution - rows;
    int oldX = shiftX < 0 ? columns : 0; // the first column that is kept
    addRect(redraw, (swTexelRect){newX, 0, newX + columns, resolution});
    addRect(redraw, (swTexelRect){oldX, newZ, oldX + resolution - columns, newZ + rows});
    for (int i = 0; i < inputs->changes->count; ++i)
    {
        const swInputChange* change = &inputs->changes->changes[i];
        if (swIsLaterChange(change, version))
        {
            swAddRedraw(now, resolution, change->low, change->high, redraw);
        }
    }
}

int swCountRedrawn(const swRedraw* redraw)
{
    int sum = 0;
    for (int i = 0; i < redraw->count; ++i)
    {
        const swTexelRect* rect = &redraw->rects[i];
        sum += (rect->endX - rect->firstX) * (rect->endZ - rect->firstZ);
    }
    return sum;
}
