# SPDX-License-Identifier: MIT
target_sources(seaway_scene PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/exact_number.c
    ${CMAKE_CURRENT_LIST_DIR}/field_tree.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_bodies.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_check.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_components.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_fields.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_hulls.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_inputs.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_lists.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_measured.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_octaves.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_read.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_resources.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_source.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_tide.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_tree.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_waves.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_wind_seas.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_world.c
    ${CMAKE_CURRENT_LIST_DIR}/scene_write.c
    ${CMAKE_CURRENT_LIST_DIR}/waves_tree.c
    ${CMAKE_CURRENT_LIST_DIR}/yaml_edit.c
    ${CMAKE_CURRENT_LIST_DIR}/yaml_merge.c
    ${CMAKE_CURRENT_LIST_DIR}/yaml_places.c
    ${CMAKE_CURRENT_LIST_DIR}/yaml_read.c
    ${CMAKE_CURRENT_LIST_DIR}/yaml_tree.c)
