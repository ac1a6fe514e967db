// SPDX-License-Identifier: MIT
// The rings fit: edges that meet share their vertices' bits, nothing is covered twice or left open, and neither a
// moving viewer nor a doubling stack moves a vertex that can be seen. The vertex shader's own formulas are compiled
// here.

#include "gpu/draw/mesh_rings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/cmocka_setup.h"

#define EDGE_STEPS (4 * 128)

typedef struct Vertex
{
    float x, z; // finest steps from the anchor
    float blend;
} Vertex;

static uint64_t s_random = 1;

static double Random(void)
{
    s_random = s_random * 6364136223846793005u + 1442695040888963407u;
    return (double)(s_random >> 11) * 0x1p-53;
}

static swViewFrame MakeFrame(int sliceCount, int resolution, int scaleLevel, double x, double z, float fade)
{
    swViewFrame frame = {
        .stack.sliceCount = sliceCount,
        .stack.resolution = resolution,
        .viewpoint = {x, 2.0, z},
        .fade = fade,
        .scaleLevel = scaleLevel,
    };
    for (int i = 0; i < sliceCount; ++i)
    {
        double texel = ldexp(1.0, i + scaleLevel - 4);
        frame.stack.slices[i] = (swSlice){
            .texel = texel,
            .firstX = (int64_t)floor(x / texel) - resolution / 2,
            .firstZ = (int64_t)floor(z / texel) - resolution / 2,
            .level = i + scaleLevel,
        };
    }
    return frame;
}

static swViewFrame RandomFrame(double range)
{
    static const int resolutions[] = {64, 128, 384, 512};
    int scaleLevel = (int)(Random() * 11.0);
    int sliceCount = 2 + (int)(Random() * 8.0);
    return MakeFrame(sliceCount, resolutions[(int)(Random() * 4.0)], scaleLevel, (Random() - 0.5) * range,
                     (Random() - 0.5) * range, Random() < 0.5 ? 0.0f : (float)Random());
}

static Vertex PlaceVertex(const swMeshRings* rings, int ring, int x, int z)
{
    const swMeshSlice* slice = &rings->slices[ring];
    float viewX = (rings->viewX - (float)slice->originX) / slice->scale;
    float viewZ = (rings->viewZ - (float)slice->originZ) / slice->scale;
    float fade = ring == 0 ? rings->fade : 0.0f;
    Vertex v;
    v.blend = swMeshBlend((float)x, (float)z, viewX, viewZ, (float)rings->quads, fade);
    v.x = swMeshPlace(x, slice->phaseX, slice->originX, slice->scale, v.blend);
    v.z = swMeshPlace(z, slice->phaseZ, slice->originZ, slice->scale, v.blend);
    return v;
}

// Every vertex of ring i's outer edge must be a vertex of ring i + 1's inner edge, which lies at `ratio` times its
// steps.
static void CheckEdges(const swMeshRings* rings)
{
    int side = 4 * rings->quads;
    for (int ring = 0; ring + 1 < rings->ringCount; ++ring)
    {
        const swMeshSlice* fine = &rings->slices[ring];
        const swMeshSlice* coarse = &rings->slices[ring + 1];
        int holeX = (fine->originX - coarse->originX) / (int)coarse->scale;
        int holeZ = (fine->originZ - coarse->originZ) / (int)coarse->scale;
        for (int edge = 0; edge < 4; ++edge)
        {
            for (int i = 0; i <= side; ++i)
            {
                int x = edge == 0 ? 0 : (edge == 1 ? side : i);
                int z = edge == 2 ? 0 : (edge == 3 ? side : i);
                Vertex outer = PlaceVertex(rings, ring, x, z);
                assert_true(outer.blend == 1.0f);
                int hx = holeX + (x + (int)swMeshSlide(x, fine->phaseX)) / 2;
                int hz = holeZ + (z + (int)swMeshSlide(z, fine->phaseZ)) / 2;
                Vertex inner = PlaceVertex(rings, ring + 1, hx, hz);
                assert_true(inner.blend == 0.0f);
                assert_memory_equal(&outer.x, &inner.x, sizeof(float));
                assert_memory_equal(&outer.z, &inner.z, sizeof(float));
                // The data must be the same texel too.
                float ox = swMeshTexel(outer.x, coarse->originX, coarse->texelX, coarse->scale);
                float ix = swMeshTexel(inner.x, coarse->originX, coarse->texelX, coarse->scale);
                assert_true(ox == ix && ox == floorf(ox));
            }
        }
    }
}

static void OuterEdgesAreTheNextRingsInnerEdgesToTheBit(void** state)
{
    (void)state;
    swMeshRings* rings = malloc(sizeof(*rings));
    for (int i = 0; i < 10000; ++i)
    {
        double range = i % 3 == 0 ? 100.0 : (i % 3 == 1 ? 1e5 : 2e6);
        swViewFrame frame = RandomFrame(range);
        swBuildMeshRings(&frame, rings);
        CheckEdges(rings);
    }
    free(rings);
}

