// SPDX-License-Identifier: MIT
// The colour of the sea: sky and sun reflected by slopes that are seen and by those that are not, light that comes back
// out of the water, foam, and the air in front of it all.
//
// The sky's part is an average over the facets that a viewer sees: slopes along the line of sight, weighted by how
// large each facet appears, which is what lifts the mean reflection above the horizon on a rough sea [Bruneton 2010].
// Across the line of sight the sky's blurred copies do.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/picture.h"
#include "shared/mesh.h"
#include "shared/fresnel.h"
#include "lib/atmosphere.glsl"
#include "lib/water_brdf.glsl"
#include "lib/surface_slopes.glsl"
#include "lib/foam_detail.glsl"

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

layout(location = 0) in vec2 place;
layout(location = 1) in vec3 position;
layout(location = 2) in float blend;
layout(location = 3) in float height;
layout(location = 4) flat in uint ring;

layout(location = 0) out vec4 color;

// The two slices to read, and how much each counts.
struct SlicePair
{
    uint first, second;
    float firstWeight, secondWeight;
};

SlicePair pairAt(float level)
{
    float last = float(picture.ringCount - 1);
    float whole = floor(min(level, last));
    float next = clamp(level - whole, 0.0, 1.0);
    SlicePair pair;
    pair.first = uint(whole);
    pair.second = min(pair.first + 1, picture.ringCount - 1);
    pair.firstWeight = (1.0 - next) * slices[pair.first].weight;
    pair.secondWeight = pair.first + 1 < picture.ringCount ? next * slices[pair.second].weight : 0.0;
    return pair;
}

// How much of a band with this shortest wave the pair holds.
float carriedBy(SlicePair pair, float wavelength)
{
    float cut = picture.finestWavelength * 0.999;
    return (wavelength >= cut * slices[pair.first].scale ? pair.firstWeight : 0.0) +
           (wavelength >= cut * slices[pair.second].scale ? pair.secondWeight : 0.0);
}

void addBands(inout Slopes slopes, SlicePair pair, vec2 rest, Footprint footprint)
{
    float side = float(textureSize(detail, 0).x);
    for (uint i = 0; i < picture.bandCount; ++i)
    {
        swDetailParams band = bands[i];
        float missing = 1.0 - carriedBy(pair, band.minWavelength);
        if (missing <= 0.0)
        {
            continue;
        }
        vec2 moments = vec2(band.slopeVarianceX, band.slopeVarianceZ);
        // Of waves hardly longer than a pixel only the mean counts: a tile is 16 of its longest waves wide, and what is
        // left of its pattern would show how it repeats.
        float merged = smoothstep(0.2, 0.7, footprint.shortest / band.maxWavelength);
        if (merged >= 1.0)
        {
            slopes.variance += missing * moments;
            continue;
        }
        vec2 uv = vec2(band.offsetX, band.offsetZ) + rest * band.perMetre;
        vec4 m = meanOverFootprint(detail, float(i), uv, footprint, band.perMetre, side, isSoftware != 0 ? 2.0 : 8.0,
                                   isSoftware != 0);
        vec2 mean = (1.0 - merged) * m.xy;
        slopes.mean += missing * mean;
        slopes.variance += missing * max(mix(m.zw, moments, merged) - mean * mean, vec2(0.0));
    }
}

// The first free wave that is shorter than this.
uint firstShorter(float wavelength)
{
    uint low = 0, high = picture.waveCount;
    while (low < high)
    {
        uint middle = (low + high) / 2;
        bool isLong = waves[middle].wavelength >= wavelength;
        low = isLong ? middle + 1 : low;
        high = isLong ? high : middle;
    }
    return low;
}

// What a pixel leaves of a wave's slope: a Gaussian over the footprint, of 0.4 of its width along either axis.
float leftOverFootprint(vec2 k, Footprint footprint)
{
    float along = 0.4 * footprint.longest * dot(k, footprint.axis);
    float across = 0.4 * footprint.shortest * (k.y * footprint.axis.x - k.x * footprint.axis.y);
    return exp(-0.5 * (along * along + across * across));
}

