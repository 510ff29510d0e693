// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/check/checker.hpp"
#include "cli/check/task.hpp"
#include "report/check_report.hpp"

namespace gloam::cli {

// What one device is asked, and how.
struct DeviceRun {
    CheckerOptions checker;
    std::vector<CheckTask> tasks;
    std::chrono::milliseconds timeout{120'000};  // for each check
    std::size_t jobs = 1;                        // worker processes
    bool in_process = false;                     // no workers: a driver that crashes takes all with it
    // The row of a task that need not run again; empty: every task runs.
    std::function<std::optional<check::Answer>(const report::DeviceSummary&, const CheckTask&)> known;
    // Called in the order of the tasks, never from two threads at once.
    std::function<void(const report::DeviceSummary&)> on_device;
    std::function<void(const report::DeviceSummary&, const check::Answer&)> on_row;
    // Called for each row that failed, in any order, never from two threads at once; empty: not wanted.
    std::function<void(const report::DeviceSummary&, const check::Answer&, const HandOver&)> on_failure;
};

// The device cannot be opened, and says so itself: there is none of that name, say.
class DeviceRefused : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Runs every task in worker processes; what a driver does to one of them costs that task alone. A device that
// cannot be opened any more ends its run with one more row, named "device", that says why and how many
// checks were not run. Throws DeviceRefused before the first task only.
[[nodiscard]] report::CheckReport run_on_device(const DeviceRun& run);

// The row of a device that cannot be opened.
[[nodiscard]] check::Answer device_row(check::Reason reason, const std::string& error,
                                       std::size_t checks_left);

}  // namespace gloam::cli
