// SPDX-License-Identifier: MIT
// Records of a measured sea by time, and places by where they lie. An answer from another year or another ocean would
// be wrong without a word, so both have limits: a time may lie outside the records by half of what usually lies between
// two of them, a point SW_MEASURED_REACH from the nearest place.

#include <math.h>
#include <stdio.h>

#include "core/base/date.h"
#include "core/base/misuse.h"
#include "core/math/scalar.h"
#include "core/records/measured.h"

#define EARTH_RADIUS 6371008.8  // m, the mean one
#define LEAST_TOLERANCE 1800.0  // s
#define LONGEST_INTERVAL 1.0e10 // s, three centuries
#define NEAR 25000.0            // m: farther away a place is taken with a warning
#define DEGREE (SW_PI / 180.0)

// ---- times ----

static const swSeaRecord* getRecords(const swMeasuredSea* sea)
{
    return sea->records.data;
}

static bool isOfPlace(const swSeaRecord* record, int location)
{
    return location < 0 || record->location == location;
}

// How many steps from one record of a place to its next there are, and how many of them are at most `longest`.
static int countSteps(const swMeasuredSea* sea, int location, double longest, int* shortCount)
{
    const swSeaRecord* records = getRecords(sea);
    int count = 0;
    *shortCount = 0;
    for (int i = 1; i < (int)sea->records.count; ++i)
    {
        if (isOfPlace(&records[i], location) && records[i].location == records[i - 1].location)
        {
            ++count;
            *shortCount += records[i].seconds - records[i - 1].seconds <= longest ? 1 : 0;
        }
    }
    return count;
}

// The median of the steps, found by halving: it needs no memory for a sorted copy. 0 if there is none.
static double findInterval(const swMeasuredSea* sea, int location)
{
    int shortCount = 0;
    double low = 0.0, high = LONGEST_INTERVAL;
    int count = countSteps(sea, location, high, &shortCount);
    for (int i = 0; i < 40 && count > 0; ++i)
    {
        double middle = 0.5 * (low + high);
        countSteps(sea, location, middle, &shortCount);
        *(2 * shortCount >= count ? &high : &low) = middle;
    }
    return count > 0 ? high : 0.0;
}

static double findTolerance(const swMeasuredSea* sea, int location)
{
    double half = 0.5 * findInterval(sea, location);
    return half > LEAST_TOLERANCE ? half : LEAST_TOLERANCE;
}

// By the minute that is printed.
static double getMinute(const swSeaRecord* record)
{
    return floor(record->seconds / 60.0) * 60.0;
}

// The records of one place, or of all, around a time.
typedef struct Search
{
    int nearest, first, last; // -1: there is none that has a time
    double distance;          // s from the nearest to the time
    double outside;           // s that the time lies before the first or after the last, or 0
} Search;

static Search searchTime(const swMeasuredSea* sea, int location, double seconds)
{
    const swSeaRecord* records = getRecords(sea);
    Search search = {-1, -1, -1, 0.0, 0.0};
    for (int i = 0; i < (int)sea->records.count; ++i)
    {
        if (!isOfPlace(&records[i], location) || !records[i].hasTime)
        {
            continue;
        }
        double distance = fabs(getMinute(&records[i]) - seconds);
        if (search.nearest < 0 || distance < search.distance)
        {
            search.nearest = i;
            search.distance = distance;
        }
        search.first = search.first < 0 || records[i].seconds < records[search.first].seconds ? i : search.first;
        search.last = search.last < 0 || records[i].seconds > records[search.last].seconds ? i : search.last;
    }
    if (search.nearest >= 0)
    {
        double before = getMinute(&records[search.first]) - seconds;
        double after = seconds - getMinute(&records[search.last]);
        search.outside = before > 0.0 ? before : after > 0.0 ? after : 0.0;
    }
    return search;
}

static int findLargest(const swMeasuredSea* sea, int location)
{
    const swSeaRecord* records = getRecords(sea);
    int best = -1;
    for (int i = 0; i < (int)sea->records.count; ++i)
    {
        bool isBetter = isOfPlace(&records[i], location) && (best < 0 || records[i].variance > records[best].variance);
        best = isBetter ? i : best;
    }
    return best;
}

