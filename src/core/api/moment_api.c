// SPDX-License-Identifier: MIT
#include "core/base/misuse.h"
#include "core/world/world.h"

const swMoment* swWorld_GetMoment(const swWorld* world)
{
    SW_REQUIRE(world != NULL, NULL, NULL, "swWorld_GetMoment() needs a world");
    return &world->moment;
}

double swMoment_GetTime(const swMoment* moment)
{
    SW_REQUIRE(moment != NULL, 0.0, NULL, "swMoment_GetTime() needs a moment");
    return moment->frame->time;
}
