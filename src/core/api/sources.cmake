# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/bake_api.c
    ${CMAKE_CURRENT_LIST_DIR}/input_api.c
    ${CMAKE_CURRENT_LIST_DIR}/moment_api.c
    ${CMAKE_CURRENT_LIST_DIR}/nest_api.c
    ${CMAKE_CURRENT_LIST_DIR}/query_api.c
    ${CMAKE_CURRENT_LIST_DIR}/replay_api.c
    ${CMAKE_CURRENT_LIST_DIR}/view_api.c
    ${CMAKE_CURRENT_LIST_DIR}/save_api.c
    ${CMAKE_CURRENT_LIST_DIR}/sea_api.c
    ${CMAKE_CURRENT_LIST_DIR}/water_body_api.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_api.c
    ${CMAKE_CURRENT_LIST_DIR}/wind_api.c
    ${CMAKE_CURRENT_LIST_DIR}/wind_sea_api.c
    ${CMAKE_CURRENT_LIST_DIR}/world_api.c)
