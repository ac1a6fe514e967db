// SPDX-License-Identifier: MIT
// A wind sea by a map: which headings and speeds it needs, a local system for each, and an input that weighs it. See
// shared/region.h for how a place mixes them.

#include <math.h>
#include <string.h>

#include "core/base/misuse.h"
#include "core/input/input_def.h"
#include "core/input/raster.h"
#include "core/math/scalar.h"
#include "core/world/world.h"
#include "seaway/wind_sea.h"
#include "shared/region.h"

#define SEED_STEP 0x9e3779b9u // as sea_api.c has it
#define MOST_HEADINGS 64
#define MOST_SPEEDS 4
#define LEAST_WEIGHT 0.02f // of a place's height
#define LEAST_SPEED 0.5    // m/s: below it there is no sea to speak of
#define SAMPLES 3          // of a cell along each axis

#define SW_DEF swWindSeaDef
static const swField windSeaFields[] = {
    SW_PART(waves, &swWaveSystemFields, .key = NULL, .label = "waves"),
    SW_GIVEN(raster, .key = NULL, .label = "raster"),
    SW_NUMBERS(position, double, "m", SW_WITHIN(-1e9, 1e9), SW_EACH(0.0, 0.0, 0.0), .key = "position_m",
               .label = "place", SW_KNOB(-1000.0, 1000.0)),
    SW_NUMBERS(rotation, float, "deg", SW_WITHIN(-1000.0, 1000.0), SW_EACH(0.0, 0.0, 0.0), .key = "rotation_deg",
               .label = "turned", .form = SW_FORM_DEGREES, SW_KNOB(-180.0, 180.0)),
    SW_NUMBER(gain, "", SW_WITHIN(-1e6, 1e6), 1.0, .key = "gain", .label = "gain", SW_KNOB(-10.0, 10.0)),
    SW_NUMBER(feather, "m", SW_WITHIN(0.0, 1e6), 0.0, .key = "feather_m", .label = "feather", SW_LOG_KNOB(0.1, 1e4)),
    SW_NUMBER(order, "", SW_WITHIN(-1e6, 1e6), 0.0, .key = "order", .label = "order", SW_KNOB(-100.0, 100.0)),
    SW_SWITCH(removesWaves, false, .key = "removes_waves", .label = "removes waves"),
    SW_NUMBER(headingCount, "", SW_WITHIN(4.0, MOST_HEADINGS), 12.0, .key = "heading_count", .label = "headings",
              SW_KNOB(4.0, MOST_HEADINGS)),
    SW_NUMBER(speedCount, "", SW_WITHIN(1.0, MOST_SPEEDS), 2.0, .key = "speed_count", .label = "speeds",
              SW_KNOB(1.0, MOST_SPEEDS)),
};
#undef SW_DEF

static const swFields windSeaDefFields = SW_FIELDS(swWindSeaDef, "wind_seas", "wind sea", windSeaFields, -1);

const swFields* swGetWindSeaFields(void)
{
    return &windSeaDefFields;
}

swWindSeaDef swDefaultWindSeaDef(void)
{
    swWindSeaDef def;
    swFillDef(&windSeaDefFields, &def);
    def.waves = swDefaultWaveSystemDef();
    return def;
}

// ---- what the map needs ----

typedef struct Plan
{
    double yaw, first, step; // headings
    int headingCount, speedCount;
    double speeds[MOST_SPEEDS]; // ascending
    float heights[MOST_SPEEDS]; // deviations of the waves' height
    bool isNeeded[MOST_SPEEDS][MOST_HEADINGS];
} Plan;

