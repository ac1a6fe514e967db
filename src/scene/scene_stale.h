// SPDX-License-Identifier: MIT
#pragma once

#include "seaway/scene.h"

// Whether a raster's file holds anything but what would be baked now of the scene that `madeFrom` names. Reads that
// scene with all its files, and makes its world.
bool swIsSceneRasterStale(const swScene* scene, int index);
