# SPDX-License-Identifier: MIT
# Installs the build, moves the package elsewhere, builds the consumer against it, and runs the consumer twice. Its
# shader must pass as it is. Broken, it must fail with a verdict and not with any other error. Before that the framework
# alone is installed, without the shaders; and what gloam promises of C++ compiles against the package. Where doctest is
# installed, the shader passes and fails with it as well.
set(prefix "${WORK}/moved here")
set(consumer "${WORK}/own_function")
set(shader "${consumer}/shaders/tone.glsl")

include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")

# expect_failure(PATTERN command...): the command fails, and its output matches.
function(expect_failure PATTERN)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(status EQUAL 0 OR NOT output MATCHES "${PATTERN}")
    message(FATAL_ERROR "expected a failure with ${PATTERN}, exit status ${status}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
foreach(component common shader_test)
  run("install ${component}" "${CMAKE_COMMAND}" --install "${BUILD}" --component ${component}
    --prefix "${WORK}/framework")
endforeach()
file(GLOB_RECURSE of_occlusion "${WORK}/framework/*.glsl" "${WORK}/framework/*.comp" "${WORK}/framework/bin/*")
if(of_occlusion)
  message(FATAL_ERROR "the framework alone has files of ambient occlusion: ${of_occlusion}")
endif()
expect_failure("without its component glsl" "${CMAKE_COMMAND}" -S "${CONSUMER}" -B "${WORK}/without"
  "-DCMAKE_PREFIX_PATH=${WORK}/framework" "-DCMAKE_CXX_COMPILER=${COMPILER}")

run("install" "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/installed")
file(RENAME "${WORK}/installed" "${prefix}")
file(COPY "${CONSUMER}" DESTINATION "${WORK}")
file(GLOB_RECURSE version_file "${prefix}/*/gloam-config-version.cmake")
foreach(asked 0.2 0.3 0.4 1.0)
  string(REPLACE "." ";" parts ${asked})
  list(GET parts 0 PACKAGE_FIND_VERSION_MAJOR)
  list(GET parts 1 PACKAGE_FIND_VERSION_MINOR)
  set(PACKAGE_FIND_VERSION ${asked})
  set(PACKAGE_VERSION_COMPATIBLE FALSE)
  include("${version_file}")
  if(NOT PACKAGE_VERSION STREQUAL VERSION)
    message(FATAL_ERROR "${version_file}: version ${PACKAGE_VERSION}, expected ${VERSION}")
  endif()
  string(FIND "${VERSION}" "${asked}." same)
  if((same EQUAL 0 AND NOT PACKAGE_VERSION_COMPATIBLE) OR (NOT same EQUAL 0 AND PACKAGE_VERSION_COMPATIBLE))
    message(FATAL_ERROR "find_package(gloam ${asked}): compatible with ${VERSION}: ${PACKAGE_VERSION_COMPATIBLE}")
  endif()
endforeach()

expect_failure("expected GoogleTest with" "${CMAKE_COMMAND}" -S "${consumer}" -B "${WORK}/alone"
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}" -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON)

set(flags "")
if(SANITIZE)
  set(flags "-fsanitize=address,undefined")
endif()
run("configure" "${CMAKE_COMMAND}" -G Ninja -S "${consumer}" -B "${consumer}/build" "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_CXX_FLAGS=${flags}")
run("build" "${CMAKE_COMMAND}" --build "${consumer}/build")
run("the consumer" "${consumer}/build/own_function_test")
if(NOT output MATCHES "\\[  PASSED  \\] 2 tests")
  message(FATAL_ERROR "expected two tests of the consumer\n${output}")
endif()

if(DOCTEST)
  set(other "${WORK}/doctest")
  run("configure doctest's" "${CMAKE_COMMAND}" -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}/doctest" -B "${other}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
    "-DCMAKE_CXX_FLAGS=${flags}" "-DSHADERS=${consumer}/shaders")
  run("build doctest's" "${CMAKE_COMMAND}" --build "${other}")
  run("doctest's" "${other}/doctest_user")
endif()

file(READ "${shader}" text)
string(REPLACE "1.0 + x" "1.5 + x" broken "${text}")
if(broken STREQUAL text)
  message(FATAL_ERROR "nothing to break in ${shader}")
endif()
file(WRITE "${shader}" "${broken}")
expect_failure("tone_reinhard.*outside.*FAILED  . Tone.MatchesReinhard.*1 FAILED TEST"
  "${consumer}/build/own_function_test")
if(DOCTEST)
  expect_failure("answer.passed.*tone_reinhard.*outside" "${other}/doctest_user")
endif()
