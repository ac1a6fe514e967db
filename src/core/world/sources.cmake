# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/digest.c
    ${CMAKE_CURRENT_LIST_DIR}/replay.c
    ${CMAKE_CURRENT_LIST_DIR}/save.c
    ${CMAKE_CURRENT_LIST_DIR}/step.c
    ${CMAKE_CURRENT_LIST_DIR}/system.c
    ${CMAKE_CURRENT_LIST_DIR}/tile_list.c
    ${CMAKE_CURRENT_LIST_DIR}/view.c
    ${CMAKE_CURRENT_LIST_DIR}/wave_set.c
    ${CMAKE_CURRENT_LIST_DIR}/world.c
    ${CMAKE_CURRENT_LIST_DIR}/world_fields.c)
