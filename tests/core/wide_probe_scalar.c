// SPDX-License-Identifier: MIT

#include "core/wide_probe.h"

#define SW_WIDE_ISA SW_WIDE_SCALAR
#include "core/wide_probe.inl"

const WideProbe wideProbeScalar = {SW_ISA_SCALAR, SW_WIDTH, RunOperations, SinCosTurns, Transpose8, Transform};
