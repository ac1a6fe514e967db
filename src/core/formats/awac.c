// SPDX-License-Identifier: MIT
// Reads what Nortek's AWAC profilers say of waves in NMEA sentences [Nortek 2017], in any order within a burst:
//
//   $PNORW,MMDDYY,hhmmss,basis,method,Hm0,...*hh                         parameters; Hm0 in m
//   $PNORE,MMDDYY,hhmmss,basis,f0,df,n,E1,...,En*hh                      densities, m2/Hz
//   $PNORF,A1,MMDDYY,hhmmss,basis,f0,df,n,...*hh                         moments A1, B1, A2, B2
//   $PNORWD,MD,MMDDYY,hhmmss,basis,f0,df,n,...*hh                        mean direction MD and spread DS, degrees
//
// Sentences of one date and time are a record. A1 and B1 are the means of cosine and sine of the direction that waves
// come from, clockwise from north, A2 and B2 those of twice it; -9 is missing. The manual says cm2/Hz, the instruments
// write m2/Hz: Hm0 tells which. Other sentences are passed over. hh is the exclusive or of the characters between.

#include <math.h>
#include <string.h>

#include "core/base/date.h"
#include "core/base/host.h"
#include "core/base/text.h"
#include "core/formats/measured_readers.h"

#define DEGREE (SW_PI / 180.0)
#define MISSING (-8.9)

typedef enum Row
{
    DENSITY,
    A1,
    B1,
    A2,
    B2,
    DIRECTION,
    SPREAD,
    ROW_COUNT
} Row;

static const char* const s_flags[ROW_COUNT] = {"", "A1", "B1", "A2", "B2", "MD", "DS"};

// Too large for a stack.
typedef struct Reader
{
    swSeaReader file;
    double seconds;  // of the burst; NAN before the first
    int line;        // where it began
    double height;   // Hm0; NAN
    bool hasHeights; // any burst has one
    int count;       // of densities; 0: none yet
    double first, step;
    int strangeCount; // bursts whose densities do not add up to Hm0
    double rows[ROW_COUNT][SW_SEA_MAX_FREQUENCIES];
    double frequencies[SW_SEA_MAX_FREQUENCIES];
    double widths[SW_SEA_MAX_FREQUENCIES];
} Reader;

bool swIsAwac(const char* text, size_t size)
{
    swText lines = swOpenText(NULL, text, size, "");
    for (int i = 0; i < 64 && swNextLine(&lines); ++i)
    {
        const char* dollar = memchr(lines.at, '$', (size_t)(lines.lineEnd - lines.at));
        lines.at = dollar != NULL ? dollar : lines.lineEnd;
        if (swHasPrefix(&lines, "$PNORW,") || swHasPrefix(&lines, "$PNORE,") || swHasPrefix(&lines, "$PNORF,") ||
            swHasPrefix(&lines, "$PNORWD,"))
        {
            return true;
        }
    }
    return false;
}

// ---- a burst's record ----

static void clear(Reader* reader)
{
    reader->height = (double)NAN;
    reader->count = 0;
    for (int i = 0; i < ROW_COUNT; ++i)
    {
        for (int j = 0; j < SW_SEA_MAX_FREQUENCIES; ++j)
        {
            reader->rows[i][j] = (double)NAN;
        }
    }
}

// Densities in cm2/Hz add up to a hundred times the height.
static void settleUnit(Reader* reader)
{
    double variance = 0.0;
    for (int i = 0; i < reader->count; ++i)
    {
        variance += reader->rows[DENSITY][i] > 0.0 ? reader->rows[DENSITY][i] * reader->widths[i] : 0.0;
    }
    double ratio = reader->height > 0.0 ? 4.0 * sqrt(variance) / reader->height : 1.0;
    bool isCentimetres = ratio > 80.0 && ratio < 120.0;
    for (int i = 0; i < reader->count && isCentimetres; ++i)
    {
        reader->rows[DENSITY][i] *= 1e-4;
    }
    reader->strangeCount += isCentimetres || (ratio > 0.8 && ratio < 1.25) ? 0 : 1;
}

// The moments where waves go, from those of where they come from; direction and r1 for where there are none.
static void turnMoments(Reader* reader, int i)
{
    double a1 = reader->rows[A1][i];
    double direction = reader->rows[DIRECTION][i], spread = reader->rows[SPREAD][i] * DEGREE;
    reader->rows[A1][i] = -reader->rows[B1][i];
    reader->rows[B1][i] = a1;
    reader->rows[A2][i] = -reader->rows[A2][i];
    reader->rows[B2][i] = -reader->rows[B2][i];
    reader->rows[DIRECTION][i] = fabs(direction) <= 720.0 ? (direction + 90.0) * DEGREE : (double)NAN;
    reader->rows[SPREAD][i] = spread >= 0.0 && spread <= sqrt(2.0) ? 1.0 - 0.5 * spread * spread : (double)NAN;
}

