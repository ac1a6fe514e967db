// SPDX-License-Identifier: MIT
// What is asked of the water: a query's def, and a ray.

#include "core/query/query_def.h"

#include <float.h>
#include <math.h>

#include "core/base/host.h"
#include "core/frame/asked.h"

// ---- a query ----

static const char* const stretchingWords[] = {"wheeler", "linear", NULL};
static const char* const stretchingNames[] = {"Wheeler", "linear theory", NULL};

#define SW_DEF swQueryDef
static const swField queryFields[] = {
    SW_NUMBER(minWavelength, "m", SW_WITHIN(0.0, (double)INFINITY), 0.0, .key = NULL, .label = "shortest wave",
              .tip = "Shorter waves are left out", SW_KNOB(0.0, 64.0), .use = SW_USE_HERE),
    SW_NUMBER(tolerance, "m", SW_WITHIN(1e-6, 1e9), 0.0005, .key = NULL, .label = "tolerance",
              .tip = "Horizontal error at which a search ends", SW_LOG_KNOB(1e-6, 1.0), .use = SW_USE_HERE),
    SW_NUMBER(maxIterations, "", SW_WITHIN(1.0, 64.0), 24.0, .key = NULL, .label = "most iterations",
              SW_KNOB(1.0, 64.0), .use = SW_USE_HERE),
    SW_NUMBER(time, "s", SW_WITHIN(-SW_LARGEST_TIME, SW_LARGEST_TIME), SW_QUERY_NOW, .key = NULL, .label = "time",
              .tip = "Another time than the last step's is slow", SW_OR(SW_QUERY_NOW), SW_KNOB(-3600.0, 3600.0),
              .use = SW_USE_HERE),
    SW_GIVEN(after, .key = NULL, .label = "later moment"),
    SW_CHOICE(stretching, stretchingWords, stretchingNames, SW_STRETCHING_WHEELER, .key = NULL, .label = "stretching",
              .use = SW_USE_HERE),
};
#undef SW_DEF

const swFields swQueryFields = SW_FIELDS(swQueryDef, NULL, "query", queryFields, -1);

const swFields* swGetQueryFields(void)
{
    return &swQueryFields;
}

swQueryDef swDefaultQueryDef(void)
{
    swQueryDef def;
    swFillDef(&swQueryFields, &def);
    return def;
}

// ---- a ray; swIsRayGood() asks the same of thousands ----

#define SW_DEF swRay
static const swField rayFields[] = {
    SW_NUMBERS(origin, double, "m", SW_WITHIN(-SW_FARTHEST_POINT, SW_FARTHEST_POINT), SW_EACH(0.0, 0.0, 0.0),
               .key = NULL, .label = "origin", SW_KNOB(-1000.0, 1000.0), .use = SW_USE_HERE),
    SW_NUMBERS(direction, float, "", SW_WITHIN((double)-FLT_MAX, (double)FLT_MAX), SW_EACH(0.0, -1.0, 0.0), .key = NULL,
               .label = "direction", SW_KNOB(-1.0, 1.0), .use = SW_USE_HERE),
    SW_NUMBER(maxDistance, "m", SW_WITHIN(0.0, 1e5), 1000.0, .key = NULL, .label = "longest way", SW_LOG_KNOB(1.0, 1e5),
              .use = SW_USE_HERE),
    SW_NUMBER(radius, "m", SW_WITHIN(0.0, 100.0), 0.0, .key = NULL, .label = "radius", .zero = "a ray",
              SW_KNOB(0.0, 10.0), .use = SW_USE_HERE),
    SW_NUMBER(duration, "s", SW_WITHIN(0.0, 3600.0), 0.0, .key = NULL, .label = "duration",
              .zero = "the surface stands still", SW_KNOB(0.0, 60.0), .use = SW_USE_HERE),
};
#undef SW_DEF

const swFields swRayFields = SW_FIELDS(swRay, NULL, "ray", rayFields, -1);

const swFields* swGetRayFields(void)
{
    return &swRayFields;
}

swRay swDefaultRay(swPos origin, swVec3 direction)
{
    swRay ray;
    swFillDef(&swRayFields, &ray);
    ray.origin = origin;
    ray.direction = direction;
    return ray;
}
