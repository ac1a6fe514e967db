// SPDX-License-Identifier: MIT
// What Assimp may hand to the reader of meshes: scenes of any meshes, faces and colours, or none. Assimp's own readers
// are left to those who write them: here its import is replaced by one that makes a scene of bytes.

#include "fuzz_bytes.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#define MESHES 3
#define VERTICES 12
#define FACES 12
#define CORNERS 9 // of a face, at most

typedef struct MadeScene
{
    struct aiScene scene;
    struct aiMesh meshes[MESHES];
    struct aiMesh* meshList[MESHES];
    struct aiVector3D vertices[MESHES][VERTICES];
    struct aiColor4D colors[MESHES][VERTICES];
    struct aiFace faces[MESHES][FACES];
    unsigned indices[MESHES][FACES][CORNERS];
} MadeScene;

static MadeScene s_made;
static bool s_isRead;

static const struct aiScene* MakeImport(const char* path, unsigned flags, struct aiFileIO* io,
                                        const struct aiPropertyStore* properties)
{
    (void)path;
    (void)flags;
    (void)io;
    (void)properties;
    return s_isRead ? &s_made.scene : NULL;
}

static void ReleaseImport(const struct aiScene* scene)
{
    (void)scene;
}

#define aiImportFileExWithProperties MakeImport
#define aiReleaseImport ReleaseImport
#include "files/mesh_file.c"

static void TakeScene(Bytes* bytes)
{
    memset(&s_made, 0, sizeof s_made);
    s_isRead = TakeByte(bytes) % 16 != 15;
    s_made.scene.mNumMeshes = (unsigned)TakeChoice(bytes, MESHES + 1);
    s_made.scene.mMeshes = s_made.scene.mNumMeshes > 0 ? s_made.meshList : NULL;
    for (unsigned i = 0; i < s_made.scene.mNumMeshes; ++i)
    {
        struct aiMesh* mesh = s_made.meshList[i] = &s_made.meshes[i];
        int kind = TakeByte(bytes);
        mesh->mNumVertices = (unsigned)TakeChoice(bytes, VERTICES + 1);
        mesh->mNumFaces = (unsigned)TakeChoice(bytes, FACES + 1);
        mesh->mVertices = mesh->mNumVertices > 0 ? s_made.vertices[i] : NULL;
        mesh->mFaces = mesh->mNumFaces > 0 ? s_made.faces[i] : NULL;
        mesh->mColors[0] = kind % 2 == 1 ? s_made.colors[i] : NULL;
        for (unsigned k = 0; k < mesh->mNumVertices; ++k)
        {
            s_made.vertices[i][k] = (struct aiVector3D){TakeNumber(bytes), TakeNumber(bytes), TakeNumber(bytes)};
            s_made.colors[i][k] = (struct aiColor4D){TakeNumber(bytes), 0.5f, 0.0f, 1.0f};
        }
        for (unsigned k = 0; k < mesh->mNumFaces; ++k)
        {
            struct aiFace* face = &s_made.faces[i][k];
            int size = TakeByte(bytes);
            face->mNumIndices = size < 160 ? 3 : (unsigned)size % (CORNERS + 1);
            face->mIndices = face->mNumIndices > 0 ? s_made.indices[i][k] : NULL;
            for (int corner = 0; corner < CORNERS; ++corner)
            {
                s_made.indices[i][k][corner] = (unsigned)TakeByte(bytes) % (VERTICES + 1);
            }
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    Bytes bytes = {data, size, 0};
    int messages = 0;
    swHost host = swDefaultHost();
    host.log = CountMessage;
    host.logContext = &messages;
    swMeshFileDef def = swDefaultMeshFileDef();
    def.up = (swMeshUp)TakeChoice(&bytes, SW_MESH_UP_COUNT);
    TakeScene(&bytes);
    // Any file that is there, by a name that a mesh has.
    static const char path[] = "/tmp/fuzz_mesh_file.obj";
    FILE* file = fopen(path, "wb");
    FUZZ_CHECK(file != NULL);
    fclose(file);
    swMesh* mesh = NULL;
    swResult result = swReadMesh(&host, path, &def, &mesh);
    FUZZ_CHECK((result == SW_SUCCESS) == (mesh != NULL));
    FUZZ_CHECK(result == SW_SUCCESS || messages > 0);
    if (mesh != NULL)
    {
        swMeshInfo info = swMesh_GetInfo(mesh);
        for (int i = 0; i < info.vertexCount; ++i)
        {
            swVec3 v = swMesh_GetVertices(mesh)[i];
            FUZZ_CHECK(isfinite(v.x) && isfinite(v.y) && isfinite(v.z));
            FUZZ_CHECK(info.channelCount == 0 || isfinite(swMesh_GetValues(mesh)[i * info.channelCount]));
        }
    }
    swDestroyMesh(mesh);
    return 0;
}
