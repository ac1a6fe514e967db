// SPDX-License-Identifier: MIT
// Foam fades and grows by its law at any rate of steps, lies still in the world while slices scroll and change their
// scale under it, and covers about as much of a sea as whitecaps do.

#include "support/cmocka_setup.h"

#include <math.h>
#include <string.h>

#include "core/base/host.h"
#include "core/lod/layer_stack.h"
#include "core/sim/foam.h"
#include "core/sim/whitecaps.h"
#include "scenarios/scenario.h"

#define RESOLUTION 64
#define SLICES 4
#define TEXELS (RESOLUTION * RESOLUTION)

// A stack with foam and without a world: J is 1 (flat) everywhere unless a test says otherwise.
typedef struct FoamBed
{
    swLayerStack layers;
    swStackFrame view;
    float derivatives[SLICES * TEXELS * 4];
    float foam[2][SLICES * TEXELS];
} FoamBed;

static FoamBed bed;

// What a fold of 0.2 bears at a growth of 2, against the fading.
#define FADE 0.8f
#define BIRTH 0.4f
#define STEADY (BIRTH / (BIRTH + FADE))
#define START 0.1f

static void SetJacobian(float jacobian)
{
    for (int i = 0; i < SLICES * TEXELS; ++i)
    {
        bed.derivatives[4 * i + 2] = jacobian;
    }
}

typedef struct BedStep
{
    swPos viewpoint;
    double seconds;
    float fade, start, currentX, currentZ;
} BedStep;

static void StepBedBy(BedStep by)
{
    int64_t ticks = (int64_t)floor(by.seconds * SW_TICKS_PER_SECOND + 0.5);
    swPlaceLayers(&bed.layers, by.viewpoint, 0.0, ticks, &bed.view);
    bed.view.layers[SW_LAYER_DERIVATIVES].texels = bed.derivatives;
    bed.view.layers[SW_LAYER_FOAM].isCarried = by.currentX != 0.0f || by.currentZ != 0.0f;
    for (int i = 0; i < bed.layers.stack.sliceCount; ++i)
    {
        swFoamBirth birth = {.fold.slice = i, .rest.bend = 1.0f, .growth = 2.0f};
        memcpy(bed.view.layers[SW_LAYER_FOAM].params[i], &birth, sizeof birth);
    }
    swHost host = swDefaultHost();
    swFrame frame = {.foam.fadeRate = by.fade, .foamLaw = {.threshold = 0.5f, .cover = by.start}};
    frame.foamLaw.currentX = by.currentX;
    frame.foamLaw.currentZ = by.currentZ;
    swLayerStep step = {.host = &host, .frame = &frame, .stack = &bed.view};
    swStepLayers(&bed.layers, SW_LAYER_FOAM, 1, swStepFoam, &step, &bed.view);
}

static void StepBed(swPos viewpoint, double seconds)
{
    StepBedBy((BedStep){.viewpoint = viewpoint, .seconds = seconds, .fade = FADE, .start = START});
}

static void MakeBedOf(int slices, float jacobian)
{
    memset(&bed, 0, sizeof bed);
    swViewDef def = {.sliceCount = slices, .resolution = RESOLUTION, .finestTexel = 0.25f, .maxScaleLevel = 6};
    bed.layers = (swLayerStack){.stack = swMakeStack(&def), .hasTexels = true};
    bed.layers.states[SW_LAYER_FOAM] = (swLayerState){.texels = {bed.foam[0], bed.foam[1]}};
    SetJacobian(jacobian);
    StepBed((swPos){0.0, 1.0, 0.0}, 0.0);
}

static void MakeBed(float jacobian)
{
    MakeBedOf(SLICES, jacobian);
}

// Foam that says where in the world it lies. Smooth, so that a coarser lattice can hold it.
static float Mark(double x, double z)
{
    return (float)(0.5 + 0.2 * sin(x * 0.05) + 0.2 * cos(z * 0.04));
}

static float* FoamAt(int slice, int row, int column)
{
    return &bed.foam[bed.layers.states[SW_LAYER_FOAM].current][(slice * RESOLUTION + row) * RESOLUTION + column];
}

static double PositionOf(int64_t first, int index, double texel)
{
    return (double)(first + index) * texel;
}

static void MarkBed(void)
{
    for (int slice = 0; slice < SLICES; ++slice)
    {
        const swSlice* s = &bed.layers.stack.slices[slice];
        for (int row = 0; row < RESOLUTION; ++row)
        {
            for (int column = 0; column < RESOLUTION; ++column)
            {
                *FoamAt(slice, row, column) =
                    Mark(PositionOf(s->firstX, column, s->texel), PositionOf(s->firstZ, row, s->texel));
            }
        }
    }
}

typedef struct Survey
{
    int exact, near, lost; // texels whose foam is Mark() to the bit, within interpolation error, or neither
} Survey;

static Survey SurveyBed(void)
{
    Survey survey = {0};
    for (int slice = 0; slice < SLICES; ++slice)
    {
        const swSlice* s = &bed.layers.stack.slices[slice];
        for (int row = 0; row < RESOLUTION; ++row)
        {
            for (int column = 0; column < RESOLUTION; ++column)
            {
                float expected = Mark(PositionOf(s->firstX, column, s->texel), PositionOf(s->firstZ, row, s->texel));
                float error = fabsf(*FoamAt(slice, row, column) - expected);
                survey.exact += error == 0.0f ? 1 : 0;
                survey.near += error > 0.0f && error < 0.01f ? 1 : 0;
                survey.lost += error >= 0.01f ? 1 : 0;
            }
        }
    }
    return survey;
}

static void FoamFadesOnCalmWater(void** state)
{
    (void)state;
    const int rates[] = {5, 30, 60, 144};
    for (int r = 0; r < 4; ++r)
    {
        MakeBed(1.0f);
        for (int i = 0; i < SLICES * TEXELS; ++i)
        {
            bed.foam[bed.layers.states[SW_LAYER_FOAM].current][i] = 1.0f;
        }
        for (int i = 0; i < rates[r]; ++i)
        {
            StepBed((swPos){0.0, 1.0, 0.0}, 1.0 / rates[r]);
        }
        // Ticks of 2^-24 s: the last of the 30 steps may fall just beyond the second.
        float fullSecond = expf(-0.8f);
        float stepLess = expf(-0.8f * 29.0f / 30.0f);
        float foam = *FoamAt(1, 20, 30);
        assert_true(fabsf(foam - fullSecond) < 1e-5f || fabsf(foam - stepLess) < 1e-5f);
    }
}

