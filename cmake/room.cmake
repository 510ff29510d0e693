# SPDX-License-Identifier: MIT
# gloam_sources(RESULT file... [| file...]...)
# Puts the files of the list into RESULT. The files between two | are compiled as one, because most of the cost of a
# source is reading its headers. They may therefore not define the same name, not even in unnamed namespaces.
# -DCMAKE_UNITY_BUILD=OFF compiles every file alone.
function(gloam_sources RESULT)
  set(group 1)
  set(files)
  foreach(word ${ARGN})
    if(word STREQUAL "|")
      math(EXPR group "${group} + 1")
    else()
      list(APPEND files ${word})
      set_source_files_properties(${word} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  set(${RESULT} ${files} PARENT_SCOPE)
endfunction()

# gloam_compile_together(TARGET [ALL])
# Compiles the sources of a target in the groups that gloam_sources() made, or all as one.
function(gloam_compile_together TARGET)
  if(DEFINED CMAKE_UNITY_BUILD AND NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON)
  if(ARGC GREATER 1)
    set_target_properties(${TARGET} PROPERTIES UNITY_BUILD_BATCH_SIZE 0)
  else()
    set_target_properties(${TARGET} PROPERTIES UNITY_BUILD_MODE GROUP)
  endif()
endfunction()

# gloam_precompiled(NAME [FLAGS flag...] HEADERS header... LIBRARIES target...)
# Headers that many sources read, precompiled once. gloam_precompile() makes a target read them. The target is then
# compiled with the same flags, because GCC accepts precompiled headers only at the optimisation level that made them.
function(gloam_precompiled NAME)
  cmake_parse_arguments(PRE "" "" "FLAGS;HEADERS;LIBRARIES" ${ARGN})
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${NAME}.cpp CONTENT "")
  add_library(${NAME} STATIC ${PROJECT_BINARY_DIR}/${NAME}.cpp)
  target_link_libraries(${NAME} PRIVATE fmt::fmt glm::glm gloam_warnings ${PRE_LIBRARIES})
  target_compile_options(${NAME} PRIVATE ${PRE_FLAGS})
  target_precompile_headers(${NAME} PRIVATE <fmt/format.h> <glm/glm.hpp>
    <algorithm> <array> <chrono> <cmath> <cstdint> <cstring> <filesystem> <fstream> <functional> <limits> <map> <memory>
    <numeric> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <tuple> <type_traits> <unordered_map>
    <utility> <variant> <vector> ${PRE_HEADERS})
endfunction()

function(gloam_precompile TARGET NAME)
  target_link_libraries(${TARGET} PRIVATE $<BUILD_INTERFACE:fmt::fmt> $<BUILD_INTERFACE:glm::glm>)
  target_compile_options(${TARGET} PRIVATE $<TARGET_PROPERTY:${NAME},COMPILE_OPTIONS>)
  target_precompile_headers(${TARGET} REUSE_FROM ${NAME})
endfunction()

gloam_precompiled(gloam_headers)

# For code that need not be fast: most of the run time is spent in the compilers, the drivers and the other rooms.
# CLI11 is not among these headers: every source that reads it, used or not, takes 1.4 s longer to compile.
gloam_precompiled(gloam_glue_headers FLAGS $<$<CONFIG:Release>:-O1>
  HEADERS <nlohmann/json.hpp> LIBRARIES nlohmann_json::nlohmann_json)

