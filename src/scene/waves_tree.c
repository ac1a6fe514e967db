// SPDX-License-Identifier: MIT
// A wave system as keys and values, in the way in which its kind is told: one number and what goes beside it, a list of
// waves or octaves, a file, or the fields of a spectrum.

#include "scene/waves_tree.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/date.h"
#include "core/base/field.h"
#include "scene/field_tree.h"
#include "scene/scene_octaves.h"
#include "scene/scene_waves.h"

static void addOctaves(swTree* tree, int parent, const swWavesWriter* writer)
{
    const swSpectrumDef* spectrum = &writer->waves->def.spectrum;
    const swFields* fields = swGetOctaveFields();
    const swField* power = swFields_Find(fields, "power");
    swSpectrumDef start = *spectrum;
    swStartOctaves(&writer->text.octaves, &start);
    int list = swAddTreeNode(tree, parent, SW_TREE_LIST, "octaves");
    for (int item = 0; item <= SW_OCTAVE_COUNT && !tree->isBroken; ++item)
    {
        for (int i = 0; i < SW_OCTAVE_COUNT && !tree->isBroken; ++i)
        {
            const swOctaveText* given = &writer->text.octaves.octaves[i];
            if ((item < SW_OCTAVE_COUNT && given->item != item) || (item == SW_OCTAVE_COUNT && given->item >= 0))
            {
                continue; // those of the file first, as they stand there
            }
            swOctave usual = start.octaves.octaves[i];
            const swOctave* octave = &spectrum->octaves.octaves[i];
            bool hasPower = (given->given >> (power - fields->fields) & 1u) != 0 || octave->power != usual.power;
            usual.isEnabled = usual.isEnabled || hasPower;
            if (given->item < 0 && swIsSameDef(fields, octave, &start.octaves.octaves[i]))
            {
                continue;
            }
            int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
            swSetTreeItem(tree, node, given->item, true);
            swOctaveText named = {.wavelength = ldexpf(1.0f, i - 4)};
            int wavelength = swAddField(tree, node, &swGetOctaveTextFields()->fields[0], &named, NULL);
            swSetTreeDefault(tree, wavelength, false);
            for (int j = 0; j < fields->count && !tree->isBroken; ++j)
            {
                swAddField(tree, node, &fields->fields[j], octave, &usual);
            }
        }
    }
    if (tree->isBroken)
    {
        return;
    }
    swOctaves shown = spectrum->octaves, usual = start.octaves;
    shown.multiplier = start.octaves.multiplier != 0.0f ? shown.multiplier / start.octaves.multiplier : 1.0f;
    usual.multiplier = 1.0f;
    fields = swGetOctavesFields();
    for (int j = 0; j < fields->count; ++j)
    {
        const swField* field = &fields->fields[j];
        if (field->type < SW_FIELD_DEF && field->key != NULL)
        {
            swAddField(tree, parent, field, &shown, &usual);
        }
    }
}

static void addComponents(swTree* tree, int parent, const swWaveSystemDef* def)
{
    int list = swAddTreeNode(tree, parent, SW_TREE_LIST, "components");
    for (int i = 0; i < def->componentCount && !tree->isBroken; ++i)
    {
        int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
        swSetTreeItem(tree, node, -1, true);
        swAddFields(tree, node, swGetWaveComponentFields(), &def->components[i], "components");
        for (int child = node >= 0 ? swGetTreeNode(tree, node)->first : -1; child >= 0;
             child = swGetTreeNode(tree, child)->next)
        {
            bool isOptional = strcmp(swGetTreeNode(tree, child)->key, "phase_deg") == 0;
            swSetTreeDefault(tree, child, isOptional && swGetTreeNode(tree, child)->isDefault);
        }
    }
    swSetTreeMain(tree, list);
    swSetTreeMatched(tree, list);
}

static void printSeconds(double seconds, char text[32])
{
    int64_t minutes = (int64_t)floor(seconds / 60.0);
    double rest = seconds - 60.0 * (double)minutes;
    swPrintMinutes(minutes, text);
    if (rest != 0.0)
    {
        char printed[24];
        snprintf(printed, sizeof(printed), ":%09.6f", rest);
        printed[3] = '.'; // whatever the locale has
        text[10] = 'T';
        snprintf(text + 16, 16, "%.10s", printed);
    }
}

static void addPlace(swTree* tree, int parent, const swWavesWriter* writer)
{
    const swMeasuredText* text = &writer->text.measured;
    const swSceneWaves* waves = writer->waves;
    int location = -1, before = -1;
    if (waves->measured != NULL && waves->isReplay)
    {
        location = waves->replay.location;
        before = writer->replay->location;
    }
    else if (waves->measured != NULL && swMeasuredSea_GetLocationCount(waves->measured) > 1)
    {
        bool isSame = !writer->isNew && waves->record == writer->record; // then what the file says is right
        location = isSame ? -1 : swMeasuredSea_GetRecord(waves->measured, waves->record).location;
    }
    if (location != before || (writer->isNew && location >= 0))
    {
        char number[64];
        swMeasuredLocation place = swMeasuredSea_GetLocation(waves->measured, location);
        bool isNamed = place.name[0] != '\0' && swMeasuredSea_FindLocation(waves->measured, place.name) == location;
        snprintf(number, sizeof(number), "%d", location + 1);
        swAddTreeText(tree, parent, "location", isNamed ? place.name : number, false);
        return;
    }
    const swFields* fields = swGetMeasuredTextFields();
    if (writer->text.hasLocation)
    {
        swAddField(tree, parent, swFields_Find(fields, "location"), text, NULL);
    }
    if (writer->text.hasPlace)
    {
        swAddField(tree, parent, swFields_Find(fields, "latitude"), text, NULL);
        swAddField(tree, parent, swFields_Find(fields, "longitude"), text, NULL);
    }
}

