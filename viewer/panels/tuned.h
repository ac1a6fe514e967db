// SPDX-License-Identifier: MIT
#pragma once

// Widgets for values that a file has too: where they differ there is a mark, and a click on it brings the file's value
// back. `filed` is that value, or NULL if no file has one. All return whether the value has changed.

#include "tuning.h"
#include "ui.h"

bool TurnKnob(const Knob* knob, float* value, const float* filed);
bool TurnSwitch(const char* label, bool* value, const bool* filed);
bool TurnCount(const char* label, int* value, const int* filed, int low, int high, const char* format);
bool TurnChoice(const char* label, int* index, const int* filed, int count, UiItemFcn getName, void* context);
bool TurnColor(const char* label, swVec3* rgb, const swVec3* filed);

// A value by its field of a table, see seaway/field.h: the widget, its range, unit and tip are the field's. `label`
// NULL: the field's too.
bool TurnValue(const swField* field, const char* label, void* value, const void* filed);

// The same of a def. Fields that are defs, lists or no values have no widget.
bool TurnField(const swField* field, void* def, const void* filed);
bool TurnMember(const swFields* fields, const char* member, void* def, const void* filed);

// Every field of a def that counts, in the order of its table.
bool TurnFields(const swFields* fields, void* def, const void* filed);

float ToDegrees(float radians);

// Where waves come from, degrees clockwise from north, of a direction they go.
float ToBearing(float direction);
