# SPDX-License-Identifier: MIT
target_sources(${core} PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/ink.c
    ${CMAKE_CURRENT_LIST_DIR}/wetness.c
    ${CMAKE_CURRENT_LIST_DIR}/wetness_def.c)
