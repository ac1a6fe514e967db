// SPDX-License-Identifier: MIT
#include "core/formats/ndbc_rows.h"

#include <math.h>
#include <stdlib.h>

#include "core/base/date.h"
#include "core/base/host.h"
#include "core/base/text.h"

bool swIsNdbcHeading(swText* text)
{
    char first = swPeekChar(text);
    return first == '#' || first == 'Y';
}

static swResult readDatePart(swText* text, const char* what, int low, int high, int* value)
{
    swToken token = swNextToken(text);
    double number = 0.0;
    if (!swParseToken(token, &number) || number < low || number > high || number != floor(number))
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the %s is '%.*s'; it must be a number from %d to %d.",
                      text->name, text->line, what, token.size, token.text, low, high);
    }
    *value = (int)number;
    return SW_SUCCESS;
}

swResult swReadNdbcDate(swText* text, bool hasMinutes, int64_t* minutes)
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

swResult swCheckNdbcRoom(const swText* text, size_t rowCount, size_t valueCount)
{
    bool hasRows = rowCount < SW_NDBC_MAX_ROWS;
    if (hasRows && valueCount < SW_NDBC_MAX_VALUES)
    {
        return SW_SUCCESS;
    }
    return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: more than %d %s; cut the file in time.", text->name, text->line,
                  hasRows ? SW_NDBC_MAX_VALUES : SW_NDBC_MAX_ROWS, hasRows ? "values" : "records");
}

swResult swAppendNdbcRow(const swText* text, swArray* rows, const swNdbcRow* row)
{
    swNdbcRow* added = swAppendItems(text->host, rows, 1, sizeof(swNdbcRow));
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

void swSortNdbcRows(const swText* text, swArray* array)
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
