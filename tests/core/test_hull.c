// SPDX-License-Identifier: MIT
#include "support/cmocka_setup.h"
#include "support/counting_host.h"
#include "support/hull_meshes.h"
#include "support/messages.h"
#include "support/scatter.h"

#include <stdio.h>

#include "shared/shape_solids.h"

static swHull* CreateHull(const swHullDef* def)
{
    swHost host = MakeHost();
    swHull* hull = NULL;
    assert_int_equal(swCreateHull(&host, def, &hull), SW_SUCCESS);
    return hull;
}

static void Refuses(const swHullDef* def, const char* sentence)
{
    swHost host = MakeHost();
    swHull* hull = NULL;
    assert_int_equal(swCreateHull(&host, def, &hull), SW_ERROR_INVALID);
    assert_null(hull);
    printf("%s", s_messages);
    assert_non_null(strstr(s_messages, sentence));
}

static float DistanceAt(const swHull* hull, float x, float y, float z)
{
    float distance;
    swHull_Sample(hull, 1, &(swVec3){x, y, z}, &distance);
    return distance;
}

// The dock is three boxes.
static float ExactDockDistance(swVec3 p)
{
    float north = swBoxDistance(p.x, p.y, p.z + 8.0f, 15.0f, 5.0f, 2.0f, 0.0f);
    float south = swBoxDistance(p.x, p.y, p.z - 8.0f, 15.0f, 5.0f, 2.0f, 0.0f);
    float west = swBoxDistance(p.x + 13.0f, p.y, p.z, 2.0f, 5.0f, 10.0f, 0.0f);
    return fminf(north, fminf(south, west));
}

static void AConcaveDockIsCutOutAndItsBasinIsNot(void** state)
{
    (void)state;
    static TestMesh mesh;
    mesh.vertexCount = mesh.triangleCount = 0;
    AddDock(&mesh);
    swHullDef def = MakeHullDef(&mesh, "dock");
    swHull* hull = CreateHull(&def);
    swHullInfo info = swHull_GetInfo(hull);
    assert_false(info.isSelfCrossing);
    assert_false(info.isInsideOut);
    printf("dock: %d x %d x %d values, %.2f m apart, %zu bytes\n", info.countX, info.countY, info.countZ,
           (double)info.spacing, info.memory);
    uint32_t seed = 3;
    float worstOutside = 0.0f;
    for (int i = 0; i < 20000; ++i)
    {
        swVec3 p = {44.0f * ((float)NextPart(&seed) - 0.5f), 16.0f * ((float)NextPart(&seed) - 0.5f),
                    32.0f * ((float)NextPart(&seed) - 0.5f)};
        float exact = ExactDockDistance(p), distance = DistanceAt(hull, p.x, p.y, p.z);
        if (fabsf(p.x) > 15.9f || fabsf(p.y) > 5.9f || fabsf(p.z) > 10.9f) // beyond the grid
        {
            assert_true(distance > 0.0f && distance < exact + 0.25f);
            continue;
        }
        // A union of distances is exact outside; inside it is short near inner corners.
        worstOutside = exact > 0.0f ? fmaxf(worstOutside, fabsf(distance - exact)) : worstOutside;
        if (fabsf(exact) > 0.5f * info.spacing)
        {
            assert_true((distance < 0.0f) == (exact < 0.0f));
        }
    }
    printf("dock: outside off by at most %.3f m, %.2f spacings\n", (double)worstOutside,
           (double)(worstOutside / info.spacing));
    assert_true(worstOutside < 0.5f * info.spacing);
    assert_true(DistanceAt(hull, 0.0f, 0.0f, 0.0f) > 5.0f); // the basin
    swDestroyHull(hull);
}

static void ARingKeepsItsHole(void** state)
{
    (void)state;
    static TestMesh mesh;
    mesh.vertexCount = mesh.triangleCount = 0;
    AddRing(&mesh, 10.0f, 3.0f, 96, 48);
    swHullDef def = MakeHullDef(&mesh, "ring");
    swHull* hull = CreateHull(&def);
    float spacing = swHull_GetInfo(hull).spacing, worst = 0.0f, worstNear = 0.0f;
    uint32_t seed = 5;
    for (int i = 0; i < 20000; ++i)
    {
        swVec3 p = {27.0f * ((float)NextPart(&seed) - 0.5f), 7.0f * ((float)NextPart(&seed) - 0.5f),
                    27.0f * ((float)NextPart(&seed) - 0.5f)};
        float from = sqrtf(p.x * p.x + p.z * p.z) - 10.0f;
        float error = fabsf(DistanceAt(hull, p.x, p.y, p.z) - (sqrtf(from * from + p.y * p.y) - 3.0f));
        worst = fmaxf(worst, error);
        worstNear = fabsf(sqrtf(from * from + p.y * p.y) - 3.0f) < spacing ? fmaxf(worstNear, error) : worstNear;
    }
    printf("ring: off by at most %.3f m, near its surface %.3f m (%.2f m apart)\n", (double)worst, (double)worstNear,
           (double)spacing);
    assert_true(worst < 0.3f); // at the tube's middle, where distances have a ridge
    assert_true(worstNear < 0.06f);
    swDestroyHull(hull);
}

