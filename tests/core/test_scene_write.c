// SPDX-License-Identifier: MIT
// A scene that is written is the text that it was read from, but for what was changed; and it reads back equal.

#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/messages.h"
#include "support/text_file.h"

#include <dirent.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/field.h"
#include "scene/scene_source.h"
#include "scene/scene_waves.h"
#include "seaway/scene.h"

#define SCENES SW_SOURCE_DIR "/scenes"

static swScene* Read(const swHost* host, const char* text)
{
    swScene* scene = NULL;
    if (swReadSceneText(host, text, strlen(text), "a.yaml", SCENES, &scene) != SW_SUCCESS)
    {
        fail_msg("%s\n%s", text, s_messages);
    }
    return scene;
}

// What the scene's file would be; NULL if it is refused.
static char* Print(const swScene* scene)
{
    size_t size = 1 << 18;
    char* text = calloc(size, 1);
    if (swPrintScene(scene, text, &size) != SW_SUCCESS)
    {
        free(text);
        return NULL;
    }
    assert_int_equal(strlen(text), size);
    return text;
}

// ---- equality, by the tables ----

// Of waves by hand that which counts.
static swWaveSystemDef KeepWhatCounts(const swWaveSystemDef* def)
{
    if (def->componentCount == 0)
    {
        return *def;
    }
    swWaveSystemDef kept = swDefaultWaveSystemDef();
    kept.method = def->method;
    kept.components = def->components;
    kept.componentCount = def->componentCount;
    kept.chop = def->chop;
    kept.weight = def->weight;
    kept.loopPeriod = def->loopPeriod;
    kept.spectrum.depth = def->spectrum.depth;
    return kept;
}

static bool AreScenesEqual(const swScene* a, const swScene* b)
{
    bool isEqual =
        swFields_AreEqual(swGetSceneFields(), a, b) && a->wavesCount == b->wavesCount && a->viewCount == b->viewCount;
    for (int i = 0; i < SW_SCENE_PART_COUNT && isEqual; ++i)
    {
        swScenePart part = swGetScenePart(i);
        isEqual = swFields_AreEqual(part.fields, (const char*)a + part.offset, (const char*)b + part.offset);
    }
    for (int i = 0; i < a->wavesCount && isEqual; ++i)
    {
        const swSceneWaves *left = &a->waves[i], *right = &b->waves[i];
        swWaveSystemDef one = KeepWhatCounts(&left->def), other = KeepWhatCounts(&right->def);
        isEqual = swFields_AreEqual(swGetWaveSystemFields(), &one, &other) && left->record == right->record &&
                  left->isReplay == right->isReplay &&
                  (!left->isReplay ||
                   (left->replay.location == right->replay.location && left->replay.speed == right->replay.speed &&
                    left->replay.startTime == right->replay.startTime &&
                    left->replay.startSeconds == right->replay.startSeconds));
    }
    for (int i = 0; i < a->viewCount && isEqual; ++i)
    {
        isEqual = swFields_AreEqual(swGetSceneViewFields(), &a->views[i], &b->views[i]);
    }
    return isEqual;
}

static void TellDifference(const swFields* fields, const void* a, const void* b)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        const char *left = (const char*)a + field->offset, *right = (const char*)b + field->offset;
        if (field->type == SW_FIELD_DEF)
        {
            TellDifference(field->fields, left, right);
        }
        else if (field->type < SW_FIELD_TEXT && memcmp(left, right, field->size) != 0)
        {
            print_message("%s is %.9g, then %.9g\n", field->member, swField_GetNumber(field, a, 0),
                          swField_GetNumber(field, b, 0));
        }
    }
}

// Print, read again, compare. Returns the text.
static char* CheckReadBack(const swHost* host, const swScene* scene)
{
    char* text = Print(scene);
    if (text == NULL)
    {
        swTree tree = swMakeSceneTree(scene, false);
        swTextBuffer wanted = {.host = host};
        swAddTreeInLine(&wanted, &tree, 0, false);
        fail_msg("%s\nfrom\n%s\nto\n%.*s", s_messages, scene->source->text, (int)wanted.chars.count,
                 (const char*)wanted.chars.data);
        return NULL;
    }
    swScene* again = Read(host, text);
    if (!AreScenesEqual(scene, again))
    {
        for (int i = 0; i < SW_SCENE_PART_COUNT; ++i)
        {
            swScenePart part = swGetScenePart(i);
            TellDifference(part.fields, (const char*)scene + part.offset, (const char*)again + part.offset);
        }
        for (int i = 0; i < scene->wavesCount; ++i)
        {
            TellDifference(swGetWaveSystemFields(), &scene->waves[i].def, &again->waves[i].def);
        }
        for (int i = 0; i < scene->viewCount; ++i)
        {
            TellDifference(swGetSceneViewFields(), &scene->views[i], &again->views[i]);
        }
        fail_msg("it does not read back equal:\n%s\nfrom\n%s", text, scene->source->text);
    }
    swDestroyScene(again);
    return text;
}

