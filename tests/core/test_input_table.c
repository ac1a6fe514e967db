// SPDX-License-Identifier: MIT
// The table of docs/inputs.md, which shape serves which field, against what a world takes and refuses.

#include "support/cmocka_setup.h"
#include "support/messages.h"

#include <stdlib.h>

#include "seaway/input.h"
#include "seaway/mesh.h"
#include "seaway/spline.h"
#include "seaway/world.h"

#define PAGE SW_SOURCE_DIR "/docs/inputs.md"
#define NO_USE "\xE2\x80\x93" // an en dash

// What inputs of all shapes need.
typedef struct Parts
{
    swHost host;
    swWorld* world;
    swRaster* raster;
    swMesh* mesh;
    swSpline* spline;
    swHull* hull;
} Parts;

static Parts MakeParts(void)
{
    static const float values[4 * 4] = {0.0f}; // four cells, or four corners, of four numbers
    static const swVec3 corners[4] = {{0.0f, 0.0f, 0.0f}, {9.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 9.0f}, {0.0f, 9.0f, 0.0f}};
    static const uint32_t faces[4 * 3] = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
    const swSplinePoint line[2] = {swDefaultSplinePoint(0.0, 0.0, 0.0), swDefaultSplinePoint(90.0, 0.0, 0.0)};
    Parts parts = {.host = MakeHost()};
    swWorldDef worldDef = swDefaultWorldDef();
    swRasterDef raster = swDefaultRasterDef();
    raster.width = raster.height = 2;
    raster.channels = 4;
    raster.values = values;
    swMeshDef mesh = swDefaultMeshDef();
    mesh.vertices = corners;
    mesh.vertexCount = 4;
    mesh.indices = faces;
    mesh.triangleCount = 4;
    mesh.channelCount = 4;
    mesh.values = values;
    swSplineDef spline = swDefaultSplineDef();
    spline.points = line;
    spline.pointCount = 2;
    swHullDef hull = swDefaultHullDef();
    hull.vertices = corners;
    hull.vertexCount = 4;
    hull.indices = faces;
    hull.triangleCount = 4;
    assert_int_equal(swCreateWorld(&parts.host, &worldDef, &parts.world), SW_SUCCESS);
    assert_int_equal(swCreateRaster(&parts.host, &raster, &parts.raster), SW_SUCCESS);
    assert_int_equal(swCreateMesh(&parts.host, &mesh, &parts.mesh), SW_SUCCESS);
    assert_int_equal(swCreateSpline(&parts.host, &spline, &parts.spline), SW_SUCCESS);
    assert_int_equal(swCreateHull(&parts.host, &hull, &parts.hull), SW_SUCCESS);
    return parts;
}

static void DestroyParts(Parts* parts)
{
    swDestroyHull(parts->hull);
    swDestroySpline(parts->spline);
    swDestroyMesh(parts->mesh);
    swDestroyRaster(parts->raster);
    swDestroyWorld(parts->world);
}

static void SayNothing(void* context, double time, int count, const swPosXZ* points, swInputAnswer* answers)
{
    (void)context;
    (void)time;
    (void)count;
    (void)points;
    (void)answers;
}

static bool IsTaken(const Parts* parts, swInputShape shape, swInputField field)
{
    static const swInputPoint points[3] = {{.x = 0.0f, .radius = 2.0f, .weight = 1.0f},
                                           {.x = 9.0f, .radius = 2.0f, .weight = 1.0f},
                                           {.z = 9.0f, .radius = 2.0f, .weight = 1.0f}};
    bool hasPoints = shape == SW_SHAPE_POLYGON || shape == SW_SHAPE_POLYLINE || shape == SW_SHAPE_PARTICLES;
    swInputDef def = swDefaultInputDef();
    swInputId id;
    def.shape = shape;
    def.field = field;
    def.blend = SW_BLEND_REPLACE; // which every field can
    def.raster = shape == SW_SHAPE_RASTER ? parts->raster : NULL;
    def.mesh = shape == SW_SHAPE_MESH ? parts->mesh : NULL;
    def.spline = shape == SW_SHAPE_SPLINE ? parts->spline : NULL;
    def.hull = shape == SW_SHAPE_HULL ? parts->hull : NULL;
    def.points = hasPoints ? points : NULL;
    def.pointCount = hasPoints ? 3 : 0;
    def.function = shape == SW_SHAPE_FUNCTION ? SayNothing : NULL;
    swResult result = swCreateInput(parts->world, &def, &id);
    if (result == SW_SUCCESS)
    {
        swDestroyInput(parts->world, id);
    }
    return result == SW_SUCCESS;
}

