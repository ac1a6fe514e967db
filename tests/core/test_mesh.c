// SPDX-License-Identifier: MIT
// Meshes as seen from above.
#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <math.h>
#include <stdlib.h>

#include "core/input/mesh.h"
#include "core/math/random.h"
#include "seaway/mesh.h"
#include "shared/shape_mesh.h"

static swMesh* Make(int vertexCount, const swVec3* vertices, int triangleCount, const uint32_t* indices, float highest)
{
    swHost host = MakeHost();
    swMeshDef def = swDefaultMeshDef();
    def.vertices = vertices;
    def.vertexCount = vertexCount;
    def.indices = indices;
    def.triangleCount = triangleCount;
    def.highest = highest;
    swMesh* mesh = NULL;
    if (swCreateMesh(&host, &def, &mesh) != SW_SUCCESS)
    {
        fail_msg("%s", s_messages);
    }
    return mesh;
}

static float HeightAt(const swMesh* mesh, float x, float z)
{
    float height = 0.0f;
    swMesh_Sample(mesh, 1, &(swVec2){x, z}, &height);
    return height;
}

static swInputSample SampleAs(const swMesh* mesh, uint32_t field, float x, float z)
{
    swInputRecord record = {.field = field, .gain = 1.0f};
    swDescribeMesh(mesh, &record);
    return swSampleMeshInput(mesh->words, record, x, z);
}

static void ATriangleIsAPlane(void** state)
{
    (void)state;
    const swVec3 vertices[] = {{0.0f, -10.0f, 0.0f}, {8.0f, -6.0f, 0.0f}, {0.0f, -12.0f, 4.0f}};
    swMesh* mesh = Make(3, vertices, 1, (uint32_t[]){2, 0, 1}, 1e6f);
    swInputSample s = SampleAs(mesh, SW_FIELD_OF_FLOOR, 2.0f, 1.0f);
    assert_true(s.share == 1.0f && s.value.x == -9.5f && s.valueX.x == 0.5f && s.valueZ.x == -0.5f);
    assert_true(HeightAt(mesh, 0.0f, 0.0f) == -10.0f && HeightAt(mesh, 8.0f, 0.0f) == -6.0f);
    assert_true(isnan(HeightAt(mesh, 4.01f, 2.0f)) && isnan(HeightAt(mesh, -0.01f, 1.0f)));
    assert_true(isnan(HeightAt(mesh, NAN, 1.0f)) && isnan(HeightAt(mesh, INFINITY, 1.0f)));
    assert_true(SampleAs(mesh, SW_FIELD_OF_FLOOR, 9.0f, 0.0f).share == 0.0f);
    swDestroyMesh(mesh);
}

// ---- a bumpy ground of many triangles ----

enum
{
    SIDE = 33,
    CORNERS = SIDE * SIDE,
    TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1)
};

static swVec3 s_corners[CORNERS];
static uint32_t s_triangles[3 * TRIANGLES];

static float Random(int index, int draw)
{
    return (float)swHashToUnit(swHashWave(7, draw, index, 0, 0));
}

// Corners off their places by up to a third of a step; triangles turned either way.
static void MakeGround(float spacing, float middle)
{
    for (int i = 0; i < CORNERS; ++i)
    {
        bool isRim = i % SIDE == 0 || i % SIDE == SIDE - 1 || i / SIDE == 0 || i / SIDE == SIDE - 1;
        float shift = isRim ? 0.0f : 0.33f;
        s_corners[i].x = middle + spacing * ((float)(i % SIDE) + shift * (Random(i, 0) - 0.5f));
        s_corners[i].z = -middle + spacing * ((float)(i / SIDE) + shift * (Random(i, 1) - 0.5f));
        s_corners[i].y = -40.0f * Random(i, 2);
    }
    uint32_t* t = s_triangles;
    for (int i = 0; i < CORNERS; ++i)
    {
        if (i % SIDE == SIDE - 1 || i / SIDE == SIDE - 1)
        {
            continue;
        }
        uint32_t a = (uint32_t)i, b = a + 1, c = a + SIDE, d = c + 1;
        const uint32_t both[6] = {a, i % 2 ? b : c, i % 2 ? c : b, b, i % 3 ? c : d, i % 3 ? d : c};
        memcpy(t, both, sizeof(both));
        t += 6;
    }
}

