// SPDX-License-Identifier: MIT
// Reading: digits M and an exponent E are the number M 10^E. Up to 15 digits and 10^22 one operation on doubles rounds
// correctly. Beyond that M 10^E is a quotient of two large integers, divided bit by bit and rounded to even.

#include "scene/exact_number.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/number.h"

#define WORDS 20 // of 32 bits: 10^80 shifted by 64 bits needs 11

typedef struct Large
{
    uint32_t words[WORDS]; // least first
} Large;

static void multiply(Large* number, uint32_t factor)
{
    uint64_t carry = 0;
    for (int i = 0; i < WORDS; ++i)
    {
        carry += (uint64_t)number->words[i] * factor;
        number->words[i] = (uint32_t)carry;
        carry >>= 32;
    }
}

static int countBits(const Large* number)
{
    int bits = 32 * WORDS;
    while (bits > 0 && (number->words[(bits - 1) / 32] >> ((bits - 1) % 32) & 1u) == 0)
    {
        --bits;
    }
    return bits;
}

static void shiftUp(Large* number, int bits)
{
    for (; bits >= 16; bits -= 16)
    {
        multiply(number, 1u << 16);
    }
    multiply(number, 1u << bits);
}

static void halve(Large* number)
{
    for (int i = 0; i < WORDS; ++i)
    {
        number->words[i] = number->words[i] >> 1 | (i + 1 < WORDS ? number->words[i + 1] << 31 : 0);
    }
}

// Take `less` away if the number is not smaller.
static bool subtract(Large* number, const Large* less)
{
    Large left;
    uint64_t borrow = 0;
    for (int i = 0; i < WORDS; ++i)
    {
        uint64_t difference = (uint64_t)number->words[i] - less->words[i] - borrow;
        left.words[i] = (uint32_t)difference;
        borrow = difference >> 63;
    }
    if (borrow == 0)
    {
        *number = left;
    }
    return borrow == 0;
}

static double roundQuotient(uint64_t quotient, bool hasRest, int exponent)
{
    int drop = 0;
    while (quotient >> drop >= (uint64_t)1 << 53)
    {
        ++drop;
    }
    uint64_t kept = quotient >> drop, rest = quotient & (((uint64_t)1 << drop) - 1);
    uint64_t half = drop > 0 ? (uint64_t)1 << (drop - 1) : 0;
    bool isUp = drop > 0 && (rest > half || (rest == half && (hasRest || (kept & 1u) != 0)));
    return ldexp((double)(kept + isUp), drop + exponent);
}

static double divide(uint64_t mantissa, int exponent)
{
    Large above = {{(uint32_t)mantissa, (uint32_t)(mantissa >> 32)}}, below = {{1}};
    for (int i = abs(exponent); i > 0; --i)
    {
        multiply(exponent > 0 ? &above : &below, 10);
    }
    int shift = 63 - (countBits(&above) - countBits(&below)); // the quotient has 63 or 64 bits
    shiftUp(shift > 0 ? &above : &below, abs(shift));
    shiftUp(&below, 63);
    uint64_t quotient = 0;
    for (int i = 0; i < 64; ++i)
    {
        quotient = quotient << 1 | (subtract(&above, &below) ? 1u : 0u);
        halve(&below);
    }
    return roundQuotient(quotient, countBits(&above) > 0, -shift);
}

bool swParseExactNumber(const char* text, int size, double* value)
{
    if (!swParseNumber(text, size, value))
    {
        return false;
    }
    uint64_t mantissa = 0;
    int digits = 0, exponent = 0, power = 0, i = 0;
    bool isFraction = false;
    for (; i < size && text[i] != 'e' && text[i] != 'E'; ++i)
    {
        bool isDigit = text[i] >= '0' && text[i] <= '9', isKept = isDigit && digits < 19;
        isFraction = isFraction || text[i] == '.';
        mantissa = isKept ? 10 * mantissa + (uint64_t)(text[i] - '0') : mantissa;
        digits += isKept && mantissa > 0;
        exponent += isKept ? (isFraction ? -1 : 0) : isDigit && !isFraction ? 1 : 0;
    }
    bool isBelow = i + 1 < size && text[i + 1] == '-';
    for (++i; i < size; ++i)
    {
        power = text[i] >= '0' && text[i] <= '9' ? 10 * power + (text[i] - '0') : power;
    }
    exponent += isBelow ? -power : power;
    bool isLong = digits > 15 || abs(exponent) > 22;
    if (isLong && mantissa > 0 && exponent >= -80 && exponent <= 60 && fabs(*value) < 1e60)
    {
        *value = copysign(divide(mantissa, exponent), *value);
    }
    return true;
}

// 0.0001 to 9,999,999 are written out, others as 1.5e-7.
void swPrintDigits(double value, int digits, char text[SW_NUMBER_TEXT])
{
    char printed[SW_NUMBER_TEXT], kept[20] = "";
    int count = 0, exponent = 0, used = 0;
    snprintf(printed, sizeof(printed), "%.*e", digits - 1, value);
    const char* c = printed;
    for (; *c != 'e' && *c != '\0'; ++c) // the locale's decimal point is passed over
    {
        if (*c >= '0' && *c <= '9' && count < 17)
        {
            kept[count++] = *c;
        }
    }
    exponent = *c == 'e' ? atoi(c + 1) : 0;
    while (count > 1 && kept[count - 1] == '0')
    {
        --count;
    }
    const char* sign = value < 0.0 ? "-" : "";
    if (exponent < -4 || exponent > 6)
    {
        snprintf(text, SW_NUMBER_TEXT, "%s%c%s%.*se%d", sign, kept[0], count > 1 ? "." : "", count - 1, kept + 1,
                 exponent);
        return;
    }
    used = snprintf(text, SW_NUMBER_TEXT, "%s%s", sign, exponent < 0 ? "0." : "");
    for (int place = exponent < 0 ? -1 : exponent; place >= 0 || exponent - place < count; --place)
    {
        int index = exponent - place;
        used += snprintf(text + used, (size_t)(SW_NUMBER_TEXT - used), "%s%c", place == -1 && exponent >= 0 ? "." : "",
                         index >= 0 && index < count ? kept[index] : '0');
    }
}
