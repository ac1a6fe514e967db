// SPDX-License-Identifier: MIT
#include "core/input/mesh.h"

#include <math.h>
#include <string.h>

#include "core/base/hash.h"
#include "core/base/misuse.h"
#include "core/input/mesh_grid.h"
#include "shared/shape_mesh.h"

#define FARTHEST 1e6f // m, of a vertex from the mesh's origin; and the largest value

// ---- what is given ----

static swResult checkVertices(const swHost* host, const swMeshDef* def, const char* name)
{
    for (int i = 0; i < def->vertexCount; ++i)
    {
        swVec3 v = def->vertices[i];
        bool isNear = fabsf(v.x) <= FARTHEST && fabsf(v.y) <= FARTHEST && fabsf(v.z) <= FARTHEST;
        if (!isNear)
        {
            return swFail(host, SW_ERROR_INVALID,
                          "%s has vertex %d at (%g, %g, %g), counted from 0; coordinates are finite and at most %g m.",
                          name, i, (double)v.x, (double)v.y, (double)v.z, (double)FARTHEST);
        }
        for (int c = 0; c < def->channelCount; ++c)
        {
            float value = def->values[(size_t)i * (size_t)def->channelCount + (size_t)c];
            if (!(fabsf(value) <= FARTHEST))
            {
                return swFail(host, SW_ERROR_INVALID,
                              "%s has the value %g at vertex %d, counted from 0; values are finite and at most %g.",
                              name, (double)value, i, (double)FARTHEST);
            }
        }
    }
    return SW_SUCCESS;
}

static swResult checkDef(const swHost* host, const swMeshDef* def, const char* name)
{
    swResult result = swCheckDef(host, &swMeshFields, def);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    for (int i = 0; i < 3 * def->triangleCount; ++i)
    {
        if (def->indices[i] >= (uint32_t)def->vertexCount)
        {
            return swFail(host, SW_ERROR_INVALID, "%s has vertex %u in triangle %d, counted from 0; there are %d.",
                          name, (unsigned)def->indices[i], i / 3, def->vertexCount);
        }
    }
    return checkVertices(host, def, name);
}

// ---- words from outside ----

// Whole numbers up to `most`, none less than the one before where they mount.
static bool areWhole(const float* words, size_t count, size_t most, bool areMounting)
{
    float least = 0.0f;
    for (size_t i = 0; i < count; ++i)
    {
        float word = words[i];
        if (!(word >= least && word <= (float)most && floorf(word) == word))
        {
            return false;
        }
        least = areMounting ? word : least;
    }
    return true;
}

bool swAreMeshWordsGood(const swInputRecord* record, const float* words)
{
    size_t x = record->extra0, z = record->extra1, cells = x * z;
    size_t entry = record->extra3, triangle = record->extra4, count = record->wordCount;
    size_t triangleWords = 9 + 3 * (size_t)record->extra2;
    // Numbers beyond 2^24 are no whole floats, and no mesh has them.
    bool isSized = x >= 1 && z >= 1 && x <= 1u << 24 && z <= 1u << 24 && cells <= 1u << 24 &&
                   record->extra2 <= SW_MAX_MESH_CHANNELS && SW_MESH_HEAD + cells + 1 <= entry && entry <= triangle &&
                   triangle <= count && triangle - entry <= 1u << 24;
    size_t triangles = isSized ? (count - triangle) / triangleWords : 0;
    return triangles >= 1 && triangles <= SW_MAX_MESH_TRIANGLES &&
           areWhole(words + SW_MESH_HEAD, cells + 1, triangle - entry, true) &&
           areWhole(words + entry, triangle - entry, triangles - 1, false);
}

// ---- making ----

// Where the parts of the block lie, in bytes.
typedef struct Layout
{
    size_t vertices, indices, values, words, size;
} Layout;

static size_t roundUp(size_t size)
{
    return (size + 63) & ~(size_t)63;
}

static Layout layOut(const swMeshDef* def, const swMeshGrid* grid, uint32_t* firstEntry, uint32_t* firstTriangle,
                     uint32_t* wordCount)
{
    size_t cells = (size_t)grid->countX * (size_t)grid->countZ;
    size_t triangleWords = (size_t)def->triangleCount * (size_t)(9 + 3 * def->channelCount);
    *firstEntry = (uint32_t)(SW_MESH_HEAD + cells + 1);
    *firstTriangle = (uint32_t)(*firstEntry + grid->entryCount);
    *wordCount = (uint32_t)(*firstTriangle + triangleWords);
    Layout layout;
    layout.vertices = roundUp(sizeof(swMesh));
    layout.indices = layout.vertices + roundUp((size_t)def->vertexCount * sizeof(swVec3));
    layout.values = layout.indices + roundUp((size_t)def->triangleCount * 3 * sizeof(uint32_t));
    layout.words = layout.values + roundUp((size_t)def->vertexCount * (size_t)def->channelCount * sizeof(float));
    layout.size = layout.words + (size_t)*wordCount * sizeof(float);
    return layout;
}