// The highest of all triangles, one by one, in double.
static double FindByHand(const swMesh* mesh, double x, double z)
{
    double best = (double)NAN;
    for (int i = 0; i < mesh->triangleCount; ++i)
    {
        const swVec3 *a = &mesh->vertices[mesh->indices[3 * i]], *b = &mesh->vertices[mesh->indices[3 * i + 1]],
                     *c = &mesh->vertices[mesh->indices[3 * i + 2]];
        double ax = (double)a->x, az = (double)a->z, bx = (double)b->x - ax, bz = (double)b->z - az;
        double cx = (double)c->x - ax, cz = (double)c->z - az, area = bx * cz - bz * cx;
        double u = ((x - ax) * cz - (z - az) * cx) / area, v = (bx * (z - az) - bz * (x - ax)) / area;
        double height = (double)a->y + u * ((double)b->y - (double)a->y) + v * ((double)c->y - (double)a->y);
        bool isIn = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
        best = isIn && !(best >= height) ? height : best;
    }
    return best;
}

static void EveryPlaceOfAGroundHasItsHeight(void** state)
{
    (void)state;
    const float spacings[] = {0.5f, 30.0f}, middles[] = {0.0f, 20000.0f};
    for (int way = 0; way < 4; ++way)
    {
        float spacing = spacings[way % 2], middle = middles[way / 2];
        MakeGround(spacing, middle);
        swMesh* mesh = Make(CORNERS, s_corners, TRIANGLES, s_triangles, 1e6f);
        double worst = 0.0;
        for (int i = 0; i < 4000; ++i)
        {
            float x = middle + spacing * (SIDE - 1) * Random(i, 3), z = -middle + spacing * (SIDE - 1) * Random(i, 4);
            float height = HeightAt(mesh, x, z);
            assert_false(isnan(height));
            double truth = FindByHand(mesh, (double)x, (double)z);
            worst = isnan(truth) ? worst : fmax(worst, fabs((double)height - truth));
        }
        print_message("cells %d x %d, %zu bytes, worst %.2e m\n", mesh->countX, mesh->countZ, mesh->memory, worst);
        assert_true(worst < 2e-5);
        for (int i = 0; i < CORNERS; ++i) // corners and middles of edges have no gap
        {
            assert_false(isnan(HeightAt(mesh, s_corners[i].x, s_corners[i].z)));
            int next = i % SIDE == SIDE - 1 ? i : i + 1;
            for (int k = 1; k < 8; ++k)
            {
                float part = (float)k * 0.125f;
                float x = s_corners[i].x + part * (s_corners[next].x - s_corners[i].x);
                float z = s_corners[i].z + part * (s_corners[next].z - s_corners[i].z);
                bool isRim = i / SIDE == 0 || i / SIDE == SIDE - 1;
                assert_true(isRim || !isnan(HeightAt(mesh, x, z)));
            }
        }
        swDestroyMesh(mesh);
    }
}

static void GradientsAreThoseOfTheHeights(void** state)
{
    (void)state;
    MakeGround(10.0f, 0.0f);
    swMesh* mesh = Make(CORNERS, s_corners, TRIANGLES, s_triangles, 1e6f);
    int compared = 0;
    for (int i = 0; i < 500; ++i)
    {
        float x = 320.0f * Random(i, 5), z = 320.0f * Random(i, 6);
        const float step = 0.05f;
        swInputSample at = SampleAs(mesh, SW_FIELD_OF_FLOOR, x, z);
        swInputSample east = SampleAs(mesh, SW_FIELD_OF_FLOOR, x + step, z);
        swInputSample south = SampleAs(mesh, SW_FIELD_OF_FLOOR, x, z + step);
        bool isOne = east.valueX.x == at.valueX.x && south.valueX.x == at.valueX.x; // of one triangle
        compared += isOne ? 1 : 0;
        assert_true(!isOne || fabsf((east.value.x - at.value.x) / step - at.valueX.x) < 2e-3f);
        assert_true(!isOne || fabsf((south.value.x - at.value.x) / step - at.valueZ.x) < 2e-3f);
    }
    assert_true(compared > 400);
    swDestroyMesh(mesh);
}

// ---- above each other ----