static void FoamGrowsOnlyBelowTheThreshold(void** state)
{
    (void)state;
    MakeBed(0.51f);
    StepBed((swPos){0.0, 1.0, 0.0}, 0.5);
    assert_float_equal(*FoamAt(0, 5, 5), START * expf(-FADE * 0.5f), 1e-6f);
    MakeBed(1.0f);
    SetJacobian(0.3f);
    StepBed((swPos){0.0, 1.0, 0.0}, 0.5);
    assert_float_equal(*FoamAt(0, 5, 5), STEADY + (START - STEADY) * expf(-(BIRTH + FADE) * 0.5f), 1e-5f);
}

static void FoamStaysWithinItsRange(void** state)
{
    (void)state;
    MakeBed(-3.0f);
    assert_true(*FoamAt(0, 5, 5) > 0.8f && *FoamAt(0, 5, 5) < 1.0f); // the steady state
    for (int i = 0; i < 100; ++i)
    {
        SetJacobian(i % 2 == 0 ? -5.0f : 9.0f);
        StepBed((swPos){0.0, 1.0, 0.0}, 0.9);
        assert_true(*FoamAt(2, 9, 9) >= 0.0f && *FoamAt(2, 9, 9) <= 1.0f);
    }
}

static void FoamStartsInTheSteadyStateAndKeepsIt(void** state)
{
    (void)state;
    MakeBed(0.3f);
    float steady = STEADY;
    assert_float_equal(*FoamAt(0, 5, 5), steady, 1e-6f);
    for (int i = 0; i < 300; ++i)
    {
        StepBed((swPos){0.1 * i, 1.0, 0.0}, 1.0 / 30.0);
    }
    for (int i = 0; i < TEXELS; ++i)
    {
        assert_float_equal(bed.foam[bed.layers.states[SW_LAYER_FOAM].current][i], steady, 1e-5f);
    }
    // A jump in time, back or far ahead, starts anew.
    SetJacobian(1.0f);
    uint32_t resets = bed.layers.states[SW_LAYER_FOAM].clock.resetCount;
    StepBed((swPos){0.0, 1.0, 0.0}, -0.1);
    assert_true(*FoamAt(0, 5, 5) == START); // the sea's mean, where nothing folds
    StepBed((swPos){0.0, 1.0, 0.0}, 100.0);
    assert_int_equal(bed.layers.states[SW_LAYER_FOAM].clock.resetCount, resets + 2);
}

static void FoamLiesStillWhileSlicesScroll(void** state)
{
    (void)state;
    MakeBed(1.0f);
    const swPos path[] = {{0.25, 1.0, 0.0}, {0.9, 1.0, -3.1}, {-2.0, 1.0, 3.7}, {5.0, 1.0, 5.0}};
    for (int i = 0; i < 4; ++i)
    {
        StepBed((swPos){0.0, 1.0, 0.0}, 0.0);
        MarkBed();
        StepBed(path[i], 0.0); // no time passes: nothing fades
        Survey survey = SurveyBed();
        print_message("moved to (%g, %g): %d exact, %d within 0.01, %d lost of %d\n", path[i].x, path[i].z,
                      survey.exact, survey.near, survey.lost, SLICES * TEXELS);
        // Only the strips that the outermost slice (texels of 2 m) newly covers have no past.
        int strips = (int)(fabs(path[i].x) / 2.0 + fabs(path[i].z) / 2.0 + 2.0);
        assert_true(survey.lost <= strips * RESOLUTION);
        assert_true(survey.exact + survey.near >= SLICES * TEXELS - strips * RESOLUTION);
    }
}

static void FoamLiesStillFarFromTheOrigin(void** state)
{
    (void)state;
    MakeBed(1.0f);
    StepBed((swPos){1e6, 1.0, -1e6}, 0.0);
    MarkBed();
    StepBed((swPos){1e6 + 0.6, 1.0, -1e6 - 0.6}, 0.0);
    assert_true(SurveyBed().lost <= 2 * RESOLUTION);
}

static void FoamSurvivesAChangeOfScale(void** state)
{
    (void)state;
    MakeBed(1.0f);
    MarkBed();
    StepBed((swPos){0.0, 12.0, 0.0}, 0.0); // finest slice is 16 m wide: 4 m and below is level 0, so this is level 1
    assert_int_equal(bed.layers.stack.scaleLevel, 1);
    Survey up = SurveyBed();
    print_message("one level up: %d exact, %d within 0.01, %d lost\n", up.exact, up.near, up.lost);
    // The new outermost slice has a past only in the quarter that the old one covered.
    assert_true(up.lost <= 3 * TEXELS / 4 + 4 * RESOLUTION);
    assert_true(up.exact >= (SLICES - 1) * TEXELS + TEXELS / 4 - 4 * RESOLUTION);

    MarkBed();
    StepBed((swPos){0.0, 1.0, 0.0}, 0.0);
    assert_int_equal(bed.layers.stack.scaleLevel, 0);
    Survey down = SurveyBed();
    print_message("one level down: %d exact, %d within 0.01, %d lost\n", down.exact, down.near, down.lost);
    assert_int_equal(down.lost, 0); // the new finest slice lies within the old one
    assert_true(down.exact >= (SLICES - 1) * TEXELS + TEXELS / 4 - 4 * RESOLUTION);
}

static void AFarTeleportStartsFromTheSteadyState(void** state)
{
    (void)state;
    MakeBed(0.3f);
    MarkBed();
    StepBed((swPos){5000.0, 1.0, 0.0}, 0.0);
    for (int i = 0; i < SLICES * TEXELS; ++i)
    {
        assert_float_equal(bed.foam[bed.layers.states[SW_LAYER_FOAM].current][i], STEADY, 1e-6f);
    }
}

static void TheExcessIsThatOfAGaussian(void** state)
{
    (void)state;
    double worst = 0.0;
    for (double x = -5.0; x < 5.0; x += 0.0313)
    {
        double sum = 0.0;
        for (double n = -x < -9.0 ? -9.0 : -x; n < 9.0; n += 0.0005)
        {
            sum += (x + n + 0.00025) * exp(-0.5 * (n + 0.00025) * (n + 0.00025)) * 0.0005 * 0.3989422804;
        }
        worst = fmax(worst, fabs((double)swFoamExcess((float)x) / sum - 1.0));
    }
    print_message("worst relative error of the excess: %.2g\n", worst);
    assert_true(worst < 0.005);
}

