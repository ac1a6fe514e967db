// SPDX-License-Identifier: MIT
#pragma once

// Foam on a view's slices: shared/foam.h has the law. Window, scrolling and clock are those of every layer, see
// core/lod/layer_stack.h. The GPU's twin is shaders/sim/foam.comp.

#include "core/base/field.h"
#include "core/lod/layer_stack.h"

extern const swFields swFoamFields;

// How each slice grows foam: the layer's parameters, see swGetFoamBirth(). In whitecaps.c.
void swPlanFoam(const swLayerPlan* plan);

void swStepFoam(const swLayerStep* step);
