// SPDX-License-Identifier: MIT

#include "scene/scene_fields.h"

#include <math.h>

#include "core/base/field.h"
#include "scene/scene_inputs.h"
#include "scene/yaml_read.h"
#include "seaway/math.h"

#define DEGREES(degrees) ((degrees) * (SW_PI / 180.0))

// Beyond any sea, yet far from where doubles lose millimetres.
#define FAR 1e9

// ---- the file ----

#define SW_DEF swScene
static const swField sceneFields[] = {
    SW_TEXT(name, .key = "name", .label = "name"),
    SW_NUMBER(time, "s", SW_WITHIN(-SW_LARGEST_TIME, SW_LARGEST_TIME), 0.0, .key = "time_s", .label = "time",
              .tip = "Of the world when the scene begins", SW_KNOB(0.0, 3600.0)),
    SW_NUMBER(exposureEv, "EV", SW_WITHIN(-20.0, 20.0), 0.0, .key = "exposure_ev", .label = "exposure",
              .tip = "Stops beside the automatic exposure", SW_KNOB(-6.0, 6.0)),
};
#undef SW_DEF

static const swFields scene = SW_PART_FIELDS(swScene, "scene", "scene", sceneFields);

const swFields* swGetSceneFields(void)
{
    return &scene;
}

#define SW_DEF swSceneView
static const swField viewFields[] = {
    SW_TEXT(name, .key = "name", .label = "name"),
    SW_NUMBERS(position, double, "m", SW_WITHIN(-FAR, FAR), SW_EACH(0.0, 20.0, 0.0), .key = "position_m",
               .label = "position", .tip = "x, height above the sea level, z", SW_KNOB(-1000.0, 1000.0)),
    SW_NUMBER(heading, "deg", SW_WITHIN(DEGREES(-360.0), DEGREES(360.0)), 0.0, .key = "heading_deg", .label = "heading",
              .tip = "Clockwise from north", .form = SW_FORM_DEGREES, SW_KNOB(0.0, 360.0)),
    SW_NUMBER(pitch, "deg", SW_WITHIN(DEGREES(-90.0), DEGREES(90.0)), 0.0, .key = "pitch_deg", .label = "pitch",
              .tip = "Up is positive", .form = SW_FORM_DEGREES, SW_KNOB(-90.0, 90.0)),
    SW_NUMBER(roll, "deg", SW_WITHIN(DEGREES(-180.0), DEGREES(180.0)), 0.0, .key = "roll_deg", .label = "roll",
              .form = SW_FORM_DEGREES, SW_KNOB(-180.0, 180.0)),
    SW_NUMBER(verticalFov, "deg", SW_WITHIN(DEGREES(1.0), DEGREES(150.0)), DEGREES(50.0), .key = "fov_deg",
              .label = "field of view", .tip = "Vertical", .form = SW_FORM_DEGREES, SW_KNOB(5.0, 120.0)),
    SW_SWITCH(hasSun, false, .key = NULL, .label = "own sun", .tip = "Instead of the scene's"),
    SW_NUMBER(sunAzimuth, "deg", SW_WITHIN(DEGREES(-360.0), DEGREES(360.0)), 0.0, .key = "sun_azimuth_deg",
              .label = "sun from", .tip = "Clockwise from north", .form = SW_FORM_DEGREES, SW_KNOB(0.0, 360.0)),
    SW_NUMBER(sunElevation, "deg", SW_WITHIN(DEGREES(-90.0), DEGREES(90.0)), 0.0, .key = "sun_elevation_deg",
              .label = "sun above", .form = SW_FORM_DEGREES, SW_KNOB(-10.0, 90.0)),
};
#undef SW_DEF

static const swFields view = SW_PART_FIELDS(swSceneView, "views", "view", viewFields);

const swFields* swGetSceneViewFields(void)
{
    return &view;
}

// ---- inputs ----

static const char* const coordinateWords[] = {"by_file", "metres", "degrees", NULL};

static const char* const numberWords[] = {"float32", "int16", "uint16", NULL};

