// SPDX-License-Identifier: MIT
#include "tuned.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// Announce the mark of the next widget; `text` is what the file has.
static void Mark(const void* value, const void* filed, size_t size, const char* text)
{
    if (filed != NULL)
    {
        UiMarkNext(memcmp(value, filed, size) != 0, "In the file: %s. Click to go back to it.", text);
    }
}

// Whether the mark was clicked; then the value is the file's.
static bool TakeBack(void* value, const void* filed, size_t size)
{
    if (filed == NULL || !UiWasReset())
    {
        return false;
    }
    memcpy(value, filed, size);
    return true;
}

bool TurnKnob(const Knob* knob, float* value, const float* filed)
{
    char text[64] = "";
    if (filed != NULL)
    {
        // Formats are this program's own, each with one number at most.
        snprintf(text, sizeof(text), ChooseFormat(knob, *filed), (double)ShowValue(knob, *filed));
    }
    Mark(value, filed, sizeof(*value), text);
    float shown = ShowValue(knob, *value);
    const char* format = ChooseFormat(knob, *value);
    bool hasChanged = knob->isLogarithmic ? UiLogSlider(knob->label, &shown, knob->low, knob->high, format)
                                          : UiSlider(knob->label, &shown, knob->low, knob->high, format);
    if (hasChanged)
    {
        *value = ReadShown(knob, shown);
    }
    hasChanged |= TakeBack(value, filed, sizeof(*value));
    if (knob->tip != NULL)
    {
        UiTip(knob->tip);
    }
    return hasChanged;
}

bool TurnSwitch(const char* label, bool* value, const bool* filed)
{
    Mark(value, filed, sizeof(*value), filed != NULL && *filed ? "On" : "Off");
    bool hasChanged = UiCheckbox(label, value);
    return TakeBack(value, filed, sizeof(*value)) || hasChanged;
}

bool TurnCount(const char* label, int* value, const int* filed, int low, int high, const char* format)
{
    char text[64] = "";
    if (filed != NULL)
    {
        snprintf(text, sizeof(text), format, *filed);
    }
    Mark(value, filed, sizeof(*value), text);
    bool hasChanged = UiSliderInt(label, value, low, high, format);
    return TakeBack(value, filed, sizeof(*value)) || hasChanged;
}

bool TurnChoice(const char* label, int* index, const int* filed, int count, UiItemFcn getName, void* context)
{
    char text[96] = "";
    if (filed != NULL)
    {
        snprintf(text, sizeof(text), "%s", getName(context, *filed));
    }
    Mark(index, filed, sizeof(*index), text);
    bool hasChanged = UiChoice(label, index, count, getName, context);
    return TakeBack(index, filed, sizeof(*index)) || hasChanged;
}

bool TurnColor(const char* label, swVec3* rgb, const swVec3* filed)
{
    char text[64] = "";
    if (filed != NULL)
    {
        snprintf(text, sizeof(text), "%.2f, %.2f, %.2f", (double)filed->x, (double)filed->y, (double)filed->z);
    }
    Mark(rgb, filed, sizeof(*rgb), text);
    bool hasChanged = UiColor(label, rgb);
    return TakeBack(rgb, filed, sizeof(*rgb)) || hasChanged;
}

static void WriteFormat(const swField* field, char* format, size_t size)
{
    double span = field->knobHigh - field->knobLow;
    const char* number = field->isLogarithmic ? (field->knobHigh > 1e4 ? "%.0f" : "%.3g")
                         : span > 100.0       ? "%.0f"
                         : span > 20.0        ? "%.1f"
                                              : "%.2f";
    snprintf(format, size, "%s%s%s", number, field->unit[0] != '\0' ? " " : "", field->unit);
}

static bool TurnNumber(const swField* field, const char* label, float* value, const float* filed)
{
    char format[48] = "infinite";
    if (isfinite(*value))
    {
        WriteFormat(field, format, sizeof(format));
    }
    Knob knob = {.label = label,
                 .low = (float)field->knobLow,
                 .high = (float)field->knobHigh,
                 .format = format,
                 .unit = field->form == SW_FORM_DEGREES ? DEGREE : 0.0f,
                 .isLogarithmic = field->isLogarithmic,
                 .isBearing = field->form == SW_FORM_BEARING,
                 .zero = field->zero,
                 .tip = field->tip};
    return TurnKnob(&knob, value, filed);
}

