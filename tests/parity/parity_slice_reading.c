// SPDX-License-Identifier: MIT
// The drawn surface reads the two slices that it means to. Each slice of a layer holds a number of its own, so that a
// reading from any other slice shows.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>

#include "ask_slices_shader.h"
#include "gpu/draw/mesh_rings.h"
#include "gpu/vk/vk_submit.h"

#define RESOLUTION 64
#define SLICES 7
#define STEPS 64 // levels between two slices
#define COUNT (SLICES * STEPS + 1)
#define BEYOND 3.0f

typedef struct Push
{
    uint32_t count, ringCount, resolution;
    float beyond;
} Push;

typedef struct Reader
{
    swPipeline pipeline;
    swImage layer;
    swBuffer pixels, slices, levels, answers;
} Reader;

static float NumberOf(int slice)
{
    return (float)(1 << (2 * slice));
}

static swMeshRings MakeRings(int scaleLevel, float fade)
{
    swViewFrame frame = {.stack = {.sliceCount = SLICES, .resolution = RESOLUTION},
                         .fade = fade,
                         .scaleLevel = scaleLevel,
                         .viewpoint = {3.0, 2.0, -5.0}};
    for (int i = 0; i < SLICES; ++i)
    {
        double texel = ldexp(1.0, i + scaleLevel - 4);
        frame.stack.slices[i] = (swSlice){.texel = texel,
                                          .firstX = (int64_t)floor(frame.viewpoint.x / texel) - RESOLUTION / 2,
                                          .firstZ = (int64_t)floor(frame.viewpoint.z / texel) - RESOLUTION / 2,
                                          .level = i + scaleLevel};
    }
    swMeshRings rings;
    swBuildMeshRings(&frame, &rings);
    return rings;
}

static Reader MakeReader(swGpu* gpu)
{
    Reader reader = {0};
    const size_t texels = SLICES * RESOLUTION * RESOLUTION;
    const VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const swImageDef def = {.format = VK_FORMAT_R32_SFLOAT,
                            .width = RESOLUTION,
                            .height = RESOLUTION,
                            .layers = SLICES,
                            .isArray = true,
                            .usage = VK_IMAGE_USAGE_SAMPLED_BIT,
                            .layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                            .name = "numbers"};
    assert_int_equal(swCreateComputePipeline(gpu, &swAskSlicesShader, NULL, &reader.pipeline), SW_SUCCESS);
    assert_int_equal(swCreateImage(gpu, &def, &reader.layer), SW_SUCCESS);
    assert_int_equal(swCreateBuffer(gpu, texels * sizeof(float), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, SW_MEMORY_UPLOAD,
                                    "pixels", &reader.pixels),
                     SW_SUCCESS);
    assert_int_equal(
        swCreateBuffer(gpu, SLICES * sizeof(swMeshSlice), storage, SW_MEMORY_UPLOAD, "slices", &reader.slices),
        SW_SUCCESS);
    assert_int_equal(swCreateBuffer(gpu, COUNT * sizeof(float), storage, SW_MEMORY_UPLOAD, "levels", &reader.levels),
                     SW_SUCCESS);
    assert_int_equal(
        swCreateBuffer(gpu, 2 * COUNT * sizeof(float), storage, SW_MEMORY_READBACK, "answers", &reader.answers),
        SW_SUCCESS);
    float* pixels = reader.pixels.mapped;
    for (size_t i = 0; i < texels; ++i)
    {
        pixels[i] = NumberOf((int)(i / (RESOLUTION * RESOLUTION)));
    }
    float* levels = reader.levels.mapped;
    for (int i = 0; i < COUNT; ++i)
    {
        levels[i] = (float)i / STEPS;
    }
    return reader;
}

static void FreeReader(swGpu* gpu, Reader* reader)
{
    swDestroyPipeline(gpu, &reader->pipeline);
    swDestroyImage(gpu, &reader->layer);
    swDestroyBuffer(gpu, &reader->pixels);
    swDestroyBuffer(gpu, &reader->slices);
    swDestroyBuffer(gpu, &reader->levels);
    swDestroyBuffer(gpu, &reader->answers);
}

