// SPDX-License-Identifier: MIT
#include "core/base/date.h"

#include <math.h>
#include <string.h>

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

int swFindMonth(const char* text, int size)
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
