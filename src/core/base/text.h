// SPDX-License-Identifier: MIT
#pragma once

// A place in a text: lines, words, fields and numbers, with the line for messages.

#include <stdbool.h>
#include <stddef.h>

#include "core/base/number.h"
#include "core/base/seam.h"
#include "seaway/base.h"

// A text and the place in it.
typedef struct swText
{
    const swHost* host;
    const char* name; // for messages
    const char* next; // first character of the next line
    const char* end;
    int line; // of `at`, from 1
    const char* lineBegin;
    const char* at;
    const char* lineEnd;
    char separator; // of fields: ',' unless a heading shows another
} swText;

typedef struct swToken
{
    const char* text;
    int size; // at most 80
} swToken;

SW_SEAM_BEGIN

// Passes over the byte order mark that some editors write. Lines end in LF, CR LF or CR; the last may lack its end.
swText swOpenText(const swHost* host, const char* text, size_t size, const char* name);

// To the next line that holds more than spaces; false at the end.
bool swNextLine(swText* text);

// The next character that is no space; '\0' at the end of the line.
char swPeekChar(swText* text);

// Empty at the end of the line. Parentheses stand alone.
swToken swNextToken(swText* text);

// The next field of a line with commas, or another separator, without the spaces and quotes around it; false behind the
// last.
bool swNextField(swText* text, swToken* field);

// Whether a field says that nothing is known: empty, NaN, MM, N/A, null, or -9, -99, -999, ...
bool swIsMissingField(swToken token);

bool swIsToken(swToken token, const char* word);
bool swParseToken(swToken token, double* value);

// Whether the rest of the line begins with a word; spaces are passed over.
bool swHasPrefix(swText* text, const char* word);

// The next number of a text that is wrapped at will: across lines, after spaces or commas. It ends where the next
// begins, even if a sign is all that parts them, as Fortran writes. "0.261-100", an exponent that has pushed its
// letter out, is small enough to be 0 where `isWide` says that exponents are written; 1e60 is the largest. Fails with
// line and name.
swResult swReadNumber(swText* text, const char* what, bool isWide, double* value);

// The same, refused outside of [low, high].
swResult swReadRange(swText* text, const char* what, double low, double high, double* value);
swResult swReadCount(swText* text, const char* what, int low, int high, int* value);

// To the next line that holds something; fails if the text ends, saying what is missing.
swResult swNeedLine(swText* text, const char* what);

SW_SEAM_END
