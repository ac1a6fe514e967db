// SPDX-License-Identifier: MIT
#include "core/base/field.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/base/misuse.h"
#include "seaway/math.h"

#define DEGREE (SW_PI / 180.0)
#define FULL_TURN 360.0

// ---- one number ----

static size_t getPartSize(const swField* field)
{
    return field->size / (size_t)(field->count > 0 ? field->count : 1);
}

static bool isNumber(const swField* field)
{
    return field->type <= SW_FIELD_DOUBLES;
}

static bool isFloat(const swField* field)
{
    return field->type == SW_FIELD_FLOAT || field->type == SW_FIELD_FLOATS;
}

static size_t getPartOffset(const swField* field, int index)
{
    return field->offset + (index == 0 ? 0 : (size_t)index * getPartSize(field)); // no division for single numbers
}

// A number of the def. Sizes are constants here, so that this is a load and not a call.
static double getNumber(const swField* field, const void* def, int index)
{
    const char* at = (const char*)def + getPartOffset(field, index);
    bool flag;
    int whole;
    uint32_t word;
    size_t size;
    float single;
    double number;
    switch (field->type)
    {
    case SW_FIELD_BOOL:
        memcpy(&flag, at, sizeof flag);
        return flag ? 1.0 : 0.0;
    case SW_FIELD_INT:
    case SW_FIELD_CHOICE:
        memcpy(&whole, at, sizeof whole);
        return (double)whole;
    case SW_FIELD_UINT:
        memcpy(&word, at, sizeof word);
        return (double)word;
    case SW_FIELD_SIZE:
        memcpy(&size, at, sizeof size);
        return (double)size;
    case SW_FIELD_FLOAT:
    case SW_FIELD_FLOATS:
        memcpy(&single, at, sizeof single);
        return (double)single;
    default:
        memcpy(&number, at, sizeof number);
        return number;
    }
}

// A whole number that the member cannot hold is left alone.
static void setNumber(const swField* field, void* def, int index, double value)
{
    char* at = (char*)def + getPartOffset(field, index);
    float single = (float)value;
    bool flag = value != 0.0;
    switch (field->type)
    {
    case SW_FIELD_BOOL:
        memcpy(at, &flag, sizeof flag);
        break;
    case SW_FIELD_INT:
    case SW_FIELD_CHOICE:
        if (value >= (double)INT32_MIN && value <= (double)INT32_MAX)
        {
            int whole = (int)value;
            memcpy(at, &whole, sizeof whole);
        }
        break;
    case SW_FIELD_UINT:
        if (value >= 0.0 && value <= (double)UINT32_MAX)
        {
            uint32_t word = (uint32_t)value;
            memcpy(at, &word, sizeof word);
        }
        break;
    case SW_FIELD_SIZE:
        if (value >= 0.0 && value < 18446744073709551616.0)
        {
            size_t size = (size_t)value;
            memcpy(at, &size, sizeof size);
        }
        break;
    case SW_FIELD_FLOAT:
    case SW_FIELD_FLOATS:
        memcpy(at, &single, sizeof single);
        break;
    default:
        memcpy(at, &value, sizeof value);
        break;
    }
}

static bool isInRange(const swField* field, double value)
{
    if (field->hasOther && (value == field->other || (isnan(value) && isnan(field->other))))
    {
        return true;
    }
    // A limit such as 0.1 is meant as the float that is nearest to it.
    double x = isFloat(field) ? (double)(float)value : value;
    double low = isFloat(field) ? (double)(float)field->low : field->low;
    double high = isFloat(field) ? (double)(float)field->high : field->high;
    return (field->isLowOpen ? x > low : x >= low) && (field->isHighOpen ? x < high : x <= high); // false for NaN
}

bool swField_IsInRange(const swField* field, double value)
{
    SW_REQUIRE(field != NULL, false, NULL, "swField_IsInRange() needs a field");
    return isInRange(field, value);
}

