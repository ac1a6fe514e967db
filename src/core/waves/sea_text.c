// SPDX-License-Identifier: MIT
// Numbers are parsed here because the C library's parsers follow the locale.

#include "core/waves/sea_text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/host.h"

// ---- memory ----

void* swAppendSeaItems(const swHost* host, swSeaArray* array, size_t count, size_t itemSize)
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

void swFreeSeaItems(const swHost* host, swSeaArray* array, size_t itemSize)
{
    swFree(host, array->data, array->capacity * itemSize);
    memset(array, 0, sizeof(*array));
}

// ---- lines and tokens ----

swSeaText swOpenSeaText(const swHost* host, const char* text, size_t size, const char* name)
{
    bool hasMark = size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0; // UTF-8's byte order mark
    const char* begin = hasMark ? text + 3 : text;
    return (swSeaText){host, name, begin, text + size, 0, begin, begin, begin, ','};
}

static bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

static bool nextLine(swSeaText* text)
{
    if (text->next >= text->end)
    {
        return false;
    }
    const char* end = text->next;
    while (end < text->end && *end != '\n' && *end != '\r')
    {
        ++end;
    }
    bool isPair = end + 1 < text->end && end[0] == '\r' && end[1] == '\n';
    text->lineBegin = text->at = text->next;
    text->lineEnd = end;
    text->next = end < text->end ? end + (isPair ? 2 : 1) : end;
    ++text->line;
    return true;
}

bool swNextSeaLine(swSeaText* text)
{
    while (nextLine(text))
    {
        swPeekSeaChar(text);
        if (text->at < text->lineEnd)
        {
            return true;
        }
    }
    return false;
}

char swPeekSeaChar(swSeaText* text)
{
    while (text->at < text->lineEnd && isSpace(*text->at))
    {
        ++text->at;
    }
    return text->at < text->lineEnd ? *text->at : '\0';
}

static char toLower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c + ('a' - 'A')) : c;
}

// 9, 99, 999, ... whatever their decimals: 999.9 as well.
static bool isNines(double value)
{
    double nines = 9.0;
    while (nines < value && floor(value) != nines && nines < 1e6)
    {
        nines = 10.0 * nines + 9.0;
    }
    return floor(value) == nines;
}

swSeaToken swNextSeaToken(swSeaText* text)
{
    swPeekSeaChar(text);
    const char* begin = text->at;
    while (text->at < text->lineEnd && !isSpace(*text->at))
    {
        bool isParenthesis = *text->at == '(' || *text->at == ')';
        if (isParenthesis && text->at > begin)
        {
            break;
        }
        ++text->at;
        if (isParenthesis)
        {
            break;
        }
    }
    return (swSeaToken){begin, (int)(text->at - begin < 80 ? text->at - begin : 80)};
}

bool swNextSeaField(swSeaText* text, swSeaToken* field)
{
    if (text->at > text->lineEnd)
    {
        return false;
    }
    const char* end =
        text->at < text->lineEnd ? memchr(text->at, text->separator, (size_t)(text->lineEnd - text->at)) : NULL;
    end = end != NULL ? end : text->lineEnd;
    const char* begin = text->at;
    text->at = end + 1;
    while (begin < end && (isSpace(*begin) || *begin == '"'))
    {
        ++begin;
    }
    while (end > begin && (isSpace(end[-1]) || end[-1] == '"'))
    {
        --end;
    }
    *field = (swSeaToken){begin, (int)(end - begin < 80 ? end - begin : 80)};
    return true;
}

bool swIsSeaMissing(swSeaToken token)
{
    static const char* const words[] = {"", "nan", "na", "n/a", "null", "none", "mm", "-"};
    for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); ++i)
    {
        int same = 0;
        while (same < token.size && words[i][same] != '\0' && toLower(token.text[same]) == words[i][same])
        {
            ++same;
        }
        if (same == token.size && words[i][same] == '\0')
        {
            return true;
        }
    }
    double value = 0.0;
    return swParseSeaNumber(token, &value) && value <= -9.0 && isNines(-value);
}

