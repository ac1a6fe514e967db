// SPDX-License-Identifier: MIT
#pragma once

// Changes of a YAML text that leave every other byte as it is: comments, order, quotes, line ends. libyaml's nodes say
// where each value stands; what a change is about is found from there.

#include "scene/yaml_places.h"

// Changes are gathered, and made in one go by swMakeYamlEdits(). They must not overlap; of two at one place the first
// comes first.
typedef struct swYamlEdits
{
    swYamlPlaces places;
    swArray edits;
    swTextBuffer added;
    swLayout layout;
    swResult result; // the first failure; nothing is changed afterwards
} swYamlEdits;

// The text that `yaml` was opened from. Needs swEndYamlEdits() whatever it gives.
swResult swBeginYamlEdits(swYaml* yaml, const char* text, size_t size, swYamlEdits* edits);
void swEndYamlEdits(swYamlEdits* edits);

// The text with all changes, into memory of the host that is `*size + 1` bytes and ends with a zero.
swResult swMakeYamlEdits(swYamlEdits* edits, char** text, size_t* size);

// Refuse what cannot be changed without touching another place, with its line.
swResult swRefuseYamlEdit(swYamlEdits* edits, const yaml_node_t* node, const char* why);

// Another text for a scalar, quoted as it was.
void swReplaceYamlScalar(swYamlEdits* edits, int node, const char* text, bool isInLine);

// What the pairs of a mapping, or the items of a list, become: each of those that stand there is kept or not, and there
// are new ones. `added` is a tree's node; those with `after` -1 come before all, the others behind what stands there.
typedef struct swYamlAdded
{
    const swTree* tree;
    int node;
    int after;
} swYamlAdded;

void swArrangeYaml(swYamlEdits* edits, int collection, const bool* isKept, const swYamlAdded* added, int addedCount);

// Put a new pair of a scalar in the place of one that stands there.
void swReplaceYamlPair(swYamlEdits* edits, int mapping, int index, const swTree* tree, int node);

// A whole text that holds no value yet, such as nothing but comments.
void swFillYaml(swYamlEdits* edits, const swTree* tree, int root);
