// SPDX-License-Identifier: MIT
// What a scene that can be read is rarely meant to be.

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/base/field.h"
#include "core/base/misuse.h"
#include "scene/scene_source.h"
#include "scene/scene_stale.h"
#include "seaway/scene.h"

typedef enum Remark
{
#define SW_REMARK(name, code, severity, found, remedy) REMARK_##name,
#include "scene/remarks.inl"
#undef SW_REMARK
    REMARK_COUNT
} Remark;

static const struct
{
    const char* code;
    swLogLevel severity;
    const char* found;
    const char* remedy;
} texts[REMARK_COUNT] = {
#define SW_REMARK(name, code, severity, found, remedy) {code, SW_LOG_##severity, found, remedy},
#include "scene/remarks.inl"
#undef SW_REMARK
};

#define LEAST_HEIGHT 1e-6f // m; waves lower than that are none
#define FAST 10.0f         // m/s
#define FASTEST_SHIP 50.0f // m/s
#define FEW_CELLS 4
#define FEW_TEXELS 128
#define NARROW_BODY 2.0f // m
#define NARROW_FLOOR 5.0 // m
#define OTHER_WIND 0.25  // relative difference

typedef struct Checker
{
    const swScene* scene;
    const swWorld* world;
    int capacity, count;
    swSceneRemark* remarks;
} Checker;

// `what` names the thing, such as "input 3 'lake'"; empty for the whole scene.
static void tell(Checker* checker, Remark remark, int line, const char* what)
{
    if (checker->count < checker->capacity)
    {
        swSceneRemark* out = &checker->remarks[checker->count];
        *out = (swSceneRemark){.code = texts[remark].code, .severity = texts[remark].severity, .line = line};
        snprintf(out->text, sizeof(out->text), "%s%s%s; %s.", what, what[0] != '\0' ? ": " : "", texts[remark].found,
                 texts[remark].remedy);
    }
    checker->count += 1;
}

static void tellOf(Checker* checker, Remark remark, int line, const char* kind, int index, const char* name)
{
    char what[128];
    bool isNamed = name != NULL && name[0] != '\0';
    snprintf(what, sizeof(what), "%s %d%s%.63s%s", kind, index + 1, isNamed ? " '" : "", isNamed ? name : "",
             isNamed ? "'" : "");
    tell(checker, remark, line, what);
}

// ---- waves ----

// Angular frequency of a wavelength, rad/s.
static float findFrequency(float wavelength, const swScene* scene, const swWaveSystemDef* def)
{
    double k = 2.0 * (double)SW_PI / (double)wavelength;
    return (float)sqrt((double)scene->world.gravity * k * tanh(k * (double)def->spectrum.depth));
}

static swSeaState getState(const swScene* scene, const swWaveSystemDef* def)
{
    float low = findFrequency(def->maxWavelength, scene, def), high = findFrequency(def->minWavelength, scene, def);
    swSeaState state = {0};
    bool isFound = def->weight > 0.0f && swSpectrum_GetSeaState(&def->spectrum, low, high, &state) == SW_SUCCESS;
    return isFound ? state : (swSeaState){0};
}

static bool hasEnergy(const swScene* scene, const swWaveSystemDef* def)
{
    float largest = 0.0f;
    for (int i = 0; i < def->componentCount; ++i)
    {
        largest = fmaxf(largest, def->components[i].amplitude);
    }
    largest = def->componentCount > 0 ? largest : getState(scene, def).significantHeight;
    return def->weight * largest > LEAST_HEIGHT;
}

static void checkEnergy(Checker* checker)
{
    const swScene* scene = checker->scene;
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        if (hasEnergy(scene, &scene->waves[i].def))
        {
            return;
        }
    }
    if (scene->windSeaCount == 0)
    {
        tell(checker, REMARK_FLAT, scene->source->lines.waves, "");
    }
}

