// SPDX-License-Identifier: MIT
// Measured seas in scene files. One file is taken as it is. Several files become one series: of each the records of one
// place are copied, and swMeasuredSea_Finish() puts them in order. A series to be replayed leaves out records without
// energy, between which and others no wave could keep its phase.

#include "scene/scene_measured.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "files/file_text.h"
#include "seaway/files.h"

#define MAX_FILES 1024

swResult swReadReplay(swYaml* yaml, yaml_node_t* node, swMeasuredText* text, yaml_node_t** from)
{
    swYamlMapping mapping;
    swBeginYamlMapping(&mapping, "replay");
    swAddYamlFields(&mapping, swGetMeasuredTextFields(), 0, "replay");
    swResult result = swReadYamlMapping(yaml, node, &mapping, text);
    *from = swGetYamlNode(&mapping, "from");
    return result;
}

// ---- one file ----

// False if there is no room for it.
static bool joinPath(char* path, size_t size, const char* folder, const char* file)
{
    bool isAlone = file[0] == '/' || folder == NULL || folder[0] == '\0';
    return (size_t)snprintf(path, size, "%s%s%s", isAlone ? "" : folder, isAlone ? "" : "/", file) < size;
}

static swResult readFile(swYaml* yaml, const swMeasuredKeys* keys, const yaml_node_t* node, const char* file,
                         swMeasuredSea** sea)
{
    char path[SW_MAX_PATH];
    if (!joinPath(path, sizeof(path), keys->folder, file))
    {
        return swFailYaml(yaml, node, SW_MISTAKE_TOO_LARGE,
                          "the path of %s has more than %d bytes; move the scene or the file.", file, SW_MAX_PATH - 1);
    }
    swMeasuredFileDef def = swDefaultMeasuredFileDef();
    if (keys->directions != NULL)
    {
        def.directions = keys->text->directions == 0 ? SW_DIRECTIONS_FROM : SW_DIRECTIONS_TO;
    }
    swResult result = swReadMeasuredFile(yaml->host, path, &def, sea);
    if (result == SW_ERROR_FILE || result == SW_ERROR_FORMAT)
    {
        swFailYaml(yaml, node, SW_MISTAKE_BAD_FILE, "the spectrum file %s cannot be used.", path);
    }
    return result;
}

// "1 A, 2 B, 3", as many as there is room for.
static void listPlaces(const swMeasuredSea* sea, char* list, size_t size)
{
    int count = swMeasuredSea_GetLocationCount(sea);
    size_t used = 0;
    for (int i = 0; i < count && used + 80 < size; ++i)
    {
        swMeasuredLocation place = swMeasuredSea_GetLocation(sea, i);
        used += (size_t)snprintf(list + used, size - used, "%s%d%s%s", i > 0 ? ", " : "", i + 1,
                                 place.name[0] != '\0' ? " " : "", place.name);
    }
}

// The place nearest to the latitude and longitude that are asked for.
static swResult chooseNearest(swYaml* yaml, const swMeasuredKeys* keys, const swMeasuredSea* sea, int* location)
{
    const yaml_node_t* node = keys->latitude != NULL ? keys->latitude : keys->longitude;
    if (keys->latitude == NULL || keys->longitude == NULL)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "latitude and longitude belong together; give both.");
    }
    if (keys->location != NULL)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_CONFLICT,
                          "location and latitude both choose a place; keep one of them.");
    }
    swResult result = swMeasuredSea_ChooseNearest(sea, keys->text->longitude, keys->text->latitude, location, NULL);
    return result == SW_SUCCESS
               ? result
               : swFailYaml(yaml, node, SW_MISTAKE_NO_RECORD, "no place of the file is near latitude %g, longitude %g.",
                            keys->text->latitude, keys->text->longitude);
}

// The place that is asked for; without one -1, if the waves may be of any.
static swResult choosePlace(swYaml* yaml, const swMeasuredKeys* keys, const yaml_node_t* fileNode,
                            const swMeasuredSea* sea, bool needsOne, int* location)
{
    if (keys->latitude != NULL || keys->longitude != NULL)
    {
        return chooseNearest(yaml, keys, sea, location);
    }
    char places[400] = "";
    listPlaces(sea, places, sizeof(places));
    *location = keys->location != NULL ? swFindMeasuredPlace(sea, keys->text->location) : -1;
    if (keys->location != NULL && *location < 0)
    {
        return swFailYaml(yaml, keys->location, SW_MISTAKE_UNKNOWN_WORD,
                          "location is '%s'; it must be the name or number of a place of the file, which has: %s.",
                          keys->text->location, places);
    }
    if (*location < 0 && needsOne)
    {
        int count = swMeasuredSea_GetLocationCount(sea);
        if (count > 1)
        {
            return swFailYaml(yaml, fileNode, SW_MISTAKE_MISSING_KEY,
                              "the file has %d places; choose one of them with location, or with latitude and "
                              "longitude: %s.",
                              count, places);
        }
        *location = 0;
    }
    return SW_SUCCESS;
}

