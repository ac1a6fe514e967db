// SPDX-License-Identifier: MIT
// Reads partitions of spectra: systems of waves by height, period and direction. WAVEWATCH III's [WW3DG 2019]:
//
//    WAVEWATCH III PARTITIONED DATA FILE       III  1.01      and two lines that name the columns, then for each point
//    yyyymmdd hhmmss  lat  lon  'name      ' n  depth  wind  direction ...
//     0   hs  tp  lp  theta  sp  wf          the whole sea, then n lines of partitions
//
// theta is where waves come from, degrees clockwise from north; sp the spread, degrees; wf the part of it that the wind
// drives, and a partition of more than a half is wind sea.
//
// And a table with a heading, columns in any order, several rows a time:
//
//    time,hs_m,tp_s,direction_from_deg,spread_deg,gamma,location
//    2024-11-16 06:50,2.4,8.3,233,30,2.0,
//
// time and the first two numbers are needed; an empty field is not known. Lines that begin with # are comments.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/base/text.h"
#include "core/formats/measured_readers.h"
#include "core/formats/partition_sea.h"

#define MAX_PARTITIONS 1000000
#define MAX_HEIGHT 40.0
#define MIN_PERIOD 0.5
#define MAX_PERIOD 60.0
#define LEAST_SPREAD 5.7 // degrees; cos^2s ends at s = 200
#define DEGREE (SW_PI / 180.0)

typedef struct Reader
{
    swSeaReader file;
    swArray partitions; // swSeaPartition
    bool isHeld;        // the line at hand is still to be read
    int emptyCount;     // partitions of no height or period
    int firstEmpty;     // line of the first
    int narrowCount;    // spreads that are told and cannot be made
} Reader;

static swResult keep(Reader* reader, const swSeaPartition* partition)
{
    if (reader->partitions.count >= MAX_PARTITIONS)
    {
        reader->file.sea->isFull = true;
        return swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: more than %d partitions; cut the file in time.",
                      reader->file.text.name, reader->file.text.line, MAX_PARTITIONS);
    }
    swSeaPartition* added = swAppendItems(reader->file.text.host, &reader->partitions, 1, sizeof(*added));
    if (added == NULL)
    {
        return swFail(reader->file.text.host, SW_ERROR_NO_MEMORY, "No memory for the contents of %s.",
                      reader->file.text.name);
    }
    *added = *partition;
    added->order = (int)reader->partitions.count - 1;
    return SW_SUCCESS;
}

static void countEmpty(Reader* reader)
{
    reader->firstEmpty = reader->emptyCount++ > 0 ? reader->firstEmpty : reader->file.text.line;
}

// Makes records of the partitions that were kept.
static swResult finish(Reader* reader, swResult result)
{
    if (reader->emptyCount > 0)
    {
        swLog(reader->file.text.host, SW_LOG_WARNING,
              "%s:%d: %d partitions have no height or period and are left out; this line is the first.",
              reader->file.text.name, reader->firstEmpty, reader->emptyCount);
    }
    if (reader->narrowCount > 0)
    {
        swLog(reader->file.text.host, SW_LOG_WARNING,
              "%s: %d partitions have a spread below %g degrees, the narrowest that is made; they get that.",
              reader->file.text.name, reader->narrowCount, LEAST_SPREAD);
    }
    if (result == SW_SUCCESS)
    {
        result = swAddPartitions(reader->file.sea, reader->partitions.data, reader->partitions.count);
    }
    swFreeItems(reader->file.text.host, &reader->partitions, sizeof(swSeaPartition));
    return result;
}

// ---- WAVEWATCH III ----

static const char s_head[] = "WAVEWATCH III PARTITIONED DATA FILE";

bool swIsWavewatchPartitions(const char* text, size_t size)
{
    swText lines = swOpenText(NULL, text, size, "");
    return swNextLine(&lines) && swHasPrefix(&lines, s_head);
}

// A number, or NAN for a word that says that there is none, or the stars of a number too long for its column.
static swResult readNumber(Reader* reader, const char* what, double* value)
{
    swToken token = swNextToken(&reader->file.text);
    *value = (double)NAN;
    bool isNothing = token.size > 0 && (swIsMissingField(token) || *token.text == '*');
    if (isNothing || swParseToken(token, value))
    {
        return SW_SUCCESS;
    }
    return swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: %s should be a number, not '%.*s'.",
                  reader->file.text.name, reader->file.text.line, what, token.size, token.text);
}

