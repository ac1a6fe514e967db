// SPDX-License-Identifier: MIT

// The law by which waves die out towards the shore.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>

#include "core/world/world.h"
#include "seaway/seaway.h"
#include "shared/depth_share.h"

static const swAttenuation Nature = {.strength = 1.0f, .perFreeDepth = 0.0f};

static void InShallowWaterTheShareIsTanh(void** state)
{
    (void)state;
    for (float kd = 1e-4f; kd <= 0.5f * (float)SW_PI; kd += 0.001f)
    {
        swDepthShare found = swFindNaturalShare(kd);
        double truth = tanh((double)kd);
        assert_true(fabs((double)found.share - truth) < 2e-7);
        assert_true(fabs((double)found.slope - (1.0 - truth * truth)) < 1e-6);
    }
}

// The blend lifts the share by less than 0.01, so that nothing is seen of it.
static void TheShareStaysNearTanh(void** state)
{
    (void)state;
    double worst = 0.0;
    for (float kd = 0.0f; kd < 8.0f; kd += 0.0005f)
    {
        worst = fmax(worst, fabs((double)swFindNaturalShare(kd).share - tanh((double)kd)));
    }
    print_message("farthest from tanh: %.5f\n", worst);
    assert_true(worst < 0.01);
}

static void DeepWaterLeavesWavesAloneToTheBit(void** state)
{
    (void)state;
    for (float wavelength = 0.0625f; wavelength < 5000.0f; wavelength *= 1.37f)
    {
        float k = (float)(2.0 * SW_PI) / wavelength;
        const float depths[] = {0.5001f * wavelength, wavelength, 11000.0f, INFINITY};
        for (int i = 0; i < 4; ++i)
        {
            swDepthShare found = swFindDepthShare(Nature, k, depths[i]);
            bool isDeep = depths[i] > 0.5f * wavelength;
            assert_true(!isDeep || (found.share == 1.0f && found.slope == 0.0f && swIsDeepFor(Nature, k, depths[i])));
        }
        assert_true(swFindDepthShare(Nature, k, 0.4f * wavelength).share < 1.0f);
        assert_false(swIsDeepFor(Nature, k, 0.49f * wavelength));
    }
}

static void NothingIsLeftAtTheWatersEdge(void** state)
{
    (void)state;
    const float depths[] = {0.0f, -0.0f, -1e-3f, -8000.0f, -INFINITY};
    for (int i = 0; i < 5; ++i)
    {
        swDepthShare found = swFindDepthShare(Nature, 0.3f, depths[i]);
        assert_true(found.share == 0.0f && found.slope == 0.0f);
    }
    assert_true(swFindDepthShare(Nature, 0.3f, 1e-4f).share < 1e-4f);
    assert_true(swFindDepthShare((swAttenuation){1.0f, 0.05f}, 0.3f, 0.0f).share == 0.0f);
}

// Whatever a host asks for: never less where it is deeper, and slopes that are those of the values.
static void CheckCurve(swAttenuation attenuation, float k)
{
    const double step = 1e-3;
    float last = 0.0f, lastSlope = swFindDepthShare(attenuation, k, 1e-6f).slope;
    float steepest = 0.0f;
    for (double kd = 2e-3; kd < 4.0; kd += step)
    {
        float depth = (float)(kd / (double)k);
        float less = (float)((kd - step) / (double)k), more = (float)((kd + step) / (double)k);
        swDepthShare found = swFindDepthShare(attenuation, k, depth);
        assert_true(found.share >= last && found.share <= 1.0f);
        assert_true(found.slope >= 0.0f);
        double difference = ((double)swFindDepthShare(attenuation, k, more).share -
                             (double)swFindDepthShare(attenuation, k, less).share) /
                            ((double)more - (double)less);
        assert_true(fabs((double)found.slope - difference) < 2e-3 * (double)k);
        assert_float_equal(found.slope / k, lastSlope / k, 0.02f); // no jump of the slope
        last = found.share;
        lastSlope = found.slope;
        steepest = fmaxf(steepest, found.slope / k);
    }
    assert_true(steepest > 0.4f * attenuation.strength);
}

