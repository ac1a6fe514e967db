// SPDX-License-Identifier: MIT
// A table has equally spaced directions. Files have them in any order, from any first angle, at times with both 0 and
// 360 degrees, now and then unequally spaced or over a sector only.
//
// Equal spacing, within what rounding in print does to it, is kept: columns are only put in order. Otherwise the file
// means the function g that runs linearly between its directions, and a table on a fine grid theta_j with step h gets
//   t_j = (1 / h) integral of g(theta) hat_j(theta),  hat_j = max(0, 1 - |theta - theta_j| / h).
// Hats add up to one, so the sum of t_j h is the integral of g: no energy is lost. The first moment keeps its direction
// within h^3 and loses h^2 / 6 of its length, 5e-5 at one degree. Both g and the hats are linear between the union of
// their nodes, where Simpson's rule is exact.

#include "core/records/direction_grid.h"

#include <math.h>
#include <stdlib.h>

#include "seaway/math.h"

#define TURN (2.0 * SW_PI)

// Closer angles are the same: a thousandth of a degree.
#define SAME_ANGLE (TURN / 360000.0)

// How far printed directions may be from equal spacing, in steps: radians with three digits are 0.3 degrees off at
// most.
#define REGULAR_TOLERANCE 0.06

// A gap that is so much wider than the next one is the outside of a sector.
#define SECTOR_RATIO 2.5

static int compareNodes(const void* a, const void* b)
{
    const swDirectionNode* first = a;
    const swDirectionNode* second = b;
    if (first->angle != second->angle)
    {
        return first->angle < second->angle ? -1 : 1;
    }
    return (first->column > second->column) - (first->column < second->column);
}

static void sortNodes(const double* angles, int count, swDirectionGrid* grid)
{
    grid->columnCount = count;
    for (int i = 0; i < count; ++i)
    {
        double turns = angles[i] / TURN;
        double angle = TURN * (turns - floor(turns));
        angle = angle > TURN - SAME_ANGLE ? 0.0 : angle;
        grid->nodes[i] = (swDirectionNode){angle, i, 1};
    }
    qsort(grid->nodes, (size_t)count, sizeof(swDirectionNode), compareNodes);
}

// Marks runs of the same angle by their first node; counts them.
static void findRuns(swDirectionGrid* grid)
{
    int first = 0;
    grid->nodeCount = grid->columnCount > 0 ? 1 : 0;
    for (int i = 1; i < grid->columnCount; ++i)
    {
        if (grid->nodes[i].angle - grid->nodes[first].angle < SAME_ANGLE)
        {
            ++grid->nodes[first].share;
            grid->nodes[i].share = 0;
        }
        else
        {
            first = i;
            ++grid->nodeCount;
        }
    }
}

// Index of the run after one, round the circle; its angle is `turn` further on if it went round.
static int nextRun(const swDirectionGrid* grid, int node, double* turn)
{
    int next = node + grid->nodes[node].share;
    *turn = next < grid->columnCount ? 0.0 : TURN;
    return next < grid->columnCount ? next : 0;
}

static double getGap(const swDirectionGrid* grid, int node)
{
    double turn = 0.0;
    int next = nextRun(grid, node, &turn);
    return grid->nodes[next].angle + turn - grid->nodes[node].angle;
}

static int previousRun(const swDirectionGrid* grid, int node)
{
    do
    {
        node = node > 0 ? node - 1 : grid->columnCount - 1;
    } while (grid->nodes[node].share == 0);
    return node;
}

static bool findRegular(swDirectionGrid* grid)
{
    double step = TURN / grid->nodeCount;
    double shift = 0.0; // mean of angle - step * i
    int index = 0;
    for (int i = 0; i < grid->columnCount; i += grid->nodes[i].share, ++index)
    {
        shift += (grid->nodes[i].angle - step * index) / grid->nodeCount;
    }
    double worst = 0.0;
    index = 0;
    for (int i = 0; i < grid->columnCount; i += grid->nodes[i].share, ++index)
    {
        double off = fabs(grid->nodes[i].angle - step * index - shift);
        worst = off > worst ? off : worst;
    }
    grid->count = grid->nodeCount;
    grid->first = shift;
    return worst <= REGULAR_TOLERANCE * step && worst <= TURN / 720.0;
}

