// SPDX-License-Identifier: MIT
// Scene files. Keys are snake case and carry their unit; docs/scenes.md lists them. What a file leaves out keeps the
// default of the def that it fills.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/misuse.h"
#include "scene/scene_components.h"
#include "files/file_text.h"
#include "scene/scene_measured.h"
#include "scene/scene_octaves.h"
#include "scene/yaml_read.h"
#include "seaway/scene.h"

#define MAX_SCENE_SIZE ((size_t)1 << 20)
#define COUNT(rows) ((int)(sizeof(rows) / sizeof((rows)[0])))

// Beyond any sea, yet far from where doubles lose millimetres.
#define FAR 1e9

typedef struct Reader
{
    swScene* scene;
    const char* folder;
} Reader;

static swScene* getScene(const swYaml* yaml)
{
    return ((Reader*)yaml->context)->scene;
}

// ---- sections that fill one def ----

static const swYamlField worldFields[] = {
    {.key = "gravity_mps2", .type = SW_YAML_FLOAT, .offset = offsetof(swWorldDef, gravity), .low = 0.1, .high = 100.0},
    {.key = "surface_tension_m3ps2",
     .type = SW_YAML_FLOAT,
     .offset = offsetof(swWorldDef, surfaceTension),
     .low = 0.0,
     .high = 1e-3},
    {.key = "sea_level_m", .type = SW_YAML_DOUBLE, .offset = offsetof(swWorldDef, seaLevel), .low = -1e6, .high = 1e6},
};

static const swYamlField foamFields[] = {
    {.key = "fade_rate_per_s",
     .type = SW_YAML_FLOAT,
     .offset = offsetof(swFoamDef, fadeRate),
     .low = 0.01,
     .high = 10.0},
    {.key = "coverage", .type = SW_YAML_FLOAT, .offset = offsetof(swFoamDef, coverage), .low = 0.0, .high = 100.0},
    {.key = "wind_speed_mps",
     .type = SW_YAML_FLOAT,
     .offset = offsetof(swFoamDef, windSpeed),
     .low = 0.0,
     .high = 100.0},
    {.key = "min_wavelength_m",
     .type = SW_YAML_FLOAT,
     .offset = offsetof(swFoamDef, minWavelength),
     .low = 0.0,
     .high = 1024.0},
    {.key = "threshold", .type = SW_YAML_FLOAT, .offset = offsetof(swFoamDef, threshold), .low = -4.0, .high = 1.0},
};

static const swYamlField viewFields[] = {
    {.key = "slice_count",
     .type = SW_YAML_INT,
     .offset = offsetof(swViewDef, sliceCount),
     .low = 2.0,
     .high = SW_MAX_SLICES},
    {.key = "resolution", .type = SW_YAML_INT, .offset = offsetof(swViewDef, resolution), .low = 64.0, .high = 1024.0},
    {.key = "finest_texel_m",
     .type = SW_YAML_FLOAT,
     .offset = offsetof(swViewDef, finestTexel),
     .low = 0.015625,
     .high = 16.0},
    {.key = "max_scale_level",
     .type = SW_YAML_INT,
     .offset = offsetof(swViewDef, maxScaleLevel),
     .low = 0.0,
     .high = 16.0},
};

static const swYamlField sunFields[] = {
    {.key = "azimuth_deg",
     .type = SW_YAML_DEGREES,
     .offset = offsetof(swSkyDef, sunAzimuth),
     .low = -360.0,
     .high = 360.0},
    {.key = "elevation_deg",
     .type = SW_YAML_DEGREES,
     .offset = offsetof(swSkyDef, sunElevation),
     .low = -90.0,
     .high = 90.0},
    {.key = "illuminance_lux",
     .type = SW_YAML_FLOAT,
     .offset = offsetof(swSkyDef, sunIlluminance),
     .low = 0.0,
     .high = 1e6},
};

static const swYamlField skyFields[] = {
    {.key = "haze", .type = SW_YAML_FLOAT, .offset = offsetof(swSkyDef, haze), .low = 0.0, .high = 20.0},
    {.key = "clouds", .type = SW_YAML_FLOAT, .offset = offsetof(swSkyDef, clouds), .low = 0.0, .high = 1.0},
};

static const swYamlField waterFields[] = {
    {.key = "absorption_per_m",
     .type = SW_YAML_COLOR,
     .offset = offsetof(swWaterDef, absorption),
     .low = 0.0,
     .high = 100.0},
    {.key = "scattering_per_m",
     .type = SW_YAML_COLOR,
     .offset = offsetof(swWaterDef, scattering),
     .low = 0.0,
     .high = 100.0},
    {.key = "refractive_index",
     .type = SW_YAML_FLOAT,
     .offset = offsetof(swWaterDef, refractiveIndex),
     .low = 1.0,
     .high = 3.0},
    {.key = "foam_albedo", .type = SW_YAML_COLOR, .offset = offsetof(swWaterDef, foamAlbedo), .low = 0.0, .high = 1.0},
    {.key = "wind_speed_mps",
     .type = SW_YAML_FLOAT,
     .offset = offsetof(swWaterDef, windSpeed),
     .low = 0.0,
     .high = 100.0},
};

static swResult readWorld(swYaml* yaml, yaml_node_t* node, void* target)
{
    swScene* scene = target;
    return swReadYamlMapping(yaml, node, "world", worldFields, SW_YAML_COUNT(worldFields), &scene->world, NULL);
}

static swResult readFoam(swYaml* yaml, yaml_node_t* node, void* target)
{
    swScene* scene = target;
    return swReadYamlMapping(yaml, node, "foam", foamFields, SW_YAML_COUNT(foamFields), &scene->world.foam, NULL);
}