double swField_GetNumber(const swField* field, const void* def, int index)
{
    SW_REQUIRE(field != NULL && def != NULL && isNumber(field) && index >= 0 && index < field->count, 0.0, NULL,
               "swField_GetNumber() needs a field that is a number, a def and an index that it has");
    return getNumber(field, def, index);
}

void swField_SetNumber(const swField* field, void* def, int index, double value)
{
    SW_REQUIRE_VOID(field != NULL && def != NULL && isNumber(field) && index >= 0 && index < field->count, NULL,
                    "swField_SetNumber() needs a field that is a number, a def and an index that it has");
    setNumber(field, def, index, value);
}

// ---- as people write it ----

double swField_Show(const swField* field, double value)
{
    SW_REQUIRE(field != NULL, 0.0, NULL, "swField_Show() needs a field");
    if (field->form != SW_FORM_DEGREES && field->form != SW_FORM_BEARING)
    {
        return value;
    }
    double degrees = value / DEGREE - (field->form == SW_FORM_BEARING ? 90.0 : 0.0);
    // A turn that was rounded to a float stays a turn.
    bool isTurn = fabs(fabs(degrees) - FULL_TURN) < 1e-4;
    return isTurn ? copysign(FULL_TURN, degrees) : fabs(degrees) < FULL_TURN ? degrees : fmod(degrees, FULL_TURN);
}

double swField_Read(const swField* field, double shown)
{
    SW_REQUIRE(field != NULL, 0.0, NULL, "swField_Read() needs a field");
    switch (field->form)
    {
    case SW_FORM_DEGREES:
        return shown * DEGREE;
    case SW_FORM_BEARING:
        return (shown + 90.0) * DEGREE; // SW_DIRECTION_FROM_BEARING()
    default:
        return shown;
    }
}

void swField_GetShownRange(const swField* field, double* low, double* high)
{
    SW_REQUIRE_VOID(field != NULL && low != NULL && high != NULL, NULL,
                    "swField_GetShownRange() needs a field and places for both ends");
    *low = field->low;
    *high = field->high;
    if (field->form == SW_FORM_BEARING)
    {
        *low = -FULL_TURN;
        *high = FULL_TURN;
    }
    else if (field->form == SW_FORM_DEGREES)
    {
        *low = fmax(field->low / DEGREE, -FULL_TURN);
        *high = fmin(field->high / DEGREE, FULL_TURN);
    }
}

// ---- a table ----

static bool counts(const swFields* fields, const swField* field, const void* def)
{
    if (fields->kind < 0 || field->kinds == 0)
    {
        return true;
    }
    double kind = getNumber(&fields->fields[fields->kind], def, 0);
    return kind >= 0.0 && kind < 32.0 && (field->kinds >> (int)kind & 1) != 0;
}

bool swFields_Counts(const swFields* fields, const swField* field, const void* def)
{
    SW_REQUIRE(fields != NULL && field != NULL && def != NULL, false, NULL,
               "swFields_Counts() needs a table, a field of it and a def");
    return counts(fields, field, def);
}

const swField* swFields_Find(const swFields* fields, const char* member)
{
    SW_REQUIRE(fields != NULL && member != NULL, NULL, NULL, "swFields_Find() needs a table and the name of a member");
    size_t length = strcspn(member, ".");
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        if (strlen(field->member) == length && memcmp(field->member, member, length) == 0)
        {
            bool isWhole = member[length] == '\0';
            return isWhole ? field : field->fields != NULL ? swFields_Find(field->fields, member + length + 1) : NULL;
        }
    }
    return NULL;
}

static int getCookie(const swFields* fields, const void* def)
{
    int cookie;
    memcpy(&cookie, (const char*)def + fields->cookieOffset, sizeof cookie);
    return cookie;
}

