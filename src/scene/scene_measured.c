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

const char* const swDirectionWords[] = {"from", "to", NULL};

enum
{
    FROM,
    TIME,
    SPEED
};

static const swYamlField replayFields[] = {
    [FROM] = {.key = "from", .type = SW_YAML_TEXT, .offset = offsetof(swMeasuredText, from), .size = 32},
    [TIME] = {.key = "time_s",
              .type = SW_YAML_DOUBLE,
              .offset = offsetof(swMeasuredText, replayTime),
              .low = -SW_LARGEST_TIME,
              .high = SW_LARGEST_TIME},
    [SPEED] = {.key = "speed",
               .type = SW_YAML_DOUBLE,
               .offset = offsetof(swMeasuredText, replaySpeed),
               .low = -1e6,
               .high = 1e6},
};

swResult swReadReplay(swYaml* yaml, yaml_node_t* node, swMeasuredText* text)
{
    text->replaySpeed = 1.0;
    swYamlNodes nodes;
    swResult result = swReadYamlMapping(yaml, node, "replay", replayFields, SW_YAML_COUNT(replayFields), text, &nodes);
    text->fromNode = nodes.nodes[FROM];
    return result;
}

// ---- one file ----

// False if there is no room for it.
static bool joinPath(char* path, size_t size, const char* folder, const char* file)
{
    bool isAlone = file[0] == '/' || folder == NULL || folder[0] == '\0';
    return (size_t)snprintf(path, size, "%s%s%s", isAlone ? "" : folder, isAlone ? "" : "/", file) < size;
}

static swResult readFile(swYaml* yaml, const swMeasuredText* text, const yaml_node_t* node, const char* file,
                         swMeasuredSea** sea)
{
    char path[SW_MAX_PATH];
    if (!joinPath(path, sizeof(path), text->folder, file))
    {
        return swFailYaml(yaml, node, SW_MISTAKE_TOO_LARGE,
                          "the path of %s has more than %d bytes; move the scene or the file.", file, SW_MAX_PATH - 1);
    }
    swMeasuredFileDef def = swDefaultMeasuredFileDef();
    if (text->directionsNode != NULL)
    {
        def.directions = text->directions == 0 ? SW_DIRECTIONS_FROM : SW_DIRECTIONS_TO;
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
static swResult chooseNearest(swYaml* yaml, const swMeasuredText* text, const swMeasuredSea* sea, int* location)
{
    const yaml_node_t* node = text->latitudeNode != NULL ? text->latitudeNode : text->longitudeNode;
    if (text->latitudeNode == NULL || text->longitudeNode == NULL)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_MISSING_KEY, "latitude and longitude belong together; give both.");
    }
    if (text->locationNode != NULL)
    {
        return swFailYaml(yaml, node, SW_MISTAKE_CONFLICT,
                          "location and latitude both choose a place; keep one of them.");
    }
    swResult result = swMeasuredSea_ChooseNearest(sea, text->longitude, text->latitude, location, NULL);
    return result == SW_SUCCESS
               ? result
               : swFailYaml(yaml, node, SW_MISTAKE_NO_RECORD, "no place of the file is near latitude %g, longitude %g.",
                            text->latitude, text->longitude);
}

