// SPDX-License-Identifier: MIT
// A spline as flat words for shaders/shared/shape_spline.h: numbers of the whole, spans, knots, and a grid of cells
// with the segments whose ribbon may reach each of them.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/input/spline.h"
#include "shared/shape_spline.h"

#define MOST_LISTED 24 // entries of lists a segment, on average

typedef struct Grid
{
    double x, z, cell;
    int columns, rows;
} Grid;

typedef struct Box
{
    double leastX, leastZ, mostX, mostZ;
} Box;

typedef struct Source
{
    const swSpline* spline;
    const swSplineSpan* spans;
    const swSplineKnot* knots;
    const double* steps; // of segments
    const int* owners;   // span of each segment
    const double* along; // where each segment begins, from its span's beginning
    double reach;        // of the ribbon to either side
} Source;

// ---- where ribbons reach ----

// The farthest that the ribbon reaches to either side. Of all points: a place in a wide part of the ribbon has to know
// whether a narrow part is nearer.
static double getReach(const swSpline* spline)
{
    float most = 0.0f;
    for (int i = 0; i < spline->def.pointCount; ++i)
    {
        most = spline->points[i].width > most ? spline->points[i].width : most;
    }
    return (double)spline->def.width * (double)most * (spline->def.offset == SW_SPLINE_CENTRE ? 0.5 : 1.0);
}

static Box widen(Box box, double x, double z)
{
    return (Box){fmin(box.leastX, x), fmin(box.leastZ, z), fmax(box.mostX, x), fmax(box.mostZ, z)};
}

// Of all that may have its foot on a segment.
static Box boundSegment(const Source* from, int segment)
{
    const swSplineKnot *a = &from->knots[segment], *b = a + 1;
    double step = from->steps[segment];
    double bend = fmax(fmax(fabs(a->bendX), fabs(a->bendZ)), fmax(fabs(b->bendX), fabs(b->bendZ)));
    // A curve leaves its chord by at most an eighth of its second derivative; the rest is for rounding.
    double more = from->reach + bend * step * step * 0.25 + 0.01;
    Box box = widen((Box){a->x, a->z, a->x, a->z}, b->x, b->z);
    return (Box){box.leastX - more, box.leastZ - more, box.mostX + more, box.mostZ + more};
}

static Box boundAll(const Source* from)
{
    Box all = boundSegment(from, 0);
    for (int i = 1; i < from->spline->segmentCount; ++i)
    {
        Box box = boundSegment(from, i);
        all = widen(widen(all, box.leastX, box.leastZ), box.mostX, box.mostZ);
    }
    return all;
}

// ---- the grid ----

typedef struct Cells
{
    int left, top, right, bottom;
} Cells;

static int clampCell(double at, int count)
{
    int cell = (int)floor(at);
    return cell < 0 ? 0 : cell >= count ? count - 1 : cell;
}

static Cells findCells(const Grid* grid, Box box)
{
    // A cell more to each side where floats may see the border elsewhere.
    double slack = grid->cell * 1e-3;
    return (Cells){clampCell((box.leastX - slack - grid->x) / grid->cell, grid->columns),
                   clampCell((box.leastZ - slack - grid->z) / grid->cell, grid->rows),
                   clampCell((box.mostX + slack - grid->x) / grid->cell, grid->columns),
                   clampCell((box.mostZ + slack - grid->z) / grid->cell, grid->rows)};
}

static size_t countListed(const Source* from, const Grid* grid)
{
    size_t listed = 0;
    for (int i = 0; i < from->spline->segmentCount; ++i)
    {
        Cells cells = findCells(grid, boundSegment(from, i));
        listed += (size_t)(cells.right - cells.left + 1) * (size_t)(cells.bottom - cells.top + 1);
    }
    return listed;
}

static Grid makeGrid(const Box* all, double cell)
{
    // Floats: the corner lies on one, and so does the size of cells.
    Grid grid = {.x = (double)(float)(all->leastX - 0.01 * cell), .z = (double)(float)(all->leastZ - 0.01 * cell)};
    grid.cell = (double)(float)cell;
    grid.columns = (int)ceil((all->mostX - grid.x) / grid.cell + 0.01);
    grid.rows = (int)ceil((all->mostZ - grid.z) / grid.cell + 0.01);
    return grid;
}

