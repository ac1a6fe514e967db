// SPDX-License-Identifier: MIT
// A shader of one's own that samples the water: a beach is flooded by a rough sea, far from the origin. The set "the
// layers of a view" is bound beside the host's own; what it says is compared with the core, and the wet sand is written
// to wet_sand.pgm.
#include <seaway/layers.h>
#include <seaway/seaway.h>

#include <vulkan/vulkan.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SIDE 128
#define SPACING 0.25f
#define SLOPE 0.1f
#define TEXEL_FLOATS 4 // height of the water and of the ground, foam, the normal's y

static const uint32_t beachCode[] =
#include "08_own_shader.comp.inc"
    ;

// What a shader is given, in this order; 08_own_shader.comp has the same.
typedef struct Push
{
    uint32_t side;
    float spacing;
    float slope;
} Push;

// The host's own: a buffer that shaders write and the host reads, and a pipeline with two sets.
typedef struct Beach
{
    VkDevice device;
    VkBuffer buffer;
    VkDeviceMemory memory;
    const float* texels;
    VkDescriptorSetLayout setLayout;
    VkDescriptorPool setPool;
    VkDescriptorSet set;
    VkPipelineLayout layout;
    VkPipeline pipeline;
    VkCommandPool pool;
    VkCommandBuffer commands;
} Beach;

static bool CreateBuffer(Beach* beach, const swGpu* gpu)
{
    VkDeviceSize size = SIDE * SIDE * TEXEL_FLOATS * sizeof(float);
    VkBufferCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT};
    if (vkCreateBuffer(beach->device, &info, NULL, &beach->buffer) != VK_SUCCESS)
    {
        return false;
    }
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(beach->device, beach->buffer, &needs);
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(swGpu_GetPhysicalDevice(gpu), &memory);
    const VkMemoryPropertyFlags wanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    uint32_t type = 0;
    while (type < memory.memoryTypeCount &&
           ((needs.memoryTypeBits & 1u << type) == 0 || (memory.memoryTypes[type].propertyFlags & wanted) != wanted))
    {
        type += 1;
    }
    VkMemoryAllocateInfo allocate = {
        .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs.size, .memoryTypeIndex = type};
    void* mapped = NULL;
    bool isGood = vkAllocateMemory(beach->device, &allocate, NULL, &beach->memory) == VK_SUCCESS &&
                  vkBindBufferMemory(beach->device, beach->buffer, beach->memory, 0) == VK_SUCCESS &&
                  vkMapMemory(beach->device, beach->memory, 0, VK_WHOLE_SIZE, 0, &mapped) == VK_SUCCESS;
    beach->texels = mapped;
    return isGood;
}

static bool CreateOwnSet(Beach* beach)
{
    VkDescriptorSetLayoutBinding binding = {.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                            .descriptorCount = 1,
                                            .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT};
    VkDescriptorSetLayoutCreateInfo layoutInfo = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = 1, .pBindings = &binding};
    VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1};
    VkDescriptorPoolCreateInfo poolInfo = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1, .poolSizeCount = 1, .pPoolSizes = &size};
    if (vkCreateDescriptorSetLayout(beach->device, &layoutInfo, NULL, &beach->setLayout) != VK_SUCCESS ||
        vkCreateDescriptorPool(beach->device, &poolInfo, NULL, &beach->setPool) != VK_SUCCESS)
    {
        return false;
    }
    VkDescriptorSetAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                        .descriptorPool = beach->setPool,
                                        .descriptorSetCount = 1,
                                        .pSetLayouts = &beach->setLayout};
    if (vkAllocateDescriptorSets(beach->device, &info, &beach->set) != VK_SUCCESS)
    {
        return false;
    }
    VkDescriptorBufferInfo buffer = {beach->buffer, 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                  .dstSet = beach->set,
                                  .descriptorCount = 1,
                                  .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                  .pBufferInfo = &buffer};
    vkUpdateDescriptorSets(beach->device, 1, &write, 0, NULL);
    return true;
}