static swResult addSpectrum(Reader* reader)
{
    if (reader->count == 0)
    {
        char time[20];
        swPrintMinutes((int64_t)floor(reader->seconds / 60.0), time);
        return swFail(reader->file.text.host, SW_ERROR_FORMAT, "%s:%d: the burst of %s has no densities (PNORE).",
                      reader->file.text.name, reader->line, time);
    }
    for (int i = 0; i < reader->count; ++i)
    {
        reader->frequencies[i] = reader->first + reader->step * i;
        reader->widths[i] = reader->step;
        turnMoments(reader, i);
    }
    settleUnit(reader);
    reader->hasHeights = reader->hasHeights || reader->height > 0.0;
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.seconds = reader->seconds;
    def.frequencyCount = reader->count;
    def.frequencies = reader->frequencies;
    def.bandwidths = reader->widths;
    def.energy = reader->rows[DENSITY];
    def.a1 = reader->rows[A1];
    def.b1 = reader->rows[B1];
    def.a2 = reader->rows[A2];
    def.b2 = reader->rows[B2];
    def.meanDirection = reader->rows[DIRECTION];
    def.r1 = reader->rows[SPREAD];
    return swMeasuredSea_AddSpectrum(reader->file.sea, &def);
}

// At the end of a burst.
static swResult endBurst(Reader* reader)
{
    swResult result = reader->seconds == reader->seconds
                          ? swJudgeRecord(&reader->file, addSpectrum(reader), reader->line)
                          : SW_SUCCESS;
    clear(reader);
    return result;
}

// ---- sentences ----

static int getHexDigit(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                  : -1;
}

// From the '$' to the '*', which becomes the line's end. A sum that is told must be right.
static swResult checkSum(swText* text)
{
    unsigned sum = 0;
    const char* at = text->at + 1;
    for (; at < text->lineEnd && *at != '*'; ++at)
    {
        sum ^= (unsigned char)*at;
    }
    if (at < text->lineEnd)
    {
        int high = text->lineEnd - at > 2 ? getHexDigit(at[1]) : -1;
        int low = text->lineEnd - at > 2 ? getHexDigit(at[2]) : -1;
        if (high < 0 || low < 0 || (unsigned)(16 * high + low) != sum)
        {
            return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the sentence's sum is %02X, not the '%.*s' behind it.",
                          text->name, text->line, sum, (int)(text->lineEnd - at), at);
        }
    }
    text->lineEnd = at;
    return SW_SUCCESS;
}

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

// MMDDYY,hhmmss and the basis. Another time ends the burst before it.
static swResult readBurst(Reader* reader)
{
    swText* text = &reader->file.text;
    double date = 0.0, time = 0.0, basis = 0.0, seconds = 0.0;
    swResult result = readField(text, "a date (MMDDYY)", 10100.0, 123199.0, &date);
    result = result == SW_SUCCESS ? readField(text, "a time (hhmmss)", 0.0, 235960.0, &time) : result;
    result = result == SW_SUCCESS ? readField(text, "the spectrum's basis", 0.0, 99.0, &basis) : result;
    int day = (int)date, clock = (int)time;
    if (result == SW_SUCCESS &&
        !swMakeSeconds(day % 100 + (day % 100 < 80 ? 2000 : 1900), day / 10000, day / 100 % 100, clock / 10000,
                       clock / 100 % 100, clock % 100 + (time - clock), &seconds))
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %06d and %06d are no date and time (MMDDYY, hhmmss).",
                        text->name, text->line, day, clock);
    }
    if (result == SW_SUCCESS && seconds != reader->seconds)
    {
        result = endBurst(reader);
        reader->seconds = seconds;
        reader->line = text->line;
    }
    return result;
}

static swResult failRow(const swText* text, swToken field, int index, int count)
{
    return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: number %d of %d is '%.*s'.", text->name, text->line, index + 1,
                  count, field.size, field.text);
}

