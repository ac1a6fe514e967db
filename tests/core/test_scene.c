// SPDX-License-Identifier: MIT
// Scene files fill defs; what is wrong in one is told in a sentence with its line; the scenes that we ship make seas.

#include "support/cmocka_setup.h"
#include "support/messages.h"
#include "support/counting_host.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

#include "seaway/files.h"
#include "seaway/scene.h"

#define SCENES SW_SOURCE_DIR "/scenes"

#define ONE_WAVE "\n      - {wavelength_m: 50, amplitude_m: 0.5, direction_from_deg: 270}\n"

static swResult ReadText(const char* text, swScene** scene)
{
    swHost host = MakeHost();
    return swReadSceneText(&host, text, strlen(text), "a.yaml", SCENES, scene);
}

static bool IsNear(double value, double expected)
{
    return fabs(value - expected) < 1e-5;
}

static void EveryKeyReachesItsField(void** state)
{
    (void)state;
    static const char text[] =
        "name: All of it\n"
        "time_s: -12.5\n"
        "exposure_ev: 0.5\n"
        "world: {gravity_mps2: 3.7, surface_tension_m3ps2: 1e-4, sea_level_m: 11}\n"
        "foam: {fade_rate_per_s: 0.5, threshold: 0.25, coverage: 3, wind_speed_mps: 7, min_wavelength_m: 2}\n"
        "view: {slice_count: 5, resolution: 256, finest_texel_m: 0.125, max_scale_level: 4}\n"
        "sun: {azimuth_deg: 90, elevation_deg: 45, illuminance_lux: 1e5}\n"
        "sky: {haze: 2, clouds: 0.75}\n"
        "water:\n"
        "  absorption_per_m: [0.5, 0.25, 0.125]\n"
        "  scattering_per_m: [0.01, 0.02, 0.03]\n"
        "  refractive_index: 1.33\n"
        "  foam_albedo: [0.5, 0.5, 0.25]\n"
        "  wind_speed_mps: 9\n"
        "waves:\n"
        "  - spectrum: jonswap\n"
        "    wind_speed_mps: 12\n"
        "    fetch_m: 2e5\n"
        "    gamma: 2\n"
        "    significant_height_m: 2.5\n"
        "    peak_period_s: 8\n"
        "    direction_from_deg: 270\n"
        "    spread_exponent: 12\n"
        "    resolution: 256\n"
        "    tile_waves: 16\n"
        "    min_wavelength_m: 0.5\n"
        "    max_wavelength_m: 512\n"
        "    chop: 0.5\n"
        "    weight: 0.75\n"
        "    depth_m: 30\n"
        "    loop_period_s: 60\n"
        "    seed: 4294967295\n"
        "  - spectrum: file\n"
        "    file: data/harbour_storm.data_spec\n"
        "    at: 2024-11-16 05:50\n"
        "    turn_deg: 90\n"
        "    extend_tail: false\n"
        "views:\n"
        "  - name: one\n"
        "    position_m: [1, 2, -3e3]\n"
        "    heading_deg: 180\n"
        "    pitch_deg: -90\n"
        "    roll_deg: 45\n"
        "    fov_deg: 60\n"
        "    sun_azimuth_deg: 270\n"
        "    sun_elevation_deg: 5\n"
        "  - name: two\n";
    swScene* scene = NULL;
    if (ReadText(text, &scene) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    assert_string_equal(scene->name, "All of it");
    assert_true(scene->time == -12.5 && scene->exposureEv == 0.5f);
    assert_true(scene->world.gravity == 3.7f && scene->world.surfaceTension == 1e-4f && scene->world.seaLevel == 11.0);
    assert_true(scene->world.foam.fadeRate == 0.5f && scene->world.foam.threshold == 0.25f &&
                scene->world.foam.coverage == 3.0f && scene->world.foam.windSpeed == 7.0f &&
                scene->world.foam.minWavelength == 2.0f);
    assert_true(scene->view.sliceCount == 5 && scene->view.resolution == 256 && scene->view.finestTexel == 0.125f &&
                scene->view.maxScaleLevel == 4);
    assert_true(IsNear((double)scene->sky.sunAzimuth, SW_PI / 2) && IsNear((double)scene->sky.sunElevation, SW_PI / 4));
    assert_true(scene->sky.sunIlluminance == 1e5f && scene->sky.haze == 2.0f && scene->sky.clouds == 0.75f);
    assert_true(scene->water.absorption.x == 0.5f && scene->water.absorption.z == 0.125f &&
                scene->water.scattering.y == 0.02f && scene->water.foamAlbedo.z == 0.25f);
    assert_true(scene->water.refractiveIndex == 1.33f && scene->water.windSpeed == 9.0f);

    assert_int_equal(scene->wavesCount, 2);
    const swWaveSystemDef* def = &scene->waves[0].def;
    assert_true(def->spectrum.kind == SW_SPECTRUM_JONSWAP && def->spectrum.windSpeed == 12.0f &&
                def->spectrum.fetch == 2e5f && def->spectrum.gamma == 2.0f && def->spectrum.significantHeight == 2.5f &&
                def->spectrum.peakPeriod == 8.0f && def->spectrum.spreadExponent == 12.0f);
    assert_true(IsNear(cos((double)def->spectrum.direction), 1.0)); // from the west: eastward
    assert_true(def->resolution == 256 && def->tileWaves == 16 && def->minWavelength == 0.5f &&
                def->maxWavelength == 512.0f && def->chop == 0.5f && def->weight == 0.75f &&
                def->spectrum.depth == 30.0f && def->loopPeriod == 60.0f && def->seed == 4294967295u);

    const swSceneWaves* measured = &scene->waves[1];
    assert_non_null(measured->measured);
    assert_int_equal(measured->record, 1);
    assert_string_equal(measured->file, "data/harbour_storm.data_spec");
    assert_ptr_equal(measured->def.spectrum.table, &measured->table);
    assert_true(measured->table.frequencyCount == 46 && !measured->def.spectrum.extendTail);
    assert_true(IsNear((double)measured->def.spectrum.direction, SW_PI / 2));

    assert_int_equal(scene->viewCount, 2);
    const swSceneView* view = &scene->views[0];
    assert_true(view->position.x == 1.0 && view->position.y == 2.0 && view->position.z == -3000.0);
    assert_true(IsNear((double)view->heading, SW_PI) && IsNear((double)view->pitch, -SW_PI / 2) &&
                IsNear((double)view->roll, SW_PI / 4) && IsNear((double)view->verticalFov, SW_PI / 3));
    assert_true(view->hasSun && !scene->views[1].hasSun);
    assert_true(IsNear((double)swScene_GetSky(scene, view).sunAzimuth, 1.5 * SW_PI));
    assert_true(IsNear((double)swScene_GetSky(scene, &scene->views[1]).sunAzimuth, SW_PI / 2));
    assert_ptr_equal(swScene_FindView(scene, NULL), view);
    assert_ptr_equal(swScene_FindView(scene, "two"), &scene->views[1]);
    assert_null(swScene_FindView(scene, "three"));
    swDestroyScene(scene);
}

static void WhatIsLeftOutKeepsItsDefault(void** state)
{
    (void)state;
    swScene* scene = NULL;
    assert_int_equal(ReadText("name: short\n", &scene), SW_SUCCESS);
    swWorldDef world = swDefaultWorldDef();
    swViewDef view = swDefaultViewDef();
    assert_true(scene->world.gravity == world.gravity && scene->world.seaLevel == world.seaLevel &&
                scene->world.enableQueries == world.enableQueries && scene->world.foam.coverage == world.foam.coverage);
    assert_true(scene->view.sliceCount == view.sliceCount && scene->view.resolution == view.resolution &&
                scene->view.finestTexel == view.finestTexel && scene->view.maxScaleLevel == view.maxScaleLevel);
    assert_int_equal(scene->wavesCount, 0);
    swDestroyScene(scene);
}

static void WrongScenesAreNamedWithTheirLine(void** state)
{
    (void)state;
    static const struct
    {
        const char *text, *words;
    } cases[] = {
        {"", "a.yaml:1: the scene file is empty"},
        {"- a\n", "a.yaml:1: a scene must hold lines of the form"},
        {"name: a\nwavs: []\n", "a.yaml:2: 'wavs' is no key of a scene; it has: name, time_s"},
        {"name: a\n\nname: b\n", "a.yaml:3: name stands twice in a scene, first on line 1"},
        {"time_s: soon\n", "a.yaml:1: time_s is 'soon'; it must be a number"},
        {"time_s: 1,5\n", "a.yaml:1: time_s is '1,5'"},
        {"time_s: .nan\n", "a.yaml:1: time_s is '.nan'"},
        {"sky:\n  haze: 30\n", "a.yaml:2: haze is 30; its range is 0 to 20."},
        {"view: {resolution: 100}\n", "a.yaml:1: resolution is 100; it must be a multiple of 64."},
        {"view: {finest_texel_m: 0.1}\n", "it must be a power of two"},
        {"view: {slice_count: 2.5}\n", "slice_count is 2.5; it must be a whole number"},
        {"waves:\n  - spectrum: tsunami\n",
         "a.yaml:2: spectrum is 'tsunami'; it must be one of: jonswap, pierson_moskowitz, tma, elfouhaily, phillips, "
         "octaves, file, wind_sea, swell."},
        {"waves:\n  - seed: 1\n", "a.yaml:2: the key spectrum is missing"},
        {"waves:\n  - spectrum: tma\n    beaufort: 5\n",
         "a.yaml:3: spectrum, beaufort, sea_state and components each make"},
        {"waves:\n  - beaufort: 13\n", "a.yaml:2: beaufort is 13; its range is 0 to 12."},
        {"waves:\n  - sea_state: 3\n    wind_speed_mps: 4\n",
         "a.yaml:3: wind_speed_mps has no effect on the spectrum 'sea_state'"},
        {"waves:\n  - spectrum: jonswap\n    duration_h: 4\n", "a.yaml:3: duration_h has no effect"},
        {"waves:\n  - spectrum: jonswap\n    spreading: wide\n",
         "a.yaml:3: spreading is 'wide'; it must be one of: cosine, mitsuyasu, hasselmann, donelan_banner, flat, "
         "elfouhaily."},
        {"waves:\n  - spectrum: jonswap\n    spreading: flat\n    spread_exponent: 4\n",
         "a.yaml:4: spread_exponent has an effect with spreading: cosine only"},
        {"waves:\n  - beaufort: 5\n    spread_exponent: 4\n", "a.yaml:3: spread_exponent has an effect"},
        {"waves:\n  - spectrum: swell\n    peak_period_s: 12\n", "a.yaml:2: a swell needs significant_height_m"},
        {"waves:\n  - spectrum: octaves\n    octaves:\n      - {power: 1}\n",
         "a.yaml:4: an octave needs a wavelength_m"},
        {"waves:\n  - spectrum: octaves\n    octaves:\n      - {wavelength_m: 3}\n", "a.yaml:4: an octave needs"},
        {"waves:\n  - spectrum: octaves\n    octaves:\n      - {wavelength_m: 4, chop: 1}\n      - {wavelength_m: 4}\n",
         "a.yaml:5: the octave of 4 m stands twice"},
        {"waves:\n  - spectrum: octaves\n    multiplier: 0\n", "a.yaml:2: the octaves have no energy"},
        {"waves:\n  - spectrum: phillips\n    octaves: []\n", "a.yaml:3: octaves has no effect"},
        {"waves:\n  - spectrum: pierson_moskowitz\n    fetch_m: 1e5\n", "a.yaml:3: fetch_m has no effect"},
        {"waves:\n  - spectrum: elfouhaily\n    growth: cube_root\n", "a.yaml:3: growth has no effect on"},
        {"waves:\n  - spectrum: wind_sea\n    growth: cube_root\n", "a.yaml:3: growth has no effect on"},
        {"waves:\n  - spectrum: tma\n    growth: linear\n",
         "a.yaml:3: growth is 'linear'; it must be one of: hasselmann, cube_root."},
        {"waves:\n  - spectrum: jonswap\n    growth: cube_root\n    peak_period_s: 8\n",
         "a.yaml:3: growth has no effect where peak_period_s is given; remove one of them."},
        {"waves:\n  - spectrum: jonswap\n    wind_speed_mps: 0\n",
         "a.yaml:3: wind_speed_mps is 0; its range is above 0 to 100"},
        {"waves:\n  - spectrum: jonswap\n    resolution: 100\n",
         "a.yaml:3: resolution is 100; it must be a power of two."},
        {"waves:\n  - spectrum: jonswap\n    resolution: 64\n",
         "a.yaml:2: tile_waves is 32; it must be at most a quarter"},
        {"waves:\n  - spectrum: file\n", "a.yaml:2: a spectrum 'file' needs the key file"},
        {"waves:\n  - spectrum: file\n    file: none.data_spec\n",
         "Cannot open " SCENES "/none.data_spec: No such file"},
        {"waves:\n  - spectrum: file\n    file: open_sea.yaml\n", "open_sea.yaml:1: no format"},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.data_spec\n    at: noon\n",
         "a.yaml:4: at is 'noon'"},
        {"waves:\n  - spectrum: jonswap\n    method: fourier\n",
         "a.yaml:3: method is 'fourier'; it must be one of: fft, gerstner."},
        {"waves:\n  - spectrum: jonswap\n    reverse_weight: 0.5\n",
         "a.yaml:3: reverse_weight has an effect with 'method: gerstner' only; add that or remove it."},
        {"waves:\n  - spectrum: jonswap\n    method: fft\n    components_per_octave: 4\n",
         "a.yaml:4: components_per_octave has an effect with 'method: gerstner' only"},
        {"waves:\n  - beaufort: 3\n    direction_variance_deg: 4\n", "a.yaml:3: direction_variance_deg has an effect"},
        {"waves:\n  - beaufort: 3\n    method: gerstner\n    resolution: 64\n",
         "a.yaml:4: resolution has an effect with 'method: fft' only; remove it."},
        {"waves:\n  - beaufort: 3\n    method: gerstner\n    components_per_octave: 33\n",
         "a.yaml:4: components_per_octave is 33; its range is 1 to 32."},
        {"waves:\n  - beaufort: 3\n    method: gerstner\n    reverse_weight: -1\n", "its range is 0 to 1."},
        {"waves:\n  - beaufort: 3\n    method: gerstner\n    direction_variance_deg: 181\n", "its range is 0 to 180."},
        {"waves:\n  - spectrum: file\n    file: a\n    files: [b]\n", "a.yaml:4: file and files both name"},
        {"waves:\n  - spectrum: file\n    files: []\n", "a.yaml:3: files is empty"},
        {"waves:\n  - spectrum: file\n    files:\n      - data/harbour_storm.spec\n      - none.spec\n",
         "a.yaml:5: the spectrum file " SCENES "/none.spec cannot be used."},
        {"waves:\n  - spectrum: file\n    files:\n      - [a]\n", "a.yaml:4: files must be a text."},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    location: Nowhere\n",
         "a.yaml:4: location is 'Nowhere'; it must be the name or number of a place of the file, which has: 1."},
        {"waves:\n  - spectrum: jonswap\n    location: 1\n", "a.yaml:3: location has no effect"},
        {"waves:\n  - spectrum: jonswap\n    latitude: 1\n", "a.yaml:3: latitude has no effect"},
        {"waves:\n  - spectrum: jonswap\n    longitude: 1\n", "a.yaml:3: longitude has no effect"},
        {"waves:\n  - spectrum: jonswap\n    directions: to\n", "a.yaml:3: directions has no effect"},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    directions: up\n", "a.yaml:4: directions"},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    directions: to\n",
         "harbour_storm.spec: what its directions mean is laid down by its format"},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    at: 2031-01-01 00:00\n",
         "a.yaml:4: at is '2031-01-01 00:00', of which the file has no record."},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    at: 2031-01-01 00:00\n",
         "which run from 2024-11-16 04:50 to 2024-11-16 06:50 (UTC)"},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    replay: {from: 2031-01-01 00:00}\n",
         "from is '2031-01-01 00:00', of which there is no record."},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    latitude: 91\n    longitude: 0\n",
         "a.yaml:4: latitude"},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    latitude: 50\n",
         "a.yaml:4: latitude and longitude belong together; give both."},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    latitude: 50\n    longitude: 0\n",
         "a.yaml:4: no place of the file is near latitude 50, longitude 0."},
        {"waves:\n  - spectrum: jonswap\n    replay: {speed: 2}\n", "a.yaml:3: replay has no effect"},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    replay: 3\n",
         "a.yaml:4: replay must hold"},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    replay: {sped: 3}\n",
         "a.yaml:4: 'sped' is no key of replay; it has: from, time_s, speed."},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    replay: {from: dawn}\n",
         "a.yaml:4: from is 'dawn'; it must be a time"},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    replay: {}\n    at: 2024-11-16 05:50\n",
         "a.yaml:5: at chooses one record, but all are replayed; say replay: {from: 2024-11-16 05:50}."},
        {"waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    replay: {}\n    method: gerstner\n",
         "a.yaml:5: a replay needs 'method: fft'"},
        {"waves:\n  - components: []\n", "a.yaml:2: components is empty; give it a wave"},
        {"waves:\n  - components: {wavelength_m: 4}\n", "a.yaml:2: components must be a list"},
        {"waves:\n  - components:\n      - {wavelength_m: 4, amplitude_m: 0.1}\n",
         "a.yaml:3: the component has no direction_from_deg; it needs"},
        {"waves:\n  - components:\n      - {amplitude_m: 0.1}\n", "a.yaml:3: the component has no wavelength_m"},
        {"waves:\n  - components:\n      - {wavelength_m: 5e3}\n",
         "a.yaml:3: wavelength_m is 5000; its range is 0.0625 to 4096."},
        {"waves:\n  - components:\n      - {length_m: 50}\n", "a.yaml:3: 'length_m' is no key of a component; it has:"},
        {"waves:\n  - components:" ONE_WAVE "    spectrum: jonswap\n", "each make the waves; keep one of them."},
        {"waves:\n  - components:" ONE_WAVE "    seed: 4\n",
         "a.yaml:4: seed has no effect on 'components'; remove it."},
        {"waves:\n  - components:" ONE_WAVE "    min_wavelength_m: 4\n", "a.yaml:4: min_wavelength_m has no effect"},
        {"waves:\n  - components:" ONE_WAVE "    direction_from_deg: 4\n",
         "a.yaml:4: direction_from_deg has no effect on 'components'; remove it."},
        {"waves:\n  - components:" ONE_WAVE "    least_jacobian: 0.4\n", "a.yaml:4: least_jacobian has no"},
        {"waves:\n  - beaufort: 3\n    least_jacobian: 0.4\n", "a.yaml:3: least_jacobian has an effect"},
        {"waves:\n  - components:" ONE_WAVE "    components_per_octave: 4\n", "a.yaml:4: components_per_octave has no"},
        {"waves:\n  - components:" ONE_WAVE "    method: fft\n",
         "a.yaml:4: components are made with 'method: gerstner' only"},
        {"waves: jonswap\n", "a.yaml:1: waves must be a list"},
        {"views:\n  - name: a\n  - name: a\n", "a.yaml:3: a view named 'a' stands above"},
        {"views:\n  - fov_deg: 50\n", "a.yaml:2: the view has no name"},
        {"views:\n  - name: a\n    position_m: [1, 2]\n", "a.yaml:3: position_m has 2 numbers"},
        {"views:\n  - name: a\n    sun_azimuth_deg: 2\n", "a.yaml:3: a view's own sun needs both"},
        {"name: [a\n", "this is not YAML"},
        {"name: a\n\tb: c\n", "a.yaml:2: this is not YAML"},
        {"name: a\n---\nname: b\n", "a second document begins"},
        {"name: \xff\n", "a.yaml:1: this is not YAML"},
        {"name: *b\n", "this is not YAML"},
        {"name: \"a\\0b\"\n", "a.yaml:1: name holds a zero byte"},
        {"name:\n", "a.yaml:1: name must be a text."},
        {"&a world: *a\n", "a.yaml:1: world must hold lines"},
        {"? [a]\n: b\n", "'' is no key of a scene"},
    };
    for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); ++i)
    {
        swScene* scene = NULL;
        swResult result = ReadText(cases[i].text, &scene);
        assert_null(scene);
        assert_true(result == SW_ERROR_FORMAT || result == SW_ERROR_FILE);
        if (strstr(s_messages, cases[i].words) == NULL)
        {
            fail_msg("\"%s\" does not say \"%s\"", s_messages, cases[i].words);
        }
    }
}

