# SPDX-License-Identifier: MIT
# Warnings, sanitizers and the GLSL-to-header step that every target of ours shares.

set(SW_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wundef -Wvla -Wdouble-promotion)
set(SW_WARNINGS_C -Wmissing-prototypes -Wstrict-prototypes)
set(SW_SANITIZE "" CACHE STRING "Sanitizers, e.g. address,undefined or thread")

# Compile options of every target of ours. No contraction: results are the same bits everywhere.
function(sw_setup_target target)
    target_compile_options(${target} PRIVATE ${SW_WARNINGS} $<$<COMPILE_LANGUAGE:C>:${SW_WARNINGS_C}>
        -ffp-contract=off -fno-math-errno -fno-trapping-math)
    if(SW_WERROR)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
    if(SW_VALIDATE)
        target_compile_definitions(${target} PRIVATE SW_VALIDATE=1)
    endif()
    if(SW_SANITIZE)
        target_compile_options(${target} PRIVATE -fsanitize=${SW_SANITIZE} -fno-omit-frame-pointer)
        target_link_options(${target} PUBLIC -fsanitize=${SW_SANITIZE})
    endif()
endfunction()

# Compile GLSL files to SPIR-V as C initializers, shaders/<dir>/<name>.<stage> to <build>/spirv/<name>.<stage>.inc,
# and add the folder to the target's includes.
function(sw_embed_shaders target)
    find_program(SW_GLSLC glslc)
    if(NOT SW_GLSLC)
        message(FATAL_ERROR "glslc was not found: run scripts/setup, or install Debian's package glslc")
    endif()
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/spirv)
    file(MAKE_DIRECTORY ${folder})
    set(outputs)
    foreach(shader IN LISTS ARGN)
        get_filename_component(name ${shader} NAME)
        set(output ${folder}/${name}.inc)
        add_custom_command(OUTPUT ${output}
            COMMAND ${SW_GLSLC} --target-env=vulkan1.3 -O -mfmt=c -I ${PROJECT_SOURCE_DIR}/shaders
                -MD -MF ${output}.d -MT ${output} -o ${output} ${PROJECT_SOURCE_DIR}/shaders/${shader}
            DEPENDS ${PROJECT_SOURCE_DIR}/shaders/${shader}
            DEPFILE ${output}.d
            COMMENT "GLSL ${shader}" VERBATIM)
        list(APPEND outputs ${output})
    endforeach()
    add_custom_target(${target}_shaders DEPENDS ${outputs})
    add_dependencies(${target} ${target}_shaders)
    target_include_directories(${target} PRIVATE ${folder})
endfunction()

# A cmocka test program and its CTest entry. Extra arguments: libraries.
function(sw_add_test name source)
    add_executable(${name} ${source})
    sw_setup_target(${name})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/shaders
        ${PROJECT_SOURCE_DIR}/tests)
    target_compile_definitions(${name} PRIVATE SW_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_link_libraries(${name} PRIVATE ${ARGN} cmocka)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES TIMEOUT 600)
endfunction()
