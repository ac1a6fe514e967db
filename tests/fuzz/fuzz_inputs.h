// SPDX-License-Identifier: MIT
#pragma once

// Worlds with inputs, for fuzz targets: resources of each kind, waves that are cheap, and what must be true of answers.

#include "fuzz_bytes.h"
#include "seaway/seaway.h"

#define FUZZ_POINTS 24

typedef struct Resources
{
    swRaster *heights, *pairs;
    swMesh* mesh;
    swHull* hull;
    swSpline* spline;
} Resources;

static inline swHost FuzzHost(int* messages)
{
    swHost host = swDefaultHost();
    host.log = CountMessage;
    host.logContext = messages;
    return host;
}

static inline swRaster* MakeFuzzRaster(const swHost* host, int channels)
{
    float values[4 * 3 * 2];
    for (int i = 0; i < 12 * channels; ++i)
    {
        values[i] = i == 5 ? NAN : 0.25f * (float)(i * 7 % 11) - 2.0f;
    }
    swRasterDef def = swDefaultRasterDef();
    def.width = 4;
    def.height = 3;
    def.channels = channels;
    def.x = def.z = -60.0;
    def.spacingX = def.spacingZ = 40.0;
    def.values = values;
    swRaster* raster = NULL;
    FUZZ_CHECK(swCreateRaster(host, &def, &raster) == SW_SUCCESS);
    return raster;
}

static inline Resources MakeResources(const swHost* host)
{
    static const swVec3 corners[4] = {
        {0.0f, 5.0f, 0.0f}, {30.0f, -5.0f, 0.0f}, {0.0f, -5.0f, 30.0f}, {-20.0f, -5.0f, -20.0f}};
    static const uint32_t faces[12] = {0, 2, 1, 0, 3, 2, 0, 1, 3, 1, 2, 3};
    const swSplinePoint points[3] = {swDefaultSplinePoint(-70.0, 5.0, 0.0), swDefaultSplinePoint(0.0, -20.0, -1.0),
                                     swDefaultSplinePoint(60.0, 30.0, -2.0)};
    Resources resources = {.heights = MakeFuzzRaster(host, 1), .pairs = MakeFuzzRaster(host, 2)};
    swMeshDef mesh = swDefaultMeshDef();
    mesh.vertices = corners;
    mesh.vertexCount = 4;
    mesh.indices = faces;
    mesh.triangleCount = 4;
    FUZZ_CHECK(swCreateMesh(host, &mesh, &resources.mesh) == SW_SUCCESS);
    swHullDef hull = swDefaultHullDef();
    hull.vertices = corners;
    hull.vertexCount = 4;
    hull.indices = faces;
    hull.triangleCount = 4;
    hull.resolution = 8;
    FUZZ_CHECK(swCreateHull(host, &hull, &resources.hull) == SW_SUCCESS);
    swSplineDef spline = swDefaultSplineDef();
    spline.points = points;
    spline.pointCount = 3;
    FUZZ_CHECK(swCreateSpline(host, &spline, &resources.spline) == SW_SUCCESS);
    return resources;
}

static inline void DestroyResources(Resources* resources)
{
    swDestroyRaster(resources->heights);
    swDestroyRaster(resources->pairs);
    swDestroyMesh(resources->mesh);
    swDestroyHull(resources->hull);
    swDestroySpline(resources->spline);
}

static inline bool FindFuzzResource(void* context, swResourceKind kind, uint64_t hash, const char* name,
                                    swResource* resource)
{
    const Resources* resources = context;
    (void)kind;
    (void)name;
    resource->raster = swRaster_GetInfo(resources->heights).hash == hash ? resources->heights : resources->pairs;
    resource->mesh = resources->mesh;
    resource->hull = resources->hull;
    resource->spline = resources->spline;
    return true;
}

// A world with two waves, which a current may carry.
static inline swWorld* MakeFuzzWorld(const swHost* host, swWaveSystemId* waves)
{
    const swWaveComponent components[2] = {{.wavelength = 60.0f, .amplitude = 0.8f, .direction = 0.3f},
                                           {.wavelength = 7.0f, .amplitude = 0.1f, .direction = 2.0f}};
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    FUZZ_CHECK(swCreateWorld(host, &worldDef, &world) == SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.method = SW_WAVES_GERSTNER;
    def.components = components;
    def.componentCount = 2;
    FUZZ_CHECK(swCreateWaveSystem(world, &def, waves) == SW_SUCCESS);
    return world;
}

typedef struct Answers
{
    float depth[FUZZ_POINTS], floor[FUZZ_POINTS], level[FUZZ_POINTS], weight[FUZZ_POINTS], clip[FUZZ_POINTS];
    float foam[FUZZ_POINTS], shadow[FUZZ_POINTS], height[FUZZ_POINTS];
    swVec2 flow[FUZZ_POINTS], wind[FUZZ_POINTS];
    swVec3 displacement[FUZZ_POINTS], normal[FUZZ_POINTS];
    swVec4 albedo[FUZZ_POINTS];
    int body[FUZZ_POINTS];
} Answers;

// Ask about places near the inputs, in their edges, and far away.
static inline void AskFuzzWorld(const swMoment* moment, Answers* answers)
{
    static const double places[8] = {0.0, 1.0, -35.0, 64.0, 127.999, -128.0, 500.25, 1e6};
    swPosXZ points[FUZZ_POINTS];
    for (int i = 0; i < FUZZ_POINTS; ++i)
    {
        points[i] = (swPosXZ){places[i % 8], places[i * 3 / 8 % 8]};
    }
    memset(answers, 0, sizeof *answers);
    const swFieldSamples fields = {.depth = answers->depth,
                                   .floor = answers->floor,
                                   .level = answers->level,
                                   .flow = answers->flow,
                                   .weight = answers->weight,
                                   .clip = answers->clip,
                                   .foam = answers->foam,
                                   .albedo = answers->albedo,
                                   .wind = answers->wind,
                                   .shadow = answers->shadow,
                                   .displacement = answers->displacement,
                                   .body = answers->body};
    FUZZ_CHECK(swMoment_QueryFields(moment, FUZZ_POINTS, points, &fields) == 0);
    swQueryDef def = swDefaultQueryDef();
    const swSurfaceSamples surface = {.height = answers->height, .normal = answers->normal};
    swMoment_QuerySurface(moment, &def, FUZZ_POINTS, points, &surface, NULL);
}

// Of a world whose inputs were all taken: every answer is a number.
static inline void CheckFuzzAnswers(const Answers* answers)
{
    for (int i = 0; i < FUZZ_POINTS; ++i)
    {
        FUZZ_CHECK(!isnan(answers->depth[i]) && !isnan(answers->floor[i]));
        FUZZ_CHECK(isfinite(answers->level[i]) && isfinite(answers->weight[i]) && isfinite(answers->clip[i]));
        FUZZ_CHECK(isfinite(answers->foam[i]) && isfinite(answers->shadow[i]) && isfinite(answers->height[i]));
        FUZZ_CHECK(isfinite(answers->flow[i].x) && isfinite(answers->flow[i].y));
        FUZZ_CHECK(isfinite(answers->wind[i].x) && isfinite(answers->wind[i].y));
        FUZZ_CHECK(isfinite(answers->displacement[i].x) && isfinite(answers->displacement[i].y));
        FUZZ_CHECK(isfinite(answers->normal[i].x) && isfinite(answers->normal[i].y));
        FUZZ_CHECK(isfinite(answers->albedo[i].x) && isfinite(answers->albedo[i].w));
        FUZZ_CHECK(answers->body[i] >= -1);
    }
}
