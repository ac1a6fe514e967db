// SPDX-License-Identifier: MIT
#include "core/input/raster.h"

#define SW_DEF swRasterDef

static const swField rasterFields[] = {
    SW_GIVEN(name, .label = "name"),
    SW_NUMBER(width, "cells", SW_WITHIN(1.0, SW_MAX_RASTER_SIDE), 1.0, .label = "cells eastwards"),
    SW_NUMBER(height, "cells", SW_WITHIN(1.0, SW_MAX_RASTER_SIDE), 1.0, .label = "cells southwards"),
    SW_NUMBER(x, "m", SW_WITHIN(-1e9, 1e9), 0.0, .label = "x of the first cell"),
    SW_NUMBER(z, "m", SW_WITHIN(-1e9, 1e9), 0.0, .label = "z of the first cell"),
    SW_NUMBER(spacingX, "m", SW_WITHIN(0.001, 1e6), 1.0, .label = "spacing eastwards"),
    SW_NUMBER(spacingZ, "m", SW_WITHIN(0.001, 1e6), 1.0, .label = "spacing southwards"),
    SW_NUMBER(channels, "", SW_WITHIN(1.0, 4.0), 1.0, .label = "channels"),
    SW_NUMBER(frames, "", SW_WITHIN(1.0, 65536.0), 1.0, .label = "frames"),
    SW_GIVEN(values, .label = "values"),
};

const swFields swRasterFields = SW_FIELDS(swRasterDef, NULL, "raster", rasterFields, -1);

const swFields* swGetRasterFields(void)
{
    return &swRasterFields;
}

swRasterDef swDefaultRasterDef(void)
{
    swRasterDef def;
    swFillDef(&swRasterFields, &def);
    def.name = "raster";
    return def;
}
