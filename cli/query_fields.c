// SPDX-License-Identifier: MIT
#include "query_fields.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "common.h"

static const struct
{
    const char* name;
    const char* columns;
} fieldTexts[FIELD_COUNT] = {
    [FIELD_DEPTH] = {"depth", "depth_m"},
    [FIELD_FLOOR] = {"floor", "floor_m"},
    [FIELD_LEVEL] = {"level", "level_m"},
    [FIELD_FLOW] = {"flow", "flow_x_mps,flow_z_mps"},
    [FIELD_CLIP] = {"clip", "clip"},
    [FIELD_BODY] = {"body", "body"},
    [FIELD_WIND] = {"wind", "wind_x_mps,wind_z_mps"},
    [FIELD_FOAM] = {"foam", "foam_per_s"},
    [FIELD_ALBEDO] = {"albedo", "albedo_red,albedo_green,albedo_blue,albedo_cover"},
    [FIELD_SHADOW] = {"shadow", "light"},
    [FIELD_DISPLACEMENT] = {"displacement", "input_dx_m,input_dy_m,input_dz_m"},
};

struct FieldAnswers
{
    float depth[FIELD_BLOCK], floor[FIELD_BLOCK], level[FIELD_BLOCK], clip[FIELD_BLOCK], foam[FIELD_BLOCK];
    float shadow[FIELD_BLOCK];
    swVec2 flow[FIELD_BLOCK], wind[FIELD_BLOCK];
    swVec3 displacement[FIELD_BLOCK];
    swVec4 albedo[FIELD_BLOCK];
    int body[FIELD_BLOCK];
};

static int FindFieldName(const char* text, size_t length)
{
    for (int i = 0; i < FIELD_COUNT; ++i)
    {
        if (strlen(fieldTexts[i].name) == length && memcmp(fieldTexts[i].name, text, length) == 0)
        {
            return i;
        }
    }
    return -1;
}

static void ComplainAboutField(const char* text, size_t length)
{
    char known[256] = "";
    for (int i = 0; i < FIELD_COUNT; ++i)
    {
        size_t used = strlen(known);
        snprintf(known + used, sizeof(known) - used, "%s%s", i > 0 ? ", " : "", fieldTexts[i].name);
    }
    Complain("query: --fields has no '%.*s'; it knows: %s", (int)(length < 60 ? length : 60), text, known);
}

bool ParseFieldList(const char* text, FieldList* list)
{
    list->count = 0;
    for (const char* at = text;; at += 1)
    {
        size_t length = strcspn(at, ",");
        int field = FindFieldName(at, length);
        if (field < 0)
        {
            ComplainAboutField(at, length);
            return false;
        }
        for (int i = 0; i < list->count; ++i)
        {
            if ((int)list->fields[i] == field)
            {
                Complain("query: --fields names %s twice", fieldTexts[field].name);
                return false;
            }
        }
        list->fields[list->count++] = (FieldName)field;
        at += length;
        if (*at == '\0')
        {
            return true;
        }
    }
}

void PrintFieldColumns(const FieldList* list)
{
    for (int i = 0; i < list->count; ++i)
    {
        printf(",%s", fieldTexts[list->fields[i]].columns);
    }
}

const FieldAnswers* AskFields(const swWorld* world, int count, const swPosXZ* points)
{
    static FieldAnswers answers;
    const swFieldSamples samples = {
        .depth = answers.depth,
        .floor = answers.floor,
        .level = answers.level,
        .flow = answers.flow,
        .clip = answers.clip,
        .foam = answers.foam,
        .albedo = answers.albedo,
        .wind = answers.wind,
        .shadow = answers.shadow,
        .displacement = answers.displacement,
        .body = answers.body,
    };
    swMoment_QueryFields(swWorld_GetMoment(world), count, points, &samples);
    return &answers;
}

static void PrintNumbers(const float* numbers, int count)
{
    for (int i = 0; i < count; ++i)
    {
        printf(",%.7g", (double)numbers[i]);
    }
}

static void PrintField(FieldName field, const FieldAnswers* answers, int row)
{
    switch (field)
    {
    case FIELD_DEPTH:
        PrintNumbers(&answers->depth[row], 1);
        break;
    case FIELD_FLOOR:
        PrintNumbers(&answers->floor[row], 1);
        break;
    case FIELD_LEVEL:
        PrintNumbers(&answers->level[row], 1);
        break;
    case FIELD_FLOW:
        PrintNumbers(&answers->flow[row].x, 2);
        break;
    case FIELD_CLIP:
        PrintNumbers(&answers->clip[row], 1);
        break;
    case FIELD_BODY:
        printf(",%d", answers->body[row]);
        break;
    case FIELD_WIND:
        PrintNumbers(&answers->wind[row].x, 2);
        break;
    case FIELD_FOAM:
        PrintNumbers(&answers->foam[row], 1);
        break;
    case FIELD_ALBEDO:
        PrintNumbers(&answers->albedo[row].x, 4);
        break;
    case FIELD_SHADOW:
        PrintNumbers(&answers->shadow[row], 1);
        break;
    default:
        PrintNumbers(&answers->displacement[row].x, 3);
        break;
    }
}

void PrintFieldRow(const FieldList* list, const FieldAnswers* answers, int row)
{
    for (int i = 0; i < list->count; ++i)
    {
        PrintField(list->fields[i], answers, row);
    }
}
