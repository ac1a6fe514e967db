// SPDX-License-Identifier: MIT
// Sizes that both halves and all shaders agree on.
#ifndef SW_SHARED_LIMITS_H
#define SW_SHARED_LIMITS_H
#define SW_LIMIT_TILES 128
#define SW_LIMIT_SYSTEMS 32
#define SW_LIMIT_SLICES 15
#define SW_LIMIT_FREE_WAVES 1024
#define SW_LIMIT_RESOLUTION 512

// Roots of unity that the FFT's table holds.
#define SW_TWIDDLES 512

// Columns that one workgroup of the FFT's second axis transforms, see waves_columns.comp.
#define SW_COLUMN_BLOCK 4

// Texels of a slice that one workgroup makes: a thread owns a column of SW_SLICE_HEIGHT texels along z. See
// slices.comp.
#define SW_SLICE_WIDTH 128
#define SW_SLICE_HEIGHT 16
// Tiles that are added as cubics (at most 32, the bits of a mask); columns of them that are laid out in shared memory
// at once, and knots of columns.
#define SW_SLICE_TILES 24
#define SW_SLICE_COLUMNS 180
#define SW_SLICE_JUMPS 960
// Spline units a texel of such a tile, at most.
#define SW_SLICE_STEP 0.75f

// Rows of such a block that a workgroup of slices_shaped.comp makes; a divisor of its height.
#define SW_SHAPED_ROWS 4
// Tiles that it looks at together, and columns of them that it lays out in shared memory at once.
#define SW_SHAPED_TILES 32
#define SW_SHAPED_COLUMNS 176

// Side of the block of detail texels that one workgroup makes and averages down to one.
#define SW_DETAIL_BLOCK 32
#define SW_DETAIL_MIPS 6

// Side of a foam workgroup.
#define SW_FOAM_BLOCK 16
#endif
