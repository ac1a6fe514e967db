// SPDX-License-Identifier: MIT
// Inputs of a scene as a file would say them: values, names of what they use, points and tides. Nests, motions and tide
// tables stay as they stand in the text.

#include <stdio.h>
#include <string.h>

#include "core/base/field.h"
#include "scene/field_tree.h"
#include "scene/scene_inputs.h"
#include "scene/scene_lists.h"

// One number by itself, several as a list in one line. Returns its node.
static int addNumbers(swTree* tree, int parent, const char* key, int count, const float* numbers)
{
    const swField* field = swFields_Find(swGetInputFields(), "value");
    int list = count > 1 ? swAddTreeNode(tree, parent, SW_TREE_LIST, key) : -1;
    int node = list;
    bool isDefault = true;
    for (int i = 0; i < count && !tree->isBroken; ++i)
    {
        char text[SW_NUMBER_TEXT];
        bool isZero = numbers[i] == 0.0f;
        swPrintFieldNumber(field, (double)numbers[i], text);
        node =
            count > 1 ? swAddTreeText(tree, list, NULL, text, isZero) : swAddTreeText(tree, parent, key, text, isZero);
        swSetTreeItem(tree, node, -1, false);
        isDefault = isDefault && isZero;
    }
    swSetTreeItem(tree, list, -1, true);
    swSetTreeDefault(tree, list, isDefault);
    swSetTreeMatched(tree, list); // another field may have more numbers
    return count > 1 ? list : node;
}

void swAddWavesNumber(swTree* tree, int parent, int waves)
{
    char text[16];
    snprintf(text, sizeof(text), "%d", waves + 1);
    if (waves >= 0)
    {
        swAddTreeText(tree, parent, "waves", text, false);
    }
}

void swAddCountedFields(swTree* tree, int parent, const swFields* fields, const void* def)
{
    for (int i = 0; i < fields->count && !tree->isBroken; ++i)
    {
        const swField* field = &fields->fields[i];
        bool isValue = fields == swGetInputFields() && strcmp(field->member, "value") == 0; // see addNumbers()
        if (field->key != NULL && field->type < SW_FIELD_DEF && !isValue && swFields_Counts(fields, field, def))
        {
            swAddField(tree, parent, field, def, NULL);
        }
    }
}

// ---- points ----

static void addPair(swTree* tree, int list, float x, float z)
{
    const float pair[2] = {x, z};
    int node = addNumbers(tree, list, NULL, 2, pair);
    swSetTreeDefault(tree, node, false);
}

static void addPoint(swTree* tree, int list, const swInputPoint* point, int valueCount)
{
    bool isPair = point->radius == 0.0f && point->weight == 1.0f;
    for (int i = 0; i < valueCount; ++i)
    {
        isPair = isPair && point->value[i] == 0.0f;
    }
    if (isPair)
    {
        addPair(tree, list, point->x, point->z);
        return;
    }
    int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
    swSetTreeItem(tree, node, -1, true);
    swAddFields(tree, node, swGetInputPointFields(), point, "points");
    swSetTreeDefault(tree, swFindTreeKey(tree, node, "x_m", 3), false);
    swSetTreeDefault(tree, swFindTreeKey(tree, node, "z_m", 3), false);
    addNumbers(tree, node, "value", valueCount, point->value);
}

void swAddPointTrees(swTree* tree, int parent, int count, const swInputPoint* points, int valueCount)
{
    int list = swAddTreeNode(tree, parent, SW_TREE_LIST, "points");
    for (int i = 0; i < count && !tree->isBroken; ++i)
    {
        addPoint(tree, list, &points[i], valueCount);
    }
    swSetTreeItem(tree, list, -1, true);
    swSetTreeMatched(tree, list);
}

void swAddShoreTrees(swTree* tree, int parent, int count, const swVec2* points)
{
    int list = swAddTreeNode(tree, parent, SW_TREE_LIST, "points");
    for (int i = 0; i < count && !tree->isBroken; ++i)
    {
        addPair(tree, list, points[i].x, points[i].y);
    }
    swSetTreeItem(tree, list, -1, true);
    swSetTreeMatched(tree, list);
}

