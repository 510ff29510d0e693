// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "cli/framework/check/checker.hpp"
#include "cli/framework/open_device.hpp"
#include "record/check_report.hpp"
#include "record/output.hpp"

namespace gloam::cli {

// The checks of one call of `gloam check`, on one device after the other. Prints rows as they come, writes
// them to the journal, and shows the progress. The runner of a device asks it for what is known, and tells it
// what happens, in the order of the tasks and never from two threads at once.
class CheckRun {
  public:
    CheckRun(const CheckOptions& options, std::vector<CheckTask> tasks);
    ~CheckRun() { progress_(-1.0); }
    CheckRun(const CheckRun&) = delete;
    CheckRun& operator=(const CheckRun&) = delete;

    // A report for each device that the options select, and for each broken driver among these.
    [[nodiscard]] std::vector<record::CheckReport> run();

    [[nodiscard]] const CheckOptions& options() const { return options_; }
    [[nodiscard]] const std::vector<CheckTask>& tasks() const { return tasks_; }
    // Whether failures are to be prepared for a report.
    [[nodiscard]] bool wants_bundles() const { return failures_.has_value(); }

    // The row of an earlier run, which is not run again. A failure is, if it is to be prepared for a report.
    [[nodiscard]] std::optional<check::Answer> known(const record::DeviceSummary& on,
                                                     const CheckTask& task) const;
    void begin(const record::DeviceSummary& on);
    void take(const record::DeviceSummary& on, const check::Answer& row);
    // In any order.
    void keep(const record::DeviceSummary& on, const check::Answer& failed, const FailureBundle& bundle);

  private:
    using Key = std::tuple<std::string, std::string, std::string>;  // device, equation, variant

    [[nodiscard]] std::vector<std::string> devices();
    void report(const BrokenDriver& driver);
    void run_on(const std::string& device);
    void show_progress() const;

    const CheckOptions& options_;
    std::vector<CheckTask> tasks_;
    std::map<Key, check::Answer> known_;
    record::Journal journal_;
    std::optional<record::OutputFolder> failures_;
    std::vector<record::CheckReport> reports_;
    std::size_t done_ = 0;  // checks, without those that are known
    std::size_t left_ = 0;
    std::function<void(double)> progress_;
};

// The device refuses to open, for example because no device has this name.
class DeviceRefused : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Runs every task in worker processes, so that a crash or hang of a driver affects only its task; or in this
// process, if the options say so. If a device cannot be opened any more, its run ends with an additional row,
// named "device", with the reason and the number of checks that were not run. Throws DeviceRefused before the
// first task only.
[[nodiscard]] record::CheckReport run_on_device(CheckRun& run, const CheckerOptions& checker);

// The row of a device that cannot be opened.
[[nodiscard]] check::Answer device_row(check::Reason reason, const std::string& error,
                                       std::size_t checks_left);

}  // namespace gloam::cli
