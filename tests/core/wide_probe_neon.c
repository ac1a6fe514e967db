// SPDX-License-Identifier: MIT

#include "core/wide_probe.h"

#define SW_WIDE_ISA SW_WIDE_NEON
#include "core/wide_probe.inl"

const WideProbe wideProbeNeon = {SW_ISA_NEON, SW_WIDTH, RunOperations, SinCosTurns, Transpose8, Transform};
