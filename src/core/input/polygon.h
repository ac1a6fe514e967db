// SPDX-License-Identifier: MIT
#pragma once

// Polygons of the plane, as areas of inputs and as shores of bodies of water.

#include "core/base/host.h"

#define SW_MAX_POLYGON_POINTS 4096

// The log says what is wrong: fewer than three points, too many, one that is not finite, two that follow each other at
// one place, edges that cross or touch, no area. Points are x and z relative to `name`'s own place, m, each `stride`
// floats after the one before.
swResult swCheckPolygon(const swHost* host, const char* name, int count, const float* points, size_t stride);