static swResult readView(swYaml* yaml, yaml_node_t* node, void* target)
{
    swScene* scene = target;
    swYamlNodes nodes;
    swResult result =
        swReadYamlMapping(yaml, node, "view", viewFields, SW_YAML_COUNT(viewFields), &scene->view, &nodes);
    if (scene->view.resolution % 64 != 0)
    {
        result = swFailYaml(yaml, nodes.nodes[1], SW_MISTAKE_OUT_OF_RANGE,
                            "resolution is %d; it must be a multiple of 64.", scene->view.resolution);
    }
    if (nodes.nodes[2] != NULL && !nodes.isWrong[2])
    {
        float power = 16.0f;
        while (power > scene->view.finestTexel)
        {
            power *= 0.5f;
        }
        if (power != scene->view.finestTexel)
        {
            result = swFailYaml(yaml, nodes.nodes[2], SW_MISTAKE_OUT_OF_RANGE,
                                "finest_texel_m is %g; it must be a power of two, such as %g.",
                                (double)scene->view.finestTexel, (double)power);
        }
    }
    return result;
}

static swResult readSun(swYaml* yaml, yaml_node_t* node, void* target)
{
    swScene* scene = target;
    return swReadYamlMapping(yaml, node, "sun", sunFields, SW_YAML_COUNT(sunFields), &scene->sky, NULL);
}

static swResult readSky(swYaml* yaml, yaml_node_t* node, void* target)
{
    swScene* scene = target;
    return swReadYamlMapping(yaml, node, "sky", skyFields, SW_YAML_COUNT(skyFields), &scene->sky, NULL);
}

static swResult readWater(swYaml* yaml, yaml_node_t* node, void* target)
{
    swScene* scene = target;
    return swReadYamlMapping(yaml, node, "water", waterFields, SW_YAML_COUNT(waterFields), &scene->water, NULL);
}

// ---- wave systems ----

// In the order of swSpectrumKind, then what the one-knob functions make. The last three are not words of `spectrum` but
// keys of their own.
static const char* const spectrumWords[] = {
    "jonswap", "pierson_moskowitz", "tma", "elfouhaily", "phillips", "octaves", "file", "wind_sea", "swell", NULL};
static const char* const knobWords[] = {"beaufort", "sea_state", "components"};

enum
{
    WIND_SEA_KIND = SW_SPECTRUM_KIND_COUNT,
    SWELL_KIND,
    BEAUFORT_KIND,
    SEA_STATE_KIND,
    COMPONENTS_KIND
};

// In the order of swSpreadingKind.
static const char* const spreadingWords[] = {"cosine", "mitsuyasu",  "hasselmann", "donelan_banner",
                                             "flat",   "elfouhaily", NULL};

// In the order of swGrowthLaw.
static const char* const growthWords[] = {"hasselmann", "cube_root", NULL};

typedef struct WavesText
{
    swSceneWaves* waves;
    int kind;
    float beaufort, seaState;
    float durationHours;
    float spread;
    int spreading;
    int growth;
    swOctavesText octaves;
    swMeasuredText measured;
    swWaveSystemDef def;
} WavesText;

#define TEXT(member) offsetof(WavesText, member)

#define SPECTRUM(member)                                                                                               \
    (offsetof(WavesText, def) + offsetof(swWaveSystemDef, spectrum) + offsetof(swSpectrumDef, member))
#define SYSTEM(member) (offsetof(WavesText, def) + offsetof(swWaveSystemDef, member))

enum
{
    KIND,
    BEAUFORT,
    SEA_STATE,
    COMPONENTS,
    FILE_NAME,
    FILE_LIST,
    PLACE,
    LATITUDE,
    LONGITUDE,
    DIRECTIONS,
    AT,
    REPLAY,
    WIND_SPEED,
    FETCH,
    GROWTH,
    DURATION,
    GAMMA,
    HEIGHT,
    PEAK_PERIOD,
    DIRECTION,
    SPREADING,
    SPREAD_EXPONENT,
    SPREAD,
    TURBULENCE,
    ELONGATION,
    OCTAVES,
    OCTAVES_START,
    MULTIPLIER,
    GRAVITY_SCALE,
    LIMIT_BY_WIND,
    TURN,
    EXTEND_TAIL,
    RESOLUTION,
    TILE_WAVES,
    MIN_WAVELENGTH,
    MAX_WAVELENGTH,
    CHOP,
    WEIGHT,
    DEPTH,
    LOOP_PERIOD,
    SEED,
    METHOD,
    COMPONENTS_PER_OCTAVE,
    REVERSE_WEIGHT,
    DIRECTION_VARIANCE,
    LEAST_JACOBIAN,
    WAVES_FIELD_COUNT
};

// In the order of swWaveMethod.
static const char* const methodWords[] = {"fft", "gerstner", NULL};

static swResult readOctavesKey(swYaml* yaml, yaml_node_t* node, void* target)
{
    return swReadOctaves(yaml, node, &((WavesText*)target)->octaves);
}

static swResult readComponentsKey(swYaml* yaml, yaml_node_t* node, void* target)
{
    return swReadComponents(yaml, node, ((WavesText*)target)->waves);
}

static swResult readReplayKey(swYaml* yaml, yaml_node_t* node, void* target)
{
    return swReadReplay(yaml, node, &((WavesText*)target)->measured);
}

// Read later, when the other keys are known.
static swResult keepNode(swYaml* yaml, yaml_node_t* node, void* target)
{
    (void)yaml;
    (void)node;
    (void)target;
    return SW_SUCCESS;
}

