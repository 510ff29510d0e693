# SPDX-License-Identifier: MIT
# cpack -G DEB makes a Debian package of each component, in the system for which it is. The source archive
# (cpack --config CPackSourceConfig.cmake) holds what the tree holds and builds without git.
set(CPACK_PACKAGE_CONTACT "The gloam maintainers <maintainers@users.noreply.gloam.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL common shader_test glsl)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

# What Debian wants compressed, and without a time.
function(gloam_gzip FROM TO)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${FROM})
  execute_process(COMMAND gzip -9n INPUT_FILE ${FROM} OUTPUT_FILE ${TO} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# gloam_debian(COMPONENT PACKAGE DESCRIPTION [SECTION s] [ARCHITECTURE all] [DEPENDS d] [RECOMMENDS r] [SUGGESTS s])
function(gloam_debian COMPONENT PACKAGE DESCRIPTION)
  set(fields SECTION ARCHITECTURE DEPENDS RECOMMENDS SUGGESTS)
  cmake_parse_arguments(DEB "" "${fields}" "" ${ARGN})
  string(TOUPPER ${COMPONENT} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${PACKAGE} PARENT_SCOPE)
  set(CPACK_COMPONENT_${key}_DESCRIPTION "${DESCRIPTION}" PARENT_SCOPE)
  foreach(field ${fields})
    set(CPACK_DEBIAN_${key}_PACKAGE_${field} "${DEB_${field}}" PARENT_SCOPE)
  endforeach()
  # The licence, and a change log in Debian's form.
  set(folder ${PROJECT_BINARY_DIR}/package/${PACKAGE})
  configure_file(LICENSE ${folder}/copyright COPYONLY)
  string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE ${folder}/changelog "${PACKAGE} (${PROJECT_VERSION}) unstable; urgency=medium\n\n"
    "  * /usr/share/gloam/CHANGELOG.md says what changed.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${now}\n")
  gloam_gzip(${folder}/changelog ${folder}/changelog.gz)
  install(FILES ${folder}/copyright ${folder}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${PACKAGE} COMPONENT ${COMPONENT})
endfunction()

set(same "(= ${PROJECT_VERSION})")
gloam_debian(common gloam-common "GLSL ambient occlusion, measured: common files\nThe other packages need them."
  SECTION libdevel ARCHITECTURE all)
gloam_debian(glsl gloam-glsl "GLSL ambient occlusion, measured: shaders\nFunctions and passes with a documented error."
  SECTION libdevel ARCHITECTURE all DEPENDS "gloam-common ${same}")
# What its CMake package finds, and in Recommends what its tests are written and run with.
string(JOIN ", " needed "gloam-common ${same}" libvulkan1 libvulkan-dev glslang-dev glslang-tools spirv-tools
  libspirv-cross-c-shared-dev libfmt-dev libglm-dev)
gloam_debian(shader_test libgloam-shader-test-dev "tests for GLSL functions, in C++\nThey run on any Vulkan driver."
  SECTION libdevel DEPENDS "${needed}"
  RECOMMENDS "mesa-vulkan-drivers, vulkan-validationlayers, libgtest-dev, libgmock-dev, cmake, g++")
if(NOT GLOAM_FRAMEWORK_ONLY)
  list(APPEND CPACK_COMPONENTS_ALL program)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
  # Vulkan and OpenGL are loaded while it runs; dpkg-shlibdeps does not see them.
  gloam_debian(program gloam "GLSL ambient occlusion, measured: program\nIt renders, packs shaders and judges drivers."
    SECTION graphics DEPENDS "gloam-glsl ${same}, libvulkan1"
    RECOMMENDS "mesa-vulkan-drivers, fonts-dejavu-core"
    SUGGESTS "libegl1, glmark2-data, spirv-tools, vulkan-validationlayers")
  gloam_gzip(${PROJECT_SOURCE_DIR}/packaging/gloam.1 ${PROJECT_BINARY_DIR}/package/gloam.1.gz)
  install(FILES ${PROJECT_BINARY_DIR}/package/gloam.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
endif()

set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME gloam-${PROJECT_VERSION})
set(CPACK_SOURCE_IGNORE_FILES
  "^${PROJECT_SOURCE_DIR}/(build|out|\\\\.git|\\\\.cache|gloam-demo|gloam-out)/"
  "/compile_commands\\\\.json$" "\\\\.pyc$" "/__pycache__/")
include(CPack)
