// SPDX-License-Identifier: MIT
// A world's state as bytes, see seaway/save.h. Sets of waves come first, each once: by the def that they are made of, or,
// of a mix, by its waves, whose first sea may be gone. Then systems, then views. What a step works out is not saved: a step
// of no time makes it again.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/world/world.h"

#define MAX_SETS (2 * SW_MAX_WAVE_SYSTEMS * SW_MAX_WAVE_LAYERS)
#define MAX_TABLE_FREQUENCIES 1024
#define MAX_TABLE_DIRECTIONS 720
#define LARGEST_TICKS ((int64_t)1 << 62) // SW_LARGEST_TIME

// ---- defs ----

void swStreamWorldDef(swStream* stream, swWorldDef* def)
{
    swStreamF32(stream, &def->gravity);
    swStreamF32(stream, &def->surfaceTension);
    swStreamF64(stream, &def->seaLevel);
    swStreamBool(stream, &def->enableQueries);
    swStreamBool(stream, &def->enableVelocity);
    swStreamBool(stream, &def->enableAcceleration);
    swStreamF32(stream, &def->foam.fadeRate);
    swStreamF32(stream, &def->foam.threshold);
    swStreamF32(stream, &def->foam.gain);
}

static void streamOctaves(swStream* stream, swOctaves* octaves)
{
    for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
    {
        swStreamF32(stream, &octaves->octaves[i].power);
        swStreamBool(stream, &octaves->octaves[i].isEnabled);
        swStreamF32(stream, &octaves->octaves[i].chop);
        swStreamF32(stream, &octaves->octaves[i].gravityScale);
    }
    swStreamF32(stream, &octaves->multiplier);
    swStreamF32(stream, &octaves->chop);
    swStreamF32(stream, &octaves->gravityScale);
    swStreamBool(stream, &octaves->limitByWind);
}

static void streamSpectrum(swStream* stream, swSpectrumDef* def)
{
    int kind = (int)def->kind, spreading = (int)def->spreading;
    swStreamRange(stream, &kind, 0, SW_SPECTRUM_KIND_COUNT - 1);
    swStreamRange(stream, &spreading, 0, SW_SPREADING_KIND_COUNT - 1);
    def->kind = (swSpectrumKind)kind;
    def->spreading = (swSpreadingKind)spreading;
    swStreamF32(stream, &def->windSpeed);
    swStreamF32(stream, &def->fetch);
    swStreamF32(stream, &def->gamma);
    swStreamF32(stream, &def->significantHeight);
    swStreamF32(stream, &def->peakPeriod);
    swStreamF32(stream, &def->direction);
    swStreamF32(stream, &def->spreadExponent);
    swStreamF32(stream, &def->turbulence);
    swStreamF32(stream, &def->swell);
    streamOctaves(stream, &def->octaves);
    swStreamF32(stream, &def->depth);
    swStreamBool(stream, &def->extendTail);
}

// Arrays of a def while it is read.
typedef struct Arrays
{
    size_t size;
    float* floats;
    swSpectrumTable table;
} Arrays;

static swResult makeArrays(const swHost* host, size_t count, Arrays* arrays)
{
    arrays->size = count * sizeof(float);
    arrays->floats = swAllocateZero(host, arrays->size);
    return arrays->floats != NULL || count == 0 ? SW_SUCCESS : SW_ERROR_NO_MEMORY;
}

static swResult streamTable(swStream* stream, const swHost* host, swSpectrumDef* def, Arrays* arrays)
{
    swSpectrumTable table = {0};
    if (!swIsReading(stream))
    {
        table = *def->table;
    }
    swStreamRange(stream, &table.frequencyCount, 2, MAX_TABLE_FREQUENCIES);
    swStreamRange(stream, &table.directionCount, 4, MAX_TABLE_DIRECTIONS);
    swStreamF32(stream, &table.firstDirection);
    size_t frequencies = (size_t)table.frequencyCount;
    size_t densities = frequencies * (size_t)table.directionCount;
    if (!swIsReading(stream))
    {
        swStreamFloats(stream, (float*)table.frequencies, frequencies);
        swStreamFloats(stream, (float*)table.bandwidths, frequencies);
        swStreamFloats(stream, (float*)table.density, densities);
        return SW_SUCCESS;
    }
    if (stream->isBroken || stream->size - stream->at < densities * sizeof(float))
    {
        return SW_ERROR_FORMAT;
    }
    swResult result = makeArrays(host, 2 * frequencies + densities, arrays);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swStreamFloats(stream, arrays->floats, 2 * frequencies + densities);
    table.frequencies = arrays->floats;
    table.bandwidths = arrays->floats + frequencies;
    table.density = arrays->floats + 2 * frequencies;
    arrays->table = table;
    def->table = &arrays->table;
    return SW_SUCCESS;
}