bool swIsSeaToken(swSeaToken token, const char* word)
{
    return (size_t)token.size == strlen(word) && memcmp(token.text, word, (size_t)token.size) == 0;
}

bool swParseSeaNumber(swSeaToken token, double* value)
{
    return swParseNumber(token.text, token.size, value);
}

bool swIsNdbcHeading(swSeaText* text)
{
    char first = swPeekSeaChar(text);
    return first == '#' || first == 'Y';
}

bool swHasSeaPrefix(swSeaText* text, const char* word)
{
    swPeekSeaChar(text);
    size_t size = strlen(word);
    return (size_t)(text->lineEnd - text->at) >= size && memcmp(text->at, word, size) == 0;
}

swResult swNeedSeaLine(swSeaText* text, const char* what)
{
    if (swNextSeaLine(text))
    {
        return SW_SUCCESS;
    }
    return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the file ends where %s should follow; is it cut off?",
                  text->name, text->line > 0 ? text->line : 1, what);
}

static bool isNumberEnd(const char* begin, const char* at)
{
    bool isSign = *at == '-' || *at == '+';
    bool isExponent = at > begin && (at[-1] == 'e' || at[-1] == 'E');
    return isSpace(*at) || *at == ',' || *at == '\'' || (isSign && at > begin && !isExponent);
}

// What follows a number without exponent letter: a sign and three digits.
static bool isLostExponent(const swSeaText* text, const char* begin)
{
    const char* at = text->at;
    bool isThree = text->lineEnd - at >= 4 && at > begin && (text->lineEnd - at == 4 || isNumberEnd(at, at + 4));
    for (int i = 1; i < 4 && isThree; ++i)
    {
        isThree = at[i] >= '0' && at[i] <= '9';
    }
    return isThree && (*at == '-' || *at == '+');
}

swResult swReadSeaNumber(swSeaText* text, const char* what, bool isWide, double* value)
{
    while (swPeekSeaChar(text) == '\0' || *text->at == ',')
    {
        if (text->at < text->lineEnd)
        {
            ++text->at;
            continue;
        }
        swResult result = swNeedSeaLine(text, what);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    const char* begin = text->at;
    while (text->at < text->lineEnd && !isNumberEnd(begin, text->at))
    {
        ++text->at;
    }
    int size = (int)(text->at - begin < 80 ? text->at - begin : 80);
    if (!swParseNumber(begin, size, value))
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %s should be a number, not '%.*s'.", text->name, text->line,
                      what, size > 0 ? size : 1, begin);
    }
    if (isWide && isLostExponent(text, begin))
    {
        *value = *text->at == '-' ? 0.0 : 1e60;
        text->at += 4;
    }
    return SW_SUCCESS;
}

swResult swReadSeaRange(swSeaText* text, const char* what, double low, double high, double* value)
{
    swResult result = swReadSeaNumber(text, what, false, value);
    if (result == SW_SUCCESS && !(*value >= low && *value <= high))
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %s is %g; it must be from %g to %g.", text->name,
                        text->line, what, *value, low, high);
    }
    return result;
}

