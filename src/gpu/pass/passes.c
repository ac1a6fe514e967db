// SPDX-License-Identifier: MIT
#include "gpu/pass/passes.h"

#include <string.h>

#include "core/base/assert.h"

static const swPass* const passes[SW_PASS_COUNT] = {
#define SW_PASS(NAME, name, text) &swPass_##name,
#include "core/frame/passes.inl"
#undef SW_PASS
};

const swPass* swGetPass(swPassId id)
{
    return passes[id];
}

swResult swCreatePasses(swGpuWorld* gpuWorld)
{
    for (int i = 0; i < SW_PASS_COUNT; ++i)
    {
        gpuWorld->passes[i].state = swAllocateZero(&gpuWorld->gpu->host, passes[i]->stateSize);
        if (gpuWorld->passes[i].state == NULL)
        {
            return swFail(&gpuWorld->gpu->host, SW_ERROR_NO_MEMORY, "no memory for the pass %s", passes[i]->name);
        }
    }
    return SW_SUCCESS;
}

void swDestroyPasses(swGpuWorld* gpuWorld)
{
    for (int i = 0; i < SW_PASS_COUNT; ++i)
    {
        void* state = gpuWorld->passes[i].state;
        if (state != NULL)
        {
            passes[i]->destroy(gpuWorld->gpu, state);
        }
        swFree(&gpuWorld->gpu->host, state, passes[i]->stateSize);
    }
}

swResult swCreatePass(swGpuWorld* gpuWorld, swPassId id)
{
    return passes[id]->create(gpuWorld, gpuWorld->passes[id].state);
}

swResult swPreparePasses(swGpuWorld* gpuWorld, const swFrame* frame)
{
    for (int i = 0; i < SW_PASS_COUNT; ++i)
    {
        swPassRun* run = &gpuWorld->passes[i];
        run->isNeeded = false;
        swResult result = passes[i]->upload(gpuWorld, frame, run->state, &run->isNeeded);
        if (result == SW_SUCCESS && run->isNeeded)
        {
            result = swCreatePass(gpuWorld, (swPassId)i);
        }
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    return SW_SUCCESS;
}

void swOrderStep(swGpu* gpu, VkCommandBuffer commands, swHazards* hazards, swStepStage stage, swResources reads,
                 swResources writes)
{
    static const struct
    {
        VkPipelineStageFlags2 stage;
        VkAccessFlags2 writes, all;
    } scopes[SW_STAGE_COUNT] = {
        [SW_STAGE_COMPUTE] = {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                              VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT |
                                  VK_ACCESS_2_SHADER_SAMPLED_READ_BIT},
        [SW_STAGE_COPY] = {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                           VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT},
    };
    uint32_t waits = swTakeStep(hazards, stage, reads, writes);
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;
    for (int by = 0; by < SW_STAGE_COUNT; ++by)
    {
        stages |= (waits & 1u << by) != 0 ? scopes[by].stage : 0;
        access |= (waits & 1u << by) != 0 ? scopes[by].writes : 0;
    }
    if (stages != 0)
    {
        swBarrier(gpu, commands, stages, access, scopes[stage].stage, scopes[stage].all);
    }
}

void swRecordPasses(swGpuWorld* gpuWorld, VkCommandBuffer commands, swHazards* hazards)
{
    swGpu* gpu = gpuWorld->gpu;
    for (int i = 0; i < SW_PASS_COUNT; ++i)
    {
        const swPass* pass = passes[i];
        if (gpuWorld->passes[i].isNeeded)
        {
            swOrderStep(gpu, commands, hazards, pass->stage, pass->reads, pass->writes);
            swBeginPass(gpu, commands, pass->name);
            pass->record(gpuWorld, gpuWorld->passes[i].state, commands);
            swEndPass(gpu, commands);
        }
    }
}

void swDiscardPasses(swGpuWorld* gpuWorld, uint64_t frameIndex)
{
    for (int i = 0; i < SW_PASS_COUNT; ++i)
    {
        if (passes[i]->discard != NULL)
        {
            passes[i]->discard(gpuWorld, gpuWorld->passes[i].state, frameIndex);
        }
    }
}

size_t swGetPassMemory(const swGpuWorld* gpuWorld)
{
    size_t bytes = 0;
    for (int i = 0; i < SW_PASS_COUNT; ++i)
    {
        bytes += passes[i]->getMemory != NULL ? passes[i]->getMemory(gpuWorld->passes[i].state) : 0;
    }
    return bytes;
}

const swGpuView* swFindGpuView(const swGpuWorld* gpuWorld, const swView* view)
{
    for (int i = 0; i < SW_MAX_VIEWS && gpuWorld->isRecorded; ++i)
    {
        if (gpuWorld->views[i].isUsed && gpuWorld->views[i].view == view)
        {
            return &gpuWorld->views[i];
        }
    }
    return NULL;
}

static int findVariant(const swVariants* variants, const swShader* shader, const void* constants)
{
    size_t size = shader->constantCount * sizeof(uint32_t);
    int found = 0;
    while (found < variants->count && memcmp(variants->constants[found], constants, size) != 0)
    {
        found += 1;
    }
    return found;
}

swResult swCreateVariant(swGpu* gpu, const swShader* shader, const void* constants, swVariants* variants)
{
    int at = findVariant(variants, shader, constants);
    if (at < variants->count)
    {
        return SW_SUCCESS;
    }
    if (at == SW_MAX_VARIANTS)
    {
        return swFail(&gpu->host, SW_ERROR_LIMIT, "%s has more than %d variants", shader->name, SW_MAX_VARIANTS);
    }
    swResult result = swCreateComputePipeline(gpu, shader, constants, &variants->pipelines[at]);
    if (result == SW_SUCCESS)
    {
        memcpy(variants->constants[at], constants, shader->constantCount * sizeof(uint32_t));
        variants->count += 1;
    }
    return result;
}

const swPipeline* swFindVariant(const swVariants* variants, const swShader* shader, const void* constants)
{
    int at = findVariant(variants, shader, constants);
    SW_ASSERT(at < variants->count);
    return at < variants->count ? &variants->pipelines[at] : NULL;
}

void swDestroyVariants(swGpu* gpu, swVariants* variants)
{
    for (int i = 0; i < variants->count; ++i)
    {
        swDestroyPipeline(gpu, &variants->pipelines[i]);
    }
    variants->count = 0;
}

swResult swCreateOnce(swGpu* gpu, const swShader* shader, swPipeline* pipeline)
{
    return pipeline->handle != VK_NULL_HANDLE ? SW_SUCCESS : swCreateComputePipeline(gpu, shader, NULL, pipeline);
}