// Doubles, and whole numbers without a sign, by way of what the widgets have.
static bool TurnDouble(const swField* field, const char* label, double* value, const double* filed)
{
    float single = (float)*value, other = filed != NULL ? (float)*filed : 0.0f;
    bool hasChanged = TurnNumber(field, label, &single, filed != NULL ? &other : NULL);
    *value = hasChanged ? (double)single : *value;
    return hasChanged;
}

static bool TurnWhole(const swField* field, const char* label, int* value, const int* filed)
{
    bool hasChanged = TurnCount(label, value, filed, (int)field->knobLow, (int)field->knobHigh, "%d");
    if (field->tip != NULL)
    {
        UiTip(field->tip);
    }
    return hasChanged;
}

static const char* GetFieldName(void* context, int index)
{
    const swField* const* field = context;
    return (*field)->names[index];
}

static bool TurnFieldChoice(const swField* field, const char* label, int* value, const int* filed)
{
    bool hasChanged = TurnChoice(label, value, filed, (int)field->high + 1, GetFieldName, &field);
    if (field->tip != NULL)
    {
        UiTip(field->tip);
    }
    return hasChanged;
}

// What three numbers are called behind the field's label.
static const char* NamePart(const swField* field, int index)
{
    static const char* const colors[3] = {"red", "green", "blue"};
    static const char* const angles[3] = {"yaw", "pitch", "roll"};
    static const char* const axes[3] = {"x", "y", "z"};
    return field->form == SW_FORM_COLOR ? colors[index] : field->form == SW_FORM_DEGREES ? angles[index] : axes[index];
}

// A knob for each of three, but a colour for one that has no unit.
static bool TurnThree(const swField* field, const char* label, float* values, const float* filed)
{
    if (field->form == SW_FORM_COLOR && field->unit[0] == '\0')
    {
        return TurnColor(label, (swVec3*)values, (const swVec3*)filed);
    }
    bool hasChanged = false;
    for (int i = 0; i < 3; i++)
    {
        char text[64];
        snprintf(text, sizeof(text), "%s %s", label, NamePart(field, i));
        hasChanged |= TurnNumber(field, text, &values[i], filed != NULL ? &filed[i] : NULL);
    }
    return hasChanged;
}

// A position, which may be anywhere: its knobs turn about where the file has it.
static bool TurnPosition(const swField* field, const char* label, double* values, const double* filed)
{
    bool hasChanged = false;
    for (int i = 0; i < 3; i++)
    {
        char text[64];
        swField knob = *field;
        double middle = filed != NULL ? filed[i] : 0.0;
        knob.knobLow = fmin(middle + field->knobLow, values[i]);
        knob.knobHigh = fmax(middle + field->knobHigh, values[i]);
        snprintf(text, sizeof(text), "%s %s", label, NamePart(field, i));
        hasChanged |= TurnDouble(&knob, text, &values[i], filed != NULL ? &filed[i] : NULL);
    }
    return hasChanged;
}

bool TurnValue(const swField* field, const char* label, void* value, const void* filed)
{
    const char* text = label != NULL ? label : field->label;
    switch (field->type)
    {
    case SW_FIELD_BOOL:
    {
        bool hasChanged = TurnSwitch(text, value, filed);
        if (field->tip != NULL)
        {
            UiTip(field->tip);
        }
        return hasChanged;
    }
    case SW_FIELD_INT:
    case SW_FIELD_UINT:
        return TurnWhole(field, text, value, filed);
    case SW_FIELD_CHOICE:
        return TurnFieldChoice(field, text, value, filed);
    case SW_FIELD_FLOAT:
        return TurnNumber(field, text, value, filed);
    case SW_FIELD_DOUBLE:
        return TurnDouble(field, text, value, filed);
    case SW_FIELD_FLOATS:
        return field->count == 3 && TurnThree(field, text, value, filed);
    case SW_FIELD_DOUBLES:
        return field->count == 3 && TurnPosition(field, text, value, filed);
    default:
        return false;
    }
}

bool TurnField(const swField* field, void* def, const void* filed)
{
    const char* other = filed;
    return TurnValue(field, NULL, (char*)def + field->offset, other != NULL ? other + field->offset : NULL);
}

bool TurnMember(const swFields* fields, const char* member, void* def, const void* filed)
{
    return TurnField(swFields_Find(fields, member), def, filed);
}

bool TurnFields(const swFields* fields, void* def, const void* filed)
{
    bool hasChanged = false;
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        hasChanged |= swFields_Counts(fields, field, def) && TurnField(field, def, filed);
    }
    return hasChanged;
}

float ToDegrees(float radians)
{
    return radians * (float)(180.0 / SW_PI);
}

float ToBearing(float direction)
{
    return ShowValue(&(Knob){.isBearing = true}, direction);
}