#define SW_DEF swSceneRaster
static const swField rasterFields[] = {
    SW_TEXT(name, .key = "name", .label = "name"),
    SW_TEXT(file, .key = "file", .label = "file", .tip = "Relative to the scene file"),
    SW_TEXT(madeFrom, .key = "made_from", .label = "made from",
            .tip = "The scene whose floor was baked into the file; `seaway check` tells when it is stale"),
    SW_SWITCH(isOptional, false, .key = "is_optional", .label = "optional",
              .tip = "If the file is not there, inputs that name it are left out, with a warning"),
    SW_TEXT(variable, .key = "variable", .label = "variable", .tip = "Of netCDF; the channel of an image"),
    SW_NUMBER(frames, "", SW_WITHIN(1.0, 65536.0), 1.0, .key = "frames", .label = "frames",
              .tip = "Lattices of the same size that stand below each other in the file, to be played"),
    SW_CHOICE(def.coordinates, coordinateWords, coordinateWords, SW_RASTER_BY_FILE, .key = "coordinates",
              .label = "coordinates", .tip = "What the file's are"),
    SW_NUMBER(def.originEast, "", SW_WITHIN(-1e9, 1e9), (double)NAN, .key = "origin_east", .label = "origin east",
              .tip = "The file's easting or longitude that is the world's x = 0"),
    SW_NUMBER(def.originNorth, "", SW_WITHIN(-1e9, 1e9), (double)NAN, .key = "origin_north", .label = "origin north",
              .tip = "The file's northing or latitude that is the world's z = 0"),
    SW_NUMBER(def.west, "m", SW_WITHIN(-1e9, 1e9), -(double)INFINITY, .key = "west_m", .label = "west",
              .tip = "Cells outside of these metres of the world are left out"),
    SW_NUMBER(def.east, "m", SW_WITHIN(-1e9, 1e9), (double)INFINITY, .key = "east_m", .label = "east"),
    SW_NUMBER(def.north, "m", SW_WITHIN(-1e9, 1e9), -(double)INFINITY, .key = "north_m", .label = "north"),
    SW_NUMBER(def.south, "m", SW_WITHIN(-1e9, 1e9), (double)INFINITY, .key = "south_m", .label = "south"),
    SW_SWITCH(def.isDepth, false, .key = "is_depth", .label = "depths", .tip = "The numbers count downwards"),
    SW_NUMBER(def.offset, "m", SW_WITHIN(-1e6, 1e6), 0.0, .key = "offset_m", .label = "offset",
              .tip = "A number n of the file is offset plus scale times n"),
    SW_NUMBER(def.scale, "m", SW_WITHIN(-1e6, 1e6), 1.0, .key = "scale_m", .label = "scale"),
    SW_NUMBER(def.missing, "", SW_WITHIN(-3.5e38, 3.5e38), (double)NAN, .key = "missing", .label = "missing",
              .tip = "The number by which the file means that nothing is known"),
    SW_NUMBER(def.spacingEast, "", SW_ABOVE(0.0, 1e6), (double)NAN, .key = "spacing_east", .label = "spacing east",
              .tip = "Of images and files without a heading, in the file's coordinates"),
    SW_NUMBER(def.spacingNorth, "", SW_ABOVE(0.0, 1e6), (double)NAN, .key = "spacing_north", .label = "spacing north"),
    SW_NUMBER(def.imageEast, "", SW_WITHIN(-1e9, 1e9), (double)NAN, .key = "image_east", .label = "first cell east",
              .tip = "Where the middle of the north-western cell lies"),
    SW_NUMBER(def.imageNorth, "", SW_WITHIN(-1e9, 1e9), (double)NAN, .key = "image_north", .label = "first cell north"),
    SW_NUMBER(def.rawWidth, "", SW_WITHIN(0.0, 16384.0), 0.0, .key = "raw_width", .label = "raw width",
              .tip = "Numbers along a row of a file without a heading", .zero = "a file with a heading"),
    SW_NUMBER(def.rawHeight, "", SW_WITHIN(0.0, 16384.0), 0.0, .key = "raw_height", .label = "raw height"),
    SW_CHOICE(def.numbers, numberWords, numberWords, SW_RASTER_FLOAT32, .key = "numbers", .label = "numbers",
              .tip = "Of a file without a heading"),
};
#undef SW_DEF

