# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/carry.c
    ${CMAKE_CURRENT_LIST_DIR}/displace.c
    ${CMAKE_CURRENT_LIST_DIR}/evaluate.c
    ${CMAKE_CURRENT_LIST_DIR}/evaluate_shaped.c
    ${CMAKE_CURRENT_LIST_DIR}/field_layers.c
    ${CMAKE_CURRENT_LIST_DIR}/input_places.c
    ${CMAKE_CURRENT_LIST_DIR}/made_foam.c
    ${CMAKE_CURRENT_LIST_DIR}/places.c
    ${CMAKE_CURRENT_LIST_DIR}/search.c
    ${CMAKE_CURRENT_LIST_DIR}/slices.c)
