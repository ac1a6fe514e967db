// SPDX-License-Identifier: MIT
#pragma once

// What a scene was read from, kept for writing it; and what a scene consists of.

#include "files/file_text.h"
#include "scene/scene_fields.h"
#include "scene/yaml_tree.h"

// Lines of what remarks about a whole scene speak of; the file's first where it has no such key.
typedef struct swSceneLines
{
    int waves, views, view, foam, looks;
} swSceneLines;

struct swSceneSource
{
    char* text; // `size` + 1 bytes
    size_t size;
    char name[SW_MAX_PATH];   // for messages; its path if it is a file
    char folder[SW_MAX_PATH]; // that the files in it are relative to
    bool isFile;
    swSceneLines lines;                     // 0 of what was read from no text
    swTree tree;                            // what the text says
    swWavesText waves[SW_MAX_WAVE_SYSTEMS]; // by item
    int records[SW_MAX_WAVE_SYSTEMS];       // as they were chosen
    swSeaReplayDef replays[SW_MAX_WAVE_SYSTEMS];
};

// The defs of a scene whose fields make its sections.
typedef struct swScenePart
{
    const swFields* fields;
    size_t offset;
} swScenePart;

#define SW_SCENE_PART_COUNT 4
swScenePart swGetScenePart(int index);

// The sections that those fields stand in, in order; returns their number.
#define SW_SCENE_MAX_SECTIONS 24
int swListSceneSections(const char* sections[SW_SCENE_MAX_SECTIONS]);

// A scene with nothing but defaults, and an empty text. NULL if there is no memory.
swScene* swMakeScene(const swHost* host, const char* name, const char* folder);

// Take over a text that says what the scene has. It is freed with the scene also if this fails.
swResult swKeepSceneText(swScene* scene, char* text, size_t size);

// As swReadSceneText(), without opening files of measured seas.
swResult swReadSceneKeys(const swHost* host, const char* text, size_t size, const char* name, swScene** scene);

// ---- scene_tree.c ----

// What a file of the scene would say. `isAsRead`: nothing was changed since, so waves are told as the file does. Needs
// swFreeTree(); isBroken if there is no memory.
swTree swMakeSceneTree(const swScene* scene, bool isAsRead);
