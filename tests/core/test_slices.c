// SPDX-License-Identifier: MIT
// A view's layers are the surface: displacement and derivatives at every texel's rest point are what a query of that
// particle answers, leaving out what the slice cannot carry, wherever the view is and however it is scaled.

#include "support/cmocka_setup.h"

#include <math.h>

#include "core/frame/frame.h"
#include "scenarios/scenario.h"

#define RESOLUTION 64

static swView* OpenView(swWorld* world, float finestTexel)
{
    swViewDef def = swDefaultViewDef();
    def.sliceCount = 3;
    def.resolution = RESOLUTION;
    def.finestTexel = finestTexel;
    def.enableCpuLayers = true;
    swView* view;
    assert_int_equal(swCreateView(world, &def, &view), SW_SUCCESS);
    return view;
}

static Scenario OpenSea(ScenarioKind kind)
{
    ScenarioDef def = DefaultScenarioDef(kind);
    def.resolution = 64;
    Scenario scenario;
    assert_int_equal(CreateScenario(&def, &scenario), SW_SUCCESS);
    return scenario;
}

// Rest points of one row.
static void MakeRow(const swSliceInfo* slice, int row, swPosXZ* points)
{
    for (int i = 0; i < RESOLUTION; ++i)
    {
        points[i].x = (double)(slice->firstX + i) * slice->texel;
        points[i].z = (double)(slice->firstZ + row) * slice->texel;
    }
}

static void CheckSlice(const swWorld* world, const swView* view, int slice)
{
    swSliceInfo info = swView_GetSlice(view, slice);
    const float* displacement = swView_GetDisplacement(view, slice);
    const float* derivatives = swView_GetDerivatives(view, slice);
    swQueryDef def = swDefaultQueryDef();
    // The query leaves out bands whose longest wave is at most this; the slice those whose shortest is below its limit.
    def.minWavelength = info.minWavelength;
    for (int row = 0; row < RESOLUTION; row += 9)
    {
        swPosXZ points[RESOLUTION];
        swVec3 moved[RESOLUTION], normals[RESOLUTION];
        float jacobians[RESOLUTION];
        MakeRow(&info, row, points);
        swSurfaceSamples samples = {.displacement = moved, .normal = normals, .jacobian = jacobians};
        swMoment_QueryParticles(swWorld_GetMoment(world), &def, RESOLUTION, points, &samples, NULL, NULL);
        for (int i = 0; i < RESOLUTION; ++i)
        {
            const float* d = displacement + 4 * (row * RESOLUTION + i);
            const float* g = derivatives + 4 * (row * RESOLUTION + i);
            assert_true(d[0] == moved[i].x && d[1] == moved[i].y && d[2] == moved[i].z && d[3] == 0.0f);
            assert_true(g[2] == jacobians[i] && g[3] == 0.0f);
            float length = sqrtf(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
            float up = g[2] < 0.0f ? -1.0f : 1.0f;
            assert_float_equal(-g[0] / length * up, normals[i].x, 1e-6f);
            assert_float_equal(-g[1] / length * up, normals[i].z, 1e-6f);
        }
    }
}

static void SlicesHoldWhatQueriesAnswer(void** state)
{
    (void)state;
    Scenario sea = OpenSea(SCENARIO_BREEZE);
    swView* view = OpenView(sea.world, 0.25f);
    const swPos viewpoints[] = {{0.0, 2.0, 0.0}, {1e6, 9.0, -1e6}, {-33.3, 300.0, 44.4}};
    for (int i = 0; i < 3; ++i)
    {
        swView_SetViewpoint(view, viewpoints[i]);
        assert_int_equal(swWorld_Step(sea.world, 1.7), SW_SUCCESS);
        for (int slice = 0; slice < 3; ++slice)
        {
            CheckSlice(sea.world, view, slice);
        }
    }
    assert_true(swView_GetSlice(view, 0).texel > 1.0); // the last viewpoint doubled the stack
    DestroyScenario(&sea);
}

static void NestedTexelsShareTheirRestPoint(void** state)
{
    (void)state;
    Scenario sea = OpenSea(SCENARIO_BREEZE);
    swView* view = OpenView(sea.world, 0.5f);
    swView_SetViewpoint(view, (swPos){-71.3, 2.0, 19.9});
    swWorld_Step(sea.world, 0.5);
    swSliceInfo fine = swView_GetSlice(view, 0);
    swSliceInfo coarse = swView_GetSlice(view, 1);
    int compared = 0;
    for (int row = 0; row < RESOLUTION; ++row)
    {
        int64_t n = 2 * (coarse.firstZ + row) - fine.firstZ;
        compared += n >= 0 && n < RESOLUTION ? 1 : 0;
        if (n >= 0 && n < RESOLUTION)
        {
            assert_true((double)(fine.firstZ + n) * fine.texel == (double)(coarse.firstZ + row) * coarse.texel);
        }
    }
    assert_true(compared >= RESOLUTION / 2 - 1);
    DestroyScenario(&sea);
}

static void ThreadsDoNotChangeLayers(void** state)
{
    (void)state;
    size_t texels = (size_t)RESOLUTION * RESOLUTION;
    static float expected[3][RESOLUTION * RESOLUTION];
    static float expectedFoam[3][RESOLUTION * RESOLUTION];
    const int threadCounts[] = {1, 2, 5};
    for (int t = 0; t < 3; ++t)
    {
        ScenarioDef def = DefaultScenarioDef(SCENARIO_GALE);
        def.resolution = 64;
        def.threadCount = threadCounts[t];
        Scenario sea;
        assert_int_equal(CreateScenario(&def, &sea), SW_SUCCESS);
        swView* view = OpenView(sea.world, 0.25f);
        for (int i = 0; i < 20; ++i)
        {
            swView_SetViewpoint(view, (swPos){0.7 * i, 2.0 + i, -1.3 * i});
            swWorld_Step(sea.world, 0.05);
        }
        for (int slice = 0; slice < 3; ++slice)
        {
            for (size_t i = 0; i < texels; ++i)
            {
                float jacobian = swView_GetDerivatives(view, slice)[4 * i + 2];
                float foam = swView_GetFoam(view, slice)[i];
                assert_true(t == 0 || (jacobian == expected[slice][i] && foam == expectedFoam[slice][i]));
                expected[slice][i] = jacobian;
                expectedFoam[slice][i] = foam;
            }
        }
        DestroyScenario(&sea);
    }
}

static void LayersExistOnlyWhereAskedFor(void** state)
{
    (void)state;
    Scenario calm = OpenSea(SCENARIO_CALM);
    swViewDef def = swDefaultViewDef();
    swView* view;
    assert_int_equal(swCreateView(calm.world, &def, &view), SW_SUCCESS);
    swWorld_Step(calm.world, 0.1);
    assert_null(swView_GetDisplacement(view, 0));
    assert_null(swView_GetDerivatives(view, 0));
    assert_null(swView_GetFoam(view, 6));
    assert_int_equal(swView_GetSliceCount(view), 7);
    assert_null(swGetWorldFrame(calm.world)->views[0].stack.layers[SW_LAYER_DISPLACEMENT].texels);
    DestroyScenario(&calm);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(SlicesHoldWhatQueriesAnswer),
        cmocka_unit_test(NestedTexelsShareTheirRestPoint),
        cmocka_unit_test(ThreadsDoNotChangeLayers),
        cmocka_unit_test(LayersExistOnlyWhereAskedFor),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