static void findGaps(swDirectionGrid* grid)
{
    double smallest = TURN, widest = 0.0, second = 0.0;
    for (int i = 0; i < grid->columnCount; i += grid->nodes[i].share)
    {
        double gap = getGap(grid, i);
        smallest = gap < smallest ? gap : smallest;
        if (gap > widest)
        {
            second = widest;
            widest = gap;
            grid->lastNode = i;
        }
        else if (gap > second)
        {
            second = gap;
        }
    }
    grid->isSector = widest > SECTOR_RATIO * second;
    grid->count = smallest < TURN / 180.0 ? 720 : 360;
    grid->first = 0.0;
}

bool swMakeDirectionGrid(const double* angles, int count, swDirectionGrid* grid)
{
    sortNodes(angles, count, grid);
    findRuns(grid);
    grid->isSector = false;
    grid->lastNode = 0;
    if (grid->nodeCount < 3)
    {
        return false;
    }
    grid->isRegular = grid->nodeCount >= 4 && findRegular(grid);
    if (!grid->isRegular)
    {
        findGaps(grid);
    }
    return true;
}

// The mean of the columns of one angle.
static double getNodeDensity(const swDirectionGrid* grid, int node, const double* density)
{
    double sum = 0.0;
    for (int i = 0; i < grid->nodes[node].share; ++i)
    {
        sum += density[grid->nodes[node + i].column];
    }
    return sum / grid->nodes[node].share;
}

// Add the integral of a line from (a, ga) to (b, gb) times the hats. a < b, both within one cell of the table.
static void addPiece(double a, double b, double ga, double gb, double step, int count, double* table)
{
    double cell = floor(0.5 * (a + b) / step);
    double ta = a / step - cell, tb = b / step - cell;
    double width = (b - a) / (6.0 * step);
    double middle = 0.5 * (ga + gb) * 0.5 * (ta + tb);
    double high = width * (ga * ta + 4.0 * middle + gb * tb);
    double all = width * 3.0 * (ga + gb);
    int index = (int)(cell - count * floor(cell / count));
    table[index] += all - high;
    table[index + 1 < count ? index + 1 : 0] += high;
}

static void addLine(double a, double b, double ga, double gb, int count, double* table)
{
    double step = TURN / count;
    double from = a;
    while (from < b)
    {
        double edge = step * (floor(from / step + 1e-9) + 1.0);
        double to = edge < b ? edge : b;
        double slope = (gb - ga) / (b - a);
        addPiece(from, to, ga + slope * (from - a), to < b ? ga + slope * (to - a) : gb, step, count, table);
        from = to;
    }
}

void swSpreadOnGrid(const swDirectionGrid* grid, const double* density, double* table)
{
    int index = 0;
    for (int i = 0; i < grid->count; ++i)
    {
        table[i] = 0.0;
    }
    for (int i = 0; i < grid->columnCount; i += grid->nodes[i].share, ++index)
    {
        double here = getNodeDensity(grid, i, density);
        if (grid->isRegular)
        {
            table[index] = here;
            continue;
        }
        double turn = 0.0;
        int next = nextRun(grid, i, &turn);
        double there = getNodeDensity(grid, next, density);
        double a = grid->nodes[i].angle, b = grid->nodes[next].angle + turn;
        if (grid->isSector && i == grid->lastNode)
        {
            // Each end falls to nothing within its own step inwards: half a cell, as at every other direction.
            double before = getGap(grid, previousRun(grid, i));
            double behind = getGap(grid, next);
            addLine(a, a + before, here, 0.0, grid->count, table);
            addLine(b - behind, b, 0.0, there, grid->count, table);
            continue;
        }
        addLine(a, b, here, there, grid->count, table);
    }
}
