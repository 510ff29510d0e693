// SPDX-License-Identifier: MIT
#include "cli/framework/check/check_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "cli/framework/check/selection.hpp"
#include "cli/progress.hpp"

namespace gloam::cli {
namespace {

void print_device(const record::DeviceSummary& device) {
    fmt::print("device: {}\nversions: {}\n{}\n", record::name_of(device), versions(), record::table_header());
    std::fflush(stdout);
}

void print_row(const check::Answer& row) {
    std::string verdict = record::verdict_of(row);
    if (row.passed() || row.failed()) verdict = colored(verdict, row.passed() ? Ink::good : Ink::bad);
    if (row.reason == check::Reason::unchanged) return;  // there are many, and step_summary() counts them
    fmt::print("{}\n", record::table_line(row, verdict));
    std::fflush(stdout);
}

// The conditions under which --resume goes on from a journal.
std::string journal_heading(const CheckOptions& options) {
    const nlohmann::ordered_json heading{{"check_journal", 2},
                                         {"versions", versions()},
                                         {"inputs", options.task.run.inputs},
                                         {"seed", options.task.run.seed},
                                         {"validation", options.validation}};
    return heading.dump();
}

}  // namespace

CheckRun::CheckRun(const CheckOptions& options, std::vector<CheckTask> tasks)
    : options_(options),
      tasks_(std::move(tasks)),
      journal_(options.journal(), journal_heading(options), options.resume,
               [this](std::string_view line) {
                   const auto kept = record::from_line<JournalRow>(line);
                   // A hang or a crash can have other causes than the driver, so the check is tried again.
                   if (kept.row.ran()) known_[{kept.device, kept.row.equation, kept.row.variant}] = kept.row;
               }),
      progress_(progress_bar("checks", options.progress)) {
    if (!options.failures.empty()) failures_.emplace(options.failures);
}

std::vector<record::CheckReport> CheckRun::run() {
    const std::vector<std::string> all = devices();
    left_ = tasks_.size() * all.size();
    for (const std::string& device : all) run_on(device);
    return std::move(reports_);
}

// What --device stands for. Adds a report for each broken driver.
std::vector<std::string> CheckRun::devices() {
    if (options_.device == every_opengl) return gl_device_names();
    if (options_.device == check::interpreter_name || is_opengl(options_.device)) return {options_.device};
    const Drivers drivers = load_drivers();
    if (!drivers.devices.empty())
        for (const BrokenDriver& driver : drivers.broken) report(driver);
    // Otherwise opening the default device reports why there is none.
    if (options_.device != "all") return {options_.device};
    if (drivers.devices.empty() && !drivers.error.empty()) throw std::runtime_error(drivers.error);
    std::vector<std::string> all;
    for (const backend::DeviceInfo& device : drivers.devices) all.push_back(std::to_string(device.index));
    if (all.empty()) all.emplace_back();
    return all;
}

// A broken driver is reported by a row, if it was selected, and by a line; others are not affected.
void CheckRun::report(const BrokenDriver& driver) {
    if (options_.device != "all" && std::ranges::count(drivers_asked_for(), driver.manifest) == 0)
        return say_skipped(driver);
    reports_.push_back({.device = {.name = "driver " + driver.manifest.string()},
                        .rows = {device_row(driver.reason, driver.error, tasks_.size())}});
    if (!options_.rows) return;
    print_device(reports_.back().device);
    print_row(reports_.back().rows.front());
}

void CheckRun::run_on(const std::string& device) {
    const auto timeout = std::max(1L, std::lround(options_.timeout * 1000.0));
    try {
        reports_.push_back(run_on_device(*this, {.equations = options_.named,
                                                 .device = device,
                                                 .validation = options_.validation,
                                                 .timeout = std::chrono::milliseconds(timeout)}));
    } catch (const DeviceRefused& refused) {
        if (options_.device != "all" && options_.device != every_opengl) throw;
        reports_.push_back({.device = {.name = "device " + device},
                            .rows = {device_row(check::Reason::error, refused.what(), tasks_.size())}});
        if (options_.rows) print_row(reports_.back().rows.front());
    }
}

std::optional<check::Answer> CheckRun::known(const record::DeviceSummary& on, const CheckTask& task) const {
    const auto row = known_.find({record::name_of(on), task.equation, task.variant});
    if (row == known_.end() || (row->second.failed() && wants_bundles())) return std::nullopt;
    return row->second;
}

void CheckRun::begin(const record::DeviceSummary& on) {
    progress_(-1.0);
    if (options_.rows) print_device(on);
    show_progress();
}

void CheckRun::take(const record::DeviceSummary& on, const check::Answer& row) {
    const bool is_known = known_.contains({record::name_of(on), row.equation, row.variant});
    if (!is_known) journal_.add(record::line_of(JournalRow{record::name_of(on), row}));
    progress_(-1.0);
    if (options_.rows) print_row(row);
    if (left_ > 0) --left_;
    if (!is_known) ++done_;  // what is known took no time
    show_progress();
}

void CheckRun::keep(const record::DeviceSummary& on, const check::Answer& failed,
                    const FailureBundle& bundle) {
    write_failure(*failures_, on, failed, bundle, {command_for(options_, on, failed), versions()});
}

void CheckRun::show_progress() const {
    progress_(static_cast<double>(done_) / static_cast<double>(std::max<std::size_t>(done_ + left_, 1)));
}

}  // namespace gloam::cli
