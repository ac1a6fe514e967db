// SPDX-License-Identifier: MIT
// What a scene's file would say, by the tables of its defs. Waves keep the way in which the file tells of them, such as
// `beaufort: 4`, as long as that makes the def that is wanted; otherwise every field is named.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/field.h"
#include "scene/field_tree.h"
#include "scene/scene_lists.h"
#include "scene/scene_source.h"
#include "scene/waves_tree.h"
#include "scene/yaml_read.h"

// ---- how waves are told ----

static void sayNothing(void* context, swLogLevel level, const char* message)
{
    (void)context;
    (void)level;
    (void)message;
}

// Whether a def is made of what is written of it. Directions are compared as they are written: a turn more is none.
// What has no effect beside the rest is not written.
static bool isSameDef(const swWaveSystemDef* def, const swWaveSystemDef* read)
{
    swWaveSystemDef other = *read;
    char wanted[SW_NUMBER_TEXT], found[SW_NUMBER_TEXT];
    const swField* direction = swFields_Find(swGetSpectrumFields(), "direction");
    swPrintFieldNumber(direction, (double)def->spectrum.direction, wanted);
    swPrintFieldNumber(direction, (double)other.spectrum.direction, found);
    other.spectrum.direction = strcmp(wanted, found) == 0 ? def->spectrum.direction : other.spectrum.direction;
    bool hasExponent = def->spectrum.spreading == SW_SPREADING_COSINE_2S;
    other.spectrum.spreadExponent = hasExponent ? other.spectrum.spreadExponent : def->spectrum.spreadExponent;
    other.spectrum.growth = def->spectrum.peakPeriod > 0.0f ? def->spectrum.growth : other.spectrum.growth;
    return swIsSameDef(swGetWaveSystemFields(), def, &other) &&
           swIsSameDef(swGetSpectrumFields(), &def->spectrum, &other.spectrum);
}

static bool isReadBack(swWavesWriter* writer)
{
    swHost host = writer->scene->host;
    host.log = sayNothing;
    swTree tree = swBeginTree(&host, SW_TREE_MAPPING);
    int list = swAddTreeNode(&tree, 0, SW_TREE_LIST, "waves");
    int item = swAddTreeNode(&tree, list, SW_TREE_MAPPING, NULL);
    swFillWavesTree(&tree, item, writer);
    swTextBuffer buffer = {.host = &host};
    swLayout layout = {"\n", 2};
    bool isSame = false;
    if (!tree.isBroken)
    {
        swAddTreePair(&buffer, &layout, &tree, list, 0);
    }
    swScene* read = NULL;
    swResult result = tree.isBroken || buffer.isBroken
                          ? SW_ERROR_NO_MEMORY
                          : swReadSceneKeys(&host, buffer.chars.data, buffer.chars.count, "waves", &read);
    writer->isBroken = writer->isBroken || result == SW_ERROR_NO_MEMORY;
    isSame = result == SW_SUCCESS && isSameDef(&writer->waves->def, &read->waves[0].def);
    swDestroyScene(read);
    swFreeItems(&host, &buffer.chars, 1);
    swFreeTree(&tree);
    return isSame;
}

// Beaufort's number of a spectrum, if that is what made it; written with as few digits as that takes.
static bool findBeaufort(swWavesWriter* writer)
{
    double number = pow((double)writer->waves->def.spectrum.windSpeed / 0.836, 2.0 / 3.0);
    double scale = 1.0;
    writer->text.kind = SW_WAVES_BEAUFORT;
    for (int digits = 0; digits < 4 && number <= 12.0005; ++digits, scale *= 10.0)
    {
        writer->text.beaufort = (float)(round(number * scale) / scale);
        if (isReadBack(writer))
        {
            return true;
        }
    }
    return false;
}

