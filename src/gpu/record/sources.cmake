# SPDX-License-Identifier: MIT
target_sources(seaway_gpu PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/gpu_query.c
    ${CMAKE_CURRENT_LIST_DIR}/gpu_query_water.c
    ${CMAKE_CURRENT_LIST_DIR}/read_layer.c
    ${CMAKE_CURRENT_LIST_DIR}/record.c
    ${CMAKE_CURRENT_LIST_DIR}/upload_core.c
    ${CMAKE_CURRENT_LIST_DIR}/upload_frame.c
    ${CMAKE_CURRENT_LIST_DIR}/upload_tiles.c)
