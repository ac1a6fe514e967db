# SPDX-License-Identifier: MIT
target_sources(seaway_gpu PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/gpu_inputs.c
    ${CMAKE_CURRENT_LIST_DIR}/gpu_tiles.c
    ${CMAKE_CURRENT_LIST_DIR}/hazards.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_detail.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_fields.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_foam.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_made_foam.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_ray_query.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_slices.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_slices_shaped.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_surface_query.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_volume_query.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_volume_waves.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_waves_columns.c
    ${CMAKE_CURRENT_LIST_DIR}/pass_waves_rows.c
    ${CMAKE_CURRENT_LIST_DIR}/passes.c
    ${CMAKE_CURRENT_LIST_DIR}/query_passes.c)
list(APPEND SW_SHADERS
    waves/waves_rows.comp
    waves/waves_columns.comp
    waves/detail.comp
    input/fields.comp
    waves/slices.comp
    waves/slices_shaped.comp
    sim/foam.comp
    sim/made_foam.comp
    query/surface_query.comp
    query/volume_waves.comp
    query/volume_query.comp
    query/ray_query.comp)
