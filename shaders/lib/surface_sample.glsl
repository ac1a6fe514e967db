// SPDX-License-Identifier: MIT
// Slopes of the sea at a pixel, and the variance of those that the pixel cannot resolve.
//
// Long waves come from the slices, chop and all. A slice carries waves from eight of its texels up, so a coarser slice
// is also a filtered one: the slice is chosen by distance, like the mesh's, or coarser where a pixel covers more. Every
// band that the chosen slices leave out comes from the layers of its own tile's slopes, filtered by their mips along
// the pixel's footprint; what a mip has averaged away is its mean square less the square of its mean.
//
// Buffers cannot be arguments, so whoever includes this says where their elements come from, by functions of the three
// names that are declared below.
#ifndef SW_LIB_SURFACE_SAMPLE
#define SW_LIB_SURFACE_SAMPLE
#include "shared/mesh.h"
#include "shared/picture.h"

swMeshSlice meshSlice(uint index);
swDetailParams detailBand(uint index);
swDetailWave detailWave(uint index);
// How much of a wave system there is where the pixel's water rests.
float shareOf(uint system);

// Of the buffers and layers: members of swPictureParams.
struct SurfaceGrid
{
    uint ringCount, bandCount, waveCount, resolution;
    float finestWavelength;
    float rippleVariance;
};

struct Slopes
{
    vec2 mean;
    vec2 variance; // unresolved
    float jacobian;
};

// The pixel's footprint on the water: an ellipse drawn out along the line of sight.
struct Footprint
{
    vec2 axis; // unit vector along the longer half axis
    float longest, shortest;
};

// From distance and angle, not from derivatives: those of a triangle seen edge on are as large as they are meaningless.
// `facing` is the mean projected area of level water, which on a rough sea stays above 0 at the horizon.
Footprint footprintAt(vec3 view, float range, float pixelAngle, float facing)
{
    Footprint footprint;
    footprint.axis = view.xz * inversesqrt(max(dot(view.xz, view.xz), 1e-8));
    footprint.shortest = range * pixelAngle;
    footprint.longest = footprint.shortest / min(facing, 1.0);
    return footprint;
}

// Mean of a repeating layer over the footprint: blurred probes along the longer axis, none narrower than a texel, and
// at most `most`. Hardware's anisotropic filter would do, but software devices walk every texel of a footprint that
// spans thousands of tiles. For those, who filter by hand, a probe also keeps to one mip where `isFast`.
vec4 meanOverFootprint(sampler2DArray layers, float layer, vec2 uv, Footprint footprint, float perMetre, float side,
                       float most, bool isFast)
{
    float longest = min(footprint.longest * perMetre, 1.0);
    float width = max(min(max(footprint.shortest * perMetre, 1.0 / side), longest), longest / most);
    float probes = clamp(ceil(longest / max(width, 1e-6)), 1.0, most);
    float lod = log2(max(width * side, 1e-3));
    lod = isFast ? floor(lod + 0.5) : lod;
    vec2 stride = footprint.axis * (longest / probes);
    vec2 at = uv - stride * (0.5 * (probes - 1.0));
    vec4 sum = vec4(0.0);
    for (float i = 0.0; i < probes; ++i)
    {
        sum += textureLod(layers, vec3(at, layer), lod);
        at += stride;
    }
    return sum / probes;
}

vec2 sliceUv(swMeshSlice slice, vec2 place, float resolution)
{
    vec2 texel = vec2(swMeshTexel(place.x, slice.originX, slice.texelX, slice.scale),
                      swMeshTexel(place.y, slice.originZ, slice.texelZ, slice.scale));
    return (texel + 0.5) / resolution;
}

// The two slices to read, and how much each counts.
struct SlicePair
{
    uint first, second;
    float firstWeight, secondWeight;
};

SlicePair slicePairAt(SurfaceGrid grid, float level)
{
    float last = float(grid.ringCount - 1);
    float whole = floor(min(level, last));
    float next = clamp(level - whole, 0.0, 1.0);
    SlicePair pair;
    pair.first = uint(whole);
    pair.second = min(pair.first + 1, grid.ringCount - 1);
    pair.firstWeight = (1.0 - next) * meshSlice(pair.first).weight;
    pair.secondWeight = pair.first + 1 < grid.ringCount ? next * meshSlice(pair.second).weight : 0.0;
    return pair;
}

// How much of a band with this shortest wave the pair holds.
float carriedBy(SurfaceGrid grid, SlicePair pair, float wavelength)
{
    float cut = grid.finestWavelength * 0.999;
    return (wavelength >= cut * meshSlice(pair.first).scale ? pair.firstWeight : 0.0) +
           (wavelength >= cut * meshSlice(pair.second).scale ? pair.secondWeight : 0.0);
}

