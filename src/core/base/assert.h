// SPDX-License-Identifier: MIT
#pragma once

// SW_ASSERT reports misuse by the caller; without NDEBUG it stops, with it the call goes on and must do nothing.

#include <assert.h>

#define SW_ASSERT(condition) assert(condition)

#if defined(SW_VALIDATE) && SW_VALIDATE
#define SW_CHECK(condition) assert(condition)
#else
#define SW_CHECK(condition) ((void)0)
#endif
