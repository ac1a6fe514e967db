// SPDX-License-Identifier: MIT
#include "core/input/input_record.h"

#include <math.h>
#include <string.h>

#include "core/input/hull.h"
#include "core/input/mesh.h"
#include "core/input/polyline.h"
#include "core/input/raster.h"
#include "core/input/spline.h"
#include "core/math/scalar.h"
#include "shared/region.h"
#include "shared/shape_hull.h"
#include "shared/shape_particles.h"
#include "shared/shape_spline.h"

bool swFindCell(double place, int32_t* cell, float* rest)
{
    double whole = floor(place / (double)SW_QUERY_CELL);
    bool fits = fabs(whole) < 2147483000.0;
    *cell = fits ? (int32_t)whole : 0;
    *rest = (float)(place - whole * (double)SW_QUERY_CELL);
    return fits;
}

int swCountInputWords(const swInputDef* def)
{
    int room = def->pointCapacity > def->pointCount ? def->pointCapacity : def->pointCount;
    if (def->shape == SW_SHAPE_POLYLINE)
    {
        return swCountPolylineWords(room);
    }
    if (def->shape == SW_SHAPE_PARTICLES)
    {
        return (int)SW_PARTICLE_WORDS * room;
    }
    return def->shape == SW_SHAPE_POLYGON ? 2 * room : 0;
}

static int writeParticles(const swInputDef* def, int pointCount, const swInputPoint* points, float* words)
{
    for (int i = 0; i < pointCount; ++i)
    {
        const swInputPoint* p = &points[i];
        float* to = words + i * (int)SW_PARTICLE_WORDS;
        to[0] = p->x;
        to[1] = p->z;
        to[2] = p->radius > 0.0f ? p->radius : 0.5f * def->size.x;
        to[3] = p->weight;
        memcpy(to + 4, p->value, sizeof p->value);
    }
    return (int)SW_PARTICLE_WORDS * pointCount;
}

int swWriteInputWords(const swInputDef* def, int pointCount, const swInputPoint* points, float* words)
{
    if (def->shape == SW_SHAPE_POLYLINE)
    {
        return swWritePolyline(pointCount, points, def->size.x, words);
    }
    if (def->shape == SW_SHAPE_PARTICLES)
    {
        return writeParticles(def, pointCount, points, words);
    }
    if (def->shape != SW_SHAPE_POLYGON)
    {
        return 0;
    }
    for (int i = 0; i < pointCount; ++i)
    {
        words[2 * i] = points[i].x;
        words[2 * i + 1] = points[i].z;
    }
    return 2 * pointCount;
}

// ---- shapes: bounds in own coordinates, and what their samplers read ----

// Of axes that begin in the middle.
static void placeCentred(swInputRecord* record, float width, float height)
{
    record->halfX = 0.5f * width;
    record->halfZ = 0.5f * height;
}

// A raster's own axes begin at the middle of its first cell.
static swPosXZ placeRaster(const swInputDef* def, const swRaster* raster, swInputRecord* record)
{
    record->extra0 = (sw_uint)raster->width;
    record->extra1 = (sw_uint)raster->height;
    record->extra2 = (sw_uint)raster->channels;
    record->part0 = (float)raster->spacingX;
    record->part1 = (float)raster->spacingZ;
    record->halfX = record->middleX = 0.5f * ((float)(raster->width - 1) * record->part0);
    record->halfZ = record->middleZ = 0.5f * ((float)(raster->height - 1) * record->part1);
    record->gain = def->gain;
    double cosine = (double)record->cosine, sine = (double)record->sine;
    return (swPosXZ){cosine * raster->x - sine * raster->z, sine * raster->x + cosine * raster->z};
}

// Heights of a mesh count from its own origin, which lies at the input's place.
static void placeMesh(const swInputDef* def, const swMesh* mesh, swInputRecord* record)
{
    swDescribeMesh(mesh, record);
    record->gain = def->gain;
    record->value.x = def->field == SW_INPUT_FLOOR ? def->value[0] + record->size.w : record->value.x;
}