static void checkRegions(Checker* checker)
{
    const swScene* scene = checker->scene;
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        bool isWeighed = !scene->waves[i].def.isLocal;
        for (int j = 0; j < scene->inputCount; ++j)
        {
            bool isOfAll = scene->inputs[j].waves < 0 && scene->inputs[j].def.field == SW_INPUT_WAVES;
            isWeighed = isWeighed || isOfAll || scene->inputs[j].waves == i;
        }
        for (int j = 0; j < scene->waterBodyCount; ++j)
        {
            isWeighed = isWeighed || scene->waterBodies[j].waves == i;
        }
        if (!isWeighed)
        {
            tellOf(checker, REMARK_NO_REGION, scene->waves[i].line, "waves", i, NULL);
        }
    }
}

static void checkWinds(Checker* checker)
{
    const swScene* scene = checker->scene;
    double wind = (double)scene->world.wind.speed;
    for (int i = 0; i < scene->wavesCount && wind > 0.0; ++i)
    {
        const swWaveSystemDef* def = &scene->waves[i].def;
        double own = (double)def->spectrum.windSpeed;
        bool isNamed = def->spectrum.hasWind && !def->takesWind && def->componentCount == 0;
        if (isNamed && fabs(own - wind) > OTHER_WIND * wind)
        {
            tellOf(checker, REMARK_OTHER_WIND, scene->waves[i].line, "waves", i, NULL);
        }
    }
}

static void checkDirections(Checker* checker)
{
    for (int i = 0; i < checker->scene->wavesCount; ++i)
    {
        const swSceneWaves* waves = &checker->scene->waves[i];
        if (waves->measured != NULL && swMeasuredSea_GetRecord(waves->measured, waves->record).meanDirection == NULL)
        {
            tellOf(checker, REMARK_NO_DIRECTIONS, waves->line, "waves", i, NULL);
        }
    }
}

static void checkFoam(Checker* checker)
{
    const swScene* scene = checker->scene;
    float longest = 0.0f;
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        longest = fmaxf(longest, scene->waves[i].def.maxWavelength);
    }
    if (scene->wavesCount > 0 && scene->world.foam.minWavelength >= longest)
    {
        tell(checker, REMARK_FOAM_FILTER, scene->source->lines.foam, "");
    }
}

// ---- views ----

static void checkViews(Checker* checker)
{
    const swScene* scene = checker->scene;
    if (scene->viewCount == 0)
    {
        tell(checker, REMARK_NO_VIEWS, scene->source->lines.views, "");
    }
    if (scene->view.resolution < FEW_TEXELS)
    {
        tell(checker, REMARK_COARSE_VIEW, scene->source->lines.view, "");
    }
    for (int i = 0; i < scene->viewCount && checker->world != NULL; ++i)
    {
        const swPosXZ place = {scene->views[i].position.x, scene->views[i].position.z};
        float floors = -INFINITY;
        const swFieldSamples samples = {.floor = &floors};
        swMoment_QueryFields(swWorld_GetMoment(checker->world), 1, &place, &samples);
        if (scene->views[i].position.y + swWorld_GetSeaLevel(checker->world) < (double)floors)
        {
            tellOf(checker, REMARK_VIEW_IN_FLOOR, scene->views[i].line, "view", i, scene->views[i].name);
        }
    }
}

// ---- inputs ----

static bool hasHeight(swInputShape shape)
{
    return shape == SW_SHAPE_BOX || shape == SW_SHAPE_ELLIPSOID || shape == SW_SHAPE_CYLINDER ||
           shape == SW_SHAPE_CAPSULE || shape == SW_SHAPE_HULL;
}

static bool isTilted(const swSceneInput* input)
{
    const swAngles *own = &input->def.rotation, *rate = &input->motion.turnRate;
    bool isEver = own->pitch != 0.0f || own->roll != 0.0f || rate->pitch != 0.0f || rate->roll != 0.0f;
    for (int i = 0; i < input->motion.pathCount; ++i)
    {
        isEver = isEver || input->motion.path[i].turned.pitch != 0.0f || input->motion.path[i].turned.roll != 0.0f;
    }
    return isEver;
}

