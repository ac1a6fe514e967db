// SPDX-License-Identifier: MIT
// Reads the directional spectra of Obscape's wave buoys, as their portal exports them:
//
//   # Station name = ...              # Latitude [deg] = 12.123           # Longitude [deg] = 1.234
//   # Timestamp = 1712136600          seconds since 1970, UTC
//   # Directions = True North         that waves come from, clockwise
//   # Columns [deg] = 0,3,6,... 357   directions
//   # Rows [Hz] = 0.048828,...        frequencies
//   # Variance-density [m2/Hz/rad]
//
// then a line of densities for each frequency, with commas between the directions.

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/base/text.h"
#include "core/formats/measured_readers.h"

#define DEGREE (SW_PI / 180.0)

// Too large for a stack.
typedef struct Reader
{
    swSeaReader file;
    char station[64];
    double seconds, latitude, longitude;
    double unit; // of densities, m2/Hz/rad
    bool hasUnit;
    int frequencyCount, directionCount;
    double frequencies[SW_SEA_MAX_FREQUENCIES];
    double directions[SW_SEA_MAX_DIRECTIONS]; // degrees
    double* density;
} Reader;

// Past the '#' of a line that begins with one; whether the key stands there.
static bool hasKey(swText* text, const char* key)
{
    text->at = text->lineBegin;
    if (swPeekChar(text) != '#')
    {
        return false;
    }
    ++text->at;
    return swHasPrefix(text, key);
}

bool swIsObscape(const char* text, size_t size)
{
    swText lines = swOpenText(NULL, text, size, "");
    bool hasRows = false, hasColumns = false;
    while (swNextLine(&lines) && swPeekChar(&lines) == '#')
    {
        hasRows = hasRows || hasKey(&lines, "Rows [Hz]");
        hasColumns = hasColumns || hasKey(&lines, "Columns [deg]");
    }
    return hasRows && hasColumns;
}

// ---- heading ----

static void skipEquals(swText* text)
{
    const char* equals = memchr(text->at, '=', (size_t)(text->lineEnd - text->at));
    text->at = equals != NULL ? equals + 1 : text->lineEnd;
    swPeekChar(text);
}

static swResult failItem(const swText* text, swToken field, int most)
{
    return swFail(text->host, SW_ERROR_FORMAT,
                  "%s:%d: '%.*s' stands where the next of at most %d numbers is expected, in ascending order.",
                  text->name, text->line, field.size, field.text, most);
}

// Numbers with commas. "0,3,6,... 357" goes on in equal steps.
static swResult readList(swText* text, int most, double* values, int* count)
{
    swToken field;
    *count = 0;
    while (swNextField(text, &field))
    {
        double value = 0.0;
        bool isGap = field.size > 3 && memcmp(field.text, "...", 3) == 0;
        swToken number = {field.text + (isGap ? 3 : 0), field.size - (isGap ? 3 : 0)};
        while (number.size > 0 && *number.text == ' ')
        {
            number = (swToken){number.text + 1, number.size - 1};
        }
        if (!swParseToken(number, &value) || (*count > 0 && !(value > values[*count - 1])) || (isGap && *count < 2))
        {
            return failItem(text, field, most);
        }
        double step = isGap ? values[*count - 1] - values[*count - 2] : 0.0;
        while (isGap && *count < most && values[*count - 1] + 1.5 * step < value)
        {
            values[*count] = values[*count - 1] + step;
            ++*count;
        }
        if (*count >= most)
        {
            return failItem(text, field, most);
        }
        values[(*count)++] = value;
    }
    return SW_SUCCESS;
}

static swResult readNumber(swText* text, const char* what, double low, double high, double* value)
{
    swToken token = swNextToken(text);
    if (token.size == 0 || swIsMissingField(token))
    {
        return SW_SUCCESS;
    }
    if (!swParseToken(token, value) || *value < low || *value > high)
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %s is '%.*s'; it must be a number from %g to %g.",
                      text->name, text->line, what, token.size, token.text, low, high);
    }
    return SW_SUCCESS;
}

static void readStation(Reader* reader)
{
    swText* text = &reader->file.text;
    size_t size = (size_t)(text->lineEnd - text->at) < 63 ? (size_t)(text->lineEnd - text->at) : 63;
    memcpy(reader->station, text->at, size);
    while (size > 0 && reader->station[size - 1] == ' ')
    {
        --size;
    }
    reader->station[size] = '\0';
}

// [m2/Hz/rad] or [m2/Hz/deg], however the square is written.
static swResult readUnit(Reader* reader)
{
    const swText* text = &reader->file.text;
    char unit[32];
    size_t size = 0;
    for (const char* at = text->at + strlen("Variance-density"); at < text->lineEnd && size + 1 < sizeof(unit); ++at)
    {
        if (strchr(" \t[]()^*=", *at) == NULL)
        {
            unit[size++] = *at;
        }
    }
    unit[size] = '\0';
    bool isRadian = strcmp(unit, "m2/Hz/rad") == 0, isDegree = strcmp(unit, "m2/Hz/deg") == 0;
    reader->unit = isDegree ? 1.0 / DEGREE : 1.0;
    reader->hasUnit = isRadian || isDegree;
    if (!reader->hasUnit && unit[0] != '\0')
    {
        return swFail(text->host, SW_ERROR_FORMAT,
                      "%s:%d: the unit of densities is '%s'; m2/Hz/rad and m2/Hz/deg are read.", text->name, text->line,
                      unit);
    }
    return SW_SUCCESS;
}

