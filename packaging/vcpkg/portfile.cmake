# SPDX-License-Identifier: MIT
# vcpkg install gloam --overlay-ports=packaging/vcpkg: the framework and the shader library of this source tree.
get_filename_component(source "${CURRENT_PORT_DIR}/../.." ABSOLUTE)
vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
vcpkg_cmake_configure(SOURCE_PATH "${source}" OPTIONS
  -DGLOAM_FRAMEWORK_ONLY=ON -DGLOAM_PYTHON=OFF -DGLOAM_QUICK_TOOLS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/gloam)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share"
  "${CURRENT_PACKAGES_DIR}/share/doc")  # of the Debian packages
vcpkg_install_copyright(FILE_LIST "${source}/LICENSE")
