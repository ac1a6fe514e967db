// SPDX-License-Identifier: MIT
#include "core/world/world.h"

#include "core/base/host.h"

static void* allocateCounted(void* context, size_t size, size_t alignment)
{
    swWorld* world = context;
    size_t held = atomic_fetch_add(&world->memory, size) + size;
    bool isOver = world->memoryBudget != 0 && held > world->memoryBudget;
    void* memory = isOver ? NULL : world->host.allocate(world->host.memoryContext, size, alignment);
    world->memory -= memory == NULL ? size : 0;
    if (isOver)
    {
        world->isOverBudget = true;
    }
    return memory;
}

static void freeCounted(void* context, void* memory, size_t size)
{
    swWorld* world = context;
    world->memory -= memory != NULL ? size : 0;
    world->host.free(world->host.memoryContext, memory, size);
}

swResult swMakeWorld(const swHost* host, const swWorldDef* def, const swWaveKernels* kernels, swWorld** worldOut)
{
    swWorld* world = swAllocateZero(host, sizeof(swWorld));
    if (world == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "no memory for a world (%zu bytes)", sizeof(swWorld));
    }
    world->host = *host;
    world->countedHost = *host;
    world->countedHost.allocate = allocateCounted;
    world->countedHost.free = freeCounted;
    world->countedHost.memoryContext = world;
    world->memory = sizeof(swWorld);
    world->def = *def;
    world->kernels = kernels;
    world->systemIds = swMakeIdPool(SW_MAX_WAVE_SYSTEMS);
    world->frame = (swFrame){
        .seaLevel = def->seaLevel,
        .gravity = def->gravity,
        .foam = def->foam,
        .tiles = world->tiles,
        .waves = world->waves,
        .views = world->viewFrames,
    };
    *worldOut = world;
    return SW_SUCCESS;
}

swResult swFailMemory(const swWorld* world, const char* what)
{
    if (world->isOverBudget)
    {
        return swFail(&world->host, SW_ERROR_LIMIT,
                      "%s would take the saved world beyond the %zu bytes of memory that it may hold "
                      "(swRestoreDef::memoryBudget)",
                      what, world->memoryBudget);
    }
    return swFail(&world->host, SW_ERROR_NO_MEMORY, "no memory for %s", what);
}

void swFreeWorld(swWorld* world)
{
    while (world->viewCount > 0)
    {
        swRemoveView(world->views[world->viewCount - 1]);
    }
    swFreeAllSystems(world);
    swFree(&world->countedHost, world->scratch, world->scratchSize * (size_t)world->host.workerCount);
    swHost host = world->host;
    swFree(&host, world, sizeof(swWorld));
}

const swFrame* swGetWorldFrame(const swWorld* world)
{
    return &world->frame;
}

const swHost* swGetWorldHost(const swWorld* world)
{
    return &world->host;
}

const swHost* swFindHost(const swWorld* world)
{
    return world != NULL ? &world->host : NULL;
}

swPosXZ swGetWorldOrigin(const swWorld* world)
{
    return world->origin;
}
