// SPDX-License-Identifier: MIT
#include "core/surface/field_layers.h"

void swPlanFields(const swLayerPlan* plan)
{
    (void)plan;
}

void swStepFields(const swLayerStep* step)
{
    (void)step;
}
