// SPDX-License-Identifier: MIT
// Reads the spectrum files (.spt) of Datawell's Waverider buoys: twelve lines of a number each (transmission, Hs in
// cm, Tz, largest density in m2/Hz, temperatures, ...), then for each frequency a line of
//
//   f, S / S_max, direction that waves come from in degrees, spread in degrees, skewness, kurtosis
//
// Spread is sqrt(2 (1 - m1)). Skewness and kurtosis of direction hold the second moments m2, n2 about the mean
// direction [Kuik 1988]:  skewness = -n2 / ((1 - m2) / 2)^(3/2),  kurtosis = (6 - 8 m1 + 2 m2) / (2 (1 - m1))^2. The
// time is in the file's name, as in buoy}2013-06-03T00h30.spt.

#include <math.h>
#include <string.h>

#include "core/base/date.h"
#include "core/base/host.h"
#include "core/base/text.h"
#include "core/math/scalar.h"
#include "core/formats/measured_readers.h"

#define HEAD_LINES 12
#define DENSITY_LINE 3 // of the largest, from 0
#define COLUMNS 6
#define DEGREE (SW_PI / 180.0)

// Too large for a stack.
typedef struct Reader
{
    swSeaReader file;
    double largest; // m^2/Hz
    int count;
    double frequencies[SW_SEA_MAX_FREQUENCIES];
    double energy[SW_SEA_MAX_FREQUENCIES];
    double moments[4][SW_SEA_MAX_FREQUENCIES]; // a1, b1, a2, b2
} Reader;

// How many numbers stand on the line, parted by commas or spaces; 0 if anything else does.
static int countNumbers(swText* text)
{
    int count = 0;
    while (swPeekChar(text) != '\0')
    {
        const char* begin = text->at;
        while (text->at < text->lineEnd && *text->at != ',' && *text->at != ' ' && *text->at != '\t' &&
               *text->at != '\r')
        {
            ++text->at;
        }
        double ignored = 0.0;
        if (text->at - begin > 40 || !swParseNumber(begin, (int)(text->at - begin), &ignored))
        {
            return 0;
        }
        ++count;
        text->at += swPeekChar(text) == ',' ? 1 : 0;
    }
    return count;
}

bool swIsDatawell(const char* text, size_t size)
{
    swText lines = swOpenText(NULL, text, size, "");
    for (int i = 0; i < HEAD_LINES; ++i)
    {
        if (!swNextLine(&lines) || countNumbers(&lines) != 1)
        {
            return false;
        }
    }
    return swNextLine(&lines) && countNumbers(&lines) == COLUMNS;
}

static swResult readHead(Reader* reader)
{
    swResult result = SW_SUCCESS;
    for (int i = 0; i < HEAD_LINES && result == SW_SUCCESS; ++i)
    {
        double value = 0.0;
        result = swNeedLine(&reader->file.text, "the heading's twelve numbers");
        if (result == SW_SUCCESS)
        {
            result = i == DENSITY_LINE ? swReadRange(&reader->file.text, "the largest density, m2/Hz,", 0.0,
                                                     0.99 * SW_SEA_MAX_ENERGY, &reader->largest)
                                       : swReadNumber(&reader->file.text, "a number of the heading", false, &value);
        }
    }
    return result;
}

static void keepRow(Reader* reader, const double values[COLUMNS])
{
    int i = reader->count++;
    double direction = (values[2] + 90.0) * DEGREE;
    double spread = values[3] * DEGREE;
    double m1 = 1.0 - 0.5 * spread * spread;
    m1 = m1 > 0.0 ? m1 : 0.0;
    double room = 2.0 * (1.0 - m1);
    double m2 = 0.5 * (values[5] * room * room - 6.0 + 8.0 * m1);
    m2 = m2 < -1.0 ? -1.0 : m2 > 1.0 ? 1.0 : m2;
    double half = 0.5 * (1.0 - m2);
    double n2 = -values[4] * half * sqrt(half);
    double c = swCos(2.0 * direction), s = swSin(2.0 * direction);
    reader->frequencies[i] = values[0];
    reader->energy[i] = values[1] * reader->largest;
    reader->moments[0][i] = m1 * swCos(direction);
    reader->moments[1][i] = m1 * swSin(direction);
    reader->moments[2][i] = m2 * c - n2 * s;
    reader->moments[3][i] = m2 * s + n2 * c;
}

static swResult readRows(Reader* reader)
{
    static const struct
    {
        const char* what;
        double low, high;
    } columns[COLUMNS] = {
        {"a frequency", 0.0, 100.0}, {"a relative density", 0.0, 1.001}, {"a direction", -360.0, 720.0},
        {"a spread", 0.0, 180.0},    {"a skewness", -1e6, 1e6},          {"a kurtosis", -1e6, 1e6},
    };
    while (swNextLine(&reader->file.text))
    {
        double values[COLUMNS];
        if (reader->count >= SW_SEA_MAX_FREQUENCIES)
        {
            return swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: more than %d frequencies.",
                          reader->file.text.name, reader->file.text.line, SW_SEA_MAX_FREQUENCIES);
        }
        for (int i = 0; i < COLUMNS; ++i)
        {
            swResult result =
                swReadRange(&reader->file.text, columns[i].what, columns[i].low, columns[i].high, &values[i]);
            if (result != SW_SUCCESS)
            {
                return result;
            }
        }
        keepRow(reader, values);
    }
    return SW_SUCCESS;
}

// "2013-06-03T00h30" anywhere in the name; NAN if there is none.
static double findTime(const char* name)
{
    static const char pattern[] = "0000-00-00T00h00";
    size_t length = strlen(name);
    for (size_t start = 0; start + 16 <= length; ++start)
    {
        int parts[5] = {0};
        int part = 0, i = 0;
        for (; i < 16; ++i)
        {
            char c = name[start + (size_t)i];
            bool isDigit = c >= '0' && c <= '9';
            if (pattern[i] == '0' ? !isDigit : c != pattern[i])
            {
                break;
            }
            part += isDigit ? 0 : 1;
            parts[part] = isDigit ? 10 * parts[part] + (c - '0') : parts[part];
        }
        double seconds = 0.0;
        if (i == 16 && swMakeSeconds(parts[0], parts[1], parts[2], parts[3], parts[4], 0.0, &seconds))
        {
            return seconds;
        }
    }
    return (double)NAN;
}

static swResult read(void* context)
{
    Reader* reader = context;
    swResult result = readHead(reader);
    if (result == SW_SUCCESS)
    {
        result = readRows(reader);
    }
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.seconds = findTime(reader->file.text.name);
    def.frequencyCount = reader->count;
    def.frequencies = reader->frequencies;
    def.energy = reader->energy;
    def.a1 = reader->moments[0];
    def.b1 = reader->moments[1];
    def.a2 = reader->moments[2];
    def.b2 = reader->moments[3];
    if (result == SW_SUCCESS)
    {
        result = swMeasuredSea_AddSpectrum(reader->file.sea, &def);
    }
    return result;
}

swResult swParseDatawell(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    return swRunReader(host, text, size, name != NULL ? name : "Datawell file", sizeof(Reader), read, sea);
}
