// SPDX-License-Identifier: MIT
#pragma once

// Fourier transforms for measuring, in double: a program that checks the library's waves does not use the library's
// own.

typedef struct SeaComplex
{
    double re, im;
} SeaComplex;

// roots[count / 2] of unity for transforms of `count`, a power of two.
void FillRoots(int count, SeaComplex* roots);

// In place: e^(-2 pi i j n / count).
void TransformLine(SeaComplex* data, int count, const SeaComplex* roots);

// In place: rows, then columns of data[count][count]; `line` has room for `count`.
void TransformSquare(SeaComplex* data, int count, const SeaComplex* roots, SeaComplex* line);
