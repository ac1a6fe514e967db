// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/field.h"
#include "seaway/island.h"

extern const swFields swIslandFields;

// Height of an island's ground or floor, m above sea level.
float swFindIsland(const swIslandDef* def, double x, double z);
