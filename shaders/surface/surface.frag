// SPDX-License-Identifier: MIT
// The colour of the sea: sky and sun reflected by slopes that are seen and by those that are not, light that comes back
// out of the water, foam, and the air in front of it all.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/picture.h"
#include "shared/mesh.h"
#include "lib/atmosphere.glsl"
#include "lib/foam_look.glsl"
#include "lib/surface_sample.glsl"
#include "lib/water_brdf.glsl"
#include "lib/water_optics.glsl"
#include "lib/water_reflection.glsl"
#include "surface/surface_debug.glsl"

layout(std430, binding = 0) readonly buffer Picture
{
    swPictureParams picture;
};
layout(std430, binding = 1) readonly buffer Slices
{
    swMeshSlice slices[];
};
layout(std430, binding = 4) readonly buffer Bands
{
    swDetailParams bands[];
};
layout(std430, binding = 5) readonly buffer Light
{
    swSkyLight light;
};
layout(binding = 6) uniform sampler2DArray derivatives;
layout(binding = 7) uniform sampler2DArray foamLayer;
layout(binding = 8) uniform sampler2DArray detail;
layout(binding = 9) uniform sampler2D skyMap;
layout(binding = 10) uniform sampler2DArray air;
layout(binding = 11) uniform sampler2D foamTexture;
layout(std430, binding = 12) readonly buffer Waves
{
    swDetailWave waves[];
};

// 1 on a device that is a CPU, where every texture sample counts.
layout(constant_id = 0) const uint isSoftware = 0;
// 1 on a device that does not filter 32-bit floats.
layout(constant_id = 1) const uint filtersByHand = 0;

layout(location = 0) in vec2 place;
layout(location = 1) in vec3 position;
layout(location = 2) in float blend;
layout(location = 3) in float height;
layout(location = 4) flat in uint ring;

layout(location = 0) out vec4 color;

swMeshSlice meshSlice(uint index)
{
    return slices[index];
}

swDetailParams detailBand(uint index)
{
    return bands[index];
}

swDetailWave detailWave(uint index)
{
    return waves[index];
}

void main()
{
    SurfaceGrid grid = SurfaceGrid(picture.ringCount, picture.bandCount, picture.waveCount, picture.resolution,
                                   picture.finestWavelength, picture.rippleVariance);
    vec2 rest = place * picture.step;
    float range = length(position);
    vec3 view = -position / range;
    float facing = facingArea(view, vec2(0.0), vec2(picture.slopeVariance));
    Footprint footprint = footprintAt(view, range, picture.pixel, facing);
    SlicePair pair = slicePairAt(grid, sliceLevelAt(grid, float(ring) + blend, footprint));
    Slopes slopes = slopesAt(grid, pair, place, rest, footprint, derivatives, detail, isSoftware != 0);
    float amount = foamAmountAt(grid, pair, place, foamLayer, picture.foamAtRest, filtersByHand != 0);
    if (picture.debugMode != 0)
    {
        float deviations = height / max(picture.deviation, 0.01);
        color = vec4(debugColor(picture.debugMode, slopes, amount, ring, blend, deviations), 1.0);
        return; // shown without exposure or curve
    }

    Water water = Water(picture.absorption, picture.scattering, picture.index, picture.deviation);
    vec3 sun = picture.sun;
    vec3 normal = facetNormal(slopes.mean);
    vec3 leaving = leavingWater(water, enteringWater(water, sun, light.sun.rgb, light.sky.rgb), amount);
    float reflectance;
    vec3 radiance = reflectedSky(skyMap, view, slopes, leaving, water.index, reflectance);
    float area = facingArea(view, slopes.mean, slopes.variance);
    radiance += light.sun.rgb * sunGlitter(view, sun, slopes.mean, slopes.variance, area, water.index);
    radiance += (1.0 - reflectance) * (leaving + throughCrest(water, view, normal, height, sun, light.sun.rgb, 1.0));

    FoamDetail foam = foamDetailAt(foamTexture, rest + vec2(picture.foamX, picture.foamZ), footprint, amount,
                                   picture.foamPhase, picture.foamSeed);
    vec3 white = foamRadiance(picture.foamAlbedo, normal, sun, light.sun.rgb, light.sky.rgb);
    radiance = mix(radiance, white, foam.cover * foam.thickness);
    radiance = behindAir(air, radiance, -view, sun, range * 1e-3, picture.cameraHeight * 1e-3);
    color = vec4(min(radiance, vec3(60000.0)), 1.0);
}
