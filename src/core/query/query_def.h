// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/field.h"
#include "seaway/query.h"

extern const swFields swQueryFields;
extern const swFields swRayFields;
