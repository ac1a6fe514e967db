// SPDX-License-Identifier: MIT
// Where a view's slices lie, for shaders of the host: what seaway/layers.glsl reads. Places are metres from a reference
// that the host chose, so that floats hold them wherever in the world that is.
#ifndef SW_SHARED_VIEW_LAYERS_H
#define SW_SHARED_VIEW_LAYERS_H
#include "types.h"

SW_PARAMS(swLayersParams)
{
    float viewX, viewZ; // the viewer, m
    float seaY;         // still water, m
    float fade;         // of the finest slice into the next
    float quads;        // a quarter of a ring of the mesh, in steps of two texels
    float foamAtRest;   // beyond the slices
    sw_uint sliceCount;
    sw_uint resolution; // texels along a slice
};
SW_PARAMS_SIZE(swLayersParams, 32);

SW_PARAMS(swLayersSlice)
{
    float firstX, firstZ; // centre of the first texel, m
    float perMetre;       // texels a metre
    float weight;         // how much of the slice is shown
};
SW_PARAMS_SIZE(swLayersSlice, 16);
#endif
