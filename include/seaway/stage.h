// SPDX-License-Identifier: MIT
#pragma once

#include "draw.h"

/// @file
/// A stage for tools and tests: a device, images to draw to, commands and their submission, and the way back to the
/// host. A host has its own of all that and needs nothing from here. It is written to be short, not to be fast: every
/// image has device memory of its own, and barriers say what they wait for by a handful of uses.
///
/// A function that returns a swResult has told the host's log why it failed. One thread at a time.

typedef struct swStage swStage;

/// The Vulkan functions of a stage's device: `vk->CmdSetScissor(...)`. Those of windows are NULL unless
/// swGpuDef::presentable was set.
typedef struct swStageVk
{
#define SW_STAGE_INSTANCE(name) PFN_vk##name name;
#define SW_STAGE_DEVICE(name) PFN_vk##name name;
#define SW_STAGE_SURFACE(name) PFN_vk##name name;
#define SW_STAGE_SWAPCHAIN(name) PFN_vk##name name;
#include "stage_functions.inl"
#undef SW_STAGE_INSTANCE
#undef SW_STAGE_DEVICE
#undef SW_STAGE_SURFACE
#undef SW_STAGE_SWAPCHAIN
} swStageVk;

/// A device by the def's choice, as swCreateGpu(), with command buffers for its frames in flight.
/// @return what swCreateGpu() returns
SW_API swResult swCreateStage(const swHost* host, const swGpuDef* def, swStage** stage);

/// Waits for the device and destroys it. What was made with it must be gone, but for frames. NULL is allowed.
SW_API void swDestroyStage(swStage* stage);

SW_API swGpu* swStage_GetGpu(const swStage* stage);
SW_API const swStageVk* swStage_GetVk(const swStage* stage);

/// What swListStageDevices() tells of a device.
typedef struct swStageDevice
{
    char name[256];
    const char* type; ///< "discrete", "integrated", "virtual", "software" or "other"
    uint32_t version; ///< of Vulkan, see VK_API_VERSION_MAJOR()
    bool isUsable;
    char missing[1024]; ///< what it lacks; empty if it is usable
} swStageDevice;

/// Every device in Vulkan's order, which is what swGpuDef::deviceIndex counts. `count` receives how many there are; at
/// most `capacity` are described.
/// @return SW_ERROR_NO_DEVICE if there is no loader or no driver
SW_API swResult swListStageDevices(const swHost* host, int capacity, swStageDevice* devices, int* count);

/// A device as users name it: "auto", "gpu", "software" or an index of at most 63. False for anything else.
SW_API bool swParseStageDevice(const char* text, swDeviceChoice* choice, int* index);

/// What an image was last used for, and what comes next.
typedef enum swStageUse
{
    SW_STAGE_USE_DISCARD,  ///< contents may be lost; waits for all work before
    SW_STAGE_USE_ACQUIRED, ///< a window's image just acquired, whose semaphore is waited for by copies
    SW_STAGE_USE_COLOR_TARGET,
    SW_STAGE_USE_DEPTH_TARGET,
    SW_STAGE_USE_SAMPLED,
    SW_STAGE_USE_COPY_FROM,
    SW_STAGE_USE_COPY_TO,
    SW_STAGE_USE_PRESENT,
    SW_STAGE_USE_COUNT
} swStageUse;

/// What an image is to be.
typedef struct swStageImageDef
{
    const char* name; ///< in messages
    VkFormat format;
    VkFormat otherFormat; ///< for a second view of the same bytes; VK_FORMAT_UNDEFINED: none
    VkImageUsageFlags usage;
    uint32_t width, height;
} swStageImageDef;

/// A 2-D image with one view or two.
typedef struct swStageImage
{
    VkImage image;
    VkDeviceMemory memory;
    VkImageView view;
    VkImageView otherView;
    VkImageAspectFlags aspect;
    uint32_t width, height;
    uint32_t texelBytes; ///< of `format`; 0 where the stage does not know it: then swStage_CopyToHost() checks no size
} swStageImage;

/// @return SW_ERROR_UNSUPPORTED (larger than the device can draw, or a format that it cannot use so),
/// SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swStage_CreateImage(swStage* stage, const swStageImageDef* def, swStageImage* image);

/// The device must be done with it. An image that was never made is allowed.
SW_API void swStage_DestroyImage(swStage* stage, swStageImage* image);

/// A barrier between two uses of an image.
SW_API void swStage_UseImage(swStage* stage, VkCommandBuffer commands, const swStageImage* image, swStageUse before,
                             swStageUse after);

/// A buffer that stays mapped, in memory that host and device both see.
typedef struct swStageBuffer
{
    VkBuffer buffer;
    VkDeviceMemory memory;
    void* data;
    VkDeviceSize size;
} swStageBuffer;

/// Memory that the host reads fast is chosen for VK_BUFFER_USAGE_TRANSFER_DST_BIT.
/// @return SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swStage_CreateBuffer(swStage* stage, VkDeviceSize size, VkBufferUsageFlags usage,
                                     swStageBuffer* buffer);

/// The device must be done with it. A buffer that was never made is allowed.
SW_API void swStage_DestroyBuffer(swStage* stage, swStageBuffer* buffer);

/// Copy an image, tightly packed, to a buffer that the host reads once the commands are done. The image is left in the
/// same use. A buffer with too little room is refused: nothing is recorded.
SW_API void swStage_CopyToHost(swStage* stage, VkCommandBuffer commands, const swStageImage* image, swStageUse use,
                               const swStageBuffer* buffer);

