// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shader/compile.hpp"

namespace gloam::shader::internal::wgsl {

// A text that pack() wrote for Vulkan, as WGSL with its comments: see translated(). Throws CompileError;
// WgslError.
[[nodiscard]] std::string packed_text(const Source& packed, Stage stage);

}  // namespace gloam::shader::internal::wgsl
