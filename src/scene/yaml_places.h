// SPDX-License-Identifier: MIT
#pragma once

// Where the values of a YAML text stand: bytes, lines, dashes, and what else uses them.

#include "scene/yaml_read.h"
#include "scene/yaml_tree.h"

typedef struct swYamlPlaces
{
    swYaml* yaml;
    const char* text;
    size_t size;
    swArray bytes;  // uint32_t: of each character where it begins; libyaml counts characters
    swArray shares; // int: how often each node is used; by * more than once
} swYamlPlaces;

// The text that `yaml` was opened from. Needs swEndYamlPlaces() whatever it gives.
swResult swBeginYamlPlaces(swYaml* yaml, const char* text, size_t size, swYamlPlaces* places);
void swEndYamlPlaces(swYamlPlaces* places);

// libyaml's node of a number.
yaml_node_t* swGetYamlNodeAt(const swYamlPlaces* places, int node);

bool swIsYamlBreak(char c);
bool swIsYamlSpace(char c);

// How many items a list has or pairs a mapping; and of each the item or the value.
int swCountYamlChildren(const yaml_node_t* node);
int swGetYamlChild(const yaml_node_t* node, int index);

// A mark of libyaml's as a place in bytes.
size_t swFindYamlByte(const swYamlPlaces* places, yaml_mark_t mark);

// Where a value begins, behind its anchor and tag.
size_t swFindYamlBegin(const swYamlPlaces* places, const yaml_node_t* node);

// Whether it is a collection as in [1, 2].
bool swIsInYamlBrackets(const yaml_node_t* node);

// Where an item or a key begins.
size_t swFindYamlChildBegin(const swYamlPlaces* places, const yaml_node_t* node, int index);

// Behind the last character of a value.
size_t swFindYamlEnd(const swYamlPlaces* places, const yaml_node_t* node);

// Where the line of a place begins, and the next one.
size_t swFindYamlLine(const swYamlPlaces* places, size_t at);
size_t swFindNextYamlLine(const swYamlPlaces* places, size_t at);

// Whether `*` repeats the node elsewhere, or anything in it.
bool swIsYamlShared(const swYamlPlaces* places, int node);

// The line ends of the text, and how far its sections are indented.
swLayout swFindYamlLayout(const swYamlPlaces* places);

// Where the dash before an item stands: on its line, or on one before it that holds nothing else but a comment.
bool swFindYamlDash(const swYamlPlaces* places, size_t item, size_t* dash);

// Nothing but spaces before, nothing but a comment behind.
bool swStandsAlone(const swYamlPlaces* places, size_t begin, size_t end);

// Whether a line of its own between two places is a comment. One behind a value goes with it.
bool swHasYamlComment(const swYamlPlaces* places, size_t begin, size_t end);

// Whether the sections of a text are parted by empty lines.
bool swHasYamlGaps(const swYamlPlaces* places, const yaml_node_t* node);

// The mapping whose value a collection is, and the key; NULL of what is no value.
const yaml_node_t* swFindYamlParent(const swYamlPlaces* places, const yaml_node_t* collection, const yaml_node_t** key);

// Behind the colon of a key.
size_t swFindYamlValue(const swYamlPlaces* places, const yaml_node_t* key);
