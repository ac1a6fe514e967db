// SPDX-License-Identifier: MIT
// A wave system in a scene file: which kind it is of, which keys go with that, and the def that they make.

#include "scene/scene_waves.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/field.h"
#include "scene/scene_components.h"
#include "scene/scene_measured.h"
#include "scene/scene_octaves.h"
#include "seaway/math.h"

#define COUNT(rows) ((int)(sizeof(rows) / sizeof((rows)[0])))

typedef struct WavesReader
{
    swWavesText text; // first: fields are read into it
    swSceneWaves* waves;
    yaml_node_t* fromNode;
    swYamlMapping mapping;
} WavesReader;

#define SYSTEM offsetof(swWavesText, def)
#define OCTAVES (offsetof(swWavesText, octaves) + offsetof(swOctavesText, given))

// ---- keys ----

static swResult readKind(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    swWavesText* text = target;
    const char* value = node->type == YAML_SCALAR_NODE ? (const char*)node->data.scalar.value : "";
    char known[700] = "";
    for (int i = 0; i < SW_WAVES_BEAUFORT; ++i)
    {
        if (strcmp(value, swGetWavesWord(i)) == 0 && node->data.scalar.length == strlen(value))
        {
            text->kind = i;
            return SW_SUCCESS;
        }
        size_t used = strlen(known);
        snprintf(known + used, sizeof(known) - used, "%s%s", used > 0 ? ", " : "", swGetWavesWord(i));
    }
    return swFailYaml(yaml, node, SW_MISTAKE_UNKNOWN_WORD, "%s is '%.60s'; it must be one of: %s.", key->key, value,
                      known);
}

static swResult readOctavesKey(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    (void)key;
    return swReadOctaves(yaml, node, &((WavesReader*)target)->text.octaves);
}

static swResult readComponentsKey(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    (void)key;
    return swReadComponents(yaml, node, ((WavesReader*)target)->waves);
}

static swResult readReplayKey(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    WavesReader* reader = target;
    (void)key;
    return swReadReplay(yaml, node, &reader->text.measured, &reader->fromNode);
}

// Read later, when the other keys are known.
static swResult keepNode(swYaml* yaml, yaml_node_t* node, const swYamlKey* key, void* target)
{
    (void)yaml;
    (void)node;
    (void)key;
    (void)target;
    return SW_SUCCESS;
}

static void addKeys(swYamlMapping* mapping)
{
    swBeginYamlMapping(mapping, "waves");
    swAddYamlKey(mapping, "spectrum", readKind);
    swAddYamlFields(mapping, swGetWavesTextFields(), 0, "waves");
    swAddYamlKey(mapping, "components", readComponentsKey);
    swAddYamlFields(mapping, swGetMeasuredTextFields(), offsetof(swWavesText, measured), "waves");
    swAddYamlKey(mapping, "files", keepNode);
    swAddYamlKey(mapping, "replay", readReplayKey);
    swAddYamlKey(mapping, "octaves", readOctavesKey);
    swAddYamlFields(mapping, swGetOctavesFields(), OCTAVES, "waves");
    swAddYamlFields(mapping, swGetWaveSystemFields(), SYSTEM, "waves");
}

static yaml_node_t* getNode(const WavesReader* reader, const char* key)
{
    return swGetYamlNode(&reader->mapping, key);
}

static bool isWrong(const WavesReader* reader, const char* key)
{
    return swIsYamlWrong(&reader->mapping, key);
}

// ---- what goes with what ----

// Sets of kinds.
#define ONE(kind) (1u << (kind))
#define FILES ONE(SW_SPECTRUM_TABLE)
#define FORMULAS (FILES - 1u) // all before it
#define NUMBERS (ONE(SW_WAVES_BEAUFORT) | ONE(SW_WAVES_SEA_STATE))
#define WIND_SEAS (ONE(SW_WAVES_WIND_SEA) | NUMBERS)
#define SWELLS ONE(SW_WAVES_SWELL)
#define EQUALISERS ONE(SW_SPECTRUM_OCTAVES)
#define BY_HAND ONE(SW_WAVES_COMPONENTS)
#define SPECTRA (~BY_HAND)

typedef struct Rule
{
    const char* key;
    unsigned kinds;
} Rule;

