// SPDX-License-Identifier: MIT
// The tables of keys in docs/scenes.md, from the tables that read and write scene files.
//
//   scene_docs PAGE          fails if the page's tables are not these
//   scene_docs --fix PAGE    writes them
//
// A table stands behind a line such as "<!-- keys: sun -->", which names its section; what is around it stays.

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/exact_number.h"
#include "scene/scene_inputs.h"
#include "scene/scene_source.h"
#include "scene/scene_waves.h"
#include "scene/yaml_read.h"

static void PrintNumber(FILE* out, double value)
{
    char text[SW_NUMBER_TEXT], *sign = text;
    if (isinf(value))
    {
        fputs(value > 0.0 ? "infinite" : "\xE2\x88\x92infinite", out);
        return;
    }
    swPrintDigits(value, 2, text);
    double rounded = 0.0;
    bool isRound = fabs(value) >= 1e5 && swParseExactNumber(text, (int)strlen(text), &rounded) && rounded == value;
    if (isRound)
    {
        int power = (int)floor(log10(fabs(value)));
        snprintf(text, sizeof(text), "%.15ge%d", value / pow(10.0, power), power);
    }
    else if (value == floor(value) && fabs(value) < 1e15)
    {
        snprintf(text, sizeof(text), "%.0f", value);
    }
    else
    {
        swPrintDigits(value, fabs(value) < 0.1 ? 6 : 4, text);
    }
    if (text[0] == '-')
    {
        fputs("\xE2\x88\x92", out);
        sign += 1;
    }
    char* power = strstr(sign, "e-");
    fprintf(out, "%.*s%s%s", power != NULL ? (int)(power - sign) : 100, sign, power != NULL ? "e\xE2\x88\x92" : "",
            power != NULL ? power + 2 : "");
}

static void PrintValues(FILE* out, const swField* field)
{
    double low = 0.0, high = 0.0;
    if (field->type == SW_FIELD_TEXT)
    {
        fprintf(out, "text of at most %zu bytes", field->size - 1);
        return;
    }
    if (field->type == SW_FIELD_BOOL)
    {
        fputs("`true` or `false`", out);
        return;
    }
    for (int i = 0; field->type == SW_FIELD_CHOICE && field->words[i] != NULL; ++i)
    {
        fprintf(out, "%s`%s`", i == 0 ? "" : field->words[i + 1] != NULL ? ", " : " or ", field->words[i]);
    }
    if (field->type == SW_FIELD_CHOICE)
    {
        return;
    }
    swField_GetShownRange(field, &low, &high);
    fprintf(out, "%s%s",
            field->count == 3   ? "three numbers, "
            : field->count == 4 ? "as many numbers as the field has, "
                                : "",
            field->isLowOpen ? "above " : "");
    PrintNumber(out, low);
    fputs(isinf(high) ? " and more" : field->isHighOpen ? " to below " : " to ", out);
    if (!isinf(high))
    {
        PrintNumber(out, high);
    }
}

static void PrintDefault(FILE* out, const swField* field)
{
    if (field->type == SW_FIELD_TEXT)
    {
        return;
    }
    if (field->type == SW_FIELD_BOOL || field->type == SW_FIELD_CHOICE)
    {
        int value = (int)field->defaults[0];
        fprintf(out, "`%s`", field->type == SW_FIELD_CHOICE ? field->words[value] : value != 0 ? "true" : "false");
        return;
    }
    if (field->zero != NULL && field->defaults[0] == 0.0)
    {
        fprintf(out, "0: %s", field->zero);
        return;
    }
    for (int i = 0; i < field->count; ++i)
    {
        fputs(i > 0 ? ", " : "", out);
        double shown = swField_Show(field, field->defaults[i]);
        PrintNumber(out, shown + (field->form == SW_FORM_BEARING && shown < 0.0 ? 360.0 : 0.0));
    }
}

static void PrintMeaning(FILE* out, const swField* field)
{
    bool isName = field->tip != NULL && isupper((unsigned char)field->tip[1]); // such as UTC
    char first = field->tip == NULL ? '\0' : isName ? field->tip[0] : (char)tolower((unsigned char)field->tip[0]);
    fprintf(out, "%s", field->label);
    if (field->tip != NULL)
    {
        fprintf(out, ": %c%s", first, field->tip + 1);
    }
}

static bool IsKind(const char* key)
{
    return strcmp(key, swGetWavesWord(SW_WAVES_BEAUFORT)) == 0 || strcmp(key, swGetWavesWord(SW_WAVES_SEA_STATE)) == 0;
}

