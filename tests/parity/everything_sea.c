// SPDX-License-Identifier: MIT
#include "parity/everything_sea.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

// What is being filled, around a place.
typedef struct Sea
{
    const swHost* host;
    swWorld* world;
    swPosXZ middle;
    uint32_t seed;                    // of the last system
    swWaveSystemId wind, swell, free; // everywhere
    swWaveSystemId regional;          // local
    swWaveSystemId along[2];          // ribbons' own
} Sea;

static void Need(swResult result, const char* what)
{
    if (result != SW_SUCCESS)
    {
        fprintf(stderr, "%s: %s\n", what, swResult_GetText(result));
        exit(2);
    }
}

static void Add(Sea* sea, const swInputDef* def)
{
    swInputId id;
    Need(swCreateInput(sea->world, def, &id), "an input");
}

// A shape at x, z from the place.
static swInputDef At(const Sea* sea, swInputField field, swInputShape shape, double x, double z, float size)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = shape;
    def.position = (swPos){sea->middle.x + x, 0.0, sea->middle.z + z};
    def.size = (swVec3){size, 10.0f, 0.7f * size};
    def.feather = 0.2f * size;
    return def;
}

// ---- depth ----

#define RASTER_SIDE 41

// `scale` (above below the middle) times a pattern between -1 and 1, one cell of which is not known.
static swRaster* MakeRaster(const Sea* sea, float middle, float scale)
{
    static float values[RASTER_SIDE * RASTER_SIDE];
    for (int i = 0; i < RASTER_SIDE * RASTER_SIDE; ++i)
    {
        int x = i % RASTER_SIDE, z = i / RASTER_SIDE;
        values[i] = middle + scale * (float)(sin(0.3 * x) * cos(0.2 * z));
    }
    values[20 * RASTER_SIDE + 12] = NAN;
    swRasterDef def = swDefaultRasterDef();
    def.width = def.height = RASTER_SIDE;
    def.spacingX = def.spacingZ = 12.0;
    def.x = sea->middle.x - 0.5 * def.spacingX * (RASTER_SIDE - 1);
    def.z = sea->middle.z - 0.5 * def.spacingZ * (RASTER_SIDE - 1);
    def.values = values;
    swRaster* raster = NULL;
    Need(swCreateRaster(sea->host, &def, &raster), "a raster");
    return raster;
}

static void AddRaster(Sea* sea, swInputDef* def, float middle, float scale)
{
    swRaster* raster = MakeRaster(sea, middle, scale);
    def->raster = raster;
    def->position = (swPos){0.0, 0.0, 0.0};
    Add(sea, def);
    swDestroyRaster(raster);
}

static void AddDepth(Sea* sea)
{
    swInputDef def = At(sea, SW_INPUT_FLOOR, SW_SHAPE_RASTER, 0.0, 0.0, 300.0f);
    AddRaster(sea, &def, -14.0f, 6.0f);
    def = At(sea, SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, -90.0, 60.0, 160.0f);
    def.value[0] = -3.0f;
    Add(sea, &def);
    def = At(sea, SW_INPUT_FLOOR, SW_SHAPE_RECTANGLE, 100.0, -40.0, 140.0f);
    def.value[0] = 1.0f; // land
    def.rotation.yaw = 0.4f;
    def.blend = SW_BLEND_MAX;
    Add(sea, &def);
}

// ---- level ----

static void AddLevel(Sea* sea)
{
    swInputDef def = At(sea, SW_INPUT_LEVEL, SW_SHAPE_CIRCLE, 40.0, 90.0, 220.0f);
    def.value[0] = 2.0f;
    def.feather = 80.0f;
    Add(sea, &def);
    def = At(sea, SW_INPUT_FLOOR, SW_SHAPE_CIRCLE, 40.0, 90.0, 260.0f); // its bed
    def.value[0] = -4.0f;
    def.feather = 60.0f;
    Add(sea, &def);
    def = At(sea, SW_INPUT_LEVEL, SW_SHAPE_RECTANGLE, -180.0, -150.0, 60.0f);
    def.value[0] = 1.0f;
    def.feather = 0.0f; // a dam
    Add(sea, &def);
}

