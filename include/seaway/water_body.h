// SPDX-License-Identifier: MIT
#pragma once

#include "field.h"
#include "id.h"
#include "input.h"
#include "math.h"
#include "world.h"

/// @file
/// Bodies of water: lakes, basins, canals, a bay of the sea. A body is a polygon with a level, waves, a look and a name
/// of its own. It is built of inputs (SW_INPUT_LEVEL, SW_INPUT_CLIP, SW_INPUT_WAVES and SW_INPUT_BODY over its
/// polygon), so queries, slices and pictures know nothing else of it; but pictures draw each body by itself, so that
/// its level ends at its shore, sharply, at any distance.
///
///     const swVec2 shore[] = {{-40, -30}, {50, -25}, {60, 40}, {-30, 35}};
///     swWaterBodyDef lake = swDefaultWaterBodyDef();
///     lake.points = shore;
///     lake.pointCount = 4;
///     lake.position = (swPos){2000.0, 312.5, -800.0}; // its water stands at 312.5 m
///     swWaterBodyId id;
///     swCreateWaterBody(world, &lake, &id);

/// Bodies that a world can have, and points of one.
#define SW_MAX_WATER_BODIES 1024
#define SW_MAX_SHORE_POINTS 4096

/// Must be initialized with swDefaultWaterBodyDef().
typedef struct swWaterBodyDef
{
    /// For messages and editors. Default "".
    char name[SW_MAX_INPUT_NAME];

    /// Where its points count from, m, in the host's coordinates; y is the height of its still water. Range [-1e9,
    /// 1e9]. Default 0.
    swPos position;

    /// Its shore: x and z from its position, m, in order around the water, either way round; at least 3, at most
    /// SW_MAX_SHORE_POINTS. Edges neither cross nor touch. Copied. Default NULL, 0.
    const swVec2* points;
    int pointCount;

    /// Where bodies overlap, the greatest order counts; of equal ones the last that was made. Its inputs have this
    /// order among those of their fields. Range [-1000000, 1000000]. Default 0.
    int order;

    /// Its water stands at position.y. Default true. False: at whatever level the sea and other inputs have there, as
    /// in a bay that only looks another way.
    bool setsLevel;

    /// A tide of its own, which is added to position.y; without it the water has none, whatever the sea around it does.
    /// Of the time of the step, or of a moment's. Default: none.
    swTideConstituent tide[SW_MAX_TIDE];

    /// There is water in it, whatever inputs of SW_INPUT_CLIP of a lower order take away. Default true.
    bool leavesWater;

    /// The waves of the sea stay outside: those of all systems but `waves` have no weight in it. Default false.
    bool isCalm;

    /// The system whose waves it has, with a weight of 1; usually one with swWaveSystemDef::isLocal. Default null: none
    /// of its own.
    swWaveSystemId waves;

    /// How far inwards from the shore waves of its own grow, and others fade, m. Range [0, 1e5]. Default 0.
    float wavesFeather;

    /// Which water it is drawn with: 0 is the picture's own, see swShot::water; n the one of index n - 1 in
    /// swShot::bodyWaters. Range [0, 255]. Default 0.
    int look;

    /// Default true. False: as if it were not there.
    bool isEnabled;

    /// Set by swDefaultWaterBodyDef().
    int internalValue;
} swWaterBodyDef;

SW_API swWaterBodyDef swDefaultWaterBodyDef(void);
SW_API const swFields* swGetWaterBodyFields(void);

/// Make a body of water, from the next step on.
/// @return SW_ERROR_INVALID (the host's log says what is wrong: a shore that crosses itself, a point that is not
/// finite), SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT (more than SW_MAX_WATER_BODIES, or than SW_MAX_INPUTS); then nothing is
/// made
SW_API swResult swCreateWaterBody(swWorld* world, const swWaterBodyDef* def, swWaterBodyId* id);

/// Take it away, from the next step on.
SW_API void swDestroyWaterBody(swWorld* world, swWaterBodyId id);

SW_API bool swWaterBody_IsValid(const swWorld* world, swWaterBodyId id);

/// Change anything about a body. It keeps its handle.
/// @return as swCreateWaterBody(); then nothing has changed
SW_API swResult swWaterBody_Set(swWorld* world, swWaterBodyId id, const swWaterBodyDef* def);

/// The def as it was given last, with the level set since. Its points are the world's, until the next change.
SW_API swWaterBodyDef swWaterBody_Get(const swWorld* world, swWaterBodyId id);

/// Let its still water stand at another height, m, absolute as positions are: a lock, a reservoir. Range [-1e6, 1e6].
/// Allocates nothing. A body that sets no level keeps to that.
SW_API void swWaterBody_SetLevel(swWorld* world, swWaterBodyId id, double level);

/// The body at a place, as of the last step; null where there is none. NaN is nowhere.
SW_API swWaterBodyId swWorld_FindWaterBody(const swWorld* world, double x, double z);

SW_API int swWorld_GetWaterBodyCount(const swWorld* world);

/// Handles of all bodies, in no order that means anything.
SW_API swWaterBodyId swWorld_GetWaterBody(const swWorld* world, int index);

/// The body of a number as swFieldSamples::body has it; null for -1.
SW_API swWaterBodyId swWorld_GetNumberedWaterBody(const swWorld* world, int number);
