// SPDX-License-Identifier: MIT
#pragma once

// Text that others wrote, such as names of files and what stands in them, made fit for a terminal: a control sequence
// in a name must not move the cursor, colour the screen or hide a line.

#include <stddef.h>

// Bytes of the character that a text begins with; 0 if it is a control character or not UTF-8. Not for the empty text.
size_t MeasureCharacter(const char* text);

// Copy a text; what MeasureCharacter() does not take becomes \xNN, a line break too. What has no room is cut
// off, and the copy then ends with "...". Returns the copy.
const char* CopyPrintable(char* copy, size_t size, const char* text);
