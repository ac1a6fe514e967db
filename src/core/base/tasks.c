// SPDX-License-Identifier: MIT
// A pool of threads for hosts without a job system. A parallel loop is one job at a time: the caller publishes it,
// takes part itself as worker 0, and closes it when no item is left; threads that wake in time join, late ones go back
// to sleep. Parts are handed out by an atomic counter, so who does which part varies, which must not change any result.
// A second caller (another world, or a loop inside a task) finds the pool busy and runs its loop alone.

#include <pthread.h>
#include <stdatomic.h>

#include "core/base/misuse.h"

typedef struct swTaskWorker
{
    struct swTaskPool* pool;
    pthread_t thread;
    int index;
} swTaskWorker;

struct swTaskPool
{
    swHost host;
    size_t allocationSize;
    pthread_mutex_t callerMutex; // held by the caller whose loop runs
    pthread_mutex_t mutex;       // guards the job, its number and the counts below
    pthread_cond_t wake;
    pthread_cond_t done;
    uint64_t jobNumber;
    bool isOpen; // threads may still join the job
    bool isQuitting;
    int joinedCount;

    swTaskFcn task;
    void* taskContext;
    int count;
    int part;          // items of one part
    atomic_llong next; // may run past count by a part for each worker

    int threadCount;
    swTaskWorker workers[];
};

static void runParts(swTaskPool* pool, int worker)
{
    for (;;)
    {
        long long next = atomic_fetch_add_explicit(&pool->next, pool->part, memory_order_relaxed);
        if (next >= pool->count)
        {
            return;
        }
        int begin = (int)next;
        int end = pool->count - begin < pool->part ? pool->count : begin + pool->part;
        pool->task(pool->taskContext, begin, end, worker);
    }
}

static void* runWorker(void* argument)
{
    swTaskWorker* worker = argument;
    swTaskPool* pool = worker->pool;
    uint64_t seen = 0;
    pthread_mutex_lock(&pool->mutex);
    for (;;)
    {
        while (!pool->isQuitting && !(pool->isOpen && pool->jobNumber != seen))
        {
            pthread_cond_wait(&pool->wake, &pool->mutex);
        }
        if (pool->isQuitting)
        {
            break;
        }
        seen = pool->jobNumber;
        pool->joinedCount += 1;
        pthread_mutex_unlock(&pool->mutex);

        runParts(pool, worker->index);

        pthread_mutex_lock(&pool->mutex);
        pool->joinedCount -= 1;
        if (pool->joinedCount == 0)
        {
            pthread_cond_signal(&pool->done);
        }
    }
    pthread_mutex_unlock(&pool->mutex);
    return NULL;
}

static void openJob(swTaskPool* pool, swTaskFcn task, void* taskContext, int count, int part)
{
    pthread_mutex_lock(&pool->mutex);
    pool->task = task;
    pool->taskContext = taskContext;
    pool->count = count;
    pool->part = part;
    atomic_store_explicit(&pool->next, 0, memory_order_relaxed);
    pool->jobNumber += 1;
    pool->isOpen = true;
    pthread_cond_broadcast(&pool->wake);
    pthread_mutex_unlock(&pool->mutex);
}

static void closeJob(swTaskPool* pool)
{
    pthread_mutex_lock(&pool->mutex);
    pool->isOpen = false;
    while (pool->joinedCount > 0)
    {
        pthread_cond_wait(&pool->done, &pool->mutex);
    }
    pthread_mutex_unlock(&pool->mutex);
}

// Four parts a worker even out parts of unequal cost; not below the grain.
static int chooseParts(int count, int grain, int workerCount)
{
    int part = count / (4 * workerCount);
    part = part > grain ? part : grain;
    return part > 0 ? part : 1;
}

static void runOnPool(void* context, swTaskFcn task, void* taskContext, int count, int grain)
{
    swTaskPool* pool = context;
    int part = chooseParts(count, grain, pool->threadCount + 1);
    if (part >= count || pool->threadCount == 0 || pthread_mutex_trylock(&pool->callerMutex) != 0)
    {
        if (count > 0)
        {
            task(taskContext, 0, count, 0);
        }
        return;
    }
    openJob(pool, task, taskContext, count, part);
    runParts(pool, 0);
    closeJob(pool);
    pthread_mutex_unlock(&pool->callerMutex);
}

swResult swCreateTaskPool(const swHost* host, int threadCount, swTaskPool** poolOut)
{
    if (poolOut != NULL)
    {
        *poolOut = NULL;
    }
    SW_REQUIRE(swIsHostValid(host) && poolOut != NULL, SW_ERROR_INVALID, host,
               "swCreateTaskPool() needs a host made by swDefaultHost() and a place for the pool");
    if (threadCount < 0 || threadCount > SW_MAX_WORKERS - 1)
    {
        return swFail(host, SW_ERROR_INVALID, "a task pool of %d threads was asked for; 0 to %d are possible",
                      threadCount, SW_MAX_WORKERS - 1);
    }
    size_t size = sizeof(swTaskPool) + (size_t)threadCount * sizeof(swTaskWorker);
    swTaskPool* pool = swAllocateZero(host, size);
    if (pool == NULL)
    {
        return swFail(host, SW_ERROR_NO_MEMORY, "no memory for a task pool of %d threads", threadCount);
    }
    pool->host = *host;
    pool->allocationSize = size;
    pthread_mutex_init(&pool->callerMutex, NULL);
    pthread_mutex_init(&pool->mutex, NULL);
    pthread_cond_init(&pool->wake, NULL);
    pthread_cond_init(&pool->done, NULL);
    for (int i = 0; i < threadCount; ++i)
    {
        pool->workers[i] = (swTaskWorker){.pool = pool, .index = i + 1};
        if (pthread_create(&pool->workers[i].thread, NULL, runWorker, &pool->workers[i]) != 0)
        {
            swResult result =
                swFail(host, SW_ERROR_LIMIT, "the system started only %d of %d worker threads", i, threadCount);
            swDestroyTaskPool(pool);
            return result;
        }
        pool->threadCount = i + 1;
    }
    *poolOut = pool;
    return SW_SUCCESS;
}

void swTaskPool_Attach(swTaskPool* pool, swHost* host)
{
    SW_REQUIRE_VOID(pool != NULL && host != NULL, pool != NULL ? &pool->host : host,
                    "swTaskPool_Attach() needs a pool and a host");
    host->parallelFor = runOnPool;
    host->taskContext = pool;
    host->workerCount = pool->threadCount + 1;
}

void swDestroyTaskPool(swTaskPool* pool)
{
    if (pool == NULL)
    {
        return;
    }
    pthread_mutex_lock(&pool->mutex);
    pool->isQuitting = true;
    pthread_cond_broadcast(&pool->wake);
    pthread_mutex_unlock(&pool->mutex);
    for (int i = 0; i < pool->threadCount; ++i)
    {
        pthread_join(pool->workers[i].thread, NULL);
    }
    pthread_cond_destroy(&pool->done);
    pthread_cond_destroy(&pool->wake);
    pthread_mutex_destroy(&pool->mutex);
    pthread_mutex_destroy(&pool->callerMutex);
    swHost host = pool->host;
    swFree(&host, pool, pool->allocationSize);
}