// Once for the whole sea.
static void AddTide(Sea* sea)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_LEVEL;
    def.blend = SW_BLEND_ADD;
    swSetTideConstituent("M2", 1.1f, 1.2f, &def.tide[0]);
    swSetTideConstituent("S2", 0.4f, 1.9f, &def.tide[1]);
    Add(sea, &def);
}

// ---- splines ----

// A closed line around a place, or an open one through it.
static swSpline* MakeLine(const Sea* sea, double x, double z, bool isClosed, float width)
{
    swSplinePoint points[6];
    for (int i = 0; i < 6; ++i)
    {
        double angle = 2.0 * SW_PI * i / 6.0;
        double alongX = isClosed ? 60.0 * cos(angle) : 50.0 * i - 125.0;
        double alongZ = isClosed ? 50.0 * sin(angle) : i % 2 == 0 ? -12.0 : 12.0;
        points[i] = swDefaultSplinePoint(sea->middle.x + x + alongX, 1.5 - 0.2 * i, sea->middle.z + z + alongZ);
        points[i].weight = 0.7f + 0.05f * (float)i;
        points[i].depth = 4.0f + 0.3f * (float)i;
        points[i].level = 0.1f * (float)i;
        points[i].width = 1.0f + 0.1f * (float)(i % 3);
        points[i].flow = 0.8f;
    }
    swSplineDef def = swDefaultSplineDef();
    def.points = points;
    def.pointCount = 6;
    def.isClosed = isClosed;
    def.width = width;
    def.startRamp = def.endRamp = isClosed ? 0.0f : 30.0f;
    swSpline* spline = NULL;
    Need(swCreateSpline(sea->host, &def, &spline), "a spline");
    return spline;
}

static swInputDef AlongLine(swInputField field, const swSpline* spline, float feather)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = SW_SHAPE_SPLINE;
    def.spline = spline;
    def.feather = feather;
    return def;
}

static void AddRiver(Sea* sea)
{
    swSpline* line = MakeLine(sea, 20.0, -190.0, false, 60.0f);
    swInputDef def = AlongLine(SW_INPUT_LEVEL, line, 20.0f);
    Add(sea, &def);
    def = AlongLine(SW_INPUT_FLOOR, line, 12.0f);
    Add(sea, &def);
    swDestroySpline(line);
}

static void AddFlow(Sea* sea)
{
    swInputDef def = At(sea, SW_INPUT_FLOW, SW_SHAPE_CIRCLE, 60.0, -40.0, 180.0f);
    def.value[0] = 0.9f;
    def.value[1] = -0.4f;
    def.feather = 60.0f;
    Add(sea, &def);
    swSpline* ring = MakeLine(sea, -60.0, 20.0, true, 70.0f);
    def = AlongLine(SW_INPUT_FLOW, ring, 25.0f);
    def.blend = SW_BLEND_ADD;
    Add(sea, &def);
    swDestroySpline(ring);
}

// Once for the whole sea.
static void AddCurrent(Sea* sea)
{
    swInputDef def = swDefaultInputDef();
    def.field = SW_INPUT_FLOW;
    def.value[0] = 0.3f;
    def.value[1] = 0.2f;
    def.order = -1;
    Add(sea, &def);
}

// Tiles along a ring that are nowhere else, and free waves along a line, which take the others of their system away.
static void AddRibbons(Sea* sea)
{
    swSpline* ring = MakeLine(sea, -70.0, -30.0, true, 80.0f);
    swInputDef def = AlongLine(SW_INPUT_WAVES, ring, 15.0f);
    def.alongSpline = true;
    def.heading = 0.5f;
    def.system = sea->along[0];
    Add(sea, &def);
    swDestroySpline(ring);
    swSpline* line = MakeLine(sea, 30.0, 70.0, false, 110.0f);
    def = AlongLine(SW_INPUT_WAVES, line, 30.0f);
    def.alongSpline = true;
    def.heading = 1.3f;
    def.system = sea->along[1];
    Add(sea, &def);
    swDestroySpline(line);
}