// One line that begins with '#'.
static swResult readRemark(Reader* reader)
{
    swText* text = &reader->file.text;
    const struct
    {
        const char* key;
        double low, high;
        double* value;
    } numbers[3] = {{"Timestamp", -2208988800.0, 7258118399.0, &reader->seconds},
                    {"Latitude", -90.0, 90.0, &reader->latitude},
                    {"Longitude", -360.0, 360.0, &reader->longitude}};
    for (int i = 0; i < 3; ++i)
    {
        if (hasKey(text, numbers[i].key))
        {
            skipEquals(text);
            return readNumber(text, numbers[i].key, numbers[i].low, numbers[i].high, numbers[i].value);
        }
    }
    if (hasKey(text, "Rows [Hz]"))
    {
        skipEquals(text);
        return readList(text, SW_SEA_MAX_FREQUENCIES, reader->frequencies, &reader->frequencyCount);
    }
    if (hasKey(text, "Columns [deg]"))
    {
        skipEquals(text);
        return readList(text, SW_SEA_MAX_DIRECTIONS, reader->directions, &reader->directionCount);
    }
    if (hasKey(text, "Station name"))
    {
        skipEquals(text);
        readStation(reader);
    }
    else if (hasKey(text, "Variance-density"))
    {
        return readUnit(reader);
    }
    else if (hasKey(text, "Directions"))
    {
        skipEquals(text);
        if (!swHasPrefix(text, "True"))
        {
            swLog(text->host, SW_LOG_WARNING,
                  "%s:%d: directions are clockwise from '%.*s'; they are taken as from true "
                  "north.",
                  text->name, text->line, (int)(text->lineEnd - text->at), text->at);
        }
    }
    return SW_SUCCESS;
}

// Up to the first line of densities.
static swResult readHead(Reader* reader)
{
    swText* text = &reader->file.text;
    swResult result = swNeedLine(text, "the heading");
    while (result == SW_SUCCESS && swPeekChar(text) == '#')
    {
        result = readRemark(reader);
        result = result == SW_SUCCESS ? swNeedLine(text, "a line of densities") : result;
    }
    if (result == SW_SUCCESS && (reader->frequencyCount < 2 || reader->directionCount < 4))
    {
        result = swFail(text->host, SW_ERROR_FORMAT,
                        "%s:%d: the heading must name at least 2 frequencies (Rows) and 4 directions (Columns).",
                        text->name, text->line);
    }
    if (result == SW_SUCCESS && !reader->hasUnit)
    {
        swLog(text->host, SW_LOG_WARNING,
              "%s: no unit of its densities (# Variance-density [m2/Hz/rad]) tells whether they are per radian or per "
              "degree; they are taken per radian.",
              text->name);
    }
    return result;
}

// ---- densities ----

static swResult readRow(Reader* reader, double* density)
{
    swText* text = &reader->file.text;
    swToken field;
    int count = 0;
    double most = SW_SEA_MAX_DENSITY / reader->unit;
    for (; swNextField(text, &field); ++count)
    {
        double value = 0.0;
        if (count < reader->directionCount && !swIsMissingField(field) &&
            (!swParseToken(field, &value) || value > most))
        {
            return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: a density is '%.*s'; it must be a number up to %g.",
                          text->name, text->line, field.size, field.text, most);
        }
        if (count < reader->directionCount)
        {
            density[count] = value * reader->unit;
        }
    }
    if (count != reader->directionCount)
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the line has %d densities for the %d directions in Columns.",
                      text->name, text->line, count, reader->directionCount);
    }
    return SW_SUCCESS;
}

static swResult addSpectrum(Reader* reader)
{
    for (int i = 0; i < reader->directionCount; ++i)
    {
        reader->directions[i] = (reader->directions[i] + 90.0) * DEGREE;
    }
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.seconds = reader->seconds;
    def.frequencyCount = reader->frequencyCount;
    def.frequencies = reader->frequencies;
    def.directionCount = reader->directionCount;
    def.directions = reader->directions;
    def.density = reader->density;
    swResult result = swMeasuredSea_AddLocation(reader->file.sea, reader->station, reader->longitude, reader->latitude,
                                                &def.location);
    return result == SW_SUCCESS ? swMeasuredSea_AddSpectrum(reader->file.sea, &def) : result;
}

static swResult readRows(Reader* reader)
{
    swResult result = SW_SUCCESS;
    for (int i = 0; i < reader->frequencyCount && result == SW_SUCCESS; ++i)
    {
        result = i > 0 ? swNeedLine(&reader->file.text, "a line of densities") : SW_SUCCESS;
        result = result == SW_SUCCESS ? readRow(reader, reader->density + i * reader->directionCount) : result;
    }
    if (result == SW_SUCCESS && swNextLine(&reader->file.text))
    {
        result = swFail(reader->file.text.host, SW_ERROR_FORMAT,
                        "%s:%d: there are more lines than the %d frequencies in Rows.", reader->file.text.name,
                        reader->file.text.line, reader->frequencyCount);
    }
    return result == SW_SUCCESS ? addSpectrum(reader) : result;
}

static swResult read(void* context)
{
    Reader* reader = context;
    const swHost* host = reader->file.text.host;
    reader->seconds = reader->latitude = reader->longitude = (double)NAN;
    reader->unit = 1.0;
    swResult result = readHead(reader);
    size_t size = (size_t)reader->frequencyCount * (size_t)reader->directionCount * sizeof(double);
    if (result == SW_SUCCESS)
    {
        reader->density = swAllocate(host, size);
        result = reader->density != NULL
                     ? readRows(reader)
                     : swFail(host, SW_ERROR_NO_MEMORY, "No memory for the spectrum of %s.", reader->file.text.name);
    }
    swFree(host, reader->density, size);
    return result;
}

swResult swParseObscape(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    return swRunReader(host, text, size, name != NULL ? name : "Obscape file", sizeof(Reader), read, sea);
}