// Number, hs, tp, lp, theta, sp, wf of the line at hand.
static swResult readSystem(Reader* reader, int expected, swSeaPartition* partition)
{
    static const char* const columns[7] = {
        "a partition's number",       "a height", "a period", "a wavelength", "a direction", "a spread",
        "a part that the wind drives"};
    double values[7];
    swResult result = SW_SUCCESS;
    for (int i = 0; i < 7 && result == SW_SUCCESS; ++i)
    {
        result = readNumber(reader, columns[i], &values[i]);
    }
    if (result == SW_SUCCESS && values[0] != expected)
    {
        result = swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: partition %g stands where %d should.",
                        reader->file.text.name, reader->file.text.line, values[0], expected);
    }
    if (result == SW_SUCCESS && values[1] > MAX_HEIGHT)
    {
        result = swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: a height is %g m; at most %g is read.",
                        reader->file.text.name, reader->file.text.line, values[1], MAX_HEIGHT);
    }
    if (result == SW_SUCCESS)
    {
        bool hasWaves = values[1] > 0.0 && values[2] >= MIN_PERIOD && values[2] <= MAX_PERIOD;
        bool hasBearing = values[4] >= 0.0 && values[4] <= 360.0;
        partition->height = hasWaves ? values[1] : 0.0;
        partition->peak = hasWaves ? 1.0 / values[2] : 0.1;
        partition->bearing = hasBearing ? values[4] : (double)NAN;
        partition->spread = values[5] > 0.0 && values[5] <= 90.0 ? values[5] * DEGREE : (double)NAN;
        reader->narrowCount += values[5] > 0.0 && values[5] < LEAST_SPREAD ? 1 : 0;
        partition->isWindSea = values[6] > 0.5;
    }
    return result;
}

// Date, place and number of partitions of a point's first line.
static swResult readPoint(Reader* reader, swSeaPartition* partition, int* count)
{
    double place[2] = {0.0, 0.0};
    char name[64];
    swText* text = &reader->file.text;
    swResult result = swReadPackedTime(text, &partition->seconds);
    if (result == SW_SUCCESS)
    {
        result = swReadRange(text, "a latitude", -90.0, 90.0, &place[0]);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadRange(text, "a longitude", -360.0, 360.0, &place[1]);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadSeaName(text, name);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadCount(text, "the number of partitions", 0, 1000, count);
    }
    if (result != SW_SUCCESS)
    {
        return result;
    }
    // Points of a grid have no name of their own: they are told apart by where they are.
    partition->location = swFindSeaPlace(reader->file.sea, name, place[1], place[0]);
    return partition->location >= 0
               ? SW_SUCCESS
               : swMeasuredSea_AddLocation(reader->file.sea, name, place[1], place[0], &partition->location);
}

// The next line of a point; false, and the line is held, if another point begins there or the text ends.
static bool nextSystem(Reader* reader)
{
    swText* text = &reader->file.text;
    reader->isHeld = swNextLine(text);
    if (reader->isHeld && !swIsPackedTime(text))
    {
        reader->isHeld = false;
        return true;
    }
    return false;
}

// The whole sea and its partitions, a line each. One that is broken is left out.
static swResult readSystems(Reader* reader, swSeaPartition partition, int count)
{
    swText* text = &reader->file.text;
    swSeaPartition whole = partition;
    whole.height = 0.0;
    double sum = 0.0;
    bool hasWhole = false;
    for (int i = 0; i <= count; ++i)
    {
        if (!nextSystem(reader))
        {
            swResult cut = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: partition %d of %d is missing before this line.",
                                  text->name, text->line, i, count);
            cut = swJudgeRecord(&reader->file, cut, text->line);
            if (cut != SW_SUCCESS)
            {
                return cut;
            }
            break;
        }
        swSeaPartition* system = i == 0 ? &whole : &partition;
        swResult part = readSystem(reader, i, system);
        swResult result = swJudgeRecord(&reader->file, part, text->line);
        if (i == 0)
        {
            hasWhole = part == SW_SUCCESS;
            partition.total = whole.total = whole.height > 0.0 && part == SW_SUCCESS ? whole.height : (double)NAN;
        }
        else if (part == SW_SUCCESS && partition.height > 0.0)
        {
            sum += partition.height;
            result = keep(reader, &partition);
        }
        else if (part == SW_SUCCESS)
        {
            countEmpty(reader);
        }
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return sum == 0.0 && hasWhole ? keep(reader, &whole) : SW_SUCCESS;
}

