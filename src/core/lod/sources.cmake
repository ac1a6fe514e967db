# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/layer_clock.c
    ${CMAKE_CURRENT_LIST_DIR}/layer_stack.c
    ${CMAKE_CURRENT_LIST_DIR}/redraw.c
    ${CMAKE_CURRENT_LIST_DIR}/scroll.c
    ${CMAKE_CURRENT_LIST_DIR}/slice.c
    ${CMAKE_CURRENT_LIST_DIR}/stack.c)
