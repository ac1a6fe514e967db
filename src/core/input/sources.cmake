# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/raster.c
    ${CMAKE_CURRENT_LIST_DIR}/raster_def.c
    ${CMAKE_CURRENT_LIST_DIR}/spline.c
    ${CMAKE_CURRENT_LIST_DIR}/spline_curve.c
    ${CMAKE_CURRENT_LIST_DIR}/spline_def.c
    ${CMAKE_CURRENT_LIST_DIR}/spline_find.c
    ${CMAKE_CURRENT_LIST_DIR}/spline_words.c)