static void FacesThatAllLookInwardsAreTurned(void** state)
{
    (void)state;
    static TestMesh mesh;
    mesh.vertexCount = mesh.triangleCount = 0;
    AddBox(&mesh, (swVec3){-1.0f, -1.0f, -1.0f}, (swVec3){1.0f, 1.0f, 1.0f});
    for (int i = 0; i < mesh.triangleCount; ++i)
    {
        uint32_t swapped = mesh.indices[3 * i];
        mesh.indices[3 * i] = mesh.indices[3 * i + 1];
        mesh.indices[3 * i + 1] = swapped;
    }
    swHullDef def = MakeHullDef(&mesh, "box");
    swHull* hull = CreateHull(&def);
    assert_true(swHull_GetInfo(hull).isInsideOut);
    assert_float_equal(DistanceAt(hull, 0.0f, 0.0f, 0.0f), -1.0f, 0.05f);
    assert_float_equal(DistanceAt(hull, 1.04f, 0.0f, 0.0f), 0.04f, 1e-3f);
    swDestroyHull(hull);
}

static void AMeshThatCrossesItselfIsMarkedAndOneHole(void** state)
{
    (void)state;
    static TestMesh mesh;
    mesh.vertexCount = mesh.triangleCount = 0;
    AddBox(&mesh, (swVec3){-4.0f, -1.0f, -1.0f}, (swVec3){1.0f, 1.0f, 1.0f});
    AddBox(&mesh, (swVec3){-1.0f, -0.9f, -0.9f}, (swVec3){4.0f, 0.9f, 0.9f});
    swHullDef def = MakeHullDef(&mesh, "two boxes");
    swHull* hull = CreateHull(&def);
    assert_true(swHull_GetInfo(hull).isSelfCrossing);
    assert_non_null(strstr(s_messages, "warning: two boxes crosses itself"));
    for (float x = -3.5f; x <= 3.5f; x += 0.05f)
    {
        assert_true(DistanceAt(hull, x, 0.0f, 0.0f) < -0.4f); // no wall inside
    }
    assert_true(DistanceAt(hull, 3.0f, 0.95f, 0.0f) > 0.0f);
    swDestroyHull(hull);
}

static void TwoPartsAndACavityAreOneHull(void** state)
{
    (void)state;
    static TestMesh mesh;
    mesh.vertexCount = mesh.triangleCount = 0;
    AddBox(&mesh, (swVec3){-10.0f, -3.0f, -3.0f}, (swVec3){-4.0f, 3.0f, 3.0f});
    AddBox(&mesh, (swVec3){4.0f, -3.0f, -3.0f}, (swVec3){10.0f, 3.0f, 3.0f});
    int outerCount = mesh.triangleCount;
    AddBox(&mesh, (swVec3){-9.0f, -2.0f, -2.0f}, (swVec3){-5.0f, 2.0f, 2.0f});
    for (int i = outerCount; i < mesh.triangleCount; ++i) // the cavity's faces look into it
    {
        uint32_t swapped = mesh.indices[3 * i];
        mesh.indices[3 * i] = mesh.indices[3 * i + 1];
        mesh.indices[3 * i + 1] = swapped;
    }
    swHullDef def = MakeHullDef(&mesh, "parts");
    def.resolution = 80;
    swHull* hull = CreateHull(&def);
    assert_false(swHull_GetInfo(hull).isSelfCrossing);
    assert_float_equal(DistanceAt(hull, 7.0f, 0.0f, 0.0f), -3.0f, 0.1f);
    assert_float_equal(DistanceAt(hull, 0.0f, 0.0f, 0.0f), 4.0f, 0.1f);
    assert_float_equal(DistanceAt(hull, -7.0f, 0.0f, 0.0f), 2.0f, 0.1f);
    assert_float_equal(DistanceAt(hull, -9.5f, 0.0f, 0.0f), -0.5f, 0.1f);
    swDestroyHull(hull);
}

