// SPDX-License-Identifier: MIT
// Hulls of any triangles. Most soups are open and are refused with a sentence; closed ones are made of a tetrahedron
// whose corners are moved and whose faces are doubled. What is taken has finite distances, below 0 only within its
// bounds.

#include "fuzz_bytes.h"
#include "seaway/hull.h"

#define VERTICES 16
#define TRIANGLES 24

static void TakeMesh(Bytes* bytes, swVec3* vertices, uint32_t* indices, swHullDef* def)
{
    static const uint32_t faces[12] = {0, 2, 1, 0, 3, 2, 0, 1, 3, 1, 2, 3};
    bool isClosed = TakeByte(bytes) % 4 != 3;
    int parts = TakeChoice(bytes, 4) + 1;
    def->vertexCount = isClosed ? 4 * parts : TakeChoice(bytes, VERTICES) + 1;
    def->triangleCount = isClosed ? 4 * parts : TakeChoice(bytes, TRIANGLES) + 1;
    for (int i = 0; i < def->vertexCount; ++i)
    {
        vertices[i] = (swVec3){TakeNumber(bytes), TakeNumber(bytes), TakeNumber(bytes)};
    }
    for (int i = 0; i < 3 * def->triangleCount; ++i)
    {
        indices[i] = isClosed ? 4 * (uint32_t)(i / 12) + faces[i % 12] : (uint32_t)TakeByte(bytes) % (VERTICES + 2);
    }
    def->vertices = vertices;
    def->indices = indices;
}

static void CheckDistances(const swHull* hull)
{
    swHullInfo info = swHull_GetInfo(hull);
    FUZZ_CHECK(info.spacing > 0.0f && info.countX > 0 && info.countY > 0 && info.countZ > 0);
    for (int i = 0; i < 27; ++i)
    {
        // From a bit outside of the bounds to a bit outside on the other side.
        float x = -0.1f + 0.6f * (float)(i % 3), y = -0.1f + 0.6f * (float)(i / 3 % 3);
        float z = -0.1f + 0.6f * (float)(i / 9);
        swVec3 point = {info.low.x + x * (info.high.x - info.low.x), info.low.y + y * (info.high.y - info.low.y),
                        info.low.z + z * (info.high.z - info.low.z)};
        float distance = 0.0f;
        swHull_Sample(hull, 1, &point, &distance);
        bool isOutside = i % 3 != 1 || i / 3 % 3 != 1 || i / 9 != 1;
        FUZZ_CHECK(isfinite(distance));
        FUZZ_CHECK(!isOutside || distance > -2.0f * info.spacing);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    swVec3 vertices[VERTICES];
    uint32_t indices[3 * TRIANGLES];
    Bytes bytes = {data, size, 0};
    swHullDef def = swDefaultHullDef();
    int messages = 0;
    swHost host = swDefaultHost();
    host.log = CountMessage;
    host.logContext = &messages;
    TakeMesh(&bytes, vertices, indices, &def);
    def.resolution = TakeByte(&bytes) % 32;
    swHull* hull = NULL;
    swResult result = swCreateHull(&host, &def, &hull);
    FUZZ_CHECK((result == SW_SUCCESS) == (hull != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (hull != NULL)
    {
        CheckDistances(hull);
    }
    swDestroyHull(hull);
    return 0;
}
