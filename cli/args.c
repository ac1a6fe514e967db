// SPDX-License-Identifier: MIT
#include "args.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "seaway/stage.h"

#include "output.h"
#include "common.h"

#define MAX_OPTIONS 32
#define MAX_NAME 64

static int Smallest(int a, int b, int c)
{
    int least = a < b ? a : b;
    return least < c ? least : c;
}

// Edits (insert, delete, replace) that turn one word into the other.
static int CountEdits(const char* a, const char* b)
{
    size_t lengthA = strlen(a), lengthB = strlen(b);
    if (lengthA >= MAX_NAME || lengthB >= MAX_NAME)
    {
        return MAX_NAME;
    }
    int row[MAX_NAME + 1];
    for (size_t j = 0; j <= lengthB; ++j)
    {
        row[j] = (int)j;
    }
    for (size_t i = 1; i <= lengthA; ++i)
    {
        int diagonal = row[0];
        row[0] = (int)i;
        for (size_t j = 1; j <= lengthB; ++j)
        {
            int above = row[j];
            row[j] = Smallest(above + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1]));
            diagonal = above;
        }
    }
    return row[lengthB];
}

const char* FindNearestName(const char* word, const char* const* names)
{
    const char* nearest = NULL;
    int fewest = (int)strlen(word) / 2 + 1; // half of the word may be wrong
    for (; *names != NULL; ++names)
    {
        int edits = CountEdits(word, *names);
        if (edits < fewest || (nearest == NULL && strlen(word) >= 2 && strncmp(word, *names, strlen(word)) == 0))
        {
            fewest = edits;
            nearest = *names;
        }
    }
    return nearest;
}

bool ParseNumber(const char* text, double* number)
{
    char* end = NULL;
    double value = strtod(text, &end);
    if (end == text || *end != 0 || !isfinite(value))
    {
        return false;
    }
    *number = value;
    return true;
}

static void PrintHelp(const Verb* verb)
{
    printf("Usage: seaway %s %s\n\n%s\n\nOptions:\n", verb->name, verb->synopsis, verb->text);
    for (int i = 0; i < verb->optionCount; ++i)
    {
        const Option* option = verb->options + i;
        char left[MAX_NAME];
        snprintf(left, sizeof(left), "--%s%s%s", option->name, option->placeholder != NULL ? " " : "",
                 option->placeholder != NULL ? option->placeholder : "");
        printf("  %-24s %s\n", left, option->help);
    }
    printf("  %-24s %s\n", "--help", "this text");
}

static bool ParseSize(const Verb* verb, const Option* option, const char* text)
{
    PixelSize* size = option->value;
    int width = 0, height = 0, used = 0;
    if (sscanf(text, "%dx%d%n", &width, &height, &used) != 2 || text[used] != 0)
    {
        Complain("%s: --%s wants a width and a height such as 1280x720, not \"%s\"", verb->name, option->name, text);
        return false;
    }
    int least = (int)option->min, most = (int)option->max;
    if (width < least || height < least || width > most || height > most)
    {
        Complain("%s: --%s %s is outside the range of %d to %d pixels", verb->name, option->name, text, least, most);
        return false;
    }
    *size = (PixelSize){width, height};
    return true;
}

static bool ParseDevice(const Verb* verb, const Option* option, const char* text)
{
    DeviceName* device = option->value;
    if (!swParseStageDevice(text, &device->choice, &device->index))
    {
        Complain("%s: --%s is auto, gpu, software or a number that `seaway devices` lists, not \"%s\"", verb->name,
                 option->name, text);
        return false;
    }
    return true;
}

// The index of the word, or -1 after a sentence.
static int FindWord(const Verb* verb, const Option* option, const char* const* words, const char* text)
{
    char all[512] = "";
    for (int i = 0; words[i] != NULL; ++i)
    {
        if (strcmp(text, words[i]) == 0)
        {
            return i;
        }
        size_t used = strlen(all);
        snprintf(all + used, sizeof(all) - used, "%s%s", i == 0 ? "" : ", ", words[i]);
    }
    const char* nearest = FindNearestName(text, words);
    if (nearest != NULL)
    {
        Complain("%s: --%s %s is unknown; did you mean %s?", verb->name, option->name, text, nearest);
    }
    else
    {
        Complain("%s: --%s is one of %s, not \"%s\"", verb->name, option->name, all, text);
    }
    return -1;
}

static bool ParseChoice(const Verb* verb, const Option* option, const char* text)
{
    int index = FindWord(verb, option, option->choices, text);
    if (index >= 0)
    {
        *(int*)option->value = index;
    }
    return index >= 0;
}