// Set 0 is the host's, set 1 the water: SW_LAYERS_SET in the shader.
static bool CreatePipeline(Beach* beach, swGpu* gpu)
{
    VkDescriptorSetLayout sets[2] = {beach->setLayout, VK_NULL_HANDLE};
    if (swGpu_GetLayersLayout(gpu, &sets[1]) != SW_SUCCESS)
    {
        return false;
    }
    VkPushConstantRange range = {.stageFlags = VK_SHADER_STAGE_COMPUTE_BIT, .size = sizeof(Push)};
    VkPipelineLayoutCreateInfo layoutInfo = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                             .setLayoutCount = 2,
                                             .pSetLayouts = sets,
                                             .pushConstantRangeCount = 1,
                                             .pPushConstantRanges = &range};
    VkShaderModuleCreateInfo moduleInfo = {
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = sizeof(beachCode), .pCode = beachCode};
    VkShaderModule module = VK_NULL_HANDLE;
    if (vkCreatePipelineLayout(beach->device, &layoutInfo, NULL, &beach->layout) != VK_SUCCESS ||
        vkCreateShaderModule(beach->device, &moduleInfo, NULL, &module) != VK_SUCCESS)
    {
        return false;
    }
    VkComputePipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                                                  .module = module,
                                                  .pName = "main"},
                                        .layout = beach->layout};
    VkResult result = vkCreateComputePipelines(beach->device, VK_NULL_HANDLE, 1, &info, NULL, &beach->pipeline);
    vkDestroyShaderModule(beach->device, module, NULL);
    return result == VK_SUCCESS;
}

static bool CreateCommands(Beach* beach, const swGpu* gpu)
{
    VkCommandPoolCreateInfo poolInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                        .queueFamilyIndex = swGpu_GetQueueFamily(gpu)};
    if (vkCreateCommandPool(beach->device, &poolInfo, NULL, &beach->pool) != VK_SUCCESS)
    {
        return false;
    }
    VkCommandBufferAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                        .commandPool = beach->pool,
                                        .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                        .commandBufferCount = 1};
    return vkAllocateCommandBuffers(beach->device, &info, &beach->commands) == VK_SUCCESS;
}

static void DestroyBeach(Beach* beach)
{
    vkDestroyCommandPool(beach->device, beach->pool, NULL);
    vkDestroyPipeline(beach->device, beach->pipeline, NULL);
    vkDestroyPipelineLayout(beach->device, beach->layout, NULL);
    vkDestroyDescriptorPool(beach->device, beach->setPool, NULL);
    vkDestroyDescriptorSetLayout(beach->device, beach->setLayout, NULL);
    vkDestroyBuffer(beach->device, beach->buffer, NULL);
    vkFreeMemory(beach->device, beach->memory, NULL);
}

// [frame]
// The water's passes first; then the set of this frame, and whatever reads it. No barrier is needed between them.
static bool RecordBeach(Beach* beach, swGpuWorld* gpuWorld, const swView* view, swPos reference, uint64_t frameIndex)
{
    VkDescriptorSet sets[2] = {beach->set, VK_NULL_HANDLE};
    if (swGpuWorld_Record(gpuWorld, beach->commands, frameIndex) != SW_SUCCESS ||
        swGpuWorld_GetLayers(gpuWorld, view, reference, &sets[1]) != SW_SUCCESS)
    {
        return false;
    }
    Push push = {.side = SIDE, .spacing = SPACING, .slope = SLOPE};
    vkCmdBindPipeline(beach->commands, VK_PIPELINE_BIND_POINT_COMPUTE, beach->pipeline);
    vkCmdBindDescriptorSets(beach->commands, VK_PIPELINE_BIND_POINT_COMPUTE, beach->layout, 0, 2, sets, 0, NULL);
    vkCmdPushConstants(beach->commands, beach->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(push), &push);
    vkCmdDispatch(beach->commands, SIDE / 8, SIDE / 8, 1);
    return true;
}
// [/frame]

static bool RunFrame(Beach* beach, const swGpu* gpu, swGpuWorld* gpuWorld, const swView* view, swPos reference)
{
    VkCommandBufferBeginInfo beginInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                          .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    VkSubmitInfo submit = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &beach->commands};
    VkMemoryBarrier toHost = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                              .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
                              .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    if (vkBeginCommandBuffer(beach->commands, &beginInfo) != VK_SUCCESS ||
        !RecordBeach(beach, gpuWorld, view, reference, 0))
    {
        return false;
    }
    vkCmdPipelineBarrier(beach->commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &toHost, 0, NULL, 0, NULL);
    return vkEndCommandBuffer(beach->commands) == VK_SUCCESS &&
           vkQueueSubmit(swGpu_GetQueue(gpu), 1, &submit, VK_NULL_HANDLE) == VK_SUCCESS &&
           vkDeviceWaitIdle(beach->device) == VK_SUCCESS;
}

