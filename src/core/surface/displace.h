// SPDX-License-Identifier: MIT
#pragma once

// Inputs of the field DISPLACEMENT, see shared/displace.h.

#include "core/surface/evaluate.h"

// What follows the waves joins their displacement at rest points, and the gradients of it; velocities and accelerations
// are scaled as displacements are. How an input changes with time makes no part of them.
void swDisplaceWaves(const swQuery* query, int count, const swPosXZ* rest, const swEvaluation* out);

// What stays put changes the heights of particles where they are. Before the level of still water is added to
// gradients, which may be NULL.
void swDisplaceHeights(const swQuery* query, int count, const swPosXZ* rest, float (*displacement)[4],
                       float (*gradients)[8]);
