// SPDX-License-Identifier: MIT
// One axis of an inverse transform, y[n] = sum over k of x[k] exp(+2 pi i k n / N), for N = 16 to 512, by N / 4 threads
// that hold four values each: Stockham's self-sorting form, radix 4 with a last radix 2 where N is no power of four
// [Van Loan 1992]. Between stages the values change places in shared memory.
//
// Before including: `shared vec2 fftLine[]`, `vec2 fftRoot(uint index)` (root `index` of SW_TWIDDLES), and the constant
// FFT_SIZE.

vec2 complexMultiply(vec2 a, vec2 b)
{
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

vec2 timesI(vec2 a)
{
    return vec2(-a.y, a.x);
}

void fftRadix4(inout vec2 v[4])
{
    vec2 evenSum = v[0] + v[2];
    vec2 evenDifference = v[0] - v[2];
    vec2 oddSum = v[1] + v[3];
    vec2 oddDifference = timesI(v[1] - v[3]);
    v[0] = evenSum + oddSum;
    v[1] = evenDifference + oddDifference;
    v[2] = evenSum - oddSum;
    v[3] = evenDifference - oddDifference;
}

// Thread i holds elements i + k N / 4, k = 0 .. 3, before and after. `line` is where this transform's N places begin.
// All threads of the workgroup call it together.
void fftTransform(uint line, uint i, inout vec2 v[4])
{
    const uint QUARTER = FFT_SIZE / 4;
    uint stride = 1;
    for (uint size = FFT_SIZE; size >= 4; size /= 4)
    {
        fftRadix4(v);
        if (size == 4)
        {
            return;
        }
        uint q = i & (stride - 1);
        vec2 w1 = fftRoot((i - q) * (SW_TWIDDLES / FFT_SIZE));
        vec2 w2 = complexMultiply(w1, w1);
        v[1] = complexMultiply(v[1], w1);
        v[2] = complexMultiply(v[2], w2);
        v[3] = complexMultiply(v[3], complexMultiply(w1, w2));
        barrier(); // others may still read what they hold from the stage before
        uint to = line + 4 * i - 3 * q;
        for (uint k = 0; k < 4; ++k)
        {
            fftLine[to + k * stride] = v[k];
        }
        barrier();
        for (uint k = 0; k < 4; ++k)
        {
            v[k] = fftLine[line + i + k * QUARTER];
        }
        stride *= 4;
    }
    // N = 2 * 4^n: pairs half a line apart remain.
    vec2 a = v[0], b = v[1];
    v[0] = a + v[2];
    v[2] = a - v[2];
    v[1] = b + v[3];
    v[3] = b - v[3];
}