static void addReplay(swTree* tree, int parent, const swWavesWriter* writer)
{
    const swSeaReplayDef *replay = &writer->waves->replay, *before = writer->replay;
    swMeasuredText text = writer->text.measured;
    bool isKnown = writer->waves->measured != NULL; // otherwise the text alone tells
    if (isKnown && (writer->isNew || replay->startTime != before->startTime))
    {
        text.replayTime = replay->startTime;
    }
    if (isKnown && (writer->isNew || replay->speed != before->speed))
    {
        text.replaySpeed = replay->speed;
    }
    int node = swAddTreeNode(tree, parent, SW_TREE_MAPPING, "replay");
    bool isMoved = isKnown && (writer->isNew || replay->startSeconds != before->startSeconds);
    if (isMoved && isfinite(replay->startSeconds))
    {
        printSeconds(replay->startSeconds, text.from);
        swAddTreeText(tree, node, "from", text.from, false);
    }
    else if (writer->text.hasFrom)
    {
        swAddTreeText(tree, node, "from", text.from, false);
    }
    const swFields* fields = swGetMeasuredTextFields();
    swAddField(tree, node, swFields_Find(fields, "replayTime"), &text, NULL);
    int speed = swAddField(tree, node, swFields_Find(fields, "replaySpeed"), &text, NULL);
    if (!isMoved && !writer->text.hasFrom)
    {
        swSetTreeDefault(tree, speed, false); // a replay that says nothing is none
    }
}

static void addMeasured(swTree* tree, int parent, const swWavesWriter* writer)
{
    const swSceneWaves* waves = writer->waves;
    const swMeasuredText* text = &writer->text.measured;
    const swFields* fields = swGetMeasuredTextFields();
    if (text->file[0] != '\0')
    {
        swAddTreeText(tree, parent, "file", text->file, false);
    }
    else
    {
        swAddTreeNode(tree, parent, SW_TREE_LIST, "files"); // stays as it is
    }
    addPlace(tree, parent, writer);
    if (writer->text.hasDirections)
    {
        swSetTreeDefault(tree, swAddField(tree, parent, swFields_Find(fields, "directions"), text, NULL), false);
    }
    if (waves->isReplay)
    {
        addReplay(tree, parent, writer);
        return;
    }
    bool isChanged = waves->measured != NULL && (writer->isNew || waves->record != writer->record);
    if (isChanged)
    {
        char time[32] = "";
        swMeasuredRecord record = swMeasuredSea_GetRecord(waves->measured, waves->record);
        printSeconds(record.seconds, time);
        if (record.time[0] != '\0')
        {
            swAddTreeText(tree, parent, "at", time, false);
        }
    }
    else if (writer->text.hasAt)
    {
        swAddTreeText(tree, parent, "at", text->at, false);
    }
}

// What the spectrum is where the file names nothing but the kind and what the knobs take.
static swSpectrumDef makeUsual(const swWavesWriter* writer)
{
    const swWavesText* text = &writer->text;
    const swSpectrumDef* spectrum = &writer->waves->def.spectrum;
    switch (text->kind)
    {
    case SW_WAVES_BEAUFORT:
        return swMakeBeaufortSpectrum(text->beaufort, 0.0f);
    case SW_WAVES_SEA_STATE:
        return swMakeSeaStateSpectrum(text->seaState, 0.0f);
    case SW_WAVES_SWELL:
        return swMakeSwellSpectrum(spectrum->significantHeight, spectrum->peakPeriod, 0.0f, text->spread);
    case SW_WAVES_WIND_SEA:
        return swMakeWindSeaSpectrum(text->def.spectrum.windSpeed, INFINITY, INFINITY, 0.0f);
    default:
        return swDefaultSpectrumDef();
    }
}

