// SPDX-License-Identifier: MIT
#pragma once

#include <vulkan/vulkan_core.h>

#include "field.h"
#include "query.h"
#include "view.h"
#include "world.h"

/// @file
/// The same waves on Vulkan 1.3, recorded into the host's command buffers. Seaway never submits, never waits and owns
/// no queue unless it is asked to create a device itself.

/// A device that Seaway may record for: pipelines, memory, upload ring. External synchronization: one thread at a time.
typedef struct swGpu swGpu;

typedef enum swDeviceChoice
{
    SW_DEVICE_AUTO,     ///< a GPU if there is one, else a software device
    SW_DEVICE_GPU,      ///< discrete or integrated only
    SW_DEVICE_SOFTWARE, ///< a CPU device such as Mesa's lavapipe only
    SW_DEVICE_INDEX     ///< swGpuDef::deviceIndex in Vulkan's order
} swDeviceChoice;

/// Who makes the layers that are drawn: displacement, derivatives and foam of a view's slices, and the tiles below
/// them.
typedef enum swLayerSource
{
    SW_LAYERS_AUTO, ///< the core on a software device, for views with swViewDef::enableCpuLayers; else the GPU
    SW_LAYERS_GPU,  ///< compute passes, on every device
    SW_LAYERS_CORE  ///< the core, for views with swViewDef::enableCpuLayers; else the GPU
} swLayerSource;

/// Must be initialized with swDefaultGpuDef().
typedef struct swGpuDef
{
    /// The host's device. Give all of instance, physicalDevice, device, queue and queueFamily, or leave all null to let
    /// Seaway create its own. The device needs what swGpu_CheckDevice() and swGpu_GetFeatures() say.
    PFN_vkGetInstanceProcAddr getInstanceProcAddr; ///< NULL: load the system's Vulkan loader
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    VkQueue queue;
    uint32_t queueFamily; ///< Range [0, UINT32_MAX]. Default 0

    /// When Seaway creates the device: which one. Default SW_DEVICE_AUTO.
    swDeviceChoice choice;
    int deviceIndex; ///< Range [0, INT32_MAX]. Default 0

    /// When Seaway creates the device: extra instance extensions (a window system's), device extensions are added when
    /// `presentable`. Read only during the call.
    const char* const* instanceExtensions;
    uint32_t instanceExtensionCount; ///< Range [0, UINT32_MAX]. Default 0
    bool presentable;                ///< enable VK_KHR_swapchain. Default false

    /// When Seaway creates the device: enable the Khronos validation layer and send its messages to the log.
    /// Default false.
    bool enableValidation;

    /// Frames that may be in flight: the host waits for frame n - framesInFlight before it records frame n.
    /// Range [1, 4]. Default 2.
    int framesInFlight;

    /// Where layers come from. The core's are as good as the GPU's, and on a device that is a CPU they take a tenth of
    /// the time. See swGpu_FitView(). Default SW_LAYERS_AUTO.
    swLayerSource layers;

    /// Pipeline cache of an earlier run, see swGpu_GetPipelineCache(). May be NULL; bad data are ignored.
    const void* pipelineCache;
    size_t pipelineCacheSize; ///< bytes. Range [0, SIZE_MAX]. Default 0

    /// Set by swDefaultGpuDef().
    int internalValue;
} swGpuDef;

SW_API swGpuDef swDefaultGpuDef(void);
SW_API const swFields* swGetGpuFields(void);

/// @return SW_ERROR_NO_DEVICE (the log names each device and what it lacks), SW_ERROR_UNSUPPORTED (the host's device
/// lacks something), SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swCreateGpu(const swHost* host, const swGpuDef* def, swGpu** gpu);

/// The device must be idle. NULL is allowed.
SW_API void swDestroyGpu(swGpu* gpu);

/// Whether a physical device can be used; otherwise `missing` (of `size` bytes) names every missing feature.
SW_API bool swGpu_CheckDevice(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance,
                              VkPhysicalDevice device, char* missing, size_t size);

/// For a host that creates its own device: extensions and the chain of features to enable. The chain points into
/// `storage`, which the caller keeps until vkCreateDevice returns.
typedef struct swGpuFeatures
{
    VkPhysicalDeviceFeatures2 features;
    VkPhysicalDeviceVulkan11Features features11;
    VkPhysicalDeviceVulkan12Features features12;
    VkPhysicalDeviceVulkan13Features features13;
} swGpuFeatures;
SW_API const VkPhysicalDeviceFeatures2* swGpu_GetFeatures(swGpuFeatures* storage);
SW_API const char* const* swGpu_GetDeviceExtensions(uint32_t* count);

