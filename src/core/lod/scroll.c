// SPDX-License-Identifier: MIT
#include "core/lod/scroll.h"

// Index of the source lattice's texel at or below index n of a lattice `shift` levels above it (below if negative).
static int64_t mapIndex(int64_t n, int shift)
{
    if (shift >= 0)
    {
        return n * ((int64_t)1 << shift);
    }
    int64_t steps = (int64_t)1 << -shift;
    int64_t quotient = n / steps;
    return quotient * steps > n ? quotient - 1 : quotient;
}

// False if no texel of the slice can lie within the source, or the indices would not fit.
static bool makeSource(const swSlice* slice, const swSlice* source, int index, int resolution, swPastSource* out)
{
    int shift = slice->level - source->level;
    if (shift > SW_MAX_SLICES || shift < -SW_MAX_SLICES)
    {
        return false;
    }
    int64_t baseX = mapIndex(slice->firstX, shift);
    int64_t baseZ = mapIndex(slice->firstZ, shift);
    int64_t lastX = mapIndex(slice->firstX + resolution, shift) - source->firstX;
    int64_t lastZ = mapIndex(slice->firstZ + resolution, shift) - source->firstZ;
    int64_t firstX = baseX - source->firstX;
    int64_t firstZ = baseZ - source->firstZ;
    if (firstX >= resolution || firstZ >= resolution || lastX < 0 || lastZ < 0)
    {
        return false;
    }
    *out = (swPastSource){.slice = index, .shift = shift, .baseX = (sw_int)firstX, .baseZ = (sw_int)firstZ};
    if (shift < 0)
    {
        out->restX = (sw_int)(slice->firstX - baseX * ((int64_t)1 << -shift));
        out->restZ = (sw_int)(slice->firstZ - baseZ * ((int64_t)1 << -shift));
    }
    return true;
}

void swFindPastSources(const swSlice* slice, int resolution, int previousCount, const swSlice* previous,
                       swPastSource* sources)
{
    int same = -1, coarser = -1, finer = -1;
    for (int i = 0; i < previousCount; ++i) // levels ascend
    {
        int level = previous[i].level;
        same = level == slice->level ? i : same;
        coarser = level > slice->level && coarser < 0 ? i : coarser;
        finer = level < slice->level ? i : finer;
    }
    const int candidates[SW_PAST_SOURCES] = {same, coarser, finer};
    int count = 0;
    for (int i = 0; i < SW_PAST_SOURCES; ++i)
    {
        int c = candidates[i];
        if (c >= 0 && makeSource(slice, &previous[c], c, resolution, &sources[count]))
        {
            count += 1;
        }
    }
    for (; count < SW_PAST_SOURCES; ++count)
    {
        sources[count] = (swPastSource){.slice = -1};
    }
}

bool swHasStackMoved(const swStackFrame* frame, const swSlice* previous)
{
    for (int i = 0; i < frame->sliceCount; ++i)
    {
        const swSlice* a = &previous[i];
        const swSlice* b = &frame->slices[i];
        if (a->level != b->level || a->firstX != b->firstX || a->firstZ != b->firstZ)
        {
            return true;
        }
    }
    return false;
}
