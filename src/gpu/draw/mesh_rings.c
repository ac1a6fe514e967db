// SPDX-License-Identifier: MIT
// Rings around the viewer, cut into rectangles with whole-number bounds.
//
// Ring i is the square block of 4d x 4d steps around the viewer's position rounded down to two of its steps, less the
// block of ring i - 1. In steps of ring i that hole is 2d x 2d and lies in the middle or one step to the positive side,
// because the finer block is rounded more finely; so the hole's bounds are computed, never assumed.

#include "gpu/draw/mesh_rings.h"

#include <math.h>
#include <string.h>

// Bounds of a block in steps of its own ring, on the world's lattice.
typedef struct swBlock
{
    int64_t x, z;
} swBlock;

static int64_t snapToTwo(double steps)
{
    return 2 * (int64_t)floor(steps * 0.5);
}

static swBlock placeBlock(const swViewFrame* frame, double step, int quads)
{
    return (swBlock){snapToTwo(frame->viewpoint.x / step) - 2 * quads,
                     snapToTwo(frame->viewpoint.z / step) - 2 * quads};
}

// Cut a rectangle into tiles of nearly equal size.
static void addRectangle(swMeshRings* rings, int ring, int x0, int z0, int x1, int z1)
{
    int width = x1 - x0;
    int height = z1 - z0;
    int columns = (width + rings->tileSide - 1) / rings->tileSide;
    int rows = (height + rings->tileSide - 1) / rings->tileSide;
    for (int row = 0; row < rows; ++row)
    {
        for (int column = 0; column < columns; ++column)
        {
            int left = x0 + width * column / columns;
            int top = z0 + height * row / rows;
            rings->tiles[rings->tileCount++] = (swMeshTile){
                .ring = (uint32_t)ring,
                .x = left,
                .z = top,
                .width = x0 + width * (column + 1) / columns - left,
                .height = z0 + height * (row + 1) / rows - top,
                .body = SW_NO_MESH_BODY,
            };
        }
    }
}

static void addRing(swMeshRings* rings, int ring, swBlock block, swBlock inner)
{
    int side = 4 * rings->quads;
    int holeX = (int)(inner.x / 2 - block.x);
    int holeZ = (int)(inner.z / 2 - block.z);
    int holeSide = side / 2;
    addRectangle(rings, ring, 0, 0, side, holeZ);
    addRectangle(rings, ring, 0, holeZ, holeX, holeZ + holeSide);
    addRectangle(rings, ring, holeX + holeSide, holeZ, side, holeZ + holeSide);
    addRectangle(rings, ring, 0, holeZ + holeSide, side, side);
}

// The rim's vertices stand two steps apart, because the last ring's odd ones have slid away.
static void addHorizon(swMeshRings* rings)
{
    int steps = 2 * rings->quads;
    for (int side = 0; side < 4; ++side)
    {
        for (int part = 0; part < 2; ++part)
        {
            rings->tiles[rings->tileCount++] = (swMeshTile){
                .ring = (uint32_t)rings->ringCount,
                .x = steps * part / 2,
                .width = steps / 2,
                .height = side,
                .body = SW_NO_MESH_BODY,
            };
        }
    }
}

// The last slice has no coarser one behind it that could take over when the stack doubles: what it adds must be gone
// just after a doubling, at fade 0, and complete just before the next. Near the water nothing can halve, so it is
// always shown.
static float getLastWeight(const swViewFrame* frame)
{
    return frame->scaleLevel == 0 ? 1.0f : fminf(4.0f * frame->fade, 1.0f);
}

void swBuildMeshRings(const swViewFrame* frame, swMeshRings* rings)
{
    memset(rings, 0, sizeof(*rings));
    rings->ringCount = frame->stack.sliceCount;
    rings->quads = frame->stack.resolution / 8;
    rings->tileSide = rings->quads + 1;
    rings->step = 2.0 * frame->stack.slices[0].texel;
    rings->fade = frame->fade;

    int64_t anchorX = (int64_t)floor(frame->viewpoint.x / rings->step);
    int64_t anchorZ = (int64_t)floor(frame->viewpoint.z / rings->step);
    rings->anchorX = (double)anchorX * rings->step;
    rings->anchorZ = (double)anchorZ * rings->step;
    rings->viewX = (float)(frame->viewpoint.x / rings->step - (double)anchorX);
    rings->viewZ = (float)(frame->viewpoint.z / rings->step - (double)anchorZ);

    swBlock inner = {0};
    for (int ring = 0; ring < rings->ringCount; ++ring)
    {
        int64_t scale = (int64_t)1 << ring;
        swBlock block = placeBlock(frame, rings->step * (double)scale, rings->quads);
        const swSlice* slice = &frame->stack.slices[ring];
        rings->slices[ring] = (swMeshSlice){
            .originX = (int32_t)(block.x * scale - anchorX),
            .originZ = (int32_t)(block.z * scale - anchorZ),
            .phaseX = (int32_t)(block.x & 3),
            .phaseZ = (int32_t)(block.z & 3),
            .texelX = (int32_t)(2 * block.x - slice->firstX),
            .texelZ = (int32_t)(2 * block.z - slice->firstZ),
            .scale = (float)scale,
            .weight = ring == rings->ringCount - 1 ? getLastWeight(frame) : 1.0f,
            .layer = (float)ring,
        };
        if (ring == 0)
        {
            addRectangle(rings, 0, 0, 0, 4 * rings->quads, 4 * rings->quads);
        }
        else
        {
            addRing(rings, ring, block, inner);
        }
        inner = block;
    }
    addHorizon(rings);
}

double swGetMeshRim(const swMeshRings* rings)
{
    return (2.0 * rings->quads - 2.0) * rings->step * (double)rings->slices[rings->ringCount - 1].scale;
}
