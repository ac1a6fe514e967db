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
#include "lib/water_floor.glsl"
#include "lib/water_optics.glsl"
#include "lib/water_reflection.glsl"
#include "shared/fields.h"
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
layout(binding = 13) uniform sampler2D opaqueColor;
layout(binding = 14) uniform sampler2D opaqueDepth;
layout(binding = 15) uniform sampler2DArray places; // depth of still water, its slopes, its level
layout(std430, binding = 16) readonly buffer InputHead
{
    swInputHead inputHead;
};
layout(std430, binding = 17) readonly buffer InputRecords
{
    swInputRecord inputRecords[];
};
layout(std430, binding = 18) readonly buffer InputNodes
{
    swInputNode inputNodes[];
};
layout(std430, binding = 19) readonly buffer InputWords
{
    float inputWords[];
};
layout(std430, binding = 22) readonly buffer Bodies
{
    swMeshBody bodies[];
};
layout(std430, binding = 23) readonly buffer Looks
{
    swPictureLook looks[];
};
layout(binding = 20) uniform sampler2DArray wakeFoamLayer;
layout(binding = 21) uniform sampler2DArray shoreFoamLayer;
layout(binding = 24) uniform sampler2DArray flow; // velocity along x and z
#include "lib/holes.glsl"
#include "lib/inputs.glsl"

// 1 on a device that is a CPU, where every texture sample counts.
layout(constant_id = 0) const uint isSoftware = 0;
// 1 on a device that does not filter 32-bit floats.
layout(constant_id = 1) const uint filtersByHand = 0;
// 1 where the host's images show what stands in the water.
layout(constant_id = 2) const uint isClear = 0;
// 1 where inputs say how deep the water is, or how high it stands.
layout(constant_id = 3) const uint hasPlaces = 0;
// 1 where inputs or shores make foam.
layout(constant_id = 5) const uint hasMadeFoam = 0;
// 1 where inputs colour the water or shade it.
layout(constant_id = 4) const uint hasColors = 0;
// 1 where inputs cut the water away.
layout(constant_id = 6) const uint hasHoles = 0;
// 1 where there are bodies of water.
layout(constant_id = 7) const uint hasBodies = 0;

layout(location = 0) in vec2 place;
layout(location = 1) in vec3 position;
layout(location = 2) in float blend;
layout(location = 3) in float height;
layout(location = 4) flat in uint ring;
layout(location = 5) flat in int body;

layout(location = 0) out vec4 color;

// 1 where inputs say how much of which waves there is.
layout(constant_id = 8) const uint hasWeights = 0;
// 1 where the water flows and takes foam along.
layout(constant_id = 9) const uint carriesFoam = 0;

// m of water along the line of sight over which its edge begins.
const float softEdge = 0.12;

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

// By system; those of `picture.systems` are set by findShares().
float shares[SW_LIMIT_SYSTEMS];

float shareOf(uint system)
{
    return hasWeights != 0 ? shares[min(system, uint(SW_LIMIT_SYSTEMS - 1))] : 1.0;
}

void findShares(vec2 rest)
{
    SeaPlace at = seaPlaceOf(ivec2(picture.anchorCellX, picture.anchorCellZ),
                             vec2(picture.anchorRestX, picture.anchorRestZ) + rest);
    for (uint left = picture.systems; left != 0u; left &= left - 1u)
    {
        uint system = uint(findLSB(left));
        shares[system] = max(fieldAt(SW_FIELD_OF_WAVES, system, at).value.x, 0.0);
    }
}

// What a pixel of clear water shows of the bottom.
struct Bottom
{
    Column column;
    vec3 radiance; // of what the line of sight ends at
    vec3 beside;   // of the image right behind the pixel
    float edge;    // 0 where the water has no depth
    bool isBacked; // the image shows something there
};

// `depth` is that of still water where a floor is known, and what counts where the bent line is hidden on the screen.
Bottom bottomAt(Water water, vec3 view, vec3 normal, float depth)
{
    Lens lens = Lens(picture.clip[0], picture.clip[1], picture.clip[2], picture.clip[3], picture.forward, picture.rayX,
                     picture.rayY);
    Sunken sunken = seenThrough(lens, opaqueColor, opaqueDepth, position, view, normal, water.index, depth);
    Bottom bottom = Bottom(Column(vec3(0.0), vec3(1.0)), vec3(0.0), vec3(0.0), 1.0, false);
    if (sunken.isThere)
    {
        bottom.column = columnOf(water, sunken.depth, sunken.way, max(picture.sun.y, 0.0));
        bottom.radiance = sunken.radiance;
    }
    vec2 uv = gl_FragCoord.xy / vec2(textureSize(opaqueDepth, 0));
    vec3 straight;
    if (opaqueAt(lens, opaqueDepth, uv, straight))
    {
        bottom.edge = smoothstep(0.0, softEdge, length(straight - position));
        bottom.isBacked = true;
        bottom.beside = textureLod(opaqueColor, uv, 0.0).rgb;
    }
    return bottom;
}