// ---- regions ----

static void AddPoints(Sea* sea, swInputDef* def)
{
    const swInputPoint points[] = {{-90.0f, -60.0f, 30.0f, 1.0f, {0.0f}},
                                   {80.0f, -75.0f, 50.0f, 0.7f, {-0.3f}},
                                   {40.0f, 10.0f, 40.0f, 0.9f, {0.2f}},
                                   {95.0f, 85.0f, 60.0f, 0.5f, {-0.4f}},
                                   {-70.0f, 60.0f, 35.0f, 1.0f, {0.1f}}};
    def->points = points;
    def->pointCount = 5;
    Add(sea, def);
}

static void AddRegions(Sea* sea)
{
    swInputDef def = At(sea, SW_INPUT_WAVES, SW_SHAPE_RASTER, 0.0, 0.0, 200.0f);
    def.system = sea->swell;
    AddRaster(sea, &def, 0.7f, 0.3f);
    def = At(sea, SW_INPUT_WAVES, SW_SHAPE_POLYGON, 60.0, 20.0, 60.0f);
    def.value[0] = 0.4f;
    def.rotation.yaw = 0.7f;
    def.system = sea->free;
    AddPoints(sea, &def);
    def = At(sea, SW_INPUT_WAVES, SW_SHAPE_PARTICLES, -60.0, -50.0, 60.0f);
    def.value[0] = 0.5f;
    AddPoints(sea, &def); // of all systems
    def = At(sea, SW_INPUT_WAVES, SW_SHAPE_CIRCLE, -120.0, 120.0, 140.0f);
    def.value[0] = 1.0f;
    def.feather = 60.0f;
    def.system = sea->regional;
    def.removesWaves = true;
    Add(sea, &def);
}

// ---- displacement ----

static void AddDisplaced(Sea* sea)
{
    swInputDef def = At(sea, SW_INPUT_DISPLACEMENT, SW_SHAPE_CIRCLE, -50.0, 40.0, 90.0f);
    def.blend = SW_BLEND_ADD;
    def.value[0] = 0.4f;
    def.value[1] = 1.2f;
    def.followsWaves = true;
    def.isBump = true;
    Add(sea, &def);
    def = At(sea, SW_INPUT_DISPLACEMENT, SW_SHAPE_RECTANGLE, 70.0, -60.0, 120.0f);
    def.blend = SW_BLEND_MULTIPLY;
    def.value[0] = def.value[1] = def.value[2] = 0.5f;
    def.followsWaves = true;
    def.rotation.yaw = 0.5f;
    Add(sea, &def);
    def = At(sea, SW_INPUT_DISPLACEMENT, SW_SHAPE_CIRCLE, 80.0, 70.0, 80.0f);
    def.blend = SW_BLEND_MIN;
    def.value[1] = -0.6f; // pressed down
    Add(sea, &def);
    def = At(sea, SW_INPUT_DISPLACEMENT, SW_SHAPE_CIRCLE, -110.0, -90.0, 70.0f);
    def.blend = SW_BLEND_ADD;
    def.value[1] = 0.7f;
    def.wavelength = 3.0f;
    Add(sea, &def);
}

// ---- other shapes ----

