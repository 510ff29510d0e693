# SPDX-License-Identifier: MIT
# Installs the build, moves the package elsewhere, builds the consumer against it, and runs the consumer twice. Its
# shader must pass as it is. Broken, it must fail with a verdict and not with any other error.
set(prefix "${WORK}/moved here")
set(consumer "${WORK}/own_function")
set(shader "${consumer}/shaders/tone.glsl")

# run(WHAT command...): stops the test when the command fails.
function(run WHAT)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${WHAT}: exit status ${status}\n${output}")
  endif()
endfunction()

function(expect_verdict EXPECTED)
  execute_process(COMMAND "${consumer}/build/own_function_test"
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(text_found NO)
  if(EXPECTED STREQUAL "pass")
    if(status EQUAL 0 AND output MATCHES "\\[  PASSED  \\] 2 tests")
      return()
    endif()
  elseif(NOT status EQUAL 0 AND output MATCHES "1 FAILED TEST" AND output MATCHES "FAILED  . Tone.MatchesReinhard"
         AND output MATCHES "tone_reinhard.*outside")
    return()
  endif()
  message(FATAL_ERROR "expected the consumer to ${EXPECTED}, exit status ${status}\n${output}")
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
run("install" "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/installed")
file(RENAME "${WORK}/installed" "${prefix}")
file(COPY "${CONSUMER}" DESTINATION "${WORK}")

set(flags "")
if(SANITIZE)
  set(flags "-fsanitize=address,undefined")
endif()
run("configure" "${CMAKE_COMMAND}" -G Ninja -S "${consumer}" -B "${consumer}/build" "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_CXX_FLAGS=${flags}")
run("build" "${CMAKE_COMMAND}" --build "${consumer}/build")
expect_verdict(pass)

file(READ "${shader}" text)
string(REPLACE "1.0 + x" "1.5 + x" broken "${text}")
if(broken STREQUAL text)
  message(FATAL_ERROR "nothing to break in ${shader}")
endif()
file(WRITE "${shader}" "${broken}")
expect_verdict(fail)
