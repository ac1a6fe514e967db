// SPDX-License-Identifier: MIT
// Digest of a simulated sea: three wave systems that change, a moving view with layers and foam on the CPU, queries of
// heights, velocities, the water below and other times, rays. Half way the world is saved, and another one, made of its
// bytes, goes on. Two machines, compilers, instruction sets or thread counts agree exactly if their digests do.
//
//   sea_digest [--isa scalar|sse2|avx2|neon|avx512|best] [--threads N] [--minutes M]    print one digest
//   sea_digest --compare [--minutes M]       all instruction sets of this machine with 1, 2 and 5 threads
//   sea_digest --expect FILE                 digests of several seas, part by part, against those that are committed
//   sea_digest --list                        the same digests, as FILE has them
//
// Public headers only: scripts/determinism builds it with every compiler at hand, also for AArch64.
#include <seaway/seaway.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STEP_SECONDS 2.0
#define POINT_COUNT 257
#define EMPTY_HASH 0xcbf29ce484222325u

typedef struct Run
{
    swIsa isa;
    int threads; // the caller's among them
    double minutes;
    bool isQuiet; // an instruction set that this machine lacks is no error
} Run;

// What of a sea differs is told apart: its waves, what queries answer, what layers hold.
typedef struct Parts
{
    uint64_t waves, queries, layers;
} Parts;

// FNV-1a, 64 bits.
static uint64_t Hash(uint64_t hash, const void* data, size_t size)
{
    const unsigned char* bytes = data;
    for (size_t i = 0; i < size; ++i)
    {
        hash = (hash ^ bytes[i]) * 0x100000001b3u;
    }
    return hash;
}

static swResult AddWaves(swWorld* world)
{
    swWaveSystemId id;
    swWaveSystemDef windSea = swDefaultWaveSystemDef();
    windSea.spectrum.kind = SW_SPECTRUM_ELFOUHAILY;
    windSea.spectrum.windSpeed = 14.0f;
    windSea.spectrum.spreading = SW_SPREADING_DONELAN_BANNER;
    windSea.spectrum.turbulence = 0.1f;
    windSea.spectrum.swell = 0.4f;
    windSea.resolution = 64;
    windSea.tileWaves = 16;
    swResult result = swCreateWaveSystem(world, &windSea, &id);

    swWaveSystemDef swell = swDefaultWaveSystemDef();
    swell.spectrum.kind = SW_SPECTRUM_TMA;
    swell.spectrum.depth = 40.0f;
    swell.spectrum.spreading = SW_SPREADING_HASSELMANN;
    swell.spectrum.significantHeight = 1.5f;
    swell.spectrum.peakPeriod = 13.0f;
    swell.spectrum.direction = 2.0f;
    swell.resolution = 32;
    swell.tileWaves = 8;
    swell.minWavelength = 64.0f;
    swell.seed = 7;
    result = result != SW_SUCCESS ? result : swCreateWaveSystem(world, &swell, &id);

    swWaveSystemDef cross = swDefaultWaveSystemDef();
    cross.method = SW_WAVES_GERSTNER;
    cross.spectrum.significantHeight = 0.8f;
    cross.spectrum.direction = -1.0f;
    cross.componentsPerOctave = 4;
    cross.reverseWeight = 0.3f;
    return result != SW_SUCCESS ? result : swCreateWaveSystem(world, &cross, &id);
}

// The wind turns wave by wave, and later another sea takes over.
static swResult ChangeWaves(swWorld* world, int step)
{
    swWaveSystemId first = {1, 1};
    swWaveSystemDef def = swWaveSystem_Get(world, first);
    def.spectrum.direction = 0.1f * (float)step;
    def.seed += step % 40 == 0 ? 1 : 0;
    return swWaveSystem_Set(world, first, &def, 6.0 * STEP_SECONDS);
}

