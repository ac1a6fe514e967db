// SPDX-License-Identifier: MIT
// Measured seas in JSON, by way of libjansson. Two shapes are known by what they hold:
//
// Sofar's Spotter buoys: {"data": {"spotterId": ..., "frequencyData": [{"frequency": [], "df": [], "varianceDensity":
// [], "a1": [], "b1": [], "a2": [], "b2": [], "timestamp": "2018-02-14T01:27:19.000Z", "latitude": , "longitude": },
// ...]}}. a1 points east and b1 north, where waves go; here north is -z. "direction" and "directionalSpread", degrees
// that waves come from, are taken where there are no moments.
//
// Spectra by name, as MHKiT keeps CDIP's: {"CDiP1": {"S": {"0.025": 0.0004, ...}, "freqBinWidth": {"0.025": 0.005,
// ...}}}: m2/Hz by Hz, without directions and time.

#include <jansson.h>
#include <math.h>
#include <string.h>

#include "core/base/number.h"
#include "core/base/trial.h"
#include "files/measured_formats.h"

#define MAX_FREQUENCIES 1025 // one may be 0

enum
{
    FREQUENCY,
    BANDWIDTH,
    ENERGY,
    A1,
    B1,
    A2,
    B2,
    DIRECTION,
    SPREAD,
    COLUMN_COUNT
};

// Too large for a stack.
typedef struct Reader
{
    const swHost* host; // the trial's: a record that fails is left out
    swTrial trial;
    const char* name;
    swMeasuredSea* sea;
    double columns[COLUMN_COUNT][MAX_FREQUENCIES];
} Reader;

// ---- Spotter ----

// A list of numbers, null where missing. *count is 0 if there is no such list.
static swResult readColumn(const Reader* reader, const json_t* record, size_t index, const char* key, double* values,
                           int* count)
{
    const json_t* list = json_object_get(record, key);
    *count = 0;
    if (list == NULL || json_is_null(list))
    {
        return SW_SUCCESS;
    }
    if (!json_is_array(list) || json_array_size(list) > MAX_FREQUENCIES)
    {
        return swFail(reader->host, SW_ERROR_FORMAT, "%s: record %zu: %s is no list of at most %d numbers.",
                      reader->name, index + 1, key, MAX_FREQUENCIES);
    }
    *count = (int)json_array_size(list);
    for (int i = 0; i < *count; ++i)
    {
        const json_t* item = json_array_get(list, (size_t)i);
        if (!json_is_number(item) && !json_is_null(item))
        {
            return swFail(reader->host, SW_ERROR_FORMAT, "%s: record %zu: item %d of %s is no number.", reader->name,
                          index + 1, i + 1, key);
        }
        values[i] = json_is_number(item) ? json_number_value(item) : (double)NAN;
    }
    return SW_SUCCESS;
}

static swResult readColumns(Reader* reader, const json_t* record, size_t index, int counts[COLUMN_COUNT])
{
    static const char* const keys[COLUMN_COUNT] = {"frequency", "df",        "varianceDensity",  "a1", "b1", "a2",
                                                   "b2",        "direction", "directionalSpread"};
    for (int i = 0; i < COLUMN_COUNT; ++i)
    {
        swResult result = readColumn(reader, record, index, keys[i], reader->columns[i], &counts[i]);
        if (result != SW_SUCCESS)
        {
            return result;
        }
        bool isOptional = i != FREQUENCY && i != ENERGY;
        if (counts[i] != counts[FREQUENCY] && !(isOptional && counts[i] == 0))
        {
            return swFail(reader->host, SW_ERROR_FORMAT, "%s: record %zu: %s has %d numbers, frequency %d.",
                          reader->name, index + 1, keys[i], counts[i], counts[FREQUENCY]);
        }
    }
    if (counts[FREQUENCY] == 0)
    {
        return swFail(reader->host, SW_ERROR_FORMAT, "%s: record %zu has no frequencies.", reader->name, index + 1);
    }
    for (int i = 0; i < counts[FREQUENCY]; ++i)
    {
        reader->columns[B1][i] = -reader->columns[B1][i];
        reader->columns[B2][i] = -reader->columns[B2][i];
        double direction = reader->columns[DIRECTION][i], spread = reader->columns[SPREAD][i] * (SW_PI / 180.0);
        reader->columns[DIRECTION][i] = fabs(direction) <= 720.0 ? (direction + 90.0) * (SW_PI / 180.0) : (double)NAN;
        reader->columns[SPREAD][i] =
            spread >= 0.0 && spread * spread <= 2.0 ? 1.0 - 0.5 * spread * spread : (double)NAN;
    }
    return SW_SUCCESS;
}

