# SPDX-License-Identifier: MIT
target_sources(seaway_gpu PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/foam_texture.c
    ${CMAKE_CURRENT_LIST_DIR}/look_def.c
    ${CMAKE_CURRENT_LIST_DIR}/mesh_rings.c
    ${CMAKE_CURRENT_LIST_DIR}/picture.c
    ${CMAKE_CURRENT_LIST_DIR}/renderer.c
    ${CMAKE_CURRENT_LIST_DIR}/sky.c
    ${CMAKE_CURRENT_LIST_DIR}/surface.c
    ${CMAKE_CURRENT_LIST_DIR}/tonemap.c
    ${CMAKE_CURRENT_LIST_DIR}/../api/draw_api.c)
list(APPEND SW_SHADERS
    sky/sky_transmittance.comp
    sky/sky_multiple.comp
    sky/sky_view.comp
    sky/sky_air.comp
    sky/sky_light.comp
    sky/sky_map.comp
    sky/fullscreen.vert+sky/sky.frag
    surface/surface_cull.comp
    surface/surface.vert+surface/surface.frag
    post/halve.comp
    post/expose.comp
    sky/fullscreen.vert+post/tonemap.frag)

# The foam's texture is made by a program of ours, while building.
add_executable(seaway_foam_texture ${PROJECT_SOURCE_DIR}/generators/foam_texture.c)
set_target_properties(seaway_foam_texture PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/generators)
target_compile_options(seaway_foam_texture PRIVATE ${SW_WARNINGS} ${SW_WARNINGS_C} -ffp-contract=off)
target_link_libraries(seaway_foam_texture PRIVATE m)
set(SW_FOAM_TEXTURE ${CMAKE_CURRENT_BINARY_DIR}/generated/foam_texture.inc)
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/generated)
add_custom_command(OUTPUT ${SW_FOAM_TEXTURE}
    COMMAND seaway_foam_texture ${SW_FOAM_TEXTURE}
    DEPENDS seaway_foam_texture
    COMMENT "Texture of foam" VERBATIM)
add_custom_target(seaway_generated DEPENDS ${SW_FOAM_TEXTURE})
add_dependencies(seaway_gpu seaway_generated)
target_include_directories(seaway_gpu PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
