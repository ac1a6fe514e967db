// SPDX-License-Identifier: MIT
#pragma once

// Authored fields on a view's slices: copies for drawing of what queries ask the inputs themselves. The GPU's twin is
// shaders/input/fields.comp.

#include "core/lod/layer_stack.h"

// A layer is made where inputs say something of it. SW_LAYER_PLACES: the depth of still water at each texel's rest
// point, its slopes along x and z, and its level above sea level. SW_LAYER_FLOW and SW_LAYER_FLOW_SLOPES: how the water
// flows there, and the gradients of it.
void swPlanFields(const swLayerPlan* plan);
void swStepFields(const swLayerStep* step);
