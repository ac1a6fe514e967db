// SPDX-License-Identifier: MIT
#pragma once

// Commands that are submitted and waited for at once: reading layers back, first uploads of tools.

#include "seaway/gpu.h"

swResult swBeginSubmit(swGpu* gpu, VkCommandBuffer* commands);
// Submits to the device's queue and waits.
swResult swEndSubmit(swGpu* gpu);
void swDestroySubmit(swGpu* gpu);
