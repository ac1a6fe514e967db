// SPDX-License-Identifier: MIT
#pragma once

// SW_ASSERT stops at misuse by the caller unless NDEBUG is defined; with it the call goes on and must do nothing.
// Public functions use SW_REQUIRE (misuse.h), which also tells the host's log.

#include <assert.h>

#define SW_ASSERT(condition) assert(condition)

#if defined(SW_VALIDATE) && SW_VALIDATE
#define SW_CHECK(condition) assert(condition)
#else
#define SW_CHECK(condition) ((void)0)
#endif
