// SPDX-License-Identifier: MIT
#include "core/input/input_def.h"

#include <math.h>
#include <stdio.h>

#include "core/input/input_record.h"
#include "core/input/mesh.h"
#include "core/input/polygon.h"
#include "core/input/raster.h"
#include "core/input/spline.h"
#include "core/input/tide.h"
#include "seaway/water_body.h"
#include "shared/input.h"

static const char* const fieldWords[] = {"floor", "level",  "flow", "waves",  "displacement", "clip",
                                         "foam",  "albedo", "wind", "shadow", "body",         NULL};
static const char* const fieldNames[] = {"sea floor", "water level", "flow", "waves",  "displacement",  "clip",
                                         "foam",      "colour",      "wind", "shadow", "body of water", NULL};
static const char* const shapeWords[] = {"everywhere", "circle",  "rectangle", "polygon",  "polyline", "spline",
                                         "mesh",       "raster",  "particles", "function", "box",      "ellipsoid",
                                         "cylinder",   "capsule", "hull",      NULL};
static const char* const shapeNames[] = {"the whole sea", "circle",  "rectangle", "polygon",  "polyline", "spline",
                                         "mesh",          "raster",  "particles", "function", "box",      "ellipsoid",
                                         "cylinder",      "capsule", "hull",      NULL};
static const char* const blendWords[] = {"add", "alpha", "multiply", "min", "max", "replace", NULL};
static const char* const blendNames[] = {"added", "mixed", "multiplied", "the lesser", "the greater", "replaced", NULL};

#define VALUES                                                                                                         \
    (SW_KIND(SW_SHAPE_RASTER) | SW_KIND(SW_SHAPE_SPLINE) | SW_KIND(SW_SHAPE_MESH) | SW_KIND(SW_SHAPE_FUNCTION))
#define PLACED (~SW_KIND(SW_SHAPE_EVERYWHERE))
#define SIZED                                                                                                          \
    (SW_KIND(SW_SHAPE_CIRCLE) | SW_KIND(SW_SHAPE_RECTANGLE) | SW_KIND(SW_SHAPE_POLYLINE) |                             \
     SW_KIND(SW_SHAPE_PARTICLES) | SW_KIND(SW_SHAPE_FUNCTION) | SW_KIND(SW_SHAPE_BOX) | SW_KIND(SW_SHAPE_ELLIPSOID) |  \
     SW_KIND(SW_SHAPE_CYLINDER) | SW_KIND(SW_SHAPE_CAPSULE))

#define SW_DEF swWindWeight
static const swField windWeightFields[] = {
    SW_SWITCH(isUsed, false, .key = "is_wind", .label = "is a wind"),
    SW_NUMBER(heading, "deg", SW_WITHIN(-1000.0, 1000.0), 0.0, .key = "wind_from_deg", .label = "of a wind from",
              .form = SW_FORM_BEARING, SW_KNOB(0.0, 360.0)),
    SW_NUMBER(headingStep, "deg", SW_WITHIN(0.01, 1.5707964), 0.5235988, .key = "heading_step_deg",
              .label = "to the next", .form = SW_FORM_DEGREES, SW_KNOB(10.0, 90.0)),
    SW_NUMBER(speed, "m/s", SW_WITHIN(0.1, 100.0), 10.0, .key = "wind_speed_mps", .label = "of a wind of",
              SW_KNOB(1.0, 40.0)),
    SW_NUMBER(speedBelow, "m/s", SW_WITHIN(0.0, 100.0), 0.0, .key = "weaker_mps", .label = "next weaker wind",
              .zero = "none", SW_KNOB(0.0, 40.0)),
    SW_NUMBER(speedAbove, "m/s", SW_WITHIN(0.0, 100.0), 0.0, .key = "stronger_mps", .label = "next stronger wind",
              .zero = "none", SW_KNOB(0.0, 40.0)),
    SW_NUMBER(heightBelow, "", SW_WITHIN(0.0, 1000.0), 1.0, .key = "weaker_height", .label = "heights below",
              SW_KNOB(0.0, 4.0)),
    SW_NUMBER(heightAbove, "", SW_WITHIN(0.0, 1000.0), 1.0, .key = "stronger_height", .label = "heights above",
              SW_KNOB(0.0, 4.0)),
};
#undef SW_DEF

