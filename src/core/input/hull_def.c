// SPDX-License-Identifier: MIT
#include "core/input/hull.h"

#define SW_DEF swHullDef

static const swField hullFields[] = {
    SW_GIVEN(name, .label = "name"),
    SW_NUMBER(resolution, "", SW_WITHIN(8.0, 256.0), 64.0, .label = "spacings along the longest side"),
    SW_GIVEN(vertices, .label = "vertices"),
    SW_GIVEN(vertexCount, .label = "number of vertices"),
    SW_GIVEN(indices, .label = "indices"),
    SW_GIVEN(triangleCount, .label = "number of triangles"),
};

const swFields swHullFields = SW_FIELDS(swHullDef, NULL, "hull", hullFields, -1);

const swFields* swGetHullFields(void)
{
    return &swHullFields;
}

swHullDef swDefaultHullDef(void)
{
    swHullDef def;
    swFillDef(&swHullFields, &def);
    def.name = "hull";
    return def;
}