/// A frame that is being recorded.
typedef struct swStageFrame
{
    VkCommandBuffer commands;
    uint64_t index; ///< for swGpuWorld_Record() and swPicture_Prepare()
} swStageFrame;

/// Wait until the frame that had this one's place is done, and begin to record. One frame at a time.
/// @return SW_ERROR_DEVICE_LOST, SW_ERROR_DEVICE, SW_ERROR_NO_MEMORY
SW_API swResult swStage_BeginFrame(swStage* stage, swStageFrame* frame);

/// What a frame waits for and signals, for windows.
typedef struct swStageSync
{
    VkSemaphore wait;
    VkPipelineStageFlags2 waitStages;
    VkSemaphore signal;
} swStageSync;

/// End the frame's commands and submit them. `sync` may be NULL.
/// @return SW_ERROR_DEVICE_LOST, SW_ERROR_DEVICE, SW_ERROR_NO_MEMORY
SW_API swResult swStage_SubmitFrame(swStage* stage, const swStageFrame* frame, const swStageSync* sync);

/// Throw the frame's commands away. What was recorded of a world wants swGpuWorld_Discard() too.
SW_API void swStage_DropFrame(swStage* stage, const swStageFrame* frame);

/// Wait until all submitted frames are done: what they copied to the host can be read, and answers of queries arrive.
/// @return SW_ERROR_DEVICE_LOST, SW_ERROR_DEVICE
SW_API swResult swStage_Wait(swStage* stage);

/// Begin rendering to all of an image, cleared to 0 unless `keepsColor`. `view` is one of the image's two; `depth` may
/// be NULL. Sets viewport and scissor.
SW_API void swStage_BeginDrawing(swStage* stage, VkCommandBuffer commands, const swStageImage* color, VkImageView view,
                                 bool keepsColor, const swStageImage* depth);
SW_API void swStage_EndDrawing(swStage* stage, VkCommandBuffer commands);

/// What a picture is drawn to, in the default formats of a picture.
typedef struct swStageTargets
{
    swStageImage hdr, depth; ///< the sea and the sky
    swStageImage output;     ///< sRGB bytes: `view` reads and blends them as they are, `otherView` encodes
    /// What the water is drawn over, once there is land; see swStageTerrain_Prepare().
    swStageImage opaqueColor, opaqueDepth;
} swStageTargets;

/// Targets for a picture of width x height pixels. The sea may be drawn with fewer or more, and is stretched over the
/// picture by tone mapping: drawnWidth and drawnHeight; 0 for as many.
/// @return SW_ERROR_UNSUPPORTED (larger than the device can draw), SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swStage_CreateTargets(swStage* stage, uint32_t width, uint32_t height, uint32_t drawnWidth,
                                      uint32_t drawnHeight, swStageTargets* targets);
SW_API void swStage_DestroyTargets(swStage* stage, swStageTargets* targets);

/// Heights of land and sea floor at places, m above the same zero as the camera's; NaN where there is none. It is
/// called by swStageTerrain_Prepare(), for a line of places at a time.
typedef void swStageFloorFcn(void* context, int count, const swPosXZ* points, float* heights);

/// Land and sea floor, drawn plainly: sand, grass and rock by height and slope. Must be initialized with
/// swDefaultStageTerrainDef().
typedef struct swStageTerrainDef
{
    const swWorld* world;   ///< whose inputs say the floor; default NULL: `floor` does
    swStageFloorFcn* floor; ///< the floor where there is no world
    void* context;          ///< given to `floor`
    float finestSpacing;    ///< of its grid near the camera, m. Range [0.01, 1000]. Default 0.5
    float reach;            ///< how far land is seen, m. Range [10, 1e6]. Default 50e3
    int internalValue;
} swStageTerrainDef;
SW_API swStageTerrainDef swDefaultStageTerrainDef(void);

/// Squares of the floor that a camera sees are sampled once and kept; far ones have fewer places than near ones.
typedef struct swStageTerrain swStageTerrain;

/// @return SW_ERROR_INVALID, SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swStage_CreateTerrain(swStage* stage, const swStageTerrainDef* def, swStageTerrain** terrain);
/// The device must be done with it. NULL is allowed.
SW_API void swStage_DestroyTerrain(swStage* stage, swStageTerrain* terrain);

/// The floor has changed, or the world's origin: sample it again. Waits for the device.
SW_API void swStageTerrain_Refresh(swStageTerrain* terrain);

/// Before swPicture_Prepare() of the shot: samples what its camera sees, makes the targets' opaque images the first
/// time, and has the shot show them through the water. A camera that sees no floor at all leaves the shot without.
/// @return SW_ERROR_INVALID, SW_ERROR_UNSUPPORTED, SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swStageTerrain_Prepare(swStageTerrain* terrain, swStageTargets* targets, swShot* shot);

/// After swPicture_Prepare(): draw land if there is some, surface and sky, measure exposure and tone map. `terrain` is
/// the one that the shot was prepared with, or NULL. `dt` is the time since the last picture, s; `immediate` jumps to
/// the measured exposure. Leaves hdr in SW_STAGE_USE_SAMPLED and output in SW_STAGE_USE_COLOR_TARGET.
SW_API void swStage_DrawPicture(swStage* stage, VkCommandBuffer commands, swPicture* picture,
                                const swStageTargets* targets, const swStageTerrain* terrain, float dt, bool immediate);
