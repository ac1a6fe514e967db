// SPDX-License-Identifier: MIT
// A host's own water, put together from installed libraries: its textures and buffers are arguments.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/foam_look.glsl"
#include "lib/surface_sample.glsl"
#include "lib/water_optics.glsl"
#include "lib/water_reflection.glsl"

layout(std430, set = 2, binding = 0) readonly buffer Slices
{
    swMeshSlice slices[];
};
layout(set = 2, binding = 1) uniform sampler2DArray derivatives;
layout(set = 2, binding = 2) uniform sampler2DArray detail;
layout(set = 2, binding = 3) uniform sampler2D skyMap;
layout(set = 2, binding = 4) uniform sampler2D foamTexture;
layout(location = 0) in vec2 place;
layout(location = 1) in vec3 position;
layout(location = 0) out vec4 color;

swMeshSlice meshSlice(uint index)
{
    return slices[index];
}

swDetailParams detailBand(uint index)
{
    return swDetailParams(0.0, 0.0, 1.0, 1.0, 2.0, 0.0, 0.0, 0u);
}

float shareOf(uint system)
{
    return 1.0;
}

swDetailWave detailWave(uint index)
{
    return swDetailWave(1.0, 0.0, 0.0, 0.1, 6.0, 0.0, 0.0, 0u);
}

void main()
{
    SurfaceGrid grid = SurfaceGrid(1, 1, 1, 384, 2.0, 0.01);
    Water water = Water(vec3(0.3, 0.07, 0.04), vec3(0.2), 1.34, 0.5);
    vec3 sun = vec3(0.0, 0.8, 0.6);
    vec3 view = normalize(-position);
    Footprint footprint = footprintAt(view, length(position), 0.001, max(view.y, 0.01));
    SlicePair pair = slicePairAt(grid, sliceLevelAt(grid, 0.0, footprint));
    Slopes slopes = slopesAt(grid, pair, place, place, footprint, derivatives, detail, false);
    vec3 leaving = leavingWater(water, enteringWater(water, sun, vec3(1.0), vec3(0.2)), 0.0);
    float reflectance;
    vec3 radiance = reflectedSky(skyMap, view, slopes, leaving, water.index, reflectance);
    radiance += (1.0 - reflectance) * leaving;
    FoamDetail foam = foamDetailAt(foamTexture, place, vec2(0.0), footprint, 0.2, 0.5, 0.0);
    vec3 white = foamRadiance(vec3(0.9), facetNormal(slopes.mean), sun, vec3(1.0), vec3(0.2));
    color = vec4(mix(radiance, white, foam.cover * foam.thickness), 1.0);
}
