// SPDX-License-Identifier: MIT
#include "core/input/sample_clip.h"

#include "core/input/input_index.h"
#include "core/input/input_record.h"
#include "shared/clip.h"

// A point whose cells do not fit 32 bits is only in what is everywhere.
float swFindClip(const swInputSet* set, swPosXZ point, float y)
{
    float distance = SW_CLIP_FAR;
    if (!swHasInputs(set, SW_INPUT_CLIP))
    {
        return distance;
    }
    int32_t cellX = 0, cellZ = 0;
    float restX = 0.0f, restZ = 0.0f;
    bool isNearX = swFindCell(point.x, &cellX, &restX), isNearZ = swFindCell(point.z, &cellZ, &restZ);
    const swCellBox box = {cellX, cellZ, cellX, cellZ};
    uint32_t at = swFindNextInput(set, SW_INPUT_CLIP, &box, 0);
    for (; at != SW_NO_RECORD; at = swFindNextInput(set, SW_INPUT_CLIP, &box, at + 1))
    {
        const swInputRecord* record = &set->records[at];
        if ((isNearX && isNearZ) || (record->flags & SW_INPUT_IS_BOUNDLESS) != 0)
        {
            sw_vec2 own = swPlaceInInput(*record, cellX, cellZ, restX, restZ);
            distance = swJoinClip(distance, set->words[at], *record, own.x, y, own.y);
        }
    }
    return distance;
}