// ---- several files ----

static double sumEnergy(const swMeasuredRecord* record)
{
    double sum = 0.0;
    for (int i = 0; i < record->table.frequencyCount; ++i)
    {
        sum += (double)record->energy[i] * (double)record->table.bandwidths[i];
    }
    return sum;
}

// What swSpectrum_GetSeaState() takes for a calm.
static bool isCalm(const swMeasuredRecord* record)
{
    swSpectrumDef def = swDefaultSpectrumDef();
    def.kind = SW_SPECTRUM_TABLE;
    def.table = &record->table;
    swSeaState state;
    return sumEnergy(record) < 1e-4 && swSpectrum_GetSeaState(&def, 0.0f, 0.0f, &state) != SW_SUCCESS;
}

static int countCalms(const swMeasuredSea* sea, int location)
{
    swMeasuredLocation place = swMeasuredSea_GetLocation(sea, location);
    int count = 0;
    for (int i = 0; i < place.recordCount; ++i)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, place.firstRecord + i);
        count += isCalm(&record);
    }
    return count;
}

static double* widen(const float* from, size_t count, double* to)
{
    for (size_t i = 0; i < count; ++i)
    {
        to[i] = (double)from[i];
    }
    return to + count;
}

static swResult copyRecord(const swHost* host, const swMeasuredRecord* record, swMeasuredSea* series)
{
    const swSpectrumTable* table = &record->table;
    size_t frequencies = (size_t)table->frequencyCount, directions = (size_t)table->directionCount;
    size_t size = (2 * frequencies + directions + frequencies * directions) * sizeof(double);
    double* numbers = swAllocate(host, size);
    if (numbers == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "No memory to copy a spectrum.");
    }
    swMeasuredSpectrumDef def = swDefaultMeasuredSpectrumDef();
    def.seconds = record->time[0] != '\0' ? record->seconds : (double)NAN;
    def.frequencyCount = table->frequencyCount;
    def.directionCount = table->directionCount;
    def.frequencies = numbers;
    def.bandwidths = numbers + frequencies;
    def.directions = numbers + 2 * frequencies;
    def.density = numbers + 2 * frequencies + directions;
    double* to = widen(table->bandwidths, frequencies, widen(table->frequencies, frequencies, numbers));
    for (size_t i = 0; i < directions; ++i)
    {
        to[i] = (double)table->firstDirection + 2.0 * SW_PI * (double)i / (double)directions;
    }
    widen(table->density, frequencies * directions, to + directions);
    swResult result = swMeasuredSea_AddSpectrum(series, &def);
    swFree(host, numbers, size);
    return result;
}

static swResult copyPlace(const swHost* host, const swMeasuredSea* sea, int location, bool dropsCalms,
                          swMeasuredSea* series)
{
    swMeasuredLocation place = swMeasuredSea_GetLocation(sea, location);
    swResult result = SW_SUCCESS;
    for (int i = 0; i < place.recordCount && result == SW_SUCCESS; ++i)
    {
        swMeasuredRecord record = swMeasuredSea_GetRecord(sea, place.firstRecord + i);
        if (!dropsCalms || !isCalm(&record))
        {
            result = copyRecord(host, &record, series);
        }
    }
    return result;
}

// Add a file's records of the place to the series, which is made with the first.
static swResult addFile(swYaml* yaml, const swMeasuredKeys* keys, const yaml_node_t* node, const char* file,
                        swMeasuredSea** series)
{
    swMeasuredSea* sea = NULL;
    int location = 0;
    swResult result = readFile(yaml, keys, node, file, &sea);
    result = result == SW_SUCCESS ? choosePlace(yaml, keys, node, sea, true, &location) : result;
    if (result == SW_SUCCESS && *series == NULL)
    {
        swMeasuredLocation place = swMeasuredSea_GetLocation(sea, location);
        swMeasuredDirections directions = swMeasuredSea_GetDirections(sea);
        result = swCreateMeasuredSea(yaml->host, yaml->name, series);
        swMeasuredSea_SetDirections(*series, &directions);
        result = result == SW_SUCCESS
                     ? swMeasuredSea_AddLocation(*series, place.name, place.longitude, place.latitude, NULL)
                     : result;
    }
    if (result == SW_SUCCESS)
    {
        int calms = keys->replay != NULL ? countCalms(sea, location) : 0;
        if (calms > 0)
        {
            swLog(yaml->host, SW_LOG_WARNING, "%s: %d %s without energy %s left out of the replay.", file, calms,
                  calms == 1 ? "record" : "records", calms == 1 ? "is" : "are");
        }
        result = copyPlace(yaml->host, sea, location, calms > 0, *series);
    }
    swDestroyMeasuredSea(sea);
    return result;
}

