// SPDX-License-Identifier: MIT
#pragma once

// Where rays and sweeping spheres meet the surface. See raycast.c.

#include "core/query/sample.h"

// Rays are checked: directions are not 0. `frame` is the one that the query was begun with.
void swCastRays(const swQuery* query, int count, const swRay* rays, swRayHit* hits);