static bool ParseDebug(const Verb* verb, const Option* option, const char* text)
{
    static const char prefix[] = "layer:";
    DebugName* debug = option->value;
    if (strncmp(text, prefix, sizeof(prefix) - 1) == 0)
    {
        char problem[512] = "";
        debug->sheet = swDefaultSheetDef();
        debug->isSheet = swParseSheet(text + sizeof(prefix) - 1, &debug->sheet, problem, sizeof(problem));
        if (!debug->isSheet)
        {
            Complain("%s: --%s %s: %s", verb->name, option->name, text, problem);
        }
        return debug->isSheet;
    }
    const char* names[SW_DEBUG_COUNT + 2] = {NULL};
    for (int i = 0; i < SW_DEBUG_COUNT; ++i)
    {
        names[i] = swDebugMode_GetName((swDebugMode)i);
    }
    names[SW_DEBUG_COUNT] = "layer:NAME";
    int index = FindWord(verb, option, names, text);
    if (index == SW_DEBUG_COUNT)
    {
        return ParseDebug(verb, option, prefix); // says which names there are
    }
    debug->mode = index >= 0 ? (swDebugMode)index : SW_DEBUG_NONE;
    return index >= 0;
}

static bool ParseRanged(const Verb* verb, const Option* option, const char* text)
{
    double number = 0.0;
    bool isWhole = option->kind == OPTION_INT;
    if (!ParseNumber(text, &number) || (isWhole && number != floor(number)))
    {
        Complain("%s: --%s wants a %s, not \"%s\"", verb->name, option->name, isWhole ? "whole number" : "number",
                 text);
        return false;
    }
    if (number < option->min || number > option->max)
    {
        Complain("%s: --%s %s is outside its range of %.10g to %.10g", verb->name, option->name, text, option->min,
                 option->max);
        return false;
    }
    if (isWhole)
    {
        *(int*)option->value = (int)number;
    }
    else
    {
        *(double*)option->value = number;
    }
    return true;
}

// The kind of file is known by its ending, and a device or FIFO is whatever is written into it.
static bool ParseOutput(const Verb* verb, const Option* option, const char* text)
{
    if (*text == 0)
    {
        Complain("%s: --%s wants the name of a file, not an empty one", verb->name, option->name);
        return false;
    }
    if (strcmp(text, "-") == 0)
    {
        Complain("%s: --%s wants the name of a file; standard output is /dev/stdout", verb->name, option->name);
        return false;
    }
    if (strlen(text) >= MAX_PATH_LENGTH)
    {
        Complain("%s: --%s has a path of %zu bytes, and the longest has %d", verb->name, option->name, strlen(text),
                 MAX_PATH_LENGTH - 1);
        return false;
    }
    char all[64] = "";
    bool isKnown = option->choices == NULL || IsDevice(text);
    for (int i = 0; !isKnown && option->choices[i] != NULL; ++i)
    {
        size_t used = strlen(all);
        snprintf(all + used, sizeof(all) - used, "%s%s", i == 0 ? "" : " or ", option->choices[i]);
        isKnown = HasEnding(text, option->choices[i]);
    }
    if (!isKnown)
    {
        Complain("%s: --%s writes %s, and \"%s\" is named otherwise; give it that ending", verb->name, option->name,
                 all, text);
        return false;
    }
    *(const char**)option->value = text;
    return true;
}

static bool ParseValue(const Verb* verb, const Option* option, const char* text)
{
    switch (option->kind)
    {
    case OPTION_FLAG:
        *(bool*)option->value = true;
        return true;
    case OPTION_TEXT:
        *(const char**)option->value = text;
        return true;
    case OPTION_OUTPUT:
        return ParseOutput(verb, option, text);
    case OPTION_INT:
    case OPTION_NUMBER:
        return ParseRanged(verb, option, text);
    case OPTION_SIZE:
        return ParseSize(verb, option, text);
    case OPTION_DEVICE:
        return ParseDevice(verb, option, text);
    case OPTION_CHOICE:
        return ParseChoice(verb, option, text);
    case OPTION_DEBUG:
        return ParseDebug(verb, option, text);
    }
    return false;
}

static void ComplainAboutOption(const Verb* verb, const char* name)
{
    const char* names[MAX_OPTIONS + 2] = {"help"};
    for (int i = 0; i < verb->optionCount; ++i)
    {
        names[i + 1] = verb->options[i].name;
    }
    const char* nearest = FindNearestName(name, names);
    if (nearest != NULL)
    {
        Complain("%s: there is no option --%s; did you mean --%s?", verb->name, name, nearest);
    }
    else
    {
        Complain("%s: there is no option --%s; `seaway %s --help` lists them", verb->name, name, verb->name);
    }
}

static int FindOption(const Verb* verb, const char* name)
{
    for (int i = 0; i < verb->optionCount; ++i)
    {
        if (strcmp(verb->options[i].name, name) == 0)
        {
            return i;
        }
    }
    return -1;
}

