// SPDX-License-Identifier: MIT
// Reads the wave files of the US National Data Buoy Center [NDBC 2024]. Two layouts are told apart by their lines:
//
// real time, frequencies beside each value, newest first, energy with a separation frequency after the date:
//   #YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >
//   2022 05 12 23 50 0.250 0.000 (0.033) 0.000 (0.038) ...
//
// archive, frequencies in the heading; no minutes before 2005, two-digit years before 1999, r1 and r2 times 100:
//   #YY  MM DD hh mm .0200  .0325  .0375 ...
//   2021 01 01 00 40   0.00   0.00   0.12 ...
//
// Missing numbers are 999 (with any decimals) or MM. Other lines that start with '#' are comments.

#include "core/formats/ndbc.h"

#include <stdbool.h>
#include <string.h>

#include "core/base/text.h"
#include "core/base/trial.h"

typedef struct Reader
{
    swText text;
    swNdbcFile* file;
    swNdbcQuantity quantity;

    // Archive layout: from the last heading.
    int headingSet; // -1 before one
    bool hasMinutes;

    swTrial trial;
} Reader;

void swFreeNdbcFile(const swHost* host, swNdbcFile* file)
{
    swFreeItems(host, &file->frequencies, sizeof(float));
    swFreeItems(host, &file->sets, sizeof(swNdbcSet));
    swFreeItems(host, &file->rows, sizeof(swNdbcRow));
    swFreeItems(host, &file->values, sizeof(float));
}

static swResult failMemory(const Reader* reader)
{
    return swFail(reader->text.host, SW_ERROR_NO_MEMORY, "No memory for the contents of %s.", reader->text.name);
}

// ---- frequencies ----

// The set equal to the last `count` frequencies of the file's list, which are then dropped, or a new set of them.
static swResult keepSet(Reader* reader, size_t first, int* set)
{
    swNdbcFile* file = reader->file;
    const float* frequencies = file->frequencies.data;
    int count = (int)(file->frequencies.count - first);
    swNdbcSet* sets = file->sets.data;
    for (size_t i = file->sets.count; i > 0; --i)
    {
        const swNdbcSet* other = &sets[i - 1];
        int shared = count < other->count ? count : other->count;
        bool isSame = memcmp(frequencies + first, frequencies + other->first, (size_t)shared * sizeof(float)) == 0;
        if (isSame && count == other->count)
        {
            file->frequencies.count = first;
            *set = (int)(i - 1);
            return SW_SUCCESS;
        }
        if (isSame && i == file->sets.count && reader->headingSet < 0 && count > other->count)
        {
            sets[i - 1].isCut = true;
        }
        else if (isSame && i == file->sets.count && reader->headingSet < 0)
        {
            return swFail(
                reader->text.host, SW_ERROR_FORMAT,
                "%s:%d: the line has %d frequencies where others have %d, the same up to there; one of them is "
                "cut off.",
                reader->text.name, reader->text.line, count, other->count);
        }
    }
    if (file->sets.count >= 256)
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT,
                      "%s:%d: the frequencies change for the 256th time; a file may hold 256 different lists of them.",
                      reader->text.name, reader->text.line);
    }
    swNdbcSet* added = swAppendItems(reader->text.host, &file->sets, 1, sizeof(swNdbcSet));
    if (added == NULL)
    {
        return failMemory(reader);
    }
    *added = (swNdbcSet){first, count, false};
    *set = (int)file->sets.count - 1;
    return SW_SUCCESS;
}

static swResult addFrequency(Reader* reader, size_t first, swToken token)
{
    swArray* frequencies = &reader->file->frequencies;
    double value = 0.0;
    if (!swParseToken(token, &value))
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: '%.*s' stands where a frequency is expected.",
                      reader->text.name, reader->text.line, token.size, token.text);
    }
    double before = frequencies->count > first ? (double)((float*)frequencies->data)[frequencies->count - 1] : 0.0;
    if (!((float)value > (float)before && value <= 100.0))
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT,
                      "%s:%d: the frequency %g Hz follows %g Hz; frequencies must ascend from above 0 to 100 Hz.",
                      reader->text.name, reader->text.line, value, before);
    }
    if (frequencies->count - first >= SW_NDBC_MAX_FREQUENCIES)
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: more than %d frequencies.", reader->text.name,
                      reader->text.line, SW_NDBC_MAX_FREQUENCIES);
    }
    float* added = swAppendItems(reader->text.host, frequencies, 1, sizeof(float));
    if (added == NULL)
    {
        return failMemory(reader);
    }
    *added = (float)value;
    return SW_SUCCESS;
}