void addBands(inout Slopes slopes, SurfaceGrid grid, SlicePair pair, vec2 rest, Footprint footprint,
              sampler2DArray detail, bool isFast)
{
    float side = float(textureSize(detail, 0).x);
    for (uint i = 0; i < grid.bandCount; ++i)
    {
        swDetailParams band = detailBand(i);
        float missing = 1.0 - carriedBy(grid, pair, band.minWavelength), share = shareOf(band.system);
        if (missing <= 0.0 || share <= 0.0)
        {
            continue;
        }
        vec2 moments = share * share * vec2(band.slopeVarianceX, band.slopeVarianceZ);
        // Of waves hardly longer than a pixel only the mean counts: a tile is 16 of its longest waves wide, and what is
        // left of its pattern would show how it repeats.
        float merged = smoothstep(0.2, 0.7, footprint.shortest / band.maxWavelength);
        if (merged >= 1.0)
        {
            slopes.variance += missing * moments;
            continue;
        }
        vec2 uv = vec2(band.offsetX, band.offsetZ) + rest * band.perMetre;
        vec4 m = meanOverFootprint(detail, float(i), uv, footprint, band.perMetre, side, isFast ? 2.0 : 8.0, isFast);
        m *= vec4(share, share, share * share, share * share);
        vec2 mean = (1.0 - merged) * m.xy;
        slopes.mean += missing * mean;
        slopes.variance += missing * max(mix(m.zw, moments, merged) - mean * mean, vec2(0.0));
    }
}