int swMeasuredSea_FindRecord(const swMeasuredSea* sea, int location, const char* time)
{
    SW_REQUIRE(sea != NULL, -1, NULL, "swMeasuredSea_FindRecord() needs a measured sea");
    double seconds = 0.0;
    if (time == NULL)
    {
        return findLargest(sea, location);
    }
    if (!swParseMeasuredTime(time, &seconds))
    {
        return -1;
    }
    Search search = searchTime(sea, location, seconds);
    bool isNear = search.outside == 0.0 || search.outside <= findTolerance(sea, location);
    return isNear ? search.nearest : -1;
}

int swMeasuredSea_FindLargest(const swMeasuredSea* sea)
{
    return swMeasuredSea_FindRecord(sea, -1, NULL);
}

int swMeasuredSea_FindTime(const swMeasuredSea* sea, const char* time)
{
    return time != NULL ? swMeasuredSea_FindRecord(sea, -1, time) : -1;
}

// "3 hours", of a length of time; rounded so that no digit misleads.
static const char* printLength(double seconds, char text[32])
{
    static const struct
    {
        const char* name;
        double seconds;
    } units[] = {{"years", 31557600.0}, {"days", 86400.0}, {"hours", 3600.0}, {"minutes", 60.0}};
    size_t i = 0;
    while (i < 3 && seconds < 2.0 * units[i].seconds)
    {
        ++i;
    }
    snprintf(text, 32, "%.0f %s", seconds / units[i].seconds, units[i].name);
    return text;
}

static void printTime(double seconds, char time[20])
{
    swPrintMinutes((int64_t)floor(seconds / 60.0), time);
}

static swResult failTime(const swMeasuredSea* sea, const char* time, const Search* search)
{
    if (search->nearest < 0)
    {
        return swFail(&sea->host, SW_ERROR_INVALID, "%s: its records have no times, so that none can be chosen by %s.",
                      sea->name, time);
    }
    char first[20], last[20], length[32];
    printTime(getRecords(sea)[search->first].seconds, first);
    printTime(getRecords(sea)[search->last].seconds, last);
    return swFail(&sea->host, SW_ERROR_INVALID,
                  "%s: %s lies %s outside its records, which run from %s to %s (UTC); choose a time between.",
                  sea->name, time, printLength(search->outside, length), first, last);
}

swResult swMeasuredSea_ChooseRecord(const swMeasuredSea* sea, int location, const char* time, int* record)
{
    if (record != NULL)
    {
        *record = -1;
    }
    SW_REQUIRE(sea != NULL && record != NULL, SW_ERROR_INVALID, sea != NULL ? &sea->host : NULL,
               "swMeasuredSea_ChooseRecord() needs a measured sea and a place for the index");
    double seconds = 0.0;
    *record = swMeasuredSea_FindRecord(sea, location, time);
    if (*record < 0 && findLargest(sea, location) < 0)
    {
        return swFail(&sea->host, SW_ERROR_INVALID, "%s: this place has no record.", sea->name);
    }
    if (time == NULL)
    {
        return SW_SUCCESS;
    }
    if (!swParseMeasuredTime(time, &seconds))
    {
        return swFail(&sea->host, SW_ERROR_INVALID, "'%s' is no time such as 2022-05-10 10:50 (UTC).", time);
    }
    Search search = searchTime(sea, location, seconds);
    if (*record < 0)
    {
        return failTime(sea, time, &search);
    }
    if (search.outside > 0.0 || search.distance > findTolerance(sea, location))
    {
        char taken[20], length[32];
        printTime(getRecords(sea)[*record].seconds, taken);
        swLog(&sea->host, SW_LOG_WARNING, "%s: %s lies %s; the nearest record, of %s (UTC), %s away, is taken.",
              sea->name, time, search.outside > 0.0 ? "outside its records" : "in a gap between its records", taken,
              printLength(search.distance, length));
    }
    return SW_SUCCESS;
}