static const swYamlField wavesFields[WAVES_FIELD_COUNT] = {
    [KIND] = {.key = "spectrum", .type = SW_YAML_CHOICE, .offset = offsetof(WavesText, kind), .words = spectrumWords},
    [BEAUFORT] = {.key = "beaufort", .type = SW_YAML_FLOAT, .offset = TEXT(beaufort), .low = 0.0, .high = 12.0},
    [SEA_STATE] = {.key = "sea_state", .type = SW_YAML_FLOAT, .offset = TEXT(seaState), .low = 0.0, .high = 9.0},
    [COMPONENTS] = {.key = "components", .type = SW_YAML_CUSTOM, .read = readComponentsKey},
    [DURATION] =
        {.key = "duration_h", .type = SW_YAML_FLOAT, .offset = TEXT(durationHours), .low = 0.1, .high = 1000.0},
    [SPREADING] = {.key = "spreading", .type = SW_YAML_CHOICE, .offset = TEXT(spreading), .words = spreadingWords},
    [SPREAD] = {.key = "spread_deg", .type = SW_YAML_DEGREES, .offset = TEXT(spread), .low = 6.0, .high = 80.0},
    [TURBULENCE] =
        {.key = "turbulence", .type = SW_YAML_FLOAT, .offset = SPECTRUM(turbulence), .low = 0.0, .high = 1.0},
    [ELONGATION] = {.key = "swell", .type = SW_YAML_FLOAT, .offset = SPECTRUM(swell), .low = 0.0, .high = 1.0},
    [OCTAVES] = {.key = "octaves", .type = SW_YAML_CUSTOM, .read = readOctavesKey},
    [OCTAVES_START] = {.key = "octaves_from",
                       .type = SW_YAML_CHOICE,
                       .offset = TEXT(octaves.start),
                       .words = swOctaveStartWords},
    [MULTIPLIER] =
        {.key = "multiplier", .type = SW_YAML_FLOAT, .offset = TEXT(octaves.multiplier), .low = 0.0, .high = 10.0},
    [GRAVITY_SCALE] =
        {.key = "gravity_scale", .type = SW_YAML_FLOAT, .offset = TEXT(octaves.gravityScale), .low = 0.0, .high = 25.0},
    [LIMIT_BY_WIND] = {.key = "limit_by_wind", .type = SW_YAML_BOOL, .offset = TEXT(octaves.limitByWind)},
    [FILE_NAME] = {.key = "file", .type = SW_YAML_TEXT, .offset = TEXT(measured.file), .size = 512},
    [FILE_LIST] = {.key = "files", .type = SW_YAML_CUSTOM, .read = keepNode},
    [PLACE] = {.key = "location", .type = SW_YAML_TEXT, .offset = TEXT(measured.location), .size = 64},
    [LATITUDE] =
        {.key = "latitude", .type = SW_YAML_DOUBLE, .offset = TEXT(measured.latitude), .low = -90.0, .high = 90.0},
    [LONGITUDE] =
        {.key = "longitude", .type = SW_YAML_DOUBLE, .offset = TEXT(measured.longitude), .low = -180.0, .high = 360.0},
    [DIRECTIONS] = {.key = "directions",
                    .type = SW_YAML_CHOICE,
                    .offset = TEXT(measured.directions),
                    .words = swDirectionWords},
    [AT] = {.key = "at", .type = SW_YAML_TEXT, .offset = TEXT(measured.at), .size = 32},
    [REPLAY] = {.key = "replay", .type = SW_YAML_CUSTOM, .read = readReplayKey},
    [WIND_SPEED] =
        {.key = "wind_speed_mps", .type = SW_YAML_FLOAT, .offset = SPECTRUM(windSpeed), .low = 0.1, .high = 100.0},
    [FETCH] = {.key = "fetch_m", .type = SW_YAML_FLOAT, .offset = SPECTRUM(fetch), .low = 1e3, .high = 1e7},
    [GROWTH] = {.key = "growth", .type = SW_YAML_CHOICE, .offset = TEXT(growth), .words = growthWords},
    [GAMMA] = {.key = "gamma", .type = SW_YAML_FLOAT, .offset = SPECTRUM(gamma), .low = 1.0, .high = 10.0},
    [HEIGHT] = {.key = "significant_height_m",
                .type = SW_YAML_FLOAT,
                .offset = SPECTRUM(significantHeight),
                .low = 0.0,
                .high = 40.0},
    [PEAK_PERIOD] =
        {.key = "peak_period_s", .type = SW_YAML_FLOAT, .offset = SPECTRUM(peakPeriod), .low = 0.0, .high = 60.0},
    [DIRECTION] = {.key = "direction_from_deg",
                   .type = SW_YAML_BEARING,
                   .offset = SPECTRUM(direction),
                   .low = -360.0,
                   .high = 360.0},
    [SPREAD_EXPONENT] = {.key = "spread_exponent",
                         .type = SW_YAML_FLOAT,
                         .offset = SPECTRUM(spreadExponent),
                         .low = 0.0,
                         .high = 200.0},
    [TURN] = {.key = "turn_deg", .type = SW_YAML_DEGREES, .offset = SPECTRUM(direction), .low = -360.0, .high = 360.0},
    [EXTEND_TAIL] = {.key = "extend_tail", .type = SW_YAML_BOOL, .offset = SPECTRUM(extendTail)},
    [RESOLUTION] = {.key = "resolution", .type = SW_YAML_INT, .offset = SYSTEM(resolution), .low = 16.0, .high = 512.0},
    [TILE_WAVES] = {.key = "tile_waves", .type = SW_YAML_INT, .offset = SYSTEM(tileWaves), .low = 4.0, .high = 128.0},
    [MIN_WAVELENGTH] = {.key = "min_wavelength_m",
                        .type = SW_YAML_FLOAT,
                        .offset = SYSTEM(minWavelength),
                        .low = 0.0625,
                        .high = 4096.0},
    [MAX_WAVELENGTH] = {.key = "max_wavelength_m",
                        .type = SW_YAML_FLOAT,
                        .offset = SYSTEM(maxWavelength),
                        .low = 0.0625,
                        .high = 4096.0},
    [CHOP] = {.key = "chop", .type = SW_YAML_FLOAT, .offset = SYSTEM(chop), .low = 0.0, .high = 2.0},
    [WEIGHT] = {.key = "weight", .type = SW_YAML_FLOAT, .offset = SYSTEM(weight), .low = 0.0, .high = 10.0},
    [DEPTH] = {.key = "depth_m", .type = SW_YAML_FLOAT, .offset = SPECTRUM(depth), .low = 0.001, .high = 1e9},
    [LOOP_PERIOD] = {.key = "loop_period_s",
                     .type = SW_YAML_FLOAT,
                     .offset = SYSTEM(loopPeriod),
                     .low = 0.0,
                     .high = SW_LARGEST_TIME},
    [SEED] = {.key = "seed", .type = SW_YAML_UINT, .offset = SYSTEM(seed), .low = 0.0, .high = 4294967295.0},
    [METHOD] = {.key = "method", .type = SW_YAML_CHOICE, .offset = SYSTEM(method), .words = methodWords},
    [COMPONENTS_PER_OCTAVE] = {.key = "components_per_octave",
                               .type = SW_YAML_INT,
                               .offset = SYSTEM(componentsPerOctave),
                               .low = 1.0,
                               .high = 32.0},
    [REVERSE_WEIGHT] =
        {.key = "reverse_weight", .type = SW_YAML_FLOAT, .offset = SYSTEM(reverseWeight), .low = 0.0, .high = 1.0},
    [LEAST_JACOBIAN] =
        {.key = "least_jacobian", .type = SW_YAML_FLOAT, .offset = SYSTEM(leastJacobian), .low = -10.0, .high = 0.9},
    [DIRECTION_VARIANCE] = {.key = "direction_variance_deg",
                            .type = SW_YAML_DEGREES,
                            .offset = SYSTEM(directionVariance),
                            .low = 0.0,
                            .high = 180.0},
};