static void AddMesh(Sea* sea)
{
    static const swVec3 vertices[] = {{-120.0f, 0.0f, -90.0f}, {120.0f, 0.0f, -90.0f}, {-120.0f, 0.0f, 90.0f},
                                      {120.0f, 0.0f, 90.0f},   {-70.0f, 7.0f, 5.0f},   {60.0f, 4.0f, -10.0f}};
    static const uint32_t faces[] = {0, 1, 5, 0, 5, 4, 0, 4, 2, 2, 4, 3, 4, 5, 3, 5, 1, 3};
    swMeshDef meshDef = swDefaultMeshDef();
    meshDef.vertices = vertices;
    meshDef.vertexCount = 6;
    meshDef.indices = faces;
    meshDef.triangleCount = 6;
    swMesh* mesh = NULL;
    Need(swCreateMesh(sea->host, &meshDef, &mesh), "a mesh");
    swInputDef def = At(sea, SW_INPUT_FLOOR, SW_SHAPE_MESH, 120.0, 150.0, 1.0f);
    def.mesh = mesh;
    def.position.y = -9.0;
    def.rotation.yaw = 0.3f;
    def.feather = 30.0f;
    Add(sea, &def);
    swDestroyMesh(mesh);
}

static void AddShapes(Sea* sea)
{
    AddMesh(sea);
    const swInputShape shapes[] = {SW_SHAPE_POLYGON, SW_SHAPE_POLYLINE, SW_SHAPE_PARTICLES};
    for (int i = 0; i < 3; ++i)
    {
        swInputDef def = At(sea, SW_INPUT_FLOOR, shapes[i], 90.0 * i - 130.0, 40.0 * i - 120.0, 60.0f);
        def.value[0] = -6.0f;
        def.rotation.yaw = 0.7f - 0.4f * (float)i;
        def.feather = 25.0f;
        AddPoints(sea, &def);
    }
}

// ---- holes ----

// A box with a notch in its deck.
static swHull* MakeHull(const Sea* sea)
{
    static const swVec3 corners[] = {{-20, -3, -8}, {20, -3, -8}, {20, -3, 8}, {-20, -3, 8}, {-20, 4, -8},
                                     {20, 4, -8},   {20, 4, 8},   {-20, 4, 8}, {0, 1, 0}};
    static const uint32_t faces[] = {0, 1, 2, 0, 2, 3, 0, 4, 5, 0, 5, 1, 1, 5, 6, 1, 6, 2, 2, 6, 7,
                                     2, 7, 3, 3, 7, 4, 3, 4, 0, 4, 8, 5, 5, 8, 6, 6, 8, 7, 7, 8, 4};
    swHullDef def = swDefaultHullDef();
    def.vertices = corners;
    def.vertexCount = 9;
    def.indices = faces;
    def.triangleCount = 14;
    swHull* hull = NULL;
    Need(swCreateHull(sea->host, &def, &hull), "a hull");
    return hull;
}

static void AddHoles(Sea* sea)
{
    const swInputShape shapes[] = {SW_SHAPE_BOX,     SW_SHAPE_ELLIPSOID, SW_SHAPE_CYLINDER,
                                   SW_SHAPE_CAPSULE, SW_SHAPE_CIRCLE,    SW_SHAPE_HULL};
    swHull* hull = MakeHull(sea);
    for (int i = 0; i < 6; ++i)
    {
        swInputDef def =
            At(sea, SW_INPUT_CLIP, shapes[i], 90.0 * (i % 3) - 110.0, 120.0 * (double)(i / 3) - 60.0, 40.0f);
        def.value[0] = 1.0f;
        def.size.y = 3.0f; // waves leave and enter it
        def.position.y = 0.5;
        def.rotation = (swAngles){.yaw = 0.4f, .pitch = i < 3 ? 0.1f : 0.0f};
        def.feather = 0.0f;
        def.hull = shapes[i] == SW_SHAPE_HULL ? hull : NULL;
        Add(sea, &def);
    }
    swDestroyHull(hull);
    swInputDef def = At(sea, SW_INPUT_CLIP, SW_SHAPE_POLYGON, 170.0, 30.0, 60.0f);
    def.value[0] = 1.0f;
    def.feather = 0.0f;
    AddPoints(sea, &def);
}

// ---- bodies of water ----

