// SPDX-License-Identifier: MIT
#pragma once

// The flow that is the same everywhere: what inputs that are everywhere say of it together. It carries all waves alike,
// which is exact, by the path of swEvenFlow; what other inputs say beside it carries copies of the waves.
//
// The path is known in a closed form where the sum is linear in the tides of its inputs: they are added, mixed in,
// replace what is below or multiply it by a number that stands still. Where it is not, or where more than
// SW_EVEN_TIDES inputs have tides, there is no such flow, and copies carry all of it.

#include "core/frame/frame.h"
#include "core/input/input_arrays.h"

#define SW_EVEN_TIDES (SW_MAX_EVEN_SWINGS / SW_MAX_TIDE)

// What the records of a set say: swInputSet::evenX, evenZ and what flows there are.
void swFindSetFlow(swInputSet* set);

// Go on with the path under the inputs of `set`, from `changed` on if their flow is another one than `flow` had; it is
// then known at `ticks`. `defs` holds the def of each record.
typedef const swInputDef* swGetRecordDef(const void* context, int record);
void swPlanEvenFlow(const swInputSet* set, swGetRecordDef* getDef, const void* context, int64_t changed, int64_t ticks,
                    swEvenFlow* flow);

// Whether one that comes from elsewhere has only numbers that could be.
bool swIsEvenFlowGood(const swEvenFlow* flow);