static const swFields windWeightFieldTable = SW_PART_FIELDS(swWindWeight, "inputs", "of a wind", windWeightFields);

#define SW_DEF swInputDef
static const swField inputFields[] = {
    SW_TEXT(name, .key = "name", .label = "name", .use = SW_USE_STATE),
    SW_CHOICE(field, fieldWords, fieldNames, SW_INPUT_FLOOR, .key = "field", .label = "says"),
    SW_CHOICE(shape, shapeWords, shapeNames, SW_SHAPE_EVERYWHERE, .key = "shape", .label = "shape"),
    SW_CHOICE(blend, blendWords, blendNames, SW_BLEND_ALPHA, .key = "blend", .label = "joins",
              .tip = "How it joins the inputs of the same field below it"),
    SW_NUMBER(order, "", SW_WITHIN(-1e6, 1e6), 0.0, .key = "order", .label = "order",
              .tip = "Inputs of a field join in this order; equal ones as they were made", SW_KNOB(-100.0, 100.0)),
    SW_SWITCH(isEnabled, true, .key = "is_enabled", .label = "enabled"),
    SW_NUMBER(weight, "", SW_WITHIN(0.0, 100.0), 1.0, .key = "weight", .label = "weight",
              .tip = "Factor on how much it counts; beyond 1 only to add", SW_KNOB(0.0, 1.0)),
    SW_NUMBERS(value, float, "", SW_WITHIN(-1e6, 1e6), SW_EACH(0.0, 0.0, 0.0, 0.0), .key = "value", .label = "value",
               SW_KNOB(-100.0, 100.0)),
    SW_NUMBER(gain, "", SW_WITHIN(-1e6, 1e6), 1.0, .key = "gain", .label = "gain",
              .tip = "Factor on the values that the shape brings", SW_KNOB(-10.0, 10.0), .kinds = VALUES),
    SW_NUMBER(feather, "m", SW_WITHIN(0.0, 1e6), 0.0, .key = "feather_m", .label = "feather",
              .tip = "How far inwards from its edge it grows to its full share", SW_LOG_KNOB(0.1, 1e4),
              .kinds = PLACED),
    SW_NUMBERS(position, double, "m", SW_WITHIN(-1e9, 1e9), SW_EACH(0.0, 0.0, 0.0), .key = "position_m",
               .label = "place", SW_KNOB(-1000.0, 1000.0), .kinds = PLACED),
    SW_NUMBERS(rotation, float, "deg", SW_WITHIN(-1000.0, 1000.0), SW_EACH(0.0, 0.0, 0.0), .key = "rotation_deg",
               .label = "turned", .tip = "Yaw, pitch and roll", .form = SW_FORM_DEGREES, SW_KNOB(-180.0, 180.0),
               .kinds = PLACED),
    SW_NUMBERS(size, float, "m", SW_WITHIN(0.0, 1e6), SW_EACH(100.0, 10.0, 100.0), .key = "size_m", .label = "size",
               SW_KNOB(0.0, 1000.0), .kinds = SIZED),
    SW_PARTS(tide, &swTideConstituentFields, .key = "tide", .label = "tide",
             .tip = "Of a level or a flow: harmonics that are added to the value"),
    SW_SWITCH(followsWaves, false, .key = "follows_waves", .label = "follows waves"),
    SW_NUMBER(wavelength, "m", SW_WITHIN(0.0, 1e6), 0.0, .key = "wavelength_m", .label = "like waves of",
              .tip = "Of displacement: what has longer waves only leaves it out", .zero = "any",
              SW_LOG_KNOB(0.1, 1000.0)),
    SW_SWITCH(isBump, false, .key = "is_bump", .label = "a bump", .tip = "Falls from the middle as a wave particle"),
    SW_GIVEN(system, .key = NULL, .label = "wave system"),
    SW_SWITCH(removesWaves, false, .key = "removes_waves", .label = "removes waves",
              .tip = "Takes away the waves of all systems below it by its share"),
    SW_PART(windWeight, &windWeightFieldTable, .key = NULL, .label = "of a wind"),
    SW_GIVEN(raster, .key = NULL, .label = "raster"),
    SW_NUMBER(framesPerSecond, "1/s", SW_WITHIN(0.0, 1000.0), 0.0, .key = "frames_per_s", .label = "frames a second",
              .zero = "stands", SW_KNOB(0.0, 60.0), .kinds = SW_KIND(SW_SHAPE_RASTER)),
    SW_NUMBER(startTime, "s", SW_WITHIN(-SW_LARGEST_TIME, SW_LARGEST_TIME), 0.0, .key = "start_s", .label = "starts",
              SW_KNOB(0.0, 3600.0), .kinds = SW_KIND(SW_SHAPE_RASTER)),
    SW_SWITCH(loops, true, .key = "loops", .label = "loops", .kinds = SW_KIND(SW_SHAPE_RASTER)),
    SW_GIVEN(mesh, .key = NULL, .label = "mesh"),
    SW_GIVEN(hull, .key = NULL, .label = "hull"),
    SW_NUMBERS(scale, float, "", SW_ABOVE(0.0, 1e4), SW_EACH(1.0, 1.0, 1.0), .key = "scale", .label = "scale",
               SW_LOG_KNOB(0.01, 100.0), .kinds = SW_KIND(SW_SHAPE_HULL)),
    SW_NUMBER(rounding, "m", SW_WITHIN(0.0, 1e6), 0.0, .key = "rounding_m", .label = "rounded by", SW_KNOB(0.0, 10.0),
              .kinds = SW_KIND(SW_SHAPE_BOX) | SW_KIND(SW_SHAPE_CYLINDER)),
    SW_GIVEN(spline, .key = NULL, .label = "spline"),
    SW_SWITCH(alongSpline, false, .key = "along_spline", .label = "along the spline", .tip = "Waves turn with the line",
              .kinds = SW_KIND(SW_SHAPE_SPLINE)),
    SW_NUMBER(heading, "deg", SW_WITHIN(-1000.0, 1000.0), 0.0, .key = "heading_deg", .label = "heading",
              .tip = "0 goes across the line from right to left, 90 along it", .form = SW_FORM_DEGREES,
              SW_KNOB(-180.0, 180.0), .kinds = SW_KIND(SW_SHAPE_SPLINE)),
    SW_GIVEN(points, .key = NULL, .label = "points"),
    SW_GIVEN(pointCount, .key = NULL, .label = "number of points"),
    SW_NUMBER(pointCapacity, "", SW_WITHIN(0.0, SW_MAX_INPUT_POINTS), 0.0, .key = NULL, .label = "room for points",
              .use = SW_USE_STATE),
    SW_GIVEN(function, .key = NULL, .label = "function"),
    SW_GIVEN(functionContext, .key = NULL, .label = "function's context"),
    SW_GIVEN(functionFingerprint, .key = NULL, .label = "function's fingerprint"),
};
#undef SW_DEF