// A spline's own axes begin in its middle. Heights of its points count from where the input is.
static swPosXZ placeSpline(const swInputDef* def, const swSpline* spline, swInputRecord* record)
{
    record->middleX = (float)(0.5 * (spline->leastX + spline->mostX));
    record->middleZ = (float)(0.5 * (spline->leastZ + spline->mostZ));
    record->halfX = (float)(0.5 * (spline->mostX - spline->leastX));
    record->halfZ = (float)(0.5 * (spline->mostZ - spline->leastZ));
    if (def->field == SW_INPUT_FLOOR || def->field == SW_INPUT_LEVEL)
    {
        record->value.x += def->field == SW_INPUT_FLOOR ? (float)def->position.y : record->size.w;
    }
    if (def->field == SW_INPUT_WAVES && def->alongSpline)
    {
        record->flags |= SW_INPUT_ALONG_SPLINE;
        record->part0 = (float)floor(swCos((double)def->heading) * (double)SW_HEADING_PARTS + 0.5) / SW_HEADING_PARTS;
        record->part1 = (float)floor(swSin((double)def->heading) * (double)SW_HEADING_PARTS + 0.5) / SW_HEADING_PARTS;
    }
    double cosine = (double)record->cosine, sine = (double)record->sine;
    return (swPosXZ){cosine * spline->originX - sine * spline->originZ,
                     sine * spline->originX + cosine * spline->originZ};
}

// Of a polygon, see shared/shape_polygon.h.
static void placePolygon(const float* words, int count, swInputRecord* record)
{
    float lowX = words[0], highX = words[0], lowZ = words[1], highZ = words[1];
    for (int i = 1; i < count; ++i)
    {
        lowX = fminf(lowX, words[2 * i]);
        highX = fmaxf(highX, words[2 * i]);
        lowZ = fminf(lowZ, words[2 * i + 1]);
        highZ = fmaxf(highZ, words[2 * i + 1]);
    }
    record->middleX = 0.5f * (lowX + highX);
    record->middleZ = 0.5f * (lowZ + highZ);
    // A little more, so that rounding leaves no point out.
    record->halfX = 0.5f * (highX - lowX) + 1e-6f * (fabsf(lowX) + fabsf(highX));
    record->halfZ = 0.5f * (highZ - lowZ) + 1e-6f * (fabsf(lowZ) + fabsf(highZ));
    record->extra0 = (sw_uint)count;
}

static void placePolyline(const float* words, int count, swInputRecord* record)
{
    float bounds[4];
    swBoundPolyline(count, words, bounds);
    record->middleX = 0.5f * (bounds[0] + bounds[2]);
    record->middleZ = 0.5f * (bounds[1] + bounds[3]);
    record->halfX = 0.5f * (bounds[2] - bounds[0]);
    record->halfZ = 0.5f * (bounds[3] - bounds[1]);
    record->extra0 = (sw_uint)count;
}

// The box of all discs.
static void placeParticles(const float* words, int count, swInputRecord* record)
{
    record->extra0 = (sw_uint)count;
    if (count == 0)
    {
        return;
    }
    float lowX = INFINITY, lowZ = INFINITY, highX = -INFINITY, highZ = -INFINITY;
    for (int i = 0; i < count; ++i)
    {
        const float* p = words + i * (int)SW_PARTICLE_WORDS;
        lowX = fminf(lowX, p[0] - p[2]);
        highX = fmaxf(highX, p[0] + p[2]);
        lowZ = fminf(lowZ, p[1] - p[2]);
        highZ = fmaxf(highZ, p[1] + p[2]);
    }
    record->middleX = 0.5f * (lowX + highX);
    record->middleZ = 0.5f * (lowZ + highZ);
    record->halfX = 0.5f * (highX - lowX);
    record->halfZ = 0.5f * (highZ - lowZ);
}

// Of a shape with a height: its own axes are turned, so its box is that of a sphere unless they are upright.
static void placeSolid(const swInputDef* def, swInputRecord* record)
{
    float x = 0.5f * def->size.x, y = 0.5f * def->size.y, z = 0.5f * def->size.z;
    y = def->shape == SW_SHAPE_CAPSULE && y < x ? x : y; // too short for its ends: a sphere
    z = def->shape == SW_SHAPE_CAPSULE ? x : z;
    bool isUpright = def->rotation.pitch == 0.0f && def->rotation.roll == 0.0f;
    float reach = sqrtf(x * x + y * y + z * z);
    record->halfX = isUpright ? x : reach;
    record->halfZ = isUpright ? z : reach;
    record->part0 = def->rounding;
}

