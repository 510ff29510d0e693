// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>

#include "catalogue/catalogue.hpp"
#include "cli/check/hand_over.hpp"
#include "cli/check/task.hpp"
#include "gpu/device.hpp"
#include "report/check_report.hpp"

namespace gloam::cli {

// The device on which checks run, and how.
struct CheckerOptions {
    std::string device;  // name or index; empty: the default
    bool validation = false;
    std::chrono::milliseconds timeout{60'000};  // longest wait for one submission
};

// A device as reports show it.
[[nodiscard]] report::DeviceSummary summary_of(const gpu::DeviceInfo& info);

// Runs checks in this process.
class Checker {
  public:
    // Opens the device. Throws as gpu::Device does.
    explicit Checker(CheckerOptions options);

    [[nodiscard]] report::DeviceSummary device() const;

    // Never throws for what goes wrong in a check: the row tells it. After Reason::device_lost and
    // Reason::hang the device is of no more use.
    [[nodiscard]] check::Answer run(const CheckTask& task);

    // Never throws for what goes wrong: HandOver::error tells it.
    [[nodiscard]] HandOver hand_over(const HandOverRequest& request);

  private:
    const check::Lab& lab(const std::string& variant, const std::filesystem::path& folder);
    const check::Lab& lab(const CheckTask& task);
    [[nodiscard]] check::Question question_of(const CheckTask& task);

    CheckerOptions options_;
    catalogue::Entries entries_;
    std::string variant_;           // that lab_ compiles
    std::filesystem::path folder_;  // of somebody's own files
    std::unique_ptr<check::Lab> lab_;
};

// What kind of thing went wrong, from an exception of the rooms.
[[nodiscard]] check::Reason reason_of(const std::exception& error);

// The answer of a check that did not run.
[[nodiscard]] check::Answer answer_without_result(const CheckTask& task, const catalogue::Entries& entries,
                                                  check::Reason reason, const std::string& error);

}  // namespace gloam::cli
