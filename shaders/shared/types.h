// SPDX-License-Identifier: MIT
// Lets one text be C and GLSL: parameter blocks with std430 layout (only float, sw_uint, sw_int and vectors of them; a
// vec4 starts on 16 bytes) and scalar formulas.
#ifndef SW_SHARED_TYPES_H
#define SW_SHARED_TYPES_H

#ifdef __STDC__

#include <assert.h>
#include <stdint.h>
#include "seaway/math.h"
typedef uint32_t sw_uint;
typedef int32_t sw_int;
typedef swVec2 sw_vec2;
typedef swVec4 sw_vec4;
#define SW_PARAMS(name)                                                                                                \
    typedef struct name name;                                                                                          \
    struct name
#define SW_PARAMS_SIZE(name, size) static_assert(sizeof(name) == (size), #name " differs between C and GLSL")
#define SW_FORMULA static inline
#define SW_FLOAT(x) ((float)(x))

#else

#define sw_uint uint
#define sw_int int
#define sw_vec2 vec2
#define sw_vec4 vec4
#define SW_PARAMS(name) struct name
#define SW_PARAMS_SIZE(name, size)
#define SW_FORMULA
#define SW_FLOAT(x) float(x)

#endif
#endif
