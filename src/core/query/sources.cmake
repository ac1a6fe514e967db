# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/answers.c
    ${CMAKE_CURRENT_LIST_DIR}/query_def.c
    ${CMAKE_CURRENT_LIST_DIR}/query_fields.c
    ${CMAKE_CURRENT_LIST_DIR}/query_surface.c
    ${CMAKE_CURRENT_LIST_DIR}/raycast.c
    ${CMAKE_CURRENT_LIST_DIR}/volume.c)
