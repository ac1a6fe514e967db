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
#include "core/waves/measured_readers.h"
#include "core/waves/partition_sea.h"

#define MAX_PARTITIONS 1000000
#define MAX_HEIGHT 40.0
#define MIN_PERIOD 0.5
#define MAX_PERIOD 60.0
#define DEGREE (SW_PI / 180.0)

typedef struct Reader
{
    swSeaText text;
    swMeasuredSea* sea;
    swSeaArray partitions; // swSeaPartition
    int lastLocation;
} Reader;

typedef swResult (*ReadFcn)(Reader* reader);

static swResult keep(Reader* reader, const swSeaPartition* partition)
{
    if (reader->partitions.count >= MAX_PARTITIONS)
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: more than %d partitions; cut the file in time.",
                      reader->text.name, reader->text.line, MAX_PARTITIONS);
    }
    swSeaPartition* added = swAppendSeaItems(reader->text.host, &reader->partitions, 1, sizeof(*added));
    if (added == NULL)
    {
        return swFail(reader->text.host, SW_ERROR_NO_MEMORY, "No memory for the contents of %s.", reader->text.name);
    }
    *added = *partition;
    added->order = (int)reader->partitions.count - 1;
    return SW_SUCCESS;
}

// ---- WAVEWATCH III ----

static const char s_head[] = "WAVEWATCH III PARTITIONED DATA FILE";

bool swIsWavewatchPartitions(const char* text, size_t size)
{
    swSeaText lines = swOpenSeaText(NULL, text, size, "");
    return swNextSeaLine(&lines) && swHasSeaPrefix(&lines, s_head);
}

// Number, hs, tp, lp, theta, sp, wf of one line.
static swResult readSystem(Reader* reader, int expected, swSeaPartition* partition)
{
    static const struct
    {
        const char* what;
        double low, high;
    } columns[7] = {{"a partition's number", 0.0, 1000.0},
                    {"a height", 0.0, MAX_HEIGHT},
                    {"a period", 0.0, 1000.0},
                    {"a wavelength", 0.0, 1e7},
                    {"a direction", -1e6, 1e6},
                    {"a spread", -1e6, 1e6},
                    {"a part that the wind drives", -1e6, 1e6}};
    double values[7];
    swResult result = swNeedSeaLine(&reader->text, "a partition");
    for (int i = 0; i < 7 && result == SW_SUCCESS; ++i)
    {
        result = swReadSeaRange(&reader->text, columns[i].what, columns[i].low, columns[i].high, &values[i]);
    }
    if (result == SW_SUCCESS && values[0] != expected)
    {
        result = swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: partition %g stands where %d should.",
                        reader->text.name, reader->text.line, values[0], expected);
    }
    if (result == SW_SUCCESS)
    {
        bool hasWaves = values[1] > 0.0 && values[2] >= MIN_PERIOD && values[2] <= MAX_PERIOD;
        bool hasBearing = values[4] >= 0.0 && values[4] <= 360.0;
        partition->height = hasWaves ? values[1] : 0.0;
        partition->peak = hasWaves ? 1.0 / values[2] : 0.1;
        partition->bearing = hasBearing ? values[4] : (double)NAN;
        partition->spread = values[5] > 0.0 && values[5] <= 90.0 ? values[5] * DEGREE : (double)NAN;
        partition->isWindSea = values[6] > 0.5;
    }
    return result;
}

