// SPDX-License-Identifier: MIT
// Moments with memory of their own. All that queries read lies in one block: a head, the tiles, free waves, then what
// the tiles name: splines' responses, modes and texels. The block holds offsets and no addresses. A moment beside it
// has the tiles with addresses of this process; a mapped one makes them once, after it has looked whether all offsets
// and counts lie within the block, so that queries follow only addresses that are good.

#include "core/world/moment.h"

#include <math.h>
#include <string.h>

#include "core/base/hash.h"
#include "core/base/host.h"
#include "core/input/wind.h"
#include "core/world/moment_inputs.h"

#define MOMENT_MARK 0x544e454d4f4d5753u // "SWMOMENT"
#define MOMENT_VERSION 4u
#define ALIGNMENT 64

// Of any legal tile, m.
#define LEAST_SIDE 0.01
#define LARGEST_SIDE 1e7
#define HIGHEST_SEA 1e6

typedef struct Head
{
    uint64_t mark;
    uint64_t hash; // of the rest of the head, the tiles and the free waves
    uint32_t version;
    uint32_t headSize, tileSize, modeSize, waveSize; // of this build's structs
    uint32_t isHeld;
    uint64_t size; // of all
    double time;
    int64_t ticks;
    double seaLevel;
    swPosXZ origin;
    float gravity;
    int32_t tileCount, waveCount;
    swWind wind;
    swEvenFlow evenFlow;
    uint64_t tiles, waves, inputs; // offsets
} Head;

typedef struct StoredTile
{
    swTile tile; // its addresses are NULL
    uint64_t response, modes;
    uint64_t texels[SW_TEXELS_COUNT]; // 0: none
} StoredTile;

// ---- sizes ----

static size_t roundUp(size_t size)
{
    return (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
}

static size_t getResponseSize(int resolution)
{
    return roundUp(((size_t)resolution / 4 + 1) * sizeof(float));
}

static size_t getTexelsSize(int resolution)
{
    size_t pitch = (size_t)resolution + 3;
    return roundUp(pitch * pitch * 4 * sizeof(float));
}

static size_t getModesSize(int count)
{
    return roundUp((size_t)count * sizeof(swMode));
}

static size_t getHeadSize(int tileCount, int waveCount)
{
    return roundUp(sizeof(Head)) + roundUp((size_t)tileCount * sizeof(StoredTile)) +
           roundUp((size_t)waveCount * sizeof(swFreeWave));
}

// What a set takes beside its part of the head.
static size_t getSetSize(const swWaves* waves, const swWaveSet* set)
{
    size_t size = set->tileCount > 0 ? getResponseSize(set->def.resolution) : 0;
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        if (set->bands[i].modeCount == 0)
        {
            continue;
        }
        size += getModesSize(set->bands[i].modeCount);
        for (int field = 0; field < SW_TEXELS_COUNT; ++field)
        {
            size += waves->hasTexels[field] ? getTexelsSize(set->def.resolution) : 0;
        }
    }
    return size;
}

static size_t getShownSize(const swWaves* waves, const swShown* shown, int* tileCount, int* waveCount)
{
    size_t size = 0;
    *tileCount = *waveCount = 0;
    for (int i = 0; i < shown->count; ++i)
    {
        const swWaveSet* set = shown->sets[i].set;
        size += getSetSize(waves, set);
        *tileCount += set->tileCount;
        *waveCount += set->waveCount;
    }
    return size + getHeadSize(*tileCount, *waveCount);
}

// A mix has all waves of what it becomes.
size_t swFindMomentSize(const swWaves* waves, const swInputs* inputs)
{
    swShown shown;
    int tileCount, waveCount;
    swFindShown(waves, 0.0, INT64_MIN / 2, &shown); // before any change that is under way
    return getShownSize(waves, &shown, &tileCount, &waveCount) + swFindStoredInputsSize(inputs);
}

// ---- making ----

// The block while it is filled.
typedef struct Fill
{
    swOwnMoment* moment;
    const swWaves* waves;
    int64_t ticks;
    size_t at;
} Fill;

static void* take(Fill* fill, size_t size)
{
    void* place = (char*)fill->moment->memory + fill->at;
    fill->at += size;
    return place;
}

