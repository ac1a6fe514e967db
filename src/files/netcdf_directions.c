// SPDX-License-Identifier: MIT
// A direction of 90 degrees may be where waves come from or where they go, and read the wrong way round a sea runs
// backwards. What tells it, the first that does: what the caller asks for; standard_name, as
// sea_surface_wave_from_direction [CF 2024]; other texts of the variable, in which words are found; a text of the file.
// Else it is what those mean who write such files, which is an assumption and said to be one.

#include "files/netcdf_directions.h"

#include <netcdf.h>
#include <stdio.h>
#include <string.h>

#include "core/base/host.h"

#define DEGREE (SW_PI / 180.0)
#define MAX_WORDS 64
#define TEXT_SIZE 512

// ---- words ----

typedef struct Words
{
    int count;
    char text[TEXT_SIZE];
    const char* words[MAX_WORDS];
} Words;

static void split(const char* text, Words* words)
{
    snprintf(words->text, sizeof(words->text), "%s", text);
    words->count = 0;
    bool isInside = false;
    for (char* c = words->text; *c != '\0'; ++c)
    {
        bool isLetter = (*c >= 'a' && *c <= 'z') || (*c >= '0' && *c <= '9');
        if (isLetter && !isInside && words->count < MAX_WORDS)
        {
            words->words[words->count++] = c;
        }
        *c = isLetter ? *c : '\0'; // the loop looks at the byte behind it
        isInside = isLetter;
    }
}

static const char* getWord(const Words* words, int index)
{
    return index >= 0 && index < words->count ? words->words[index] : "";
}

static bool isLast(const Words* words, int i)
{
    return i == words->count - 1;
}

// Whether a "from" or "to" is of waves: "waves from", "travelling to", "from direction", "direction to", "from" alone.
// Others are not: "clockwise from north", "relative to", "from 0 to 360", "from first spectral moment", "obtained from
// a model".
static bool isOfWaves(const Words* words, int i)
{
    static const char* const before[] = {
        "coming",    "comes",  "come",      "came",        "wave",       "waves",       "swell",
        "arriving",  "arrive", "go",        "approaching", "travelling", "propagating", "propagates",
        "propagate", "moving", "traveling", "travel",      "directed",   "pointing",    NULL};
    static const char* const after[] = {"direction", "directions", "which", "where", "convention", NULL};
    static const char* const directions[] = {"direction", "directions", "dir", NULL};
    static const char* const units[] = {"degree", "degrees", "deg", "rad", "radian", "radians", "in", NULL};
    const char* next = getWord(words, i + 1);
    return swIsOneOf(getWord(words, i - 1), before) || swIsOneOf(next, after) || words->count == 1 ||
           (swIsOneOf(getWord(words, i - 1), directions) && (isLast(words, i) || swIsOneOf(next, units)));
}

// "nautical convention": such a word counts beside "convention", or where hardly another one is.
static bool isConvention(const Words* words)
{
    bool isNamed = words->count <= 4;
    for (int i = 0; i < words->count; ++i)
    {
        isNamed = isNamed || strncmp(words->words[i], "convention", 10) == 0;
    }
    return isNamed;
}

static bool isFromWord(const Words* words, int i)
{
    static const char* const plain[] = {"coming", "comes", "come", "incoming", "originating", NULL};
    static const char* const conventions[] = {"nautical", "meteorological", NULL};
    const char* word = words->words[i];
    bool isOrigin = strcmp(word, "origin") == 0 && strcmp(getWord(words, i - 1), "of") == 0;
    return swIsOneOf(word, plain) || isOrigin || (swIsOneOf(word, conventions) && isConvention(words)) ||
           (strcmp(word, "from") == 0 && isOfWaves(words, i));
}

