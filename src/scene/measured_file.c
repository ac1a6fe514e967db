// SPDX-License-Identifier: MIT
// An NDBC summary, or an NDBC set from its energy file. The direction files lie beside it under names that follow from its own:
//   real time    44013.data_spec   44013.swdir   44013.swdir2   44013.swr1   44013.swr2   (44013.swden as well)
//   archive      44013w2021.txt    44013d2021.txt 44013i2021.txt 44013j2021.txt 44013k2021.txt
// each perhaps with .gz at the end. A summary (44013.spec) stands alone and is known by its heading.

#include <stdio.h>
#include <string.h>

#include "core/base/host.h"
#include "scene/scene_file.h"
#include "seaway/scene.h"

#define MAX_PATH_LENGTH 1024
#define MAX_FILE_SIZE ((size_t)64 << 20) // a year of hourly records has 5 MB

enum
{
    ENERGY,
    ALPHA1,
    ALPHA2,
    R1,
    R2,
    FILE_COUNT
};

typedef struct FileSet
{
    char paths[FILE_COUNT][MAX_PATH_LENGTH]; // empty: there is none
    swText texts[FILE_COUNT];
} FileSet;

static bool endsWith(const char* text, size_t length, const char* ending)
{
    size_t size = strlen(ending);
    return length >= size && memcmp(text + length - size, ending, size) == 0;
}

static bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

// Tries stem + ending, and that with .gz.
static void tryPath(char path[MAX_PATH_LENGTH], const char* stem, size_t stemLength, const char* ending)
{
    snprintf(path, MAX_PATH_LENGTH, "%.*s%s", (int)stemLength, stem, ending);
    if (!swHasFile(path))
    {
        snprintf(path, MAX_PATH_LENGTH, "%.*s%s.gz", (int)stemLength, stem, ending);
        if (!swHasFile(path))
        {
            path[0] = '\0';
        }
    }
}

static void findSiblings(const char* path, FileSet* set)
{
    static const char* const endings[FILE_COUNT] = {"", ".swdir", ".swdir2", ".swr1", ".swr2"};
    static const char letters[FILE_COUNT + 1] = "wdijk";
    size_t length = strlen(path);
    length -= endsWith(path, length, ".gz") ? 3 : 0;
    for (int i = ALPHA1; i < FILE_COUNT; ++i)
    {
        if (endsWith(path, length, ".data_spec") || endsWith(path, length, ".swden"))
        {
            size_t stem = length - (endsWith(path, length, ".swden") ? strlen(".swden") : strlen(".data_spec"));
            tryPath(set->paths[i], path, stem, endings[i]);
        }
        else if (length > 9 && endsWith(path, length, ".txt") && path[length - 9] == 'w' && isDigit(path[length - 8]) &&
                 isDigit(path[length - 7]) && isDigit(path[length - 6]) && isDigit(path[length - 5]))
        {
            char ending[10] = {letters[i]};
            memcpy(ending + 1, path + length - 8, 8);
            tryPath(set->paths[i], path, length - 9, ending);
        }
    }
}

static swResult readFiles(const swHost* host, FileSet* set)
{
    for (int i = 0; i < FILE_COUNT; ++i)
    {
        if (set->paths[i][0] == '\0')
        {
            continue;
        }
        swResult result = swReadText(host, set->paths[i], MAX_FILE_SIZE, &set->texts[i]);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return SW_SUCCESS;
}

static swResult parseFiles(const swHost* host, const FileSet* set, swMeasuredSea** sea)
{
    const swText* texts = set->texts;
    if (swIsNdbcSummary(texts[ENERGY].data, texts[ENERGY].size))
    {
        return swParseNdbcSummary(host, texts[ENERGY].data, texts[ENERGY].size, set->paths[ENERGY], sea);
    }
    if (set->paths[ALPHA1][0] == '\0')
    {
        swLog(host, SW_LOG_INFO, "%s has no direction files beside it: its waves are taken to go east.",
              set->paths[ENERGY]);
    }
    swNdbcTexts ndbc = {
        .energy = texts[ENERGY].data != NULL ? texts[ENERGY].data : "",
        .alpha1 = texts[ALPHA1].data,
        .alpha2 = texts[ALPHA2].data,
        .r1 = texts[R1].data,
        .r2 = texts[R2].data,
        .energySize = texts[ENERGY].size,
        .alpha1Size = texts[ALPHA1].size,
        .alpha2Size = texts[ALPHA2].size,
        .r1Size = texts[R1].size,
        .r2Size = texts[R2].size,
        .energyName = set->paths[ENERGY],
        .alpha1Name = set->paths[ALPHA1],
        .alpha2Name = set->paths[ALPHA2],
        .r1Name = set->paths[R1],
        .r2Name = set->paths[R2],
    };
    return swParseNdbc(host, &ndbc, sea);
}

swResult swReadMeasuredSea(const swHost* host, const char* path, swMeasuredSea** sea)
{
    *sea = NULL;
    FileSet set;
    memset(&set, 0, sizeof(set));
    if (strlen(path) >= MAX_PATH_LENGTH - 8)
    {
        return swFail(host, SW_ERROR_FILE, "The path of a spectrum file has %zu characters; at most %d are read.",
                      strlen(path), MAX_PATH_LENGTH - 9);
    }
    memcpy(set.paths[ENERGY], path, strlen(path));
    findSiblings(path, &set);
    swResult result = readFiles(host, &set);
    if (result == SW_SUCCESS)
    {
        result = parseFiles(host, &set, sea);
    }
    for (int i = 0; i < FILE_COUNT; ++i)
    {
        swFreeText(host, &set.texts[i]);
    }
    return result;
}