static uint64_t HashQueries(uint64_t hash, const swWorld* world)
{
    swPosXZ points[POINT_COUNT];
    float heights[POINT_COUNT];
    swVec3 normals[POINT_COUNT];
    swVec3 velocities[POINT_COUNT];
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        points[i].x = 1.0e5 + 7.25 * i;
        points[i].z = -3.0e4 + 0.125 * i * i;
    }
    swQueryDef def = swDefaultQueryDef();
    swSurfaceSamples samples = {.height = heights, .normal = normals, .velocity = velocities};
    swMoment_QuerySurface(swWorld_GetMoment(world), &def, POINT_COUNT, points, &samples, NULL);
    hash = Hash(hash, heights, sizeof(heights));
    hash = Hash(hash, normals, sizeof(normals));
    hash = Hash(hash, velocities, sizeof(velocities)); // from their own tiles

    // A few at another time, and of the water below, wave by wave.
    enum
    {
        FEW = 8
    };
    swVec3 motion[FEW];
    swPos places[FEW];
    def.time = -12345.678;
    samples = (swSurfaceSamples){.height = heights, .acceleration = motion};
    swMoment_QuerySurface(swWorld_GetMoment(world), &def, FEW, points, &samples, NULL);
    hash = Hash(hash, heights, FEW * sizeof(float));
    hash = Hash(hash, motion, sizeof(motion));
    def.time = SW_QUERY_NOW;
    for (int i = 0; i < FEW; ++i)
    {
        places[i] = (swPos){points[i].x, -1.0 - 2.0 * i, points[i].z};
    }
    swVolumeSamples below = {.velocity = motion, .pressureHead = heights};
    swMoment_QueryVolume(swWorld_GetMoment(world), &def, FEW, places, &below, NULL);
    hash = Hash(hash, heights, FEW * sizeof(float));
    return Hash(hash, motion, sizeof(motion));
}

// From a mast down to the sea all around, and back up from below.
static uint64_t HashRays(uint64_t hash, const swWorld* world)
{
    enum
    {
        RAYS = 16
    };
    swRay rays[RAYS];
    swRayHit hits[RAYS];
    for (int i = 0; i < RAYS; ++i)
    {
        float up = i % 4 == 3 ? 1.0f : -1.0f;
        swPos origin = {1.0e5 + 3.5 * i, up > 0.0f ? -20.0 : 25.0, -3.0e4 - 1.75 * i};
        rays[i] = swDefaultRay(origin, (swVec3){0.25f * (float)(i - 8), up, 0.125f * (float)i});
        rays[i].radius = i % 2 == 0 ? 0.0f : 0.5f;
        rays[i].maxDistance = 200.0f;
    }
    swQueryDef def = swDefaultQueryDef();
    def.minWavelength = 1.0f;
    swMoment_CastRays(swWorld_GetMoment(world), &def, RAYS, rays, hits, NULL);
    for (int i = 0; i < RAYS; ++i)
    {
        hash = Hash(hash, &hits[i].distance, sizeof(hits[i].distance));
        hash = Hash(hash, &hits[i].point, sizeof(hits[i].point));
        hash = Hash(hash, &hits[i].normal, sizeof(hits[i].normal));
    }
    return hash;
}

// The world is another one afterwards; its digest is that of before.
static swResult SaveAndRestore(const swHost* host, swIsa isa, swWorld** world, swView** view)
{
    size_t size = 0;
    swResult result = swWorld_Save(*world, NULL, &size);
    void* data = malloc(size);
    swWorld* restored = NULL;
    swRestoreDef def = swDefaultRestoreDef();
    def.isa = isa;
    result = data == NULL ? SW_ERROR_NO_MEMORY : result;
    result = result == SW_SUCCESS ? swWorld_Save(*world, data, &size) : result;
    result = result == SW_SUCCESS ? swRestoreWorld(host, data, size, &def, &restored) : result;
    free(data);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (swWorld_GetDigest(restored) != swWorld_GetDigest(*world))
    {
        fprintf(stderr, "sea_digest: a restored world has another digest\n");
        result = SW_ERROR_FORMAT;
    }
    swDestroyWorld(*world);
    *world = restored;
    *view = swWorld_GetView(restored, 0);
    return result;
}

static uint64_t HashLayers(uint64_t hash, const swView* view)
{
    for (int slice = 0; slice < swView_GetSliceCount(view); ++slice)
    {
        size_t resolution = (size_t)swView_GetSlice(view, slice).resolution;
        size_t texels = resolution * resolution;
        hash = Hash(hash, swView_GetDisplacement(view, slice), 4 * texels * sizeof(float));
        hash = Hash(hash, swView_GetDerivatives(view, slice), 4 * texels * sizeof(float));
        hash = Hash(hash, swView_GetFoam(view, slice), texels * sizeof(float));
    }
    return hash;
}