const swFields swInputFields = SW_FIELDS(swInputDef, "inputs", "input", inputFields, 2);

const swFields* swGetInputFields(void)
{
    return &swInputFields;
}

int swInputField_CountNumbers(swInputField field)
{
    return (int)swCountInputNumbers((sw_uint)field);
}

swInputDef swDefaultInputDef(void)
{
    swInputDef def;
    swFillDef(&swInputFields, &def);
    return def;
}

const char* swGetInputFieldWord(int field)
{
    return (unsigned)field < SW_INPUT_FIELD_COUNT ? fieldWords[field] : "unknown";
}

const char* swGetInputShapeWord(int shape)
{
    return (unsigned)shape < SW_SHAPE_COUNT ? shapeWords[shape] : "unknown";
}

// ---- what the table cannot say ----

// Shapes that can be made. A shape that is added is added here.
static const uint32_t knownShapes =
    SW_KIND(SW_SHAPE_EVERYWHERE) | SW_KIND(SW_SHAPE_CIRCLE) | SW_KIND(SW_SHAPE_RECTANGLE) | SW_KIND(SW_SHAPE_POLYGON) |
    SW_KIND(SW_SHAPE_RASTER) | SW_KIND(SW_SHAPE_BOX) | SW_KIND(SW_SHAPE_ELLIPSOID) | SW_KIND(SW_SHAPE_CYLINDER) |
    SW_KIND(SW_SHAPE_CAPSULE) | SW_KIND(SW_SHAPE_HULL) | SW_KIND(SW_SHAPE_SPLINE) | SW_KIND(SW_SHAPE_PARTICLES) |
    SW_KIND(SW_SHAPE_FUNCTION) | SW_KIND(SW_SHAPE_POLYLINE) | SW_KIND(SW_SHAPE_MESH);

