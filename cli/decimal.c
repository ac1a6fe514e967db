// SPDX-License-Identifier: MIT
#include "decimal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

const char* FormatExact(char* text, double value)
{
    for (int digits = 15; digits <= 17; ++digits)
    {
        snprintf(text, DECIMAL_SIZE, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
        {
            break;
        }
    }
    return text;
}

double StepDecimal(double begin, double step, int index)
{
    const double lastBit = 0x1p-52; // as a part
    double way = step * index, sum = begin + way;
    char text[DECIMAL_SIZE];
    snprintf(text, sizeof(text), "%.15g", sum);
    double decimal = strtod(text, NULL);
    double largest = fmax(fmax(fabs(begin), fabs(way)), fabs(sum));
    return fabs(decimal - sum) <= 2.0 * lastBit * largest ? decimal : sum;
}