static void AddBodies(Sea* sea)
{
    const swVec2 shore[] = {{-40.0f, -30.0f}, {30.0f, -40.0f}, {50.0f, 35.0f}, {-10.0f, 20.0f}, {-35.0f, 40.0f}};
    for (int i = 0; i < 2; ++i)
    {
        swWaterBodyDef def = swDefaultWaterBodyDef();
        def.points = shore;
        def.pointCount = 5;
        def.position = (swPos){sea->middle.x + 110.0 - 220.0 * i, 1.5 + i, sea->middle.z + 190.0 - 400.0 * i};
        def.isCalm = i == 0;
        def.waves = i == 0 ? sea->regional : (swWaveSystemId){0};
        def.wavesFeather = 10.0f;
        swWaterBodyId id;
        Need(swCreateWaterBody(sea->world, &def, &id), "a body of water");
    }
}

// ---- all of them ----

static const struct
{
    const char* name;
    void (*add)(Sea* sea);
} known[FEATURE_COUNT] = {
    [FEATURE_DEPTH] = {"depth", AddDepth},
    [FEATURE_LEVEL] = {"level, tide, dam", AddLevel},
    [FEATURE_RIVER] = {"river", AddRiver},
    [FEATURE_FLOW] = {"flow", AddFlow},
    [FEATURE_DISPLACED] = {"displacement", AddDisplaced},
    [FEATURE_REGIONS] = {"regions of waves", AddRegions},
    [FEATURE_RIBBONS] = {"waves along splines", AddRibbons},
    [FEATURE_SHAPES] = {"floors of all shapes", AddShapes},
    [FEATURE_HOLES] = {"holes", AddHoles},
    [FEATURE_BODIES] = {"bodies of water", AddBodies},
};

const char* GetFeatureName(Feature feature)
{
    return known[feature].name;
}

static swWaveSystemId AddWaves(Sea* sea, swWaveMethod method, float windSpeed, float direction, bool isLocal)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = method;
    def.seed = ++sea->seed;
    def.isLocal = isLocal;
    def.spectrum.windSpeed = windSpeed;
    def.spectrum.fetch = 60e3f;
    def.spectrum.direction = direction;
    def.chop = 0.8f;
    def.minWavelength = method == SW_WAVES_FFT ? 0.25f : 1.0f;
    swWaveSystemId id;
    Need(swCreateWaveSystem(sea->world, &def, &id), "a wave system");
    return id;
}

swWorld* MakeEverything(const swHost* host, uint32_t features, int placeCount, const swPosXZ* places)
{
    swWorldDef def = swDefaultWorldDef();
    def.enableVelocity = true;
    Sea sea = {.host = host, .seed = 300};
    Need(swCreateWorld(host, &def, &sea.world), "a world");
    sea.wind = AddWaves(&sea, SW_WAVES_FFT, 7.0f, 0.3f, false);
    sea.swell = AddWaves(&sea, SW_WAVES_FFT, 5.0f, 2.0f, false);
    sea.free = AddWaves(&sea, SW_WAVES_GERSTNER, 4.0f, -1.1f, false);
    if ((features & (1u << FEATURE_REGIONS | 1u << FEATURE_BODIES)) != 0)
    {
        sea.regional = AddWaves(&sea, SW_WAVES_FFT, 5.0f, 4.0f, true);
    }
    if ((features & 1u << FEATURE_RIBBONS) != 0)
    {
        sea.along[0] = AddWaves(&sea, SW_WAVES_FFT, 4.0f, 0.0f, true);
        sea.along[1] = AddWaves(&sea, SW_WAVES_GERSTNER, 4.0f, 0.2f, false);
    }
    if ((features & 1u << FEATURE_LEVEL) != 0)
    {
        AddTide(&sea);
    }
    if ((features & 1u << FEATURE_FLOW) != 0)
    {
        AddCurrent(&sea);
    }
    for (int p = 0; p < placeCount; ++p)
    {
        sea.middle = places[p];
        for (int f = 0; f < FEATURE_COUNT; ++f)
        {
            if ((features >> f & 1u) != 0)
            {
                known[f].add(&sea);
            }
        }
    }
    return sea.world;
}
