// SPDX-License-Identifier: MIT
// Every field of every def's table: what the header says of it, its default, its range and the sentence outside of it,
// equality, saving and the digest. A new table or field is tried without anybody writing anything here.

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/field.h"
#include "core/frame/asked.h"
#include "seaway/seaway.h"
#if FIELDS_GPU
#include "seaway/draw.h"
#endif

#define LARGEST_DEF 16384
#define COUNT(items) ((int)(sizeof(items) / sizeof((items)[0])))

// A table, and what makes its def; NULL of what is part of others.
typedef struct Table
{
    const swFields* (*getFields)(void);
    void (*make)(void* def);
} Table;

// What a header says of a member.
typedef struct Said
{
    const char *def, *member;
    bool hasRange;
    double low, high;
    bool isLowOpen, isHighOpen;
    bool hasDefault;
    double standard;
} Said;

#include "said.inl"

typedef struct Def
{
    _Alignas(16) char bytes[LARGEST_DEF];
} Def;

static Def MakeDef(const Table* table)
{
    Def def;
    memset(&def, 0, sizeof(def));
    assert_true(table->getFields()->size <= sizeof(def));
    if (table->make != NULL)
    {
        table->make(def.bytes);
    }
    else
    {
        swFillDef(table->getFields(), def.bytes);
    }
    return def;
}

static bool IsNumber(const swField* field)
{
    return field->type <= SW_FIELD_DOUBLES;
}

// ---- every field of a def, also those of defs within ----

// One number of a def; `owner` is the struct of `fields` in the def that holds it.
typedef struct Spot
{
    const swFields* fields;
    const swField* field;
    size_t owner;
    int index;
    bool isHere;   // of this machine only, or part of what is
    bool isUnseen; // part of what the digest does not see
} Spot;

typedef void (*SpotFcn)(const Table* table, const Spot* spot);

static void VisitFields(const Table* table, const swFields* fields, size_t owner, bool isHere, bool isUnseen,
                        SpotFcn visit)
{
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        bool isDef = field->type == SW_FIELD_DEF || field->type == SW_FIELD_DEFS;
        bool isLocal = isHere || field->use == SW_USE_HERE;
        bool isHidden = isUnseen || field->use != SW_USE_SEA;
        for (int k = 0; k < field->count && (isDef || IsNumber(field)); k++)
        {
            size_t part = field->offset + (size_t)k * (field->size / (size_t)field->count);
            if (isDef)
            {
                VisitFields(table, field->fields, owner + part, isLocal, isHidden, visit);
            }
            else
            {
                visit(table, &(Spot){fields, field, owner, k, isLocal, isHidden});
            }
        }
    }
}

static void VisitTables(SpotFcn visit)
{
    for (int i = 0; i < COUNT(tables); i++)
    {
        VisitFields(&tables[i], tables[i].getFields(), 0, false, false, visit);
    }
}

static double GetSpot(const Spot* spot, const Def* def)
{
    return swField_GetNumber(spot->field, def->bytes + spot->owner, spot->index);
}

static void SetSpot(const Spot* spot, Def* def, double value)
{
    swField_SetNumber(spot->field, def->bytes + spot->owner, spot->index, value);
}

static void ChooseKind(const swFields* fields, const swField* field, char* def)
{
    if (field->kinds != 0)
    {
        swField_SetNumber(&fields->fields[fields->kind], def, 0, (double)__builtin_ctz(field->kinds));
    }
}

// Choose the kinds with which the field counts: of its own struct and of all that this is part of.
static void MakeCount(const swFields* fields, const Spot* spot, char* def, size_t at)
{
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        size_t part = field->size / (size_t)(field->count > 0 ? field->count : 1);
        for (int k = 0; k < field->count && (field->type == SW_FIELD_DEF || field->type == SW_FIELD_DEFS); k++)
        {
            size_t begin = at + field->offset + (size_t)k * part;
            if (spot->owner >= begin && spot->owner < begin + part)
            {
                ChooseKind(fields, field, def + at);
                MakeCount(field->fields, spot, def, begin);
            }
        }
    }
    if (fields == spot->fields && at == spot->owner)
    {
        ChooseKind(fields, spot->field, def + at);
    }
}