static void StepsOfAnyLengthComeToTheSame(void** state)
{
    (void)state;
    float many = 0.2f;
    for (int i = 0; i < 60; ++i)
    {
        many = swFoamStep(many, BIRTH, FADE, 1.0f / 30.0f);
    }
    assert_float_equal(many, swFoamStep(0.2f, BIRTH, FADE, 2.0f), 1e-5f);
}

static void ShoreFoamIsAsWideOnAnySlope(void** state)
{
    (void)state;
    const float slopes[] = {0.005f, 0.05f, 0.5f, 3.0f};
    const float width = 4.0f, rate = 0.7f;
    for (int i = 0; i < 4; ++i)
    {
        for (float along = 0.0f; along < 8.0f; along += 0.5f)
        {
            float depth = slopes[i] * along;
            float distance = swFindShoreDistance(depth, 0.6f * slopes[i], -0.8f * slopes[i]);
            assert_float_equal(distance, along, 1e-4f * (along + 1.0f));
            float birth = swFindShoreBirth(distance, width, rate);
            assert_true(along < width - 0.1f ? birth > 0.0f : birth < 0.001f * rate);
        }
    }
    assert_float_equal(swFindShoreBirth(0.0f, width, rate), rate, 1e-6f);
    assert_true(swFindShoreDistance(-2.0f, 0.1f, 0.0f) == 0.0f);  // land
    assert_true(swFindShoreDistance(0.3f, 0.0f, 0.0f) > 1000.0f); // a shoal without an edge
    assert_true(swFindShoreDistance(100.0f, 1e4f, 0.0f) > width); // where a floor fades into none
    assert_true(swFindShoreBirth(1e30f, width, rate) == 0.0f);    // no floor
    assert_true(swFindShoreBirth(NAN, width, rate) == 0.0f);
    assert_true(swFindShoreBirth(0.0f, 0.0f, rate) == 0.0f); // none is wanted
}

// What a world's foam of inputs and of shores is after two seconds of frames of any length.
static void GetMadeFoam(const double* frames, int count, float* wake, float* shore)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    swView* view = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = 2;
    viewDef.resolution = RESOLUTION;
    viewDef.enableCpuLayers = true;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_SUCCESS);
    swInputDef floor = swDefaultInputDef(), maker = swDefaultInputDef();
    floor.shape = SW_SHAPE_CIRCLE;
    floor.size = (swVec3){12.0f, 0.0f, 12.0f};
    floor.feather = 5.0f;
    floor.value[0] = 2.0f;
    maker.field = SW_INPUT_FOAM;
    maker.value[0] = 0.4f;
    swInputId id;
    assert_int_equal(swCreateInput(world, &floor, &id), SW_SUCCESS);
    assert_int_equal(swCreateInput(world, &maker, &id), SW_SUCCESS);
    assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
    double time = 0.0;
    for (int i = 0; time < 2.0 - 1e-9; ++i)
    {
        double dt = fmin(frames[i % count], 2.0 - time);
        time += dt;
        assert_int_equal(swWorld_Step(world, dt), SW_SUCCESS);
    }
    *wake = swView_GetWakeFoam(view, 0)[0];
    *shore = 0.0f;
    for (int i = 0; i < TEXELS; ++i)
    {
        *shore += swView_GetShoreFoam(view, 0)[i] / TEXELS;
    }
    swDestroyView(view);
    swDestroyWorld(world);
}

static void MadeFoamIsTheSameAtAnyRateOfFrames(void** state)
{
    (void)state;
    const double even[3] = {1.0 / 30.0, 1.0 / 60.0, 1.0 / 144.0}, uneven[5] = {0.01, 0.13, 0.002, 0.05, 0.3};
    float wake[4], shore[4];
    for (int i = 0; i < 3; ++i)
    {
        GetMadeFoam(&even[i], 1, &wake[i], &shore[i]);
    }
    GetMadeFoam(uneven, 5, &wake[3], &shore[3]);
    double b = 0.4, f = 0.1; // the closed form from 0, with the step of a thirtieth that may be missing
    double full = b / (b + f) * (1.0 - exp(-(b + f) * 2.0)),
           less = b / (b + f) * (1.0 - exp(-(b + f) * (2.0 - 1.0 / 30.0)));
    for (int i = 0; i < 4; ++i)
    {
        print_message("foam of an input %.5f, of a shore %.5f\n", (double)wake[i], (double)shore[i]);
        assert_true(fabs((double)wake[i] - full) < 1e-4 || fabs((double)wake[i] - less) < 1e-4);
        assert_float_equal(shore[i], shore[0], 1e-5f);
        assert_true(shore[i] > 0.001f && shore[i] < 1.0f);
    }
}

// ---- foam that goes with the water ----

#define NO_FADE 1e-9f

// A blob of a deviation in texels of the finest slice about a place, in each slice.
static void DropBlob(double x, double z, double deviation)
{
    for (int slice = 0; slice < bed.layers.stack.sliceCount; ++slice)
    {
        const swSlice* s = &bed.layers.stack.slices[slice];
        for (int i = 0; i < TEXELS; ++i)
        {
            double dx = (PositionOf(s->firstX, i % RESOLUTION, s->texel) - x) / deviation;
            double dz = (PositionOf(s->firstZ, i / RESOLUTION, s->texel) - z) / deviation;
            *FoamAt(slice, i / RESOLUTION, i % RESOLUTION) = (float)exp(-0.5 * (dx * dx + dz * dz));
        }
    }
}

typedef struct Blob
{
    double mass, x, z, deviationX, deviationZ, peak; // in m, of a slice
} Blob;

static Blob MeasureBlob(int slice)
{
    const swSlice* s = &bed.layers.stack.slices[slice];
    Blob blob = {0};
    double sums[5] = {0};
    for (int i = 0; i < TEXELS; ++i)
    {
        double foam = (double)*FoamAt(slice, i / RESOLUTION, i % RESOLUTION);
        double x = PositionOf(s->firstX, i % RESOLUTION, s->texel), z = PositionOf(s->firstZ, i / RESOLUTION, s->texel);
        blob.peak = fmax(blob.peak, foam);
        sums[0] += foam;
        sums[1] += foam * x;
        sums[2] += foam * z;
    }
    blob.x = sums[1] / sums[0];
    blob.z = sums[2] / sums[0];
    for (int i = 0; i < TEXELS; ++i)
    {
        double foam = (double)*FoamAt(slice, i / RESOLUTION, i % RESOLUTION);
        double x = PositionOf(s->firstX, i % RESOLUTION, s->texel), z = PositionOf(s->firstZ, i / RESOLUTION, s->texel);
        sums[3] += foam * (x - blob.x) * (x - blob.x);
        sums[4] += foam * (z - blob.z) * (z - blob.z);
    }
    blob.mass = sums[0] * s->texel * s->texel;
    blob.deviationX = sqrt(sums[3] / sums[0]);
    blob.deviationZ = sqrt(sums[4] / sums[0]);
    return blob;
}