swResult swReadSeaCount(swSeaText* text, const char* what, int low, int high, int* value)
{
    double number = 0.0;
    swResult result = swReadSeaRange(text, what, low, high, &number);
    *value = result == SW_SUCCESS ? (int)number : low;
    return result;
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

bool swMakeSeconds(int year, int month, int day, int hour, int minute, double second, double* seconds)
{
    if (year < 1900 || year > 2199 || month < 1 || month > 12 || day < 1 || day > swGetDaysInMonth(year, month) ||
        hour < 0 || hour > 23 || minute < 0 || minute > 59 || !(second >= 0.0 && second <= 60.0))
    {
        return false;
    }
    *seconds = 60.0 * (double)swGetMinutes(year, month, day, hour, minute) + second;
    return true;
}

int swFindSeaMonth(const char* text, int size)
{
    static const char names[] = "janfebmaraprmayjunjulaugsepoctnovdec";
    for (int i = 0; i + 3 <= size; ++i)
    {
        for (int month = 0; month < 12; ++month)
        {
            int same = 0;
            while (same < 3 && ((text[i + same] | 0x20) == names[3 * month + same]))
            {
                ++same;
            }
            if (same == 3)
            {
                return month + 1;
            }
        }
    }
    return 0;
}

bool swMakePackedSeconds(double date, double time, double* seconds)
{
    if (!(date >= 0.0 && date < 1e8 && time >= 0.0 && time < 1e6) || date != floor(date))
    {
        return false;
    }
    int days = (int)date;
    int clock = (int)time;
    return swMakeSeconds(days / 10000, days / 100 % 100, days % 100, clock / 10000, clock / 100 % 100,
                         clock % 100 + (time - clock), seconds);
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

static swResult readDatePart(swSeaText* text, const char* what, int low, int high, int* value)
{
    swSeaToken token = swNextSeaToken(text);
    double number = 0.0;
    if (!swParseSeaNumber(token, &number) || number < low || number > high || number != floor(number))
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the %s is '%.*s'; it must be a number from %d to %d.",
                      text->name, text->line, what, token.size, token.text, low, high);
    }
    *value = (int)number;
    return SW_SUCCESS;
}

swResult swReadNdbcDate(swSeaText* text, bool hasMinutes, int64_t* minutes)
{
    int year = 0;
    int month = 1;
    int day = 1;
    int hour = 0;
    int minute = 0;
    swResult result = readDatePart(text, "year", 0, 2199, &year);
    year += year < 50 ? 2000 : year < 100 ? 1900 : 0;
    if (result == SW_SUCCESS && year < 1900)
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the year is %d; it must have two digits or be above 1900.",
                        text->name, text->line, year);
    }
    if (result == SW_SUCCESS)
    {
        result = readDatePart(text, "month", 1, 12, &month);
    }
    if (result == SW_SUCCESS)
    {
        result = readDatePart(text, "day", 1, swGetDaysInMonth(year, month), &day);
    }
    if (result == SW_SUCCESS)
    {
        result = readDatePart(text, "hour", 0, 23, &hour);
    }
    if (result == SW_SUCCESS && hasMinutes)
    {
        result = readDatePart(text, "minute", 0, 59, &minute);
    }
    *minutes = swGetMinutes(year, month, day, hour, minute);
    return result;
}

// ---- rows ----

swResult swCheckNdbcRoom(const swSeaText* text, size_t rowCount, size_t valueCount)
{
    bool hasRows = rowCount < SW_NDBC_MAX_ROWS;
    if (hasRows && valueCount < SW_NDBC_MAX_VALUES)
    {
        return SW_SUCCESS;
    }
    return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: more than %d %s; cut the file in time.", text->name, text->line,
                  hasRows ? SW_NDBC_MAX_VALUES : SW_NDBC_MAX_ROWS, hasRows ? "values" : "records");
}

swResult swAppendNdbcRow(const swSeaText* text, swSeaArray* rows, const swNdbcRow* row)
{
    swNdbcRow* added = swAppendSeaItems(text->host, rows, 1, sizeof(swNdbcRow));
    if (added == NULL)
    {
        return swFail(text->host, SW_ERROR_NO_MEMORY, "No memory for the contents of %s.", text->name);
    }
    *added = *row;
    return SW_SUCCESS;
}

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

void swSortNdbcRows(const swSeaText* text, swSeaArray* array)
{
    swNdbcRow* rows = array->data;
    qsort(rows, array->count, sizeof(swNdbcRow), compareRows);
    size_t kept = 0;
    for (size_t i = 0; i < array->count; ++i)
    {
        if (kept > 0 && rows[kept - 1].minutes == rows[i].minutes)
        {
            char time[20];
            swPrintMinutes(rows[i].minutes, time);
            swLog(text->host, SW_LOG_WARNING, "%s:%d: a second record of %s is ignored; the first is on line %d.",
                  text->name, rows[i].line, time, rows[kept - 1].line);
            continue;
        }
        rows[kept++] = rows[i];
    }
    array->count = kept;
}