// Shapes with a height: of clip alone.
#define SOLID                                                                                                          \
    (SW_KIND(SW_SHAPE_BOX) | SW_KIND(SW_SHAPE_ELLIPSOID) | SW_KIND(SW_SHAPE_CYLINDER) | SW_KIND(SW_SHAPE_CAPSULE) |    \
     SW_KIND(SW_SHAPE_HULL))

static swResult refuse(const swHost* host, swResult result, const swInputDef* def, const char* what)
{
    bool isNamed = def->name[0] != '\0';
    return swFail(host, result, "the input%s%s%s (%s of the %s) %s", isNamed ? " '" : "", isNamed ? def->name : "",
                  isNamed ? "'" : "", swGetInputShapeWord((int)def->shape), swGetInputFieldWord((int)def->field), what);
}

static swResult checkKinds(const swHost* host, const swInputDef* def)
{
    uint32_t shape = SW_KIND(def->shape);
    if ((shape & knownShapes) == 0)
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def, "has a shape that this version cannot make");
    }
    if ((shape & SOLID) != 0 && def->field != SW_INPUT_CLIP)
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def,
                      "has a height, which only clip looks at; give it a circle, a rectangle, a polygon or a mesh");
    }
    if (def->field == SW_INPUT_FLOOR && def->blend == SW_BLEND_MULTIPLY)
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def,
                      "multiplies heights, which depends on where they count from; add, mix, or take the lesser or "
                      "the greater");
    }
    if (def->field == SW_INPUT_BODY && def->blend != SW_BLEND_REPLACE)
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def,
                      "mixes numbers of bodies, which mean nothing in between; its blend must be SW_BLEND_REPLACE");
    }
    bool isMixed = SW_KIND(def->shape) & (SW_KIND(SW_SHAPE_RASTER) | SW_KIND(SW_SHAPE_MESH));
    if (def->field == SW_INPUT_BODY && isMixed)
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def,
                      "would mix numbers of bodies between its corners; give each body a polygon or another shape with "
                      "one value");
    }
    bool canFollow =
        def->field == SW_INPUT_ALBEDO || def->field == SW_INPUT_FOAM || def->field == SW_INPUT_DISPLACEMENT;
    if (def->followsWaves && !canFollow)
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def, "follows waves, which only colour, foam and displacement can");
    }
    bool isDisplacing = def->field == SW_INPUT_DISPLACEMENT;
    if (def->wavelength > 0.0f && !isDisplacing)
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def, "is like waves of a length, which only displacement can be");
    }
    if (def->isBump && def->shape != SW_SHAPE_CIRCLE && def->shape != SW_SHAPE_PARTICLES)
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def, "is a bump, which only circles and particles can be");
    }
    bool isOfWaves = def->field == SW_INPUT_WAVES;
    if ((def->removesWaves && !isOfWaves) || (def->windWeight.isUsed && !(isOfWaves && def->shape == SW_SHAPE_RASTER)))
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def,
                      def->removesWaves ? "removes waves, which only inputs of waves can"
                                        : "weighs waves by a wind, which only rasters of waves can");
    }
    return SW_SUCCESS;
}