static bool bringsValues(swInputShape shape)
{
    return shape == SW_SHAPE_RASTER || shape == SW_SHAPE_SPLINE || shape == SW_SHAPE_MESH ||
           shape == SW_SHAPE_FUNCTION || shape == SW_SHAPE_POLYLINE || shape == SW_SHAPE_PARTICLES;
}

static bool saysNothing(const swSceneInput* input)
{
    const swInputDef* def = &input->def;
    bool isZero = def->value[0] == 0.0f && def->value[1] == 0.0f && def->value[2] == 0.0f && def->value[3] == 0.0f;
    for (int i = 0; i < SW_MAX_TIDE; ++i)
    {
        isZero = isZero && def->tide[i].amplitude == 0.0f && def->tide[i].amplitudeAcross == 0.0f;
    }
    return def->weight <= 0.0f ||
           (def->blend == SW_BLEND_ADD && isZero && input->tide.count == 0 && !bringsValues(def->shape));
}

// An input after this one that leaves nothing of what is below it.
static bool isCovered(const swScene* scene, int index)
{
    const swSceneInput* own = &scene->inputs[index];
    for (int i = 0; i < scene->inputCount; ++i)
    {
        const swInputDef* def = &scene->inputs[i].def;
        bool isAfter = def->order > own->def.order || (def->order == own->def.order && i > index);
        bool isSame = def->field == own->def.field && scene->inputs[i].waves == own->waves;
        bool isAll = def->isEnabled && def->shape == SW_SHAPE_EVERYWHERE &&
                     (def->blend == SW_BLEND_REPLACE || (def->blend == SW_BLEND_ALPHA && def->weight >= 1.0f));
        if (isAfter && isSame && isAll && def->field != SW_INPUT_ALBEDO)
        {
            return true;
        }
    }
    return false;
}

// Bodies are made before inputs, so that an input of the same order comes later.
static bool isOverBody(const swScene* scene, const swInputDef* def)
{
    bool isAll = def->field == SW_INPUT_LEVEL && def->shape == SW_SHAPE_EVERYWHERE && def->isEnabled;
    for (int i = 0; i < scene->waterBodyCount && isAll; ++i)
    {
        const swWaterBodyDef* body = &scene->waterBodies[i].def;
        if (body->setsLevel && body->isEnabled && body->order <= def->order)
        {
            return true;
        }
    }
    return false;
}

// The raster of an input; no numbers where it has none.
static swRasterInfo getInputRaster(const swInputDef* def)
{
    bool hasRaster = def->shape == SW_SHAPE_RASTER && def->raster != NULL;
    return hasRaster ? swRaster_GetInfo(def->raster) : (swRasterInfo){0};
}

static bool hasSpareChannels(const swInputDef* def, const swRasterInfo* info)
{
    return info->channels > (def->windWeight.isUsed ? 2 : swInputField_CountNumbers(def->field));
}

static bool isTinyFloor(const swInputDef* def, const swRasterInfo* info)
{
    double width = info->width * info->spacingX, height = info->height * info->spacingZ;
    return def->field == SW_INPUT_FLOOR && info->width > 0 && fmax(width, height) < NARROW_FLOOR;
}

static void checkInput(Checker* checker, int index)
{
    const swSceneInput* input = &checker->scene->inputs[index];
    const swInputDef* def = &input->def;
    float speed = hypotf(def->value[0], def->value[1]);
    swRasterInfo raster = getInputRaster(def);
    const struct
    {
        bool isFound;
        Remark remark;
    } found[] = {
        {!def->isEnabled, REMARK_DISABLED_INPUT},
        {def->isEnabled && saysNothing(input), REMARK_EMPTY_INPUT},
        {!hasHeight(def->shape) && isTilted(input), REMARK_TILTED_INPUT},
        {isCovered(checker->scene, index), REMARK_COVERED_INPUT},
        {isOverBody(checker->scene, def) && !saysNothing(input), REMARK_LEVEL_OVER_BODY},
        {def->field == SW_INPUT_FLOW && speed > FAST, REMARK_FAST_FLOW},
        {swSceneMotion_GetSpeed(&input->motion) > FASTEST_SHIP, REMARK_FAST_MOTION},
        {def->field == SW_INPUT_WIND, REMARK_WIND_OF_QUERIES},
        {hasSpareChannels(def, &raster), REMARK_SPARE_CHANNELS},
        {raster.frames > 1 && def->framesPerSecond == 0.0f, REMARK_STANDING_FRAMES},
        {isTinyFloor(def, &raster), REMARK_TINY_FLOOR},
    };
    for (size_t i = 0; i < sizeof(found) / sizeof(found[0]); ++i)
    {
        if (found[i].isFound)
        {
            tellOf(checker, found[i].remark, input->line, "input", index, def->name);
        }
    }
}