// ---- tides ----

// A constituent by its name where its speed has one.
static void addConstituent(swTree* tree, int list, const swTideConstituent* constituent, bool isFlow)
{
    int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
    const char* name = swFindTideName(constituent->speed);
    swSetTreeItem(tree, node, -1, true);
    if (name != NULL)
    {
        swAddTreeText(tree, node, "constituent", name, false);
    }
    const swFields* fields = swGetTideFields();
    for (int i = 0; i < fields->count && !tree->isBroken; ++i)
    {
        const swField* field = &fields->fields[i];
        bool isSpeed = strcmp(field->member, "speed") == 0, isAcross = strstr(field->member, "Across") != NULL;
        if (!(isSpeed && name != NULL) && (isFlow || !isAcross))
        {
            int child = swAddField(tree, node, field, constituent, NULL);
            swSetTreeDefault(tree, child, !isSpeed && child >= 0 && swGetTreeNode(tree, child)->isDefault);
        }
    }
}

void swAddTideTrees(swTree* tree, int parent, const swTideConstituent tide[SW_MAX_TIDE], bool isFlow)
{
    int list = swAddTreeNode(tree, parent, SW_TREE_LIST, "tide");
    bool isDefault = true;
    for (int i = 0; i < SW_MAX_TIDE && !tree->isBroken; ++i)
    {
        if (tide[i].speed > 0.0f || tide[i].amplitude != 0.0f || tide[i].amplitudeAcross != 0.0f)
        {
            addConstituent(tree, list, &tide[i], isFlow);
            isDefault = false;
        }
    }
    swSetTreeItem(tree, list, -1, true);
    swSetTreeDefault(tree, list, isDefault);
    swSetTreeMatched(tree, list);
}

// ---- inputs ----

// The key and the name of what a shape needs; NULL where that is not known.
static const char* findName(const swScene* scene, const swSceneInput* input, const char** key)
{
    int index = input->resource;
    switch (index >= 0 ? input->def.shape : SW_SHAPE_EVERYWHERE)
    {
    case SW_SHAPE_RASTER:
        *key = "raster";
        return scene->rasters[index].name;
    case SW_SHAPE_MESH:
        *key = "mesh";
        return scene->meshes[index].name;
    case SW_SHAPE_HULL:
        *key = "hull";
        return scene->hulls[index].name;
    case SW_SHAPE_SPLINE:
        *key = "spline";
        return scene->splines[index].name;
    default:
        return NULL;
    }
}

static void addInput(swTree* tree, int node, const swScene* scene, const swSceneInput* input)
{
    const swInputDef* def = &input->def;
    const char* key = NULL;
    const char* name = findName(scene, input, &key);
    bool hasTide = def->field == SW_INPUT_LEVEL || def->field == SW_INPUT_FLOW;
    swAddCountedFields(tree, node, swGetInputFields(), def);
    int field = swFindTreeKey(tree, node, "field", strlen("field"));
    swSetTreeDefault(tree, field, false);
    addNumbers(tree, node, "value", swInputField_CountNumbers(def->field), def->value);
    swAddWavesNumber(tree, node, input->waves);
    if (name != NULL)
    {
        swAddTreeText(tree, node, key, name, false);
    }
    if (def->shape == SW_SHAPE_POLYGON || def->shape == SW_SHAPE_POLYLINE || def->shape == SW_SHAPE_PARTICLES)
    {
        swAddPointTrees(tree, node, input->pointCount, input->points, swInputField_CountNumbers(def->field));
    }
    if (hasTide && input->tide.count == 0)
    {
        swAddTideTrees(tree, node, def->tide, def->field == SW_INPUT_FLOW);
    }
}

void swAddInputTrees(swTree* tree, int list, const swScene* scene)
{
    for (int i = 0; i < scene->inputCount && !tree->isBroken; ++i)
    {
        const swSceneInput* input = &scene->inputs[i];
        if (input->hasLostWaves)
        {
            continue;
        }
        int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
        swSetTreeItem(tree, node, input->item - 1, false);
        addInput(tree, node, scene, input);
    }
}
