// SPDX-License-Identifier: MIT
#pragma once

// Tables of defs: see seaway/field.h for what a field is. Each table stands beside the module that the def is about, as
// `x_fields.c`, and holds one line for each field:
//
//     #define SW_DEF swFoamDef
//     static const swField foamFields[] = {
//         SW_NUMBER(fadeRate, "1/s", SW_WITHIN(0.01, 10.0), 0.25, .key = "fade_rate_per_s", .label = "fading", ...),
//         SW_PART(look, &swLookFields, .label = "look"),
//     };
//     const swFields swFoamFields = SW_FIELDS(swFoamDef, "foam", "foam", foamFields, -1);
//
// After what a macro asks for come designated initializers of swField: key and label always; knobs, tips, kinds and use
// where they are not the usual. Left out, `use` is SW_USE_SEA and `form` SW_FORM_PLAIN, and the field always counts.
//
// One table drives the default (swFillDef), the check with its sentence (swCheckDef), equality (swIsSameDef), saving
// (swStreamDef) and the digest (swHashDef). Rules that cross fields are small functions beside the table. A test looks
// at every field of every table (tests/core/test_fields.c), and one holds the tables against the headers' prose.

#include "core/base/hash.h"
#include "core/base/host.h"
#include "core/base/seam.h"
#include "core/base/stream.h"
#include "seaway/field.h"

// ---- lines of a table; SW_DEF is the struct ----

#define SW_MEMBER(member_) ((SW_DEF*)0)->member_
#define SW_FIELD_AT(member_) .member = #member_, .offset = offsetof(SW_DEF, member_), .size = sizeof(SW_MEMBER(member_))

// float, double, int or uint32_t
#define SW_NUMBER(member_, unit_, range_, default_, ...)                                                               \
    {                                                                                                                  \
        SW_FIELD_AT(member_), .unit = (unit_), range_, .defaults = {default_}, .count = 1,                             \
                              .type = _Generic(SW_MEMBER(member_), float                                               \
                                               : SW_FIELD_FLOAT, double                                                \
                                               : SW_FIELD_DOUBLE, int                                                  \
                                               : SW_FIELD_INT, uint32_t                                                \
                                               : SW_FIELD_UINT),                                                       \
                              __VA_ARGS__                                                                              \
    }

// size_t
#define SW_BYTES(member_, range_, default_, ...)                                                                       \
    {                                                                                                                  \
        SW_FIELD_AT(member_), .unit = "bytes", range_, .defaults = {default_}, .count = 1, .type = SW_FIELD_SIZE,      \
                              __VA_ARGS__                                                                              \
    }

// swVec3, swPos and other structs of nothing but floats or doubles; the defaults stand in SW_EACH(x, y, z).
#define SW_NUMBERS(member_, part_, unit_, range_, defaults_, ...)                                                      \
    {                                                                                                                  \
        SW_FIELD_AT(member_), .unit = (unit_), range_, defaults_,                                                      \
                              .count = (int)(sizeof(SW_MEMBER(member_)) / sizeof(part_)),                              \
                              .type = _Generic((part_)0, float                                                         \
                                               : SW_FIELD_FLOATS, double                                               \
                                               : SW_FIELD_DOUBLES),                                                    \
                              __VA_ARGS__                                                                              \
    }
#define SW_EACH(...) .defaults = {__VA_ARGS__}

#define SW_SWITCH(member_, default_, ...)                                                                              \
    {                                                                                                                  \
        SW_FIELD_AT(member_), .unit = "", .high = 1.0, .defaults = {default_}, .count = 1,                             \
                              .type = _Generic(SW_MEMBER(member_), bool                                                \
                                               : SW_FIELD_BOOL),                                                       \
                              __VA_ARGS__                                                                              \
    }

// An enumeration; `words_` and `names_` have one for each enumerator and NULL at their end.
#define SW_CHOICE(member_, words_, names_, default_, ...)                                                              \
    {                                                                                                                  \
        SW_FIELD_AT(member_), .unit = "", .words = (words_), .names = (names_),                                        \
                              .high = (double)(sizeof(names_) / sizeof((names_)[0]) - 2), .defaults = {default_},      \
                              .count = 1, .type = SW_FIELD_CHOICE, __VA_ARGS__                                         \
    }

