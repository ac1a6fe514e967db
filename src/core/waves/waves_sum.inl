// SPDX-License-Identifier: MIT

// Direct sums of waves at points, see waves_sum.h. Written on the wide float and compiled per instruction set; included
// after core/math/wide.h.
//
// Waves come in chunks. A chunk holds, for one time, each wave's complex height 2 H and its rate; at a point with phase
// theta = k x the wave is
//   C = re cos theta - im sin theta,  S = re sin theta + im cos theta,
// height C, displacement -d S along k, and so on by derivatives. Lanes are waves: eight sums for each output, whatever
// the width, which are added in a fixed order at the end, so that every instruction set gives the same bits.
//
// Phases are turns in 32-bit integers. On a lattice they are bins times the place within the tile, exact; a free wave's
// are worked out in double and reduced.

#include "core/waves/waves_sum.h"

#define SUM_LANES 8
#define SUM_CHUNK 32

// Points that share a chunk: at most so many, and as many as their sums have room for. It bounds the stack of a query.
#define SUM_POINTS 64
#define SUM_FLOATS 2048

// Waves that their places shape come for few points, with more on the stack above them.
#define FEW_POINTS 8
#define FEW_FLOATS 240

// Outputs that a point of the surface collects, in order; how many depends on the kind.
enum
{
    SUM_DISPLACEMENT,      // 3
    SUM_GRADIENTS = 3,     // 6
    SUM_VELOCITY = 9,      // 3
    SUM_ACCELERATION = 12, // 3
    SUM_COUNT = 15
};

// The same of the water below.
enum
{
    SUM_HEAD,
    SUM_BELOW_VELOCITY,         // 3
    SUM_BELOW_ACCELERATION = 4, // 3
    SUM_BELOW_COUNT = 7
};

typedef enum SumKind
{
    SUM_SURFACE,
    SUM_SURFACE_GRADIENTS,
    SUM_SURFACE_ALL,
    SUM_BELOW,
    SUM_BELOW_FINITE
} SumKind;

typedef struct WaveChunk
{
    int count; // rounded up to SUM_LANES with waves of no height
    float re[SUM_CHUNK], im[SUM_CHUNK];
    float rateRe[SUM_CHUNK], rateIm[SUM_CHUNK];
    float kx[SUM_CHUNK], kz[SUM_CHUNK];             // rad/m
    float dx[SUM_CHUNK], dz[SUM_CHUNK];             // chop
    float square[SUM_CHUNK];                        // omega^2
    float overSinh[SUM_CHUNK], overCosh[SUM_CHUNK]; // 1 / (1 -+ exp(-2 k depth))
    float k[SUM_CHUNK];
    float unitX[SUM_CHUNK], unitZ[SUM_CHUNK];    // of k
    uint32_t binX[SUM_CHUNK], binZ[SUM_CHUNK];   // of a lattice
    double turnsX[SUM_CHUNK], turnsZ[SUM_CHUNK]; // of free waves, turns per metre
} WaveChunk;

static inline int countOutputs(SumKind kind)
{
    switch (kind)
    {
    case SUM_SURFACE:
        return SUM_GRADIENTS;
    case SUM_SURFACE_GRADIENTS:
        return SUM_VELOCITY;
    case SUM_SURFACE_ALL:
        return SUM_COUNT;
    default:
        return SUM_BELOW_COUNT;
    }
}

// Sums of a block of points: [point][output][SUM_LANES].
typedef struct BlockSums
{
    SumKind kind;
    int room; // floats
    float* lanes;
} BlockSums;

static inline float* getLanes(BlockSums* sums, int point)
{
    return sums->lanes + point * countOutputs(sums->kind) * SUM_LANES;
}

static void clearTail(WaveChunk* chunk, int count)
{
    chunk->count = (count + SUM_LANES - 1) / SUM_LANES * SUM_LANES;
    for (int i = count; i < chunk->count; ++i)
    {
        chunk->re[i] = chunk->im[i] = chunk->rateRe[i] = chunk->rateIm[i] = 0.0f;
        chunk->kx[i] = chunk->kz[i] = chunk->dx[i] = chunk->dz[i] = chunk->square[i] = chunk->k[i] = 0.0f;
        chunk->unitX[i] = chunk->unitZ[i] = 0.0f;
        chunk->binX[i] = chunk->binZ[i] = 0;
        chunk->turnsX[i] = chunk->turnsZ[i] = 0.0;
    }
}

