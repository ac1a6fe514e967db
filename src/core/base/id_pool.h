// SPDX-License-Identifier: MIT
#pragma once

// Handles of up to `capacity` objects that live in an array of the owner's: index1 is the slot plus one, and a slot's
// generation grows with every use, so that a stale handle is caught (after 2^32 uses of one slot it no longer is).
// Freed slots are used again in order of index, so that the order of slots depends only on the calls made.

#include "seaway/base.h"

#define SW_ID_POOL_CAPACITY 64

typedef struct swIdPool
{
    int capacity; // at most SW_ID_POOL_CAPACITY
    int count;
    uint64_t used; // bit per slot
    uint32_t generations[SW_ID_POOL_CAPACITY];
} swIdPool;

// Any handle: every public id type has these two members.
typedef struct swId
{
    int32_t index1;
    uint32_t generation;
} swId;

swIdPool swMakeIdPool(int capacity);
// Null if all slots are in use.
swId swAllocId(swIdPool* pool);
void swFreeId(swIdPool* pool, swId id);
bool swIsIdValid(const swIdPool* pool, swId id);
bool swIsSlotUsed(const swIdPool* pool, int slot);
