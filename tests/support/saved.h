// SPDX-License-Identifier: MIT
#pragma once

// Saved worlds, and how to sign one that was changed.

#include "support/cmocka_setup.h"

#include <stdlib.h>

#include <seaway/save.h>

#include "core/base/hash.h"

typedef struct Saved
{
    size_t size;
    uint8_t* data;
} Saved;

static inline Saved Save(const swWorld* world)
{
    Saved saved = {0};
    assert_int_equal(swWorld_Save(world, NULL, &saved.size), SW_SUCCESS);
    saved.data = malloc(saved.size);
    assert_non_null(saved.data);
    assert_int_equal(swWorld_Save(world, saved.data, &saved.size), SW_SUCCESS);
    return saved;
}

static inline void Sign(Saved* saved)
{
    swHash hash = swBeginHash();
    size_t size = saved->size - 8;
    for (size_t i = 0; i < size; i += 8)
    {
        uint64_t word = 0;
        for (size_t k = 0; k < 8 && i + k < size; ++k)
        {
            word |= (uint64_t)saved->data[i + k] << (8 * k);
        }
        swAddHash(&hash, word);
    }
    swAddHash(&hash, size);
    uint64_t value = swEndHash(&hash);
    for (int k = 0; k < 8; ++k)
    {
        saved->data[size + (size_t)k] = (unsigned char)(value >> (8 * k));
    }
}
