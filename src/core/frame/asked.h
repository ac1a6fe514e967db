// SPDX-License-Identifier: MIT
#pragma once

// What can be asked of the water, on either half. A point, a place or a ray that cannot be answered gets NaN and is
// counted; the others are as without it. Comparisons are written so that NaN fails them.

#include <math.h>

#include "core/base/host.h"
#include "seaway/query.h"

static inline bool swIsNear(double metres)
{
    return fabs(metres) <= SW_FARTHEST_POINT;
}

// In double, where squares of floats neither vanish nor overflow.
static inline double swGetRayLength(const swRay* ray)
{
    double x = (double)ray->direction.x, y = (double)ray->direction.y, z = (double)ray->direction.z;
    return sqrt(x * x + y * y + z * z);
}

static inline bool swIsRayGood(const swRay* ray)
{
    double length = swGetRayLength(ray);
    return ray->internalValue == SW_DEF_COOKIE && length > 0.0 && length <= 1e40 && swIsNear(ray->origin.x) &&
           swIsNear(ray->origin.y) && swIsNear(ray->origin.z) && ray->maxDistance >= 0.0f && ray->maxDistance <= 1e5f &&
           ray->radius >= 0.0f && ray->radius <= 100.0f && ray->duration >= 0.0f && ray->duration <= 3600.0f;
}
