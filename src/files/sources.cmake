# SPDX-License-Identifier: MIT
# What is read by way of a library: measured seas, rasters and meshes in files. AUTO takes a library if it is there.
target_sources(seaway_scene PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/file_text.c
    ${CMAKE_CURRENT_LIST_DIR}/measured_file.c
    ${CMAKE_CURRENT_LIST_DIR}/mesh_file.c
    ${CMAKE_CURRENT_LIST_DIR}/polygon_ears.c
    ${CMAKE_CURRENT_LIST_DIR}/raster_esri.c
    ${CMAKE_CURRENT_LIST_DIR}/raster_file.c
    ${CMAKE_CURRENT_LIST_DIR}/raster_grid.c
    ${CMAKE_CURRENT_LIST_DIR}/raster_raw.c
    ${CMAKE_CURRENT_LIST_DIR}/raster_ring.c
    ${CMAKE_CURRENT_LIST_DIR}/raster_units.c
    ${CMAKE_CURRENT_LIST_DIR}/raster_write.c
    ${CMAKE_CURRENT_LIST_DIR}/raster_xyz.c)

# sw_add_format(OPTION header library package DEFINE sources...)
function(sw_add_format option header library package define)
    set(${option} AUTO CACHE STRING "Read files by way of ${package}: AUTO, ON or OFF")
    set_property(CACHE ${option} PROPERTY STRINGS AUTO ON OFF)
    if("${${option}}" STREQUAL OFF)
        return()
    endif()
    find_path(${define}_INCLUDE ${header} PATH_SUFFIXES OpenEXR)
    find_library(${define}_LIBRARY ${library})
    if(${define}_INCLUDE AND ${define}_LIBRARY)
        list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/)
        target_sources(seaway_scene PRIVATE ${ARGN})
        target_compile_definitions(seaway_scene PRIVATE ${define}=1)
        target_include_directories(seaway_scene PRIVATE ${${define}_INCLUDE})
        target_link_libraries(seaway_scene PRIVATE ${${define}_LIBRARY})
        set(${define} ON PARENT_SCOPE)
    elseif(NOT "${${option}}" STREQUAL AUTO)
        message(FATAL_ERROR "${option} is ON, but ${header} was not found: install Debian's package ${package}")
    else()
        message(STATUS "${package} was not found: files that need it will not be read")
    endif()
endfunction()
sw_add_format(SW_BUILD_JSON jansson.h jansson libjansson-dev SW_HAS_JSON json_sea.c)
sw_add_format(SW_BUILD_NETCDF netcdf.h netcdf libnetcdf-dev SW_HAS_NETCDF
    netcdf_axes.c
    netcdf_directions.c
    netcdf_file.c
    netcdf_header.c
    netcdf_moments.c
    netcdf_places.c
    netcdf_sea.c
    netcdf_spectra.c
    netcdf_time.c
    raster_gmt.c
    raster_netcdf.c)
sw_add_format(SW_BUILD_PNG png.h png libpng-dev SW_HAS_PNG raster_png.c)
sw_add_format(SW_BUILD_EXR openexr.h OpenEXRCore libopenexr-dev SW_HAS_EXR raster_exr.c)
sw_add_format(SW_BUILD_TIFF tiffio.h tiff libtiff-dev SW_HAS_TIFF raster_tiff.c)
sw_add_format(SW_BUILD_ASSIMP assimp/cimport.h assimp libassimp-dev SW_HAS_ASSIMP)
set(SW_SCENE_PACKAGES)
if(SW_HAS_JSON)
    list(APPEND SW_SCENE_PACKAGES jansson)
endif()
if(SW_HAS_NETCDF)
    list(APPEND SW_SCENE_PACKAGES netcdf)
endif()
if(SW_HAS_PNG)
    list(APPEND SW_SCENE_PACKAGES libpng)
endif()
if(SW_HAS_EXR)
    list(APPEND SW_SCENE_PACKAGES OpenEXR)
endif()
if(SW_HAS_TIFF)
    list(APPEND SW_SCENE_PACKAGES libtiff-4)
endif()
if(SW_HAS_ASSIMP)
    list(APPEND SW_SCENE_PACKAGES assimp)
endif()
