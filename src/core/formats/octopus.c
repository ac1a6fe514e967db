// SPDX-License-Identifier: MIT
// Reads the forecasts of spectra that the program Octopus takes, a table with commas:
//
//   Forecast valid for 01-Dec-2014 00:00:00
//   nfreqs,25   ndir,24   nrecs,9   Latitude,19.95   Longitude,92.10   Depth,106.59     a line each
//
// then for each time
//
//   CCYYMM,DDHHmm,LPoint,WD,WS,ETot,TZ,VMD,...,HSig,DomDr,AngSpr,Tau
//   201412,'010000,...
//   freq,0.0411800,...,anspec
//   0,0.0000000,...                a line for each direction that waves come from, degrees, and its sum at the end
//   fSpec,...  den,...             sums over the directions
//
// and the whole again for another place. A cell holds the variance of its band and sector, m2: bands reach half-way
// to their neighbours.

#include <math.h>
#include <string.h>

#include "core/base/date.h"
#include "core/base/host.h"
#include "core/base/text.h"
#include "core/formats/measured_readers.h"

#define DEGREE (SW_PI / 180.0)

// Too large for a stack.
typedef struct Reader
{
    swSeaReader file;
    int frequencyCount, directionCount, location;
    int restCount; // columns behind the frequencies
    double frequencies[SW_SEA_MAX_FREQUENCIES];
    double widths[SW_SEA_MAX_FREQUENCIES];
    double directions[SW_SEA_MAX_DIRECTIONS];
    double* density;
    size_t densitySize;
} Reader;

static bool isRecord(swText* text)
{
    return swHasPrefix(text, "CCYYMM");
}

// The lines above a place's records.
static bool isHeading(swText* text)
{
    return swHasPrefix(text, "Forecast") || swHasPrefix(text, "nfreqs,");
}

bool swIsOctopus(const char* text, size_t size)
{
    swText lines = swOpenText(NULL, text, size, "");
    bool hasFrequencies = false, hasDirections = false;
    for (int i = 0; i < 12 && swNextLine(&lines); ++i)
    {
        hasFrequencies = hasFrequencies || swHasPrefix(&lines, "nfreqs,");
        hasDirections = hasDirections || swHasPrefix(&lines, "ndir,");
    }
    return hasFrequencies && hasDirections;
}

// ---- heading ----

static swResult readField(swText* text, const char* what, double low, double high, double* value)
{
    swToken field = {text->at, 0};
    if (swNextField(text, &field) && swParseToken(field, value) && *value >= low && *value <= high)
    {
        return SW_SUCCESS;
    }
    return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %s is '%.*s'; it must be a number from %g to %g.", text->name,
                  text->line, what, field.size, field.text, low, high);
}

// Room for a spectrum of as many frequencies and directions as the heading tells.
static swResult makeRoom(Reader* reader)
{
    const swHost* host = reader->file.text.host;
    swFree(host, reader->density, reader->densitySize);
    reader->densitySize = (size_t)reader->frequencyCount * (size_t)reader->directionCount * sizeof(double);
    reader->density = swAllocate(host, reader->densitySize);
    return reader->density != NULL
               ? SW_SUCCESS
               : swFail(host, SW_ERROR_NO_MEMORY, "No memory for a spectrum of %s.", reader->file.text.name);
}

static swResult findPlace(Reader* reader, const double place[2])
{
    reader->location = swFindSeaPlace(reader->file.sea, "", place[1], place[0]);
    return reader->location >= 0
               ? SW_SUCCESS
               : swMeasuredSea_AddLocation(reader->file.sea, NULL, place[1], place[0], &reader->location);
}

// Lines of a word and a number, from the line at hand to the first record.
static swResult readHead(Reader* reader)
{
    double counts[2] = {0.0, 0.0}, place[2] = {(double)NAN, (double)NAN};
    const struct
    {
        const char* key;
        double low, high;
        double* value;
    } fields[4] = {{"nfreqs", 2.0, SW_SEA_MAX_FREQUENCIES, &counts[0]},
                   {"ndir", 4.0, SW_SEA_MAX_DIRECTIONS, &counts[1]},
                   {"Latitude", -90.0, 90.0, &place[0]},
                   {"Longitude", -360.0, 360.0, &place[1]}};
    swText* text = &reader->file.text;
    swResult result = SW_SUCCESS;
    while (result == SW_SUCCESS && !isRecord(text))
    {
        swToken key;
        bool hasKey = swNextField(text, &key);
        for (int i = 0; i < 4 && hasKey && result == SW_SUCCESS; ++i)
        {
            result = swIsToken(key, fields[i].key)
                         ? readField(text, fields[i].key, fields[i].low, fields[i].high, fields[i].value)
                         : SW_SUCCESS;
        }
        result = result == SW_SUCCESS ? swNeedLine(text, "a record (CCYYMM,DDHHmm,...)") : result;
    }
    if (result == SW_SUCCESS && (counts[0] == 0.0 || counts[1] == 0.0))
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: nfreqs and ndir must stand above the first record.",
                        text->name, text->line);
    }
    reader->frequencyCount = result == SW_SUCCESS ? (int)counts[0] : 0;
    reader->directionCount = result == SW_SUCCESS ? (int)counts[1] : 0;
    result = result == SW_SUCCESS ? makeRoom(reader) : result;
    return result == SW_SUCCESS ? findPlace(reader, place) : result;
}

// ---- records ----

// To the next line, of the same record.
static swResult nextLine(Reader* reader, const char* what)
{
    swText* text = &reader->file.text;
    swResult result = swNeedLine(text, what);
    if (result == SW_SUCCESS && (isRecord(text) || isHeading(text)))
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: another record begins where %s should stand.", text->name,
                        text->line, what);
    }
    return result;
}