// Another value in the range.
static double ChooseOther(const swField* field, double now)
{
    double low = fmax(field->low, -1e6), high = fmin(field->high, 1e6);
    double other = low + 0.375 * (high - low);
    bool isWhole = field->type <= SW_FIELD_CHOICE;
    other = isWhole ? floor(other) : other;
    other = other == now ? (isWhole ? (now < high ? now + 1.0 : now - 1.0) : low + 0.625 * (high - low)) : other;
    return other;
}

// ---- the tests ----

static const Said* FindSaid(const swFields* fields, const char* member)
{
    for (int i = 0; i < COUNT(said); i++)
    {
        if (strcmp(said[i].def, fields->name) == 0 && strcmp(said[i].member, member) == 0)
        {
            return &said[i];
        }
    }
    return NULL;
}

static bool IsListCount(const swFields* fields, const char* member)
{
    size_t length = strlen(member);
    for (int i = 0; i < fields->count; i++)
    {
        // components and componentCount
        bool isList = fields->fields[i].type == SW_FIELD_LIST;
        if (isList && length > 5 && strncmp(fields->fields[i].member, member, length - 5) == 0)
        {
            return true;
        }
    }
    return false;
}

static void EveryMemberOfADefIsInItsTable(void** state)
{
    (void)state;
    int found = 0;
    for (int i = 0; i < COUNT(tables); i++)
    {
        const swFields* fields = tables[i].getFields();
        for (int k = 0; k < COUNT(said); k++)
        {
            bool isMine = strcmp(said[k].def, fields->name) == 0 && strcmp(said[k].member, "internalValue") != 0;
            found += isMine;
            if (isMine && swFields_Find(fields, said[k].member) == NULL && !IsListCount(fields, said[k].member))
            {
                fail_msg("%s::%s is in no table", fields->name, said[k].member);
            }
        }
        // In the order of the struct, without a gap that a member would fit in.
        size_t end = 0;
        for (int k = 0; k < fields->count; k++)
        {
            const swField* field = &fields->fields[k];
            if (field->offset < end || field->offset - end >= 8 || FindSaid(fields, field->member) == NULL)
            {
                fail_msg("%s::%s stands at %zu; what is before it ends at %zu", fields->name, field->member,
                         field->offset, end);
            }
            end = field->type == SW_FIELD_LIST ? field->countOffset + sizeof(int) : field->offset + field->size;
        }
    }
    print_message("%d members of %d structs\n", found, COUNT(tables));
}

static void HeadersSayWhatTablesSay(void** state)
{
    (void)state;
    int ranges = 0, defaults = 0;
    for (int i = 0; i < COUNT(tables); i++)
    {
        const swFields* fields = tables[i].getFields();
        for (int k = 0; k < fields->count; k++)
        {
            const swField* field = &fields->fields[k];
            const Said* words = FindSaid(fields, field->member);
            assert_non_null(words);
            bool isWrong =
                words->hasRange && (words->low != field->low || words->high != field->high ||
                                    words->isLowOpen != field->isLowOpen || words->isHighOpen != field->isHighOpen);
            bool isSame =
                words->standard == field->defaults[0] || (isnan(words->standard) && isnan(field->defaults[0]));
            if (isWrong || (words->hasDefault && IsNumber(field) && !isSame))
            {
                fail_msg("the header's words on %s::%s are not the table's: [%.10g, %.10g], default %.10g",
                         fields->name, field->member, field->low, field->high, field->defaults[0]);
            }
            bool needsRange = IsNumber(field) && field->type != SW_FIELD_BOOL && field->type != SW_FIELD_CHOICE;
            // Waves a tile hang on the resolution; of what has parts, the prose says more than a range.
            needsRange = needsRange && field->count == 1 && strcmp(field->member, "tileWaves") != 0;
            if (needsRange && !words->hasRange)
            {
                fail_msg("the header does not say the range of %s::%s", fields->name, field->member);
            }
            ranges += words->hasRange;
            defaults += words->hasDefault;
        }
    }
    print_message("%d ranges and %d defaults\n", ranges, defaults);
}

