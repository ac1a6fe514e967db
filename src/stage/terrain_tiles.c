// SPDX-License-Identifier: MIT
// A tree of squares over the plane, from tiles as wide as the land is seen down to the finest. A square is cut in four
// where the camera is nearer than so many of its sides; what is not cut is drawn as a grid of its own spacing. Each
// grid slides into the coarser one before its square meets one that is not cut [Strugar 2010]: a square's farthest
// point lies less than its nearest and its diagonal away, which is where sliding begins.

#include "stage/terrain_tiles.h"

#include <math.h>
#include <string.h>

#define SW_TERRAIN_CUT 2.5      // sides of a square: nearer than this it is cut
#define SW_TERRAIN_DIAGONAL 1.5 // sides: a little more than the root of 2
#define SW_TERRAIN_MARGIN 2     // samples beyond a tile's edge, for slopes
#define SW_TERRAIN_SAMPLES (SW_TERRAIN_SIDE + 2 * SW_TERRAIN_MARGIN)
#define SW_TERRAIN_KEPT 8 // frames before a slot may be used anew

typedef struct swTerrainChoice
{
    swTerrainTiles* tiles;
    swPos eye;
    double eyeHeight;
    double planes[4][3]; // the view's sides from the camera: inside is positive
    swTerrainTile* chosen;
    int count, capacity;
} swTerrainChoice;

void swForgetTerrain(swTerrainTiles* tiles)
{
    memset(tiles->hash, 0, sizeof(tiles->hash));
    memset(tiles->slots, 0, sizeof(tiles->slots));
}

static uint64_t hashKey(swTerrainKey key)
{
    uint64_t h = (uint64_t)key.x * 0x9e3779b97f4a7c15u ^ (uint64_t)key.z * 0xc2b2ae3d27d4eb4fu ^ (uint64_t)key.level;
    h ^= h >> 29;
    h *= 0xbf58476d1ce4e5b9u;
    return h ^ h >> 32;
}

static bool isSame(swTerrainKey a, swTerrainKey b)
{
    return a.x == b.x && a.z == b.z && a.level == b.level;
}

static int* findEntry(swTerrainTiles* tiles, swTerrainKey key)
{
    const uint64_t mask = 2 * SW_TERRAIN_SLOTS - 1;
    uint64_t at = hashKey(key) & mask;
    while (tiles->hash[at] != 0 && !isSame(tiles->slots[tiles->hash[at] - 1].key, key))
    {
        at = (at + 1) & mask;
    }
    return &tiles->hash[at];
}

// Entries of a slot that is used anew are dropped by entering all others again.
static void enterAll(swTerrainTiles* tiles)
{
    memset(tiles->hash, 0, sizeof(tiles->hash));
    for (int i = 0; i < SW_TERRAIN_SLOTS; ++i)
    {
        if (tiles->slots[i].isFilled)
        {
            *findEntry(tiles, tiles->slots[i].key) = i + 1;
        }
    }
}

// A free slot, or the one that has been out of use the longest; -1 if all are in use.
static int takeSlot(swTerrainTiles* tiles)
{
    int oldest = 0;
    for (int i = 0; i < SW_TERRAIN_SLOTS; ++i)
    {
        if (!tiles->slots[i].isFilled)
        {
            return i;
        }
        oldest = tiles->slots[i].lastUsed < tiles->slots[oldest].lastUsed ? i : oldest;
    }
    if (tiles->slots[oldest].lastUsed + SW_TERRAIN_KEPT > tiles->frame)
    {
        return -1;
    }
    tiles->slots[oldest].isFilled = false;
    enterAll(tiles);
    return oldest;
}

// IEEE half, rounded towards zero; slopes beyond 60000 are cut.
static uint32_t halfOf(float value)
{
    uint32_t bits;
    value = value > 60000.0f ? 60000.0f : (value < -60000.0f ? -60000.0f : value);
    memcpy(&bits, &value, sizeof(bits));
    uint32_t sign = bits >> 16 & 0x8000u;
    int exponent = (int)(bits >> 23 & 255u) - 112;
    return exponent <= 0 ? sign : sign | (uint32_t)exponent << 10 | (bits >> 13 & 0x3ffu);
}

static uint32_t packSlopes(float x, float z)
{
    return halfOf(x) | halfOf(z) << 16;
}