// What inputs put on the water at a pixel. The field has colours times their cover.
struct Paint
{
    vec4 albedo; // and how much of the pixel it covers
    float light; // of the sun that arrives
};

const uint paintFields[2] = {SW_FIELD_OF_ALBEDO, SW_FIELD_OF_SHADOW};

// At places along the longer axis of the pixel's footprint, so that a decal neither flickers nor is lost far away.
Paint paintAt(vec2 rest, Footprint footprint)
{
    ivec2 anchorCell = ivec2(picture.anchorCellX, picture.anchorCellZ);
    vec2 anchorRest = vec2(picture.anchorRestX, picture.anchorRestZ);
    vec2 here = position.xz - vec2(picture.anchorX, picture.anchorZ);
    float reach = 0.5 * footprint.longest;
    vec2 span = abs(footprint.axis) * reach + abs(here - rest);
    ivec2 low = seaPlaceOf(anchorCell, anchorRest + here - span).cell;
    ivec2 high = seaPlaceOf(anchorCell, anchorRest + here + span).cell;
    Paint paint = Paint(vec4(0.0), 1.0);
    for (uint f = 0; f < 2; ++f)
    {
        if (!touchesInputs(paintFields[f], low, high))
        {
            continue;
        }
        float looks = clamp(ceil(footprint.longest / max(2.0 * footprint.shortest, 0.05)), 1.0, 8.0);
        vec4 sum = vec4(0.0);
        for (float i = 0.0; i < looks; ++i)
        {
            vec2 aside = footprint.axis * (footprint.longest * ((i + 0.5) / looks - 0.5));
            vec4 value = fieldOnWater(paintFields[f], seaPlaceOf(anchorCell, anchorRest + here + aside),
                                      seaPlaceOf(anchorCell, anchorRest + rest + aside));
            sum += value; // a colour times its cover
        }
        sum /= looks;
        paint.albedo = f == 0 ? vec4(sum.rgb / max(sum.a, 1e-4), clamp(sum.a, 0.0, 1.0)) : paint.albedo;
        paint.light = f == 1 ? clamp(sum.x, 0.0, 1.0) : paint.light;
    }
    return paint;
}

// Where the pixel is in the sea.
SeaPlace pixelPlace()
{
    vec2 here = position.xz - vec2(picture.anchorX, picture.anchorZ);
    return seaPlaceOf(ivec2(picture.anchorCellX, picture.anchorCellZ),
                      vec2(picture.anchorRestX, picture.anchorRestZ) + here);
}

// How much of a pixel is water that has the distance at its middle. `reach` is what no pixel is larger than, m: farther
// from an edge nothing is soft, so that distances may jump there.
float waterInPixel(float distance, float reach)
{
    float near = clamp(distance, -reach, reach);
    float across = max(fwidth(near), 1e-6);
    return abs(distance) >= reach ? step(0.0, distance) : clamp(0.5 + near / across, 0.0, 1.0);
}

// How much of the pixel is water that is not cut away.
float waterLeft(SeaPlace here)
{
    float drop = swMeshDrop(length(position.xz), picture.flatDistance, picture.earthRadius);
    float reach = max(length(dFdx(position)), length(dFdy(position)));
    return waterInPixel(clipAt(here, position.y - picture.seaY + drop), reach);
}

// How far the water takes foam while a pattern lasts, m.
vec2 foamDrift(SurfaceGrid grid, SlicePair pair)
{
    if (carriesFoam == 0)
    {
        return vec2(0.0);
    }
    vec2 velocity = vec2(picture.foamCurrentX, picture.foamCurrentZ);
    // Of a sea without inputs of flow there is one texel, of none.
    if (textureSize(flow, 0).x > 1)
    {
        velocity += sampleSlices(flow, grid, pair, place, vec4(0.0), true).xy;
    }
    return velocity * picture.foamRenewal;
}

bool isOfBody(SeaPlace here)
{
    return bodyAt(here) == (body == SW_NO_MESH_BODY ? -1 : bodies[body].number);
}

