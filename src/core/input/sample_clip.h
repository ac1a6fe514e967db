// SPDX-License-Identifier: MIT
#pragma once

// Holes in the water, see shared/clip.h. The GPU's twin is shaders/lib/clip.glsl.

#include "core/frame/input_set.h"

// The signed distance from the edge of the holes to a point in the sea, m: below 0 there is no water. `y` is the height
// of the surface there above sea level. The set may be NULL.
float swFindClip(const swInputSet* set, swPosXZ point, float y);
