// SPDX-License-Identifier: MIT
// Reads the table that the dashboard of Sofar's Spotter buoys exports [Sofar 2023]: a heading, and a line for each
// record with
//
//   Epoch Time, Latitude (deg), Longitude (deg)         seconds since 1970, UTC
//   f_0 ..., df_0 ..., varianceDensity_0 ...            Hz, Hz, m2/Hz
//   a1_0 ..., b1_0 ..., a2_0 ..., b2_0 ...              moments: a1 points east and b1 north, where waves go
//   direction_0 ..., directionalSpread_0 ...            degrees that waves come from; taken where there are no moments
//
// in any order, among columns of other names. A drifting buoy is one place, where it was first.

#include <math.h>
#include <string.h>

#include "core/base/text.h"
#include "core/formats/measured_readers.h"

#define DEGREE (SW_PI / 180.0)
#define MAX_COLUMNS 12000
#define MAX_BANDS (SW_SEA_MAX_FREQUENCIES + 1)

typedef enum Quantity
{
    FREQUENCY,
    BANDWIDTH,
    DENSITY,
    A1,
    B1,
    A2,
    B2,
    DIRECTION,
    SPREAD,
    BAND_QUANTITIES,
    TIME = BAND_QUANTITIES,
    LATITUDE,
    LONGITUDE,
    OTHER
} Quantity;

static const char* const s_names[OTHER] = {"f_",
                                           "df_",
                                           "varianceDensity_",
                                           "a1_",
                                           "b1_",
                                           "a2_",
                                           "b2_",
                                           "direction_",
                                           "directionalSpread_",
                                           "Epoch Time",
                                           "Latitude (deg)",
                                           "Longitude (deg)"};

typedef struct Column
{
    Quantity quantity;
    int band;
} Column;

// Too large for a stack.
typedef struct Reader
{
    swSeaReader file;
    int columnCount;
    int bandCount;
    double first, place[2]; // time, latitude and longitude of the first record
    double single[OTHER - BAND_QUANTITIES];
    double bands[BAND_QUANTITIES][MAX_BANDS];
    Column columns[MAX_COLUMNS];
} Reader;

// ---- heading ----

static Column findColumn(swToken field)
{
    for (int i = 0; i < OTHER; ++i)
    {
        int size = (int)strlen(s_names[i]);
        if (field.size < size || memcmp(field.text, s_names[i], (size_t)size) != 0)
        {
            continue;
        }
        double band = 0.0;
        swToken rest = {field.text + size, field.size - size};
        if (i >= BAND_QUANTITIES && rest.size == 0)
        {
            return (Column){(Quantity)i, 0};
        }
        if (i < BAND_QUANTITIES && swParseToken(rest, &band) && band >= 0.0 && band < MAX_BANDS)
        {
            return (Column){(Quantity)i, (int)band};
        }
    }
    return (Column){OTHER, 0};
}

bool swIsSpotterCsv(const char* text, size_t size)
{
    swText lines = swOpenText(NULL, text, size, "");
    swToken field;
    bool hasTime = false, hasBands = false;
    if (swNextLine(&lines))
    {
        while (swNextField(&lines, &field))
        {
            Quantity quantity = findColumn(field).quantity;
            hasTime = hasTime || quantity == TIME;
            hasBands = hasBands || quantity == DENSITY || swIsToken(field, "Significant Wave Height (m)");
        }
    }
    return hasTime && hasBands;
}

static swResult readHeading(Reader* reader)
{
    swText* text = &reader->file.text;
    swResult result = swNeedLine(text, "the heading");
    swToken field;
    bool hasDensity = false;
    while (result == SW_SUCCESS && swNextField(text, &field))
    {
        if (reader->columnCount >= MAX_COLUMNS)
        {
            return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the heading has more than %d columns.", text->name,
                          text->line, MAX_COLUMNS);
        }
        Column column = findColumn(field);
        hasDensity = hasDensity || column.quantity == DENSITY;
        reader->bandCount =
            column.quantity < BAND_QUANTITIES && column.band >= reader->bandCount ? column.band + 1 : reader->bandCount;
        reader->columns[reader->columnCount++] = column;
    }
    if (result == SW_SUCCESS && !hasDensity)
    {
        result =
            swFail(text->host, SW_ERROR_FORMAT,
                   "%s:%d: the table holds no spectra (varianceDensity_0 ...): download it from the dashboard with "
                   "the frequency data, or write its heights and periods as a table of partitions.",
                   text->name, text->line);
    }
    return result;
}

// ---- records ----

