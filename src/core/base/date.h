// SPDX-License-Identifier: MIT
#pragma once

// Dates of the Gregorian calendar, UTC.

#include <stdbool.h>
#include <stdint.h>

#include "core/base/seam.h"

SW_SEAM_BEGIN

// Minutes since 1970 of a UTC date, and back as "YYYY-MM-DD hh:mm" (20 bytes). Years 1900 to 2199.
int64_t swGetMinutes(int year, int month, int day, int hour, int minute);
void swPrintMinutes(int64_t minutes, char text[20]);
int swGetDaysInMonth(int year, int month);

// Seconds since 1970; false if there is no such date.
bool swMakeSeconds(int year, int month, int day, int hour, int minute, double second, double* seconds);

// 1 to 12 by the first English name of a month, or its first three letters, in text[0 .. size); 0 if there is none.
int swFindMonth(const char* text, int size);

// yyyymmdd and hhmmss as numbers; false if there is no such date.
bool swMakePackedSeconds(double date, double time, double* seconds);

SW_SEAM_END