// ---- nothing changes ----

static const char* const nasty[] = {
    "waves: []",
    "\xEF\xBB\xBF# \xC3\xA9t\xC3\xA9\r\nname: \"Mer d'\xC3\x89t\xC3\xA9\" # \xC3\xA9\r\n\r\nwaves:\r\n  - beaufort: 4 "
    "# breeze\r\n",
    "---\nwaves:\n- {spectrum: swell, significant_height_m: 1.5, peak_period_s: +12,}\n...\n# end\n",
    "%YAML 1.1\n--- # here\nname: >\n  a long\n  name\n\nwaves:\n  -\n    # deep\n    sea_state:   4.50\n    seed: 1e1",
    "\"name\": 'it''s'\nsky: {\n  haze: 2, # thick\n  clouds: .5\n}\nwaves: [ {beaufort: 3} , {beaufort: 2, seed: 2} "
    "]\n",
    "name: a\tb\nwater:\n      absorption_per_m:\n        - 0.1\n        # red\n        - 0.2\n        - "
    "3e-1\nwaves:\n   - components:\n     - {wavelength_m: 90, amplitude_m: .55, direction_from_deg: 240}\n",
};

static void WhatIsNotChangedKeepsItsBytes(void** state)
{
    (void)state;
    swHost host = MakeHost();
    DIR* folder = opendir(SCENES);
    int count = 0;
    assert_non_null(folder);
    for (struct dirent* entry = readdir(folder); entry != NULL; entry = readdir(folder))
    {
        if (strstr(entry->d_name, ".yaml") != NULL)
        {
            char path[512];
            size_t size = 0;
            snprintf(path, sizeof(path), "%s/%s", SCENES, entry->d_name);
            char* text = ReadTextFile(path, &size);
            swScene* scene = NULL;
            assert_int_equal(swReadScene(&host, path, &scene), SW_SUCCESS);
            char* made = CheckReadBack(&host, scene);
            assert_string_equal(made, text);
            swDestroyScene(scene);
            free(made);
            free(text);
            count++;
        }
    }
    closedir(folder);
    assert_true(count >= 8);
    for (size_t i = 0; i < sizeof(nasty) / sizeof(nasty[0]); ++i)
    {
        swScene* scene = Read(&host, nasty[i]);
        char* made = CheckReadBack(&host, scene);
        assert_string_equal(made, nasty[i]);
        swDestroyScene(scene);
        free(made);
    }
}

// ---- one change ----

// How many bytes at the begin and at the end two texts have in common, and whether what lies between is the change.
static void CheckChange(const char* text, const char* made, const char* old, const char* fresh)
{
    const char* at = strstr(text, old);
    assert_non_null(at);
    size_t before = (size_t)(at - text);
    if (strncmp(text, made, before) != 0 || strncmp(made + before, fresh, strlen(fresh)) != 0 ||
        strcmp(made + before + strlen(fresh), at + strlen(old)) != 0)
    {
        fail_msg("more than '%s' has changed:\n%s", old, made);
    }
}

static void ItsSizeCanBeAskedFor(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swScene* scene = Read(&host, "waves: []\n");
    char text[16] = "";
    size_t size = 0;
    assert_int_equal(swPrintScene(scene, NULL, &size), SW_SUCCESS);
    assert_int_equal(size, 10);
    size = 9;
    assert_int_equal(swPrintScene(scene, text, &size), SW_ERROR_LIMIT);
    assert_true(size == 10 && text[0] == '\0');
    assert_int_equal(swPrintScene(scene, text, &size), SW_SUCCESS);
    assert_string_equal(text, "waves: []\n");
    swDestroyScene(scene);
}

static void OneValueChangesItsBytes(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swScene* scene = NULL;
    assert_int_equal(swReadScene(&host, SCENES "/two_swells.yaml", &scene), SW_SUCCESS);
    const char* text = scene->source->text;
    swSceneView* view = &scene->views[0];
    scene->sky.haze = 1.25f;
    char* made = CheckReadBack(&host, scene);
    CheckChange(text, made, "haze: 1\n", "haze: 1.25\n");
    free(made);
    scene->sky.haze = 1.0f;
    scene->sky.sunAzimuth = (float)(SW_PI / 180.0 * 116.5);
    made = CheckReadBack(&host, scene);
    CheckChange(text, made, "115\n", "116.5\n");
    free(made);
    scene->sky.sunAzimuth = (float)(SW_PI / 180.0 * 115.0);
    scene->waves[1].def.minWavelength = 16.0f;
    made = CheckReadBack(&host, scene);
    CheckChange(text, made, "32 # a swell has", "16 # a swell has");
    free(made);
    scene->waves[1].def.minWavelength = 32.0f;
    view->position.x = -1e-3;
    made = CheckReadBack(&host, scene);
    CheckChange(text, made, "[0, 3, 0]", "[-0.001, 3, 0]");
    free(made);
    view->position.x = 0.0;
    scene->waves[2].def.chop = 0.5f; // a new key
    made = CheckReadBack(&host, scene);
    CheckChange(text, made, "    min_wavelength_m: 16\n    seed: 3\n",
                "    min_wavelength_m: 16\n    seed: 3\n    chop: 0.5\n");
    free(made);
    scene->waves[2].def.chop = 1.0f;
    scene->world.gravity = 3.7f; // a new section
    made = CheckReadBack(&host, scene);
    assert_non_null(strstr(made, "\n\nworld:\n  gravity_mps2: 3.7\n"));
    free(made);
    swDestroyScene(scene);
}