static void CheckDefault(const Table* table, const Spot* spot)
{
    Def def = MakeDef(table);
    const swFields* fields = table->getFields();
    char sentence[320] = "";
    if (!swFields_Check(fields, def.bytes, sentence, sizeof(sentence)))
    {
        fail_msg("the default is refused: %s", sentence);
    }
    assert_true(swField_IsInRange(spot->field, GetSpot(spot, &def)));
    const swField* field = spot->field;
    assert_non_null(field->label);
    assert_non_null(field->unit);
    assert_true(field->key == NULL || strpbrk(field->key, " -") == NULL);
    double low, high;
    swField_GetShownRange(field, &low, &high);
    assert_true(low <= high && field->knobLow <= field->knobHigh);
}

static void EveryDefaultIsInItsRange(void** state)
{
    (void)state;
    VisitTables(CheckDefault);
}

static int s_refused;

static void CheckRefused(const Table* table, const Spot* spot, double value)
{
    Def def = MakeDef(table);
    MakeCount(table->getFields(), spot, def.bytes, 0);
    SetSpot(spot, &def, value);
    double stored = GetSpot(spot, &def);
    if (!(stored == value || (isnan(stored) && isnan(value))))
    {
        return; // the member cannot hold it
    }
    char sentence[320] = "";
    if (swFields_Check(table->getFields(), def.bytes, sentence, sizeof(sentence)))
    {
        fail_msg("%s takes %s = %g", table->getFields()->name, spot->field->member, value);
    }
    if (strstr(sentence, spot->field->member) == NULL || strstr(sentence, "range") == NULL)
    {
        fail_msg("\"%s\" does not name %s and its range", sentence, spot->field->member);
    }
    s_refused += 1;
}

static void RefuseOutside(const Table* table, const Spot* spot)
{
    const swField* field = spot->field;
    if (field->type == SW_FIELD_BOOL)
    {
        return;
    }
    bool isFloat = field->type == SW_FIELD_FLOAT || field->type == SW_FIELD_FLOATS;
    bool isDouble = field->type == SW_FIELD_DOUBLE || field->type == SW_FIELD_DOUBLES;
    double below = isFloat    ? (double)nextafterf((float)field->low, -INFINITY)
                   : isDouble ? nextafter(field->low, -(double)INFINITY)
                              : field->low - 1.0;
    double above = isFloat    ? (double)nextafterf((float)field->high, INFINITY)
                   : isDouble ? nextafter(field->high, (double)INFINITY)
                              : field->high + 1.0;
    below = field->isLowOpen ? field->low : below;
    above = field->isHighOpen ? field->high : above;
    CheckRefused(table, spot, below);
    if (isfinite(field->high) || field->isHighOpen)
    {
        CheckRefused(table, spot, above);
        CheckRefused(table, spot, (double)INFINITY);
    }
    CheckRefused(table, spot, -(double)INFINITY);
    if (!(field->hasOther && isnan(field->other)))
    {
        CheckRefused(table, spot, (double)NAN);
    }
}

static void EveryFieldIsRefusedOutsideItsRange(void** state)
{
    (void)state;
    s_refused = 0;
    VisitTables(RefuseOutside);
    print_message("%d values refused\n", s_refused);
    assert_true(s_refused > 300);
}

