// SPDX-License-Identifier: MIT
#pragma once

// Lines through points, such as trails: words for shared/shape_polyline.h.

#include "seaway/input.h"
#include "shared/shape_polyline.h"

// Words of at most so many points, and those of points. `width` is that of points that have none.
int swCountPolylineWords(int count);
int swWritePolyline(int count, const swInputPoint* points, float width, float* words);

// What the line covers: least x, least z, most x, most z.
void swBoundPolyline(int count, const float* words, float bounds[4]);