// The way in which a file tells of waves stays as long as it can.
static void WavesAreToldAsBefore(void** state)
{
    (void)state;
    swHost host = MakeHost();
    static const char text[] = "waves:\n  - beaufort: 4 # breeze\n    direction_from_deg: 200\n";
    swScene* scene = Read(&host, text);
    swSpectrumDef* spectrum = &scene->waves[0].def.spectrum;
    float direction = spectrum->direction;
    *spectrum = swMakeBeaufortSpectrum(5.5f, direction);
    char* made = CheckReadBack(&host, scene);
    assert_string_equal(made, "waves:\n  - beaufort: 5.5 # breeze\n    direction_from_deg: 200\n");
    free(made);
    spectrum->gamma = 2.0f;
    made = CheckReadBack(&host, scene);
    assert_non_null(strstr(made, "  - spectrum: jonswap # breeze\n    direction_from_deg: 200\n"));
    assert_non_null(strstr(made, "    gamma: 2\n"));
    free(made);
    *spectrum = swMakeSwellSpectrum(2.0f, 12.0f, direction, 0.2f);
    made = CheckReadBack(&host, scene);
    free(made);
    *spectrum = swDefaultSpectrumDef();
    spectrum->kind = SW_SPECTRUM_OCTAVES;
    spectrum->octaves.octaves[3].power = -2.0f;
    made = CheckReadBack(&host, scene);
    assert_non_null(strstr(made, "    octaves:\n      - {wavelength_m: 0.5, power: -2}\n"));
    free(made);
    spectrum->depth = 8.0f;
    free(CheckReadBack(&host, scene));
    swDestroyScene(scene);
    scene = Read(&host, "waves:\n  - spectrum: jonswap\n    depth_m: 8 # shallow\n    seed: 2\n");
    scene->waves[0].def.spectrum.depth = INFINITY;
    made = CheckReadBack(&host, scene);
    assert_string_equal(made, "waves:\n  - spectrum: jonswap\n    seed: 2\n");
    free(made);
    swDestroyScene(scene);
}

