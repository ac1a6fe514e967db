// SPDX-License-Identifier: MIT
#pragma once

// shared/wetness.h has the law.

#include "core/base/field.h"
#include "core/lod/layer_stack.h"

extern const swFields swWetnessFields;

void swPlanWetness(const swLayerPlan* plan);
void swStepWetness(const swLayerStep* step);