// Each free wave that the slices leave out, with its own slope as far as the pixel resolves it. All that are shorter
// than a pixel are roughness at once.
void addFreeWaves(inout Slopes slopes, SlicePair pair, vec2 rest, Footprint footprint)
{
    float cut = picture.finestWavelength * 0.999;
    bool isWhole = pair.firstWeight + pair.secondWeight > 0.999;
    float longest = cut * slices[pair.secondWeight > 0.0 ? pair.second : pair.first].scale;
    float shortest = min(footprint.shortest, cut * slices[pair.first].scale);
    for (uint i = isWhole ? firstShorter(longest) : 0; i < picture.waveCount; ++i)
    {
        swDetailWave wave = waves[i];
        if (wave.wavelength < shortest)
        {
            slopes.variance += vec2(wave.restX, wave.restZ);
            return;
        }
        vec2 k = vec2(wave.kx, wave.kz);
        float missing = 1.0 - carriedBy(pair, wave.wavelength);
        float left = leftOverFootprint(k, footprint);
        vec2 steepness = wave.amplitude * k;
        slopes.mean -= (missing * left * sin(dot(k, rest) + wave.phase)) * steepness;
        slopes.variance += (0.5 * missing * (1.0 - left * left)) * steepness * steepness;
    }
}

Slopes slopesAt(vec2 rest, Footprint footprint, out SlicePair pair)
{
    Slopes slopes;
    float byDistance = float(ring) + blend;
    // A pixel may cover as much as the shortest wave's quarter, a texel.
    float byFootprint = log2(max(3.0 * footprint.longest / picture.finestWavelength, 1e-6));
    slopes.level = clamp(max(byDistance, byFootprint), 0.0, float(picture.ringCount));
    pair = pairAt(slopes.level);
    vec3 d = vec3(0.0, 0.0, 1.0 - pair.firstWeight - pair.secondWeight);
    float resolution = float(picture.resolution);
    d += pair.firstWeight *
         textureLod(derivatives, vec3(sliceUv(slices[pair.first], place, resolution), float(pair.first)), 0.0).xyz;
    if (pair.secondWeight > 0.0)
    {
        d +=
            pair.secondWeight *
            textureLod(derivatives, vec3(sliceUv(slices[pair.second], place, resolution), float(pair.second)), 0.0).xyz;
    }
    slopes.jacobian = d.z;
    // A fold would be vertical; its place is under foam, and steeper than this no water stands.
    slopes.mean = d.xy / max(d.z, 0.25);
    slopes.mean *= min(1.0, 1.4 * inversesqrt(max(dot(slopes.mean, slopes.mean), 1e-8)));
    slopes.variance = vec2(picture.rippleVariance);
    addBands(slopes, pair, rest, footprint);
    addFreeWaves(slopes, pair, rest, footprint);
    return slopes;
}

float foamAmount(SlicePair pair)
{
    float resolution = float(picture.resolution);
    float amount =
        (1.0 - pair.firstWeight - pair.secondWeight) * picture.foamAtRest +
        pair.firstWeight *
            textureLod(foamLayer, vec3(sliceUv(slices[pair.first], place, resolution), float(pair.first)), 0.0).r;
    if (pair.secondWeight > 0.0)
    {
        amount +=
            pair.secondWeight *
            textureLod(foamLayer, vec3(sliceUv(slices[pair.second], place, resolution), float(pair.second)), 0.0).r;
    }
    return clamp(amount, 0.0, 1.0);
}

// Radiance that reaches the water along `direction`; near and below the horizon other waves stand in the way, which
// themselves mirror the sky at a grazing angle over the water's own colour.
vec3 surroundings(vec3 direction, float blur, vec3 leaving)
{
    vec3 up = vec3(direction.x, abs(direction.y), direction.z);
    vec3 sky = textureLod(skyMap, skyViewUv(up, 0.0), blur).rgb;
    float open = smoothstep(-0.10, 0.06, direction.y);
    float mirror = swFresnel(up.y + 0.12, picture.index);
    return mix(mix(leaving, sky, mirror), sky, open);
}

