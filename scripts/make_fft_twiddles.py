#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes src/core/math/fft_twiddles.inl: exp(2 pi i n / 512) as floats. Run it from the repository's root.

The result is part of the repository, so that a build never depends on a machine's sine. Angles are taken within an
eighth of a turn, which makes the table exactly symmetric.
"""
import math
import struct
import sys

SIZE = 512


def as_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def cosine(n):
    n %= SIZE
    if n > SIZE // 2:
        n = SIZE - n
    if n > SIZE // 4:
        return -cosine(SIZE // 2 - n)
    if n > SIZE // 8:
        return math.sin(2 * math.pi * (SIZE // 4 - n) / SIZE)
    return math.cos(2 * math.pi * n / SIZE)


def literal(x):
    text = f"{as_float(x) + 0.0:.9g}"
    return text + ("f" if "." in text or "e" in text else ".0f")


def main():
    with open("src/core/math/fft_twiddles.inl", "w", encoding="ascii") as out:
        out.write("// SPDX-License-Identifier: MIT\n")
        out.write("// clang-format off\n")
        out.write("// Written by scripts/make_fft_twiddles.py: the real and imaginary part of exp(2 pi i n / 512).\n")
        for n in range(SIZE):
            out.write(f"{literal(cosine(n))}, {literal(cosine(n - SIZE // 4))},\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
