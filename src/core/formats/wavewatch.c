// SPDX-License-Identifier: MIT
// Reads WAVEWATCH III's point spectra [WW3DG 2019], as its point output writes them in text:
//
//   'WAVEWATCH III SPECTRA'     50    36     1 'title'       frequencies, directions, points
//   frequencies, Hz; directions where waves go, radians clockwise from north; as many on a line as fit
//   20220912 060000                                          for each time,
//   '44097     '  40.98 -71.12      46.6   1.45 225.6   0.18  94.1   and each point: name, latitude, longitude, depth,
//   ... densities, m2 s/rad, frequency fastest

#include <math.h>
#include <string.h>

#include "core/base/date.h"
#include "core/base/host.h"
#include "core/base/text.h"
#include "core/formats/measured_readers.h"

#define MAX_POINTS 100000

// Too large for a stack.
typedef struct Reader
{
    swSeaReader file;
    int frequencyCount;
    int directionCount;
    int pointCount;
    bool hasBlock; // the points of one time are known
    bool isHeld;   // the line at hand is still to be read
    double frequencies[SW_SEA_MAX_FREQUENCIES];
    double directions[SW_SEA_MAX_DIRECTIONS];
    double* density;
} Reader;

static const char s_head[] = "'WAVEWATCH III SPECTRA'";

bool swIsWavewatch(const char* text, size_t size)
{
    swText lines = swOpenText(NULL, text, size, "");
    return swNextLine(&lines) && swHasPrefix(&lines, s_head);
}

