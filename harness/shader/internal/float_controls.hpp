// SPDX-License-Identifier: MIT
#pragma once

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// `module` with the float controls of `original` (execution modes such as SignedZeroInfNanPreserve, with
// their capabilities and the extension) that it lacks. Both have one entry point. Throws std::runtime_error
// when the words are no SPIR-V module.
[[nodiscard]] Spirv with_float_controls_of(const Spirv& original, const Spirv& module);

}  // namespace gloam::shader::internal