// Keys that are no fields of a spectrum, and go with some kinds only.
static const Rule rules[] = {
    {"file", FILES},
    {"files", FILES},
    {"location", FILES},
    {"latitude", FILES},
    {"longitude", FILES},
    {"directions", FILES},
    {"replay", FILES},
    {"at", FILES},
    {"turn_deg", FILES},
    {"direction_from_deg", FORMULAS | WIND_SEAS | SWELLS},
    {"duration_h", ONE(SW_WAVES_WIND_SEA)},
    {"spread_deg", SWELLS},
    {"octaves", EQUALISERS},
    {"octaves_from", EQUALISERS},
    {"min_wavelength_m", SPECTRA},
    {"max_wavelength_m", SPECTRA},
    {"seed", SPECTRA},
    {"takes_wind", FORMULAS},
    {"components_per_octave", SPECTRA},
    {"reverse_weight", SPECTRA},
    {"direction_variance_deg", SPECTRA},
    {"least_jacobian", SPECTRA},
};

// Fields of a spectrum that one knob decides, and with which knobs they can be given all the same. Every other field
// that a JONSWAP spectrum has goes with all knobs.
static const Rule knobRules[] = {
    {"wind_speed_mps", ONE(SW_WAVES_WIND_SEA)},
    {"wind_is_known", 0},
    {"fetch_m", ONE(SW_WAVES_WIND_SEA)},
    {"growth", 0},
    {"gamma", 0},
    {"significant_height_m", SWELLS},
    {"peak_period_s", SWELLS},
    {"spreading", WIND_SEAS},
    {"spread_exponent", WIND_SEAS},
    {"depth_m", WIND_SEAS | SWELLS | BY_HAND},
};

static const Rule* findRule(const Rule* list, int count, const char* key)
{
    for (int i = 0; i < count; ++i)
    {
        if (strcmp(list[i].key, key) == 0)
        {
            return &list[i];
        }
    }
    return NULL;
}

static unsigned findKinds(const swYamlKey* key)
{
    const swField* field = key->field;
    const Rule* rule = findRule(rules, COUNT(rules), key->key);
    if (rule != NULL || field == NULL)
    {
        return rule != NULL ? rule->kinds : ~0u;
    }
    if (key->fields == swGetSpectrumFields())
    {
        const Rule* knobs = findRule(knobRules, COUNT(knobRules), key->key);
        unsigned kinds = field->kinds != 0 ? field->kinds : FORMULAS | FILES;
        bool isOfKnobs = (kinds & ONE(SW_SPECTRUM_JONSWAP)) != 0;
        return kinds | (knobs != NULL ? knobs->kinds : isOfKnobs ? WIND_SEAS | SWELLS : 0);
    }
    return key->fields == swGetOctavesFields() ? EQUALISERS : ~0u;
}

bool swGoesWithWaves(const char* key, int kind)
{
    swYamlMapping mapping;
    addKeys(&mapping);
    const swYamlKey* found = swFindYamlKey(&mapping, key);
    return found != NULL && (findKinds(found) & ONE(kind)) != 0;
}

// `spectrum`, `beaufort`, `sea_state` or `components`: one of them, which is the kind.
static swResult chooseKind(swYaml* yaml, yaml_node_t* node, WavesReader* reader)
{
    static const char* const keys[] = {"spectrum", "beaufort", "sea_state", "components"};
    const yaml_node_t* second = NULL;
    int count = 0;
    for (int i = 0; i < COUNT(keys); ++i)
    {
        const yaml_node_t* given = getNode(reader, keys[i]);
        bool isLater = given != NULL && (second == NULL || given->start_mark.index > second->start_mark.index);
        second = isLater ? given : second;
        count += given != NULL;
    }
    if (isWrong(reader, "spectrum"))
    {
        return SW_ERROR_FORMAT; // has been told
    }
    if (count == 0)
    {
        char known[400] = "";
        for (int i = 0; i < SW_WAVES_BEAUFORT; ++i)
        {
            size_t used = strlen(known);
            snprintf(known + used, sizeof(known) - used, "%s%s",
                     i == 0                      ? ""
                     : i + 1 < SW_WAVES_BEAUFORT ? ", "
                                                 : " or ",
                     swGetWavesWord(i));
        }
        return swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                          "the key spectrum is missing; it is %s. Or give a number of beaufort or sea_state, or a list "
                          "of components.",
                          known);
    }
    if (count > 1)
    {
        return swFailYaml(yaml, second, SW_MISTAKE_CONFLICT,
                          "spectrum, beaufort, sea_state and components each make the waves; keep one of them.");
    }
    for (int i = 1; i < COUNT(keys); ++i)
    {
        reader->text.kind = getNode(reader, keys[i]) != NULL ? SW_WAVES_BEAUFORT + i - 1 : reader->text.kind;
    }
    return SW_SUCCESS;
}

