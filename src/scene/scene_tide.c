// SPDX-License-Identifier: MIT
// Tides of a scene file: constituents by their name, such as M2, or by their speed; or a table of levels or flows, in
// the scene or in a file of its own.

#include <math.h>
#include <string.h>

#include "core/base/field.h"
#include "core/base/misuse.h"
#include "scene/exact_number.h"
#include "scene/scene_lists.h"

const char* swFindTideName(float speed)
{
    int index = 0;
    const char* name = swGetTideName(0);
    while (name != NULL && !(speed > 0.0f && swGetTideSpeed(name) == speed))
    {
        name = swGetTideName(++index);
    }
    return name;
}

static swResult readName(swYaml* yaml, yaml_node_t* node, swTideConstituent* constituent)
{
    char name[16] = "";
    swResult result = swReadYamlText(yaml, node, "constituent", name, sizeof(name));
    constituent->speed = result == SW_SUCCESS ? swGetTideSpeed(name) : 0.0f;
    return result == SW_SUCCESS && !(constituent->speed > 0.0f)
               ? swFailYaml(yaml, node, SW_MISTAKE_UNKNOWN_WORD,
                            "there is no constituent named '%s' here; take one such as M2, or give its speed_rad_s.",
                            name)
               : result;
}

static swResult readConstituent(swYaml* yaml, yaml_node_t* node, bool isFlow, swTideConstituent* constituent)
{
    static const char* const across[] = {"amplitude_across_m_s", "phase_across_deg"};
    swYamlMapping mapping;
    swFillDef(swGetTideFields(), constituent);
    swBeginYamlMapping(&mapping, "a constituent");
    swAddYamlKey(&mapping, "constituent", swKeepYamlNode);
    swAddYamlFields(&mapping, swGetTideFields(), 0, "tide");
    swResult result = swReadYamlMapping(yaml, node, &mapping, constituent);
    if (node->type != YAML_MAPPING_NODE || swIsYamlOver(yaml, result))
    {
        return result;
    }
    yaml_node_t *name = swGetYamlNode(&mapping, "constituent"), *speed = swGetYamlNode(&mapping, "speed_rad_s");
    if (name != NULL && speed != NULL)
    {
        return swFailYaml(yaml, speed, SW_MISTAKE_CONFLICT,
                          "speed_rad_s stands beside constituent, which has a speed; remove one.");
    }
    if (name == NULL && speed == NULL)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                          "the constituent has no speed; name it, such as constituent: M2, or give its speed_rad_s.");
    }
    for (int i = 0; i < 2 && !isFlow; ++i)
    {
        const yaml_node_t* key = swGetYamlNode(&mapping, across[i]);
        result = key == NULL ? result
                             : swKeepFailure(result, swFailYaml(yaml, key, SW_MISTAKE_NO_EFFECT,
                                                                "%s has no effect on a level; remove it.", across[i]));
    }
    return name != NULL ? swKeepFailure(result, readName(yaml, name, constituent)) : result;
}

static swResult readConstituents(swYaml* yaml, yaml_node_t* node, const swTideReader* tide)
{
    int count = 0;
    swResult result = swReadYamlList(yaml, node, "tide", SW_MAX_TIDE, &count);
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        result = swKeepFailure(
            result, readConstituent(yaml, swGetYamlItem(yaml, node, i), tide->isFlow, &tide->constituents[i]));
    }
    return result;
}

// ---- tables ----

static swResult makeTable(swYaml* yaml, const swTideReader* tide, int count)
{
    swSceneTide* table = tide->table;
    table->along = swAllocateZero(yaml->host, (size_t)count * sizeof(swTideLevel));
    table->across = tide->isFlow ? swAllocateZero(yaml->host, (size_t)count * sizeof(swTideLevel)) : NULL;
    table->count = count; // what is there is freed with it
    bool isMissing = table->along == NULL || (tide->isFlow && table->across == NULL);
    return isMissing ? swFail(yaml->host, SW_ERROR_NO_MEMORY, "No memory for a tide table of %s.", yaml->name)
                     : SW_SUCCESS;
}

