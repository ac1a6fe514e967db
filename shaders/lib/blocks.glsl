// SPDX-License-Identifier: MIT

// Place of thread i of 256 in a square of 16 x 16: 32 threads in a row stand in a block of 8 x 4. Images lie in memory
// in blocks whose smallest pieces are two rows high; threads that write or read one row of sixteen touch halves of
// them.
uvec2 blockPlace(uint i)
{
    return uvec2((i & 7) | ((i >> 2) & 8), ((i >> 3) & 3) | ((i >> 4) & 12));
}
