// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/check.hpp"
#include "shader/compile.hpp"

namespace gloam::cli {

// The name of all OpenGL devices together.
inline constexpr const char* every_opengl = "gl";
[[nodiscard]] bool is_opengl(const std::string& device);

// The variants that the options ask for, with the steps of each --compiler. OpenGL devices have one variant:
// the others are ways to make a SPIR-V module. Throws std::invalid_argument.
[[nodiscard]] std::vector<shader::Variant> variants_of(const CheckOptions& options);

// What came of the steps, a line for each variant that has some: modules changed, failed, not judged. Empty
// if no variant has steps.
[[nodiscard]] std::string step_summary(const std::vector<report::CheckReport>& reports);

}  // namespace gloam::cli
