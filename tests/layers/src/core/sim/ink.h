// SPDX-License-Identifier: MIT
#pragma once

// shared/ink.h has the law.

#include "core/lod/layer_stack.h"

void swPlanInk(const swLayerPlan* plan);
void swStepInk(const swLayerStep* step);