static swResult addFiles(swYaml* yaml, const swMeasuredKeys* keys, swSceneWaves* waves)
{
    if (keys->list == NULL)
    {
        return addFile(yaml, keys, keys->file, keys->text->file, &waves->measured);
    }
    int count = 0;
    swResult result = swReadYamlList(yaml, keys->list, "files", MAX_FILES, &count);
    if (result == SW_SUCCESS && count == 0)
    {
        result = swFailYaml(yaml, keys->list, SW_MISTAKE_MISSING_KEY, "files is empty; name the files of the series.");
    }
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        char name[sizeof(waves->file)];
        yaml_node_t* item = swGetYamlItem(yaml, keys->list, i);
        swResult own = swReadYamlText(yaml, item, "files", name, sizeof(name));
        own = own == SW_SUCCESS ? addFile(yaml, keys, item, name, &waves->measured) : own;
        result = swKeepFailure(result, own);
        if (i == 0 && own == SW_SUCCESS)
        {
            memcpy(waves->file, name, sizeof(waves->file));
        }
    }
    return result;
}

// All records of one place in a sea of their own.
static swResult readSeries(swYaml* yaml, const swMeasuredKeys* keys, swSceneWaves* waves)
{
    swResult result = addFiles(yaml, keys, waves);
    if (result == SW_SUCCESS)
    {
        result = swMeasuredSea_Finish(waves->measured);
        if (result == SW_ERROR_FORMAT)
        {
            swFailYaml(yaml, keys->file != NULL ? keys->file : keys->list, SW_MISTAKE_NO_RECORD,
                       "no record is left of which a sea could be made.");
        }
    }
    return result;
}

// ---- what is made of it ----

static swResult chooseRecord(swYaml* yaml, const swMeasuredKeys* keys, int location, swSceneWaves* waves)
{
    waves->record = swMeasuredSea_FindRecord(waves->measured, location, NULL);
    if (waves->record < 0)
    {
        return swFailYaml(yaml, keys->location, SW_MISTAKE_NO_RECORD, "location '%s' has no record; choose another.",
                          keys->text->location);
    }
    double seconds = 0.0;
    if (keys->at != NULL && !swParseMeasuredTime(keys->text->at, &seconds))
    {
        return swFailYaml(yaml, keys->at, SW_MISTAKE_WRONG_FORM,
                          "at is '%s'; it must be a time such as 2022-05-10 10:50.", keys->text->at);
    }
    if (keys->at != NULL &&
        swMeasuredSea_ChooseRecord(waves->measured, location, keys->text->at, &waves->record) != SW_SUCCESS)
    {
        return swFailYaml(yaml, keys->at, SW_MISTAKE_NO_RECORD, "at is '%s', of which the file has no record.",
                          keys->text->at);
    }
    return SW_SUCCESS;
}

static swResult chooseRecords(swYaml* yaml, const swMeasuredKeys* keys, int location, swSceneWaves* waves)
{
    swMeasuredLocation place = swMeasuredSea_GetLocation(waves->measured, location);
    swMeasuredRecord first = swMeasuredSea_GetRecord(waves->measured, place.firstRecord);
    if (place.recordCount < 2 || first.time[0] == '\0')
    {
        return swFailYaml(yaml, keys->replay, SW_MISTAKE_NO_RECORD,
                          "a replay needs records of at least two times; there %s.",
                          place.recordCount > 1 ? "are no times" : "is one");
    }
    waves->isReplay = true;
    waves->record = place.firstRecord;
    waves->replay = swDefaultSeaReplayDef();
    waves->replay.sea = waves->measured;
    waves->replay.location = location;
    waves->replay.startTime = keys->text->replayTime;
    waves->replay.startSeconds = first.seconds;
    waves->replay.speed = keys->text->replaySpeed;
    if (keys->from != NULL && !swParseMeasuredTime(keys->text->from, &waves->replay.startSeconds))
    {
        return swFailYaml(yaml, keys->from, SW_MISTAKE_WRONG_FORM,
                          "from is '%s'; it must be a time such as 2022-05-10 10:50.", keys->text->from);
    }
    int start = 0;
    if (keys->from != NULL &&
        swMeasuredSea_ChooseRecord(waves->measured, location, keys->text->from, &start) != SW_SUCCESS)
    {
        return swFailYaml(yaml, keys->from, SW_MISTAKE_NO_RECORD, "from is '%s', of which there is no record.",
                          keys->text->from);
    }
    return SW_SUCCESS;
}

