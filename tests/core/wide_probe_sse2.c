// SPDX-License-Identifier: MIT

#include "core/wide_probe.h"

#define SW_WIDE_ISA SW_WIDE_SSE2
#include "core/wide_probe.inl"

const WideProbe wideProbeSse2 = {SW_ISA_SSE2, SW_WIDTH, RunOperations, SinCosTurns, Transpose8, Transform};