static void WhatComesAndGoesIsWritten(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swScene* scene = NULL;
    assert_int_equal(swReadScene(&host, SCENES "/crossing.yaml", &scene), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum = swMakeBeaufortSpectrum(4.0f, SW_DIRECTION_FROM_BEARING(250.0));
    def.seed = 7;
    assert_int_equal(swScene_AddWaves(scene, &def), SW_SUCCESS);
    swWaveComponent rows[6];
    memcpy(rows, scene->waves[0].components, 5 * sizeof(rows[0]));
    rows[5] = (swWaveComponent){.wavelength = 30.0f, .amplitude = 0.25f, .direction = 1.0f};
    rows[1] = rows[5]; // one changes, one comes
    swWaveSystemDef hand = scene->waves[0].def;
    hand.components = rows;
    hand.componentCount = 6;
    assert_int_equal(swScene_SetWaves(scene, 0, &hand), SW_SUCCESS);
    swSceneView view = swDefaultSceneView();
    snprintf(view.name, sizeof(view.name), "from above: all");
    view.hasSun = true;
    view.sunElevation = 0.25f;
    assert_int_equal(swScene_AddView(scene, &view), SW_SUCCESS);
    assert_int_equal(swScene_AddView(scene, &view), SW_ERROR_INVALID);
    char* made = CheckReadBack(&host, scene);
    assert_non_null(
        strstr(made, "    direction_from_deg: 225\n  - beaufort: 4\n    direction_from_deg: 250\n    seed: 7\n"));
    assert_non_null(strstr(made, "    fov_deg: 55\n  - name: \"from above: all\"\n    sun_azimuth_deg: 0\n"));
    free(made);

    // All again, down to nothing.
    while (scene->wavesCount > 0)
    {
        swScene_RemoveWaves(scene, 0);
        free(CheckReadBack(&host, scene));
    }
    while (scene->viewCount > 0)
    {
        swScene_RemoveView(scene, scene->viewCount - 1);
        free(CheckReadBack(&host, scene));
    }
    swDestroyScene(scene);

    // From nothing.
    assert_int_equal(swCreateScene(&host, &scene), SW_SUCCESS);
    assert_int_equal(swScene_AddWaves(scene, &def), SW_SUCCESS);
    assert_int_equal(swScene_AddWaves(scene, &hand), SW_SUCCESS);
    assert_int_equal(swScene_AddView(scene, &view), SW_SUCCESS);
    snprintf(scene->name, sizeof(scene->name), "New");
    scene->sky.clouds = 0.5f;
    free(CheckReadBack(&host, scene));
    swDestroyScene(scene);
}

static void MeasuredSeasStayWhatTheyAre(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swScene* scene = NULL;
    assert_int_equal(swReadScene(&host, SCENES "/buoy.yaml", &scene), SW_SUCCESS);
    scene->waves[0].record = 1;
    scene->waves[0].def.spectrum.direction = (float)(SW_PI / 6.0);
    scene->waves[0].def.weight = 0.5f;
    char* made = CheckReadBack(&host, scene);
    assert_non_null(strstr(made, "    at: 2024-11-16 05:50\n    turn_deg: 30\n    weight: 0.5\n"));
    free(made);
    swDestroyScene(scene);

    assert_int_equal(swReadScene(&host, SCENES "/hindcast.yaml", &scene), SW_SUCCESS);
    swSeaReplayDef* replay = &scene->waves[0].replay;
    replay->speed = 100.0;
    replay->startTime = 12.5;
    made = CheckReadBack(&host, scene);
    assert_non_null(strstr(made, "      speed: 100\n      time_s: 12.5\n"));
    assert_non_null(strstr(made, "2024-03-09 00:00 # is the sea"));
    free(made);
    replay->startSeconds += 3600.0 + 12.25;
    made = CheckReadBack(&host, scene);
    assert_non_null(strstr(made, "from: 2024-03-09T01:00:12.25"));
    free(made);
    swDestroyScene(scene);
}

// ---- every field ----

static uint64_t s_random = 88172645463325252u;

static double Random(void)
{
    s_random ^= s_random << 13;
    s_random ^= s_random >> 7;
    s_random ^= s_random << 17;
    return (double)(s_random >> 11) / 9007199254740992.0;
}

// A number of the field's range: an end of it, one as a hand would turn it, or any.
static double ChooseNumber(const swField* field)
{
    double low = 0.0, high = 0.0;
    swField_GetShownRange(field, &low, &high); // a turn more would come back as none
    low = swField_Read(field, fmax(low, -1e6));
    high = swField_Read(field, fmin(high, 1e6));
    double value = low + (high - low) * Random(), kind = Random();
    value = kind < 0.1 ? low : kind < 0.2 ? high : kind < 0.5 ? round(value * 10.0) / 10.0 : value;
    if (field->type == SW_FIELD_INT || field->type == SW_FIELD_UINT || field->type == SW_FIELD_CHOICE ||
        field->type == SW_FIELD_BOOL)
    {
        value = floor(low + (high - low + 0.999) * Random());
    }
    return swField_IsInRange(field, value) ? value : low + 0.5 * (high - low);
}

static void ChangeField(const swField* field, void* def)
{
    if (field->type == SW_FIELD_TEXT)
    {
        static const char* const words[] = {
            "word", "two words", "it's: here # no", "\"q\"", "- x", "\xC3\xA9t\xC3\xA9 12", " a "};
        snprintf((char*)def + field->offset, field->size, "%s%d", words[(int)(Random() * 7.0)], (int)(Random() * 1e6));
        return;
    }
    for (int i = 0; i < field->count; ++i)
    {
        swField_SetNumber(field, def, i, ChooseNumber(field));
    }
}

// Rules that cross fields.
static void MendView(swViewDef* view)
{
    view->resolution = view->resolution / 64 * 64;
    view->finestTexel = exp2f(roundf(log2f(fminf(fmaxf(view->finestTexel, 0.015625f), 16.0f))));
}

static void MendWaves(swWaveSystemDef* def)
{
    int resolution = 16;
    while (resolution * 2 <= def->resolution)
    {
        resolution *= 2;
    }
    def->resolution = resolution;
    def->tileWaves = def->tileWaves > resolution / 4 ? resolution / 4 : def->tileWaves;
    // What has no effect is not written.
    def->spectrum.spreadExponent =
        def->spectrum.spreading == SW_SPREADING_COSINE_2S ? def->spectrum.spreadExponent : 8.0f;
    def->spectrum.growth = def->spectrum.peakPeriod > 0.0f ? SW_GROWTH_HASSELMANN : def->spectrum.growth;
    if (def->minWavelength >= def->maxWavelength)
    {
        def->minWavelength = 0.0625f;
        def->maxWavelength = 4096.0f;
    }
}

static void ChangeFields(const swFields* fields, void* def);

static void ChangeView(swSceneView* view)
{
    ChangeFields(swGetSceneViewFields(), view);
    view->sunAzimuth *= view->hasSun ? 1.0f : 0.0f;
    view->sunElevation *= view->hasSun ? 1.0f : 0.0f;
}

static void ChangeFields(const swFields* fields, void* def)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        if (field->type == SW_FIELD_DEF)
        {
            ChangeFields(field->fields, (char*)def + field->offset);
        }
        else if (field->type < SW_FIELD_DEF && field->key != NULL)
        {
            ChangeField(field, def);
        }
    }
}

