// SPDX-License-Identifier: MIT
// The detail texture of foam: four patterns that repeat without a seam, written as numbers for a C array.
//
//   0  wide lace: walls between cells of several sizes, bent by noise
//   1  another, finer lace
//   2  bubbles
//   3  patches
//
// Each pattern's values are replaced by their rank, so that a share t of the texels lies below t and a threshold covers
// the area it says. Only integer hashes, square roots and plain arithmetic: the same bytes on every machine.

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define SIDE 256
#define CHANNELS 4
#define COUNT (SIDE * SIDE)

static uint32_t Hash(uint32_t x, uint32_t y, uint32_t seed)
{
    uint32_t h = x * 0x8da6b343u + y * 0xd8163841u + seed * 0xcb1ab31fu;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return h;
}

static double Uniform(uint32_t x, uint32_t y, uint32_t seed)
{
    return Hash(x, y, seed) / 4294967296.0;
}

static int Wrap(int i, int period)
{
    return ((i % period) + period) % period;
}

// Value noise with `cells` cells over the unit square, in [-1, 1].
static double Noise(double u, double v, int cells, uint32_t seed)
{
    double x = u * cells;
    double y = v * cells;
    int i = (int)floor(x);
    int j = (int)floor(y);
    double fx = x - i;
    double fy = y - j;
    fx = fx * fx * (3.0 - 2.0 * fx);
    fy = fy * fy * (3.0 - 2.0 * fy);
    uint32_t i0 = (uint32_t)Wrap(i, cells);
    uint32_t i1 = (uint32_t)Wrap(i + 1, cells);
    uint32_t j0 = (uint32_t)Wrap(j, cells);
    uint32_t j1 = (uint32_t)Wrap(j + 1, cells);
    double a = Uniform(i0, j0, seed) * (1.0 - fx) + Uniform(i1, j0, seed) * fx;
    double b = Uniform(i0, j1, seed) * (1.0 - fx) + Uniform(i1, j1, seed) * fx;
    return 2.0 * (a * (1.0 - fy) + b * fy) - 1.0;
}

static double Octaves(double u, double v, int cells, int octaves, uint32_t seed)
{
    double sum = 0.0;
    double amplitude = 0.5;
    for (int i = 0; i < octaves; ++i)
    {
        sum += amplitude * Noise(u, v, cells << i, seed + (uint32_t)i);
        amplitude *= 0.5;
    }
    return sum;
}

// Nearest and second nearest of random points, one a cell, in cell widths.
static void Nearest(double u, double v, int cells, uint32_t seed, double* first, double* second)
{
    double x = u * cells;
    double y = v * cells;
    int i = (int)floor(x);
    int j = (int)floor(y);
    double a = 1e9;
    double b = 1e9;
    for (int dj = -1; dj <= 1; ++dj)
    {
        for (int di = -1; di <= 1; ++di)
        {
            uint32_t ci = (uint32_t)Wrap(i + di, cells);
            uint32_t cj = (uint32_t)Wrap(j + dj, cells);
            double px = i + di + 0.1 + 0.8 * Uniform(ci, cj, seed) - x;
            double py = j + dj + 0.1 + 0.8 * Uniform(ci, cj, seed + 1u) - y;
            double d = px * px + py * py;
            if (d < a)
            {
                b = a;
                a = d;
            }
            else if (d < b)
            {
                b = d;
            }
        }
    }
    *first = sqrt(a);
    *second = sqrt(b);
}

// High along the walls between cells, low inside them.
static double Lace(double u, double v, int cells, uint32_t seed)
{
    double first, second;
    Nearest(u, v, cells, seed, &first, &second);
    double wall = second - first;
    return 1.0 / (1.0 + 6.0 * wall * wall + 2.0 * wall);
}

static double WideLace(double u, double v)
{
    double bendX = u + 0.045 * Octaves(u, v, 4, 4, 11u);
    double bendY = v + 0.045 * Octaves(u, v, 4, 4, 23u);
    double lace = Lace(bendX, bendY, 5, 3u) + 0.7 * Lace(bendX, bendY, 11, 5u) + 0.45 * Lace(bendX, bendY, 25, 7u);
    return lace + 0.9 * Octaves(u, v, 6, 5, 31u);
}

static double FineLace(double u, double v)
{
    double bendX = u + 0.03 * Octaves(u, v, 6, 4, 41u);
    double bendY = v + 0.03 * Octaves(u, v, 6, 4, 43u);
    double lace = Lace(bendX, bendY, 7, 47u) + 0.8 * Lace(bendX, bendY, 17, 53u) + 0.5 * Lace(bendX, bendY, 37, 59u);
    return lace + 0.6 * Octaves(u, v, 8, 5, 61u);
}

static double Bubbles(double u, double v)
{
    double sum = 0.0;
    static const int cells[] = {24, 40, 64};
    for (int i = 0; i < 3; ++i)
    {
        double first, second;
        Nearest(u, v, cells[i], 71u + 2u * (uint32_t)i, &first, &second);
        sum += fmax(0.0, 0.6 - first) + 0.3 / (1.0 + 20.0 * (second - first));
    }
    return sum + 0.2 * Octaves(u, v, 16, 4, 83u);
}

static double Patches(double u, double v)
{
    return Octaves(u, v, 3, 6, 97u);
}

typedef struct Texel
{
    double value;
    int index;
} Texel;

static int CompareTexels(const void* a, const void* b)
{
    const Texel* left = a;
    const Texel* right = b;
    if (left->value != right->value)
    {
        return left->value < right->value ? -1 : 1;
    }
    return left->index - right->index;
}

static void FillChannel(int channel, double (*pattern)(double, double), Texel* texels, uint8_t* pixels)
{
    for (int i = 0; i < COUNT; ++i)
    {
        double u = (i % SIDE + 0.5) / SIDE;
        double v = (i / SIDE + 0.5) / SIDE;
        texels[i] = (Texel){pattern(u, v), i};
    }
    qsort(texels, COUNT, sizeof(*texels), CompareTexels);
    for (int rank = 0; rank < COUNT; ++rank)
    {
        pixels[texels[rank].index * CHANNELS + channel] = (uint8_t)(rank * 256 / COUNT);
    }
}

int main(int argc, char** argv)
{
    static double (*const patterns[CHANNELS])(double, double) = {WideLace, FineLace, Bubbles, Patches};
    static Texel texels[COUNT];
    static uint8_t pixels[COUNT * CHANNELS];
    FILE* file = argc == 2 ? fopen(argv[1], "w") : NULL;
    if (!file)
    {
        fprintf(stderr, "usage: foam_texture FILE\n");
        return 2;
    }
    for (int channel = 0; channel < CHANNELS; ++channel)
    {
        FillChannel(channel, patterns[channel], texels, pixels);
    }
    for (int i = 0; i < COUNT * CHANNELS; ++i)
    {
        fprintf(file, "%d,%s", pixels[i], i % 32 == 31 ? "\n" : "");
    }
    return fclose(file) == 0 ? 0 : 1;
}