static void StepInCurrent(swPos viewpoint, double seconds, float x, float z)
{
    StepBedBy((BedStep){.viewpoint = viewpoint, .seconds = seconds, .fade = NO_FADE, .currentX = x, .currentZ = z});
}

static void FoamIsCarriedFarWithoutASmear(void** state)
{
    (void)state;
    const double texels[2] = {2.0, 4.0};
    for (int i = 0; i < 2; ++i)
    {
        MakeBedOf(1, 1.0f);
        DropBlob(0.0, 0.0, texels[i] * 0.25);
        Blob before = MeasureBlob(0);
        double time = 0.0;
        for (int step = 1; step <= 7500; ++step) // 250 s at 2 m/s
        {
            time = step / 30.0;
            StepInCurrent((swPos){1.6 * time, 1.0, -1.2 * time}, step / 30.0 - (step - 1) / 30.0, 1.6f, -1.2f);
        }
        Blob after = MeasureBlob(0);
        double steps = (double)bed.layers.states[SW_LAYER_FOAM].clock.clock;
        print_message("500 m, 2,000 texels: deviation %.2f texels to %.2f along x and %.2f along z, mass %.3f, peak "
                      "%.3f, off by %.3f and %.3f m\n",
                      before.deviationX / 0.25, after.deviationX / 0.25, after.deviationZ / 0.25,
                      after.mass / before.mass, after.peak, after.x - 1.6 * steps / 30.0, after.z + 1.2 * steps / 30.0);
        assert_true(fabs(after.x - 1.6 * steps / 30.0) < 0.25 && fabs(after.z + 1.2 * steps / 30.0) < 0.25);
        assert_true(after.deviationX < before.deviationX + 0.25 * (i == 0 ? 2.0 : 0.5));
        assert_true(after.mass > 0.95 * before.mass && after.mass < (i == 0 ? 1.35 : 1.02) * before.mass);
        assert_true(after.peak > (i == 0 ? 0.4 : 0.85));
    }
}

// What comes into a fine slice from upstream was in a coarser one.
static void FoamComesInOverTheEdgeOfASlice(void** state)
{
    (void)state;
    MakeBedOf(3, 1.0f);
    DropBlob(-12.0, 0.0, 1.5); // the finest slice reaches to 8 m, the next to 16 m
    assert_true(MeasureBlob(0).peak < 0.1);
    for (int step = 1; step <= 180; ++step)
    {
        StepInCurrent((swPos){0.0, 1.0, 0.0}, 1.0 / 30.0 + 1e-7, 2.0f, 0.0f);
    }
    Blob blob = MeasureBlob(0);
    print_message("over the edge: peak %.3f at (%.2f, %.2f)\n", blob.peak, blob.x, blob.z);
    assert_true(blob.peak > 0.9 && fabs(blob.x) < 0.2 && fabs(blob.z) < 0.1);
}

// An eddy that turns like a disc about a place, in 12.6 s once.
static void TurnAround(void* context, double time, int count, const swPosXZ* points, swInputAnswer* answers)
{
    (void)context;
    (void)time;
    for (int i = 0; i < count; ++i)
    {
        answers[i] = (swInputAnswer){.share = 1.0f,
                                     .value = {(float)(-0.5 * points[i].z), (float)(0.5 * points[i].x)},
                                     .valueAlongX = {0.0f, 0.5f},
                                     .valueAlongZ = {-0.5f, 0.0f}};
    }
}

typedef struct CarryCase
{
    const double* frames;
    int count;
    bool isEddy;
    float currentX;
    double seconds;
} CarryCase;

static float carried[3][2 * TEXELS]; // of whitecaps, inputs and shores; both slices

// A spot where an input made foam for half a second, in an eddy or a current.
static void CarryFoam(const CarryCase* c)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world = NULL;
    swView* view = NULL;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = 2;
    viewDef.resolution = RESOLUTION;
    viewDef.finestTexel = 0.25f;
    viewDef.enableCpuLayers = true;
    assert_int_equal(swCreateView(world, &viewDef, &view), SW_SUCCESS);
    swInputDef floor = swDefaultInputDef(), maker = swDefaultInputDef(), flow = swDefaultInputDef();
    floor.shape = SW_SHAPE_CIRCLE;
    floor.size = (swVec3){12.0f, 0.0f, 12.0f};
    floor.feather = 5.0f;
    floor.value[0] = 2.0f;
    maker.field = SW_INPUT_FOAM;
    maker.shape = SW_SHAPE_CIRCLE;
    maker.size = (swVec3){2.0f, 0.0f, 2.0f};
    maker.feather = 0.8f;
    maker.position.x = 4.0;
    maker.value[0] = 4.0f;
    flow.field = SW_INPUT_FLOW;
    flow.shape = SW_SHAPE_FUNCTION;
    flow.size = (swVec3){15.0f, 0.0f, 15.0f};
    flow.function = TurnAround;
    swInputId id, makerId;
    assert_int_equal(swCreateInput(world, &floor, &id), SW_SUCCESS);
    assert_int_equal(swCreateInput(world, &maker, &makerId), SW_SUCCESS);
    if (c->isEddy)
    {
        assert_int_equal(swCreateInput(world, &flow, &id), SW_SUCCESS);
    }
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    swWaveSystemId waveId;
    waves.weight = 1e-5f; // too little to move foam, enough to say which way the current goes
    waves.currentX = c->currentX;
    assert_int_equal(c->isEddy ? SW_SUCCESS : swCreateWaveSystem(world, &waves, &waveId), SW_SUCCESS);
    assert_int_equal(swWorld_StepTo(world, 0.0), SW_SUCCESS);
    double time = 0.0;
    for (int i = 0; time < c->seconds - 1e-9; ++i)
    {
        double before = time;
        time = fmin(time + c->frames[i % c->count], before < 0.51 ? 0.51 : c->seconds);
        if (before == 0.51)
        {
            swDestroyInput(world, makerId);
        }
        assert_int_equal(swWorld_StepTo(world, time), SW_SUCCESS);
    }
    memcpy(carried[0], swView_GetFoam(view, 0), TEXELS * sizeof(float));
    memcpy(carried[0] + TEXELS, swView_GetFoam(view, 1), TEXELS * sizeof(float));
    memcpy(carried[1], swView_GetWakeFoam(view, 0), TEXELS * sizeof(float));
    memcpy(carried[1] + TEXELS, swView_GetWakeFoam(view, 1), TEXELS * sizeof(float));
    memcpy(carried[2], swView_GetShoreFoam(view, 0), TEXELS * sizeof(float));
    memcpy(carried[2] + TEXELS, swView_GetShoreFoam(view, 1), TEXELS * sizeof(float));
    swDestroyView(view);
    swDestroyWorld(world);
}

