// SPDX-License-Identifier: MIT
#include "core/base/field.h"
#include "core/sim/foam.h"
#include "seaway/world.h"

#define SW_DEF swFoamDef

static const swField foamFields[] = {
    SW_NUMBER(fadeRate, "1/s", SW_WITHIN(0.01, 10.0), 0.25, .key = "fade_rate_per_s", .label = "fading",
              .tip = "Foam fades as exp(-rate t)", SW_LOG_KNOB(0.01, 10.0)),
    SW_NUMBER(coverage, "", SW_WITHIN(0.0, 100.0), 1.0, .key = "coverage", .label = "coverage",
              .tip = "Factor on the whitecaps that the wind gives", SW_KNOB(0.0, 5.0)),
    SW_NUMBER(windSpeed, "m/s", SW_WITHIN(0.0, 100.0), 0.0, .key = "wind_speed_mps", .label = "wind",
              .tip = "Wind that makes the whitecaps; at 0 the waves tell it", .zero = "by the waves",
              SW_KNOB(0.0, 40.0)),
    SW_NUMBER(minWavelength, "m", SW_WITHIN(0.0, 1024.0), 0.0, .key = "min_wavelength_m", .label = "shortest wave",
              .tip = "Shorter waves make no foam", SW_KNOB(0.0, 16.0)),
    SW_NUMBER(threshold, "", SW_WITHIN(-4.0, 1.0), 0.0, .key = "threshold", .label = "threshold",
              .tip = "Folding below which foam is born even without wind: 1 is flat water, 0 a fold",
              SW_KNOB(-4.0, 1.0)),
    SW_NUMBER(shoreWidth, "m", SW_WITHIN(0.0, 1000.0), 3.0, .key = "shore_width_m", .label = "width of shore foam",
              .tip = "How far foam reaches from the water's edge, on any slope; 0 for none", .use = SW_USE_STATE,
              SW_KNOB(0.0, 20.0)),
    SW_NUMBER(shoreRate, "1/s", SW_WITHIN(0.0, 100.0), 0.6, .key = "shore_per_s", .label = "shore foam",
              .tip = "Foam made at the water's edge, per second", .use = SW_USE_STATE, SW_KNOB(0.0, 4.0)),
    SW_NUMBER(shoreFadeRate, "1/s", SW_WITHIN(0.01, 10.0), 0.3, .key = "shore_fade_rate_per_s",
              .label = "fading of shore foam", .use = SW_USE_STATE, SW_LOG_KNOB(0.01, 10.0)),
    SW_NUMBER(wakeFadeRate, "1/s", SW_WITHIN(0.01, 10.0), 0.1, .key = "wake_fade_rate_per_s",
              .label = "fading of wakes", .tip = "Foam of inputs and wakes", .use = SW_USE_STATE,
              SW_LOG_KNOB(0.01, 10.0)),
};

const swFields swFoamFields = SW_FIELDS(swFoamDef, "foam", "foam", foamFields, -1);

const swFields* swGetFoamFields(void)
{
    return &swFoamFields;
}

swFoamDef swDefaultFoamDef(void)
{
    swFoamDef def;
    swFillDef(&swFoamFields, &def);
    return def;
}