static void findBounds(const swMeshDef* def, swVec3* low, swVec3* high)
{
    *low = *high = def->vertices[def->indices[0]];
    for (int i = 0; i < 3 * def->triangleCount; ++i)
    {
        swVec3 v = def->vertices[def->indices[i]];
        *low = (swVec3){fminf(low->x, v.x), fminf(low->y, v.y), fminf(low->z, v.z)};
        *high = (swVec3){fmaxf(high->x, v.x), fmaxf(high->y, v.y), fmaxf(high->z, v.z)};
    }
}

static void writeTriangles(const swMesh* mesh, float* words)
{
    size_t channels = (size_t)mesh->channelCount;
    for (int i = 0; i < mesh->triangleCount; ++i)
    {
        for (int corner = 0; corner < 3; ++corner)
        {
            uint32_t vertex = mesh->indices[3 * i + corner];
            memcpy(words + 3 * corner, &mesh->vertices[vertex], 3 * sizeof(float));
            for (size_t c = 0; c < channels; ++c)
            {
                words[9 + (size_t)corner * channels + c] = mesh->values[vertex * channels + c];
            }
        }
        words += 9 + 3 * channels;
    }
}

static void hashMesh(swMesh* mesh)
{
    swHash hash = swBeginHash();
    swAddHash(&hash, (uint64_t)mesh->vertexCount << 32 | (uint64_t)mesh->triangleCount);
    swAddHash(&hash, (uint64_t)mesh->channelCount);
    swAddHashDouble(&hash, (double)mesh->highest);
    swAddHashFloats(&hash, &mesh->vertices[0].x, 3 * (size_t)mesh->vertexCount);
    for (int i = 0; i < 3 * mesh->triangleCount; ++i)
    {
        swAddHash(&hash, mesh->indices[i]);
    }
    if (mesh->values != NULL)
    {
        swAddHashFloats(&hash, mesh->values, (size_t)mesh->vertexCount * (size_t)mesh->channelCount);
    }
    mesh->hash = swEndHash(&hash);
}

static float findLargest(const swMeshDef* def)
{
    size_t count = (size_t)def->vertexCount * (size_t)def->channelCount;
    float largest = count > 0 ? 0.0f : 1.0f;
    for (size_t i = 0; i < count; ++i)
    {
        largest = fmaxf(largest, fabsf(def->values[i]));
    }
    return largest;
}

static void fillMesh(swMesh* mesh, const swMeshDef* def, const swMeshGrid* grid, const Layout* layout)
{
    char* block = (char*)mesh;
    float* words = (float*)(void*)(block + layout->words);
    mesh->vertices = memcpy(block + layout->vertices, def->vertices, (size_t)def->vertexCount * sizeof(swVec3));
    mesh->indices = memcpy(block + layout->indices, def->indices, (size_t)def->triangleCount * 3 * sizeof(uint32_t));
    if (def->channelCount > 0)
    {
        mesh->values = memcpy(block + layout->values, def->values,
                              (size_t)def->vertexCount * (size_t)def->channelCount * sizeof(float));
    }
    words[0] = (float)grid->x;
    words[1] = (float)grid->z;
    words[2] = (float)grid->side;
    words[3] = mesh->highest;
    swFillMeshGrid(mesh->vertices, mesh->indices, mesh->triangleCount, mesh->highest, grid, words + SW_MESH_HEAD,
                   words + mesh->firstEntry);
    writeTriangles(mesh, words + mesh->firstTriangle);
    mesh->words = words;
    hashMesh(mesh);
}

