// SPDX-License-Identifier: MIT
// What a scene's file would say, by the tables of its defs. A number is the shortest text that is read as the same
// number again. Waves keep the way in which the file tells of them, such as `beaufort: 4`, as long as that makes the
// def that is wanted; otherwise every field is named.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/date.h"
#include "core/base/field.h"
#include "scene/exact_number.h"
#include "scene/scene_octaves.h"
#include "scene/scene_source.h"
#include "scene/scene_waves.h"

// ---- fields ----

static bool isFloat(const swField* field)
{
    return field->type == SW_FIELD_FLOAT || field->type == SW_FIELD_FLOATS;
}

static bool isReadAs(const swField* field, const char* text, double value)
{
    double shown = 0.0;
    if (!swParseExactNumber(text, (int)strlen(text), &shown))
    {
        return false;
    }
    double read = swField_Read(field, shown);
    return isFloat(field) ? (float)read == (float)value : read == value;
}

static bool printShown(const swField* field, double shown, double value, char text[SW_NUMBER_TEXT])
{
    for (int digits = 1; digits <= 17; ++digits)
    {
        swPrintDigits(shown, digits, text);
        if (isReadAs(field, text, value))
        {
            return true;
        }
    }
    return false;
}

// An angle beyond a turn is written as that within it, which is the same direction.
static void printNumber(const swField* field, double value, char text[SW_NUMBER_TEXT])
{
    double read = swField_Read(field, swField_Show(field, value));
    if (field->form != SW_FORM_PLAIN &&
        (printShown(field, 360.0, value, text) || printShown(field, -360.0, value, text)))
    {
        return; // a turn, which as a float is a little more than one
    }
    if (fabs(read - value) > 1.0 && field->form != SW_FORM_PLAIN && field->form != SW_FORM_COLOR)
    {
        value = isFloat(field) ? (double)(float)read : read;
    }
    double shown = swField_Show(field, value);
    bool isWrapped = field->form == SW_FORM_BEARING && shown < 0.0;
    if ((isWrapped && printShown(field, shown + 360.0, value, text)) || printShown(field, shown, value, text))
    {
        return;
    }
    swPrintDigits(shown, 17, text);
}

static bool isDefaultNumber(const swField* field, const void* def, const void* usual, int index)
{
    double value = swField_GetNumber(field, def, index);
    double other = usual != NULL ? swField_GetNumber(field, usual, index) : field->defaults[index];
    return isFloat(field) ? (float)value == (float)other : value == other;
}

// A field of a def; `usual` is what the def has where a file says nothing, NULL that of the table. Numbers without end
// have no text: they are what is meant where the key is missing.
static int addField(swTree* tree, int parent, const swField* field, const void* def, const void* usual)
{
    char text[SW_NUMBER_TEXT] = "";
    bool isNumbers = field->type == SW_FIELD_FLOATS || field->type == SW_FIELD_DOUBLES;
    if (field->type == SW_FIELD_TEXT)
    {
        const char* value = (const char*)def + field->offset;
        return value[0] != '\0' ? swAddTreeText(tree, parent, field->key, value, false) : -1;
    }
    if (field->type == SW_FIELD_BOOL || field->type == SW_FIELD_CHOICE)
    {
        int value = (int)swField_GetNumber(field, def, 0);
        const char* word = field->type == SW_FIELD_CHOICE ? field->words[value] : value != 0 ? "true" : "false";
        return swAddTreeText(tree, parent, field->key, word, isDefaultNumber(field, def, usual, 0));
    }
    int list = isNumbers ? swAddTreeNode(tree, parent, SW_TREE_LIST, field->key) : -1;
    bool isDefault = true;
    for (int i = 0; i < field->count; ++i)
    {
        double value = swField_GetNumber(field, def, i);
        bool isUsual = isDefaultNumber(field, def, usual, i);
        isDefault = isDefault && isUsual;
        if (!(fabs(value) <= 1e300))
        {
            return -1;
        }
        printNumber(field, value, text);
        int node = swAddTreeText(tree, isNumbers ? list : parent, isNumbers ? NULL : field->key, text, isUsual);
        if (!isNumbers || node < 0)
        {
            return node;
        }
        ((swTreeNode*)tree->nodes.data)[node].item = i;
    }
    ((swTreeNode*)tree->nodes.data)[list].isLine = true;
    ((swTreeNode*)tree->nodes.data)[list].isDefault = isDefault;
    return list;
}

