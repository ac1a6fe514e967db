// SPDX-License-Identifier: MIT
#pragma once

// Numbers in text. The C library's parsers follow the locale of the process, which is the host's; this one never does.

#include <stdbool.h>
#include <stdint.h>

// Parse the whole of text[0 .. size): [+-] digits [. digits] [e [+-] digits]. Correctly rounded while 15 digits and
// powers of ten up to 22 suffice. Neither infinity nor NaN can be written.
static inline bool swParseNumber(const char* text, int size, double* value)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    int i = size > 0 && (text[0] == '-' || text[0] == '+') ? 1 : 0;
    bool isNegative = i == 1 && text[0] == '-';
    int64_t mantissa = 0;
    int digits = 0;
    int exponent = 0;
    bool isFraction = false;
    for (; i < size; ++i)
    {
        if (text[i] == '.' && !isFraction)
        {
            isFraction = true;
            continue;
        }
        if (text[i] < '0' || text[i] > '9')
        {
            break;
        }
        ++digits;
        bool isKept = mantissa < 100000000000000;
        mantissa = isKept ? 10 * mantissa + (text[i] - '0') : mantissa;
        exponent += (isKept ? 0 : 1) - (isFraction ? 1 : 0);
    }
    if (digits == 0)
    {
        return false;
    }
    if (i < size && (text[i] == 'e' || text[i] == 'E'))
    {
        ++i;
        int sign = i < size && text[i] == '-' ? -1 : 1;
        i += i < size && (text[i] == '-' || text[i] == '+') ? 1 : 0;
        int power = 0;
        int first = i;
        for (; i < size && i < first + 4 && text[i] >= '0' && text[i] <= '9'; ++i)
        {
            power = 10 * power + (text[i] - '0');
        }
        if (i == first)
        {
            return false;
        }
        exponent += sign * power;
    }
    if (i < size)
    {
        return false;
    }
    double magnitude = (double)mantissa;
    if (mantissa == 0 || exponent < -60)
    {
        magnitude = 0.0;
    }
    else if (exponent > 60)
    {
        magnitude = 1e60;
    }
    for (int left = exponent; left < 0 && magnitude > 0.0; left += 22)
    {
        magnitude /= powers[left < -22 ? 22 : -left];
    }
    for (int left = exponent; left > 0 && magnitude < 1e60 && magnitude > 0.0; left -= 22)
    {
        magnitude *= powers[left > 22 ? 22 : left];
    }
    *value = isNegative ? -magnitude : magnitude;
    return true;
}
