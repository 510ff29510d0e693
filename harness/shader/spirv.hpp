// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shader/compile.hpp"

namespace gloam::shader {

// Throws std::runtime_error with the validator's message if the module is not valid for Vulkan 1.2.
void validate(const Spirv& module);

// The module after the passes of the given kind; `none` returns it unchanged. Does not validate. Throws
// std::runtime_error with the optimizer's message if it cannot read the module.
[[nodiscard]] Spirv optimize(const Spirv& module, Optimization optimization);

// The module as assembly text with friendly names. Throws std::runtime_error when it cannot be decoded.
[[nodiscard]] std::string disassemble(const Spirv& module);

}  // namespace gloam::shader