// Which fields the digest and the saved bytes hold is said by their use.
static void ChangeOne(const Table* table, const Spot* spot)
{
    const swFields* fields = table->getFields();
    Def def = MakeDef(table);
    MakeCount(table->getFields(), spot, def.bytes, 0);
    Def changed = def;
    SetSpot(spot, &changed, ChooseOther(spot->field, GetSpot(spot, &def)));
    double value = GetSpot(spot, &changed);
    if (value == GetSpot(spot, &def) || swIsSameDef(fields, def.bytes, changed.bytes))
    {
        fail_msg("equality does not see %s of %s", spot->field->member, fields->name);
    }
    assert_true(swIsSameDef(fields, def.bytes, def.bytes));

    uint8_t bytes[4096];
    swStream write = {.purpose = SW_STREAM_WRITE, .data = bytes, .size = sizeof(bytes)};
    swStreamDef(&write, fields, changed.bytes);
    swStream read = {.purpose = SW_STREAM_READ, .data = bytes, .size = write.at};
    Def back = def;
    swStreamDef(&read, fields, back.bytes);
    assert_true(!write.isBroken && !read.isBroken && read.at == write.at);
    bool isBack = GetSpot(spot, &back) == value;
    if (isBack == spot->isHere)
    {
        fail_msg("%s of %s is %s", spot->field->member, fields->name, isBack ? "saved" : "not saved");
    }

    swHash a = swBeginHash(), b = swBeginHash();
    swHashDef(&a, fields, def.bytes);
    swHashDef(&b, fields, changed.bytes);
    bool isSeen = swEndHash(&a) != swEndHash(&b);
    if (isSeen == spot->isUnseen)
    {
        fail_msg("the digest %s %s of %s", isSeen ? "sees" : "does not see", spot->field->member, fields->name);
    }
}

static void EveryFieldIsComparedSavedAndHashed(void** state)
{
    (void)state;
    VisitTables(ChangeOne);
}

// ---- through a saved world ----

// Values that suit the rules which cross fields, and spectra that have energy.
static const struct
{
    const char* member;
    double value;
} s_suited[] = {{"kind", 1.0},          {"resolution", 64.0},     {"tileWaves", 16.0},
                {"minWavelength", 2.0}, {"maxWavelength", 512.0}, {"loopPeriod", 600.0},
                {"depth", 30.0},        {"peakPeriod", 8.0},      {"spreadExponent", 20.0},
                {"leastJacobian", 0.2}};

static double ChooseSuited(const swField* field, double now)
{
    for (int i = 0; i < COUNT(s_suited); i++)
    {
        if (strcmp(s_suited[i].member, field->member) == 0)
        {
            return s_suited[i].value;
        }
    }
    return ChooseOther(field, now);
}

// A system with the field changed comes back with its world. A table's fields need a table.
static void SaveAndRestore(const Table* table, const Spot* spot)
{
    static const float frequencies[2] = {0.1f, 0.2f}, bandwidths[2] = {0.1f, 0.1f};
    static const float density[8] = {1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f};
    static const swSpectrumTable measured = {2, 4, frequencies, bandwidths, density, 0.0f};
    Def def = MakeDef(table);
    MakeCount(table->getFields(), spot, def.bytes, 0);
    swWaveSystemDef* waves = (swWaveSystemDef*)(void*)def.bytes;
    waves->spectrum.table = waves->spectrum.kind == SW_SPECTRUM_TABLE ? &measured : NULL;
    waves->minWavelength = 1.0f;
    waves->tileWaves = 8;
    waves->resolution = strcmp(spot->field->member, "tileWaves") == 0 ? 64 : 32;
    SetSpot(spot, &def, ChooseSuited(spot->field, GetSpot(spot, &def)));

    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    worldDef.enableQueries = false;
    swWorld *world = NULL, *restored = NULL;
    swWaveSystemId id;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    if (swCreateWaveSystem(world, waves, &id) != SW_SUCCESS)
    {
        fail_msg("no waves with another %s", spot->field->member);
    }
    static uint8_t bytes[1 << 20];
    size_t size = sizeof(bytes);
    assert_int_equal(swWorld_Save(world, bytes, &size), SW_SUCCESS);
    swRestoreDef restoreDef = swDefaultRestoreDef();
    assert_int_equal(swRestoreWorld(&host, bytes, size, &restoreDef, &restored), SW_SUCCESS);
    swWaveSystemDef back = swWaveSystem_Get(restored, id);
    double wanted = GetSpot(spot, &def), got = swField_GetNumber(spot->field, (char*)&back + spot->owner, spot->index);
    if (wanted != got || !swFields_AreEqual(table->getFields(), waves, &back))
    {
        fail_msg("%s was %g and came back as %g", spot->field->member, wanted, got);
    }
    swDestroyWorld(restored);
    swDestroyWorld(world);
}

