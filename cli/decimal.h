// SPDX-License-Identifier: MIT
#pragma once

// Decimal numbers that mean what was asked.

#define DECIMAL_SIZE 32

// The shortest of 15 to 17 digits that reads back as the same number, into text[DECIMAL_SIZE], which is returned.
const char* FormatExact(char* text, double value);

// begin + step * index. If a decimal of 15 digits is as good a sum but for the last bit of what is added, it is that
// decimal: 3 * 0.1 is 0.3.
double StepDecimal(double begin, double step, int index);