void swFreeTide(const swHost* host, swSceneTide* tide)
{
    swFree(host, tide->along, (size_t)tide->count * sizeof(swTideLevel));
    swFree(host, tide->across, (size_t)tide->count * sizeof(swTideLevel));
    *tide = (swSceneTide){0};
}

// What is wrong with a row of numbers, beginning behind "the tide table"; NULL if nothing is.
static const char* setRow(const swTideReader* tide, int row, int count, const double numbers[3])
{
    const swSceneTide* table = tide->table;
    double most = tide->isFlow ? (double)SW_MAX_INPUT_SPEED : 1e6;
    if (count != (tide->isFlow ? 3 : 2))
    {
        return tide->isFlow ? "has a row that is not a time and two velocities, such as [0, 0.5, -0.2]"
                            : "has a row that is not a time and a level, such as [0, 1.4]";
    }
    if (!(fabs(numbers[0]) <= SW_LARGEST_TIME) || (row > 0 && !(numbers[0] > table->along[row - 1].time)))
    {
        return "has a time that does not come after the one before; times are s and ascend";
    }
    for (int i = 1; i < count; ++i)
    {
        if (!(fabs(numbers[i] + (double)tide->value[i - 1]) <= most))
        {
            return tide->isFlow ? "gives, with the input's value, a flow of more than 100 m/s"
                                : "gives, with the value, a level beyond 1e6 m";
        }
    }
    table->along[row] = (swTideLevel){numbers[0], (float)numbers[1]};
    if (tide->isFlow)
    {
        table->across[row] = (swTideLevel){numbers[0], (float)numbers[2]};
    }
    return NULL;
}

static swResult readRow(swYaml* yaml, yaml_node_t* node, const swTideReader* tide, int row)
{
    double numbers[3] = {0.0};
    int count = 0;
    swResult result = swReadYamlList(yaml, node, "a row of a tide table", 3, &count);
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        result = swReadYamlNumber(yaml, swGetYamlItem(yaml, node, i), i == 0 ? "a time" : "a number of a tide table",
                                  i == 0 ? SW_LARGEST_TIME : 1e6, &numbers[i]);
    }
    const char* wrong = result == SW_SUCCESS ? setRow(tide, row, count, numbers) : NULL;
    return wrong != NULL ? swFailYaml(yaml, node, SW_MISTAKE_OUT_OF_RANGE, "the tide table %s.", wrong) : result;
}

static swResult readRows(swYaml* yaml, yaml_node_t* node, const swTideReader* tide)
{
    int count = 0;
    swResult result = swReadYamlList(yaml, node, "tide", SW_MAX_SCENE_TIDE, &count);
    result = result == SW_SUCCESS ? makeTable(yaml, tide, count) : result;
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        result = readRow(yaml, swGetYamlItem(yaml, node, i), tide, i); // the next one is held against it
    }
    return result;
}

static bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r';
}

// Numbers of a line that are parted by spaces, commas or semicolons, at most `most`; -1 if anything else is in it.
static int readLine(const char* line, size_t size, int most, double* numbers)
{
    int count = 0;
    for (size_t at = 0; at < size;)
    {
        size_t end = at;
        while (end < size && !isSpace(line[end]))
        {
            ++end;
        }
        if (end > at && (count == most || !swParseExactNumber(line + at, (int)(end - at), &numbers[count++])))
        {
            return -1;
        }
        at = end + 1;
    }
    return count;
}

// The next line of a text that is neither empty nor a comment nor, before the first row, a heading. False at the end.
static bool findRow(const char* text, size_t size, size_t* at, bool isFirst, int* count, double numbers[4])
{
    while (*at < size)
    {
        const char* line = text + *at;
        const char* end = memchr(line, '\n', size - *at);
        size_t length = end != NULL ? (size_t)(end - line) : size - *at;
        *at += length + 1;
        *count = line[0] == '#' ? 0 : readLine(line, length, 4, numbers);
        if (*count > 0 || (*count < 0 && !isFirst))
        {
            return true;
        }
    }
    return false;
}

