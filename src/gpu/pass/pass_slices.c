// SPDX-License-Identifier: MIT
// One dispatch a view for all its slices; nothing waits between views. Where a slice lies on a tile is reduced in
// double here, so that the shader sees small numbers wherever in the world the viewer is.

#include <math.h>
#include <string.h>

#include "core/math/scalar.h"
#include "gpu/pass/passes.h"
#include "slices_shader.h"

// Of one view, in this frame.
typedef struct ViewState
{
    swUpload lists; // swSliceList[sliceCount]
    swUpload tiles; // swSliceTile[]
    swUpload waves; // swSliceWave[]
    swSlicesConstants constants;
} ViewState;

typedef struct State
{
    swVariants pipelines;
    ViewState views[SW_MAX_VIEWS];
} State;

// Turns as a fraction of 2^32.
static uint32_t toPhase(double turns)
{
    return (uint32_t)(uint64_t)floor((turns - floor(turns)) * 0x1p32);
}

// Whether systems may have weights of their own somewhere.
static bool hasWeights(const swFrame* frame)
{
    return swHasInputs(frame->inputs, SW_INPUT_WAVES) || frame->inputs->localSystems != 0;
}

// Spline coordinate of the slice's first texel along one axis, as a texel column and a fraction.
static void reduceOffset(int64_t first, double texel, double shift, const swTile* tile, float* fraction, uint32_t* base)
{
    double turns = ((double)first * texel - shift) / tile->side;
    double coordinate = (turns - floor(turns)) * tile->resolution;
    double cell = floor(coordinate);
    *fraction = (float)(coordinate - cell);
    *base = (uint32_t)cell & (uint32_t)(tile->resolution - 1);
}

static swSliceTile makeSliceTile(const swSlice* slice, const swTile* tile, uint32_t firstTexel)
{
    swSliceTile out = {
        .step = (float)(slice->texel * tile->resolution / tile->side),
        .perMetre = (float)(tile->resolution / tile->side),
        .firstTexel = firstTexel,
        .secondTexel = SW_NO_TEXEL,
        .resolution = (uint32_t)tile->resolution,
        .texelsPerUnit = (float)(tile->side / (slice->texel * tile->resolution)),
        .waveNumber = swGetTileWaveNumber(tile),
        .system = (uint32_t)tile->system,
        .attenuation = tile->attenuation,
        .cellTurns = toPhase((double)SW_QUERY_CELL / tile->side + 0x1p-33),
    };
    uint32_t baseX, baseZ;
    reduceOffset(slice->firstX, slice->texel, tile->shiftX, tile, &out.fractionX, &baseX);
    reduceOffset(slice->firstZ, slice->texel, tile->shiftZ, tile, &out.fractionZ, &baseZ);
    out.base = baseX | baseZ << 16;
    return out;
}

// The most columns of a tile that a block of texels touches: its texels lie floor(texels * step) + 1 cells apart at
// most, and rounding may add one.
static uint32_t countColumns(const swSliceTile* tile)
{
    return (uint32_t)((float)(SW_SLICE_WIDTH - 1) * tile->step * 1.0001f) + 5;
}

// The most knots that a group of rows passes. All rows have one gap less between them.
static uint32_t countKnots(const swSliceTile* tile, uint32_t rows)
{
    uint32_t gaps = rows < SW_SLICE_HEIGHT ? rows : SW_SLICE_HEIGHT - 1;
    return (uint32_t)((float)gaps * tile->step) + 1;
}

// Gives the tiles of a list their places among the columns that are laid out together.
static void placeColumns(uint32_t count, swSliceTile* tiles)
{
    uint32_t begin = 0, columns = 0, all = 0;
    for (uint32_t i = 0; i < count; ++i)
    {
        if (columns + tiles[i].columnCount > SW_SLICE_COLUMNS)
        {
            begin = i;
            columns = 0;
        }
        tiles[i].firstColumn = columns;
        tiles[i].firstOfAll = all;
        columns += tiles[i].columnCount;
        all += tiles[i].columnCount;
        for (uint32_t j = begin; j <= i; ++j)
        {
            tiles[j].batchEnd = i + 1;
        }
    }
}