// How a wave of k fades with depth.
static void fillDepth(WaveChunk* chunk, float depth)
{
    for (int i = 0; i < chunk->count; i += SW_WIDTH)
    {
        swWide one = swSplatW(1.0f);
        swWide fade = swSplatW(0.0f);
        if (depth < 1e9f)
        {
            fade = swExpW(swMulW(swLoadW(chunk->k + i), swSplatW(-2.0f * depth)));
        }
        float down[SW_WIDTH];
        swStoreW(down, swSubW(one, fade));
        float up[SW_WIDTH];
        swStoreW(up, swAddW(one, fade));
        for (int lane = 0; lane < SW_WIDTH; ++lane)
        {
            chunk->overSinh[i + lane] = down[lane] > 0.0f ? 1.0f / down[lane] : 0.0f;
            chunk->overCosh[i + lane] = 1.0f / up[lane];
        }
    }
}

static void fillTileChunk(const swTile* tile, const swMode* modes, int count, int64_t ticks, WaveChunk* chunk)
{
    float dk = (float)(6.283185307179586 / tile->side);
    for (int i = 0; i < count; ++i)
    {
        const swMode* m = modes + i;
        uint64_t frequency = ((uint64_t)m->frequencyHigh << 32) | m->frequencyLow;
        float s, c;
        swSinCosTurns((uint32_t)((frequency * (uint64_t)ticks) >> 32), &s, &c);
        int qx = m->qx < 0 ? -m->qx : m->qx;
        float scale = 2.0f * tile->weight * (tile->response[qx] * tile->response[m->qz]);
        float omega = getModeOmega(frequency);
        chunk->re[i] = scale * (m->pr * c + m->qi * s);
        chunk->im[i] = scale * (m->pi * c - m->qr * s);
        chunk->rateRe[i] = scale * omega * (m->qi * c - m->pr * s);
        chunk->rateIm[i] = -scale * omega * (m->pi * s + m->qr * c);
        chunk->square[i] = omega * omega;
        chunk->kx[i] = dk * (float)m->qx;
        chunk->kz[i] = dk * (float)m->qz;
        chunk->k[i] = dk * sqrtf((float)(m->qx * m->qx + m->qz * m->qz));
        chunk->unitX[i] = chunk->kx[i] / chunk->k[i];
        chunk->unitZ[i] = chunk->kz[i] / chunk->k[i];
        chunk->dx[i] = m->dx;
        chunk->dz[i] = m->dz;
        chunk->binX[i] = (uint32_t)(int32_t)m->qx;
        chunk->binZ[i] = (uint32_t)(int32_t)m->qz;
    }
    clearTail(chunk, count);
    fillDepth(chunk, tile->depth);
}

static void fillFreeChunk(const swFreeWave* waves, int count, int64_t ticks, WaveChunk* chunk)
{
    for (int i = 0; i < count; ++i)
    {
        const swFreeWave* w = waves + i;
        float s, c;
        swSinCosTurns(w->phase - swGetPassedTurns(w, ticks), &s, &c);
        float omega = getModeOmega(w->frequency);
        chunk->re[i] = w->amplitude * c;
        chunk->im[i] = w->amplitude * s;
        chunk->rateRe[i] = omega * chunk->im[i];
        chunk->rateIm[i] = -omega * chunk->re[i];
        chunk->square[i] = omega * omega;
        chunk->kx[i] = (float)(6.283185307179586 * w->turnsX);
        chunk->kz[i] = (float)(6.283185307179586 * w->turnsZ);
        chunk->k[i] = sqrtf(chunk->kx[i] * chunk->kx[i] + chunk->kz[i] * chunk->kz[i]);
        chunk->unitX[i] = chunk->kx[i] / chunk->k[i];
        chunk->unitZ[i] = chunk->kz[i] / chunk->k[i];
        chunk->dx[i] = w->dx;
        chunk->dz[i] = w->dz;
        chunk->turnsX[i] = w->turnsX;
        chunk->turnsZ[i] = w->turnsZ;
    }
    clearTail(chunk, count);
    fillDepth(chunk, waves->depth);
}

// Turns of theta at a place within a tile, given as fractions of its side.
static inline void fillLatticePhases(const WaveChunk* chunk, uint32_t placeX, uint32_t placeZ, uint32_t* phases)
{
    swWideI x = swSplatI(placeX);
    swWideI z = swSplatI(placeZ);
    for (int i = 0; i < chunk->count; i += SW_WIDTH)
    {
        swWideI turns = swAddI(swMulI(swLoadI(chunk->binX + i), x), swMulI(swLoadI(chunk->binZ + i), z));
        swStoreI(phases + i, turns);
    }
}

