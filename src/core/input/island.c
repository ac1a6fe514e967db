// SPDX-License-Identifier: MIT
// An island out of noise. Around it lies a beach after Dean's law, depth = A distance^(2/3) [Dean 1991], out to the
// edge of a shelf; beyond, the floor falls to the depth around. Inland a mountain rises, cut by valleys: each octave of
// noise counts less where those before it are steep, so that ridges stay sharp and valleys smooth.
//
// Plain arithmetic and the core's own functions: the same bits on every machine.

#include "core/input/island.h"

#include <math.h>

#include "core/base/misuse.h"
#include "core/math/random.h"
#include "core/math/scalar.h"

#define BEACH 0.12       // Dean's A, m^(1/3): fine sand
#define SHORE_SLOPE 0.06 // of the dry beach
#define OCTAVES 9

enum
{
    COAST = 101,
    WARP_X,
    WARP_Z,
    MOUNTAIN,
    FLOOR
};

typedef struct Noise
{
    double value, alongX, alongZ; // value in [-1, 1]
} Noise;

static double pick(uint32_t seed, int kind, double x, double z)
{
    return 2.0 * swHashToUnit(swHashWave(seed, kind, (int)x, (int)z, 0)) - 1.0;
}

// Values at whole numbers, joined by 6 t^5 - 15 t^4 + 10 t^3.
static Noise findNoise(uint32_t seed, int kind, double x, double z)
{
    double cellX = floor(x), cellZ = floor(z);
    double u = x - cellX, v = z - cellZ;
    double su = u * u * u * (u * (u * 6.0 - 15.0) + 10.0), sv = v * v * v * (v * (v * 6.0 - 15.0) + 10.0);
    double du = 30.0 * u * u * (u * (u - 2.0) + 1.0), dv = 30.0 * v * v * (v * (v - 2.0) + 1.0);
    double a = pick(seed, kind, cellX, cellZ), b = pick(seed, kind, cellX + 1.0, cellZ);
    double c = pick(seed, kind, cellX, cellZ + 1.0), d = pick(seed, kind, cellX + 1.0, cellZ + 1.0);
    double across = a - b - c + d;
    return (Noise){a + (b - a) * su + (c - a) * sv + across * su * sv, du * (b - a + across * sv),
                   dv * (c - a + across * su)};
}

// Octaves, each turned against the one before so that no lattice shows.
static void turn(double* x, double* z)
{
    double oldX = *x;
    *x = 2.0 * (0.8 * oldX + 0.6 * *z);
    *z = 2.0 * (0.8 * *z - 0.6 * oldX);
}

static double sumNoise(uint32_t seed, int kind, double x, double z, int octaves)
{
    double sum = 0.0, weight = 0.5;
    for (int i = 0; i < octaves; ++i)
    {
        sum += weight * findNoise(seed + (uint32_t)i * 7919u, kind, x, z).value;
        weight *= 0.5;
        turn(&x, &z);
    }
    return sum;
}

// In [0, 1] about: ridges and valleys.
static double findMountain(uint32_t seed, double x, double z)
{
    double sum = 0.0, weight = 0.5, steepX = 0.0, steepZ = 0.0;
    for (int i = 0; i < OCTAVES; ++i)
    {
        Noise n = findNoise(seed + (uint32_t)i * 104729u, MOUNTAIN, x, z);
        steepX += n.alongX;
        steepZ += n.alongZ;
        sum += weight * n.value / (1.0 + 0.35 * (steepX * steepX + steepZ * steepZ));
        weight *= 0.5;
        turn(&x, &z);
    }
    return 0.5 + 0.9 * sum;
}

static double smooth(double t)
{
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    return t * t * (3.0 - 2.0 * t);
}

