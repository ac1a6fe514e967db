// SPDX-License-Identifier: MIT
#pragma once

// Pictures to files. Rows from the top, three components a pixel, no padding. All complain and return false on failure
// and leave no partial file under the name.

#include <stdbool.h>
#include <stdint.h>

// 8 bits, sRGB.
bool WritePng(const char* path, int width, int height, const uint8_t* rgb);

// Linear light, half or single precision, ZIP compressed.
bool WriteExr(const char* path, int width, int height, const float* rgb, bool asHalf);