// The wind in the middle of some part of a cell; false where it is not known.
static bool readWind(const swWindSeaDef* def, int column, int row, int part, double wind[2])
{
    const swRaster* raster = def->raster;
    int right = column + 1 < raster->width ? column + 1 : column, down = row + 1 < raster->height ? row + 1 : row;
    double east = (part % SAMPLES) / (double)(SAMPLES - 1), south = (part / SAMPLES) / (double)(SAMPLES - 1);
    const int columns[4] = {column, right, column, right}, rows[4] = {row, row, down, down};
    const double shares[4] = {(1.0 - east) * (1.0 - south), east * (1.0 - south), (1.0 - east) * south, east * south};
    wind[0] = wind[1] = 0.0;
    for (int i = 0; i < 4; ++i)
    {
        size_t cell = (size_t)rows[i] * (size_t)raster->width + (size_t)columns[i];
        const float* values = raster->values + cell * (size_t)raster->channels;
        wind[0] += shares[i] * (double)values[0] * (double)def->gain;
        wind[1] += shares[i] * (double)values[1] * (double)def->gain;
    }
    return isfinite(wind[0]) && isfinite(wind[1]);
}

typedef void VisitFcn(void* context, const double wind[2]);

static void visitWinds(const swWindSeaDef* def, VisitFcn* visit, void* context)
{
    for (int row = 0; row < def->raster->height; ++row)
    {
        for (int column = 0; column < def->raster->width; ++column)
        {
            for (int part = 0; part < SAMPLES * SAMPLES; ++part)
            {
                double wind[2];
                if (readWind(def, column, row, part, wind))
                {
                    visit(context, wind);
                }
            }
        }
    }
}

typedef struct Range
{
    double x, z; // sums
    double least, most;
} Range;

static void addToRange(void* context, const double wind[2])
{
    Range* range = context;
    double speed = sqrt(wind[0] * wind[0] + wind[1] * wind[1]);
    range->x += wind[0];
    range->z += wind[1];
    range->least = fmin(range->least, speed);
    range->most = fmax(range->most, speed);
}

static void markSpeed(Plan* plan, double speed, int heading)
{
    int above = 0;
    while (above < plan->speedCount && plan->speeds[above] < speed)
    {
        above += 1;
    }
    int below = above > 0 ? above - 1 : 0;
    above = above < plan->speedCount ? above : plan->speedCount - 1;
    double way = above > below ? (speed - plan->speeds[below]) / (plan->speeds[above] - plan->speeds[below]) : 0.0;
    swWeightPair pair = swPairSmoothly((float)way);
    plan->isNeeded[below][heading] |= pair.first > LEAST_WEIGHT;
    plan->isNeeded[above][heading] |= pair.second > LEAST_WEIGHT;
}

static void markWind(void* context, const double wind[2])
{
    Plan* plan = context;
    double speed = sqrt(wind[0] * wind[0] + wind[1] * wind[1]);
    if (speed < LEAST_SPEED)
    {
        return;
    }
    double turn = (swAtan2(wind[1], wind[0]) - plan->first) / plan->step;
    double whole = floor(turn), part = turn - whole;
    // As swFindHeadingWeight() has it: the wind as a sum of the two headings.
    double share = swSin(part * plan->step) / (swSin(part * plan->step) + swSin((1.0 - part) * plan->step));
    swWeightPair pair = swPairSmoothly((float)share);
    int heading = (int)(whole - floor(whole / plan->headingCount) * plan->headingCount);
    if (pair.first > LEAST_WEIGHT)
    {
        markSpeed(plan, speed, heading);
    }
    if (pair.second > LEAST_WEIGHT)
    {
        markSpeed(plan, speed, (heading + 1) % plan->headingCount);
    }
}

static bool makePlan(const swWindSeaDef* def, Plan* plan)
{
    Range range = {.least = (double)INFINITY};
    visitWinds(def, addToRange, &range);
    if (!(range.most >= LEAST_SPEED))
    {
        return false;
    }
    *plan = (Plan){.headingCount = def->headingCount, .speedCount = def->speedCount};
    plan->step = 2.0 * SW_PI / def->headingCount;
    plan->first = swAtan2(range.z, range.x);
    double slowest = fmax(fmax(range.least, 0.25 * range.most), LEAST_SPEED);
    bool isOne = slowest > 0.99 * range.most; // the wind blows alike everywhere
    plan->speedCount = isOne ? 1 : def->speedCount;
    for (int i = 0; i < plan->speedCount; ++i)
    {
        double way = plan->speedCount > 1 ? (double)(plan->speedCount - 1 - i) / (plan->speedCount - 1) : 0.0;
        plan->speeds[i] = range.most * swPow(slowest / range.most, way);
    }
    visitWinds(def, markWind, plan);
    return true;
}