// Likewise among the knots of a group of rows. Returns how many tiles there is room for.
static uint32_t placeJumps(uint32_t count, swSliceTile* tiles, uint32_t rows)
{
    uint32_t jumps = 0;
    for (uint32_t i = 0; i < count; ++i)
    {
        uint32_t jumpCount = countKnots(&tiles[i], rows) * tiles[i].columnCount;
        if (jumps + jumpCount > SW_SLICE_JUMPS)
        {
            return i;
        }
        tiles[i].firstJump = jumps;
        jumps += jumpCount;
    }
    return count;
}

// Gives all tiles of a list, also those added texel by texel, their places among what slices_shaped.comp lays out. The
// longest waves are last, and those are shaped first as water gets shallower.
static void placeShaped(uint32_t count, swSliceTile* tiles)
{
    uint32_t end = count, columns = 0;
    for (uint32_t i = count; i-- > 0;)
    {
        uint32_t own = tiles[i].columnCount <= SW_SHAPED_COLUMNS ? tiles[i].columnCount : 0;
        tiles[i].shapedColumns = own;
        if (columns + own > SW_SHAPED_COLUMNS || (i + 1) % SW_SHAPED_TILES == 0)
        {
            end = i + 1;
            columns = 0;
        }
        tiles[i].firstShaped = columns;
        columns += own;
        for (uint32_t j = i; j < end; ++j)
        {
            tiles[j].shapedBegin = i;
        }
    }
}

static bool isAlike(const swAttenuation* a, const swAttenuation* b)
{
    return a->strength == b->strength && a->perFreeDepth == b->perFreeDepth;
}

// Adds a tile to one that lies just so in the slice, of a sea of the same resolution that moves with the same current.
// Where systems have weights of their own, each stays by itself.
static bool joinTile(uint32_t count, swSliceTile* tiles, const swSliceTile* tile)
{
    for (uint32_t i = 0; i < count; ++i)
    {
        swSliceTile* other = &tiles[i];
        if (other->secondTexel == SW_NO_TEXEL && other->step == tile->step && other->resolution == tile->resolution &&
            other->base == tile->base && other->fractionX == tile->fractionX && other->fractionZ == tile->fractionZ &&
            other->waveNumber == tile->waveNumber && other->carryTurns == tile->carryTurns &&
            other->carryPeriod == tile->carryPeriod && isAlike(&other->attenuation, &tile->attenuation))
        {
            other->secondTexel = tile->firstTexel;
            return true;
        }
    }
    return false;
}

// The slice's tiles: first those that are added as cubics, as many as a block has room for, then the others.
static void makeSliceTiles(const swGpuWorld* gpuWorld, const swFrame* frame, const swSlice* slice, swSliceTile* tiles,
                           swSliceList* list)
{
    swSliceTile others[SW_MAX_TILES];
    uint32_t count = 0;
    bool isJoined = !hasWeights(frame);
    for (int i = 0; i < frame->tileCount; ++i)
    {
        if (frame->tiles[i].minWavelength < slice->minWavelength)
        {
            continue;
        }
        swSliceTile tile = makeSliceTile(slice, &frame->tiles[i], gpuWorld->tiles.params[i].firstTexel);
        if (gpuWorld->tiles.isCarried)
        {
            tile.carryTurns =
                swGetCarryPhase(tile.waveNumber, frame->tiles[i].loopTicks, frame->ticks, &tile.carryPeriod);
        }
        tile.columnCount = countColumns(&tile);
        if (isJoined && (joinTile(count, tiles, &tile) || joinTile(list->windowCount, others, &tile)))
        {
            continue;
        }
        if (tile.step <= SW_SLICE_STEP && count < SW_SLICE_TILES)
        {
            tiles[count++] = tile;
        }
        else
        {
            others[list->windowCount++] = tile;
        }
    }
    list->groupRows = SW_SLICE_HEIGHT;
    list->count = placeJumps(count, tiles, list->groupRows);
    while (list->count < count && list->groupRows > 2)
    {
        list->groupRows /= 2;
        list->count = placeJumps(count, tiles, list->groupRows);
    }
    placeColumns(list->count, tiles);
    memcpy(tiles + count, others, list->windowCount * sizeof(swSliceTile));
    list->windowCount += count - list->count;
    placeShaped(list->count + list->windowCount, tiles);
}

