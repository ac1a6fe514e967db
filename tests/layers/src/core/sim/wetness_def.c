// SPDX-License-Identifier: MIT
#include "core/base/field.h"
#include "core/sim/wetness.h"
#include "seaway/world.h"

#define SW_DEF swWetnessDef

static const swField wetnessFields[] = {
    SW_NUMBER(soak, "1/m", SW_WITHIN(0.0, 10.0), 2.0, .key = "soak_per_m", .label = "soaking", SW_KNOB(0.0, 10.0)),
    SW_NUMBER(dryRate, "1/s", SW_WITHIN(0.01, 10.0), 0.5, .key = "dry_rate_per_s", .label = "drying",
              .tip = "Wetness fades as exp(-rate t)", SW_LOG_KNOB(0.01, 10.0)),
};

const swFields swWetnessFields = SW_FIELDS(swWetnessDef, "wetness", "wetness", wetnessFields, -1);

swWetnessDef swDefaultWetnessDef(void)
{
    swWetnessDef def;
    swFillDef(&swWetnessFields, &def);
    return def;
}
