# SPDX-License-Identifier: MIT
"""conan create packaging/conan: the framework and the shader library of this source tree, for Conan 2."""
import re
from pathlib import Path

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

# The CMake packages that gloam looks for, where the recipe has another name for its own.
PACKAGES = {"glslang": "glslang", "spirv-tools": "SPIRV-Tools-opt", "spirv-cross": "spirv_cross_c_shared",
            "vulkan-loader": "Vulkan"}
OPTIONS = {"GLOAM_FRAMEWORK_ONLY": True, "GLOAM_PYTHON": False, "GLOAM_QUICK_TOOLS": False}


class Gloam(ConanFile):
    name = "gloam"
    description = "Tests for GLSL functions in C++, and a GLSL library of ambient occlusion"
    license = "MIT"
    package_type = "static-library"
    settings = "os", "compiler", "build_type", "arch"
    default_options = {"spirv-cross/*:shared": True}
    requires = ("fmt/[>=9]", "glm/[>=0.9.9]", "glslang/[>=1.3.239]", "nlohmann_json/[>=3.11]",
                "spirv-cross/[>=1.3.239]", "spirv-tools/[>=1.3.239]", "stb/[>=cci.20220909]",
                "vulkan-loader/[>=1.3.239]", "xxhash/[>=0.8]")

    def _root(self):
        return Path(self.recipe_folder).parents[1]

    def set_version(self):
        self.version = re.search(r"project\(gloam VERSION ([\d.]+)", load(self, self._root() / "CMakeLists.txt"))[1]

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "README.md", "cmake/*", "glsl/*", "harness/framework/*"):
            copy(self, pattern, self._root(), self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        dependencies = CMakeDeps(self)
        for recipe, package in PACKAGES.items():
            dependencies.set_property(recipe, "cmake_file_name", package)
        dependencies.generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update(OPTIONS)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, Path(self.package_folder) / "licenses")

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # gloam's own package is found
        self.cpp_info.builddirs = ["lib/cmake/gloam"]
