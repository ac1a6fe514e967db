# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/foam.c
    ${CMAKE_CURRENT_LIST_DIR}/foam_def.c
    ${CMAKE_CURRENT_LIST_DIR}/whitecaps.c)
