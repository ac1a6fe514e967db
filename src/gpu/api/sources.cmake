# SPDX-License-Identifier: MIT
target_sources(seaway_gpu PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/gpu_api.c
    ${CMAKE_CURRENT_LIST_DIR}/gpu_def.c
    ${CMAKE_CURRENT_LIST_DIR}/gpu_query_api.c
    ${CMAKE_CURRENT_LIST_DIR}/layers_api.c)