static swResult Sail(const swHost* host, const Run* run, swWorld** worldPlace, Parts* parts)
{
    swWorld* world = *worldPlace;
    swView* view = swWorld_GetView(world, 0);
    int stepCount = (int)(run->minutes * 60.0 / STEP_SECONDS);
    *parts = (Parts){EMPTY_HASH, EMPTY_HASH, EMPTY_HASH};
    for (int step = 1; step <= stepCount; ++step)
    {
        swView_SetViewpoint(view, (swPos){1.0e5 + 12.0 * step, 2.0 + 2.0 * step, -3.0e4});
        swResult result = swWorld_Step(world, STEP_SECONDS);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        uint64_t tiles = swWorld_GetDigest(world);
        parts->waves = Hash(parts->waves, &tiles, sizeof(tiles));
        if (step % 20 == 0 && ChangeWaves(world, step) != SW_SUCCESS)
        {
            return SW_ERROR_LIMIT;
        }
        if (step % 10 == 0)
        {
            parts->queries = HashRays(HashQueries(parts->queries, world), world);
            parts->layers = HashLayers(parts->layers, view);
        }
        if (step == stepCount / 2)
        {
            result = SaveAndRestore(host, run->isa, &world, &view);
            *worldPlace = world;
            if (result != SW_SUCCESS)
            {
                return result;
            }
        }
    }
    return SW_SUCCESS;
}

static swResult MakeParts(const Run* run, Parts* parts)
{
    swHost host = swDefaultHost();
    host.log = run->isQuiet ? NULL : host.log;
    swTaskPool* pool = NULL;
    swWorld* world = NULL;
    swView* view = NULL;
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.isa = run->isa;
    worldDef.enableVelocity = true;
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = 4;
    viewDef.resolution = 64;
    viewDef.enableCpuLayers = true;

    swResult result = swCreateTaskPool(&host, run->threads - 1, &pool);
    if (result == SW_SUCCESS)
    {
        swTaskPool_Attach(pool, &host);
        result = swCreateWorld(&host, &worldDef, &world);
    }
    result = result != SW_SUCCESS ? result : AddWaves(world);
    result = result != SW_SUCCESS ? result : swCreateView(world, &viewDef, &view);
    result = result != SW_SUCCESS ? result : Sail(&host, run, &world, parts);
    swDestroyWorld(world);
    swDestroyTaskPool(pool);
    return result;
}

static swResult MakeDigest(const Run* run, uint64_t* digest)
{
    Parts parts = {0, 0, 0};
    swResult result = MakeParts(run, &parts);
    *digest = Hash(EMPTY_HASH, &parts, sizeof(parts));
    return result;
}

// A wind that has gusts and turns from place to place, with a sea that follows it and removes the other; a particle
// that follows the waves, and a plate that presses them down.
static swResult AddRegions(swWorld* world)
{
    static const float winds[2 * 3 * 2] = {9.0f, 1.0f, 7.0f, 6.0f, -2.0f, 8.0f, 10.0f, 0.0f, 6.0f, 7.0f, 0.0f, 5.0f};
    swHost host = swDefaultHost();
    swWindDef wind = swDefaultWindDef();
    wind.speed = 9.0f;
    wind.gustStrength = 0.12f;
    swResult result = swWorld_SetWind(world, &wind, 30.0);
    swRasterDef map = swDefaultRasterDef();
    map.width = 3;
    map.height = 2;
    map.channels = 2;
    map.x = map.z = -150.0;
    map.spacingX = map.spacingZ = 300.0;
    map.values = winds;
    swRaster* raster = NULL;
    result = result != SW_SUCCESS ? result : swCreateRaster(&host, &map, &raster);
    swWindSeaDef sea = swDefaultWindSeaDef();
    sea.raster = raster;
    sea.waves.resolution = 32;
    sea.waves.tileWaves = 8;
    sea.waves.minWavelength = 4.0f;
    sea.waves.seed = 11;
    sea.feather = 40.0f;
    sea.removesWaves = true;
    sea.headingCount = 8;
    swWindSea made;
    result = result != SW_SUCCESS ? result : swCreateWindSea(world, &sea, &made);
    swDestroyRaster(raster);
    swInputId id;
    swInputDef bump = swDefaultInputDef();
    bump.field = SW_INPUT_DISPLACEMENT;
    bump.shape = SW_SHAPE_CIRCLE;
    bump.blend = SW_BLEND_ADD;
    bump.isBump = bump.followsWaves = true;
    bump.value[0] = 0.5f;
    bump.value[1] = 1.0f;
    result = result != SW_SUCCESS ? result : swCreateInput(world, &bump, &id);
    swInputDef plate = bump;
    plate.isBump = plate.followsWaves = false;
    plate.blend = SW_BLEND_MIN;
    plate.value[0] = plate.value[1] = 0.0f;
    plate.size.x = 30.0f;
    plate.feather = 5.0f;
    plate.position = (swPos){20.0, -0.5, 10.0};
    return result != SW_SUCCESS ? result : swCreateInput(world, &plate, &id);
}