static bool isSpeed(const swInputDef* def)
{
    return def->field == SW_INPUT_FLOW || def->field == SW_INPUT_WIND || def->windWeight.isUsed;
}

// What the shape brings of its own, at most, m/s either way.
static float findBroughtSpeed(const swInputDef* def)
{
    float most = 0.0f;
    if (def->shape == SW_SHAPE_RASTER && def->raster != NULL && def->raster->least <= def->raster->most)
    {
        most = fmaxf(fabsf(def->raster->least), fabsf(def->raster->most));
    }
    else if (def->shape == SW_SHAPE_MESH && def->mesh != NULL)
    {
        most = def->mesh->largest;
    }
    else if (def->shape == SW_SHAPE_SPLINE && def->spline != NULL && def->field == SW_INPUT_FLOW)
    {
        most = swGetFastestSplineFlow(def->spline);
    }
    return most * fabsf(def->gain);
}

// A weight above 1 makes it faster; that of waves by the wind does not.
static swResult checkSpeed(const swHost* host, const swInputDef* def)
{
    float given = fmaxf(fabsf(def->value[0]), fabsf(def->value[1]));
    float factor = def->windWeight.isUsed ? 1.0f : fmaxf(def->weight, 1.0f);
    float most = (given + findBroughtSpeed(def)) * factor;
    if (!(given <= SW_MAX_INPUT_SPEED))
    {
        return refuse(host, SW_ERROR_INVALID, def,
                      "has a speed beyond 100 m/s, which no water and no wind has; give swInputDef::value in m/s");
    }
    if (!(most <= SW_MAX_INPUT_SPEED))
    {
        return swFail(host, SW_ERROR_INVALID,
                      "the input '%s' says %s of up to %g m/s, by what its shape brings, its value, gain and weight "
                      "together; at most %g is taken",
                      def->name, swGetInputFieldWord((int)def->field), (double)most, (double)SW_MAX_INPUT_SPEED);
    }
    return SW_SUCCESS;
}

static swResult checkValues(const swHost* host, const swInputDef* def)
{
    swResult result = isSpeed(def) ? checkSpeed(host, def) : SW_SUCCESS;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    float number = def->value[0];
    if (def->field == SW_INPUT_BODY && !(number == floorf(number) && number >= -1.0f && number < SW_MAX_WATER_BODIES))
    {
        return refuse(host, SW_ERROR_INVALID, def,
                      "has a number that no body of water has; they are whole, from 0 on, and -1 is none");
    }
    bool staysPut = def->field == SW_INPUT_DISPLACEMENT && !def->followsWaves;
    if (staysPut && (def->value[0] != 0.0f || def->value[2] != 0.0f))
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def,
                      "moves water sideways from where it stays put; set followsWaves, or let value x and z be 0");
    }
    if (def->weight > 1.0f && def->blend != SW_BLEND_ADD)
    {
        return refuse(host, SW_ERROR_INVALID, def,
                      "has a weight above 1, which only SW_BLEND_ADD can use; a mix is at most 1");
    }
    const swWindWeight* wind = &def->windWeight;
    if (wind->isUsed && ((wind->speedBelow > 0.0f && wind->speedBelow >= wind->speed) ||
                         (wind->speedAbove > 0.0f && wind->speedAbove <= wind->speed)))
    {
        return refuse(
            host, SW_ERROR_INVALID, def,
            "has speeds of winds that do not ascend; swWindWeight::speedBelow must be below speed, speedAbove "
            "above it");
    }
    uint32_t shape = SW_KIND(def->shape);
    uint32_t round = SW_KIND(SW_SHAPE_CIRCLE) | SW_KIND(SW_SHAPE_CAPSULE);
    uint32_t tall = SOLID & ~SW_KIND(SW_SHAPE_HULL);
    bool isThin = (shape & (round | tall | SW_KIND(SW_SHAPE_RECTANGLE))) != 0 && def->size.x <= 0.0f;
    isThin = isThin || ((shape & tall) != 0 && def->size.y <= 0.0f);
    isThin = isThin || ((shape & ((tall & ~round) | SW_KIND(SW_SHAPE_RECTANGLE))) != 0 && def->size.z <= 0.0f);
    if (isThin)
    {
        return refuse(host, SW_ERROR_INVALID, def, "has no extent; swInputDef::size must be above 0 m");
    }
    return SW_SUCCESS;
}

