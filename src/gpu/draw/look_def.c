// SPDX-License-Identifier: MIT
// The tables of what a picture shows of sun, air and water.

#include "core/base/field.h"
#include "seaway/draw.h"

#define DEGREES(degrees) ((degrees) * (SW_PI / 180.0))

#define SW_DEF swSkyDef
static const swField skyFields[] = {
    SW_NUMBER(sunAzimuth, "deg", SW_WITHIN(-1000.0, 1000.0), DEGREES(135.0), .key = "azimuth_deg", .section = "sun",
              .label = "sun azimuth", .tip = "Clockwise from north", .form = SW_FORM_DEGREES, .use = SW_USE_HERE,
              SW_KNOB(0.0, 360.0)),
    SW_NUMBER(sunElevation, "deg", SW_WITHIN(DEGREES(-90.0), DEGREES(90.0)), DEGREES(40.0), .key = "elevation_deg",
              .section = "sun", .label = "sun elevation", .form = SW_FORM_DEGREES, .use = SW_USE_HERE,
              SW_KNOB(-10.0, 90.0)),
    SW_NUMBER(sunIlluminance, "lux", SW_WITHIN(0.0, 1e6), 128e3, .key = "illuminance_lux", .section = "sun",
              .label = "illuminance", .tip = "Above the atmosphere", .use = SW_USE_HERE, SW_KNOB(0.0, 200e3)),
    SW_NUMBER(haze, "", SW_WITHIN(0.0, 20.0), 1.0, .key = "haze", .label = "haze",
              .tip = "Aerosol relative to clear air", .use = SW_USE_HERE, SW_KNOB(0.0, 10.0)),
    SW_NUMBER(clouds, "", SW_WITHIN(0.0, 1.0), 0.35, .key = "clouds", .label = "clouds", .tip = "High cloud cover",
              .use = SW_USE_HERE, SW_KNOB(0.0, 1.0)),
};
#undef SW_DEF

static const swFields sky = SW_FIELDS(swSkyDef, "sky", "sun and air", skyFields, -1);

#define SW_DEF swWaterDef
static const swField waterFields[] = {
    SW_NUMBERS(absorption, float, "1/m", SW_WITHIN(0.0, 100.0), SW_EACH(0.30, 0.066, 0.040), .key = "absorption_per_m",
               .label = "absorption", .form = SW_FORM_COLOR, .use = SW_USE_HERE, SW_LOG_KNOB(1e-3, 5.0)),
    SW_NUMBERS(scattering, float, "1/m", SW_WITHIN(0.0, 100.0), SW_EACH(0.22, 0.26, 0.30), .key = "scattering_per_m",
               .label = "scattering", .form = SW_FORM_COLOR, .use = SW_USE_HERE, SW_LOG_KNOB(1e-4, 1.0)),
    SW_NUMBER(refractiveIndex, "", SW_WITHIN(1.0, 3.0), 1.34, .key = "refractive_index", .label = "refractive index",
              .use = SW_USE_HERE, SW_KNOB(1.0, 2.0)),
    SW_NUMBERS(foamAlbedo, float, "", SW_WITHIN(0.0, 1.0), SW_EACH(0.9, 0.9, 0.9), .key = "foam_albedo",
               .label = "foam colour", .form = SW_FORM_COLOR, .use = SW_USE_HERE, SW_KNOB(0.0, 1.0)),
    SW_NUMBER(windSpeed, "m/s", SW_WITHIN(0.0, 100.0), 0.0, .key = "wind_speed_mps", .label = "wind on ripples",
              .tip = "Roughens what no wave resolves; it makes no waves", .zero = "the world's, or 7",
              .use = SW_USE_HERE, SW_KNOB(0.0, 40.0)),
};
#undef SW_DEF

static const swFields water = SW_FIELDS(swWaterDef, "water", "water", waterFields, -1);

const swFields* swGetSkyFields(void)
{
    return &sky;
}

const swFields* swGetWaterFields(void)
{
    return &water;
}

swSkyDef swDefaultSkyDef(void)
{
    swSkyDef def;
    swFillDef(&sky, &def);
    return def;
}

// Clear ocean with some plankton: absorption of pure water [Pope 1997] and pigments at about 610, 540 and 460 nm.
swWaterDef swDefaultWaterDef(void)
{
    swWaterDef def;
    swFillDef(&water, &def);
    return def;
}
