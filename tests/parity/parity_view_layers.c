// SPDX-License-Identifier: MIT
// The layers of a view in a shader of the host: what seaway/layers.glsl reads is what the core has, wherever the
// reference is, and fades as the drawn mesh does.

#include "parity/parity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gpu/vk/vk_submit.h"
#include "seaway/layers.h"
#include "shared/mesh.h"

static const uint32_t askCode[] =
#include "ask_layers.comp.inc"
    ;

#define RESOLUTION 64
#define SLICES 4
#define MOST 512

typedef struct Place
{
    float x, z, slice, unused;
} Place;

typedef struct Answer
{
    float displacement[4], derivatives[4];
    float height, foam, first, second;
    float firstWeight, secondWeight, sliceFoam, jacobian;
} Answer;

// A host's pipeline: set 0 is pushed, set 1 the layers.
typedef struct Host
{
    swGpu* gpu;
    VkDescriptorSetLayout ownLayout;
    VkPipelineLayout layout;
    VkPipeline pipeline;
    swBuffer places, answers;
    PFN_vkCmdBindDescriptorSets bindSets;
} Host;

static Host MakeHost(swGpu* gpu)
{
    Host host = {.gpu = gpu};
    host.bindSets = (PFN_vkCmdBindDescriptorSets)gpu->vk.GetDeviceProcAddr(gpu->device, "vkCmdBindDescriptorSets");
    VkDescriptorSetLayoutBinding bindings[2] = {0};
    for (uint32_t i = 0; i < 2; ++i)
    {
        bindings[i] = (VkDescriptorSetLayoutBinding){.binding = i,
                                                     .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                                     .descriptorCount = 1,
                                                     .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT};
    }
    const VkDescriptorSetLayoutCreateInfo setInfo = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                                     .flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR,
                                                     .bindingCount = 2,
                                                     .pBindings = bindings};
    assert_int_equal(gpu->vk.CreateDescriptorSetLayout(gpu->device, &setInfo, NULL, &host.ownLayout), VK_SUCCESS);
    VkDescriptorSetLayout sets[2] = {host.ownLayout, VK_NULL_HANDLE};
    assert_int_equal(swGpu_GetLayersLayout(gpu, &sets[1]), SW_SUCCESS);
    const VkPushConstantRange range = {VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(uint32_t)};
    const VkPipelineLayoutCreateInfo layoutInfo = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                                   .setLayoutCount = 2,
                                                   .pSetLayouts = sets,
                                                   .pushConstantRangeCount = 1,
                                                   .pPushConstantRanges = &range};
    assert_int_equal(gpu->vk.CreatePipelineLayout(gpu->device, &layoutInfo, NULL, &host.layout), VK_SUCCESS);
    const VkShaderModuleCreateInfo moduleInfo = {
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = sizeof(askCode), .pCode = askCode};
    VkShaderModule module;
    assert_int_equal(gpu->vk.CreateShaderModule(gpu->device, &moduleInfo, NULL, &module), VK_SUCCESS);
    const VkComputePipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                              .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                        .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                                                        .module = module,
                                                        .pName = "main"},
                                              .layout = host.layout};
    assert_int_equal(gpu->vk.CreateComputePipelines(gpu->device, VK_NULL_HANDLE, 1, &info, NULL, &host.pipeline),
                     VK_SUCCESS);
    gpu->vk.DestroyShaderModule(gpu->device, module, NULL);
    const VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    assert_int_equal(swCreateBuffer(gpu, MOST * sizeof(Place), storage, SW_MEMORY_UPLOAD, "places", &host.places),
                     SW_SUCCESS);
    assert_int_equal(swCreateBuffer(gpu, MOST * sizeof(Answer), storage, SW_MEMORY_READBACK, "answers", &host.answers),
                     SW_SUCCESS);
    return host;
}

static void FreeHost(Host* host)
{
    swDestroyBuffer(host->gpu, &host->places);
    swDestroyBuffer(host->gpu, &host->answers);
    host->gpu->vk.DestroyPipeline(host->gpu->device, host->pipeline, NULL);
    host->gpu->vk.DestroyPipelineLayout(host->gpu->device, host->layout, NULL);
    host->gpu->vk.DestroyDescriptorSetLayout(host->gpu->device, host->ownLayout, NULL);
}