// ---- making ----

static swWaveSystemDef makeSystem(const swWindSeaDef* def, const Plan* plan, int speed, int heading)
{
    swWaveSystemDef system = def->waves;
    system.isLocal = true;
    system.takesWind = false;
    system.spectrum.windSpeed = (float)plan->speeds[speed];
    system.spectrum.direction = (float)(plan->first + (double)def->rotation.yaw + plan->step * heading);
    system.spectrum.hasWind = true;
    system.seed += SEED_STEP * (uint32_t)(1 + speed * plan->headingCount + heading);
    return system;
}

// How heights go on beyond a speed, see swWindWeight::heightBelow.
static float findBend(const swWindSeaDef* def, double speed)
{
    swSpectrumDef spectrum = def->waves.spectrum;
    swSeaState at, below;
    spectrum.windSpeed = (float)speed;
    bool isFine = swSpectrum_GetSeaState(&spectrum, 0.0f, 0.0f, &at) == SW_SUCCESS;
    spectrum.windSpeed = (float)(0.9 * speed);
    isFine = isFine && swSpectrum_GetSeaState(&spectrum, 0.0f, 0.0f, &below) == SW_SUCCESS;
    if (!isFine || !(at.significantHeight > 0.0f))
    {
        return 1.0f;
    }
    double bend = (1.0 - (double)below.significantHeight / (double)at.significantHeight / 0.9) / 0.1;
    return (float)fmax(bend, 0.0);
}

static float findDeviation(const swWorld* world, swWaveSystemId id)
{
    swBandInfo bands[SW_MAX_BANDS];
    float variance = 0.0f, weight = swWaveSystem_GetWeight(world, id);
    int count = swWaveSystem_GetBands(world, id, bands);
    for (int i = 0; i < count; ++i)
    {
        variance += bands[i].variance;
    }
    return weight > 0.0f ? sqrtf(variance) / weight : 0.0f;
}

static swResult makeSystems(swWorld* world, const swWindSeaDef* def, Plan* plan, swWindSea* sea)
{
    for (int speed = 0; speed < plan->speedCount; ++speed)
    {
        for (int heading = 0; heading < plan->headingCount; ++heading)
        {
            if (!plan->isNeeded[speed][heading])
            {
                continue;
            }
            if (sea->count == SW_MAX_WAVE_SYSTEMS)
            {
                return swFail(&world->host, SW_ERROR_LIMIT,
                              "the wind of the raster '%s' needs more than %d wave systems; ask for fewer headings or "
                              "speeds",
                              def->raster->name, SW_MAX_WAVE_SYSTEMS);
            }
            swWaveSystemDef system = makeSystem(def, plan, speed, heading);
            swResult result = swCreateWaveSystem(world, &system, &sea->systems[sea->count]);
            if (result != SW_SUCCESS)
            {
                return result;
            }
            plan->heights[speed] = findDeviation(world, sea->systems[sea->count]);
            sea->count += 1;
        }
    }
    return SW_SUCCESS;
}

static swWindWeight weighSystem(const swWindSeaDef* def, const Plan* plan, int speed, int heading)
{
    bool hasBelow = speed > 0 && plan->heights[speed - 1] > 0.0f;
    bool hasAbove = speed + 1 < plan->speedCount && plan->heights[speed + 1] > 0.0f;
    float own = plan->heights[speed];
    float bend = findBend(def, plan->speeds[speed]);
    return (swWindWeight){
        .isUsed = true,
        .heading = (float)(plan->first + (double)def->rotation.yaw + plan->step * heading),
        .headingStep = (float)plan->step,
        .speed = (float)plan->speeds[speed],
        .speedBelow = hasBelow ? (float)plan->speeds[speed - 1] : 0.0f,
        .speedAbove = hasAbove ? (float)plan->speeds[speed + 1] : 0.0f,
        .heightBelow = hasBelow ? plan->heights[speed - 1] / own : bend,
        .heightAbove = hasAbove ? plan->heights[speed + 1] / own : bend,
    };
}

