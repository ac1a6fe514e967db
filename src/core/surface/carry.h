// SPDX-License-Identifier: MIT
#pragma once

// Waves that a flow carries, as two copies. See shaders/shared/carry.h.

#include "core/surface/places.h"

// Makes two copies of the one that a look has, where `block` has a flow.
void swCarryLook(const swPlaceBlock* block, const swWaveGroup* group, bool withSlopes, swLook* look);

// How far the first copy of a group of waves is in its period, a fraction of 2^32; the second is half a turn ahead.
// `period` is in seconds.
uint32_t swFindCarryPhase(const swWaveGroup* group, int64_t ticks, float* period);