// A floor at -20 m, a pier at -2 m over a part of it, and a bridge from 12 m up across all.
static const swVec3 Harbour[] = {{-50.0f, -20.0f, -50.0f}, {50.0f, -20.0f, -50.0f}, {-50.0f, -20.0f, 50.0f},
                                 {50.0f, -20.0f, 50.0f},   {0.0f, -2.0f, -50.0f},   {20.0f, -2.0f, -50.0f},
                                 {0.0f, -2.0f, 50.0f},     {20.0f, -2.0f, 50.0f},   {-50.0f, 12.0f, -5.0f},
                                 {50.0f, 15.0f, -5.0f},    {-50.0f, 12.0f, 5.0f},   {50.0f, 15.0f, 5.0f}};
static const uint32_t HarbourFaces[] = {0, 1, 2, 1, 3, 2, 4, 6, 5, 5, 6, 7, 8, 9, 10, 9, 11, 10};

static void TheHighestCountsAndABridgeIsNoLand(void** state)
{
    (void)state;
    swMesh* all = Make(12, Harbour, 6, HarbourFaces, 1e6f);
    swMesh* low = Make(12, Harbour, 6, HarbourFaces, 5.0f);
    swMesh* half = Make(12, Harbour, 6, HarbourFaces, 13.5f);
    assert_true(HeightAt(all, -25.0f, 20.0f) == -20.0f && HeightAt(all, 10.0f, 20.0f) == -2.0f);
    assert_true(HeightAt(all, 0.0f, 0.0f) == 13.5f && HeightAt(low, 10.0f, 0.0f) == -2.0f);
    assert_true(HeightAt(low, -25.0f, 0.0f) == -20.0f);
    assert_true(HeightAt(half, -25.0f, 0.0f) == 12.75f && HeightAt(half, 25.0f, 0.0f) == -20.0f);
    swDestroyMesh(all);
    swDestroyMesh(low);
    swDestroyMesh(half);
}

static void WallsHaveNoGroundAndDoNoHarm(void** state)
{
    (void)state;
    const swVec3 vertices[] = {{0.0f, -5.0f, 0.0f}, {10.0f, -5.0f, 0.0f},  {0.0f, -5.0f, 10.0f}, {10.0f, -5.0f, 10.0f},
                               {5.0f, 90.0f, 0.0f}, {5.0f, -90.0f, 10.0f}, {5.0f, 80.0f, 5.0f}};
    const uint32_t faces[] = {0, 1, 2, 1, 3, 2, 4, 5, 6, 0, 0, 1, 3, 3, 3};
    swMesh* mesh = Make(7, vertices, 5, faces, 1e6f);
    assert_true(HeightAt(mesh, 5.0f, 5.0f) == -5.0f && HeightAt(mesh, 5.0f, 0.0f) == -5.0f);
    swDestroyMesh(mesh);
    swMesh* wall = Make(7, vertices, 1, faces + 6, 1e6f); // nothing at all is seen of it
    assert_true(isnan(HeightAt(wall, 5.0f, 5.0f)));
    swDestroyMesh(wall);
}

static void OtherFieldsHaveTheCornersValues(void** state)
{
    (void)state;
    swHost host = MakeHost();
    swMeshDef def = swDefaultMeshDef();
    def.vertices = Harbour;
    def.vertexCount = 12;
    def.indices = HarbourFaces;
    def.triangleCount = 2;
    float values[12 * 2];
    for (int i = 0; i < 12; ++i)
    {
        values[2 * i] = Harbour[i].x * 0.01f;
        values[2 * i + 1] = 3.0f;
    }
    def.values = values;
    def.channelCount = 2;
    swMesh* mesh = NULL;
    assert_int_equal(swCreateMesh(&host, &def, &mesh), SW_SUCCESS);
    swInputSample s = SampleAs(mesh, SW_FIELD_OF_FLOW, 20.0f, 10.0f);
    assert_true(fabsf(s.value.x - 0.2f) < 1e-6f && fabsf(s.valueX.x - 0.01f) < 1e-7f && s.value.y == 3.0f);
    assert_true(s.value.z == 1.0f); // a mesh without values says 1
    assert_true(SampleAs(mesh, SW_FIELD_OF_FLOOR, 20.0f, 10.0f).value.x == -20.0f);
    assert_memory_equal(swMesh_GetValues(mesh), values, sizeof(values));
    swDestroyMesh(mesh);
}

// ---- what is refused ----

static void CheckRefused(const swMeshDef* def, swResult expected, const char* words)
{
    swHost host = MakeHost();
    swMesh* mesh = NULL;
    assert_int_equal(swCreateMesh(&host, def, &mesh), expected);
    assert_null(mesh);
    if (strstr(s_messages, words) == NULL)
    {
        fail_msg("\"%s\" does not say \"%s\"", s_messages, words);
    }
}