static bool isToWord(const Words* words, int i)
{
    static const char* const plain[] = {"going", "goes", "propagation", NULL};
    static const char* const conventions[] = {"oceanographic", "oceanographical", "mathematical", "cartesian", NULL};
    static const char* const compass[] = {"north", "east", "true", "the", "x", "y", NULL};
    const char* word = words->words[i];
    bool isTowards = strncmp(word, "toward", 6) == 0 && !swIsOneOf(getWord(words, i + 1), compass);
    bool isTravel = strcmp(word, "travel") == 0 && strcmp(getWord(words, i - 1), "of") == 0;
    return swIsOneOf(word, plain) || isTowards || isTravel || (swIsOneOf(word, conventions) && isConvention(words)) ||
           (strcmp(word, "to") == 0 && isOfWaves(words, i));
}

// "counterclockwise from east", "mathematical": angles that are no bearings.
static bool isFromEast(const Words* words)
{
    bool isCounter = false, hasEast = false;
    for (int i = 0; i < words->count; ++i)
    {
        const char* word = words->words[i];
        isCounter = isCounter || strcmp(word, "counterclockwise") == 0 || strcmp(word, "anticlockwise") == 0 ||
                    strcmp(word, "ccw") == 0 ||
                    (strcmp(word, "clockwise") == 0 &&
                     (strcmp(getWord(words, i - 1), "counter") == 0 || strcmp(getWord(words, i - 1), "anti") == 0));
        hasEast = hasEast || strcmp(word, "east") == 0 || strcmp(word, "x") == 0;
        if (strcmp(word, "mathematical") == 0 || strcmp(word, "cartesian") == 0)
        {
            return true;
        }
    }
    return isCounter && hasEast;
}

swDirectionMeaning swFindDirectionWords(const char* text)
{
    Words words;
    bool isFrom = false, isTo = false;
    split(text, &words);
    for (int i = 0; i < words.count; ++i)
    {
        isFrom = isFrom || isFromWord(&words, i);
        isTo = isTo || isToWord(&words, i);
    }
    if (isFrom == isTo)
    {
        return SW_DIRECTIONS_BY_FORMAT;
    }
    return isFrom ? SW_DIRECTIONS_FROM : isFromEast(&words) ? SW_DIRECTIONS_TO_FROM_EAST : SW_DIRECTIONS_TO;
}

// ---- turning ----

double swTurnDirection(swDirectionMeaning meaning, double degrees)
{
    return meaning == SW_DIRECTIONS_FROM ? (degrees + 90.0) * DEGREE
           : meaning == SW_DIRECTIONS_TO ? (degrees - 90.0) * DEGREE
                                         : -degrees * DEGREE;
}

// A direction that is counted from elsewhere by q quarter turns: cos and sin of n times it are turned by n q of them.
void swTurnMoments(swDirectionMeaning meaning, int order, double* a, double* b)
{
    double c = *a, s = *b;
    if (meaning == SW_DIRECTIONS_TO_FROM_EAST)
    {
        *b = -s;
    }
    else if (order == 2)
    {
        *a = -c;
        *b = -s;
    }
    else
    {
        *a = meaning == SW_DIRECTIONS_FROM ? -s : s;
        *b = meaning == SW_DIRECTIONS_FROM ? c : -c;
    }
}

// ---- attributes ----

// The first attribute of a variable or of the file that tells; its name becomes the basis.
static swDirectionMeaning findInAttributes(const swNetcdfFile* file, int variable, swMeasuredDirections* found)
{
    static const char* const names[] = {"standard_name",
                                        "long_name",
                                        "direction_convention",
                                        "directional_convention",
                                        "convention",
                                        "comment",
                                        "description",
                                        "definition",
                                        "note",
                                        "reference",
                                        "direction_reference",
                                        "units",
                                        NULL};
    static const char* const ofFile[] = {"direction_convention", "directional_convention",    "Directional_convention",
                                         "Direction_convention", "wave_direction_convention", NULL};
    const char* const* name = variable == NC_GLOBAL ? ofFile : names;
    for (; *name != NULL; ++name)
    {
        char text[TEXT_SIZE];
        swGetNetcdfText(file, variable, *name, true, text, sizeof(text));
        swDirectionMeaning meaning = swFindDirectionWords(text);
        if (meaning != SW_DIRECTIONS_BY_FORMAT)
        {
            snprintf(found->basis, sizeof(found->basis), "%s", *name);
            return meaning;
        }
    }
    return SW_DIRECTIONS_BY_FORMAT;
}

