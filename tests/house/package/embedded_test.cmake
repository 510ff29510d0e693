# SPDX-License-Identifier: MIT
# Another project includes gloam's tree with add_subdirectory. It gets the framework alone: without the packages that
# only the program needs, without gloam's tests, and without its warnings. The project's test compiles against the
# headers by their installed names.
set(work "${WORK}/embedded")
file(REMOVE_RECURSE "${work}")
file(MAKE_DIRECTORY "${work}")

include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")

set(without)
foreach(package embree assimp OpenEXR CLI11 SQLite3 rapidcheck benchmark)
  list(APPEND without -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
run("configure" "${CMAKE_COMMAND}" -G Ninja -S "${CONSUMER}" -B "${work}" "-DGLOAM_SOURCE=${SOURCE}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" -DCMAKE_BUILD_TYPE=Debug ${without})
run("list targets" "${CMAKE_COMMAND}" --build "${work}" --target help)
if(output MATCHES "gloam_(catalogue|effect|scene|record):|bin/gloam|_tests:")
  message(FATAL_ERROR "expected the framework alone, got:\n${output}")
endif()
if(NOT output MATCHES "gloam_judge:")
  message(FATAL_ERROR "expected the framework among the targets, got:\n${output}")
endif()
run("compile" "${CMAKE_COMMAND}" --build "${work}" --target CMakeFiles/own_function_test.dir/shader_test.cpp.o)

file(READ "${work}/compile_commands.json" commands)
if(commands MATCHES "-Werror")
  message(FATAL_ERROR "a project that uses gloam must not stop at warnings in gloam's sources")
endif()
