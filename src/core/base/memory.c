// SPDX-License-Identifier: MIT
#include "core/base/memory.h"

static void* allocateCounted(void* context, size_t size, size_t alignment)
{
    swMemory* memory = context;
    size_t held = atomic_fetch_add(&memory->held, size) + size;
    bool isOver = memory->budget != 0 && held > memory->budget;
    void* block = isOver ? NULL : memory->uncounted->allocate(memory->uncounted->memoryContext, size, alignment);
    memory->held -= block == NULL ? size : 0;
    if (isOver)
    {
        memory->isOverBudget = true;
    }
    return block;
}

static void freeCounted(void* context, void* block, size_t size)
{
    swMemory* memory = context;
    memory->held -= block != NULL ? size : 0;
    memory->uncounted->free(memory->uncounted->memoryContext, block, size);
}

void swBeginMemory(swMemory* memory, const swHost* uncounted, size_t held)
{
    memory->uncounted = uncounted;
    memory->held = held;
    memory->host = *uncounted;
    memory->host.allocate = allocateCounted;
    memory->host.free = freeCounted;
    memory->host.memoryContext = memory;
}

swResult swFailMemory(const swMemory* memory, const char* what)
{
    if (memory->isOverBudget)
    {
        return swFail(memory->uncounted, SW_ERROR_LIMIT,
                      "%s would take the saved world beyond the %zu bytes of memory that it may hold "
                      "(swRestoreDef::memoryBudget)",
                      what, memory->budget);
    }
    return swFail(memory->uncounted, SW_ERROR_NO_MEMORY, "no memory for %s", what);
}
