// SPDX-License-Identifier: MIT
#pragma once

#include "base.h"

/// @file
/// What defs are made of, for editors, file formats and bindings to other languages: one table for each def, with a
/// line for each field. The tables are the library's own truth: defaults, range checks, saved worlds, digests, scene
/// files and the viewer's panels come from them. They are constant, any thread may read them, and nothing here
/// allocates.
///
/// A def's table is what its swGetXFields() gives. Fields stand in the order of the struct. All that a def holds is in
/// its table but `internalValue`.
///
///     const swFields* fields = swGetFoamFields();
///     for (int i = 0; i < fields->count; ++i)
///     {
///         const swField* field = &fields->fields[i];
///         double value = swField_GetNumber(field, &foam, 0);
///         printf("%s: %g %s\n", field->label, swField_Show(field, value), field->unit);
///     }

/// What a field is. The last five are no numbers.
typedef enum swFieldType
{
    SW_FIELD_BOOL,
    SW_FIELD_INT,
    SW_FIELD_UINT,   ///< uint32_t
    SW_FIELD_SIZE,   ///< size_t
    SW_FIELD_CHOICE, ///< an enumeration from 0 on; see swField::words
    SW_FIELD_FLOAT,
    SW_FIELD_DOUBLE,
    SW_FIELD_FLOATS,  ///< several, such as a swVec3
    SW_FIELD_DOUBLES, ///< several, such as a swPos
    SW_FIELD_TEXT,    ///< char[size], ended by a zero
    SW_FIELD_DEF,     ///< a def of its own, see swField::fields
    SW_FIELD_DEFS,    ///< swField::count of them, one after another
    SW_FIELD_LIST,    ///< a pointer to as many of them as the int at swField::countOffset says
    SW_FIELD_GIVEN,   ///< what is no value: an object, an array or a function of the host's
    SW_FIELD_TYPE_COUNT
} swFieldType;

/// How people and files name a number. Ranges, defaults and what swField_GetNumber() gives are as the struct has them.
typedef enum swFieldForm
{
    SW_FORM_PLAIN,   ///< as the struct has it
    SW_FORM_DEGREES, ///< radians in the struct, degrees to people
    SW_FORM_BEARING, ///< where waves go, radians from +x towards +z; to people where they come from, see math.h
    SW_FORM_COLOR,   ///< three numbers: red, green, blue, linear
    SW_FORM_COUNT
} swFieldForm;

/// What depends on a field.
typedef enum swFieldUse
{
    SW_USE_SEA,   ///< the sea: it is saved, and digests see it (of waves, by what they are made into)
    SW_USE_STATE, ///< what a world keeps beside the sea: it is saved
    SW_USE_HERE,  ///< this machine or this call only
    SW_USE_COUNT
} swFieldUse;

/// One field of a def.
typedef struct swField
{
    const char* member;  ///< its name in C
    const char* key;     ///< its name in scene files, with its unit; NULL if they do not have it
    const char* section; ///< the section of scene files and panels that it stands in; NULL: that of its table
    const char* label;   ///< a word or two for people
    const char* tip;     ///< a sentence or two for people; NULL if the label says it all
    const char* unit;    ///< of what swField_Show() gives, such as "m/s"; "" of plain numbers
    swFieldType type;
    swFieldForm form;
    swFieldUse use;
    size_t offset; ///< in the def, bytes
    size_t size;   ///< bytes
    int count;     ///< of numbers, of defs; most of a list; else 1

    /// Of numbers: smallest and largest, which may be infinite, and whether those themselves are out of range. NaN is
    /// out of every range. `other`, if there is such, is allowed beside it: it means something of its own.
    double low, high;
    bool isLowOpen, isHighOpen;
    bool hasOther;
    double other;

    double defaults[4]; ///< one for each number

    /// What people turn a knob within, as swField_Show() gives it: inside the range. Logarithmic where most of the
    /// range's sense is at its low end. `zero` says what 0 stands for where that is no number, such as "from the wind".
    double knobLow, knobHigh;
    bool isLogarithmic;
    const char* zero;

    /// Of a choice: the words of scene files, and those for people; both end with NULL.
    const char* const* words;
    const char* const* names;

    /// Bit k: it counts where the choice at swFields::kind is k. 0: it always counts.
    uint32_t kinds;

    const struct swFields* fields; ///< of a def, or of each of several
    size_t countOffset;            ///< of a list: where its int count is
} swField;

/// A def's table.
typedef struct swFields
{
    const char* name;    ///< of the def in C
    const char* section; ///< of scene files; NULL if they do not have it
    const char* label;   ///< for people
    size_t size;         ///< of the def, bytes
    const swField* fields;
    int count;
    int kind;            ///< index of the choice that decides which of the others count; -1 if all do
    size_t cookieOffset; ///< of `internalValue`
    int cookie;          ///< what it must be; 0 if there is none
} swFields;

/// @name Tables
/// @{
SW_API const swFields* swGetWorldFields(void);
SW_API const swFields* swGetFoamFields(void);
SW_API const swFields* swGetSpectrumFields(void);
SW_API const swFields* swGetOctavesFields(void);
SW_API const swFields* swGetOctaveFields(void);
SW_API const swFields* swGetWaveSystemFields(void);
SW_API const swFields* swGetWaveComponentFields(void);
SW_API const swFields* swGetViewFields(void);
SW_API const swFields* swGetSeaFields(void);
SW_API const swFields* swGetSeaReplayFields(void);
SW_API const swFields* swGetQueryFields(void);
SW_API const swFields* swGetRayFields(void);
SW_API const swFields* swGetRestoreFields(void);
/// @}

/// The field of a member, or of a member's member as in "foam.windSpeed"; NULL if there is none.
SW_API const swField* swFields_Find(const swFields* fields, const char* member);

/// Whether a field has an effect in this def, by the choice that the def's kind is.
SW_API bool swFields_Counts(const swFields* fields, const swField* field, const void* def);

/// Check all that a table knows of a def: that it was made by its swDefaultXDef(), and each field that counts by its
/// range. What depends on several fields at once is checked where the def is used.
/// @param sentence receives what is wrong; may be NULL
/// @return whether all is right
SW_API bool swFields_Check(const swFields* fields, const void* def, char* sentence, size_t size);

/// Whether two defs ask for the same: each field that counts is equal. What is given is not looked at.
SW_API bool swFields_AreEqual(const swFields* fields, const void* a, const void* b);

/// A number of a def, as the struct has it: `index` of several, 0 of a single one. Choices and bools are numbers too.
/// Misuse, such as a field that is no number, gives 0 or does nothing.
SW_API double swField_GetNumber(const swField* field, const void* def, int index);
SW_API void swField_SetNumber(const swField* field, void* def, int index, double value);

/// Whether a number, as the struct has it, is in the field's range. Of a float, what it is rounded to.
SW_API bool swField_IsInRange(const swField* field, double value);

/// From a number as the struct has it to one as people and scene files write it, and back: degrees, bearings.
SW_API double swField_Show(const swField* field, double value);
SW_API double swField_Read(const swField* field, double shown);

/// The range of what people and scene files write: an angle is at most a turn, either way.
SW_API void swField_GetShownRange(const swField* field, double* low, double* high);
