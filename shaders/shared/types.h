// SPDX-License-Identifier: MIT
// Lets one text be C and GLSL: parameter blocks with std430 layout (only float, sw_uint, sw_int and vectors of them;
// a vec3 or vec4 starts on 16 bytes, and what follows a vec3 fills its fourth place) and scalar formulas.
#ifndef SW_SHARED_TYPES_H
#define SW_SHARED_TYPES_H

#ifdef __STDC__

#include <assert.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "seaway/math.h"
typedef uint32_t sw_uint;
typedef int32_t sw_int;
typedef swVec2 sw_vec2;
typedef swVec3 sw_vec3;
typedef swVec4 sw_vec4;
#define SW_PARAMS(name)                                                                                                \
    typedef struct name name;                                                                                          \
    struct name
#define SW_PARAMS_SIZE(name, size) static_assert(sizeof(name) == (size), #name " differs between C and GLSL")
#define SW_PARAMS_VEC3(name, member)                                                                                   \
    static_assert(offsetof(name, member) % 16 == 0, #name "." #member " differs between C and GLSL")
#define SW_FORMULA static inline
#define SW_FLOAT(x) ((float)(x))
#define SW_UINT(x) ((sw_uint)(x))
#define SW_INT(x) ((sw_int)(x))

#else

#define sw_uint uint
#define sw_int int
#define sw_vec2 vec2
#define sw_vec3 vec3
#define sw_vec4 vec4
#define SW_PARAMS(name) struct name
#define SW_PARAMS_SIZE(name, size)
#define SW_PARAMS_VEC3(name, member)
#define SW_FORMULA
#define SW_FLOAT(x) float(x)
#define SW_UINT(x) uint(x)
#define SW_INT(x) int(x)

#endif
#endif
