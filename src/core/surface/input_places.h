// SPDX-License-Identifier: MIT
#pragma once

// What places are like by a world's inputs.

#include "core/surface/places.h"

// The set may be NULL. Returns false, and all NULL, where no input and no local system shapes any wave or level.
bool swMakeInputPlaces(const swInputSet* set, swPlaces* places);

// Depth of still water at points, m, and its gradients: level above floor. Infinite without a floor.
void swFindInputDepths(const swInputSet* set, int count, const swPosXZ* points, float* depths, float (*gradients)[2]);
