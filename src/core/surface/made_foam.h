// SPDX-License-Identifier: MIT
#pragma once

// Foam that inputs, wakes and shores make, on a view's slices: shared/foam.h has the laws. Each kind has a layer of its
// own, because each fades at a rate of its own. The GPU's twin is shaders/sim/made_foam.comp.

#include "core/lod/layer_stack.h"

void swPlanMadeFoam(const swLayerPlan* plan);
void swStepMadeFoam(const swLayerStep* step);