// The modes and statistics of a set at the share of its mix, into the moment's own bands.
static void fillBands(Fill* fill, const swShownSet* shown)
{
    swBandModes* bands = fill->moment->bands;
    memcpy(bands, shown->set->bands, sizeof fill->moment->bands);
    for (int i = 0; i < SW_SET_TILES; ++i)
    {
        if (bands[i].modeCount > 0)
        {
            size_t size = (size_t)bands[i].modeCount * sizeof(swMode);
            bands[i].modes = memcpy(take(fill, getModesSize(bands[i].modeCount)), bands[i].modes, size);
        }
    }
    if (shown->set->mix != NULL)
    {
        swApplyModeMix(shown->set->mix, shown->share, bands);
    }
}

static void fillTile(Fill* fill, const float* response, int index)
{
    swTileList* list = &fill->moment->list;
    swTile* tile = &list->tiles[index];
    float** texels = list->texels[index];
    for (int field = 0; field < SW_TEXELS_COUNT; ++field)
    {
        texels[field] = fill->waves->hasTexels[field] ? take(fill, getTexelsSize(tile->resolution)) : NULL;
    }
    tile->response = response;
    tile->texels = texels[SW_TEXELS_DISPLACEMENT];
    tile->velocity = texels[SW_TEXELS_VELOCITY];
    tile->acceleration = texels[SW_TEXELS_ACCELERATION];
    tile->likeness = texels[SW_TEXELS_LIKENESS];
    list->isLikenessMade[index] = false;
}

static void fillSet(Fill* fill, const swShownSet* shown)
{
    swTileList* list = &fill->moment->list;
    int first = list->tileCount;
    fillBands(fill, shown);
    swListSet(list, shown, fill->moment->bands, fill->ticks);
    if (list->tileCount == first)
    {
        return;
    }
    size_t count = (size_t)shown->set->def.resolution / 4 + 1;
    float* response = take(fill, getResponseSize(shown->set->def.resolution));
    memcpy(response, shown->set->response, count * sizeof(float));
    for (int i = first; i < list->tileCount; ++i)
    {
        fillTile(fill, response, i);
    }
}

static uint64_t getOffset(const swOwnMoment* moment, const void* place)
{
    return place == NULL ? 0 : (uint64_t)((const char*)place - (const char*)moment->memory);
}

static uint64_t hashHead(const char* block, const Head* head)
{
    swHash hash = swBeginHash();
    size_t begin = offsetof(Head, version);
    size_t end = getHeadSize(head->tileCount, head->waveCount);
    for (size_t at = begin; at + 8 <= end; at += 8)
    {
        uint64_t word;
        memcpy(&word, block + at, sizeof word);
        swAddHash(&hash, word);
    }
    return swEndHash(&hash);
}

static bool areCountsGood(const Head* head)
{
    return head->tileCount >= 0 && head->tileCount <= SW_MAX_TILES && head->waveCount >= 0 &&
           head->waveCount <= SW_MAX_FREE_WAVES;
}

void swSignMoment(void* block)
{
    Head head;
    memcpy(&head, block, sizeof head);
    head.hash = areCountsGood(&head) ? hashHead(block, &head) : 0;
    memcpy(block, &head, sizeof head);
}

// The head, last: what stands behind it is there.
static void writeHead(swOwnMoment* moment, uint64_t inputs)
{
    const swTileList* list = &moment->list;
    const swWindFrame* wind = &moment->frame.windField;
    char* block = moment->memory;
    memset(block, 0, getHeadSize(list->tileCount, list->waveCount));
    Head head = {
        .mark = MOMENT_MARK,
        .version = MOMENT_VERSION,
        .headSize = sizeof(Head),
        .tileSize = sizeof(StoredTile),
        .modeSize = sizeof(swMode),
        .waveSize = sizeof(swFreeWave),
        .isHeld = moment->moment.isHeld ? 1 : 0,
        .size = moment->usedSize,
        .time = moment->frame.time,
        .ticks = moment->frame.ticks,
        .seaLevel = moment->frame.seaLevel,
        .origin = moment->origin,
        .gravity = moment->frame.gravity,
        .wind = {.from = wind->fromDef, .to = wind->toDef, .begin = wind->begin, .length = wind->length},
        .evenFlow = moment->evenFlow,
        .tileCount = list->tileCount,
        .waveCount = list->waveCount,
        .inputs = inputs,
        .tiles = roundUp(sizeof(Head)),
        .waves = roundUp(sizeof(Head)) + roundUp((size_t)list->tileCount * sizeof(StoredTile)),
    };
    memcpy(block, &head, sizeof head);
    StoredTile* tiles = (StoredTile*)(void*)(block + head.tiles);
    for (int i = 0; i < list->tileCount; ++i)
    {
        StoredTile* stored = &tiles[i];
        stored->tile = list->tiles[i];
        stored->response = getOffset(moment, stored->tile.response);
        stored->modes = getOffset(moment, stored->tile.modes);
        for (int field = 0; field < SW_TEXELS_COUNT; ++field)
        {
            stored->texels[field] = getOffset(moment, list->texels[i][field]);
        }
        stored->tile.modes = NULL;
        stored->tile.evenFlow = NULL;
        stored->tile.response = stored->tile.texels = stored->tile.velocity = stored->tile.acceleration = NULL;
    }
    swFreeWave* waves = (swFreeWave*)(void*)(block + head.waves);
    for (int i = 0; i < list->waveCount; ++i)
    {
        waves[i] = list->waves[i];
        waves[i].evenFlow = NULL;
    }
    swSignMoment(block);
}

