// SPDX-License-Identifier: MIT
#pragma once

// The surface above points, particles by where they rest, and grids of heights.

#include "core/surface/evaluate.h"

// Every point of a query that is refused as a whole is bad. `samples` and `slopes` may be NULL.
void swRefuseSurface(int count, const swSurfaceSamples* samples, swVec2* slopes, swQueryStats* stats);

void swQuerySurface(const swQuery* query, int count, const swPosXZ* points, const swSurfaceSamples* samples,
                    swQueryStats* stats);
// Height of the water above a point, m. NaN for a point that cannot be answered.
double swFindHeight(const swQuery* query, double x, double z);

void swQueryParticles(const swQuery* query, int count, const swPosXZ* points, const swSurfaceSamples* samples,
                      swVec2* slopes, swQueryStats* stats);
void swQueryHeightMap(const swQuery* query, const swHeightMapDef* map, float* heights, swQueryStats* stats);
