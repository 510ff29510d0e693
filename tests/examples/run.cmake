# SPDX-License-Identifier: MIT
# run(WHAT command...): stops the test when the command fails.
function(run WHAT)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${WHAT}: exit status ${status}\n${command}\n${output}")
  endif()
endfunction()

# build(NAME option...): configures and builds the example of that name in ${WORK}/build.
function(build NAME)
  run("configure" "${CMAKE_COMMAND}" -G Ninja -S "${EXAMPLES}/${NAME}" -B "${WORK}/build"
    "-DCMAKE_CXX_COMPILER=${COMPILER}"
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS=-Wall\ -Wextra\ -Werror ${ARGN})
  run("build" "${CMAKE_COMMAND}" --build "${WORK}/build")
endfunction()
