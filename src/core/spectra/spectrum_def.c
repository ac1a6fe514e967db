// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/spectra/compiled.h"

#define FORMULAS (SW_KIND(SW_SPECTRUM_TABLE) - 1u) // all before it
#define GROWING (SW_KIND(SW_SPECTRUM_JONSWAP) | SW_KIND(SW_SPECTRUM_TMA))
#define OCTAVES SW_KIND(SW_SPECTRUM_OCTAVES)
#define TABLES SW_KIND(SW_SPECTRUM_TABLE)

// ---- the equaliser ----

#define SW_DEF swOctave
static const swField octaveFields[] = {
    SW_NUMBER(power, "", SW_WITHIN(-10.0, 5.0), -10.0, .key = "power", .label = "power",
              .tip = "log10 of the density, m^2 s, at the octave's shortest wave", SW_KNOB(-10.0, 5.0)),
    SW_SWITCH(isEnabled, false, .key = "enabled", .label = "on"),
    SW_NUMBER(chop, "", SW_WITHIN(0.0, 4.0), 1.0, .key = "chop", .label = "chop",
              .tip = "Factor on horizontal displacement", SW_KNOB(0.0, 4.0)),
    SW_NUMBER(gravityScale, "", SW_WITHIN(0.0, 4.0), 1.0, .key = "gravity_scale", .label = "gravity",
              .tip = "Factor on gravity, for the waves' speed alone", SW_KNOB(0.0, 4.0)),
};
#undef SW_DEF

const swFields swOctaveFields = SW_PART_FIELDS(swOctave, "octaves", "octave", octaveFields);

#define SW_DEF swOctaves
static const swField octavesFields[] = {
    SW_PARTS(octaves, &swOctaveFields, .key = "octaves", .label = "octaves"),
    SW_NUMBER(multiplier, "", SW_WITHIN(0.0, 10.0), 1.0, .key = "multiplier", .label = "all heights",
              .tip = "Factor on the waves' height", SW_KNOB(0.0, 10.0)),
    SW_NUMBER(chop, "", SW_WITHIN(0.0, 4.0), 1.0, .key = "octaves_chop", .label = "all chops",
              .tip = "Factor on every octave's chop", SW_KNOB(0.0, 4.0)),
    SW_NUMBER(gravityScale, "", SW_WITHIN(0.0, 25.0), 1.0, .key = "gravity_scale", .label = "all gravities",
              .tip = "Factor on every octave's gravity", SW_KNOB(0.0, 25.0)),
    SW_SWITCH(limitByWind, true, .key = "limit_by_wind", .label = "limited by the wind",
              .tip = "Takes away waves that are too long for the wind"),
};
#undef SW_DEF

const swFields swOctavesFields = SW_PART_FIELDS(swOctaves, "waves", "equaliser", octavesFields);

// ---- the spectrum ----

static const char* const kindWords[] = {"jonswap",  "pierson_moskowitz", "tma",  "elfouhaily",
                                        "phillips", "octaves",           "file", NULL};
static const char* const kindNames[] = {"JONSWAP",  "Pierson-Moskowitz", "TMA",   "Elfouhaily",
                                        "Phillips", "octaves",           "table", NULL};
static const char* const growthWords[] = {"hasselmann", "cube_root", NULL};
static const char* const growthNames[] = {"Hasselmann 1973", "cube root", NULL};
static const char* const spreadingWords[] = {"cosine", "mitsuyasu",  "hasselmann", "donelan_banner",
                                             "flat",   "elfouhaily", NULL};
static const char* const spreadingNames[] = {"cos^2s", "Mitsuyasu",  "Hasselmann", "Donelan-Banner",
                                             "flat",   "Elfouhaily", NULL};