// Record the world's frame and the host's question; wait for the answers.
static const Answer* Ask(Host* host, Parity* parity, swPos reference, uint32_t count, const Place* places)
{
    swGpu* gpu = host->gpu;
    assert_true(count <= MOST);
    memcpy(host->places.mapped, places, count * sizeof(Place));
    VkCommandBuffer commands;
    VkDescriptorSet set;
    assert_int_equal(swBeginSubmit(gpu, &commands), SW_SUCCESS);
    assert_int_equal(swGpuWorld_Record(parity->gpuWorld, commands, gpu->hasFrame ? gpu->frameIndex + 1 : 0),
                     SW_SUCCESS);
    assert_int_equal(swGpuWorld_GetLayers(parity->gpuWorld, parity->view, reference, &set), SW_SUCCESS);
    const VkDescriptorBufferInfo buffers[2] = {{host->places.handle, 0, VK_WHOLE_SIZE},
                                               {host->answers.handle, 0, VK_WHOLE_SIZE}};
    const VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                        .descriptorCount = 1,
                                        .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    VkWriteDescriptorSet writes[2] = {write, write};
    writes[0].pBufferInfo = &buffers[0];
    writes[1].pBufferInfo = &buffers[1];
    writes[1].dstBinding = 1;
    gpu->vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, host->pipeline);
    gpu->vk.CmdPushDescriptorSetKHR(commands, VK_PIPELINE_BIND_POINT_COMPUTE, host->layout, 0, 2, writes);
    host->bindSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, host->layout, 1, 1, &set, 0, NULL);
    gpu->vk.CmdPushConstants(commands, host->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(count), &count);
    gpu->vk.CmdDispatch(commands, (count + 63) / 64, 1, 1);
    swBarrier(gpu, commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
              VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
    assert_int_equal(swEndSubmit(gpu), SW_SUCCESS);
    return host->answers.mapped;
}

static Parity MakeSea(void** state, swPos viewpoint)
{
    Parity parity = MakeParity(state);
    swWaveSystemDef sea = swDefaultWaveSystemDef();
    sea.minWavelength = 2.0f;
    AddParitySea(&parity, &sea);
    AddParityView(&parity, SLICES, RESOLUTION, viewpoint);
    StepParity(&parity, 3.0);
    return parity;
}

static float MaxOf(float a, float b)
{
    return a > b ? a : b;
}

// At texel centres, where nothing is interpolated. The bounds are those of the parity tests of each layer.
static void ALayerIsWhatTheCoreHas(void** state)
{
    const swPos viewpoint = {1.0e6, 2.0, -3.0e5};
    Parity parity = MakeSea(state, viewpoint);
    Host host = MakeHost(parity.gpu);
    Place places[MOST];
    uint32_t count = 0;
    for (int slice = 0; slice < SLICES; ++slice)
    {
        swSliceInfo info = swView_GetSlice(parity.view, slice);
        for (int i = 0; i < 100; ++i, ++count)
        {
            int column = (i * 37) % RESOLUTION, row = (i * 11 + slice) % RESOLUTION;
            places[count] =
                (Place){(float)((double)(info.firstX + column) * info.texel - viewpoint.x),
                        (float)((double)(info.firstZ + row) * info.texel - viewpoint.z), (float)slice, 0.0f};
        }
    }
    const Answer* answers = Ask(&host, &parity, viewpoint, count, places);
    float worst[3] = {0.0f, 0.0f, 0.0f};
    for (uint32_t a = 0; a < count; ++a)
    {
        int slice = (int)places[a].slice, i = (int)a % 100;
        size_t texel = (size_t)((i * 11 + slice) % RESOLUTION) * RESOLUTION + (size_t)((i * 37) % RESOLUTION);
        for (int k = 0; k < 3; ++k)
        {
            const float* displacement = swView_GetDisplacement(parity.view, slice) + 4 * texel;
            const float* derivatives = swView_GetDerivatives(parity.view, slice) + 4 * texel;
            worst[0] = MaxOf(worst[0], fabsf(answers[a].displacement[k] - displacement[k]));
            worst[1] = MaxOf(worst[1], fabsf(answers[a].derivatives[k] - derivatives[k]));
        }
        worst[2] = MaxOf(worst[2], fabsf(answers[a].sliceFoam - swView_GetFoam(parity.view, slice)[texel]));
    }
    printf("  displacement %.2g m, derivatives %.2g, foam %.2g\n", (double)worst[0], (double)worst[1],
           (double)worst[2]);
    assert_true(worst[0] < 2e-4f); // a place is a float, 1e-5 of a texel off
    assert_true(worst[1] < 2e-3f); // stored as half floats
    assert_true(worst[2] < 1e-3f);
    FreeHost(&host);
    FreeParity(&parity);
}

// The blend of swMeshBlend() over the whole stack: weights sum to 1 up to where the last slice ends.
static void SlicesFadeAsInTheMesh(void** state)
{
    const swPos viewpoint = {3.3, 0.1, 4.7};
    Parity parity = MakeSea(state, viewpoint);
    Host host = MakeHost(parity.gpu);
    Place places[MOST];
    float coarsest = (float)swView_GetSlice(parity.view, SLICES - 1).texel;
    for (int i = 0; i < MOST; ++i)
    {
        float range = 40.0f * coarsest * (float)i / MOST;
        places[i] = (Place){range, 0.3f * range, 0.0f, 0.0f};
    }
    const Answer* answers = Ask(&host, &parity, viewpoint, MOST, places);
    assert_int_equal(parity.gpuWorld->views[0].place.scaleLevel, 0);
    const float quads = RESOLUTION / 8.0f;
    for (int i = 0; i < MOST; ++i)
    {
        const Answer* a = &answers[i];
        int first = (int)a->first;
        float steps = places[i].x / (2.0f * (float)swView_GetSlice(parity.view, first).texel);
        bool isLast = first == SLICES - 1;
        assert_true(isLast || steps < 2.0f * quads - 2.0f + 1e-3f);
        float blend = swMeshBlend(steps, 0.0f, 0.0f, 0.0f, quads, 0.0f); // a low view: nothing halves
        float shown = isLast && steps >= 2.0f * quads - 2.0f ? 0.0f : 1.0f - blend;
        assert_float_equal(a->firstWeight, shown, 1e-3f);
        assert_float_equal(a->secondWeight, isLast ? 0.0f : blend, 1e-3f);
    }
    assert_float_equal(answers[0].firstWeight, 1.0f, 0.0f);
    assert_float_equal(answers[MOST - 1].firstWeight, 0.0f, 0.0f); // level water out there
    assert_float_equal(answers[MOST - 1].height, -0.1f, 1e-6f);
    assert_float_equal(answers[MOST - 1].jacobian, 1.0f, 1e-6f);
    FreeHost(&host);
    FreeParity(&parity);
}