// The file's way of telling if it makes the def, otherwise the kind with all its fields.
static void chooseForm(swWavesWriter* writer)
{
    const swWaveSystemDef* def = &writer->waves->def;
    swWavesText before = writer->text;
    bool isKnob = before.kind >= SW_SPECTRUM_KIND_COUNT && before.kind != SW_WAVES_COMPONENTS;
    if (def->componentCount > 0)
    {
        writer->text.kind = SW_WAVES_COMPONENTS;
        return;
    }
    if (writer->waves->measured != NULL || def->spectrum.kind == SW_SPECTRUM_TABLE)
    {
        writer->text.kind = SW_SPECTRUM_TABLE;
        return;
    }
    if (!writer->isNew && (isKnob || before.kind == SW_SPECTRUM_OCTAVES) && isReadBack(writer))
    {
        return;
    }
    bool mayBeKnob = writer->isNew || before.kind == SW_WAVES_BEAUFORT;
    if (mayBeKnob && def->spectrum.kind == SW_SPECTRUM_JONSWAP && findBeaufort(writer))
    {
        return;
    }
    writer->text = before;
    writer->text.kind = def->spectrum.kind;
    if (writer->text.kind == SW_SPECTRUM_OCTAVES && !isReadBack(writer))
    {
        writer->text.octaves.start = 0;
    }
}

static void addWaves(swTree* tree, int list, const swScene* scene, int index, bool isAsRead)
{
    const swSceneWaves* waves = &scene->waves[index];
    int from = waves->item - 1;
    swWavesWriter writer = {.scene = scene, .waves = waves, .isNew = from < 0};
    if (from >= 0)
    {
        writer.text = scene->source->waves[from];
        writer.record = scene->source->records[from];
        writer.replay = &scene->source->replays[from];
    }
    else
    {
        swFillDef(swGetWavesTextFields(), &writer.text);
        swFillDef(swGetMeasuredTextFields(), &writer.text.measured);
        snprintf(writer.text.measured.file, sizeof(writer.text.measured.file), "%s", waves->file);
        for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
        {
            writer.text.octaves.octaves[i].item = -1;
        }
        writer.replay = &waves->replay;
    }
    if (!isAsRead)
    {
        chooseForm(&writer);
        tree->isBroken = tree->isBroken || writer.isBroken;
    }
    int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
    swSetTreeItem(tree, node, from, false);
    swFillWavesTree(tree, node, &writer);
}

// ---- the scene ----

static void addView(swTree* tree, int list, const swSceneView* view)
{
    const swFields* fields = swGetSceneViewFields();
    int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
    swSetTreeItem(tree, node, view->item - 1, false);
    for (int i = 0; i < fields->count && !tree->isBroken; ++i)
    {
        const swField* field = &fields->fields[i];
        bool isSun = strncmp(field->member, "sun", 3) == 0;
        if (field->key != NULL && (view->hasSun || !isSun))
        {
            int child = swAddField(tree, node, field, view, NULL);
            swSetTreeDefault(tree, child, !isSun && child >= 0 && swGetTreeNode(tree, child)->isDefault);
        }
    }
}

swTree swMakeSceneTree(const swScene* scene, bool isAsRead)
{
    const char* sections[SW_SCENE_MAX_SECTIONS];
    int count = swListSceneSections(sections);
    swTree tree = swBeginTree(&scene->host, SW_TREE_MAPPING);
    swAddFields(&tree, 0, swGetSceneFields(), scene, "scene");
    for (int i = 0; i < count && !tree.isBroken; ++i)
    {
        int node = swAddTreeNode(&tree, 0, SW_TREE_MAPPING, sections[i]);
        for (int j = 0; j < SW_SCENE_PART_COUNT && !tree.isBroken; ++j)
        {
            swScenePart part = swGetScenePart(j);
            swAddFields(&tree, node, part.fields, (const char*)scene + part.offset, sections[i]);
        }
    }
    int list = swAddTreeNode(&tree, 0, SW_TREE_LIST, "waves");
    for (int i = 0; i < scene->wavesCount && !tree.isBroken; ++i)
    {
        addWaves(&tree, list, scene, i, isAsRead);
    }
    swAddBodyTrees(&tree, swAddTreeNode(&tree, 0, SW_TREE_LIST, "water_bodies"), scene);
    swAddInputTrees(&tree, swAddTreeNode(&tree, 0, SW_TREE_LIST, "inputs"), scene);
    list = swAddTreeNode(&tree, 0, SW_TREE_LIST, "views");
    for (int i = 0; i < scene->viewCount && !tree.isBroken; ++i)
    {
        addView(&tree, list, &scene->views[i]);
    }
    return tree;
}