// Each by itself, from a scene that says nothing of it and from one that does.
static void CheckEachField(const swHost* host, const swFields* fields, size_t offset)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        if (field->type == SW_FIELD_DEF)
        {
            CheckEachField(host, field->fields, offset + field->offset);
        }
        for (int j = 0; j < 8 && field->type < SW_FIELD_DEF && field->key != NULL; ++j)
        {
            swScene* scene = Read(host, "# nothing\nwaves: []\n");
            ChangeField(field, (char*)scene + offset);
            MendView(&scene->view);
            char* made = CheckReadBack(host, scene);
            swScene* again = Read(host, made);
            ChangeField(field, (char*)again + offset);
            MendView(&again->view);
            free(CheckReadBack(host, again));
            free(made);
            swDestroyScene(again);
            swDestroyScene(scene);
        }
    }
}

static void EveryFieldOfASectionSurvives(void** state)
{
    (void)state;
    swHost host = MakeHost();
    CheckEachField(&host, swGetSceneFields(), 0);
    for (int i = 0; i < SW_SCENE_PART_COUNT; ++i)
    {
        swScenePart part = swGetScenePart(i);
        CheckEachField(&host, part.fields, part.offset);
    }
    for (int j = 0; j < 50; ++j)
    {
        swScene* scene = Read(&host, "waves: []\nviews:\n  - name: first # one\n");
        scene->views[0].hasSun = j % 2 == 0;
        ChangeView(&scene->views[0]);
        free(CheckReadBack(&host, scene));
        swDestroyScene(scene);
    }
}

// Any def of a kind that the world takes: waves of every kind, made in both ways.
static void ChangeWaves(swWaveSystemDef* def, int kind)
{
    ChangeFields(swGetWaveSystemFields(), def);
    def->spectrum.kind = (swSpectrumKind)kind;
    ChangeFields(swGetOctavesFields(), &def->spectrum.octaves);
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        ChangeFields(swGetOctaveFields(), &def->spectrum.octaves.octaves[i]);
    }
    def->spectrum.octaves.octaves[8].isEnabled = true;
    def->spectrum.octaves.octaves[8].power = 1.0f;
    def->spectrum.octaves.multiplier += 0.5f;
    def->spectrum.octaves.multiplier = fminf(def->spectrum.octaves.multiplier, 10.0f);
    def->spectrum.octaves.limitByWind = false;
    def->spectrum.depth = Random() < 0.5 ? INFINITY : def->spectrum.depth;
    MendWaves(def);
}

static void EveryFieldOfWavesSurvives(void** state)
{
    (void)state;
    swHost host = MakeHost();
    static const char* const starts[] = {
        "waves:\n  - beaufort: 4 # breeze\n    turbulence: 0.1\n",
        "waves:\n  - sea_state: 4\n",
        "waves: [{spectrum: swell, significant_height_m: 2, peak_period_s: 12, spread_deg: 20, seed: 2}]\n",
        "waves:\n  - spectrum: wind_sea\n    duration_h: 6\n    wind_speed_mps: 12\n    fetch_m: 1e5\n",
        "waves:\n  - spectrum: jonswap\n    growth: cube_root\n    spread_exponent: 3\n    # end\n",
        "waves:\n  - spectrum: octaves\n    octaves_from: pierson_moskowitz\n    octaves:\n      - {wavelength_m: 4, "
        "power: -1}\n"
        "      - wavelength_m: 0.5\n        enabled: true\n",
        "waves:\n  - components: [{wavelength_m: 9, amplitude_m: 1, direction_from_deg: 3}]\n    depth_m: 4\n",
    };
    for (size_t start = 0; start < sizeof(starts) / sizeof(starts[0]); ++start)
    {
        for (int kind = 0; kind < SW_SPECTRUM_TABLE; ++kind)
        {
            for (int j = 0; j < 8; ++j)
            {
                swScene* scene = Read(&host, starts[start]);
                swWaveSystemDef def = scene->waves[0].def;
                def.components = NULL;
                def.componentCount = 0;
                ChangeWaves(&def, kind);
                assert_int_equal(swScene_SetWaves(scene, 0, &def), SW_SUCCESS);
                free(CheckReadBack(&host, scene));
                swDestroyScene(scene);
            }
        }
    }
}

