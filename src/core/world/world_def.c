// SPDX-License-Identifier: MIT
#include "core/base/field.h"
#include "core/input/wind.h"
#include "core/sim/foam.h"
#include "core/world/world.h"

const char* const swIsaWords[SW_ISA_COUNT + 1] = {"best", "scalar", "sse2", "avx2", "neon", "avx512", NULL};

#define SW_DEF swWorldDef
static const swField worldFields[] = {
    SW_NUMBER(gravity, "m/s^2", SW_ABOVE(0.0, 100.0), 9.81, .key = "gravity_mps2", .label = "gravity",
              SW_KNOB(1.0, 25.0)),
    SW_NUMBER(surfaceTension, "m^3/s^2", SW_WITHIN(0.0, 1e-3), 7.4e-5, .key = "surface_tension_m3ps2",
              .label = "surface tension", .tip = "Over density; it makes ripples faster", SW_KNOB(0.0, 1e-3)),
    SW_NUMBER(seaLevel, "m", SW_WITHIN(-1e6, 1e6), 0.0, .key = "sea_level_m", .label = "sea level",
              SW_KNOB(-100.0, 100.0)),
    SW_SWITCH(enableQueries, true, .key = NULL, .label = "queries", .tip = "Compute the surface on the CPU",
              .use = SW_USE_STATE),
    SW_SWITCH(enableVelocity, false, .key = NULL, .label = "velocities",
              .tip = "Keep velocities of the surface, for fast queries", .use = SW_USE_STATE),
    SW_SWITCH(enableAcceleration, false, .key = NULL, .label = "accelerations",
              .tip = "Keep accelerations of the surface, for fast queries", .use = SW_USE_STATE),
    SW_PART(foam, &swFoamFields, .key = "foam", .label = "foam"),
    // The digest has it where one is named.
    SW_PART(wind, &swWindFields, .key = "wind", .label = "wind", .use = SW_USE_STATE),
    SW_CHOICE(isa, swIsaWords, swIsaWords, SW_ISA_BEST, .key = NULL, .label = "instruction set", .use = SW_USE_HERE),
};
#undef SW_DEF

const swFields swWorldFields = SW_FIELDS(swWorldDef, "world", "world", worldFields, -1);

const swFields* swGetWorldFields(void)
{
    return &swWorldFields;
}

swWorldDef swDefaultWorldDef(void)
{
    swWorldDef def;
    swFillDef(&swWorldFields, &def);
    return def;
}
