// SPDX-License-Identifier: MIT

#include "sea_transform.h"

#include <math.h>

#include "seaway/math.h"

void FillRoots(int count, SeaComplex* roots)
{
    for (int i = 0; i < count / 2; ++i)
    {
        roots[i] = (SeaComplex){cos(2.0 * SW_PI * i / count), -sin(2.0 * SW_PI * i / count)};
    }
}

// To the order of reversed bits.
static void ReverseBits(SeaComplex* data, int count)
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
            SeaComplex swap = data[i];
            data[i] = data[j];
            data[j] = swap;
        }
    }
}

void TransformLine(SeaComplex* data, int count, const SeaComplex* roots)
{
    ReverseBits(data, count);
    for (int half = 1; half < count; half *= 2)
    {
        int stride = count / (2 * half);
        for (int first = 0; first < count; first += 2 * half)
        {
            for (int i = 0; i < half; ++i)
            {
                SeaComplex root = roots[i * stride];
                SeaComplex a = data[first + i], b = data[first + i + half];
                SeaComplex turned = {b.re * root.re - b.im * root.im, b.re * root.im + b.im * root.re};
                data[first + i] = (SeaComplex){a.re + turned.re, a.im + turned.im};
                data[first + i + half] = (SeaComplex){a.re - turned.re, a.im - turned.im};
            }
        }
    }
}

void TransformSquare(SeaComplex* data, int count, const SeaComplex* roots, SeaComplex* line)
{
    for (int row = 0; row < count; ++row)
    {
        TransformLine(data + (long)row * count, count, roots);
    }
    for (int column = 0; column < count; ++column)
    {
        for (int row = 0; row < count; ++row)
        {
            line[row] = data[(long)row * count + column];
        }
        TransformLine(line, count, roots);
        for (int row = 0; row < count; ++row)
        {
            data[(long)row * count + column] = line[row];
        }
    }
}
