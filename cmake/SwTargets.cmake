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
        # What a sanitizer finds ends the program, whatever the environment says: a line that nobody reads is no finding.
        target_compile_options(${target} PRIVATE -fsanitize=${SW_SANITIZE} -fno-sanitize-recover=all
            -fno-omit-frame-pointer)
        target_link_options(${target} PUBLIC -fsanitize=${SW_SANITIZE})
    endif()
endfunction()

find_program(SW_GLSLC glslc)

# SPIR-V of shaders/<dir>/<name>.<stage>, or of a path, as C initializers in <folder>/<name>.<stage>.inc, once
# optimised, which is what is embedded, and once with its names, <name>.<stage>.named. Includes are looked for in
# SW_SHADER_FOLDERS too.
function(sw_compile_shader folder shader)
    if(NOT SW_GLSLC)
        message(FATAL_ERROR "glslc was not found: run scripts/setup, or install Debian's package glslc")
    endif()
    get_filename_component(name ${shader} NAME)
    set(output ${folder}/${name}.inc)
    get_filename_component(source ${shader} ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR}/shaders)
    list(TRANSFORM SW_SHADER_FOLDERS PREPEND -I OUTPUT_VARIABLE folders)
    set(glslc ${SW_GLSLC} --target-env=vulkan1.3 -mfmt=c -I ${PROJECT_SOURCE_DIR}/shaders ${folders})
    add_custom_command(OUTPUT ${output} ${folder}/${name}.named
        COMMAND ${glslc} -O -MD -MF ${output}.d -MT ${output} -o ${output} ${source}
        COMMAND ${glslc} -O0 -o ${folder}/${name}.named ${source}
        DEPENDS ${source}
        DEPFILE ${output}.d
        COMMENT "GLSL ${shader}" VERBATIM)
endfunction()

# Shaders of the target, as SPIR-V that its sources include: <dir>/<name>.comp, or <dir>/<name>.vert+<dir>/<name>.frag
# for the two stages of one pipeline. Of each comes <name>_shader.h, the fragment shader's name for two stages, which
# names all that it binds; see scripts/reflect_spirv.py. A lone .vert or .frag is only compiled, to <name>.<stage>.inc.
function(sw_embed_shaders target)
    find_package(Python3 REQUIRED COMPONENTS Interpreter)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/spirv)
    file(MAKE_DIRECTORY ${folder})
    set(reflect ${PROJECT_SOURCE_DIR}/scripts/reflect_spirv.py)
    set(outputs)
    set(compiled)
    foreach(entry IN LISTS ARGN)
        string(REPLACE "+" ";" stages ${entry})
        set(words)
        foreach(shader IN LISTS stages)
            if(NOT shader IN_LIST compiled)
                sw_compile_shader(${folder} ${shader})
                list(APPEND compiled ${shader})
            endif()
            get_filename_component(name ${shader} NAME)
            get_filename_component(pipeline ${shader} NAME_WE)
            list(APPEND words ${folder}/${name}.inc ${folder}/${name}.named)
        endforeach()
        list(APPEND outputs ${words})
        if(entry MATCHES "\\+|\\.comp$")
            set(header ${folder}/${pipeline}_shader.h)
            add_custom_command(OUTPUT ${header}
                COMMAND Python3::Interpreter ${reflect} ${pipeline} ${header} ${words}
                DEPENDS ${reflect} ${words}
                COMMENT "Bindings of ${pipeline}" VERBATIM)
            list(APPEND outputs ${header})
        endif()
    endforeach()
    list(REMOVE_DUPLICATES outputs)
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
