// SPDX-License-Identifier: MIT
// A file of measured seas: its format is known by its contents. JSON and netCDF need libraries, texts go to the core, and
// the direction files of an NDBC set lie beside its energy file under names that follow from its own:
//   real time    44013.data_spec   44013.swdir   44013.swdir2   44013.swr1   44013.swr2   (44013.swden as well)
//   archive      44013w2021.txt    44013d2021.txt 44013i2021.txt 44013j2021.txt 44013k2021.txt
// each perhaps with .gz at the end.

#include <stdio.h>
#include <string.h>

#include "core/base/host.h"
#include "scene/measured_formats.h"
#include "scene/scene_file.h"
#include "seaway/scene.h"

#define START_SIZE 8                      // of a netCDF file, enough to know it
#define MAX_FILE_SIZE ((size_t)512 << 20) // a year of hourly records has 5 MB as moments, 180 MB by direction

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
    char paths[FILE_COUNT][SW_MAX_PATH]; // empty: there is none
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
static void tryPath(char path[SW_MAX_PATH], const char* stem, size_t stemLength, const char* ending)
{
    snprintf(path, SW_MAX_PATH, "%.*s%s", (int)stemLength, stem, ending);
    if (!swHasFile(path))
    {
        snprintf(path, SW_MAX_PATH, "%.*s%s.gz", (int)stemLength, stem, ending);
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

static swResult readSiblings(const swHost* host, FileSet* set)
{
    findSiblings(set->paths[ENERGY], set);
    for (int i = ALPHA1; i < FILE_COUNT; ++i)
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

static swResult parseNdbc(const swHost* host, FileSet* set, swMeasuredSea** sea)
{
    const swText* texts = set->texts;
    swResult result = readSiblings(host, set);
    if (result != SW_SUCCESS)
    {
        return result;
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

// ---- formats that need a library ----

static bool beginsWith(const swText* text, const char* bytes, size_t size)
{
    return text->size >= size && memcmp(text->data, bytes, size) == 0;
}

// Classic netCDF, or HDF5, which netCDF-4 files are.
static bool isNetcdf(const swText* text)
{
    return beginsWith(text, "CDF\1", 4) || beginsWith(text, "CDF\2", 4) || beginsWith(text, "CDF\5", 4) ||
           beginsWith(text, "\x89HDF\r\n", 6);
}

static bool isJson(const swText* text)
{
    size_t i = 0;
    while (i < text->size &&
           (text->data[i] == ' ' || text->data[i] == '\t' || text->data[i] == '\r' || text->data[i] == '\n'))
    {
        ++i;
    }
    return i < text->size && (text->data[i] == '{' || text->data[i] == '[');
}

static swResult readNetcdf(const swHost* host, const char* path, swMeasuredSea** sea)
{
#if defined(SW_HAS_NETCDF)
    return swReadNetcdfSea(host, path, sea);
#else
    (void)sea;
    return swFail(host, SW_ERROR_FORMAT, "%s: built without NetCDF: install libnetcdf-dev and build again.", path);
#endif
}

static swResult parseJson(const swHost* host, const swText* text, const char* path, swMeasuredSea** sea)
{
#if defined(SW_HAS_JSON)
    return swReadJsonSea(host, text->data, text->size, path, sea);
#else
    (void)text;
    (void)sea;
    return swFail(host, SW_ERROR_FORMAT, "%s: built without JSON: install libjansson-dev and build again.", path);
#endif
}

// ---- any file ----

// A netCDF file may be larger than what is read at once; its beginning is enough to know it.
static swResult readStart(const swHost* host, FileSet* set)
{
    char bytes[START_SIZE] = {0};
    FILE* file = fopen(set->paths[ENERGY], "rb");
    size_t count = file != NULL ? fread(bytes, 1, sizeof(bytes), file) : 0;
    if (file != NULL)
    {
        fclose(file);
    }
    swText start = {bytes, count, 0};
    if (!isNetcdf(&start))
    {
        return swReadText(host, set->paths[ENERGY], MAX_FILE_SIZE, &set->texts[ENERGY]);
    }
    swText* text = &set->texts[ENERGY];
    text->data = swAllocate(host, sizeof(bytes));
    if (text->data == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", set->paths[ENERGY]);
    }
    memcpy(text->data, bytes, sizeof(bytes));
    text->size = text->capacity = sizeof(bytes);
    return SW_SUCCESS;
}

// By name, where a text is too strange to be known: the NDBC reader then says what is wrong with it.
static bool isNamedNdbc(const char* path)
{
    static const char* const endings[] = {".data_spec", ".swden"};
    size_t length = strlen(path);
    length -= endsWith(path, length, ".gz") ? 3 : 0;
    return endsWith(path, length, endings[0]) || endsWith(path, length, endings[1]);
}

static swResult failUnknown(const swHost* host, const char* path)
{
    return swFail(host, SW_ERROR_FORMAT,
                  "%s:1: no format of measured seas that is read. Those are %s; JSON of Sofar's Spotter buoys and of "
                  "MHKiT; netCDF of WAVEWATCH III and ERA5.",
                  path, swGetMeasuredFormatList());
}

static swResult parseFile(const swHost* host, FileSet* set, swMeasuredSea** sea)
{
    const swText* text = &set->texts[ENERGY];
    const char* path = set->paths[ENERGY];
    if (isNetcdf(text) && text->size != START_SIZE)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s: netCDF is read as it is: unpack it first, with gunzip.", path);
    }
    if (isNetcdf(text))
    {
        return readNetcdf(host, path, sea);
    }
    if (isJson(text))
    {
        return parseJson(host, text, path, sea);
    }
    swMeasuredFormat format = swFindMeasuredFormat(text->data, text->size);
    if (format == SW_MEASURED_NDBC_SPECTRUM || (format == SW_MEASURED_UNKNOWN && isNamedNdbc(path)))
    {
        return parseNdbc(host, set, sea);
    }
    return format != SW_MEASURED_UNKNOWN ? swParseMeasuredSea(host, text->data, text->size, path, sea)
                                         : failUnknown(host, path);
}

swResult swReadMeasuredSea(const swHost* host, const char* path, swMeasuredSea** sea)
{
    *sea = NULL;
    FileSet set;
    memset(&set, 0, sizeof(set));
    if (strlen(path) >= SW_MAX_PATH - 8)
    {
        return swFail(host, SW_ERROR_FILE, "The path of a spectrum file has %zu characters; at most %d are read.",
                      strlen(path), SW_MAX_PATH - 9);
    }
    memcpy(set.paths[ENERGY], path, strlen(path));
    swResult result = readStart(host, &set);
    if (result == SW_SUCCESS)
    {
        result = parseFile(host, &set, sea);
    }
    for (int i = 0; i < FILE_COUNT; ++i)
    {
        swFreeText(host, &set.texts[i]);
    }
    return result;
}