static void addFields(swTree* tree, int parent, const swFields* fields, const void* def, const char* section)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        const char* own = swGetFieldSection(fields, field);
        if (field->type == SW_FIELD_DEF)
        {
            addFields(tree, parent, field->fields, (const char*)def + field->offset, section);
        }
        else if (field->type < SW_FIELD_DEF && field->key != NULL && own != NULL && strcmp(own, section) == 0)
        {
            addField(tree, parent, field, def, NULL);
        }
    }
}

static void markNode(swTree* tree, int node, int item, bool isLine)
{
    if (node >= 0)
    {
        ((swTreeNode*)tree->nodes.data)[node].item = item;
        ((swTreeNode*)tree->nodes.data)[node].isLine = isLine;
    }
}

static void markMain(swTree* tree, int node)
{
    if (node >= 0)
    {
        ((swTreeNode*)tree->nodes.data)[node].isMain = true;
        ((swTreeNode*)tree->nodes.data)[node].isDefault = false;
    }
}

// ---- waves ----

// One system to be written, and how.
typedef struct WavesWriter
{
    const swScene* scene;
    const swSceneWaves* waves;
    swWavesText text; // the file's, or what a new system is told by
    int record;       // as it was read
    const swSeaReplayDef* replay;
    bool isNew;
    bool isBroken; // memory has run out
} WavesWriter;

static void addOctaves(swTree* tree, int parent, const WavesWriter* writer)
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
            markNode(tree, node, given->item, true);
            swOctaveText named = {.wavelength = ldexpf(1.0f, i - 4)};
            int wavelength = addField(tree, node, &swGetOctaveTextFields()->fields[0], &named, NULL);
            if (wavelength >= 0)
            {
                ((swTreeNode*)tree->nodes.data)[wavelength].isDefault = false;
            }
            for (int j = 0; j < fields->count && !tree->isBroken; ++j)
            {
                addField(tree, node, &fields->fields[j], octave, &usual);
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
            addField(tree, parent, field, &shown, &usual);
        }
    }
}

static void addComponents(swTree* tree, int parent, const swWaveSystemDef* def)
{
    int list = swAddTreeNode(tree, parent, SW_TREE_LIST, "components");
    for (int i = 0; i < def->componentCount && !tree->isBroken; ++i)
    {
        int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
        markNode(tree, node, -1, true);
        addFields(tree, node, swGetWaveComponentFields(), &def->components[i], "components");
        for (int child = node >= 0 ? swGetTreeNode(tree, node)->first : -1; child >= 0;
             child = swGetTreeNode(tree, child)->next)
        {
            bool isOptional = strcmp(swGetTreeNode(tree, child)->key, "phase_deg") == 0;
            ((swTreeNode*)tree->nodes.data)[child].isDefault &= isOptional;
        }
    }
    markMain(tree, list);
    if (list >= 0)
    {
        ((swTreeNode*)tree->nodes.data)[list].isMatched = true;
    }
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

static void addPlace(swTree* tree, int parent, const WavesWriter* writer)
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
        addField(tree, parent, swFields_Find(fields, "location"), text, NULL);
    }
    if (writer->text.hasPlace)
    {
        addField(tree, parent, swFields_Find(fields, "latitude"), text, NULL);
        addField(tree, parent, swFields_Find(fields, "longitude"), text, NULL);
    }
}