// Date, place and number of partitions of a point's first line.
static swResult readPoint(Reader* reader, swSeaPartition* partition, int* count)
{
    double place[2] = {0.0, 0.0};
    char name[64];
    swSeaText* text = &reader->text;
    swResult result = swReadPackedTime(text, &partition->seconds);
    if (result == SW_SUCCESS)
    {
        result = swReadSeaRange(text, "a latitude", -90.0, 90.0, &place[0]);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadSeaRange(text, "a longitude", -360.0, 360.0, &place[1]);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadSeaName(text, name);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadSeaCount(text, "the number of partitions", 0, 1000, count);
    }
    // Points of a grid have no name of their own: they are told apart by where they are. Times have them in one order.
    int knownCount = swMeasuredSea_GetLocationCount(reader->sea);
    for (int i = 0; result == SW_SUCCESS && i < knownCount; ++i)
    {
        int candidate = (reader->lastLocation + 1 + i) % knownCount;
        swMeasuredLocation known = swMeasuredSea_GetLocation(reader->sea, candidate);
        if (known.latitude == place[0] && known.longitude == place[1] && strcmp(known.name, name) == 0)
        {
            partition->location = reader->lastLocation = candidate;
            return SW_SUCCESS;
        }
    }
    return result == SW_SUCCESS ? swMeasuredSea_AddLocation(reader->sea, name, place[1], place[0], &partition->location)
                                : result;
}

static swResult readSystems(Reader* reader)
{
    swSeaPartition partition = {.hasTime = true, .gamma = (double)NAN};
    int count = 0;
    swResult result = readPoint(reader, &partition, &count);
    reader->text.at = reader->text.lineEnd;
    swSeaPartition whole = partition;
    if (result == SW_SUCCESS)
    {
        result = readSystem(reader, 0, &whole);
    }
    partition.total = whole.height > 0.0 ? whole.height : (double)NAN;
    whole.total = partition.total;
    double sum = 0.0;
    for (int i = 0; i < count && result == SW_SUCCESS; ++i)
    {
        reader->text.at = reader->text.lineEnd;
        result = readSystem(reader, i + 1, &partition);
        sum += partition.height;
        result = result == SW_SUCCESS ? keep(reader, &partition) : result;
    }
    reader->text.at = reader->text.lineEnd;
    return result == SW_SUCCESS && sum == 0.0 ? keep(reader, &whole) : result;
}

static swResult readWavewatch(Reader* reader)
{
    swResult result = swNeedSeaLine(&reader->text, "the heading");
    while (result == SW_SUCCESS && swNextSeaLine(&reader->text))
    {
        char first = swPeekSeaChar(&reader->text);
        bool isHeading = (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z');
        result = isHeading ? SW_SUCCESS : readSystems(reader);
    }
    return result;
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

// The next field of a line, without spaces around; false at its end.
static bool nextField(swSeaText* text, swSeaToken* field)
{
    if (text->at > text->lineEnd)
    {
        return false;
    }
    const char* end = text->at < text->lineEnd ? memchr(text->at, ',', (size_t)(text->lineEnd - text->at)) : NULL;
    end = end != NULL ? end : text->lineEnd;
    const char* begin = text->at;
    text->at = end + 1;
    while (begin < end && (*begin == ' ' || *begin == '\t' || *begin == '"'))
    {
        ++begin;
    }
    while (end > begin && (end[-1] == ' ' || end[-1] == '\t' || end[-1] == '\r' || end[-1] == '"'))
    {
        --end;
    }
    *field = (swSeaToken){begin, (int)(end - begin < 80 ? end - begin : 80)};
    return true;
}

static bool nextRow(swSeaText* text)
{
    while (swNextSeaLine(text))
    {
        if (swPeekSeaChar(text) != '#')
        {
            return true;
        }
    }
    return false;
}

// Which column each field is, COLUMN_COUNT for others. False if it is no heading of partitions.
static bool readHeading(swSeaText* text, int columns[64], int* count)
{
    bool has[COLUMN_COUNT + 1] = {false};
    swSeaToken field;
    *count = 0;
    while (*count < 64 && nextField(text, &field))
    {
        int column = 0;
        while (column < COLUMN_COUNT && !swIsSeaToken(field, s_columns[column].name))
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

bool swIsPartitionTable(const char* text, size_t size)
{
    int columns[64], count = 0;
    swSeaText lines = swOpenSeaText(NULL, text, size, "");
    return nextRow(&lines) && readHeading(&lines, columns, &count);
}

static swResult failField(const Reader* reader, int column, swSeaToken field, const char* wish)
{
    return swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: %s is '%.*s'; it must be %s.", reader->text.name,
                  reader->text.line, s_columns[column].name, field.size, field.text, wish);
}

static void copyField(swSeaToken field, char text[64])
{
    int size = field.size < 63 ? field.size : 63;
    memcpy(text, field.text, (size_t)size);
    text[size] = '\0';
}

static swResult readField(Reader* reader, int column, swSeaToken field, swSeaPartition* partition)
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
        partition->location = swMeasuredSea_FindLocation(reader->sea, text);
        return partition->location >= 0
                   ? SW_SUCCESS
                   : swMeasuredSea_AddLocation(reader->sea, text, (double)NAN, (double)NAN, &partition->location);
    }
    if (column == COLUMN_COUNT || (field.size == 0 && column != HEIGHT))
    {
        return SW_SUCCESS;
    }
    double value = 0.0;
    if (!swParseSeaNumber(field, &value) || value < s_columns[column].low || value > s_columns[column].high)
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: %s is '%.*s'; it must be a number from %g to %g.",
                      reader->text.name, reader->text.line, s_columns[column].name, field.size, field.text,
                      s_columns[column].low, s_columns[column].high);
    }
    *values[column] = column == PERIOD ? 1.0 / value : column == SPREAD ? value * DEGREE : value;
    return SW_SUCCESS;
}

