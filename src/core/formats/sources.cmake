# SPDX-License-Identifier: MIT
target_sources(seaway_core PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/awac.c
    ${CMAKE_CURRENT_LIST_DIR}/datawell.c
    ${CMAKE_CURRENT_LIST_DIR}/measured_text.c
    ${CMAKE_CURRENT_LIST_DIR}/ndbc.c
    ${CMAKE_CURRENT_LIST_DIR}/ndbc_rows.c
    ${CMAKE_CURRENT_LIST_DIR}/ndbc_sea.c
    ${CMAKE_CURRENT_LIST_DIR}/obscape.c
    ${CMAKE_CURRENT_LIST_DIR}/octopus.c
    ${CMAKE_CURRENT_LIST_DIR}/partition_sea.c
    ${CMAKE_CURRENT_LIST_DIR}/partition_text.c
    ${CMAKE_CURRENT_LIST_DIR}/run_reader.c
    ${CMAKE_CURRENT_LIST_DIR}/spotter_csv.c
    ${CMAKE_CURRENT_LIST_DIR}/summary.c
    ${CMAKE_CURRENT_LIST_DIR}/summary_sea.c
    ${CMAKE_CURRENT_LIST_DIR}/swan.c
    ${CMAKE_CURRENT_LIST_DIR}/triaxys.c
    ${CMAKE_CURRENT_LIST_DIR}/wavewatch.c)
