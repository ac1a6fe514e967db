// SPDX-License-Identifier: MIT

#include "scene/scene_source.h"

#include <stdio.h>
#include <string.h>

#include "core/base/assert.h"
#include "core/base/host.h"
#include "scene/yaml_read.h"

swScenePart swGetScenePart(int index)
{
    const swScenePart parts[SW_SCENE_PART_COUNT] = {
        {swGetWorldFields(), offsetof(swScene, world)},
        {swGetViewFields(), offsetof(swScene, view)},
        {swGetSkyFields(), offsetof(swScene, sky)},
        {swGetWaterFields(), offsetof(swScene, water)},
    };
    return parts[index];
}

static void addSection(const char* section, const char** sections, int* count)
{
    for (int i = 0; i < *count; ++i)
    {
        if (strcmp(sections[i], section) == 0)
        {
            return;
        }
    }
    SW_ASSERT(*count < SW_SCENE_MAX_SECTIONS);
    if (*count < SW_SCENE_MAX_SECTIONS)
    {
        sections[(*count)++] = section;
    }
}

static void listSections(const swFields* fields, const char** sections, int* count)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        const char* section = swGetFieldSection(fields, field);
        if (field->type == SW_FIELD_DEF)
        {
            listSections(field->fields, sections, count);
        }
        else if (field->key != NULL && section != NULL)
        {
            addSection(section, sections, count);
        }
    }
}

int swListSceneSections(const char* sections[SW_SCENE_MAX_SECTIONS])
{
    int count = 0;
    for (int i = 0; i < SW_SCENE_PART_COUNT; ++i)
    {
        listSections(swGetScenePart(i).fields, sections, &count);
    }
    return count;
}

swScene* swMakeScene(const swHost* host, const char* name, const char* folder)
{
    swScene* made = swAllocateZero(host, sizeof(*made));
    swSceneSource* source = swAllocateZero(host, sizeof(*source));
    if (made == NULL || source == NULL)
    {
        swFree(host, made, sizeof(*made));
        swFree(host, source, sizeof(*source));
        swFail(host, SW_ERROR_NO_MEMORY, "No memory for the scene %s.", name);
        return NULL;
    }
    snprintf(source->name, sizeof(source->name), "%s", name);
    snprintf(source->folder, sizeof(source->folder), "%s", folder != NULL ? folder : "");
    made->source = source;
    made->host = *host;
    made->world = swDefaultWorldDef();
    made->view = swDefaultViewDef();
    made->sky = swDefaultSkyDef();
    made->water = swDefaultWaterDef();
    return made;
}

swResult swKeepSceneText(swScene* scene, char* text, size_t size)
{
    swSceneSource* source = scene->source;
    swFree(&scene->host, source->text, source->text != NULL ? source->size + 1 : 0);
    source->text = text;
    source->size = size;
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        source->records[i] = scene->waves[i].record;
        source->replays[i] = scene->waves[i].replay;
    }
    swFreeTree(&source->tree);
    source->tree = swMakeSceneTree(scene, true);
    return source->tree.isBroken ? swFail(&scene->host, SW_ERROR_NO_MEMORY, "No memory for the scene %s.", source->name)
                                 : SW_SUCCESS;
}
