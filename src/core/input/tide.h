// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/field.h"
#include "seaway/tide.h"

extern const swFields swTideConstituentFields;
