// SPDX-License-Identifier: MIT
// Reads the spectral wave summaries of the US National Data Buoy Center [NDBC 2024]:
//
//   #YY  MM DD hh mm WVHT  SwH  SwP  WWH  WWP SwD WWD  STEEPNESS  APD MWD
//   #yr  mo dy hr mn    m    m  sec    m  sec  -  degT     -      sec degT
//   2022 05 12 23 40  1.0  0.9  9.1  0.2  3.7   E   E      SWELL  6.7  81
//
// Columns are known by their names, so that standard meteorological files (WDIR WSPD GST WVHT DPD APD MWD ...) are read
// too; columns of other names are passed over. Directions of swell and wind sea are points of the compass, of others
// degrees, and either is understood in both. Missing is MM or N/A, in archives 99 for heights and periods and 999 for
// directions.

#include "core/formats/summary.h"

#include <string.h>

#include "core/base/text.h"
#include "core/base/trial.h"
#include "seaway/measured.h"

#define MAX_COLUMNS 64

#define MAX_HEIGHT 40.0
#define MIN_PERIOD 1.0
#define MAX_PERIOD 40.0

#define POINT_COUNT 16

typedef enum Kind
{
    HEIGHT,
    PERIOD,
    DIRECTION
} Kind;

static const struct
{
    const char* label;
    Kind kind;
} s_fields[SW_SUMMARY_FIELD_COUNT] = {
    [SW_SUMMARY_HEIGHT] = {"WVHT", HEIGHT},           [SW_SUMMARY_SWELL_HEIGHT] = {"SwH", HEIGHT},
    [SW_SUMMARY_SWELL_PERIOD] = {"SwP", PERIOD},      [SW_SUMMARY_SWELL_DIRECTION] = {"SwD", DIRECTION},
    [SW_SUMMARY_WIND_HEIGHT] = {"WWH", HEIGHT},       [SW_SUMMARY_WIND_PERIOD] = {"WWP", PERIOD},
    [SW_SUMMARY_WIND_DIRECTION] = {"WWD", DIRECTION}, [SW_SUMMARY_DOMINANT_PERIOD] = {"DPD", PERIOD},
    [SW_SUMMARY_AVERAGE_PERIOD] = {"APD", PERIOD},    [SW_SUMMARY_MEAN_DIRECTION] = {"MWD", DIRECTION},
};

// What the last heading says of the lines below it.
typedef struct Columns
{
    int count; // without the date's; 0 before a heading
    bool hasMinutes;
    int fields[MAX_COLUMNS]; // SW_SUMMARY_FIELD_COUNT: passed over
} Columns;

void swFreeSummaryFile(const swHost* host, swSummaryFile* file)
{
    swFreeItems(host, &file->rows, sizeof(swNdbcRow));
    swFreeItems(host, &file->values, sizeof(float));
}

// ---- headings ----

static int findField(swToken label)
{
    for (int i = 0; i < SW_SUMMARY_FIELD_COUNT; ++i)
    {
        if (swIsToken(label, s_fields[i].label))
        {
            return i;
        }
    }
    return SW_SUMMARY_FIELD_COUNT;
}

// Reads a line of labels: year, month, day, hour, perhaps minutes, then values. Returns false if it is no such line, or
// none of wave heights; `columns` is then of no use. More labels than MAX_COLUMNS are counted only.
static bool readHeading(swText* text, Columns* columns)
{
    if (swPeekChar(text) == '#')
    {
        ++text->at;
    }
    swToken year = swNextToken(text);
    if (!swIsToken(year, "YY") && !swIsToken(year, "YYYY"))
    {
        return false;
    }
    for (int i = 0; i < 3; ++i)
    {
        swNextToken(text); // MM DD hh
    }
    *columns = (Columns){0};
    bool hasHeight = false;
    for (swToken label = swNextToken(text); label.size > 0; label = swNextToken(text))
    {
        if (columns->count == 0 && !columns->hasMinutes && swIsToken(label, "mm"))
        {
            columns->hasMinutes = true;
            continue;
        }
        int field = findField(label);
        hasHeight = hasHeight || field == SW_SUMMARY_HEIGHT;
        if (columns->count < MAX_COLUMNS)
        {
            columns->fields[columns->count] = field;
        }
        ++columns->count;
    }
    return hasHeight;
}

bool swIsNdbcSummary(const char* text, size_t size)
{
    if (text == NULL)
    {
        return false;
    }
    swText lines = swOpenText(NULL, text, size, "");
    Columns columns;
    while (swNextLine(&lines) && swIsNdbcHeading(&lines))
    {
        if (readHeading(&lines, &columns))
        {
            return true;
        }
    }
    return false;
}

// ---- values ----

// Clockwise from north.
static bool parsePoint(swToken token, double* degrees)
{
    static const char* const points[POINT_COUNT] = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                                    "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        if (swIsToken(token, points[i]))
        {
            *degrees = i * (360.0 / POINT_COUNT);
            return true;
        }
    }
    return false;
}

static swResult failRange(const swText* text, const char* label, double value, double low, double high)
{
    return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %s is %g; it must be from %g to %g, or MM where it is missing.",
                  text->name, text->line, label, value, low, high);
}

