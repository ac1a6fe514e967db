// SPDX-License-Identifier: MIT
#pragma once

// shared/wetness.h has the law.

#include "core/lod/layer_stack.h"

void swPlanWetness(const swLayerPlan* plan);
void swStepWetness(const swLayerStep* step);