// A river whose water flows, and a polygon in which there are other waves, where it ends.
static swResult AddRiver(swWorld* world, swPos place)
{
    swHost host = swDefaultHost();
    const swSplinePoint line[] = {swDefaultSplinePoint(0.0, 0.0, 0.0), swDefaultSplinePoint(300.0, 150.0, 0.0),
                                  swDefaultSplinePoint(700.0, 100.0, 0.0), swDefaultSplinePoint(1000.0, 400.0, 0.0)};
    swSplineDef splineDef = swDefaultSplineDef();
    splineDef.points = line;
    splineDef.pointCount = 4;
    splineDef.width = 220.0f;
    swSpline* spline = NULL;
    swResult result = swCreateSpline(&host, &splineDef, &spline);
    swInputId id;
    swInputDef river = swDefaultInputDef();
    river.field = SW_INPUT_FLOW;
    river.shape = SW_SHAPE_SPLINE;
    river.spline = spline;
    river.position = place;
    river.feather = 60.0f;
    result = result != SW_SUCCESS ? result : swCreateInput(world, &river, &id);
    swDestroySpline(spline);
    const swInputPoint shore[] = {{.x = 0.0f, .z = 0.0f}, {.x = 900.0f, .z = -200.0f}, {.x = 700.0f, .z = 900.0f}};
    swInputDef calm = swDefaultInputDef();
    calm.field = SW_INPUT_WAVES;
    calm.shape = SW_SHAPE_POLYGON;
    calm.points = shore;
    calm.pointCount = 3;
    calm.position = (swPos){place.x + 400.0, 0.0, place.z};
    calm.feather = 80.0f;
    calm.value[0] = 0.4f;
    return result != SW_SUCCESS ? result : swCreateInput(world, &calm, &id);
}

// A floor, a lake, a tide and a river where queries and rays ask.
static swResult AddInputs(swWorld* world)
{
    const swPos place = {1.0e5, 0.0, -3.0e4};
    static const float depths[2 * 3] = {-40.0f, -12.0f, -5.0f, -25.0f, -8.0f, -15.0f};
    swHost host = swDefaultHost();
    swRasterDef chart = swDefaultRasterDef();
    chart.width = 3;
    chart.height = 2;
    chart.x = place.x - 200.0;
    chart.z = place.z - 200.0;
    chart.spacingX = 900.0;
    chart.spacingZ = 1500.0;
    chart.values = depths;
    swRaster* raster = NULL;
    swResult result = swCreateRaster(&host, &chart, &raster);
    swInputId id;
    swInputDef floor = swDefaultInputDef();
    floor.shape = SW_SHAPE_RASTER;
    floor.raster = raster;
    floor.feather = 100.0f;
    result = result != SW_SUCCESS ? result : swCreateInput(world, &floor, &id);
    swDestroyRaster(raster);
    swInputDef level = swDefaultInputDef();
    level.field = SW_INPUT_LEVEL;
    level.shape = SW_SHAPE_CIRCLE;
    level.size = (swVec3){500.0f, 0.0f, 500.0f};
    level.position = place;
    level.feather = 120.0f;
    level.value[0] = 3.0f;
    result = result != SW_SUCCESS ? result : swCreateInput(world, &level, &id);
    swInputDef tide = swDefaultInputDef();
    tide.field = SW_INPUT_LEVEL;
    tide.blend = SW_BLEND_ADD;
    tide.order = 1;
    bool isKnown =
        swSetTideConstituent("M2", 2.1f, 1.2f, &tide.tide[0]) && swSetTideConstituent("S2", 0.7f, 1.9f, &tide.tide[1]);
    result = result == SW_SUCCESS && !isKnown ? SW_ERROR_INVALID : result;
    result = result != SW_SUCCESS ? result : swCreateInput(world, &tide, &id);
    return result != SW_SUCCESS ? result : AddRiver(world, place);
}

