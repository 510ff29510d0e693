// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/framework/check.hpp"

namespace gloam::cli {

// The name of all OpenGL devices together.
inline constexpr const char* every_opengl = "gl";
[[nodiscard]] bool is_opengl(const std::string& device);

// Whether the first word is a file of the user's: functions, or a module.
[[nodiscard]] bool is_of_file(const CheckOptions& options);

// The selected equations or functions in every selected variant; only this shard's share. `outcome` receives
// what was left out of a file. Throws like functions_of(), and std::invalid_argument
// for variants that the device does not have.
[[nodiscard]] std::vector<CheckTask> tasks_of(const CheckOptions& options, CheckOutcome& outcome);

// The command that repeats this check exactly: the same inputs on the same device.
[[nodiscard]] std::string command_for(const CheckOptions& options, const record::DeviceSummary& device,
                                      const check::Answer& row);

}  // namespace gloam::cli