static void TheShareNeverFallsWithDepthAndItsSlopeIsExact(void** state)
{
    (void)state;
    const float waveNumbers[] = {0.0015f, 0.1f, 2.0f, 70.0f};
    for (int i = 0; i < 4; ++i)
    {
        float k = waveNumbers[i];
        CheckCurve(Nature, k);
        CheckCurve((swAttenuation){0.95f, 0.0f}, k);
        CheckCurve((swAttenuation){1.0f, k / 1.3f}, k);
        CheckCurve((swAttenuation){0.5f, k / 2.5f}, k);
    }
}

static void AHostMayAskForLess(void** state)
{
    (void)state;
    swAttenuation none = {.strength = 0.0f, .perFreeDepth = 0.0f};
    assert_true(swFindDepthShare(none, 0.1f, 1.0f).share == 1.0f);
    assert_true(swFindDepthShare(none, 0.1f, -5.0f).share == 1.0f);
    swAttenuation most = {.strength = 0.95f, .perFreeDepth = 0.0f};
    assert_float_equal(swFindDepthShare(most, 0.1f, 0.0f).share, 0.05f, 1e-7f);
    swAttenuation shallows = {.strength = 1.0f, .perFreeDepth = 0.05f};
    assert_true(swFindDepthShare(shallows, 0.01f, 20.0f).share == 1.0f);
    assert_true(swIsDeepFor(shallows, 0.01f, 20.0f) && !swIsDeepFor(shallows, 0.01f, 19.9f));
    assert_true(swFindDepthShare(shallows, 0.01f, 10.0f).share > swFindDepthShare(Nature, 0.01f, 10.0f).share);
}

// ---- what a system says about it ----

static void StepTo(swWorld* world, double time)
{
    assert_int_equal(swWorld_StepTo(world, time), SW_SUCCESS);
}

static swAttenuation FindAttenuation(const swWorld* world, int system)
{
    const swFrame* frame = swGetWorldFrame(world);
    for (int i = 0; i < frame->tileCount; ++i)
    {
        if (frame->tiles[i].system == system)
        {
            return frame->tiles[i].attenuation;
        }
    }
    for (int i = 0; i < frame->waveCount; ++i)
    {
        if (frame->waves[i].system == system)
        {
            return frame->waves[i].attenuation;
        }
    }
    fail();
    return (swAttenuation){0.0f, 0.0f};
}

static void CheckAttenuation(const swWorld* world, int system, float strength, float perFreeDepth)
{
    swAttenuation found = FindAttenuation(world, system);
    assert_float_equal(found.strength, strength, 1e-6f);
    assert_float_equal(found.perFreeDepth, perFreeDepth, 1e-6f);
}

static void EachSystemHasItsOwnAttenuation(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 32;
    def.tileWaves = 8;
    swWaveSystemId ids[3];
    assert_int_equal(swCreateWaveSystem(world, &def, &ids[0]), SW_SUCCESS);
    def.attenuation = 0.25f; // else the same waves: they are not shared
    assert_int_equal(swCreateWaveSystem(world, &def, &ids[1]), SW_SUCCESS);
    def.method = SW_WAVES_GERSTNER;
    def.shallowsDepth = 40.0f;
    assert_int_equal(swCreateWaveSystem(world, &def, &ids[2]), SW_SUCCESS);
    StepTo(world, 1.0);
    CheckAttenuation(world, 0, 1.0f, 0.0f);
    CheckAttenuation(world, 1, 0.25f, 0.0f);
    CheckAttenuation(world, 2, 0.25f, 0.025f);
    swDestroyWorld(world);
}