swResult swCreateMesh(const swHost* host, const swMeshDef* def, swMesh** mesh)
{
    SW_REQUIRE_PLACE(host, mesh, "swCreateMesh()");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE && def->vertices != NULL && def->indices != NULL &&
                   def->vertexCount > 0 && def->triangleCount > 0 && def->triangleCount <= SW_MAX_MESH_TRIANGLES &&
                   def->vertexCount <= 3 * SW_MAX_MESH_TRIANGLES,
               SW_ERROR_INVALID, host,
               "swCreateMesh() needs a def made by swDefaultMeshDef(), vertices, and 1 to %d triangles",
               SW_MAX_MESH_TRIANGLES);
    SW_REQUIRE(def->channelCount >= 0 && def->channelCount <= SW_MAX_MESH_CHANNELS &&
                   (def->channelCount == 0 || def->values != NULL),
               SW_ERROR_INVALID, host, "swMeshDef::channelCount is %d; it is at most %d, and above 0 with values",
               def->channelCount, SW_MAX_MESH_CHANNELS);
    const char* name = def->name != NULL ? def->name : "mesh";
    swResult result = checkDef(host, def, name);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swVec3 low, high;
    swMeshGrid grid;
    findBounds(def, &low, &high);
    if (!swPlanMeshGrid(def->vertices, def->indices, def->triangleCount, def->highest, low, high, &grid))
    {
        return swFail(host, SW_ERROR_LIMIT, "%s has too many triangles above each other; take a simpler mesh.", name);
    }
    swMesh head = {.host = *host,
                   .users = 1,
                   .low = low,
                   .high = high,
                   .highest = def->highest,
                   .largest = findLargest(def),
                   .vertexCount = def->vertexCount,
                   .triangleCount = def->triangleCount,
                   .channelCount = def->channelCount,
                   .countX = grid.countX,
                   .countZ = grid.countZ};
    Layout layout = layOut(def, &grid, &head.firstEntry, &head.firstTriangle, &head.wordCount);
    head.memory = layout.size;
    swMesh* made = swAllocateZero(host, layout.size);
    if (made == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory for %s, %zu bytes.", name, layout.size);
    }
    memcpy(made, &head, sizeof(head));
    strncpy(made->name, name, sizeof(made->name) - 1);
    fillMesh(made, def, &grid, &layout);
    *mesh = made;
    return SW_SUCCESS;
}

// ---- users ----

// A mesh that inputs name is const, and its count of users is all that changes of it.
static swMesh* getCounted(const swMesh* mesh)
{
    union
    {
        const swMesh* given;
        swMesh* counted;
    } same = {.given = mesh};
    return same.counted;
}

void swHoldMesh(const swMesh* mesh)
{
    if (mesh != NULL)
    {
        getCounted(mesh)->users += 1;
    }
}

void swReleaseMesh(const swMesh* mesh)
{
    if (mesh != NULL && --getCounted(mesh)->users == 0)
    {
        swHost host = mesh->host;
        swFree(&host, getCounted(mesh), mesh->memory);
    }
}

void swDestroyMesh(swMesh* mesh)
{
    swReleaseMesh(mesh);
}

// ---- asking ----

swMeshInfo swMesh_GetInfo(const swMesh* mesh)
{
    SW_REQUIRE(mesh != NULL, ((swMeshInfo){.name = ""}), NULL, "swMesh_GetInfo() needs a mesh");
    return (swMeshInfo){.name = mesh->name,
                        .low = mesh->low,
                        .high = mesh->high,
                        .highest = mesh->highest,
                        .vertexCount = mesh->vertexCount,
                        .triangleCount = mesh->triangleCount,
                        .channelCount = mesh->channelCount,
                        .memory = mesh->memory,
                        .hash = mesh->hash};
}

const swVec3* swMesh_GetVertices(const swMesh* mesh)
{
    SW_REQUIRE(mesh != NULL, NULL, NULL, "swMesh_GetVertices() needs a mesh");
    return mesh->vertices;
}

const uint32_t* swMesh_GetIndices(const swMesh* mesh)
{
    SW_REQUIRE(mesh != NULL, NULL, NULL, "swMesh_GetIndices() needs a mesh");
    return mesh->indices;
}

const float* swMesh_GetValues(const swMesh* mesh)
{
    SW_REQUIRE(mesh != NULL, NULL, NULL, "swMesh_GetValues() needs a mesh");
    return mesh->values;
}

void swDescribeMesh(const swMesh* mesh, swInputRecord* record)
{
    record->extra0 = (sw_uint)mesh->countX;
    record->extra1 = (sw_uint)mesh->countZ;
    record->extra2 = (sw_uint)mesh->channelCount;
    record->extra3 = mesh->firstEntry;
    record->extra4 = mesh->firstTriangle;
    record->middleX = 0.5f * (mesh->low.x + mesh->high.x);
    record->middleZ = 0.5f * (mesh->low.z + mesh->high.z);
    record->halfX = 0.5f * (mesh->high.x - mesh->low.x);
    record->halfZ = 0.5f * (mesh->high.z - mesh->low.z);
}

void swMesh_Sample(const swMesh* mesh, int count, const swVec2* points, float* heights)
{
    SW_REQUIRE_VOID(mesh != NULL && count >= 0 && (count == 0 || (points != NULL && heights != NULL)),
                    mesh != NULL ? &mesh->host : NULL,
                    "swMesh_Sample() needs a mesh, points and a place for their heights");
    swInputRecord record = {.field = SW_FIELD_OF_FLOOR};
    swDescribeMesh(mesh, &record);
    for (int i = 0; i < count; ++i)
    {
        swMeshHit hit = swFindOnMesh(mesh->words, record, points[i].x, points[i].y);
        heights[i] = hit.at != SW_NO_MESH ? hit.height.value : NAN;
    }
}
