// SPDX-License-Identifier: MIT
// What a spectrum is, how waves are made of it, and the equaliser.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "panels.h"

const char* GetKindName(void* context, int index)
{
    (void)context;
    return swFields_Find(swGetSpectrumFields(), "kind")->names[index];
}

// The address of a member of the file's twin, if there is a file.
#define FILED(member) (filed != NULL ? &filed->member : NULL)

// One number that sets wind, height and period; it follows them where they are set by themselves.
static bool DrawBeaufort(swSpectrumDef* spectrum)
{
    BeaufortNumber beaufort = FindBeaufort(spectrum);
    bool hasChanged = UiSlider("Beaufort", &beaufort.number, 0.0f, 12.0f, beaufort.isExact ? "%.1f" : "(wind of %.1f)");
    UiTip("Sets wind, height and period together, as `beaufort` in a scene file.\n"
          "In brackets: the wind has this number, but the sea is another one.");
    if (hasChanged)
    {
        SetBeaufort(spectrum, beaufort.number);
    }
    return hasChanged;
}

static bool DrawKind(swSpectrumDef* spectrum, const swSpectrumDef* filed)
{
    int kind = (int)spectrum->kind, other = filed != NULL ? (int)filed->kind : 0;
    bool hasFiled = filed != NULL && other != SW_SPECTRUM_TABLE;
    bool hasChanged = TurnChoice("spectrum", &kind, hasFiled ? &other : NULL, SW_SPECTRUM_TABLE, GetKindName, NULL);
    if (hasChanged && kind == SW_SPECTRUM_OCTAVES && !(hasFiled && kind == other))
    {
        *spectrum = swMakeOctaveSpectrum(spectrum); // begins as what was there
    }
    spectrum->kind = (swSpectrumKind)kind;
    return hasChanged;
}

static bool IsOneOf(const swField* field, const char* const* members)
{
    while (*members != NULL && strcmp(*members, field->member) != 0)
    {
        members++;
    }
    return *members != NULL;
}

// Whether a field has a widget here: the kind has its own, and some fields count only where others have a value.
static bool IsTurned(const swField* field, const swSpectrumDef* spectrum)
{
    static const char* const others[] = {"kind", "octaves", "table", "hasWind", NULL};
    bool isIdle = (strcmp(field->member, "growth") == 0 && spectrum->peakPeriod > 0.0f) ||
                  (strcmp(field->member, "spreadExponent") == 0 && spectrum->spreading != SW_SPREADING_COSINE_2S);
    return !isIdle && !IsOneOf(field, others) && swFields_Counts(swGetSpectrumFields(), field, spectrum);
}

static bool TurnSpectrum(swSpectrumDef* spectrum, const swSpectrumDef* filed, bool directions)
{
    static const char* const spreads[] = {"spreading", "spreadExponent", "turbulence", "swell", NULL};
    const swFields* fields = swGetSpectrumFields();
    bool hasChanged = false;
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        if (IsOneOf(field, spreads) == directions && IsTurned(field, spectrum))
        {
            hasChanged |= TurnField(field, spectrum, filed);
        }
    }
    return hasChanged;
}

bool DrawFormula(swSpectrumDef* spectrum, const swSpectrumDef* filed)
{
    bool hasChanged = DrawKind(spectrum, filed);
    hasChanged |= spectrum->kind != SW_SPECTRUM_OCTAVES && DrawBeaufort(spectrum);
    hasChanged |= TurnSpectrum(spectrum, filed, false);
    if (BeginUiGroup("Directions", false))
    {
        hasChanged |= TurnSpectrum(spectrum, filed, true);
    }
    if (spectrum->kind == SW_SPECTRUM_OCTAVES && BeginUiGroup("Octaves", true))
    {
        hasChanged |= DrawEqualiser(spectrum, filed != NULL && filed->kind == SW_SPECTRUM_OCTAVES ? filed : NULL);
    }
    return hasChanged;
}

static bool DrawOctave(swOctave* octave, const swOctave* filed, int index)
{
    const swFields* fields = swGetOctaveFields();
    PushUiScope(index);
    UiLabelCell("%.4g", (double)ldexpf(1.0f, index - 4));
    UiNextCell();
    bool hasChanged = TurnValue(swFields_Find(fields, "isEnabled"), "##on", &octave->isEnabled, FILED(isEnabled));
    UiNextCell();
    hasChanged |= TurnValue(swFields_Find(fields, "power"), "##power", &octave->power, FILED(power));
    UiNextCell();
    hasChanged |= TurnValue(swFields_Find(fields, "chop"), "##chop", &octave->chop, FILED(chop));
    UiNextCell();
    hasChanged |=
        TurnValue(swFields_Find(fields, "gravityScale"), "##gravity", &octave->gravityScale, FILED(gravityScale));
    PopUiScope();
    return hasChanged;
}

bool DrawEqualiser(swSpectrumDef* spectrum, const swSpectrumDef* filed)
{
    static const UiColumn columns[] = {
        {"from m", 6.0f}, {"on", 4.5f}, {"power", 0.0f}, {"chop", 0.0f}, {"gravity", 0.0f}};
    swOctaves* octaves = &spectrum->octaves;
    bool hasChanged = false;
    if (BeginUiTable("octaves", 5, columns))
    {
        for (int i = SW_OCTAVE_COUNT - 1; i >= 0; i--)
        {
            hasChanged |= DrawOctave(&octaves->octaves[i], FILED(octaves.octaves[i]), i);
        }
        EndUiTable();
    }
    return TurnFields(swGetOctavesFields(), octaves, FILED(octaves)) || hasChanged;
}

// A tile's samples along a side: a power of two.
#define LEAST_RESOLUTION 16

static const char* GetResolutionName(void* context, int index)
{
    static char text[16];
    (void)context;
    snprintf(text, sizeof(text), "%d", LEAST_RESOLUTION << index);
    return text;
}

static int FindResolution(int resolution)
{
    int index = 0;
    while (LEAST_RESOLUTION << index < resolution)
    {
        index++;
    }
    return index;
}

static bool DrawResolution(swWaveSystemDef* def, const swWaveSystemDef* filed)
{
    const swField* field = swFields_Find(swGetWaveSystemFields(), "resolution");
    int index = FindResolution(def->resolution), other = filed != NULL ? FindResolution(filed->resolution) : 0;
    bool hasChanged = TurnChoice(field->label, &index, filed != NULL ? &other : NULL,
                                 FindResolution((int)field->high) + 1, GetResolutionName, NULL);
    UiTip(field->tip);
    def->resolution = LEAST_RESOLUTION << index;
    return hasChanged;
}

bool DrawMethod(swWaveSystemDef* def, const swWaveSystemDef* filed)
{
    // Weight and chop are drawn for every system, the components as rows.
    static const char* const others[] = {"spectrum", "resolution", "components", "weight", "chop", NULL};
    const swFields* fields = swGetWaveSystemFields();
    bool hasChanged = false;
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        if (swFields_Counts(fields, field, def) && strcmp(field->member, "resolution") == 0)
        {
            hasChanged |= DrawResolution(def, filed);
        }
        else if (swFields_Counts(fields, field, def) && !IsOneOf(field, others))
        {
            hasChanged |= TurnField(field, def, filed);
        }
    }
    return hasChanged;
}