// The grid lies in the mesh's own axes, which need not begin in its middle. `size` is what a length of it becomes.
static void placeHull(const swInputDef* def, const swHull* hull, swInputRecord* record)
{
    record->extra0 = (sw_uint)hull->grid.countX;
    record->extra1 = (sw_uint)hull->grid.countY;
    record->extra2 = (sw_uint)hull->grid.countZ;
    record->size.x = def->scale.x;
    record->size.y = def->scale.y;
    record->size.z = def->scale.z;
    swVec3 low = {hull->low.x * def->scale.x, hull->low.y * def->scale.y, hull->low.z * def->scale.z};
    swVec3 high = {hull->high.x * def->scale.x, hull->high.y * def->scale.y, hull->high.z * def->scale.z};
    if (def->rotation.pitch == 0.0f && def->rotation.roll == 0.0f)
    {
        record->middleX = 0.5f * (low.x + high.x);
        record->middleZ = 0.5f * (low.z + high.z);
        record->halfX = 0.5f * (high.x - low.x);
        record->halfZ = 0.5f * (high.z - low.z);
        return;
    }
    float x = fmaxf(fabsf(low.x), fabsf(high.x)), y = fmaxf(fabsf(low.y), fabsf(high.y));
    float z = fmaxf(fabsf(low.z), fabsf(high.z));
    record->halfX = record->halfZ = sqrtf(x * x + y * y + z * z);
}

static swPosXZ placeShape(const swInputDef* def, const swInputData* data, swInputRecord* record)
{
    switch (def->shape)
    {
    case SW_SHAPE_CIRCLE:
        placeCentred(record, def->size.x, def->size.x);
        break;
    case SW_SHAPE_RECTANGLE:
        placeCentred(record, def->size.x, def->size.z);
        break;
    case SW_SHAPE_MESH:
        placeMesh(def, data->mesh, record);
        break;
    case SW_SHAPE_RASTER:
        return placeRaster(def, data->raster, record);
    case SW_SHAPE_SPLINE:
        return placeSpline(def, data->spline, record);
    case SW_SHAPE_POLYGON:
    {
        int count;
        const float* words = swGetInputWords(data, &count);
        placePolygon(words, count / 2, record);
        break;
    }
    case SW_SHAPE_POLYLINE:
    {
        int count;
        placePolyline(swGetInputWords(data, &count), data->pointCount, record);
        break;
    }
    case SW_SHAPE_PARTICLES:
    {
        int count;
        const float* words = swGetInputWords(data, &count);
        placeParticles(words, count / (int)SW_PARTICLE_WORDS, record);
        break;
    }
    case SW_SHAPE_FUNCTION:
        placeCentred(record, def->size.x, def->size.z);
        break;
    case SW_SHAPE_BOX:
    case SW_SHAPE_ELLIPSOID:
    case SW_SHAPE_CYLINDER:
    case SW_SHAPE_CAPSULE:
        placeSolid(def, record);
        break;
    case SW_SHAPE_HULL:
        placeHull(def, data->hull, record);
        break;
    default:
        record->flags |= SW_INPUT_IS_BOUNDLESS;
        break;
    }
    return (swPosXZ){0.0, 0.0};
}

// ---- the record ----

// Pitch about z lifts the x axis, roll about x lowers the z axis; pitch comes first, so roll is inside.
static sw_vec4 makeTilt(swAngles rotation)
{
    double pitch = 0.5 * (double)rotation.pitch, roll = 0.5 * (double)rotation.roll;
    double cp = swCos(pitch), sp = swSin(pitch), cr = swCos(roll), sr = swSin(roll);
    return (sw_vec4){(float)(cp * sr), (float)(sp * sr), (float)(sp * cr), (float)(cp * cr)};
}

static void turnRecord(const swInputDef* def, swInputRecord* record)
{
    bool isTurned = def->shape != SW_SHAPE_EVERYWHERE && def->rotation.yaw != 0.0f;
    double yaw = (double)def->rotation.yaw;
    record->cosine = isTurned ? (float)swCos(yaw) : 1.0f;
    record->sine = isTurned ? (float)swSin(yaw) : 0.0f;
    record->turn = makeTilt(def->rotation);
    bool isVector = def->windWeight.isUsed || def->field == SW_INPUT_FLOW || def->field == SW_INPUT_WIND ||
                    def->field == SW_INPUT_DISPLACEMENT;
    record->flags |= isTurned && isVector ? SW_INPUT_TURNS_VALUES : 0u;
}