static swSliceWave makeSliceWave(const swSlice* slice, const swFreeWave* wave, int64_t ticks)
{
    double place =
        wave->turnsX * ((double)slice->firstX * slice->texel) + wave->turnsZ * ((double)slice->firstZ * slice->texel);
    swSliceWave out = {
        .phase = toPhase(place) + wave->phase - swGetPassedTurns(wave, ticks),
        .stepX = toPhase(wave->turnsX * slice->texel + 0x1p-33),
        .stepZ = toPhase(wave->turnsZ * slice->texel + 0x1p-33),
        .amplitude = wave->amplitude,
        .dx = wave->dx,
        .dz = wave->dz,
        .kx = (float)(2.0 * SW_PI * wave->turnsX),
        .kz = (float)(2.0 * SW_PI * wave->turnsZ),
        .waveNumber = swGetOctaveWaveNumber(wave->wavelength),
        .system = (uint32_t)wave->system,
        .attenuation = wave->attenuation,
        .cellTurnsX = toPhase(wave->turnsX * (double)SW_QUERY_CELL + 0x1p-33),
        .cellTurnsZ = toPhase(wave->turnsZ * (double)SW_QUERY_CELL + 0x1p-33),
    };
    swSinCosTurns(out.stepZ, &out.sinZ, &out.cosZ);
    return out;
}

// Longest first, as the frame has them.
static void fillSliceWaves(const swFrame* frame, const swSlice* slice, swSliceWave* waves, swSliceList* list)
{
    int count = 0, groupEnd = 0;
    while (count < frame->waveCount && frame->waves[count].wavelength >= slice->minWavelength)
    {
        count += 1;
    }
    for (int i = 0; i < count; ++i)
    {
        const swFreeWave* wave = &frame->waves[i];
        swSliceWave seen = makeSliceWave(slice, wave, frame->ticks);
        groupEnd = i == groupEnd ? swFindCarriedEnd(frame->waves, i, count) : groupEnd;
        seen.groupEnd = (uint32_t)groupEnd;
        seen.carryTurns = swGetCarryPhase(seen.waveNumber, wave->loopTicks, frame->ticks, &seen.carryPeriod);
        waves[i] = seen;
    }
    list->waveCount = (uint32_t)count;
}

static swResult uploadView(swGpuWorld* gpuWorld, const swFrame* frame, const swStackFrame* stack, ViewState* view)
{
    swGpu* gpu = gpuWorld->gpu;
    swSliceList lists[SW_MAX_SLICES] = {0};
    size_t slices = (size_t)stack->sliceCount;
    size_t mostTiles = slices * (size_t)(frame->tileCount > 0 ? frame->tileCount : 1);
    size_t mostWaves = slices * (size_t)(frame->waveCount > 0 ? frame->waveCount : 1);
    swResult result = swReserveUpload(gpu, mostTiles * sizeof(swSliceTile), &view->tiles);
    result = result == SW_SUCCESS ? swReserveUpload(gpu, mostWaves * sizeof(swSliceWave), &view->waves) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    uint32_t tileCount = 0;
    uint32_t waveCount = 0;
    view->constants = (swSlicesConstants){
        .withPlaces = gpuWorld->inputs.isAuthored ? 1 : 0,
    };
    for (int i = 0; i < stack->sliceCount; ++i)
    {
        const swSlice* slice = &stack->slices[i];
        swSliceList* list = &lists[i];
        swSliceTile tiles[SW_MAX_TILES]; // uploads are written once, in order: they are slow to read
        list->first = tileCount;
        list->firstWave = waveCount;
        list->texelsPerMetre = (float)(1.0 / slice->texel);
        list->minWavelength = slice->minWavelength;
        makeSliceTiles(gpuWorld, frame, slice, tiles, list);
        uint32_t all = list->count + list->windowCount;
        memcpy((swSliceTile*)view->tiles.data + tileCount, tiles, all * sizeof(swSliceTile));
        fillSliceWaves(frame, slice, (swSliceWave*)view->waves.data + waveCount, list);
        tileCount += all;
        waveCount += list->waveCount;
        view->constants.withOthers |= list->windowCount + list->waveCount > 0 ? 1 : 0;
    }
    return swUploadData(gpu, lists, sizeof(lists), &view->lists);
}

