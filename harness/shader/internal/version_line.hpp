// SPDX-License-Identifier: MIT
#pragma once

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// Throws CompileError unless the first line of code is a #version that Vulkan supports in every stage.
// glslang must not see another version: for some it prints its tables to standard output.
void require_vulkan_version(const Source& source);

}  // namespace gloam::shader::internal
