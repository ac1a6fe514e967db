// SPDX-License-Identifier: MIT
#pragma once

// Arguments of a verb, from one table: the same table parses, checks ranges and prints the help.
// Options are `--name value` or `--name=value`; `--` ends them; "-" alone is a positional argument.

#include <stdbool.h>

#include "seaway/draw.h"
#include "seaway/sheet.h"

typedef enum OptionKind
{
    OPTION_FLAG,   // bool
    OPTION_TEXT,   // const char*
    OPTION_OUTPUT, // const char*: a file to write; `choices` are the endings of what it can be, NULL: any
    OPTION_INT,    // int, in [min, max]
    OPTION_NUMBER, // double, in [min, max]
    OPTION_SIZE,   // PixelSize, WxH, each in [min, max]
    OPTION_DEVICE, // DeviceName, auto|gpu|software|INDEX
    OPTION_CHOICE, // int: index of the word in `choices`
    OPTION_DEBUG   // DebugName: a swDebugMode, or layer:NAME[.CHANNEL][:SLICE]
} OptionKind;

typedef struct PixelSize
{
    int width, height;
} PixelSize;

typedef struct DeviceName
{
    swDeviceChoice choice;
    int index;
} DeviceName;

// What is shown instead of the picture.
typedef struct DebugName
{
    swDebugMode mode;
    bool isSheet; // of a layer
    swSheetDef sheet;
} DebugName;

typedef struct Option
{
    const char* name; // without the dashes
    OptionKind kind;
    void* value;             // keeps what it holds if the option is not given
    const char* placeholder; // "T", "WxH"; NULL for flags
    const char* help;        // one line
    double min, max;
    const char* const* choices; // ends with NULL

    // An option that would have no effect is refused. "On" is what was given, other than the first of the choices
    // and no debug mode.
    const char* needs;          // the name of the option that has to be on too; NULL: none
    const char* const* without; // names of options of which none may be on; ends with NULL
} Option;

#define MAX_POSITIONALS 4

typedef struct Verb
{
    const char* name;
    const char* synopsis; // "SCENE --out FILE [options]"
    const char* text;     // what it does, for --help; lines of at most 100 characters
    const Option* options;
    int optionCount;
    int positionalMin, positionalMax;
    const char* positionalName; // of the first missing one, for messages: "a scene file"
    const char** positionals;   // [positionalMax], filled
    bool* isGiven;              // [optionCount], filled; NULL: nobody asks
} Verb;

typedef enum ParseResult
{
    PARSE_FINE,
    PARSE_HELP, // help was printed; leave with EXIT_FINE
    PARSE_WRONG // a sentence was printed; leave with EXIT_USAGE
} ParseResult;

ParseResult ParseArguments(const Verb* verb, int argumentCount, char** arguments);

// The exit code for a result other than PARSE_FINE.
int GetParseExit(ParseResult result);

// The name nearest to `word` by edits, or NULL if none is near. `names` ends with NULL.
const char* FindNearestName(const char* word, const char* const* names);

// A finite number that fills the whole text.
bool ParseNumber(const char* text, double* number);
