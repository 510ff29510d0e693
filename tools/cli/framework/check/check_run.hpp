// SPDX-License-Identifier: MIT
#pragma once

#include "cli/framework/check.hpp"

namespace gloam::cli {

// The name of all OpenGL devices together.
inline constexpr const char* every_opengl = "gl";
[[nodiscard]] bool is_opengl(const std::string& device);

// Whether the first word is a file of the user's: functions, or a module.
[[nodiscard]] bool is_of_file(const CheckOptions& options);

// This shard's share of the selected equations or functions in every selected variant. `outcome` gets what
// was left out of a file. Throws like functions_of(); std::invalid_argument for variants of other devices.
[[nodiscard]] std::vector<CheckTask> tasks_of(const CheckOptions& options, CheckOutcome& outcome);

// Runs every task on each device that the options select, in worker processes, so that a crash or hang of a
// driver affects only its task; or in this process, if the options say so. Prints rows as they come, in the
// order of the tasks, writes them to the journal, and shows the progress. Returns a report for each device,
// and for each broken driver among these. If a device cannot be opened any more, its run ends with an
// additional row, named "device", with the reason and the number of checks that were not run. Throws NoWorker
// if the only device cannot be opened.
[[nodiscard]] std::vector<record::CheckReport> run_tasks(const CheckOptions& options,
                                                         const std::vector<CheckTask>& tasks);

// The command that repeats this check exactly: the same inputs on the same device.
[[nodiscard]] std::string command_for(const CheckOptions& options, const record::DeviceSummary& device,
                                      const judge::Answer& row);

}  // namespace gloam::cli
