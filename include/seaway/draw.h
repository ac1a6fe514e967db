// SPDX-License-Identifier: MIT
#pragma once

#include "field.h"
#include "gpu.h"

/// @file
/// The picture: sky, surface, exposure and tone mapping, recorded into the host's command buffers. A host with its own
/// sky or post-processing leaves those calls out.

/// A camera. Matrices are camera-relative: the view matrix holds rotation only, positions are subtracted in double.
typedef struct swCamera
{
    swPos position;
    swMat4 view;       ///< world axes to camera axes (x right, y up, -z forward), no translation
    swMat4 projection; ///< reversed-Z with an infinite far plane, Vulkan clip space (y down)
    float nearPlane;   ///< m
    uint32_t width, height;
} swCamera;

/// A camera that looks along a heading (radians clockwise from north) and pitch (radians, up positive).
/// `verticalFov` in radians.
SW_API swCamera swMakeCamera(swPos position, float heading, float pitch, float roll, float verticalFov, uint32_t width,
                             uint32_t height);

/// Sun and air. Must be initialized with swDefaultSkyDef().
typedef struct swSkyDef
{
    float sunAzimuth;   ///< bearing of the sun, radians clockwise from north. Range [-1000, 1000]. Default 135 degrees
    float sunElevation; ///< radians. Range [-90 degrees, 90 degrees]. Default 40 degrees
    float sunIlluminance; ///< above the atmosphere, lux. Range [0, 1e6]. Default 128e3
    float haze;           ///< aerosol relative to clear air. Range [0, 20]. Default 1
    float clouds;         ///< high cloud cover. Range [0, 1]. Default 0.35
    int internalValue;
} swSkyDef;
SW_API swSkyDef swDefaultSkyDef(void);
SW_API const swFields* swGetSkyFields(void);

/// Look of the water. Must be initialized with swDefaultWaterDef().
typedef struct swWaterDef
{
    swVec3 absorption;     ///< per metre, linear sRGB primaries. Range [0, 100]. Default clear ocean
    swVec3 scattering;     ///< per metre. Range [0, 100]. Default clear ocean
    float refractiveIndex; ///< Range [1, 3]. Default 1.34
    swVec3 foamAlbedo;     ///< Range [0, 1]. Default 0.9 grey
    /// For the roughness of ripples that no band holds [Cox 1954], m/s. Range [0, 100]. Default 0: the mean of the
    /// world's wind, or 7 where it names none.
    float windSpeed;
    int internalValue;
} swWaterDef;
SW_API swWaterDef swDefaultWaterDef(void);
SW_API const swFields* swGetWaterFields(void);

typedef enum swDebugMode
{
    SW_DEBUG_NONE,
    SW_DEBUG_SLICES,
    SW_DEBUG_WIREFRAME,
    SW_DEBUG_NORMALS,
    SW_DEBUG_HEIGHT,
    SW_DEBUG_JACOBIAN,
    SW_DEBUG_FOAM,
    SW_DEBUG_ROUGHNESS,
    SW_DEBUG_COUNT
} swDebugMode;
SW_API const char* swDebugMode_GetName(swDebugMode mode);

/// What all pictures of a world share: pipelines, and the pattern of foam.
typedef struct swRenderer swRenderer;

/// @return SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swCreateRenderer(swGpuWorld* gpuWorld, swRenderer** renderer);

/// Destroys its pictures too. The device must be idle. NULL is allowed.
SW_API void swDestroyRenderer(swRenderer* renderer);

/// A camera's eye: what it has got used to, the sky as it is at its height, the part of the mesh that it sees. A
/// renderer has any number: halves of a split screen, a mirror, a map. Each is prepared and drawn on its own, in the
/// same frame or not, and pictures of one view share its layers. The commands of a frame's pictures run in the order in
/// which they were recorded.
typedef struct swPicture swPicture;

/// What a picture is drawn to. Must be initialized with swDefaultPictureDef().
typedef struct swPictureDef
{
    VkFormat colorFormat;  ///< HDR target, sampled and filtered. Default VK_FORMAT_R16G16B16A16_SFLOAT
    VkFormat depthFormat;  ///< Default VK_FORMAT_D32_SFLOAT
    VkFormat outputFormat; ///< target of swPicture_Tonemap(). Default VK_FORMAT_R8G8B8A8_SRGB
    int internalValue;
} swPictureDef;
SW_API swPictureDef swDefaultPictureDef(void);

/// The first picture of its formats makes their pipelines.
/// @return SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE, SW_ERROR_UNSUPPORTED (a format cannot be drawn to)
SW_API swResult swCreatePicture(swRenderer* renderer, const swPictureDef* def, swPicture** picture);