// Cells about as large as the ribbon is wide, as far as their number and their lists stay in proportion.
static Grid chooseGrid(const Source* from, const Box* all, size_t* listed)
{
    int segments = from->spline->segmentCount;
    double width = all->mostX - all->leastX, height = all->mostZ - all->leastZ;
    double cell = fmax(2.0 * from->reach, sqrt(width * height / (4.0 * segments + 64.0)));
    Grid grid = makeGrid(all, cell);
    while ((*listed = countListed(from, &grid)) > (size_t)MOST_LISTED * (size_t)segments &&
           grid.columns * grid.rows > 1)
    {
        cell *= 1.5;
        grid = makeGrid(all, cell);
    }
    return grid;
}

// Each cell's list in the order of segments: count, sum up, fill.
static void fillGrid(const Source* from, const Grid* grid, size_t firstCell, size_t firstList, float* words)
{
    size_t cells = (size_t)grid->columns * (size_t)grid->rows;
    float* starts = words + firstCell;
    memset(starts, 0, (cells + 1) * sizeof(float));
    for (int pass = 0; pass < 2; ++pass)
    {
        for (int i = 0; i < from->spline->segmentCount; ++i)
        {
            Cells box = findCells(grid, boundSegment(from, i));
            for (int row = box.top; row <= box.bottom; ++row)
            {
                for (int column = box.left; column <= box.right; ++column)
                {
                    float* start = &starts[(size_t)row * (size_t)grid->columns + (size_t)column];
                    if (pass == 1)
                    {
                        words[(size_t)*start] = (float)i;
                    }
                    *start += 1.0f;
                }
            }
        }
        // After counting, from counts to starts; after filling, from ends back to starts.
        float at = (float)firstList;
        for (size_t i = 0; i <= cells; ++i)
        {
            float value = starts[i];
            starts[i] = at;
            at = pass == 0 ? at + value : value;
        }
    }
}

// ---- spans and knots ----

// Of heights at a point: those of a curve that never overshoots [Fritsch and Butland 1984].
static double getSlope(const swSpline* spline, const swSplineSpan* spans, int point)
{
    int count = spline->def.pointCount, last = count - 1;
    bool hasBefore = spline->def.isClosed || point > 0, hasAfter = spline->def.isClosed || point < last;
    int before = (point + count - 1) % count, after = (point + 1) % count;
    double in = 0.0, out = 0.0, inLength = 0.0, outLength = 0.0;
    if (hasBefore)
    {
        inLength = spans[before].length;
        in = (spline->points[point].y - spline->points[before].y) / inLength;
    }
    if (hasAfter)
    {
        outLength = spans[point].length;
        out = (spline->points[after].y - spline->points[point].y) / outLength;
    }
    if (!hasBefore || !hasAfter)
    {
        return hasBefore ? in : out;
    }
    if (!(in * out > 0.0))
    {
        return 0.0;
    }
    double a = 2.0 * outLength + inLength, b = outLength + 2.0 * inLength;
    return (a + b) / (a / in + b / out);
}

// Cells of SW_QUERY_CELL and the rest.
static void splitLength(double length, float* cells, float* rest)
{
    double whole = floor(length / (double)SW_QUERY_CELL);
    *cells = (float)whole;
    *rest = (float)(length - whole * (double)SW_QUERY_CELL);
}

static void fillSpan(const Source* from, int span, int firstKnot, float* words)
{
    const swSpline* spline = from->spline;
    int next = (span + 1) % spline->def.pointCount;
    const swSplinePoint* ends[2] = {&spline->points[span], &spline->points[next]};
    words[SW_SPAN_FIRST_KNOT] = (float)firstKnot;
    words[SW_SPAN_LENGTH] = (float)from->spans[span].length;
    splitLength(spline->starts[span], &words[SW_SPAN_CELL], &words[SW_SPAN_REST]);
    words[SW_SPAN_SLOPE] = (float)getSlope(spline, from->spans, span);
    words[SW_SPAN_SLOPE + 1] = (float)getSlope(spline, from->spans, next);
    for (int end = 0; end < 2; ++end)
    {
        const swSplinePoint* point = ends[end];
        words[SW_SPAN_HEIGHT + end] = (float)point->y;
        words[SW_SPAN_WIDTH + end] = point->width;
        words[SW_SPAN_WEIGHT + end] = point->weight;
        words[SW_SPAN_FLOW + end] = point->flow;
        words[SW_SPAN_FOAM + end] = point->foam;
        words[SW_SPAN_LEVEL + end] = point->level;
        words[SW_SPAN_DEPTH + end] = point->depth;
    }
}

