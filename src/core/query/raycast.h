// SPDX-License-Identifier: MIT
#pragma once

// Where rays and sweeping spheres meet the surface. See raycast.c.

#include "core/surface/evaluate.h"

void swRefuseRays(int count, swRayHit* hits, swQueryStats* stats);
void swCastRays(const swQuery* query, int count, const swRay* rays, swRayHit* hits, swQueryStats* stats);
