# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/ramp.c
    ${CMAKE_CURRENT_LIST_DIR}/replay.c
    ${CMAKE_CURRENT_LIST_DIR}/tile_list.c
    ${CMAKE_CURRENT_LIST_DIR}/wave_def.c
    ${CMAKE_CURRENT_LIST_DIR}/wave_hash.c
    ${CMAKE_CURRENT_LIST_DIR}/wave_set.c
    ${CMAKE_CURRENT_LIST_DIR}/wave_system.c
    ${CMAKE_CURRENT_LIST_DIR}/waves.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_save.c
    ${CMAKE_CURRENT_LIST_DIR}/wind_level.c
    ${CMAKE_CURRENT_LIST_DIR}/wind_of_waves.c)

# The FFT's kernels, once per instruction set. AVX2 without its fused multiply-add: results are the same bits everywhere.
# AVX-512 cannot do without it; -ffp-contract=off keeps compilers from using it.
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/mode_mix.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_bins.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_fft.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_gerstner.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_kernels_scalar.c)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    target_sources(seaway_core PRIVATE
        ${CMAKE_CURRENT_LIST_DIR}/waves_kernels_sse2.c
        ${CMAKE_CURRENT_LIST_DIR}/waves_kernels_avx2.c
        ${CMAKE_CURRENT_LIST_DIR}/waves_kernels_avx512.c)
    set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/waves_kernels_avx2.c
        PROPERTIES COMPILE_OPTIONS "-mavx2;-mno-fma")
    set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/waves_kernels_avx512.c
        PROPERTIES COMPILE_OPTIONS "-mavx512f;-mavx512vl;-mavx512dq;-mprefer-vector-width=256")
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
    target_sources(seaway_core PRIVATE ${CMAKE_CURRENT_LIST_DIR}/waves_kernels_neon.c)
endif()
