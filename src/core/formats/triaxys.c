// SPDX-License-Identifier: MIT
// Reads the spectra of TriAxys buoys, directional and not:
//
//   TRIAXYS BUOY DATA REPORT - TAS01970 - TAB01401 - 4857.6668S16631.6837W
//   TYPE    = DIRECTIONAL SPECTRUM              or NON-DIRECTIONAL SPECTRUM
//   DATE    = 2018-01-31 21:00(UTC)             or 2018 Jan 31 21:00(UTC)
//   NUMBER OF FREQUENCIES = 63                  then INITIAL FREQUENCY (Hz), FREQUENCY SPACING (Hz)
//   NUMBER OF DIRECTIONS  = 121                 then DIRECTION SPACING (DEG), COLUMNS = 0.00 TO 360.00 DEG
//
// then a line for each frequency: densities by direction that waves come from, m2/Hz/deg; or frequency and m2/Hz.
// 0 and 360 degrees may both be there. Position is degrees and minutes.

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
    bool isKnown; // TYPE was there
    bool isDirectional;
    double seconds;
    double latitude, longitude;
    double frequencyCount, firstFrequency, frequencyStep;
    double directionCount, firstDirection, lastDirection, directionStep;
    double frequencies[SW_SEA_MAX_FREQUENCIES + 1];
    double directions[SW_SEA_MAX_DIRECTIONS];
    double energy[SW_SEA_MAX_FREQUENCIES + 1];
    double* density;
} Reader;

static const char s_head[] = "TRIAXYS BUOY"; // DATA REPORT, or REPORT

bool swIsTriaxys(const char* text, size_t size)
{
    swText lines = swOpenText(NULL, text, size, "");
    return swNextLine(&lines) && swHasPrefix(&lines, s_head);
}

// ---- heading ----

// "4857.6668S" from digits that end in the letter: degrees and minutes.
static bool parseAngle(const char* letter, const char* begin, double* degrees)
{
    const char* at = letter;
    while (at > begin && ((at[-1] >= '0' && at[-1] <= '9') || at[-1] == '.'))
    {
        --at;
    }
    double number = 0.0;
    if (letter - at > 16 || !swParseNumber(at, (int)(letter - at), &number))
    {
        return false;
    }
    double whole = floor(number / 100.0);
    *degrees = (whole + (number - 100.0 * whole) / 60.0) * (*letter == 'S' || *letter == 'W' ? -1.0 : 1.0);
    return fabs(*degrees) <= 180.0;
}

static void findPosition(Reader* reader)
{
    const swText* text = &reader->file.text;
    for (const char* at = text->at + 1; at < text->lineEnd; ++at)
    {
        bool isBehindDigit = at[-1] >= '0' && at[-1] <= '9';
        if (isBehindDigit && (*at == 'N' || *at == 'S'))
        {
            parseAngle(at, text->at, &reader->latitude);
        }
        else if (isBehindDigit && (*at == 'E' || *at == 'W'))
        {
            parseAngle(at, text->at, &reader->longitude);
        }
    }
}

static bool isLetter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

// A number of the date or the name of its month, and what parts it from the next.
static int readDatePart(const char** text, const char* end)
{
    const char* begin = *text;
    int value = 0;
    while (*text < end && isLetter(**text))
    {
        ++*text;
    }
    if (*text > begin)
    {
        value = swFindMonth(begin, (int)(*text - begin < 40 ? *text - begin : 40));
    }
    for (int digits = 0; *text < end && **text >= '0' && **text <= '9' && digits < 4; ++*text, ++digits)
    {
        value = 10 * value + (**text - '0');
    }
    *text += *text < end ? 1 : 0;
    return value;
}

static swResult readDate(Reader* reader)
{
    int parts[5];
    const char* at = reader->file.text.at;
    for (int i = 0; i < 5; ++i)
    {
        parts[i] = readDatePart(&at, reader->file.text.lineEnd);
    }
    if (!swMakeSeconds(parts[0], parts[1], parts[2], parts[3], parts[4], 0.0, &reader->seconds))
    {
        return swFail(reader->file.text.host, SW_ERROR_FORMAT,
                      "%s:%d: DATE should be as 2018-01-31 21:00(UTC) or 2018 Jan 31 21:00(UTC).",
                      reader->file.text.name, reader->file.text.line);
    }
    // Behind the time its zone.
    for (; at < reader->file.text.lineEnd && !isLetter(*at); ++at)
    {
    }
    size_t left = (size_t)(reader->file.text.lineEnd - at);
    bool isUtc =
        left == 0 || *at == 'Z' || (left >= 3 && memcmp(at, "UTC", 3) == 0) || (left >= 3 && memcmp(at, "GMT", 3) == 0);
    bool isShifted = left > 3 && (at[3] == '+' || at[3] == '-');
    if (!isUtc || isShifted)
    {
        swLog(reader->file.text.host, SW_LOG_WARNING, "%s:%d: the time is in '%.*s'; it is taken as UTC.",
              reader->file.text.name, reader->file.text.line, (int)left, at);
    }
    return SW_SUCCESS;
}