// What shared/region.h reads of a record of waves.
static void weighByWind(const swWindWeight* wind, swInputRecord* record)
{
    double heading = (double)wind->heading, step = (double)wind->headingStep;
    record->flags |= SW_INPUT_TAKES_WIND;
    record->turn = (sw_vec4){(float)swCos(heading), (float)swSin(heading), (float)swCos(step), (float)swSin(step)};
    record->size = (sw_vec4){wind->speed, wind->speedBelow, wind->speedAbove, record->size.w};
    record->value.z = wind->heightBelow;
    record->value.w = wind->heightAbove;
}

// The bounds of a turned box. Own coordinates are rounded to floats: a little more is covered.
static void findBounds(const swInputRecord* record, swPosXZ origin, swPosXZ* low, swPosXZ* high)
{
    double c = (double)record->cosine, s = (double)record->sine;
    double x = origin.x + c * (double)record->middleX - s * (double)record->middleZ;
    double z = origin.z + s * (double)record->middleX + c * (double)record->middleZ;
    double halfX = fabs(c) * (double)record->halfX + fabs(s) * (double)record->halfZ;
    double halfZ = fabs(s) * (double)record->halfX + fabs(c) * (double)record->halfZ;
    halfX += 0.01 + 1e-6 * (halfX + fabs((double)record->middleX) + fabs((double)record->middleZ));
    halfZ += 0.01 + 1e-6 * (halfZ + fabs((double)record->middleX) + fabs((double)record->middleZ));
    *low = (swPosXZ){x - halfX, z - halfZ};
    *high = (swPosXZ){x + halfX, z + halfZ};
}

void swFindInputArea(const swInputRecord* record, swPosXZ* low, swPosXZ* high)
{
    const double cell = (double)SW_QUERY_CELL;
    const swPosXZ origin = {(double)record->cellX * cell + (double)record->restX,
                            (double)record->cellZ * cell + (double)record->restZ};
    findBounds(record, origin, low, high);
    if ((record->flags & SW_INPUT_IS_BOUNDLESS) != 0)
    {
        *low = (swPosXZ){-(double)INFINITY, -(double)INFINITY};
        *high = (swPosXZ){(double)INFINITY, (double)INFINITY};
    }
}

static swCellBox findBox(const swInputRecord* record, swPosXZ origin)
{
    swPosXZ low, high;
    findBounds(record, origin, &low, &high);
    swCellBox box;
    float rest;
    bool fits = swFindCell(low.x, &box.minX, &rest) && swFindCell(high.x, &box.maxX, &rest) &&
                swFindCell(low.z, &box.minZ, &rest) && swFindCell(high.z, &box.maxZ, &rest);
    return fits ? box : (swCellBox){INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX};
}

void swMakeInputRecord(const swInputDef* def, const swInputData* data, double seaLevel, double time,
                       swInputRecord* record, swCellBox* box)
{
    *record = (swInputRecord){
        .weight = def->weight,
        .feather = def->feather,
        .value = {def->value[0], def->value[1], def->value[2], def->value[3]},
        .size = {def->size.x, def->size.y, def->size.z, (float)(def->position.y - seaLevel)},
        .field = (sw_uint)def->field,
        .shape = (sw_uint)def->shape,
        .blend = (sw_uint)def->blend,
        .flags = def->followsWaves ? SW_INPUT_FOLLOWS_WAVES : 0u,
        .system = def->system.index1 > 0 ? (sw_uint)def->system.index1 - 1u : SW_ALL_SYSTEMS,
        .gain = def->gain,
    };
    // Heights of floors count from sea level, so that they are as good wherever that is.
    if (def->field == SW_INPUT_FLOOR)
    {
        record->value.x = (float)((double)def->value[0] - seaLevel);
    }
    turnRecord(def, record);
    bool isHeight = def->field == SW_INPUT_DISPLACEMENT && def->shape == SW_SHAPE_RASTER && def->raster->channels < 3;
    record->flags |= isHeight ? SW_INPUT_IS_HEIGHT : 0u;
    record->flags |= def->isBump ? SW_INPUT_IS_BUMP : 0u;
    record->value.w = def->field == SW_INPUT_DISPLACEMENT ? def->wavelength : record->value.w;
    record->flags |= def->removesWaves ? SW_INPUT_REMOVES_WAVES : 0u;
    if (def->windWeight.isUsed)
    {
        weighByWind(&def->windWeight, record);
    }
    swPosXZ at = placeShape(def, data, record);
    swPosXZ origin = {def->position.x + at.x, def->position.z + at.z};
    if ((record->flags & SW_INPUT_IS_BOUNDLESS) != 0)
    {
        *box = (swCellBox){INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX};
    }
    else
    {
        swFindCell(origin.x, &record->cellX, &record->restX);
        swFindCell(origin.z, &record->cellZ, &record->restZ);
        *box = findBox(record, origin);
    }
    swSetInputTime(def, time, record);
}

