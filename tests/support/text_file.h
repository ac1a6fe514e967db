// SPDX-License-Identifier: MIT
#pragma once

#include "support/cmocka_setup.h"

#include <stdio.h>
#include <stdlib.h>

// A whole file, ended by a zero; NULL with a message if it is absent.
static inline char* ReadTextFile(const char* path, size_t* size)
{
    FILE* file = fopen(path, "rb");
    if (file == NULL)
    {
        print_message("skipped: %s is absent\n", path);
        return NULL;
    }
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char* text = malloc(*size + 1);
    assert_int_equal(fread(text, 1, *size, file), *size);
    text[*size] = '\0';
    fclose(file);
    return text;
}