/// At any time: what frames in flight use of it goes when they are done. NULL is allowed.
SW_API void swDestroyPicture(swPicture* picture);

/// Kinds of water that a shot may have beside its own.
#define SW_MAX_BODY_WATERS 255

/// What a picture shows in one frame.
typedef struct swShot
{
    const swView* view; ///< its slices are drawn
    swCamera camera;
    swSkyDef sky;
    swWaterDef water;
    swDebugMode debug;
    double time;      ///< for clouds, s
    float exposureEv; ///< added to automatic exposure, stops. Range [-40, 40]. Default 0

    /// What stands in the water and behind it: copies of the colour and the depth that the host has drawn before the
    /// surface, as large as the target that it draws the surface to, both VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL.
    /// Colour is radiance as the picture has it, see swPicture_GetSources(), and is unfiltered; of a format with depth
    /// and stencil the view shows depth alone; 0 is nothing. With them the water is clear: the bottom is seen through
    /// it, absorbed and scattered over by the water's def, bent by its slopes, and the surface ends softly where the
    /// water does. Things under water are drawn in the light that they would have without it, and as wet as they are.
    /// Both or none; default none: nothing is seen through the water.
    VkImageView opaqueColor;
    VkImageView opaqueDepth;

    /// Water of bodies that have another look than the sea, see swWaterBodyDef::look: look n is bodyWaters[n - 1].
    /// Their roughness by the wind is the sea's. Range of the count [0, SW_MAX_BODY_WATERS]. Default none.
    const swWaterDef* bodyWaters;
    int bodyWaterCount;
} swShot;

/// After swGpuWorld_Record() and outside of rendering: sky tables, culling, indirect arguments.
/// @return SW_ERROR_INVALID (the shot's view was not recorded), SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swPicture_Prepare(swPicture* picture, VkCommandBuffer commands, const swShot* shot,
                                  uint64_t frameIndex);

/// What shaders of a host read to stand in the light and the air of a prepared picture, as the sea does.
typedef struct swPictureSources
{
    VkBuffer params; ///< swPictureParams of shared/picture.h: camera, sun, sea level
    VkDeviceSize paramsOffset, paramsSize;
    VkBuffer light;  ///< swSkyLight of shared/picture.h: light of sun and sky at sea level, pre-exposed lux
    VkImageView air; ///< for behindAir() of lib/atmosphere.glsl. VK_IMAGE_LAYOUT_GENERAL, sampled linearly, clamped
} swPictureSources;

/// The sources of a picture after swPicture_Prepare(), until it is prepared again. Fragment shaders of the
/// same command buffer read them without a barrier. Colours that a host draws are radiance times SW_PRE_EXPOSURE.
/// @return SW_ERROR_INVALID if the picture was not prepared
SW_API swResult swPicture_GetSources(const swPicture* picture, swPictureSources* sources);

/// Most rectangles that swPicture_GetTiles() gives.
#define SW_MAX_TILE_BOUNDS 256

/// A rectangle of the surface's mesh.
typedef struct swTileBounds
{
    int slice;         ///< that it is drawn from
    swPosXZ low, high; ///< corners, m
    double seaLevel;   ///< m
} swTileBounds;

/// The rectangles that the prepared picture's mesh is cut into, but for the strip to the horizon: for tools. Those that
/// the camera does not see are not drawn.
/// @return how many there are; at most `capacity` are written. 0 if the picture was not prepared
SW_API int swPicture_GetTiles(const swPicture* picture, int capacity, swTileBounds* tiles);

/// Inside the host's dynamic rendering with the def's formats, viewport and scissor set, depth cleared to 0 (reversed
/// Z) or with what the host has drawn in it: the water, and the sky behind everything with depth 0.
SW_API void swPicture_DrawSurface(swPicture* picture, VkCommandBuffer commands);
SW_API void swPicture_DrawSky(swPicture* picture, VkCommandBuffer commands);

/// Outside of rendering: measure exposure from `hdr` (sampled, SHADER_READ_ONLY_OPTIMAL) for this and later frames.
/// `immediate` jumps to the measured exposure instead of adapting.
SW_API void swPicture_Expose(swPicture* picture, VkCommandBuffer commands, VkImageView hdr, float dt, bool immediate);

/// Inside dynamic rendering with one colour target of outputFormat: exposure, tone curve, dither.
SW_API void swPicture_Tonemap(swPicture* picture, VkCommandBuffer commands, VkImageView hdr);
