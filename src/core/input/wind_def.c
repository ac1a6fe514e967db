// SPDX-License-Identifier: MIT
#include "core/input/wind.h"
#include "seaway/math.h"

#define SW_DEF swWindDef
static const swField windFields[] = {
    SW_NUMBER(speed, "m/s", SW_WITHIN(0.0, 100.0), 0.0, .key = "speed_mps", .label = "wind",
              .tip = "Mean at 10 m; waves and water that name no wind of their own take it", .zero = "none is named",
              SW_KNOB(0.0, 40.0)),
    SW_NUMBER(direction, "deg", SW_WITHIN(-1000.0, 1000.0), 0.0, .key = "direction_from_deg", .label = "from",
              .tip = "Where it blows from, clockwise from north", .form = SW_FORM_BEARING, SW_KNOB(0.0, 360.0)),
    SW_NUMBER(gustStrength, "", SW_WITHIN(0.0, 1.0), 0.0, .key = "gust_strength", .label = "gusts",
              .tip = "Standard deviation of the speed over its mean: 0.1 to 0.15 over open sea", SW_KNOB(0.0, 0.5)),
    SW_NUMBER(gustSeconds, "s", SW_WITHIN(1.0, 3600.0), 20.0, .key = "gust_time_s", .label = "length of gusts",
              .tip = "Time that a gust takes to pass", SW_LOG_KNOB(1.0, 600.0)),
    SW_NUMBER(gustSeed, "", SW_WITHIN(0.0, 4294967295.0), 1.0, .key = "gust_seed", .label = "seed of gusts",
              SW_KNOB(0.0, 100.0)),
};
#undef SW_DEF

const swFields swWindFields = SW_FIELDS(swWindDef, "wind", "wind", windFields, -1);

const swFields* swGetWindFields(void)
{
    return &swWindFields;
}

swWindDef swDefaultWindDef(void)
{
    swWindDef def;
    swFillDef(&swWindFields, &def);
    return def;
}
