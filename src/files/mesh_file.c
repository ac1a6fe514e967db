// SPDX-License-Identifier: MIT
// Meshes in files, by way of Assimp's C interface: all triangles of a scene, each where its node puts it.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/host.h"
#include "core/base/misuse.h"
#include "files/file_text.h"
#include "files/polygon_ears.h"
#include "seaway/files.h"

swMeshFileDef swDefaultMeshFileDef(void)
{
    return (swMeshFileDef){.scale = 1.0f, .highest = 1e6f, .internalValue = SW_DEF_COOKIE};
}

#if SW_HAS_ASSIMP
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

typedef struct MeshFile
{
    const swHost* host;
    const char* path;
    const swMeshFileDef* def;
    const struct aiScene* scene;
    int vertexCount, triangleCount, channelCount;
    size_t verticesSize, indicesSize, valuesSize;
    swVec3* vertices;
    uint32_t* indices;
    float* values;
    int crossedCount; // faces of more than three corners that cannot be divided for sure
} MeshFile;

static bool endsWith(const char* path, const char* end)
{
    size_t size = strlen(path), endSize = strlen(end), k = 0;
    while (size >= endSize && k < endSize)
    {
        char c = path[size - endSize + k];
        c = c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
        if (c != end[k])
        {
            break;
        }
        ++k;
    }
    return size >= endSize && k == endSize;
}

// What Assimp takes a file for depends on its name, so only such names are passed on.
static bool hasKnownName(const char* path)
{
    static const char* const ends[] = {".obj", ".gltf", ".glb", ".stl", ".ply"};
    bool isKnown = false;
    for (size_t i = 0; i < sizeof(ends) / sizeof(ends[0]); ++i)
    {
        isKnown = isKnown || endsWith(path, ends[i]);
    }
    return isKnown;
}

#define MOST_PLY_HEADING 65536

// A PLY's heading is lines of these words up to one that is end_header alone. Assimp 5 does not come to an end with
// others.
static bool isPlyHeading(const char* text)
{
    static const char* const words[] = {"ply", "format ", "comment", "obj_info", "element ", "property "};
    while (*text != '\0')
    {
        size_t size = strcspn(text, "\r\n");
        if (size == strlen("end_header") && strncmp(text, "end_header", size) == 0)
        {
            return true;
        }
        bool isKnown = size == 0;
        for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); ++i)
        {
            isKnown = isKnown || strncmp(text, words[i], strlen(words[i])) == 0;
        }
        if (!isKnown)
        {
            return false;
        }
        text += size;
        text += strspn(text, "\r\n");
    }
    return false;
}

static swResult checkPly(const swHost* host, const char* path)
{
    char* text = swAllocate(host, MOST_PLY_HEADING);
    FILE* file = text != NULL ? fopen(path, "rb") : NULL;
    size_t size = file != NULL ? fread(text, 1, MOST_PLY_HEADING - 1, file) : 0;
    if (file != NULL)
    {
        fclose(file);
    }
    if (text == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", path);
    }
    text[size] = '\0';
    bool isFine = isPlyHeading(text);
    swFree(host, text, MOST_PLY_HEADING);
    return isFine ? SW_SUCCESS
                  : swFail(host, SW_ERROR_FORMAT,
                           "%s has no heading of a PLY file: lines of format, element and property, and one that is "
                           "end_header alone. Export it anew.",
                           path);
}

