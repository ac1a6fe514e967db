// SPDX-License-Identifier: MIT
#include "text.h"

#include <stdio.h>
#include <string.h>

// Longer forms than needed, surrogates and what lies beyond Unicode are no UTF-8.
static int IsWithinRange(const unsigned char* c, size_t size)
{
    switch (size)
    {
    case 2:
        return c[0] > 0xc2 || (c[0] == 0xc2 && c[1] >= 0xa0); // below are the controls of Latin-1
    case 3:
        return !(c[0] == 0xe0 && c[1] < 0xa0) && !(c[0] == 0xed && c[1] >= 0xa0);
    default:
        return !(c[0] == 0xf0 && c[1] < 0x90) && !(c[0] == 0xf4 && c[1] >= 0x90) && c[0] <= 0xf4;
    }
}

size_t MeasureCharacter(const char* text)
{
    const unsigned char* c = (const unsigned char*)text;
    if (c[0] < 0x80)
    {
        return c[0] >= 0x20 && c[0] != 0x7f ? 1 : 0;
    }
    size_t size = c[0] >= 0xf0 ? 4 : c[0] >= 0xe0 ? 3 : c[0] >= 0xc2 ? 2 : 0;
    for (size_t i = 1; i < size; ++i)
    {
        if ((c[i] & 0xc0) != 0x80)
        {
            return 0;
        }
    }
    return size > 0 && IsWithinRange(c, size) ? size : 0;
}

const char* CopyPrintable(char* copy, size_t size, const char* text)
{
    size_t used = 0;
    while (*text != 0)
    {
        size_t length = MeasureCharacter(text);
        size_t written = length > 0 ? length : 4;
        if (used + written + 4 > size) // room for "..." and the zero
        {
            memcpy(copy + used, "...", 3);
            used += 3;
            break;
        }
        if (length > 0)
        {
            memcpy(copy + used, text, length);
        }
        else
        {
            char escape[5];
            snprintf(escape, sizeof(escape), "\\x%02x", *(const unsigned char*)text);
            memcpy(copy + used, escape, 4);
        }
        used += written;
        text += length > 0 ? length : 1;
    }
    copy[used] = 0;
    return copy;
}
