// SPDX-License-Identifier: MIT
#pragma once

// The layers of one stack of slices: memory, window, scrolling, clocks, and how they are saved and digested, all as
// layers.inl says. A view has a stack that follows its viewpoint, for looks and copies of authored fields. A zone has
// one that the host places, for simulated fields.

#include "core/base/hash.h"
#include "core/base/stream.h"
#include "core/lod/layer_clock.h"
#include "core/lod/stack.h"

// What a maker leaves with the texels of the first of its layers, for its next call.
typedef struct swLayerNote
{
    uint32_t version; // of the inputs that they are of
    int made;         // texels that the call evaluated
} swLayerNote;

// A layer's texels, [slice][R][R][channels]; one that has no past uses the first only.
typedef struct swLayerState
{
    float* texels[2];
    int current;
    bool isAuthored; // of an authored field, in the last step
    swLayerClock clock;
    swLayerNote note;
} swLayerState;

typedef struct swLayerStack
{
    swStack stack;
    bool isZone;    // of simulated fields
    bool hasTexels; // the core makes the layers
    swLayerState states[SW_LAYERS];
} swLayerStack;

// What a layer's swPlan function works on, in every frame, also where the core makes no texels. Once it is called,
// slices, sources and clocks are there; it fills stack->layers[...].params.
typedef struct swLayerPlan
{
    const swWorldDef* def; // a layer's own def is a part of it
    const swFrame* frame;
    swStackFrame* stack;
} swLayerPlan;

// What a layer's swStep function works on.
typedef struct swLayerStep
{
    const swHost* host;
    const struct swWaveKernels* kernels;
    const swFrame* frame;
    const swStackFrame* stack;
    const float* previous[SW_LAYERS]; // texels before, of those with a past
    float* next[SW_LAYERS];           // texels to fill
    // From where the texels of `previous` lie to the stack's slices, of layers that take the past themselves.
    swPastSource (*sources)[SW_PAST_SOURCES];
    swLayerNote* note;
    int index;     // of the call in this frame
    int64_t clock; // of the one step to take, where the layer is not exact
    float dt;      // s: of this step, or of all together
} swLayerStep;

typedef void swPlanLayerFcn(const swLayerPlan* plan);
typedef void swStepLayerFcn(const swLayerStep* step);

bool swHasLayer(const swLayerStack* layers, int layer);
int swCountChannels(swTexelFormat format);

// Texels need the host's memory; false if there is none, and then nothing is held.
bool swMakeLayers(const swHost* host, swLayerStack* layers);
void swFreeLayers(const swHost* host, swLayerStack* layers);
// Texels of authored fields, which a view has no need of before there are inputs; nothing if it has them. False if
// there is no memory, and then none is held that was not before.
bool swMakeFieldTexels(const swHost* host, swLayerStack* layers);
bool swHasFieldTexels(const swLayerStack* layers);
const float* swGetLayerTexels(const swLayerStack* layers, int layer); // the current ones, or NULL

// Move the window to a viewpoint or a zone's centre, find where texels were, and decide the steps of a frame.
void swPlaceLayers(swLayerStack* layers, swPos place, double seaLevel, int64_t elapsedTicks, swStackFrame* frame);

// Take a frame's steps of `count` layers that are made together. `step` has host, kernels, frame and stack.
void swStepLayers(swLayerStack* layers, int first, int count, swStepLayerFcn* stepFcn, swLayerStep* step,
                  swStackFrame* frame);

// Clocks and texels of the layers that are saved. While reading, into `layers`, which must have texels of those on
// demand where those were held.
void swStreamLayers(swStream* stream, swLayerStack* layers);
// Read past them and look whether they can be.
void swCheckLayers(swStream* stream, const swLayerStack* layers);
size_t swCountSavedFloats(const swLayerStack* layers); // at least so many

// Windows, clocks and texels of simulated fields.
void swHashLayers(swHash* hash, const swLayerStack* layers);