// Numbers by frequency. Moments are put where their frequency's density is or will be.
static swResult readRow(Reader* reader, Row row)
{
    swText* text = &reader->file.text;
    double first = 0.0, step = 0.0, count = 0.0;
    swResult result = readBurst(reader);
    result = result == SW_SUCCESS ? readField(text, "the first frequency", 0.0, 100.0, &first) : result;
    result = result == SW_SUCCESS ? readField(text, "the step of frequencies", 1e-4, 10.0, &step) : result;
    result = result == SW_SUCCESS ? readField(text, "the number of frequencies", 2.0, SW_SEA_MAX_FREQUENCIES, &count)
                                  : result;
    if (result == SW_SUCCESS && reader->count > 0 && (first != reader->first || step != reader->step))
    {
        return swFail(text->host, SW_ERROR_FORMAT,
                      "%s:%d: the frequencies are not those of the burst's other sentences.", text->name, text->line);
    }
    double values[SW_SEA_MAX_FREQUENCIES];
    for (int i = 0; i < (int)count && result == SW_SUCCESS; ++i)
    {
        swToken field = {text->at, 0};
        bool isNumber = swNextField(text, &field) && swParseToken(field, &values[i]);
        result = isNumber ? SW_SUCCESS : failRow(text, field, i, (int)count);
        values[i] = isNumber && values[i] > MISSING ? values[i] : (double)NAN;
    }
    if (result == SW_SUCCESS && text->at <= text->lineEnd)
    {
        result = swFail(text->host, SW_ERROR_FORMAT, "%s:%d: more numbers follow than the %d that are told.",
                        text->name, text->line, (int)count);
    }
    if (result == SW_SUCCESS)
    {
        memcpy(reader->rows[row], values, (size_t)count * sizeof(double));
        reader->count = row == DENSITY ? (int)count : reader->count;
        reader->first = first;
        reader->step = step;
    }
    return result;
}

static swResult readFlagged(Reader* reader, Row first, Row last)
{
    swText* text = &reader->file.text;
    swToken flag = {text->at, 0};
    bool isThere = swNextField(text, &flag);
    for (int row = first; row <= (int)last && isThere; ++row)
    {
        if (swIsToken(flag, s_flags[row]))
        {
            return readRow(reader, (Row)row);
        }
    }
    return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: '%.*s' should be %s to %s.", text->name, text->line, flag.size,
                  flag.text, s_flags[first], s_flags[last]);
}

static swResult readParameters(Reader* reader)
{
    double method = 0.0, height = 0.0;
    swResult result = readBurst(reader);
    result = result == SW_SUCCESS ? readField(&reader->file.text, "the method", 0.0, 99.0, &method) : result;
    result = result == SW_SUCCESS ? readField(&reader->file.text, "Hm0", -99.0, 99.0, &height) : result;
    reader->height = result == SW_SUCCESS && height > 0.0 ? height : reader->height;
    return result;
}

static swResult readSentence(Reader* reader)
{
    swText* text = &reader->file.text;
    swToken name;
    const char* dollar = memchr(text->at, '$', (size_t)(text->lineEnd - text->at)); // loggers put times before it
    if (dollar == NULL)
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the line holds no sentence ($...).", text->name, text->line);
    }
    text->at = dollar;
    swResult result = checkSum(text);
    if (result != SW_SUCCESS || !swNextField(text, &name))
    {
        return result;
    }
    if (swIsToken(name, "$PNORW"))
    {
        return readParameters(reader);
    }
    if (swIsToken(name, "$PNORE"))
    {
        return readRow(reader, DENSITY);
    }
    return swIsToken(name, "$PNORF")    ? readFlagged(reader, A1, B2)
           : swIsToken(name, "$PNORWD") ? readFlagged(reader, DIRECTION, SPREAD)
                                        : SW_SUCCESS;
}

static void warn(const Reader* reader)
{
    const swText* text = &reader->file.text;
    if (!reader->hasHeights && reader->file.sea->records.count > 0)
    {
        swLog(text->host, SW_LOG_WARNING, "%s: no PNORW tells a height: densities are taken to be in m2/Hz.",
              text->name);
    }
    if (reader->strangeCount > 0)
    {
        swLog(text->host, SW_LOG_WARNING,
              "%s: in %d bursts the densities (PNORE) do not add up to the height in PNORW; they are kept as they are.",
              text->name, reader->strangeCount);
    }
}

static swResult read(void* context)
{
    Reader* reader = context;
    swResult result = SW_SUCCESS;
    reader->seconds = (double)NAN;
    clear(reader);
    while (result == SW_SUCCESS && swNextLine(&reader->file.text))
    {
        result = swJudgeRecord(&reader->file, readSentence(reader), reader->file.text.line);
    }
    result = result == SW_SUCCESS ? endBurst(reader) : result;
    warn(reader);
    return result;
}

swResult swParseAwac(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    return swRunReader(host, text, size, name != NULL ? name : "AWAC sentences", sizeof(Reader), read, sea);
}