static swResult readFields(Reader* reader)
{
    swText* text = &reader->file.text;
    swToken field;
    int count = 0;
    for (; swNextField(text, &field); ++count)
    {
        Column column = count < reader->columnCount ? reader->columns[count] : (Column){OTHER, 0};
        double value = (double)NAN;
        if (column.quantity == OTHER)
        {
            continue;
        }
        bool isNumber = swParseToken(field, &value);
        if (!isNumber && !swIsMissingField(field))
        {
            return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: %s should be a number, not '%.*s'.", text->name,
                          text->line, s_names[column.quantity], field.size, field.text);
        }
        double* values = column.quantity < BAND_QUANTITIES ? reader->bands[column.quantity]
                                                           : &reader->single[column.quantity - BAND_QUANTITIES];
        values[column.band] = isNumber ? value : (double)NAN;
    }
    if (count != reader->columnCount)
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the line has %d fields, the heading %d; is it cut off?",
                      text->name, text->line, count, reader->columnCount);
    }
    return SW_SUCCESS;
}

// Moments of a band in the library's directions, north being -z; its direction and r1 for where there are none.
static void turnMoments(Reader* reader, int band)
{
    double spread = reader->bands[SPREAD][band] * DEGREE;
    double direction = reader->bands[DIRECTION][band];
    reader->bands[B1][band] = -reader->bands[B1][band];
    reader->bands[B2][band] = -reader->bands[B2][band];
    reader->bands[DIRECTION][band] = fabs(direction) <= 720.0 ? (direction + 90.0) * DEGREE : (double)NAN;
    reader->bands[SPREAD][band] = spread >= 0.0 && spread <= sqrt(2.0) ? 1.0 - 0.5 * spread * spread : (double)NAN;
}

// Puts the bands whose frequency is known in a row, each with its moments. Returns how many there are, 0 without any
// density.
static int gatherBands(Reader* reader, bool* hasWidths)
{
    int count = 0;
    bool hasDensity = false;
    *hasWidths = true;
    for (int i = 0; i < reader->bandCount; ++i)
    {
        bool isKnown = reader->bands[FREQUENCY][i] == reader->bands[FREQUENCY][i];
        hasDensity = hasDensity || (isKnown && reader->bands[DENSITY][i] == reader->bands[DENSITY][i]);
        for (int j = 0; j < BAND_QUANTITIES && isKnown; ++j)
        {
            reader->bands[j][count] = reader->bands[j][i];
        }
        if (isKnown)
        {
            *hasWidths = *hasWidths && reader->bands[BANDWIDTH][count] > 0.0;
            turnMoments(reader, count++);
        }
    }
    return hasDensity ? count : 0;
}

static swResult addSpectrum(Reader* reader)
{
    swText* text = &reader->file.text;
    bool hasWidths = false;
    double seconds = reader->single[TIME - BAND_QUANTITIES];
    int count = gatherBands(reader, &hasWidths);
    if (seconds != seconds || count == 0)
    {
        return swFail(text->host, SW_ERROR_FORMAT, "%s:%d: the record has no %s.", text->name, text->line,
                      count > 0 ? "time" : "spectrum");
    }
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.seconds = seconds;
    def.frequencyCount = count;
    def.frequencies = reader->bands[FREQUENCY];
    def.bandwidths = hasWidths ? reader->bands[BANDWIDTH] : NULL;
    def.energy = reader->bands[DENSITY];
    def.a1 = reader->bands[A1];
    def.b1 = reader->bands[B1];
    def.a2 = reader->bands[A2];
    def.b2 = reader->bands[B2];
    def.meanDirection = reader->bands[DIRECTION];
    def.r1 = reader->bands[SPREAD];
    swResult result = swMeasuredSea_AddSpectrum(reader->file.sea, &def);
    if (result == SW_SUCCESS && !(reader->first <= seconds)) // true for the first, when it is NAN
    {
        reader->first = seconds;
        reader->place[0] = reader->single[LATITUDE - BAND_QUANTITIES];
        reader->place[1] = reader->single[LONGITUDE - BAND_QUANTITIES];
    }
    return result;
}

static void clear(Reader* reader)
{
    for (int i = 0; i < OTHER - BAND_QUANTITIES; ++i)
    {
        reader->single[i] = (double)NAN;
    }
    for (int i = 0; i < BAND_QUANTITIES; ++i)
    {
        for (int j = 0; j < reader->bandCount; ++j)
        {
            reader->bands[i][j] = (double)NAN;
        }
    }
}

static swResult read(void* context)
{
    Reader* reader = context;
    swResult result = readHeading(reader);
    reader->first = reader->place[0] = reader->place[1] = (double)NAN;
    while (result == SW_SUCCESS && swNextLine(&reader->file.text))
    {
        clear(reader);
        result = readFields(reader);
        result = result == SW_SUCCESS ? addSpectrum(reader) : result;
        result = swJudgeRecord(&reader->file, result, reader->file.text.line);
    }
    return result == SW_SUCCESS
               ? swMeasuredSea_AddLocation(reader->file.sea, NULL, reader->place[1], reader->place[0], NULL)
               : result;
}

swResult swParseSpotterCsv(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    return swRunReader(host, text, size, name != NULL ? name : "Spotter table", sizeof(Reader), read, sea);
}