// One row for each line. `rows` NULL: they are only counted.
static const char* takeRows(const char* text, size_t size, const swTideReader* tide, bool isCounting, int* rows)
{
    double numbers[4] = {0.0};
    const char* wrong = NULL;
    size_t at = 0;
    int count = 0;
    *rows = 0;
    while (wrong == NULL && findRow(text, size, &at, *rows == 0, &count, numbers))
    {
        wrong = isCounting ? (*rows == SW_MAX_SCENE_TIDE ? "has more than 65536 rows" : NULL)
                           : setRow(tide, *rows, count, numbers);
        *rows += 1;
    }
    return wrong != NULL ? wrong : *rows == 0 ? "has no row of numbers" : NULL;
}

static swResult readTable(swYaml* yaml, yaml_node_t* node, const swTideReader* tide)
{
    char file[512] = "", path[SW_MAX_PATH];
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "a tide table");
    swAddYamlKey(&mapping, "file", swKeepYamlNode);
    swResult result = swReadYamlMapping(yaml, node, &mapping, NULL);
    yaml_node_t* name = swGetYamlNode(&mapping, "file");
    if (result != SW_SUCCESS || name == NULL)
    {
        return swKeepFailure(result, name == NULL ? swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY,
                                                               "the tide has no file; give it one, or a list.")
                                                  : SW_SUCCESS);
    }
    result = swReadYamlText(yaml, name, "file", file, sizeof(file));
    if (result != SW_SUCCESS || tide->reader->opensNone)
    {
        return result;
    }
    swFileText text = {0};
    int rows = 0;
    swJoinScenePath(tide->reader->folder, file, path);
    result = swReadText(yaml->host, path, (size_t)1 << 24, &text);
    const char* data = text.data != NULL ? text.data : "";
    const char* wrong = result == SW_SUCCESS ? takeRows(data, text.size, tide, true, &rows) : NULL;
    result = result == SW_SUCCESS && wrong == NULL ? makeTable(yaml, tide, rows) : result;
    wrong = result == SW_SUCCESS && wrong == NULL ? takeRows(data, text.size, tide, false, &rows) : wrong;
    swFreeText(yaml->host, &text);
    if (wrong != NULL)
    {
        return swFailYaml(yaml, name, SW_MISTAKE_BAD_FILE, "%s, a tide table, %s (row %d).", file, wrong, rows);
    }
    return result == SW_SUCCESS || result == SW_ERROR_NO_MEMORY
               ? result
               : swFailYaml(yaml, name, SW_MISTAKE_BAD_FILE,
                            "the tide table %s cannot be read; the message before says why.", file);
}

swResult swReadTide(swYaml* yaml, yaml_node_t* node, const swTideReader* tide)
{
    bool isList = node->type == YAML_SEQUENCE_NODE && node->data.sequence.items.start < node->data.sequence.items.top;
    return node->type == YAML_MAPPING_NODE                                      ? readTable(yaml, node, tide)
           : isList && swGetYamlItem(yaml, node, 0)->type == YAML_SEQUENCE_NODE ? readRows(yaml, node, tide)
                                                                                : readConstituents(yaml, node, tide);
}

// ---- at a time ----

bool swSceneInput_IsChanging(const swSceneInput* input)
{
    SW_REQUIRE(input != NULL, false, NULL, "swSceneInput_IsChanging() needs an input");
    return input->tide.count > 0;
}

void swSceneInput_GetValue(const swSceneInput* input, double time, float value[4])
{
    SW_REQUIRE_VOID(input != NULL && value != NULL, NULL,
                    "swSceneInput_GetValue() needs an input and room for a value");
    const swSceneTide* tide = &input->tide;
    memcpy(value, input->def.value, sizeof(input->def.value));
    value[0] += tide->count > 0 ? swGetTideOfTable(tide->count, tide->along, time) : 0.0f;
    value[1] += tide->across != NULL ? swGetTideOfTable(tide->count, tide->across, time) : 0.0f;
}

double swSceneWaterBody_GetLevel(const swSceneWaterBody* body, double time)
{
    SW_REQUIRE(body != NULL, 0.0, NULL, "swSceneWaterBody_GetLevel() needs a body of water");
    const swSceneTide* tide = &body->tide;
    return body->def.position.y + (tide->count > 0 ? (double)swGetTideOfTable(tide->count, tide->along, time) : 0.0);
}
