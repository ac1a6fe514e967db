// SPDX-License-Identifier: MIT
#include "core/input/spline.h"

#include <math.h>
#include <string.h>

#include "core/base/hash.h"
#include "core/base/misuse.h"

// ---- checks ----

// Whether a number of a point is outside of its range; then `sentence` says which.
static bool isPointWrong(const swSplinePoint* point, char* sentence, size_t size)
{
    return !swFields_Check(&swSplinePointFields, point, sentence, size);
}

static double measureStep(const swSplinePoint* a, const swSplinePoint* b)
{
    double x = b->x - a->x, z = b->z - a->z;
    return sqrt(x * x + z * z);
}

static swResult checkPoints(const swHost* host, const swSplineDef* def, const char* name)
{
    char sentence[256];
    int least = def->isClosed ? 3 : 2;
    if (def->pointCount < least || def->points == NULL)
    {
        return swFail(host, SW_ERROR_INVALID, "%s has %d points; %s spline needs %d or more.", name,
                      def->points == NULL ? 0 : def->pointCount, def->isClosed ? "a closed" : "a", least);
    }
    for (int i = 0; i < def->pointCount; ++i)
    {
        if (isPointWrong(&def->points[i], sentence, sizeof(sentence)))
        {
            return swFail(host, SW_ERROR_INVALID, "Point %d of %s, counted from 0: %s", i, name, sentence);
        }
    }
    int spans = def->isClosed ? def->pointCount : def->pointCount - 1;
    for (int i = 0; i < spans; ++i)
    {
        int next = (i + 1) % def->pointCount;
        double step = measureStep(&def->points[i], &def->points[next]);
        if (step < SW_LEAST_SPLINE_STEP)
        {
            return swFail(
                host, SW_ERROR_INVALID,
                "Points %d and %d of %s, counted from 0, are %g m apart as seen from above; they must be %g m "
                "apart. Take one away, or close the spline by isClosed instead of a doubled point.",
                i, next, name, step, SW_LEAST_SPLINE_STEP);
        }
    }
    return SW_SUCCESS;
}

// The middle of the points, and how far they reach.
static swResult findOrigin(const swHost* host, const swSplineDef* def, const char* name, swSpline* spline)
{
    double leastX = def->points[0].x, mostX = leastX, leastZ = def->points[0].z, mostZ = leastZ;
    for (int i = 1; i < def->pointCount; ++i)
    {
        leastX = fmin(leastX, def->points[i].x);
        mostX = fmax(mostX, def->points[i].x);
        leastZ = fmin(leastZ, def->points[i].z);
        mostZ = fmax(mostZ, def->points[i].z);
    }
    if (mostX - leastX > SW_MAX_SPLINE_SIDE || mostZ - leastZ > SW_MAX_SPLINE_SIDE)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "%s is %g m by %g m large; it may be %g m. Divide it into several splines.", name, mostX - leastX,
                      mostZ - leastZ, SW_MAX_SPLINE_SIDE);
    }
    spline->originX = 0.5 * (leastX + mostX);
    spline->originZ = 0.5 * (leastZ + mostZ);
    return SW_SUCCESS;
}

static swResult checkDef(const swHost* host, const swSplineDef* def, const char* name)
{
    // A list is checked with its def, but a point is worth a sentence of its own.
    swSplineDef alone = *def;
    alone.points = NULL;
    alone.pointCount = 0;
    swResult result = swCheckDef(host, &swSplineFields, &alone);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (def->pointCount > SW_MAX_SPLINE_POINTS)
    {
        return swFail(host, SW_ERROR_INVALID, "%s has %d points; a spline has at most %d.", name, def->pointCount,
                      SW_MAX_SPLINE_POINTS);
    }
    return checkPoints(host, def, name);
}

// ---- making ----

static size_t getHeadSize(int pointCount)
{
    return sizeof(swSpline) + (size_t)pointCount * sizeof(swSplinePoint) + (size_t)(pointCount + 1) * sizeof(double);
}

static void freeSpline(swSpline* spline)
{
    swHost host = spline->host;
    swFree(&host, spline->words, spline->wordCount * sizeof(float));
    swFree(&host, spline, getHeadSize(spline->def.pointCount));
}

static swResult measureSpans(swSpline* spline, swSplineSpan* spans)
{
    for (int i = 0; i < spline->spanCount; ++i)
    {
        swResult result = swMeasureSpan(spline, i, &spans[i]);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        spline->starts[i + 1] = spline->starts[i] + spans[i].length;
        spline->segmentCount += spans[i].segmentCount;
    }
    return SW_SUCCESS;
}

