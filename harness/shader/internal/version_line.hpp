// SPDX-License-Identifier: MIT
#pragma once

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// Throws CompileError unless the first line of code is a #version that Vulkan compiles in every stage.
// glslang must not see another one: for some it prints its tables on the standard output.
void require_vulkan_version(const Source& source);

}  // namespace gloam::shader::internal