// Keys that do not go together.
static swResult checkText(swYaml* yaml, const swMeasuredKeys* keys, const swSceneWaves* waves)
{
    swResult result = SW_SUCCESS;
    if (keys->file == NULL && keys->list == NULL)
    {
        result =
            swFailYaml(yaml, keys->system, SW_MISTAKE_MISSING_KEY,
                       "a spectrum 'file' needs the key file with the name of an NDBC energy file or summary, or of "
                       "any other measured sea, or a list of files.");
    }
    if (keys->file != NULL && keys->list != NULL)
    {
        result = swFailYaml(yaml, keys->list, SW_MISTAKE_CONFLICT,
                            "file and files both name what to read; keep one of them.");
    }
    if (keys->replay != NULL && keys->at != NULL)
    {
        result = swFailYaml(yaml, keys->at, SW_MISTAKE_CONFLICT,
                            "at chooses one record, but all are replayed; say replay: {from: %s}.", keys->text->at);
    }
    if (keys->replay != NULL && waves->def.method != SW_WAVES_FFT)
    {
        result = swFailYaml(yaml, keys->method, SW_MISTAKE_CONFLICT, "a replay needs 'method: fft'; remove this.");
    }
    return result;
}

static swResult useRecord(swYaml* yaml, const swMeasuredKeys* keys, swSceneWaves* waves)
{
    swMeasuredRecord record = swMeasuredSea_GetRecord(waves->measured, waves->record);
    waves->table = record.table;
    waves->def.spectrum.table = &waves->table;
    swSeaState seaState;
    if (swSpectrum_GetSeaState(&waves->def.spectrum, 0.0f, 0.0f, &seaState) != SW_SUCCESS)
    {
        return swFailYaml(yaml, keys->file != NULL ? keys->file : keys->list, SW_MISTAKE_NO_ENERGY,
                          "the record of %s in %s has no energy; choose another with at.", record.time, waves->file);
    }
    if (record.meanDirection == NULL)
    {
        swLog(yaml->host, SW_LOG_WARNING,
              "%s:%d: the record of %s in %s has no directions: its waves are made around east, spread as cos^16 of "
              "half the angle. [no_directions]",
              yaml->name, waves->line, record.time, waves->file);
    }
    return SW_SUCCESS;
}

swResult swReadSceneMeasured(swYaml* yaml, const swMeasuredKeys* keys, swSceneWaves* waves)
{
    bool isReplay = keys->replay != NULL;
    int location = 0;
    swResult result = checkText(yaml, keys, waves);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    memcpy(waves->file, keys->text->file, sizeof(waves->file));
    if (keys->opensNone)
    {
        waves->isReplay = isReplay;
        return SW_SUCCESS;
    }
    bool isSeries = keys->list != NULL;
    if (!isSeries)
    {
        result = readFile(yaml, keys, keys->file, keys->text->file, &waves->measured);
        result =
            result == SW_SUCCESS ? choosePlace(yaml, keys, keys->file, waves->measured, isReplay, &location) : result;
        if (result == SW_SUCCESS && isReplay && countCalms(waves->measured, location) > 0)
        {
            swDestroyMeasuredSea(waves->measured);
            waves->measured = NULL;
            isSeries = true;
        }
    }
    if (isSeries)
    {
        result = readSeries(yaml, keys, waves);
        location = 0;
    }
    if (result == SW_SUCCESS)
    {
        result = isReplay ? chooseRecords(yaml, keys, location, waves) : chooseRecord(yaml, keys, location, waves);
    }
    return result == SW_SUCCESS ? useRecord(yaml, keys, waves) : result;
}

void swChooseReplayRecords(swScene* scene)
{
    for (int i = 0; i < scene->wavesCount; ++i)
    {
        swSceneWaves* waves = &scene->waves[i];
        const swSeaReplayDef* replay = &waves->replay;
        double seconds = replay->startSeconds + (scene->time - replay->startTime) * replay->speed;
        int before = 0, after = 0;
        double fraction = 0.0;
        if (waves->isReplay && replay->sea != NULL &&
            swMeasuredSea_Bracket(replay->sea, replay->location, seconds, &before, &after, &fraction))
        {
            waves->record = fraction < 0.5 ? before : after;
            waves->table = swMeasuredSea_GetRecord(waves->measured, waves->record).table;
        }
    }
}