static const struct aiScene* import(const char* path)
{
    struct aiPropertyStore* properties = aiCreatePropertyStore();
    if (properties == NULL)
    {
        return NULL;
    }
    aiSetImportPropertyInteger(properties, AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const struct aiScene* scene = aiImportFileExWithProperties(
        path, aiProcess_SortByPType | aiProcess_PreTransformVertices | aiProcess_ValidateDataStructure, NULL,
        properties);
    aiReleasePropertyStore(properties);
    return scene;
}

// Assimp's own triangles of concave faces may lie outside of them.
static swResult countTriangles(const MeshFile* file, const struct aiMesh* mesh, size_t* triangles)
{
    for (unsigned i = 0; i < mesh->mNumFaces; ++i)
    {
        const struct aiFace* face = &mesh->mFaces[i];
        if (face->mNumIndices > SW_MAX_FACE_CORNERS)
        {
            return swFail(file->host, SW_ERROR_LIMIT, "%s has a face of %u corners; at most %d are read. Divide it.",
                          file->path, face->mNumIndices, SW_MAX_FACE_CORNERS);
        }
        bool isFace = face->mNumIndices >= 3;
        for (unsigned k = 0; k < face->mNumIndices; ++k)
        {
            isFace = isFace && face->mIndices[k] < mesh->mNumVertices;
        }
        if (!isFace)
        {
            return swFail(file->host, SW_ERROR_FORMAT, "%s has a face %u that is not made of its vertices.", file->path,
                          i);
        }
        *triangles += face->mNumIndices - 2;
    }
    return SW_SUCCESS;
}

static swResult count(MeshFile* file)
{
    size_t vertices = 0, triangles = 0;
    bool hasColors = file->scene->mNumMeshes > 0;
    for (unsigned i = 0; i < file->scene->mNumMeshes; ++i)
    {
        const struct aiMesh* mesh = file->scene->mMeshes[i];
        vertices += mesh->mNumVertices;
        hasColors = hasColors && mesh->mColors[0] != NULL;
        swResult result = countTriangles(file, mesh, &triangles);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    if (triangles == 0 || vertices == 0)
    {
        return swFail(file->host, SW_ERROR_FORMAT, "%s holds no triangles.", file->path);
    }
    if (triangles > SW_MAX_MESH_TRIANGLES || vertices > 3 * SW_MAX_MESH_TRIANGLES)
    {
        return swFail(file->host, SW_ERROR_LIMIT, "%s has %zu triangles; at most %d are read. Take a simpler mesh.",
                      file->path, triangles, SW_MAX_MESH_TRIANGLES);
    }
    file->vertexCount = (int)vertices;
    file->triangleCount = (int)triangles;
    file->channelCount = hasColors ? 4 : 0;
    return SW_SUCCESS;
}

static swVec3 place(const MeshFile* file, struct aiVector3D v)
{
    float scale = file->def->scale;
    bool isZUp = file->def->up == SW_MESH_Z_UP;
    return isZUp ? (swVec3){scale * v.x, scale * v.z, -scale * v.y} : (swVec3){scale * v.x, scale * v.y, scale * v.z};
}

// The triangles of a face. Returns where the next ones go.
static uint32_t* keepFace(MeshFile* file, const struct aiFace* face, uint32_t firstVertex, uint32_t* indices)
{
    int corners = (int)face->mNumIndices;
    if (corners == 3)
    {
        for (int k = 0; k < 3; ++k)
        {
            indices[k] = firstVertex + face->mIndices[k];
        }
        return indices + 3;
    }
    swVec3 places[SW_MAX_FACE_CORNERS];
    for (int k = 0; k < corners; ++k)
    {
        places[k] = file->vertices[firstVertex + face->mIndices[k]];
    }
    file->crossedCount += !swDivideFace(corners, places, indices);
    for (int k = 0; k < 3 * (corners - 2); ++k)
    {
        indices[k] = firstVertex + face->mIndices[indices[k]];
    }
    return indices + 3 * (corners - 2);
}

static void keepMeshes(MeshFile* file)
{
    uint32_t vertex = 0;
    uint32_t* indices = file->indices;
    for (unsigned i = 0; i < file->scene->mNumMeshes; ++i)
    {
        const struct aiMesh* mesh = file->scene->mMeshes[i];
        for (unsigned k = 0; k < mesh->mNumVertices; ++k)
        {
            file->vertices[vertex + k] = place(file, mesh->mVertices[k]);
            if (file->channelCount > 0)
            {
                struct aiColor4D c = mesh->mColors[0][k];
                memcpy(file->values + 4 * (size_t)(vertex + k), (float[]){c.r, c.g, c.b, c.a}, 4 * sizeof(float));
            }
        }
        for (unsigned k = 0; k < mesh->mNumFaces; ++k)
        {
            indices = keepFace(file, &mesh->mFaces[k], vertex, indices);
        }
        vertex += mesh->mNumVertices;
    }
    if (file->crossedCount > 0)
    {
        swLog(file->host, SW_LOG_WARNING,
              "%s has %d faces of more than three corners that cross themselves or have no area; what they cover is a "
              "guess. Divide them into triangles.",
              file->path, file->crossedCount);
    }
}

static swResult make(MeshFile* file, swMesh** mesh)
{
    file->verticesSize = (size_t)file->vertexCount * sizeof(swVec3);
    file->indicesSize = (size_t)file->triangleCount * 3 * sizeof(uint32_t);
    file->valuesSize = (size_t)file->vertexCount * 4 * sizeof(float);
    file->vertices = swAllocate(file->host, file->verticesSize);
    file->indices = swAllocate(file->host, file->indicesSize);
    file->values = file->channelCount > 0 ? swAllocate(file->host, file->valuesSize) : NULL;
    if (file->vertices == NULL || file->indices == NULL || (file->channelCount > 0 && file->values == NULL))
    {
        return swFail(file->host, SW_ERROR_NO_MEMORY, "No memory for the triangles of %s.", file->path);
    }
    keepMeshes(file);
    swMeshDef def = swDefaultMeshDef();
    def.name = file->path;
    def.highest = file->def->highest;
    def.vertices = file->vertices;
    def.vertexCount = file->vertexCount;
    def.indices = file->indices;
    def.triangleCount = file->triangleCount;
    def.values = file->values;
    def.channelCount = file->channelCount;
    swResult result = swCreateMesh(file->host, &def, mesh);
    return result == SW_ERROR_INVALID ? SW_ERROR_FORMAT : result;
}

static swResult readMesh(const swHost* host, const char* path, const swMeshFileDef* def, swMesh** mesh)
{
    if (swIsDevice(path) || !swHasFile(path))
    {
        return swFail(host, SW_ERROR_FILE, "Cannot read %s: there is no such file.", path);
    }
    if (!hasKnownName(path))
    {
        return swFail(host, SW_ERROR_UNSUPPORTED, "%s is no mesh by its name; those end in obj, gltf, glb, stl or ply.",
                      path);
    }
    swResult result = endsWith(path, ".ply") ? checkPly(host, path) : SW_SUCCESS;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    MeshFile file = {.host = host, .path = path, .def = def, .scene = import(path)};
    if (file.scene == NULL)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s cannot be read as a mesh: %s", path, aiGetErrorString());
    }
    result = count(&file);
    result = result != SW_SUCCESS ? result : make(&file, mesh);
    swFree(host, file.vertices, file.verticesSize);
    swFree(host, file.indices, file.indicesSize);
    swFree(host, file.values, file.valuesSize);
    aiReleaseImport(file.scene);
    return result;
}
#else
static swResult readMesh(const swHost* host, const char* path, const swMeshFileDef* def, swMesh** mesh)
{
    (void)def;
    (void)mesh;
    return swFail(host, SW_ERROR_UNSUPPORTED,
                  "%s is a mesh, which this build does not read: configure with libassimp-dev installed.", path);
}
#endif

swResult swReadMesh(const swHost* host, const char* path, const swMeshFileDef* def, swMesh** mesh)
{
    SW_REQUIRE_PLACE(host, mesh, "swReadMesh()");
    swMeshFileDef usual = swDefaultMeshFileDef();
    def = def != NULL ? def : &usual;
    SW_REQUIRE(path != NULL && def->internalValue == SW_DEF_COOKIE, SW_ERROR_INVALID, host,
               "swReadMesh() needs a path, and a def made by swDefaultMeshFileDef()");
    SW_REQUIRE((unsigned)def->up < SW_MESH_UP_COUNT, SW_ERROR_INVALID, host, "swMeshFileDef::up is %d; there are %d",
               (int)def->up, SW_MESH_UP_COUNT);
    SW_REQUIRE(def->scale >= 1e-6f && def->scale <= 1e6f, SW_ERROR_INVALID, host,
               "swMeshFileDef::scale is %g; its range is [1e-6, 1e6]", (double)def->scale);
    SW_REQUIRE(fabsf(def->highest) <= 1e6f, SW_ERROR_INVALID, host,
               "swMeshFileDef::highest is %g; its range is [-1e6, 1e6]", (double)def->highest);
    return readMesh(host, path, def, mesh);
}