// What a file of each quantity is called in its heading, in words and by its name.
static const struct
{
    const char *heading, *meaning, *ending;
} s_quantities[SW_NDBC_QUANTITY_COUNT] = {
    [SW_NDBC_ENERGY] = {"spec_", "energies", ".data_spec"},
    [SW_NDBC_ALPHA1] = {"alpha1", "directions (alpha1)", ".swdir"},
    [SW_NDBC_ALPHA2] = {"alpha2", "directions (alpha2)", ".swdir2"},
    [SW_NDBC_R1] = {"r1", "lengths of moments (r1)", ".swr1"},
    [SW_NDBC_R2] = {"r2", "lengths of moments (r2)", ".swr2"},
};

// A heading that names another quantity than the one that is wanted.
static swResult checkQuantity(const Reader* reader, swToken label)
{
    for (int i = 0; i < SW_NDBC_QUANTITY_COUNT; ++i)
    {
        size_t size = strlen(s_quantities[i].heading);
        bool isNamed = (size_t)label.size >= size && memcmp(label.text, s_quantities[i].heading, size) == 0;
        if (isNamed && i != (int)reader->quantity)
        {
            return swFail(
                reader->text.host, SW_ERROR_FORMAT,
                "%s:%d: these are %s, not %s: the heading names '%.*s'. Name the set by its file of energies, "
                "such as 44013.data_spec or 44013w2021.txt; %s files beside it are found by themselves.",
                reader->text.name, reader->text.line, s_quantities[i].meaning, s_quantities[reader->quantity].meaning,
                label.size, label.text, s_quantities[i].ending);
        }
    }
    return SW_SUCCESS;
}

// A line of names: those of the date's columns, then in archives the frequencies.
static swResult readHeading(Reader* reader)
{
    if (*reader->text.at == '#')
    {
        ++reader->text.at;
    }
    int labelCount = 0;
    double number = 0.0;
    swToken token = swNextToken(&reader->text);
    bool isOfDate = token.size >= 2 && memcmp(token.text, "YY", 2) == 0;
    for (; token.size > 0 && !swParseToken(token, &number); token = swNextToken(&reader->text))
    {
        ++labelCount;
        swResult result = isOfDate ? checkQuantity(reader, token) : SW_SUCCESS;
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    if (token.size == 0 || (labelCount != 4 && labelCount != 5))
    {
        return SW_SUCCESS; // a comment, or the heading of the real-time layout
    }
    reader->hasMinutes = labelCount == 5;
    reader->headingSet = -1;
    size_t first = reader->file->frequencies.count;
    for (; token.size > 0; token = swNextToken(&reader->text))
    {
        swResult result = addFrequency(reader, first, token);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    if (reader->file->frequencies.count - first < 2)
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: the heading names fewer than 2 frequencies.",
                      reader->text.name, reader->text.line);
    }
    reader->headingSet = 0; // allow a list that begins as another does
    return keepSet(reader, first, &reader->headingSet);
}

// ---- rows ----

