// SPDX-License-Identifier: MIT
#include "gpu/layer/layer_set.h"

#include "seaway/layers.h"
#include "shared/view_layers.h"

static_assert((int)SW_LAYERS_BINDING_PLACES == 1 + (int)SW_LAYER_PLACES, "a binding for each layer");
static_assert((int)SW_LAYERS_BINDING_FLOW == 1 + (int)SW_LAYER_FLOW, "a binding for each layer");
static_assert((int)SW_LAYERS_BINDING_FLOW_SLOPES == 1 + (int)SW_LAYER_FLOW_SLOPES, "a binding for each layer");
static_assert((int)SW_LAYERS_BINDING_DISPLACEMENT == 1 + (int)SW_LAYER_DISPLACEMENT, "a binding for each layer");
static_assert((int)SW_LAYERS_BINDING_DERIVATIVES == 1 + (int)SW_LAYER_DERIVATIVES, "a binding for each layer");
static_assert((int)SW_LAYERS_BINDING_FOAM == 1 + (int)SW_LAYER_FOAM, "a binding for each layer");
static_assert((int)SW_LAYERS_BINDING_WAKE_FOAM == 1 + (int)SW_LAYER_WAKE_FOAM, "a binding for each layer");
static_assert((int)SW_LAYERS_BINDING_SHORE_FOAM == 1 + (int)SW_LAYER_SHORE_FOAM, "a binding for each layer");
static_assert(SW_LAYERS < SW_MAX_BINDINGS, "there is room for all layers");

// Parameters, then each layer that lives in views. Layers that do not have no number.
static uint32_t listTypes(VkDescriptorType types[SW_MAX_BINDINGS])
{
    uint32_t count = 0;
    types[count++] = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        if (swIsLayerInView(i))
        {
            types[count++] = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        }
    }
    return count;
}

swResult swFindLayersLayout(swGpu* gpu, VkDescriptorSetLayout* layout)
{
    if (gpu->layersLayout == VK_NULL_HANDLE)
    {
        VkDescriptorType types[SW_MAX_BINDINGS];
        VkDescriptorSetLayoutBinding bindings[SW_MAX_BINDINGS];
        uint32_t count = listTypes(types);
        for (uint32_t i = 0; i < count; ++i)
        {
            bindings[i] = (VkDescriptorSetLayoutBinding){
                .binding = i,
                .descriptorType = types[i],
                .descriptorCount = 1,
                .stageFlags = VK_SHADER_STAGE_ALL,
            };
        }
        const VkDescriptorSetLayoutCreateInfo info = {
            .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
            .bindingCount = count,
            .pBindings = bindings,
        };
        swResult result = swCheckVk(
            gpu, gpu->vk.CreateDescriptorSetLayout(gpu->device, &info, NULL, &gpu->layersLayout), "creating a layout");
        if (result != SW_SUCCESS)
        {
            return result;
        }
    }
    *layout = gpu->layersLayout;
    return SW_SUCCESS;
}

// The last slice has no coarser one behind it: see getLastWeight() in draw/mesh_rings.c, which says the same.
static float getWeight(const swGpuView* view, int slice)
{
    bool isFading = slice == view->sliceCount - 1 && view->place.scaleLevel > 0;
    float weight = isFading ? 4.0f * view->place.fade : 1.0f;
    return weight < 1.0f ? weight : 1.0f;
}

typedef struct Block
{
    swLayersParams params;
    swLayersSlice slices[SW_MAX_SLICES];
} Block;

// World coordinates end here: all is subtracted in double.
static Block fillBlock(const swGpuView* view, swPos reference)
{
    const swViewPlace* place = &view->place;
    Block block = {
        .params = {.viewX = (float)(place->viewpoint.x - reference.x),
                   .viewZ = (float)(place->viewpoint.z - reference.z),
                   .seaY = (float)(place->seaLevel - reference.y),
                   .fade = place->fade,
                   .quads = (float)(view->resolution / 8),
                   .foamAtRest = place->foamAtRest,
                   .sliceCount = (uint32_t)view->sliceCount,
                   .resolution = (uint32_t)view->resolution},
    };
    for (int i = 0; i < view->sliceCount; ++i)
    {
        const swSlice* slice = &place->slices[i];
        block.slices[i] = (swLayersSlice){
            .firstX = (float)((double)slice->firstX * slice->texel - reference.x),
            .firstZ = (float)((double)slice->firstZ * slice->texel - reference.z),
            .perMetre = (float)(1.0 / slice->texel),
            .weight = getWeight(view, i),
        };
    }
    return block;
}

swResult swMakeLayerSet(swGpu* gpu, const swGpuView* view, swPos reference, VkDescriptorSet* set)
{
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    Block block = fillBlock(view, reference);
    swUpload upload;
    swResult result = swFindLayersLayout(gpu, &layout);
    result = result == SW_SUCCESS ? swUploadData(gpu, &block, sizeof(block), &upload) : result;
    result = result == SW_SUCCESS ? swAllocateSet(gpu, layout, set) : result;
    if (result != SW_SUCCESS)
    {
        return result;
    }
    VkDescriptorType types[SW_MAX_BINDINGS];
    swBinding bindings[SW_MAX_BINDINGS];
    uint32_t count = 0;
    bindings[count++] = swBindUpload(&upload);
    for (int i = 0; i < SW_LAYERS; ++i)
    {
        if (swIsLayerInView(i))
        {
            bindings[count++] = swBindImage(gpu, swGetLayerImage(view, i), swChooseLayerSampler(gpu, i));
        }
    }
    swWriteSet(gpu, *set, listTypes(types), types, bindings);
    return SW_SUCCESS;
}