static swResult streamComponents(swStream* stream, const swHost* host, swWaveSystemDef* def, Arrays* arrays)
{
    int count = def->componentCount;
    swStreamRange(stream, &count, 0, SW_MAX_FREE_WAVES);
    size_t floats = (size_t)count * (sizeof(swWaveComponent) / sizeof(float));
    def->componentCount = count;
    if (!swIsReading(stream))
    {
        swStreamFloats(stream, (float*)def->components, floats);
        return SW_SUCCESS;
    }
    swResult result = makeArrays(host, floats, arrays);
    if (result == SW_SUCCESS)
    {
        swStreamFloats(stream, arrays->floats, floats);
        def->components = (const swWaveComponent*)arrays->floats;
    }
    return result;
}

// `arrays` are freed by the caller, whatever the result.
static swResult streamSystemDef(swStream* stream, const swHost* host, swWaveSystemDef* def, Arrays arrays[2])
{
    streamSpectrum(stream, &def->spectrum);
    int method = (int)def->method;
    swStreamRange(stream, &method, 0, SW_WAVE_METHOD_COUNT - 1);
    def->method = (swWaveMethod)method;
    swStreamI32(stream, &def->resolution);
    swStreamI32(stream, &def->tileWaves);
    swStreamI32(stream, &def->componentsPerOctave);
    swStreamF32(stream, &def->reverseWeight);
    swStreamF32(stream, &def->directionVariance);
    swStreamF32(stream, &def->minWavelength);
    swStreamF32(stream, &def->maxWavelength);
    swStreamF32(stream, &def->chop);
    swStreamF32(stream, &def->weight);
    swStreamF32(stream, &def->loopPeriod);
    swStreamU32(stream, &def->seed);
    swResult result = stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
    if (result == SW_SUCCESS && def->spectrum.kind == SW_SPECTRUM_TABLE)
    {
        result = streamTable(stream, host, &def->spectrum, &arrays[0]);
    }
    return result == SW_SUCCESS ? streamComponents(stream, host, def, &arrays[1]) : result;
}

// ---- sets ----

typedef struct SetList
{
    int count;
    swWaveSet* sets[MAX_SETS];
} SetList;

static int findInList(const SetList* list, const swWaveSet* set)
{
    for (int i = 0; i < list->count; ++i)
    {
        if (list->sets[i] == set)
        {
            return i;
        }
    }
    return -1;
}

static void listOnce(SetList* list, swWaveSet* set)
{
    if (set->to != NULL)
    {
        listOnce(list, set->to);
    }
    if (findInList(list, set) < 0)
    {
        list->sets[list->count++] = set;
    }
}

static void listSets(const swWorld* world, SetList* list)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < world->systems[slot].layerCount; ++i)
        {
            listOnce(list, world->systems[slot].layers[i].set);
        }
    }
}

static swResult streamPlainSet(swWorld* world, swStream* stream, swWaveSet** set)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    Arrays arrays[2] = {{0}};
    if (!swIsReading(stream))
    {
        def = (*set)->def;
    }
    swResult result = streamSystemDef(stream, &world->countedHost, &def, arrays);
    if (result == SW_SUCCESS && swIsReading(stream))
    {
        bool isFine = !stream->isBroken && swCheckWaveSystemDef(&world->host, &def) == SW_SUCCESS;
        result = isFine ? swAcquireSet(world, &def, set) : SW_ERROR_FORMAT;
    }
    swFree(&world->countedHost, arrays[0].floats, arrays[0].size);
    swFree(&world->countedHost, arrays[1].floats, arrays[1].size);
    return result;
}

static swResult streamSet(swWorld* world, swStream* stream, SetList* list, int index)
{
    swWaveSet* set = swIsReading(stream) ? NULL : list->sets[index];
    int to = set != NULL && set->to != NULL ? findInList(list, set->to) : -1;
    swStreamRange(stream, &to, -1, index - 1);
    swResult result = SW_SUCCESS;
    if (to < 0)
    {
        result = streamPlainSet(world, stream, &set);
    }
    else if (list->sets[to]->to != NULL || list->sets[to]->def.method != SW_WAVES_FFT)
    {
        result = SW_ERROR_FORMAT; // a mix becomes a sea of tiles
    }
    else
    {
        result = swStreamMix(world, stream, list->sets[to], &set);
    }
    if (result == SW_SUCCESS)
    {
        list->sets[index] = set;
    }
    return result;
}