static swResult reserve(swOwnMoment* moment, const swMomentSource* source, size_t needed)
{
    const swWaves* waves = source->waves;
    if (moment->scratchSize < waves->scratchSize)
    {
        void* scratch = swAllocate(&moment->host, waves->scratchSize);
        if (scratch == NULL)
        {
            return swFail(&moment->host, SW_ERROR_NO_MEMORY, "no memory for a moment's transforms (%zu bytes)",
                          waves->scratchSize);
        }
        swFree(&moment->host, moment->scratch, moment->scratchSize);
        moment->scratch = scratch;
        moment->scratchSize = waves->scratchSize;
    }
    if (needed <= moment->memorySize)
    {
        return SW_SUCCESS;
    }
    if (!moment->isAllocated)
    {
        return swFail(&moment->host, SW_ERROR_LIMIT,
                      "a moment of the world takes %zu bytes; its memory has %zu (swWorld_GetMomentSize())", needed,
                      moment->memorySize);
    }
    size_t size = swFindMomentSize(waves, source->inputs);
    size = size > needed ? size : needed;
    void* memory = swAllocate(&moment->host, size);
    if (memory == NULL)
    {
        return swFail(&moment->host, SW_ERROR_NO_MEMORY, "no memory for a moment (%zu bytes)", size);
    }
    swFree(&moment->host, moment->memory, moment->memorySize);
    moment->memory = memory;
    moment->memorySize = size;
    return SW_SUCCESS;
}

static void showList(swOwnMoment* moment)
{
    moment->frame.tileCount = moment->list.tileCount;
    moment->frame.tiles = moment->list.tiles;
    moment->frame.waveCount = moment->list.waveCount;
    moment->frame.waves = moment->list.waves;
    moment->frame.inputs = &moment->inputs.set;
}

swResult swSetMoment(swOwnMoment* moment, const swMomentSource* source, double time)
{
    const swWaves* waves = source->waves;
    int64_t ticks = (int64_t)floor(time * SW_TICKS_PER_SECOND + 0.5);
    swShown shown;
    swFindShown(waves, time, ticks, &shown);
    int tileCount, waveCount;
    size_t waveSize = getShownSize(waves, &shown, &tileCount, &waveCount);
    if (!swReserveInputArrays(&moment->host, &moment->inputs, source->inputs->count))
    {
        return swFail(&moment->host, SW_ERROR_NO_MEMORY, "no memory for a moment's %d inputs", source->inputs->count);
    }
    swResult result = reserve(moment, source, waveSize + swFindStoredInputsSize(source->inputs));
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swFillInputArrays(source->inputs, time, source->localSystems, &moment->inputs);
    swFindEvenFlow(source->inputs, &moment->inputs, ticks, &moment->evenFlow);
    swClearTileList(&moment->list);
    Fill fill = {.moment = moment, .waves = waves, .ticks = ticks, .at = getHeadSize(tileCount, waveCount)};
    for (int i = 0; i < shown.count; ++i)
    {
        if (shown.sets[i].weight != 0.0f)
        {
            fillSet(&fill, &shown.sets[i]);
        }
    }
    for (int i = 0; i < swCountTransforms(&moment->list); ++i)
    {
        swTransformListed(&moment->list, waves->kernels, ticks, i, moment->scratch);
    }
    moment->moment.kernels = waves->kernels;
    moment->moment.isHeld = shown.isHeld;
    moment->origin = source->origin;
    moment->frame = (swFrame){
        .time = time,
        .ticks = ticks,
        .seaLevel = source->frame->seaLevel,
        .gravity = source->frame->gravity,
        .windField = source->frame->windField,
    };
    swStoreInputs(&moment->inputs, (char*)moment->memory + fill.at);
    moment->usedSize = fill.at + swGetStoredInputsSize(&moment->inputs.set);
    showList(moment);
    writeHead(moment, fill.at);
    return SW_SUCCESS;
}

