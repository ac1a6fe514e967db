// SPDX-License-Identifier: MIT
// A cell takes a triangle if their bounds meet and no edge of the triangle has the cell on its outer side. Cells are
// taken a little larger than they are, so that a place whose cell is rounded finds its triangle all the same.

#include "core/input/mesh_grid.h"

#include <math.h>
#include <string.h>

#define SLACK 1e-3 // of a cell's side

typedef struct Triangle
{
    double x[3], z[3];
    bool counts; // it has an area from above, and a part below the greatest height
} Triangle;

static Triangle getTriangle(const swVec3* vertices, const uint32_t* corners, float highest)
{
    Triangle t = {.counts = false};
    float least = vertices[corners[0]].y;
    for (int i = 0; i < 3; ++i)
    {
        swVec3 v = vertices[corners[i]];
        t.x[i] = (double)v.x;
        t.z[i] = (double)v.z;
        least = v.y < least ? v.y : least;
    }
    // As the shader has it, in floats.
    swVec3 a = vertices[corners[0]], b = vertices[corners[1]], c = vertices[corners[2]];
    float bx = b.x - a.x, bz = b.z - a.z, cx = c.x - a.x, cz = c.z - a.z;
    float area = bx * cz - bz * cx;
    float longest = fmaxf(bx * bx + bz * bz, cx * cx + cz * cz);
    t.counts = fabsf(area) > 1e-7f * longest && least <= highest;
    return t;
}

// Cells from first to last along an axis.
static void findSpan(double low, double high, double corner, double side, int count, int* first, int* last)
{
    double from = floor((low - corner) / side - SLACK), to = floor((high - corner) / side + SLACK);
    *first = from < 0.0 ? 0 : from > count - 1 ? count - 1 : (int)from;
    *last = to < 0.0 ? 0 : to > count - 1 ? count - 1 : (int)to;
}

static double least(const double v[3])
{
    return fmin(v[0], fmin(v[1], v[2]));
}

static double most(const double v[3])
{
    return fmax(v[0], fmax(v[1], v[2]));
}

// Whether an edge has all of a cell on the side where the third corner is not.
static bool isBesideEdge(const Triangle* t, int edge, double x, double z, double half)
{
    int from = edge, to = (edge + 1) % 3, other = (edge + 2) % 3;
    double dx = t->x[to] - t->x[from], dz = t->z[to] - t->z[from];
    double inside = dx * (t->z[other] - t->z[from]) - dz * (t->x[other] - t->x[from]);
    double at = dx * (z - t->z[from]) - dz * (x - t->x[from]);
    double reach = half * (fabs(dx) + fabs(dz));
    return inside > 0.0 ? at + reach < 0.0 : at - reach > 0.0;
}

static bool isOverCell(const Triangle* t, const swMeshGrid* grid, int column, int row)
{
    double x = grid->x + grid->side * (column + 0.5), z = grid->z + grid->side * (row + 0.5);
    double half = grid->side * (0.5 + SLACK);
    return !isBesideEdge(t, 0, x, z, half) && !isBesideEdge(t, 1, x, z, half) && !isBesideEdge(t, 2, x, z, half);
}

// Counts the cells of each triangle in `counts`, or, where there are entries, writes its number to where `counts` says
// and moves that on. Stops beyond the most entries.
static size_t visit(const swVec3* vertices, const uint32_t* indices, int triangleCount, float highest,
                    const swMeshGrid* grid, float* counts, float* entries)
{
    size_t total = 0;
    for (int i = 0; i < triangleCount && total <= SW_MAX_MESH_ENTRIES; ++i)
    {
        Triangle t = getTriangle(vertices, indices + 3 * (size_t)i, highest);
        int left = 0, right = -1, top = 0, bottom = -1;
        if (t.counts)
        {
            findSpan(least(t.x), most(t.x), grid->x, grid->side, grid->countX, &left, &right);
            findSpan(least(t.z), most(t.z), grid->z, grid->side, grid->countZ, &top, &bottom);
        }
        for (int row = top; row <= bottom; ++row)
        {
            for (int column = left; column <= right; ++column)
            {
                if (!isOverCell(&t, grid, column, row))
                {
                    continue;
                }
                size_t cell = (size_t)row * (size_t)grid->countX + (size_t)column;
                if (entries != NULL)
                {
                    entries[(size_t)counts[cell]] = (float)i;
                }
                if (counts != NULL)
                {
                    counts[cell] += 1.0f;
                }
                total += 1;
            }
        }
    }
    return total;
}

bool swPlanMeshGrid(const swVec3* vertices, const uint32_t* indices, int triangleCount, float highest, swVec3 low,
                    swVec3 high, swMeshGrid* grid)
{
    double width = (double)high.x - (double)low.x, height = (double)high.z - (double)low.z;
    double longest = fmax(fmax(width, height), 1e-3);
    double area = fmax(width, longest * 1e-3) * fmax(height, longest * 1e-3);
    for (double cells = triangleCount;; cells *= 0.25)
    {
        cells = fmax(cells, 1.0);
        // A rim of a tenth of a cell, so that the bounds lie inside.
        grid->side = fmax(sqrt(area / cells), longest / 2048.0);
        grid->side = (double)(float)grid->side;
        grid->x = (double)(float)((double)low.x - 0.1 * grid->side);
        grid->z = (double)(float)((double)low.z - 0.1 * grid->side);
        grid->countX = (int)floor(((double)high.x - grid->x) / grid->side + 0.1) + 1;
        grid->countZ = (int)floor(((double)high.z - grid->z) / grid->side + 0.1) + 1;
        grid->entryCount = visit(vertices, indices, triangleCount, highest, grid, NULL, NULL);
        if (grid->entryCount <= SW_MAX_MESH_ENTRIES || cells <= 1.0)
        {
            return grid->entryCount <= SW_MAX_MESH_ENTRIES;
        }
    }
}

void swFillMeshGrid(const swVec3* vertices, const uint32_t* indices, int triangleCount, float highest,
                    const swMeshGrid* grid, float* starts, float* entries)
{
    size_t cells = (size_t)grid->countX * (size_t)grid->countZ;
    memset(starts, 0, (cells + 1) * sizeof(float));
    visit(vertices, indices, triangleCount, highest, grid, starts + 1, NULL); // counts, one cell on
    for (size_t i = 1; i <= cells; ++i)
    {
        starts[i] += starts[i - 1];
    }
    visit(vertices, indices, triangleCount, highest, grid, starts, entries); // leaves in each cell its end
    memmove(starts + 1, starts, cells * sizeof(float));
    starts[0] = 0.0f;
}
