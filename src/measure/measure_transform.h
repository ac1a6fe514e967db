// SPDX-License-Identifier: MIT
#pragma once

// Fourier transforms for measuring, in double: a program that checks the library's waves does not use the library's
// own.

typedef struct swMeasureComplex
{
    double re, im;
} swMeasureComplex;

// roots[count / 2] of unity for transforms of `count`, a power of two.
void swFillRoots(int count, swMeasureComplex* roots);

// In place: e^(-2 pi i j n / count).
void swTransformLine(swMeasureComplex* data, int count, const swMeasureComplex* roots);

// In place: rows, then columns of data[count][count]; `line` has room for `count`.
void swTransformSquare(swMeasureComplex* data, int count, const swMeasureComplex* roots, swMeasureComplex* line);