static void FindSpot(const float* foam, double* x, double* z)
{
    double sum = 0.0;
    *x = *z = 0.0;
    for (int i = 0; i < TEXELS; ++i)
    {
        sum += (double)foam[i];
        *x += (double)foam[i] * 0.25 * (i % RESOLUTION - RESOLUTION / 2);
        *z += (double)foam[i] * 0.25 * (i / RESOLUTION - RESOLUTION / 2);
    }
    *x /= sum;
    *z /= sum;
}

static void CarriedFoamIsTheSameAtAnyRateOfFrames(void** state)
{
    (void)state;
    static float first[3][2 * TEXELS];
    const double even[3] = {1.0 / 30.0, 1.0 / 60.0, 1.0 / 144.0}, uneven[5] = {0.01, 0.13, 0.002, 0.05, 0.3};
    for (int i = 0; i < 4; ++i)
    {
        CarryFoam(
            &(CarryCase){.frames = i < 3 ? &even[i] : uneven, .count = i < 3 ? 1 : 5, .isEddy = true, .seconds = 3.01});
        if (i == 0)
        {
            memcpy(first, carried, sizeof first);
        }
        assert_memory_equal(first, carried, sizeof first);
    }
    float most = 0.0f, mostShore = 0.0f;
    for (int i = 0; i < TEXELS; ++i)
    {
        most = fmaxf(most, carried[1][i]);
        mostShore = fmaxf(mostShore, carried[2][i]);
    }
    assert_true(most > 0.3f && mostShore > 0.3f);
}

// It turns with the water, and neither nears the eye nor leaves it.
static void FoamTurnsWithAnEddy(void** state)
{
    (void)state;
    double frame = 1.0 / 30.0, x, z;
    CarryFoam(&(CarryCase){.frames = &frame, .count = 1, .isEddy = true, .seconds = 12.01});
    FindSpot(carried[1], &x, &z);
    double angle = atan2(z, x), wanted = 0.5 * (360.0 / 30.0 - 0.25) - 6.283185307;
    print_message("foam in an eddy: %.3f m from the eye, at %.3f rad where the water is at about %.3f\n",
                  sqrt(x * x + z * z), angle, wanted);
    assert_true(fabs(angle - wanted) < 0.03);
    assert_true(fabs(sqrt(x * x + z * z) - 4.0) < 0.1); // of first order it would be 4.4
}

static void FoamGoesWithTheCurrentOfTheWaves(void** state)
{
    (void)state;
    double frame = 1.0 / 60.0, x, z;
    CarryFoam(&(CarryCase){.frames = &frame, .count = 1, .currentX = -1.5f, .seconds = 3.01});
    FindSpot(carried[1], &x, &z);
    print_message("foam in a current: at (%.3f, %.3f)\n", x, z);
    assert_true(fabs(x - (4.0 - 1.5 * (3.0 - 0.25))) < 0.1 && fabs(z) < 0.01);
}

static void AFoldThatIsKnownIsExact(void** state)
{
    (void)state;
    swFoamRest nothing = {.deviation = 0.0f, .bend = 0.8f}, little = {.deviation = 0.1f, .bend = 0.8f};
    assert_true(swFoamFold(0.2f, 0.5f, nothing) == 0.5f - 0.2f);
    assert_true(swFoamFold(0.6f, 0.5f, nothing) == 0.0f);
    // Continuous in J, and ever less with it.
    float before = swFoamFold(-0.5f, 0.5f, little);
    for (float jacobian = -0.5f; jacobian < 1.5f; jacobian += 0.001f)
    {
        float fold = swFoamFold(jacobian, 0.5f, little);
        assert_true(fold >= 0.0f && fold <= before + 1e-4f && fold >= before - 3e-3f);
        before = fold;
    }
}

#define POINT_COUNT 100000

static void ScatterPoints(swPosXZ* points)
{
    uint32_t seed = 7;
    for (int i = 0; i < POINT_COUNT; ++i)
    {
        seed = seed * 1664525u + 1013904223u;
        points[i].x = 1e5 * (double)(seed >> 8) * 0x1p-24;
        seed = seed * 1664525u + 1013904223u;
        points[i].z = 1e5 * (double)(seed >> 8) * 0x1p-24;
    }
}

static float SumDeviation(const swFrame* frame, float maxWavelength)
{
    float variance = 0.0f;
    for (int i = 0; i < frame->tileCount; ++i)
    {
        variance += frame->tiles[i].minWavelength < maxWavelength ? swGetStrainVariance(&frame->tiles[i].strain) : 0.0f;
    }
    return sqrtf(variance);
}