static swResult makeInputs(swWorld* world, const swWindSeaDef* def, const Plan* plan, swWindSea* sea)
{
    int made = 0;
    for (int at = 0; at < plan->speedCount * plan->headingCount && made < sea->count; ++at)
    {
        int speed = at / plan->headingCount, heading = at % plan->headingCount;
        if (!plan->isNeeded[speed][heading])
        {
            continue;
        }
        swInputDef input = swDefaultInputDef();
        input.field = SW_INPUT_WAVES;
        input.shape = SW_SHAPE_RASTER;
        input.blend = SW_BLEND_ADD;
        input.raster = def->raster;
        input.position = def->position;
        input.rotation = def->rotation;
        input.gain = def->gain;
        input.feather = def->feather;
        input.order = def->order;
        input.system = sea->systems[made];
        input.removesWaves = def->removesWaves && made == 0; // the others are added to it
        input.windWeight = weighSystem(def, plan, speed, heading);
        swResult result = swCreateInput(world, &input, &sea->inputs[made]);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        made += 1;
    }
    return SW_SUCCESS;
}

// What the table cannot say.
static swResult checkDef(const swWorld* world, const swWindSeaDef* def)
{
    swResult result = swCheckDef(&world->host, &windSeaDefFields, def);
    result = result == SW_SUCCESS ? swCheckWaveSystemDef(&world->host, &def->waves) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    const swSpectrumDef* spectrum = &def->waves.spectrum;
    bool isFree = spectrum->kind == SW_SPECTRUM_TABLE || spectrum->kind == SW_SPECTRUM_OCTAVES ||
                  spectrum->significantHeight > 0.0f || spectrum->peakPeriod > 0.0f ||
                  (def->waves.method == SW_WAVES_GERSTNER && def->waves.componentCount > 0);
    if (isFree)
    {
        return swFail(&world->host, SW_ERROR_INVALID,
                      "a wind sea needs waves that follow the wind; swWindSeaDef::waves has a table, octaves, given "
                      "components, or a height or period of its own");
    }
    if (def->raster == NULL || def->raster->channels < 2)
    {
        return swFail(&world->host, SW_ERROR_INVALID,
                      "a wind sea needs a raster of two channels, the wind along x and z; swWindSeaDef::raster %s",
                      def->raster == NULL ? "is NULL" : "has one");
    }
    return SW_SUCCESS;
}

swResult swCreateWindSea(swWorld* world, const swWindSeaDef* def, swWindSea* sea)
{
    if (sea != NULL)
    {
        memset(sea, 0, sizeof(*sea));
    }
    SW_REQUIRE(world != NULL && sea != NULL, SW_ERROR_INVALID, swFindHost(world),
               "swCreateWindSea() needs a world and a place for the sea's handles");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, &world->host,
               "swCreateWindSea() needs a def made by swDefaultWindSeaDef()");
    swResult result = checkDef(world, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    Plan plan;
    if (!makePlan(def, &plan))
    {
        return swFail(&world->host, SW_ERROR_INVALID,
                      "the raster '%s' has no wind of %g m/s or more; give it in m/s, or set swWindSeaDef::gain",
                      def->raster->name, LEAST_SPEED);
    }
    result = makeSystems(world, def, &plan, sea);
    result = result == SW_SUCCESS ? makeInputs(world, def, &plan, sea) : result;
    if (result != SW_SUCCESS)
    {
        swDestroyWindSea(world, sea);
    }
    return result;
}

void swDestroyWindSea(swWorld* world, swWindSea* sea)
{
    SW_REQUIRE_VOID(world != NULL && sea != NULL, swFindHost(world), "swDestroyWindSea() needs a world and a sea");
    for (int i = 0; i < sea->count && i < SW_MAX_WAVE_SYSTEMS; ++i)
    {
        if (swInput_IsValid(world, sea->inputs[i]))
        {
            swDestroyInput(world, sea->inputs[i]);
        }
        if (swWaveSystem_IsValid(world, sea->systems[i]))
        {
            swDestroyWaveSystem(world, sea->systems[i]);
        }
    }
    memset(sea, 0, sizeof(*sea));
}