// The fraction of t in turns as 32 bits. Adding 3 * 2^51 leaves the nearest integer, adding 3 * 2^19 moves 2^-32 to the
// last bit.
static inline uint32_t fractionOf(double t)
{
    const double whole = 6755399441055744.0;
    double fraction = t - ((t + whole) - whole);
    double shifted = fraction + 1572864.0;
    uint64_t bits;
    memcpy(&bits, &shifted, sizeof bits);
    return (uint32_t)bits;
}

static inline void fillFreePhases(const WaveChunk* chunk, double x, double z, uint32_t* phases)
{
    for (int i = 0; i < chunk->count; ++i)
    {
        phases[i] = fractionOf(chunk->turnsX[i] * x + chunk->turnsZ[i] * z);
    }
}

// One point's sums in lanes [lane, lane + SW_WIDTH) over the chunk. `kind` is a constant where this is inlined.
static inline void addLanes(const WaveChunk* w, SumKind kind, const uint32_t* phases, float height, float twiceDepth,
                            int lane, float* lanes)
{
    const int outputs = countOutputs(kind);
    const int motion = kind >= SUM_BELOW ? SUM_BELOW_VELOCITY : SUM_VELOCITY;
    swWide acc[SUM_COUNT];
    for (int o = 0; o < outputs; ++o)
    {
        acc[o] = swLoadW(lanes + o * SUM_LANES + lane);
    }
    for (int i = lane; i < w->count; i += SUM_LANES)
    {
        swWide sine, cosine;
        swSinCosTurnsW(swLoadI(phases + i), &sine, &cosine);
        swWide re = swLoadW(w->re + i), im = swLoadW(w->im + i);
        swWide c = swSubW(swMulW(re, cosine), swMulW(im, sine));
        swWide s = swAddW(swMulW(re, sine), swMulW(im, cosine));
        swWide dx = swLoadW(w->dx + i), dz = swLoadW(w->dz + i);
        if (kind <= SUM_SURFACE_ALL)
        {
            acc[0] = swSubW(acc[0], swMulW(dx, s));
            acc[1] = swAddW(acc[1], c);
            acc[2] = swSubW(acc[2], swMulW(dz, s));
        }
        if (kind == SUM_SURFACE_GRADIENTS || kind == SUM_SURFACE_ALL)
        {
            swWide kx = swLoadW(w->kx + i), kz = swLoadW(w->kz + i);
            swWide alongX = swMulW(kx, c), alongZ = swMulW(kz, c);
            acc[3] = swSubW(acc[3], swMulW(dx, alongX));
            acc[4] = swSubW(acc[4], swMulW(dx, alongZ));
            acc[5] = swSubW(acc[5], swMulW(dz, alongX));
            acc[6] = swSubW(acc[6], swMulW(dz, alongZ));
            acc[7] = swSubW(acc[7], swMulW(kx, s));
            acc[8] = swSubW(acc[8], swMulW(kz, s));
        }
        if (kind >= SUM_SURFACE_ALL)
        {
            swWide rateRe = swLoadW(w->rateRe + i), rateIm = swLoadW(w->rateIm + i);
            swWide square = swLoadW(w->square + i);
            swWide rateC = swSubW(swMulW(rateRe, cosine), swMulW(rateIm, sine));
            swWide rateS = swAddW(swMulW(rateRe, sine), swMulW(rateIm, cosine));
            swWide vertical = swSplatW(1.0f);
            if (kind >= SUM_BELOW)
            {
                swWide k = swLoadW(w->k + i);
                swWide down = swExpW(swMulW(k, swSplatW(height)));
                swWide up = swSplatW(0.0f);
                swWide horizontal = down;
                vertical = down;
                if (kind == SUM_BELOW_FINITE)
                {
                    up = swExpW(swMulW(k, swSplatW(-height - twiceDepth)));
                    swWide overSinh = swLoadW(w->overSinh + i);
                    horizontal = swMulW(swAddW(down, up), overSinh);
                    vertical = swMulW(swSubW(down, up), overSinh);
                }
                swWide pressure = swMulW(swAddW(down, up), swLoadW(w->overCosh + i));
                acc[SUM_HEAD] = swAddW(acc[SUM_HEAD], swMulW(pressure, c));
                dx = swMulW(swLoadW(w->unitX + i), horizontal); // linear theory knows no chop
                dz = swMulW(swLoadW(w->unitZ + i), horizontal);
            }
            swWide squareS = swMulW(square, s), squareC = swMulW(square, c);
            acc[motion] = swSubW(acc[motion], swMulW(dx, rateS));
            acc[motion + 1] = swAddW(acc[motion + 1], swMulW(vertical, rateC));
            acc[motion + 2] = swSubW(acc[motion + 2], swMulW(dz, rateS));
            acc[motion + 3] = swAddW(acc[motion + 3], swMulW(dx, squareS));
            acc[motion + 4] = swSubW(acc[motion + 4], swMulW(vertical, squareC));
            acc[motion + 5] = swAddW(acc[motion + 5], swMulW(dz, squareS));
        }
    }
    for (int o = 0; o < outputs; ++o)
    {
        swStoreW(lanes + o * SUM_LANES + lane, acc[o]);
    }
}