static void addReplay(swTree* tree, int parent, const WavesWriter* writer)
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
    addField(tree, node, swFields_Find(fields, "replayTime"), &text, NULL);
    int speed = addField(tree, node, swFields_Find(fields, "replaySpeed"), &text, NULL);
    if (speed >= 0 && !(isMoved || writer->text.hasFrom))
    {
        ((swTreeNode*)tree->nodes.data)[speed].isDefault = false; // a replay that says nothing is none
    }
}

static void addMeasured(swTree* tree, int parent, const WavesWriter* writer)
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
        int node = addField(tree, parent, swFields_Find(fields, "directions"), text, NULL);
        markMain(tree, node);
        if (node >= 0)
        {
            ((swTreeNode*)tree->nodes.data)[node].isMain = false;
        }
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
static swSpectrumDef makeUsual(const WavesWriter* writer)
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

static void setDefault(swTree* tree, int node, bool isDefault)
{
    if (node >= 0)
    {
        ((swTreeNode*)tree->nodes.data)[node].isDefault = isDefault;
    }
}

static void addSpectrum(swTree* tree, int parent, const WavesWriter* writer)
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
            addField(tree, parent, field, isOfText ? &writer->text.def.spectrum : spectrum, isOfText ? NULL : &usual);
        if (isWind && isFormula)
        {
            setDefault(tree, node, !hasWind);
        }
        else if (isKnown)
        {
            setDefault(tree, node, spectrum->hasWind == (hasWind || writer->text.hasWindSpeed));
        }
        else if ((isFetch && isWindSea) || (isHeight && kind == SW_WAVES_SWELL))
        {
            setDefault(tree, node, false);
        }
    }
}

static void addKind(swTree* tree, int parent, const WavesWriter* writer)
{
    const swFields* fields = swGetWavesTextFields();
    switch (writer->text.kind)
    {
    case SW_WAVES_BEAUFORT:
        markMain(tree, addField(tree, parent, swFields_Find(fields, "beaufort"), &writer->text, NULL));
        break;
    case SW_WAVES_SEA_STATE:
        markMain(tree, addField(tree, parent, swFields_Find(fields, "seaState"), &writer->text, NULL));
        break;
    case SW_WAVES_COMPONENTS:
        addComponents(tree, parent, &writer->waves->def);
        break;
    default:
        markMain(tree, swAddTreeText(tree, parent, "spectrum", swGetWavesWord(writer->text.kind), false));
        break;
    }
}

static void addKnobs(swTree* tree, int parent, const WavesWriter* writer)
{
    const swFields* fields = swGetWavesTextFields();
    if (writer->text.kind == SW_WAVES_WIND_SEA && writer->text.hasDuration)
    {
        setDefault(tree, addField(tree, parent, swFields_Find(fields, "durationHours"), &writer->text, NULL), false);
    }
    if (writer->text.kind == SW_WAVES_SWELL)
    {
        addField(tree, parent, swFields_Find(fields, "spread"), &writer->text, NULL);
    }
    if (writer->text.kind == SW_SPECTRUM_TABLE)
    {
        swWavesText turned = writer->text;
        turned.def.spectrum.direction = writer->waves->def.spectrum.direction;
        for (int i = 0; i < fields->count; ++i)
        {
            if (strcmp(fields->fields[i].key, "turn_deg") == 0)
            {
                addField(tree, parent, &fields->fields[i], &turned, NULL);
            }
        }
    }
    if (writer->text.kind == SW_SPECTRUM_OCTAVES)
    {
        for (int i = 0; i < fields->count; ++i)
        {
            if (strcmp(fields->fields[i].key, "octaves_from") == 0)
            {
                addField(tree, parent, &fields->fields[i], &writer->text, NULL);
            }
        }
    }
}

// The pairs of one wave system.
static void fillWaves(swTree* tree, int parent, const WavesWriter* writer)
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
            int node = addField(tree, parent, field, def, NULL);
            bool isGiven = i == fields->kind && kind == SW_WAVES_COMPONENTS;
            setDefault(tree, node, isGiven || (node >= 0 && swGetTreeNode(tree, node)->isDefault));
        }
    }
}

