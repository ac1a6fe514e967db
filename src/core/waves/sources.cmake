# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/measured.c
    ${CMAKE_CURRENT_LIST_DIR}/ndbc.c
    ${CMAKE_CURRENT_LIST_DIR}/slices.c
    ${CMAKE_CURRENT_LIST_DIR}/spectrum.c
    ${CMAKE_CURRENT_LIST_DIR}/spreading.c)
