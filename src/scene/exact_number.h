// SPDX-License-Identifier: MIT
#pragma once

// Numbers of scene files. What is written is the shortest text that is read as the same number, on every machine and in
// every locale.

#include <stdbool.h>

// As swParseNumber(), and correctly rounded for any number of digits up to 19; those beyond are dropped.
bool swParseExactNumber(const char* text, int size, double* value);

#define SW_NUMBER_TEXT 40 // bytes

// With so many significant digits, 1 to 17.
void swPrintDigits(double value, int digits, char text[SW_NUMBER_TEXT]);
