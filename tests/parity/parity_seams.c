// SPDX-License-Identifier: MIT
// No seam shows in a slice between blocks of texels whose waves are summed up in different ways: blocks that no input
// touches, and blocks whose waves are shaped texel by texel, by another pass. Both sides of each border between blocks
// are held against the surface that the core answers where the texel's particle is.
//
// Slices keep three of the four derivatives of shaped waves, so the derivatives of shaped texels are not a query's. But
// on the border of a block that nothing touches, texels of both blocks rest in water without a floor.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "shared/depth_share.h"
#include "shared/fields.h"
#include "shared/limits.h"

#define MOST_OFF 1e-4     // m, and of derivatives
#define HALF_STEP 0x1p-10 // of half floats, in parts of their size: devices may cut off
#define SLICES 3
#define RESOLUTION 256

typedef struct Seams
{
    double height, derivatives; // at borders of blocks that nothing touches
    double step;                // of heights, from texel to texel over any border of blocks
    int borderCount, seamCount;
} Seams;

// A slice as the GPU has it, and depths as the core has them.
typedef struct Slice
{
    swSliceInfo info;
    float *displacement, *derivatives;
    const float* places;
} Slice;

static void* Allocate(size_t count)
{
    float* memory = malloc(count * sizeof(float));
    assert_non_null(memory);
    return memory;
}

static bool IsBlockTouched(const Slice* slice, int column, int row)
{
    int firstColumn = column / SW_SLICE_WIDTH * SW_SLICE_WIDTH, firstRow = row / SW_SLICE_HEIGHT * SW_SLICE_HEIGHT;
    bool isTouched = false;
    for (int z = firstRow; z < firstRow + SW_SLICE_HEIGHT; ++z)
    {
        for (int x = firstColumn; x < firstColumn + SW_SLICE_WIDTH; ++x)
        {
            isTouched = isTouched || slice->places[4 * (z * RESOLUTION + x)] < SW_NO_DEPTH;
        }
    }
    return isTouched;
}

// How far a texel's height is from that of the surface where its particle is, with the slice's shortest wave; and in
// `derivatives` the largest difference of those.
static double CompareTexel(const Parity* parity, const Slice* slice, int column, int row, double* derivatives)
{
    const float* d = slice->displacement + 4 * (row * RESOLUTION + column);
    const float* g = slice->derivatives + 4 * (row * RESOLUTION + column);
    swPosXZ point = {(double)(slice->info.firstX + column) * slice->info.texel + (double)d[0],
                     (double)(slice->info.firstZ + row) * slice->info.texel + (double)d[2]};
    swQueryDef def = swDefaultQueryDef();
    def.minWavelength = slice->info.minWavelength;
    def.tolerance = 1e-6f;
    def.maxIterations = 64;
    float height, jacobian;
    swVec3 normal;
    const swSurfaceSamples samples = {.height = &height, .jacobian = &jacobian, .normal = &normal};
    swMoment_QuerySurface(swWorld_GetMoment(parity->world), &def, 1, &point, &samples, NULL);
    const float exact[3] = {-normal.x / normal.y * jacobian, -normal.z / normal.y * jacobian, jacobian};
    *derivatives = 0.0;
    for (int c = 0; c < 3; ++c)
    {
        double off = fabs((double)(exact[c] - g[c])) - HALF_STEP * fabs((double)exact[c]);
        *derivatives = fmax(*derivatives, off);
    }
    return (double)(d[1] - height);
}

// Two texels on either side of a border.
static void CompareBorder(const Parity* parity, const Slice* slice, int column, int row, int back, int up, Seams* seams)
{
    double derivatives[2];
    double height = CompareTexel(parity, slice, column, row, &derivatives[0]);
    double before = CompareTexel(parity, slice, column - back, row - up, &derivatives[1]);
    seams->step = fmax(seams->step, fabs(height - before));
    seams->borderCount += 1;
    if (IsBlockTouched(slice, column, row) != IsBlockTouched(slice, column - back, row - up))
    {
        seams->height = fmax(seams->height, fmax(fabs(height), fabs(before)));
        seams->derivatives = fmax(seams->derivatives, fmax(derivatives[0], derivatives[1]));
        seams->seamCount += 1;
    }
}

