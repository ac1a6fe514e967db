// SPDX-License-Identifier: MIT
// A picture without a window: Seaway makes the Vulkan device, this program the images and the command buffer. Works
// without a GPU too, on Mesa's software device.
//
//   02_headless_picture [picture.ppm]
#include <seaway/draw.h>
#include <seaway/seaway.h>

#include <vulkan/vulkan.h>

#include <stdio.h>

#define WIDTH 640u
#define HEIGHT 360u

typedef struct Image
{
    VkImage image;
    VkDeviceMemory memory;
    VkImageView view;
} Image;

typedef struct Targets
{
    swGpu* gpu;
    VkDevice device;
    Image hdr, depth, output;
    VkBuffer buffer; // the finished picture, for the CPU
    VkDeviceMemory bufferMemory;
    VkCommandPool pool;
    VkCommandBuffer commands;
} Targets;

static VkDeviceMemory Allocate(const Targets* targets, VkMemoryRequirements needs, VkMemoryPropertyFlags wanted)
{
    VkPhysicalDeviceMemoryProperties properties;
    vkGetPhysicalDeviceMemoryProperties(swGpu_GetPhysicalDevice(targets->gpu), &properties);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    for (uint32_t i = 0; i < properties.memoryTypeCount && !memory; ++i)
    {
        bool fits = (needs.memoryTypeBits & (1u << i)) && (properties.memoryTypes[i].propertyFlags & wanted) == wanted;
        VkMemoryAllocateInfo info = {
            .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs.size, .memoryTypeIndex = i};
        if (fits && vkAllocateMemory(targets->device, &info, NULL, &memory) != VK_SUCCESS)
        {
            memory = VK_NULL_HANDLE;
        }
    }
    return memory;
}

static bool CreateImage(Targets* targets, Image* image, VkFormat format, VkImageUsageFlags usage)
{
    bool isDepth = format == VK_FORMAT_D32_SFLOAT;
    VkImageCreateInfo info = {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                              .imageType = VK_IMAGE_TYPE_2D,
                              .format = format,
                              .extent = {WIDTH, HEIGHT, 1},
                              .mipLevels = 1,
                              .arrayLayers = 1,
                              .samples = VK_SAMPLE_COUNT_1_BIT,
                              .usage = usage};
    if (vkCreateImage(targets->device, &info, NULL, &image->image) != VK_SUCCESS)
    {
        return false;
    }
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(targets->device, image->image, &needs);
    image->memory = Allocate(targets, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    VkImageAspectFlags aspect = isDepth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
    VkImageViewCreateInfo viewInfo = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                      .image = image->image,
                                      .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                      .format = format,
                                      .subresourceRange = {aspect, 0, 1, 0, 1}};
    return image->memory && vkBindImageMemory(targets->device, image->image, image->memory, 0) == VK_SUCCESS &&
           vkCreateImageView(targets->device, &viewInfo, NULL, &image->view) == VK_SUCCESS;
}

static void DestroyImage(VkDevice device, const Image* image)
{
    vkDestroyImageView(device, image->view, NULL);
    vkDestroyImage(device, image->image, NULL);
    vkFreeMemory(device, image->memory, NULL);
}

static bool CreateBuffer(Targets* targets)
{
    VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                               .size = 4u * WIDTH * HEIGHT,
                               .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    if (vkCreateBuffer(targets->device, &info, NULL, &targets->buffer) != VK_SUCCESS)
    {
        return false;
    }
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(targets->device, targets->buffer, &needs);
    targets->bufferMemory =
        Allocate(targets, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    return targets->bufferMemory &&
           vkBindBufferMemory(targets->device, targets->buffer, targets->bufferMemory, 0) == VK_SUCCESS;
}

static bool CreateCommands(Targets* targets)
{
    VkCommandPoolCreateInfo poolInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                        .queueFamilyIndex = swGpu_GetQueueFamily(targets->gpu)};
    if (vkCreateCommandPool(targets->device, &poolInfo, NULL, &targets->pool) != VK_SUCCESS)
    {
        return false;
    }
    VkCommandBufferAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                        .commandPool = targets->pool,
                                        .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                        .commandBufferCount = 1};
    return vkAllocateCommandBuffers(targets->device, &info, &targets->commands) == VK_SUCCESS;
}