static const swFields raster = SW_PART_FIELDS(swSceneRaster, "rasters", "raster", rasterFields);

const swFields* swGetSceneRasterFields(void)
{
    return &raster;
}

static const char* const upWords[] = {"y", "z", NULL};

#define SW_DEF swSceneMesh
static const swField meshFields[] = {
    SW_TEXT(name, .key = "name", .label = "name"),
    SW_TEXT(file, .key = "file", .label = "file", .tip = "Relative to the scene file"),
    SW_CHOICE(def.up, upWords, upWords, SW_MESH_Y_UP, .key = "up", .label = "up",
              .tip = "The file's axis that points up"),
    SW_NUMBER(def.scale, "m", SW_WITHIN(1e-6, 1e6), 1.0, .key = "scale_m", .label = "scale",
              .tip = "Metres of one of the file's lengths"),
    SW_NUMBER(def.highest, "m", SW_WITHIN(-1e6, 1e6), 1e6, .key = "highest_m", .label = "highest",
              .tip = "What lies above is left out"),
};
#undef SW_DEF

static const swFields mesh = SW_PART_FIELDS(swSceneMesh, "meshes", "mesh", meshFields);

const swFields* swGetSceneMeshFields(void)
{
    return &mesh;
}

#define SW_DEF swSceneHull
static const swField hullFields[] = {
    SW_TEXT(name, .key = "name", .label = "name"),
    SW_TEXT(file, .key = "file", .label = "file", .tip = "Relative to the scene file"),
    SW_CHOICE(def.up, upWords, upWords, SW_MESH_Y_UP, .key = "up", .label = "up",
              .tip = "The file's axis that points up"),
    SW_NUMBER(def.scale, "m", SW_WITHIN(1e-6, 1e6), 1.0, .key = "scale_m", .label = "scale",
              .tip = "Metres of one of the file's lengths"),
    SW_NUMBER(resolution, "", SW_WITHIN(8.0, 256.0), 64.0, .key = "resolution", .label = "resolution",
              .tip = "Spacings of its grid of distances along its longest side"),
};
#undef SW_DEF

static const swFields hull = SW_PART_FIELDS(swSceneHull, "hulls", "hull", hullFields);

const swFields* swGetSceneHullFields(void)
{
    return &hull;
}

#define SW_DEF swInputPoint
static const swField pointFields[] = {
    SW_NUMBER(x, "m", SW_WITHIN(-1e6, 1e6), 0.0, .key = "x_m", .label = "x"),
    SW_NUMBER(z, "m", SW_WITHIN(-1e6, 1e6), 0.0, .key = "z_m", .label = "z"),
    SW_NUMBER(radius, "m", SW_WITHIN(0.0, 1e6), 0.0, .key = "radius_m", .label = "radius",
              .tip = "Of a particle, or half the width of a polyline", .zero = "half the input's size"),
    SW_NUMBER(weight, "", SW_WITHIN(0.0, 100.0), 1.0, .key = "weight", .label = "weight"),
};
#undef SW_DEF

static const swFields point = SW_PART_FIELDS(swInputPoint, "points", "point", pointFields);

const swFields* swGetInputPointFields(void)
{
    return &point;
}

// ---- waves ----

static const char* const startWords[] = {"default", "swell", "pierson_moskowitz", "jonswap", NULL};
static const char* const directionWords[] = {"from", "to", NULL};