// Keys that only the other method knows. Waves given by hand have a method of their own.
static swResult checkMethodKeys(swYaml* yaml, WavesReader* reader)
{
    swWavesText* text = &reader->text;
    const swField* method = swFields_Find(swGetWaveSystemFields(), "method");
    const yaml_node_t* node = getNode(reader, "method");
    if (text->kind == SW_WAVES_COMPONENTS && node != NULL && text->def.method != SW_WAVES_GERSTNER)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_CONFLICT,
                          "components are made with 'method: gerstner' only; remove this.");
    }
    text->def.method = text->kind == SW_WAVES_COMPONENTS ? SW_WAVES_GERSTNER : text->def.method;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < reader->mapping.count && !isWrong(reader, "method"); ++i)
    {
        const swYamlKey* key = &reader->mapping.keys[i];
        bool isOurs = key->node != NULL && key->fields == swGetWaveSystemFields() && key->field->kinds != 0;
        if (isOurs && (key->field->kinds & ONE(text->def.method)) == 0 && (findKinds(key) & ONE(text->kind)) != 0)
        {
            int other = (key->field->kinds & ONE(SW_WAVES_FFT)) != 0 ? SW_WAVES_FFT : SW_WAVES_GERSTNER;
            result = swFailYaml(yaml, key->node, SW_MISTAKE_NO_EFFECT, "%s has an effect with 'method: %s' only; %s.",
                                key->key, method->words[other],
                                other == SW_WAVES_GERSTNER ? "add that or remove it" : "remove it");
        }
    }
    return result;
}

// Keys that do not go with a kind of spectrum would have no effect: refused, so that nobody turns a dead knob.
static swResult checkKeys(swYaml* yaml, WavesReader* reader)
{
    const swWavesText* text = &reader->text;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < reader->mapping.count; ++i)
    {
        const swYamlKey* key = &reader->mapping.keys[i];
        if (key->node != NULL && (findKinds(key) & ONE(text->kind)) == 0)
        {
            bool isTurned = strcmp(key->key, "direction_from_deg") == 0 && text->kind == SW_SPECTRUM_TABLE;
            result = swFailYaml(yaml, key->node, SW_MISTAKE_NO_EFFECT, "%s has no effect on %s'%s'; remove it%s.",
                                key->key, text->kind == SW_WAVES_COMPONENTS ? "" : "the spectrum ",
                                swGetWavesWord(text->kind), isTurned ? ", or turn the measured sea with turn_deg" : "");
        }
    }
    result = swKeepFailure(result, checkMethodKeys(yaml, reader));
    const swYamlKey* growth = swFindYamlKey(&reader->mapping, "growth");
    if (growth->node != NULL && text->def.spectrum.peakPeriod > 0.0f && (findKinds(growth) & ONE(text->kind)) != 0)
    {
        result = swFailYaml(yaml, getNode(reader, "growth"), SW_MISTAKE_NO_EFFECT,
                            "growth has no effect where peak_period_s is given; remove one of them.");
    }
    // Wind seas by one knob have a spreading of their own.
    bool isCosine = getNode(reader, "spreading") != NULL ? text->def.spectrum.spreading == SW_SPREADING_COSINE_2S
                                                         : (WIND_SEAS & ONE(text->kind)) == 0;
    bool hasSpreading = ((FORMULAS | WIND_SEAS) & ONE(text->kind)) != 0 && !isWrong(reader, "spreading");
    if (getNode(reader, "spread_exponent") != NULL && hasSpreading && !isCosine)
    {
        result = swFailYaml(yaml, getNode(reader, "spread_exponent"), SW_MISTAKE_NO_EFFECT,
                            "spread_exponent has an effect with spreading: cosine only; remove it, or say so.");
    }
    return result;
}

// ---- the def ----