// Single fields of waves, by the way in which each kind tells of them.
static void OneFieldOfWavesKeepsTheRest(void** state)
{
    (void)state;
    swHost host = MakeHost();
    const swFields* fields = swGetSpectrumFields();
    for (int kind = 0; kind < SW_WAVES_COMPONENTS; ++kind)
    {
        for (int i = 0; i < fields->count && kind != SW_SPECTRUM_TABLE; ++i)
        {
            const swField* field = &fields->fields[i];
            char text[256];
            const char* word = swGetWavesWord(kind);
            bool isWord = kind < SW_WAVES_BEAUFORT;
            if (field->key == NULL || field->type >= SW_FIELD_DEF || i == fields->kind)
            {
                continue;
            }
            snprintf(text, sizeof(text), "waves:\n  - %s%s%s\n    seed: 9 # nine\n", isWord ? "spectrum: " : word,
                     isWord ? word : ": 3",
                     kind == SW_WAVES_SWELL ? "\n    significant_height_m: 2\n    peak_period_s: 12" : "");
            swScene* scene = Read(&host, text);
            ChangeField(field, &scene->waves[0].def.spectrum);
            MendWaves(&scene->waves[0].def);
            char* made = CheckReadBack(&host, scene);
            assert_non_null(strstr(made, "seed: 9 # nine\n"));
            free(made);
            swDestroyScene(scene);
        }
    }
}

// ---- any edits ----

static void EditScene(swScene* scene)
{
    double kind = Random();
    if (kind < 0.35)
    {
        swScenePart part = swGetScenePart((int)(Random() * SW_SCENE_PART_COUNT));
        const swField* field = &part.fields->fields[(int)(Random() * part.fields->count)];
        if (field->type == SW_FIELD_DEF)
        {
            ChangeFields(field->fields, (char*)scene + part.offset + field->offset);
        }
        else if (field->key != NULL)
        {
            ChangeField(field, (char*)scene + part.offset);
        }
        MendView(&scene->view);
    }
    else if (kind < 0.6 && scene->wavesCount > 0)
    {
        swSceneWaves* waves = &scene->waves[(int)(Random() * scene->wavesCount)];
        const swFields* fields = Random() < 0.5 ? swGetSpectrumFields() : swGetWaveSystemFields();
        const swField* field = &fields->fields[(int)(Random() * fields->count)];
        bool isKind = strcmp(field->member, "kind") == 0 || strcmp(field->member, "method") == 0;
        if (field->type < SW_FIELD_DEF && field->key != NULL && !isKind)
        {
            ChangeField(field, fields == swGetSpectrumFields() ? (void*)&waves->def.spectrum : (void*)&waves->def);
        }
        MendWaves(&waves->def);
    }
    else if (kind < 0.7 && scene->viewCount > 0)
    {
        ChangeView(&scene->views[(int)(Random() * scene->viewCount)]);
    }
    else if (kind < 0.78)
    {
        swWaveSystemDef def = swDefaultWaveSystemDef();
        ChangeWaves(&def, (int)(Random() * SW_SPECTRUM_TABLE));
        swScene_AddWaves(scene, &def);
    }
    else if (kind < 0.84 && scene->wavesCount > 0)
    {
        swScene_RemoveWaves(scene, (int)(Random() * scene->wavesCount));
    }
    else if (kind < 0.9)
    {
        swSceneView view = swDefaultSceneView();
        ChangeView(&view);
        swScene_AddView(scene, &view);
    }
    else if (kind < 0.94 && scene->viewCount > 0)
    {
        swScene_RemoveView(scene, (int)(Random() * scene->viewCount));
    }
    else if (scene->wavesCount > 0 && scene->waves[0].measured == NULL)
    {
        swWaveComponent rows[40];
        swWaveSystemDef def = scene->waves[0].def;
        int count = def.componentCount;
        if (count > 0 && count < 40)
        {
            memcpy(rows, scene->waves[0].components, (size_t)count * sizeof(rows[0]));
        }
        count = count >= 38 || (count > 1 && Random() < 0.4) ? count - 1 : count + 1;
        ChangeFields(swGetWaveComponentFields(), &rows[(int)(Random() * count)]);
        ChangeFields(swGetWaveComponentFields(), &rows[count - 1]);
        def.components = rows;
        def.componentCount = count;
        def.method = SW_WAVES_GERSTNER;
        swScene_SetWaves(scene, 0, &def);
    }
}

static void AThousandEditsReadBackEqual(void** state)
{
    (void)state;
    static const char* const names[] = {"open_sea", "crossing", "hindcast", "two_swells", "buoy"};
    swHost host = MakeHost();
    for (int run = 0; run < 5; ++run)
    {
        char path[512];
        snprintf(path, sizeof(path), "%s/%s.yaml", SCENES, names[run]);
        swScene* scene = NULL;
        assert_int_equal(swReadScene(&host, path, &scene), SW_SUCCESS);
        for (int i = 0; i < 200; ++i)
        {
            s_messages[0] = '\0';
            EditScene(scene);
            char* made = CheckReadBack(&host, scene);
            if (i % 3 != 0) // several changes at once as well
            {
                swDestroyScene(scene);
                scene = Read(&host, made);
            }
            free(made);
        }
        swDestroyScene(scene);
    }
}

// ---- files ----

static char s_folder[64];

static int MakeFolder(void** state)
{
    (void)state;
    snprintf(s_folder, sizeof(s_folder), "/tmp/seaway_write_XXXXXX");
    return mkdtemp(s_folder) != NULL ? 0 : -1;
}