// Heights at the same places of the world, 1,000 km from the origin, asked from two references.
static void TheReferenceDoesNotMatter(void** state)
{
    const swPos viewpoint = {1.0e6, 2.0, 1.0e6};
    Parity parity = MakeSea(state, viewpoint);
    Host host = MakeHost(parity.gpu);
    Place places[2][100];
    float heights[100];
    for (int i = 0; i < 100; ++i)
    {
        places[0][i] = (Place){0.125f * (float)(i % 10), 0.125f * (float)(i / 10), 0.0f, 0.0f};
        places[1][i] = (Place){places[0][i].x - 16.0f, places[0][i].z + 8.0f, 0.0f, 0.0f};
    }
    const Answer* answers = Ask(&host, &parity, viewpoint, 100, places[0]);
    for (int i = 0; i < 100; ++i)
    {
        heights[i] = answers[i].height;
    }
    answers = Ask(&host, &parity, (swPos){1.0e6 + 16.0, 5.0, 1.0e6 - 8.0}, 100, places[1]);
    float low = heights[0], high = heights[0];
    for (int i = 0; i < 100; ++i)
    {
        assert_float_equal(answers[i].height + 3.0f, heights[i], 1e-4f);
        low = fminf(low, heights[i]);
        high = MaxOf(high, heights[i]);
    }
    assert_true(high - low > 0.01f); // it is no level sea
    FreeHost(&host);
    FreeParity(&parity);
}

// What the host draws after the world has stepped on is still the recorded frame.
static void ASetBelongsToTheRecordedFrame(void** state)
{
    Parity parity = MakeSea(state, (swPos){0.0, 2.0, 0.0});
    swPos there = {500.0, 2.0, 0.0};
    float before = (float)parity.gpuWorld->views[0].place.viewpoint.x;
    swView_SetViewpoint(parity.view, there);
    assert_int_equal(swWorld_Step(parity.world, 0.1), SW_SUCCESS);
    assert_float_equal(parity.gpuWorld->views[0].place.viewpoint.x, before, 0.0f);
    FreeParity(&parity);
}

static void AViewThatWasNotRecordedIsRefused(void** state)
{
    Parity parity = MakeParity(state);
    AddParityView(&parity, SLICES, RESOLUTION, (swPos){0.0, 2.0, 0.0});
    VkDescriptorSet set;
    assert_int_equal(swGpuWorld_GetLayers(parity.gpuWorld, parity.view, (swPos){0}, &set), SW_ERROR_INVALID);
    assert_true(set == VK_NULL_HANDLE);
    StepParity(&parity, 0.1);
    assert_int_equal(swGpuWorld_GetLayers(parity.gpuWorld, parity.view, (swPos){0}, &set), SW_SUCCESS);
    swGpuWorld_Discard(parity.gpuWorld, parity.gpu->frameIndex);
    assert_int_equal(swGpuWorld_GetLayers(parity.gpuWorld, parity.view, (swPos){0}, &set), SW_ERROR_INVALID);
    FreeParity(&parity);
}

static void SetsOfAFrameAreCounted(void** state)
{
    Parity parity = MakeSea(state, (swPos){0.0, 2.0, 0.0});
    VkDescriptorSet set;
    for (int frame = 0; frame < 5; ++frame)
    {
        for (int i = 0; i < 256; ++i)
        {
            assert_int_equal(swGpuWorld_GetLayers(parity.gpuWorld, parity.view, (swPos){0}, &set), SW_SUCCESS);
        }
        assert_int_equal(swGpuWorld_GetLayers(parity.gpuWorld, parity.view, (swPos){0}, &set), SW_ERROR_LIMIT);
        StepParity(&parity, 0.1); // the next frame has its own
    }
    FreeParity(&parity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ALayerIsWhatTheCoreHas),           cmocka_unit_test(SlicesFadeAsInTheMesh),
        cmocka_unit_test(TheReferenceDoesNotMatter),        cmocka_unit_test(ASetBelongsToTheRecordedFrame),
        cmocka_unit_test(AViewThatWasNotRecordedIsRefused), cmocka_unit_test(SetsOfAFrameAreCounted),
    };
    return cmocka_run_group_tests_name("layers of a view", tests, OpenParityGpu, CloseParityGpu);
}