// The first free wave that is shorter than this.
uint firstShorter(SurfaceGrid grid, float wavelength)
{
    uint low = 0, high = grid.waveCount;
    while (low < high)
    {
        uint middle = (low + high) / 2;
        bool isLong = detailWave(middle).wavelength >= wavelength;
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
void addFreeWaves(inout Slopes slopes, SurfaceGrid grid, SlicePair pair, vec2 rest, Footprint footprint)
{
    float cut = grid.finestWavelength * 0.999;
    bool isWhole = pair.firstWeight + pair.secondWeight > 0.999;
    float longest = cut * meshSlice(pair.secondWeight > 0.0 ? pair.second : pair.first).scale;
    float shortest = min(footprint.shortest, cut * meshSlice(pair.first).scale);
    for (uint i = isWhole ? firstShorter(grid, longest) : 0; i < grid.waveCount; ++i)
    {
        swDetailWave wave = detailWave(i);
        float share = shareOf(wave.system);
        if (wave.wavelength < shortest)
        {
            slopes.variance += share * share * vec2(wave.restX, wave.restZ);
            return;
        }
        vec2 k = vec2(wave.kx, wave.kz);
        float missing = 1.0 - carriedBy(grid, pair, wave.wavelength);
        float left = leftOverFootprint(k, footprint);
        vec2 steepness = share * wave.amplitude * k;
        slopes.mean -= (missing * left * sin(dot(k, rest) + wave.phase)) * steepness;
        slopes.variance += (0.5 * missing * (1.0 - left * left)) * steepness * steepness;
    }
}

// The slice to read, and a fraction of the next: by distance, as the mesh has it, or coarser where a pixel covers more.
float sliceLevelAt(SurfaceGrid grid, float byDistance, Footprint footprint)
{
    // A pixel may cover as much as the shortest wave's quarter, a texel.
    float byFootprint = log2(max(3.0 * footprint.longest / grid.finestWavelength, 1e-6));
    return clamp(max(byDistance, byFootprint), 0.0, float(grid.ringCount));
}

// A slice of a layer, between texels. `byHand` where the device does not filter the layer's format.
//
// Samplers round the number of an array's layer to the nearest. It is read from memory, because NVIDIA's compiler drops
// the floor of a number that was computed from a level, and then takes the next slice from halfway on.
vec4 sampleSlice(sampler2DArray layer, vec2 uv, uint slice, bool byHand)
{
    if (!byHand)
    {
        return textureLod(layer, vec3(uv, meshSlice(slice).layer), 0.0);
    }
    vec2 most = vec2(textureSize(layer, 0).xy) - 1.0;
    vec2 texel = clamp(uv * (most + 1.0) - 0.5, vec2(0.0), most);
    vec2 low = floor(texel);
    vec2 f = texel - low;
    ivec3 t = ivec3(ivec2(low), int(slice));
    ivec2 next = min(t.xy + 1, ivec2(most));
    vec4 a = mix(texelFetch(layer, t, 0), texelFetch(layer, ivec3(next.x, t.y, t.z), 0), f.x);
    vec4 b = mix(texelFetch(layer, ivec3(t.x, next.y, t.z), 0), texelFetch(layer, ivec3(next, t.z), 0), f.x);
    return mix(a, b, f.y);
}

// A layer of the slices at a place of the mesh; what the pair does not hold is `beyond`.
vec4 sampleSlices(sampler2DArray layer, SurfaceGrid grid, SlicePair pair, vec2 place, vec4 beyond, bool byHand)
{
    float resolution = float(grid.resolution);
    vec4 sum = (1.0 - pair.firstWeight - pair.secondWeight) * beyond;
    vec2 uv = sliceUv(meshSlice(pair.first), place, resolution);
    sum += pair.firstWeight * sampleSlice(layer, uv, pair.first, byHand);
    if (pair.secondWeight > 0.0)
    {
        uv = sliceUv(meshSlice(pair.second), place, resolution);
        sum += pair.secondWeight * sampleSlice(layer, uv, pair.second, byHand);
    }
    return sum;
}

// Depth of still water where something is, m, how high it stands, and the level's slopes along x and z.
struct Standing
{
    float depth, level;
    vec2 slope;
};

Standing sampleStanding(sampler2DArray places, swMeshSlice slice, uint index, vec2 place, float texel)
{
    vec2 most = vec2(textureSize(places, 0).xy) - 1.0;
    vec2 at = vec2(swMeshTexel(place.x, slice.originX, slice.texelX, slice.scale),
                   swMeshTexel(place.y, slice.originZ, slice.texelZ, slice.scale));
    at = clamp(at, vec2(0.0), most);
    ivec2 low = ivec2(min(floor(at), most - 1.0));
    vec2 f = at - vec2(low);
    vec4 a = texelFetch(places, ivec3(low, int(index)), 0);
    vec4 b = texelFetch(places, ivec3(low.x + 1, low.y, int(index)), 0);
    vec4 c = texelFetch(places, ivec3(low.x, low.y + 1, int(index)), 0);
    vec4 d = texelFetch(places, ivec3(low + 1, int(index)), 0);
    vec4 middle = mix(mix(a, b, f.x), mix(c, d, f.x), f.y);
    vec2 slope = vec2(mix(b.w - a.w, d.w - c.w, f.y), mix(c.w - a.w, d.w - b.w, f.x)) / texel;
    return Standing(middle.x, middle.w, slope);
}

// `place` is that of the water itself, not of its rest; `texel` that of the finest slice, m.
Standing standingAt(SurfaceGrid grid, float level, vec2 place, float texel, sampler2DArray places)
{
    float last = float(grid.ringCount - 1);
    uint first = uint(min(floor(level), last));
    float next = min(float(first), last) < last ? clamp(level - float(first), 0.0, 1.0) : 0.0;
    Standing fine = sampleStanding(places, meshSlice(first), first, place, texel * meshSlice(first).scale);
    if (next <= 0.0)
    {
        return fine;
    }
    Standing coarse =
        sampleStanding(places, meshSlice(first + 1), first + 1, place, texel * meshSlice(first + 1).scale);
    return Standing(mix(fine.depth, coarse.depth, next), mix(fine.level, coarse.level, next),
                    mix(fine.slope, coarse.slope, next));
}

// `place` is in finest steps from the mesh's anchor, `rest` the same in metres.
Slopes slopesAt(SurfaceGrid grid, SlicePair pair, vec2 place, vec2 rest, Footprint footprint,
                sampler2DArray derivatives, sampler2DArray detail, bool isFast)
{
    vec4 d = sampleSlices(derivatives, grid, pair, place, vec4(0.0, 0.0, 1.0, 0.0), false);
    Slopes slopes;
    slopes.jacobian = d.z;
    // A fold would be vertical; its place is under foam, and steeper than this no water stands.
    slopes.mean = d.xy / max(d.z, 0.25);
    slopes.mean *= min(1.0, 1.4 * inversesqrt(max(dot(slopes.mean, slopes.mean), 1e-8)));
    slopes.variance = vec2(grid.rippleVariance);
    addBands(slopes, grid, pair, rest, footprint, detail, isFast);
    addFreeWaves(slopes, grid, pair, rest, footprint);
    return slopes;
}

// Smooth amount of foam, [0, 1]; `atRest` is that beyond the slices. Many mobile devices do not filter its 32 bits.
float foamAmountAt(SurfaceGrid grid, SlicePair pair, vec2 place, sampler2DArray foam, float atRest, bool byHand)
{
    return clamp(sampleSlices(foam, grid, pair, place, vec4(atRest), byHand).r, 0.0, 1.0);
}
#endif