# gloam_room(NAME SOURCES file... [| file...]... USES room... LIBRARIES target... [HEADERS precompiled])
# A room (docs/architecture.md): static library gloam_NAME (interface library when it has no sources), alias
# gloam::NAME. USES are rooms that its headers may include; only its sources see LIBRARIES. HEADERS: see
# gloam_precompiled(). Headers of its own wing, and of those of the rooms that it uses, are included as ROOM/FILE.hpp.
function(gloam_room NAME)
  cmake_parse_arguments(ROOM "" "HEADERS" "SOURCES;USES;LIBRARIES" ${ARGN})
  set(target gloam_${NAME})
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR PARENT_PATH wing)
  list(TRANSFORM ROOM_USES PREPEND gloam_)
  if(ROOM_SOURCES)
    gloam_sources(sources ${ROOM_SOURCES})
    add_library(${target} STATIC ${sources})
    gloam_compile_together(${target})
    if(NOT ROOM_HEADERS)
      set(ROOM_HEADERS gloam_headers)
    endif()
    gloam_precompile(${target} ${ROOM_HEADERS})
    target_link_libraries(${target} PUBLIC ${ROOM_USES} PRIVATE ${ROOM_LIBRARIES} $<BUILD_INTERFACE:gloam_warnings>)
    set(scope PUBLIC)
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${ROOM_USES} ${ROOM_LIBRARIES})
    set(scope INTERFACE)
  endif()
  add_library(gloam::${NAME} ALIAS ${target})
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${wing}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} ${scope} cxx_std_20)
endfunction()

# gloam_test(NAME SOURCES file... USES room... LIBRARIES target... [SWIFTSHADER filter])
# A GoogleTest program whose suites ctest finds (list_suites.cmake). The tests that match the filter run once more, as
# one ctest test, on a browser's SwiftShader where there is one. All sources are compiled as one, so each has a
# namespace with the name of its file.
function(gloam_test NAME)
  cmake_parse_arguments(TEST "" "SWIFTSHADER" "SOURCES;USES;LIBRARIES" ${ARGN})
  list(TRANSFORM TEST_USES PREPEND gloam_)
  add_executable(${NAME} ${TEST_SOURCES})
  target_link_libraries(${NAME} PRIVATE ${TEST_USES} ${TEST_LIBRARIES} gloam_glsl gloam_warnings GTest::gmock_main)
  target_sources(${NAME} PRIVATE $<TARGET_OBJECTS:gloam_test_seen_files>)
  target_include_directories(${NAME} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  gloam_compile_together(${NAME} ALL)
  gloam_precompile(${NAME} gloam_test_headers)
  # Newer layers of Vulkan check what shaders access by the last word alone.
  string(CONCAT environment "RC_PARAMS=seed=1;GLOAM_CACHE_DIR=${CMAKE_BINARY_DIR}/cache;"
    "LSAN_OPTIONS=print_suppressions=0:suppressions=${PROJECT_SOURCE_DIR}/tests/driver-leaks.supp;"
    "ASAN_OPTIONS=verify_asan_link_order=0:handle_segv=0;VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC=true")
  string(REGEX REPLACE "_tests$" "" prefix ${NAME})
  set(listing "${CMAKE_CURRENT_BINARY_DIR}/${NAME}_suites.cmake")
  set_property(TARGET ${NAME} APPEND PROPERTY LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/list_suites.cmake)
  add_custom_command(TARGET ${NAME} POST_BUILD BYPRODUCTS ${listing} VERBATIM
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${NAME}> -D PREFIX=${prefix} -D OUTPUT=${listing}
      -D "ENVIRONMENT=${environment}" -D SEEN=${CMAKE_BINARY_DIR}/seen -P ${PROJECT_SOURCE_DIR}/cmake/list_suites.cmake)
  set(file "${CMAKE_CURRENT_BINARY_DIR}/${NAME}_tests.cmake")
  file(WRITE "${file}" "if(EXISTS [==[${listing}]==])\n  include([==[${listing}]==])\n"
    "else()\n  add_test(${NAME}_NOT_BUILT ${NAME}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${file}")
  if(TEST_SWIFTSHADER)
    target_sources(${NAME} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/swiftshader.cpp)
    add_test(NAME ${NAME}.swiftshader COMMAND ${NAME} "--gtest_filter=${TEST_SWIFTSHADER}" --gtest_brief=1)
    string(APPEND environment ";GLOAM_DEPENDENCIES_OUTPUT=${CMAKE_BINARY_DIR}/seen/${NAME}.swiftshader")
    set_tests_properties(${NAME}.swiftshader PROPERTIES TIMEOUT 300 SKIP_REGULAR_EXPRESSION "no SwiftShader here"
      ENVIRONMENT "${environment};GLOAM_TEST_DEVICE=SwiftShader")
  endif()
endfunction()
