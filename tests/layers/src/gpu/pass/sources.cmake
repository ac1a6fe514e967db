# SPDX-License-Identifier: MIT
target_sources(${gpu} PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/pass_wetness.c)
list(APPEND SW_SHADERS
    ${CMAKE_CURRENT_SOURCE_DIR}/shaders/sim/wetness.comp)
