// SPDX-License-Identifier: MIT
#include "core/lod/layer_stack.h"

#include "core/base/host.h"
#include "core/lod/scroll.h"

#define LARGEST_CLOCK ((int64_t)1 << 62)

bool swHasLayer(const swLayerStack* layers, int layer)
{
    return (swGetLayerInfo(layer)->kind == SW_LAYER_IS_SIMULATED) == layers->isZone;
}

int swCountChannels(swTexelFormat format)
{
    return format == SW_TEXEL_R32F ? 1 : 4;
}

// ---- memory ----

static size_t countFloats(const swLayerStack* layers, int layer)
{
    size_t side = (size_t)layers->stack.resolution;
    size_t channels = (size_t)swCountChannels(swGetLayerInfo(layer)->format);
    return layers->hasTexels ? (size_t)layers->stack.sliceCount * side * side * channels : 0;
}

bool swMakeLayers(const swHost* host, swLayerStack* layers)
{
    for (int i = 0; i < SW_LAYERS && layers->hasTexels; ++i)
    {
        bool waits = swIsOnDemand(swGetLayerInfo(i));
        int images = !swHasLayer(layers, i) || waits ? 0 : swGetLayerInfo(i)->hasPast ? 2 : 1;
        for (int k = 0; k < images; ++k)
        {
            layers->states[i].texels[k] = swAllocateZero(host, countFloats(layers, i) * sizeof(float));
            if (layers->states[i].texels[k] == NULL)
            {
                swFreeLayers(host, layers);
                return false;
            }
        }
    }
    return true;
}

void swFreeLayers(const swHost* host, swLayerStack* layers)
{
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        for (int k = 0; k < 2; ++k)
        {
            swFree(host, layers->states[i].texels[k], countFloats(layers, i) * sizeof(float));
            layers->states[i].texels[k] = NULL;
        }
    }
}

bool swMakeFieldTexels(const swHost* host, swLayerStack* layers)
{
    bool isNew[SW_LAYERS][2] = {{false}};
    bool isMade = true;
    for (int i = 0; i < 2 * SW_LAYERS && layers->hasTexels && isMade; ++i)
    {
        int layer = i / 2, k = i % 2;
        const swLayerInfo* info = swGetLayerInfo(layer);
        float** texels = &layers->states[layer].texels[k];
        if (swHasLayer(layers, layer) && swIsOnDemand(info) && k < (info->hasPast ? 2 : 1) && *texels == NULL)
        {
            *texels = swAllocateZero(host, countFloats(layers, layer) * sizeof(float));
            isNew[layer][k] = isMade = *texels != NULL;
        }
    }
    for (int i = 0; i < 2 * SW_LAYERS && !isMade; ++i)
    {
        float** texels = &layers->states[i / 2].texels[i % 2];
        if (isNew[i / 2][i % 2])
        {
            swFree(host, *texels, countFloats(layers, i / 2) * sizeof(float));
            *texels = NULL;
        }
    }
    return isMade;
}

bool swHasFieldTexels(const swLayerStack* layers)
{
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        if (swIsOnDemand(swGetLayerInfo(i)) && layers->states[i].texels[0] != NULL)
        {
            return true;
        }
    }
    return false;
}

const float* swGetLayerTexels(const swLayerStack* layers, int layer)
{
    const swLayerState* state = &layers->states[layer];
    bool isThere = !swIsOnDemand(swGetLayerInfo(layer)) || state->isAuthored;
    return isThere ? state->texels[state->current] : NULL;
}

// ---- a frame ----

void swPlaceLayers(swLayerStack* layers, swPos place, double seaLevel, int64_t elapsedTicks, swStackFrame* frame)
{
    swStack* stack = &layers->stack;
    bool isFirst = !stack->isPlaced;
    memset(frame, 0, sizeof *frame);
    frame->sliceCount = stack->sliceCount;
    frame->resolution = stack->resolution;
    memcpy(frame->previousSlices, stack->slices, sizeof frame->previousSlices);
    swPlaceStack(stack, place, seaLevel);
    memcpy(frame->slices, stack->slices, sizeof frame->slices);
    if (isFirst)
    {
        memcpy(frame->previousSlices, stack->slices, sizeof frame->previousSlices);
    }
    for (int i = 0; i < frame->sliceCount; ++i)
    {
        swFindPastSources(&frame->slices[i], frame->resolution, frame->sliceCount, frame->previousSlices,
                          frame->sources[i]);
    }
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        const swLayerInfo* info = swGetLayerInfo(i);
        if (swHasLayer(layers, i) && info->hasPast)
        {
            swAdvanceLayerClock(&layers->states[i].clock, info, elapsedTicks, &frame->layers[i]);
        }
        frame->layers[i].isAuthored = frame->layers[i].isBegun = layers->states[i].isAuthored;
    }
}

