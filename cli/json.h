// SPDX-License-Identifier: MIT
#pragma once

// Writes JSON to a file as it goes. Nesting is the caller's: each Open has its Close. What is not finite becomes null.

#include <stdbool.h>
#include <stdio.h>

#define JSON_MAX_DEPTH 16

typedef struct Json
{
    FILE* file;
    int depth;
    bool hasItems[JSON_MAX_DEPTH];
    bool isInline[JSON_MAX_DEPTH]; // arrays of numbers stay on one line
} Json;

// In an array `key` is NULL; so it is for the outermost object.
Json OpenJson(FILE* file);
void JsonOpenObject(Json* json, const char* key);
void JsonCloseObject(Json* json);
void JsonOpenArray(Json* json, const char* key);
void JsonCloseArray(Json* json);
void JsonText(Json* json, const char* key, const char* value); // NULL becomes null
void JsonNumber(Json* json, const char* key, double value);    // six digits
void JsonInteger(Json* json, const char* key, long long value);
void JsonFlag(Json* json, const char* key, bool value);
void JsonNull(Json* json, const char* key);

// An array of numbers on one line.
void JsonFloats(Json* json, const char* key, const float* values, int count);
