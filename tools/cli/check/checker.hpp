// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "cli/check/hand_over.hpp"
#include "cli/check/task.hpp"
#include "gpu/device.hpp"
#include "report/check_report.hpp"

namespace gloam::cli {

// The device for checks, and its options.
struct CheckerOptions {
    std::string device;  // name or index; empty: the default
    bool validation = false;
    std::chrono::milliseconds timeout{60'000};  // longest wait for one submission
};

// A device in the form of reports.
[[nodiscard]] report::DeviceSummary summary_of(const gpu::DeviceInfo& info);

// Runs checks in this process.
class Checker {
  public:
    // Opens the device. Throws like gpu::Device.
    explicit Checker(CheckerOptions options);

    [[nodiscard]] report::DeviceSummary device() const;

    // Runs a check. It does not throw for errors of the check; the row reports them. After
    // Reason::device_lost and Reason::hang the device cannot be used any more.
    [[nodiscard]] check::Answer run(const CheckTask& task);

    // Prepares a failure for a report. It does not throw for errors; HandOver::error reports them.
    [[nodiscard]] HandOver hand_over(const HandOverRequest& request);

  private:
    const check::Lab& lab(const std::string& variant, const std::vector<std::filesystem::path>& roots,
                          const std::filesystem::path& file);
    const check::Lab& lab(const CheckTask& task);
    [[nodiscard]] check::Question question_of(const CheckTask& task);

    CheckerOptions options_;
    catalogue::Entries entries_;
    std::string variant_;                       // that lab_ compiles
    std::vector<std::filesystem::path> roots_;  // in which it looks for includes
    std::filesystem::path file_;                // of a user
    std::unique_ptr<check::Lab> lab_;
};

// The kind of an error, from an exception of the rooms.
[[nodiscard]] check::Reason reason_of(const std::exception& error);

// The answer of a check that did not run.
[[nodiscard]] check::Answer answer_without_result(const CheckTask& task, const catalogue::Entries& entries,
                                                  check::Reason reason, const std::string& error);

}  // namespace gloam::cli