static bool CreateTargets(Targets* targets, swGpu* gpu, const swPictureDef* def)
{
    VkImageUsageFlags target = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    targets->gpu = gpu;
    targets->device = swGpu_GetDevice(gpu);
    return CreateImage(targets, &targets->hdr, def->colorFormat, target | VK_IMAGE_USAGE_SAMPLED_BIT) &&
           CreateImage(targets, &targets->depth, def->depthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT) &&
           CreateImage(targets, &targets->output, def->outputFormat, target | VK_IMAGE_USAGE_TRANSFER_SRC_BIT) &&
           CreateBuffer(targets) && CreateCommands(targets);
}

static void DestroyTargets(Targets* targets)
{
    if (!targets->device)
    {
        return;
    }
    vkDeviceWaitIdle(targets->device);
    vkDestroyCommandPool(targets->device, targets->pool, NULL);
    vkDestroyBuffer(targets->device, targets->buffer, NULL);
    vkFreeMemory(targets->device, targets->bufferMemory, NULL);
    DestroyImage(targets->device, &targets->hdr);
    DestroyImage(targets->device, &targets->depth);
    DestroyImage(targets->device, &targets->output);
}

// Wait for everything before, then change the layout: simple, and fast enough for one picture.
static void Transition(VkCommandBuffer commands, const Image* image, VkImageAspectFlags aspect, VkImageLayout from,
                       VkImageLayout to)
{
    VkImageMemoryBarrier2 barrier = {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                     .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                     .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
                                     .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                     .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
                                     .oldLayout = from,
                                     .newLayout = to,
                                     .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                     .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                     .image = image->image,
                                     .subresourceRange = {aspect, 0, 1, 0, 1}};
    VkDependencyInfo dependency = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier};
    vkCmdPipelineBarrier2(commands, &dependency);
}