// Parse arguments[*index], an option, and its value, which may be the next argument.
static bool ParseOption(const Verb* verb, int argumentCount, char** arguments, int* index, bool* isGiven)
{
    const char* text = arguments[*index] + 1;
    text += *text == '-';
    char name[MAX_NAME];
    snprintf(name, sizeof(name), "%s", text);
    char* equals = strchr(name, '=');
    const char* value = equals != NULL ? strchr(text, '=') + 1 : NULL;
    if (equals != NULL)
    {
        *equals = 0;
    }
    int number = FindOption(verb, name);
    if (number < 0)
    {
        ComplainAboutOption(verb, name);
        return false;
    }
    const Option* option = verb->options + number;
    if (isGiven[number])
    {
        Complain("%s: --%s is given twice; leave one of them out", verb->name, name);
        return false;
    }
    isGiven[number] = true;
    if (option->kind == OPTION_FLAG && value != NULL)
    {
        Complain("%s: --%s takes no value", verb->name, name);
        return false;
    }
    if (option->kind != OPTION_FLAG && value == NULL)
    {
        if (*index + 1 >= argumentCount)
        {
            Complain("%s: --%s wants a value: --%s %s", verb->name, name, name, option->placeholder);
            return false;
        }
        *index += 1;
        value = arguments[*index];
        if (strncmp(value, "--", 2) == 0)
        {
            Complain("%s: --%s wants a value, and \"%s\" looks like an option; if it is meant, write --%s=%s",
                     verb->name, name, value, name, value);
            return false;
        }
    }
    return ParseValue(verb, option, value);
}

// Given, and of a choice not the first, which is what would be without it.
static bool IsOn(const Verb* verb, const char* name, const bool* isGiven)
{
    int number = FindOption(verb, name);
    if (number < 0 || !isGiven[number])
    {
        return false;
    }
    const Option* option = verb->options + number;
    const DebugName* debug = option->value;
    return option->kind == OPTION_DEBUG    ? debug->isSheet || debug->mode != SW_DEBUG_NONE
           : option->kind == OPTION_CHOICE ? *(const int*)option->value != 0
                                           : true;
}

// Nobody turns a knob that does nothing.
static bool CheckEffects(const Verb* verb, const bool* isGiven)
{
    for (int i = 0; i < verb->optionCount; ++i)
    {
        const Option* option = verb->options + i;
        if (!isGiven[i])
        {
            continue;
        }
        if (option->needs != NULL && !IsOn(verb, option->needs, isGiven))
        {
            const Option* needed = verb->options + FindOption(verb, option->needs);
            Complain("%s: --%s has no effect without --%s%s%s; add that, or leave it out", verb->name, option->name,
                     needed->name, needed->kind == OPTION_CHOICE ? " " : "",
                     needed->kind == OPTION_CHOICE ? needed->choices[1] : "");
            return false;
        }
        for (int j = 0; option->without != NULL && option->without[j] != NULL; ++j)
        {
            if (IsOn(verb, option->without[j], isGiven))
            {
                Complain("%s: --%s has no effect with --%s; leave one of them out", verb->name, option->name,
                         option->without[j]);
                return false;
            }
        }
    }
    return true;
}

ParseResult ParseArguments(const Verb* verb, int argumentCount, char** arguments)
{
    int positionalCount = 0;
    bool areOptionsOver = false;
    bool isGiven[MAX_OPTIONS] = {false};
    for (int i = 1; i < argumentCount; ++i)
    {
        const char* text = arguments[i];
        if (!areOptionsOver && (strcmp(text, "--help") == 0 || strcmp(text, "-h") == 0))
        {
            PrintHelp(verb);
            return PARSE_HELP;
        }
        if (!areOptionsOver && strcmp(text, "--") == 0)
        {
            areOptionsOver = true;
        }
        else if (!areOptionsOver && text[0] == '-' && text[1] != 0)
        {
            if (!ParseOption(verb, argumentCount, arguments, &i, isGiven))
            {
                return PARSE_WRONG;
            }
        }
        else if (positionalCount == verb->positionalMax)
        {
            Complain("%s: \"%s\" is one argument too many; usage: seaway %s %s", verb->name, text, verb->name,
                     verb->synopsis);
            return PARSE_WRONG;
        }
        else
        {
            verb->positionals[positionalCount++] = text;
        }
    }
    if (positionalCount < verb->positionalMin)
    {
        Complain("%s: %s is missing; usage: seaway %s %s", verb->name, verb->positionalName, verb->name,
                 verb->synopsis);
        return PARSE_WRONG;
    }
    if (verb->isGiven != NULL)
    {
        memcpy(verb->isGiven, isGiven, (size_t)verb->optionCount * sizeof(bool));
    }
    return CheckEffects(verb, isGiven) ? PARSE_FINE : PARSE_WRONG;
}

int GetParseExit(ParseResult result)
{
    return result == PARSE_HELP ? EXIT_FINE : EXIT_USAGE;
}
