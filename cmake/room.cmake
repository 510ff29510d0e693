# SPDX-License-Identifier: MIT
# gloam_room(NAME SOURCES file... USES room... LIBRARIES target...)
# A room of the house: static library gloam_NAME (interface library when it has no sources), alias gloam::NAME.
# USES are rooms that its headers may include; LIBRARIES stay hidden behind its sources.
function(gloam_room NAME)
  cmake_parse_arguments(ROOM "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
  set(target gloam_${NAME})
  list(TRANSFORM ROOM_USES PREPEND gloam_)
  if(ROOM_SOURCES)
    add_library(${target} STATIC ${ROOM_SOURCES})
    target_link_libraries(${target} PUBLIC ${ROOM_USES} PRIVATE ${ROOM_LIBRARIES} $<BUILD_INTERFACE:gloam_warnings>)
    set(scope PUBLIC)
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${ROOM_USES} ${ROOM_LIBRARIES})
    set(scope INTERFACE)
  endif()
  add_library(gloam::${NAME} ALIAS ${target})
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/harness>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} ${scope} cxx_std_20)
endfunction()

# gloam_test(NAME SOURCES file... USES room... LIBRARIES target... [SWIFTSHADER filter])
# A GoogleTest program, its tests found by ctest. Those of the filter run once more, as one test, on a browser's
# SwiftShader where there is one.
function(gloam_test NAME)
  cmake_parse_arguments(TEST "" "SWIFTSHADER" "SOURCES;USES;LIBRARIES" ${ARGN})
  list(TRANSFORM TEST_USES PREPEND gloam_)
  add_executable(${NAME} ${TEST_SOURCES})
  target_link_libraries(${NAME} PRIVATE ${TEST_USES} ${TEST_LIBRARIES} gloam_glsl gloam_warnings GTest::gmock)
  target_include_directories(${NAME} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_options(${NAME} PRIVATE $<$<CONFIG:Release>:-O1>)  # nothing in a test is worth optimising for longer
  # Parsing GoogleMock is most of the cost of a test file.
  list(LENGTH TEST_SOURCES sources)
  if(sources GREATER 2)
    target_precompile_headers(${NAME} PRIVATE <gmock/gmock.h> <gtest/gtest.h>)
  endif()
  set(environment "RC_PARAMS=seed=1;GLOAM_CACHE_DIR=${CMAKE_BINARY_DIR}/cache;LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/driver-leaks.supp")
  gtest_discover_tests(${NAME} DISCOVERY_TIMEOUT 60 TEST_LIST ${NAME}_found PROPERTIES TIMEOUT 300)
  # gtest_discover_tests() would take a list apart, and set the first variable only.
  set(file "${CMAKE_CURRENT_BINARY_DIR}/${NAME}_environment.cmake")
  file(WRITE "${file}" "if(${NAME}_found)\n  set_tests_properties(\${${NAME}_found} PROPERTIES ENVIRONMENT \"${environment}\")\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${file}")
  if(TEST_SWIFTSHADER)
    target_sources(${NAME} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/device_main.cpp)
    add_test(NAME ${NAME}.swiftshader COMMAND ${NAME} --swiftshader "--gtest_filter=${TEST_SWIFTSHADER}" --gtest_brief=1)
    set_tests_properties(${NAME}.swiftshader PROPERTIES TIMEOUT 300 SKIP_RETURN_CODE 77 ENVIRONMENT "${environment}")
  else()
    target_link_libraries(${NAME} PRIVATE GTest::gtest_main)
  endif()
endfunction()
