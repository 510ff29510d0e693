// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/framework/check/checker.hpp"
#include "record/check_report.hpp"

namespace gloam::cli {

// The tasks of one device, and how they run.
struct DeviceRun {
    CheckerOptions checker;  // its timeout is that of each check, too
    std::vector<CheckTask> tasks;
    std::size_t jobs = 1;     // worker processes
    bool in_process = false;  // without workers: a crash of a driver ends the whole run
    // The known row of a task, which is not run then; empty: every task runs.
    std::function<std::optional<check::Answer>(const record::DeviceSummary&, const CheckTask&)> known;
    // Called in the order of the tasks, never from two threads at once.
    std::function<void(const record::DeviceSummary&)> on_device;
    std::function<void(const record::DeviceSummary&, const check::Answer&)> on_row;
    // Called for each failed row, in any order, never from two threads at once; empty: not needed.
    std::function<void(const record::DeviceSummary&, const check::Answer&, const HandOver&)> on_failure;
};

// The device refuses to open, for example because no device has this name.
class DeviceRefused : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Runs every task in worker processes, so that a crash or hang of a driver affects only its task. If a device
// cannot be opened any more, its run ends with an additional row, named "device", with the reason and the
// number of checks that were not run. Throws DeviceRefused before the first task only.
[[nodiscard]] record::CheckReport run_on_device(const DeviceRun& run);

// The row of a device that cannot be opened.
[[nodiscard]] check::Answer device_row(check::Reason reason, const std::string& error,
                                       std::size_t checks_left);

}  // namespace gloam::cli