// A period of zero says that there are no waves, as MM does.
static swResult readValue(const swText* text, int field, swToken token, float* value)
{
    Kind kind = s_fields[field].kind;
    const char* label = s_fields[field].label;
    *value = SW_NDBC_MISSING;
    if (swIsToken(token, "MM") || swIsToken(token, "N/A"))
    {
        return SW_SUCCESS;
    }
    double number = 0.0;
    if (!swParseToken(token, &number) && !(kind == DIRECTION && parsePoint(token, &number)))
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %s is '%.*s'; it must be %s, or MM where it is missing.",
                      text->name, text->line, label, token.size, token.text,
                      kind == DIRECTION ? "a point of the compass such as NNE, or degrees" : "a number");
    }
    if (number == (kind == DIRECTION ? 999.0 : 99.0) || (kind == PERIOD && number == 0.0))
    {
        return SW_SUCCESS;
    }
    double low = kind == PERIOD ? MIN_PERIOD : 0.0;
    double high = kind == HEIGHT ? MAX_HEIGHT : kind == PERIOD ? MAX_PERIOD : 360.0;
    if (number < low || number > high)
    {
        return failRange(text, label, number, low, high);
    }
    *value = (float)number;
    return SW_SUCCESS;
}

static swResult readValues(swText* text, const Columns* columns, float* values)
{
    for (int i = 0; i < SW_SUMMARY_FIELD_COUNT; ++i)
    {
        values[i] = SW_NDBC_MISSING;
    }
    int count = 0;
    for (swToken token = swNextToken(text); token.size > 0; token = swNextToken(text), ++count)
    {
        int field = count < columns->count ? columns->fields[count] : SW_SUMMARY_FIELD_COUNT;
        swResult result = field < SW_SUMMARY_FIELD_COUNT ? readValue(text, field, token, &values[field]) : SW_SUCCESS;
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    if (count != columns->count)
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the line has %d values after its date, the heading %d%s.",
                      text->name, text->line, count, columns->count,
                      count < columns->count ? "; it may be cut off" : "");
    }
    return SW_SUCCESS;
}

// ---- the whole file ----

static swResult readRow(swText* text, const Columns* columns, swSummaryFile* file)
{
    if (columns->count == 0)
    {
        return swFail(text->host, SW_ERROR_FORMAT,
                      "%s:%d: no heading (#YY MM DD hh mm WVHT ...) above the line; is this an NDBC wave summary?",
                      text->name, text->line);
    }
    swNdbcRow row = {.first = file->values.count, .line = text->line};
    float values[SW_SUMMARY_FIELD_COUNT];
    swResult result = swReadNdbcDate(text, columns->hasMinutes, &row.minutes);
    if (result == SW_SUCCESS)
    {
        result = readValues(text, columns, values);
    }
    if (result == SW_SUCCESS)
    {
        result = swAppendNdbcRow(text, &file->rows, &row);
    }
    if (result != SW_SUCCESS)
    {
        return result;
    }
    float* added = swAppendItems(text->host, &file->values, SW_SUMMARY_FIELD_COUNT, sizeof(float));
    if (added == NULL)
    {
        return swFail(text->host, SW_ERROR_NO_MEMORY, "No memory for the contents of %s.", text->name);
    }
    memcpy(added, values, sizeof(values));
    return SW_SUCCESS;
}

// The line of units below a heading: heights are read in metres only.
static swResult checkUnits(swText* lines, const Columns* columns)
{
    lines->at = lines->lineBegin;
    lines->at += swPeekChar(lines) == '#' ? 1 : 0;
    if (!swIsToken(swNextToken(lines), "yr"))
    {
        return SW_SUCCESS; // a comment
    }
    for (int i = 1; i < (columns->hasMinutes ? 5 : 4); ++i)
    {
        swNextToken(lines); // mo dy hr mn
    }
    for (int i = 0; i < columns->count && i < MAX_COLUMNS; ++i)
    {
        swToken unit = swNextToken(lines);
        int field = columns->fields[i];
        if (unit.size > 0 && field < SW_SUMMARY_FIELD_COUNT && s_fields[field].kind == HEIGHT && !swIsToken(unit, "m"))
        {
            return swFail(lines->host, SW_ERROR_FORMAT, "%s:%d: %s is in '%.*s'; heights are read in m.", lines->name,
                          lines->line, s_fields[field].label, unit.size, unit.text);
        }
    }
    return SW_SUCCESS;
}

// A heading, a comment, or a record, which is left out if it is broken.
static swResult readLine(swText* lines, swTrial* trial, Columns* columns, swSummaryFile* file)
{
    if (!swIsNdbcHeading(lines))
    {
        swResult room = swCheckNdbcRoom(lines, file->rows.count, 0);
        return room == SW_SUCCESS ? swJudgeTrial(trial, readRow(lines, columns, file), "line", lines->line) : room;
    }
    Columns read;
    if (!readHeading(lines, &read))
    {
        return checkUnits(lines, columns);
    }
    *columns = read;
    if (columns->count > MAX_COLUMNS)
    {
        return swFail(lines->host, SW_ERROR_FORMAT, "%s:%d: the heading names %d columns; at most %d are read.",
                      lines->name, lines->line, columns->count, MAX_COLUMNS);
    }
    return SW_SUCCESS;
}

swResult swReadSummaryFile(const swHost* host, const char* text, size_t size, const char* name, swSummaryFile* file)
{
    memset(file, 0, sizeof(*file));
    file->name = name;
    swTrial trial;
    swBeginTrial(&trial, host);
    swText lines = swOpenText(&trial.host, text, size, name);
    Columns columns = {0};
    swResult result = SW_SUCCESS;
    while (result == SW_SUCCESS && swNextLine(&lines))
    {
        result = readLine(&lines, &trial, &columns, file);
    }
    result = swEndTrial(&trial, result);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (file->rows.count == 0 && trial.leftOutCount > 0)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s Nothing else could be read.", trial.first);
    }
    if (file->rows.count == 0)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:%d: the file ends without a record; is this an NDBC wave summary?",
                      name, lines.line > 0 ? lines.line : 1);
    }
    swSortNdbcRows(&lines, &file->rows);
    return SW_SUCCESS;
}