static void MeshesWithoutAnInsideAreRefusedInASentence(void** state)
{
    (void)state;
    static TestMesh mesh;
    mesh.vertexCount = mesh.triangleCount = 0;
    AddDock(&mesh);
    swHullDef def = MakeHullDef(&mesh, "dock");
    def.triangleCount -= 1;
    Refuses(&def, "dock is open: 3 edges have no face on one side");
    def.triangleCount = 3;
    Refuses(&def, "dock has 3 triangles; a closed hull has at least 4");

    def = MakeHullDef(&mesh, "dock");
    mesh.vertices[3].y = (float)NAN;
    Refuses(&def, "dock has vertex 3, counted from 0, at (15, nan, -10)");
    mesh.vertices[3].y = 5.0f;

    mesh.indices[7] = 99;
    Refuses(&def, "dock has index 99 in triangle 2, counted from 0, but 16 vertices");
    mesh.vertexCount = mesh.triangleCount = 0;
    AddDock(&mesh);

    uint32_t swapped = mesh.indices[0];
    mesh.indices[0] = mesh.indices[1];
    mesh.indices[1] = swapped;
    Refuses(&def, "turned against their neighbours at 3 edges");
    mesh.vertexCount = mesh.triangleCount = 0;
    AddBox(&mesh, (swVec3){0.0f, 0.0f, 0.0f}, (swVec3){5.0f, 0.0f, 5.0f});
    def = MakeHullDef(&mesh, "flat");
    Refuses(&def, "flat is 5 x 0 x 5 m large; a hull has a volume");
    def.resolution = 1000;
    Refuses(&def, "resolution");
}

// Corners of triangles of a text file: [count][3].
static int ReadStlText(const char* path, TestMesh* mesh)
{
    FILE* file = fopen(path, "r");
    mesh->vertexCount = mesh->triangleCount = 0;
    if (file == NULL)
    {
        printf("skipped: there is no %s\n", path);
        return 0;
    }
    char line[256];
    while (fgets(line, sizeof line, file) != NULL)
    {
        swVec3* v = &mesh->vertices[mesh->vertexCount];
        if (sscanf(line, " vertex %f %f %f", &v->x, &v->y, &v->z) == 3)
        {
            mesh->indices[mesh->vertexCount] = (uint32_t)mesh->vertexCount;
            mesh->vertexCount += 1;
        }
    }
    fclose(file);
    mesh->triangleCount = mesh->vertexCount / 3;
    return mesh->triangleCount;
}

static void RoundedCornersOfAFileOfTrianglesAreJoined(void** state)
{
    (void)state;
    static TestMesh mesh;
    if (ReadStlText(SW_SOURCE_DIR "/../shared/data/meshes/wecsim_rm3/float.stl", &mesh) == 0)
    {
        skip();
    }
    swHullDef def = MakeHullDef(&mesh, "float");
    swHull* hull = CreateHull(&def);
    swHullInfo info = swHull_GetInfo(hull);
    printf("float: %d triangles, %d x %d x %d values, %zu bytes%s%s\n", mesh.triangleCount, info.countX, info.countY,
           info.countZ, info.memory, info.isSelfCrossing ? ", crosses itself" : "",
           info.isInsideOut ? ", inside out" : "");
    assert_false(info.isSelfCrossing);
    // A ring of 20 m about a hole of 6.5 m.
    assert_true(DistanceAt(hull, 0.0f, 0.0f, 0.5f * (info.low.z + info.high.z)) > 2.0f);
    assert_true(DistanceAt(hull, 7.0f, 0.0f, 0.5f * (info.low.z + info.high.z)) < -0.5f);
    swDestroyHull(hull);
}

static void NothingIsHalfMadeWithoutMemory(void** state)
{
    (void)state;
    static TestMesh mesh;
    mesh.vertexCount = mesh.triangleCount = 0;
    AddDock(&mesh);
    swHullDef def = MakeHullDef(&mesh, "dock");
    def.resolution = 16;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swHull* hull = NULL;
    int failures = 0;
    for (;; ++failures)
    {
        atomic_store(&memory.allocations, 0);
        atomic_store(&memory.failAt, failures);
        if (swCreateHull(&host, &def, &hull) == SW_SUCCESS)
        {
            break;
        }
        assert_null(hull);
        assert_int_equal(atomic_load(&memory.bytes), 0);
    }
    assert_true(failures >= 6);
    swDestroyHull(hull);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(AConcaveDockIsCutOutAndItsBasinIsNot),
        cmocka_unit_test(ARingKeepsItsHole),
        cmocka_unit_test(FacesThatAllLookInwardsAreTurned),
        cmocka_unit_test(AMeshThatCrossesItselfIsMarkedAndOneHole),
        cmocka_unit_test(TwoPartsAndACavityAreOneHull),
        cmocka_unit_test(MeshesWithoutAnInsideAreRefusedInASentence),
        cmocka_unit_test(RoundedCornersOfAFileOfTrianglesAreJoined),
        cmocka_unit_test(NothingIsHalfMadeWithoutMemory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
