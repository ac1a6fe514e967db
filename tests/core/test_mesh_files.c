// SPDX-License-Identifier: MIT
// Meshes in files: made here, and real ones where they are there.
#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <seaway/files.h>

#define MESHES SW_SOURCE_DIR "/../shared/data/meshes/"

static char s_path[64];

static void Write(const char* end, const char* text)
{
    snprintf(s_path, sizeof(s_path), "mesh_%ld.%s", (long)getpid(), end);
    FILE* file = fopen(s_path, "wb");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static swMesh* ReadAt(const char* path, const swMeshFileDef* def)
{
    swHost host = MakeHost();
    swMesh* mesh = NULL;
    if (swReadMesh(&host, path, def, &mesh) != SW_SUCCESS)
    {
        remove(s_path);
        fail_msg("%s", s_messages);
    }
    return mesh;
}

static swMesh* Read(const swMeshFileDef* def)
{
    swMesh* mesh = ReadAt(s_path, def);
    remove(s_path);
    return mesh;
}

static void CheckRefused(const swMeshFileDef* def, swResult expected, const char* words)
{
    swHost host = MakeHost();
    swMesh* mesh = NULL;
    swResult result = swReadMesh(&host, s_path, def, &mesh);
    remove(s_path);
    assert_int_equal(result, expected);
    assert_null(mesh);
    if (strstr(s_messages, words) == NULL)
    {
        fail_msg("\"%s\" does not say \"%s\"", s_messages, words);
    }
}

static float HeightAt(const swMesh* mesh, float x, float z)
{
    float height = 0.0f;
    swMesh_Sample(mesh, 1, &(swVec2){x, z}, &height);
    return height;
}

// A quay as a quad, and a triangle beside it.
static const char Quay[] = "# a quay\nv 0 2 0\nv 10 2 0\nv 10 2 5\nv 0 2 5\nv 20 4 0\nf 1 2 3 4\nf 2 5 3\n";

static void ObjIsReadAsTriangles(void** state)
{
    (void)state;
    Write("obj", Quay);
    swMesh* mesh = Read(NULL);
    swMeshInfo info = swMesh_GetInfo(mesh);
    assert_true(info.triangleCount == 3 && info.channelCount == 0);
    assert_true(HeightAt(mesh, 5.0f, 2.0f) == 2.0f && fabsf(HeightAt(mesh, 15.0f, 0.0f) - 3.0f) < 1e-6f);
    swDestroyMesh(mesh);
}

// Whether a point lies inside of a polygon.
static bool IsInside(int count, const swVec2* polygon, float x, float z)
{
    bool isInside = false;
    for (int i = 0; i < count; ++i)
    {
        swVec2 a = polygon[i], b = polygon[(i + 1) % count];
        if ((a.y > z) != (b.y > z) && x < (b.x - a.x) * (z - a.y) / (b.y - a.y) + a.x)
        {
            isInside = !isInside;
        }
    }
    return isInside;
}

// One face, flat, upright or tilted, is read as what it encloses: seen from above, whichever corner comes first and
// whichever way it turns.
static void CheckFace(int count, const swVec2* polygon, float slope)
{
    for (int way = 0; way < 2 * count; ++way)
    {
        char text[8192] = "", faces[2048] = "f";
        for (int i = 0; i < count; ++i)
        {
            int from = (way / 2 + i) % count;
            swVec2 p = polygon[way % 2 == 0 ? from : count - 1 - from];
            snprintf(text + strlen(text), 64, "v %.9g %.9g %.9g\n", (double)p.x, (double)(slope * p.x), (double)p.y);
            snprintf(faces + strlen(faces), 16, " %d", i + 1);
        }
        strcat(strcat(text, faces), "\n");
        Write("obj", text);
        swMesh* mesh = Read(NULL);
        assert_string_equal(s_messages, "");
        assert_int_equal(swMesh_GetInfo(mesh).triangleCount, count - 2);
        for (int i = 0; i < 2500; ++i)
        {
            float x = -13.0f + 0.613f * (float)(i % 50), z = -13.0f + 0.617f * (float)(i / 50);
            float height = HeightAt(mesh, x, z);
            if (isnan(height) == IsInside(count, polygon, x, z) ||
                (!isnan(height) && fabsf(height - slope * x) > 1e-4f))
            {
                fail_msg("way %d: %g at %g, %g", way, (double)height, (double)x, (double)z);
            }
        }
        swDestroyMesh(mesh);
    }
}

static void ConcaveFacesAreWhatTheyEnclose(void** state)
{
    (void)state;
    const swVec2 corner[] = {{0, 0}, {12, 0}, {12, 6}, {6, 6}, {6, 12}, {0, 12}};
    const swVec2 arrow[] = {{0, 0}, {10, 5}, {0, 10}, {3, 5}};
    const swVec2 docks[] = {{-12, -3}, {12, -3}, {12, 10}, {8, 10}, {8, 0},   {4, 0},
                            {4, 10},   {0, 10},  {0, 0},   {-4, 0}, {-4, 10}, {-12, 10}};
    swVec2 star[24];
    for (int i = 0; i < 24; ++i)
    {
        float angle = 6.2831853f * (float)i / 24.0f, radius = i % 2 == 0 ? 11.0f : 3.0f + 0.2f * (float)i;
        star[i] = (swVec2){radius * cosf(angle), radius * sinf(angle)};
    }
    CheckFace(6, corner, 0.0f);
    CheckFace(6, corner, -3.0f);
    CheckFace(4, arrow, 0.5f);
    CheckFace(12, docks, 0.1f);
    CheckFace(24, star, 0.0f);
}

static void FacesThatCannotBeDividedAreTold(void** state)
{
    (void)state;
    Write("obj", "v 0 1 0\nv 9 1 9\nv 9 1 0\nv 3 1 7\nv 0 1 12\nf 1 2 3 4 5\n");
    swMesh* mesh = Read(NULL);
    assert_non_null(strstr(s_messages, "has 1 faces of more than three corners that cross themselves"));
    assert_int_equal(swMesh_GetInfo(mesh).triangleCount, 3);
    swDestroyMesh(mesh);
    static char text[1 << 18];
    static char faces[1 << 16] = "f";
    size_t size = 0, facesSize = 1;
    for (int i = 0; i < 2049; ++i)
    {
        double angle = 6.2831853 * i / 2049.0;
        size += (size_t)snprintf(text + size, 64, "v %.6f 0 %.6f\n", 100.0 * cos(angle), 100.0 * sin(angle));
        facesSize += (size_t)snprintf(faces + facesSize, 16, " %d", i + 1);
    }
    snprintf(text + size, sizeof(text) - size, "%s\n", faces);
    Write("obj", text);
    CheckRefused(NULL, SW_ERROR_LIMIT, "a face of 2049 corners");
}

static void AxesAndLengthsAreTurned(void** state)
{
    (void)state;
    Write("stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 300\nvertex 1000 0 300\nvertex 0 2000 500\n"
                 "endloop\nendfacet\nendsolid s\n");
    swMeshFileDef def = swDefaultMeshFileDef();
    def.up = SW_MESH_Z_UP; // a drawing in centimetres
    def.scale = 0.01f;
    swMesh* mesh = Read(&def);
    swMeshInfo info = swMesh_GetInfo(mesh);
    assert_true(fabsf(info.high.x - 10.0f) < 1e-5f && fabsf(info.low.z + 20.0f) < 1e-5f);
    assert_float_equal(HeightAt(mesh, 1.0f, -10.0f), 4.0f, 1e-5f);
    swDestroyMesh(mesh);
}

static void NodesPutMeshesInTheirPlaces(void** state)
{
    (void)state;
    // One triangle, twice as large, 100 m to the east and 7 m lower. The buffer: three positions.
    Write(
        "gltf",
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,"
        "\"translation\":[100,-7,0],\"scale\":[2,2,2]}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}"
        "]}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],"
        "\"max\":[1,0,1]}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"buffers\":[{\"byteLength\":36,\"uri\":"
        "\"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAAAAAIA/\"}]}");
    swMesh* mesh = Read(NULL);
    swMeshInfo info = swMesh_GetInfo(mesh);
    assert_true(info.low.x == 100.0f && info.high.x == 102.0f && info.high.z == 2.0f);
    assert_float_equal(HeightAt(mesh, 100.5f, 0.5f), -7.0f, 1e-6f);
    swDestroyMesh(mesh);
}

static void ColoursOfCornersAreValues(void** state)
{
    (void)state;
    Write("ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty "
          "uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nelement face 1\nproperty "
          "list uchar int vertex_indices\nend_header\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 0 1 0 0 255 51\n3 0 1 "
          "2\n");
    swMesh* mesh = Read(NULL);
    assert_int_equal(swMesh_GetInfo(mesh).channelCount, 4);
    const float* values = swMesh_GetValues(mesh);
    float sum = 0.0f;
    for (int i = 0; i < 12; ++i)
    {
        sum += values[i];
    }
    assert_float_equal(sum, 5.2f, 1e-4f); // three colours, covers of 1, 1 and 0.2
    swDestroyMesh(mesh);
}

// Assimp comes to no end with some of them.
static void HeadingsOfPlyAreLookedAt(void** state)
{
    (void)state;
    static const char vertices[] = "0 1 0\n9 1 0\n0 1 9\n3 0 1 2\n";
    static const char heading[] = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\nproperty float x\n"
                                  "property float y\nproperty float z\nelement face 1\n"
                                  "property list uchar int vertex_indices\nend_header";
    char text[1024];
    snprintf(text, sizeof(text), "%s\n%s", heading, vertices);
    Write("ply", text);
    swMesh* mesh = Read(NULL);
    assert_true(HeightAt(mesh, 1.0f, 1.0f) == 1.0f);
    swDestroyMesh(mesh);
    snprintf(text, sizeof(text), "%s%s", heading, vertices); // the last line runs on
    Write("ply", text);
    CheckRefused(NULL, SW_ERROR_FORMAT, "has no heading of a PLY file");
    snprintf(text, sizeof(text), "%.60s", heading);
    Write("ply", text);
    CheckRefused(NULL, SW_ERROR_FORMAT, "has no heading of a PLY file");
}

static void BadMeshFilesAreNamed(void** state)
{
    (void)state;
    snprintf(s_path, sizeof(s_path), "no_such_mesh.obj");
    CheckRefused(NULL, SW_ERROR_FILE, "no_such_mesh.obj: there is no such file");
    Write("txt", Quay);
    CheckRefused(NULL, SW_ERROR_UNSUPPORTED, "no mesh by its name");
    Write("obj", "nothing at all\n");
    CheckRefused(NULL, SW_ERROR_FORMAT, "cannot be read as a mesh");
    Write("obj", "v 0 0 0\nv 1 0 0\nv 0 nan 1\nf 1 2 3\n");
    CheckRefused(NULL, SW_ERROR_FORMAT, "");
    Write("gltf", "{\"asset\":{\"version\":\"2.0\"}");
    CheckRefused(NULL, SW_ERROR_FORMAT, "cannot be read as a mesh");
    Write("obj", "v 0 0 0\nv 1e7 0 0\nv 0 0 1\nf 1 2 3\n");
    CheckRefused(NULL, SW_ERROR_FORMAT, "has vertex");
#ifdef NDEBUG // misuse: where asserts are on, the program stops
    Write("obj", Quay);
    swMeshFileDef def = swDefaultMeshFileDef();
    def.scale = 0.0f;
    CheckRefused(&def, SW_ERROR_INVALID, "scale is 0");
    def = swDefaultMeshFileDef();
    def.up = SW_MESH_UP_COUNT;
    Write("obj", Quay);
    CheckRefused(&def, SW_ERROR_INVALID, "up is 2");
#endif
}

static void RealMeshesAreRead(void** state)
{
    (void)state;
    const struct
    {
        const char* path;
        swMeshUp up;
        float width, height; // of the bounds along x and y, m
        float slack;
    } files[] = {
        {"oes_sphere/oes_task10_sphere.obj", SW_MESH_Z_UP, 10.0f, 10.0f, 0.1f},
        {"wecsim_rm3/float.stl", SW_MESH_Z_UP, 20.0f, 5.0f, 1.0f},
        {"quaternius_ships/Viking_boat.glb", SW_MESH_Y_UP, 0.0f, 0.0f, 0.0f},
        {"vrx/wamv_base.glb", SW_MESH_Y_UP, 0.0f, 0.0f, 0.0f},
        {"kaykit_props/barrel.gltf", SW_MESH_Y_UP, 0.0f, 0.0f, 0.0f},
    };
    for (size_t i = 0; i < sizeof(files) / sizeof(files[0]); ++i)
    {
        char path[512];
        snprintf(path, sizeof(path), "%s%s", MESHES, files[i].path);
        if (access(path, R_OK) != 0)
        {
            print_message("%s is not here\n", path);
            continue;
        }
        swMeshFileDef def = swDefaultMeshFileDef();
        def.up = files[i].up;
        swMesh* mesh = ReadAt(path, &def);
        swMeshInfo info = swMesh_GetInfo(mesh);
        print_message("%s: %d triangles, %.2f x %.2f x %.2f m\n", files[i].path, info.triangleCount,
                      (double)(info.high.x - info.low.x), (double)(info.high.y - info.low.y),
                      (double)(info.high.z - info.low.z));
        assert_true(files[i].slack == 0.0f || (fabsf(info.high.x - info.low.x - files[i].width) < files[i].slack &&
                                               fabsf(info.high.y - info.low.y - files[i].height) < files[i].slack));
        float middleX = 0.5f * (info.low.x + info.high.x), middleZ = 0.5f * (info.low.z + info.high.z);
        float top = HeightAt(mesh, middleX + 1e-3f, middleZ + 2e-3f);
        assert_true(isnan(top) || (top >= info.low.y && top <= info.high.y));
        swDestroyMesh(mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ObjIsReadAsTriangles),
        cmocka_unit_test(ConcaveFacesAreWhatTheyEnclose),
        cmocka_unit_test(FacesThatCannotBeDividedAreTold),
        cmocka_unit_test(AxesAndLengthsAreTurned),
        cmocka_unit_test(NodesPutMeshesInTheirPlaces),
        cmocka_unit_test(ColoursOfCornersAreValues),
        cmocka_unit_test(BadMeshFilesAreNamed),
        cmocka_unit_test(HeadingsOfPlyAreLookedAt),
        cmocka_unit_test(RealMeshesAreRead),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
