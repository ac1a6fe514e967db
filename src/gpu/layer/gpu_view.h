// SPDX-License-Identifier: MIT
#pragma once

// The images of a view's layers: made, written in turns, read back, and brought from the core.

#include "core/frame/frame.h"
#include "gpu/vk/vk_device.h"

// How many foam-making frames back a view can be taken: as many as may be in flight.
#define SW_FOAM_MARKS SW_MAX_FRAMES_IN_FLIGHT

// Where a view's foam stands after a recorded frame.
typedef struct swFoamMark
{
    bool hasFoam;
    uint64_t frameIndex;
    int index;     // of the image that holds it
    int64_t clock; // of the frame that foam was brought to, see swViewFrame
    uint32_t resetCount;
    swSlice slices[SW_MAX_SLICES]; // where the foam lies
} swFoamMark;

// Layers of one view. Array layer = slice; texel centres are the lattice points, so point (column, row) of a slice is
// at uv = ((column + 0.5) / R, (row + 0.5) / R).
typedef struct swGpuView
{
    uint32_t viewVersion; // of the view it belongs to
    bool isUsed;
    const swView* view; // identity only
    int sliceCount, resolution;
    swImage displacement;              // RGBA32F: x, y, z, J; foam grows by J in full precision
    swImage derivatives;               // RGBA16F: gx, gz, J, 0
    swImage foam[2];                   // R32F, written in turns
    uint64_t firstFrame;               // the one that begins the images
    swFoamMark mark;                   // of the last recorded frame
    swFoamMark earlier[SW_FOAM_MARKS]; // of those before, newest first

    // Set by each swGpuWorld_Record(), valid for this frame.
    swUpload sliceLists;  // swSliceList[sliceCount]
    swUpload sliceTiles;  // swSliceTile[]
    swUpload sliceWaves;  // swSliceWave[]
    swUpload foamParams;  // swFoamSliceParams[sliceCount]
    swUpload foamSources; // swFoamSource[sliceCount * SW_FOAM_SOURCES]
    bool foamMoves;       // the foam pass has something to do
    const swViewFrame* frame;
    bool isCore; // the core made the layers, they are only copied
    swUpload layerUploads[SW_LAYER_COUNT];
} swGpuView;

// Make the images of a view that is new; an entry that is in use keeps its own.
swResult swMakeGpuView(swGpu* gpu, const swViewFrame* frame, swGpuView* view);
// Once no frame in flight can use them any more. Clears the entry.
void swRetireGpuView(swGpu* gpu, swGpuView* view);
// At once; the device is idle.
void swDestroyGpuView(swGpu* gpu, swGpuView* view);
// Record what new images need, once.
void swBeginGpuView(swGpu* gpu, VkCommandBuffer commands, swGpuView* view);
// The foam pass was recorded.
void swCommitGpuFoam(uint64_t frameIndex, const swViewFrame* frame, swGpuView* view);
// Take back what frame `frameIndex` and all later frames did, which will not run.
void swDiscardGpuView(swGpuView* view, uint64_t frameIndex);
// Bytes of device memory.
size_t swGetGpuViewMemory(const swGpuView* view);

// Layers that the core has made: all that may fail, then the copies.
swResult swPrepareCoreLayers(swGpu* gpu, const swViewFrame* frame, swGpuView* view);
void swRecordCoreLayers(swGpu* gpu, VkCommandBuffer commands, const swGpuView* view);

// Copy one slice of a layer to the host; waits.
swResult swReadLayer(swGpu* gpu, const swGpuView* view, swLayer layer, int slice, float* texels);
// Copy one layer and mip of an image of four half floats to the host, as floats; waits.
swResult swReadHalves(swGpu* gpu, const swImage* image, uint32_t layer, uint32_t mip, float* texels);
// Copy a part of a buffer to the host; waits.
swResult swReadBuffer(swGpu* gpu, const swBuffer* buffer, VkDeviceSize offset, VkDeviceSize size, void* data);

// Foam of the last recorded frame.
static inline const swImage* swGetFoamImage(const swGpuView* view)
{
    return &view->foam[view->mark.index];
}