static const float* Read(swGpu* gpu, Reader* reader, const swMeshRings* rings)
{
    memcpy(reader->slices.mapped, rings->slices, SLICES * sizeof(swMeshSlice));
    const Push push = {COUNT, SLICES, RESOLUTION, BEYOND};
    static_assert(sizeof(Push) == SW_ASK_SLICES_PUSH_SIZE, "what ask_slices.comp is given");
    const swUpload pixels = {reader->pixels.handle, 0, reader->pixels.size, reader->pixels.mapped};
    const swSamplerKind sampler = gpu->filtersFloats ? SW_SAMPLER_LINEAR_CLAMP : SW_SAMPLER_NEAREST_CLAMP;
    const swAskSlicesBindings bindings = {.slices = swBindBuffer(&reader->slices),
                                          .levels = swBindBuffer(&reader->levels),
                                          .answers = swBindBuffer(&reader->answers),
                                          .layer = swBindImage(gpu, &reader->layer, sampler)};
    VkCommandBuffer commands;
    assert_int_equal(swBeginSubmit(gpu, &commands), SW_SUCCESS);
    swRecordImageUpload(gpu, commands, &pixels, &reader->layer);
    swBindAskSlices(gpu, commands, &reader->pipeline, &bindings, &push);
    gpu->vk.CmdDispatch(commands, (COUNT + 63) / 64, 1, 1);
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
              VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
    assert_int_equal(swEndSubmit(gpu), SW_SUCCESS);
    return reader->answers.mapped;
}

// From one slice to the next, and from the last to what lies beyond; `lastWeight` is that of the last slice.
static double ExpectAt(float level, double lastWeight)
{
    int first = level >= SLICES - 1 ? SLICES - 1 : (int)level;
    double next = (double)level - first;
    double firstWeight = (1.0 - next) * (first == SLICES - 1 ? lastWeight : 1.0);
    double secondWeight = first == SLICES - 1 ? 0.0 : next * (first == SLICES - 2 ? lastWeight : 1.0);
    double second = first == SLICES - 1 ? 0.0 : (double)NumberOf(first + 1);
    return firstWeight * (double)NumberOf(first) + secondWeight * second +
           (1.0 - firstWeight - secondWeight) * (double)BEYOND;
}

static void CheckReading(swGpu* gpu, Reader* reader, int scaleLevel, float fade, double lastWeight)
{
    swMeshRings rings = MakeRings(scaleLevel, fade);
    const float* answers = Read(gpu, reader, &rings);
    double worst[2] = {0.0, 0.0};
    for (int i = 0; i < COUNT; ++i)
    {
        float level = (float)i / STEPS;
        double expected = ExpectAt(level, lastWeight);
        for (int way = 0; way < 2; ++way)
        {
            double error = fabs((double)answers[2 * i + way] - expected) / expected;
            if (error > 1e-5 && error > worst[way])
            {
                printf("level %.3f, %s: %g instead of %g\n", (double)level, way == 0 ? "filtered" : "by hand",
                       (double)answers[2 * i + way], expected);
            }
            worst[way] = fmax(worst[way], error);
        }
    }
    printf("largest error: filtered %.2g, by hand %.2g of the number\n", worst[0], worst[1]);
    assert_true(worst[0] < 1e-5 && worst[1] < 1e-5);
}

static void ALevelIsReadFromTheSliceBelowItAndTheNext(void** state)
{
    swGpu* gpu = *state;
    Reader reader = MakeReader(gpu);
    CheckReading(gpu, &reader, 0, 0.0f, 1.0);
    CheckReading(gpu, &reader, 3, 0.125f, 0.5); // a last slice that fades in
    FreeReader(gpu, &reader);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ALevelIsReadFromTheSliceBelowItAndTheNext),
    };
    return cmocka_run_group_tests(tests, OpenParityGpu, CloseParityGpu);
}