static const char* getKindWord(int kind)
{
    return kind >= BEAUFORT_KIND ? knobWords[kind - BEAUFORT_KIND] : spectrumWords[kind];
}

// `spectrum`, `beaufort`, `sea_state` or `components`: one of them, which is the kind.
static swResult chooseKind(swYaml* yaml, yaml_node_t* node, WavesText* text, const swYamlNodes* nodes)
{
    static const int fields[] = {KIND, BEAUFORT, SEA_STATE, COMPONENTS};
    const yaml_node_t* second = NULL;
    int count = 0;
    for (int i = 0; i < COUNT(fields); ++i)
    {
        const yaml_node_t* given = nodes->nodes[fields[i]];
        bool isLater = given != NULL && (second == NULL || given->start_mark.index > second->start_mark.index);
        second = isLater ? given : second;
        count += given != NULL;
    }
    if (nodes->isWrong[KIND])
    {
        return SW_ERROR_FORMAT; // has been told
    }
    if (count == 0)
    {
        return swFailYaml(
            yaml, node, SW_MISTAKE_MISSING_KEY,
            "the key spectrum is missing; it is jonswap, pierson_moskowitz, tma, elfouhaily, phillips, "
            "octaves, file, wind_sea or swell. Or give a number of beaufort or sea_state, or a list of components.");
    }
    if (count > 1)
    {
        return swFailYaml(yaml, second, SW_MISTAKE_CONFLICT,
                          "spectrum, beaufort, sea_state and components each make the waves; keep one of them.");
    }
    text->kind = nodes->nodes[BEAUFORT] != NULL     ? BEAUFORT_KIND
                 : nodes->nodes[SEA_STATE] != NULL  ? SEA_STATE_KIND
                 : nodes->nodes[COMPONENTS] != NULL ? COMPONENTS_KIND
                                                    : text->kind;
    return SW_SUCCESS;
}

// Sets of kinds.
#define ONE(kind) (1u << (kind))
#define FILES ONE(SW_SPECTRUM_TABLE)
#define FORMULAS (FILES - 1u) // all before it
#define NUMBERS (ONE(BEAUFORT_KIND) | ONE(SEA_STATE_KIND))
#define WIND_SEAS (ONE(WIND_SEA_KIND) | NUMBERS)
#define GROWING (ONE(SW_SPECTRUM_JONSWAP) | ONE(SW_SPECTRUM_TMA))
#define EQUALISERS ONE(SW_SPECTRUM_OCTAVES)
#define SPECTRA (~ONE(COMPONENTS_KIND))