static void fillKnot(const Source* from, int knot, float* words)
{
    const swSplineKnot* k = &from->knots[knot];
    int segment = knot < from->spline->segmentCount ? knot : knot - 1;
    words[SW_KNOT_X] = (float)k->x;
    words[SW_KNOT_Z] = (float)k->z;
    words[SW_KNOT_TANGENT_X] = (float)k->tangentX;
    words[SW_KNOT_TANGENT_Z] = (float)k->tangentZ;
    words[SW_KNOT_BEND_X] = (float)k->bendX;
    words[SW_KNOT_BEND_Z] = (float)k->bendZ;
    words[SW_KNOT_SPAN] = (float)from->owners[segment];
    words[SW_KNOT_STEP] = (float)from->steps[segment];
    words[SW_KNOT_ALONG] = (float)from->along[segment];
    // Feet may appear within it if places of the ribbon reach the centre of one of its bends.
    const swSplineKnot *a = &from->knots[segment], *b = a + 1;
    double bend = fmax(a->bendX * a->bendX + a->bendZ * a->bendZ, b->bendX * b->bendX + b->bendZ * b->bendZ);
    words[SW_KNOT_IS_TIGHT] = sqrt(bend) * from->reach > 0.6 ? 1.0f : 0.0f;
}

static void fillHead(const Source* from, const Grid* grid, float* words)
{
    const swSplineDef* def = &from->spline->def;
    double length = from->spline->starts[from->spline->spanCount];
    words[SW_RIBBON_SEGMENTS] = (float)from->spline->segmentCount;
    words[SW_RIBBON_IS_CLOSED] = def->isClosed ? 1.0f : 0.0f;
    words[SW_RIBBON_LEFT] = def->offset == SW_SPLINE_CENTRE ? 0.5f * def->width
                            : def->offset == SW_SPLINE_LEFT ? def->width
                                                            : 0.0f;
    words[SW_RIBBON_RIGHT] = def->width - words[SW_RIBBON_LEFT];
    words[SW_RIBBON_START_RAMP] = def->startRamp;
    words[SW_RIBBON_END_RAMP] = def->endRamp;
    words[SW_RIBBON_LENGTH] = (float)length;
    words[SW_RIBBON_GRID_X] = (float)grid->x;
    words[SW_RIBBON_GRID_Z] = (float)grid->z;
    words[SW_RIBBON_CELL] = (float)grid->cell;
    words[SW_RIBBON_COLUMNS] = (float)grid->columns;
    words[SW_RIBBON_ROWS] = (float)grid->rows;
    // As long as most waves are, but there is a lap to fade into.
    words[SW_RIBBON_SEAM] = def->isClosed ? (float)fmin(0.25 * length, 200.0) : 0.0f;
    splitLength(length, &words[SW_RIBBON_LENGTH_CELL], &words[SW_RIBBON_LENGTH_REST]);
}

static void fillWords(const Source* from, const Grid* grid, float* words)
{
    const swSpline* spline = from->spline;
    size_t spans = SW_RIBBON_HEAD, knots = spans + (size_t)spline->spanCount * SW_SPAN_WORDS;
    size_t cells = knots + ((size_t)spline->segmentCount + 1) * SW_KNOT_WORDS;
    size_t lists = cells + (size_t)grid->columns * (size_t)grid->rows + 1;
    fillHead(from, grid, words);
    words[SW_RIBBON_SPANS] = (float)spans;
    words[SW_RIBBON_KNOTS] = (float)knots;
    words[SW_RIBBON_CELLS] = (float)cells;
    for (int i = 0, knot = 0; i < spline->spanCount; knot += from->spans[i].segmentCount, ++i)
    {
        fillSpan(from, i, knot, words + spans + (size_t)i * SW_SPAN_WORDS);
    }
    for (int i = 0; i <= spline->segmentCount; ++i)
    {
        fillKnot(from, i, words + knots + (size_t)i * SW_KNOT_WORDS);
    }
    fillGrid(from, grid, cells, lists, words);
}

static void findOwners(const swSpline* spline, const swSplineSpan* spans, const double* steps, int* owners,
                       double* along)
{
    for (int i = 0, segment = 0; i < spline->spanCount; ++i)
    {
        double at = 0.0;
        for (int k = 0; k < spans[i].segmentCount; ++k, ++segment)
        {
            owners[segment] = i;
            along[segment] = at;
            at += steps[segment];
        }
    }
}

static double findLeastRadius(const Source* from)
{
    double most = 0.0;
    for (int i = 0; i < from->spline->segmentCount; ++i)
    {
        most = fmax(most, swGetMostCurvature(&from->knots[i], from->steps[i]));
    }
    return most > 0.0 ? 1.0 / most : (double)INFINITY;
}

