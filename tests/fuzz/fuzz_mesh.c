// SPDX-License-Identifier: MIT
// Meshes of any numbers: what is taken answers everywhere, and what is refused is told.

#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "seaway/mesh.h"

#define VERTICES 64
#define TRIANGLES 96

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static swVec3 vertices[VERTICES];
    static uint32_t indices[3 * TRIANGLES];
    if (size < 4)
    {
        return 0;
    }
    memset(vertices, 0, sizeof(vertices));
    memset(indices, 0, sizeof(indices));
    size_t half = (size - 2) / 2;
    memcpy(vertices, data + 2, half < sizeof(vertices) ? half : sizeof(vertices));
    for (size_t i = 0; i < half && i < 3 * TRIANGLES; ++i)
    {
        indices[i] = data[2 + half + i];
    }
    swMeshDef def = swDefaultMeshDef();
    def.vertices = vertices;
    def.vertexCount = data[0] % VERTICES + 1;
    def.indices = indices;
    def.triangleCount = data[1] % TRIANGLES + 1;
    swHost host = swDefaultHost();
    int messages = 0;
    host.log = CountMessage;
    host.logContext = &messages;
    swMesh* mesh = NULL;
    swResult result = swCreateMesh(&host, &def, &mesh);
    FUZZ_CHECK((result == SW_SUCCESS) == (mesh != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    for (int i = 0; i < def.vertexCount && mesh != NULL; ++i)
    {
        float height = 0.0f;
        swMesh_Sample(mesh, 1, &(swVec2){vertices[i].x, vertices[i].z}, &height);
        swMeshInfo info = swMesh_GetInfo(mesh);
        FUZZ_CHECK(isnan(height) || (height >= info.low.y && height <= info.high.y));
    }
    swDestroyMesh(mesh);
    return 0;
}