static void addChunk(const WaveChunk* chunk, SumKind kind, const uint32_t* phases, float height, float depth,
                     float* lanes)
{
    for (int lane = 0; lane < SUM_LANES; lane += SW_WIDTH)
    {
        switch (kind)
        {
        case SUM_SURFACE:
            addLanes(chunk, SUM_SURFACE, phases, 0.0f, 0.0f, lane, lanes);
            break;
        case SUM_SURFACE_GRADIENTS:
            addLanes(chunk, SUM_SURFACE_GRADIENTS, phases, 0.0f, 0.0f, lane, lanes);
            break;
        case SUM_SURFACE_ALL:
            addLanes(chunk, SUM_SURFACE_ALL, phases, 0.0f, 0.0f, lane, lanes);
            break;
        case SUM_BELOW:
            addLanes(chunk, SUM_BELOW, phases, height, 0.0f, lane, lanes);
            break;
        case SUM_BELOW_FINITE:
            addLanes(chunk, SUM_BELOW_FINITE, phases, height, 2.0f * depth, lane, lanes);
            break;
        }
    }
}

static float addUpLanes(const float* lanes)
{
    return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) + ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

static void addVector(const float* lanes, int first, float* to)
{
    for (int c = 0; c < 3; ++c)
    {
        to[c] += addUpLanes(lanes + (first + c) * SUM_LANES);
    }
}

static void addSurface(const float* lanes, const swSurfaceSums* to, int point)
{
    if (to->displacement != NULL)
    {
        addVector(lanes, SUM_DISPLACEMENT, to->displacement[point]);
    }
    if (to->gradients != NULL)
    {
        addVector(lanes, SUM_GRADIENTS, to->gradients[point]);
        addVector(lanes, SUM_GRADIENTS + 3, to->gradients[point] + 3);
    }
    if (to->velocity != NULL)
    {
        addVector(lanes, SUM_VELOCITY, to->velocity[point]);
    }
    if (to->acceleration != NULL)
    {
        addVector(lanes, SUM_ACCELERATION, to->acceleration[point]);
    }
}

static void addBelow(const float* lanes, const swDepthSums* to, int point)
{
    to->head[point] += addUpLanes(lanes + SUM_HEAD * SUM_LANES);
    addVector(lanes, SUM_BELOW_VELOCITY, to->velocity[point]);
    addVector(lanes, SUM_BELOW_ACCELERATION, to->acceleration[point]);
}

static SumKind chooseSurface(const swSurfaceSums* sums)
{
    if (sums->velocity != NULL || sums->acceleration != NULL)
    {
        return SUM_SURFACE_ALL;
    }
    return sums->gradients != NULL ? SUM_SURFACE_GRADIENTS : SUM_SURFACE;
}

// What a block of points needs of one tile.
typedef struct BlockPlaces
{
    uint32_t x[SUM_POINTS], z[SUM_POINTS];
} BlockPlaces;

// Whether waves of a length reach the height of a point.
static inline bool reachesPoint(float wavelength, const float* heights, int point)
{
    return heights == NULL || wavelength > swGetFadedWavelength(heights[point]);
}

// The points of a block that waves of a length reach.
static int listReached(float wavelength, int count, const float* heights, int reached[SUM_POINTS])
{
    int reachedCount = 0;
    for (int i = 0; i < count; ++i)
    {
        reached[reachedCount] = i;
        reachedCount += reachesPoint(wavelength, heights, i) ? 1 : 0;
    }
    return reachedCount;
}