// Point a step at a layer's texels before and after, which then change their parts.
static void turn(swLayerStack* layers, int layer, swLayerStep* step)
{
    swLayerState* state = &layers->states[layer];
    step->previous[layer] = state->texels[state->current];
    state->current ^= swGetLayerInfo(layer)->hasPast ? 1 : 0;
    step->next[layer] = state->texels[state->current];
}

typedef struct ScrollJob
{
    const swStackFrame* frame;
    int slice, channels;
    bool isReset;
    const float* previous;
    float* next;
} ScrollJob;

static void scrollRows(void* context, int begin, int end, int worker)
{
    const ScrollJob* job = context;
    const swStackFrame* frame = job->frame;
    size_t side = (size_t)frame->resolution;
    (void)worker;
    for (int row = begin; row < end; ++row)
    {
        float* texel = job->next + ((size_t)job->slice * side + (size_t)row) * side * (size_t)job->channels;
        for (int i = 0; i < frame->resolution * job->channels; ++i)
        {
            int column = i / job->channels, channel = i % job->channels;
            float value = 0.0f;
            bool hasPast = !job->isReset && swReadPast(frame->sources[job->slice], job->previous + channel,
                                                       job->channels, frame->resolution, column, row, &value);
            texel[i] = hasPast ? value : 0.0f;
        }
    }
}

// Carry texels to where the slices are now; what has no past is 0.
static void scroll(swLayerStack* layers, int layer, swLayerStep* step, const swStackFrame* frame)
{
    if (!frame->layers[layer].isReset && !swHasStackMoved(frame, frame->previousSlices))
    {
        return;
    }
    turn(layers, layer, step);
    for (int i = 0; i < frame->sliceCount; ++i)
    {
        ScrollJob job = {
            .frame = frame,
            .slice = i,
            .channels = swCountChannels(swGetLayerInfo(layer)->format),
            .isReset = frame->layers[layer].isReset,
            .previous = step->previous[layer],
            .next = step->next[layer],
        };
        swParallelFor(step->host, scrollRows, &job, frame->resolution, 16);
    }
}

static void turnAll(swLayerStack* layers, int first, int count, swLayerStep* step)
{
    for (int i = first; i < first + count; ++i)
    {
        turn(layers, i, step);
    }
}

// The maker looks up the past by itself: in the first call where slices lay before, and in later ones where they lie.
// At least one call, also where no step is due.
static void stepExactly(swLayerStack* layers, int first, int count, swStepLayerFcn* stepFcn, swLayerStep* step,
                        swStackFrame* frame)
{
    const swLayerFrame* now = &frame->layers[first];
    swCarriedSteps carried = swFindCarriedSteps(swGetLayerInfo(first), now->isCarried ? now->due : 0);
    int calls = carried.count > 1 ? carried.count : 1;
    swPastSource still[SW_MAX_SLICES][SW_PAST_SOURCES];
    for (int i = 0; i < frame->sliceCount && calls > 1; ++i)
    {
        swFindPastSources(&frame->slices[i], frame->resolution, frame->sliceCount, frame->slices, still[i]);
    }
    for (int i = 0; i < calls; ++i)
    {
        turnAll(layers, first, count, step);
        step->index = i;
        step->sources = i == 0 ? frame->sources : still;
        step->dt = calls > 1 ? carried.dt : now->stepDt * (float)now->steps;
        stepFcn(step);
    }
}

void swStepLayers(swLayerStack* layers, int first, int count, swStepLayerFcn* stepFcn, swLayerStep* step,
                  swStackFrame* frame)
{
    const swLayerInfo* info = swGetLayerInfo(first);
    const swLayerFrame* now = &frame->layers[first];
    step->note = &layers->states[first].note;
    if (!info->hasPast || info->isExact)
    {
        stepExactly(layers, first, count, stepFcn, step, frame);
    }
    for (int i = first; i < first + count && info->hasPast && !info->isExact; ++i)
    {
        scroll(layers, i, step, frame);
    }
    for (int i = 0; i < now->steps && !info->isExact; ++i)
    {
        turnAll(layers, first, count, step);
        step->dt = now->stepDt;
        step->clock = now->clock - now->steps + i + 1;
        stepFcn(step);
    }
    for (int i = first; i < first + count; ++i)
    {
        layers->states[i].isAuthored = frame->layers[i].isAuthored;
        frame->layers[i].texels = swGetLayerTexels(layers, i);
    }
}