// A point, or a line of names between the points.
static swResult readBlock(Reader* reader)
{
    swText* text = &reader->file.text;
    char first = swPeekChar(text);
    if ((first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z'))
    {
        return SW_SUCCESS;
    }
    swSeaPartition partition = {.hasTime = true, .gamma = (double)NAN};
    int count = 0, line = text->line;
    swResult part = readPoint(reader, &partition, &count);
    if (part == SW_SUCCESS)
    {
        return readSystems(reader, partition, count);
    }
    swResult result = swJudgeRecord(&reader->file, part, line);
    while (result == SW_SUCCESS && nextSystem(reader))
    {
        // of a point that is left out
    }
    return result;
}

static swResult readWavewatch(void* context)
{
    Reader* reader = context;
    swResult result = swNeedLine(&reader->file.text, "the heading");
    while (result == SW_SUCCESS && (reader->isHeld || swNextLine(&reader->file.text)))
    {
        reader->isHeld = false;
        result = readBlock(reader);
    }
    return finish(reader, result);
}

// ---- the table ----

typedef enum Column
{
    TIME,
    HEIGHT,
    PERIOD,
    BEARING,
    SPREAD,
    GAMMA,
    LOCATION,
    COLUMN_COUNT
} Column;

static const struct
{
    const char* name;
    double low, high;
} s_columns[COLUMN_COUNT] = {
    [TIME] = {"time", 0.0, 0.0},
    [HEIGHT] = {"hs_m", 0.0, MAX_HEIGHT},
    [PERIOD] = {"tp_s", MIN_PERIOD, MAX_PERIOD},
    [BEARING] = {"direction_from_deg", -360.0, 720.0},
    [SPREAD] = {"spread_deg", 0.0, 81.0},
    [GAMMA] = {"gamma", 1.0, 20.0},
    [LOCATION] = {"location", 0.0, 0.0},
};

static bool nextRow(swText* text)
{
    while (swNextLine(text))
    {
        if (swPeekChar(text) != '#')
        {
            text->at = text->lineBegin; // a tab there is an empty field
            return true;
        }
    }
    return false;
}

// Which column each field is, COLUMN_COUNT for others. False if it is no heading of partitions.
static bool readHeading(swText* text, int columns[64], int* count)
{
    bool has[COLUMN_COUNT + 1] = {false};
    swToken field;
    *count = 0;
    while (*count < 64 && swNextField(text, &field))
    {
        int column = 0;
        while (column < COLUMN_COUNT && !swIsToken(field, s_columns[column].name))
        {
            ++column;
        }
        if (column < COLUMN_COUNT && has[column])
        {
            return false;
        }
        has[column] = true;
        columns[(*count)++] = column;
    }
    return has[TIME] && has[HEIGHT] && has[PERIOD];
}

// The same, with whatever stands between its names: a comma, a tab or a semicolon.
static bool readAnyHeading(swText* text, int columns[64], int* count)
{
    static const char separators[] = ",\t;";
    for (const char* separator = separators; *separator != '\0'; ++separator)
    {
        text->at = text->lineBegin;
        text->separator = *separator;
        if (readHeading(text, columns, count))
        {
            return true;
        }
    }
    return false;
}

bool swIsPartitionTable(const char* text, size_t size)
{
    int columns[64], count = 0;
    swText lines = swOpenText(NULL, text, size, "");
    return nextRow(&lines) && readAnyHeading(&lines, columns, &count);
}

// A column of another name is passed over; one that seems to tell what a partition is made of is named.
static void warnOfStrangers(swText text, const int columns[64])
{
    static const char* const words[] = {"dir", "spr", "hs_", "tp_", "gam", "height", "period"};
    swToken field;
    text.at = text.lineBegin;
    for (int i = 0; i < 64 && swNextField(&text, &field); ++i)
    {
        bool isStrange = false;
        for (size_t j = 0; j < sizeof(words) / sizeof(words[0]) && columns[i] == COLUMN_COUNT; ++j)
        {
            int size = (int)strlen(words[j]);
            for (int k = 0; k + size <= field.size; ++k)
            {
                isStrange = isStrange || memcmp(field.text + k, words[j], (size_t)size) == 0;
            }
        }
        if (isStrange)
        {
            swLog(text.host, SW_LOG_WARNING,
                  "%s:%d: the column '%.*s' is passed over; those that are read are named time, hs_m, tp_s, "
                  "direction_from_deg, spread_deg, gamma and location.",
                  text.name, text.line, field.size, field.text);
        }
    }
}

static swResult failField(const Reader* reader, int column, swToken field, const char* wish)
{
    return swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: %s is '%.*s'; it must be %s.",
                  reader->file.text.name, reader->file.text.line, s_columns[column].name, field.size, field.text, wish);
}

static void copyField(swToken field, char text[64])
{
    int size = field.size < 63 ? field.size : 63;
    memcpy(text, field.text, (size_t)size);
    text[size] = '\0';
}

static swResult readField(Reader* reader, int column, swToken field, swSeaPartition* partition)
{
    char text[64];
    double* const values[COLUMN_COUNT] = {
        NULL, &partition->height, &partition->peak, &partition->bearing, &partition->spread, &partition->gamma, NULL};
    copyField(field, text);
    if (column == TIME)
    {
        partition->hasTime = swParseMeasuredTime(text, &partition->seconds);
        return partition->hasTime ? SW_SUCCESS : failField(reader, column, field, "a time such as 2024-11-16 06:50");
    }
    if (column == LOCATION)
    {
        partition->location = swMeasuredSea_FindLocation(reader->file.sea, text);
        return partition->location >= 0
                   ? SW_SUCCESS
                   : swMeasuredSea_AddLocation(reader->file.sea, text, (double)NAN, (double)NAN, &partition->location);
    }
    if (column == COLUMN_COUNT)
    {
        return SW_SUCCESS;
    }
    double value = 0.0;
    bool isNumber = swParseToken(field, &value);
    bool isAngle = column == BEARING && isNumber && value >= s_columns[BEARING].low; // -9 degrees are 351
    if ((swIsMissingField(field) && !isAngle) || (column == PERIOD && isNumber && value == 0.0))
    {
        return SW_SUCCESS;
    }
    if (!isNumber || value < s_columns[column].low || value > s_columns[column].high)
    {
        return swFail(reader->file.text.host, SW_ERROR_FORMAT,
                      "%s:%d: %s is '%.*s'; it must be a number from %g to %g.", reader->file.text.name,
                      reader->file.text.line, s_columns[column].name, field.size, field.text, s_columns[column].low,
                      s_columns[column].high);
    }
    reader->narrowCount += column == SPREAD && value < LEAST_SPREAD ? 1 : 0;
    *values[column] = column == PERIOD ? 1.0 / value : column == SPREAD ? value * DEGREE : value;
    return SW_SUCCESS;
}

// A partition of no height is one that the hour does not have; one of height 0 still tells the hour.
static swResult keepRow(Reader* reader, const swSeaPartition* partition)
{
    if (!(partition->height > 0.0))
    {
        countEmpty(reader);
        return partition->height == 0.0 ? keep(reader, partition) : SW_SUCCESS;
    }
    if (!(partition->peak > 0.0))
    {
        return swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: there is a height but no tp_s.",
                      reader->file.text.name, reader->file.text.line);
    }
    return keep(reader, partition);
}