// ---- how waves are told ----

static void sayNothing(void* context, swLogLevel level, const char* message)
{
    (void)context;
    (void)level;
    (void)message;
}

// Whether a def is made of what is written of it. Directions are compared as they are written: a turn more is none.
// What has no effect beside the rest is not written.
static bool isSameDef(const swWaveSystemDef* def, const swWaveSystemDef* read)
{
    swWaveSystemDef other = *read;
    char wanted[SW_NUMBER_TEXT], found[SW_NUMBER_TEXT];
    const swField* direction = swFields_Find(swGetSpectrumFields(), "direction");
    printNumber(direction, (double)def->spectrum.direction, wanted);
    printNumber(direction, (double)other.spectrum.direction, found);
    other.spectrum.direction = strcmp(wanted, found) == 0 ? def->spectrum.direction : other.spectrum.direction;
    bool hasExponent = def->spectrum.spreading == SW_SPREADING_COSINE_2S;
    other.spectrum.spreadExponent = hasExponent ? other.spectrum.spreadExponent : def->spectrum.spreadExponent;
    other.spectrum.growth = def->spectrum.peakPeriod > 0.0f ? def->spectrum.growth : other.spectrum.growth;
    return swIsSameDef(swGetWaveSystemFields(), def, &other) &&
           swIsSameDef(swGetSpectrumFields(), &def->spectrum, &other.spectrum);
}

static bool isReadBack(WavesWriter* writer)
{
    swHost host = writer->scene->host;
    host.log = sayNothing;
    swTree tree = swBeginTree(&host, SW_TREE_MAPPING);
    int list = swAddTreeNode(&tree, 0, SW_TREE_LIST, "waves");
    int item = swAddTreeNode(&tree, list, SW_TREE_MAPPING, NULL);
    fillWaves(&tree, item, writer);
    swTextBuffer buffer = {.host = &host};
    swLayout layout = {"\n", 2};
    bool isSame = false;
    if (!tree.isBroken)
    {
        swAddTreePair(&buffer, &layout, &tree, list, 0);
    }
    swScene* read = NULL;
    swResult result = tree.isBroken || buffer.isBroken
                          ? SW_ERROR_NO_MEMORY
                          : swReadSceneKeys(&host, buffer.chars.data, buffer.chars.count, "waves", &read);
    writer->isBroken = writer->isBroken || result == SW_ERROR_NO_MEMORY;
    isSame = result == SW_SUCCESS && isSameDef(&writer->waves->def, &read->waves[0].def);
    swDestroyScene(read);
    swFreeItems(&host, &buffer.chars, 1);
    swFreeTree(&tree);
    return isSame;
}

// Beaufort's number of a spectrum, if that is what made it; written with as few digits as that takes.
static bool findBeaufort(WavesWriter* writer)
{
    double number = pow((double)writer->waves->def.spectrum.windSpeed / 0.836, 2.0 / 3.0);
    double scale = 1.0;
    writer->text.kind = SW_WAVES_BEAUFORT;
    for (int digits = 0; digits < 4 && number <= 12.0005; ++digits, scale *= 10.0)
    {
        writer->text.beaufort = (float)(round(number * scale) / scale);
        if (isReadBack(writer))
        {
            return true;
        }
    }
    return false;
}

