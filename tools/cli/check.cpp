// SPDX-License-Identifier: MIT
#include "cli/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include "catalogue/catalogue.hpp"
#include "cli/check/failure_folders.hpp"
#include "cli/check/own_file.hpp"
#include "cli/check/run_device.hpp"
#include "cli/check/shard.hpp"
#include "cli/check/worker.hpp"
#include "cli/driver_probe.hpp"
#include "cli/drivers.hpp"
#include "cli/variant.hpp"
#include "cli/versions.hpp"
#include "report/check_report.hpp"
#include "report/output_file.hpp"

namespace gloam::cli {
namespace {

std::vector<std::string> devices_to_check(const std::string& device) {
    if (device != "all") return {device};
    std::vector<std::string> all;
    const std::size_t count = count_devices();
    for (std::size_t i = 0; i < count; ++i) all.push_back(std::to_string(i));
    if (all.empty()) all.emplace_back();  // opening the default then says that there is none
    return all;
}

// Every equation in every variant that was asked for, of which this shard takes its share.
std::vector<CheckTask> tasks_of(const CheckOptions& options) {
    const Shard shard = shard_from(options.shard);
    const catalogue::Entries entries = catalogue::select(catalogue::all_entries(), options.equations);
    std::vector<CheckTask> tasks;
    std::size_t position = 0;
    for (const shader::Variant& variant : select_variants(options.variant)) {
        for (const catalogue::Entry& entry : entries) {
            if (!shard.holds(position++)) continue;
            tasks.push_back({.equation = entry.description.id,
                             .variant = variant.name,
                             .inputs = options.inputs,
                             .seed = options.seed});
        }
    }
    return tasks;
}

void print_device(const report::DeviceSummary& device) {
    fmt::print("device: {}\nversions: {}\n{}\n", report::name_of(device), versions(), report::table_header());
    std::fflush(stdout);
}

void print_row(const report::CheckRow& row) {
    fmt::print("{}\n", report::table_line(row));
    std::fflush(stdout);
}

// What runs this check again, to the bit: the same inputs on the same device.
std::string command_for(const CheckOptions& options, const report::DeviceSummary& device,
                        const report::CheckRow& row) {
    std::string command = fmt::format("gloam check {} --variant {} --device {} --inputs {} --seed {}",
                                      report::shell_word(row.equation), report::shell_word(row.variant),
                                      report::shell_word(device.name), options.inputs, options.seed);
    for (const auto& driver : drivers_asked_for())
        command += " --driver " + report::shell_word(driver.string());
    return options.validation ? command + " --validation" : command;
}

void print_failure(const CheckOptions& options, const report::DeviceSummary& device,
                   const report::CheckRow& row) {
    fmt::print("\n{} {}: {}\n", row.equation, row.variant, row.ran() ? row.story : row.error);
    if (row.variant.empty()) return;  // the device itself
    fmt::print("run it again: {}\n", command_for(options, device, row));
}

report::CheckReport check_device(const CheckOptions& options, const std::string& device,
                                 const std::vector<CheckTask>& tasks, FailureFolders& failures) {
    const auto timeout = std::chrono::milliseconds(std::max(1L, std::lround(options.timeout * 1000.0)));
    DeviceRun run{.checker = {.device = device, .validation = options.validation, .timeout = timeout},
                  .tasks = tasks,
                  .timeout = timeout,
                  .jobs = options.jobs,
                  .in_process = options.in_process,
                  .on_device = print_device,
                  .on_row = print_row,
                  .on_failure = {}};
    if (failures.wanted()) {
        run.on_failure = [&](const auto& on, const auto& row, const HandOver& failure) {
            failures.write(on, row, failure, {command_for(options, on, row), versions()});
        };
    }
    try {
        return run_on_device(run);
    } catch (const DeviceRefused& refused) {
        if (options.device != "all") throw;
        report::CheckReport report{.device = {.name = "device " + device},
                                   .rows = {device_row(report::Reason::error, refused.what(), tasks.size())}};
        print_row(report.rows.front());
        return report;
    }
}

}  // namespace

// A driver that does not even load costs itself alone: its row, where it was to be checked, and a line.
std::vector<report::CheckReport> reports_of_bad_drivers(const CheckOptions& options, std::size_t checks) {
    std::vector<report::CheckReport> reports;
    const LeftOut left_out = leave_out_bad_drivers();
    if (!left_out.others) return reports;  // opening a device says what is wrong
    for (const DriverTrouble& driver : left_out.drivers) {
        const std::string name = "driver " + driver.manifest.string();
        if (options.device != "all" && !driver.asked_for) {
            fmt::print(stderr, "gloam: Vulkan {}: {}; it is left out\n", name, driver.error);
            continue;
        }
        reports.push_back(
            {.device = {.name = name}, .rows = {device_row(driver.reason, driver.error, checks)}});
        print_device(reports.back().device);
        print_row(reports.back().rows.front());
    }
    return reports;
}

// The functions of a shader file, by the rules alone.
int run_check_of_file(const CheckOptions& options) {
    const report::OutputFile json(options.json);
    const report::OutputFile junit(options.junit);
    std::vector<report::CheckReport> reports;
    std::size_t failures = 0;
    std::size_t checks = 0;
    for (const std::string& device : devices_to_check(options.device)) {
        reports.push_back(check_own_file(
            {.file = options.equations.front(),
             .functions = {options.equations.begin() + 1, options.equations.end()},
             .ranges = options.ranges,
             .device = device,
             .variants = select_variants(options.variant),
             .inputs = options.inputs,
             .seed = options.seed,
             .validation = options.validation,
             .timeout = std::chrono::milliseconds(std::max(1L, std::lround(options.timeout * 1000.0))),
             .on_device = print_device,
             .on_row = print_row}));
        failures += reports.back().failures();
        checks += reports.back().rows.size();
        for (const report::CheckRow& row : reports.back().rows)
            if (!row.passed())
                fmt::print("\n{} {}: {}\n", row.function, row.variant, row.ran() ? row.story : row.error);
    }
    fmt::print("{} checks, {} failed\n", checks, failures);
    for (report::CheckReport& report : reports) report.versions = versions();
    json.write(report::to_json(reports));
    junit.write(report::to_junit(reports));
    return failures == 0 ? 0 : 1;
}

int run_check(const CheckOptions& options) {
    if (!options.equations.empty() && is_shader_file(options.equations.front()))
        return run_check_of_file(options);
    if (!options.ranges.empty()) throw std::invalid_argument("--range is for the functions of a shader file");
    const std::vector<CheckTask> tasks = tasks_of(options);
    const report::OutputFile json(options.json);
    const report::OutputFile junit(options.junit);
    FailureFolders failed(options.failures);
    std::vector<report::CheckReport> reports = reports_of_bad_drivers(options, tasks.size());
    std::size_t failures = reports.size();
    std::size_t checks = reports.size();
    for (const std::string& device : devices_to_check(options.device)) {
        reports.push_back(check_device(options, device, tasks, failed));
        failures += reports.back().failures();
        checks += reports.back().rows.size();
    }
    for (const report::CheckReport& report : reports) {
        for (const report::CheckRow& row : report.rows) {
            if (!row.passed()) print_failure(options, report.device, row);
        }
    }
    fmt::print("{} checks, {} failed\n", checks, failures);
    for (report::CheckReport& report : reports) report.versions = versions();
    json.write(report::to_json(reports));
    junit.write(report::to_junit(reports));
    return failures == 0 ? 0 : 1;
}

void add_check(CLI::App& app, int& status) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command =
        app.add_subcommand("check", "run equations on a Vulkan device and judge every result");
    command->add_option(
        "equation", options->equations,
        "IDs, functions or globs (all when none is given); or a GLSL file of your own, and its functions");
    command->add_option("--range", options->ranges,
                        "NAME=LOW:HIGH: what a parameter of your own file's functions is drawn from");
    command->add_option("--device", options->device, "name or index of the device, or all");
    command
        ->add_option("--variant", options->variant,
                     "how the shaders are compiled (gloam list variants), or all")
        ->capture_default_str();
    command->add_option("--inputs", options->inputs, "inputs for each equation")
        ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "seed of the inputs")->capture_default_str();
    command->add_option("--shard", options->shard,
                        "INDEX/COUNT: run only this share of the checks, counted from 0 "
                        "(default: GTEST_SHARD_INDEX of GTEST_TOTAL_SHARDS)");
    command->add_flag("--validation", options->validation,
                      "Vulkan validation layers on; any message fails the check");
    command
        ->add_option("--timeout", options->timeout,
                     "seconds that one check may take; more is a hang, and costs that check")
        ->check(CLI::Range(0.001, 1e6))
        ->capture_default_str();
    CLI::Option* jobs = command->add_option("--jobs", options->jobs, "worker processes for each device")
                            ->check(CLI::Range(std::size_t{1}, std::size_t{1024}))
                            ->capture_default_str();
    command
        ->add_flag("--in-process", options->in_process,
                   "no worker processes, for a debugger: a driver that crashes then ends the whole run")
        ->excludes(jobs);
    command->add_option("--json", options->json, "write the results to this file");
    command->add_option("--junit", options->junit, "write the results as JUnit XML");
    command->add_option("--failures", options->failures,
                        "folder that receives each failure ready to report: the smallest input found, the "
                        "shader, an AmberScript");
    add_driver_option(*command);
    command->callback([options, &status] { status = run_check(*options); });
}

}  // namespace gloam::cli