static void RingsCoverTheirBlocksOnce(void** state)
{
    (void)state;
    static uint8_t covered[EDGE_STEPS * EDGE_STEPS];
    swMeshRings* rings = malloc(sizeof(*rings));
    for (int i = 0; i < 300; ++i)
    {
        swViewFrame frame = RandomFrame(1e5);
        swBuildMeshRings(&frame, rings);
        int side = 4 * rings->quads;
        assert_in_range(side, 1, EDGE_STEPS);
        for (int ring = 0; ring < rings->ringCount; ++ring)
        {
            memset(covered, 0, sizeof(covered));
            for (int t = 0; t < rings->tileCount; ++t)
            {
                const swMeshTile* tile = &rings->tiles[t];
                if ((int)tile->ring != ring)
                {
                    continue;
                }
                assert_true(tile->width > 0 && tile->width <= rings->tileSide);
                assert_true(tile->height > 0 && tile->height <= rings->tileSide);
                for (int z = tile->z; z < tile->z + tile->height; ++z)
                {
                    for (int x = tile->x; x < tile->x + tile->width; ++x)
                    {
                        ++covered[z * side + x];
                    }
                }
            }
            const swMeshSlice* slice = &rings->slices[ring];
            int scale = (int)slice->scale;
            int holeX = ring > 0 ? (rings->slices[ring - 1].originX - slice->originX) / scale : side;
            int holeZ = ring > 0 ? (rings->slices[ring - 1].originZ - slice->originZ) / scale : side;
            for (int z = 0; z < side; ++z)
            {
                for (int x = 0; x < side; ++x)
                {
                    bool hole = x >= holeX && x < holeX + side / 2 && z >= holeZ && z < holeZ + side / 2;
                    assert_int_equal(covered[z * side + x], hole ? 0 : 1);
                }
            }
        }
    }
    free(rings);
}

// Every vertex that both meshes have must lie within `limit` metres of itself.
static float GreatestMove(const swMeshRings* a, const swMeshRings* b, int shift)
{
    float greatest = 0.0f;
    for (int ring = 0; ring < b->ringCount; ++ring)
    {
        int other = ring + shift;
        if (other < 0 || other >= a->ringCount)
        {
            continue;
        }
        double step = b->step * (double)b->slices[ring].scale;
        double offsetX = (b->anchorX - a->anchorX) / a->step + b->slices[ring].originX * (b->step / a->step);
        double offsetZ = (b->anchorZ - a->anchorZ) / a->step + b->slices[ring].originZ * (b->step / a->step);
        int dx = (int)((offsetX - a->slices[other].originX) / (double)a->slices[other].scale);
        int dz = (int)((offsetZ - a->slices[other].originZ) / (double)a->slices[other].scale);
        for (int i = 0; i < 4000; ++i)
        {
            int x = (int)(Random() * (4 * b->quads + 1));
            int z = (int)(Random() * (4 * b->quads + 1));
            Vertex now = PlaceVertex(b, ring, x, z);
            Vertex then = PlaceVertex(a, other, x + dx, z + dz);
            double moveX = ((double)now.x * b->step + b->anchorX) - ((double)then.x * a->step + a->anchorX);
            double moveZ = ((double)now.z * b->step + b->anchorZ) - ((double)then.z * a->step + a->anchorZ);
            float move = (float)(fmax(fabs(moveX), fabs(moveZ)) / step);
            greatest = fmaxf(greatest, fmaxf(move, fabsf(now.blend - then.blend)));
        }
    }
    return greatest;
}

static void VerticesStayWhenTheViewerMoves(void** state)
{
    (void)state;
    swMeshRings* before = malloc(sizeof(*before));
    swMeshRings* after = malloc(sizeof(*after));
    float greatest = 0.0f;
    for (int i = 0; i < 200; ++i)
    {
        double x = (Random() - 0.5) * 2e6;
        double z = (Random() - 0.5) * 2e6;
        if (i % 2 == 0)
        {
            x = floor(x); // just below the place where every ring snaps
        }
        swViewFrame a = MakeFrame(7, 384, 0, x - 1e-4, z, 0.3f);
        swViewFrame b = MakeFrame(7, 384, 0, x + 1e-4, z, 0.3f);
        swBuildMeshRings(&a, before);
        swBuildMeshRings(&b, after);
        greatest = fmaxf(greatest, GreatestMove(before, after, 0));
    }
    print_message("greatest move under a step of 0.2 mm: %g of a ring's step\n", (double)greatest);
    assert_true(greatest < 1e-3f);
    free(before);
    free(after);
}

static void VerticesStayWhenTheStackDoubles(void** state)
{
    (void)state;
    swMeshRings* before = malloc(sizeof(*before));
    swMeshRings* after = malloc(sizeof(*after));
    float greatest = 0.0f;
    for (int i = 0; i < 200; ++i)
    {
        double x = (Random() - 0.5) * 2e6;
        double z = (Random() - 0.5) * 2e6;
        int level = (int)(Random() * 9.0);
        swViewFrame a = MakeFrame(7, 384, level, x, z, 1.0f);
        swViewFrame b = MakeFrame(7, 384, level + 1, x, z, 0.0f);
        swBuildMeshRings(&a, before);
        swBuildMeshRings(&b, after);
        greatest = fmaxf(greatest, GreatestMove(before, after, 1));
        // The finest ring has become the second one's lattice, and what the new last slice adds starts from nothing.
        Vertex odd = PlaceVertex(before, 0, 97, 101);
        assert_true(odd.blend == 1.0f);
        assert_true(before->slices[6].weight == 1.0f);
        assert_true(after->slices[5].weight == 1.0f);
        assert_true(after->slices[6].weight == 0.0f);
    }
    print_message("greatest move when the stack doubles: %g of a ring's step\n", (double)greatest);
    assert_true(greatest < 1e-4f);
    free(before);
    free(after);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(OuterEdgesAreTheNextRingsInnerEdgesToTheBit),
        cmocka_unit_test(RingsCoverTheirBlocksOnce),
        cmocka_unit_test(VerticesStayWhenTheViewerMoves),
        cmocka_unit_test(VerticesStayWhenTheStackDoubles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
