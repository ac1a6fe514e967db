// SPDX-License-Identifier: MIT
// Inputs that come and go, and are given another field, another shape, other points or another tide.

#include <stdlib.h>
#include <string.h>

#include "sea.h"

// ---- points ----

bool HasPoints(swInputShape shape)
{
    return shape == SW_SHAPE_POLYGON || shape == SW_SHAPE_POLYLINE || shape == SW_SHAPE_PARTICLES;
}

bool TakeInputPoints(SeaInput* input, int count, const swInputPoint* points)
{
    swInputPoint* copy = count > 0 ? malloc((size_t)count * sizeof(swInputPoint)) : NULL;
    if (count > 0 && copy == NULL)
    {
        return false;
    }
    if (count > 0)
    {
        memcpy(copy, points, (size_t)count * sizeof(swInputPoint));
    }
    free(input->points);
    input->points = copy;
    input->pointCount = count;
    input->def.points = copy;
    input->def.pointCount = count;
    return true;
}

bool AddInputPoint(SeaInput* input, int row)
{
    int count = input->pointCount;
    swInputPoint* points = count < SW_MAX_INPUT_POINTS ? malloc((size_t)(count + 1) * sizeof(swInputPoint)) : NULL;
    if (points == NULL)
    {
        return false;
    }
    memcpy(points, input->points, (size_t)(row + 1) * sizeof(swInputPoint));
    memcpy(points + row + 1, input->points + row, (size_t)(count - row) * sizeof(swInputPoint));
    const swInputPoint* next = &input->points[(row + 1) % count];
    if (input->def.shape == SW_SHAPE_POLYGON || (input->def.shape == SW_SHAPE_POLYLINE && row + 1 < count))
    {
        points[row + 1].x = 0.5f * (input->points[row].x + next->x);
        points[row + 1].z = 0.5f * (input->points[row].z + next->z);
    }
    else
    {
        points[row + 1].x += 1.0f;
    }
    bool isTaken = TakeInputPoints(input, count + 1, points);
    free(points);
    input->hasChanged = true;
    return isTaken;
}

void RemoveInputPoint(SeaInput* input, int row)
{
    int least = input->def.shape == SW_SHAPE_POLYGON ? 3 : input->def.shape == SW_SHAPE_POLYLINE ? 2 : 1;
    if (input->pointCount <= least)
    {
        return;
    }
    input->pointCount -= 1;
    memmove(input->points + row, input->points + row + 1, (size_t)(input->pointCount - row) * sizeof(swInputPoint));
    input->def.pointCount = input->pointCount;
    input->hasChanged = true;
}

// ---- shores ----

bool TakeShore(SeaBody* body, int count, const swVec2* points)
{
    swVec2* copy = count > 0 ? malloc((size_t)count * sizeof(swVec2)) : NULL;
    if (copy == NULL)
    {
        return count == 0;
    }
    memcpy(copy, points, (size_t)count * sizeof(swVec2));
    free(body->points);
    body->points = copy;
    body->pointCount = count;
    body->def.points = copy;
    body->def.pointCount = count;
    return true;
}

bool AddShorePoint(SeaBody* body, int row)
{
    int count = body->pointCount;
    swVec2* points = count < SW_MAX_SHORE_POINTS ? malloc((size_t)(count + 1) * sizeof(swVec2)) : NULL;
    if (points == NULL)
    {
        return false;
    }
    const swVec2 a = body->points[row], b = body->points[(row + 1) % count];
    memcpy(points, body->points, (size_t)(row + 1) * sizeof(swVec2));
    points[row + 1] = (swVec2){0.5f * (a.x + b.x), 0.5f * (a.y + b.y)};
    memcpy(points + row + 2, body->points + row + 1, (size_t)(count - row - 1) * sizeof(swVec2));
    bool isTaken = TakeShore(body, count + 1, points);
    free(points);
    body->hasChanged = true;
    return isTaken;
}

void RemoveShorePoint(SeaBody* body, int row)
{
    if (body->pointCount <= 3)
    {
        return;
    }
    body->pointCount -= 1;
    memmove(body->points + row, body->points + row + 1, (size_t)(body->pointCount - row) * sizeof(swVec2));
    body->def.pointCount = body->pointCount;
    body->hasChanged = true;
}

// ---- fields and shapes ----

bool IsShapeFree(const SeaInput* input, swInputShape shape)
{
    bool isFlat = shape == SW_SHAPE_EVERYWHERE || shape == SW_SHAPE_CIRCLE || shape == SW_SHAPE_RECTANGLE ||
                  HasPoints(shape) || shape == input->def.shape;
    bool isSolid =
        shape == SW_SHAPE_BOX || shape == SW_SHAPE_ELLIPSOID || shape == SW_SHAPE_CYLINDER || shape == SW_SHAPE_CAPSULE;
    return isFlat || (isSolid && input->def.field == SW_INPUT_CLIP);
}

// Values by which one sees that the input is there.
static void SetFirstValue(swInputDef* def)
{
    static const float first[SW_INPUT_FIELD_COUNT][4] = {
        [SW_INPUT_FLOOR] = {-3.0f}, [SW_INPUT_LEVEL] = {1.0f}, [SW_INPUT_FLOW] = {1.0f},
        [SW_INPUT_WAVES] = {0.2f},  [SW_INPUT_CLIP] = {1.0f},  [SW_INPUT_DISPLACEMENT] = {0.0f, 1.0f},
        [SW_INPUT_FOAM] = {0.5f},   [SW_INPUT_WIND] = {10.0f}, [SW_INPUT_ALBEDO] = {0.8f, 0.1f, 0.05f, 0.8f},
        [SW_INPUT_SHADOW] = {0.2f},
    };
    memcpy(def->value, first[def->field], sizeof(def->value));
}

