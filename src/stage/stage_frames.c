// SPDX-License-Identifier: MIT
// Frames in flight: each has a slot, and a slot is recorded again once its last frame is done.

#include "stage/stage_base.h"

static swResult createSlot(swStage* stage, swStageSlot* slot)
{
    const VkCommandPoolCreateInfo poolInfo = {
        .sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
        .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
        .queueFamilyIndex = swGpu_GetQueueFamily(stage->gpu),
    };
    const VkFenceCreateInfo fenceInfo = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkResult result = stage->vk.CreateCommandPool(stage->device, &poolInfo, NULL, &slot->pool);
    if (result != VK_SUCCESS)
    {
        return swCheckStage(stage, result, "making a command pool");
    }
    const VkCommandBufferAllocateInfo info = {
        .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
        .commandPool = slot->pool,
        .commandBufferCount = 1,
    };
    result = stage->vk.AllocateCommandBuffers(stage->device, &info, &slot->commands);
    result = result != VK_SUCCESS ? result : stage->vk.CreateFence(stage->device, &fenceInfo, NULL, &slot->isDone);
    return swCheckStage(stage, result, "making a command buffer");
}

swResult swCreateStageSlots(swStage* stage, int count)
{
    stage->slotCount = count < SW_STAGE_MAX_SLOTS ? count : SW_STAGE_MAX_SLOTS;
    swResult result = SW_SUCCESS;
    for (int i = 0; i < stage->slotCount && result == SW_SUCCESS; ++i)
    {
        result = createSlot(stage, &stage->slots[i]);
    }
    return result;
}

void swDestroyStageSlots(swStage* stage)
{
    for (int i = 0; i < stage->slotCount; ++i)
    {
        stage->vk.DestroyFence(stage->device, stage->slots[i].isDone, NULL);
        stage->vk.DestroyCommandPool(stage->device, stage->slots[i].pool, NULL);
    }
}

static swStageSlot* findSlot(swStage* stage, uint64_t index)
{
    return &stage->slots[index % (uint64_t)stage->slotCount];
}

static swResult waitForSlot(swStage* stage, swStageSlot* slot)
{
    if (!slot->isSubmitted)
    {
        return SW_SUCCESS;
    }
    VkResult result = stage->vk.WaitForFences(stage->device, 1, &slot->isDone, VK_TRUE, UINT64_MAX);
    result = result != VK_SUCCESS ? result : stage->vk.ResetFences(stage->device, 1, &slot->isDone);
    if (result != VK_SUCCESS)
    {
        return swCheckStage(stage, result, "waiting for a frame");
    }
    slot->isSubmitted = false;
    return SW_SUCCESS;
}

swResult swStage_BeginFrame(swStage* stage, swStageFrame* frame)
{
    SW_REQUIRE(stage != NULL, SW_ERROR_INVALID, NULL, "swStage_BeginFrame() needs a stage");
    SW_REQUIRE(frame != NULL, SW_ERROR_INVALID, &stage->host, "swStage_BeginFrame() needs a place for the frame");
    SW_REQUIRE(!stage->isRecording, SW_ERROR_INVALID, &stage->host,
               "swStage_BeginFrame() was called before the last frame was submitted or dropped");
    swStageSlot* slot = findSlot(stage, stage->nextIndex);
    swResult waited = waitForSlot(stage, slot);
    if (waited != SW_SUCCESS)
    {
        return waited;
    }
    const VkCommandBufferBeginInfo info = {
        .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
        .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT,
    };
    VkResult result = stage->vk.ResetCommandPool(stage->device, slot->pool, 0);
    result = result != VK_SUCCESS ? result : stage->vk.BeginCommandBuffer(slot->commands, &info);
    if (result != VK_SUCCESS)
    {
        return swCheckStage(stage, result, "beginning a frame");
    }
    slot->index = stage->nextIndex++;
    stage->isRecording = true;
    *frame = (swStageFrame){.commands = slot->commands, .index = slot->index};
    return SW_SUCCESS;
}

static bool isRecorded(const swStage* stage, const swStageFrame* frame, const char* call)
{
    SW_REQUIRE(stage != NULL, false, NULL, "%s needs a stage", call);
    SW_REQUIRE(frame != NULL && frame->commands != VK_NULL_HANDLE && stage->isRecording &&
                   frame->index + 1 == stage->nextIndex,
               false, &stage->host, "%s needs the frame that swStage_BeginFrame() began last", call);
    return true;
}

swResult swStage_SubmitFrame(swStage* stage, const swStageFrame* frame, const swStageSync* sync)
{
    if (!isRecorded(stage, frame, "swStage_SubmitFrame()"))
    {
        return SW_ERROR_INVALID;
    }
    const VkSemaphoreSubmitInfo wait = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                        .semaphore = sync != NULL ? sync->wait : VK_NULL_HANDLE,
                                        .stageMask = sync != NULL ? sync->waitStages : 0};
    const VkSemaphoreSubmitInfo signal = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                          .semaphore = sync != NULL ? sync->signal : VK_NULL_HANDLE,
                                          .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    const VkCommandBufferSubmitInfo commands = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                                .commandBuffer = frame->commands};
    const VkSubmitInfo2 info = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
        .waitSemaphoreInfoCount = wait.semaphore != VK_NULL_HANDLE,
        .pWaitSemaphoreInfos = &wait,
        .commandBufferInfoCount = 1,
        .pCommandBufferInfos = &commands,
        .signalSemaphoreInfoCount = signal.semaphore != VK_NULL_HANDLE,
        .pSignalSemaphoreInfos = &signal,
    };
    swStageSlot* slot = findSlot(stage, frame->index);
    stage->isRecording = false;
    VkResult result = stage->vk.EndCommandBuffer(frame->commands);
    result = result != VK_SUCCESS ? result : stage->vk.QueueSubmit2(stage->queue, 1, &info, slot->isDone);
    slot->isSubmitted = result == VK_SUCCESS;
    return swCheckStage(stage, result, "submitting a frame");
}

void swStage_DropFrame(swStage* stage, const swStageFrame* frame)
{
    if (isRecorded(stage, frame, "swStage_DropFrame()"))
    {
        stage->isRecording = false; // the slot's next frame resets the pool
    }
}

swResult swStage_Wait(swStage* stage)
{
    SW_REQUIRE(stage != NULL, SW_ERROR_INVALID, NULL, "swStage_Wait() needs a stage");
    uint64_t newest = 0;
    bool hasWaited = false;
    for (int i = 0; i < stage->slotCount; ++i)
    {
        swStageSlot* slot = &stage->slots[i];
        bool isNewest = slot->isSubmitted && slot->index >= newest;
        newest = isNewest ? slot->index : newest;
        hasWaited = hasWaited || isNewest;
        swResult result = waitForSlot(stage, slot);
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    if (hasWaited)
    {
        swGpu_SetFinishedFrame(stage->gpu, newest);
    }
    return SW_SUCCESS;
}