// Sky reflected by facets whose slopes differ from the mean in one direction, weighted by how large each appears; xyz
// is radiance times reflectance, w the mean Fresnel reflectance. The sky's blurred copies stand for the other
// direction.
vec4 skyOfFacets(vec3 view, Slopes slopes, vec2 direction, vec3 leaving)
{
    vec2 across = vec2(-direction.y, direction.x);
    float level = dot(view.xz, direction);
    float deviation = sqrt(dot(direction * direction, slopes.variance));
    float blur = log2(max(2.0 * sqrt(dot(across * across, slopes.variance)), 1e-3) * 32.0);

    const int facets = 5;
    float highest = clamp((view.y - dot(view.xz, slopes.mean)) / max(level * deviation, 1e-4), -6.0, 2.4);
    float lowest = min(-2.4, highest - 2.4);
    vec4 sum = vec4(0.0);
    float total = 1e-9;
    for (int i = 0; i < facets; ++i)
    {
        float x = mix(lowest, highest, (float(i) + 0.5) / float(facets));
        vec3 normal = facetNormal(slopes.mean + direction * (x * deviation));
        float cosine = dot(view, normal);
        float weight = exp(-0.5 * x * x) * max(cosine, 1e-4) / normal.y;
        float f = swFresnel(cosine, picture.index);
        sum += weight * f * vec4(surroundings(reflect(-view, normal), max(blur, 0.0), leaving), 1.0);
        total += weight;
    }
    return sum / total;
}

// Reflected sky; returns the mean Fresnel reflectance in `reflectance`. Seen from above no direction is along the line
// of sight: there facets of both directions count, or the sky's brighter side would show as a wedge under the viewer.
vec3 reflectedSky(vec3 view, Slopes slopes, vec3 leaving, out float reflectance)
{
    vec2 along = view.xz * inversesqrt(max(dot(view.xz, view.xz), 1e-8));
    along = dot(along, along) > 0.5 ? along : vec2(1.0, 0.0);
    vec4 sky = skyOfFacets(view, slopes, along, leaving);
    float both = 0.5 - 0.5 * smoothstep(0.1, 0.7, length(view.xz));
    if (both > 0.0)
    {
        sky = mix(sky, skyOfFacets(view, slopes, vec2(-along.y, along.x), leaving), both);
    }
    reflectance = sky.w;
    return sky.rgb;
}

// Light scattered back by deep water, leaving it per unit of its own solid angle: R = 0.33 bb / a under the surface
// [Morel and Prieur 1977], 0.54 for both passages through it [Mobley 1994]. A fiftieth of what particles scatter goes
// backward [Petzold 1972]; bubbles scatter back white.
vec3 leavingWater(vec3 illuminance, float bubbles)
{
    vec3 back = 0.0183 * picture.scattering + vec3(0.0006, 0.0009, 0.0019) + vec3(0.08 * bubbles);
    vec3 reflectance = 0.33 * back / (picture.absorption + back);
    return illuminance * reflectance * (0.54 / pi);
}

// Sunlight that comes through a crest: once scattered, strongly forward, on a path as long as the crest is thick.
vec3 throughCrest(vec3 view, vec3 normal, float illuminated)
{
    vec3 sun = picture.sun;
    float deviation = max(picture.deviation, 0.01);
    float crest = height / deviation;
    float thickness = 2.5 * deviation * exp2(-max(crest, 0.0));
    vec3 inward = refract(-view, normal, 1.0 / picture.index);
    // The crest's far side leans towards the sun.
    vec3 back = normalize(vec3(0.4 * sun.x, 1.0, 0.4 * sun.z));
    vec3 travel = refract(-sun, back, 1.0 / picture.index);
    float cosine = dot(travel, -inward);
    float phase = 0.0151 / pow(max(1.81 - 1.8 * cosine, 1e-3), 1.5) + 0.006;
    vec3 lost = picture.absorption + 0.1 * picture.scattering;
    float entering = max(dot(back, sun), 0.0) * (1.0 - swFresnel(dot(back, sun), picture.index));
    return light.sun.rgb * picture.scattering * phase * thickness * exp(-2.0 * lost * thickness) *
           (entering * illuminated * smoothstep(-0.2, 1.6, crest) / (picture.index * picture.index));
}

