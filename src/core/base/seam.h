// SPDX-License-Identifier: MIT
#pragma once

// Functions between SW_SEAM_BEGIN and SW_SEAM_END are called by the gpu and scene libraries too, so a shared core
// library keeps them visible although no installed header declares them. Everything else that is internal is hidden.

#if defined(__GNUC__)
#define SW_SEAM_BEGIN _Pragma("GCC visibility push(default)")
#define SW_SEAM_END _Pragma("GCC visibility pop")
#else
#define SW_SEAM_BEGIN
#define SW_SEAM_END
#endif
