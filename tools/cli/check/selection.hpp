// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/check.hpp"
#include "cli/check/task.hpp"
#include "module/compile.hpp"

namespace gloam::cli {

// The name of all OpenGL devices together.
inline constexpr const char* every_opengl = "gl";
[[nodiscard]] bool is_opengl(const std::string& device);

// Whether the first word is a file of the user's: functions, or a module.
[[nodiscard]] bool is_of_file(const CheckOptions& options);

// The variants that the options ask for, with the steps of each --compiler. OpenGL devices have one variant:
// the others are ways to make a SPIR-V module. Throws std::invalid_argument.
[[nodiscard]] std::vector<shader::Variant> variants_of(const CheckOptions& options);

// The selected equations or functions in every selected variant; only this shard's share. `outcome` receives
// what was left out of a file. Throws like own_selection() and variants_of().
[[nodiscard]] std::vector<CheckTask> tasks_of(const CheckOptions& options, CheckOutcome& outcome);

// What came of the steps, a line for each variant that has some: modules changed, failed, not judged. Empty
// if no variant has steps.
[[nodiscard]] std::string step_summary(const std::vector<report::CheckReport>& reports);

}  // namespace gloam::cli
