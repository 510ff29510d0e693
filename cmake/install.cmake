# SPDX-License-Identifier: MIT
# The package: find_package(gloam COMPONENTS shader_test glsl) gives gloam::shader_test (the generic test framework) and
# gloam::glsl (the shaders). What is installed has four components: common, shader_test, glsl and program. Each of the
# last three needs common, and the program needs glsl.
include(CMakePackageConfigHelpers)
include(cmake/gloam_add_shader_test.cmake)

set(package_rooms base numeric backend source module interpreter subject judge audit pass)
set(package_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gloam)

add_library(gloam_shader_test INTERFACE)
add_library(gloam::shader_test ALIAS gloam_shader_test)
set_target_properties(gloam_shader_test PROPERTIES EXPORT_NAME shader_test)
list(TRANSFORM package_rooms PREPEND gloam_ OUTPUT_VARIABLE package_targets)
target_link_libraries(gloam_shader_test INTERFACE ${package_targets})

foreach(room ${package_rooms})
  set_target_properties(gloam_${room} PROPERTIES EXPORT_NAME ${room})
endforeach()
install(TARGETS gloam_shader_test ${package_targets} EXPORT gloam-shader_test-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT shader_test)
install(TARGETS gloam_glsl EXPORT gloam-glsl-targets)
foreach(component shader_test glsl)
  install(EXPORT gloam-${component}-targets NAMESPACE gloam:: DESTINATION ${package_cmake_dir} COMPONENT ${component})
endforeach()

# Public headers, as <gloam/ROOM/FILE.hpp>: those of a room but for its folders internal/.
set(header_stage ${PROJECT_BINARY_DIR}/package/include)
if(NOT PROJECT_IS_TOP_LEVEL)
  # A project that takes gloam in includes them by the same names, without an installation.
  set(rooms ${package_rooms})
  set(source ${PROJECT_SOURCE_DIR}/harness/framework)
  set(stage ${header_stage})
  include(cmake/stage_headers.cmake)
  foreach(room ${package_rooms})
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${source}/${room}/*.hpp)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${headers})
  endforeach()
  target_include_directories(gloam_shader_test INTERFACE $<BUILD_INTERFACE:${header_stage}>)
endif()
install(CODE "
  set(rooms ${package_rooms})
  set(source \"${PROJECT_SOURCE_DIR}/harness/framework\")
  set(stage \"${header_stage}\")
  include(\"${PROJECT_SOURCE_DIR}/cmake/stage_headers.cmake\")" COMPONENT shader_test)
install(DIRECTORY ${header_stage}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT shader_test)
install(FILES cmake/gloam_add_shader_test.cmake DESTINATION ${package_cmake_dir} COMPONENT shader_test)

set(data ${CMAKE_INSTALL_DATADIR}/gloam)
install(DIRECTORY glsl/ DESTINATION ${data}/glsl COMPONENT glsl)
if(NOT GLOAM_FRAMEWORK_ONLY)
  install(DIRECTORY docs experiments DESTINATION ${data} COMPONENT program)
  install(DIRECTORY tools/stress/shaders/ DESTINATION ${data}/stress COMPONENT program)
  install(DIRECTORY tools/site/effect tools/site/npm tools/site/page tools/site/shaders
    DESTINATION ${data}/site COMPONENT program)
endif()

install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${data} COMPONENT common)

list(JOIN spirv_cross_packages " " spirv_cross_packages)
# Not where find_package() would take the build tree for an installation.
configure_package_config_file(cmake/gloam-config.cmake.in ${PROJECT_BINARY_DIR}/package/gloam-config.cmake
  INSTALL_DESTINATION ${package_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/gloam-config-version.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/package/gloam-config.cmake ${PROJECT_BINARY_DIR}/package/gloam-config-version.cmake
  DESTINATION ${package_cmake_dir} COMPONENT common)
if(PROJECT_IS_TOP_LEVEL)
  include(cmake/packages.cmake)
endif()
