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
// Missing numbers are 999 (with any decimals) or MM. Other lines that start with '#' are comments. Numbers are parsed
// here because the C library's parsers follow the locale.

#include "core/waves/ndbc.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/host.h"
#include "core/base/number.h"

typedef struct Reader
{
    const swHost* host;
    swNdbcFile* file;
    swNdbcQuantity quantity;
    const char* name;
    const char* next; // first character of the next line
    const char* end;
    int line; // of `at`, from 1
    const char* at;
    const char* lineEnd;

    // Archive layout: from the last heading.
    int headingSet; // -1 before one
    bool hasMinutes;
} Reader;

typedef struct Token
{
    const char* text;
    int size;
} Token;

// ---- memory ----

static void* appendItems(const swHost* host, swNdbcArray* array, size_t count, size_t itemSize)
{
    if (array->count + count > array->capacity)
    {
        size_t capacity = array->capacity < 64 ? 64 : 2 * array->capacity;
        while (capacity < array->count + count)
        {
            capacity *= 2;
        }
        void* data = swAllocate(host, capacity * itemSize);
        if (data == NULL)
        {
            return NULL;
        }
        if (array->count > 0)
        {
            memcpy(data, array->data, array->count * itemSize);
        }
        swFree(host, array->data, array->capacity * itemSize);
        array->data = data;
        array->capacity = capacity;
    }
    void* items = (char*)array->data + array->count * itemSize;
    array->count += count;
    return items;
}

static void freeItems(const swHost* host, swNdbcArray* array, size_t itemSize)
{
    swFree(host, array->data, array->capacity * itemSize);
    memset(array, 0, sizeof(*array));
}

void swFreeNdbcFile(const swHost* host, swNdbcFile* file)
{
    freeItems(host, &file->frequencies, sizeof(float));
    freeItems(host, &file->sets, sizeof(swNdbcSet));
    freeItems(host, &file->rows, sizeof(swNdbcRow));
    freeItems(host, &file->values, sizeof(float));
}

static swResult failMemory(const Reader* reader)
{
    return swFail(reader->host, SW_ERROR_NO_MEMORY, "No memory for the contents of %s.", reader->name);
}

// ---- dates ----

