// SPDX-License-Identifier: MIT
#pragma once

#include "gpu.h"

/// @file
/// The water in a host's own shaders: terrain that is wet, boats that stir up foam, particles that fall into the sea. A
/// descriptor set holds the layers of a view after a recorded frame; the GLSL file seaway/layers.glsl declares it and
/// has functions that read it:
///
///     #define SW_LAYERS_SET 1
///     #include "seaway/layers.glsl"
///     ...
///     float depth = swWaterHeight(position.xz) - position.y;
///
/// Its folder is SEAWAY_SHADER_DIR, a variable of find_package(seaway) and add_subdirectory(seaway); `pkg-config
/// --variable=shaderdir seaway-gpu` says it, too. examples/08_own_shader.c shows all of it.
///
/// Layers hold what a view needs: waves from eight texels of a slice up, and no water beyond the coarsest slice but the
/// level sea. What must be exact, or is far from every view, is asked by swGpuQuery.

/// Bindings of the set, for hosts that read it without the file: all are visible to all stages. Images are arrays with
/// one layer for each slice, in VK_IMAGE_LAYOUT_GENERAL, as swLayer says; the fourth component of displacement is for
/// Seaway alone. A layer that is not linear can only be fetched.
typedef enum swLayersBinding
{
    SW_LAYERS_BINDING_PARAMS,       ///< storage buffer: swLayersParams, then swLayersSlice[], see shared/view_layers.h
    SW_LAYERS_BINDING_PLACES,       ///< sampler2DArray, nearest; one texel where nothing is authored
    SW_LAYERS_BINDING_FLOW,         ///< sampler2DArray, nearest; one texel where no input makes water flow
    SW_LAYERS_BINDING_FLOW_SLOPES,  ///< likewise
    SW_LAYERS_BINDING_DISPLACEMENT, ///< sampler2DArray, nearest
    SW_LAYERS_BINDING_DERIVATIVES,  ///< sampler2DArray, linear
    SW_LAYERS_BINDING_FOAM,         ///< sampler2DArray, linear where the device can filter 32-bit floats, else nearest
    SW_LAYERS_BINDING_WAKE_FOAM,    ///< likewise; one texel where no input makes foam
    SW_LAYERS_BINDING_SHORE_FOAM    ///< likewise; one texel where there is no floor
} swLayersBinding;

/// The layout of the set, for pipeline layouts. It belongs to the device and is the same for all views.
/// @return SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swGpu_GetLayersLayout(swGpu* gpu, VkDescriptorSetLayout* layout);

/// The set of a view, as the last swGpuWorld_Record() leaves it. Places in the shader are metres from `reference`, a
/// position of the host that is best near what is drawn: its camera, or the origin of its own floats. A float's spacing
/// is all that is lost: 0.1 mm at 1 km from it. Call it once for each frame, view and reference, after
/// swGpuWorld_Record() and before the commands that use it; it can be bound in commands of that frame's index alone. At
/// most 256 sets a frame.
/// @return SW_ERROR_INVALID (the view was not recorded), SW_ERROR_LIMIT, SW_ERROR_NO_MEMORY, SW_ERROR_DEVICE
SW_API swResult swGpuWorld_GetLayers(swGpuWorld* gpuWorld, const swView* view, swPos reference, VkDescriptorSet* set);
