// SPDX-License-Identifier: MIT
#pragma once

// The sky's tables and the sky itself. Tables are computed again only when the sun, the air, the clouds or the camera's
// height have changed enough to be seen.

#include "gpu/draw/picture.h"

typedef struct swSkyState
{
    float haze;
    swVec3 sun, sunLight;
    float cameraHeight;
    float clouds, cloudX, cloudZ;
} swSkyState;

// Of all pictures: what makes the tables.
typedef struct swSkyPipelines
{
    swPipeline transmittance, multiple, view, air, light, map;
    swPipeline halve;
} swSkyPipelines;

// Of one picture: they depend on the height of its camera.
typedef struct swSky
{
    swImage transmittance; // to the top of the air
    swImage multiple;      // light scattered more than once
    swImage view;          // layer 0 from the camera, 1 from the sea; 2 and 3 what haze adds to them
    swImage air;           // between camera and sea: layer 0 added, 1 let through, 2 added by haze
    swImage map;           // what waves reflect, with blurred mips
    swBuffer light;        // swSkyLight
    bool isValid;
    swSkyState state; // that the tables were computed for
} swSky;

swResult swCreateSkyPipelines(swGpu* gpu, swSkyPipelines* pipelines);
void swDestroySkyPipelines(swGpu* gpu, swSkyPipelines* pipelines);
// That draws the sky itself, to a picture's formats.
swResult swCreateSkyPipeline(swGpu* gpu, const swPictureDef* formats, swPipeline* pipeline);

swResult swCreateSky(swGpu* gpu, swSky* sky);
// Once no frame in flight can use it any more.
void swRetireSky(swGpu* gpu, swSky* sky);

// Outside of rendering: bring the tables up to date.
void swRecordSkyTables(swGpu* gpu, VkCommandBuffer commands, const swSkyPipelines* pipelines, swSky* sky,
                       const swPictureFrame* picture);
// What was recorded did not run: make the tables again.
void swForgetSky(swSky* sky);
// Inside rendering.
void swDrawSky(swGpu* gpu, VkCommandBuffer commands, const swPipeline* pipeline, const swSky* sky,
               const swPictureFrame* picture);

// The chain of mips of an RGBA16F image, each from the one before.
void swRecordMips(swGpu* gpu, VkCommandBuffer commands, const swPipeline* halve, const swImage* image);