// The expectation over the waves that a slice leaves out, against the law's own of a place with no waves known.
static void SlicesOfAnyFinenessExpectTheFoldOfTheWholeSea(void** state)
{
    (void)state;
    ScenarioDef scenarioDef = DefaultScenarioDef(SCENARIO_GALE);
    scenarioDef.resolution = 64;
    Scenario sea;
    assert_int_equal(CreateScenario(&scenarioDef, &sea), SW_SUCCESS);
    static swPosXZ points[POINT_COUNT];
    static float jacobians[POINT_COUNT];
    ScatterPoints(points);
    const swFrame* frame = swGetWorldFrame(sea.world);
    const swFoamLaw* law = &frame->foamLaw;
    float shortest[] = {0.0f, 0.25f, 1.0f, 4.0f, 16.0f, 64.0f};
    double whole = (double)swFoamFold(1.0f, law->threshold, law->rest);
    print_message("threshold %.3f, deviation %.3f, bend %.3f, cover %.2f %%\n", (double)law->threshold,
                  (double)law->rest.deviation, (double)law->rest.bend, 100.0 * (double)law->cover);
    for (int s = 0; s < 6; ++s)
    {
        swQueryDef def = swDefaultQueryDef();
        def.minWavelength = shortest[s];
        swSurfaceSamples samples = {.jacobian = jacobians};
        swMoment_QueryParticles(swWorld_GetMoment(sea.world), &def, POINT_COUNT, points, &samples, NULL, NULL);
        swFoamRest rest = {.deviation = SumDeviation(frame, shortest[s]), .bend = law->rest.bend};
        double fold = 0.0;
        for (int i = 0; i < POINT_COUNT; ++i)
        {
            fold += (double)swFoamFold(jacobians[i], law->threshold, rest) / POINT_COUNT;
        }
        print_message("waves from %g m: deviation of the others %.3f, mean fold %.3g, %.2f of the whole\n",
                      (double)shortest[s], (double)rest.deviation, fold, fold / whole);
        assert_true(fold > 0.8 * whole && fold < 1.25 * whole);
    }
    DestroyScenario(&sea);
}

static void CoverByWindLiesBetweenTheTwoLaws(void** state)
{
    (void)state;
    assert_true(swGetWhitecapCover(0.0f) == 0.0f && swGetWhitecapCover(3.69f) == 0.0f);
    assert_true(swGetWhitecapCover(NAN) == 0.0f);
    // Percent at 5, 8, 10, 15, 20 m/s: [Callaghan 2008] and [Monahan and O'Muircheartaigh 1980].
    const double winds[5] = {5.0, 8.0, 10.0, 15.0, 20.0};
    const double low[5] = {0.007, 0.25, 0.80, 2.36, 5.1}, high[5] = {0.093, 0.46, 0.99, 3.93, 10.5};
    for (int i = 0; i < 5; ++i)
    {
        double cover = 100.0 * (double)swGetWhitecapCover((float)winds[i]);
        assert_true(cover > low[i] && cover < high[i]);
    }
    float before = 0.0f;
    for (float wind = 4.0f; wind <= 100.0f; wind += 0.25f)
    {
        float cover = swGetWhitecapCover(wind);
        assert_true(cover > before && cover < 1.0f);
        before = cover < 0.999f ? cover : 0.0f;
    }
}

// Mean foam of the finest slice over a few seconds of a sea.
static swWorld* MakeWindySea(float windSpeed, float finestTexel, swView** view)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &worldDef, &world), SW_SUCCESS);
    swWaveSystemDef systemDef = swDefaultWaveSystemDef();
    systemDef.spectrum.windSpeed = windSpeed;
    systemDef.resolution = 64;
    systemDef.tileWaves = 16;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &systemDef, &id), SW_SUCCESS);
    swViewDef viewDef = swDefaultViewDef();
    viewDef.sliceCount = 2;
    viewDef.resolution = 128;
    viewDef.finestTexel = finestTexel;
    viewDef.enableCpuLayers = true;
    assert_int_equal(swCreateView(world, &viewDef, view), SW_SUCCESS);
    return world;
}

static double MeanFoamOf(const swView* view)
{
    double mean = 0.0;
    for (int t = 0; t < 128 * 128; ++t)
    {
        mean += (double)swView_GetFoam(view, 0)[t] / (128.0 * 128.0);
    }
    return mean;
}

static double MeasureFoam(float windSpeed, float finestTexel)
{
    swView* view;
    swWorld* world = MakeWindySea(windSpeed, finestTexel, &view);
    double mean = 0.0;
    for (int i = 0; i < 40; ++i)
    {
        swWorld_Step(world, 0.1);
        mean += i % 5 == 4 ? MeanFoamOf(view) / 8.0 : 0.0;
    }
    swDestroyWorld(world);
    return mean;
}

static void CoverGrowsWithWindAsWhitecapsDo(void** state)
{
    (void)state;
    double light = MeasureFoam(3.0f, 4.0f);
    double fresh = MeasureFoam(10.0f, 4.0f);
    double gale = MeasureFoam(20.0f, 4.0f);
    print_message("mean foam: %.3f %% at 3 m/s, %.2f %% at 10 m/s, %.2f %% at 20 m/s\n", 100.0 * light, 100.0 * fresh,
                  100.0 * gale);
    // [Monahan and O'Muircheartaigh 1980]: 0.016, 0.99 and 10.5 %; [Callaghan 2008]: 0, 0.80 and 5.1 %.
    assert_true(light < 0.0005);
    assert_true(fresh > 0.004 && fresh < 0.02);
    assert_true(gale > 0.025 && gale < 0.15);
}

static void TheSeaBeyondTheSlicesHasAsMuchFoam(void** state)
{
    (void)state;
    swView* view;
    swWorld* world = MakeWindySea(20.0f, 8.0f, &view);
    double mean = 0.0;
    for (int i = 0; i < 40; ++i)
    {
        swWorld_Step(world, 0.1);
        mean += MeanFoamOf(view) / 40.0;
    }
    double beyond = (double)swGetWorldFrame(world)->foamLaw.cover;
    print_message("mean foam: %.4f in a slice of 8 m, %.4f beyond\n", mean, beyond);
    assert_true(beyond > 0.8 * mean && beyond < 1.25 * mean);
    swDestroyWorld(world);
}

// Where every wave that counts is known, folds at random times bear the foam that the law's mean fold bears elsewhere.
static void AFoldThatIsSeenWholeBearsAsMuch(void** state)
{
    (void)state;
    swView* view;
    swWorld* world = MakeWindySea(15.0f, 1.0f, &view);
    swFoamDef def = swDefaultFoamDef();
    def.minWavelength = 8.0f;
    swWorld_SetFoam(world, &def);
    const swFrame* frame = swGetWorldFrame(world);
    double folds = 0.0, foam = 0.0;
    for (int i = 0; i < 300; ++i)
    {
        swWorld_Step(world, 0.1);
        swFoamBirth birth = swGetFoamBirth(&frame->views[0].stack, 0);
        for (int t = 0; t < 128 * 128 && i >= 100; ++t)
        {
            float jacobian = frame->views[0].stack.layers[SW_LAYER_DERIVATIVES].texels[4 * t + 2];
            folds += (double)swFoamFold(jacobian, frame->foamLaw.threshold, birth.rest);
            foam += (double)swView_GetFoam(view, 0)[t];
        }
    }
    double count = 200.0 * 128.0 * 128.0;
    double birth = (double)frame->foamLaw.unknownGrowth * folds / count;
    double wanted = birth / (birth + (double)def.fadeRate);
    print_message("mean foam: %.4f where waves are known, %.4f by the mean fold there\n", foam / count, wanted);
    assert_true(foam / count > 0.6 * wanted && foam / count < 1.7 * wanted);
    swDestroyWorld(world);
}

