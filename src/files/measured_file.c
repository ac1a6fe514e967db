// SPDX-License-Identifier: MIT
// A file of measured seas: its format is known by its contents. JSON and netCDF need libraries, texts go to the core,
// and the direction files of an NDBC set lie beside its energy file under names that follow from its own:
//   real time    44013.data_spec   44013.swdir   44013.swdir2   44013.swr1   44013.swr2   (44013.swden as well)
//   archive      44013w2021.txt    44013d2021.txt 44013i2021.txt 44013j2021.txt 44013k2021.txt
// with anything behind the ending or the year, and each perhaps with .gz at the end. One of the direction files alone
// is no sea: it is refused, and the file of energies that belongs to it is named.

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/misuse.h"
#include "core/base/text.h"
#include "files/file_text.h"
#include "files/measured_formats.h"
#include "seaway/files.h"

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
    swFileText texts[FILE_COUNT];
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

static bool isAlphanumeric(char c)
{
    return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// ---- names of an NDBC set ----

static const char s_letters[FILE_COUNT + 1] = "wdijk";
static const char* const s_endings[FILE_COUNT] = {".data_spec", ".swdir", ".swdir2", ".swr1", ".swr2"};

// The part of a path that says which file of a set it is.
typedef struct NameKey
{
    bool isKnown;
    bool isArchive; // a letter, else an ending
    int file;       // ENERGY, ALPHA1, ...
    size_t first, size;
} NameKey;

static size_t findName(const char* path)
{
    const char* slash = strrchr(path, '/');
    return slash != NULL ? (size_t)(slash - path) + 1 : 0;
}

// A letter of the set and a year behind it. The station before it has five letters and digits; of energies it may have
// any number, as no harm is done where such a name means something else.
static NameKey findLetter(const char* path)
{
    NameKey key = {0};
    size_t name = findName(path), station = 0;
    for (size_t i = name; path[i] != '\0'; ++i)
    {
        const char* letter = strchr(s_letters, path[i]);
        const char* year = path + i + 1;
        bool isYear = isDigit(year[0]) && isDigit(year[1]) && isDigit(year[2]) && isDigit(year[3]);
        if (letter != NULL && isYear && ((i == name + 5 && station == 5) || path[i] == 'w'))
        {
            key = (NameKey){true, true, (int)(letter - s_letters), i, 1};
            if (i == name + 5)
            {
                break;
            }
        }
        station += isAlphanumeric(path[i]) ? 1 : 0;
    }
    return key;
}

// The longest ending that stands in the name, with nothing, a dot or another sign that is no letter or digit behind.
static NameKey findEnding(const char* path)
{
    NameKey key = {0};
    size_t name = findName(path);
    for (int i = 0; i <= FILE_COUNT; ++i)
    {
        const char* ending = i < FILE_COUNT ? s_endings[i] : ".swden";
        const char* found = strstr(path + name, ending);
        if (found != NULL && !isAlphanumeric(found[strlen(ending)]))
        {
            key = (NameKey){true, false, i < FILE_COUNT ? i : ENERGY, (size_t)(found - path), strlen(ending)};
        }
    }
    return key;
}

static NameKey findKey(const char* path)
{
    NameKey key = findLetter(path);
    return key.isKnown ? key : findEnding(path);
}

// The path with another key in its place; then as it is, and with .gz at its end added or taken away.
static bool findOther(const char* path, const NameKey* key, const char* word, char other[SW_MAX_PATH])
{
    int size = snprintf(other, SW_MAX_PATH, "%.*s%s%s", (int)key->first, path, word, path + key->first + key->size);
    size_t length = size > 0 && size + 4 < SW_MAX_PATH ? (size_t)size : 0;
    if (length == 0 || swHasFile(other))
    {
        return length > 0;
    }
    memcpy(other + length, ".gz", 4);
    if (swHasFile(other))
    {
        return true;
    }
    other[length] = '\0';
    if (endsWith(other, length, ".gz"))
    {
        other[length - 3] = '\0';
        return swHasFile(other);
    }
    return false;
}

static void findSiblings(const char* path, FileSet* set)
{
    NameKey key = findKey(path);
    for (int i = ALPHA1; i < FILE_COUNT && key.isKnown; ++i)
    {
        char letter[2] = {s_letters[i], '\0'};
        if (!findOther(path, &key, key.isArchive ? letter : s_endings[i], set->paths[i]))
        {
            set->paths[i][0] = '\0';
        }
    }
}

// Says which of the direction files are not there, and what follows.
static void warnOfMissing(const swHost* host, const FileSet* set)
{
    static const char* const names[FILE_COUNT] = {"energy", "alpha1", "alpha2", "r1", "r2"};
    const char* path = set->paths[ENERGY];
    char missing[40] = "";
    for (int i = ALPHA1; i < FILE_COUNT; ++i)
    {
        if (set->paths[i][0] == '\0')
        {
            size_t used = strlen(missing);
            snprintf(missing + used, sizeof(missing) - used, "%s%s", used > 0 ? ", " : "", names[i]);
        }
    }
    NameKey key = findKey(path);
    if (set->paths[ALPHA1][0] == '\0')
    {
        swLog(host, SW_LOG_WARNING,
              key.isKnown
                  ? "%s has no file of directions (%s) beside it: its directions are not known, and its waves "
                    "are taken to go east."
                  : "%s is not named as NDBC names a set (44013.data_spec, 44013w2021.txt), so that no files of "
                    "directions can be found beside it: its waves are taken to go east.",
              path, key.isArchive ? "44013d2021.txt" : ".swdir");
    }
    else if (missing[0] != '\0')
    {
        swLog(host, SW_LOG_WARNING,
              "%s has no file of %s beside it: what they would tell is taken from a cos^2s spread around the mean "
              "direction.",
              path, missing);
    }
}

static swResult refuseDirections(const swHost* host, const char* path, const NameKey* key)
{
    static const char* const meanings[FILE_COUNT] = {"energies", "mean directions (alpha1)",
                                                     "principal directions (alpha2)", "lengths of moments (r1)",
                                                     "lengths of moments (r2)"};
    char energy[SW_MAX_PATH];
    bool isThere = findOther(path, key, key->isArchive ? "w" : ".data_spec", energy);
    if (!isThere && !key->isArchive)
    {
        isThere = findOther(path, key, ".swden", energy);
    }
    if (!isThere)
    {
        findOther(path, key, key->isArchive ? "w" : ".data_spec", energy);
    }
    return swFail(host, SW_ERROR_FORMAT, "%s holds NDBC's %s, not energies: name the file of energies, %s%s.", path,
                  meanings[key->file], energy,
                  isThere ? "; this one is found beside it" : ", which must lie beside it");
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
    const swFileText* texts = set->texts;
    NameKey key = findKey(set->paths[ENERGY]);
    if (key.isKnown && key.file != ENERGY)
    {
        return refuseDirections(host, set->paths[ENERGY], &key);
    }
    swResult result = readSiblings(host, set);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    warnOfMissing(host, set);
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

static bool beginsWith(const swFileText* text, const char* bytes, size_t size)
{
    return text->size >= size && memcmp(text->data, bytes, size) == 0;
}

// Classic netCDF, or HDF5, which netCDF-4 files are.
static bool isNetcdf(const swFileText* text)
{
    return beginsWith(text, "CDF\1", 4) || beginsWith(text, "CDF\2", 4) || beginsWith(text, "CDF\5", 4) ||
           beginsWith(text, "\x89HDF\r\n", 6);
}

static bool isJson(const swFileText* text)
{
    size_t i = beginsWith(text, "\xEF\xBB\xBF", 3) ? 3 : 0; // UTF-8's byte order mark
    while (i < text->size &&
           (text->data[i] == ' ' || text->data[i] == '\t' || text->data[i] == '\r' || text->data[i] == '\n'))
    {
        ++i;
    }
    return i < text->size && (text->data[i] == '{' || text->data[i] == '[');
}

static swResult readNetcdf(const swHost* host, const char* path, swDirectionMeaning directions, swMeasuredSea** sea)
{
#if defined(SW_HAS_NETCDF)
    return swReadNetcdfSea(host, path, directions, sea);
#else
    (void)directions;
    (void)sea;
    return swFail(host, SW_ERROR_FORMAT, "%s: built without NetCDF: install libnetcdf-dev and build again.", path);
#endif
}

static swResult parseJson(const swHost* host, const swFileText* text, const char* path, swMeasuredSea** sea)
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
    swFileText start = {.data = bytes, .size = count};
    if (!isNetcdf(&start))
    {
        return swReadText(host, set->paths[ENERGY], MAX_FILE_SIZE, &set->texts[ENERGY]);
    }
    swFileText* text = &set->texts[ENERGY];
    text->data = swAllocate(host, sizeof(bytes));
    if (text->data == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", set->paths[ENERGY]);
    }
    memcpy(text->data, bytes, sizeof(bytes));
    text->size = text->capacity = sizeof(bytes);
    return SW_SUCCESS;
}

static swResult failUnknown(const swHost* host, const char* path)
{
    return swFail(host, SW_ERROR_FORMAT,
                  "%s:1: no format of measured seas that is read. Those are %s; JSON of Sofar's Spotter buoys and of "
                  "MHKiT; netCDF of WAVEWATCH III, SWAN, WWM, ERA5, NDBC, CDIP, Sofar, Copernicus, MHKiT and "
                  "wavespectra.",
                  path, swGetMeasuredFormatList());
}

static swResult parseFile(const swHost* host, FileSet* set, swDirectionMeaning directions, swMeasuredSea** sea)
{
    const swFileText* text = &set->texts[ENERGY];
    const char* path = set->paths[ENERGY];
    if (isNetcdf(text) && text->size != START_SIZE)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s: netCDF is read as it is: unpack it first, with gunzip.", path);
    }
    if (isNetcdf(text))
    {
        return readNetcdf(host, path, directions, sea);
    }
    if (directions != SW_DIRECTIONS_BY_FORMAT)
    {
        return swFail(host, SW_ERROR_FORMAT,
                      "%s: what its directions mean is laid down by its format; only of netCDF it can be told. Leave "
                      "directions out.",
                      path);
    }
    if (isJson(text))
    {
        return parseJson(host, text, path, sea);
    }
    swMeasuredFormat format = swFindMeasuredFormat(text->data, text->size);
    bool isNamed = findEnding(path).isKnown; // a text too strange to be known: the reader says what is wrong with it
    if (format == SW_MEASURED_NDBC_SPECTRUM || (format == SW_MEASURED_UNKNOWN && isNamed))
    {
        return parseNdbc(host, set, sea);
    }
    bool isWide = beginsWith(text, "\xFF\xFE", 2) || beginsWith(text, "\xFE\xFF", 2); // the parser says so
    return format != SW_MEASURED_UNKNOWN || isWide ? swParseMeasuredSea(host, text->data, text->size, path, sea)
                                                   : failUnknown(host, path);
}

