// SPDX-License-Identifier: MIT
#pragma once

// What the def of a wave system is.

#include "core/base/field.h"
#include "seaway/waves.h"

extern const swFields swWaveSystemFields;
extern const swFields swWaveComponentFields;

// What the table and its cross rules ask for; SW_ERROR_INVALID and a sentence in the log otherwise.
swResult swCheckWaveSystemDef(const swHost* host, const swWaveSystemDef* def);

// Whether two checked defs make the same waves, whatever their weights. Tables are compared by what they hold.
bool swAreSameWaves(const swWaveSystemDef* a, const swWaveSystemDef* b);