/// What is in use, also when Seaway created it.
SW_API PFN_vkGetInstanceProcAddr swGpu_GetInstanceProcAddr(const swGpu* gpu);
SW_API VkInstance swGpu_GetInstance(const swGpu* gpu);
SW_API VkPhysicalDevice swGpu_GetPhysicalDevice(const swGpu* gpu);
SW_API VkDevice swGpu_GetDevice(const swGpu* gpu);
SW_API VkQueue swGpu_GetQueue(const swGpu* gpu);
SW_API uint32_t swGpu_GetQueueFamily(const swGpu* gpu);
SW_API const char* swGpu_GetDeviceName(const swGpu* gpu);
SW_API bool swGpu_IsSoftware(const swGpu* gpu);

/// Whether views for this device are best made with swViewDef::enableCpuLayers (and their world with
/// swWorldDef::enableQueries): layers then come from the core, and the GPU only gets a copy of them.
SW_API bool swGpu_WantsCpuLayers(const swGpu* gpu);

/// A view that suits the device and pictures of `height` pixels. On a GPU it is `def` as it is. On a software device it
/// has CPU layers, and for pictures of less than 540 and of less than 270 lines half and a third of the default's
/// texels, each twice and four times as wide: what a pixel covers grows likewise. A def that names another resolution
/// or finest texel than the default keeps its own.
SW_API swViewDef swGpu_FitView(const swGpu* gpu, const swViewDef* def, uint32_t height);

/// Number of validation errors and warnings seen since creation (0 without enableValidation).
SW_API int swGpu_GetValidationCount(const swGpu* gpu);

/// Pipeline cache data to store; call with NULL for the size.
SW_API swResult swGpu_GetPipelineCache(const swGpu* gpu, void* data, size_t* size);

/// Say that the device is done with a frame and all before it: the host has seen its fence or its semaphore. Not
/// needed, since recording frame n says it of frame n - framesInFlight, but it lets answers of queries arrive sooner.
SW_API void swGpu_SetFinishedFrame(swGpu* gpu, uint64_t frameIndex);

/// The GPU twin of a world: its spectra, tiles and the layers of its views.
typedef struct swGpuWorld swGpuWorld;

/// The world must outlive it. Memory grows when the world gets wave systems or views, at the next swGpuWorld_Record().
/// @return SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swCreateGpuWorld(swGpu* gpu, const swWorld* world, swGpuWorld** gpuWorld);

/// The device must be idle. NULL is allowed.
SW_API void swDestroyGpuWorld(swGpuWorld* gpuWorld);

/// Record all passes of the world's last step and all its views: spectra to tiles to slices to foam. Compute only,
/// outside of a render pass. `frameIndex` grows by one per recorded frame.
/// All or nothing: after an error nothing has been recorded, nothing can be drawn, and the next call, with the same
/// frameIndex or a larger one, makes up for all that this one did not do.
/// @return SW_ERROR_NO_MEMORY or SW_ERROR_DEVICE when something new could not be allocated
SW_API swResult swGpuWorld_Record(swGpuWorld* gpuWorld, VkCommandBuffer commands, uint64_t frameIndex);

/// Say that the commands of frame `frameIndex`, and of all frames recorded after it, will never run: the host has
/// thrown them away, or could not submit them. Without this call Seaway takes it that recorded commands run, and draws
/// what they would have left. The next swGpuWorld_Record() then brings everything again that was lost, and foam goes on
/// from the last frame that does run; frame indices may be used again. At most the framesInFlight newest frames can be
/// taken back without foam beginning anew. Renderers of the world follow by themselves.
SW_API void swGpuWorld_Discard(swGpuWorld* gpuWorld, uint64_t frameIndex);

/// Bytes of device memory in use, queries included.
SW_API size_t swGpuWorld_GetMemory(const swGpuWorld* gpuWorld);

/// Read a slice's layer of the last recorded frame to the host. For tests and tools: submits to the device's queue and
/// waits, so the recorded work must have been submitted. `texels` has room for resolution^2 * channels floats.
SW_API swResult swGpuWorld_ReadLayer(swGpuWorld* gpuWorld, const swView* view, swLayer layer, int slice, float* texels);

/// Points that the GPU looks up in every frame: the twin of the core's queries for many points that may wait a frame or
/// two, or whose answers other shaders want. A few points at once are better asked of the core, which answers now. Use
/// it on the thread that uses its swGpu.
typedef struct swGpuQuery swGpuQuery;

/// What a query is about.
typedef enum swGpuQueryKind
{
    /// The surface above points, as swMoment_QuerySurface().
    SW_GPU_QUERY_KIND_SURFACE,

    /// The water at places, as swMoment_QueryVolume(): depth and pressure head always, orbital velocity and local
    /// acceleration as outputs. Waves are summed one by one, which takes some fifteen times as long as the surface
    /// does; waves too short to reach any place of a group of 64 cost nothing, so places in order of depth are the
    /// cheapest.
    SW_GPU_QUERY_KIND_VOLUME,

    /// What rays and spheres meet, as swMoment_CastRays() of a surface that stands still.
    SW_GPU_QUERY_KIND_RAYS
} swGpuQueryKind;