vec3 debugColor(Slopes slopes, float foam)
{
    vec3 hue = 0.5 + 0.5 * cos(6.2831853 * (float(ring) * 0.381966 + vec3(0.0, 0.33, 0.67)));
    switch (picture.debugMode)
    {
    case 1: // slices: their colours, blending
    {
        vec3 next = 0.5 + 0.5 * cos(6.2831853 * (float(ring + 1) * 0.381966 + vec3(0.0, 0.33, 0.67)));
        return mix(hue, next, blend) * (0.35 + 0.65 * facetNormal(slopes.mean).y * facetNormal(slopes.mean).y);
    }
    case 2: // wireframe
        return hue;
    case 3: // normals
        return 0.5 + 0.5 * facetNormal(slopes.mean).xzy;
    case 4: // height: two deviations from black to white
        return vec3(0.5 + 0.25 * height / max(picture.deviation, 0.01));
    case 5: // Jacobian: grey 1, red below 0
        return slopes.jacobian < 0.0 ? vec3(1.0, 0.1, 0.0) : vec3(0.5 * slopes.jacobian);
    case 6: // foam
        return vec3(foam);
    default: // roughness
        return vec3(sqrt(slopes.variance) * 4.0, 0.0);
    }
}

void main()
{
    vec2 rest = place * picture.step;
    float range = length(position);
    vec3 view = -position / range;
    float facing = facingArea(view, vec2(0.0), vec2(picture.slopeVariance));
    Footprint footprint = footprintAt(view, range, picture.pixel, facing);
    SlicePair pair;
    Slopes slopes = slopesAt(rest, footprint, pair);
    float amount = foamAmount(pair);
    if (picture.debugMode != 0)
    {
        color = vec4(debugColor(slopes, amount), 1.0); // shown without exposure or curve
        return;
    }

    vec3 sun = picture.sun;
    vec3 normal = facetNormal(slopes.mean);
    float index = picture.index;

    float sunOnWater = max(sun.y, 0.0) * (1.0 - swFresnel(sun.y, index));
    vec3 entering = light.sun.rgb * sunOnWater + light.sky.rgb * 0.934;
    vec3 leaving = leavingWater(entering, amount);

    float reflectance;
    vec3 radiance = reflectedSky(view, slopes, leaving, reflectance);
    float area = facingArea(view, slopes.mean, slopes.variance);
    radiance += light.sun.rgb * sunGlitter(view, sun, slopes.mean, slopes.variance, area, index);
    radiance += (1.0 - reflectance) * (leaving + throughCrest(view, normal, 1.0));

    FoamDetail foam = foamDetailAt(foamTexture, rest + vec2(picture.foamX, picture.foamZ), footprint, amount,
                                   picture.foamPhase, picture.foamSeed);
    float lambert = max(0.85 * dot(normal, sun) + 0.15, 0.0);
    vec3 foamLight = (light.sun.rgb * lambert * smoothstep(-0.02, 0.05, sun.y) + light.sky.rgb) / pi;
    radiance = mix(radiance, foamLight * picture.foamAlbedo, foam.cover * foam.thickness);

    vec2 airAt = airUv(-view, sun, range * 1e-3, picture.cameraHeight * 1e-3);
    vec3 added =
        withHaze(textureLod(air, vec3(airAt, 0.0), 0.0).rgb, textureLod(air, vec3(airAt, 2.0), 0.0).rgb, -view, sun);
    vec3 passed = textureLod(air, vec3(airAt, 1.0), 0.0).rgb;
    color = vec4(min(radiance * passed + added, vec3(60000.0)), 1.0);
}