// The same of keys that only one method knows. Waves given by hand have a method of their own.
static swResult checkMethodKeys(swYaml* yaml, WavesText* text, const swYamlNodes* nodes)
{
    static const struct
    {
        int field;
        swWaveMethod method;
        unsigned kinds; // of others the field has been told of
    } rules[] = {
        {RESOLUTION, SW_WAVES_FFT, ~0u},
        {TILE_WAVES, SW_WAVES_FFT, ~0u},
        {COMPONENTS_PER_OCTAVE, SW_WAVES_GERSTNER, SPECTRA},
        {REVERSE_WEIGHT, SW_WAVES_GERSTNER, SPECTRA},
        {DIRECTION_VARIANCE, SW_WAVES_GERSTNER, SPECTRA},
        {LEAST_JACOBIAN, SW_WAVES_GERSTNER, SPECTRA},
    };
    if (text->kind == COMPONENTS_KIND && nodes->nodes[METHOD] != NULL && text->def.method != SW_WAVES_GERSTNER)
    {
        return swFailYaml(yaml, nodes->nodes[METHOD], SW_MISTAKE_CONFLICT,
                          "components are made with 'method: gerstner' only; remove this.");
    }
    text->def.method = text->kind == COMPONENTS_KIND ? SW_WAVES_GERSTNER : text->def.method;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < COUNT(rules) && !nodes->isWrong[METHOD]; ++i)
    {
        const yaml_node_t* node = nodes->nodes[rules[i].field];
        if (node != NULL && rules[i].method != text->def.method && (rules[i].kinds & ONE(text->kind)) != 0)
        {
            result = swFailYaml(yaml, node, SW_MISTAKE_NO_EFFECT, "%s has an effect with 'method: %s' only; %s.",
                                wavesFields[rules[i].field].key, methodWords[rules[i].method],
                                rules[i].method == SW_WAVES_GERSTNER ? "add that or remove it" : "remove it");
        }
    }
    return result;
}

// Keys that do not go with a kind of spectrum would have no effect: refused, so that nobody turns a dead knob.
static swResult checkKeys(swYaml* yaml, WavesText* text, const swYamlNodes* nodes)
{
    static const struct
    {
        int field;
        unsigned kinds;
    } rules[] = {
        {FILE_NAME, FILES},
        {FILE_LIST, FILES},
        {PLACE, FILES},
        {LATITUDE, FILES},
        {LONGITUDE, FILES},
        {DIRECTIONS, FILES},
        {REPLAY, FILES},
        {AT, FILES},
        {TURN, FILES},
        {EXTEND_TAIL, FILES},
        {WIND_SPEED, FORMULAS | FILES | ONE(WIND_SEA_KIND)},
        {FETCH, GROWING | ONE(SW_SPECTRUM_ELFOUHAILY) | ONE(WIND_SEA_KIND)},
        {DURATION, ONE(WIND_SEA_KIND)},
        {GROWTH, GROWING},
        {GAMMA, GROWING},
        {HEIGHT, FORMULAS | FILES | ONE(SWELL_KIND)},
        {PEAK_PERIOD, FORMULAS | ONE(SWELL_KIND)},
        {DIRECTION, FORMULAS | WIND_SEAS | ONE(SWELL_KIND)},
        {SPREADING, FORMULAS | WIND_SEAS},
        {SPREAD_EXPONENT, FORMULAS | WIND_SEAS},
        {SPREAD, ONE(SWELL_KIND)},
        {TURBULENCE, FORMULAS | WIND_SEAS | ONE(SWELL_KIND)},
        {ELONGATION, FORMULAS | WIND_SEAS | ONE(SWELL_KIND)},
        {OCTAVES, EQUALISERS},
        {OCTAVES_START, EQUALISERS},
        {MULTIPLIER, EQUALISERS},
        {GRAVITY_SCALE, EQUALISERS},
        {LIMIT_BY_WIND, EQUALISERS},
        {MIN_WAVELENGTH, SPECTRA},
        {MAX_WAVELENGTH, SPECTRA},
        {SEED, SPECTRA},
        {COMPONENTS_PER_OCTAVE, SPECTRA},
        {REVERSE_WEIGHT, SPECTRA},
        {DIRECTION_VARIANCE, SPECTRA},
        {LEAST_JACOBIAN, SPECTRA},
    };
    swResult result = SW_SUCCESS;
    for (int i = 0; i < COUNT(rules); ++i)
    {
        const yaml_node_t* node = nodes->nodes[rules[i].field];
        if (node != NULL && (rules[i].kinds & ONE(text->kind)) == 0)
        {
            bool isTurned = rules[i].field == DIRECTION && text->kind == SW_SPECTRUM_TABLE;
            result = swFailYaml(yaml, node, SW_MISTAKE_NO_EFFECT, "%s has no effect on %s'%s'; remove it%s.",
                                wavesFields[rules[i].field].key, text->kind == COMPONENTS_KIND ? "" : "the spectrum ",
                                getKindWord(text->kind), isTurned ? ", or turn the measured sea with turn_deg" : "");
        }
    }
    result = swKeepFailure(result, checkMethodKeys(yaml, text, nodes));
    if (nodes->nodes[GROWTH] != NULL && text->def.spectrum.peakPeriod > 0.0f && (GROWING & ONE(text->kind)) != 0)
    {
        result = swFailYaml(yaml, nodes->nodes[GROWTH], SW_MISTAKE_NO_EFFECT,
                            "growth has no effect where peak_period_s is given; remove one of them.");
    }
    // Wind seas by one knob have a spreading of their own.
    bool isCosine = nodes->nodes[SPREADING] != NULL ? text->spreading == SW_SPREADING_COSINE_2S
                                                    : (WIND_SEAS & ONE(text->kind)) == 0;
    bool hasSpreading = ((FORMULAS | WIND_SEAS) & ONE(text->kind)) != 0 && !nodes->isWrong[SPREADING];
    if (nodes->nodes[SPREAD_EXPONENT] != NULL && hasSpreading && !isCosine)
    {
        result = swFailYaml(yaml, nodes->nodes[SPREAD_EXPONENT], SW_MISTAKE_NO_EFFECT,
                            "spread_exponent has an effect with spreading: cosine only; remove it, or say so.");
    }
    return result;
}