static swResult readRow(Reader* reader, const int* columns, int count)
{
    swSeaPartition partition = {.height = (double)NAN,
                                .total = (double)NAN,
                                .bearing = (double)NAN,
                                .spread = (double)NAN,
                                .gamma = (double)NAN};
    swToken field;
    int fields = 0;
    swResult result = SW_SUCCESS;
    for (; result == SW_SUCCESS && swNextField(&reader->file.text, &field); ++fields)
    {
        result = fields < count ? readField(reader, columns[fields], field, &partition) : SW_SUCCESS;
    }
    if (result == SW_SUCCESS && fields != count)
    {
        result = swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: the line has %d fields, the heading %d.",
                        reader->file.text.name, reader->file.text.line, fields, count);
    }
    return result == SW_SUCCESS ? keepRow(reader, &partition) : result;
}

static swResult readTable(void* context)
{
    Reader* reader = context;
    int columns[64], count = 0;
    swResult result = SW_SUCCESS;
    if (!nextRow(&reader->file.text) || !readAnyHeading(&reader->file.text, columns, &count))
    {
        result = swFail(reader->file.text.host, SW_ERROR_FORMAT,
                        "%s:%d: the heading must name time, hs_m and tp_s once each.", reader->file.text.name,
                        reader->file.text.line);
    }
    if (result == SW_SUCCESS)
    {
        warnOfStrangers(reader->file.text, columns);
    }
    while (result == SW_SUCCESS && nextRow(&reader->file.text))
    {
        result = swJudgeRecord(&reader->file, readRow(reader, columns, count), reader->file.text.line);
    }
    return finish(reader, result);
}

// ---- the whole file ----

swResult swParseWavewatchPartitions(const swHost* host, const char* text, size_t size, const char* name,
                                    swMeasuredSea** sea)
{
    return swRunReader(host, text, size, name != NULL ? name : "partitions", sizeof(Reader), readWavewatch, sea);
}

swResult swParsePartitionTable(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    return swRunReader(host, text, size, name != NULL ? name : "partitions", sizeof(Reader), readTable, sea);
}
