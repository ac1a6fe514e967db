// SPDX-License-Identifier: MIT
// What lines show of a sea: queries, a ray, tiles of the mesh, outlines of inputs.

#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "seaway/lines.h"
#include "seaway/query.h"
#include "seaway/spline.h"
#include "seaway/mesh.h"
#include "seaway/water_body.h"
#include "stage/stage_base.h"

#define SW_MARK_BLOCK 128
#define SW_MARK_PARTS 48 // of a circle, or of a long edge

static swPos moveBy(swPos p, double x, double y, double z)
{
    return (swPos){p.x + x, p.y + y, p.z + z};
}

static void addCross(swStageLines* lines, swPos at, double half, swVec3 color)
{
    swStageLines_Add(lines, moveBy(at, -half, 0.0, 0.0), moveBy(at, half, 0.0, 0.0), color);
    swStageLines_Add(lines, moveBy(at, 0.0, 0.0, -half), moveBy(at, 0.0, 0.0, half), color);
}

// ---- queries ----

void swStageLines_AddQueries(swStageLines* lines, const swMoment* moment, swPosXZ middle, float step, int count)
{
    SW_REQUIRE_VOID(lines != NULL && moment != NULL && step > 0.0f && step <= 1e6f && count >= 1 &&
                        count <= SW_MARK_BLOCK && middle.x - middle.x == 0.0 && middle.z - middle.z == 0.0,
                    swFindLinesHost(lines),
                    "swStageLines_AddQueries() needs lines, a moment, a place, a step above 0 and 1 to 128 points");
    const swVec3 green = {0.2f, 1.0f, 0.3f}, blue = {0.3f, 0.5f, 1.0f};
    const swQueryDef def = swDefaultQueryDef();
    swPosXZ points[SW_MARK_BLOCK];
    float heights[SW_MARK_BLOCK];
    swVec3 normals[SW_MARK_BLOCK];
    const swSurfaceSamples samples = {.height = heights, .normal = normals};
    double half = fmin(0.25 * (double)step, 1.0), length = 0.5 * (double)step;
    for (int row = 0; row < count; ++row)
    {
        for (int i = 0; i < count; ++i)
        {
            points[i] = (swPosXZ){middle.x + (double)step * (i - 0.5 * (count - 1)),
                                  middle.z + (double)step * (row - 0.5 * (count - 1))};
        }
        swMoment_QuerySurface(moment, &def, count, points, &samples, NULL);
        for (int i = 0; i < count; ++i)
        {
            swPos at = {points[i].x, (double)heights[i], points[i].z};
            addCross(lines, at, half, green);
            swStageLines_Add(
                lines, at,
                moveBy(at, length * (double)normals[i].x, length * (double)normals[i].y, length * (double)normals[i].z),
                blue);
        }
    }
}

// ---- a ray ----