static swResult checkRaster(const swHost* host, const swInputDef* def)
{
    if (def->raster == NULL)
    {
        return refuse(host, SW_ERROR_INVALID, def, "has no raster");
    }
    const swRaster* raster = def->raster;
    sw_uint numbers = def->windWeight.isUsed ? 2u : swCountInputNumbers((sw_uint)def->field);
    numbers = def->field == SW_INPUT_DISPLACEMENT && raster->channels == 1 ? 1u : numbers; // heights
    if (raster->channels < (int)numbers)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "the input '%s' says %s, which has %u numbers; its raster '%s' has %d channels", def->name,
                      def->windWeight.isUsed ? "wind" : swGetInputFieldWord((int)def->field), numbers, raster->name,
                      raster->channels);
    }
    return SW_SUCCESS;
}

static swResult checkSpline(const swHost* host, const swInputDef* def)
{
    if (def->spline == NULL)
    {
        return refuse(host, SW_ERROR_INVALID, def, "has no spline");
    }
    bool turns = def->alongSpline && def->field == SW_INPUT_WAVES;
    if (def->alongSpline && !turns)
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def, "turns with its spline, which only waves can");
    }
    if (turns && def->blend != SW_BLEND_ALPHA && def->blend != SW_BLEND_ADD)
    {
        return refuse(host, SW_ERROR_UNSUPPORTED, def,
                      "turns waves with its spline; they join by SW_BLEND_ALPHA or SW_BLEND_ADD");
    }
    return SW_SUCCESS;
}

swResult swCheckInputValues(const swHost* host, const swInputDef* def)
{
    swResult result = swCheckDef(host, &swInputFields, def);
    return result == SW_SUCCESS ? checkValues(host, def) : result;
}

// Each point by itself; a point is named by its place in the array.
static swResult checkPoints(const swHost* host, const swInputDef* def, int count, const swInputPoint* points)
{
    if (count < 0 || count > SW_MAX_INPUT_POINTS || (count > 0 && points == NULL))
    {
        return swFail(host, SW_ERROR_INVALID, "the input '%s' has %d points; it may have 0 to %d", def->name, count,
                      SW_MAX_INPUT_POINTS);
    }
    float largest = isSpeed(def) ? SW_MAX_INPUT_SPEED : 1e6f;
    float heaviest = def->blend == SW_BLEND_ADD ? 100.0f : 1.0f;
    for (int i = 0; i < count; ++i)
    {
        const swInputPoint* p = &points[i];
        bool isFine = fabsf(p->x) <= 1e6f && fabsf(p->z) <= 1e6f && p->radius >= 0.0f && p->radius <= 1e6f &&
                      p->weight >= 0.0f && p->weight <= heaviest;
        for (int k = 0; k < 4; ++k)
        {
            isFine = isFine && fabsf(p->value[k]) <= largest;
        }
        if (!isFine)
        {
            return swFail(host, SW_ERROR_INVALID,
                          "point %d of the input '%s' is out of range: at (%g, %g) m with the radius %g m, the weight "
                          "%g and the value %g; see swInputPoint",
                          i, def->name, (double)p->x, (double)p->z, (double)p->radius, (double)p->weight,
                          (double)p->value[0]);
        }
    }
    return SW_SUCCESS;
}