// What the one-knob functions make of these keys.
static swSpectrumDef makeKnobSpectrum(const WavesText* text, const swYamlNodes* nodes)
{
    const swSpectrumDef* given = &text->def.spectrum;
    switch (text->kind)
    {
    case BEAUFORT_KIND:
        return swMakeBeaufortSpectrum(text->beaufort, given->direction);
    case SEA_STATE_KIND:
        return swMakeSeaStateSpectrum(text->seaState, given->direction);
    case SWELL_KIND:
        return swMakeSwellSpectrum(given->significantHeight, given->peakPeriod, given->direction, text->spread);
    default:
        return swMakeWindSeaSpectrum(given->windSpeed, nodes->nodes[FETCH] != NULL ? given->fetch : INFINITY,
                                     nodes->nodes[DURATION] != NULL ? 3600.0f * text->durationHours : INFINITY,
                                     given->direction);
    }
}

static swResult checkSwell(swYaml* yaml, yaml_node_t* node, const WavesText* text, const swYamlNodes* nodes)
{
    if (text->kind == SWELL_KIND && (nodes->nodes[HEIGHT] == NULL || nodes->nodes[PEAK_PERIOD] == NULL))
    {
        return swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "a swell needs significant_height_m and peak_period_s.");
    }
    return SW_SUCCESS;
}

static swResult buildSpectrum(swYaml* yaml, yaml_node_t* node, WavesText* text, const swYamlNodes* nodes)
{
    swSpectrumDef* spectrum = &text->def.spectrum;
    if (text->kind < SW_SPECTRUM_KIND_COUNT)
    {
        spectrum->kind = (swSpectrumKind)text->kind;
        spectrum->spreading = (swSpreadingKind)text->spreading;
        spectrum->growth = (swGrowthLaw)text->growth;
        spectrum->hasWind = nodes->nodes[WIND_SPEED] != NULL;
    }
    else if (text->kind != COMPONENTS_KIND)
    {
        swSpectrumDef made = makeKnobSpectrum(text, nodes);
        made.spreading = nodes->nodes[SPREADING] != NULL ? (swSpreadingKind)text->spreading : made.spreading;
        made.spreadExponent = nodes->nodes[SPREAD_EXPONENT] != NULL ? spectrum->spreadExponent : made.spreadExponent;
        made.turbulence = spectrum->turbulence;
        made.swell = spectrum->swell;
        made.depth = spectrum->depth;
        *spectrum = made;
    }
    if (text->kind == SW_SPECTRUM_OCTAVES)
    {
        text->octaves.hasLimit = nodes->nodes[LIMIT_BY_WIND] != NULL;
        swBuildOctaves(&text->octaves, spectrum);
        swSeaState seaState;
        if (swSpectrum_GetSeaState(spectrum, 0.0f, 0.0f, &seaState) != SW_SUCCESS)
        {
            return swFailYaml(yaml, nodes->nodes[OCTAVES] != NULL ? nodes->nodes[OCTAVES] : node, SW_MISTAKE_NO_ENERGY,
                              "the octaves have no energy; enable one, or raise its power.");
        }
    }
    return SW_SUCCESS;
}

static bool isPowerOfTwo(int value)
{
    return value > 0 && (value & (value - 1)) == 0;
}

static swResult checkSystem(swYaml* yaml, yaml_node_t* node, const swWaveSystemDef* def, const swYamlNodes* nodes)
{
    swResult result = SW_SUCCESS;
    if (!isPowerOfTwo(def->resolution))
    {
        result = swFailYaml(yaml, nodes->nodes[RESOLUTION], SW_MISTAKE_OUT_OF_RANGE,
                            "resolution is %d; it must be a power of two.", def->resolution);
    }
    else if (def->tileWaves > def->resolution / 4 && !nodes->isWrong[RESOLUTION] && !nodes->isWrong[TILE_WAVES])
    {
        result =
            swFailYaml(yaml, nodes->nodes[TILE_WAVES] != NULL ? nodes->nodes[TILE_WAVES] : node,
                       SW_MISTAKE_OUT_OF_RANGE, "tile_waves is %d; it must be at most a quarter of the resolution, %d.",
                       def->tileWaves, def->resolution / 4);
    }
    if (def->minWavelength >= def->maxWavelength && !nodes->isWrong[MIN_WAVELENGTH] && !nodes->isWrong[MAX_WAVELENGTH])
    {
        result = swFailYaml(yaml, nodes->nodes[MIN_WAVELENGTH] != NULL ? nodes->nodes[MIN_WAVELENGTH] : node,
                            SW_MISTAKE_CONFLICT,
                            "min_wavelength_m is %g and max_wavelength_m is %g; the first must be smaller.",
                            (double)def->minWavelength, (double)def->maxWavelength);
    }
    return result;
}

static swResult readMeasured(swYaml* yaml, yaml_node_t* node, WavesText* text, const swYamlNodes* nodes)
{
    static const int needed[] = {FILE_NAME, FILE_LIST, PLACE, AT, REPLAY, METHOD};
    for (int i = 0; i < COUNT(needed); ++i)
    {
        if (nodes->isWrong[needed[i]])
        {
            return SW_ERROR_FORMAT; // has been told
        }
    }
    swMeasuredText* measured = &text->measured;
    measured->system = node;
    measured->fileNode = nodes->nodes[FILE_NAME];
    measured->listNode = nodes->nodes[FILE_LIST];
    measured->locationNode = nodes->nodes[PLACE];
    measured->latitudeNode = nodes->nodes[LATITUDE];
    measured->longitudeNode = nodes->nodes[LONGITUDE];
    measured->directionsNode = nodes->nodes[DIRECTIONS];
    measured->atNode = nodes->nodes[AT];
    measured->replayNode = nodes->nodes[REPLAY];
    measured->methodNode = nodes->nodes[METHOD];
    measured->folder = ((Reader*)yaml->context)->folder;
    return swReadSceneMeasured(yaml, measured, text->waves);
}

