// SPDX-License-Identifier: MIT
#pragma once

// What the fuzz targets share.

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "seaway/base.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

// An assertion that no build type removes.
#define FUZZ_CHECK(condition)                                                                                          \
    do                                                                                                                 \
    {                                                                                                                  \
        if (!(condition))                                                                                              \
        {                                                                                                              \
            fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #condition);                                  \
            abort();                                                                                                   \
        }                                                                                                              \
    } while (0)

// For swHost::log; the context is an int.
static inline void CountMessage(void* context, swLogLevel level, const char* message)
{
    (void)level;
    (void)message;
    ++*(int*)context;
}
