// SPDX-License-Identifier: MIT
// What the def of a view is, by default and at most.

#include <math.h>

#include "core/base/host.h"
#include "core/world/world.h"

#define SW_DEF swViewDef
static const swField viewFields[] = {
    SW_NUMBER(sliceCount, "", SW_WITHIN(2.0, SW_MAX_SLICES), 7.0, .key = "slice_count", .label = "slices",
              SW_KNOB(2.0, SW_MAX_SLICES), .use = SW_USE_STATE),
    SW_NUMBER(resolution, "", SW_WITHIN(64.0, 1024.0), 384.0, .key = "resolution", .label = "resolution",
              .tip = "Texels along a slice's side, a multiple of 64", SW_KNOB(64.0, 1024.0), .use = SW_USE_STATE),
    SW_NUMBER(finestTexel, "m", SW_WITHIN(0.015625, 16.0), 0.0625, .key = "finest_texel_m", .label = "finest texel",
              .tip = "Of the finest slice near the water, a power of two", SW_LOG_KNOB(0.015625, 16.0),
              .use = SW_USE_STATE),
    SW_NUMBER(maxScaleLevel, "", SW_WITHIN(0.0, 16.0), 10.0, .key = "max_scale_level", .label = "doublings",
              .tip = "How many times slices may double with height", SW_KNOB(0.0, 16.0), .use = SW_USE_STATE),
    SW_SWITCH(enableCpuLayers, false, .key = NULL, .label = "CPU layers",
              .tip = "Compute the slices' layers on the CPU too", .use = SW_USE_STATE),
};
#undef SW_DEF

const swFields swViewFields = SW_FIELDS(swViewDef, "view", "slices", viewFields, -1);

const swFields* swGetViewFields(void)
{
    return &swViewFields;
}

swViewDef swDefaultViewDef(void)
{
    swViewDef def;
    swFillDef(&swViewFields, &def);
    return def;
}

// ---- what the table cannot say ----

swResult swCheckViewDef(const swHost* host, const swViewDef* def, bool hasQueries)
{
    swResult result = swCheckDef(host, &swViewFields, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (def->resolution % 64 != 0)
    {
        return swFail(host, SW_ERROR_INVALID, "swViewDef::resolution is %d; it must be a multiple of 64.",
                      def->resolution);
    }
    int exponent;
    if (frexpf(def->finestTexel, &exponent) != 0.5f)
    {
        return swFail(host, SW_ERROR_INVALID, "swViewDef::finestTexel is %g m; it must be a power of two.",
                      (double)def->finestTexel);
    }
    if (def->enableCpuLayers && !hasQueries)
    {
        return swFail(host, SW_ERROR_INVALID,
                      "swViewDef::enableCpuLayers is true; that needs a world with swWorldDef::enableQueries.");
    }
    return SW_SUCCESS;
}