// All of it in a tidal stream, which carries the waves by its path.
static swResult AddTidalStream(swWorld* world)
{
    swInputDef stream = swDefaultInputDef();
    stream.field = SW_INPUT_FLOW;
    stream.order = -1;
    stream.value[0] = 0.75f;
    bool isKnown = swSetTideConstituent("M2", 1.3f, 0.8f, &stream.tide[0]);
    stream.tide[0].amplitudeAcross = 0.4f;
    stream.tide[0].phaseAcross = 2.0f;
    swInputId id;
    swResult result = isKnown ? swCreateInput(world, &stream, &id) : SW_ERROR_INVALID;
    return result != SW_SUCCESS ? result : AddInputs(world);
}

typedef swResult AddFcn(swWorld* world);

// One system, a minute in, with whatever is added to it, and what is asked of it.
static swResult MakeSmallParts(const swWaveSystemDef* def, AddFcn* add, Parts* parts)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableVelocity = true;
    swWorld* world = NULL;
    swWaveSystemId id;
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = 2;
    viewDef.resolution = 64;
    viewDef.enableCpuLayers = true;
    swView* view = NULL;
    swResult result = swCreateWorld(&host, &worldDef, &world);
    result = result != SW_SUCCESS ? result : swCreateWaveSystem(world, def, &id);
    result = result == SW_SUCCESS && add != NULL ? add(world) : result;
    result = result != SW_SUCCESS ? result : swCreateView(world, &viewDef, &view);
    if (result == SW_SUCCESS && (add == AddInputs || add == AddTidalStream))
    {
        swView_SetViewpoint(view, (swPos){1.0e5, 5.0, -3.0e4}); // where the inputs are
    }
    result = result != SW_SUCCESS ? result : swWorld_Step(world, 60.0);
    result = result != SW_SUCCESS ? result : swWorld_Step(world, 0.25);
    if (result == SW_SUCCESS)
    {
        uint64_t digest = swWorld_GetDigest(world);
        parts->waves = Hash(EMPTY_HASH, &digest, sizeof(digest));
        parts->queries = HashRays(HashQueries(EMPTY_HASH, world), world);
        parts->layers = HashLayers(EMPTY_HASH, view);
    }
    swDestroyWorld(world);
    return result;
}

static swWaveSystemDef MakeKind(swSpectrumKind kind)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum.kind = kind;
    def.resolution = 64;
    def.tileWaves = 16;
    return def;
}

enum
{
    FREQUENCIES = 12,
    DIRECTIONS = 8
};

// A table of a swell from one direction and a wind sea from another.
static swSpectrumTable MakeTable(float* frequencies, float* bandwidths, float* density)
{
    for (int i = 0; i < FREQUENCIES; ++i)
    {
        frequencies[i] = 0.0625f + 0.03125f * (float)i;
        bandwidths[i] = 0.03125f;
        for (int j = 0; j < DIRECTIONS; ++j)
        {
            float swell = i == 1 && j == 2 ? 4.0f : 0.0f;
            float wind = j >= 4 && j <= 6 ? 0.5f / (float)(1 + (i > 5 ? i - 5 : 5 - i)) : 0.0f;
            density[i * DIRECTIONS + j] = swell + wind;
        }
    }
    return (swSpectrumTable){.frequencyCount = FREQUENCIES,
                             .directionCount = DIRECTIONS,
                             .frequencies = frequencies,
                             .bandwidths = bandwidths,
                             .density = density};
}

typedef struct Line
{
    char name[32];
    Parts parts;
} Line;

enum
{
    MAX_LINES = 16
};

static swResult AddLine(Line* lines, int* count, const char* name, const swWaveSystemDef* def)
{
    AddFcn* add = strcmp(name, "regions") == 0        ? AddRegions
                  : strcmp(name, "inputs") == 0       ? AddInputs
                  : strcmp(name, "tidal_stream") == 0 ? AddTidalStream
                                                      : NULL;
    Line* line = &lines[(*count)++];
    snprintf(line->name, sizeof(line->name), "%s", name);
    if (def != NULL)
    {
        return MakeSmallParts(def, add, &line->parts);
    }
    Run run = {SW_ISA_BEST, 1, 1.0, false};
    return MakeParts(&run, &line->parts);
}

