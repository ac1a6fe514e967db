// SPDX-License-Identifier: MIT
// Slopes of the sea at a pixel, and the variance of those that the pixel cannot resolve.
//
// Long waves come from the slices, chop and all. A slice carries waves from eight of its texels up, so a coarser slice
// is also a filtered one: the slice is chosen by distance, like the mesh's, or coarser where a pixel covers more. Every
// band that the chosen slices leave out comes from the layers of its own tile's slopes, filtered by their mips along
// the pixel's footprint; what a mip has averaged away is its mean square less the square of its mean. Needs
// shared/picture.h and shared/mesh.h.

struct Slopes
{
    vec2 mean;
    vec2 variance; // unresolved
    float jacobian;
    float level; // slice and fraction that were read
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
