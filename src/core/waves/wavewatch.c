// SPDX-License-Identifier: MIT
// Reads WAVEWATCH III's point spectra [WW3DG 2019], as its point output writes them in text:
//
//   'WAVEWATCH III SPECTRA'     50    36     1 'title'       frequencies, directions, points
//   frequencies, Hz; directions where waves go, radians clockwise from north; as many on a line as fit
//   20220912 060000                                          for each time,
//   '44097     '  40.98 -71.12      46.6   1.45 225.6   0.18  94.1   and each point: name, latitude, longitude, depth, ...
//   densities, m2 s/rad, frequency fastest

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/waves/measured_readers.h"

#define MAX_POINTS 100000

// Too large for a stack.
typedef struct Reader
{
    swSeaText text;
    swMeasuredSea* sea;
    int frequencyCount;
    int directionCount;
    int pointCount;
    bool hasBlock; // the points of one time are known
    double frequencies[SW_SEA_MAX_FREQUENCIES];
    double directions[SW_SEA_MAX_DIRECTIONS];
    double* density;
} Reader;

static const char s_head[] = "'WAVEWATCH III SPECTRA'";

bool swIsWavewatch(const char* text, size_t size)
{
    swSeaText lines = swOpenSeaText(NULL, text, size, "");
    return swNextSeaLine(&lines) && swHasSeaPrefix(&lines, s_head);
}

static swResult readHead(Reader* reader)
{
    swSeaText* text = &reader->text;
    swResult result = swNeedSeaLine(text, "the heading");
    text->at += result == SW_SUCCESS ? strlen(s_head) : 0;
    if (result == SW_SUCCESS)
    {
        result = swReadSeaCount(text, "the number of frequencies", 2, SW_SEA_MAX_FREQUENCIES, &reader->frequencyCount);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadSeaCount(text, "the number of directions", 4, SW_SEA_MAX_DIRECTIONS, &reader->directionCount);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadSeaCount(text, "the number of points", 1, MAX_POINTS, &reader->pointCount);
    }
    text->at = text->lineEnd; // the title
    for (int i = 0; i < reader->frequencyCount && result == SW_SUCCESS; ++i)
    {
        result = swReadSeaRange(text, "a frequency", 0.0, 100.0, &reader->frequencies[i]);
    }
    for (int i = 0; i < reader->directionCount && result == SW_SUCCESS; ++i)
    {
        double bearing = 0.0;
        result = swReadSeaRange(text, "a direction in radians", -7.0, 14.0, &bearing);
        reader->directions[i] = bearing - 0.5 * SW_PI; // from +x, which is east, towards south
    }
    if (result == SW_SUCCESS)
    {
        size_t count = (size_t)reader->frequencyCount * (size_t)reader->directionCount;
        reader->density = swAllocate(text->host, count * sizeof(double));
        result = reader->density != NULL
                     ? SW_SUCCESS
                     : swFail(text->host, SW_ERROR_NO_MEMORY, "No memory for a spectrum of %s.", text->name);
    }
    return result;
}

// The last quote of a line that begins with another: names may hold apostrophes, the numbers behind them never do.
static const char* findLastQuote(const swSeaText* text)
{
    const char* at = text->lineEnd - 1;
    while (at > text->at && *at != '\'')
    {
        --at;
    }
    return at > text->at ? at : NULL;
}

swResult swReadSeaName(swSeaText* text, char name[64])
{
    const char* end = swPeekSeaChar(text) == '\'' ? findLastQuote(text) : NULL;
    if (end == NULL)
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: a point's name in quotes should stand here.", text->name,
                      text->line);
    }
    const char* begin = text->at + 1;
    text->at = end + 1;
    while (end > begin && end[-1] == ' ')
    {
        --end;
    }
    while (begin < end && *begin == ' ')
    {
        ++begin;
    }
    size_t size = (size_t)(end - begin) < 63 ? (size_t)(end - begin) : 63;
    memcpy(name, begin, size);
    name[size] = '\0';
    return SW_SUCCESS;
}

swResult swFindSeaPoint(swMeasuredSea* sea, bool isNew, int index, const char* name, double longitude, double latitude,
                        int* location)
{
    *location = -1;
    if (!isNew)
    {
        bool isHere = strcmp(swMeasuredSea_GetLocation(sea, index).name, name) == 0;
        *location =
            isHere && index < swMeasuredSea_GetLocationCount(sea) ? index : swMeasuredSea_FindLocation(sea, name);
    }
    return *location >= 0 ? SW_SUCCESS : swMeasuredSea_AddLocation(sea, name, longitude, latitude, location);
}

