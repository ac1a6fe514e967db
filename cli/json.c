// SPDX-License-Identifier: MIT
#include "json.h"

#include <math.h>

#include "text.h"

Json OpenJson(FILE* file)
{
    return (Json){.file = file};
}

static void WriteString(Json* json, const char* text)
{
    fputc('"', json->file);
    while (*text != 0)
    {
        size_t size = MeasureCharacter(text);
        if (*text == '"' || *text == '\\')
        {
            fputc('\\', json->file);
        }
        if (size > 0)
        {
            fwrite(text, size, 1, json->file);
        }
        else
        {
            // A control character of two bytes by its number; a byte that is no UTF-8, as a file's name may have,
            // alike.
            const unsigned char* c = (const unsigned char*)text;
            size = c[0] == 0xc2 && c[1] >= 0x80 && c[1] < 0xa0 ? 2 : 1;
            fprintf(json->file, "\\u%04x", c[size - 1]);
        }
        text += size;
    }
    fputc('"', json->file);
}

static void BreakLine(Json* json)
{
    fputc('\n', json->file);
    for (int i = 0; i < json->depth; ++i)
    {
        fputs("  ", json->file);
    }
}

// Comma, line break and key before a value.
static void BeginItem(Json* json, const char* key)
{
    if (json->depth > 0)
    {
        if (json->hasItems[json->depth])
        {
            fputc(',', json->file);
        }
        json->hasItems[json->depth] = true;
        if (json->isInline[json->depth])
        {
            fputc(' ', json->file);
        }
        else
        {
            BreakLine(json);
        }
    }
    if (key != NULL)
    {
        WriteString(json, key);
        fputs(": ", json->file);
    }
}

static void Open(Json* json, const char* key, char bracket, bool isInline)
{
    BeginItem(json, key);
    fputc(bracket, json->file);
    json->depth += 1;
    json->hasItems[json->depth] = false;
    json->isInline[json->depth] = isInline;
}

static void Close(Json* json, char bracket)
{
    bool breakLine = json->hasItems[json->depth] && !json->isInline[json->depth];
    json->depth -= 1;
    if (breakLine)
    {
        BreakLine(json);
    }
    fputc(bracket, json->file);
    if (json->depth == 0)
    {
        fputc('\n', json->file);
    }
}

void JsonOpenObject(Json* json, const char* key)
{
    Open(json, key, '{', false);
}

void JsonCloseObject(Json* json)
{
    Close(json, '}');
}

void JsonOpenArray(Json* json, const char* key)
{
    Open(json, key, '[', false);
}

void JsonCloseArray(Json* json)
{
    Close(json, ']');
}

void JsonText(Json* json, const char* key, const char* value)
{
    BeginItem(json, key);
    if (value == NULL)
    {
        fputs("null", json->file);
        return;
    }
    WriteString(json, value);
}

void JsonNumber(Json* json, const char* key, double value)
{
    BeginItem(json, key);
    if (isfinite(value))
    {
        fprintf(json->file, "%.6g", value);
    }
    else
    {
        fputs("null", json->file);
    }
}

void JsonInteger(Json* json, const char* key, long long value)
{
    BeginItem(json, key);
    fprintf(json->file, "%lld", value);
}

void JsonFlag(Json* json, const char* key, bool value)
{
    BeginItem(json, key);
    fputs(value ? "true" : "false", json->file);
}

void JsonNull(Json* json, const char* key)
{
    BeginItem(json, key);
    fputs("null", json->file);
}

void JsonFloats(Json* json, const char* key, const float* values, int count)
{
    Open(json, key, '[', true);
    for (int i = 0; i < count; ++i)
    {
        JsonNumber(json, NULL, (double)values[i]);
    }
    Close(json, ']');
}
