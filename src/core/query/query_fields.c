// SPDX-License-Identifier: MIT
#include "core/query/query_fields.h"

#include <math.h>

#include "core/frame/asked.h"
#include "core/input/sample_clip.h"
#include "core/input/sample_inputs.h"
#include "core/input/wind.h"
#include "core/query/answers.h"
#include "core/surface/input_places.h"

// The next places that can be answered.
typedef struct Block
{
    int count;
    int at[SW_PLACE_BLOCK];
    swPosXZ places[SW_PLACE_BLOCK]; // in the sea
} Block;

static void markBad(const swFieldSamples* samples, int i)
{
    float* numbers[] = {samples->depth, samples->floor, samples->level, samples->weight,
                        samples->clip,  samples->foam,  samples->shadow};
    for (int k = 0; k < 7; ++k)
    {
        if (numbers[k] != NULL)
        {
            numbers[k][i] = SW_NO_NUMBER;
        }
    }
    if (samples->flow != NULL)
    {
        samples->flow[i] = (swVec2){SW_NO_NUMBER, SW_NO_NUMBER};
    }
    if (samples->wind != NULL)
    {
        samples->wind[i] = (swVec2){SW_NO_NUMBER, SW_NO_NUMBER};
    }
    if (samples->albedo != NULL)
    {
        samples->albedo[i] = (swVec4){SW_NO_NUMBER, SW_NO_NUMBER, SW_NO_NUMBER, SW_NO_NUMBER};
    }
    if (samples->displacement != NULL)
    {
        samples->displacement[i] = SW_NO_VECTOR;
    }
    if (samples->body != NULL)
    {
        samples->body[i] = -1;
    }
}

void swRefuseFields(int count, const swFieldSamples* samples)
{
    for (int i = 0; i < count && samples != NULL; ++i)
    {
        markBad(samples, i);
    }
}

// Values of a field; what is below all inputs where there is no set.
static void find(const swInputSet* set, int field, int system, const Block* block, swInputValue* values)
{
    if (set != NULL)
    {
        swFindInputValues(set, field, system, block->count, block->places, values);
        return;
    }
    for (int i = 0; i < block->count; ++i)
    {
        values[i] = swGetFieldBelow((sw_uint)field);
    }
}

static void findNumber(const swInputSet* set, int field, int system, const Block* block, float* to)
{
    swInputValue values[SW_PLACE_BLOCK];
    if (to == NULL)
    {
        return;
    }
    find(set, field, system, block, values);
    for (int i = 0; i < block->count; ++i)
    {
        to[block->at[i]] = values[i].value.x;
    }
}

static void findPair(const swInputSet* set, int field, const Block* block, swVec2* to)
{
    swInputValue values[SW_PLACE_BLOCK];
    if (to == NULL)
    {
        return;
    }
    find(set, field, -1, block, values);
    for (int i = 0; i < block->count; ++i)
    {
        to[block->at[i]] = (swVec2){values[i].value.x, values[i].value.y};
    }
}

// The world's wind of the frame's time, and what inputs make of it.
static void findWinds(const swFrame* frame, const Block* block, swVec2* to)
{
    swInputValue values[SW_PLACE_BLOCK];
    swVec2 winds[SW_PLACE_BLOCK];
    if (to == NULL)
    {
        return;
    }
    swFindWinds(&frame->windField, frame->ticks, block->count, block->places, winds);
    for (int i = 0; i < block->count; ++i)
    {
        values[i] = swGetFieldBelow(SW_FIELD_OF_WIND);
        values[i].value.x = winds[i].x;
        values[i].value.y = winds[i].y;
    }
    if (frame->inputs != NULL)
    {
        swJoinInputValues(frame->inputs, SW_INPUT_WIND, -1, block->count, block->places, values);
    }
    for (int i = 0; i < block->count; ++i)
    {
        to[block->at[i]] = (swVec2){values[i].value.x, values[i].value.y};
    }
}