static void EverySpectrumCanBeWritten(void** state)
{
    (void)state;
    static const char text[] =
        "waves:\n"
        "  - {spectrum: tma, depth_m: 8, gamma: 2.5, growth: cube_root, spreading: hasselmann, turbulence: 0.25}\n"
        "  - {spectrum: elfouhaily, fetch_m: 1e6, spreading: elfouhaily, swell: 0.5}\n"
        "  - {spectrum: phillips, wind_speed_mps: 9, spreading: donelan_banner}\n"
        "  - {spectrum: wind_sea, wind_speed_mps: 15, fetch_m: 2e5, duration_h: 6}\n"
        "  - {spectrum: swell, significant_height_m: 1.5, peak_period_s: 14, spread_deg: 10}\n"
        "  - {beaufort: 6.5, spreading: cosine, spread_exponent: 4, depth_m: 20}\n"
        "  - {sea_state: 4, direction_from_deg: 270}\n"
        "  - spectrum: octaves\n"
        "    octaves_from: swell\n"
        "    octaves:\n"
        "      - {wavelength_m: 64, power: -0.5, chop: 1.25, gravity_scale: 0.5}\n"
        "      - {wavelength_m: 128, enabled: false}\n"
        "      - {wavelength_m: 0.0625, power: -7}\n"
        "    multiplier: 1.5\n"
        "    gravity_scale: 2\n"
        "    limit_by_wind: false\n"
        "  - {spectrum: octaves, octaves_from: pierson_moskowitz, wind_speed_mps: 12}\n";
    swScene* scene = NULL;
    if (ReadText(text, &scene) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    const swSpectrumDef* tma = &scene->waves[0].def.spectrum;
    assert_true(tma->kind == SW_SPECTRUM_TMA && tma->depth == 8.0f && tma->gamma == 2.5f &&
                tma->growth == SW_GROWTH_CUBE_ROOT && tma->spreading == SW_SPREADING_HASSELMANN &&
                tma->turbulence == 0.25f);
    const swSpectrumDef* unified = &scene->waves[1].def.spectrum;
    assert_true(unified->kind == SW_SPECTRUM_ELFOUHAILY && unified->fetch == 1e6f && unified->swell == 0.5f &&
                unified->spreading == SW_SPREADING_ELFOUHAILY);
    const swSpectrumDef* phillips = &scene->waves[2].def.spectrum;
    assert_true(phillips->kind == SW_SPECTRUM_PHILLIPS && phillips->spreading == SW_SPREADING_DONELAN_BANNER);
    const swSpectrumDef* wind = &scene->waves[3].def.spectrum;
    swSpectrumDef wanted = swMakeWindSeaSpectrum(15.0f, 2e5f, 6.0f * 3600.0f, 0.0f);
    assert_true(wind->significantHeight == wanted.significantHeight && wind->peakPeriod == wanted.peakPeriod &&
                wind->spreading == SW_SPREADING_HASSELMANN);
    const swSpectrumDef* swell = &scene->waves[4].def.spectrum;
    assert_true(swell->significantHeight == 1.5f && swell->peakPeriod == 14.0f && swell->gamma == 7.0f);
    double width = 10.0 * SW_PI / 180.0;
    assert_true(fabs((double)swell->spreadExponent - (2.0 / (width * width) - 1.0)) < 1e-3);
    const swSpectrumDef* beaufort = &scene->waves[5].def.spectrum;
    assert_true(beaufort->significantHeight == 3.5f && beaufort->spreading == SW_SPREADING_COSINE_2S &&
                beaufort->spreadExponent == 4.0f && beaufort->depth == 20.0f);
    const swSpectrumDef* slight = &scene->waves[6].def.spectrum;
    assert_true(slight->significantHeight == 1.875f && IsNear(cos((double)slight->direction), 1.0));
    const swOctaves* octaves = &scene->waves[7].def.spectrum.octaves;
    assert_true(octaves->octaves[10].power == -0.5f && octaves->octaves[10].chop == 1.25f &&
                octaves->octaves[10].gravityScale == 0.5f && octaves->octaves[10].isEnabled);
    assert_true(!octaves->octaves[11].isEnabled && octaves->octaves[11].power == swDefaultOctaves().octaves[11].power);
    assert_true(octaves->octaves[0].isEnabled && !octaves->octaves[1].isEnabled);
    assert_true(octaves->multiplier == 1.5f && octaves->gravityScale == 2.0f && !octaves->limitByWind);
    swSeaState made;
    assert_int_equal(swSpectrum_GetSeaState(&scene->waves[8].def.spectrum, 0.0f, 0.0f, &made), SW_SUCCESS);
    assert_true(fabs((double)made.significantHeight / (0.22027 * 144.0 / 9.81) - 1.0) < 0.01);
    swDestroyScene(scene);
}

static void FewWavesComeFromSpectraOrByHand(void** state)
{
    (void)state;
    static const char text[] =
        "waves:\n"
        "  - {beaufort: 4, method: gerstner, components_per_octave: 3, reverse_weight: 0.25, direction_variance_deg: "
        "90, least_jacobian: 0.3}\n"
        "  - {spectrum: swell, significant_height_m: 1, peak_period_s: 9, method: gerstner}\n"
        "  - {spectrum: jonswap, method: fft}\n"
        "  - components:\n"
        "      - {wavelength_m: 50, amplitude_m: 0.5, direction_from_deg: 270}\n"
        "      - {wavelength_m: 20, amplitude_m: 0.25, direction_from_deg: 180, phase_deg: -90}\n"
        "    method: gerstner\n"
        "    chop: 0.5\n"
        "    weight: 2\n"
        "    depth_m: 7\n"
        "    loop_period_s: 100\n";
    swScene* scene = NULL;
    if (ReadText(text, &scene) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    const swWaveSystemDef* few = &scene->waves[0].def;
    assert_true(few->method == SW_WAVES_GERSTNER && few->componentsPerOctave == 3 && few->reverseWeight == 0.25f &&
                IsNear((double)few->directionVariance, SW_PI / 2) && few->leastJacobian == 0.3f &&
                few->componentCount == 0);
    swWaveSystemDef defaults = swDefaultWaveSystemDef();
    few = &scene->waves[1].def;
    assert_true(few->method == SW_WAVES_GERSTNER && few->componentsPerOctave == defaults.componentsPerOctave &&
                few->reverseWeight == 0.0f && few->directionVariance == 0.0f);
    assert_true(scene->waves[2].def.method == SW_WAVES_FFT);
    const swWaveSystemDef* given = &scene->waves[3].def;
    assert_true(given->method == SW_WAVES_GERSTNER && given->componentCount == 2 && given->chop == 0.5f &&
                given->weight == 2.0f && given->spectrum.depth == 7.0f && given->loopPeriod == 100.0f);
    assert_ptr_equal(given->components, scene->waves[3].components);
    assert_true(given->components[0].wavelength == 50.0f && given->components[0].amplitude == 0.5f &&
                IsNear(cos((double)given->components[0].direction), 1.0) && given->components[0].phase == 0.0f);
    assert_true(given->components[1].wavelength == 20.0f && given->components[1].amplitude == 0.25f &&
                IsNear(sin((double)given->components[1].direction), -1.0) &&
                IsNear((double)given->components[1].phase, -SW_PI / 2));
    swDestroyScene(scene);
}

static void WavesByHandStandWhereTheyWereAsked(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swScene* scene = NULL;
    swWorld* world = NULL;
    assert_int_equal(ReadText("waves:\n  - components:" ONE_WAVE "    chop: 0\n", &scene), SW_SUCCESS);
    assert_int_equal(swCreateSceneWorld(&host, scene, &world), SW_SUCCESS);
    for (int i = 0; i < 50; ++i)
    {
        double height = swMoment_GetHeight(swWorld_GetMoment(world), (double)i, 17.0);
        assert_true(fabs(height - 0.5 * cos(2.0 * SW_PI * i / 50.0)) < 1e-4);
    }
    swDestroyWorld(world);
    swDestroyScene(scene);
}

// Three hours of two places, in two files that overlap; the second has a calm.
static const char s_places[] = "SWAN   1\nTIME\n1\nLONLAT\n2\n4.5 52.25\n5 52.5\nAFREQ\n3\n0.05\n0.1\n0.2\n"
                               "NDIR\n4\n0\n90\n180\n270\nQUANT\n1\nVaDens\nm2/Hz/degr\n-99\n"
                               "%s.0000\nFACTOR\n1e-4\n0 0 0 0\n%d 0 0 0\n0 0 0 0\n%s\n"
                               "%s.0000\nFACTOR\n1e-4\n0 0 0 0\n0 %d 0 0\n0 0 0 0\n%s\n";
#define OTHER_PLACE "FACTOR\n1e-4\n0 0 0 0\n0 0 0 9\n0 0 0 0"

static void WriteText(const char* path, const char* text)
{
    FILE* file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static void PlacesAndSeriesAreChosen(void** state)
{
    (void)state;
    char folder[] = "/tmp/seaway_scene_XXXXXX", first[64], second[64], text[2048];
    assert_non_null(mkdtemp(folder));
    snprintf(first, sizeof(first), "%s/one.spec", folder);
    snprintf(second, sizeof(second), "%s/two.spec", folder);
    snprintf(text, sizeof(text), s_places, "20240102.00", 100, OTHER_PLACE, "20240102.01", 400, OTHER_PLACE);
    WriteText(first, text);
    snprintf(text, sizeof(text), s_places, "20240102.02", 0, OTHER_PLACE, "20240102.03", 900, OTHER_PLACE);
    WriteText(second, text);

    swHost host = MakeHost();
    swScene* scene = NULL;
    static const char one[] = "waves:\n  - {spectrum: file, file: one.spec, location: 2, at: 2024-01-02 01:10}\n";
    if (swReadSceneText(&host, one, sizeof(one) - 1, "a.yaml", folder, &scene) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    swMeasuredRecord record = swMeasuredSea_GetRecord(scene->waves[0].measured, scene->waves[0].record);
    assert_int_equal(record.location, 1);
    assert_string_equal(record.time, "2024-01-02 01:00");
    swDestroyScene(scene);

    // The place nearest to a point, whichever way its longitude is counted.
    static const char near[] =
        "waves:\n  - {spectrum: file, file: one.spec, latitude: 52.45, longitude: 5.1, at: 2024-01-02 01:10}\n";
    host = MakeHost();
    assert_int_equal(swReadSceneText(&host, near, sizeof(near) - 1, "a.yaml", folder, &scene), SW_SUCCESS);
    assert_int_equal(swMeasuredSea_GetRecord(scene->waves[0].measured, scene->waves[0].record).location, 1);
    assert_non_null(strstr(s_messages, "place 2 at latitude 52.5000, longitude 5.0000 is taken, 8.8 km away"));
    swDestroyScene(scene);
    static const char* const far[] = {
        "waves:\n  - {spectrum: file, file: one.spec, latitude: 54, longitude: 5}\n",
        "waves:\n  - {spectrum: file, file: one.spec, latitude: 52, longitude: 5, location: 1}\n",
        "waves:\n  - {spectrum: file, file: one.spec, location: 1, at: 2025-01-02 01:10}\n"};
    static const char* const reasons[] = {"number 2 at 52.5000, 5.0000, 167 km away; at most 100 km",
                                          "location and latitude both choose a place", "run from 2024-01-02 00:00"};
    for (int i = 0; i < 3; ++i)
    {
        host = MakeHost();
        assert_int_equal(swReadSceneText(&host, far[i], strlen(far[i]), "a.yaml", folder, &scene), SW_ERROR_FORMAT);
        assert_non_null(strstr(s_messages, reasons[i]));
    }

    // Several places and none chosen.
    host = MakeHost();
    static const char none[] = "waves:\n  - spectrum: file\n    file: one.spec\n    replay: {}\n";
    assert_int_equal(swReadSceneText(&host, none, sizeof(none) - 1, "a.yaml", folder, &scene), SW_ERROR_FORMAT);
    assert_non_null(strstr(s_messages, "a.yaml:3: the file has 2 places; choose one of them with location, or with "
                                       "latitude and longitude: 1, 2."));

    // Two files, of which a calm is left out.
    host = MakeHost();
    static const char both[] =
        "time_s: 20\nwaves:\n  - spectrum: file\n    files: [two.spec, one.spec]\n    location: 1\n"
        "    replay: {from: 2024-01-02 00:30, time_s: 10, speed: 360}\n";
    if (swReadSceneText(&host, both, sizeof(both) - 1, "a.yaml", folder, &scene) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    assert_non_null(strstr(s_messages, "two.spec: 1 record without energy is left out"));
    const swSceneWaves* waves = &scene->waves[0];
    assert_int_equal(swMeasuredSea_GetCount(waves->measured), 3);
    assert_true(waves->isReplay && waves->replay.startTime == 10.0 && waves->replay.speed == 360.0 &&
                waves->replay.startSeconds == swMeasuredSea_GetRecord(waves->measured, 0).seconds + 1800.0);
    assert_int_equal(waves->record, 1); // 01:30 at the scene's time, half-way to 02:00 of which there is none
    remove(first);
    remove(second);
    rmdir(folder);

    swWorld* world = NULL;
    swSceneSea sea;
    assert_int_equal(swOpenScene(&host, scene, &world, &sea), SW_SUCCESS);
    static const double times[] = {5.0, 15.0, 45.0}; // the records themselves
    static const double energies[] = {100.0, 400.0, 900.0};
    for (int i = 0; i < 3; ++i)
    {
        swBandInfo bands[SW_MAX_BANDS];
        double variance = 0.0, wanted = energies[i] * 1e-4 * 90.0 * 0.075; // m^2/Hz/degree, degrees, Hz
        assert_int_equal(swSceneSea_Advance(&sea, times[i]), SW_SUCCESS);
        assert_int_equal(swWorld_StepTo(world, times[i]), SW_SUCCESS);
        int count = swWaveSystem_GetBands(world, sea.systems[0], bands);
        for (int j = 0; j < count; ++j)
        {
            variance += (double)bands[j].variance;
        }
        print_message("at %.0f s variance %.4f m^2, recorded %.4f\n", times[i], variance, wanted);
        assert_true(fabs(variance / wanted - 1.0) < 0.01);
    }
    swDestroySceneSea(&sea);
    swDestroyWorld(world);
    swDestroyScene(scene);
}

static void ShippedScenesMakeSeas(void** state)
{
    (void)state;
    static const char* const names[] = {"open_sea", "buoy", "gale", "two_swells", "shallow_tma"};
    for (int i = 0; i < 5; ++i)
    {
        swHost host = MakeHost();
        char path[512];
        snprintf(path, sizeof(path), SCENES "/%s.yaml", names[i]);
        swScene* scene = NULL;
        if (swReadScene(&host, path, &scene) != SW_SUCCESS)
        {
            fail_msg("%s", s_messages);
        }
        static const char* const views[] = {"deck",        "mast",        "hill",        "plane",
                                            "deck_sunset", "mast_sunset", "hill_sunset", "plane_sunset"};
        for (int j = 0; j < 8; ++j)
        {
            assert_non_null(swScene_FindView(scene, views[j]));
        }
        swWorld* world = NULL;
        assert_int_equal(swCreateSceneWorld(&host, scene, &world), SW_SUCCESS);

        // The deck stays dry for five minutes.
        double deck = swScene_FindView(scene, "deck")->position.y;
        double highest = -100.0;
        double square = 0.0;
        for (int j = 0; j < 300; ++j)
        {
            assert_int_equal(swWorld_Step(world, 1.0), SW_SUCCESS);
            double height = swMoment_GetHeight(swWorld_GetMoment(world), 0.0, 0.0);
            highest = fmax(highest, height);
            square += height * height / 300.0;
        }
        print_message("%s: Hs about %.1f m, highest crest %.1f m, deck at %.1f m\n", names[i], 4.0 * sqrt(square),
                      highest, deck);
        assert_true(highest < deck - 0.5);
        swDestroyWorld(world);
        swDestroyScene(scene);
    }
}

static void CopyPacked(const char* from, const char* to, bool isPacked)
{
    FILE* source = fopen(from, "rb");
    assert_non_null(source);
    char buffer[65536];
    size_t size = fread(buffer, 1, sizeof(buffer), source);
    fclose(source);
    gzFile target = gzopen(to, isPacked ? "wb" : "wbT");
    assert_int_equal(gzwrite(target, buffer, (unsigned)size), (int)size);
    gzclose(target);
}

static void PackedSetsAreFoundByTheirNames(void** state)
{
    (void)state;
    swHost host = MakeHost();
    char folder[] = "/tmp/seaway_scene_XXXXXX";
    assert_non_null(mkdtemp(folder));
    // As archives name them, some packed.
    static const char* const from[] = {"data_spec", "swdir", "swdir2", "swr1", "swr2"};
    static const char* const to[] = {"9w2024.txt.gz", "9d2024.txt", "9i2024.txt.gz", "9j2024.txt", "9k2024.txt.gz"};
    char paths[5][256];
    for (int i = 0; i < 5; ++i)
    {
        char source[512];
        snprintf(source, sizeof(source), SCENES "/data/harbour_storm.%s", from[i]);
        snprintf(paths[i], sizeof(paths[i]), "%s/%s", folder, to[i]);
        CopyPacked(source, paths[i], i % 2 == 0);
    }
    swMeasuredSea* packed = NULL;
    swMeasuredSea* plain = NULL;
    assert_int_equal(swReadMeasuredSea(&host, paths[0], &packed), SW_SUCCESS);
    assert_int_equal(swReadMeasuredSea(&host, SCENES "/data/harbour_storm.data_spec", &plain), SW_SUCCESS);
    swMeasuredRecord a = swMeasuredSea_GetRecord(packed, 1);
    swMeasuredRecord b = swMeasuredSea_GetRecord(plain, 1);
    assert_non_null(a.meanDirection);
    assert_memory_equal(a.table.density, b.table.density, 46 * (size_t)b.table.directionCount * sizeof(float));
    swDestroyMeasuredSea(packed);
    swDestroyMeasuredSea(plain);

    // Cut off in the middle.
    assert_int_equal(truncate(paths[0], 400), 0);
    assert_int_equal(swReadMeasuredSea(&host, paths[0], &packed), SW_ERROR_FILE);
    assert_non_null(strstr(s_messages, "Cannot read"));
    assert_int_equal(swReadMeasuredSea(&host, folder, &packed), SW_ERROR_FILE);
    for (int i = 0; i < 5; ++i)
    {
        remove(paths[i]);
    }
    rmdir(folder);
}

static void SummariesAreSeasToo(void** state)
{
    (void)state;
    swHost host = MakeHost();
    char folder[] = "/tmp/seaway_scene_XXXXXX";
    assert_non_null(mkdtemp(folder));
    char packedPath[256];
    snprintf(packedPath, sizeof(packedPath), "%s/storm.gz", folder); // known by its heading, not its name
    CopyPacked(SCENES "/data/harbour_storm.spec", packedPath, true);
    swMeasuredSea* packed = NULL;
    swMeasuredSea* plain = NULL;
    assert_int_equal(swReadMeasuredSea(&host, packedPath, &packed), SW_SUCCESS);
    assert_int_equal(swReadMeasuredSea(&host, SCENES "/data/harbour_storm.spec", &plain), SW_SUCCESS);
    remove(packedPath);
    rmdir(folder);
    assert_int_equal(swMeasuredSea_GetCount(packed), 3);
    swMeasuredRecord a = swMeasuredSea_GetRecord(packed, 1);
    swMeasuredRecord b = swMeasuredSea_GetRecord(plain, 1);
    assert_int_equal(a.partitionCount, 2);
    size_t size = (size_t)b.table.frequencyCount * (size_t)b.table.directionCount * sizeof(float);
    assert_memory_equal(a.table.density, b.table.density, size);
    swDestroyMeasuredSea(packed);
    swDestroyMeasuredSea(plain);

    static const char text[] =
        "waves:\n  - spectrum: file\n    file: data/harbour_storm.spec\n    at: 2024-11-16 05:50\n";
    swScene* scene = NULL;
    assert_int_equal(swReadSceneText(&host, text, sizeof(text) - 1, "a.yaml", SCENES, &scene), SW_SUCCESS);
    swSeaState seaState;
    assert_int_equal(swSpectrum_GetSeaState(&scene->waves[0].def.spectrum, 0.0f, 0.0f, &seaState), SW_SUCCESS);
    assert_true(IsNear((double)seaState.peakPeriod, 7.6));
    swDestroyScene(scene);
}

static void FailEachAllocation(const char* path)
{
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swScene* scene = NULL;
    assert_int_equal(swReadScene(&host, path, &scene), SW_SUCCESS);
    swDestroyScene(scene);
    assert_int_equal(atomic_load(&memory.bytes), 0);
    long long allocations = atomic_load(&memory.allocations);
    for (long long i = 0; i < allocations; ++i)
    {
        atomic_store(&memory.allocations, 0);
        atomic_store(&memory.failAt, i);
        assert_int_equal(swReadScene(&host, path, &scene), SW_ERROR_NO_MEMORY);
        assert_null(scene);
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
    print_message("%s: %lld allocations, each failed once\n", path, allocations);
}

static void FailingMemoryLeavesNothingBehind(void** state)
{
    (void)state;
    FailEachAllocation(SCENES "/buoy.yaml");
    FailEachAllocation(SCENES "/crossing.yaml");
    FailEachAllocation(SCENES "/hindcast.yaml");
    FailEachAllocation(SCENES "/whirlpool.yaml");
    FailEachAllocation(SCENES "/dioramas/varying_level.yaml");
    FailEachAllocation(SCENES "/dioramas/river.yaml");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryKeyReachesItsField),
        cmocka_unit_test(WhatIsLeftOutKeepsItsDefault),
        cmocka_unit_test(WrongScenesAreNamedWithTheirLine),
        cmocka_unit_test(ShippedScenesMakeSeas),
        cmocka_unit_test(EverySpectrumCanBeWritten),
        cmocka_unit_test(FewWavesComeFromSpectraOrByHand),
        cmocka_unit_test(WavesByHandStandWhereTheyWereAsked),
        cmocka_unit_test(PlacesAndSeriesAreChosen),
        cmocka_unit_test(PackedSetsAreFoundByTheirNames),
        cmocka_unit_test(SummariesAreSeasToo),
        cmocka_unit_test(FailingMemoryLeavesNothingBehind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
