// SPDX-License-Identifier: MIT
#include "seaway/layers.h"

#include <math.h>

#include "core/base/misuse.h"
#include "gpu/layer/layer_set.h"
#include "gpu/pass/gpu_world.h"

swResult swGpu_GetLayersLayout(swGpu* gpu, VkDescriptorSetLayout* layout)
{
    if (layout != NULL)
    {
        *layout = VK_NULL_HANDLE;
    }
    SW_REQUIRE(gpu != NULL && layout != NULL, SW_ERROR_INVALID, gpu != NULL ? &gpu->host : NULL,
               "swGpu_GetLayersLayout() needs a swGpu and a place for the layout");
    return swFindLayersLayout(gpu, layout);
}

swResult swGpuWorld_GetLayers(swGpuWorld* gpuWorld, const swView* view, swPos reference, VkDescriptorSet* set)
{
    if (set != NULL)
    {
        *set = VK_NULL_HANDLE;
    }
    const swHost* host = gpuWorld != NULL ? &gpuWorld->gpu->host : NULL;
    SW_REQUIRE(gpuWorld != NULL && view != NULL && set != NULL, SW_ERROR_INVALID, host,
               "swGpuWorld_GetLayers() needs a swGpuWorld, a view and a place for the set");
    SW_REQUIRE(isfinite(reference.x) && isfinite(reference.y) && isfinite(reference.z), SW_ERROR_INVALID, host,
               "the reference of swGpuWorld_GetLayers() is not a position");
    const swGpuView* gpuView = swFindGpuView(gpuWorld, view);
    if (gpuView == NULL)
    {
        return swFail(host, SW_ERROR_INVALID, "the view has no layers: record a frame with it first");
    }
    swPosXZ origin = swGetWorldOrigin(gpuWorld->world);
    reference.x += origin.x;
    reference.z += origin.z;
    return swMakeLayerSet(gpuWorld->gpu, gpuView, reference, set);
}
