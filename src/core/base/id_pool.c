// SPDX-License-Identifier: MIT
#include "core/base/id_pool.h"

#include "core/base/assert.h"

swIdPool swMakeIdPool(int capacity)
{
    SW_ASSERT(0 < capacity && capacity <= SW_ID_POOL_CAPACITY);
    return (swIdPool){.capacity = capacity};
}

swId swAllocId(swIdPool* pool)
{
    for (int slot = 0; slot < pool->capacity; ++slot)
    {
        if (!swIsSlotUsed(pool, slot))
        {
            pool->used |= (uint64_t)1 << slot;
            pool->count += 1;
            pool->generations[slot] += 1;
            return (swId){slot + 1, pool->generations[slot]};
        }
    }
    return (swId){0, 0};
}

void swFreeId(swIdPool* pool, swId id)
{
    SW_ASSERT(swIsIdValid(pool, id));
    pool->used &= ~((uint64_t)1 << (id.index1 - 1));
    pool->count -= 1;
}

bool swIsIdValid(const swIdPool* pool, swId id)
{
    return 0 < id.index1 && id.index1 <= pool->capacity && swIsSlotUsed(pool, id.index1 - 1) &&
           pool->generations[id.index1 - 1] == id.generation;
}

bool swIsSlotUsed(const swIdPool* pool, int slot)
{
    return (pool->used >> slot & 1) != 0;
}
