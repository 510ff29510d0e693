// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// The module as GLSL 4.50 for Vulkan, as SPIRV-Cross writes it; names are kept. Throws std::runtime_error
// with SPIRV-Cross's message.
[[nodiscard]] std::string to_glsl(const Spirv& module);

// The module translated to GLSL and compiled again. Float controls, which SPIRV-Cross drops, are added again.
// `name`: for messages. Throws CompileError if SPIRV-Cross cannot translate the module or glslang rejects the
// result.
[[nodiscard]] Spirv round_trip(const Spirv& module, Stage stage, const std::string& name);

// Name and version of SPIRV-Cross.
[[nodiscard]] std::string cross_version();

}  // namespace gloam::shader::internal