static void CompareBorders(const Parity* parity, const Slice* slice, Seams* seams)
{
    for (int i = 0; i < RESOLUTION; ++i)
    {
        for (int row = SW_SLICE_HEIGHT; row < RESOLUTION; row += SW_SLICE_HEIGHT)
        {
            CompareBorder(parity, slice, i, row, 0, 1, seams);
        }
        for (int column = SW_SLICE_WIDTH; column < RESOLUTION; column += SW_SLICE_WIDTH)
        {
            CompareBorder(parity, slice, column, i, 1, 0, seams);
        }
    }
}

static Seams CompareSlices(Parity* parity)
{
    Seams seams = {0};
    size_t count = 4 * (size_t)RESOLUTION * RESOLUTION;
    Slice slice = {.displacement = Allocate(count), .derivatives = Allocate(count)};
    for (int i = 0; i < SLICES; ++i)
    {
        slice.info = swView_GetSlice(parity->view, i);
        slice.places = swView_GetPlaces(parity->view, i);
        assert_non_null(slice.places);
        assert_int_equal(
            swGpuWorld_ReadLayer(parity->gpuWorld, parity->view, SW_LAYER_DISPLACEMENT, i, slice.displacement),
            SW_SUCCESS);
        assert_int_equal(
            swGpuWorld_ReadLayer(parity->gpuWorld, parity->view, SW_LAYER_DERIVATIVES, i, slice.derivatives),
            SW_SUCCESS);
        CompareBorders(parity, &slice, &seams);
    }
    free(slice.displacement);
    free(slice.derivatives);
    return seams;
}

static swInputDef Disc(swInputField field, swPosXZ middle, float x, float z, float size, float value)
{
    swInputDef def = swDefaultInputDef();
    def.field = field;
    def.shape = SW_SHAPE_CIRCLE;
    def.position = (swPos){middle.x + (double)x, 0.0, middle.z + (double)z};
    def.size = (swVec3){size, 1.0f, size};
    def.feather = 0.3f * size;
    def.value[0] = value;
    return def;
}

static void AddShore(Parity* parity, swPosXZ middle)
{
    const swInputDef defs[] = {
        Disc(SW_INPUT_FLOOR, middle, 0.0f, 0.0f, 30.0f, -2.0f),
        Disc(SW_INPUT_FLOOR, middle, 60.0f, 45.0f, 40.0f, -5.0f),
        Disc(SW_INPUT_FLOW, middle, 3.0f, 3.0f, 14.0f, 0.8f),
        Disc(SW_INPUT_WAVES, middle, -4.0f, 4.0f, 12.0f, 0.3f),
    };
    for (size_t i = 0; i < sizeof(defs) / sizeof(defs[0]); ++i)
    {
        swInputId id;
        assert_int_equal(swCreateInput(parity->world, &defs[i], &id), SW_SUCCESS);
    }
}

static void CheckSeams(void** state, swPosXZ middle, const char* where)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.chop = 0.6f; // no folds, where a query may find another particle
    AddParitySea(&parity, &sea);
    sea.seed = 9;
    sea.method = SW_WAVES_GERSTNER;
    sea.spectrum.direction = 1.7f;
    sea.spectrum.windSpeed = 4.0f;
    AddParitySea(&parity, &sea);
    AddShore(&parity, middle);
    AddParityView(&parity, SLICES, RESOLUTION, (swPos){middle.x, 2.0, middle.z});
    StepParity(&parity, 3.0);
    Seams seams = CompareSlices(&parity);
    printf("  %s: over %d borders of blocks heights step by %.2g m too much; at %d of blocks without inputs they are "
           "off by "
           "%.2g m, derivatives by %.2g beyond half floats\n",
           where, seams.borderCount, seams.step, seams.seamCount, seams.height, seams.derivatives);
    assert_true(seams.seamCount > 200);
    assert_true(seams.height < MOST_OFF);
    assert_true(seams.step < MOST_OFF);
    assert_true(seams.derivatives < MOST_OFF);
    FreeParity(&parity);
}

static void NoSeamShowsHere(void** state)
{
    CheckSeams(state, (swPosXZ){20.0, -30.0}, "here");
}

static void NoSeamShows100KmAway(void** state)
{
    CheckSeams(state, (swPosXZ){1e5 + 17.3, -1e5 - 40.6}, "100 km away");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(NoSeamShowsHere),
        cmocka_unit_test(NoSeamShows100KmAway),
    };
    return cmocka_run_group_tests(tests, OpenParityGpu, CloseParityGpu);
}