static swResult readSystem(swYaml* yaml, yaml_node_t* node, swSceneWaves* waves)
{
    WavesText text;
    memset(&text, 0, sizeof(text));
    text.waves = waves;
    text.def = swDefaultWaveSystemDef();
    text.spread = 0.157f; // 9 degrees
    text.octaves.multiplier = 1.0f;
    text.octaves.gravityScale = 1.0f;
    swYamlNodes nodes;
    swResult result = swReadYamlMapping(yaml, node, "waves", wavesFields, SW_YAML_COUNT(wavesFields), &text, &nodes);
    if (swIsYamlOver(yaml, result) || node->type != YAML_MAPPING_NODE)
    {
        return result;
    }
    swResult kind = chooseKind(yaml, node, &text, &nodes);
    result = swKeepFailure(result, kind);
    result = swKeepFailure(result, checkSystem(yaml, node, &text.def, &nodes));
    if (kind == SW_SUCCESS)
    {
        result = swKeepFailure(result, checkKeys(yaml, &text, &nodes));
        result = swKeepFailure(result, checkSwell(yaml, node, &text, &nodes));
    }
    result = result == SW_SUCCESS ? buildSpectrum(yaml, node, &text, &nodes) : result;
    waves->def = text.def;
    waves->def.components = waves->components;
    waves->def.componentCount = waves->componentCount;
    bool isFile = kind == SW_SUCCESS && text.kind == SW_SPECTRUM_TABLE;
    waves->def.spectrum.kind = isFile ? SW_SPECTRUM_TABLE : waves->def.spectrum.kind;
    return isFile ? swKeepFailure(result, readMeasured(yaml, node, &text, &nodes)) : result;
}

static swResult readWaves(swYaml* yaml, yaml_node_t* node, void* target)
{
    swScene* scene = target;
    int count = 0;
    swResult result = swReadYamlList(yaml, node, "waves", SW_MAX_WAVE_SYSTEMS, &count);
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        // Counted first, so that what a failed one has read is freed.
        scene->wavesCount = i + 1;
        result = swKeepFailure(result, readSystem(yaml, swGetYamlItem(yaml, node, i), &scene->waves[i]));
    }
    return result;
}

// ---- views ----

enum
{
    VIEW_NAME,
    VIEW_POSITION,
    VIEW_HEADING,
    VIEW_PITCH,
    VIEW_ROLL,
    VIEW_FOV,
    VIEW_SUN_AZIMUTH,
    VIEW_SUN_ELEVATION,
    VIEW_FIELD_COUNT
};

static const swYamlField sceneViewFields[VIEW_FIELD_COUNT] = {
    [VIEW_NAME] = {.key = "name", .type = SW_YAML_TEXT, .offset = offsetof(swSceneView, name), .size = 64},
    [VIEW_POSITION] = {.key = "position_m",
                       .type = SW_YAML_POSITION,
                       .offset = offsetof(swSceneView, position),
                       .low = -FAR,
                       .high = FAR},
    [VIEW_HEADING] = {.key = "heading_deg",
                      .type = SW_YAML_DEGREES,
                      .offset = offsetof(swSceneView, heading),
                      .low = -360.0,
                      .high = 360.0},
    [VIEW_PITCH] = {.key = "pitch_deg",
                    .type = SW_YAML_DEGREES,
                    .offset = offsetof(swSceneView, pitch),
                    .low = -90.0,
                    .high = 90.0},
    [VIEW_ROLL] = {.key = "roll_deg",
                   .type = SW_YAML_DEGREES,
                   .offset = offsetof(swSceneView, roll),
                   .low = -180.0,
                   .high = 180.0},
    [VIEW_FOV] = {.key = "fov_deg",
                  .type = SW_YAML_DEGREES,
                  .offset = offsetof(swSceneView, verticalFov),
                  .low = 1.0,
                  .high = 150.0},
    [VIEW_SUN_AZIMUTH] = {.key = "sun_azimuth_deg",
                          .type = SW_YAML_DEGREES,
                          .offset = offsetof(swSceneView, sunAzimuth),
                          .low = -360.0,
                          .high = 360.0},
    [VIEW_SUN_ELEVATION] = {.key = "sun_elevation_deg",
                            .type = SW_YAML_DEGREES,
                            .offset = offsetof(swSceneView, sunElevation),
                            .low = -90.0,
                            .high = 90.0},
};

static swResult checkSceneView(swYaml* yaml, yaml_node_t* node, const swScene* scene, int index,
                               const swYamlNodes* nodes)
{
    const swSceneView* view = &scene->views[index];
    swResult result = SW_SUCCESS;
    if (nodes->nodes[VIEW_NAME] == NULL)
    {
        result = swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "the view has no name; give it one to ask for.");
    }
    for (int i = 0; i < index && view->name[0] != '\0'; ++i)
    {
        if (strcmp(scene->views[i].name, view->name) == 0)
        {
            result = swFailYaml(yaml, nodes->nodes[VIEW_NAME], SW_MISTAKE_REPEATED,
                                "a view named '%s' stands above; names must differ.", view->name);
            break;
        }
    }
    const yaml_node_t* azimuth = nodes->nodes[VIEW_SUN_AZIMUTH];
    const yaml_node_t* elevation = nodes->nodes[VIEW_SUN_ELEVATION];
    if ((azimuth == NULL) != (elevation == NULL))
    {
        result = swFailYaml(yaml, azimuth != NULL ? azimuth : elevation, SW_MISTAKE_MISSING_KEY,
                            "a view's own sun needs both sun_azimuth_deg and sun_elevation_deg.");
    }
    return result;
}

