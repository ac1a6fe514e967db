// SPDX-License-Identifier: MIT

// Blocks of texels that workgroups make.
#include "shared/limits.h"

// Place of thread i of 256 in a square of 16 x 16: 32 threads in a row stand in a block of 8 x 4. Images lie in memory
// in blocks whose smallest pieces are two rows high; threads that write or read one row of sixteen touch halves of
// them.
uvec2 blockPlace(uint i)
{
    return uvec2((i & 7) | ((i >> 2) & 8), ((i >> 3) & 3) | ((i >> 4) & 12));
}

// Which of the blocks that the pass of fields tells of holds a workgroup's square; of a slice of so many texels a side.
uint fieldBlockOf(uvec3 group, uint resolution)
{
    uint columns = (resolution + SW_SLICE_WIDTH - 1) / SW_SLICE_WIDTH;
    uint row = group.y * SW_FOAM_BLOCK / SW_SLICE_HEIGHT;
    return (group.z * (resolution / SW_SLICE_HEIGHT) + row) * columns + group.x * SW_FOAM_BLOCK / SW_SLICE_WIDTH;
}
