// SPDX-License-Identifier: MIT
#include "support/cmocka_setup.h"
#include "support/counting_host.h"

#include <pthread.h>
#include <string.h>

#include "core/base/host.h"

#define ITEM_COUNT 5000

typedef struct Loop
{
    atomic_int visits[ITEM_COUNT];
    atomic_int busy[SW_MAX_WORKERS];
    atomic_int errors;
    int workerCount;
    const swHost* host; // for a loop inside the loop
} Loop;

static void Visit(void* context, int begin, int end, int worker)
{
    Loop* loop = context;
    bool isWorkerWrong = worker < 0 || worker >= loop->workerCount;
    if (isWorkerWrong || begin >= end || atomic_fetch_add(&loop->busy[worker], 1) != 0)
    {
        atomic_fetch_add(&loop->errors, 1);
        return;
    }
    for (int i = begin; i < end; ++i)
    {
        atomic_fetch_add(&loop->visits[i], 1);
    }
    atomic_fetch_sub(&loop->busy[worker], 1);
}

static void CheckVisits(Loop* loop, int count, int expected)
{
    for (int i = 0; i < count; ++i)
    {
        assert_int_equal(atomic_load(&loop->visits[i]), expected);
    }
    assert_int_equal(atomic_load(&loop->errors), 0);
}

static void EveryItemIsVisitedOnce(void** state)
{
    (void)state;
    const int threadCounts[] = {0, 1, 4, 13};
    for (size_t t = 0; t < sizeof threadCounts / sizeof threadCounts[0]; ++t)
    {
        swHost host = swDefaultHost();
        swTaskPool* pool;
        assert_int_equal(swCreateTaskPool(&host, threadCounts[t], &pool), SW_SUCCESS);
        swTaskPool_Attach(pool, &host);
        assert_int_equal(host.workerCount, threadCounts[t] + 1);
        const int counts[] = {0, 1, 2, 7, 64, ITEM_COUNT};
        for (int c = 0; c < 6; ++c)
        {
            for (int grain = 1; grain < 100; grain = grain * 6 + 1)
            {
                static Loop loop;
                memset(&loop, 0, sizeof loop);
                loop.workerCount = host.workerCount;
                swParallelFor(&host, Visit, &loop, counts[c], grain);
                CheckVisits(&loop, counts[c], 1);
            }
        }
        swDestroyTaskPool(pool);
    }
}

static void ManyShortLoopsAllFinish(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swTaskPool* pool;
    assert_int_equal(swCreateTaskPool(&host, 3, &pool), SW_SUCCESS);
    swTaskPool_Attach(pool, &host);
    static Loop loop;
    memset(&loop, 0, sizeof loop);
    loop.workerCount = host.workerCount;
    for (int i = 0; i < 3000; ++i)
    {
        swParallelFor(&host, Visit, &loop, 16, 1);
    }
    CheckVisits(&loop, 16, 3000);
    swDestroyTaskPool(pool);
}

static void VisitInside(void* context, int begin, int end, int worker)
{
    (void)begin;
    (void)end;
    (void)worker;
    Loop* loop = context;
    Loop* own = calloc(1, sizeof *own);
    own->workerCount = loop->workerCount;
    swParallelFor(loop->host, Visit, own, 100, 1);
    for (int i = 0; i < 100; ++i)
    {
        atomic_fetch_add(&loop->errors, atomic_load(&own->visits[i]) == 1 ? 0 : 1);
    }
    atomic_fetch_add(&loop->errors, atomic_load(&own->errors));
    free(own);
}

static void ALoopInsideALoopRuns(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swTaskPool* pool;
    assert_int_equal(swCreateTaskPool(&host, 3, &pool), SW_SUCCESS);
    swTaskPool_Attach(pool, &host);
    static Loop loop;
    memset(&loop, 0, sizeof loop);
    loop.workerCount = host.workerCount;
    loop.host = &host;
    swParallelFor(&host, VisitInside, &loop, 50, 1);
    assert_int_equal(atomic_load(&loop.errors), 0);
    swDestroyTaskPool(pool);
}

static void* RunLoops(void* argument)
{
    const swHost* host = argument;
    Loop* loop = calloc(1, sizeof *loop);
    loop->workerCount = host->workerCount;
    for (int i = 0; i < 500; ++i)
    {
        swParallelFor(host, Visit, loop, 64, 1);
    }
    intptr_t errors = atomic_load(&loop->errors);
    for (int i = 0; i < 64; ++i)
    {
        errors += atomic_load(&loop->visits[i]) == 500 ? 0 : 1;
    }
    free(loop);
    return (void*)errors;
}

static void TwoCallersShareAPool(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swTaskPool* pool;
    assert_int_equal(swCreateTaskPool(&host, 2, &pool), SW_SUCCESS);
    swTaskPool_Attach(pool, &host);
    pthread_t threads[3];
    for (int i = 0; i < 3; ++i)
    {
        assert_int_equal(pthread_create(&threads[i], NULL, RunLoops, &host), 0);
    }
    for (int i = 0; i < 3; ++i)
    {
        void* errors;
        pthread_join(threads[i], &errors);
        assert_null(errors);
    }
    swDestroyTaskPool(pool);
}

static void APoolGivesItsMemoryBackAndALoopTakesNone(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swTaskPool* pool;
    assert_int_equal(swCreateTaskPool(&host, 2, &pool), SW_SUCCESS);
    swTaskPool_Attach(pool, &host);
    long long before = atomic_load(&memory.allocations);
    static Loop loop;
    memset(&loop, 0, sizeof loop);
    loop.workerCount = host.workerCount;
    swParallelFor(&host, Visit, &loop, 1000, 1);
    assert_int_equal(atomic_load(&memory.allocations), before);
    swDestroyTaskPool(pool);
    assert_int_equal(atomic_load(&memory.bytes), 0);
}

static void WhatCannotBeMadeIsSaid(void** state)
{
    (void)state;
    CountingMemory memory;
    swHost host = MakeCountingHost(&memory);
    swTaskPool* pool;
    assert_int_equal(swCreateTaskPool(&host, -1, &pool), SW_ERROR_INVALID);
    assert_int_equal(swCreateTaskPool(&host, 64, &pool), SW_ERROR_INVALID);
    atomic_store(&memory.failAt, 0);
    assert_int_equal(swCreateTaskPool(&host, 1, &pool), SW_ERROR_NO_MEMORY);
    assert_null(pool);
    assert_int_equal(atomic_load(&memory.messages), 3);
    swDestroyTaskPool(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(EveryItemIsVisitedOnce),
        cmocka_unit_test(ManyShortLoopsAllFinish),
        cmocka_unit_test(ALoopInsideALoopRuns),
        cmocka_unit_test(TwoCallersShareAPool),
        cmocka_unit_test(APoolGivesItsMemoryBackAndALoopTakesNone),
        cmocka_unit_test(WhatCannotBeMadeIsSaid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
