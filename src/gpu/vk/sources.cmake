# SPDX-License-Identifier: MIT
target_sources(seaway_gpu PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/vk_buffer.c
    ${CMAKE_CURRENT_LIST_DIR}/vk_device.c
    ${CMAKE_CURRENT_LIST_DIR}/vk_features.c
    ${CMAKE_CURRENT_LIST_DIR}/vk_image.c
    ${CMAKE_CURRENT_LIST_DIR}/vk_memory.c
    ${CMAKE_CURRENT_LIST_DIR}/vk_pass.c
    ${CMAKE_CURRENT_LIST_DIR}/vk_pipeline.c
    ${CMAKE_CURRENT_LIST_DIR}/vk_result.c
    ${CMAKE_CURRENT_LIST_DIR}/vk_sets.c
    ${CMAKE_CURRENT_LIST_DIR}/vk_submit.c
    ${CMAKE_CURRENT_LIST_DIR}/vk_upload.c)