// ---- saving ----

static bool isSaved(const swLayerStack* layers, int layer)
{
    return swHasLayer(layers, layer) && swGetLayerInfo(layer)->isSaved;
}

static void streamClock(swStream* stream, const swLayerInfo* info, swLayerClock* clock)
{
    swStreamBool(stream, &clock->isRunning);
    swStreamI64(stream, &clock->remainder);
    swStreamI64(stream, &clock->clock);
    swStreamU32(stream, &clock->resetCount);
    bool isClock = clock->remainder >= 0 && clock->remainder < (int64_t)SW_TICKS_PER_SECOND && clock->clock >= 0 &&
                   clock->clock <= LARGEST_CLOCK;
    stream->isBroken = stream->isBroken || (info->hasPast && !isClock);
}

// Whether a layer on demand is held. How many texels follow: none if it is not.
static size_t streamHeld(swStream* stream, const swLayerStack* layers, int layer, bool* isHeld)
{
    size_t count = countFloats(layers, layer);
    if (!swIsOnDemand(swGetLayerInfo(layer)))
    {
        return count;
    }
    swStreamBool(stream, isHeld);
    bool hasRoom = count == 0 || layers->states[layer].texels[0] != NULL;
    stream->isBroken = stream->isBroken || (*isHeld && !hasRoom);
    return *isHeld ? count : 0;
}

// Into `texels`, or only looked at where that is NULL.
static void streamTexels(swStream* stream, const swLayerInfo* info, size_t count, float* texels)
{
    for (size_t i = 0; i < count && !stream->isBroken; ++i)
    {
        float value = texels != NULL ? texels[i] : 0.0f;
        swStreamF32(stream, &value);
        stream->isBroken = stream->isBroken || !(value >= info->least && value <= info->most); // NaN as well
        if (texels != NULL && swIsReading(stream))
        {
            texels[i] = value;
        }
    }
}

void swStreamLayers(swStream* stream, swLayerStack* layers)
{
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        if (swIsReading(stream) && !isSaved(layers, i))
        {
            layers->states[i].isAuthored = false; // texels are of what was before
        }
        if (isSaved(layers, i))
        {
            swLayerState* state = &layers->states[i];
            streamClock(stream, swGetLayerInfo(i), &state->clock);
            size_t count = streamHeld(stream, layers, i, &state->isAuthored);
            streamTexels(stream, swGetLayerInfo(i), count, state->texels[state->current]);
        }
    }
}

void swCheckLayers(swStream* stream, const swLayerStack* layers)
{
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        if (isSaved(layers, i))
        {
            swLayerClock clock = {.isRunning = false};
            streamClock(stream, swGetLayerInfo(i), &clock);
            bool isHeld;
            size_t count = streamHeld(stream, layers, i, &isHeld);
            streamTexels(stream, swGetLayerInfo(i), count, NULL);
        }
    }
}

size_t swCountSavedFloats(const swLayerStack* layers)
{
    size_t count = 0;
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        count += isSaved(layers, i) && !swIsOnDemand(swGetLayerInfo(i)) ? countFloats(layers, i) : 0;
    }
    return count;
}

// ---- digest ----

void swHashLayers(swHash* hash, const swLayerStack* layers)
{
    for (int i = 0; i < layers->stack.sliceCount && layers->stack.isPlaced; ++i)
    {
        swAddHash(hash, (uint64_t)layers->stack.slices[i].firstX);
        swAddHash(hash, (uint64_t)layers->stack.slices[i].firstZ);
    }
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        const swLayerState* state = &layers->states[i];
        if (swHasLayer(layers, i) && swGetLayerInfo(i)->kind == SW_LAYER_IS_SIMULATED)
        {
            swAddHash(hash, (uint64_t)state->clock.remainder);
            swAddHash(hash, (uint64_t)state->clock.clock);
            swAddHashFloats(hash, swGetLayerTexels(layers, i), countFloats(layers, i));
        }
    }
}
