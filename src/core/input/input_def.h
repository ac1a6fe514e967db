// SPDX-License-Identifier: MIT
#pragma once

// What an input's def must hold.

#include "core/base/field.h"
#include "seaway/input.h"

extern const swFields swInputFields;

// SW_ERROR_INVALID or SW_ERROR_UNSUPPORTED, and a sentence in the log that names the input and the remedy.
swResult swCheckInputDef(const swHost* host, const swInputDef* def);
// Of a def that was checked: what its shape does not look at may be anything, and is dropped before a world keeps it.
void swForgetUnused(swInputDef* def);
// What swInput_SetValue() and swInput_SetWeight() may change.
swResult swCheckInputValues(const swHost* host, const swInputDef* def);
swResult swCheckInputPoints(const swHost* host, const swInputDef* def, int count, const swInputPoint* points);

// The words of a field and a shape, as scene files have them.
const char* swGetInputFieldWord(int field);
const char* swGetInputShapeWord(int shape);