swResult swCheckInputPoints(const swHost* host, const swInputDef* def, int count, const swInputPoint* points)
{
    if (def->shape == SW_SHAPE_POLYLINE && (count < 2 || points == NULL))
    {
        return refuse(host, SW_ERROR_INVALID, def, "is a line through fewer than two points");
    }
    if (def->shape == SW_SHAPE_PARTICLES || def->shape == SW_SHAPE_POLYLINE)
    {
        return checkPoints(host, def, count, points);
    }
    if (def->shape != SW_SHAPE_POLYGON)
    {
        return SW_SUCCESS;
    }
    char name[SW_MAX_INPUT_NAME + 32];
    bool isNamed = def->name[0] != '\0';
    snprintf(name, sizeof name, "the input%s%s%s", isNamed ? " '" : "", def->name, isNamed ? "'" : "");
    if (points == NULL)
    {
        return refuse(host, SW_ERROR_INVALID, def, "has no points");
    }
    return swCheckPolygon(host, name, count, &points->x, sizeof(swInputPoint) / sizeof(float));
}

swResult swCheckInputDef(const swHost* host, const swInputDef* def)
{
    swResult result = swCheckDef(host, &swInputFields, def);
    result = result == SW_SUCCESS ? checkKinds(host, def) : result;
    result = result == SW_SUCCESS ? checkValues(host, def) : result;
    if (result == SW_SUCCESS && swHasTide(def) && def->field != SW_INPUT_LEVEL && def->field != SW_INPUT_FLOW)
    {
        return refuse(host, SW_ERROR_INVALID, def, "has a tide, which levels and flows can have");
    }
    if (result == SW_SUCCESS && def->shape == SW_SHAPE_HULL && def->hull == NULL)
    {
        return refuse(host, SW_ERROR_INVALID, def, "has no hull");
    }
    if (result == SW_SUCCESS && def->shape == SW_SHAPE_FUNCTION && def->function == NULL)
    {
        return refuse(host, SW_ERROR_INVALID, def, "has no function");
    }
    if (result == SW_SUCCESS && def->shape == SW_SHAPE_RASTER)
    {
        result = checkRaster(host, def);
    }
    if (result == SW_SUCCESS && def->shape == SW_SHAPE_MESH && def->mesh == NULL)
    {
        result = refuse(host, SW_ERROR_INVALID, def, "has no mesh");
    }
    if (result == SW_SUCCESS && def->shape == SW_SHAPE_SPLINE)
    {
        result = checkSpline(host, def);
    }
    return result == SW_SUCCESS ? swCheckInputPoints(host, def, def->pointCount, def->points) : result;
}

static bool hasPoints(swInputShape shape)
{
    return shape == SW_SHAPE_POLYGON || shape == SW_SHAPE_POLYLINE || shape == SW_SHAPE_PARTICLES;
}

void swForgetUnused(swInputDef* def)
{
    def->raster = def->shape == SW_SHAPE_RASTER ? def->raster : NULL;
    def->mesh = def->shape == SW_SHAPE_MESH ? def->mesh : NULL;
    def->spline = def->shape == SW_SHAPE_SPLINE ? def->spline : NULL;
    def->hull = def->shape == SW_SHAPE_HULL ? def->hull : NULL;
    if (!hasPoints(def->shape))
    {
        def->points = NULL;
        def->pointCount = def->pointCapacity = 0;
    }
    if (def->shape == SW_SHAPE_EVERYWHERE)
    {
        def->position = (swPos){0.0, 0.0, 0.0};
    }
    if (def->shape != SW_SHAPE_FUNCTION)
    {
        def->function = NULL;
        def->functionContext = NULL;
        def->functionFingerprint = 0;
    }
}