// 201412,'010000: year and month; day, hour and minute.
static swResult readTime(Reader* reader, double* seconds)
{
    swText* text = &reader->file.text;
    double month = 0.0, rest = 0.0;
    swResult result = nextLine(reader, "a record's time");
    result = result == SW_SUCCESS ? readField(text, "CCYYMM", 190001.0, 219912.0, &month) : result;
    text->at += result == SW_SUCCESS && swPeekChar(text) == '\'' ? 1 : 0;
    result = result == SW_SUCCESS ? readField(text, "DDHHmm", 10000.0, 312359.0, &rest) : result;
    int date = (int)month, clock = (int)rest;
    if (result == SW_SUCCESS &&
        !swMakeSeconds(date / 100, date % 100, clock / 10000, clock / 100 % 100, clock % 100, 0.0, seconds))
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %06d and %06d are no date and time (CCYYMM, DDHHmm).",
                        text->name, text->line, date, clock);
    }
    return result;
}

// Fields that are left in the line and not empty.
static int countFields(swText* text)
{
    swToken field;
    int count = 0;
    while (swNextField(text, &field))
    {
        count += field.size > 0 ? 1 : 0;
    }
    return count;
}

static swResult readFrequencies(Reader* reader)
{
    swText* text = &reader->file.text;
    swToken key = {text->at, 0};
    swResult result = nextLine(reader, "the frequencies");
    if (result == SW_SUCCESS && !(swNextField(text, &key) && swIsToken(key, "freq")))
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: a line of frequencies (freq,...) should stand here.",
                      text->name, text->line);
    }
    for (int i = 0; i < reader->frequencyCount && result == SW_SUCCESS; ++i)
    {
        double least = i > 0 ? reader->frequencies[i - 1] + 1e-6 : 1e-6;
        result = readField(text, "a frequency", least, 100.0, &reader->frequencies[i]);
    }
    reader->restCount = countFields(text); // anspec, the sum over them
    for (int i = 0; i < reader->frequencyCount; ++i)
    {
        int below = i > 0 ? i - 1 : i, above = i + 1 < reader->frequencyCount ? i + 1 : i;
        reader->widths[i] = (reader->frequencies[above] - reader->frequencies[below]) / (above - below);
    }
    double widest = 2.0 * reader->frequencies[0];
    reader->widths[0] = reader->widths[0] > widest ? widest : reader->widths[0];
    return result;
}

static swResult readSector(Reader* reader, int sector)
{
    swText* text = &reader->file.text;
    double bearing = 0.0, width = 2.0 * SW_PI / reader->directionCount;
    swResult result = nextLine(reader, "a direction's variances");
    result = result == SW_SUCCESS ? readField(text, "a direction", -360.0, 720.0, &bearing) : result;
    reader->directions[sector] = (bearing + 90.0) * DEGREE;
    for (int i = 0; i < reader->frequencyCount && result == SW_SUCCESS; ++i)
    {
        double cell = 0.0, most = SW_SEA_MAX_DENSITY * reader->widths[i] * width;
        result = readField(text, "a variance", -most, most, &cell);
        reader->density[i * reader->directionCount + sector] = cell / (reader->widths[i] * width);
    }
    if (result == SW_SUCCESS && countFields(text) > reader->restCount)
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the line has more variances than the %d frequencies.",
                        text->name, text->line, reader->frequencyCount);
    }
    for (int j = 0; j < sector && result == SW_SUCCESS; ++j)
    {
        if (fabs(reader->directions[j] - reader->directions[sector]) < 1e-9)
        {
            result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the direction %g stands there twice.", text->name,
                            text->line, bearing);
        }
    }
    return result;
}

static swResult readRecord(Reader* reader)
{
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    swResult result = readTime(reader, &def.seconds);
    result = result == SW_SUCCESS ? readFrequencies(reader) : result;
    for (int i = 0; i < reader->directionCount && result == SW_SUCCESS; ++i)
    {
        result = readSector(reader, i);
    }
    def.location = reader->location;
    def.frequencyCount = reader->frequencyCount;
    def.frequencies = reader->frequencies;
    def.bandwidths = reader->widths;
    def.directionCount = reader->directionCount;
    def.directions = reader->directions;
    def.density = reader->density;
    return result == SW_SUCCESS ? swMeasuredSea_AddSpectrum(reader->file.sea, &def) : result;
}

// To the line at hand or the next where a record or a heading begins; beyond line `line` in any case.
static bool nextPart(Reader* reader, int line)
{
    swText* text = &reader->file.text;
    bool isMore = text->line > line || swNextLine(text);
    text->at = text->lineBegin;
    while (isMore && !isRecord(text) && !isHeading(text))
    {
        isMore = swNextLine(text);
    }
    return isMore;
}

// A place's heading, or a record; those below a broken heading are passed over.
static swResult readPart(Reader* reader)
{
    swText* text = &reader->file.text;
    int line = text->line;
    if (isHeading(text))
    {
        return swJudgeRecord(&reader->file, readHead(reader), line);
    }
    return reader->frequencyCount > 0 ? swJudgeRecord(&reader->file, readRecord(reader), line) : SW_SUCCESS;
}

static swResult read(void* context)
{
    Reader* reader = context;
    swText* text = &reader->file.text;
    swResult result = SW_SUCCESS;
    bool isMore = nextPart(reader, 0);
    while (result == SW_SUCCESS && isMore)
    {
        int line = text->line;
        result = readPart(reader);
        isMore = result == SW_SUCCESS && nextPart(reader, line);
    }
    swFree(text->host, reader->density, reader->densitySize);
    return result;
}

swResult swParseOctopus(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    return swRunReader(host, text, size, name != NULL ? name : "Octopus file", sizeof(Reader), read, sea);
}
