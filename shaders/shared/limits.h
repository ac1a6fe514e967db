// SPDX-License-Identifier: MIT
// Sizes that both halves and all shaders agree on.
#ifndef SW_SHARED_LIMITS_H
#define SW_SHARED_LIMITS_H
#define SW_LIMIT_TILES 64
#define SW_LIMIT_SLICES 15
#define SW_LIMIT_FREE_WAVES 1024
#define SW_LIMIT_RESOLUTION 512

// Roots of unity that the FFT's table holds.
#define SW_TWIDDLES 512

// Columns that one workgroup of the FFT's second axis transforms, see waves_columns.comp.
#define SW_COLUMN_BLOCK 4

// Texels of a slice that one workgroup makes: a thread owns a column of SW_SLICE_RUNS runs of SW_SLICE_RUN (4) texels
// along z. See slices.comp.
#define SW_SLICE_WIDTH 128
#define SW_SLICE_RUN 4
#define SW_SLICE_RUNS 2
#define SW_SLICE_HEIGHT 8
// Tiles that are laid out in shared memory at once (at most 32, the bits of a mask), tile rows that a run may touch,
// tile columns that a block may touch (laid out by a thread a row), and the vec4s that a tile takes: 2 a run and row,
// or 3 a column.
#define SW_SLICE_BATCH 16
#define SW_SLICE_ROWS 6
#define SW_SLICE_COLUMNS SW_SLICE_HEIGHT
#define SW_SLICE_LAYOUT 24

// Side of the block of detail texels that one workgroup makes and averages down to one.
#define SW_DETAIL_BLOCK 32
#define SW_DETAIL_MIPS 6

// Side of a foam workgroup.
#define SW_FOAM_BLOCK 16
#endif