static int CountFiles(void)
{
    DIR* folder = opendir(s_folder);
    int count = 0;
    for (struct dirent* entry = readdir(folder); entry != NULL; entry = readdir(folder))
    {
        count += entry->d_name[0] != '.';
    }
    closedir(folder);
    return count;
}

static int RemoveFolder(void** state)
{
    (void)state;
    char command[128];
    snprintf(command, sizeof(command), "rm -rf %s", s_folder);
    return system(command);
}

static const char* PutText(const char* name, const char* text)
{
    static char path[256];
    snprintf(path, sizeof(path), "%s/%s", s_folder, name);
    FILE* file = fopen(path, "wb");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
    return path;
}

static void CheckText(const char* path, const char* text)
{
    size_t size = 0;
    char* found = ReadTextFile(path, &size);
    assert_string_equal(found, text);
    free(found);
}

static void AFileIsReplacedWhole(void** state)
{
    (void)state;
    swHost host = MakeHost();
    const char* path = PutText("a.yaml", "sky: {haze: 1} # air\nwaves: []\n");
    assert_int_equal(chmod(path, 0640), 0);
    char link[256];
    snprintf(link, sizeof(link), "%s/link.yaml", s_folder);
    assert_int_equal(symlink("a.yaml", link), 0);
    swScene* scene = NULL;
    assert_int_equal(swReadScene(&host, link, &scene), SW_SUCCESS);
    scene->sky.haze = 2.0f;
    assert_int_equal(swWriteScene(scene, link), SW_SUCCESS);
    CheckText(path, "sky: {haze: 2} # air\nwaves: []\n");
    struct stat status;
    assert_true(stat(path, &status) == 0 && (status.st_mode & 0777) == 0640);
    assert_true(lstat(link, &status) == 0 && S_ISLNK(status.st_mode));
    scene->sky.haze = 3.0f; // and on from there
    swWaveSystemDef def = swDefaultWaveSystemDef();
    assert_int_equal(swScene_AddWaves(scene, &def), SW_SUCCESS);
    assert_int_equal(swWriteScene(scene, link), SW_SUCCESS);
    scene->waves[0].def.chop = 0.5f;
    assert_int_equal(swWriteScene(scene, link), SW_SUCCESS);
    swScene* again = NULL;
    assert_int_equal(swReadScene(&host, path, &again), SW_SUCCESS);
    assert_true(AreScenesEqual(scene, again));
    swDestroyScene(again);
    assert_int_equal(CountFiles(), 2);

    // What somebody else has written since is not lost.
    PutText("a.yaml", "waves: []\n");
    scene->sky.haze = 4.0f;
    assert_int_equal(swWriteScene(scene, link), SW_ERROR_FILE);
    assert_non_null(strstr(s_messages, "has changed since it was read"));
    CheckText(path, "waves: []\n");
    assert_int_equal(swWriteScene(scene, path), SW_ERROR_FILE); // whatever the path is called
    CheckText(path, "waves: []\n");
    swDestroyScene(scene);
}

static void NamesOfFilesLeadThereFromTheNewPlace(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swScene* scene = NULL;
    assert_int_equal(swReadScene(&host, SCENES "/buoy.yaml", &scene), SW_SUCCESS);
    char path[256];
    snprintf(path, sizeof(path), "%s/buoy.yaml", s_folder);
    int files = CountFiles();
    assert_int_equal(swWriteScene(scene, path), SW_ERROR_FILE);
    assert_non_null(strstr(s_messages, "data/harbour_storm.data_spec, which is not there beside it"));
    assert_int_equal(CountFiles(), files);
    swScene_RemoveWaves(scene, 0);
    assert_int_equal(swWriteScene(scene, path), SW_SUCCESS);
    remove(path);
    swDestroyScene(scene);
}

static void CountsOutOfRangeAreRefused(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swScene* scene = Read(&host, "waves: []\nviews:\n  - name: a\n");
    const int counts[] = {-1, SW_MAX_SCENE_VIEWS + 1};
    size_t size = 0;
    for (int i = 0; i < 2; ++i)
    {
        scene->wavesCount = counts[i];
        assert_int_equal(swPrintScene(scene, NULL, &size), SW_ERROR_INVALID);
        scene->wavesCount = 0;
        scene->viewCount = counts[i];
        assert_int_equal(swPrintScene(scene, NULL, &size), SW_ERROR_INVALID);
        scene->viewCount = 1;
    }
    assert_int_equal(swPrintScene(scene, NULL, &size), SW_SUCCESS);
    swDestroyScene(scene);
}