static void addSpectrum(swTree* tree, int parent, const swWavesWriter* writer)
{
    const swFields* fields = swGetSpectrumFields();
    const swSpectrumDef* spectrum = &writer->waves->def.spectrum;
    int kind = writer->text.kind;
    swSpectrumDef usual = makeUsual(writer);
    bool isFormula = kind < SW_SPECTRUM_KIND_COUNT, isWindSea = kind == SW_WAVES_WIND_SEA;
    bool hasWind = isFormula && (spectrum->hasWind || spectrum->windSpeed != usual.windSpeed);
    for (int i = 0; i < fields->count && !tree->isBroken; ++i)
    {
        const swField* field = &fields->fields[i];
        if (field->key == NULL || field->type >= SW_FIELD_DEF || i == fields->kind ||
            !swGoesWithWaves(field->key, kind))
        {
            continue;
        }
        bool isWind = strcmp(field->member, "windSpeed") == 0, isKnown = strcmp(field->member, "hasWind") == 0;
        bool isFetch = strcmp(field->member, "fetch") == 0, isGrowth = strcmp(field->member, "growth") == 0;
        bool isExponent = strcmp(field->member, "spreadExponent") == 0;
        bool isHeight = strcmp(field->member, "significantHeight") == 0 || strcmp(field->member, "peakPeriod") == 0;
        if ((isWindSea && isFetch && !writer->text.hasFetch) || (isGrowth && spectrum->peakPeriod > 0.0f) ||
            (isExponent && spectrum->spreading != SW_SPREADING_COSINE_2S))
        {
            continue; // it would have no effect, and be refused
        }
        bool isOfText = isWindSea && (isWind || isFetch); // what the knobs make of it is another
        int node =
            swAddField(tree, parent, field, isOfText ? &writer->text.def.spectrum : spectrum, isOfText ? NULL : &usual);
        if (isWind && isFormula)
        {
            swSetTreeDefault(tree, node, !hasWind);
        }
        else if (isKnown)
        {
            swSetTreeDefault(tree, node, spectrum->hasWind == (hasWind || writer->text.hasWindSpeed));
        }
        else if ((isFetch && isWindSea) || (isHeight && kind == SW_WAVES_SWELL))
        {
            swSetTreeDefault(tree, node, false);
        }
    }
}

static void addKind(swTree* tree, int parent, const swWavesWriter* writer)
{
    const swFields* fields = swGetWavesTextFields();
    switch (writer->text.kind)
    {
    case SW_WAVES_BEAUFORT:
        swSetTreeMain(tree, swAddField(tree, parent, swFields_Find(fields, "beaufort"), &writer->text, NULL));
        break;
    case SW_WAVES_SEA_STATE:
        swSetTreeMain(tree, swAddField(tree, parent, swFields_Find(fields, "seaState"), &writer->text, NULL));
        break;
    case SW_WAVES_COMPONENTS:
        addComponents(tree, parent, &writer->waves->def);
        break;
    default:
        swSetTreeMain(tree, swAddTreeText(tree, parent, "spectrum", swGetWavesWord(writer->text.kind), false));
        break;
    }
}

static void addKnobs(swTree* tree, int parent, const swWavesWriter* writer)
{
    const swFields* fields = swGetWavesTextFields();
    if (writer->text.kind == SW_WAVES_WIND_SEA && writer->text.hasDuration)
    {
        swSetTreeDefault(tree, swAddField(tree, parent, swFields_Find(fields, "durationHours"), &writer->text, NULL),
                         false);
    }
    if (writer->text.kind == SW_WAVES_SWELL)
    {
        swAddField(tree, parent, swFields_Find(fields, "spread"), &writer->text, NULL);
    }
    if (writer->text.kind == SW_SPECTRUM_TABLE)
    {
        swWavesText turned = writer->text;
        turned.def.spectrum.direction = writer->waves->def.spectrum.direction;
        for (int i = 0; i < fields->count; ++i)
        {
            if (strcmp(fields->fields[i].key, "turn_deg") == 0)
            {
                swAddField(tree, parent, &fields->fields[i], &turned, NULL);
            }
        }
    }
    if (writer->text.kind == SW_SPECTRUM_OCTAVES)
    {
        for (int i = 0; i < fields->count; ++i)
        {
            if (strcmp(fields->fields[i].key, "octaves_from") == 0)
            {
                swAddField(tree, parent, &fields->fields[i], &writer->text, NULL);
            }
        }
    }
}

// The pairs of one wave system.
void swFillWavesTree(swTree* tree, int parent, const swWavesWriter* writer)
{
    const swFields* fields = swGetWaveSystemFields();
    const swWaveSystemDef* def = &writer->waves->def;
    int kind = writer->text.kind;
    addKind(tree, parent, writer);
    addKnobs(tree, parent, writer);
    if (kind == SW_SPECTRUM_TABLE)
    {
        addMeasured(tree, parent, writer);
    }
    addSpectrum(tree, parent, writer);
    if (kind == SW_SPECTRUM_OCTAVES)
    {
        addOctaves(tree, parent, writer);
    }
    for (int i = 0; i < fields->count && !tree->isBroken; ++i)
    {
        const swField* field = &fields->fields[i];
        if (field->type < SW_FIELD_DEF && field->key != NULL && swGoesWithWaves(field->key, kind) &&
            swFields_Counts(fields, field, def))
        {
            int node = swAddField(tree, parent, field, def, NULL);
            bool isGiven = i == fields->kind && kind == SW_WAVES_COMPONENTS;
            swSetTreeDefault(tree, node, isGiven || (node >= 0 && swGetTreeNode(tree, node)->isDefault));
        }
    }
}
