// SPDX-License-Identifier: MIT
// Times in netCDF: numbers of a unit since an origin, as CF writes them. Origins lie anywhere from the year 1 on; of
// the standard calendar those before 15 October 1582 are Julian.

#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <string.h>

#include "core/base/host.h"
#include "core/base/number.h"
#include "files/netcdf_axes.h"

#define DAY 86400.0

// Days since 1970-01-01 of a date of the Gregorian or the Julian calendar, by counting years from March on, so that the
// day that leap years add is a year's last.
static double countDays(int year, int month, int day, bool isGregorian)
{
    int y = month > 2 ? year : year - 1;
    int m = month > 2 ? month - 3 : month + 9;
    double days = 365.0 * y + floor(y / 4.0) + (153 * m + 2) / 5 + day - 1;
    return isGregorian ? days - floor(y / 100.0) + floor(y / 400.0) - 719468.0 : days - 719470.0;
}

static bool isGregorianDate(int year, int month, int day, const char* calendar)
{
    return strcmp(calendar, "proleptic gregorian") == 0 || year * 10000 + month * 100 + day >= 15821015;
}

// "+05:30", "-3", "z", "utc" or nothing, to seconds east of Greenwich.
static bool parseZone(const char* text, double* seconds)
{
    int hours = 0, minutes = 0;
    char sign = '\0';
    *seconds = 0.0;
    text += strspn(text, " ");
    if (*text == '\0' || strcmp(text, "z") == 0 || strcmp(text, "utc") == 0 || strcmp(text, "gmt") == 0 ||
        strcmp(text, "ut") == 0)
    {
        return true;
    }
    int end = 0;
    if (sscanf(text, "%c%2d:%2d%n", &sign, &hours, &minutes, &end) < 3)
    {
        minutes = 0;
        if (sscanf(text, "%c%2d%n", &sign, &hours, &end) < 2)
        {
            return false;
        }
    }
    bool isZone = (sign == '+' || sign == '-') && hours >= 0 && hours < 24 && minutes >= 0 && minutes < 60;
    *seconds = (sign == '-' ? -60.0 : 60.0) * (60 * hours + minutes);
    return isZone && strspn(text + end, " ") == strlen(text + end);
}

// What is behind "since ", in lower case.
static bool parseOrigin(const char* text, const char* calendar, double* origin)
{
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, end = 0;
    double second = 0.0, zone = 0.0;
    if (sscanf(text, "%4d-%2d-%2d%n", &year, &month, &day, &end) < 3)
    {
        return false;
    }
    text += end;
    char joint = text[0];
    if ((joint == 't' || joint == ' ') && sscanf(text + 1, "%2d:%2d%n", &hour, &minute, &end) == 2)
    {
        text += 1 + end;
        if (*text == ':')
        {
            size_t length = strspn(text + 1, "0123456789.");
            if (length == 0 || !swParseNumber(text + 1, (int)length, &second))
            {
                return false;
            }
            text += 1 + length;
        }
    }
    bool isFine = year >= 1 && year <= 9999 && month >= 1 && month <= 12 && day >= 1 && day <= 31 && hour >= 0 &&
                  hour <= 24 && minute >= 0 && minute < 60 && second >= 0.0 && second < 61.0 && parseZone(text, &zone);
    *origin = countDays(year, month, day, isGregorianDate(year, month, day, calendar)) * DAY + hour * 3600.0 +
              minute * 60.0 + second - zone;
    return isFine;
}