// Not inlined, and so the next one: their chunks shall not both be on the stack.
__attribute__((noinline)) static void addTileToBlock(const swTile* tile, int64_t ticks, int count,
                                                     const swPosXZ* points, const float* heights, BlockSums* sums)
{
    int reached[SUM_POINTS];
    int reachedCount = listReached(tile->maxWavelength, count, heights, reached);
    if (reachedCount == 0)
    {
        return;
    }
    BlockPlaces places;
    double perMetre = 1.0 / tile->side;
    swPosXZ shift = swGetTileShift(tile, ticks);
    for (int i = 0; i < count; ++i)
    {
        places.x[i] = fractionOf((points[i].x - shift.x) * perMetre);
        places.z[i] = fractionOf((points[i].z - shift.z) * perMetre);
    }
    int64_t tileTicks = swGetTileTicks(tile, ticks);
    bool isFinite = tile->depth < 1e9f;
    SumKind kind = sums->kind == SUM_BELOW && isFinite ? SUM_BELOW_FINITE : sums->kind;
    for (int first = 0; first < tile->modeCount; first += SUM_CHUNK)
    {
        int left = tile->modeCount - first;
        WaveChunk chunk;
        fillTileChunk(tile, tile->modes + first, left < SUM_CHUNK ? left : SUM_CHUNK, tileTicks, &chunk);
        for (int r = 0; r < reachedCount; ++r)
        {
            int i = reached[r];
            uint32_t phases[SUM_CHUNK];
            fillLatticePhases(&chunk, places.x[i], places.z[i], phases);
            float height = heights != NULL ? swClampHeight(heights[i], tile->depth) : 0.0f;
            addChunk(&chunk, kind, phases, height, tile->depth, getLanes(sums, i));
        }
    }
}

__attribute__((noinline)) static void addFreeToBlock(int waveCount, const swFreeWave* waves, int64_t ticks, int count,
                                                     const swPosXZ* points, const float* heights, BlockSums* sums)
{
    for (int first = 0; first < waveCount;)
    {
        // A chunk has one depth.
        int end = first + 1;
        while (end < waveCount && end - first < SUM_CHUNK && waves[end].depth == waves[first].depth)
        {
            end += 1;
        }
        float depth = waves[first].depth;
        int reached[SUM_POINTS];
        int reachedCount = listReached(waves[first].wavelength, count, heights, reached); // the chunk's longest
        WaveChunk chunk;
        if (reachedCount > 0)
        {
            fillFreeChunk(waves + first, end - first, ticks, &chunk);
        }
        SumKind kind = sums->kind == SUM_BELOW && depth < 1e9f ? SUM_BELOW_FINITE : sums->kind;
        for (int r = 0; r < reachedCount; ++r)
        {
            int i = reached[r];
            uint32_t phases[SUM_CHUNK];
            fillFreePhases(&chunk, points[i].x, points[i].z, phases);
            float height = heights != NULL ? swClampHeight(heights[i], depth) : 0.0f;
            addChunk(&chunk, kind, phases, height, depth, getLanes(sums, i));
        }
        first = end;
    }
}

static void writeBlock(BlockSums* sums, const swWaveSumJob* job, int first, int count)
{
    for (int i = 0; i < count; ++i)
    {
        if (job->surface != NULL)
        {
            addSurface(getLanes(sums, i), job->surface, first + i);
        }
        else
        {
            addBelow(getLanes(sums, i), job->below, first + i);
        }
    }
}

// Tiles, or free waves where there are none; the surface, or the water below.
static inline void sumBlocks(const swWaveSumJob* job, int room, float* lanes)
{
    BlockSums sums = {
        .kind = job->surface != NULL ? chooseSurface(job->surface) : SUM_BELOW, .room = room, .lanes = lanes};
    int pointFloats = countOutputs(sums.kind) * SUM_LANES;
    int most = sums.room / pointFloats < SUM_POINTS ? sums.room / pointFloats : SUM_POINTS;
    for (int first = 0; first < job->count; first += most)
    {
        int count = job->count - first < most ? job->count - first : most;
        const swPosXZ* points = job->points + first;
        const float* heights = job->heights != NULL ? job->heights + first : NULL;
        memset(sums.lanes, 0, (size_t)(count * pointFloats) * sizeof(float));
        for (int tile = 0; tile < job->tileCount; ++tile)
        {
            if (swIsTileChosen(&job->tiles[tile], job->shortest, job->longest))
            {
                addTileToBlock(job->tiles + tile, job->ticks, count, points, heights, &sums);
            }
        }
        addFreeToBlock(job->waveCount, job->waves, job->ticks, count, points, heights, &sums);
        writeBlock(&sums, job, first, count);
    }
}

__attribute__((noinline)) static void sumFew(const swWaveSumJob* job)
{
    float lanes[FEW_FLOATS];
    sumBlocks(job, FEW_FLOATS, lanes);
}

__attribute__((noinline)) static void sumMany(const swWaveSumJob* job)
{
    float lanes[SUM_FLOATS];
    sumBlocks(job, SUM_FLOATS, lanes);
}

static void sumWaves(const swWaveSumJob* job)
{
    if (job->count <= FEW_POINTS)
    {
        sumFew(job);
        return;
    }
    sumMany(job);
}
