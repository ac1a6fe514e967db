// SPDX-License-Identifier: MIT
#pragma once

// The images of a view's layers: made, written in turns, read back, and brought from the core.

#include "core/lod/layer_clock.h"
#include "gpu/vk/vk_device.h"

// How many frames back in which a layer stepped a view can be taken: as many as may be in flight.
#define SW_LAYER_MARKS SW_MAX_FRAMES_IN_FLIGHT

// Where a layer with a past stands after a recorded frame.
typedef struct swGpuLayerMark
{
    swLayerMark at;
    uint64_t frameIndex;
    int index; // of the image that holds it
} swGpuLayerMark;

typedef struct swGpuLayer
{
    // The second of layers with a past only, which are written in turns. Of a layer on demand that is not held: one
    // texel.
    swImage images[2];
    // Of layers that water carries, where steps of one frame are in turns; of authored fields, where slices that move
    // lie meanwhile.
    swImage between;
    uint64_t firstFrame;                    // that begins the images
    swGpuLayerMark mark;                    // of the last recorded frame
    swGpuLayerMark earlier[SW_LAYER_MARKS]; // of those before, newest first

    // Set by each swGpuWorld_Record(), valid for this frame.
    swLayerCatchUp due; // of layers with a past
    swUpload upload;    // of what the core made, or of a rest texel
} swGpuLayer;

// Layers of one view, as layers.inl lists them. Array layer = slice; texel centres are the lattice points, so point
// (column, row) of a slice is at uv = ((column + 0.5) / R, (row + 0.5) / R). The fourth component of the displacement
// holds J in full precision, by which foam grows.
// Where a view's slices were when it was recorded, and what is beyond them: kept for who asks after the world has
// stepped on.
typedef struct swViewPlace
{
    swPos viewpoint;
    double seaLevel;
    float fade; // see swViewFrame
    int scaleLevel;
    float foamAtRest;
    swSlice slices[SW_MAX_SLICES];
} swViewPlace;

typedef struct swGpuView
{
    uint32_t viewVersion; // of the view it belongs to
    bool isUsed;
    const swView* view; // identity only
    int sliceCount, resolution;
    bool hasBegun; // a recorded frame, firstFrame, begins the images
    uint64_t firstFrame;
    swGpuLayer layers[SW_LAYERS];

    // Set by each swGpuWorld_Record(), valid for this frame.
    const swViewFrame* frame;
    swViewPlace place;
    bool isCore; // the core made the layers, they are only copied
} swGpuView;

// The images of a frame's views: entries of views that are gone are retired, and new ones made. `views` are
// SW_MAX_VIEWS entries. All that may fail, also what the core has made; records nothing. Finds what each layer with a
// past has to make up for in this frame.
swResult swPrepareGpuViews(swGpu* gpu, const swFrame* frame, swGpuView* views);
// Record what new images need, and the copies of what the core has made. Says whether there were such copies.
bool swCopyGpuViews(swGpu* gpu, VkCommandBuffer commands, swGpuView* views);
// The passes were recorded: layers with a past have moved on.
void swCommitGpuViews(uint64_t frameIndex, swGpuView* views);
// Take back what frame `frameIndex` and all later frames did, which will not run.
void swDiscardGpuViews(swGpuView* views, uint64_t frameIndex);
// At once; the device is idle.
void swDestroyGpuViews(swGpu* gpu, swGpuView* views);
// Bytes of device memory.
size_t swGetGpuViewMemory(const swGpuView* views);

// Where the texels of each slice were in the image that swGetLayerImage() gives: SW_PAST_SOURCES entries a slice, each
// slice's first one `stride` behind that of the slice before.
void swFillPastSources(const swGpuView* view, int layer, int stride, swPastSource* sources);

// Steps of a layer in this frame: one of all that is due, or one after another where water carries the layer, since
// what is upstream of upstream is in neither image. The first reads the image before, the last writes the next one.
swCarriedSteps swFindLayerSteps(const swGpuView* view, int layer);
const swImage* swGetStepSource(const swGpuView* view, int layer, int step, int count);
const swImage* swGetStepTarget(const swGpuView* view, int layer, int step, int count);
// As swFillPastSources(), of the steps after the first: slices lie still.
void swFillStillSources(const swGpuView* view, int stride, swPastSource* sources);

// Layers that the core has made: all that may fail, then the copies.
swResult swPrepareCoreLayers(swGpu* gpu, const swViewFrame* frame, swGpuView* view);
// The texel of an authored field that nothing is said of.
swResult swPrepareRestTexel(swGpu* gpu, swGpuView* view, int layer);
void swCopyCoreLayers(swGpu* gpu, VkCommandBuffer commands, const swGpuView* view);

// Whether views have the layer: simulated fields live in zones.
bool swIsLayerInView(int layer);
// How readers sample a layer: linear if it is meant so and the device can filter its format.
swSamplerKind swChooseLayerSampler(const swGpu* gpu, int layer);

// Copy one slice of a layer to the host; waits.
swResult swReadLayer(swGpu* gpu, const swGpuView* view, int layer, int slice, float* texels);
// Copy one layer and mip of an image of four half floats to the host, as floats; waits.
swResult swReadHalves(swGpu* gpu, const swImage* image, uint32_t layer, uint32_t mip, float* texels);
// Copy a part of a buffer to the host; waits.
swResult swReadBuffer(swGpu* gpu, const swBuffer* buffer, VkDeviceSize offset, VkDeviceSize size, void* data);

// A layer as the last recorded frame left it; while recording, as it was before if it has a past.
static inline const swImage* swGetLayerImage(const swGpuView* view, int layer)
{
    return &view->layers[layer].images[view->layers[layer].mark.index];
}

// The image that a pass writes.
static inline const swImage* swGetNextLayerImage(const swGpuView* view, int layer)
{
    int turn = swGetLayerInfo(layer)->hasPast ? 1 : 0;
    return &view->layers[layer].images[view->layers[layer].mark.index ^ turn];
}
