// SPDX-License-Identifier: MIT
#include "json.h"

#include <math.h>

Json OpenJson(FILE* file)
{
    return (Json){.file = file};
}

static void WriteString(Json* json, const char* text)
{
    fputc('"', json->file);
    for (const unsigned char* c = (const unsigned char*)text; *c != 0; ++c)
    {
        if (*c == '"' || *c == '\\')
        {
            fputc('\\', json->file);
            fputc(*c, json->file);
        }
        else if (*c < 0x20)
        {
            fprintf(json->file, "\\u%04x", *c);
        }
        else
        {
            fputc(*c, json->file);
        }
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