// Heights where none is known, from what is known beside them, so that triangles at the edge are not drawn out. What
// has nothing known beside it is not drawn at all.
static float heightNear(const float* heights, int column, int row)
{
    float sum = 0.0f, count = 0.0f;
    for (int z = row > 0 ? row - 1 : 0; z <= row + 1 && z < SW_TERRAIN_SAMPLES; ++z)
    {
        for (int x = column > 0 ? column - 1 : 0; x <= column + 1 && x < SW_TERRAIN_SAMPLES; ++x)
        {
            float height = heights[z * SW_TERRAIN_SAMPLES + x];
            sum += isfinite(height) ? height : 0.0f;
            count += isfinite(height) ? 1.0f : 0.0f;
        }
    }
    return count > 0.0f ? sum / count : 0.0f;
}

static float slopeOver(float low, float high, float middle, float distance)
{
    low = isfinite(low) ? low : middle;
    high = isfinite(high) ? high : middle;
    return (high - low) / distance;
}

static swTerrainVertex makeVertex(const float* heights, int column, int row, float spacing)
{
    const int line = SW_TERRAIN_SAMPLES;
    const float* at = heights + row * line + column;
    bool isKnown = isfinite(*at);
    float own = isKnown ? *at : heightNear(heights, column, row);
    return (swTerrainVertex){
        .height = own,
        .known = isKnown ? 1.0f : 0.0f,
        .slopes = packSlopes(slopeOver(at[-1], at[1], own, 2.0f * spacing),
                             slopeOver(at[-line], at[line], own, 2.0f * spacing)),
        .farSlopes = packSlopes(slopeOver(at[-2], at[2], own, 4.0f * spacing),
                                slopeOver(at[-2 * line], at[2 * line], own, 4.0f * spacing)),
    };
}

static void sampleSlot(swTerrainTiles* tiles, int slot)
{
    swPosXZ points[SW_TERRAIN_SAMPLES];
    float heights[SW_TERRAIN_SAMPLES * SW_TERRAIN_SAMPLES];
    swTerrainKey key = tiles->slots[slot].key;
    double spacing = ldexp(tiles->finestSide / SW_TERRAIN_QUADS, key.level);
    double firstX = ((double)key.x * SW_TERRAIN_QUADS - SW_TERRAIN_MARGIN) * spacing;
    double firstZ = ((double)key.z * SW_TERRAIN_QUADS - SW_TERRAIN_MARGIN) * spacing;
    for (int row = 0; row < SW_TERRAIN_SAMPLES; ++row)
    {
        for (int column = 0; column < SW_TERRAIN_SAMPLES; ++column)
        {
            points[column] = (swPosXZ){firstX + column * spacing, firstZ + row * spacing};
        }
        tiles->floor(tiles->context, SW_TERRAIN_SAMPLES, points, heights + row * SW_TERRAIN_SAMPLES);
    }
    bool isEmpty = true;
    for (int i = 0; i < SW_TERRAIN_SAMPLES * SW_TERRAIN_SAMPLES; ++i)
    {
        isEmpty = isEmpty && !isfinite(heights[i]);
    }
    tiles->slots[slot].isEmpty = isEmpty;
    swTerrainVertex* vertices = tiles->vertices + (size_t)slot * SW_TERRAIN_VERTICES;
    for (int i = 0; i < SW_TERRAIN_VERTICES && !isEmpty; ++i)
    {
        vertices[i] = makeVertex(heights, i % SW_TERRAIN_SIDE + SW_TERRAIN_MARGIN,
                                 i / SW_TERRAIN_SIDE + SW_TERRAIN_MARGIN, (float)spacing);
    }
}

static int findSlot(swTerrainTiles* tiles, swTerrainKey key)
{
    int* entry = findEntry(tiles, key);
    int slot = *entry - 1;
    if (slot < 0)
    {
        slot = takeSlot(tiles);
        if (slot < 0)
        {
            return -1;
        }
        tiles->slots[slot] = (swTerrainSlot){.key = key, .isFilled = true};
        *findEntry(tiles, key) = slot + 1;
        sampleSlot(tiles, slot);
    }
    tiles->slots[slot].lastUsed = tiles->frame;
    return slot;
}