void swFillDef(const swFields* fields, void* def)
{
    memset(def, 0, fields->size);
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        for (int k = 0; k < field->count && isNumber(field); ++k)
        {
            setNumber(field, def, k, field->defaults[k]);
        }
        bool isDef = field->type == SW_FIELD_DEF || field->type == SW_FIELD_DEFS;
        for (int k = 0; k < field->count && isDef; ++k)
        {
            swFillDef(field->fields, (char*)def + field->offset + (size_t)k * getPartSize(field));
        }
    }
    if (fields->cookie != 0)
    {
        memcpy((char*)def + fields->cookieOffset, &fields->cookie, sizeof fields->cookie);
    }
}

// ---- the check ----

// Where a struct is in the def, and where what is wrong goes. The words are made when they are needed only: queries
// check a def in every call.
typedef struct Place
{
    const struct Place* outer; // NULL of the def itself
    const swFields* fields;
    const swField* field; // of the outer struct; its index is -1 if it is no array
    int index;
    char* sentence;
    size_t size;
} Place;

// "swWaveSystemDef::components[3]."
static int writePlace(const Place* place, char* text, int size)
{
    if (place->outer == NULL)
    {
        return snprintf(text, (size_t)size, "%s::", place->fields->name);
    }
    int used = writePlace(place->outer, text, size);
    char number[16] = "";
    if (place->index >= 0)
    {
        snprintf(number, sizeof number, "[%d]", place->index);
    }
    return used < size ? used + snprintf(text + used, (size_t)(size - used), "%s%s.", place->field->member, number)
                       : used;
}

static bool complain(const Place* place, const char* format, ...) SW_PRINTF(2, 3);

// The place, then the words; always false.
static bool complain(const Place* place, const char* format, ...)
{
    int size = place->size < 1024 ? (int)place->size : 1024;
    if (place->sentence == NULL || size == 0)
    {
        return false;
    }
    int used = writePlace(place, place->sentence, size);
    if (used < size)
    {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(place->sentence + used, (size_t)(size - used), format, arguments);
        va_end(arguments);
    }
    return false;
}

static bool failNumber(const Place* place, const swField* field, double value, int index)
{
    static const char* const parts[] = {".x", ".y", ".z", ".w"};
    bool isAngle = field->form == SW_FORM_DEGREES || field->form == SW_FORM_BEARING;
    const char* unit = isAngle ? "rad" : field->unit;
    return complain(place, "%s%s is %.8g%s%s; its range is %s%.10g, %.10g%s.", field->member,
                    field->count > 1 && index < 4 ? parts[index] : "", value, unit[0] != '\0' ? " " : "", unit,
                    field->isLowOpen ? "(" : "[", field->low, field->high, field->isHighOpen ? ")" : "]");
}

static bool checkFields(const Place* place, const void* def);

// A struct in the def; `index` is -1 of one that stands alone.
static bool checkPart(const Place* outer, const swField* field, const void* part, int index)
{
    const swFields* fields = field->fields;
    const Place place = {outer, fields, field, index, outer->sentence, outer->size};
    if (fields->cookie != 0 && getCookie(fields, part) != fields->cookie)
    {
        return complain(outer, "%s was not made by swDefault%s().", field->member, fields->name + 2);
    }
    return checkFields(&place, part);
}

static bool checkList(const Place* place, const swField* field, const void* def)
{
    int count;
    const char* items;
    memcpy(&count, (const char*)def + field->countOffset, sizeof count);
    memcpy(&items, (const char*)def + field->offset, sizeof items);
    if (count < 0 || count > field->count || (count > 0 && items == NULL))
    {
        return complain(place, "%s is %s with %d items; its range is [0, %d].", field->member,
                        items == NULL ? "NULL" : "a list", count, field->count);
    }
    for (int i = 0; i < count; ++i)
    {
        if (!checkPart(place, field, items + (size_t)i * field->fields->size, i))
        {
            return false;
        }
    }
    return true;
}