// Structs that have tables of their own: one, an array of them, and a pointer to some with their count in an int.
#define SW_PART(member_, fields_, ...)                                                                                 \
    {                                                                                                                  \
        SW_FIELD_AT(member_), .unit = "", .fields = (fields_), .count = 1, .type = SW_FIELD_DEF, __VA_ARGS__           \
    }
#define SW_PARTS(member_, fields_, ...)                                                                                \
    {                                                                                                                  \
        SW_FIELD_AT(member_), .unit = "", .fields = (fields_), .type = SW_FIELD_DEFS,                                  \
                              .count = (int)(sizeof(SW_MEMBER(member_)) / sizeof(SW_MEMBER(member_[0]))), __VA_ARGS__  \
    }
#define SW_LIST(member_, count_, most_, fields_, ...)                                                                  \
    {                                                                                                                  \
        SW_FIELD_AT(member_), .unit = "", .fields = (fields_), .type = SW_FIELD_LIST, .count = (most_),                \
                              .countOffset = offsetof(SW_DEF, count_), __VA_ARGS__                                     \
    }

#define SW_TEXT(member_, ...)                                                                                          \
    {                                                                                                                  \
        SW_FIELD_AT(member_), .unit = "", .count = 1, .type = SW_FIELD_TEXT, __VA_ARGS__                               \
    }

// What the host gives: no value. It is neither checked, saved nor hashed here.
#define SW_GIVEN(member_, ...)                                                                                         \
    {                                                                                                                  \
        SW_FIELD_AT(member_), .unit = "", .count = 1, .type = SW_FIELD_GIVEN, .use = SW_USE_HERE, __VA_ARGS__          \
    }

// Ranges, as the struct has the number. Of floats, the ends are rounded to floats too.
#define SW_WITHIN(low_, high_) .low = (low_), .high = (high_)
#define SW_ABOVE(low_, high_) .low = (low_), .high = (high_), .isLowOpen = true
#define SW_OR(other_) .hasOther = true, .other = (other_)

// Where a knob turns, as people read the number.
#define SW_KNOB(low_, high_) .knobLow = (low_), .knobHigh = (high_)
#define SW_LOG_KNOB(low_, high_) .knobLow = (low_), .knobHigh = (high_), .isLogarithmic = true

#define SW_KIND(kind_) (1u << (kind_))

// The table itself. `kind_` is the index of the choice that decides which fields count, or -1.
#define SW_FIELDS_COUNT(fields_) ((int)(sizeof(fields_) / sizeof((fields_)[0])))
#define SW_FIELDS(def_, section_, label_, fields_, kind_)                                                              \
    {                                                                                                                  \
        .name = #def_, .section = (section_), .label = (label_), .size = sizeof(def_), .fields = (fields_),            \
        .count = SW_FIELDS_COUNT(fields_), .kind = (kind_), .cookieOffset = offsetof(def_, internalValue),             \
        .cookie = SW_DEF_COOKIE                                                                                        \
    }
// Of a struct that is only part of defs and has no `internalValue`.
#define SW_PART_FIELDS(def_, section_, label_, fields_)                                                                \
    {                                                                                                                  \
        .name = #def_, .section = (section_), .label = (label_), .size = sizeof(def_), .fields = (fields_),            \
        .count = SW_FIELDS_COUNT(fields_), .kind = -1                                                                  \
    }

SW_SEAM_BEGIN

// ---- what a table drives ----

// Every field to its default; the rest to zero. What is given is zero, a list empty.
void swFillDef(const swFields* fields, void* def);

// The def was made by its default and every field that counts is in its range; otherwise SW_ERROR_INVALID, and the log
// has a sentence such as "swFoamDef::fadeRate is 20 1/s; its range is [0.01, 10]."
swResult swCheckDef(const swHost* host, const swFields* fields, const void* def);

// Each field that counts is equal, floats by value; two NaN are. What is given is not looked at.
bool swIsSameDef(const swFields* fields, const void* a, const void* b);

// Every field that is saved, in order, whether it counts or not. Neither lists nor what is given. What was read has
// to be checked.
void swStreamDef(swStream* stream, const swFields* fields, void* def);

// Every field that decides the sea, in order. Neither lists nor what is given.
void swHashDef(swHash* hash, const swFields* fields, const void* def);

SW_SEAM_END
