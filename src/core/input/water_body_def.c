// SPDX-License-Identifier: MIT
#include <stdio.h>

#include "core/input/polygon.h"
#include "core/input/tide.h"
#include "core/input/water_bodies.h"

#define SW_DEF swWaterBodyDef
static const swField bodyFields[] = {
    SW_TEXT(name, .key = "name", .label = "name"),
    SW_NUMBERS(position, double, "m", SW_WITHIN(-1e9, 1e9), SW_EACH(0.0, 0.0, 0.0), .key = "position_m",
               .label = "place", .tip = "Where its shore counts from, and the height of its still water",
               SW_KNOB(-1000.0, 1000.0)),
    SW_GIVEN(points, .key = NULL, .label = "shore"),
    SW_GIVEN(pointCount, .key = NULL, .label = "number of points"),
    SW_NUMBER(order, "", SW_WITHIN(-1e6, 1e6), 0.0, .key = "order", .label = "order",
              .tip = "Where bodies overlap, the greatest counts; of equal ones the last that was made",
              SW_KNOB(-100.0, 100.0)),
    SW_SWITCH(setsLevel, true, .key = "sets_level", .label = "sets the level"),
    SW_PARTS(tide, &swTideConstituentFields, .key = "tide", .label = "tide",
             .tip = "Harmonics that are added to the height of its water"),
    SW_SWITCH(leavesWater, true, .key = "leaves_water", .label = "leaves water",
              .tip = "There is water in it, whatever was cut before"),
    SW_SWITCH(isCalm, false, .key = "is_calm", .label = "calm", .tip = "The waves of the sea stay outside"),
    SW_GIVEN(waves, .key = NULL, .label = "waves of its own"),
    SW_NUMBER(wavesFeather, "m", SW_WITHIN(0.0, 1e5), 0.0, .key = "waves_feather_m", .label = "waves grow within",
              SW_KNOB(0.0, 100.0)),
    SW_NUMBER(look, "", SW_WITHIN(0.0, 255.0), 0.0, .key = "look", .label = "look",
              .tip = "Which water it is drawn with", SW_KNOB(0.0, 255.0)),
    SW_SWITCH(isEnabled, true, .key = "is_enabled", .label = "enabled"),
};
#undef SW_DEF

const swFields swWaterBodyFields = SW_FIELDS(swWaterBodyDef, "water_bodies", "body of water", bodyFields, -1);

const swFields* swGetWaterBodyFields(void)
{
    return &swWaterBodyFields;
}

swWaterBodyDef swDefaultWaterBodyDef(void)
{
    swWaterBodyDef def;
    swFillDef(&swWaterBodyFields, &def);
    return def;
}

swResult swCheckWaterBodyDef(const swHost* host, const swWaterBodyDef* def)
{
    swResult result = swCheckDef(host, &swWaterBodyFields, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (def->points == NULL)
    {
        return swFail(host, SW_ERROR_INVALID, "the body of water '%s' has no shore; set swWaterBodyDef::points",
                      def->name);
    }
    char what[SW_MAX_INPUT_NAME + 32];
    snprintf(what, sizeof what, "the body of water '%s'", def->name);
    return swCheckPolygon(host, what, def->pointCount, &def->points->x, 2);
}
