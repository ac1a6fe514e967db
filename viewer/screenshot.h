// SPDX-License-Identifier: MIT
#pragma once

// Pictures to disk.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Find the first "seaway_0001.png" and so on of the working folder that does not exist yet; false if all do.
bool NameScreenshot(char* path, size_t size);

// Write sRGB bytes (r, g, b and one that is ignored) as a PNG. On failure a sentence goes into `reason`.
bool WriteScreenshot(const char* path, const uint8_t* rgba, uint32_t width, uint32_t height, char* reason, size_t size);