static bool checkNumbers(const Place* place, const swField* field, const void* def)
{
    for (int i = 0; i < field->count && field->type != SW_FIELD_BOOL; ++i)
    {
        double value = getNumber(field, def, i);
        if (!isInRange(field, value))
        {
            return failNumber(place, field, value, i);
        }
    }
    return true;
}

static bool checkField(const Place* place, const swField* field, const void* def)
{
    bool isFine = true;
    switch (field->type)
    {
    case SW_FIELD_TEXT:
    case SW_FIELD_GIVEN:
        return true;
    case SW_FIELD_LIST:
        return checkList(place, field, def);
    case SW_FIELD_DEF:
    case SW_FIELD_DEFS:
        for (int i = 0; i < field->count && isFine; ++i)
        {
            const char* part = (const char*)def + field->offset + (size_t)i * getPartSize(field);
            isFine = checkPart(place, field, part, field->type == SW_FIELD_DEFS ? i : -1);
        }
        return isFine;
    default:
        return checkNumbers(place, field, def);
    }
}

// The kind first: whether the others count hangs on it.
static bool checkFields(const Place* place, const void* def)
{
    const swFields* fields = place->fields;
    if (fields->kind >= 0 && !checkField(place, &fields->fields[fields->kind], def))
    {
        return false;
    }
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        if (counts(fields, field, def) && !checkField(place, field, def))
        {
            return false;
        }
    }
    return true;
}

bool swFields_Check(const swFields* fields, const void* def, char* sentence, size_t size)
{
    SW_REQUIRE(fields != NULL && def != NULL, false, NULL, "swFields_Check() needs a table and a def");
    const Place place = {.fields = fields, .index = -1, .sentence = sentence, .size = size};
    if (fields->cookie != 0 && getCookie(fields, def) != fields->cookie)
    {
        if (sentence != NULL && size > 0)
        {
            snprintf(sentence, size, "The %s was not made by swDefault%s().", fields->name, fields->name + 2);
        }
        return false;
    }
    return checkFields(&place, def);
}

swResult swCheckDef(const swHost* host, const swFields* fields, const void* def)
{
    char sentence[320];
    bool isFine = swFields_Check(fields, def, sentence, sizeof sentence);
    return isFine ? SW_SUCCESS : swFail(host, SW_ERROR_INVALID, "%s", sentence);
}

// ---- equality ----

static bool isSameList(const swField* field, const void* a, const void* b)
{
    int counts[2];
    const char* items[2];
    const void* defs[2] = {a, b};
    for (int i = 0; i < 2; ++i)
    {
        memcpy(&counts[i], (const char*)defs[i] + field->countOffset, sizeof counts[i]);
        memcpy(&items[i], (const char*)defs[i] + field->offset, sizeof items[i]);
    }
    bool isSame = counts[0] == counts[1];
    for (int i = 0; i < counts[0] && isSame; ++i)
    {
        size_t at = (size_t)i * field->fields->size;
        isSame = swIsSameDef(field->fields, items[0] + at, items[1] + at);
    }
    return isSame;
}

static bool isSameField(const swField* field, const void* a, const void* b)
{
    const char* x = (const char*)a + field->offset;
    const char* y = (const char*)b + field->offset;
    switch (field->type)
    {
    case SW_FIELD_TEXT:
        return strncmp(x, y, field->size) == 0;
    case SW_FIELD_GIVEN:
        return true;
    case SW_FIELD_LIST:
        return isSameList(field, a, b);
    default:
        break;
    }
    for (int i = 0; i < field->count; ++i)
    {
        size_t at = (size_t)i * getPartSize(field);
        double u = isNumber(field) ? getNumber(field, a, i) : 0.0;
        double v = isNumber(field) ? getNumber(field, b, i) : 0.0;
        bool isSame = isNumber(field) ? u == v || (isnan(u) && isnan(v)) : swIsSameDef(field->fields, x + at, y + at);
        if (!isSame)
        {
            return false;
        }
    }
    return true;
}

