# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/awac.c
    ${CMAKE_CURRENT_LIST_DIR}/dispersion.c
    ${CMAKE_CURRENT_LIST_DIR}/datawell.c
    ${CMAKE_CURRENT_LIST_DIR}/direction_grid.c
    ${CMAKE_CURRENT_LIST_DIR}/measured.c
    ${CMAKE_CURRENT_LIST_DIR}/measured_def.c
    ${CMAKE_CURRENT_LIST_DIR}/measured_find.c
    ${CMAKE_CURRENT_LIST_DIR}/measured_text.c
    ${CMAKE_CURRENT_LIST_DIR}/ndbc.c
    ${CMAKE_CURRENT_LIST_DIR}/ndbc_sea.c
    ${CMAKE_CURRENT_LIST_DIR}/obscape.c
    ${CMAKE_CURRENT_LIST_DIR}/octopus.c
    ${CMAKE_CURRENT_LIST_DIR}/partition_sea.c
    ${CMAKE_CURRENT_LIST_DIR}/partition_text.c
    ${CMAKE_CURRENT_LIST_DIR}/sea_places.c
    ${CMAKE_CURRENT_LIST_DIR}/sea_presets.c
    ${CMAKE_CURRENT_LIST_DIR}/sea_text.c
    ${CMAKE_CURRENT_LIST_DIR}/slices.c
    ${CMAKE_CURRENT_LIST_DIR}/sea_state.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_check.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_elfouhaily.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_formula.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_octaves.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_table.c
    ${CMAKE_CURRENT_LIST_DIR}/spread_models.c
    ${CMAKE_CURRENT_LIST_DIR}/spreading.c
    ${CMAKE_CURRENT_LIST_DIR}/spotter_csv.c
    ${CMAKE_CURRENT_LIST_DIR}/summary.c
    ${CMAKE_CURRENT_LIST_DIR}/summary_sea.c
    ${CMAKE_CURRENT_LIST_DIR}/summary_shape.c
    ${CMAKE_CURRENT_LIST_DIR}/swan.c
    ${CMAKE_CURRENT_LIST_DIR}/triaxys.c
    ${CMAKE_CURRENT_LIST_DIR}/wavewatch.c
    ${CMAKE_CURRENT_LIST_DIR}/wind_level.c)

# The FFT's kernels, once per instruction set. AVX2 without its fused multiply-add: results are the same bits everywhere.
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/mode_mix.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_bins.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_fft.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_gerstner.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_kernels_scalar.c)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    target_sources(seaway_core PRIVATE
        ${CMAKE_CURRENT_LIST_DIR}/waves_kernels_sse2.c
        ${CMAKE_CURRENT_LIST_DIR}/waves_kernels_avx2.c)
    set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/waves_kernels_avx2.c
        PROPERTIES COMPILE_OPTIONS "-mavx2;-mno-fma")
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
    target_sources(seaway_core PRIVATE ${CMAKE_CURRENT_LIST_DIR}/waves_kernels_neon.c)
endif()
