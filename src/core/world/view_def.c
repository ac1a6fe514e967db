// SPDX-License-Identifier: MIT
#include <math.h>

#include "core/base/host.h"
#include "core/world/world.h"

swViewDef swDefaultViewDef(void)
{
    return (swViewDef){
        .sliceCount = 7,
        .resolution = 384,
        .finestTexel = 1.0f / 16.0f,
        .maxScaleLevel = 10,
        .internalValue = SW_DEF_COOKIE,
    };
}

static bool isPowerOfTwoTexel(float texel)
{
    int exponent;
    return texel >= 1.0f / 64.0f && texel <= 16.0f && frexpf(texel, &exponent) == 0.5f;
}

swResult swCheckViewDef(const swHost* host, const swViewDef* def, bool hasQueries)
{
    if (def->sliceCount < 2 || def->sliceCount > SW_MAX_SLICES)
    {
        return swFail(host, SW_ERROR_INVALID, "a view's slice count is %d; it must be in [2, %d]", def->sliceCount,
                      SW_MAX_SLICES);
    }
    if (def->resolution < 64 || def->resolution > 1024 || def->resolution % 64 != 0)
    {
        return swFail(host, SW_ERROR_INVALID, "a view's resolution is %d; it must be a multiple of 64 in [64, 1024]",
                      def->resolution);
    }
    if (!isPowerOfTwoTexel(def->finestTexel))
    {
        return swFail(host, SW_ERROR_INVALID, "a view's finest texel is %g m; it must be a power of two in [1/64, 16]",
                      (double)def->finestTexel);
    }
    if (def->maxScaleLevel < 0 || def->maxScaleLevel > 16)
    {
        return swFail(host, SW_ERROR_INVALID, "a view's highest scale level is %d; it must be in [0, 16]",
                      def->maxScaleLevel);
    }
    if (def->enableCpuLayers && !hasQueries)
    {
        return swFail(host, SW_ERROR_INVALID, "a view asks for CPU layers in a world made without queries");
    }
    return SW_SUCCESS;
}
