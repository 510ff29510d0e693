// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shader/compile.hpp"
#include "shader/variant.hpp"

namespace gloam::shader::internal {

// The module translated to a language and compiled again. Float controls, which SPIRV-Cross drops, are added
// again. `name`: for messages. Throws CompileError if SPIRV-Cross cannot translate the module or glslang
// rejects the result.
[[nodiscard]] Spirv round_trip(const Spirv& module, Stage stage, const std::string& name,
                               Variant::Through through);

// Name and version of SPIRV-Cross.
[[nodiscard]] std::string cross_version();

}  // namespace gloam::shader::internal