// ---- bodies of water ----

static void checkBody(Checker* checker, int index)
{
    const swSceneWaterBody* body = &checker->scene->waterBodies[index];
    swVec2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (int i = 0; i < body->pointCount; ++i)
    {
        low = (swVec2){fminf(low.x, body->points[i].x), fminf(low.y, body->points[i].y)};
        high = (swVec2){fmaxf(high.x, body->points[i].x), fmaxf(high.y, body->points[i].y)};
    }
    if (fmaxf(high.x - low.x, high.y - low.y) < NARROW_BODY)
    {
        tellOf(checker, REMARK_SMALL_BODY, body->line, "body of water", index, body->def.name);
    }
}

static void checkLooks(Checker* checker)
{
    const swScene* scene = checker->scene;
    for (int i = 0; i < scene->lookCount; ++i)
    {
        bool isUsed = false;
        for (int k = 0; k < scene->waterBodyCount; ++k)
        {
            isUsed = isUsed || scene->waterBodies[k].def.look == i + 1;
        }
        if (!isUsed)
        {
            tellOf(checker, REMARK_UNUSED_LOOK, scene->source->lines.looks, "look", i, NULL);
        }
    }
}

// ---- what inputs name ----

// Whether an input has a resource at a member of its def.
static bool isNamed(const swScene* scene, size_t member, const void* resource)
{
    for (int i = 0; i < scene->inputCount; ++i)
    {
        if (memcmp((const char*)&scene->inputs[i].def + member, &resource, sizeof(resource)) == 0)
        {
            return true;
        }
    }
    return false;
}

static bool isRasterUsed(const swScene* scene, const swRaster* raster)
{
    bool isUsed = isNamed(scene, offsetof(swInputDef, raster), raster);
    for (int i = 0; i < scene->inputCount; ++i)
    {
        const swSceneInput* input = &scene->inputs[i];
        for (int k = 0; k < input->nestCount; ++k)
        {
            isUsed = isUsed || input->nest[k] == raster;
        }
    }
    for (int i = 0; i < scene->windSeaCount; ++i)
    {
        isUsed = isUsed || scene->windSeas[i].def.raster == raster;
    }
    return isUsed;
}

static void checkRaster(Checker* checker, int index)
{
    const swScene* scene = checker->scene;
    const swSceneRaster* raster = &scene->rasters[index];
    if (raster->raster == NULL)
    {
        tellOf(checker, REMARK_LEFT_OUT, raster->line, "raster", index, raster->name);
        return;
    }
    swRasterInfo info = swRaster_GetInfo(raster->raster);
    if (info.width < FEW_CELLS || info.height < FEW_CELLS)
    {
        tellOf(checker, REMARK_SMALL_RASTER, raster->line, "raster", index, raster->name);
    }
    if (!(info.least <= info.most))
    {
        tellOf(checker, REMARK_UNKNOWN_RASTER, raster->line, "raster", index, raster->name);
    }
    if (raster->madeFrom[0] != '\0' && swIsSceneRasterStale(scene, index))
    {
        tellOf(checker, REMARK_STALE_RASTER, raster->line, "raster", index, raster->name);
    }
    if (!isRasterUsed(scene, raster->raster))
    {
        tellOf(checker, REMARK_UNUSED_RASTER, raster->line, "raster", index, raster->name);
    }
}