// Checks a number of the file's quantity. Ratios are scaled once all are known.
static swResult addValue(Reader* reader, swToken token)
{
    double value = 0.0;
    if (swIsToken(token, "MM"))
    {
        value = 999.0;
    }
    else if (!swParseToken(token, &value))
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: '%.*s' is not a number.", reader->text.name,
                      reader->text.line, token.size, token.text);
    }
    static const double largest[SW_NDBC_QUANTITY_COUNT] = {998.0, 360.0, 360.0, 110.0, 110.0};
    bool isMissing = value >= 999.0;
    if (!isMissing && (value < 0.0 || value > largest[reader->quantity]))
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT,
                      "%s:%d: the value is %g; it must be from 0 to %g, or 999 or MM where it is missing.",
                      reader->text.name, reader->text.line, value, largest[reader->quantity]);
    }
    float* added = swAppendItems(reader->text.host, &reader->file->values, 1, sizeof(float));
    if (added == NULL)
    {
        return failMemory(reader);
    }
    *added = isMissing ? SW_NDBC_MISSING : (float)value;
    return SW_SUCCESS;
}

// "value (frequency)" to the end of the line, perhaps after a separation frequency.
static swResult readPairs(Reader* reader, int* set)
{
    size_t firstFrequency = reader->file->frequencies.count;
    swToken token = swNextToken(&reader->text);
    if (swPeekChar(&reader->text) != '(')
    {
        double separation = 0.0;
        if (!swIsToken(token, "MM") && !swParseToken(token, &separation))
        {
            return swFail(reader->text.host, SW_ERROR_FORMAT,
                          "%s:%d: '%.*s' stands where a value or the separation frequency is expected.",
                          reader->text.name, reader->text.line, token.size, token.text);
        }
        token = swNextToken(&reader->text);
    }
    for (; token.size > 0; token = swNextToken(&reader->text))
    {
        swToken open = swNextToken(&reader->text);
        swToken frequency = swNextToken(&reader->text);
        swToken close = swNextToken(&reader->text);
        if (!swIsToken(open, "(") || frequency.size == 0 || !swIsToken(close, ")"))
        {
            return swFail(
                reader->text.host, SW_ERROR_FORMAT,
                "%s:%d: the value '%.*s' is not followed by its frequency in parentheses; the line may be cut "
                "off.",
                reader->text.name, reader->text.line, token.size, token.text);
        }
        swResult result = addValue(reader, token);
        if (result == SW_SUCCESS)
        {
            result = addFrequency(reader, firstFrequency, frequency);
        }
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    if (reader->file->frequencies.count - firstFrequency < 2)
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT, "%s:%d: the line has fewer than 2 frequencies.",
                      reader->text.name, reader->text.line);
    }
    return keepSet(reader, firstFrequency, set);
}

