// SPDX-License-Identifier: MIT
// The water in a host's own shaders, from the descriptor set of seaway/layers.h. Before it is included,
//   #define SW_LAYERS_SET n
// says which set it is bound as; 0 otherwise.
//
// Two kinds of places: `rest` is where a particle of the surface is when the sea is calm, `place` where it has been
// carried to. Layers are read at rest; swRestOf() finds what is at a place. Both are metres from the reference that
// swGpuWorld_GetLayers() was given, x and z; heights count from the reference's height.
//
// The finest slice that holds a rest place is blended into the next towards its edge, as in the mesh that Seaway draws,
// so that nothing pops; beyond the coarsest slice the sea is level. Everything is interpolated by hand: filtering
// hardware rounds its weights, and not all of it filters 32-bit floats.
#ifndef SW_SEAWAY_LAYERS_GLSL
#define SW_SEAWAY_LAYERS_GLSL
#include "shared/mesh.h"
#include "shared/view_layers.h"

#ifndef SW_LAYERS_SET
#define SW_LAYERS_SET 0
#endif

// Numbers as in swLayersBinding.
layout(std430, set = SW_LAYERS_SET, binding = 0) readonly buffer swLayersBlock
{
    swLayersParams swLayers;
    swLayersSlice swLayerSlices[];
};
layout(set = SW_LAYERS_SET, binding = 1) uniform sampler2DArray swPlacesLayer; // depth, its slopes along x, z, level
layout(set = SW_LAYERS_SET, binding = 2) uniform sampler2DArray swFlowLayer;   // velocity along x and z, m/s
layout(set = SW_LAYERS_SET, binding = 3) uniform sampler2DArray swFlowSlopesLayer;   // of x along x, z; of z
layout(set = SW_LAYERS_SET, binding = 4) uniform sampler2DArray swDisplacementLayer; // x, y, z, m
layout(set = SW_LAYERS_SET, binding = 5) uniform sampler2DArray swDerivativesLayer;  // gx, gz, J
layout(set = SW_LAYERS_SET, binding = 6) uniform sampler2DArray swFoamLayer;         // [0, 1], of whitecaps
layout(set = SW_LAYERS_SET, binding = 7) uniform sampler2DArray swWakeFoamLayer;     // of inputs and wakes
layout(set = SW_LAYERS_SET, binding = 8) uniform sampler2DArray swShoreFoamLayer;    // of shores

// Two slices at a place, and how much of each is shown; the rest is level water.
struct swLayerPair
{
    int first, second;
    float firstWeight, secondWeight;
};

swLayerPair swFindLayers(vec2 rest)
{
    vec2 view = vec2(swLayers.viewX, swLayers.viewZ);
    int last = int(swLayers.sliceCount) - 1;
    int slice = 0;
    vec2 steps = vec2(0.0); // from the viewer, two texels each
    for (; slice <= last; ++slice)
    {
        steps = abs(rest - view) * (0.5 * swLayerSlices[slice].perMetre);
        if (max(steps.x, steps.y) < 2.0 * swLayers.quads - 2.0)
        {
            break;
        }
    }
    if (slice > last)
    {
        return swLayerPair(last, last, 0.0, 0.0);
    }
    float blend = swMeshBlend(steps.x, steps.y, 0.0, 0.0, swLayers.quads, slice == 0 ? swLayers.fade : 0.0);
    int next = min(slice + 1, last);
    float nextWeight = slice < last ? blend * swLayerSlices[next].weight : 0.0;
    return swLayerPair(slice, next, (1.0 - blend) * swLayerSlices[slice].weight, nextWeight);
}

// One layer of one slice, linear between its texels.
vec4 swReadSlice(sampler2DArray layer, int slice, vec2 rest)
{
    swLayersSlice lattice = swLayerSlices[slice];
    if (textureSize(layer, 0).x == 1) // an authored field that no input says anything of
    {
        return texelFetch(layer, ivec3(0, 0, slice), 0);
    }
    ivec2 last = ivec2(int(swLayers.resolution) - 1);
    vec2 texel = clamp((rest - vec2(lattice.firstX, lattice.firstZ)) * lattice.perMetre, vec2(0.0), vec2(last));
    ivec2 low = min(ivec2(texel), last - 1);
    vec2 along = texel - vec2(low);
    vec4 a = texelFetch(layer, ivec3(low, slice), 0);
    vec4 b = texelFetch(layer, ivec3(low.x + 1, low.y, slice), 0);
    vec4 c = texelFetch(layer, ivec3(low.x, low.y + 1, slice), 0);
    vec4 d = texelFetch(layer, ivec3(low + 1, slice), 0);
    return mix(mix(a, b, along.x), mix(c, d, along.x), along.y);
}

// One layer of the slices that are shown; what no slice covers counts as `beyond`.
vec4 swReadLayer(sampler2DArray layer, swLayerPair pair, vec2 rest, vec4 beyond)
{
    vec4 value = (1.0 - pair.firstWeight - pair.secondWeight) * beyond;
    value += pair.firstWeight > 0.0 ? pair.firstWeight * swReadSlice(layer, pair.first, rest) : vec4(0.0);
    value += pair.secondWeight > 0.0 ? pair.secondWeight * swReadSlice(layer, pair.second, rest) : vec4(0.0);
    return value;
}

// Of the particle that rests here, m.
vec3 swDisplacementAt(vec2 rest)
{
    return swReadLayer(swDisplacementLayer, swFindLayers(rest), rest, vec4(0.0)).xyz;
}

// xyz: unit normal; w: Jacobian, 1 on flat water and below 0 where it folds over.
vec4 swNormalAt(vec2 rest)
{
    vec3 g = swReadLayer(swDerivativesLayer, swFindLayers(rest), rest, vec4(0.0, 0.0, 1.0, 0.0)).xyz;
    return vec4(normalize(vec3(-g.x, g.z, -g.y)), g.z);
}

// Cover of foam, [0, 1].
float swFoamAt(vec2 rest)
{
    swLayerPair pair = swFindLayers(rest);
    float bare = 1.0 - swReadLayer(swFoamLayer, pair, rest, vec4(swLayers.foamAtRest)).x;
    bare *= 1.0 - swReadLayer(swWakeFoamLayer, pair, rest, vec4(0.0)).x;
    return 1.0 - bare * (1.0 - swReadLayer(swShoreFoamLayer, pair, rest, vec4(0.0)).x);
}

// Depth of still water where a particle rests, m; 1e30 where there is no floor.
float swDepthAt(vec2 rest)
{
    return swReadLayer(swPlacesLayer, swFindLayers(rest), rest, vec4(1e30, 0.0, 0.0, 0.0)).x;
}

// Velocity along x and z that inputs give the water where a particle rests, m/s, without the waves' own.
vec2 swFlowAt(vec2 rest)
{
    return swReadLayer(swFlowLayer, swFindLayers(rest), rest, vec4(0.0)).xy;
}

// Where the water rests that is at a place now. Six steps leave some millimetres on a rough sea; where waves fold, one
// of the particles that are there.
vec2 swRestOf(vec2 place)
{
    vec2 rest = place;
    for (int i = 0; i < 6; ++i)
    {
        rest = place - swDisplacementAt(rest).xz;
    }
    return rest;
}

// Of the water at a place, m from the reference's height.
float swWaterHeight(vec2 place)
{
    return swLayers.seaY + swDisplacementAt(swRestOf(place)).y;
}
#endif