const float* swGetInputWords(const swInputData* data, int* count)
{
    *count = 0;
    if (data == NULL)
    {
        return NULL;
    }
    if (data->raster != NULL)
    {
        const swRaster* raster = data->raster;
        *count = raster->width * raster->height * raster->channels * raster->frames;
        return raster->values;
    }
    if (data->spline != NULL)
    {
        *count = (int)data->spline->wordCount;
        return data->spline->words;
    }
    if (data->mesh != NULL)
    {
        *count = (int)data->mesh->wordCount;
        return data->mesh->words;
    }
    if (data->hull != NULL)
    {
        *count = (int)data->hull->wordCount;
        return data->hull->words;
    }
    int which = data->isNew ? 1 - data->shown : data->shown;
    *count = data->wordCount[which];
    return *count > 0 ? data->words[which] : NULL;
}

static bool isRasterGood(const swInputRecord* record)
{
    uint64_t cells = (uint64_t)record->extra0 * record->extra1;
    bool isSized = record->extra0 >= 1 && record->extra0 <= SW_MAX_RASTER_SIDE && record->extra1 >= 1 &&
                   record->extra1 <= SW_MAX_RASTER_SIDE && record->extra2 >= swCountRecordNumbers(*record) &&
                   record->extra2 <= 4 && record->part0 > 0.0f && record->part1 > 0.0f;
    uint64_t frame = cells * record->extra2;
    return isSized && record->extra3 + frame <= record->wordCount && record->extra4 + frame <= record->wordCount;
}

static bool isHullGood(const swInputRecord* record)
{
    uint64_t x = record->extra0, y = record->extra1, z = record->extra2;
    bool isSized = x >= 2 && y >= 2 && z >= 2 && x <= 4096 && y <= 4096 && z <= 4096;
    return isSized && x * y * z + SW_HULL_HEAD <= record->wordCount;
}

bool swIsInputRecordGood(const swInputRecord* record, const float* words)
{
    if (record->field >= SW_INPUT_FIELD_COUNT || record->blend >= SW_BLEND_COUNT ||
        record->wordCount > SW_MAX_RASTER_VALUES ||
        ((record->flags & SW_INPUT_ALONG_SPLINE) != 0 && record->shape != SW_SHAPE_SPLINE) ||
        !(fabsf(record->cosine) <= 2.0f && fabsf(record->sine) <= 2.0f))
    {
        return false;
    }
    switch (record->shape)
    {
    case SW_SHAPE_EVERYWHERE:
    case SW_SHAPE_CIRCLE:
    case SW_SHAPE_RECTANGLE:
    case SW_SHAPE_BOX:
    case SW_SHAPE_ELLIPSOID:
    case SW_SHAPE_CYLINDER:
    case SW_SHAPE_CAPSULE:
        return true;
    case SW_SHAPE_POLYGON:
        return record->extra0 >= 3 && record->extra0 <= SW_MAX_INPUT_POINTS && 2 * record->extra0 <= record->wordCount;
    case SW_SHAPE_POLYLINE:
        return record->extra0 >= 2 && record->extra0 <= SW_MAX_INPUT_POINTS &&
               (sw_uint)swCountPolylineWords((int)record->extra0) <= record->wordCount;
    case SW_SHAPE_SPLINE:
        return swAreSplineWordsGood(words, record->wordCount) && fabsf(record->part0) <= 2.0f &&
               fabsf(record->part1) <= 2.0f; // cosine and sine of its waves' heading
    case SW_SHAPE_PARTICLES:
        return (uint64_t)record->extra0 * SW_PARTICLE_WORDS <= record->wordCount;
    case SW_SHAPE_MESH:
        return swAreMeshWordsGood(record, words);
    case SW_SHAPE_HULL:
        return isHullGood(record);
    case SW_SHAPE_RASTER:
        return isRasterGood(record);
    default:
        return false;
    }
}