static void EveryFieldOfASystemComesBackWithItsWorld(void** state)
{
    (void)state;
    for (int i = 0; i < COUNT(tables); i++)
    {
        if (tables[i].getFields() == swGetWaveSystemFields())
        {
            VisitFields(&tables[i], tables[i].getFields(), 0, false, false, SaveAndRestore);
        }
    }
}

static void PeoplesNumbersAreThoseOfTheStruct(void** state)
{
    (void)state;
    const swField* direction = swFields_Find(swGetWaveSystemFields(), "spectrum.direction");
    assert_non_null(direction);
    assert_true((float)swField_Read(direction, 225.0) == SW_DIRECTION_FROM_BEARING(225.0));
    for (double bearing = -360.0; bearing <= 360.0; bearing += 7.5)
    {
        float stored = (float)swField_Read(direction, bearing);
        assert_true((float)swField_Read(direction, swField_Show(direction, (double)stored)) == stored);
    }
    const swField* variance = swFields_Find(swGetWaveSystemFields(), "directionVariance");
    assert_float_equal(swField_Show(variance, SW_PI), 180.0, 1e-9);
    double low, high;
    swField_GetShownRange(variance, &low, &high);
    assert_true(low == 0.0 && fabs(high - 180.0) < 1e-9);
    assert_null(swFields_Find(swGetWaveSystemFields(), "spectrum.nothing"));
}

static void WhatWasNotMadeByItsDefaultIsNamed(void** state)
{
    (void)state;
    swWorldDef def = swDefaultWorldDef();
    char sentence[200];
    def.foam.internalValue = 0;
    assert_false(swFields_Check(swGetWorldFields(), &def, sentence, sizeof(sentence)));
    assert_string_equal(sentence, "swWorldDef::foam was not made by swDefaultFoamDef().");
    def.internalValue = 0;
    assert_false(swFields_Check(swGetWorldFields(), &def, sentence, sizeof(sentence)));
    assert_string_equal(sentence, "The swWorldDef was not made by swDefaultWorldDef().");

    swWaveComponent components[3] = {{10.0f, 0.0f, 1.0f, 0.0f}, {10.0f, 0.0f, 1.0f, 0.0f}, {10.0f, 0.0f, 99.0f, 0.0f}};
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.method = SW_WAVES_GERSTNER;
    waves.components = components;
    waves.componentCount = 3;
    assert_false(swFields_Check(swGetWaveSystemFields(), &waves, sentence, sizeof(sentence)));
    assert_string_equal(sentence, "swWaveSystemDef::components[2].amplitude is 99 m; its range is [0, 40].");
    char few[8];
    assert_false(swFields_Check(swGetWaveSystemFields(), &waves, few, sizeof(few)));
    assert_string_equal(few, "swWaveS");
}

// Thousands of rays are looked at without the table.
static void RaysAreGoodWhereTheirTableSaysSo(void** state)
{
    (void)state;
    const swFields* fields = swGetRayFields();
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        const double values[] = {field->low, field->high, field->low - 1.0, field->high * 1.001 + 1.0, (double)NAN};
        for (int k = 0; k < COUNT(values) && strcmp(field->member, "direction") != 0; k++)
        {
            swRay ray = swDefaultRay((swPos){0.0, 0.0, 0.0}, (swVec3){0.0f, -1.0f, 0.0f});
            swField_SetNumber(field, &ray, 0, values[k]);
            assert_int_equal(swIsRayGood(&ray), swFields_Check(fields, &ray, NULL, 0));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryMemberOfADefIsInItsTable),
        cmocka_unit_test(HeadersSayWhatTablesSay),
        cmocka_unit_test(EveryDefaultIsInItsRange),
        cmocka_unit_test(EveryFieldIsRefusedOutsideItsRange),
        cmocka_unit_test(EveryFieldIsComparedSavedAndHashed),
        cmocka_unit_test(EveryFieldOfASystemComesBackWithItsWorld),
        cmocka_unit_test(PeoplesNumbersAreThoseOfTheStruct),
        cmocka_unit_test(WhatWasNotMadeByItsDefaultIsNamed),
        cmocka_unit_test(RaysAreGoodWhereTheirTableSaysSo),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
