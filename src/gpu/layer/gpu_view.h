// SPDX-License-Identifier: MIT
#pragma once

// The images of a view's layers: made, written in turns, read back, and brought from the core. What a layer's images
// are, and whether it has a past, stands in one table in gpu_view.c.

#include "core/frame/frame.h"
#include "gpu/vk/vk_device.h"

// How many frames back a layer with a past can be taken: as many as may be in flight.
#define SW_LAYER_MARKS SW_MAX_FRAMES_IN_FLIGHT

// Where a layer with a past stands after a recorded frame.
typedef struct swLayerMark
{
    bool isHeld; // there is something
    uint64_t frameIndex;
    int index;     // of the image that holds it
    int64_t clock; // that the layer was brought to, see swViewFrame
    uint32_t resetCount;
    swSlice slices[SW_MAX_SLICES]; // where its texels lie
} swLayerMark;

// One layer. Array layer = slice; texel centres are the lattice points, so point (column, row) of a slice is at
// uv = ((column + 0.5) / R, (row + 0.5) / R). All images rest in VK_IMAGE_LAYOUT_GENERAL, because compute shaders write
// them each frame.
typedef struct swGpuLayer
{
    swImage images[2];                   // the second only with a past: they are written in turns
    uint64_t firstFrame;                 // the one that begins the images
    swLayerMark mark;                    // of the last recorded frame
    swLayerMark earlier[SW_LAYER_MARKS]; // of those before, newest first
    swUpload upload;                     // of this frame: what the core has made
} swGpuLayer;

typedef struct swGpuView
{
    uint32_t viewVersion; // of the view it belongs to
    bool isUsed;
    const swView* view; // identity only
    int sliceCount, resolution;
    swGpuLayer layers[SW_LAYER_COUNT];

    // Set by each swGpuWorld_Record(), valid for this frame.
    const swViewFrame* frame;
    bool isCore; // the core made the layers, they are only copied
} swGpuView;

// The images of a frame's views: entries of views that are gone are retired, and new ones made. `views` are
// SW_MAX_VIEWS entries. All that may fail, also what the core has made; records nothing.
swResult swPrepareGpuViews(swGpu* gpu, const swFrame* frame, swGpuView* views);
// Record what new images need, and the copies of what the core has made. Says whether there were such copies.
bool swCopyGpuViews(swGpu* gpu, VkCommandBuffer commands, swGpuView* views);
// Take back what frame `frameIndex` and all later frames did, which will not run.
void swDiscardGpuViews(swGpuView* views, uint64_t frameIndex);
// At once; the device is idle.
void swDestroyGpuViews(swGpu* gpu, swGpuView* views);
// Bytes of device memory.
size_t swGetGpuViewMemory(const swGpuView* views);

// What the last recorded frame left.
static inline const swImage* swGetLayerImage(const swGpuView* view, swLayer layer)
{
    return &view->layers[layer].images[view->layers[layer].mark.index];
}

// Of a layer with a past, the image that this frame writes.
static inline const swImage* swGetNextLayerImage(const swGpuView* view, swLayer layer)
{
    return &view->layers[layer].images[view->layers[layer].mark.index ^ 1];
}

// A pass has written the next image of a layer with a past, which stands at `now` (but for its index) after this frame.
void swTurnLayer(swGpuView* view, swLayer layer, const swLayerMark* now);

// Layers that the core has made: all that may fail, then the copies.
swResult swPrepareCoreLayers(swGpu* gpu, const swViewFrame* frame, swGpuView* view);
void swCopyCoreLayers(swGpu* gpu, VkCommandBuffer commands, const swGpuView* view);

// Copy one slice of a layer to the host; waits.
swResult swReadLayer(swGpu* gpu, const swGpuView* view, swLayer layer, int slice, float* texels);
// Copy one layer and mip of an image of four half floats to the host, as floats; waits.
swResult swReadHalves(swGpu* gpu, const swImage* image, uint32_t layer, uint32_t mip, float* texels);
// Copy a part of a buffer to the host; waits.
swResult swReadBuffer(swGpu* gpu, const swBuffer* buffer, VkDeviceSize offset, VkDeviceSize size, void* data);