static swResult makeWords(swSpline* spline, const Source* from)
{
    Box all = boundAll(from);
    size_t listed = 0;
    Grid grid = chooseGrid(from, &all, &listed);
    size_t count = SW_RIBBON_HEAD + (size_t)spline->spanCount * SW_SPAN_WORDS +
                   ((size_t)spline->segmentCount + 1) * SW_KNOT_WORDS + (size_t)grid.columns * (size_t)grid.rows + 1 +
                   listed;
    // Words name other words by floats.
    if (count > 1u << 24)
    {
        return swFail(&spline->host, SW_ERROR_LIMIT,
                      "%s needs %zu words and may have %u; divide it into several splines.", spline->name, count,
                      1u << 24);
    }
    spline->words = swAllocate(&spline->host, count * sizeof(float));
    if (spline->words == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    spline->wordCount = count;
    spline->leastX = all.leastX;
    spline->leastZ = all.leastZ;
    spline->mostX = all.mostX;
    spline->mostZ = all.mostZ;
    fillWords(from, &grid, spline->words);
    return SW_SUCCESS;
}

swResult swMakeSplineWords(swSpline* spline, const swSplineSpan* spans, swSplineKnot* knots, const double* steps)
{
    size_t count = (size_t)spline->segmentCount;
    size_t size = (5 * count + 4) * sizeof(double) + count * sizeof(int);
    double* scratch = swAllocate(&spline->host, size);
    if (scratch == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    double* along = scratch + 4 * (count + 1);
    int* owners = (int*)(along + count);
    findOwners(spline, spans, steps, owners, along);
    double start[2], end[2];
    swGetEndDirections(spline, start, end);
    swFitKnots((int)count, spline->def.isClosed, steps, start, end, knots, scratch);
    const Source from = {spline, spans, knots, steps, owners, along, getReach(spline)};
    spline->leastRadius = findLeastRadius(&from);
    swResult result = makeWords(spline, &from);
    swFree(&spline->host, scratch, size);
    return result;
}

// ---- words from outside ----

// A whole number that a float says, from `least` to `most`.
static bool readWhole(float word, size_t least, size_t most, size_t* whole)
{
    bool isWithin = word >= (float)least && word <= (float)most && floorf(word) == word;
    *whole = isWithin ? (size_t)word : 0;
    return isWithin;
}

static bool areKnotsGood(const float* knots, size_t segments, size_t spans)
{
    for (size_t i = 0; i <= segments; ++i)
    {
        size_t span;
        const float* knot = knots + i * SW_KNOT_WORDS;
        if (!readWhole(knot[SW_KNOT_SPAN], 0, spans - 1, &span) || !(knot[SW_KNOT_STEP] > 0.0f))
        {
            return false;
        }
    }
    return true;
}

static bool areListsGood(const float* words, size_t cells, size_t cellCount, size_t count, size_t segments)
{
    size_t before = cells + cellCount + 1, start, segment;
    for (size_t i = 0; i <= cellCount; ++i)
    {
        if (!readWhole(words[cells + i], before, count, &start))
        {
            return false;
        }
        before = start;
    }
    for (size_t i = cells + cellCount + 1; i < before; ++i)
    {
        if (!readWhole(words[i], 0, segments - 1, &segment))
        {
            return false;
        }
    }
    return true;
}

// Places along the line and beside it become whole cells of 32 bits.
static bool areNumbersGood(const float* words, size_t count)
{
    bool areGood = true;
    for (size_t i = 0; i < count && areGood; ++i)
    {
        areGood = fabsf(words[i]) <= 0x1p28f; // false for NaN
    }
    return areGood;
}

bool swAreSplineWordsGood(const float* words, size_t count)
{
    size_t segments, columns, rows, spans, knots, cells;
    if (count < SW_RIBBON_HEAD || count > 1u << 24 || !readWhole(words[SW_RIBBON_SEGMENTS], 1, count, &segments) ||
        !readWhole(words[SW_RIBBON_COLUMNS], 1, count, &columns) ||
        !readWhole(words[SW_RIBBON_ROWS], 1, count, &rows) ||
        !readWhole(words[SW_RIBBON_SPANS], SW_RIBBON_HEAD, SW_RIBBON_HEAD, &spans) ||
        !readWhole(words[SW_RIBBON_KNOTS], spans + SW_SPAN_WORDS, count, &knots) ||
        !readWhole(words[SW_RIBBON_CELLS], knots, count, &cells))
    {
        return false;
    }
    bool isFull = knots + (segments + 1) * SW_KNOT_WORDS == cells && columns * rows < count - cells;
    return isFull && areNumbersGood(words, count) &&
           areKnotsGood(words + knots, segments, (knots - spans) / SW_SPAN_WORDS) &&
           areListsGood(words, cells, columns * rows, count, segments);
}
