// SPDX-License-Identifier: MIT
#pragma once

// Authored fields at the points of `seaway query --fields`.

#include <seaway/input.h>

typedef enum FieldName
{
    FIELD_DEPTH,
    FIELD_FLOOR,
    FIELD_LEVEL,
    FIELD_FLOW,
    FIELD_CLIP,
    FIELD_BODY,
    FIELD_WIND,
    FIELD_FOAM,
    FIELD_ALBEDO,
    FIELD_SHADOW,
    FIELD_DISPLACEMENT,
    FIELD_COUNT
} FieldName;

// The fields asked for, in the order in which they were named.
typedef struct FieldList
{
    int count;
    FieldName fields[FIELD_COUNT];
} FieldList;

// "depth,level". Complains about what is no field, or named twice.
bool ParseFieldList(const char* text, FieldList* list);

// ",depth_m,level_m"
void PrintFieldColumns(const FieldList* list);

// Of at most FIELD_BLOCK points. Rows are printed one by one, each without what comes before the fields.
#define FIELD_BLOCK 4096
typedef struct FieldAnswers FieldAnswers;
const FieldAnswers* AskFields(const swWorld* world, int count, const swPosXZ* points);
void PrintFieldRow(const FieldList* list, const FieldAnswers* answers, int row);
