// SPDX-License-Identifier: MIT
#pragma once

// What a layer is: a quantity on the texels of a stack of slices. Its kind decides where it lives and who sees it.
//
// - An authored field (depth, level, flow) is a function of place and time, made from inputs that are saved and
//   digested. It lives in the plane; queries ask the function itself. A view's texels of it are a copy for drawing.
// - A simulated field (dynamic waves) lives in zones of the world, which the host places. Its texels are saved, part of
//   the digest, and rolled back. Queries see it.
// - A look (foam, wetness) lives in views and decides nothing but the picture. It is saved where a view that goes on
//   would show a seam, and is no part of the digest.
//
// Layers without a past are made anew in each frame. Those with one are written in turns to two images, step at a fixed
// rate, and scroll: a texel goes on from where the step before left its place, see core/lod/scroll.h.

#include <assert.h>
#include <stdbool.h>
#include <stdint.h>

#include "seaway/view.h"

#define SW_FOAM_RATE 30

typedef enum swLayerKind
{
    SW_LAYER_IS_FIELD,
    SW_LAYER_IS_SIMULATED,
    SW_LAYER_IS_LOOK
} swLayerKind;

// As the GPU stores a texel; the core keeps floats.
typedef enum swTexelFormat
{
    SW_TEXEL_R32F,
    SW_TEXEL_RGBA32F,
    SW_TEXEL_RGBA16F
} swTexelFormat;

typedef struct swLayerInfo
{
    const char* name;
    swLayerKind kind;
    swTexelFormat format;
    bool isLinear;     // readers interpolate by the texture unit; nearest otherwise
    bool hasPast;      // two images in turns, scrolled; one that is redrawn otherwise
    int rate;          // steps per second; 0: made in every frame
    int mostSteps;     // in one frame; more are taken as this many longer ones
    double longestGap; // s between two frames; what is longer is a jump, after which the layer starts anew
    bool isExact;      // n steps of dt are one of n dt, and one of no time changes nothing: the maker takes all at
                       // once unless water carries the layer, and looks up the past by itself
    bool isSaved;
    bool isOnDemand; // held only while its swPlan function says that there is something in it; authored fields all are
    float least, most;       // what a saved texel may hold
    float rest[4];           // of a layer on demand: what it is where it is not held
    const char* channels[4]; // what each number is called, the first NULL ends them; none: a single amount
} swLayerInfo;

static inline bool swIsOnDemand(const swLayerInfo* info)
{
    return info->isOnDemand || info->kind == SW_LAYER_IS_FIELD;
}

// Places in the table. Layers that the public API names have the same number there.
enum
{
#define SW_LAYER(NAME, name, Maker, ...) SW_LAYER_INDEX_##NAME,
#include "core/frame/layers.inl"
#undef SW_LAYER
    SW_LAYERS
};
static_assert((int)SW_LAYER_PLACES == (int)SW_LAYER_INDEX_PLACES, "one order");
static_assert((int)SW_LAYER_FLOW == (int)SW_LAYER_INDEX_FLOW, "one order");
static_assert((int)SW_LAYER_FLOW_SLOPES == (int)SW_LAYER_INDEX_FLOW_SLOPES, "one order");
static_assert((int)SW_LAYER_DISPLACEMENT == (int)SW_LAYER_INDEX_DISPLACEMENT, "one order");
static_assert((int)SW_LAYER_DERIVATIVES == (int)SW_LAYER_INDEX_DERIVATIVES, "one order");
static_assert((int)SW_LAYER_FOAM == (int)SW_LAYER_INDEX_FOAM, "one order");
static_assert((int)SW_LAYER_WAKE_FOAM == (int)SW_LAYER_INDEX_WAKE_FOAM, "one order");
static_assert((int)SW_LAYER_SHORE_FOAM == (int)SW_LAYER_INDEX_SHORE_FOAM, "one order");