// The seas whose digests are committed.
static swResult MakeLines(Line* lines, int* count)
{
    static const struct
    {
        const char* name;
        swSpectrumKind kind;
    } kinds[] = {{"octaves", SW_SPECTRUM_OCTAVES},       {"pierson_moskowitz", SW_SPECTRUM_PIERSON_MOSKOWITZ},
                 {"jonswap", SW_SPECTRUM_JONSWAP},       {"tma", SW_SPECTRUM_TMA},
                 {"elfouhaily", SW_SPECTRUM_ELFOUHAILY}, {"phillips", SW_SPECTRUM_PHILLIPS}};
    *count = 0;
    swResult result = AddLine(lines, count, "three_systems", NULL);
    for (int i = 0; result == SW_SUCCESS && i < (int)(sizeof(kinds) / sizeof(kinds[0])); ++i)
    {
        swWaveSystemDef def = MakeKind(kinds[i].kind);
        def.spectrum.depth = kinds[i].kind == SW_SPECTRUM_TMA ? 20.0f : def.spectrum.depth;
        result = AddLine(lines, count, kinds[i].name, &def);
    }
    swWaveSystemDef gerstner = MakeKind(SW_SPECTRUM_JONSWAP);
    gerstner.method = SW_WAVES_GERSTNER;
    result = result != SW_SUCCESS ? result : AddLine(lines, count, "gerstner", &gerstner);
    swWaveSystemDef loop = MakeKind(SW_SPECTRUM_JONSWAP);
    loop.loopPeriod = 32.0f;
    loop.chop = 1.2f;
    result = result != SW_SUCCESS ? result : AddLine(lines, count, "loop", &loop);
    swWaveSystemDef swell = MakeKind(SW_SPECTRUM_JONSWAP);
    swell.spectrum.significantHeight = 2.0f;
    swell.spectrum.peakPeriod = 12.0f;
    swell.spectrum.spreading = SW_SPREADING_COSINE_2S;
    swell.spectrum.spreadExponent = 60.0f;
    result = result != SW_SUCCESS ? result : AddLine(lines, count, "narrow_swell", &swell);
    float frequencies[FREQUENCIES], bandwidths[FREQUENCIES], density[FREQUENCIES * DIRECTIONS];
    swSpectrumTable table = MakeTable(frequencies, bandwidths, density);
    swWaveSystemDef measured = MakeKind(SW_SPECTRUM_TABLE);
    measured.spectrum.table = &table;
    result = result != SW_SUCCESS ? result : AddLine(lines, count, "table", &measured);
    swWaveSystemDef open = MakeKind(SW_SPECTRUM_JONSWAP);
    result = result != SW_SUCCESS ? result : AddLine(lines, count, "regions", &open);
    result = result != SW_SUCCESS ? result : AddLine(lines, count, "inputs", &open);
    return result != SW_SUCCESS ? result : AddLine(lines, count, "tidal_stream", &open);
}

static int List(void)
{
    Line lines[MAX_LINES];
    int count = 0;
    swResult result = MakeLines(lines, &count);
    if (result != SW_SUCCESS)
    {
        fprintf(stderr, "sea_digest: %s\n", swResult_GetText(result));
        return 1;
    }
    for (int i = 0; i < count; ++i)
    {
        const Parts* parts = &lines[i].parts;
        printf("%-20s %016llx %016llx %016llx\n", lines[i].name, (unsigned long long)parts->waves,
               (unsigned long long)parts->queries, (unsigned long long)parts->layers);
    }
    return 0;
}

// Whether one part is as committed; says both values if not.
static bool IsExpected(const char* name, const char* part, uint64_t expected, uint64_t found)
{
    if (expected != found)
    {
        fprintf(stderr, "%s: the digest of its %s is %016llx; %016llx is committed\n", name, part,
                (unsigned long long)found, (unsigned long long)expected);
    }
    return expected == found;
}

static bool FindExpected(FILE* file, const char* name, Parts* parts)
{
    char text[256], found[32];
    rewind(file);
    while (fgets(text, sizeof(text), file) != NULL)
    {
        unsigned long long waves, queries, layers;
        if (sscanf(text, "%31s %llx %llx %llx", found, &waves, &queries, &layers) == 4 && strcmp(found, name) == 0)
        {
            *parts = (Parts){waves, queries, layers};
            return true;
        }
    }
    fprintf(stderr, "%s: no digest is committed\n", name);
    return false;
}