static double getNumber(const json_t* object, const char* key)
{
    const json_t* value = json_object_get(object, key);
    return json_is_number(value) ? json_number_value(value) : (double)NAN;
}

static swResult addSpectrum(Reader* reader, swMeasuredSpectrumDef* def, size_t index)
{
    def->warnOnly = true;
    swResult result = swMeasuredSea_AddSpectrum(reader->sea, def);
    return result == SW_ERROR_FORMAT
               ? swFail(reader->host, result, "%s: record %zu cannot be used.", reader->name, index + 1)
               : result;
}

static swResult addSpotter(Reader* reader, const json_t* record, size_t index)
{
    int counts[COLUMN_COUNT] = {0};
    swResult result = readColumns(reader, record, index, counts);
    const char* time = json_string_value(json_object_get(record, "timestamp"));
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    if (result == SW_SUCCESS && (time == NULL || !swParseMeasuredTime(time, &def.seconds)))
    {
        result = swFail(reader->host, SW_ERROR_FORMAT,
                        "%s: record %zu: timestamp is '%s'; it must be as 2018-02-14T01:27:19.000Z.", reader->name,
                        index + 1, time != NULL ? time : "");
    }
    def.frequencyCount = counts[FREQUENCY];
    def.frequencies = reader->columns[FREQUENCY];
    def.bandwidths = counts[BANDWIDTH] > 0 ? reader->columns[BANDWIDTH] : NULL;
    def.energy = reader->columns[ENERGY];
    def.a1 = counts[A1] > 0 ? reader->columns[A1] : NULL;
    def.b1 = counts[B1] > 0 ? reader->columns[B1] : NULL;
    def.a2 = counts[A2] > 0 ? reader->columns[A2] : NULL;
    def.b2 = counts[B2] > 0 ? reader->columns[B2] : NULL;
    def.meanDirection = counts[DIRECTION] > 0 ? reader->columns[DIRECTION] : NULL; // where there are no moments
    def.r1 = counts[SPREAD] > 0 ? reader->columns[SPREAD] : NULL;
    return result == SW_SUCCESS ? addSpectrum(reader, &def, index) : result;
}

// A drifting buoy is one place, where it was first.
static swResult readSpotter(Reader* reader, const json_t* data, const json_t* records)
{
    if (!json_is_array(records) || json_array_size(records) == 0)
    {
        return swFail(reader->host, SW_ERROR_FORMAT,
                      "%s: frequencyData is no list of records; ask Sofar for the spectra too (includeFrequencyData).",
                      reader->name);
    }
    const json_t* first = json_array_get(records, 0);
    swResult result = swMeasuredSea_AddLocation(reader->sea, json_string_value(json_object_get(data, "spotterId")),
                                                getNumber(first, "longitude"), getNumber(first, "latitude"), NULL);
    for (size_t i = 0; i < json_array_size(records) && result == SW_SUCCESS; ++i)
    {
        result = addSpotter(reader, json_array_get(records, i), i);
        result = swJudgeTrial(&reader->trial, result, "record", (int)i + 1);
    }
    return result;
}

// ---- spectra by name ----

static swResult failSpectrum(const Reader* reader, const char* name, const char* key, const char* what)
{
    return swFail(reader->host, SW_ERROR_FORMAT, "%s: %s: '%s' %s.", reader->name, name, key, what);
}

