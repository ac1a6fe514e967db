# SPDX-License-Identifier: MIT
target_sources(seaway_gpu PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/gpu_query.c
    ${CMAKE_CURRENT_LIST_DIR}/gpu_query_water.c)