// Against committed digests: 1 where one differs.
static int Expect(const char* path)
{
    FILE* file = fopen(path, "r");
    if (file == NULL)
    {
        fprintf(stderr, "sea_digest: cannot open %s\n", path);
        return 2;
    }
    Line lines[MAX_LINES];
    int count = 0, wrongCount = 0;
    swResult result = MakeLines(lines, &count);
    for (int i = 0; result == SW_SUCCESS && i < count; ++i)
    {
        Parts expected = {0, 0, 0};
        const Parts* found = &lines[i].parts;
        bool isListed = FindExpected(file, lines[i].name, &expected);
        // Every part is compared, so that each that differs is told.
        bool areWaves = isListed && IsExpected(lines[i].name, "waves", expected.waves, found->waves);
        bool areQueries = isListed && IsExpected(lines[i].name, "queries", expected.queries, found->queries);
        bool areLayers = isListed && IsExpected(lines[i].name, "layers", expected.layers, found->layers);
        wrongCount += areWaves && areQueries && areLayers ? 0 : 1;
    }
    fclose(file);
    printf("%d seas, %d differ from %s\n", count, wrongCount, path);
    if (wrongCount > 0)
    {
        printf("If that is meant, say so in the changelog and renew the file: sea_digest --list\n");
    }
    return result != SW_SUCCESS || wrongCount > 0;
}

// Every instruction set of this machine with 1, 2 and 5 threads. Returns the program's exit code.
static int Compare(double minutes)
{
    static const int threadCounts[] = {1, 2, 5};
    uint64_t first = 0;
    int runCount = 0, differCount = 0;
    for (int isa = SW_ISA_SCALAR; isa < SW_ISA_COUNT; ++isa)
    {
        for (int i = 0; i < 3; ++i)
        {
            Run run = {(swIsa)isa, threadCounts[i], minutes, true};
            uint64_t digest = 0;
            swResult result = MakeDigest(&run, &digest);
            if (result == SW_ERROR_UNSUPPORTED)
            {
                break;
            }
            if (result != SW_SUCCESS)
            {
                fprintf(stderr, "sea_digest: %s\n", swResult_GetText(result));
                return 1;
            }
            first = runCount == 0 ? digest : first;
            differCount += digest != first;
            ++runCount;
            printf("%-6s %d threads  %016llx%s\n", swIsa_GetName(run.isa), run.threads, (unsigned long long)digest,
                   digest == first ? "" : "  DIFFERS");
        }
    }
    printf("%d runs of %g minutes, %d differ\n", runCount, minutes, differCount);
    return runCount == 0 || differCount > 0;
}

static bool FindIsa(const char* name, swIsa* isa)
{
    static const char* const names[SW_ISA_COUNT] = {"best", "scalar", "sse2", "avx2", "neon", "avx512"};
    for (int i = 0; i < SW_ISA_COUNT; ++i)
    {
        if (strcmp(name, names[i]) == 0)
        {
            *isa = (swIsa)i;
            return true;
        }
    }
    return false;
}

int main(int argc, char** argv)
{
    Run run = {SW_ISA_BEST, 1, 10.0, false};
    bool compare = false;
    for (int i = 1; i < argc; ++i)
    {
        const char* value = i + 1 < argc ? argv[i + 1] : "";
        if (strcmp(argv[i], "--list") == 0)
        {
            return List();
        }
        if (strcmp(argv[i], "--expect") == 0 && i + 1 < argc)
        {
            return Expect(value);
        }
        if (strcmp(argv[i], "--compare") == 0)
        {
            compare = true;
            continue;
        }
        bool isKnown = (strcmp(argv[i], "--isa") == 0 && FindIsa(value, &run.isa)) ||
                       (strcmp(argv[i], "--threads") == 0 && (run.threads = atoi(value)) > 0) ||
                       (strcmp(argv[i], "--minutes") == 0 && (run.minutes = atof(value)) > 0.0);
        if (!isKnown)
        {
            fprintf(stderr, "sea_digest: cannot use '%s %s'\n", argv[i], value);
            return 2;
        }
        ++i;
    }
    if (compare)
    {
        return Compare(run.minutes);
    }
    uint64_t digest = 0;
    swResult result = MakeDigest(&run, &digest);
    if (result != SW_SUCCESS)
    {
        fprintf(stderr, "sea_digest: %s\n", swResult_GetText(result));
        return result == SW_ERROR_UNSUPPORTED ? 77 : 1;
    }
    printf("%016llx\n", (unsigned long long)digest);
    return 0;
}
