// SPDX-License-Identifier: MIT
#pragma once

#include "math.h"
#include "moment.h"

/// @file
/// Ask for the water: its surface, the motion below it, what a ray meets. Answers come from the same waves that are
/// drawn and never depend on a view. They are of a moment: the world's own, swWorld_GetMoment(), is the water of its
/// last step. All queries are thread-safe on a `const swMoment*`, take no lock and allocate nothing. docs/queries.md
/// says what each costs and how exact it is.
///
/// A point that cannot be answered spoils no other. It is one with a coordinate that is NaN, infinite, or beyond
/// SW_FARTHEST_POINT; a ray that is out of range is such a one, too. Each of its answers is NaN, it is counted in
/// swQueryStats::badCount, and the others are, to the bit, as without it.
///
/// While one thread steps, sets or destroys, no other may ask the same world. Put a barrier between them, or let two
/// worlds take turns: one is asked while the other steps to the next time. docs/queries.md has more on it.

/// For swQueryDef::time: the moment's time.
#define SW_QUERY_NOW (-1e300)

/// Farthest that a point may be from the host's origin along an axis, m: doubles there are 0.1 mm apart, and cells of
/// the finest tiles can just be counted.
#define SW_FARTHEST_POINT 1e12

/// Most bytes of its caller's stack that a query takes, in builds that are optimized, so that fibres may ask.
#define SW_QUERY_STACK 40960

/// How the motion below is stretched between trough and crest.
typedef enum swStretching
{
    /// Heights count from the bottom to the surface above: what linear theory has at still water is found at the
    /// surface [Wheeler 1970]. Continuous with the surface.
    SW_STRETCHING_WHEELER,

    /// Linear theory as it stands: heights count from still water, and above it the motion is that at still water.
    /// Free of divergence to rounding.
    SW_STRETCHING_LINEAR
} swStretching;

/// Must be initialized with swDefaultQueryDef().
typedef struct swQueryDef
{
    /// Ignore bands whose waves are all shorter than this, and free waves that are, m. Range [0, inf]. Default 0.
    float minWavelength;

    /// Stop the search for the water column once the horizontal error is below this, m. Range [1e-6, 1e9]. Default
    /// 0.0005.
    float tolerance;

    /// Evaluations of all waves after a search's first guess. Range [1, 64]. Default 24.
    int maxIterations;

    /// s, past or future. Range [-SW_LARGEST_TIME, SW_LARGEST_TIME], or SW_QUERY_NOW. Default SW_QUERY_NOW. At another
    /// time than the moment's each wave is summed by itself: exact where tiles are interpolated (0.5 % of a band's
    /// height), and some hundred times slower. Systems that are changing keep the amplitudes that they have at the
    /// moment's time. Many points are better asked of a moment of that time.
    double time;

    /// A later moment of the same world, or NULL. From the moment's time to this one's the surface then runs linearly
    /// from the one to the other, at three to four times the cost of a moment's own time: for shots, and for what
    /// happens between two steps. Waves of angular frequency w are off by at most (w dt)^2 / 8 of their height: of
    /// steps of 1/60 s by 0.05 % for waves of 4 m and 3.4 % for ripples of 6 cm. Times that are not between the two are
    /// summed as without it. Default NULL.
    const swMoment* after;

    /// Of swMoment_QueryVolume(). Default SW_STRETCHING_WHEELER.
    swStretching stretching;

    /// Set by swDefaultQueryDef().
    int internalValue;
} swQueryDef;

SW_API swQueryDef swDefaultQueryDef(void);

/// What the last search for a point found, for callers that ask about the same points in each step: the next one then
/// begins where the particle should have gone by now, and takes half to a third of the time. All zero: nothing is
/// known. Keep one for each point, also of points that move with a ship; a query reads and writes it. The answer is as
/// exact with a hint as without, but has other bits within the tolerance; the same hints give the same bits. A hint
/// that is of no use (older than 0.25 s, of other waves, of another point) costs time and nothing else. Plain data:
/// save it where a run must be repeated to the bit.
typedef struct swSurfaceHint
{
    double time;            ///< of the search, s
    float offsetX, offsetZ; ///< from the point to where its particle rests, m
    float rateX, rateZ;     ///< m/s
    float bendX, bendZ;     ///< m/s^2
    float lastStep;         ///< between the last two searches, s
    int searchCount;        ///< searches that the hint knows of, at most 3
} swSurfaceHint;

/// Where answers go: arrays of as many elements as points, or NULL to skip.
typedef struct swSurfaceSamples
{
    /// Height of the water above the point, m (absolute: includes sea level).
    float* height;

    /// Displacement of the water particle that is there, from its resting point, m.
    swVec3* displacement;

    /// Unit normal of the true (Eulerian) surface. Of bands above minWavelength only: the scale asked for.
    swVec3* normal;

    /// Determinant of the horizontal displacement's Jacobian: 1 flat, below 0 folded over.
    float* jacobian;

    /// Horizontal distance between the point and where the answering particle is, m; above the tolerance where the
    /// surface is folded and the search did not converge.
    float* residual;

    /// Velocity, m/s, and acceleration, m/s^2, of the water particle that is there. Fast with
    /// swWorldDef::enableVelocity and enableAcceleration, else summed wave by wave.
    swVec3* velocity;
    swVec3* acceleration;

    /// Read before and written after the search, or NULL. See swSurfaceHint. swWorld_QueryParticles() leaves them
    /// alone.
    swSurfaceHint* hints;

    /// Whether the water is cut away there: whether the surface, where it is displaced to, lies in a hole that inputs
    /// of SW_INPUT_CLIP make, see docs/clip.md. The other answers are those of the surface that would be there. False
    /// at a point that cannot be answered.
    bool* isClipped;
} swSurfaceSamples;

