// SPDX-License-Identifier: MIT
// Slopes of the sea at a pixel, and the variance of those that the pixel cannot resolve.
//
// Long waves come from the slices, chop and all. A slice carries waves from four of its texels up, so a coarser slice is
// also a filtered one: the slice is chosen by distance, like the mesh's, or coarser where a pixel covers more. Every band
// that the chosen slices leave out comes from the layers of its own tile's slopes, filtered by their mips along the pixel's
// footprint; what a mip has averaged away is its mean square less the square of its mean. Needs shared/picture.h and
// shared/mesh.h.

struct Slopes
{
    vec2 mean;
    vec2 variance; // unresolved
    float jacobian;
    float level; // slice and fraction that were read
};

// Lengths of the pixel's footprint on the rest plane, longest first.
vec2 footprintOf(vec2 dx, vec2 dy)
{
    float a = dot(dx, dx);
    float b = dot(dx, dy);
    float c = dot(dy, dy);
    float middle = 0.5 * (a + c);
    float reach = sqrt(max(0.25 * (a - c) * (a - c) + b * b, 0.0));
    return sqrt(max(vec2(middle + reach, middle - reach), vec2(1e-12)));
}

vec2 sliceUv(swMeshSlice slice, vec2 place, float resolution)
{
    vec2 texel = vec2(swMeshTexel(place.x, slice.originX, slice.texelX, slice.scale),
                      swMeshTexel(place.y, slice.originZ, slice.texelZ, slice.scale));
    return (texel + 0.5) / resolution;
}