// What the one-knob functions make of these keys.
static swSpectrumDef makeKnobSpectrum(const WavesReader* reader)
{
    const swWavesText* text = &reader->text;
    const swSpectrumDef* given = &text->def.spectrum;
    switch (text->kind)
    {
    case SW_WAVES_BEAUFORT:
        return swMakeBeaufortSpectrum(text->beaufort, given->direction);
    case SW_WAVES_SEA_STATE:
        return swMakeSeaStateSpectrum(text->seaState, given->direction);
    case SW_WAVES_SWELL:
        return swMakeSwellSpectrum(given->significantHeight, given->peakPeriod, given->direction, text->spread);
    default:
        return swMakeWindSeaSpectrum(given->windSpeed, getNode(reader, "fetch_m") != NULL ? given->fetch : INFINITY,
                                     getNode(reader, "duration_h") != NULL ? 3600.0f * text->durationHours : INFINITY,
                                     given->direction);
    }
}

// Fields that the file gives and that no knob decides.
static void keepGiven(const WavesReader* reader, swSpectrumDef* made)
{
    const swFields* fields = swGetSpectrumFields();
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        const Rule* knobs = field->key != NULL ? findRule(knobRules, COUNT(knobRules), field->key) : NULL;
        bool isDecided = knobs != NULL && (knobs->kinds & NUMBERS) == 0;
        if (field->type < SW_FIELD_DEF && i != fields->kind && field->key != NULL && !isDecided &&
            getNode(reader, field->key) != NULL)
        {
            memcpy((char*)made + field->offset, (const char*)&reader->text.def.spectrum + field->offset, field->size);
        }
    }
}

static swResult checkSwell(swYaml* yaml, yaml_node_t* node, const WavesReader* reader)
{
    if (reader->text.kind == SW_WAVES_SWELL &&
        (getNode(reader, "significant_height_m") == NULL || getNode(reader, "peak_period_s") == NULL))
    {
        return swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "a swell needs significant_height_m and peak_period_s.");
    }
    return SW_SUCCESS;
}

static swResult buildSpectrum(swYaml* yaml, yaml_node_t* node, WavesReader* reader)
{
    swWavesText* text = &reader->text;
    swSpectrumDef* spectrum = &text->def.spectrum;
    if (text->kind < SW_SPECTRUM_KIND_COUNT)
    {
        spectrum->kind = (swSpectrumKind)text->kind;
        spectrum->hasWind =
            getNode(reader, "wind_is_known") != NULL ? spectrum->hasWind : getNode(reader, "wind_speed_mps") != NULL;
    }
    else if (text->kind != SW_WAVES_COMPONENTS)
    {
        swSpectrumDef made = makeKnobSpectrum(reader);
        keepGiven(reader, &made);
        *spectrum = made;
    }
    if (text->kind == SW_SPECTRUM_OCTAVES)
    {
        swBuildOctaves(&text->octaves, &reader->mapping, spectrum);
        swSeaState seaState;
        if (swSpectrum_GetSeaState(spectrum, 0.0f, 0.0f, &seaState) != SW_SUCCESS)
        {
            const yaml_node_t* octaves = getNode(reader, "octaves");
            return swFailYaml(yaml, octaves != NULL ? octaves : node, SW_MISTAKE_NO_ENERGY,
                              "the octaves have no energy; enable one, or raise its power.");
        }
    }
    return SW_SUCCESS;
}

static bool isPowerOfTwo(int value)
{
    return value > 0 && (value & (value - 1)) == 0;
}

static swResult checkSystem(swYaml* yaml, yaml_node_t* node, const WavesReader* reader)
{
    const swWaveSystemDef* def = &reader->text.def;
    const yaml_node_t *tiles = getNode(reader, "tile_waves"), *least = getNode(reader, "min_wavelength_m");
    swResult result = SW_SUCCESS;
    if (!isPowerOfTwo(def->resolution))
    {
        result = swFailYaml(yaml, getNode(reader, "resolution"), SW_MISTAKE_OUT_OF_RANGE,
                            "resolution is %d; it must be a power of two.", def->resolution);
    }
    else if (def->tileWaves > def->resolution / 4 && !isWrong(reader, "resolution") && !isWrong(reader, "tile_waves"))
    {
        result = swFailYaml(yaml, tiles != NULL ? tiles : node, SW_MISTAKE_OUT_OF_RANGE,
                            "tile_waves is %d; it must be at most a quarter of the resolution, %d.", def->tileWaves,
                            def->resolution / 4);
    }
    if (def->minWavelength >= def->maxWavelength && !isWrong(reader, "min_wavelength_m") &&
        !isWrong(reader, "max_wavelength_m"))
    {
        result = swFailYaml(yaml, least != NULL ? least : node, SW_MISTAKE_CONFLICT,
                            "min_wavelength_m is %g and max_wavelength_m is %g; the first must be smaller.",
                            (double)def->minWavelength, (double)def->maxWavelength);
    }
    return result;
}