static swResult readSceneView(swYaml* yaml, yaml_node_t* node, swScene* scene, int index)
{
    swSceneView* view = &scene->views[index];
    view->position.y = 20.0;
    view->verticalFov = (float)(50.0 * (SW_PI / 180.0));
    swYamlNodes nodes;
    swResult result =
        swReadYamlMapping(yaml, node, "views", sceneViewFields, SW_YAML_COUNT(sceneViewFields), view, &nodes);
    view->hasSun = nodes.nodes[VIEW_SUN_AZIMUTH] != NULL;
    return node->type == YAML_MAPPING_NODE ? swKeepFailure(result, checkSceneView(yaml, node, scene, index, &nodes))
                                           : result;
}

static swResult readViews(swYaml* yaml, yaml_node_t* node, void* target)
{
    swScene* scene = target;
    swResult result = swReadYamlList(yaml, node, "views", SW_MAX_SCENE_VIEWS, &scene->viewCount);
    for (int i = 0; i < scene->viewCount && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(result, readSceneView(yaml, swGetYamlItem(yaml, node, i), scene, i));
    }
    return result;
}

// ---- the file ----

static const swYamlField sceneFields[] = {
    {.key = "name", .type = SW_YAML_TEXT, .offset = offsetof(swScene, name), .size = 128},
    {.key = "time_s",
     .type = SW_YAML_DOUBLE,
     .offset = offsetof(swScene, time),
     .low = -SW_LARGEST_TIME,
     .high = SW_LARGEST_TIME},
    {.key = "exposure_ev", .type = SW_YAML_FLOAT, .offset = offsetof(swScene, exposureEv), .low = -20.0, .high = 20.0},
    {.key = "world", .type = SW_YAML_CUSTOM, .read = readWorld},
    {.key = "foam", .type = SW_YAML_CUSTOM, .read = readFoam},
    {.key = "view", .type = SW_YAML_CUSTOM, .read = readView},
    {.key = "sun", .type = SW_YAML_CUSTOM, .read = readSun},
    {.key = "sky", .type = SW_YAML_CUSTOM, .read = readSky},
    {.key = "water", .type = SW_YAML_CUSTOM, .read = readWater},
    {.key = "waves", .type = SW_YAML_CUSTOM, .read = readWaves},
    {.key = "views", .type = SW_YAML_CUSTOM, .read = readViews},
};

static swResult readRoot(const swHost* host, const char* text, size_t size, const char* name, Reader* reader)
{
    swYaml yaml;
    yaml_node_t* root = NULL;
    swResult result = swOpenYaml(host, text, size, name, &yaml, &root);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    yaml.context = reader;
    if (root == NULL)
    {
        result = swFail(host, SW_ERROR_FORMAT,
                        "%s:1: the scene file is empty; it needs at least a list of waves. [missing_key]", name);
    }
    else
    {
        result =
            swReadYamlMapping(&yaml, root, "a scene", sceneFields, SW_YAML_COUNT(sceneFields), getScene(&yaml), NULL);
    }
    if (result == SW_SUCCESS)
    {
        swChooseReplayRecords(reader->scene);
    }
    swCloseYaml(&yaml);
    return result;
}

swResult swReadSceneText(const swHost* host, const char* text, size_t size, const char* name, const char* folder,
                         swScene** scene)
{
    SW_REQUIRE_PLACE(host, scene, "swReadSceneText()");
    SW_REQUIRE(text != NULL || size == 0, SW_ERROR_INVALID, host, "swReadSceneText() needs the text of a scene");
    text = text != NULL ? text : "";
    name = name != NULL ? name : "scene";
    if (size > MAX_SCENE_SIZE)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:1: the scene file has %zu bytes; at most %zu are read. [too_large]",
                      name, size, MAX_SCENE_SIZE);
    }
    swScene* made = swAllocateZero(host, sizeof(*made));
    if (made == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for the scene %s.", name);
    }
    made->host = *host;
    made->world = swDefaultWorldDef();
    made->view = swDefaultViewDef();
    made->sky = swDefaultSkyDef();
    made->water = swDefaultWaterDef();
    Reader reader = {made, folder};
    swResult result = readRoot(host, text, size, name, &reader);
    if (result != SW_SUCCESS)
    {
        swDestroyScene(made);
        return result;
    }
    *scene = made;
    return SW_SUCCESS;
}

swResult swReadScene(const swHost* host, const char* path, swScene** scene)
{
    SW_REQUIRE_PLACE(host, scene, "swReadScene()");
    SW_REQUIRE(path != NULL, SW_ERROR_INVALID, host, "swReadScene() needs a path");
    char folder[SW_MAX_PATH] = "";
    const char* slash = strrchr(path, '/');
    if (strlen(path) >= sizeof(folder))
    {
        return swFail(host, SW_ERROR_FILE, "The path of a scene has %zu bytes; at most %zu are read.", strlen(path),
                      sizeof(folder) - 1);
    }
    if (slash != NULL)
    {
        // The root folder keeps its slash.
        snprintf(folder, sizeof(folder), "%.*s", slash > path ? (int)(slash - path) : 1, path);
    }
    swFileText text;
    swResult result = swReadText(host, path, MAX_SCENE_SIZE, &text);
    if (result == SW_SUCCESS)
    {
        result = swReadSceneText(host, text.data != NULL ? text.data : "", text.size, path, folder, scene);
        swFreeText(host, &text);
    }
    return result;
}

void swDestroyScene(swScene* scene)
{
    if (scene != NULL)
    {
        swHost host = scene->host;
        for (int i = 0; i < scene->wavesCount; ++i)
        {
            swDestroyMeasuredSea(scene->waves[i].measured);
            swFreeComponents(&host, &scene->waves[i]);
        }
        swFree(&host, scene, sizeof(*scene));
    }
}