// The file's way of telling if it makes the def, otherwise the kind with all its fields.
static void chooseForm(WavesWriter* writer)
{
    const swWaveSystemDef* def = &writer->waves->def;
    swWavesText before = writer->text;
    bool isKnob = before.kind >= SW_SPECTRUM_KIND_COUNT && before.kind != SW_WAVES_COMPONENTS;
    if (def->componentCount > 0)
    {
        writer->text.kind = SW_WAVES_COMPONENTS;
        return;
    }
    if (writer->waves->measured != NULL || def->spectrum.kind == SW_SPECTRUM_TABLE)
    {
        writer->text.kind = SW_SPECTRUM_TABLE;
        return;
    }
    if (!writer->isNew && (isKnob || before.kind == SW_SPECTRUM_OCTAVES) && isReadBack(writer))
    {
        return;
    }
    bool mayBeKnob = writer->isNew || before.kind == SW_WAVES_BEAUFORT;
    if (mayBeKnob && def->spectrum.kind == SW_SPECTRUM_JONSWAP && findBeaufort(writer))
    {
        return;
    }
    writer->text = before;
    writer->text.kind = def->spectrum.kind;
    if (writer->text.kind == SW_SPECTRUM_OCTAVES && !isReadBack(writer))
    {
        writer->text.octaves.start = 0;
    }
}

static void addWaves(swTree* tree, int list, const swScene* scene, int index, bool isAsRead)
{
    const swSceneWaves* waves = &scene->waves[index];
    int from = waves->item - 1;
    WavesWriter writer = {.scene = scene, .waves = waves, .isNew = from < 0};
    if (from >= 0)
    {
        writer.text = scene->source->waves[from];
        writer.record = scene->source->records[from];
        writer.replay = &scene->source->replays[from];
    }
    else
    {
        swFillDef(swGetWavesTextFields(), &writer.text);
        swFillDef(swGetMeasuredTextFields(), &writer.text.measured);
        snprintf(writer.text.measured.file, sizeof(writer.text.measured.file), "%s", waves->file);
        for (int i = 0; i < SW_OCTAVE_COUNT; ++i)
        {
            writer.text.octaves.octaves[i].item = -1;
        }
        writer.replay = &waves->replay;
    }
    if (!isAsRead)
    {
        chooseForm(&writer);
        tree->isBroken = tree->isBroken || writer.isBroken;
    }
    int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
    markNode(tree, node, from, false);
    fillWaves(tree, node, &writer);
}

// ---- the scene ----

static void addView(swTree* tree, int list, const swSceneView* view)
{
    const swFields* fields = swGetSceneViewFields();
    int node = swAddTreeNode(tree, list, SW_TREE_MAPPING, NULL);
    markNode(tree, node, view->item - 1, false);
    for (int i = 0; i < fields->count && !tree->isBroken; ++i)
    {
        const swField* field = &fields->fields[i];
        bool isSun = strncmp(field->member, "sun", 3) == 0;
        if (field->key != NULL && (view->hasSun || !isSun))
        {
            int child = addField(tree, node, field, view, NULL);
            setDefault(tree, child, !isSun && child >= 0 && swGetTreeNode(tree, child)->isDefault);
        }
    }
}

swTree swMakeSceneTree(const swScene* scene, bool isAsRead)
{
    const char* sections[SW_SCENE_MAX_SECTIONS];
    int count = swListSceneSections(sections);
    swTree tree = swBeginTree(&scene->host, SW_TREE_MAPPING);
    addFields(&tree, 0, swGetSceneFields(), scene, "scene");
    for (int i = 0; i < count && !tree.isBroken; ++i)
    {
        int node = swAddTreeNode(&tree, 0, SW_TREE_MAPPING, sections[i]);
        for (int j = 0; j < SW_SCENE_PART_COUNT && !tree.isBroken; ++j)
        {
            swScenePart part = swGetScenePart(j);
            addFields(&tree, node, part.fields, (const char*)scene + part.offset, sections[i]);
        }
    }
    int list = swAddTreeNode(&tree, 0, SW_TREE_LIST, "waves");
    for (int i = 0; i < scene->wavesCount && !tree.isBroken; ++i)
    {
        addWaves(&tree, list, scene, i, isAsRead);
    }
    list = swAddTreeNode(&tree, 0, SW_TREE_LIST, "views");
    for (int i = 0; i < scene->viewCount && !tree.isBroken; ++i)
    {
        addView(&tree, list, &scene->views[i]);
    }
    return tree;
}