/// Of a batch; every query takes one, or NULL.
typedef struct swQueryStats
{
    int convergedCount; ///< points whose residual is within the tolerance; rays that met the water or came to their end
    int iterationCount; ///< surface evaluations, all points together; a search's first guess counts as one
    float worstResidual; ///< m; 0 of particles and rays
    int badCount;        ///< points, places or rays that could not be answered: their answers are NaN
} swQueryStats;

/// Sample the surface above `count` points of the horizontal plane. `stats` may be NULL.
/// With a bad `def` every point is bad.
SW_API void swMoment_QuerySurface(const swMoment* moment, const swQueryDef* def, int count, const swPosXZ* points,
                                  const swSurfaceSamples* samples, swQueryStats* stats);

/// Height above one point, m. NaN for a point that cannot be answered.
SW_API double swMoment_GetHeight(const swMoment* moment, double x, double z);

/// Sample the particles that rest at `count` points: no search, residual 0. What a moored buoy feels.
/// `slopes` (d height / d x, d height / d z per rest metre) may be NULL, as may any array of `samples` and `stats`.
SW_API void swMoment_QueryParticles(const swMoment* moment, const swQueryDef* def, int count, const swPosXZ* points,
                                    const swSurfaceSamples* samples, swVec2* slopes, swQueryStats* stats);

/// A grid of heights for engines that want one, such as a physics engine's height field. Point (i, j) is at
/// (originX + i * spacing, originZ + j * spacing).
typedef struct swHeightMapDef
{
    double originX, originZ; ///< m
    double spacing;          ///< m. Range (0, inf)
    int width, height;       ///< points along x and along z, at least 1
} swHeightMapDef;

/// Fill `heights` ([height][width], m, absolute): the same answers as swMoment_QuerySurface(). `stats` may be NULL.
SW_API void swMoment_QueryHeightMap(const swMoment* moment, const swQueryDef* def, const swHeightMapDef* map,
                                    float* heights, swQueryStats* stats);

/// Where answers about places in the water go: arrays of as many elements as points, or NULL to skip.
typedef struct swVolumeSamples
{
    /// How far below the surface the place is, measured upwards along the vertical, m; negative in the air.
    float* depth;

    /// Velocity by the waves and with the flow of inputs, m/s, and local acceleration by the waves, m/s^2. 0 in the
    /// air.
    swVec3* velocity;
    swVec3* acceleration;

    /// Dynamic pressure, by which the waves change the pressure of still water, in metres of water: times density and
    /// gravity it is pascals. 0 in the air.
    float* pressureHead;
} swVolumeSamples;

/// Sample the motion of the water at `count` places by linear theory [Dean and Dalrymple 1991], each wave with its own
/// fading with depth. Waves are summed one by one; those too short to reach a place are skipped. `stats`, of the search
/// for the surface above, may be NULL.
///
/// The surface above a place is that which inputs have made (level, floor, weights), and so are its depth and how far
/// it is stretched. Each wave moves the water below by the share and the way that a floor, weights, splines and a flow
/// leave it at the surface above; how it fades with depth follows from the depth of its system's spectrum. A swGpuQuery
/// knows the surface and its level, and of the rest what docs/queries.md says.
SW_API void swMoment_QueryVolume(const swMoment* moment, const swQueryDef* def, int count, const swPos* points,
                                 const swVolumeSamples* samples, swQueryStats* stats);

/// Mean drift of the water at a depth below still water (m, at least 0) by all waves together: Stokes drift in deep and
/// finite water [Kenyon 1969], m/s along x and z. Of open water: inputs do not count. NaN of a depth that is NaN or
/// below 0.
SW_API swVec2 swMoment_GetStokesDrift(const swMoment* moment, double depthBelow);

/// A ray, or a sphere that sweeps along one. Must be initialized with swDefaultRay().
typedef struct swRay
{
    swPos origin;      ///< m
    swVec3 direction;  ///< of any length but 0; finite
    float maxDistance; ///< m. Range [0, 1e5]. Default 1000
    float radius;      ///< of the sphere, m. Range [0, 100]. Default 0: a ray

    /// Time that the way to maxDistance takes, s: the surface moves meanwhile, from the query's time on. Range
    /// [0, 3600]. Default 0: the surface stands still. Otherwise waves are summed one by one, as at any other time, but
    /// for the times up to swQueryDef::after.
    float duration;

    /// Set by swDefaultRay().
    int internalValue;
} swRay;

SW_API swRay swDefaultRay(swPos origin, swVec3 direction);

typedef struct swRayHit
{
    bool isHit;
    float
        distance; ///< along the ray to the sphere's centre, m; without a hit, how far it was looked along: maxDistance
    swPos position; ///< of the sphere's centre then
    swPos point;    ///< of the water that it touches
    swVec3 normal;  ///< of the surface there
    bool fromBelow; ///< it began in the water and came out
} swRayHit;

/// Find where rays first cross the surface, from either side. A ray passes through holes, see docs/clip.md. Along the
/// way the surface is looked at in steps of at most half the shortest wavelength that counts, so that whole crests are
/// not missed; def.minWavelength makes long rays fast. Hits are good to 2 def.tolerance along the ray. A sphere touches
/// where its lowest point seen along the surface's normal does: exact on flat water, and good to radius^2 times the
/// surface's curvature / 2 on waves. A ray looks at the surface at most 100,000 times; one that needs more (a long way
/// just above the water) ends without a hit at the distance that it has come to, and is not among stats'
/// convergedCount. `stats` may be NULL.
SW_API void swMoment_CastRays(const swMoment* moment, const swQueryDef* def, int count, const swRay* rays,
                              swRayHit* hits, swQueryStats* stats);
