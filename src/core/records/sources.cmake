# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/direction_grid.c
    ${CMAKE_CURRENT_LIST_DIR}/measured.c
    ${CMAKE_CURRENT_LIST_DIR}/measured_def.c
    ${CMAKE_CURRENT_LIST_DIR}/measured_find.c
    ${CMAKE_CURRENT_LIST_DIR}/sea_places.c
    ${CMAKE_CURRENT_LIST_DIR}/summary_shape.c)
