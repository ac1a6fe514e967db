// SPDX-License-Identifier: MIT
// Sizes that both halves and all shaders agree on.
#ifndef SW_SHARED_LIMITS_H
#define SW_SHARED_LIMITS_H
#define SW_LIMIT_TILES 64
#define SW_LIMIT_SLICES 15
#define SW_LIMIT_RESOLUTION 512
#endif
