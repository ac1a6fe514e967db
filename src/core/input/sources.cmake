# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/hull.c
    ${CMAKE_CURRENT_LIST_DIR}/hull_def.c
    ${CMAKE_CURRENT_LIST_DIR}/hull_grid.c
    ${CMAKE_CURRENT_LIST_DIR}/input_arrays.c
    ${CMAKE_CURRENT_LIST_DIR}/input_def.c
    ${CMAKE_CURRENT_LIST_DIR}/input_index.c
    ${CMAKE_CURRENT_LIST_DIR}/input_record.c
    ${CMAKE_CURRENT_LIST_DIR}/inputs.c
    ${CMAKE_CURRENT_LIST_DIR}/inputs_save.c
    ${CMAKE_CURRENT_LIST_DIR}/polygon.c
    ${CMAKE_CURRENT_LIST_DIR}/raster.c
    ${CMAKE_CURRENT_LIST_DIR}/raster_def.c
    ${CMAKE_CURRENT_LIST_DIR}/sample_clip.c
    ${CMAKE_CURRENT_LIST_DIR}/spline.c
    ${CMAKE_CURRENT_LIST_DIR}/spline_curve.c
    ${CMAKE_CURRENT_LIST_DIR}/spline_def.c
    ${CMAKE_CURRENT_LIST_DIR}/spline_find.c
    ${CMAKE_CURRENT_LIST_DIR}/spline_words.c
    ${CMAKE_CURRENT_LIST_DIR}/sample_inputs.c
    ${CMAKE_CURRENT_LIST_DIR}/water_bodies.c
    ${CMAKE_CURRENT_LIST_DIR}/water_body_def.c
    ${CMAKE_CURRENT_LIST_DIR}/wind.c
    ${CMAKE_CURRENT_LIST_DIR}/wind_def.c)
