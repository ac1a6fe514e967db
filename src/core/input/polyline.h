// SPDX-License-Identifier: MIT
#pragma once

// Lines through points, such as trails: words for shared/shape_polyline.h.

#include "seaway/input.h"
#include "shared/shape_polyline.h"

// SW_ERROR_INVALID and a sentence that begins with `name` if there are too few or if a number is out of its range.
swResult swCheckPolyline(const swHost* host, const char* name, int count, const swInputPoint* points);

// Words of at most so many points, and those of points. `width` is that of points that have none.
int swCountPolylineWords(int count);
int swWritePolyline(int count, const swInputPoint* points, float width, float* words);

// What the line covers: least x, least z, most x, most z.
void swBoundPolyline(int count, const float* words, float bounds[4]);
