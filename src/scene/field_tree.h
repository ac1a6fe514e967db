// SPDX-License-Identifier: MIT
#pragma once

// Fields of defs as keys and values of a tree.

#include "scene/exact_number.h"
#include "scene/yaml_tree.h"
#include "seaway/field.h"

// The shortest text that is read as the same number. An angle beyond a turn is written as that within it, which is the
// same direction.
void swPrintFieldNumber(const swField* field, double value, char text[SW_NUMBER_TEXT]);

// A field of a def, and its node; `usual` is what the def has where a file says nothing, NULL that of the table.
// Numbers without end and empty texts have no node, -1: they are what is meant where the key is missing.
int swAddField(swTree* tree, int parent, const swField* field, const void* def, const void* usual);

// All fields of a table that stand in a section, those of the defs within as well.
void swAddFields(swTree* tree, int parent, const swFields* fields, const void* def, const char* section);
