// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"
#include "field.h"
#include "math.h"

/// @file
/// The wind of a world, 10 m above the water. Wave systems that say so (swWaveSystemDef::takesWind), whitecaps, and the
/// ripples of a picture take it, unless they name a wind of their own. It is a function of place and time: a mean,
/// gusts that the mean carries along, and inputs of the field SW_INPUT_WIND, which change it by place.

typedef struct swWorld swWorld;

/// Must be initialized with swDefaultWindDef().
typedef struct swWindDef
{
    /// Mean speed at 10 m above the water, m/s. Range [0, 100]. Default 0: the world names no wind. Then waves and
    /// pictures have the winds of their own defs, and whitecaps the one that the waves tell of.
    float speed;

    /// Where the wind blows to, radians from +x towards +z. Range [-1000, 1000]. Default 0.
    float direction;

    /// Gusts: standard deviation of the speed along the mean, over the mean. Across it is 0.75 times as much. Over open
    /// sea 0.1 to 0.15. Range [0, 1]. Default 0: none.
    float gustStrength;

    /// Time scale of gusts at a place that stays, s: the mean length of what passes, over the mean speed. Range [1,
    /// 3600]. Default 20.
    float gustSeconds;

    /// Another seed is other gusts of the same statistics. Range [0, UINT32_MAX]. Default 1.
    uint32_t gustSeed;

    /// Set by swDefaultWindDef().
    int internalValue;
} swWindDef;

/// No wind that the world names.
SW_API swWindDef swDefaultWindDef(void);
SW_API const swFields* swGetWindFields(void);

/// Change the world's wind. Over `seconds` of its time, from its last step on, the one turns into the other; each keeps
/// its gusts. A change that interrupts another begins at the mean that was reached. Wave systems that take the wind
/// change over the same time, as by swWaveSystem_Set(); that is what it costs. Whitecaps follow at once.
/// @param seconds range [0, SW_MAX_TRANSITION]
/// @return SW_ERROR_INVALID, or what swWaveSystem_Set() returns for a wave system; then the wind is as before, but
/// systems that stand before that one have changed
SW_API swResult swWorld_SetWind(swWorld* world, const swWindDef* def, double seconds);

/// The def that was asked for last.
SW_API swWindDef swWorld_GetWind(const swWorld* world);

/// Winds at points of the host's coordinates, m/s along x and z, gusts and all, without inputs: swMoment_QueryFields()
/// has those too. 0 where the world names no wind, NaN where a point is not finite or farther than 1e12 m away.
/// @param time s, past or future, within SW_LARGEST_TIME; SW_QUERY_NOW is the last step's
/// @param winds [count]
SW_API void swWorld_FindWind(const swWorld* world, double time, int count, const swPosXZ* points, swVec2* winds);
