# SPDX-License-Identifier: MIT
target_sources(seaway_gpu PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/core_layers.c
    ${CMAKE_CURRENT_LIST_DIR}/gpu_view.c
    ${CMAKE_CURRENT_LIST_DIR}/layer_set.c
    ${CMAKE_CURRENT_LIST_DIR}/read_layer.c)
