// SPDX-License-Identifier: MIT
#include "support/cmocka_setup.h"

#include "core/base/id_pool.h"

static void TheFirstHandleIsNotNull(void** state)
{
    (void)state;
    swIdPool pool = swMakeIdPool(4);
    swId id = swAllocId(&pool);
    assert_int_equal(id.index1, 1);
    assert_int_equal(id.generation, 1);
    assert_true(swIsIdValid(&pool, id));
    assert_false(swIsIdValid(&pool, (swId){0, 0}));
    assert_false(swIsIdValid(&pool, (swId){5, 1}));
    assert_false(swIsIdValid(&pool, (swId){-1, 1}));
}

static void AStaleHandleIsCaught(void** state)
{
    (void)state;
    swIdPool pool = swMakeIdPool(4);
    swId first = swAllocId(&pool);
    swFreeId(&pool, first);
    assert_false(swIsIdValid(&pool, first));
    swId second = swAllocId(&pool);
    assert_int_equal(second.index1, first.index1);
    assert_true(swIsIdValid(&pool, second));
    assert_false(swIsIdValid(&pool, first));
}

static void AFullPoolAnswersNull(void** state)
{
    (void)state;
    swIdPool pool = swMakeIdPool(SW_ID_POOL_CAPACITY);
    swId ids[SW_ID_POOL_CAPACITY];
    for (int i = 0; i < SW_ID_POOL_CAPACITY; ++i)
    {
        ids[i] = swAllocId(&pool);
        assert_int_equal(ids[i].index1, i + 1);
    }
    assert_int_equal(swAllocId(&pool).index1, 0);
    swFreeId(&pool, ids[40]);
    swFreeId(&pool, ids[7]);
    assert_int_equal(pool.count, SW_ID_POOL_CAPACITY - 2);
    assert_int_equal(swAllocId(&pool).index1, 8); // lowest slot first, whatever order they were freed in
    assert_int_equal(swAllocId(&pool).index1, 41);
    assert_int_equal(swAllocId(&pool).index1, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(TheFirstHandleIsNotNull),
        cmocka_unit_test(AStaleHandleIsCaught),
        cmocka_unit_test(AFullPoolAnswersNull),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