void ChangeInputField(SeaInput* input, swInputField field)
{
    const swInputDef old = input->def;
    swInputDef* def = &input->def;
    bool isSolid = old.shape >= SW_SHAPE_BOX;
    *def = swDefaultInputDef(); // what suited the old field may be refused by the new one
    memcpy(def->name, old.name, sizeof(def->name));
    def->field = field;
    def->shape = isSolid && field != SW_INPUT_CLIP ? SW_SHAPE_CIRCLE : old.shape;
    def->blend = field == SW_INPUT_BODY ? SW_BLEND_REPLACE : SW_BLEND_ALPHA;
    def->order = old.order;
    def->isEnabled = old.isEnabled;
    def->feather = old.feather;
    def->position = old.position;
    def->rotation = old.rotation;
    def->size = old.size;
    def->raster = old.raster;
    def->mesh = old.mesh;
    def->hull = old.hull;
    def->spline = old.spline;
    def->points = input->points;
    def->pointCount = input->pointCount;
    SetFirstValue(def);
    input->hasChanged = true;
}

bool ChangeInputShape(SeaInput* input, swInputShape shape)
{
    const float x = 0.5f * input->def.size.x, z = 0.5f * input->def.size.z;
    const swInputPoint square[4] = {{.x = -x, .z = -z, .weight = 1.0f},
                                    {.x = x, .z = -z, .weight = 1.0f},
                                    {.x = x, .z = z, .weight = 1.0f},
                                    {.x = -x, .z = z, .weight = 1.0f}};
    if (HasPoints(shape) && input->pointCount < 3 && !TakeInputPoints(input, 4, square))
    {
        return false;
    }
    input->def.shape = shape;
    input->def.isBump = input->def.isBump && (shape == SW_SHAPE_CIRCLE || shape == SW_SHAPE_PARTICLES);
    input->hasChanged = true;
    return true;
}

// ---- tides ----

int CountTide(const swTideConstituent tide[SW_MAX_TIDE])
{
    int count = 0;
    while (count < SW_MAX_TIDE && tide[count].speed > 0.0f)
    {
        count++;
    }
    return count;
}

void AddConstituent(swTideConstituent tide[SW_MAX_TIDE])
{
    int count = CountTide(tide);
    if (count < SW_MAX_TIDE)
    {
        swSetTideConstituent("M2", 1.0f, 0.0f, &tide[count]);
    }
}

void RemoveConstituent(swTideConstituent tide[SW_MAX_TIDE], int row)
{
    memmove(tide + row, tide + row + 1, (size_t)(SW_MAX_TIDE - 1 - row) * sizeof(*tide));
    tide[SW_MAX_TIDE - 1] = (swTideConstituent){0};
}

// ---- coming and going ----

static bool MakeRoomForInput(Sea* sea)
{
    size_t count = (size_t)sea->scene->inputCount;
    SeaInput* inputs = calloc(count + 1, sizeof(SeaInput));
    if (inputs == NULL)
    {
        return false;
    }
    if (count > 0)
    {
        memcpy(inputs, sea->inputs, count * sizeof(SeaInput));
    }
    free(sea->inputs);
    sea->inputs = inputs;
    return true;
}

bool AddInput(Sea* sea, swInputField field, swPos position)
{
    SeaInput fresh = {.def = swDefaultInputDef(), .isAdded = true};
    fresh.def.shape = SW_SHAPE_CIRCLE;
    fresh.def.feather = 10.0f;
    fresh.def.position = position;
    ChangeInputField(&fresh, field);
    swPosXZ origin = swWorld_GetOrigin(sea->world);
    swInputDef placed = fresh.def;
    placed.position.x -= origin.x;
    placed.position.z -= origin.z;
    if (sea->scene == NULL || !MakeRoomForInput(sea) || swCreateInput(sea->world, &placed, &fresh.id) != SW_SUCCESS)
    {
        SayInSea(sea, "no input was added: there is no scene to add it to, or no room for another");
        return false;
    }
    fresh.filedDef = fresh.takenDef = fresh.def;
    if (swScene_AddInput(sea->scene, &fresh.def, -1) != SW_SUCCESS)
    {
        swDestroyInput(sea->world, fresh.id);
        return false;
    }
    sea->inputs[sea->scene->inputCount - 1] = fresh;
    sea->floorVersion += field == SW_INPUT_FLOOR;
    return true;
}

void RemoveInput(Sea* sea, int index)
{
    SeaInput* input = &sea->inputs[index];
    input->hasChanged = true;
    input->isRemoved = true;
    if (!input->isAdded)
    {
        return;
    }
    sea->floorVersion += input->takenDef.field == SW_INPUT_FLOOR;
    swDestroyInput(sea->world, input->id);
    free(input->points);
    memmove(input, input + 1, (size_t)(sea->scene->inputCount - 1 - index) * sizeof(SeaInput));
    swScene_RemoveInput(sea->scene, index);
}

void BringBackInput(Sea* sea, int index)
{
    sea->inputs[index].isRemoved = false;
    sea->inputs[index].hasChanged = true;
}
