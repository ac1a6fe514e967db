# SPDX-License-Identifier: MIT
# Run by CTest: install, build the consumer both ways, run it. Any step that fails stops the script with its output.

function(run)
    cmake_parse_arguments(arg "" "OUTPUT" "COMMAND" ${ARGN})
    execute_process(COMMAND ${arg_COMMAND} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
    if(NOT result EQUAL 0)
        string(REPLACE ";" " " command "${arg_COMMAND}")
        message(FATAL_ERROR "failed with ${result}: ${command}\n${output}${errors}")
    endif()
    if(arg_OUTPUT)
        string(STRIP "${output}" output)
        set(${arg_OUTPUT} "${output}" PARENT_SCOPE)
    endif()
endfunction()

set(prefix ${WORK_DIR}/prefix)
file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})
unset(ENV{DESTDIR})
run(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})

set(components core)
set(modules seaway-core)
if(HAS_GPU)
    list(APPEND components gpu)
    list(APPEND modules seaway-gpu)
endif()
if(HAS_SCENE)
    list(APPEND components scene)
    list(APPEND modules seaway-scene)
endif()

# With find_package.
separate_arguments(flags UNIX_COMMAND "${C_FLAGS}")
run(COMMAND ${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${WORK_DIR}/cmake -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_C_FLAGS=${C_FLAGS} "-DCOMPONENTS=${components}")
run(COMMAND ${CMAKE_COMMAND} --build ${WORK_DIR}/cmake)
run(COMMAND ${WORK_DIR}/cmake/consumer OUTPUT said)
message("find_package(seaway COMPONENTS ${components}): ${said}")

# A component that does not exist is refused with its name.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${WORK_DIR}/wrong -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_C_COMPILER=${C_COMPILER} -DCOMPONENTS=lava RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors)
if(result EQUAL 0 OR NOT errors MATCHES "no component[ \n]+'lava'")
    message(FATAL_ERROR "find_package took a component that does not exist:\n${errors}")
endif()

# With pkg-config.
file(GLOB_RECURSE packages ${prefix}/*/seaway-core.pc)
get_filename_component(folder "${packages}" DIRECTORY)
get_filename_component(libraries ${folder} DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${folder})
find_program(PKG_CONFIG NAMES pkg-config pkgconf REQUIRED)
run(COMMAND ${PKG_CONFIG} --cflags --libs ${modules} OUTPUT found)
separate_arguments(found UNIX_COMMAND "${found}")
foreach(component IN LISTS components)
    string(TOUPPER ${component} upper)
    list(APPEND flags -DUSE_${upper})
endforeach()
run(COMMAND ${C_COMPILER} ${flags} ${CONSUMER_DIR}/consumer.c -o ${WORK_DIR}/consumer ${found})
set(ENV{LD_LIBRARY_PATH} ${libraries})
run(COMMAND ${WORK_DIR}/consumer OUTPUT said)
message("pkg-config ${modules}: ${said}")