static bool isLeapYear(int year)
{
    return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

int swGetDaysInMonth(int year, int month)
{
    static const int days[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return days[month - 1] + (month == 2 && isLeapYear(year) ? 1 : 0);
}

int64_t swGetMinutes(int year, int month, int day, int hour, int minute)
{
    int64_t days = day - 1;
    for (int y = 1900; y < year; ++y)
    {
        days += isLeapYear(y) ? 366 : 365;
    }
    for (int m = 1; m < month; ++m)
    {
        days += swGetDaysInMonth(year, m);
    }
    days -= 25567; // 1900 to 1970
    return (days * 24 + hour) * 60 + minute;
}

static void printDigits(char* text, int value, int digits)
{
    for (int i = digits - 1; i >= 0; --i)
    {
        text[i] = (char)('0' + value % 10);
        value /= 10;
    }
}

void swPrintMinutes(int64_t minutes, char text[20])
{
    int64_t sinceStart = minutes + (int64_t)25567 * 1440;
    int days = (int)(sinceStart / 1440);
    int rest = (int)(sinceStart % 1440);
    int year = 1900;
    while (days >= (isLeapYear(year) ? 366 : 365))
    {
        days -= isLeapYear(year) ? 366 : 365;
        ++year;
    }
    int month = 1;
    while (days >= swGetDaysInMonth(year, month))
    {
        days -= swGetDaysInMonth(year, month);
        ++month;
    }
    memcpy(text, "0000-00-00 00:00", 17);
    printDigits(text, year, 4);
    printDigits(text + 5, month, 2);
    printDigits(text + 8, days + 1, 2);
    printDigits(text + 11, rest / 60, 2);
    printDigits(text + 14, rest % 60, 2);
}

// ---- lines and tokens ----

static bool nextLine(Reader* reader)
{
    if (reader->next >= reader->end)
    {
        return false;
    }
    size_t left = (size_t)(reader->end - reader->next);
    const char* newline = memchr(reader->next, '\n', left);
    reader->at = reader->next;
    reader->lineEnd = newline != NULL ? newline : reader->end;
    reader->next = newline != NULL ? newline + 1 : reader->end;
    ++reader->line;
    return true;
}

static bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

static char peekChar(Reader* reader)
{
    while (reader->at < reader->lineEnd && isSpace(*reader->at))
    {
        ++reader->at;
    }
    return reader->at < reader->lineEnd ? *reader->at : '\0';
}

// Empty at the end of the line. Parentheses stand alone.
static Token nextToken(Reader* reader)
{
    peekChar(reader);
    const char* begin = reader->at;
    while (reader->at < reader->lineEnd && !isSpace(*reader->at))
    {
        bool isParenthesis = *reader->at == '(' || *reader->at == ')';
        if (isParenthesis && reader->at > begin)
        {
            break;
        }
        ++reader->at;
        if (isParenthesis)
        {
            break;
        }
    }
    return (Token){begin, (int)(reader->at - begin < 80 ? reader->at - begin : 80)};
}

static bool parseNumber(Token token, double* value)
{
    return swParseNumber(token.text, token.size, value);
}

static bool isText(Token token, const char* text)
{
    return (size_t)token.size == strlen(text) && memcmp(token.text, text, (size_t)token.size) == 0;
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
        if (isSame && i == file->sets.count && reader->headingSet < 0)
        {
            return swFail(
                reader->host, SW_ERROR_FORMAT,
                "%s:%d: the line has %d frequencies where others have %d, the same up to there; one of them is "
                "cut off.",
                reader->name, reader->line, count, other->count);
        }
    }
    if (file->sets.count >= 256)
    {
        return swFail(reader->host, SW_ERROR_FORMAT,
                      "%s:%d: the frequencies change for the 256th time; a file may hold 256 different lists of them.",
                      reader->name, reader->line);
    }
    swNdbcSet* added = appendItems(reader->host, &file->sets, 1, sizeof(swNdbcSet));
    if (added == NULL)
    {
        return failMemory(reader);
    }
    *added = (swNdbcSet){first, count};
    *set = (int)file->sets.count - 1;
    return SW_SUCCESS;
}

static swResult addFrequency(Reader* reader, size_t first, Token token)
{
    swNdbcArray* frequencies = &reader->file->frequencies;
    double value = 0.0;
    if (!parseNumber(token, &value))
    {
        return swFail(reader->host, SW_ERROR_FORMAT, "%s:%d: '%.*s' stands where a frequency is expected.",
                      reader->name, reader->line, token.size, token.text);
    }
    double before = frequencies->count > first ? (double)((float*)frequencies->data)[frequencies->count - 1] : 0.0;
    if (!((float)value > (float)before && value <= 100.0))
    {
        return swFail(reader->host, SW_ERROR_FORMAT,
                      "%s:%d: the frequency %g Hz follows %g Hz; frequencies must ascend from above 0 to 100 Hz.",
                      reader->name, reader->line, value, before);
    }
    if (frequencies->count - first >= SW_NDBC_MAX_FREQUENCIES)
    {
        return swFail(reader->host, SW_ERROR_FORMAT, "%s:%d: more than %d frequencies.", reader->name, reader->line,
                      SW_NDBC_MAX_FREQUENCIES);
    }
    float* added = appendItems(reader->host, frequencies, 1, sizeof(float));
    if (added == NULL)
    {
        return failMemory(reader);
    }
    *added = (float)value;
    return SW_SUCCESS;
}

// A line of names: those of the date's columns, then in archives the frequencies.
static swResult readHeading(Reader* reader)
{
    if (*reader->at == '#')
    {
        ++reader->at;
    }
    int labelCount = 0;
    double number = 0.0;
    Token token = nextToken(reader);
    for (; token.size > 0 && !parseNumber(token, &number); token = nextToken(reader))
    {
        ++labelCount;
    }
    if (token.size == 0 || (labelCount != 4 && labelCount != 5))
    {
        return SW_SUCCESS; // a comment, or the heading of the real-time layout
    }
    reader->hasMinutes = labelCount == 5;
    reader->headingSet = -1;
    size_t first = reader->file->frequencies.count;
    for (; token.size > 0; token = nextToken(reader))
    {
        swResult result = addFrequency(reader, first, token);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    if (reader->file->frequencies.count - first < 2)
    {
        return swFail(reader->host, SW_ERROR_FORMAT, "%s:%d: the heading names fewer than 2 frequencies.", reader->name,
                      reader->line);
    }
    reader->headingSet = 0; // allow a list that begins as another does
    return keepSet(reader, first, &reader->headingSet);
}

// ---- rows ----

static swResult readDatePart(Reader* reader, const char* what, int low, int high, int* value)
{
    Token token = nextToken(reader);
    double number = 0.0;
    if (!parseNumber(token, &number) || number < low || number > high || number != floor(number))
    {
        return swFail(reader->host, SW_ERROR_FORMAT, "%s:%d: the %s is '%.*s'; it must be a number from %d to %d.",
                      reader->name, reader->line, what, token.size, token.text, low, high);
    }
    *value = (int)number;
    return SW_SUCCESS;
}

static swResult readDate(Reader* reader, bool hasMinutes, int64_t* minutes)
{
    int year = 0;
    int month = 1;
    int day = 1;
    int hour = 0;
    int minute = 0;
    swResult result = readDatePart(reader, "year", 0, 2199, &year);
    year += year < 50 ? 2000 : year < 100 ? 1900 : 0;
    if (result == SW_SUCCESS && year < 1900)
    {
        result =
            swFail(reader->host, SW_ERROR_FORMAT, "%s:%d: the year is %d; it must have two digits or be above 1900.",
                   reader->name, reader->line, year);
    }
    if (result == SW_SUCCESS)
    {
        result = readDatePart(reader, "month", 1, 12, &month);
    }
    if (result == SW_SUCCESS)
    {
        result = readDatePart(reader, "day", 1, swGetDaysInMonth(year, month), &day);
    }
    if (result == SW_SUCCESS)
    {
        result = readDatePart(reader, "hour", 0, 23, &hour);
    }
    if (result == SW_SUCCESS && hasMinutes)
    {
        result = readDatePart(reader, "minute", 0, 59, &minute);
    }
    *minutes = swGetMinutes(year, month, day, hour, minute);
    return result;
}

// Checks a number of the file's quantity. Ratios are scaled once all are known.
static swResult addValue(Reader* reader, Token token)
{
    double value = 0.0;
    if (isText(token, "MM"))
    {
        value = 999.0;
    }
    else if (!parseNumber(token, &value))
    {
        return swFail(reader->host, SW_ERROR_FORMAT, "%s:%d: '%.*s' is not a number.", reader->name, reader->line,
                      token.size, token.text);
    }
    static const double largest[] = {998.0, 360.0, 110.0};
    bool isMissing = value >= 999.0;
    if (!isMissing && (value < 0.0 || value > largest[reader->quantity]))
    {
        return swFail(reader->host, SW_ERROR_FORMAT,
                      "%s:%d: the value is %g; it must be from 0 to %g, or 999 or MM where it is missing.",
                      reader->name, reader->line, value, largest[reader->quantity]);
    }
    if (reader->file->values.count >= SW_NDBC_MAX_VALUES)
    {
        return swFail(reader->host, SW_ERROR_FORMAT, "%s:%d: more than %d values; cut the file in time.", reader->name,
                      reader->line, SW_NDBC_MAX_VALUES);
    }
    float* added = appendItems(reader->host, &reader->file->values, 1, sizeof(float));
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
    Token token = nextToken(reader);
    if (peekChar(reader) != '(')
    {
        double separation = 0.0;
        if (!isText(token, "MM") && !parseNumber(token, &separation))
        {
            return swFail(reader->host, SW_ERROR_FORMAT,
                          "%s:%d: '%.*s' stands where a value or the separation frequency is expected.", reader->name,
                          reader->line, token.size, token.text);
        }
        token = nextToken(reader);
    }
    for (; token.size > 0; token = nextToken(reader))
    {
        Token open = nextToken(reader);
        Token frequency = nextToken(reader);
        Token close = nextToken(reader);
        if (!isText(open, "(") || frequency.size == 0 || !isText(close, ")"))
        {
            return swFail(
                reader->host, SW_ERROR_FORMAT,
                "%s:%d: the value '%.*s' is not followed by its frequency in parentheses; the line may be cut "
                "off.",
                reader->name, reader->line, token.size, token.text);
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
        return swFail(reader->host, SW_ERROR_FORMAT, "%s:%d: the line has fewer than 2 frequencies.", reader->name,
                      reader->line);
    }
    return keepSet(reader, firstFrequency, set);
}

// As many values as the heading has frequencies.
static swResult readColumns(Reader* reader)
{
    const swNdbcSet* set = (const swNdbcSet*)reader->file->sets.data + reader->headingSet;
    int count = 0;
    for (Token token = nextToken(reader); token.size > 0; token = nextToken(reader))
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
        return swFail(reader->host, SW_ERROR_FORMAT,
                      "%s:%d: the line has %d values for the heading's %d frequencies%s.", reader->name, reader->line,
                      count, set->count, count < set->count ? "; it may be cut off" : "");
    }
    return SW_SUCCESS;
}

static swResult readRow(Reader* reader)
{
    bool isRealTime = memchr(reader->at, '(', (size_t)(reader->lineEnd - reader->at)) != NULL;
    if (!isRealTime && reader->headingSet < 0)
    {
        return swFail(
            reader->host, SW_ERROR_FORMAT,
            "%s:%d: no frequencies: neither in parentheses after each value nor in a heading above; is this an "
            "NDBC spectrum file?",
            reader->name, reader->line);
    }
    if (reader->file->rows.count >= SW_NDBC_MAX_ROWS)
    {
        return swFail(reader->host, SW_ERROR_FORMAT, "%s:%d: more than %d records; cut the file in time.", reader->name,
                      reader->line, SW_NDBC_MAX_ROWS);
    }
    swNdbcRow row = {0, reader->file->values.count, reader->headingSet, reader->line};
    swResult result = readDate(reader, isRealTime || reader->hasMinutes, &row.minutes);
    if (result == SW_SUCCESS)
    {
        result = isRealTime ? readPairs(reader, &row.set) : readColumns(reader);
    }
    if (result != SW_SUCCESS)
    {
        return result;
    }
    swNdbcRow* added = appendItems(reader->host, &reader->file->rows, 1, sizeof(swNdbcRow));
    if (added == NULL)
    {
        return failMemory(reader);
    }
    *added = row;
    return SW_SUCCESS;
}

// ---- the whole file ----

static int compareRows(const void* a, const void* b)
{
    const swNdbcRow* first = a;
    const swNdbcRow* second = b;
    if (first->minutes != second->minutes)
    {
        return first->minutes < second->minutes ? -1 : 1;
    }
    return (first->line > second->line) - (first->line < second->line);
}

static void sortRows(Reader* reader)
{
    swNdbcArray* array = &reader->file->rows;
    swNdbcRow* rows = array->data;
    qsort(rows, array->count, sizeof(swNdbcRow), compareRows);
    size_t kept = 0;
    for (size_t i = 0; i < array->count; ++i)
    {
        if (kept > 0 && rows[kept - 1].minutes == rows[i].minutes)
        {
            char time[20];
            swPrintMinutes(rows[i].minutes, time);
            swLog(reader->host, SW_LOG_WARNING, "%s:%d: a second record of %s is ignored; the first is on line %d.",
                  reader->name, rows[i].line, time, rows[kept - 1].line);
            continue;
        }
        rows[kept++] = rows[i];
    }
    array->count = kept;
}

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

swResult swReadNdbcFile(const swHost* host, const char* text, size_t size, const char* name, swNdbcQuantity quantity,
                        swNdbcFile* file)
{
    memset(file, 0, sizeof(*file));
    file->name = name;
    Reader reader = {host, file, quantity, name, text, text + size, 0, text, text, -1, false};
    while (nextLine(&reader))
    {
        char first = peekChar(&reader);
        if (first == '\0' && reader.at == reader.lineEnd)
        {
            continue;
        }
        bool isHeading = first == '#' || first == 'Y';
        swResult result = isHeading ? readHeading(&reader) : readRow(&reader);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    if (file->rows.count == 0)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:%d: the file ends without a record; is this an NDBC spectrum file?",
                      name, reader.line > 0 ? reader.line : 1);
    }
    sortRows(&reader);
    if (quantity == SW_NDBC_RATIO)
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