/// What is answered beside height and residual; the bits can be added.
typedef enum swGpuQueryOutput
{
    SW_GPU_QUERY_SIDEWAYS = 1, ///< horizontal displacement of the particle that is there, and swGpuStill. Of a surface
    SW_GPU_QUERY_NORMAL = 2,   ///< normal and Jacobian. Of a surface, or where a ray meets it

    /// Velocity and acceleration: of the particle that is there, or of the water below. At the surface each makes the
    /// frame's transforms of waves once more, and tiles of its own, in frames in which a query with points asks for it;
    /// their memory stays with the swGpuWorld.
    SW_GPU_QUERY_VELOCITY = 4,
    SW_GPU_QUERY_ACCELERATION = 8
} swGpuQueryOutput;

/// Must be initialized with swDefaultGpuQueryDef().
typedef struct swGpuQueryDef
{
    /// Default SW_GPU_QUERY_KIND_SURFACE.
    swGpuQueryKind kind;

    /// Most points. Range [1, 4194304]. Default 1024.
    int capacity;

    /// Bits of swGpuQueryOutput. Each costs memory and time of the bus. Range [0, 15]. Default 0.
    uint32_t outputs;

    float minWavelength; ///< as in swQueryDef, m. Range [0, inf]. Default 0
    float tolerance;     ///< as in swQueryDef, m. Range [1e-5, 1e9]. Default 0.0005
    int maxIterations;   ///< as in swQueryDef. Range [1, 64]. Default 24

    /// Of the water below, as in swQueryDef. Default SW_STRETCHING_WHEELER.
    swStretching stretching;

    /// Copy the answers to memory that the host can read. Default true; without it only shaders see them.
    bool readBack;

    /// Set by swDefaultGpuQueryDef().
    int internalValue;
} swGpuQueryDef;

SW_API swGpuQueryDef swDefaultGpuQueryDef(void);
SW_API const swFields* swGetGpuQueryFields(void);

/// A world may have any number of queries, made and destroyed at any time.
/// @return SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE, SW_ERROR_INVALID, SW_ERROR_LIMIT (more points than the device binds at
/// once: some have room for 3,355,443 rays only)
SW_API swResult swCreateGpuQuery(swGpuWorld* gpuWorld, const swGpuQueryDef* def, swGpuQuery** query);

/// Frames in flight may still use it. What is left of them is destroyed with the swGpuWorld. NULL is allowed.
SW_API void swDestroyGpuQuery(swGpuQuery* query);

/// The points that are asked from the next swGpuWorld_Record() on, until others are set. They are copied, each to 0.01
/// mm. How far the first is from the origin does not matter; the others are best within 1,000 km of it. No points: the
/// query rests. A point that cannot be answered spoils no other, as query.h says; here one that is farther than 1e11 m
/// from the first good one is bad, too. Its answers are NaN, also in the buffers that shaders see.
SW_API void swGpuQuery_SetPoints(swGpuQuery* query, int count, const swPosXZ* points);

/// The same for a query of the water below: places with a height, above or below the surface.
SW_API void swGpuQuery_SetPlaces(swGpuQuery* query, int count, const swPos* places);

/// The same for a query of rays. Their duration must be 0: the surface is that of the frame. A ray looks at the surface
/// at most 4096 times; one that needs more (for a very long way just above the water) ends without a hit at the
/// distance that it has come to. A larger minWavelength lengthens its steps.
SW_API void swGpuQuery_SetRays(swGpuQuery* query, int count, const swRay* rays);

/// Points that are on the GPU already: `count` pairs of floats (x, z), m from `origin`, at byte `offset` (a multiple of
/// 8) of a storage buffer of the host's. Of the water below they are triples (x, y, z), y as in swPos, and of rays
/// eights (x, y, z, maxDistance, direction x, y, z, radius), at a multiple of 4. The host makes what it writes there
/// visible to compute shaders' storage reads before swGpuWorld_Record()'s commands, and keeps the buffer until the
/// query has other points and frames that used it are done. A float's own spacing is all that is lost: 0.1 mm at 1 km
/// from `origin`.
SW_API void swGpuQuery_SetPointBuffer(swGpuQuery* query, int count, VkBuffer buffer, VkDeviceSize offset,
                                      swPosXZ origin);

/// Of one point.
typedef struct swGpuHeight
{
    float height;   ///< of the water, above sea level, m
    float residual; ///< as in swSurfaceSamples, m; converged if within the tolerance
} swGpuHeight;

/// Of one point: what inputs say there.
typedef struct swGpuStill
{
    float level; ///< of still water, above sea level, m; 0 where no input says another
    float hole;  ///< signed distance of the particle to the edge of holes, m: below 0 the water is cut away there
} swGpuStill;