bool swParseNetcdfTimeUnit(const char* text, const char* calendar, double* factor, double* origin)
{
    static const struct
    {
        const char* names[6];
        double seconds;
    } units[] = {{{"days", "day", "d", NULL}, DAY},
                 {{"hours", "hour", "hrs", "hr", "h", NULL}, 3600.0},
                 {{"minutes", "minute", "mins", "min", NULL}, 60.0},
                 {{"seconds", "second", "secs", "sec", "s", NULL}, 1.0},
                 {{"milliseconds", "millisecond", "msec", "ms", NULL}, 1e-3},
                 {{"microseconds", "microsecond", NULL}, 1e-6},
                 {{"nanoseconds", "nanosecond", NULL}, 1e-9}};
    char lower[128], unit[32] = "";
    size_t i = 0;
    for (; text[i] != '\0' && i + 1 < sizeof(lower); ++i)
    {
        lower[i] = text[i] >= 'A' && text[i] <= 'Z' ? (char)(text[i] + 32) : text[i];
    }
    lower[i] = '\0';
    const char* since = strstr(lower, "since ");
    bool isStrange = strcmp(calendar, "360 day") == 0 || strcmp(calendar, "noleap") == 0 ||
                     strcmp(calendar, "365 day") == 0 || strcmp(calendar, "all leap") == 0 ||
                     strcmp(calendar, "366 day") == 0 || strcmp(calendar, "julian") == 0;
    if (isStrange || since == NULL || sscanf(lower, "%31s", unit) != 1 || !parseOrigin(since + 6, calendar, origin))
    {
        return false;
    }
    *factor = 0.0;
    for (i = 0; i < sizeof(units) / sizeof(units[0]); ++i)
    {
        *factor = swIsOneOf(unit, units[i].names) ? units[i].seconds : *factor;
    }
    return *factor > 0.0;
}

// The variable of the dimension of times, or one that stands alone beside spectra without that dimension.
static bool findTime(swNetcdfAxes* axes)
{
    static const char* const names[] = {"time",       "valid_time",     "ocean_time", "wavetime",
                                        "time_index", "ocean_time_day", "datetime",   NULL};
    if (axes->timeAt >= 0)
    {
        return swFindNetcdfCoordinate(&axes->file, axes->main.dimensions[axes->timeAt], names, &axes->time);
    }
    return (swFindNetcdfVariable(&axes->file, "time", &axes->time) ||
            swFindNetcdfVariable(&axes->file, "valid_time", &axes->time)) &&
           axes->time.dimensionCount == 0;
}

swResult swReadNetcdfTimeUnit(swNetcdfAxes* axes)
{
    char text[128], calendar[64];
    axes->hasTime = findTime(axes);
    if (!axes->hasTime)
    {
        return axes->timeAt < 0
                   ? SW_SUCCESS
                   : swFail(axes->file.host, SW_ERROR_FORMAT, "%s: the times have no values.", axes->file.name);
    }
    swGetNetcdfText(&axes->file, axes->time.id, "units", false, text, sizeof(text));
    swGetNetcdfText(&axes->file, axes->time.id, "calendar", true, calendar, sizeof(calendar));
    if (!swParseNetcdfTimeUnit(text, calendar, &axes->timeFactor, &axes->timeOrigin))
    {
        return swFail(axes->file.host, SW_ERROR_FORMAT,
                      "%s: the time's units are '%s', its calendar '%s'; units such as hours since 1990-01-01 00:00:00 "
                      "and the usual calendar are read.",
                      axes->file.name, text, calendar);
    }
    return SW_SUCCESS;
}

bool swReadNetcdfTime(const swNetcdfAxes* axes, size_t index, double* seconds)
{
    double value = 0.0;
    size_t one = 1;
    *seconds = (double)NAN;
    if (!axes->hasTime)
    {
        return true;
    }
    if (swReadNetcdfBlock(&axes->file, &axes->time, &index, &one, &value) != SW_SUCCESS)
    {
        return false;
    }
    *seconds = axes->timeOrigin + value * axes->timeFactor;
    // Days as floating-point numbers are off by microseconds.
    *seconds = floor(*seconds * 1000.0 + 0.5) / 1000.0;
    return *seconds >= -2208988800.0 && *seconds < 7258118400.0; // 1900 to 2199
}
