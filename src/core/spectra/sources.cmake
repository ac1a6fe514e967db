# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/dispersion.c
    ${CMAKE_CURRENT_LIST_DIR}/octave_fit.c
    ${CMAKE_CURRENT_LIST_DIR}/sea_presets.c
    ${CMAKE_CURRENT_LIST_DIR}/sea_state.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_check.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_def.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_elfouhaily.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_formula.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_moments.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_octaves.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum_table.c
    ${CMAKE_CURRENT_LIST_DIR}/spread_models.c
    ${CMAKE_CURRENT_LIST_DIR}/spreading.c)