static void AttenuationChangesGentlyAndIsSaved(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld *world = NULL, *restored = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.resolution = 32;
    def.tileWaves = 8;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    StepTo(world, 1.0);
    uint64_t before = swWorld_GetDigest(world);
    def.attenuation = 0.5f;
    def.shallowsDepth = 10.0f;
    assert_int_equal(swWaveSystem_Set(world, id, &def, 8.0), SW_SUCCESS);
    assert_true(swWorld_GetDigest(world) != before);
    StepTo(world, 5.0); // half of the way
    CheckAttenuation(world, 0, 0.75f, 0.05f);

    size_t size = 0;
    assert_int_equal(swWorld_Save(world, NULL, &size), SW_SUCCESS);
    swRestoreDef restoreDef = swDefaultRestoreDef();
    void* bytes = malloc(size);
    assert_non_null(bytes);
    assert_int_equal(swWorld_Save(world, bytes, &size), SW_SUCCESS);
    assert_int_equal(swRestoreWorld(&host, bytes, size, &restoreDef, &restored), SW_SUCCESS);
    free(bytes);
    CheckAttenuation(restored, 0, 0.75f, 0.05f);

    def.attenuation = 1.0f; // and from half of the way elsewhere
    assert_int_equal(swWaveSystem_Set(world, id, &def, 4.0), SW_SUCCESS);
    StepTo(world, 7.0);
    CheckAttenuation(world, 0, 0.875f, 0.075f);
    StepTo(world, 9.5);
    CheckAttenuation(world, 0, 1.0f, 0.1f);
    StepTo(restored, 9.5);
    CheckAttenuation(restored, 0, 0.5f, 0.1f);
    swDestroyWorld(restored);
    swDestroyWorld(world);
}

// What the core's sums take eight at a time, without a branch.
static void TheKernelsHaveTheSameShareOnEachMachine(void** state)
{
    (void)state;
    const swAttenuation laws[4] = {Nature, {0.7f, 0.0f}, {1.0f, 0.05f}, {0.0f, 0.01f}};
    const swWaveKernels* first = swGetWaveKernels(SW_ISA_SCALAR);
    for (int i = 0; i < 4 * 4000; i += SW_SHARE_LANES)
    {
        swAttenuation law = laws[i / 4000];
        float k = 0.02f * (float)(1 + i % 700);
        float depths[SW_SHARE_LANES], shares[SW_SHARE_LANES], slopes[SW_SHARE_LANES];
        for (int d = 0; d < SW_SHARE_LANES; ++d)
        {
            depths[d] = d == 7 ? INFINITY : 0.013f * (float)(i % 4000 + d) / (k + 0.1f);
        }
        swFindDepthShares(first, law, k, SW_SHARE_LANES, depths, shares, slopes);
        for (int d = 0; d < SW_SHARE_LANES; ++d)
        {
            swDepthShare one = swFindDepthShare(law, k, depths[d]);
            assert_float_equal(shares[d], one.share, 3e-7f);
            assert_true(depths[d] == 0.0f || fabsf(slopes[d] - one.slope) <= 1e-6f * (k + 1.0f));
            assert_true((shares[d] == 1.0f && slopes[d] == 0.0f) == (one.share == 1.0f && one.slope == 0.0f));
        }
        for (int isa = SW_ISA_SCALAR; isa < SW_ISA_COUNT; ++isa)
        {
            const swWaveKernels* kernels = swGetWaveKernels((swIsa)isa);
            float own[SW_SHARE_LANES], ownSlopes[SW_SHARE_LANES];
            if (kernels != NULL)
            {
                swFindDepthShares(kernels, law, k, SW_SHARE_LANES, depths, own, ownSlopes);
                assert_memory_equal(shares, own, sizeof shares);
                assert_memory_equal(slopes, ownSlopes, sizeof slopes);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(InShallowWaterTheShareIsTanh),
        cmocka_unit_test(TheShareStaysNearTanh),
        cmocka_unit_test(DeepWaterLeavesWavesAloneToTheBit),
        cmocka_unit_test(NothingIsLeftAtTheWatersEdge),
        cmocka_unit_test(TheShareNeverFallsWithDepthAndItsSlopeIsExact),
        cmocka_unit_test(AHostMayAskForLess),
        cmocka_unit_test(TheKernelsHaveTheSameShareOnEachMachine),
        cmocka_unit_test(EachSystemHasItsOwnAttenuation),
        cmocka_unit_test(AttenuationChangesGentlyAndIsSaved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