#define SW_DEF swWavesText
static const swField wavesFields[] = {
    SW_NUMBER(beaufort, "", SW_WITHIN(0.0, 12.0), 0.0, .key = "beaufort", .label = "Beaufort",
              .tip = "The sea of that number, which may lie between two"),
    SW_NUMBER(seaState, "", SW_WITHIN(0.0, 9.0), 0.0, .key = "sea_state", .label = "sea state",
              .tip = "The sea of that state (Douglas's), which may lie between two"),
    SW_NUMBER(durationHours, "h", SW_WITHIN(0.1, 1000.0), 0.0, .key = "duration_h", .label = "duration",
              .tip = "For how long the wind has blown"),
    SW_NUMBER(spread, "deg", SW_WITHIN(DEGREES(6.0), DEGREES(80.0)), 0.157, .key = "spread_deg", .label = "spread",
              .tip = "Standard deviation of the directions", .form = SW_FORM_DEGREES),
    SW_NUMBER(def.spectrum.direction, "deg", SW_WITHIN(DEGREES(-360.0), DEGREES(360.0)), 0.0, .key = "turn_deg",
              .label = "turned by", .tip = "Turns the measured sea clockwise", .form = SW_FORM_DEGREES),
    SW_CHOICE(octaves.start, startWords, startWords, 0, .key = "octaves_from", .label = "octaves from",
              .tip = "What the equaliser starts from; the last two take the wind"),
};
#undef SW_DEF

static const swFields waves = SW_PART_FIELDS(swWavesText, "waves", "waves", wavesFields);

const swFields* swGetWavesTextFields(void)
{
    return &waves;
}

#define SW_DEF swMeasuredText
static const swField measuredFields[] = {
    SW_TEXT(file, .key = "file", .label = "file", .tip = "Relative to the scene file"),
    SW_TEXT(location, .key = "location", .label = "place", .tip = "Its name, or its number from 1 on"),
    SW_NUMBER(latitude, "deg", SW_WITHIN(-90.0, 90.0), 0.0, .key = "latitude", .label = "latitude"),
    SW_NUMBER(longitude, "deg", SW_WITHIN(-180.0, 360.0), 0.0, .key = "longitude", .label = "longitude"),
    SW_CHOICE(directions, directionWords, directionWords, 0, .key = "directions", .label = "directions",
              .tip = "What those in a netCDF file mean: where waves come from, or where they go"),
    SW_TEXT(at, .key = "at", .label = "at", .tip = "Time of the wanted record, UTC"),
    SW_TEXT(from, .key = "from", .section = "replay", .label = "from", .tip = "UTC time whose sea stands at time_s"),
    SW_NUMBER(replayTime, "s", SW_WITHIN(-SW_LARGEST_TIME, SW_LARGEST_TIME), 0.0, .key = "time_s", .section = "replay",
              .label = "time", .tip = "Of the world"),
    SW_NUMBER(replaySpeed, "", SW_WITHIN(-1e6, 1e6), 1.0, .key = "speed", .section = "replay", .label = "speed",
              .tip = "Seconds of records in a second of the world"),
};
#undef SW_DEF

static const swFields measured = SW_PART_FIELDS(swMeasuredText, "waves", "measured sea", measuredFields);

const swFields* swGetMeasuredTextFields(void)
{
    return &measured;
}

#define SW_DEF swOctaveText
static const swField octaveFields[] = {
    SW_NUMBER(wavelength, "m", SW_WITHIN(0.0625, 512.0), 0.0625, .key = "wavelength_m", .label = "shortest wave"),
};
#undef SW_DEF

static const swFields octave = SW_PART_FIELDS(swOctaveText, "octaves", "octave", octaveFields);

const swFields* swGetOctaveTextFields(void)
{
    return &octave;
}

const char* swGetWavesWord(int kind)
{
    static const char* const others[] = {"wind_sea", "swell", "beaufort", "sea_state", "components"};
    const swField* field = swFields_Find(swGetSpectrumFields(), "kind");
    return kind < 0 || kind >= SW_WAVES_KIND_COUNT ? NULL
           : kind < SW_SPECTRUM_KIND_COUNT         ? field->words[kind]
                                                   : others[kind - SW_SPECTRUM_KIND_COUNT];
}
