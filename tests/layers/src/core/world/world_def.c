// SPDX-License-Identifier: MIT
//@ before #include "core/world/world.h"
#include "core/sim/wetness.h"
//@ before SW_CHOICE(isa, swIsaWords, swIsaWords, SW_ISA_BEST, .key = NULL, .label = "instruction set", .use = SW_USE_HERE),
SW_PART(wetness, &swWetnessFields, .key = "wetness", .label = "wetness"),
