// SPDX-License-Identifier: MIT
// Fresnel's reflectance of unpolarised light at a smooth boundary, exact for a medium that does not absorb.
// `cosine` is that of the angle between light and normal, on the side where the light comes from; `index` is the
// refractive index of the other side over that of this side: 1.333 from air into water, 1 / 1.333 from water into air,
// where beyond the critical angle everything is reflected.
#ifndef SW_SHARED_FRESNEL_H
#define SW_SHARED_FRESNEL_H
#include "types.h"

#ifdef __STDC__
#include <math.h>
#define SW_FRESNEL_SQRT sqrtf
#else
#define SW_FRESNEL_SQRT sqrt
#endif

SW_FORMULA float swFresnel(float cosine, float index)
{
    float c = cosine < 0.0f ? 0.0f : cosine;
    c = c > 1.0f ? 1.0f : c;
    float square = index * index - 1.0f + c * c; // of index times the cosine on the other side
    if (square <= 0.0f)
    {
        return 1.0f;
    }
    float g = SW_FRESNEL_SQRT(square);
    float a = (g - c) / (g + c);
    float b = (c * (g + c) - 1.0f) / (c * (g - c) + 1.0f);
    return 0.5f * a * a * (1.0f + b * b);
}
#endif