swMeasuredFileDef swDefaultMeasuredFileDef(void)
{
    return (swMeasuredFileDef){.directions = SW_DIRECTIONS_BY_FORMAT, .internalValue = SW_DEF_COOKIE};
}

swResult swReadMeasuredSea(const swHost* host, const char* path, swMeasuredSea** sea)
{
    swMeasuredFileDef def = swDefaultMeasuredFileDef();
    return swReadMeasuredFile(host, path, &def, sea);
}

swResult swReadMeasuredFile(const swHost* host, const char* path, const swMeasuredFileDef* def, swMeasuredSea** sea)
{
    if (sea != NULL)
    {
        *sea = NULL;
    }
    SW_REQUIRE(swIsHostValid(host) && path != NULL && sea != NULL, SW_ERROR_INVALID, host,
               "swReadMeasuredFile() needs a host made by swDefaultHost(), a path and a place for the sea");
    SW_REQUIRE(def != NULL && def->internalValue == SW_DEF_COOKIE &&
                   (unsigned)def->directions <= SW_DIRECTIONS_TO_FROM_EAST,
               SW_ERROR_INVALID, host,
               "swReadMeasuredFile() needs a def made by swDefaultMeasuredFileDef(), with directions that exist");
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
        result = parseFile(host, &set, def->directions, sea);
    }
    for (int i = 0; i < FILE_COUNT; ++i)
    {
        swFreeText(host, &set.texts[i]);
    }
    return result;
}

int swFindMeasuredPlace(const swMeasuredSea* sea, const char* text)
{
    SW_REQUIRE(sea != NULL, -1, NULL, "swFindMeasuredPlace() needs a sea");
    if (text == NULL)
    {
        return -1;
    }
    int location = swMeasuredSea_FindLocation(sea, text);
    char* end = NULL;
    long number = strtol(text, &end, 10);
    bool isNumber = end != text && *end == '\0' && number >= 1 && number <= swMeasuredSea_GetLocationCount(sea);
    return location >= 0 ? location : isNumber ? (int)number - 1 : -1;
}