// Sets that are read belong to the list until they are released.
static swResult streamSets(swWorld* world, swStream* stream, SetList* list)
{
    int count = list->count;
    swStreamRange(stream, &count, 0, MAX_SETS);
    for (int i = 0; i < count; ++i)
    {
        swResult result = streamSet(world, stream, list, i);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        list->count = i + 1;
    }
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

// ---- systems ----

static void streamRamp(swStream* stream, swRamp* ramp)
{
    swStreamF32(stream, &ramp->from);
    swStreamF32(stream, &ramp->to);
    swStreamI64(stream, &ramp->begin);
    swStreamI64(stream, &ramp->length);
    // Ticks of times in range, so that differences of two fit.
    bool isTime = ramp->begin < LARGEST_TICKS && ramp->begin > -LARGEST_TICKS && ramp->length >= 0 &&
                  ramp->length <= (int64_t)(SW_MAX_TRANSITION * SW_TICKS_PER_SECOND);
    bool isFine = isTime && ramp->from >= 0.0f && ramp->from <= 10.0f && ramp->to >= 0.0f && ramp->to <= 10.0f;
    stream->isBroken = stream->isBroken || !isFine;
}

static void streamLayer(swStream* stream, const SetList* list, swWaveLayer* layer)
{
    int index = swIsReading(stream) ? 0 : findInList(list, layer->set);
    swStreamRange(stream, &index, 0, list->count > 0 ? list->count - 1 : 0);
    stream->isBroken = stream->isBroken || list->count == 0;
    streamRamp(stream, &layer->fade);
    streamRamp(stream, &layer->share);
    swStreamBool(stream, &layer->isMixing);
    swStreamBool(stream, &layer->isShared);
    if (swIsReading(stream) && !stream->isBroken && list->count > 0)
    {
        layer->set = list->sets[index];
        layer->set->useCount += 1;
        bool isMix = layer->set->mix != NULL;
        layer->isMixing = layer->isMixing && isMix;
        layer->isShared = layer->isShared && isMix;
    }
}

static void streamSystem(swStream* stream, const SetList* list, swWaveSystem* system)
{
    int count = system->layerCount;
    swStreamRange(stream, &count, 1, SW_MAX_WAVE_LAYERS);
    streamRamp(stream, &system->weight);
    for (int i = 0; i < count && !stream->isBroken; ++i)
    {
        streamLayer(stream, list, &system->layers[i]);
        if (swIsReading(stream) && !stream->isBroken)
        {
            system->layerCount = i + 1;
        }
    }
}

static void streamSystems(swWorld* world, swStream* stream, const SetList* list)
{
    swIdPool* ids = &world->systemIds;
    swStreamU64(stream, &ids->used);
    if (ids->used >> SW_MAX_WAVE_SYSTEMS != 0)
    {
        stream->isBroken = true;
        ids->used = 0;
    }
    int count = 0;
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        swStreamU32(stream, &ids->generations[slot]);
        if ((ids->used >> slot & 1) != 0)
        {
            count += 1;
            streamSystem(stream, list, &world->systems[slot]);
        }
    }
    if (swIsReading(stream))
    {
        ids->count = count;
    }
}

// ---- views ----

static void streamViewDef(swStream* stream, swViewDef* def)
{
    swStreamI32(stream, &def->sliceCount);
    swStreamI32(stream, &def->resolution);
    swStreamF32(stream, &def->finestTexel);
    swStreamI32(stream, &def->maxScaleLevel);
    swStreamBool(stream, &def->enableCpuLayers);
}

static void streamPlace(swStream* stream, swPos* place)
{
    swStreamF64(stream, &place->x);
    swStreamF64(stream, &place->y);
    swStreamF64(stream, &place->z);
    bool isNear = place->x <= 1e12 && place->x >= -1e12 && place->y <= 1e12 && place->y >= -1e12 && place->z <= 1e12 &&
                  place->z >= -1e12;
    stream->isBroken = stream->isBroken || !isNear;
}

// `last` is the viewpoint of the last step.
static void streamView(swStream* stream, swView* view, swPos* last)
{
    streamPlace(stream, &view->viewpoint);
    streamPlace(stream, last);
    swStreamBool(stream, &view->stack.isPlaced);
    swStreamRange(stream, &view->stack.scaleLevel, 0, view->stack.maxScaleLevel);
    swStreamBool(stream, &view->foamState.isRunning);
    swStreamI64(stream, &view->foamState.remainder);
    swStreamI64(stream, &view->foamState.clock);
    swStreamU32(stream, &view->foamState.resetCount);
    const swFoamState* foam = &view->foamState;
    bool isClock = foam->remainder >= 0 && foam->remainder < (int64_t)SW_TICKS_PER_SECOND && foam->clock >= 0 &&
                   foam->clock < LARGEST_TICKS;
    stream->isBroken = stream->isBroken || !isClock;
    if (view->def.enableCpuLayers)
    {
        size_t side = (size_t)view->def.resolution;
        swStreamFloats(stream, view->foam[view->foamIndex], side * side * (size_t)view->def.sliceCount);
    }
}

