// SPDX-License-Identifier: MIT
// Tiles as cubics along z, for the passes that add up waves in slices. Between two knots a column of a tile is one
// cubic; a column of texels weighs four such columns along x, once for all texels of it between the two knots.
//
// Before including: lib/slice_waves.glsl.
#ifndef SW_LIB_SLICE_CUBICS
#define SW_LIB_SLICE_CUBICS

// Displacement is x[0] + x[1] t + x[2] t^2 + x[3] t^3, t texels from some row, y and z the same; slopeX to slopeZ are
// its slope along x.
struct Cubic
{
    vec4 x, y, z;
    vec4 slopeX, slopeY, slopeZ;
};

const Cubic FLAT = Cubic(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));

float evaluate(vec4 c, float t)
{
    return fma(fma(fma(c.w, t, c.z), t, c.y), t, c.x);
}

float evaluateSlope(vec4 c, float t)
{
    return fma(fma(3.0 * c.w, t, 2.0 * c.z), t, c.y);
}

Texel evaluateCubic(Cubic cubic, float t, float texelsPerMetre)
{
    return Texel(vec3(evaluate(cubic.x, t), evaluate(cubic.y, t), evaluate(cubic.z, t)),
                 vec3(evaluate(cubic.slopeX, t), evaluate(cubic.slopeY, t), evaluate(cubic.slopeZ, t)),
                 texelsPerMetre * vec2(evaluateSlope(cubic.y, t), evaluateSlope(cubic.z, t)));
}

// What each of four coefficients of the spline adds to its cubic, as Taylor polynomials t beyond a knot.
mat4 cubicPieces(float t, float step)
{
    float halfSquare = 0.5 * step * step;
    vec4 w1 = swSplineSlopes(t) * step;
    vec4 w2 = vec4(1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t) * halfSquare;
    vec4 w3 = vec4(-1.0, 3.0, -3.0, 1.0) * (halfSquare * step * (1.0 / 3.0));
    return transpose(mat4(swSplineWeights(t), w1, w2, w3));
}

// First column of a tile that a block of texels touches, not wrapped.
float firstOfBlock(swSliceTile tile)
{
    return floor(splineX(tile, gl_WorkGroupID.x * SW_SLICE_WIDTH));
}

// Where a column of texels has its window of four of the block's tile columns, and the window's weights.
struct Window
{
    uint first;
    vec4 value, slope;
};

Window makeWindow(swSliceTile tile, uint column)
{
    float s = splineX(tile, column);
    float cell = floor(s);
    return Window(uint(cell - firstOfBlock(tile)), swSplineWeights(s - cell), swSplineSlopes(s - cell) * tile.perMetre);
}

// Adds a column's cubics, weighted.
void addColumn(inout Cubic cubic, vec4 x, vec4 y, vec4 z, float value, float slope)
{
    cubic.x = fma(vec4(value), x, cubic.x);
    cubic.y = fma(vec4(value), y, cubic.y);
    cubic.z = fma(vec4(value), z, cubic.z);
    cubic.slopeX = fma(vec4(slope), x, cubic.slopeX);
    cubic.slopeY = fma(vec4(slope), y, cubic.slopeY);
    cubic.slopeZ = fma(vec4(slope), z, cubic.slopeZ);
}
#endif
