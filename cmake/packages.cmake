# SPDX-License-Identifier: MIT
# cpack -G DEB makes a Debian package of each component, in the system for which it is. The source archive
# (cpack --config CPackSourceConfig.cmake) holds what the tree holds and builds without git.
set(CPACK_PACKAGE_VENDOR gloam)
set(CPACK_PACKAGE_CONTACT "The gloam maintainers <maintainers@users.noreply.gloam.example>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_FILE_NAME gloam-${PROJECT_VERSION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL common shader_test glsl)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

# gloam_debian(COMPONENT PACKAGE SUMMARY [SECTION s] [ARCHITECTURE all] [DEPENDS d] [RECOMMENDS r] [SUGGESTS s])
function(gloam_debian COMPONENT PACKAGE SUMMARY)
  cmake_parse_arguments(DEB "" "SECTION;ARCHITECTURE;DEPENDS;RECOMMENDS;SUGGESTS" "" ${ARGN})
  string(TOUPPER ${COMPONENT} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${PACKAGE} PARENT_SCOPE)
  set(CPACK_COMPONENT_${key}_DESCRIPTION "${SUMMARY}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${DEB_SECTION} PARENT_SCOPE)
  foreach(field DEPENDS RECOMMENDS SUGGESTS)
    set(CPACK_DEBIAN_${key}_PACKAGE_${field} "${DEB_${field}}" PARENT_SCOPE)
  endforeach()
  if(DEB_ARCHITECTURE)
    set(CPACK_DEBIAN_${key}_PACKAGE_ARCHITECTURE ${DEB_ARCHITECTURE} PARENT_SCOPE)
  endif()
  # The licence of gloam.
  set(copyright ${PROJECT_BINARY_DIR}/package/${PACKAGE}/copyright)
  configure_file(LICENSE ${copyright} COPYONLY)
  install(FILES ${copyright} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${PACKAGE} COMPONENT ${COMPONENT})
endfunction()

set(same "(= ${PROJECT_VERSION})")
gloam_debian(common gloam-common "GLSL ambient occlusion, measured: CMake package, licence" SECTION libdevel
  ARCHITECTURE all)
gloam_debian(glsl gloam-glsl "GLSL ambient occlusion, measured: the shader library" SECTION libdevel ARCHITECTURE all
  DEPENDS "gloam-common ${same}")
# What its CMake package finds, and in Recommends what its tests are written and run with.
string(JOIN ", " needed "gloam-common ${same}" libvulkan1 libvulkan-dev glslang-dev glslang-tools spirv-tools
  libspirv-cross-c-shared-dev libfmt-dev libglm-dev)
gloam_debian(shader_test libgloam-shader-test-dev "tests for GLSL functions, in C++" SECTION libdevel
  DEPENDS "${needed}"
  RECOMMENDS "mesa-vulkan-drivers, libgtest-dev, libgmock-dev, cmake")
if(NOT GLOAM_FRAMEWORK_ONLY)
  list(APPEND CPACK_COMPONENTS_ALL program)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
  # Vulkan and OpenGL are loaded while it runs; dpkg-shlibdeps does not see them.
  gloam_debian(program gloam "GLSL ambient occlusion, measured: the program" SECTION graphics
    DEPENDS "gloam-glsl ${same}, libvulkan1"
    RECOMMENDS "mesa-vulkan-drivers, fonts-dejavu-core"
    SUGGESTS "libegl1, glmark2-data, spirv-tools, vulkan-validationlayers")
endif()

set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME gloam-${PROJECT_VERSION})
set(CPACK_SOURCE_IGNORE_FILES
  "^${PROJECT_SOURCE_DIR}/(build|out|\\\\.git|\\\\.cache|gloam-demo|gloam-out)/"
  "/compile_commands\\\\.json$" "\\\\.pyc$" "/__pycache__/")
include(CPack)
