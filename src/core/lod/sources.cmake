# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/slice.c
    ${CMAKE_CURRENT_LIST_DIR}/stack.c)