// Of defs of different kinds the kind itself tells.
bool swIsSameDef(const swFields* fields, const void* a, const void* b)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        if (counts(fields, field, a) && !isSameField(field, a, b))
        {
            return false;
        }
    }
    return true;
}

bool swFields_AreEqual(const swFields* fields, const void* a, const void* b)
{
    SW_REQUIRE(fields != NULL && a != NULL && b != NULL, false, NULL, "swFields_AreEqual() needs a table and two defs");
    return swIsSameDef(fields, a, b);
}

// ---- bytes and digests ----

static void streamNumber(swStream* stream, const swField* field, void* def, int index)
{
    char* at = (char*)def + getPartOffset(field, index);
    switch (field->type)
    {
    case SW_FIELD_BOOL:
        swStreamBool(stream, (bool*)(void*)at);
        break;
    case SW_FIELD_CHOICE:
        swStreamRange(stream, (int*)(void*)at, 0, (int)field->high);
        break;
    case SW_FIELD_INT:
        swStreamI32(stream, (int*)(void*)at);
        break;
    case SW_FIELD_UINT:
        swStreamU32(stream, (uint32_t*)(void*)at);
        break;
    case SW_FIELD_SIZE:
    {
        size_t size;
        memcpy(&size, at, sizeof size);
        uint64_t word = size;
        swStreamU64(stream, &word);
        if (swIsReading(stream))
        {
            size = (size_t)word;
            memcpy(at, &size, sizeof size);
        }
        break;
    }
    case SW_FIELD_FLOAT:
    case SW_FIELD_FLOATS:
        swStreamF32(stream, (float*)(void*)at);
        break;
    default:
        swStreamF64(stream, (double*)(void*)at);
        break;
    }
}

// Its length, then eight bytes at a time.
static void streamText(swStream* stream, const swField* field, void* def)
{
    char* text = (char*)def + field->offset;
    int length = 0;
    while (!swIsReading(stream) && length < (int)field->size - 1 && text[length] != '\0')
    {
        length += 1;
    }
    swStreamRange(stream, &length, 0, (int)field->size - 1);
    for (int i = 0; i < length; i += 8)
    {
        uint64_t word = 0;
        for (int k = 0; k < 8 && i + k < length; ++k)
        {
            word |= (uint64_t)(unsigned char)text[i + k] << (8 * k);
        }
        swStreamU64(stream, &word);
        for (int k = 0; k < 8 && i + k < length && swIsReading(stream); ++k)
        {
            text[i + k] = (char)(word >> (8 * k) & 255);
        }
    }
    if (swIsReading(stream))
    {
        text[length] = '\0';
        stream->isBroken = stream->isBroken || strlen(text) != (size_t)length;
    }
}

void swStreamDef(swStream* stream, const swFields* fields, void* def)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        bool isDef = field->type == SW_FIELD_DEF || field->type == SW_FIELD_DEFS;
        for (int k = 0; k < field->count && field->use != SW_USE_HERE; ++k)
        {
            if (field->type == SW_FIELD_TEXT)
            {
                streamText(stream, field, def);
            }
            else if (isNumber(field))
            {
                streamNumber(stream, field, def, k);
            }
            else if (isDef)
            {
                swStreamDef(stream, field->fields, (char*)def + field->offset + (size_t)k * getPartSize(field));
            }
        }
    }
}

void swHashDef(swHash* hash, const swFields* fields, const void* def)
{
    for (int i = 0; i < fields->count; ++i)
    {
        const swField* field = &fields->fields[i];
        bool isDef = field->type == SW_FIELD_DEF || field->type == SW_FIELD_DEFS;
        for (int k = 0; k < field->count && field->use == SW_USE_SEA; ++k)
        {
            if (isNumber(field))
            {
                swAddHashDouble(hash, getNumber(field, def, k));
            }
            else if (isDef)
            {
                swHashDef(hash, field->fields, (const char*)def + field->offset + (size_t)k * getPartSize(field));
            }
        }
    }
}
