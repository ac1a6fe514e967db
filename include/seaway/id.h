// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

/// @file
/// Handles of what lives in a world. Pass by value; all zero is null; a handle of something destroyed is caught. They
/// are counted anew in each world, so that machines in lockstep have the same ones: whether one is another world's
/// cannot be seen, keep them apart.

/// A wave system. See waves.h.
typedef struct swWaveSystemId
{
    int32_t index1;
    uint32_t generation;
} swWaveSystemId;

/// Something that the host puts into the sea. See input.h.
typedef struct swInputId
{
    int32_t index1;
    uint32_t generation;
} swInputId;

/// A body of water. See water_body.h.
typedef struct swWaterBodyId
{
    int32_t index1;
    uint32_t generation;
} swWaterBodyId;

#define SW_IS_NULL(id) ((id).index1 == 0)
#define SW_ID_EQUALS(a, b) ((a).index1 == (b).index1 && (a).generation == (b).generation)