static void AChangedLawTakesEffect(void** state)
{
    (void)state;
    swView* view;
    swWorld* world = MakeWindySea(20.0f, 4.0f, &view);
    swWorld_Step(world, 0.1);
    double before = MeanFoamOf(view);
    swFoamDef barren = swDefaultFoamDef();
    barren.coverage = 0.0f;
    barren.threshold = -4.0f;
    barren.fadeRate = 0.5f;
    swWorld_SetFoam(world, &barren);
    for (int i = 0; i < 60; ++i)
    {
        swWorld_Step(world, 1.0 / 30.0);
    }
    assert_true(fabs(MeanFoamOf(view) / before - exp(-1.0)) < 0.02);
    swDestroyWorld(world);
}

// ---- the wind, and the law made of it ----

static void ALawOutOfItsRangeIsRefusedAndChangesNothing(void** state)
{
    (void)state;
    swHost host = swDefaultHost();
    host.log = NULL;
    swWorldDef def = swDefaultWorldDef();
    swWorld* world = NULL;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    uint64_t digest = swWorld_GetDigest(world);
    swFoamDef foam = swDefaultFoamDef();
    foam.fadeRate = NAN;
    swWorld_SetFoam(world, &foam); // builds with asserts go on: a number may come from a file
    assert_int_equal(swWorld_GetDigest(world), digest);
    foam = swDefaultFoamDef();
    foam.coverage = 2.0f;
    swWorld_SetFoam(world, &foam);
    assert_int_not_equal(swWorld_GetDigest(world), digest);
    swDestroyWorld(world);
}

static void AssertNear(double value, double wanted, double error)
{
    if (!(fabs(value - wanted) <= error))
    {
        print_message("%.6f where %.6f is right\n", value, wanted);
        fail();
    }
}

static swWaveSystemDef MakeSystemOf(const swSpectrumDef* spectrum)
{
    swWaveSystemDef def = swDefaultWaveSystemDef();
    def.spectrum = *spectrum;
    def.resolution = 64;
    def.tileWaves = 16;
    return def;
}

static swWaveSystemId AddSystem(swWorld* world, swWaveSystemDef def, float windSpeed)
{
    def.spectrum.hasWind = windSpeed > 0.0f;
    def.spectrum.windSpeed = windSpeed > 0.0f ? windSpeed : 10.0f;
    swWaveSystemId id;
    assert_int_equal(swCreateWaveSystem(world, &def, &id), SW_SUCCESS);
    return id;
}

static swWorld* MakeDrawnWorld(void)
{
    swHost host = swDefaultHost();
    swWorldDef def = swDefaultWorldDef();
    def.enableQueries = false;
    swWorld* world;
    assert_int_equal(swCreateWorld(&host, &def, &world), SW_SUCCESS);
    return world;
}

static double GetWindAfter(swWorld* world, double seconds)
{
    assert_int_equal(swWorld_Step(world, seconds), SW_SUCCESS);
    return (double)swWorld_GetFoamState(world).windSpeed;
}

static void AKnownWindIsTheWindWhateverTheWaves(void** state)
{
    (void)state;
    // Height, period, wind: a narrow swell under a gale, a steep sea in a breeze, a ripple in a storm, a sea of its
    // wind.
    static const float seas[][3] = {
        {2.0f, 12.0f, 18.0f}, {10.0f, 9.0f, 4.0f}, {0.1f, 2.0f, 40.0f}, {2.0f, 7.0f, 11.0f}};
    for (int i = 0; i < 4; ++i)
    {
        swWorld* world = MakeDrawnWorld();
        swSpectrumDef spectrum = swMakeSwellSpectrum(seas[i][0], seas[i][1], 0.0f, 0.3f);
        swWaveSystemId id = AddSystem(world, MakeSystemOf(&spectrum), seas[i][2]);
        AssertNear(GetWindAfter(world, 0.1), (double)seas[i][2], 1e-4);
        swWaveSystem_SetWeight(world, id, 0.5f);
        AssertNear(GetWindAfter(world, 0.1), 0.25 * (double)seas[i][2], 1e-4);
        swWaveSystem_SetWeight(world, id, 3.0f);
        AssertNear(GetWindAfter(world, 0.1), (double)seas[i][2], 1e-4);
        swDestroyWorld(world);
    }
}

static void ATableKnowsTheWindThatItIsGiven(void** state)
{
    (void)state;
    const float frequencies[3] = {0.07f, 0.08f, 0.09f}, bandwidths[3] = {0.01f, 0.01f, 0.01f};
    const float density[12] = {0, 0, 0, 0, 5, 1, 0, 1, 0, 0, 0, 0}; // one bin of swell
    swSpectrumTable table = {3, 4, frequencies, bandwidths, density, 0.0f};
    swSpectrumDef spectrum = swDefaultSpectrumDef();
    spectrum.kind = SW_SPECTRUM_TABLE;
    spectrum.table = &table;
    swWorld* world = MakeDrawnWorld();
    swWaveSystemId id = AddSystem(world, MakeSystemOf(&spectrum), 0.0f);
    AssertNear(GetWindAfter(world, 0.1), 0.0, 0.5);
    swDestroyWaveSystem(world, id);
    AddSystem(world, MakeSystemOf(&spectrum), 14.0f);
    AssertNear(GetWindAfter(world, 0.1), 14.0, 1e-4);
    swDestroyWorld(world);
}

static void KnownWindsOfSeveralSystemsAreOneWind(void** state)
{
    (void)state;
    swWorld* world = MakeDrawnWorld();
    swSpectrumDef swell = swMakeSwellSpectrum(3.0f, 14.0f, 0.0f, 0.2f);
    swSpectrumDef sea = swMakeWindSeaSpectrum(12.0f, 200e3f, INFINITY, 1.0f);
    AddSystem(world, MakeSystemOf(&swell), swell.windSpeed);
    swWaveSystemId one = AddSystem(world, MakeSystemOf(&sea), 12.0f);
    AssertNear(GetWindAfter(world, 0.1), 12.0, 1e-4);
    sea.direction = 2.0f;
    AddSystem(world, MakeSystemOf(&sea), 12.0f);
    AssertNear(GetWindAfter(world, 0.1), 12.0, 1e-4);
    swWaveSystem_FadeWeight(world, one, 0.0f, 1.0);
    for (int i = 0; i < 4; ++i)
    {
        AssertNear(GetWindAfter(world, 0.3), 12.0, 1e-4);
    }
    swDestroyWorld(world);
}