// To behind the '=' of a line.
static bool skipEquals(swText* text)
{
    const char* equals = memchr(text->at, '=', (size_t)(text->lineEnd - text->at));
    text->at = equals != NULL ? equals + 1 : text->at;
    swPeekChar(text);
    return equals != NULL;
}

// To behind the TO of "COLUMNS = 0.00 TO 360.00 DEG".
static swResult readLastDirection(Reader* reader)
{
    swText* text = &reader->file.text;
    return swIsToken(swNextToken(text), "TO") ? swReadRange(text, "COLUMNS", -360.0, 720.0, &reader->lastDirection)
                                              : SW_SUCCESS;
}

static swResult readField(Reader* reader)
{
    const struct
    {
        const char* key;
        double low, high;
        double* value;
    } fields[] = {
        {"NUMBER OF FREQUENCIES", 2.0, SW_SEA_MAX_FREQUENCIES + 1, &reader->frequencyCount},
        {"INITIAL FREQUENCY", 0.0, 10.0, &reader->firstFrequency},
        {"FREQUENCY SPACING", 1e-5, 1.0, &reader->frequencyStep},
        {"NUMBER OF DIRECTIONS", 4.0, SW_SEA_MAX_DIRECTIONS, &reader->directionCount},
        {"DIRECTION SPACING", 0.1, 90.0, &reader->directionStep},
        {"COLUMNS", -360.0, 360.0, &reader->firstDirection},
    };
    swText* text = &reader->file.text;
    for (size_t i = 0; i < sizeof(fields) / sizeof(fields[0]); ++i)
    {
        if (swHasPrefix(text, fields[i].key) && skipEquals(text))
        {
            swResult result = swReadRange(text, fields[i].key, fields[i].low, fields[i].high, fields[i].value);
            bool hasLast = fields[i].value == &reader->firstDirection;
            return result == SW_SUCCESS && hasLast ? readLastDirection(reader) : result;
        }
    }
    if (swHasPrefix(text, "DATE") && skipEquals(text))
    {
        return readDate(reader);
    }
    if (swHasPrefix(text, "TYPE") && skipEquals(text))
    {
        reader->isDirectional = swHasPrefix(text, "DIRECTIONAL SPECTRUM");
        reader->isKnown = reader->isDirectional || swHasPrefix(text, "NON-DIRECTIONAL SPECTRUM");
        return reader->isKnown ? SW_SUCCESS
                               : swFail(text->host, SW_ERROR_FORMAT,
                                        "%s:%d: TYPE is '%.*s'; DIRECTIONAL and NON-DIRECTIONAL SPECTRUM are read.",
                                        text->name, text->line, (int)(text->lineEnd - text->at), text->at);
    }
    return SW_SUCCESS; // VERSION, ROWS, COLUMN 1, resolvable frequencies
}

// Whether the line belongs to the heading: words do.
static bool isHeading(swText* text)
{
    return isLetter(swPeekChar(text));
}

static swResult readHead(Reader* reader)
{
    swResult result = swNeedLine(&reader->file.text, "the heading");
    if (result == SW_SUCCESS)
    {
        findPosition(reader);
        result = swNeedLine(&reader->file.text, "the heading");
    }
    while (result == SW_SUCCESS && isHeading(&reader->file.text))
    {
        result = readField(reader);
        if (result == SW_SUCCESS)
        {
            result = swNeedLine(&reader->file.text, "the spectrum");
        }
    }
    bool isWhole = reader->isKnown && reader->frequencyCount > 0.0 &&
                   (!reader->isDirectional ||
                    (reader->directionCount > 0.0 && reader->directionStep > 0.0 && reader->frequencyStep > 0.0));
    if (result == SW_SUCCESS && !isWhole)
    {
        result = swFail(reader->file.text.host, SW_ERROR_FORMAT,
                        "%s:%d: the heading lacks TYPE, NUMBER OF FREQUENCIES, FREQUENCY SPACING, NUMBER OF DIRECTIONS "
                        "or DIRECTION SPACING.",
                        reader->file.text.name, reader->file.text.line);
    }
    double span = (reader->directionCount - 1.0) * reader->directionStep;
    double told = reader->lastDirection - reader->firstDirection; // NAN where COLUMNS does not say
    if (result == SW_SUCCESS && reader->isDirectional &&
        (span > 360.5 || fabs(told - span) > 0.5 * reader->directionStep))
    {
        result =
            swFail(reader->file.text.host, SW_ERROR_FORMAT,
                   "%s:%d: the heading contradicts itself: %g directions %g degrees apart span %g degrees.",
                   reader->file.text.name, reader->file.text.line, reader->directionCount, reader->directionStep, span);
    }
    return result;
}