static swResult addByFrequency(Reader* reader, const char* name, json_t* spectrum, const json_t* widths, size_t index)
{
    int count = 0, widthCount = 0;
    const char* key = NULL;
    json_t* value = NULL;
    json_object_foreach(spectrum, key, value)
    {
        size_t length = strlen(key);
        if (count >= MAX_FREQUENCIES || !json_is_number(value) || length > 60 ||
            !swParseNumber(key, (int)length, &reader->columns[FREQUENCY][count]))
        {
            return failSpectrum(reader, name, key, "in S is no frequency with a number, or there are too many");
        }
        double width = getNumber(widths, key);
        reader->columns[ENERGY][count] = json_number_value(value);
        reader->columns[BANDWIDTH][count] = width;
        widthCount += width == width ? 1 : 0;
        ++count;
    }
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.frequencyCount = count;
    def.frequencies = reader->columns[FREQUENCY];
    def.bandwidths = widthCount == count ? reader->columns[BANDWIDTH] : NULL;
    def.energy = reader->columns[ENERGY];
    swResult result = swMeasuredSea_AddLocation(reader->sea, name, (double)NAN, (double)NAN, &def.location);
    return result == SW_SUCCESS ? addSpectrum(reader, &def, index) : result;
}

static swResult readByName(Reader* reader, json_t* root)
{
    const char* name = NULL;
    json_t* item = NULL;
    int found = 0;
    json_object_foreach(root, name, item)
    {
        json_t* spectrum = json_object_get(item, "S");
        if (json_is_object(spectrum))
        {
            size_t index = (size_t)found++;
            swResult result = addByFrequency(reader, name, spectrum, json_object_get(item, "freqBinWidth"), index);
            result = swJudgeTrial(&reader->trial, result, "record", found);
            if (result != SW_SUCCESS)
            {
                return result;
            }
        }
    }
    if (found == 0)
    {
        return swFail(reader->host, SW_ERROR_FORMAT,
                      "%s:1: this JSON holds neither frequencyData, as Sofar's Spotter buoys have it, nor spectra S by "
                      "name, as MHKiT has them.",
                      reader->name);
    }
    return SW_SUCCESS;
}

// ---- the file ----

static swResult readRoot(Reader* reader, json_t* root)
{
    const json_t* data = json_object_get(root, "data");
    data = json_is_object(data) ? data : root;
    const json_t* records = json_object_get(data, "frequencyData");
    swResult result = records != NULL ? readSpotter(reader, data, records) : readByName(reader, root);
    result = swEndTrial(&reader->trial, result);
    return result == SW_SUCCESS ? swMeasuredSea_Finish(reader->sea) : result;
}

swResult swReadJsonSea(const swHost* host, const char* text, size_t size, const char* name, swMeasuredSea** sea)
{
    *sea = NULL;
    json_error_t error;
    size_t mark = size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0; // UTF-8's byte order mark
    json_t* root = json_loadb(text + mark, size - mark, 0, &error);
    if (root == NULL)
    {
        return swFail(host, SW_ERROR_FORMAT, "%s:%d: this is no JSON: %s.", name, error.line > 0 ? error.line : 1,
                      error.text);
    }
    Reader* reader = swAllocateZero(host, sizeof(*reader));
    swResult result = reader != NULL ? SW_SUCCESS : swFail(host, SW_ERROR_NO_MEMORY, "No memory to read %s.", name);
    if (result == SW_SUCCESS)
    {
        swBeginTrial(&reader->trial, host);
        reader->host = &reader->trial.host;
        reader->name = name;
        result = swCreateMeasuredSea(host, name, &reader->sea);
    }
    if (result == SW_SUCCESS)
    {
        result = readRoot(reader, root);
    }
    if (result == SW_SUCCESS)
    {
        *sea = reader->sea;
    }
    else if (reader != NULL)
    {
        swDestroyMeasuredSea(reader->sea);
    }
    json_decref(root);
    swFree(host, reader, sizeof(*reader));
    return result;
}
