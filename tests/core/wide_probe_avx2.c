// SPDX-License-Identifier: MIT

#include "core/wide_probe.h"

#define SW_WIDE_ISA SW_WIDE_AVX2
#include "core/wide_probe.inl"

const WideProbe wideProbeAvx2 = {SW_ISA_AVX2, SW_WIDTH, RunOperations, SinCosTurns, Transpose8, Transform};
