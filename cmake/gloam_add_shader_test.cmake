# SPDX-License-Identifier: MIT
# gloam_add_cost_test(NAME FOLDER "FILE [FUNCTION...] N")
# A test of ctest that a shader costs at most N vector instructions on a GPU (`gloam cost FILE FUNCTION --below N`).
# Where Mesa's RADV is missing, it is skipped.
function(gloam_add_cost_test NAME FOLDER LIMIT)
  separate_arguments(words UNIX_COMMAND "${LIMIT}")
  list(POP_FRONT words file)
  list(POP_BACK words limit)
  if(NOT limit MATCHES "^[0-9.]+$" OR NOT EXISTS ${FOLDER}/${file})
    message(FATAL_ERROR "cost \"${LIMIT}\": expected \"FILE [FUNCTION...] N\", FILE in ${FOLDER}")
  endif()
  if(TARGET gloam)
    set(program $<TARGET_FILE:gloam>)
  else()
    find_program(GLOAM_PROGRAM gloam REQUIRED)
    set(program ${GLOAM_PROGRAM})
  endif()
  add_test(NAME ${NAME} COMMAND ${program} cost ${FOLDER}/${file} ${words} --below ${limit})
  set_tests_properties(${NAME} PROPERTIES SKIP_REGULAR_EXPRESSION "RADV, Mesa's driver .* is not here")
endfunction()

# gloam_add_shader_test(NAME SHADERS folder SOURCES file... [COST "FILE [FUNCTION...] N"...])
# A program with GoogleTest's main that tests shader functions with gloam::shader_test. In its sources SHADER_DIR is the
# folder of its GLSL files. Where gloam's own library is installed too, GLOAM_GLSL_DIR is its folder. Every TEST of
# it is a test of ctest. The program is linked again when a GLSL file of the folder changes, so whatever depends on the
# program sees the change. COST: limits of what shaders of the folder cost, a test each (gloam_add_cost_test).
function(gloam_add_shader_test NAME)
  cmake_parse_arguments(PARSE_ARGV 1 TEST "" "SHADERS" "SOURCES;COST")
  if(TEST_UNPARSED_ARGUMENTS OR NOT TEST_SHADERS OR NOT TEST_SOURCES)
    list(JOIN TEST_UNPARSED_ARGUMENTS ", " unknown)
    message(FATAL_ERROR
      "gloam_add_shader_test(${NAME} ...): expected SHADERS folder and SOURCES file..., not \"${unknown}\"")
  endif()
  get_filename_component(folder ${TEST_SHADERS} ABSOLUTE)
  if(NOT IS_DIRECTORY ${folder})
    message(FATAL_ERROR "gloam_add_shader_test(${NAME} ...): SHADERS ${folder}: expected a folder")
  endif()
  find_package(GTest QUIET)
  if(NOT TARGET GTest::gmock)
    message(FATAL_ERROR "gloam_add_shader_test(${NAME} ...): expected GoogleTest with its gmock (Debian: libgmock-dev)")
  endif()
  include(GoogleTest)
  file(GLOB_RECURSE shaders CONFIGURE_DEPENDS
    ${folder}/*.glsl ${folder}/*.comp ${folder}/*.frag ${folder}/*.vert)
  add_executable(${NAME} ${TEST_SOURCES})
  target_link_libraries(${NAME} PRIVATE
    gloam::shader_test $<TARGET_NAME_IF_EXISTS:gloam::glsl> GTest::gmock GTest::gtest_main)
  target_compile_definitions(${NAME} PRIVATE SHADER_DIR="${folder}")
  set_property(TARGET ${NAME} APPEND PROPERTY LINK_DEPENDS ${shaders})
  gtest_discover_tests(${NAME} DISCOVERY_TIMEOUT 60)
  foreach(limit ${TEST_COST})
    string(REGEX REPLACE "[^A-Za-z0-9_.]+" "_" shader "${limit}")
    gloam_add_cost_test(${NAME}.cost.${shader} ${folder} "${limit}")
  endforeach()
endfunction()
