// SPDX-License-Identifier: MIT

#include "measure/measure_transform.h"

#include <math.h>

#include "seaway/math.h"

void swFillRoots(int count, swMeasureComplex* roots)
{
    for (int i = 0; i < count / 2; ++i)
    {
        roots[i] = (swMeasureComplex){cos(2.0 * SW_PI * i / count), -sin(2.0 * SW_PI * i / count)};
    }
}

// To the order of reversed bits.
static void reverseBits(swMeasureComplex* data, int count)
{
    for (int i = 1, j = 0; i < count; ++i)
    {
        int bit = count >> 1;
        for (; (j & bit) != 0; bit >>= 1)
        {
            j ^= bit;
        }
        j |= bit;
        if (i < j)
        {
            swMeasureComplex swap = data[i];
            data[i] = data[j];
            data[j] = swap;
        }
    }
}

void swTransformLine(swMeasureComplex* data, int count, const swMeasureComplex* roots)
{
    reverseBits(data, count);
    for (int half = 1; half < count; half *= 2)
    {
        int stride = count / (2 * half);
        for (int first = 0; first < count; first += 2 * half)
        {
            for (int i = 0; i < half; ++i)
            {
                swMeasureComplex root = roots[i * stride];
                swMeasureComplex a = data[first + i], b = data[first + i + half];
                swMeasureComplex turned = {b.re * root.re - b.im * root.im, b.re * root.im + b.im * root.re};
                data[first + i] = (swMeasureComplex){a.re + turned.re, a.im + turned.im};
                data[first + i + half] = (swMeasureComplex){a.re - turned.re, a.im - turned.im};
            }
        }
    }
}

void swTransformSquare(swMeasureComplex* data, int count, const swMeasureComplex* roots, swMeasureComplex* line)
{
    for (int row = 0; row < count; ++row)
    {
        swTransformLine(data + (long)row * count, count, roots);
    }
    for (int column = 0; column < count; ++column)
    {
        for (int row = 0; row < count; ++row)
        {
            line[row] = data[(long)row * count + column];
        }
        swTransformLine(line, count, roots);
        for (int row = 0; row < count; ++row)
        {
            data[(long)row * count + column] = line[row];
        }
    }
}