#define SW_DEF swSpectrumDef
static const swField spectrumFields[] = {
    SW_CHOICE(kind, kindWords, kindNames, SW_SPECTRUM_JONSWAP, .key = "spectrum", .label = "spectrum"),
    SW_NUMBER(windSpeed, "m/s", SW_ABOVE(0.0, 100.0), 10.0, .key = "wind_speed_mps", .label = "wind",
              .tip = "At 10 m above the water", SW_KNOB(1.0, 40.0)),
    SW_SWITCH(hasWind, false, .key = "wind_is_known", .label = "wind is known",
              .tip = "Whitecaps follow the wind above, also where the height or the period was given"),
    SW_NUMBER(fetch, "m", SW_WITHIN(1e3, 1e7), 300e3, .key = "fetch_m", .label = "fetch",
              .tip = "Distance over which the wind has blown", SW_LOG_KNOB(1e3, 2e6),
              .kinds = GROWING | SW_KIND(SW_SPECTRUM_ELFOUHAILY)),
    SW_CHOICE(growth, growthWords, growthNames, SW_GROWTH_HASSELMANN, .key = "growth", .label = "growth law",
              .tip = "How the peak follows from wind and fetch: as printed in 1973, or by the rounded law that many "
                     "programs take",
              .kinds = GROWING),
    SW_NUMBER(gamma, "", SW_WITHIN(1.0, 10.0), 3.3, .key = "gamma", .label = "peak enhancement", SW_KNOB(1.0, 10.0),
              .kinds = GROWING),
    SW_NUMBER(significantHeight, "m", SW_WITHIN(0.0, 40.0), 0.0, .key = "significant_height_m", .label = "height Hs",
              .zero = "from the wind", SW_KNOB(0.0, 20.0)),
    SW_NUMBER(peakPeriod, "s", SW_WITHIN(0.0, 60.0), 0.0, .key = "peak_period_s", .label = "peak period Tp",
              .zero = "from the wind", SW_KNOB(0.0, 25.0), .kinds = FORMULAS),
    SW_NUMBER(direction, "deg", SW_WITHIN(-1000.0, 1000.0), 0.0, .key = "direction_from_deg", .label = "comes from",
              .form = SW_FORM_BEARING, SW_KNOB(0.0, 360.0)),
    SW_CHOICE(spreading, spreadingWords, spreadingNames, SW_SPREADING_COSINE_2S, .key = "spreading",
              .label = "spreading", .kinds = FORMULAS),
    SW_NUMBER(spreadExponent, "", SW_WITHIN(0.0, 200.0), 8.0, .key = "spread_exponent", .label = "spreading s",
              .tip = "cos^2s of half the angle: 0 is from all sides, 8 a wind sea, 75 a swell", SW_KNOB(0.0, 75.0),
              .kinds = FORMULAS),
    SW_NUMBER(turbulence, "", SW_WITHIN(0.0, 1.0), 0.0, .key = "turbulence", .label = "turbulence",
              .tip = "Part of the energy that goes in all directions alike", SW_KNOB(0.0, 1.0), .kinds = FORMULAS),
    SW_NUMBER(swell, "", SW_WITHIN(0.0, 1.0), 0.0, .key = "swell", .label = "swell",
              .tip = "Draws the longest waves out into parallel crests", SW_KNOB(0.0, 1.0), .kinds = FORMULAS),
    SW_PART(octaves, &swOctavesFields, .key = NULL, .label = "octaves", .kinds = OCTAVES),
    SW_NUMBER(depth, "m", SW_WITHIN(0.001, (double)INFINITY), (double)INFINITY, .key = "depth_m", .label = "depth",
              .tip = "Of the water that the waves run over", SW_LOG_KNOB(1.0, 1000.0)),
    SW_GIVEN(table, .key = NULL, .label = "table", .kinds = TABLES),
    SW_SWITCH(extendTail, true, .key = "extend_tail", .label = "tail",
              .tip = "Continues a table beyond its highest frequency", .kinds = TABLES),
};
#undef SW_DEF

const swFields swSpectrumFields = SW_FIELDS(swSpectrumDef, "waves", "spectrum", spectrumFields, 0);

const swFields* swGetOctaveFields(void)
{
    return &swOctaveFields;
}

const swFields* swGetOctavesFields(void)
{
    return &swOctavesFields;
}

const swFields* swGetSpectrumFields(void)
{
    return &swSpectrumFields;
}

swSpectrumDef swDefaultSpectrumDef(void)
{
    swSpectrumDef def;
    swFillDef(&swSpectrumFields, &def);
    def.octaves = swDefaultOctaves(); // each octave has its own power
    return def;
}
