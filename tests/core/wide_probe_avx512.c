// SPDX-License-Identifier: MIT

#include "core/wide_probe.h"

#define SW_WIDE_ISA SW_WIDE_AVX512
#include "core/wide_probe.inl"

const WideProbe wideProbeAvx512 = {SW_ISA_AVX512, SW_WIDTH, RunOperations, SinCosTurns, Transpose8, Transform};