// "all", "all but `file`", or the kinds.
static void PrintKinds(FILE* out, const char* key)
{
    if (IsKind(key))
    {
        fputs("in place of `spectrum`", out);
        return;
    }
    int count = 0, printed = 0;
    for (int kind = 0; kind < SW_WAVES_KIND_COUNT; ++kind)
    {
        count += swGoesWithWaves(key, kind);
    }
    bool isMost = 2 * count > SW_WAVES_KIND_COUNT;
    fputs(count == SW_WAVES_KIND_COUNT ? "all" : isMost ? "all but " : "", out);
    for (int kind = 0; kind < SW_WAVES_KIND_COUNT && count < SW_WAVES_KIND_COUNT; ++kind)
    {
        if (swGoesWithWaves(key, kind) != isMost)
        {
            fprintf(out, "%s`%s`", printed++ > 0 ? ", " : "", swGetWavesWord(kind));
        }
    }
}

static void PrintKey(FILE* out, const swField* field, const char* section)
{
    bool isOfWaves = strcmp(section, "waves") == 0;
    fprintf(out, "| `%s` | ", field->key);
    PrintValues(out, field);
    fputs(" | ", out);
    if (isOfWaves)
    {
        PrintKinds(out, field->key);
    }
    else
    {
        PrintDefault(out, field);
    }
    fputs(" | ", out);
    PrintMeaning(out, field);
    bool hasDefault = field->type != SW_FIELD_TEXT && swField_IsInRange(field, field->defaults[0]);
    if (isOfWaves && hasDefault && !IsKind(field->key))
    {
        fputs(" (", out);
        PrintDefault(out, field);
        fputs(")", out);
    }
    fputs(" |\n", out);
}

static void PrintSection(FILE* out, const char* section)
{
    swYamlMapping mapping;
    const swFields* const tables[] = {
        swGetSceneFields(),       swGetSceneViewFields(),     swGetWavesTextFields(),   swGetMeasuredTextFields(),
        swGetOctaveTextFields(),  swGetOctaveFields(),        swGetOctavesFields(),     swGetWaveSystemFields(),
        swGetWorldFields(),       swGetWaveComponentFields(), swGetViewFields(),        swGetSkyFields(),
        swGetWaterFields(),       swGetInputFields(),         swGetSceneRasterFields(), swGetInputPointFields(),
        swGetSplineFields(),      swGetSplinePointFields(),   swGetWaterBodyFields(),   swGetIslandFields(),
        swGetSceneMeshFields(),   swGetSceneHullFields(),     swGetTideFields(),        swGetWindSeaFields(),
        swGetSceneMotionFields(), swGetScenePathFields(),
    };
    swBeginYamlMapping(&mapping, section);
    for (size_t i = 0; i < sizeof(tables) / sizeof(tables[0]); ++i)
    {
        swAddYamlFields(&mapping, tables[i], 0, section);
    }
    bool isOfWaves = strcmp(section, "waves") == 0;
    fprintf(out, "| Key | Values | %s | Meaning%s |\n| --- | --- | --- | --- |\n", isOfWaves ? "Goes with" : "Default",
            isOfWaves ? " (default)" : "");
    for (int i = 0; i < mapping.count; ++i)
    {
        if (strcmp(mapping.keys[i].key, "spectrum") != 0) // whose words the text around the table explains
        {
            PrintKey(out, mapping.keys[i].field, section);
        }
    }
}

static char* ReadPage(const char* path)
{
    FILE* file = fopen(path, "rb");
    char* text = calloc(1, 1 << 20);
    if (file == NULL || text == NULL || fread(text, 1, (1 << 20) - 1, file) == 0)
    {
        fprintf(stderr, "scene_docs: cannot read %s\n", path);
        exit(1);
    }
    fclose(file);
    return text;
}

// The page with its tables made anew.
static char* MakePage(const char* page)
{
    static const char mark[] = "<!-- keys: ";
    char* made = NULL;
    size_t size = 0;
    FILE* out = open_memstream(&made, &size);
    for (const char* at = strstr(page, mark); at != NULL; at = strstr(page, mark))
    {
        char section[64] = "";
        sscanf(at + strlen(mark), "%63s", section);
        const char* table = strchr(at, '\n');
        fwrite(page, 1, (size_t)(table + 1 - page), out);
        fputs("\n", out);
        PrintSection(out, section);
        page = table + 1;
        while (*page == '\n' || *page == '|')
        {
            page = strchr(page, '\n') + 1;
        }
        fputs("\n", out);
    }
    fputs(page, out);
    fclose(out);
    return made;
}

int main(int argc, char** argv)
{
    bool isFix = argc == 3 && strcmp(argv[1], "--fix") == 0;
    if (argc != 2 && !isFix)
    {
        fprintf(stderr, "usage: scene_docs [--fix] PAGE\n");
        return 2;
    }
    const char* path = argv[argc - 1];
    char *page = ReadPage(path), *made = MakePage(page);
    bool isSame = strcmp(page, made) == 0;
    if (!isSame && isFix)
    {
        FILE* file = fopen(path, "wb");
        isSame = file != NULL && fputs(made, file) >= 0 && fclose(file) == 0;
    }
    if (!isSame)
    {
        fprintf(stderr, "scene_docs: the tables of %s are not those of the library; run scripts/make_scene_docs\n",
                path);
    }
    free(page);
    free(made);
    return isSame ? 0 : 1;
}
