// SPDX-License-Identifier: MIT
#pragma once

// The slices of a view: each is twice as wide as the one before, all centred on the viewer. Seen from high above, fine
// slices are wasted, so the stack doubles with height: scale level s multiplies every slice by 2^s. While the viewer
// climbs through one level, `fade` runs from 0 to 1: the finest slice turns into the next and the outermost one
// appears, so that nothing is seen of the doubling itself. The picture of level s at fade 1 is that of level s + 1 at
// fade 0.
//
// With L = log2(height / one quarter of the finest slice's side), level s holds between L = s - delta and s + 1 + delta
// and fade goes from 0 at s + delta to 1 at s + 1 - delta. A viewer who bobs at a boundary therefore changes nothing.

#include "core/lod/slice.h"

// Hysteresis of the scale level, in doublings of height.
#define SW_SCALE_HYSTERESIS 0.1

typedef struct swStack
{
    int sliceCount;
    int resolution;
    int maxScaleLevel;
    double finestTexel;
    bool isPlaced; // the level has a past
    int scaleLevel;
    float fade;
    swSlice slices[SW_MAX_SLICES];
} swStack;

swStack swMakeStack(const swViewDef* def);

// Follow the viewer. The first placement takes the level that its height asks for, later ones keep to the hysteresis.
void swPlaceStack(swStack* stack, swPos viewpoint, double seaLevel);
