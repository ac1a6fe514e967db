// SPDX-License-Identifier: MIT
#pragma once

// Memory of a world: a host whose bytes are counted, and which may be held to a budget.

#include <stdatomic.h>

#include "core/base/host.h"

typedef struct swMemory
{
    swHost host;             // the caller's, with its memory counted
    const swHost* uncounted; // the caller's
    atomic_size_t held;      // bytes; workers allocate too
    size_t budget;           // most bytes that may be held; 0: any number
    atomic_bool isOverBudget;
} swMemory;

// `uncounted` must live as long. `held` counts from a size on that is held already.
void swBeginMemory(swMemory* memory, const swHost* uncounted, size_t held);

// There was no memory for something: a sentence in the log, and SW_ERROR_LIMIT if that was because of the budget.
swResult swFailMemory(const swMemory* memory, const char* what);