// "direction_from", "dir_to".
static swDirectionMeaning findInName(const swNetcdfFile* file, int variable, swMeasuredDirections* found)
{
    char name[257];
    swGetNetcdfVariableName(file, variable, name);
    for (char* c = name; *c != '\0'; ++c)
    {
        *c = *c == '_' ? ' ' : *c;
    }
    snprintf(found->basis, sizeof(found->basis), "%s", "the name of the directions");
    return swFindDirectionWords(name);
}

static const char* nameMeaning(swDirectionMeaning meaning)
{
    return meaning == SW_DIRECTIONS_FROM ? "where waves come from"
           : meaning == SW_DIRECTIONS_TO ? "where waves go"
                                         : "where waves go, counterclockwise from east";
}

static swMeasuredDirections findTold(const swNetcdfFile* file, int directions, int densities,
                                     const swNetcdfWriter* writer)
{
    swMeasuredDirections found = {0};
    found.meaning = directions >= 0 ? findInAttributes(file, directions, &found) : SW_DIRECTIONS_BY_FORMAT;
    if (found.meaning == SW_DIRECTIONS_BY_FORMAT && directions >= 0)
    {
        found.meaning = findInName(file, directions, &found);
    }
    if (found.meaning == SW_DIRECTIONS_BY_FORMAT)
    {
        found.meaning = findInAttributes(file, NC_GLOBAL, &found);
    }
    if (found.meaning == SW_DIRECTIONS_BY_FORMAT && densities >= 0)
    {
        found.meaning = findInAttributes(file, densities, &found);
    }
    found.meaning =
        found.meaning == SW_DIRECTIONS_TO && writer->isFromXAxis ? SW_DIRECTIONS_TO_FROM_EAST : found.meaning;
    return found;
}

swMeasuredDirections swFindNetcdfDirections(const swNetcdfFile* file, int directions, int densities,
                                            const swNetcdfWriter* writer, swDirectionMeaning asked)
{
    swMeasuredDirections found = findTold(file, directions, densities, writer);
    if (asked != SW_DIRECTIONS_BY_FORMAT)
    {
        if (found.meaning == SW_DIRECTIONS_BY_FORMAT && writer->isCertain && writer->meaning != asked)
        {
            swLog(file->host, SW_LOG_WARNING, "%s: in files of %s directions are %s; they are read as %s, as asked.",
                  file->name, writer->name, nameMeaning(writer->meaning), nameMeaning(asked));
        }
        if (found.meaning != SW_DIRECTIONS_BY_FORMAT && found.meaning != asked)
        {
            swLog(file->host, SW_LOG_WARNING, "%s: its %s says that directions are %s; they are read as %s, as asked.",
                  file->name, found.basis, nameMeaning(found.meaning), nameMeaning(asked));
        }
        return (swMeasuredDirections){.meaning = asked, .basis = "as asked"};
    }
    if (found.meaning == SW_DIRECTIONS_BY_FORMAT)
    {
        found.meaning = writer->meaning;
        found.isAssumed = !writer->isCertain;
        snprintf(found.basis, sizeof(found.basis), "%s", writer->name);
    }
    if (found.isAssumed)
    {
        swLog(
            file->host, SW_LOG_WARNING,
            "%s: it does not say whether its directions are where waves come from or where they go. As in files of %s "
            "they are taken as %s; say directions: from or to in a scene, --directions from or to in a command, if you "
            "know.",
            file->name, writer->name, nameMeaning(found.meaning));
    }
    return found;
}
