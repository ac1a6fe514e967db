// SPDX-License-Identifier: MIT
// A world's state as bytes, see seaway/save.h. Sets of waves come first, each once: by the def that they are made of,
// or, of a mix, by its waves, whose first sea may be gone. Then systems, then views. What a step works out is not
// saved: a step of no time makes it again.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/world/world.h"

#define MAX_SETS (2 * SW_MAX_WAVE_SYSTEMS * SW_MAX_WAVE_LAYERS)
#define MAX_SET_TILES (2 * SW_MAX_TILES) // of what is seen, and of what mixes become
#define LEAST_SET_BYTES 16
#define MAX_TABLE_FREQUENCIES 1024
#define MAX_TABLE_DIRECTIONS 720
#define LARGEST_TICKS ((int64_t)1 << 62) // of SW_LARGEST_TIME

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
    swStreamF32(stream, &def->foam.coverage);
    swStreamF32(stream, &def->foam.windSpeed);
    swStreamF32(stream, &def->foam.minWavelength);
    swStreamF32(stream, &def->foam.threshold);
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
    int kind = (int)def->kind, spreading = (int)def->spreading, growth = (int)def->growth;
    swStreamRange(stream, &kind, 0, SW_SPECTRUM_KIND_COUNT - 1);
    swStreamRange(stream, &spreading, 0, SW_SPREADING_KIND_COUNT - 1);
    swStreamRange(stream, &growth, 0, SW_GROWTH_LAW_COUNT - 1);
    def->kind = (swSpectrumKind)kind;
    def->spreading = (swSpreadingKind)spreading;
    def->growth = (swGrowthLaw)growth;
    swStreamF32(stream, &def->windSpeed);
    swStreamBool(stream, &def->hasWind);
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

static swResult makeArrays(const swWorld* world, size_t count, Arrays* arrays)
{
    arrays->size = count * sizeof(float);
    arrays->floats = swAllocateZero(&world->countedHost, arrays->size);
    return arrays->floats != NULL || count == 0 ? SW_SUCCESS : swFailMemory(world, "a spectrum's table or components");
}

static swResult streamTable(swStream* stream, const swWorld* world, swSpectrumDef* def, Arrays* arrays)
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
    if (!swStreamHasLeft(stream, 2 * frequencies + densities, sizeof(float)))
    {
        return SW_ERROR_FORMAT;
    }
    swResult result = makeArrays(world, 2 * frequencies + densities, arrays);
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

static swResult streamComponents(swStream* stream, const swWorld* world, swWaveSystemDef* def, Arrays* arrays)
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
    if (!swStreamHasLeft(stream, floats, sizeof(float)))
    {
        return SW_ERROR_FORMAT;
    }
    swResult result = makeArrays(world, floats, arrays);
    if (result == SW_SUCCESS)
    {
        swStreamFloats(stream, arrays->floats, floats);
        def->components = (const swWaveComponent*)arrays->floats;
    }
    return result;
}

// `arrays` are freed by the caller, whatever the result.
static swResult streamSystemDef(swStream* stream, const swWorld* world, swWaveSystemDef* def, Arrays arrays[2])
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
    swStreamF32(stream, &def->leastJacobian);
    swStreamF32(stream, &def->minWavelength);
    swStreamF32(stream, &def->maxWavelength);
    swStreamF32(stream, &def->chop);
    swStreamF32(stream, &def->weight);
    swStreamF32(stream, &def->loopPeriod);
    swStreamU32(stream, &def->seed);
    swResult result = stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
    if (result == SW_SUCCESS && def->spectrum.kind == SW_SPECTRUM_TABLE)
    {
        result = streamTable(stream, world, &def->spectrum, &arrays[0]);
    }
    return result == SW_SUCCESS ? streamComponents(stream, world, def, &arrays[1]) : result;
}

// ---- sets ----

typedef struct SetList
{
    int count;
    swWaveSet* sets[MAX_SETS];
    int tileCount; // of all that were read
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
    swResult result = streamSystemDef(stream, world, &def, arrays);
    if (result == SW_SUCCESS && swIsReading(stream))
    {
        bool isFine = !stream->isBroken && swCheckWaveSystemDef(&world->host, &def) == SW_SUCCESS;
        result = isFine ? swAcquireSet(world, &def, set) : SW_ERROR_FORMAT;
    }
    swFree(&world->countedHost, arrays[0].floats, arrays[0].size);
    swFree(&world->countedHost, arrays[1].floats, arrays[1].size);
    return result;
}