static void BadMeshesAreRefusedWithTheVertex(void** state)
{
    (void)state;
    swVec3 vertices[4];
    memcpy(vertices, Harbour, sizeof(vertices));
    uint32_t faces[6];
    memcpy(faces, HarbourFaces, sizeof(faces));
    swMeshDef def = swDefaultMeshDef();
    def.name = "quay";
    def.vertices = vertices;
    def.vertexCount = 4;
    def.indices = faces;
    def.triangleCount = 2;
    vertices[2].y = NAN;
    CheckRefused(&def, SW_ERROR_INVALID, "quay has vertex 2 at (-50, nan, 50)");
    vertices[2].y = 2e6f;
    CheckRefused(&def, SW_ERROR_INVALID, "quay has vertex 2 at");
    vertices[2].y = 0.0f;
    faces[4] = 4;
    CheckRefused(&def, SW_ERROR_INVALID, "quay has vertex 4 in triangle 1, counted from 0; there are 4");
    faces[4] = 3;
    const float values[4] = {0.0f, 1.0f, INFINITY, 0.0f};
    def.values = values;
    def.channelCount = 1;
    CheckRefused(&def, SW_ERROR_INVALID, "the value inf at vertex 2");
#ifdef NDEBUG // misuse: where asserts are on, the program stops
    def.channelCount = 5;
    CheckRefused(&def, SW_ERROR_INVALID, "channelCount is 5");
#endif
    def.channelCount = 0;
    def.highest = NAN;
    CheckRefused(&def, SW_ERROR_INVALID, "highest");
    def.highest = 0.0f;
#ifdef NDEBUG
    def.triangleCount = 0;
    CheckRefused(&def, SW_ERROR_INVALID, "1 to 1000000 triangles");
#endif
}

static void ManyTrianglesMayLieAboveEachOther(void** state)
{
    (void)state;
    enum
    {
        LAYERS = 2000
    };
    swVec3* vertices = malloc(3 * LAYERS * sizeof(swVec3));
    uint32_t* faces = malloc(3 * LAYERS * sizeof(uint32_t));
    assert_true(vertices != NULL && faces != NULL);
    for (uint32_t i = 0; i < 3 * LAYERS; ++i)
    {
        vertices[i] = (swVec3){i % 3 == 1 ? 1000.0f : 0.0f, (float)(i / 3), i % 3 == 2 ? 1000.0f : 0.0f};
        faces[i] = i;
    }
    swMesh* mesh = Make(3 * LAYERS, vertices, LAYERS, faces, 1e6f);
    assert_true(HeightAt(mesh, 100.0f, 100.0f) == LAYERS - 1);
    print_message("%d layers: cells %d x %d, %zu bytes\n", LAYERS, mesh->countX, mesh->countZ, mesh->memory);
    swDestroyMesh(mesh);
    free(vertices);
    free(faces);
}

static void UsersKeepAMesh(void** state)
{
    (void)state;
    swMesh* mesh = Make(12, Harbour, 6, HarbourFaces, 5.0f);
    swMesh* same = Make(12, Harbour, 6, HarbourFaces, 5.0f);
    swMesh* other = Make(12, Harbour, 6, HarbourFaces, 6.0f);
    assert_true(swMesh_GetInfo(mesh).hash == swMesh_GetInfo(same).hash);
    assert_true(swMesh_GetInfo(mesh).hash != swMesh_GetInfo(other).hash);
    swHoldMesh(mesh);
    swDestroyMesh(mesh);
    assert_true(HeightAt(mesh, -25.0f, 0.0f) == -20.0f);
    swReleaseMesh(mesh);
    swDestroyMesh(same);
    swDestroyMesh(other);
    swDestroyMesh(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ATriangleIsAPlane),
        cmocka_unit_test(EveryPlaceOfAGroundHasItsHeight),
        cmocka_unit_test(GradientsAreThoseOfTheHeights),
        cmocka_unit_test(TheHighestCountsAndABridgeIsNoLand),
        cmocka_unit_test(WallsHaveNoGroundAndDoNoHarm),
        cmocka_unit_test(OtherFieldsHaveTheCornersValues),
        cmocka_unit_test(BadMeshesAreRefusedWithTheVertex),
        cmocka_unit_test(ManyTrianglesMayLieAboveEachOther),
        cmocka_unit_test(UsersKeepAMesh),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
