// SPDX-License-Identifier: MIT
#pragma once

#include <stddef.h>

#include "core/base/seam.h"
#include "seaway/base.h"

// A growing array of the host's memory. All zero is empty.
typedef struct swArray
{
    void* data;
    size_t count;
    size_t capacity;
} swArray;

SW_SEAM_BEGIN

// Room for `count` more items at the end, not cleared; NULL if there is no memory.
void* swAppendItems(const swHost* host, swArray* array, size_t count, size_t itemSize);
void swFreeItems(const swHost* host, swArray* array, size_t itemSize);

SW_SEAM_END