static swResult readMeasured(swYaml* yaml, yaml_node_t* node, WavesReader* reader, const char* folder, bool opensNone)
{
    static const char* const needed[] = {"file", "files", "location", "at", "replay", "method"};
    for (int i = 0; i < COUNT(needed); ++i)
    {
        if (isWrong(reader, needed[i]))
        {
            return SW_ERROR_FORMAT; // has been told
        }
    }
    swMeasuredKeys keys = {.text = &reader->text.measured,
                           .folder = folder,
                           .opensNone = opensNone,
                           .system = node,
                           .file = getNode(reader, "file"),
                           .list = getNode(reader, "files"),
                           .location = getNode(reader, "location"),
                           .latitude = getNode(reader, "latitude"),
                           .longitude = getNode(reader, "longitude"),
                           .directions = getNode(reader, "directions"),
                           .at = getNode(reader, "at"),
                           .replay = getNode(reader, "replay"),
                           .from = reader->fromNode,
                           .method = getNode(reader, "method")};
    return swReadSceneMeasured(yaml, &keys, reader->waves);
}

// What the file has, for writing it.
static void keepText(const WavesReader* reader, swWavesText* text)
{
    *text = reader->text;
    text->hasFetch = getNode(reader, "fetch_m") != NULL;
    text->hasDuration = getNode(reader, "duration_h") != NULL;
    text->hasWindSpeed = getNode(reader, "wind_speed_mps") != NULL;
    text->hasLocation = getNode(reader, "location") != NULL;
    text->hasPlace = getNode(reader, "latitude") != NULL;
    text->hasDirections = getNode(reader, "directions") != NULL;
    text->hasAt = getNode(reader, "at") != NULL;
    text->hasFrom = reader->fromNode != NULL;
}

static void beginText(WavesReader* reader)
{
    memset(reader, 0, sizeof(*reader));
    swFillDef(swGetWavesTextFields(), &reader->text);
    swFillDef(swGetMeasuredTextFields(), &reader->text.measured);
    swFillDef(swGetOctavesFields(), &reader->text.octaves.given);
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        reader->text.octaves.octaves[i].item = -1;
    }
    reader->text.def = swDefaultWaveSystemDef();
    addKeys(&reader->mapping);
}

swResult swReadSceneWaves(swYaml* yaml, yaml_node_t* node, const char* folder, bool opensNone, swSceneWaves* waves,
                          swWavesText* text)
{
    WavesReader reader;
    beginText(&reader);
    reader.waves = waves;
    swResult result = swReadYamlMapping(yaml, node, &reader.mapping, &reader);
    if (swIsYamlOver(yaml, result) || node->type != YAML_MAPPING_NODE)
    {
        return result;
    }
    swResult kind = chooseKind(yaml, node, &reader);
    result = swKeepFailure(result, kind);
    result = swKeepFailure(result, checkSystem(yaml, node, &reader));
    if (kind == SW_SUCCESS)
    {
        result = swKeepFailure(result, checkKeys(yaml, &reader));
        result = swKeepFailure(result, checkSwell(yaml, node, &reader));
    }
    result = result == SW_SUCCESS ? buildSpectrum(yaml, node, &reader) : result;
    waves->def = reader.text.def;
    waves->def.components = waves->components;
    waves->def.componentCount = waves->componentCount;
    keepText(&reader, text);
    bool isFile = kind == SW_SUCCESS && reader.text.kind == SW_SPECTRUM_TABLE;
    waves->def.spectrum.kind = isFile ? SW_SPECTRUM_TABLE : waves->def.spectrum.kind;
    return isFile ? swKeepFailure(result, readMeasured(yaml, node, &reader, folder, opensNone)) : result;
}