// ---- spectrum ----

static swResult readDensity(Reader* reader, const char* what, double scale, double most, double* value)
{
    swResult result = swReadNumber(&reader->file.text, what, true, value);
    *value *= scale;
    if (result == SW_SUCCESS && !(*value <= most))
    {
        result = swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: %s is %g; at most %g is read.",
                        reader->file.text.name, reader->file.text.line, what, *value, most);
    }
    return result;
}

static swResult readRows(Reader* reader)
{
    swResult result = SW_SUCCESS;
    int directions = reader->isDirectional ? (int)reader->directionCount : 0;
    for (int j = 0; j < directions; ++j)
    {
        reader->directions[j] = (reader->firstDirection + reader->directionStep * j + 90.0) * DEGREE;
    }
    for (int i = 0; i < (int)reader->frequencyCount && result == SW_SUCCESS; ++i)
    {
        reader->frequencies[i] = reader->firstFrequency + reader->frequencyStep * i;
        for (int j = 0; j < directions && result == SW_SUCCESS; ++j)
        {
            result = readDensity(reader, "a density", 1.0 / DEGREE, SW_SEA_MAX_DENSITY,
                                 &reader->density[i * directions + j]);
        }
        if (!reader->isDirectional)
        {
            result = swReadRange(&reader->file.text, "a frequency", 0.0, 100.0, &reader->frequencies[i]);
        }
        if (!reader->isDirectional && result == SW_SUCCESS)
        {
            result = readDensity(reader, "an energy", 1.0, SW_SEA_MAX_ENERGY, &reader->energy[i]);
        }
    }
    if (result == SW_SUCCESS && (swPeekChar(&reader->file.text) != '\0' || swNextLine(&reader->file.text)))
    {
        result = swFail(reader->file.text.host, SW_ERROR_FORMAT,
                        "%s:%d: the spectrum has more numbers than its heading tells.", reader->file.text.name,
                        reader->file.text.line);
    }
    return result;
}

static swResult addSpectrum(Reader* reader)
{
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.seconds = reader->seconds;
    def.frequencyCount = (int)reader->frequencyCount;
    def.frequencies = reader->frequencies;
    def.directionCount = reader->isDirectional ? (int)reader->directionCount : 0;
    def.directions = reader->directions;
    def.density = reader->density;
    def.energy = reader->energy;
    swResult result =
        swMeasuredSea_AddLocation(reader->file.sea, NULL, reader->longitude, reader->latitude, &def.location);
    if (result == SW_SUCCESS)
    {
        result = swMeasuredSea_AddSpectrum(reader->file.sea, &def);
    }
    return result;
}

static swResult read(void* context)
{
    Reader* reader = context;
    reader->seconds = reader->latitude = reader->longitude = reader->lastDirection = (double)NAN;
    swResult result = readHead(reader);
    size_t size = 0;
    if (result == SW_SUCCESS && reader->isDirectional)
    {
        size = (size_t)reader->frequencyCount * (size_t)reader->directionCount * sizeof(double);
        reader->density = swAllocate(reader->file.text.host, size);
        result = reader->density != NULL ? SW_SUCCESS
                                         : swFail(reader->file.text.host, SW_ERROR_NO_MEMORY,
                                                  "No memory for the spectrum of %s.", reader->file.text.name);
    }
    if (result == SW_SUCCESS)
    {
        result = readRows(reader);
    }
    if (result == SW_SUCCESS)
    {
        result = addSpectrum(reader);
    }
    swFree(reader->file.text.host, reader->density, size);
    return result;
}

swResult swParseTriaxys(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    return swRunReader(host, text, size, name != NULL ? name : "TriAxys file", sizeof(Reader), read, sea);
}