// A row's first cell names shapes, such as "circle, rectangle"; the others are of the fields in their order.
typedef struct Table
{
    char cells[SW_SHAPE_COUNT][SW_INPUT_FIELD_COUNT][64];
    bool isThere[SW_SHAPE_COUNT];
} Table;

static void TrimCell(const char* from, const char* to, char cell[64])
{
    while (from < to && *from == ' ')
    {
        ++from;
    }
    while (to > from && to[-1] == ' ')
    {
        --to;
    }
    snprintf(cell, 64, "%.*s", (int)(to - from), from);
}

static int SplitRow(const char* line, char cells[SW_INPUT_FIELD_COUNT + 1][64])
{
    int count = 0;
    const char* begin = strchr(line, '|');
    for (const char* end; begin != NULL && (end = strchr(begin + 1, '|')) != NULL; begin = end)
    {
        assert_true(count <= SW_INPUT_FIELD_COUNT);
        TrimCell(begin + 1, end, cells[count++]);
    }
    return count;
}

static void TakeRow(Table* table, char cells[SW_INPUT_FIELD_COUNT + 1][64])
{
    const swField* shapes = swFields_Find(swGetInputFields(), "shape");
    for (char* name = strtok(cells[0], ", "); name != NULL; name = strtok(NULL, ", "))
    {
        int shape = 0;
        while (shape < SW_SHAPE_COUNT && strcmp(shapes->words[shape], name) != 0)
        {
            ++shape;
        }
        if (shape == SW_SHAPE_COUNT || table->isThere[shape])
        {
            fail_msg("the table's shape '%s' is none, or stands twice", name);
        }
        table->isThere[shape] = true;
        memcpy(table->cells[shape], cells[1], sizeof(table->cells[shape]));
    }
}

static void ReadTable(Table* table)
{
    char line[1024], cells[SW_INPUT_FIELD_COUNT + 1][64];
    const swField* fields = swFields_Find(swGetInputFields(), "field");
    FILE* page = fopen(PAGE, "r");
    bool isInside = false;
    assert_non_null(page);
    while (fgets(line, sizeof(line), page) != NULL && !(isInside && line[0] != '|'))
    {
        if (!isInside && strncmp(line, "| Shape |", 9) == 0)
        {
            isInside = true;
            assert_int_equal(SplitRow(line, cells), SW_INPUT_FIELD_COUNT + 1);
            for (int i = 0; i < SW_INPUT_FIELD_COUNT; ++i)
            {
                assert_string_equal(cells[i + 1], fields->words[i]);
            }
        }
        else if (isInside && strncmp(line, "| ---", 5) != 0)
        {
            assert_int_equal(SplitRow(line, cells), SW_INPUT_FIELD_COUNT + 1);
            TakeRow(table, cells);
        }
    }
    fclose(page);
    for (int i = 0; i < SW_SHAPE_COUNT; ++i)
    {
        assert_true(table->isThere[i]);
    }
}

static bool IsSolid(int shape)
{
    return shape >= SW_SHAPE_BOX;
}

// What the table names is taken. What it has a dash for is rarely meant, or refused as the text below it says.
static void TheTableIsWhatAWorldTakes(void** state)
{
    (void)state;
    static Table table;
    Parts parts = MakeParts();
    int wrong = 0;
    ReadTable(&table);
    for (int shape = 0; shape < SW_SHAPE_COUNT; ++shape)
    {
        for (int field = 0; field < SW_INPUT_FIELD_COUNT; ++field)
        {
            bool isNamed = strcmp(table.cells[shape][field], NO_USE) != 0;
            bool isTaken = IsTaken(&parts, (swInputShape)shape, (swInputField)field);
            bool isNumberOfBody = field == SW_INPUT_BODY && (shape == SW_SHAPE_RASTER || shape == SW_SHAPE_MESH);
            bool mustBeTaken = IsSolid(shape) ? field == SW_INPUT_CLIP : !isNumberOfBody;
            if (isTaken != mustBeTaken || (isNamed && !isTaken))
            {
                print_message("shape %d of the field %d: %s, and the table has '%s'\n%s", shape, field,
                              isTaken ? "taken" : "refused", table.cells[shape][field], s_messages);
                ++wrong;
            }
            s_messages[0] = '\0';
        }
    }
    DestroyParts(&parts);
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TheTableIsWhatAWorldTakes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