static bool isMade(const swGpuView* view)
{
    return view->isUsed && !view->isCore;
}

static swResult upload(swGpuWorld* gpuWorld, const swFrame* frame, void* state, bool* isNeeded)
{
    State* s = state;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < SW_MAX_VIEWS && result == SW_SUCCESS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i];
        if (isMade(view))
        {
            *isNeeded = true;
            result = uploadView(gpuWorld, frame, &view->frame->stack, &s->views[i]);
        }
    }
    return result;
}

static swResult create(swGpuWorld* gpuWorld, void* state)
{
    State* s = state;
    const swSlicesConstants tilesAlone = {0};
    swResult result = swCreateVariant(gpuWorld->gpu, &swSlicesShader, &tilesAlone, &s->pipelines);
    for (int i = 0; i < SW_MAX_VIEWS && result == SW_SUCCESS; ++i)
    {
        if (isMade(&gpuWorld->views[i]))
        {
            result = swCreateVariant(gpuWorld->gpu, &swSlicesShader, &s->views[i].constants, &s->pipelines);
        }
    }
    return result;
}

static void record(const swGpuWorld* gpuWorld, void* state, VkCommandBuffer commands)
{
    swGpu* gpu = gpuWorld->gpu;
    const State* s = state;
    static_assert(sizeof(uint32_t) == SW_SLICES_PUSH_SIZE, "what slices.comp is given");
    for (int i = 0; i < SW_MAX_VIEWS; ++i)
    {
        const swGpuView* view = &gpuWorld->views[i];
        if (!isMade(view))
        {
            continue;
        }
        swBinding fields[2] = {swBindUpload(&s->views[i].lists), swBindUpload(&s->views[i].lists)};
        swBindFieldPlaces(gpuWorld, i, &fields[0], &fields[1]);
        const swBuffer* shaped = swGetShapedWaves(gpuWorld, i);
        const swImage* displacement = swGetLayerImage(view, SW_LAYER_DISPLACEMENT);
        const swImage* derivatives = swGetLayerImage(view, SW_LAYER_DERIVATIVES);
        const swSlicesBindings bindings = {
            .lists = swBindUpload(&s->views[i].lists),
            .tiles = swBindUpload(&s->views[i].tiles),
            .texels = swBindBuffer(&gpuWorld->tiles.texels),
            .displacement = swBindImage(gpu, displacement, SW_SAMPLER_NEAREST_CLAMP),
            .derivatives = swBindImage(gpu, derivatives, SW_SAMPLER_NEAREST_CLAMP),
            .waves = swBindUpload(&s->views[i].waves),
            .blocks = fields[1],
            .shaped = shaped->handle != VK_NULL_HANDLE ? swBindBuffer(shaped) : fields[0],
        };
        uint32_t resolution = (uint32_t)view->resolution;
        swBindSlices(gpu, commands, swFindVariant(&s->pipelines, &swSlicesShader, &s->views[i].constants), &bindings,
                     &resolution);
        gpu->vk.CmdDispatch(commands, (resolution + SW_SLICE_WIDTH - 1) / SW_SLICE_WIDTH, resolution / SW_SLICE_HEIGHT,
                            (uint32_t)view->sliceCount);
    }
}

static void destroy(swGpu* gpu, void* state)
{
    swDestroyVariants(gpu, &((State*)state)->pipelines);
}

void swBindSliceWaves(const swGpuWorld* gpuWorld, int view, swBinding waves[SW_SLICE_WAVE_BINDINGS])
{
    const State* s = gpuWorld->passes[SW_PASS_SLICES].state;
    waves[0] = swBindUpload(&s->views[view].lists);
    waves[1] = swBindUpload(&s->views[view].tiles);
    waves[2] = swBindUpload(&s->views[view].waves);
}

const swPass swPass_slices = {
    .name = "slices",
    .stateSize = sizeof(State),
    .reads = SW_TEXELS_BIT | SW_OUTPUT_BIT(SW_PASS_FIELDS) | SW_OUTPUT_BIT(SW_PASS_SLICES_SHAPED),
    .writes = SW_LAYER_BIT(SW_LAYER_DISPLACEMENT) | SW_LAYER_BIT(SW_LAYER_DERIVATIVES),
    .upload = upload,
    .create = create,
    .record = record,
    .destroy = destroy,
};
