// SPDX-License-Identifier: MIT
#pragma once

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// `module` with those float controls of `original` that it lacks: execution modes such as
// SignedZeroInfNanPreserve, with their capabilities and the extension. Both have one entry point. Throws
// std::runtime_error for words that are not a SPIR-V module.
[[nodiscard]] Spirv with_float_controls_of(const Spirv& original, const Spirv& module);

}  // namespace gloam::shader::internal
