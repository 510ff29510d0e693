// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// The module as GLSL 4.50 for Vulkan, as SPIRV-Cross writes it; names are kept. Throws std::runtime_error
// with SPIRV-Cross's message.
[[nodiscard]] std::string to_glsl(const Spirv& module);

// The module turned into GLSL and compiled again. Float controls are put back: SPIRV-Cross drops them.
// `name` is for messages. Throws CompileError when SPIRV-Cross cannot write the module or glslang rejects
// what it wrote.
[[nodiscard]] Spirv round_trip(const Spirv& module, Stage stage, const std::string& name);

// Name and version of SPIRV-Cross.
[[nodiscard]] std::string cross_version();

}  // namespace gloam::shader::internal