static void BeginRendering(VkCommandBuffer commands, const Image* color, const Image* depth)
{
    // Reversed depth: 0 is infinitely far.
    VkRenderingAttachmentInfo colorInfo = {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                           .imageView = color->view,
                                           .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                           .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                           .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
    VkRenderingAttachmentInfo depthInfo = {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                           .imageView = depth ? depth->view : VK_NULL_HANDLE,
                                           .imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                           .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                           .storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE};
    VkRenderingInfo info = {.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                            .renderArea = {{0, 0}, {WIDTH, HEIGHT}},
                            .layerCount = 1,
                            .colorAttachmentCount = 1,
                            .pColorAttachments = &colorInfo,
                            .pDepthAttachment = depth ? &depthInfo : NULL};
    VkViewport viewport = {0.0f, 0.0f, (float)WIDTH, (float)HEIGHT, 0.0f, 1.0f};
    VkRect2D scissor = {{0, 0}, {WIDTH, HEIGHT}};
    vkCmdBeginRendering(commands, &info);
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
}

// [passes]
// Water, sky, exposure, tone curve, and a copy that the CPU can read.
static void RecordPicture(Targets* targets, swPicture* picture)
{
    VkCommandBuffer commands = targets->commands;
    VkImageAspectFlags color = VK_IMAGE_ASPECT_COLOR_BIT;
    Transition(commands, &targets->hdr, color, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    Transition(commands, &targets->depth, VK_IMAGE_ASPECT_DEPTH_BIT, VK_IMAGE_LAYOUT_UNDEFINED,
               VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    BeginRendering(commands, &targets->hdr, &targets->depth);
    swPicture_DrawSurface(picture, commands);
    swPicture_DrawSky(picture, commands);
    vkCmdEndRendering(commands);

    Transition(commands, &targets->hdr, color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
               VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    swPicture_Expose(picture, commands, targets->hdr.view, 0.0f, true);

    Transition(commands, &targets->output, color, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    BeginRendering(commands, &targets->output, NULL);
    swPicture_Tonemap(picture, commands, targets->hdr.view);
    vkCmdEndRendering(commands);

    Transition(commands, &targets->output, color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
               VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkBufferImageCopy copy = {.imageSubresource = {color, 0, 0, 1}, .imageExtent = {WIDTH, HEIGHT, 1}};
    vkCmdCopyImageToBuffer(commands, targets->output.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, targets->buffer, 1,
                           &copy);
}
// [/passes]

static bool SubmitAndWait(const Targets* targets)
{
    VkQueue queue = swGpu_GetQueue(targets->gpu);
    VkSubmitInfo info = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &targets->commands};
    return vkEndCommandBuffer(targets->commands) == VK_SUCCESS &&
           vkQueueSubmit(queue, 1, &info, VK_NULL_HANDLE) == VK_SUCCESS && vkQueueWaitIdle(queue) == VK_SUCCESS;
}

static bool WritePpm(const Targets* targets, const char* path)
{
    void* mapped;
    if (vkMapMemory(targets->device, targets->bufferMemory, 0, VK_WHOLE_SIZE, 0, &mapped) != VK_SUCCESS)
    {
        return false;
    }
    FILE* file = fopen(path, "wb");
    bool isWritten = file != NULL;
    if (file)
    {
        const unsigned char* texels = mapped;
        fprintf(file, "P6\n%u %u\n255\n", WIDTH, HEIGHT);
        for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; ++i)
        {
            fwrite(texels + 4 * i, 1, 3, file);
        }
        isWritten = !ferror(file);
        isWritten = fclose(file) == 0 && isWritten;
    }
    vkUnmapMemory(targets->device, targets->bufferMemory);
    return isWritten;
}

// A gale seen from a ship's bridge.
static bool DrawSea(Targets* targets, swWorld* world, swView* view, swGpuWorld* gpuWorld, swPicture* picture)
{
    swPos eye = {0.0, 12.0, 0.0};
    swShot shot = {.view = view, .sky = swDefaultSkyDef(), .water = swDefaultWaterDef()};
    shot.camera = swMakeCamera(eye, 3.6f, -0.09f, 0.0f, 0.9f, WIDTH, HEIGHT);
    shot.water.windSpeed = 16.0f;
    VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};

    swView_SetViewpoint(view, eye);
    if (swWorld_Step(world, 0.0) != SW_SUCCESS || vkBeginCommandBuffer(targets->commands, &begin) != VK_SUCCESS ||
        swGpuWorld_Record(gpuWorld, targets->commands, 0) != SW_SUCCESS ||
        swPicture_Prepare(picture, targets->commands, &shot, 0) != SW_SUCCESS)
    {
        return false;
    }
    RecordPicture(targets, picture);
    return SubmitAndWait(targets);
}

int main(int argc, char** argv)
{
    const char* path = argc > 1 ? argv[1] : "sea.ppm";
    swHost host = swDefaultHost();
    swWorldDef worldDef = swDefaultWorldDef();
    swViewDef viewDef = swDefaultViewDef();
    swGpuDef gpuDef = swDefaultGpuDef();
    swPictureDef pictureDef = swDefaultPictureDef();
    swWaveSystemDef waves = swDefaultWaveSystemDef();
    waves.spectrum.windSpeed = 16.0f;

    swWorld* world = NULL;
    swView* view = NULL;
    swGpu* gpu = NULL;
    swGpuWorld* gpuWorld = NULL;
    swRenderer* renderer = NULL;
    swPicture* picture = NULL;
    swWaveSystemId sea;
    Targets targets = {0};
    bool isDrawn = swCreateGpu(&host, &gpuDef, &gpu) == SW_SUCCESS;
    if (isDrawn)
    {
        viewDef = swGpu_FitView(gpu, &viewDef, HEIGHT); // without a GPU the core makes the view's layers
    }
    isDrawn =
        isDrawn && swCreateWorld(&host, &worldDef, &world) == SW_SUCCESS &&
        swCreateWaveSystem(world, &waves, &sea) == SW_SUCCESS && swCreateView(world, &viewDef, &view) == SW_SUCCESS &&
        swCreateGpuWorld(gpu, world, &gpuWorld) == SW_SUCCESS && swCreateRenderer(gpuWorld, &renderer) == SW_SUCCESS &&
        swCreatePicture(renderer, &pictureDef, &picture) == SW_SUCCESS && CreateTargets(&targets, gpu, &pictureDef) &&
        DrawSea(&targets, world, view, gpuWorld, picture);
    bool isWritten = isDrawn && WritePpm(&targets, path);
    if (isWritten)
    {
        printf("%s: %u x %u, drawn by %s\n", path, WIDTH, HEIGHT, swGpu_GetDeviceName(gpu));
    }
    else if (isDrawn)
    {
        fprintf(stderr, "02_headless_picture: cannot write %s\n", path);
    }

    DestroyTargets(&targets);
    swDestroyPicture(picture);
    swDestroyRenderer(renderer);
    swDestroyGpuWorld(gpuWorld);
    swDestroyGpu(gpu);
    swDestroyView(view);
    swDestroyWorld(world);
    return isWritten ? 0 : 1;
}