/// Of one place in the water.
typedef struct swGpuDepth
{
    float depth;        ///< below the surface, m; negative in the air
    float pressureHead; ///< dynamic pressure, m of water; 0 in the air
} swGpuDepth;

/// Of one ray.
typedef struct swGpuHit
{
    float distance; ///< along the ray to the sphere's centre, m; maxDistance without a hit, NaN of a bad ray
    float side;     ///< 1: it came from above, -1: from below, 0: no hit
} swGpuHit;

/// The newest answers that have arrived. Pointers are valid until the next swGpuWorld_Record().
typedef struct swGpuQueryResults
{
    uint64_t frameIndex;    ///< the frame that they were recorded in
    double time;            ///< of the world then, s
    double seaLevel;        ///< of the world then, m
    uint32_t pointsVersion; ///< how often points had been set then: which points these are
    int count;
    float tolerance; ///< of the query, m
    const swGpuHeight* heights;
    const swVec2* sideways;   ///< x and z of displacement, m; y is the height less the level. NULL unless asked for
    const swGpuStill* stills; ///< with `sideways`, and of the water below, which does not ask for holes
    const swVec4* normals;    ///< unit normal, and the Jacobian in w. NULL unless asked for

    /// Of the water below and of rays; NULL unless the query is about them. Heights are then those of the surface
    /// there.
    const swGpuDepth* depths;
    const swGpuHit* hits;

    /// m/s and m/s^2; w is 0. NULL unless asked for.
    const swVec4* velocities;
    const swVec4* accelerations;
} swGpuQueryResults;

/// Never waits: answers arrive framesInFlight frames after they were recorded, or once swGpu_SetFinishedFrame() says
/// so. Bound: a height is that of swMoment_QuerySurface() at the stamp's time to 0.1 mm for points within 100 km of the
/// first, to 1 mm within 1,000 km, and besides to the slope of the water times both residuals. Velocity and
/// acceleration are those of a world that has enableVelocity and enableAcceleration to 1 mm/s and 1 cm/s^2 likewise;
/// below the surface they are those of swMoment_QueryVolume() to 0.3 mm/s and 3 mm/s^2, pressure to 0.1 mm of water. A
/// hit is on the core's surface to the tolerance, the slope of the water times both residuals, and 1e-7 of the way. In
/// a fold, where the water is above a point more than once, it may be another of the particles there.
/// @return false while none have arrived
SW_API bool swGpuQuery_GetResults(const swGpuQuery* query, swGpuQueryResults* results);

/// Write results where swMoment_QuerySurface() would: heights include sea level. Arrays of `samples` for which the
/// query has no output must be NULL; displacement and isClipped want SW_GPU_QUERY_SIDEWAYS. `stats` may be NULL; its
/// iterationCount is 0.
SW_API void swGpuQueryResults_Unpack(const swGpuQueryResults* results, const swSurfaceSamples* samples,
                                     swQueryStats* stats);

/// The same for a query of the water below: results where swMoment_QueryVolume() would write them.
SW_API void swGpuQueryResults_UnpackVolume(const swGpuQueryResults* results, const swVolumeSamples* samples,
                                           swQueryStats* stats);

/// The same for a query of rays with SW_GPU_QUERY_NORMAL: results as swMoment_CastRays() would write them. `rays` are
/// those that had been set then.
SW_API void swGpuQueryResults_UnpackHits(const swGpuQueryResults* results, const swRay* rays, swRayHit* hits,
                                         swQueryStats* stats);

/// Where shaders find the answers of the last recorded frame, as std430 arrays at byte offsets that suit any
/// descriptor: vec2 heights[] (height, residual), vec2 depths[] (depth, pressure head), vec2 hits[] (distance, side),
/// vec2 sideways[], vec2 stills[] (level, distance to the edge of holes), vec4 normals[] (w: Jacobian), vec4
/// velocities[] and vec4 accelerations[] (w: 0). An offset without an output is 0. swGpuWorld_Record() leaves them
/// visible to vertex, fragment and compute shaders of the same queue.
typedef struct swGpuQueryBuffer
{
    VkBuffer buffer;
    VkDeviceSize heights, depths, hits, sideways, stills, normals, velocities, accelerations;
} swGpuQueryBuffer;
SW_API swGpuQueryBuffer swGpuQuery_GetBuffer(const swGpuQuery* query);

/// Time of each pass in the latest frame whose timestamps arrived, ms; names are those of passes.inl and of the
/// renderer's stages.
typedef struct swPassTime
{
    const char* name;
    float milliseconds;
} swPassTime;

/// @return number of passes written, at most `capacity`
SW_API int swGpu_GetPassTimes(const swGpu* gpu, swPassTime* times, int capacity);
