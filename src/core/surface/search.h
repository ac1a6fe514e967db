// SPDX-License-Identifier: MIT
#pragma once

// The surface above points of the horizontal plane: find the particle that is there. See search.c.

#include "core/surface/evaluate.h"

// What the search for the particles above a block of points found.
typedef struct swFound
{
    float (*gradients)[8];        // asked for unless NULL: of the surface at the particles, with the level's slope
    swPosXZ rest[SW_QUERY_BLOCK]; // in the sea
    float displacement[SW_QUERY_BLOCK][4];
    float levels[SW_QUERY_BLOCK]; // of still water above sea level, at the points
    float residual[SW_QUERY_BLOCK];
    int evaluations;
} swFound;

// Find the particles above at most SW_QUERY_BLOCK points in the sea. `hints` are those of the points, or NULL; they are
// brought up to date.
void swFindParticles(const swQuery* query, int count, const swPosXZ* points, swSurfaceHint* const* hints,
                     swFound* found);
