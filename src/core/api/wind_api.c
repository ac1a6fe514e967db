// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/misuse.h"
#include "core/world/world.h"
#include "seaway/query.h"

// Of points from the host's origin, m.
#define FARTHEST 1e12

swResult swWorld_SetWind(swWorld* world, const swWindDef* def, double seconds)
{
    SW_REQUIRE(world != NULL && def != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swWorld_SetWind() needs a world and a def");
    SW_REQUIRE(seconds >= 0.0 && seconds <= SW_MAX_TRANSITION, SW_ERROR_INVALID, &world->host,
               "swWorld_SetWind() was asked to take %g s; a change takes 0 to %g s", seconds, SW_MAX_TRANSITION);
    swResult result = swCheckDef(&world->host, &swWindFields, def);
    return result == SW_SUCCESS ? swChangeWorldWind(world, def, seconds) : result;
}

swWindDef swWorld_GetWind(const swWorld* world)
{
    SW_REQUIRE(world != NULL, swDefaultWindDef(), NULL, "swWorld_GetWind() needs a world");
    return world->def.wind;
}

static bool isNear(const swPosXZ* point)
{
    return fabs(point->x) <= FARTHEST && fabs(point->z) <= FARTHEST; // false for NaN
}

void swWorld_FindWind(const swWorld* world, double time, int count, const swPosXZ* points, swVec2* winds)
{
    SW_REQUIRE_VOID(world != NULL && count >= 0 && (count == 0 || (points != NULL && winds != NULL)), swFindHost(world),
                    "swWorld_FindWind() needs a world, points and room for their winds");
    bool isNow = time == SW_QUERY_NOW;
    SW_REQUIRE_VOID(isNow || fabs(time) <= SW_LARGEST_TIME, &world->host,
                    "swWorld_FindWind() was given %.17g s; a time must be within %.17g of 0", time, SW_LARGEST_TIME);
    int64_t ticks = isNow ? world->frame.ticks : (int64_t)floor(time * SW_TICKS_PER_SECOND + 0.5);
    for (int i = 0; i < count; ++i)
    {
        const swPosXZ place = {points[i].x + world->origin.x, points[i].z + world->origin.z};
        winds[i] = (swVec2){NAN, NAN};
        if (isNear(&points[i]))
        {
            swFindWinds(&world->frame.windField, ticks, 1, &place, &winds[i]);
        }
    }
}
