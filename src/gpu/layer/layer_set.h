// SPDX-License-Identifier: MIT
#pragma once

// The descriptor set "the layers of a view" for shaders of the host, see seaway/layers.h.

#include "gpu/layer/gpu_view.h"

swResult swFindLayersLayout(swGpu* gpu, VkDescriptorSetLayout* layout);
// After the frame was recorded. `reference` is in the sea's own coordinates.
swResult swMakeLayerSet(swGpu* gpu, const swGpuView* view, swPos reference, VkDescriptorSet* set);