// Waves as short as the finest slice holds, at the texels' places. Returns the largest difference of a height.
static double CompareWithCore(const swWorld* world, const swView* view, const Beach* beach, swPos reference)
{
    swPosXZ places[SIDE];
    float heights[SIDE];
    double worst = 0.0;
    swQueryDef def = swDefaultQueryDef();
    def.minWavelength = swView_GetSlice(view, 0).minWavelength;
    for (int row = 0; row < SIDE; row += 8)
    {
        for (int column = 0; column < SIDE; ++column)
        {
            places[column].x = reference.x + (column - SIDE / 2) * (double)SPACING;
            places[column].z = reference.z + (row - SIDE / 2) * (double)SPACING;
        }
        swSurfaceSamples samples = {.height = heights};
        swMoment_QuerySurface(swWorld_GetMoment(world), &def, SIDE, places, &samples, NULL);
        for (int column = 0; column < SIDE; ++column)
        {
            double own = reference.y + (double)beach->texels[(row * SIDE + column) * TEXEL_FLOATS];
            double difference = fabs(own - (double)heights[column]);
            worst = difference <= worst ? worst : difference; // NaN counts as worst
        }
    }
    return worst;
}

// Dry sand is light, wet sand dark, and foam white.
static bool WriteSand(const Beach* beach)
{
    FILE* file = fopen("wet_sand.pgm", "wb");
    if (file == NULL)
    {
        return false;
    }
    fprintf(file, "P5\n%d %d\n255\n", SIDE, SIDE);
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
        const float* texel = beach->texels + i * TEXEL_FLOATS;
        float depth = texel[0] - texel[1];
        float grey = depth <= 0.0f ? 0.8f : 0.1f + 0.3f * expf(-depth);
        grey = depth > 0.0f ? grey + (1.0f - grey) * texel[2] : grey;
        fputc((int)(grey * 255.0f + 0.5f), file);
    }
    return fclose(file) == 0;
}

static bool RunBeach(swWorld* world, swGpu* gpu, swView* view)
{
    // 1,000 km from the origin: the shader's floats count from the beach.
    const swPos reference = {1.0e6, 1.0, -1.0e6};
    swGpuWorld* gpuWorld = NULL;
    Beach beach = {.device = swGpu_GetDevice(gpu)};
    swView_SetViewpoint(view, reference);
    bool isGood = swWorld_Step(world, 20.0) == SW_SUCCESS && swCreateGpuWorld(gpu, world, &gpuWorld) == SW_SUCCESS &&
                  CreateBuffer(&beach, gpu) && CreateOwnSet(&beach) && CreatePipeline(&beach, gpu) &&
                  CreateCommands(&beach, gpu) && RunFrame(&beach, gpu, gpuWorld, view, reference);
    if (isGood)
    {
        double worst = CompareWithCore(world, view, &beach, reference);
        printf("largest difference from the core: %.2g m\n", worst);
        isGood = worst < 0.05 && WriteSand(&beach); // waves of eight texels, drawn straight from texel to texel
    }
    DestroyBeach(&beach);
    swDestroyGpuWorld(gpuWorld);
    return isGood;
}

int main(void)
{
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    swGpuDef gpuDef = swDefaultGpuDef();
    swViewDef viewDef = swDefaultViewDef();
    swWorld* world = NULL;
    swWaveSystemId sea;
    swGpu* gpu = NULL;
    swView* view = NULL;
    bool isGood = swCreateWorld(&host, &worldDef, &world) == SW_SUCCESS &&
                  swCreateWaveSystem(world, &waves, &sea) == SW_SUCCESS &&
                  swCreateGpu(&host, &gpuDef, &gpu) == SW_SUCCESS;
    if (isGood)
    {
        viewDef.enableCpuLayers = swGpu_WantsCpuLayers(gpu);
        isGood = swCreateView(world, &viewDef, &view) == SW_SUCCESS && RunBeach(world, gpu, view);
    }
    swDestroyView(view);
    swDestroyGpu(gpu);
    swDestroyWorld(world);
    return isGood ? 0 : 1; // the host's log has said why
}