static swResult readRow(Reader* reader, const int* columns, int count)
{
    swSeaPartition partition = {
        .total = (double)NAN, .bearing = (double)NAN, .spread = (double)NAN, .gamma = (double)NAN};
    swSeaToken field;
    int fields = 0;
    swResult result = SW_SUCCESS;
    for (; result == SW_SUCCESS && nextField(&reader->text, &field); ++fields)
    {
        result = fields < count ? readField(reader, columns[fields], field, &partition) : SW_SUCCESS;
    }
    if (result == SW_SUCCESS && fields != count)
    {
        result = swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: the line has %d fields, the heading %d.",
                        reader->text.name, reader->text.line, fields, count);
    }
    if (result == SW_SUCCESS && partition.height > 0.0 && !(partition.peak > 0.0))
    {
        result = swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: there is a height but no tp_s.", reader->text.name,
                        reader->text.line);
    }
    return result == SW_SUCCESS ? keep(reader, &partition) : result;
}

static swResult readTable(Reader* reader)
{
    int columns[64], count = 0;
    if (!nextRow(&reader->text) || !readHeading(&reader->text, columns, &count))
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: the heading must name time, hs_m and tp_s once each.",
                      reader->text.name, reader->text.line);
    }
    swResult result = SW_SUCCESS;
    while (result == SW_SUCCESS && nextRow(&reader->text))
    {
        result = readRow(reader, columns, count);
    }
    return result;
}

// ---- the whole file ----

static swResult parse(const swHost* host, const char* text, size_t size, const char* name, ReadFcn read,
                      swMeasuredSea** sea)
{
    *sea = NULL;
    Reader reader = {swOpenSeaText(host, text, size, name != NULL ? name : "partitions"), NULL, {0}, 0};
    swResult result = swCreateMeasuredSea(host, reader.text.name, &reader.sea);
    if (result == SW_SUCCESS)
    {
        result = read(&reader);
    }
    if (result == SW_SUCCESS)
    {
        result = swAddPartitions(reader.sea, reader.partitions.data, reader.partitions.count);
    }
    if (result == SW_SUCCESS)
    {
        result = swMeasuredSea_Finish(reader.sea);
    }
    swFreeSeaItems(host, &reader.partitions, sizeof(swSeaPartition));
    if (result == SW_SUCCESS)
    {
        *sea = reader.sea;
    }
    else
    {
        swDestroyMeasuredSea(reader.sea);
    }
    return result;
}

swResult swParseWavewatchPartitions(const swHost* host, const char* text, size_t size, const char* name,
                                    swMeasuredSea** sea)
{
    return parse(host, text, size, name, readWavewatch, sea);
}

swResult swParsePartitionTable(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    return parse(host, text, size, name, readTable, sea);
}
