# SPDX-License-Identifier: MIT
# What a host links: static or shared libraries, headers, a CMake package with one component per library, pkg-config
# files; and the program, its man page, manuals, examples and scenes. Included after every target exists.

include(CMakePackageConfigHelpers)
set(SW_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/seaway)

# A library of ours as a product: hidden symbols, a soname, an exported target seaway::<component>, and its .pc file.
#   DESCRIPTION  one sentence           REQUIRES  our libraries that it needs, by pkg-config name
#   PACKAGES     others' pkg-config names that a static library leaves to its user
#   LIBRARIES    linker flags likewise
function(sw_install_library component)
    cmake_parse_arguments(arg "" "DESCRIPTION" "REQUIRES;PACKAGES;LIBRARIES" ${ARGN})
    set(target seaway_${component})
    set_target_properties(${target} PROPERTIES
        OUTPUT_NAME seaway-${component} EXPORT_NAME ${component} C_VISIBILITY_PRESET hidden
        INSTALL_RPATH "$ORIGIN" VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    set(SW_PC_DEFINES)
    if(BUILD_SHARED_LIBS)
        target_compile_definitions(${target} PUBLIC SEAWAY_SHARED PRIVATE SEAWAY_EXPORTS)
        set(SW_PC_DEFINES " -DSEAWAY_SHARED")
    endif()
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    if(NOT SW_INSTALL)
        return()
    endif()
    install(TARGETS ${target} EXPORT seaway-${component}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    install(EXPORT seaway-${component} NAMESPACE seaway:: FILE seaway-${component}-targets.cmake
        DESTINATION ${SW_PACKAGE_DIR})

    file(RELATIVE_PATH SW_PC_UP /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
    set(SW_PC_NAME seaway-${component})
    set(SW_PC_DESCRIPTION "${arg_DESCRIPTION}")
    string(REPLACE ";" ", " SW_PC_REQUIRES "${arg_REQUIRES}")
    string(REPLACE ";" " " SW_PC_LIBRARIES "${arg_LIBRARIES}")
    if(BUILD_SHARED_LIBS)
        set(SW_PC_LIBRARIES)
    elseif(arg_PACKAGES)
        string(JOIN ", " SW_PC_REQUIRES ${arg_REQUIRES} ${arg_PACKAGES})
    endif()
    configure_file(${PROJECT_SOURCE_DIR}/cmake/seaway.pc.in ${PROJECT_BINARY_DIR}/seaway-${component}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/seaway-${component}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

sw_install_library(core DESCRIPTION "Ocean waves on the CPU: the surface, and queries of it" LIBRARIES -pthread -lm)
sw_install_library(measure DESCRIPTION "Sea states and spectra measured on a sea" REQUIRES seaway-core LIBRARIES -lm)
set(SW_COMPONENTS core measure)
if(TARGET seaway_gpu)
    sw_install_library(gpu DESCRIPTION "The same waves on Vulkan 1.3, and the picture" REQUIRES seaway-core
        LIBRARIES -ldl -lm)
    list(APPEND SW_COMPONENTS gpu)
endif()
if(TARGET seaway_stage)
    sw_install_library(stage DESCRIPTION "A device without a window, for tools and tests of Seaway" REQUIRES seaway-gpu
        LIBRARIES -ldl)
    list(APPEND SW_COMPONENTS stage)
endif()
if(TARGET seaway_scene)
    sw_install_library(scene DESCRIPTION "Scene files and measured spectra for Seaway" REQUIRES seaway-gpu
        PACKAGES yaml-0.1 zlib ${SW_SCENE_PACKAGES} LIBRARIES -lm)
    list(APPEND SW_COMPONENTS scene)
endif()
if(NOT SW_INSTALL)
    return()
endif()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/seaway DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# GLSL for hosts' own shaders: the layers of a view, and what the water's own shaders are put together from.
set(SW_SHADER_INSTALL_DIR ${CMAKE_INSTALL_DATADIR}/seaway/shaders)
if(TARGET seaway_gpu)
    foreach(folder IN ITEMS seaway shared lib)
        install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders/${folder} DESTINATION ${SW_SHADER_INSTALL_DIR})
    endforeach()
endif()
if(BUILD_SHARED_LIBS)
    set(SW_IS_SHARED ON)
else()
    set(SW_IS_SHARED OFF)
endif()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/seaway-config.cmake.in
    ${PROJECT_BINARY_DIR}/seaway-config.cmake INSTALL_DESTINATION ${SW_PACKAGE_DIR}
    PATH_VARS SW_SHADER_INSTALL_DIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/seaway-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/seaway-config.cmake ${PROJECT_BINARY_DIR}/seaway-config-version.cmake
    DESTINATION ${SW_PACKAGE_DIR})
if(TARGET seaway)
    set_target_properties(seaway PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
    install(TARGETS seaway RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/seaway)

# Manuals keep the folders that their links go by; examples are sources.
foreach(file IN ITEMS LICENSE CHANGELOG.md CONTRIBUTING.md README.md)
    install(FILES ${PROJECT_SOURCE_DIR}/${file} DESTINATION ${CMAKE_INSTALL_DOCDIR})
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.c"
    PATTERN "*.comp")

# The program writes its own man page, where it can be run and there is a shell.
find_program(SW_BASH bash)
if(TARGET seaway AND SW_BASH AND NOT CMAKE_CROSSCOMPILING)
    set(page ${PROJECT_BINARY_DIR}/seaway.1)
    add_custom_command(OUTPUT ${page}
        COMMAND ${SW_BASH} ${PROJECT_SOURCE_DIR}/scripts/make_man $<TARGET_FILE:seaway> ${page}
            ${CMAKE_INSTALL_FULL_DATADIR}/seaway ${CMAKE_INSTALL_FULL_DOCDIR}
        DEPENDS seaway ${PROJECT_SOURCE_DIR}/scripts/make_man
        COMMENT "Man page seaway.1" VERBATIM)
    add_custom_target(seaway_man ALL DEPENDS ${page})
    install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