// Before memory for layers is asked for: their foam must be there.
static bool hasFoam(const swStream* stream, const swViewDef* def)
{
    size_t texels = (size_t)def->sliceCount * (size_t)def->resolution * (size_t)def->resolution;
    return !def->enableCpuLayers || stream->size - stream->at >= texels * sizeof(float);
}

static swResult streamOneView(swWorld* world, swStream* stream, int index, swPos* last)
{
    swView* view = swIsReading(stream) ? NULL : world->views[index];
    swViewDef def = view != NULL ? view->def : swDefaultViewDef();
    streamViewDef(stream, &def);
    if (swIsReading(stream))
    {
        if (stream->isBroken || swCheckViewDef(world, &def) != SW_SUCCESS || !hasFoam(stream, &def))
        {
            return SW_ERROR_FORMAT;
        }
        swResult result = swAddView(world, &def, &view);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    else
    {
        const swViewFrame* frame = swFindViewFrame(view);
        *last = frame != NULL ? frame->viewpoint : view->viewpoint;
    }
    streamView(stream, view, last);
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

// Slices of the last step, where the next one finds its foam.
static void placeStack(swView* view, swPos last)
{
    if (view->stack.isPlaced)
    {
        swPlaceStack(&view->stack, last, view->world->def.seaLevel);
    }
}

static swResult streamViews(swWorld* world, swStream* stream, swPos last[SW_MAX_VIEWS])
{
    int count = world->viewCount;
    swStreamRange(stream, &count, 0, SW_MAX_VIEWS);
    for (int i = 0; i < count; ++i)
    {
        swResult result = streamOneView(world, stream, i, &last[i]);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        if (swIsReading(stream))
        {
            placeStack(world->views[i], last[i]);
        }
    }
    return SW_SUCCESS;
}

// ---- all of it ----

// Work out what the last step left: a step of no time from its viewpoints, to its time. Views that were made since, which
// come last, have no past: their first step is still to come.
static void makeFrame(swWorld* world, double stepped, const swPos last[SW_MAX_VIEWS])
{
    double time = world->time;
    swPos next[SW_MAX_VIEWS];
    for (int i = 0; i < world->viewCount; ++i)
    {
        next[i] = world->views[i]->viewpoint;
        world->views[i]->viewpoint = last[i];
    }
    int viewCount = world->viewCount;
    while (world->viewCount > 0 && !world->views[world->viewCount - 1]->stack.isPlaced)
    {
        world->viewCount -= 1;
    }
    world->time = stepped;
    swStepWorld(world, 0.0);
    world->time = time;
    world->viewCount = viewCount;
    for (int i = 0; i < world->viewCount; ++i)
    {
        world->views[i]->viewpoint = next[i];
    }
}

swResult swStreamState(swWorld* world, swStream* stream)
{
    double stepped = world->frame.time;
    swStreamF64(stream, &world->time);
    swStreamF64(stream, &stepped);
    swStreamI64(stream, &world->frame.ticks);
    swStreamF64(stream, &world->origin.x);
    swStreamF64(stream, &world->origin.z);
    bool isFine = world->time <= SW_LARGEST_TIME && world->time >= -SW_LARGEST_TIME && stepped <= SW_LARGEST_TIME &&
                  stepped >= -SW_LARGEST_TIME && world->origin.x <= 1e12 && world->origin.x >= -1e12 &&
                  world->origin.z <= 1e12 && world->origin.z >= -1e12 &&
                  world->frame.ticks == (int64_t)floor(stepped * SW_TICKS_PER_SECOND + 0.5);
    if (!isFine)
    {
        return SW_ERROR_FORMAT;
    }
    SetList list = {0};
    swPos last[SW_MAX_VIEWS];
    if (!swIsReading(stream))
    {
        listSets(world, &list);
    }
    swResult result = streamSets(world, stream, &list);
    if (result == SW_SUCCESS)
    {
        streamSystems(world, stream, &list);
        result = stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
    }
    for (int i = 0; i < list.count && swIsReading(stream); ++i)
    {
        swReleaseSet(world, list.sets[i]);
    }
    result = result == SW_SUCCESS ? streamViews(world, stream, last) : result;
    if (result == SW_SUCCESS && swIsReading(stream))
    {
        result = swIsWithinLimits(world) ? SW_SUCCESS : SW_ERROR_FORMAT;
        world->isTileListStale = true;
        if (result == SW_SUCCESS)
        {
            makeFrame(world, stepped, last);
        }
    }
    return result;
}