// Ahead of each set stand its identity, by which a world that has it already knows it, and the number of its bytes.
static size_t beginSet(swStream* stream, uint64_t* hash, uint32_t* size)
{
    swStreamU64(stream, hash);
    swStreamU32(stream, size);
    return stream->at;
}

static void endSet(swStream* stream, size_t begin)
{
    uint32_t size = (uint32_t)(stream->at - begin);
    if (stream->purpose == SW_STREAM_WRITE)
    {
        swStream head = {.purpose = SW_STREAM_WRITE, .data = stream->data, .size = begin, .at = begin - sizeof size};
        swStreamU32(&head, &size);
    }
}

static swResult streamSet(swWorld* world, swStream* stream, SetList* list, int index)
{
    swWaveSet* set = swIsReading(stream) ? NULL : list->sets[index];
    uint64_t hash = set != NULL ? set->identity : 0;
    uint32_t size = 0;
    size_t begin = beginSet(stream, &hash, &size);
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
    endSet(stream, begin);
    if (result == SW_SUCCESS)
    {
        list->sets[index] = set;
        list->count = swIsReading(stream) ? index + 1 : list->count;
        list->tileCount += set->tileCount;
        result = list->tileCount <= MAX_SET_TILES ? SW_SUCCESS : SW_ERROR_FORMAT;
    }
    return result;
}

// Sets that are read belong to the list until they are released.
static swResult streamSets(swWorld* world, swStream* stream, SetList* list)
{
    int count = list->count;
    swStreamRange(stream, &count, 0, MAX_SETS);
    swStreamHasLeft(stream, (size_t)count, LEAST_SET_BYTES);
    for (int i = 0; i < count && !stream->isBroken; ++i)
    {
        swResult result = streamSet(world, stream, list, i);
        if (result != SW_SUCCESS)
        {
            return result;
        }
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
    bool isTime = ramp->begin <= LARGEST_TICKS && ramp->begin >= -LARGEST_TICKS && ramp->length >= 0 &&
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

// Layers that are read do not yet count as users of their sets.
static void streamSystems(swStream* stream, const SetList* list, swIdPool* ids, swWaveSystem* systems)
{
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
            streamSystem(stream, list, &systems[slot]);
        }
    }
    if (swIsReading(stream))
    {
        ids->count = count;
    }
}

static void useLayers(const swWaveSystem* systems)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < systems[slot].layerCount; ++i)
        {
            systems[slot].layers[i].set->useCount += 1;
        }
    }
}