// ---- places ----

// Along a great circle, by the chord: exact for near points, where the cosine of the angle loses all digits.
static double measureDistance(double longitude1, double latitude1, double longitude2, double latitude2)
{
    double c1 = swCos(latitude1 * DEGREE), c2 = swCos(latitude2 * DEGREE);
    double x = c1 * swCos(longitude1 * DEGREE) - c2 * swCos(longitude2 * DEGREE);
    double y = c1 * swSin(longitude1 * DEGREE) - c2 * swSin(longitude2 * DEGREE);
    double z = swSin(latitude1 * DEGREE) - swSin(latitude2 * DEGREE);
    double half = 0.25 * (x * x + y * y + z * z); // squared
    return 2.0 * EARTH_RADIUS * swAtan2(sqrt(half), sqrt(half < 1.0 ? 1.0 - half : 0.0));
}

static bool isOnGlobe(double longitude, double latitude)
{
    return fabs(longitude) <= 720.0 && fabs(latitude) <= 90.0;
}

int swMeasuredSea_FindNearest(const swMeasuredSea* sea, double longitude, double latitude, double* distance)
{
    if (distance != NULL)
    {
        *distance = 0.0;
    }
    SW_REQUIRE(sea != NULL, -1, NULL, "swMeasuredSea_FindNearest() needs a measured sea");
    int best = -1;
    double nearest = 0.0;
    const swMeasuredLocation* places = sea->locations.data;
    for (int i = 0; isOnGlobe(longitude, latitude) && i < (int)sea->locations.count; ++i)
    {
        if (places[i].recordCount == 0 || !isOnGlobe(places[i].longitude, places[i].latitude))
        {
            continue; // land, or nowhere
        }
        double metres = measureDistance(longitude, latitude, places[i].longitude, places[i].latitude);
        if (best < 0 || metres < nearest)
        {
            best = i;
            nearest = metres;
        }
    }
    if (distance != NULL)
    {
        *distance = nearest;
    }
    return best;
}

swResult swMeasuredSea_ChooseNearest(const swMeasuredSea* sea, double longitude, double latitude, int* location,
                                     double* distance)
{
    if (location != NULL)
    {
        *location = -1;
    }
    if (distance != NULL)
    {
        *distance = 0.0;
    }
    SW_REQUIRE(sea != NULL && location != NULL, SW_ERROR_INVALID, sea != NULL ? &sea->host : NULL,
               "swMeasuredSea_ChooseNearest() needs a measured sea and a place for the index");
    double metres = 0.0;
    int nearest = swMeasuredSea_FindNearest(sea, longitude, latitude, &metres);
    if (distance != NULL)
    {
        *distance = metres;
    }
    if (nearest < 0)
    {
        return swFail(&sea->host, SW_ERROR_INVALID,
                      isOnGlobe(longitude, latitude)
                          ? "%s: it does not tell where its places lie; choose one by name or number."
                          : "%s: latitude must be from -90 to 90 and longitude from -180 to 360.",
                      sea->name);
    }
    swMeasuredLocation place = swMeasuredSea_GetLocation(sea, nearest);
    if (metres > SW_MEASURED_REACH)
    {
        return swFail(&sea->host, SW_ERROR_INVALID,
                      "%s: the place nearest to latitude %g, longitude %g is number %d at %.4f, %.4f, %.0f km away; at "
                      "most %.0f km are bridged. To take it nevertheless choose it by its number.",
                      sea->name, latitude, longitude, nearest + 1, place.latitude, place.longitude, metres / 1000.0,
                      SW_MEASURED_REACH / 1000.0);
    }
    swLog(&sea->host, metres > NEAR ? SW_LOG_WARNING : SW_LOG_INFO,
          "%s: place %d%s%s at latitude %.4f, longitude %.4f is taken, %.1f km away.", sea->name, nearest + 1,
          place.name[0] != '\0' ? " " : "", place.name, place.latitude, place.longitude, metres / 1000.0);
    *location = nearest;
    return SW_SUCCESS;
}