// The narrowest bend towards a side on which the ribbon lies. A ribbon on one side alone does not mind bends to the
// other, which are looked for at places along the line.
static float findLeastRadius(const swSceneSpline* spline)
{
    swSplineInfo info = swSpline_GetInfo(spline->spline);
    if (spline->def.offset == SW_SPLINE_CENTRE)
    {
        return info.leastRadius;
    }
    float most = 0.0f, side = spline->def.offset == SW_SPLINE_LEFT ? 1.0f : -1.0f;
    int count = 32 * spline->pointCount;
    for (int i = 0; i <= count; ++i)
    {
        most = fmaxf(most, side * swSpline_FindPlace(spline->spline, info.length * i / count).curvature);
    }
    return most > 0.0f ? 1.0f / most : INFINITY;
}

static void checkSpline(Checker* checker, int index)
{
    const swScene* scene = checker->scene;
    const swSceneSpline* spline = &scene->splines[index];
    if (!isNamed(scene, offsetof(swInputDef, spline), spline->spline))
    {
        tellOf(checker, REMARK_UNUSED_SPLINE, spline->line, "spline", index, spline->name);
    }
    float reach = spline->def.offset == SW_SPLINE_CENTRE ? 0.5f * spline->def.width : spline->def.width;
    if (findLeastRadius(spline) < reach)
    {
        tellOf(checker, REMARK_NARROW_BEND, spline->line, "spline", index, spline->name);
    }
}

// Whether a triangle of a mesh has an area from above, and a part below what is left out.
static bool isSeenFromAbove(const swMesh* mesh)
{
    swMeshInfo info = swMesh_GetInfo(mesh);
    const swVec3* vertices = swMesh_GetVertices(mesh);
    const uint32_t* indices = swMesh_GetIndices(mesh);
    for (int i = 0; i < info.triangleCount; ++i)
    {
        swVec3 a = vertices[indices[3 * i]], b = vertices[indices[3 * i + 1]], c = vertices[indices[3 * i + 2]];
        float area = (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
        if (area != 0.0f && fminf(a.y, fminf(b.y, c.y)) < info.highest)
        {
            return true;
        }
    }
    return false;
}

static void checkMesh(Checker* checker, int index)
{
    const swSceneMesh* mesh = &checker->scene->meshes[index];
    if (mesh->mesh != NULL && !isSeenFromAbove(mesh->mesh))
    {
        tellOf(checker, REMARK_UPRIGHT_MESH, mesh->line, "mesh", index, mesh->name);
    }
    if (!isNamed(checker->scene, offsetof(swInputDef, mesh), mesh->mesh))
    {
        tellOf(checker, REMARK_UNUSED_MESH, mesh->line, "mesh", index, mesh->name);
    }
}

static void checkHull(Checker* checker, int index)
{
    const swSceneHull* hull = &checker->scene->hulls[index];
    if (!isNamed(checker->scene, offsetof(swInputDef, hull), hull->hull))
    {
        tellOf(checker, REMARK_UNUSED_HULL, hull->line, "hull", index, hull->name);
    }
}

// Each item of a list.
static void checkEach(Checker* checker, int count, void (*check)(Checker*, int))
{
    for (int i = 0; i < count; ++i)
    {
        check(checker, i);
    }
}

int swScene_Check(const swScene* scene, const swWorld* world, int capacity, swSceneRemark* remarks)
{
    SW_REQUIRE(scene != NULL && capacity >= 0 && (remarks != NULL || capacity == 0), 0,
               scene != NULL ? &scene->host : NULL, "swScene_Check() needs a scene and room for remarks");
    Checker checker = {scene, world, capacity, 0, remarks};
    checkViews(&checker);
    checkEnergy(&checker);
    checkRegions(&checker);
    checkWinds(&checker);
    checkDirections(&checker);
    checkFoam(&checker);
    checkLooks(&checker);
    checkEach(&checker, scene->waterBodyCount, checkBody);
    checkEach(&checker, scene->inputCount, checkInput);
    checkEach(&checker, scene->rasterCount, checkRaster);
    checkEach(&checker, scene->splineCount, checkSpline);
    checkEach(&checker, scene->meshCount, checkMesh);
    checkEach(&checker, scene->hullCount, checkHull);
    return checker.count;
}
