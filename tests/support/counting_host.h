// SPDX-License-Identifier: MIT
#pragma once

// A host whose memory is counted and can be made to fail, and whose messages are counted. Any thread.

#include <stdatomic.h>
#include <stdlib.h>

#include <seaway/base.h>

typedef struct CountingMemory
{
    atomic_llong bytes;       // held now
    atomic_llong allocations; // made so far
    atomic_llong failAt;      // index of the allocation that fails; -1: none
    atomic_llong messages;
} CountingMemory;

static inline void* CountedAllocate(void* context, size_t size, size_t alignment)
{
    CountingMemory* memory = context;
    if (atomic_fetch_add(&memory->allocations, 1) == atomic_load(&memory->failAt))
    {
        return NULL;
    }
    void* result = aligned_alloc(alignment, (size + alignment - 1) & ~(alignment - 1));
    atomic_fetch_add(&memory->bytes, result != NULL ? (long long)size : 0);
    return result;
}

static inline void CountedFree(void* context, void* pointer, size_t size)
{
    CountingMemory* memory = context;
    atomic_fetch_sub(&memory->bytes, pointer != NULL ? (long long)size : 0);
    free(pointer);
}

static inline void CountedLog(void* context, swLogLevel level, const char* message)
{
    CountingMemory* memory = context;
    (void)level;
    (void)message;
    atomic_fetch_add(&memory->messages, 1);
}

static inline swHost MakeCountingHost(CountingMemory* memory)
{
    swHost host = swDefaultHost();
    atomic_store(&memory->bytes, 0);
    atomic_store(&memory->allocations, 0);
    atomic_store(&memory->failAt, -1);
    atomic_store(&memory->messages, 0);
    host.allocate = CountedAllocate;
    host.free = CountedFree;
    host.memoryContext = memory;
    host.log = CountedLog;
    host.logContext = memory;
    return host;
}
