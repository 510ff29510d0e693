// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shader/compile.hpp"
#include "shader/variant.hpp"

namespace gloam::shader::internal {

// The module as GLSL 4.50 for Vulkan, as SPIRV-Cross writes it; names are kept. Throws std::runtime_error
// with SPIRV-Cross's message.
[[nodiscard]] std::string to_glsl(const Spirv& module);

// The module as HLSL of shader model 6.0, as SPIRV-Cross writes it; names are kept. Push constants have the
// attribute
// [[vk::push_constant]]. Throws like to_glsl().
[[nodiscard]] std::string to_hlsl(const Spirv& module);

// The module translated to a language and compiled again. Float controls, which SPIRV-Cross drops, are added
// again. `name`: for messages. Throws CompileError if SPIRV-Cross cannot translate the module or glslang
// rejects the result.
[[nodiscard]] Spirv round_trip(const Spirv& module, Stage stage, const std::string& name,
                               Variant::Through through);

// Name and version of SPIRV-Cross.
[[nodiscard]] std::string cross_version();

}  // namespace gloam::shader::internal