// Of what the host computes nothing is known.
#define LARGEST_VALUE 1e6f

void swFindInputRange(const swInputDef* def, const swInputData* data, float* least, float* most)
{
    float low = 0.0f, high = 0.0f;
    bool isMeshOfFloor = def->shape == SW_SHAPE_MESH && def->field == SW_INPUT_FLOOR;
    bool isUnknown = def->shape == SW_SHAPE_FUNCTION ||
                     (def->shape == SW_SHAPE_SPLINE && def->field != SW_INPUT_LEVEL) ||
                     (def->shape == SW_SHAPE_MESH && !isMeshOfFloor);
    if (isMeshOfFloor)
    {
        low = def->mesh->low.y;
        high = fminf(def->mesh->high.y, fmaxf(def->mesh->highest, low));
    }
    if (def->shape == SW_SHAPE_RASTER && def->raster->least <= def->raster->most)
    {
        low = def->raster->least;
        high = def->raster->most;
    }
    if (def->shape == SW_SHAPE_SPLINE)
    {
        // Heights of points count from where the input is, which may lie anywhere above or below the sea.
        swGetSplineHeights(def->spline, &low, &high);
        low = fminf(0.0f, low);
        high = fmaxf(0.0f, high);
    }
    for (int i = 0; def->shape != SW_SHAPE_POLYGON && data != NULL && i < data->pointCount; ++i)
    {
        for (int k = 0; k < 4; ++k)
        {
            low = fminf(low, data->points[i].value[k]);
            high = fmaxf(high, data->points[i].value[k]);
        }
    }
    bool isScaled = def->shape == SW_SHAPE_RASTER || def->shape == SW_SHAPE_SPLINE || isMeshOfFloor;
    float a = isScaled ? def->gain * low : low, b = isScaled ? def->gain * high : high;
    *least = isUnknown ? -LARGEST_VALUE : fminf(a, b);
    *most = isUnknown ? LARGEST_VALUE : fmaxf(a, b);
}

// ---- time ----

bool swHasTide(const swInputDef* def)
{
    bool hasTide = false;
    for (int i = 0; i < SW_MAX_TIDE; ++i)
    {
        hasTide = hasTide || def->tide[i].amplitude != 0.0f || def->tide[i].amplitudeAcross != 0.0f;
    }
    return hasTide;
}

static bool isPlayed(const swInputDef* def)
{
    return def->shape == SW_SHAPE_RASTER && def->raster->frames > 1 && def->framesPerSecond > 0.0f;
}

bool swDoesInputChange(const swInputDef* def)
{
    return isPlayed(def) || swHasTide(def);
}

// The frame of a raster that is played, and the share of the next.
static void playRaster(const swInputDef* def, double time, swInputRecord* record)
{
    int frames = def->raster->frames;
    double at = (time - def->startTime) * (double)def->framesPerSecond;
    double last = def->loops ? (double)frames : (double)(frames - 1);
    at = def->loops ? at - floor(at / last) * last : at < 0.0 ? 0.0 : at > last ? last : at;
    int first = (int)at < frames ? (int)at : frames - 1;
    int second = first + 1 < frames ? first + 1 : def->loops ? 0 : first;
    sw_uint frameWords = record->extra0 * record->extra1 * record->extra2;
    record->extra3 = (sw_uint)first * frameWords;
    record->extra4 = (sw_uint)second * frameWords;
    record->part2 = (float)(at - (double)first);
    record->part2 = record->part2 < 1.0f ? record->part2 : 1.0f;
}

void swSetInputTime(const swInputDef* def, double time, swInputRecord* record)
{
    if (swDoesInputChange(def))
    {
        record->flags |= SW_INPUT_CHANGES;
    }
    if (isPlayed(def))
    {
        playRaster(def, time, record);
    }
    if (swHasTide(def))
    {
        float x, z;
        swGetTide(SW_MAX_TIDE, def->tide, time, &x, &z);
        record->value.x = def->value[0] + x;
        record->value.y = def->field == SW_INPUT_FLOW ? def->value[1] + z : record->value.y;
    }
}