// The place that is asked for; without one -1, if the waves may be of any.
static swResult choosePlace(swYaml* yaml, const swMeasuredText* text, const yaml_node_t* fileNode,
                            const swMeasuredSea* sea, bool needsOne, int* location)
{
    if (text->latitudeNode != NULL || text->longitudeNode != NULL)
    {
        return chooseNearest(yaml, text, sea, location);
    }
    char places[400] = "";
    listPlaces(sea, places, sizeof(places));
    *location = text->locationNode != NULL ? swFindMeasuredPlace(sea, text->location) : -1;
    if (text->locationNode != NULL && *location < 0)
    {
        return swFailYaml(yaml, text->locationNode, SW_MISTAKE_UNKNOWN_WORD,
                          "location is '%s'; it must be the name or number of a place of the file, which has: %s.",
                          text->location, places);
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
static swResult addFile(swYaml* yaml, const swMeasuredText* text, const yaml_node_t* node, const char* file,
                        swMeasuredSea** series)
{
    swMeasuredSea* sea = NULL;
    int location = 0;
    swResult result = readFile(yaml, text, node, file, &sea);
    result = result == SW_SUCCESS ? choosePlace(yaml, text, node, sea, true, &location) : result;
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
        int calms = text->replayNode != NULL ? countCalms(sea, location) : 0;
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

static swResult addFiles(swYaml* yaml, const swMeasuredText* text, swSceneWaves* waves)
{
    if (text->listNode == NULL)
    {
        return addFile(yaml, text, text->fileNode, text->file, &waves->measured);
    }
    static const swYamlField itemField = {.key = "files", .type = SW_YAML_TEXT, .size = sizeof(waves->file)};
    int count = 0;
    swResult result = swReadYamlList(yaml, text->listNode, "files", MAX_FILES, &count);
    if (result == SW_SUCCESS && count == 0)
    {
        result =
            swFailYaml(yaml, text->listNode, SW_MISTAKE_MISSING_KEY, "files is empty; name the files of the series.");
    }
    for (int i = 0; i < count && !swIsYamlOver(yaml, result); ++i)
    {
        char name[sizeof(waves->file)];
        yaml_node_t* item = swGetYamlItem(yaml, text->listNode, i);
        swResult own = swReadYamlText(yaml, item, &itemField, name);
        own = own == SW_SUCCESS ? addFile(yaml, text, item, name, &waves->measured) : own;
        result = swKeepFailure(result, own);
        if (i == 0 && own == SW_SUCCESS)
        {
            memcpy(waves->file, name, sizeof(waves->file));
        }
    }
    return result;
}

// All records of one place in a sea of their own.
static swResult readSeries(swYaml* yaml, const swMeasuredText* text, swSceneWaves* waves)
{
    swResult result = addFiles(yaml, text, waves);
    if (result == SW_SUCCESS)
    {
        result = swMeasuredSea_Finish(waves->measured);
        if (result == SW_ERROR_FORMAT)
        {
            swFailYaml(yaml, text->fileNode != NULL ? text->fileNode : text->listNode, SW_MISTAKE_NO_RECORD,
                       "no record is left of which a sea could be made.");
        }
    }
    return result;
}

// ---- what is made of it ----

static swResult chooseRecord(swYaml* yaml, const swMeasuredText* text, int location, swSceneWaves* waves)
{
    waves->record = swMeasuredSea_FindRecord(waves->measured, location, NULL);
    if (waves->record < 0)
    {
        return swFailYaml(yaml, text->locationNode, SW_MISTAKE_NO_RECORD,
                          "location '%s' has no record; choose another.", text->location);
    }
    double seconds = 0.0;
    if (text->atNode != NULL && !swParseMeasuredTime(text->at, &seconds))
    {
        return swFailYaml(yaml, text->atNode, SW_MISTAKE_WRONG_FORM,
                          "at is '%s'; it must be a time such as 2022-05-10 10:50.", text->at);
    }
    if (text->atNode != NULL &&
        swMeasuredSea_ChooseRecord(waves->measured, location, text->at, &waves->record) != SW_SUCCESS)
    {
        return swFailYaml(yaml, text->atNode, SW_MISTAKE_NO_RECORD, "at is '%s', of which the file has no record.",
                          text->at);
    }
    return SW_SUCCESS;
}

static swResult chooseRecords(swYaml* yaml, const swMeasuredText* text, int location, swSceneWaves* waves)
{
    swMeasuredLocation place = swMeasuredSea_GetLocation(waves->measured, location);
    swMeasuredRecord first = swMeasuredSea_GetRecord(waves->measured, place.firstRecord);
    if (place.recordCount < 2 || first.time[0] == '\0')
    {
        return swFailYaml(yaml, text->replayNode, SW_MISTAKE_NO_RECORD,
                          "a replay needs records of at least two times; there %s.",
                          place.recordCount > 1 ? "are no times" : "is one");
    }
    waves->isReplay = true;
    waves->record = place.firstRecord;
    waves->replay = swDefaultSeaReplayDef();
    waves->replay.sea = waves->measured;
    waves->replay.location = location;
    waves->replay.startTime = text->replayTime;
    waves->replay.startSeconds = first.seconds;
    waves->replay.speed = text->replaySpeed;
    if (text->fromNode != NULL && !swParseMeasuredTime(text->from, &waves->replay.startSeconds))
    {
        return swFailYaml(yaml, text->fromNode, SW_MISTAKE_WRONG_FORM,
                          "from is '%s'; it must be a time such as 2022-05-10 10:50.", text->from);
    }
    int start = 0;
    if (text->fromNode != NULL &&
        swMeasuredSea_ChooseRecord(waves->measured, location, text->from, &start) != SW_SUCCESS)
    {
        return swFailYaml(yaml, text->fromNode, SW_MISTAKE_NO_RECORD, "from is '%s', of which there is no record.",
                          text->from);
    }
    return SW_SUCCESS;
}

// Keys that do not go together.
static swResult checkText(swYaml* yaml, const swMeasuredText* text, const swSceneWaves* waves)
{
    swResult result = SW_SUCCESS;
    if (text->fileNode == NULL && text->listNode == NULL)
    {
        result =
            swFailYaml(yaml, text->system, SW_MISTAKE_MISSING_KEY,
                       "a spectrum 'file' needs the key file with the name of an NDBC energy file or summary, or of "
                       "any other measured sea, or a list of files.");
    }
    if (text->fileNode != NULL && text->listNode != NULL)
    {
        result = swFailYaml(yaml, text->listNode, SW_MISTAKE_CONFLICT,
                            "file and files both name what to read; keep one of them.");
    }
    if (text->replayNode != NULL && text->atNode != NULL)
    {
        result = swFailYaml(yaml, text->atNode, SW_MISTAKE_CONFLICT,
                            "at chooses one record, but all are replayed; say replay: {from: %s}.", text->at);
    }
    if (text->replayNode != NULL && waves->def.method != SW_WAVES_FFT)
    {
        result = swFailYaml(yaml, text->methodNode, SW_MISTAKE_CONFLICT, "a replay needs 'method: fft'; remove this.");
    }
    return result;
}

static swResult useRecord(swYaml* yaml, const swMeasuredText* text, swSceneWaves* waves)
{
    swMeasuredRecord record = swMeasuredSea_GetRecord(waves->measured, waves->record);
    waves->table = record.table;
    waves->def.spectrum.table = &waves->table;
    swSeaState seaState;
    if (swSpectrum_GetSeaState(&waves->def.spectrum, 0.0f, 0.0f, &seaState) != SW_SUCCESS)
    {
        return swFailYaml(yaml, text->fileNode != NULL ? text->fileNode : text->listNode, SW_MISTAKE_NO_ENERGY,
                          "the record of %s in %s has no energy; choose another with at.", record.time, waves->file);
    }
    if (record.meanDirection == NULL)
    {
        swLog(yaml->host, SW_LOG_WARNING,
              "%s: the record of %s in %s has no directions: its waves are made around east, spread as cos^16 of half "
              "the "
              "angle.",
              yaml->name, record.time, waves->file);
    }
    return SW_SUCCESS;
}

swResult swReadSceneMeasured(swYaml* yaml, const swMeasuredText* text, swSceneWaves* waves)
{
    bool isReplay = text->replayNode != NULL;
    int location = 0;
    swResult result = checkText(yaml, text, waves);
    if (result != SW_SUCCESS)
    {
        return result;
    }
    memcpy(waves->file, text->file, sizeof(waves->file));
    bool isSeries = text->listNode != NULL;
    if (!isSeries)
    {
        result = readFile(yaml, text, text->fileNode, text->file, &waves->measured);
        result = result == SW_SUCCESS ? choosePlace(yaml, text, text->fileNode, waves->measured, isReplay, &location)
                                      : result;
        if (result == SW_SUCCESS && isReplay && countCalms(waves->measured, location) > 0)
        {
            swDestroyMeasuredSea(waves->measured);
            waves->measured = NULL;
            isSeries = true;
        }
    }
    if (isSeries)
    {
        result = readSeries(yaml, text, waves);
        location = 0;
    }
    if (result == SW_SUCCESS)
    {
        result = isReplay ? chooseRecords(yaml, text, location, waves) : chooseRecord(yaml, text, location, waves);
    }
    return result == SW_SUCCESS ? useRecord(yaml, text, waves) : result;
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
        if (waves->isReplay &&
            swMeasuredSea_Bracket(replay->sea, replay->location, seconds, &before, &after, &fraction))
        {
            waves->record = fraction < 0.5 ? before : after;
            waves->table = swMeasuredSea_GetRecord(waves->measured, waves->record).table;
        }
    }
}