static void unuseLayers(swWorld* world, const swWaveSystem* systems)
{
    for (int slot = 0; slot < SW_MAX_WAVE_SYSTEMS; ++slot)
    {
        for (int i = 0; i < systems[slot].layerCount; ++i)
        {
            swReleaseSet(world, systems[slot].layers[i].set);
        }
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
    const double farthest = SW_FARTHEST_VIEWPOINT + SW_FARTHEST_ORIGIN; // it counts from the sea's origin
    bool isNear = fabs(place->x) <= farthest && fabs(place->y) <= farthest && fabs(place->z) <= farthest;
    stream->isBroken = stream->isBroken || !isNear;
}

// What a view has beside its def and its layers.
typedef struct ViewState
{
    swPos viewpoint, last; // of the next step, of the last one
    bool isPlaced;
    int scaleLevel;
} ViewState;

static void streamViewState(swStream* stream, int maxScaleLevel, ViewState* state)
{
    streamPlace(stream, &state->viewpoint);
    streamPlace(stream, &state->last);
    swStreamBool(stream, &state->isPlaced);
    swStreamRange(stream, &state->scaleLevel, 0, maxScaleLevel);
}

static ViewState getViewState(const swView* view)
{
    const swViewFrame* frame = swFindViewFrame(view);
    return (ViewState){
        .viewpoint = view->viewpoint,
        .last = frame != NULL ? frame->viewpoint : view->viewpoint,
        .isPlaced = view->layers.stack.isPlaced,
        .scaleLevel = view->layers.stack.scaleLevel,
    };
}

// Slices are those of the last step, where the next one finds the past of layers.
static void setViewState(swView* view, const ViewState* state)
{
    swStack* stack = &view->layers.stack;
    view->viewpoint = state->viewpoint;
    stack->isPlaced = state->isPlaced;
    stack->scaleLevel = state->scaleLevel;
    if (state->isPlaced)
    {
        swPlaceStack(stack, state->last, view->world->def.seaLevel);
    }
}

static swResult streamOneView(swWorld* world, swStream* stream, int index, swPos* last)
{
    swView* view = swIsReading(stream) ? NULL : world->views[index];
    swViewDef def = view != NULL ? view->def : swDefaultViewDef();
    ViewState state = view != NULL ? getViewState(view) : (ViewState){.isPlaced = false};
    streamViewDef(stream, &def);
    if (swIsReading(stream))
    {
        // Before memory for layers is asked for: what is saved of them must be there.
        bool isFine = !stream->isBroken && swCheckViewDef(world, &def) == SW_SUCCESS;
        const swLayerStack layers = isFine ? swDescribeViewLayers(&def) : (swLayerStack){.hasTexels = false};
        isFine = isFine && swStreamHasLeft(stream, swCountSavedFloats(&layers), sizeof(float));
        swResult result = isFine ? swAddView(world, &def, &view) : SW_ERROR_FORMAT;
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    streamViewState(stream, def.maxScaleLevel, &state);
    swStreamLayers(stream, &view->layers);
    if (stream->isBroken)
    {
        return SW_ERROR_FORMAT;
    }
    *last = state.last;
    if (swIsReading(stream))
    {
        setViewState(view, &state);
    }
    return SW_SUCCESS;
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
    }
    return SW_SUCCESS;
}

// ---- all of it ----

// Work out what the last step left: a step of no time from its viewpoints, to its time. Views that were made since,
// which come last, have no past: their first step is still to come.
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
    while (world->viewCount > 0 && !world->views[world->viewCount - 1]->layers.stack.isPlaced)
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

// Times, the origin, and whether a change waits for the next step.
typedef struct Clocks
{
    double time, stepped;
    int64_t ticks;
    swPosXZ origin;
    bool isChanged;
} Clocks;

static Clocks getClocks(const swWorld* world)
{
    return (Clocks){world->time, world->frame.time, world->frame.ticks, world->origin, world->isChanged};
}

static bool isWithin(double value, double largest)
{
    return value <= largest && value >= -largest; // false for NaN
}

static void streamClocks(swStream* stream, Clocks* clocks)
{
    swStreamF64(stream, &clocks->time);
    swStreamF64(stream, &clocks->stepped);
    swStreamI64(stream, &clocks->ticks);
    swStreamF64(stream, &clocks->origin.x);
    swStreamF64(stream, &clocks->origin.z);
    swStreamBool(stream, &clocks->isChanged);
    bool isFine = isWithin(clocks->time, SW_LARGEST_TIME) && isWithin(clocks->stepped, SW_LARGEST_TIME) &&
                  isWithin(clocks->origin.x, SW_FARTHEST_ORIGIN) && isWithin(clocks->origin.z, SW_FARTHEST_ORIGIN) &&
                  clocks->ticks == (int64_t)floor(clocks->stepped * SW_TICKS_PER_SECOND + 0.5);
    stream->isBroken = stream->isBroken || !isFine;
}

// Everything that was read is in its place but what a step works out.
static void finishReading(swWorld* world, const Clocks* clocks, const swPos last[SW_MAX_VIEWS])
{
    world->time = clocks->time;
    world->origin = clocks->origin;
    world->frame.ticks = clocks->ticks;
    world->isTileListStale = true;
    makeFrame(world, clocks->stepped, last);
    world->isChanged = clocks->isChanged;
}

swResult swStreamState(swWorld* world, swStream* stream)
{
    Clocks clocks = getClocks(world);
    SetList list = {0};
    swPos last[SW_MAX_VIEWS];
    streamClocks(stream, &clocks);
    if (stream->isBroken)
    {
        return SW_ERROR_FORMAT;
    }
    if (!swIsReading(stream))
    {
        listSets(world, &list);
    }
    swResult result = streamSets(world, stream, &list);
    if (result == SW_SUCCESS)
    {
        streamSystems(stream, &list, &world->systemIds, world->systems);
        result = stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
    }
    if (swIsReading(stream))
    {
        useLayers(world->systems);
    }
    for (int i = 0; i < list.count && swIsReading(stream); ++i)
    {
        swReleaseSet(world, list.sets[i]);
    }
    result = result == SW_SUCCESS ? streamViews(world, stream, last) : result;
    if (result == SW_SUCCESS && swIsReading(stream))
    {
        result = swIsWithinLimits(world, world->systems) ? SW_SUCCESS : SW_ERROR_FORMAT;
        if (result == SW_SUCCESS)
        {
            finishReading(world, &clocks, last);
        }
    }
    return result == SW_SUCCESS && stream->isBroken ? SW_ERROR_FORMAT : result;
}

// ---- back to a state of this world ----

// All of a state but waves and layers, read before anything is changed.
typedef struct Rewind
{
    Clocks clocks;
    SetList sets; // of the world's own
    swIdPool ids;
    swWaveSystem systems[SW_MAX_WAVE_SYSTEMS];
    ViewState views[SW_MAX_VIEWS];
    size_t layers[SW_MAX_VIEWS]; // where they are in the stream
} Rewind;

static swResult failRewind(const swWorld* world, const char* what)
{
    return swFail(&world->host, SW_ERROR_UNSUPPORTED, "the world cannot go back to a saved state: %s", what);
}

// The sets by their hashes; what stands behind them is what the world has.
static swResult findSets(swWorld* world, swStream* stream, SetList* found)
{
    SetList own = {0};
    listSets(world, &own);
    swStreamRange(stream, &found->count, 0, MAX_SETS);
    for (int i = 0; i < found->count && !stream->isBroken; ++i)
    {
        uint64_t hash = 0;
        uint32_t size = 0;
        beginSet(stream, &hash, &size);
        stream->isBroken = stream->isBroken || size > stream->size - stream->at;
        stream->at += stream->isBroken ? 0 : size;
        for (int k = 0; k < own.count; ++k)
        {
            found->sets[i] = own.sets[k]->identity == hash ? own.sets[k] : found->sets[i];
        }
        if (found->sets[i] == NULL && !stream->isBroken)
        {
            return failRewind(world, "a wave system had other waves then, which are gone; make a world of it with "
                                     "swRestoreWorld()");
        }
    }
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

static bool isSameViewDef(const swViewDef* a, const swViewDef* b)
{
    return a->sliceCount == b->sliceCount && a->resolution == b->resolution && a->finestTexel == b->finestTexel &&
           a->maxScaleLevel == b->maxScaleLevel && a->enableCpuLayers == b->enableCpuLayers;
}

static swResult readViews(const swWorld* world, swStream* stream, Rewind* rewind)
{
    int count = 0;
    swStreamRange(stream, &count, 0, SW_MAX_VIEWS);
    if (!stream->isBroken && count != world->viewCount)
    {
        return failRewind(world, "it had another number of views then");
    }
    for (int i = 0; i < count && !stream->isBroken; ++i)
    {
        swViewDef def = world->views[i]->def;
        streamViewDef(stream, &def);
        if (!stream->isBroken && !isSameViewDef(&def, &world->views[i]->def))
        {
            return failRewind(world, "a view had another def then");
        }
        streamViewState(stream, def.maxScaleLevel, &rewind->views[i]);
        rewind->layers[i] = stream->at;
        swCheckLayers(stream, &world->views[i]->layers);
    }
    return stream->isBroken ? SW_ERROR_FORMAT : SW_SUCCESS;
}

static void applyRewind(swWorld* world, const swStream* stream, const Rewind* rewind)
{
    useLayers(rewind->systems);
    unuseLayers(world, world->systems);
    world->systemIds = rewind->ids;
    memcpy(world->systems, rewind->systems, sizeof world->systems);
    swPos last[SW_MAX_VIEWS];
    for (int i = 0; i < world->viewCount; ++i)
    {
        swView* view = world->views[i];
        swStream layers = *stream;
        layers.at = rewind->layers[i];
        swStreamLayers(&layers, &view->layers);
        setViewState(view, &rewind->views[i]);
        last[i] = rewind->views[i].last;
    }
    world->rewindCount += 1;
    finishReading(world, &rewind->clocks, last);
}

swResult swRewindState(swWorld* world, swStream* stream)
{
    Rewind rewind = {.ids = swMakeIdPool(SW_MAX_WAVE_SYSTEMS)};
    streamClocks(stream, &rewind.clocks);
    swResult result = stream->isBroken ? SW_ERROR_FORMAT : findSets(world, stream, &rewind.sets);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    streamSystems(stream, &rewind.sets, &rewind.ids, rewind.systems);
    result = stream->isBroken ? SW_ERROR_FORMAT : readViews(world, stream, &rewind);
    bool isFine = stream->at == stream->size && swIsWithinLimits(world, rewind.systems);
    result = result == SW_SUCCESS && !isFine ? SW_ERROR_FORMAT : result;
    if (result == SW_SUCCESS)
    {
        applyRewind(world, stream, &rewind);
    }
    return result;
}
