// SPDX-License-Identifier: MIT
#pragma once

// The inputs that a world has: handles, data, and the flat set that a step makes of them. Memory is taken when an input
// is made or set; a step only makes records, boxes and trees anew, where something changed.

#include "core/base/array.h"
#include "core/base/id_pool.h"
#include "core/base/memory.h"
#include "core/input/even_flow.h"
#include "core/input/input_arrays.h"
#include "core/input/input_record.h"

typedef struct swInput
{
    bool isUsed;
    bool isTouched; // since the last step
    uint32_t generation;
    uint64_t serial;   // grows with every input made
    swInputDef def;    // its place is in the sea; its pointers are those of `data`
    uint32_t flags;    // that its record has beside those of its def
    swInputData* data; // NULL of shapes that have none
} swInput;

typedef struct swInputs
{
    swMemory* memory;
    const swIdPool* systemIds; // the world's
    double seaLevel;
    swArray slots;     // swInput
    int count;         // of inputs
    uint64_t serials;  // given so far
    bool isChanged;    // records are to be made anew
    swInputData* dead; // freed with the next step

    uint32_t* order; // [orderCapacity] slots by field, order and serial
    int orderCapacity;
    int64_t ticks;        // of the last step, from where changes begin
    swEvenFlow evenFlow;  // as it was then
    swInputArrays arrays; // as the last step made them
    swInputChanges changes;
} swInputs;

void swBeginInputs(swInputs* inputs, swMemory* memory, const swIdPool* systemIds, double seaLevel);
void swEndInputs(swInputs* inputs);

// Defs have their place in the sea and were checked. SW_ERROR_NO_MEMORY, SW_ERROR_LIMIT; then nothing is made.
swResult swAddInput(swInputs* inputs, const swInputDef* def, swId* id);
swResult swChangeInput(swInputs* inputs, swInput* input, const swInputDef* def);
void swRemoveInput(swInputs* inputs, swInput* input);

// What it says is another thing from the next step on.
void swTouchInput(swInputs* inputs, swInput* input);

// NULL for a handle that is null or stale.
swInput* swFindInput(const swInputs* inputs, swId id);
swId swGetInputId(const swInputs* inputs, const swInput* input);
swInput* swGetInputAt(const swInputs* inputs, int index); // in the order in which they join

// For saved worlds: an input in a slot of its own, which is the next one; a slot that is free; an input that is as it
// was, with the data that it has and points that were written there.
swResult swRestoreInput(swInputs* inputs, const swInputDef* def, int slot, uint32_t generation, uint64_t serial);
swResult swRestoreFreeSlot(swInputs* inputs, int slot, uint32_t generation);
void swRewindInput(swInputs* inputs, swInput* input, const swInputDef* def, uint64_t serial);

void swSetInputPoints(swInputs* inputs, swInput* input, int count, const swInputPoint* points);

// Make the set of a time, with what was ordered since the last step, in arrays that have room for all inputs.
// `localSystems` as swInputSet has it.
void swFillInputArrays(const swInputs* inputs, double time, uint32_t localSystems, swInputArrays* arrays);

// The flow that is the same everywhere under the inputs that `arrays` were just filled with, at a time.
void swFindEvenFlow(const swInputs* inputs, const swInputArrays* arrays, int64_t ticks, swEvenFlow* flow);

// The world's own set, anew where something changed. Allocates nothing.
void swStepInputs(swInputs* inputs, double time, int64_t ticks, uint32_t localSystems);