static swResult cutSpans(swSpline* spline, const swSplineSpan* spans)
{
    size_t count = (size_t)spline->segmentCount + 1, size = count * (sizeof(swSplineKnot) + sizeof(double));
    swSplineKnot* knots = swAllocate(&spline->host, size);
    if (knots == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    double* steps = (double*)(knots + count);
    int knot = 0;
    for (int i = 0; i < spline->spanCount; ++i)
    {
        swCutSpan(spline, i, knots + knot, steps + knot);
        knot += spans[i].segmentCount;
    }
    const swSplinePoint* last = &spline->points[spline->spanCount % spline->def.pointCount];
    knots[knot] = (swSplineKnot){.x = last->x - spline->originX, .z = last->z - spline->originZ};
    swResult result = swMakeSplineWords(spline, spans, knots, steps);
    swFree(&spline->host, knots, size);
    return result;
}

static swResult shape(swSpline* spline)
{
    size_t size = (size_t)spline->spanCount * sizeof(swSplineSpan);
    swSplineSpan* spans = swAllocate(&spline->host, size);
    if (spans == NULL)
    {
        return SW_ERROR_NO_MEMORY;
    }
    swResult result = measureSpans(spline, spans);
    result = result == SW_SUCCESS ? cutSpans(spline, spans) : result;
    swFree(&spline->host, spans, size);
    return result;
}

static uint64_t hashSpline(const swSpline* spline)
{
    swHash hash = swBeginHash();
    swHashDef(&hash, &swSplineFields, &spline->def);
    for (int i = 0; i < spline->def.pointCount; ++i)
    {
        swHashDef(&hash, &swSplinePointFields, &spline->points[i]);
    }
    return swEndHash(&hash);
}

// All but what memory may fail for.
static void copyDef(const swHost* host, const swSplineDef* def, const char* name, swSpline* spline)
{
    spline->host = *host;
    atomic_init(&spline->holderCount, 1);
    strncpy(spline->name, name, sizeof(spline->name) - 1);
    spline->points = (swSplinePoint*)(spline + 1);
    spline->starts = (double*)(spline->points + def->pointCount);
    memcpy(spline->points, def->points, (size_t)def->pointCount * sizeof(swSplinePoint));
    spline->starts[0] = 0.0;
    spline->def = *def;
    spline->def.name = spline->name;
    spline->def.points = spline->points;
    spline->spanCount = def->isClosed ? def->pointCount : def->pointCount - 1;
}

swResult swCreateSpline(const swHost* host, const swSplineDef* def, swSpline** spline)
{
    SW_REQUIRE_PLACE(host, spline, "swCreateSpline()");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, host,
               "swCreateSpline() needs a def made by swDefaultSplineDef()");
    const char* name = def->name != NULL ? def->name : "spline";
    swSpline empty = {.points = NULL};
    swResult result = checkDef(host, def, name);
    result = result == SW_SUCCESS ? findOrigin(host, def, name, &empty) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swSpline* made = swAllocate(host, getHeadSize(def->pointCount));
    if (made == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for the %d points of %s.", def->pointCount, name);
    }
    *made = empty;
    copyDef(host, def, name, made);
    result = shape(made);
    if (result != SW_SUCCESS)
    {
        freeSpline(made);
        return result == SW_ERROR_NO_MEMORY ? swFail(host, result, "No memory for %s.", name) : result;
    }
    made->memory = getHeadSize(def->pointCount) + made->wordCount * sizeof(float);
    made->hash = hashSpline(made);
    *spline = made;
    return SW_SUCCESS;
}

// ---- holders ----

void swRetainSpline(const swSpline* spline)
{
    if (spline != NULL)
    {
        atomic_fetch_add(&((swSpline*)(uintptr_t)spline)->holderCount, 1);
    }
}

void swReleaseSpline(const swSpline* spline)
{
    swSpline* held = (swSpline*)(uintptr_t)spline;
    if (held != NULL && atomic_fetch_sub(&held->holderCount, 1) == 1)
    {
        freeSpline(held);
    }
}

void swDestroySpline(swSpline* spline)
{
    swReleaseSpline(spline);
}

// ---- asking ----

swSplineDef swSpline_GetDef(const swSpline* spline)
{
    SW_REQUIRE(spline != NULL, ((swSplineDef){.name = ""}), NULL, "swSpline_GetDef() needs a spline");
    return spline->def;
}

swSplineInfo swSpline_GetInfo(const swSpline* spline)
{
    SW_REQUIRE(spline != NULL, ((swSplineInfo){.length = 0.0}), NULL, "swSpline_GetInfo() needs a spline");
    return (swSplineInfo){
        .length = spline->starts[spline->spanCount],
        .leastX = spline->originX + spline->leastX,
        .leastZ = spline->originZ + spline->leastZ,
        .mostX = spline->originX + spline->mostX,
        .mostZ = spline->originZ + spline->mostZ,
        .leastRadius = spline->leastRadius,
        .memory = spline->memory,
        .hash = spline->hash,
    };
}

float swGetFastestSplineFlow(const swSpline* spline)
{
    float most = 0.0f;
    for (int i = 0; i < spline->def.pointCount; ++i)
    {
        most = fmaxf(most, fabsf(spline->points[i].flow));
    }
    return most;
}

// Between points, both run within those of the points.
void swGetSplineHeights(const swSpline* spline, float* least, float* most)
{
    float low = INFINITY, high = -INFINITY, lowLevel = INFINITY, highLevel = -INFINITY;
    for (int i = 0; i < spline->def.pointCount; ++i)
    {
        low = fminf(low, (float)spline->points[i].y);
        high = fmaxf(high, (float)spline->points[i].y);
        lowLevel = fminf(lowLevel, spline->points[i].level);
        highLevel = fmaxf(highLevel, spline->points[i].level);
    }
    *least = low + lowLevel;
    *most = high + highLevel;
}