void swStageLines_AddRay(swStageLines* lines, const swMoment* moment, swPos from, swVec3 direction, float reach)
{
    float length = sqrtf(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
    SW_REQUIRE_VOID(lines != NULL && moment != NULL && length > 0.0f && length < 1e9f && reach > 0.0f &&
                        reach <= 1e5f && from.x - from.x == 0.0 && from.y - from.y == 0.0 && from.z - from.z == 0.0,
                    swFindLinesHost(lines),
                    "swStageLines_AddRay() needs lines, a moment, a place, a direction and a reach up to 1e5 m");
    const swVec3 green = {0.2f, 1.0f, 0.3f}, red = {1.0f, 0.2f, 0.2f};
    const swQueryDef def = swDefaultQueryDef();
    swRay ray = swDefaultRay(from, direction);
    swRayHit hit;
    ray.maxDistance = reach;
    swMoment_CastRays(moment, &def, 1, &ray, &hit, NULL);
    double scale = (double)(reach / length);
    swPos end =
        hit.isHit ? hit.point
                  : moveBy(from, scale * (double)direction.x, scale * (double)direction.y, scale * (double)direction.z);
    swStageLines_Add(lines, from, end, hit.isHit ? green : red);
    if (hit.isHit)
    {
        addCross(lines, end, 1.0, green);
    }
}

// ---- lines on the ground ----

// Heights of the water at rest, or of the land that stands above it.
static void findHeights(const swMoment* moment, int count, const swPosXZ* points, double* heights, double seaLevel)
{
    float levels[SW_MARK_PARTS + 1], floors[SW_MARK_PARTS + 1];
    const swFieldSamples samples = {.level = levels, .floor = floors};
    swMoment_QueryFields(moment, count, points, &samples);
    for (int i = 0; i < count; ++i)
    {
        heights[i] = fmax(seaLevel + (double)levels[i], (double)floors[i]) + 0.1;
    }
}

// Between two places, in parts that follow the ground.
static void addGroundLine(swStageLines* lines, const swMoment* moment, double seaLevel, swPosXZ a, swPosXZ b,
                          swVec3 color)
{
    double length = hypot(b.x - a.x, b.z - a.z);
    int parts = length < 4.0 * SW_MARK_PARTS ? 1 + (int)(length / 4.0) : SW_MARK_PARTS;
    parts = parts < SW_MARK_PARTS ? parts : SW_MARK_PARTS;
    swPosXZ points[SW_MARK_PARTS + 1];
    double heights[SW_MARK_PARTS + 1];
    for (int i = 0; i <= parts; ++i)
    {
        double t = (double)i / parts;
        points[i] = (swPosXZ){a.x + t * (b.x - a.x), a.z + t * (b.z - a.z)};
    }
    findHeights(moment, parts + 1, points, heights, seaLevel);
    for (int i = 0; i < parts; ++i)
    {
        swStageLines_Add(lines, (swPos){points[i].x, heights[i], points[i].z},
                         (swPos){points[i + 1].x, heights[i + 1], points[i + 1].z}, color);
    }
}

void swStageLines_AddTiles(swStageLines* lines, const swPicture* picture, const swMoment* moment)
{
    SW_REQUIRE_VOID(lines != NULL && picture != NULL && moment != NULL, swFindLinesHost(lines),
                    "swStageLines_AddTiles() needs lines, a prepared picture and a moment");
    static const swVec3 colors[4] = {{1.0f, 0.9f, 0.2f}, {1.0f, 0.5f, 0.1f}, {0.9f, 0.3f, 0.6f}, {0.4f, 0.6f, 1.0f}};
    static const int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    swTileBounds tiles[SW_MAX_TILE_BOUNDS];
    int count = swPicture_GetTiles(picture, SW_MAX_TILE_BOUNDS, tiles);
    for (int i = 0; i < count && i < SW_MAX_TILE_BOUNDS; ++i)
    {
        for (int k = 0; k < 4; ++k)
        {
            const int *a = corners[k], *b = corners[(k + 1) % 4];
            swPosXZ from = {a[0] ? tiles[i].high.x : tiles[i].low.x, a[1] ? tiles[i].high.z : tiles[i].low.z};
            swPosXZ to = {b[0] ? tiles[i].high.x : tiles[i].low.x, b[1] ? tiles[i].high.z : tiles[i].low.z};
            addGroundLine(lines, moment, tiles[i].seaLevel, from, to, colors[tiles[i].slice % 4]);
        }
    }
}

// ---- inputs ----

swVec3 swGetInputColor(swInputField field)
{
    static const swVec3 colors[SW_INPUT_FIELD_COUNT] = {
        [SW_INPUT_FLOOR] = {0.6f, 0.4f, 0.2f},        [SW_INPUT_LEVEL] = {0.2f, 0.9f, 0.2f},
        [SW_INPUT_FLOW] = {0.2f, 0.4f, 1.0f},         [SW_INPUT_WAVES] = {1.0f, 0.9f, 0.2f},
        [SW_INPUT_DISPLACEMENT] = {0.6f, 0.4f, 1.0f}, [SW_INPUT_CLIP] = {0.1f, 1.0f, 1.0f},
        [SW_INPUT_FOAM] = {1.0f, 1.0f, 1.0f},         [SW_INPUT_ALBEDO] = {1.0f, 0.2f, 1.0f},
        [SW_INPUT_WIND] = {1.0f, 0.6f, 0.1f},         [SW_INPUT_SHADOW] = {0.0f, 0.0f, 0.0f},
        [SW_INPUT_BODY] = {1.0f, 0.2f, 0.2f},
    };
    return (unsigned)field < SW_INPUT_FIELD_COUNT ? colors[field] : (swVec3){1.0f, 1.0f, 1.0f};
}

typedef struct Outline
{
    swStageLines* lines;
    const swMoment* moment;
    double seaLevel;
    const swInputDef* def;
    swVec3 color;
} Outline;

// From the input's own axes. Shapes without a height take the yaw alone.
static swPosXZ placeFlat(const Outline* outline, double x, double z)
{
    const swInputDef* def = outline->def;
    double c = cos((double)def->rotation.yaw), s = sin((double)def->rotation.yaw);
    return (swPosXZ){def->position.x + c * x - s * z, def->position.z + s * x + c * z};
}

static void addFlat(const Outline* outline, double x0, double z0, double x1, double z1)
{
    addGroundLine(outline->lines, outline->moment, outline->seaLevel, placeFlat(outline, x0, z0),
                  placeFlat(outline, x1, z1), outline->color);
}

static void addRectangle(const Outline* outline, double x0, double z0, double x1, double z1)
{
    addFlat(outline, x0, z0, x1, z0);
    addFlat(outline, x1, z0, x1, z1);
    addFlat(outline, x1, z1, x0, z1);
    addFlat(outline, x0, z1, x0, z0);
}

static void addCircle(const Outline* outline, double x, double z, double radius, int parts)
{
    for (int i = 0; i < parts; ++i)
    {
        double a = 2.0 * SW_PI * i / parts, b = 2.0 * SW_PI * (i + 1) / parts;
        addFlat(outline, x + radius * cos(a), z + radius * sin(a), x + radius * cos(b), z + radius * sin(b));
    }
}

// Roll about x, then pitch about z, then yaw, see swInputDef::rotation.
static swPos placeSolid(const Outline* outline, double x, double y, double z)
{
    const swInputDef* def = outline->def;
    double cr = cos((double)def->rotation.roll), sr = sin((double)def->rotation.roll);
    double cp = cos((double)def->rotation.pitch), sp = sin((double)def->rotation.pitch);
    double y1 = cr * y - sr * z, z1 = sr * y + cr * z;
    double x2 = cp * x - sp * y1, y2 = sp * x + cp * y1;
    swPosXZ flat = placeFlat(outline, x2, z1);
    return (swPos){flat.x, def->position.y + y2, flat.z};
}

static void addSolidLine(const Outline* outline, swPos a, swPos b)
{
    swStageLines_Add(outline->lines, placeSolid(outline, a.x, a.y, a.z), placeSolid(outline, b.x, b.y, b.z),
                     outline->color);
}

static void addBox(const Outline* outline, double x, double y, double z)
{
    for (int i = 0; i < 4; ++i)
    {
        double a = i & 1 ? 1.0 : -1.0, b = i & 2 ? 1.0 : -1.0;
        addSolidLine(outline, (swPos){-x, a * y, b * z}, (swPos){x, a * y, b * z});
        addSolidLine(outline, (swPos){a * x, -y, b * z}, (swPos){a * x, y, b * z});
        addSolidLine(outline, (swPos){a * x, b * y, -z}, (swPos){a * x, b * y, z});
    }
}

// An ellipse about the axis that has no extent.
static void addRing(const Outline* outline, double x, double y, double z, double height)
{
    for (int i = 0; i < SW_MARK_PARTS; ++i)
    {
        double a = 2.0 * SW_PI * i / SW_MARK_PARTS, b = 2.0 * SW_PI * (i + 1) / SW_MARK_PARTS;
        swPos from = {x * cos(a), height + y * (x > 0.0 ? sin(a) : cos(a)), z * sin(a)};
        swPos to = {x * cos(b), height + y * (x > 0.0 ? sin(b) : cos(b)), z * sin(b)};
        addSolidLine(outline, from, to);
    }
}

static void addPoints(const Outline* outline, bool isClosed)
{
    const swInputDef* def = outline->def;
    for (int i = 0; i + (isClosed ? 0 : 1) < def->pointCount; ++i)
    {
        const swInputPoint *a = &def->points[i], *b = &def->points[(i + 1) % def->pointCount];
        addFlat(outline, (double)a->x, (double)a->z, (double)b->x, (double)b->z);
    }
}

// A spline lies where it says itself, moved and turned by the input.
static void addSpline(const Outline* outline)
{
    const swSpline* spline = outline->def->spline;
    double length = swSpline_GetInfo(spline).length;
    int parts = length < 800.0 ? 8 + (int)(length / 4.0) : 208;
    swSplinePlace last = swSpline_FindPlace(spline, 0.0);
    for (int i = 1; i <= parts; ++i)
    {
        swSplinePlace next = swSpline_FindPlace(spline, length * i / parts);
        addFlat(outline, last.point.x, last.point.z, next.point.x, next.point.z);
        last = next;
    }
}

// A hull's outline: where its surface meets level planes of its own axes. Corners of a plane's lattice inside and
// outside are parted by a line through the middles of its crossed edges, in each triangle of half a cell.
#define SW_HULL_SIDE 28  // cells along a plane's sides
#define SW_HULL_PLANES 5 // none of them at the hull's very bottom or top

typedef struct Corner
{
    swVec3 place;
    float distance; // below 0 inside
} Corner;

// Where the surface lies between two corners.
static swPos crossEdge(const Outline* outline, const Corner* a, const Corner* b)
{
    double share = (double)(a->distance / (a->distance - b->distance));
    const swVec3 scale = outline->def->scale;
    return (swPos){(double)scale.x * ((double)a->place.x + share * (double)(b->place.x - a->place.x)),
                   (double)scale.y * (double)a->place.y,
                   (double)scale.z * ((double)a->place.z + share * (double)(b->place.z - a->place.z))};
}

static void addHullTriangle(const Outline* outline, const Corner* a, const Corner* b, const Corner* c)
{
    const Corner* corners[3] = {a, b, c};
    swPos ends[3];
    int count = 0;
    for (int i = 0; i < 3; ++i)
    {
        const Corner *from = corners[i], *to = corners[(i + 1) % 3];
        if ((from->distance < 0.0f) != (to->distance < 0.0f))
        {
            ends[count++] = crossEdge(outline, from, to);
        }
    }
    if (count == 2)
    {
        addSolidLine(outline, ends[0], ends[1]);
    }
}

static void addHullPlane(const Outline* outline, const swHullInfo* info, float y)
{
    enum
    {
        ROW = SW_HULL_SIDE + 1
    };
    Corner corners[ROW * ROW];
    swVec3 places[ROW * ROW];
    float distances[ROW * ROW];
    const float margin = info->spacing; // so that the outermost corners lie outside
    for (int i = 0; i < ROW * ROW; ++i)
    {
        float u = (float)(i % ROW) / SW_HULL_SIDE, v = (float)(i / ROW) / SW_HULL_SIDE;
        places[i] = (swVec3){info->low.x - margin + u * (info->high.x - info->low.x + 2.0f * margin), y,
                             info->low.z - margin + v * (info->high.z - info->low.z + 2.0f * margin)};
    }
    swHull_Sample(outline->def->hull, ROW * ROW, places, distances);
    for (int i = 0; i < ROW * ROW; ++i)
    {
        corners[i] = (Corner){places[i], distances[i]};
    }
    for (int z = 0; z < SW_HULL_SIDE; ++z)
    {
        for (int x = 0; x < SW_HULL_SIDE; ++x)
        {
            const Corner* first = &corners[z * ROW + x];
            addHullTriangle(outline, first, first + 1, first + ROW);
            addHullTriangle(outline, first + 1, first + ROW + 1, first + ROW);
        }
    }
}

static void addHull(const Outline* outline)
{
    swHullInfo info = swHull_GetInfo(outline->def->hull);
    for (int i = 0; i < SW_HULL_PLANES; ++i)
    {
        float share = ((float)i + 0.5f) / SW_HULL_PLANES;
        addHullPlane(outline, &info, info.low.y + share * (info.high.y - info.low.y));
    }
}

static void addOutline(const Outline* outline)
{
    const swInputDef* def = outline->def;
    double x = 0.5 * (double)def->size.x, y = 0.5 * (double)def->size.y, z = 0.5 * (double)def->size.z;
    switch (def->shape)
    {
    case SW_SHAPE_CIRCLE:
        addCircle(outline, 0.0, 0.0, x, SW_MARK_PARTS);
        break;
    case SW_SHAPE_RECTANGLE:
    case SW_SHAPE_FUNCTION:
        addRectangle(outline, -x, -z, x, z);
        break;
    case SW_SHAPE_POLYGON:
    case SW_SHAPE_POLYLINE:
        addPoints(outline, def->shape == SW_SHAPE_POLYGON);
        break;
    case SW_SHAPE_PARTICLES:
        for (int i = 0; i < def->pointCount && i < 256; ++i)
        {
            double radius = def->points[i].radius > 0.0f ? (double)def->points[i].radius : x;
            addCircle(outline, (double)def->points[i].x, (double)def->points[i].z, radius, 8);
        }
        break;
    case SW_SHAPE_SPLINE:
        addSpline(outline);
        break;
    case SW_SHAPE_RASTER:
    {
        swRasterInfo info = swRaster_GetInfo(def->raster);
        addRectangle(outline, info.x, info.z, info.x + info.spacingX * (info.width - 1),
                     info.z + info.spacingZ * (info.height - 1));
        break;
    }
    case SW_SHAPE_MESH:
    {
        swMeshInfo info = swMesh_GetInfo(def->mesh);
        addRectangle(outline, (double)info.low.x, (double)info.low.z, (double)info.high.x, (double)info.high.z);
        break;
    }
    case SW_SHAPE_BOX:
        addBox(outline, x, y, z);
        break;
    case SW_SHAPE_ELLIPSOID:
        addRing(outline, x, y, 0.0, 0.0);
        addRing(outline, x, 0.0, z, 0.0);
        addRing(outline, 0.0, y, z, 0.0);
        break;
    case SW_SHAPE_CYLINDER:
        addRing(outline, x, 0.0, z, -y);
        addRing(outline, x, 0.0, z, y);
        break;
    case SW_SHAPE_CAPSULE:
        addRing(outline, x, 0.0, x, x - y);
        addRing(outline, x, 0.0, x, y - x);
        break;
    case SW_SHAPE_HULL:
        addHull(outline);
        break;
    default:
        break; // everywhere
    }
}

static void addBody(Outline* outline, const swWaterBodyDef* body)
{
    outline->color = swGetInputColor(SW_INPUT_BODY);
    for (int i = 0; i < body->pointCount; ++i)
    {
        swVec2 a = body->points[i], b = body->points[(i + 1) % body->pointCount];
        addGroundLine(outline->lines, outline->moment, outline->seaLevel,
                      (swPosXZ){body->position.x + (double)a.x, body->position.z + (double)a.y},
                      (swPosXZ){body->position.x + (double)b.x, body->position.z + (double)b.y}, outline->color);
    }
}

void swStageLines_AddInputs(swStageLines* lines, const swWorld* world)
{
    SW_REQUIRE_VOID(lines != NULL && world != NULL, swFindLinesHost(lines),
                    "swStageLines_AddInputs() needs lines and a world");
    Outline outline = {.lines = lines, .moment = swWorld_GetMoment(world), .seaLevel = swWorld_GetSeaLevel(world)};
    for (int i = 0; i < swWorld_GetInputCount(world); ++i)
    {
        const swInputDef def = swInput_Get(world, swWorld_GetInput(world, i));
        if (def.isEnabled)
        {
            outline.def = &def;
            outline.color = swGetInputColor(def.field);
            addOutline(&outline);
        }
    }
    for (int i = 0; i < swWorld_GetWaterBodyCount(world); ++i)
    {
        const swWaterBodyDef body = swWaterBody_Get(world, swWorld_GetWaterBody(world, i));
        if (body.isEnabled)
        {
            addBody(&outline, &body);
        }
    }
}

// ---- all of them ----

bool swParseStageMarks(const char* text, uint32_t* marks)
{
    static const char* const names[] = {"queries", "ray", "tiles", "inputs"};
    SW_REQUIRE(text != NULL && marks != NULL, false, NULL,
               "swParseStageMarks() needs a text and a place for the marks");
    uint32_t all = 0;
    for (;;)
    {
        size_t length = strcspn(text, ",");
        uint32_t mark = 0;
        for (uint32_t i = 0; i < 4; ++i)
        {
            mark = strlen(names[i]) == length && memcmp(names[i], text, length) == 0 ? 1u << i : mark;
        }
        if (mark == 0)
        {
            return false;
        }
        all |= mark;
        if (text[length] == '\0')
        {
            *marks = all;
            return true;
        }
        text += length + 1;
    }
}

// Where the middle of the picture is on the water, or 50 m ahead.
static swPos findAim(const swMoment* moment, const swCamera* camera, double* distance)
{
    const float* m = camera->view.m;
    swRay ray = swDefaultRay(camera->position, (swVec3){-m[2], -m[6], -m[10]});
    swQueryDef def = swDefaultQueryDef();
    swRayHit hit;
    ray.maxDistance = 20000.0f;
    def.minWavelength = 1.0f;
    swMoment_CastRays(moment, &def, 1, &ray, &hit, NULL);
    *distance = hit.isHit ? (double)hit.distance : 50.0;
    return hit.isHit ? hit.point
                     : moveBy(camera->position, -50.0 * (double)m[2], -50.0 * (double)m[6], -50.0 * (double)m[10]);
}

void swStageLines_AddMarks(swStageLines* lines, const swWorld* world, const swPicture* picture, const swCamera* camera,
                           uint32_t marks)
{
    SW_REQUIRE_VOID(lines != NULL && world != NULL && picture != NULL && camera != NULL, swFindLinesHost(lines),
                    "swStageLines_AddMarks() needs lines, a world, a picture and a camera");
    const swMoment* moment = swWorld_GetMoment(world);
    const float* m = camera->view.m;
    double distance = 0.0;
    swPos aim = findAim(moment, camera, &distance);
    if ((marks & SW_MARKS_QUERIES) != 0)
    {
        float step = (float)fmin(fmax(distance / 24.0, 0.25), 200.0);
        swStageLines_AddQueries(lines, moment, (swPosXZ){aim.x, aim.z}, step, 17);
    }
    if ((marks & SW_MARKS_RAY) != 0)
    {
        double aside = 0.3 * distance;
        swPos from = moveBy(camera->position, aside * (double)m[0], aside * (double)m[4], aside * (double)m[8]);
        swVec3 way = {(float)(aim.x - from.x), (float)(aim.y - from.y), (float)(aim.z - from.z)};
        swStageLines_AddRay(lines, moment, from, way, (float)fmin(2.0 * distance, 1e5));
    }
    if ((marks & SW_MARKS_TILES) != 0)
    {
        swStageLines_AddTiles(lines, picture, moment);
    }
    if ((marks & SW_MARKS_INPUTS) != 0)
    {
        swStageLines_AddInputs(lines, world);
    }
}