// Metres to the coast, above 0 at sea: of a circle that noise pushes in and out. Not exact, and smooth.
static double findDistance(const swIslandDef* def, double x, double z)
{
    double radius = (double)def->radius;
    double scaleX = x / radius, scaleZ = z / radius;
    double warpX = scaleX + 0.35 * sumNoise(def->seed, WARP_X, 1.7 * scaleX, 1.7 * scaleZ, 4);
    double warpZ = scaleZ + 0.35 * sumNoise(def->seed, WARP_Z, 1.7 * scaleX, 1.7 * scaleZ, 4);
    double r = sqrt(warpX * warpX + warpZ * warpZ);
    double coast = 1.0 + 0.5 * (double)def->ruggedness * sumNoise(def->seed, COAST, 1.3 * warpX, 1.3 * warpZ, OCTAVES);
    return radius * (r - coast);
}

// Under water, at a distance from the coast.
static double findSea(const swIslandDef* def, double x, double z, double distance)
{
    double shelf = (double)def->shelfWidth, most = (double)def->depth;
    double near = distance < shelf ? distance : shelf;
    double depth = BEACH * swPow(near + 1e-9, 2.0 / 3.0);
    depth = depth < most ? depth : most;
    if (distance > shelf)
    {
        double fall = (distance - shelf) / (double)def->radius;
        depth += (most - depth) * (1.0 - swExp(-fall * fall - 0.3 * fall));
    }
    // Rocks and sand: a part of the depth, so that nothing stands out of the water. What lies deep is covered with mud.
    double rough = sumNoise(def->seed, FLOOR, 9.0 * x / (double)def->radius, 9.0 * z / (double)def->radius, 6);
    double sediment = 1.0 - 0.8 * smooth((distance - shelf) / (double)def->radius);
    return -depth * (1.0 + 0.5 * (double)def->ruggedness * sediment * rough);
}

static double findLand(const swIslandDef* def, double x, double z, double inland)
{
    double radius = (double)def->radius;
    double beach = SHORE_SLOPE * (inland < 60.0 ? inland : 60.0);
    double rise = inland / (0.85 * radius);
    double dome = swPow((rise > 0.0 ? rise : 0.0) + 1e-9, 1.25);
    dome = dome < 1.0 ? dome : 1.0;
    double peaks = findMountain(def->seed, 3.1 * x / radius, 3.1 * z / radius);
    double shape = 0.35 + 0.9 * (double)def->ruggedness * (peaks - 0.5) + 0.65 * peaks;
    double hills = (double)def->height * dome * (shape > 0.05 ? shape : 0.05);
    return beach + hills * smooth(inland / 150.0);
}

float swFindIsland(const swIslandDef* def, double x, double z)
{
    double fromX = x - def->x, fromZ = z - def->z;
    double distance = findDistance(def, fromX, fromZ);
    return (float)(distance > 0.0 ? findSea(def, fromX, fromZ, distance) : findLand(def, fromX, fromZ, -distance));
}

swResult swCreateIsland(const swHost* host, const swIslandDef* def, swRaster** raster)
{
    SW_REQUIRE_PLACE(host, raster, "swCreateIsland()");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, host,
               "swCreateIsland() needs a def made by swDefaultIslandDef()");
    swResult result = swCheckDef(host, &swIslandFields, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    size_t side = (size_t)def->cells, size = side * side * sizeof(float);
    float* values = swAllocate(host, size);
    if (values == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for an island of %d x %d cells.", def->cells, def->cells);
    }
    double spacing = (double)def->extent / (def->cells - 1);
    double west = def->x - 0.5 * (double)def->extent, north = def->z - 0.5 * (double)def->extent;
    for (size_t i = 0; i < side * side; ++i)
    {
        values[i] = swFindIsland(def, west + spacing * (double)(i % side), north + spacing * (double)(i / side));
    }
    swRasterDef made = swDefaultRasterDef();
    made.name = "island";
    made.width = made.height = def->cells;
    made.x = west;
    made.z = north;
    made.spacingX = made.spacingZ = spacing;
    made.values = values;
    result = swCreateRaster(host, &made, raster);
    swFree(host, values, size);
    return result;
}
