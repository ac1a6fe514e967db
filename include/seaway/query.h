// SPDX-License-Identifier: MIT
#pragma once

#include "math.h"
#include "world.h"

/// @file
/// Ask for the surface. Answers come from the same waves that are drawn, at the time of the last step, and never depend
/// on a view. All queries are thread-safe, take no lock and allocate nothing.

/// Must be initialized with swDefaultQueryDef().
typedef struct swQueryDef
{
    /// Ignore bands whose waves are all shorter than this, m. Default 0.
    float minWavelength;

    /// Stop the search for the water column once the horizontal error is below this, m. Default 0.0005.
    float tolerance;

    /// Range [1, 64]. Default 24.
    int maxIterations;

    /// Set by swDefaultQueryDef().
    int internalValue;
} swQueryDef;

SW_API swQueryDef swDefaultQueryDef(void);

/// Where answers go: arrays of as many elements as points, or NULL to skip.
typedef struct swSurfaceSamples
{
    /// Height of the water above the point, m (absolute: includes sea level).
    float* height;

    /// Displacement of the water particle that is there, from its resting point, m.
    swVec3* displacement;

    /// Unit normal of the true (Eulerian) surface.
    swVec3* normal;

    /// Determinant of the horizontal displacement's Jacobian: 1 flat, below 0 folded over.
    float* jacobian;

    /// Horizontal distance between the point and where the answering particle is, m; above the tolerance where the
    /// surface is folded and the search did not converge.
    float* residual;
} swSurfaceSamples;

typedef struct swQueryStats
{
    int convergedCount;  ///< points whose residual is within the tolerance
    int iterationCount;  ///< surface evaluations, all points together
    float worstResidual; ///< m
} swQueryStats;

/// Sample the surface above `count` points of the horizontal plane. `stats` may be NULL.
SW_API void swWorld_QuerySurface(const swWorld* world, const swQueryDef* def, int count, const swPosXZ* points,
                                 const swSurfaceSamples* samples, swQueryStats* stats);

/// Height above one point, m.
SW_API double swWorld_GetHeight(const swWorld* world, double x, double z);

/// Sample the particles that rest at `count` points: no search, residual 0. What a moored buoy feels.
/// `slopes` (d height / d x, d height / d z per rest metre) may be NULL, as may any array of `samples`.
SW_API void swWorld_QueryParticles(const swWorld* world, const swQueryDef* def, int count, const swPosXZ* points,
                                   const swSurfaceSamples* samples, swVec2* slopes);