static swResult readHead(Reader* reader)
{
    swText* text = &reader->file.text;
    swResult result = swNeedLine(text, "the heading");
    text->at += result == SW_SUCCESS ? strlen(s_head) : 0;
    if (result == SW_SUCCESS)
    {
        result = swReadCount(text, "the number of frequencies", 2, SW_SEA_MAX_FREQUENCIES, &reader->frequencyCount);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadCount(text, "the number of directions", 4, SW_SEA_MAX_DIRECTIONS, &reader->directionCount);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadCount(text, "the number of points", 1, MAX_POINTS, &reader->pointCount);
    }
    text->at = text->lineEnd; // the title
    for (int i = 0; i < reader->frequencyCount && result == SW_SUCCESS; ++i)
    {
        result = swReadRange(text, "a frequency", 0.0, 100.0, &reader->frequencies[i]);
    }
    for (int i = 0; i < reader->directionCount && result == SW_SUCCESS; ++i)
    {
        double bearing = 0.0;
        result = swReadRange(text, "a direction in radians", -7.0, 14.0, &bearing);
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
static const char* findLastQuote(const swText* text)
{
    const char* at = text->lineEnd - 1;
    while (at > text->at && *at != '\'')
    {
        --at;
    }
    return at > text->at ? at : NULL;
}

swResult swReadSeaName(swText* text, char name[64])
{
    const char* end = swPeekChar(text) == '\'' ? findLastQuote(text) : NULL;
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

static swResult readPoint(Reader* reader, int index, int* location)
{
    char name[64];
    double latitude = 0.0, longitude = 0.0;
    swText* text = &reader->file.text;
    swResult result = swReadSeaName(text, name);
    if (result == SW_SUCCESS)
    {
        result = swReadNumber(text, "a point's latitude", false, &latitude);
    }
    if (result == SW_SUCCESS)
    {
        result = swReadNumber(text, "a point's longitude", false, &longitude);
    }
    if (fabs(latitude) > 90.0 || fabs(longitude) > 360.0) // kilometres of a grid that is no globe
    {
        latitude = longitude = (double)NAN;
    }
    text->at = text->lineEnd; // depth, wind, current
    return result == SW_SUCCESS
               ? swFindSeaPoint(reader->file.sea, !reader->hasBlock, index, name, longitude, latitude, location)
               : result;
}

static swResult readDensity(Reader* reader)
{
    swText* text = &reader->file.text;
    swResult result = SW_SUCCESS;
    for (int j = 0; j < reader->directionCount; ++j)
    {
        for (int i = 0; i < reader->frequencyCount && result == SW_SUCCESS; ++i)
        {
            double* value = &reader->density[i * reader->directionCount + j];
            result = swReadNumber(text, "a density", true, value);
            if (result == SW_SUCCESS && !(*value <= SW_SEA_MAX_DENSITY))
            {
                result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: a density is %g m2 s/rad; at most %g is read.",
                                text->name, text->line, *value, SW_SEA_MAX_DENSITY);
            }
        }
    }
    if (result == SW_SUCCESS && swPeekChar(text) != '\0')
    {
        result =
            swFail(text->host, SW_ERROR_FORMAT,
                   "%s:%d: the spectrum has more numbers than frequencies times directions.", text->name, text->line);
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
    return result == SW_SUCCESS ? swMeasuredSea_AddSpectrum(reader->file.sea, &def) : result;
}

swResult swReadPackedTime(swText* text, double* seconds)
{
    double date = 0.0, time = 0.0;
    swResult result = swReadNumber(text, "a date (yyyymmdd)", false, &date);
    if (result == SW_SUCCESS)
    {
        result = swReadNumber(text, "a time (hhmmss)", false, &time);
    }
    if (result == SW_SUCCESS && !swMakePackedSeconds(date, time, seconds))
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %.0f %06.0f is no date and time (yyyymmdd hhmmss).",
                        text->name, text->line, date, time);
    }
    return result;
}

bool swIsPackedTime(const swText* line)
{
    swText copy = *line;
    double date = 0.0, time = 0.0, ignored = 0.0;
    swToken token = swNextToken(&copy);
    return token.size == 8 && swParseToken(token, &date) && swParseToken(swNextToken(&copy), &time) &&
           swMakePackedSeconds(date, time, &ignored);
}

// After a fault: to the next line where a point or a time begins, or this one if it is not the line of the fault's
// part.
static void skipBroken(Reader* reader, int line)
{
    swText* text = &reader->file.text;
    bool isMore = text->line > line || swNextLine(text);
    text->at = text->lineBegin;
    while (isMore && swPeekChar(text) != '\'' && !swIsPackedTime(text))
    {
        isMore = swNextLine(text);
    }
    reader->isHeld = isMore;
}

// Before a time and at the end: every point must have been there.
static swResult checkWhole(Reader* reader, int found)
{
    int line = reader->file.text.line;
    if (found >= reader->pointCount)
    {
        return SW_SUCCESS;
    }
    swResult result = swFail(reader->file.text.host, SW_ERROR_FORMAT,
                             "%s:%d: only %d of %d points stand before this line; is the file cut off?",
                             reader->file.text.name, line, found, reader->pointCount);
    return swJudgeRecord(&reader->file, result, line);
}

// A point, or the time of those that follow. *found counts the points of a time; -1 before one that could be read.
static swResult readPart(Reader* reader, int* found, double* seconds)
{
    swText* text = &reader->file.text;
    if (swPeekChar(text) == '\'' && *found < 0)
    {
        skipBroken(reader, text->line); // its time is not known, which was said
        return SW_SUCCESS;
    }
    if (swPeekChar(text) == '\'' || (*found >= 0 && *found < reader->pointCount && !swIsPackedTime(text)))
    {
        return readSpectrum(reader, (*found)++, *seconds);
    }
    swResult result = *found >= 0 ? checkWhole(reader, *found) : SW_SUCCESS;
    reader->hasBlock = reader->hasBlock || *found > 0;
    *found = -1;
    result = result == SW_SUCCESS ? swReadPackedTime(text, seconds) : result;
    *found = result == SW_SUCCESS ? 0 : -1;
    return result;
}

static swResult readSpectra(Reader* reader)
{
    swText* text = &reader->file.text;
    double seconds = 0.0;
    int found = -1;
    swResult result = SW_SUCCESS;
    while (result == SW_SUCCESS && (reader->isHeld || swNextLine(text)))
    {
        int line = text->line;
        reader->isHeld = false;
        swResult part = readPart(reader, &found, &seconds);
        result = swJudgeRecord(&reader->file, part, line);
        if (part != SW_SUCCESS && result == SW_SUCCESS)
        {
            skipBroken(reader, line);
        }
    }
    return result == SW_SUCCESS && found >= 0 ? checkWhole(reader, found) : result;
}

static swResult read(void* context)
{
    Reader* reader = context;
    swResult result = readHead(reader);
    if (result == SW_SUCCESS)
    {
        result = readSpectra(reader);
    }
    swFree(reader->file.text.host, reader->density,
           (size_t)reader->frequencyCount * (size_t)reader->directionCount * sizeof(double));
    return result;
}

swResult swParseWavewatch(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    return swRunReader(host, text, size, name != NULL ? name : "WAVEWATCH III file", sizeof(Reader), read, sea);
}