static swResult readPoint(Reader* reader, int index, int* location)
{
    char name[64];
    double latitude = 0.0, longitude = 0.0;
    swSeaText* text = &reader->text;
    swResult result = swNeedSeaLine(text, "a point");
    if (result == SW_SUCCESS)
    {
        result = swReadSeaName(text, name);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadSeaNumber(text, "a point's latitude", false, &latitude);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadSeaNumber(text, "a point's longitude", false, &longitude);
    }
    if (fabs(latitude) > 90.0 || fabs(longitude) > 360.0) // kilometres of a grid that is no globe
    {
        latitude = longitude = (double)NAN;
    }
    text->at = text->lineEnd; // depth, wind, current
    return result == SW_SUCCESS
               ? swFindSeaPoint(reader->sea, !reader->hasBlock, index, name, longitude, latitude, location)
               : result;
}

static swResult readDensity(Reader* reader)
{
    swSeaText* text = &reader->text;
    swResult result = SW_SUCCESS;
    for (int j = 0; j < reader->directionCount; ++j)
    {
        for (int i = 0; i < reader->frequencyCount && result == SW_SUCCESS; ++i)
        {
            double* value = &reader->density[i * reader->directionCount + j];
            result = swReadSeaNumber(text, "a density", true, value);
            if (result == SW_SUCCESS && !(*value <= SW_SEA_MAX_DENSITY))
            {
                result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: a density is %g m2 s/rad; at most %g is read.",
                                text->name, text->line, *value, SW_SEA_MAX_DENSITY);
            }
        }
    }
    return result;
}

static swResult readSpectrum(Reader* reader, int index, double seconds)
{
    int location = 0;
    swResult result = readPoint(reader, index, &location);
    if (result == SW_SUCCESS)
    {
        result = readDensity(reader);
    }
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.location = location;
    def.seconds = seconds;
    def.frequencyCount = reader->frequencyCount;
    def.frequencies = reader->frequencies;
    def.directionCount = reader->directionCount;
    def.directions = reader->directions;
    def.density = reader->density;
    return result == SW_SUCCESS ? swMeasuredSea_AddSpectrum(reader->sea, &def) : result;
}

swResult swReadPackedTime(swSeaText* text, double* seconds)
{
    double date = 0.0, time = 0.0;
    swResult result = swReadSeaNumber(text, "a date (yyyymmdd)", false, &date);
    if (result == SW_SUCCESS)
    {
        result = swReadSeaNumber(text, "a time (hhmmss)", false, &time);
    }
    if (result == SW_SUCCESS && !swMakePackedSeconds(date, time, seconds))
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %.0f %06.0f is no date and time (yyyymmdd hhmmss).",
                        text->name, text->line, date, time);
    }
    return result;
}

static swResult readSpectra(Reader* reader)
{
    swResult result = SW_SUCCESS;
    while (result == SW_SUCCESS && swNextSeaLine(&reader->text))
    {
        double seconds = 0.0;
        result = swReadPackedTime(&reader->text, &seconds);
        reader->text.at = reader->text.lineEnd;
        for (int i = 0; i < reader->pointCount && result == SW_SUCCESS; ++i)
        {
            result = readSpectrum(reader, i, seconds);
            reader->text.at = reader->text.lineEnd;
        }
        reader->hasBlock = true;
    }
    return result;
}

static swResult read(Reader* reader)
{
    swResult result = readHead(reader);
    if (result == SW_SUCCESS)
    {
        result = readSpectra(reader);
    }
    if (reader->density != NULL)
    {
        swFree(reader->text.host, reader->density,
               (size_t)reader->frequencyCount * (size_t)reader->directionCount * sizeof(double));
    }
    return result == SW_SUCCESS ? swMeasuredSea_Finish(reader->sea) : result;
}

swResult swParseWavewatch(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    *sea = NULL;
    Reader* reader = swAllocateZero(host, sizeof(*reader));
    if (reader == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to read a WAVEWATCH III file.");
    }
    name = name != NULL ? name : "WAVEWATCH III file";
    reader->text = swOpenSeaText(host, text, size, name);
    swResult result = swCreateMeasuredSea(host, name, &reader->sea);
    if (result == SW_SUCCESS)
    {
        result = read(reader);
    }
    if (result == SW_SUCCESS)
    {
        *sea = reader->sea;
    }
    else
    {
        swDestroyMeasuredSea(reader->sea);
    }
    swFree(host, reader, sizeof(*reader));
    return result;
}
