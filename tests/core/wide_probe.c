// SPDX-License-Identifier: MIT

#include "core/wide_probe.h"

int ListWideProbes(const WideProbe** probes)
{
    int count = 0;
    probes[count++] = &wideProbeScalar;
#if defined(__x86_64__)
    probes[count++] = &wideProbeSse2;
    if (__builtin_cpu_supports("avx2"))
    {
        probes[count++] = &wideProbeAvx2;
    }
#elif defined(__aarch64__)
    probes[count++] = &wideProbeNeon;
#endif
    return count;
}