// As many values as the heading has frequencies.
static swResult readColumns(Reader* reader)
{
    const swNdbcSet* set = (const swNdbcSet*)reader->file->sets.data + reader->headingSet;
    int count = 0;
    for (swToken token = swNextToken(&reader->text); token.size > 0; token = swNextToken(&reader->text))
    {
        ++count;
        swResult result = count <= set->count ? addValue(reader, token) : SW_SUCCESS;
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    if (count != set->count)
    {
        return swFail(reader->text.host, SW_ERROR_FORMAT,
                      "%s:%d: the line has %d values for the heading's %d frequencies%s.", reader->text.name,
                      reader->text.line, count, set->count, count < set->count ? "; it may be cut off" : "");
    }
    return SW_SUCCESS;
}

static swResult readRow(Reader* reader)
{
    bool isRealTime = memchr(reader->text.at, '(', (size_t)(reader->text.lineEnd - reader->text.at)) != NULL;
    if (!isRealTime && reader->headingSet < 0)
    {
        return swFail(
            reader->text.host, SW_ERROR_FORMAT,
            "%s:%d: no frequencies: neither in parentheses after each value nor in a heading above; is this an "
            "NDBC spectrum file?",
            reader->text.name, reader->text.line);
    }
    swNdbcRow row = {0, reader->file->values.count, reader->headingSet, reader->text.line};
    swResult result = swReadNdbcDate(&reader->text, isRealTime || reader->hasMinutes, &row.minutes);
    if (result == SW_SUCCESS)
    {
        result = isRealTime ? readPairs(reader, &row.set) : readColumns(reader);
    }
    if (result != SW_SUCCESS)
    {
        return result;
    }
    return swAppendNdbcRow(&reader->text, &reader->file->rows, &row);
}

// ---- the whole file ----

// Archives hold r1 and r2 times 100. In files that do not, 99 means missing too.
static void scaleRatios(swNdbcFile* file)
{
    float* values = file->values.data;
    bool isPercent = false;
    for (size_t i = 0; i < file->values.count; ++i)
    {
        isPercent = isPercent || (values[i] > 2.0f && values[i] != 99.0f);
    }
    for (size_t i = 0; i < file->values.count; ++i)
    {
        if (isPercent && values[i] >= 0.0f)
        {
            values[i] *= 0.01f;
        }
        else if (values[i] == 99.0f)
        {
            values[i] = SW_NDBC_MISSING;
        }
    }
}

// What a broken line has left is taken back.
static swResult readRowOrLeaveOut(Reader* reader)
{
    swNdbcFile* file = reader->file;
    size_t values = file->values.count, frequencies = file->frequencies.count, sets = file->sets.count;
    swResult room = swCheckNdbcRoom(&reader->text, file->rows.count, values);
    if (room != SW_SUCCESS)
    {
        return room;
    }
    swResult row = readRow(reader);
    swResult result = swJudgeTrial(&reader->trial, row, "line", reader->text.line);
    if (row != SW_SUCCESS && result == SW_SUCCESS)
    {
        file->values.count = values;
        file->frequencies.count = frequencies;
        file->sets.count = sets;
    }
    return result;
}

// Lines that were found to be cut off only by longer ones behind them.
static void dropCutRows(Reader* reader)
{
    const swNdbcSet* sets = reader->file->sets.data;
    swNdbcRow* rows = reader->file->rows.data;
    size_t kept = 0;
    for (size_t i = 0; i < reader->file->rows.count; ++i)
    {
        if (sets[rows[i].set].isCut)
        {
            swResult result = swFail(reader->text.host, SW_ERROR_FORMAT,
                                     "%s:%d: the line has %d frequencies where others have more; it is cut off.",
                                     reader->text.name, rows[i].line, sets[rows[i].set].count);
            swJudgeTrial(&reader->trial, result, "line", rows[i].line);
            continue;
        }
        rows[kept++] = rows[i];
    }
    reader->file->rows.count = kept;
}

static swResult readLines(Reader* reader)
{
    swResult result = SW_SUCCESS;
    while (result == SW_SUCCESS && swNextLine(&reader->text))
    {
        result = swIsNdbcHeading(&reader->text) ? readHeading(reader) : readRowOrLeaveOut(reader);
    }
    if (result == SW_SUCCESS)
    {
        dropCutRows(reader);
    }
    return swEndTrial(&reader->trial, result);
}

swResult swReadNdbcFile(const swHost* host, const char* text, size_t size, const char* name, swNdbcQuantity quantity,
                        swNdbcFile* file)
{
    memset(file, 0, sizeof(*file));
    file->name = name;
    Reader reader = {.file = file, .quantity = quantity, .headingSet = -1};
    swBeginTrial(&reader.trial, host);
    reader.text = swOpenText(&reader.trial.host, text, size, name);
    swResult result = readLines(&reader);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    if (file->rows.count == 0 && reader.trial.leftOutCount > 0)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s Nothing else could be read.", reader.trial.first);
    }
    if (file->rows.count == 0)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:%d: the file ends without a record; is this an NDBC spectrum file?",
                      name, reader.text.line > 0 ? reader.text.line : 1);
    }
    swSortNdbcRows(&reader.text, &file->rows);
    if (quantity == SW_NDBC_R1 || quantity == SW_NDBC_R2)
    {
        scaleRatios(file);
    }
    return SW_SUCCESS;
}

const swNdbcRow* swFindNdbcRow(const swNdbcFile* file, int64_t minutes)
{
    const swNdbcRow* rows = file->rows.data;
    size_t low = 0;
    size_t high = file->rows.count;
    while (low < high)
    {
        size_t middle = (low + high) / 2;
        if (rows[middle].minutes == minutes)
        {
            return &rows[middle];
        }
        if (rows[middle].minutes < minutes)
        {
            low = middle + 1;
        }
        else
        {
            high = middle;
        }
    }
    return NULL;
}