// The view's sides through the camera, from its matrices: a point p is inside of a side where a p is positive.
static void setPlanes(swTerrainChoice* choice, const swCamera* camera)
{
    const float* view = camera->view.m;
    const float* projection = camera->projection.m;
    for (int i = 0; i < 4; ++i)
    {
        int axis = i / 2;
        double sign = i % 2 == 0 ? 1.0 : -1.0;
        for (int k = 0; k < 3; ++k)
        {
            // w + sign x or y of clip space: w is -z of the camera's axes.
            choice->planes[i][k] =
                -(double)view[4 * k + 2] + sign * (double)projection[5 * axis] * (double)view[4 * k + axis];
        }
    }
}

// Boxes from the deepest trench to the highest summit.
static bool isSeen(const swTerrainChoice* choice, double x, double z, double side)
{
    const double low[3] = {x, -12e3 - choice->eye.y, z};
    const double high[3] = {x + side, 9e3 - choice->eye.y, z + side};
    for (int i = 0; i < 4; ++i)
    {
        double most = 0.0;
        for (int k = 0; k < 3; ++k)
        {
            most += choice->planes[i][k] * (choice->planes[i][k] > 0.0 ? high[k] : low[k]);
        }
        if (most < 0.0)
        {
            return false;
        }
    }
    return true;
}

static double distanceTo(const swTerrainChoice* choice, double x, double z, double side)
{
    double dx = fmax(fmax(x, -(x + side)), 0.0);
    double dz = fmax(fmax(z, -(z + side)), 0.0);
    return sqrt(dx * dx + dz * dz + choice->eyeHeight * choice->eyeHeight);
}

static void chooseTile(swTerrainChoice* choice, swTerrainKey key, double x, double z, double side)
{
    int slot = choice->count < choice->capacity ? findSlot(choice->tiles, key) : -1;
    if (slot < 0 || choice->tiles->slots[slot].isEmpty)
    {
        return;
    }
    choice->chosen[choice->count++] = (swTerrainTile){
        .x = (float)x,
        .z = (float)z,
        .spacing = (float)(side / SW_TERRAIN_QUADS),
        .firstVertex = (uint32_t)slot * SW_TERRAIN_VERTICES,
        .slideFrom = (float)((SW_TERRAIN_CUT + SW_TERRAIN_DIAGONAL) * side),
        .slideEnd = (float)(0.999 * 2.0 * SW_TERRAIN_CUT * side),
    };
}

static void descend(swTerrainChoice* choice, swTerrainKey key)
{
    double side = ldexp(choice->tiles->finestSide, key.level);
    double x = (double)key.x * side - choice->eye.x;
    double z = (double)key.z * side - choice->eye.z;
    double distance = distanceTo(choice, x, z, side);
    if (!isSeen(choice, x, z, side) || distance > choice->tiles->reach)
    {
        return;
    }
    if (key.level == 0 || distance >= SW_TERRAIN_CUT * side)
    {
        chooseTile(choice, key, x, z, side);
        return;
    }
    for (int i = 0; i < 4; ++i)
    {
        descend(choice, (swTerrainKey){2 * key.x + i % 2, 2 * key.z + i / 2, key.level - 1});
    }
}

int swChooseTerrain(swTerrainTiles* tiles, const swCamera* camera, double eyeHeight, swTerrainTile* chosen,
                    int capacity)
{
    swTerrainChoice choice = {
        .tiles = tiles, .eye = camera->position, .eyeHeight = eyeHeight, .chosen = chosen, .capacity = capacity};
    setPlanes(&choice, camera);
    ++tiles->frame;
    int top = tiles->levelCount - 1;
    double side = ldexp(tiles->finestSide, top);
    int64_t x0 = (int64_t)floor((camera->position.x - tiles->reach) / side);
    int64_t x1 = (int64_t)floor((camera->position.x + tiles->reach) / side);
    int64_t z0 = (int64_t)floor((camera->position.z - tiles->reach) / side);
    int64_t z1 = (int64_t)floor((camera->position.z + tiles->reach) / side);
    for (int64_t z = z0; z <= z1; ++z)
    {
        for (int64_t x = x0; x <= x1; ++x)
        {
            descend(&choice, (swTerrainKey){x, z, top});
        }
    }
    return choice.count;
}
