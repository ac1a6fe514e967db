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
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
    {
        probes[count++] = &wideProbeAvx512;
    }
#elif defined(__aarch64__)
    probes[count++] = &wideProbeNeon;
#endif
    return count;
}