static swOwnMoment* allocateMoment(const swHost* host)
{
    swOwnMoment* moment = swAllocateZero(host, sizeof *moment);
    if (moment == NULL)
    {
        swFail(host, SW_ERROR_NO_MEMORY, "no memory for a moment (%zu bytes)", sizeof *moment);
        return NULL;
    }
    moment->host = *host;
    moment->list.evenFlow = &moment->evenFlow;
    moment->moment = (swMoment){
        .host = &moment->host,
        .frame = &moment->frame,
        .origin = &moment->origin,
        .isOwn = true,
    };
    return moment;
}

swResult swMakeMoment(const swMomentSource* source, const swMomentDef* def, swOwnMoment** momentOut)
{
    swOwnMoment* moment = allocateMoment(source->host);
    if (moment == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    moment->memory = def->memory;
    moment->memorySize = def->memory != NULL ? def->memorySize : 0;
    moment->isAllocated = def->memory == NULL;
    swResult result = swSetMoment(moment, source, def->time);
    if (result != SW_SUCCESS)
    {
        swFreeMoment(moment);
        return result;
    }
    *momentOut = moment;
    return SW_SUCCESS;
}

void swFreeMoment(swOwnMoment* moment)
{
    swHost host = moment->host;
    swFree(&host, moment->scratch, moment->scratchSize);
    swFreeInputArrays(&host, &moment->inputs);
    if (moment->isAllocated)
    {
        swFree(&host, moment->memory, moment->memorySize);
    }
    swFree(&host, moment, sizeof *moment);
}

// ---- mapping ----

static swResult refuse(const swHost* host, const char* what)
{
    return swFail(host, SW_ERROR_FORMAT, "the memory of a moment %s", what);
}

static swResult readHead(const swHost* host, const char* block, size_t size, Head* head)
{
    if (size < sizeof *head)
    {
        return refuse(host, "is too short to hold one");
    }
    memcpy(head, block, sizeof *head);
    if (head->mark != MOMENT_MARK)
    {
        return refuse(host, "does not begin as one does");
    }
    if (head->version != MOMENT_VERSION || head->headSize != sizeof(Head) || head->tileSize != sizeof(StoredTile) ||
        head->modeSize != sizeof(swMode) || head->waveSize != sizeof(swFreeWave))
    {
        return refuse(host, "was made by another build of this library");
    }
    if (!areCountsGood(head) || head->size > size || head->size < getHeadSize(head->tileCount, head->waveCount) ||
        head->hash != hashHead(block, head))
    {
        return refuse(host, "is damaged, or not all there");
    }
    bool isPlaced = head->tiles == roundUp(sizeof(Head)) &&
                    head->waves == head->tiles + roundUp((size_t)head->tileCount * sizeof(StoredTile));
    bool isTime =
        fabs(head->time) <= SW_LARGEST_TIME && head->ticks == (int64_t)floor(head->time * SW_TICKS_PER_SECOND + 0.5);
    bool isWind = swIsWindGood(&head->wind);
    return isPlaced && isTime && isWind && swIsEvenFlowGood(&head->evenFlow)
               ? SW_SUCCESS
               : refuse(host, "holds a state that cannot be");
}

// An address in the block, or NULL if `bytes` there would not lie within it.
static void* findPlace(const swOwnMoment* moment, uint64_t offset, size_t bytes)
{
    bool isInside = offset >= sizeof(Head) && offset % ALIGNMENT == 0 && offset <= moment->usedSize &&
                    bytes <= moment->usedSize - offset;
    return isInside ? (char*)moment->memory + offset : NULL;
}

static bool areModesGood(const swTile* tile)
{
    for (int i = 0; i < tile->modeCount; ++i)
    {
        const swMode* mode = &tile->modes[i];
        if (mode->qx < -tile->maxBin || mode->qx > tile->maxBin || mode->qz < 0 || mode->qz > tile->maxBin)
        {
            return false;
        }
    }
    return true;
}

static bool mapTexels(const swOwnMoment* moment, const StoredTile* stored, int field, const float** texels)
{
    bool isThere = stored->texels[field] != 0;
    *texels = isThere ? findPlace(moment, stored->texels[field], getTexelsSize(stored->tile.resolution)) : NULL;
    return !isThere || *texels != NULL;
}

static bool mapTile(const swOwnMoment* moment, const StoredTile* stored, swTile* tile)
{
    *tile = stored->tile;
    tile->evenFlow = moment->list.evenFlow;
    int n = tile->resolution;
    bool isFine = n >= 16 && n <= SW_LIMIT_RESOLUTION && (n & (n - 1)) == 0 && tile->maxBin >= 0 &&
                  tile->maxBin <= n / 4 && tile->side >= LEAST_SIDE && tile->side <= LARGEST_SIDE &&
                  tile->modeCount > 0 && tile->modeCount <= n * n && (unsigned)tile->band < SW_MAX_BANDS;
    if (!isFine)
    {
        return false;
    }
    tile->response = findPlace(moment, stored->response, ((size_t)n / 4 + 1) * sizeof(float));
    tile->modes = findPlace(moment, stored->modes, (size_t)tile->modeCount * sizeof(swMode));
    return tile->response != NULL && tile->modes != NULL &&
           mapTexels(moment, stored, SW_TEXELS_DISPLACEMENT, &tile->texels) &&
           mapTexels(moment, stored, SW_TEXELS_VELOCITY, &tile->velocity) &&
           mapTexels(moment, stored, SW_TEXELS_ACCELERATION, &tile->acceleration) &&
           mapTexels(moment, stored, SW_TEXELS_LIKENESS, &tile->likeness) && areModesGood(tile);
}

// All tiles have the same fields, as those of a world.
static bool mapTiles(swOwnMoment* moment, const Head* head)
{
    const StoredTile* stored = (const StoredTile*)(const void*)((const char*)moment->memory + head->tiles);
    swTile* tiles = moment->list.tiles;
    for (int i = 0; i < head->tileCount; ++i)
    {
        if (!mapTile(moment, &stored[i], &tiles[i]) || (tiles[i].texels == NULL) != (tiles[0].texels == NULL) ||
            (tiles[i].velocity == NULL) != (tiles[0].velocity == NULL) ||
            (tiles[i].acceleration == NULL) != (tiles[0].acceleration == NULL))
        {
            return false;
        }
    }
    moment->list.tileCount = head->tileCount;
    return true;
}

swResult swMapMomentBlock(const swHost* host, const void* memory, size_t size, swOwnMoment** momentOut)
{
    Head head;
    swResult result = readHead(host, memory, size, &head);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swOwnMoment* moment = allocateMoment(host);
    if (moment == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    moment->memory = (void*)memory;
    moment->memorySize = size;
    moment->usedSize = (size_t)head.size;
    moment->isMapped = true;
    moment->evenFlow = head.evenFlow;
    int inputCount = 0;
    const char* inputs = findPlace(moment, head.inputs, 1);
    bool areInputsGood =
        inputs != NULL && swCheckStoredInputs(inputs, moment->usedSize - (size_t)head.inputs, &inputCount);
    if (!mapTiles(moment, &head) || !areInputsGood)
    {
        swFreeMoment(moment);
        return refuse(host, "holds a state that cannot be");
    }
    if (!swReserveInputArrays(host, &moment->inputs, inputCount))
    {
        swFreeMoment(moment);
        return swFail(host, SW_ERROR_NO_MEMORY, "no memory for a moment's %d inputs", inputCount);
    }
    moment->list.waveCount = head.waveCount;
    memcpy(moment->list.waves, (const char*)memory + head.waves, (size_t)head.waveCount * sizeof(swFreeWave));
    for (int i = 0; i < head.waveCount; ++i)
    {
        moment->list.waves[i].evenFlow = &moment->evenFlow;
    }
    moment->moment.kernels = swGetWaveKernels(SW_ISA_BEST);
    moment->moment.isHeld = head.isHeld != 0;
    moment->origin = head.origin;
    moment->frame = (swFrame){
        .time = head.time,
        .ticks = head.ticks,
        .seaLevel = head.seaLevel,
        .gravity = head.gravity,
    };
    swDeriveWind(&head.wind, head.ticks, &moment->frame.windField);
    showList(moment);
    swMapStoredInputs((const char*)memory + head.inputs, &moment->inputs);
    *momentOut = moment;
    return SW_SUCCESS;
}