void main()
{
    float left = 1.0;
    if (hasHoles != 0 || hasBodies != 0)
    {
        SeaPlace here = pixelPlace();
        left = hasHoles != 0 ? waterLeft(here) : 1.0;
        // A pixel that shows what is behind it is a mix; without that it is water or not.
        if (left < (isClear != 0 ? 0.004 : 0.5) || (hasBodies != 0 && !isOfBody(here)))
        {
            discard;
        }
    }
    SurfaceGrid grid = SurfaceGrid(picture.ringCount, picture.bandCount, picture.waveCount, picture.resolution,
                                   picture.finestWavelength, picture.rippleVariance);
    vec2 rest = place * picture.step;
    float range = length(position);
    vec3 view = -position / range;
    float facing = facingArea(view, vec2(0.0), vec2(picture.slopeVariance));
    Footprint footprint = footprintAt(view, range, picture.pixel, facing);
    SlicePair pair = slicePairAt(grid, sliceLevelAt(grid, float(ring) + blend, footprint));
    if (hasWeights != 0)
    {
        findShares(rest);
    }
    Slopes slopes = slopesAt(grid, pair, place, rest, footprint, derivatives, detail, isSoftware != 0);
    float depth = SW_NO_DEPTH;
    if (hasPlaces != 0)
    {
        vec2 here = (position.xz - vec2(picture.anchorX, picture.anchorZ)) / picture.step;
        Standing standing = standingAt(grid, float(ring) + blend, here, 0.5 * picture.step, places);
        depth = standing.depth;
        bool isFlat = hasBodies != 0 && body != SW_NO_MESH_BODY && bodies[body].setsLevel != 0;
        slopes.mean += hasBodies == 0 ? standing.slope : isFlat ? vec2(0.0) : levelBetweenBodies(pixelPlace()).yz;
    }
    float amount = foamAmountAt(grid, pair, place, foamLayer, picture.foamAtRest, filtersByHand != 0);
    if (hasMadeFoam != 0)
    {
        bool byHand = filtersByHand != 0;
        float wake = foamAmountAt(grid, pair, place, wakeFoamLayer, 0.0, byHand);
        float shore = foamAmountAt(grid, pair, place, shoreFoamLayer, 0.0, byHand);
        amount = 1.0 - (1.0 - amount) * (1.0 - wake) * (1.0 - shore);
    }
    if (picture.debugMode != 0)
    {
        float deviations = height / max(picture.deviation, 0.01);
        color = vec4(debugColor(picture.debugMode, slopes, amount, ring, blend, deviations), 1.0);
        return; // shown without exposure or curve
    }

    Water water = Water(picture.absorption, picture.scattering, picture.index, picture.deviation);
    vec3 foamAlbedo = picture.foamAlbedo;
    if (hasBodies != 0 && body != SW_NO_MESH_BODY)
    {
        swPictureLook look = looks[bodies[body].look];
        water = Water(look.absorption, look.scattering, look.index, picture.deviation);
        foamAlbedo = look.foamAlbedo;
    }
    vec3 sun = picture.sun;
    vec3 normal = facetNormal(slopes.mean);
    vec3 sunlight = light.sun.rgb;
    Paint paint = Paint(vec4(0.0), 1.0);
    if (hasColors != 0)
    {
        paint = paintAt(rest, footprint);
        sunlight *= paint.light;
    }
    vec3 leaving = leavingWater(water, enteringWater(water, sun, sunlight, light.sky.rgb), amount);
    Bottom bottom;
    if (isClear != 0)
    {
        bottom = bottomAt(water, view, normal, depth);
        leaving *= bottom.column.water;
    }
    float reflectance;
    vec3 radiance = reflectedSky(skyMap, view, slopes, leaving, water.index, reflectance);
    float area = facingArea(view, slopes.mean, slopes.variance);
    radiance += sunlight * sunGlitter(view, sun, slopes.mean, slopes.variance, area, water.index);
    radiance += (1.0 - reflectance) * (leaving + throughCrest(water, view, normal, height, sun, sunlight, 1.0));

    FoamDetail foam = foamDetailAt(foamTexture, rest + vec2(picture.foamX, picture.foamZ), foamDrift(grid, pair),
                                   footprint, amount, picture.foamPhase, picture.foamSeed);
    vec3 white = foamRadiance(foamAlbedo, normal, sun, sunlight, light.sky.rgb);
    radiance = mix(radiance, white, foam.cover * foam.thickness);
    if (hasColors != 0)
    {
        radiance = mix(radiance, foamRadiance(paint.albedo.rgb, normal, sun, sunlight, light.sky.rgb), paint.albedo.a);
    }
    radiance = behindAir(air, radiance, -view, sun, range * 1e-3, picture.cameraHeight * 1e-3);
    if (isClear != 0)
    {
        // The image has its own air in front of it.
        float seen = (1.0 - reflectance) * (1.0 - foam.cover * foam.thickness) * (1.0 - paint.albedo.a);
        radiance += seen * bottom.column.bottom * bottom.radiance;
        radiance = mix(bottom.beside, radiance, bottom.isBacked ? bottom.edge * left : 1.0);
        if (!bottom.isBacked && left < 0.5)
        {
            discard;
        }
    }
    color = vec4(min(radiance, vec3(60000.0)), 1.0);
}
