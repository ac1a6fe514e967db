// SPDX-License-Identifier: MIT
#include "tuned.h"

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

float ToDegrees(float radians)
{
    return radians * (float)(180.0 / SW_PI);
}

float ToBearing(float direction)
{
    return ShowValue(&(Knob){.isBearing = true}, direction);
}
