// SPDX-License-Identifier: MIT
#include "core/input/mesh.h"

#define SW_DEF swMeshDef

static const swField meshFields[] = {
    SW_GIVEN(name, .label = "name"),
    SW_NUMBER(highest, "m", SW_WITHIN(-1e6, 1e6), 1e6, .label = "height above which nothing counts"),
    SW_GIVEN(vertices, .label = "vertices"),
    SW_GIVEN(vertexCount, .label = "number of vertices"),
    SW_GIVEN(indices, .label = "indices"),
    SW_GIVEN(triangleCount, .label = "number of triangles"),
    SW_GIVEN(values, .label = "values"),
    SW_GIVEN(channelCount, .label = "values a vertex"),
};

const swFields swMeshFields = SW_FIELDS(swMeshDef, NULL, "mesh", meshFields, -1);

const swFields* swGetMeshFields(void)
{
    return &swMeshFields;
}

swMeshDef swDefaultMeshDef(void)
{
    swMeshDef def;
    swFillDef(&swMeshFields, &def);
    def.name = "mesh";
    return def;
}