static void WhatCannotBeWrittenLosesNothing(void** state)
{
    (void)state;
    swHost host = MakeHost();
    static const char text[] = "sky: {haze: 1}\nwaves: []\n";
    char path[256];
    snprintf(path, sizeof(path), "%s", PutText("b.yaml", text));
    int files = CountFiles();
    swScene* scene = NULL;
    assert_int_equal(swReadScene(&host, path, &scene), SW_SUCCESS);
    scene->sky.haze = 2.0f;

    // The disk is full.
    struct rlimit before, little;
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    little = before;
    little.rlim_cur = 5;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &little), 0);
    swResult result = swWriteScene(scene, path);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    assert_int_equal(result, SW_ERROR_FILE);
    CheckText(path, text);
    assert_int_equal(CountFiles(), files);

    // No file, no folder, no permission.
    assert_int_equal(swWriteScene(scene, "/dev/full"), SW_ERROR_FILE);
    assert_non_null(strstr(s_messages, "it is no file"));
    assert_int_equal(swWriteScene(scene, s_folder), SW_ERROR_FILE);
    assert_int_equal(swWriteScene(scene, "/nowhere/at/all.yaml"), SW_ERROR_FILE);
    if (geteuid() != 0)
    {
        assert_int_equal(chmod(s_folder, 0500), 0);
        assert_int_equal(swWriteScene(scene, path), SW_ERROR_FILE);
        assert_int_equal(chmod(s_folder, 0700), 0);
        CheckText(path, text);
    }

    // A value that no file can have.
    scene->sky.haze = NAN;
    assert_int_equal(swWriteScene(scene, path), SW_ERROR_INVALID);
    scene->sky.haze = 2.0f;
    CheckText(path, text);

    // And then it is written after all.
    assert_int_equal(swWriteScene(scene, path), SW_SUCCESS);
    CheckText(path, "sky: {haze: 2}\nwaves: []\n");
    swDestroyScene(scene);
}

static void WhatIsSharedIsRefusedWithItsLine(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swScene* scene = Read(&host, "waves: []\nwater:\n  absorption_per_m: &c [0.1, 0.2, 0.3]\n  scattering_per_m: *c\n");
    scene->water.absorption.x = 0.5f;
    assert_null(Print(scene));
    assert_non_null(strstr(s_messages, "a.yaml:3: "));
    scene->water.absorption.x = 0.1f;
    free(CheckReadBack(&host, scene));
    scene->water.windSpeed = 3.0f; // beside them
    assert_null(Print(scene));
    swDestroyScene(scene);
}

static void FailingMemoryLosesNothing(void** state)
{
    (void)state;
    static const char text[] =
        "sky: {haze: 1}\nwaves:\n  - beaufort: 3\n  - components: [{wavelength_m: 9, amplitude_m: 1, "
        "direction_from_deg: 3}]\nviews:\n  - name: a\n";
    char path[256];
    snprintf(path, sizeof(path), "%s", PutText("c.yaml", text));
    CountingMemory counting;
    swHost host = MakeCountingHost(&counting);
    swResult result = SW_ERROR_NO_MEMORY;
    int tries = 0;
    for (; result != SW_SUCCESS && tries < 2000; ++tries)
    {
        swScene* scene = NULL;
        assert_int_equal(swReadScene(&host, path, &scene), SW_SUCCESS);
        scene->sky.haze = 2.0f;
        scene->waves[0].def.spectrum.gamma = 2.0f;
        scene->views[0].roll = 0.1f;
        atomic_store(&counting.failAt, atomic_load(&counting.allocations) + tries);
        swWaveSystemDef def = swDefaultWaveSystemDef();
        result = swScene_AddWaves(scene, &def);
        result = result == SW_SUCCESS ? swWriteScene(scene, path) : result;
        atomic_store(&counting.failAt, -1);
        assert_true(result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY);
        if (result != SW_SUCCESS)
        {
            CheckText(path, text);
        }
        swDestroyScene(scene);
        assert_int_equal(atomic_load(&counting.bytes), 0);
    }
    assert_true(tries > 10);
    assert_int_equal(result, SW_SUCCESS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(WhatIsNotChangedKeepsItsBytes),
        cmocka_unit_test(ItsSizeCanBeAskedFor),
        cmocka_unit_test(OneValueChangesItsBytes),
        cmocka_unit_test(WavesAreToldAsBefore),
        cmocka_unit_test(WhatComesAndGoesIsWritten),
        cmocka_unit_test(MeasuredSeasStayWhatTheyAre),
        cmocka_unit_test(EveryFieldOfASectionSurvives),
        cmocka_unit_test(EveryFieldOfWavesSurvives),
        cmocka_unit_test(OneFieldOfWavesKeepsTheRest),
        cmocka_unit_test(AThousandEditsReadBackEqual),
        cmocka_unit_test(AFileIsReplacedWhole),
        cmocka_unit_test(NamesOfFilesLeadThereFromTheNewPlace),
        cmocka_unit_test(CountsOutOfRangeAreRefused),
        cmocka_unit_test(WhatCannotBeWrittenLosesNothing),
        cmocka_unit_test(WhatIsSharedIsRefusedWithItsLine),
        cmocka_unit_test(FailingMemoryLosesNothing),
    };
    return cmocka_run_group_tests(tests, MakeFolder, RemoveFolder);
}