static void TheWindHasNoDipWhileASeaChanges(void** state)
{
    (void)state;
    for (int change = 0; change < 3; ++change)
    {
        swWorld* world = MakeDrawnWorld();
        swSpectrumDef spectrum = swDefaultSpectrumDef();
        spectrum.significantHeight = 2.5f;
        spectrum.peakPeriod = 7.0f;
        swWaveSystemDef def = MakeSystemOf(&spectrum);
        swWaveSystemId id = AddSystem(world, def, 12.0f);
        double begin = GetWindAfter(world, 0.1);
        def.spectrum.hasWind = change != 1; // the waves tell it then
        def.spectrum.windSpeed = change == 2 ? 15.0f : 12.0f;
        def.seed = change == 0 ? 7 : def.seed; // a cross-fade
        assert_int_equal(swWaveSystem_Set(world, id, &def, 2.0), SW_SUCCESS);
        double winds[24];
        for (int i = 0; i < 24; ++i)
        {
            winds[i] = GetWindAfter(world, 0.1);
        }
        for (int i = 0; i < 24; ++i)
        {
            double low = fmin(begin, winds[23]), high = fmax(begin, winds[23]);
            assert_true(winds[i] > 0.99 * low && winds[i] < 1.01 * high);
            assert_true(i == 0 || fabs(winds[i] - winds[i - 1]) < 0.8);
        }
        swDestroyWorld(world);
    }
}

static void NoSeaTellsOfMoreThanTheStrongestWind(void** state)
{
    (void)state;
    swWorld* world = MakeDrawnWorld();
    swSpectrumDef spectrum = swDefaultSpectrumDef();
    spectrum.significantHeight = 20.0f;
    spectrum.peakPeriod = 4.0f;
    AddSystem(world, MakeSystemOf(&spectrum), 0.0f);
    AssertNear(GetWindAfter(world, 0.1), 100.0, 1e-6);
    swFoamState foam = swWorld_GetFoamState(world);
    assert_true(foam.cover > 0.5f && foam.cover < 1.0f);
    swDestroyWorld(world);
}

// Chops, spreads and winds of every size: the threshold is that of the cover.
static void TheThresholdIsFoundForEverySea(void** state)
{
    (void)state;
    static const float chops[] = {0.02f, 0.3f, 1.0f, 2.0f}, exponents[] = {0.0f, 8.0f, 200.0f};
    for (int i = 0; i < 4 * 3; ++i)
    {
        swWorld* world = MakeDrawnWorld();
        swSpectrumDef spectrum = swDefaultSpectrumDef();
        spectrum.spreadExponent = exponents[i / 4];
        swWaveSystemDef def = MakeSystemOf(&spectrum);
        def.chop = chops[i % 4];
        AddSystem(world, def, 15.0f);
        swFoamDef foam = swDefaultFoamDef();
        float before = 1.0f;
        for (float wind = 30.0f; wind > 3.72f; wind -= 1.01f)
        {
            foam.windSpeed = wind;
            foam.threshold = -4.0f;
            swWorld_SetFoam(world, &foam);
            assert_int_equal(swWorld_Step(world, 0.0), SW_SUCCESS);
            swFoamState found = swWorld_GetFoamState(world);
            assert_true(found.threshold < before && found.threshold > -4.0f);
            AssertNear((double)found.cover / (double)swGetWhitecapCover(wind), 1.0, 1e-4);
            before = found.threshold;
        }
        swDestroyWorld(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(FoamFadesOnCalmWater),
        cmocka_unit_test(FoamGrowsOnlyBelowTheThreshold),
        cmocka_unit_test(FoamStaysWithinItsRange),
        cmocka_unit_test(FoamStartsInTheSteadyStateAndKeepsIt),
        cmocka_unit_test(FoamLiesStillWhileSlicesScroll),
        cmocka_unit_test(FoamLiesStillFarFromTheOrigin),
        cmocka_unit_test(FoamSurvivesAChangeOfScale),
        cmocka_unit_test(AFarTeleportStartsFromTheSteadyState),
        cmocka_unit_test(TheExcessIsThatOfAGaussian),
        cmocka_unit_test(ShoreFoamIsAsWideOnAnySlope),
        cmocka_unit_test(MadeFoamIsTheSameAtAnyRateOfFrames),
        cmocka_unit_test(StepsOfAnyLengthComeToTheSame),
        cmocka_unit_test(FoamIsCarriedFarWithoutASmear),
        cmocka_unit_test(FoamComesInOverTheEdgeOfASlice),
        cmocka_unit_test(CarriedFoamIsTheSameAtAnyRateOfFrames),
        cmocka_unit_test(FoamTurnsWithAnEddy),
        cmocka_unit_test(FoamGoesWithTheCurrentOfTheWaves),
        cmocka_unit_test(AFoldThatIsKnownIsExact),
        cmocka_unit_test(CoverByWindLiesBetweenTheTwoLaws),
        cmocka_unit_test(SlicesOfAnyFinenessExpectTheFoldOfTheWholeSea),
        cmocka_unit_test(CoverGrowsWithWindAsWhitecapsDo),
        cmocka_unit_test(TheSeaBeyondTheSlicesHasAsMuchFoam),
        cmocka_unit_test(AFoldThatIsSeenWholeBearsAsMuch),
        cmocka_unit_test(AChangedLawTakesEffect),
        cmocka_unit_test(ALawOutOfItsRangeIsRefusedAndChangesNothing),
        cmocka_unit_test(AKnownWindIsTheWindWhateverTheWaves),
        cmocka_unit_test(ATableKnowsTheWindThatItIsGiven),
        cmocka_unit_test(KnownWindsOfSeveralSystemsAreOneWind),
        cmocka_unit_test(TheWindHasNoDipWhileASeaChanges),
        cmocka_unit_test(NoSeaTellsOfMoreThanTheStrongestWind),
        cmocka_unit_test(TheThresholdIsFoundForEverySea),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
