# SPDX-License-Identifier: MIT
target_sources(seaway_gpu PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/record.c
    ${CMAKE_CURRENT_LIST_DIR}/upload_frame.c
    ${CMAKE_CURRENT_LIST_DIR}/upload_tiles.c)
