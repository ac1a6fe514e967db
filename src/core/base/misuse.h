// SPDX-License-Identifier: MIT
#pragma once

// The contract of the API, see seaway/base.h: misuse is told to the host's log in a sentence and stops the program
// where asserts are on. Without them the call does nothing but set what it would have answered to neutral values.

#include "core/base/assert.h"
#include "core/base/host.h"

SW_SEAM_BEGIN

// `host` may be NULL where none can be known, or be no host at all: then nobody is told.
void swTellMisuse(const swHost* host, const char* format, ...) SW_PRINTF(2, 3);

SW_SEAM_END

// At the head of a public function: unless the condition holds, the sentence is told and the function returns
// `neutral`.
#define SW_REQUIRE(condition, neutral, host, ...)                                                                      \
    do                                                                                                                 \
    {                                                                                                                  \
        if (!(condition))                                                                                              \
        {                                                                                                              \
            swTellMisuse((host), __VA_ARGS__);                                                                         \
            SW_ASSERT(condition);                                                                                      \
            return neutral;                                                                                            \
        }                                                                                                              \
    } while (0)

// At the head of a function that makes an object by a host: `place` is NULL until the object is there.
#define SW_REQUIRE_PLACE(host, place, call)                                                                            \
    do                                                                                                                 \
    {                                                                                                                  \
        if ((place) != NULL)                                                                                           \
        {                                                                                                              \
            *(place) = NULL;                                                                                           \
        }                                                                                                              \
        SW_REQUIRE(swIsHostValid(host), SW_ERROR_INVALID, host, call " needs a host made by swDefaultHost()");         \
        SW_REQUIRE((place) != NULL, SW_ERROR_INVALID, host, call " needs a place for what it makes");                  \
    } while (0)

// SW_REQUIRE() in a function that returns nothing.
#define SW_REQUIRE_VOID(condition, host, ...)                                                                          \
    do                                                                                                                 \
    {                                                                                                                  \
        if (!(condition))                                                                                              \
        {                                                                                                              \
            swTellMisuse((host), __VA_ARGS__);                                                                         \
            SW_ASSERT(condition);                                                                                      \
            return;                                                                                                    \
        }                                                                                                              \
    } while (0)
