// SPDX-License-Identifier: MIT
#pragma once

// Barriers of a frame, from what its steps read and write. A step is a pass or a run of copies; it waits if it touches
// what an earlier step has written, or writes what an earlier step reads, and nothing has waited for that since.
// Barriers are global memory barriers, so one makes everything that was written visible to the step's stage at once.

#include <stdbool.h>
#include <stdint.h>

// Where steps run. The host only reads, after the frame.
typedef enum swStepStage
{
    SW_STAGE_COMPUTE,
    SW_STAGE_COPY,
    SW_STAGE_COUNT
} swStepStage;

// Sets of what is read and written, a bit each.
typedef uint64_t swResources;

// [by][seen by]: what steps of one stage have written or read that steps of another have not waited for yet.
typedef struct swHazards
{
    swResources written[SW_STAGE_COUNT][SW_STAGE_COUNT];
    swResources read[SW_STAGE_COUNT][SW_STAGE_COUNT];
} swHazards;

// Note a step. Returns the stages that it must wait for, a bit each; 0: no barrier.
uint32_t swTakeStep(swHazards* hazards, swStepStage stage, swResources reads, swResources writes);
