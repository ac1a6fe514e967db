// SPDX-License-Identifier: MIT
//@ before #include "core/world/world.h"
#include "core/sim/wetness.h"
//@ before SW_CHOICE(isa,
SW_PART(wetness, &swWetnessFields, .key = "wetness", .label = "wetness"),
