# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/digest.c
    ${CMAKE_CURRENT_LIST_DIR}/layer_makers.c
    ${CMAKE_CURRENT_LIST_DIR}/moment.c
    ${CMAKE_CURRENT_LIST_DIR}/moment_inputs.c
    ${CMAKE_CURRENT_LIST_DIR}/save.c
    ${CMAKE_CURRENT_LIST_DIR}/step.c
    ${CMAKE_CURRENT_LIST_DIR}/view.c
    ${CMAKE_CURRENT_LIST_DIR}/view_def.c
    ${CMAKE_CURRENT_LIST_DIR}/view_save.c
    ${CMAKE_CURRENT_LIST_DIR}/world.c
    ${CMAKE_CURRENT_LIST_DIR}/world_def.c
    ${CMAKE_CURRENT_LIST_DIR}/world_wind.c
    ${CMAKE_CURRENT_LIST_DIR}/zone.c
    ${CMAKE_CURRENT_LIST_DIR}/zone_save.c)
