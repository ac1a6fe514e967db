# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/sample.c
    ${CMAKE_CURRENT_LIST_DIR}/slices.c)