static void findFloors(const swFrame* frame, const Block* block, float* to)
{
    swInputValue values[SW_PLACE_BLOCK];
    if (to == NULL)
    {
        return;
    }
    find(frame->inputs, SW_INPUT_FLOOR, -1, block, values);
    for (int i = 0; i < block->count; ++i)
    {
        float height = values[i].value.x;
        bool isThere = height > 0.5f * SW_NO_FLOOR;
        to[block->at[i]] = isThere ? (float)((double)height + frame->seaLevel) : -INFINITY;
    }
}

static void findDepths(const swFrame* frame, const Block* block, float* to)
{
    float depths[SW_PLACE_BLOCK], gradients[SW_PLACE_BLOCK][2];
    if (to == NULL)
    {
        return;
    }
    if (frame->inputs != NULL)
    {
        swFindInputDepths(frame->inputs, block->count, block->places, depths, gradients);
    }
    for (int i = 0; i < block->count; ++i)
    {
        to[block->at[i]] = frame->inputs != NULL ? depths[i] : INFINITY;
    }
}

// At the height of still water.
static void findClips(const swInputSet* set, const Block* block, float* to)
{
    swInputValue levels[SW_PLACE_BLOCK];
    if (to == NULL)
    {
        return;
    }
    find(set, SW_INPUT_LEVEL, -1, block, levels);
    for (int i = 0; i < block->count; ++i)
    {
        float distance = swFindClip(set, block->places[i], levels[i].value.x);
        to[block->at[i]] = fminf(fmaxf(0.5f - distance, 0.0f), 1.0f);
    }
}

static void findRest(const swInputSet* set, const Block* block, const swFieldSamples* samples)
{
    swInputValue values[SW_PLACE_BLOCK];
    if (samples->albedo != NULL)
    {
        find(set, SW_INPUT_ALBEDO, -1, block, values);
        for (int i = 0; i < block->count; ++i)
        {
            samples->albedo[block->at[i]] = values[i].value;
        }
    }
    if (samples->displacement != NULL)
    {
        find(set, SW_INPUT_DISPLACEMENT, -1, block, values);
        for (int i = 0; i < block->count; ++i)
        {
            sw_vec4 v = values[i].value;
            samples->displacement[block->at[i]] = (swVec3){v.x, v.y, v.z};
        }
    }
    if (samples->body != NULL)
    {
        find(set, SW_INPUT_BODY, -1, block, values);
        for (int i = 0; i < block->count; ++i)
        {
            samples->body[block->at[i]] = swGetBodyNumber(values[i].value.x);
        }
    }
}

static void answerBlock(const swFrame* frame, int system, const Block* block, const swFieldSamples* samples)
{
    const swInputSet* set = frame->inputs;
    findDepths(frame, block, samples->depth);
    findFloors(frame, block, samples->floor);
    findNumber(set, SW_INPUT_LEVEL, -1, block, samples->level);
    findNumber(set, SW_INPUT_WAVES, system, block, samples->weight);
    findClips(set, block, samples->clip);
    findNumber(set, SW_INPUT_FOAM, -1, block, samples->foam);
    findNumber(set, SW_INPUT_SHADOW, -1, block, samples->shadow);
    findPair(set, SW_INPUT_FLOW, block, samples->flow);
    findWinds(frame, block, samples->wind);
    findRest(set, block, samples);
}

int swFindFields(const swFrame* frame, swPosXZ origin, int system, int count, const swPosXZ* points,
                 const swFieldSamples* samples)
{
    int badCount = 0;
    Block block = {0};
    for (int i = 0; i < count; ++i)
    {
        if (swIsNear(points[i].x) && swIsNear(points[i].z))
        {
            block.at[block.count] = i;
            block.places[block.count++] = (swPosXZ){points[i].x + origin.x, points[i].z + origin.z};
        }
        else
        {
            markBad(samples, i);
            badCount += 1;
        }
        if (block.count == SW_PLACE_BLOCK || (i == count - 1 && block.count > 0))
        {
            answerBlock(frame, system, &block, samples);
            block.count = 0;
        }
    }
    return badCount;
}
