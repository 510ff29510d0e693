// SPDX-License-Identifier: MIT
#include "cli/framework/check.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <thread>
#include <tuple>

#include "backend/gl/device.hpp"
#include "base/text.hpp"
#include "base/threads.hpp"
#include "cli/environment.hpp"
#include "cli/framework/check/checker.hpp"
#include "cli/framework/check/hand_over.hpp"
#include "cli/framework/check/run_device.hpp"
#include "cli/framework/check/selection.hpp"
#include "cli/framework/check/worker_session.hpp"
#include "cli/framework/open_device.hpp"
#include "cli/progress.hpp"
#include "record/check_page.hpp"
#include "record/check_report.hpp"
#include "record/output.hpp"

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

void print_failure(const CheckOptions& options, const record::DeviceSummary& device,
                   const check::Answer& row) {
    fmt::print("\n{} {}: {}\n", row.equation, row.variant, row.ran() ? row.story : row.error);
    if (row.variant.empty()) return;  // the device itself
    fmt::print("run it again: {}\n", command_for(options, device, row));
}

void print_coverage(const record::CheckReport& report) {
    for (const check::Answer& row : report.rows)
        if (row.coverage) fmt::print("{} {}: {}\n", row.equation, row.variant, to_text(*row.coverage));
}

// What a table would say of what was not judged.
void print_not_judged(const CheckOutcome& outcome) {
    for (const record::CheckReport& report : outcome.reports)
        for (const check::Answer& row : report.rows)
            if (row.outcome() == check::Outcome::not_judged && row.reason != check::Reason::unchanged)
                fmt::print("{} {}: not judged: {}\n", row.equation, row.variant,
                           base::one_line(row.ran() ? row.not_judged_because() : row.error));
}

// Inputs for which a user's function has no defined result.
void print_undefined(const record::CheckReport& report) {
    for (const check::Answer& row : report.rows)
        if (row.undefined > 0)
            fmt::print("{} {}: {} {} of {} inputs, which were not judged: {}\n", row.equation, row.variant,
                       row.no_result == check::NoResult::too_long ? "it takes too long for"
                                                                  : "the result is undefined for",
                       row.undefined, row.inputs(), row.first_undefined);
}

// What helps where the usual inputs of a user's function could not be judged.
void print_range_hint(const CheckOptions& options, const record::OutcomeCounts& counts) {
    if (counts.not_judged > 0 && is_of_file(options) && options.ranges.empty())
        fmt::print("--range PARAMETER=LOW:HIGH limits the inputs to those that a function is made for\n");
}

// One worker for each core, unless the work is too short for another worker's start.
std::size_t jobs_of(const CheckOptions& options, std::size_t checks) {
    constexpr std::size_t checks_that_pay = 64;
    constexpr std::size_t most = 16;
    if (options.jobs > 0) return options.jobs;
    const std::size_t cores = std::min<std::size_t>(base::processors(), most);
    return std::clamp<std::size_t>(checks / checks_that_pay, 1, cores);
}

// The journal of the rows while the check runs, from which --resume continues a run that was killed; empty if
// no result file is written.
std::filesystem::path journal_of(const CheckOptions& options) {
    return options.json.empty() ? "" : options.json.string() + ".journal";
}

// The conditions under which it does.
std::string journal_heading(const CheckOptions& options) {
    const nlohmann::ordered_json heading{{"check_journal", 2},
                                         {"versions", versions()},
                                         {"inputs", options.inputs},
                                         {"seed", options.seed},
                                         {"validation", options.validation}};
    return heading.dump();
}

// Prints rows as they come, writes them to the journal, and shows the progress.
class CheckRun {
  public:
    CheckRun(const CheckOptions& options, std::vector<CheckTask> tasks, std::size_t devices)
        : options_(options),
          tasks_(std::move(tasks)),
          journal_(journal_of(options), journal_heading(options), options.resume,
                   [this](std::string_view line) { take_over(record::from_line<JournalRow>(line)); }),
          failures_(options.failures),
          left_(tasks_.size() * devices),
          progress_(progress_bar("checks", options.progress)) {}

    ~CheckRun() { progress_(-1.0); }

    record::CheckReport on_device(const std::string& device) {
        DeviceRun run{.checker = {.equations = options_.named,
                                  .device = device,
                                  .validation = options_.validation,
                                  .timeout = std::chrono::milliseconds(
                                      std::max(1L, std::lround(options_.timeout * 1000.0)))},
                      .tasks = tasks_,
                      .jobs = jobs_of(options_, tasks_.size()),
                      .in_process = options_.in_process,
                      .known = [this](const auto& on, const CheckTask& task) { return known(on, task); },
                      .on_device = [this](const auto& on) { begin(on); },
                      .on_row = [this](const auto& on, const auto& row) { take(on, row); },
                      .on_failure = {}};
        if (failures_.wanted()) {
            run.on_failure = [this](const auto& on, const auto& row, const HandOver& failure) {
                failures_.write(on, row, failure, {command_for(options_, on, row), versions()});
            };
        }
        try {
            return run_on_device(run);
        } catch (const DeviceRefused& refused) {
            if (options_.device != "all" && options_.device != every_opengl) throw;
            record::CheckReport report{
                .device = {.name = "device " + device},
                .rows = {device_row(check::Reason::error, refused.what(), tasks_.size())}};
            if (options_.rows) print_row(report.rows.front());
            return report;
        }
    }

  private:
    using Key = std::tuple<std::string, std::string, std::string>;  // device, equation, variant

    // A hang or a crash can have other causes than the driver, so the check is tried again.
    void take_over(const JournalRow& kept) {
        if (kept.row.ran()) known_[{kept.device, kept.row.equation, kept.row.variant}] = kept.row;
    }

    // The row of an earlier run. A failure is run again if it is to be prepared for a report.
    [[nodiscard]] std::optional<check::Answer> known(const record::DeviceSummary& on,
                                                     const CheckTask& task) const {
        const auto found = known_.find({record::name_of(on), task.equation, task.variant});
        if (found == known_.end() || (found->second.failed() && failures_.wanted())) return std::nullopt;
        return found->second;
    }

    void begin(const record::DeviceSummary& on) {
        progress_(-1.0);
        if (options_.rows) print_device(on);
        show_progress();
    }

    void take(const record::DeviceSummary& on, const check::Answer& row) {
        const bool is_known = known_.contains({record::name_of(on), row.equation, row.variant});
        if (!is_known) journal_.add(record::line_of(JournalRow{record::name_of(on), row}));
        progress_(-1.0);
        if (options_.rows) print_row(row);
        if (left_ > 0) --left_;
        if (!is_known) ++done_;  // what is known took no time
        show_progress();
    }

    void show_progress() const {
        progress_(static_cast<double>(done_) / static_cast<double>(std::max<std::size_t>(done_ + left_, 1)));
    }

    const CheckOptions& options_;
    std::vector<CheckTask> tasks_;
    std::map<Key, check::Answer> known_;
    record::Journal journal_;
    FailureFolders failures_;
    std::size_t done_ = 0;  // checks, without those that are known
    std::size_t left_;
    std::function<void(double)> progress_;
};

// A broken driver is reported by a row, if it was selected, and by a line; others are not affected.
std::vector<record::CheckReport> reports_of(const std::vector<BrokenDriver>& broken,
                                            const CheckOptions& options, std::size_t checks) {
    std::vector<record::CheckReport> reports;
    for (const BrokenDriver& driver : broken) {
        if (options.device != "all" && std::ranges::count(drivers_asked_for(), driver.manifest) == 0) {
            say_skipped(driver);
            continue;
        }
        reports.push_back({.device = {.name = "driver " + driver.manifest.string()},
                           .rows = {device_row(driver.reason, driver.error, checks)}});
        if (!options.rows) continue;
        print_device(reports.back().device);
        print_row(reports.back().rows.front());
    }
    return reports;
}

// What --device stands for. Adds a report for each broken driver.
std::vector<std::string> devices_to_check(const CheckOptions& options, std::size_t checks,
                                          std::vector<record::CheckReport>& reports) {
    if (options.device == every_opengl) return gl_device_names();
    if (options.device == check::interpreter_name || is_opengl(options.device)) return {options.device};
    const Drivers drivers = load_drivers();
    if (!drivers.devices.empty()) reports = reports_of(drivers.broken, options, checks);
    // Otherwise opening the default device reports why there is none.
    if (options.device != "all") return {options.device};
    if (drivers.devices.empty() && !drivers.error.empty()) throw std::runtime_error(drivers.error);
    std::vector<std::string> all;
    for (const backend::DeviceInfo& device : drivers.devices) all.push_back(std::to_string(device.index));
    if (all.empty()) all.emplace_back();
    return all;
}

// Adds the reports to the outcome, and what was left out.
void run_devices(const CheckOptions& options, CheckOutcome& outcome) {
    if (is_of_file(options) && options.resume)
        throw std::invalid_argument("--resume is for equations, not for a shader file");
    if (!is_of_file(options) && !options.ranges.empty())
        throw std::invalid_argument("--range is for the functions of a shader file");
    if (!is_of_file(options) && !options.includes.empty())
        throw std::invalid_argument("--include is for a shader file");
    if (!is_of_file(options) && !options.defines.empty())
        throw std::invalid_argument("--define is for a shader file");
    std::vector<CheckTask> tasks = tasks_of(options, outcome);
    std::vector<record::CheckReport>& reports = outcome.reports;
    const std::vector<std::string> devices = devices_to_check(options, tasks.size(), reports);
    CheckRun run(options, std::move(tasks), devices.size());
    for (const std::string& device : devices) reports.push_back(run.on_device(device));
}

}  // namespace

CheckOutcome check(const CheckOptions& options) {
    const record::OutputFile json(options.json);
    const record::OutputFile junit(options.junit);
    const record::OutputFile html(options.html);
    CheckOutcome outcome;
    run_devices(options, outcome);
    for (record::CheckReport& report : outcome.reports) {
        report.versions = versions();
        report.inputs = options.inputs;
        report.seed = options.seed;
    }
    outcome.counts = counts_of(outcome.reports);
    json.write(record::to_json(outcome.reports));
    junit.write(record::to_junit(outcome.reports));
    html.write(record::to_check_page(outcome.reports));
    if (!options.json.empty()) {      // the results are now in the result file
        std::error_code still_there;  // harmless: the next run starts it anew
        std::filesystem::remove(journal_of(options), still_there);
    }
    return outcome;
}

namespace {

// Runs check() and prints the story of each failure. Returns the exit status: 0, 1 or 2; 2 for an outcome
// that is not complete, unless a check failed.
int run_check(const CheckOptions& options) {
    const CheckOutcome outcome = check(options);
    for (const record::CheckReport& report : outcome.reports) {
        for (const check::Answer& row : report.rows) {
            if (row.failed()) print_failure(options, report.device, row);
        }
    }
    if (options.rows)
        fmt::print("\n{}", record::table_legend());
    else
        print_not_judged(outcome);
    fmt::print("{}", step_summary(outcome.reports));
    for (const record::CheckReport& report : outcome.reports) print_coverage(report);
    for (const record::CheckReport& report : outcome.reports) print_undefined(report);
    for (const std::string& note : outcome.notes) fmt::print("{}\n", note);
    print_range_hint(options, outcome.counts);
    const int status = outcome.counts.exit_status();
    fmt::print("{}\n", colored(to_text(outcome.counts), status == 0 ? Ink::good : Ink::bad));
    return status == 0 && !outcome.complete ? 2 : status;
}

// What is checked, in which variants; how much of it, and how; files, and what is printed.
std::vector<Option> options_of(CheckOptions& options) {
    return {
        {"equation", &options.equations,
         "IDs, functions or globs (all when none is given), PASS-* for whole passes; or a GLSL file of your "
         "own, and its functions"},
        {"--range", &options.ranges,
         "NAME=LOW:HIGH: what a parameter of your own file's functions is drawn from"},
        include_option(options.includes),
        define_option(options.defines),
        {"--device", &options.device,
         "name or index of the device, or all: every Vulkan device; gl: every OpenGL and OpenGL ES device, "
         "or one's name; interpreter: no driver, every operation correctly rounded"},
        {"--variant", &options.variant, "how the shaders are compiled (gloam list variants), or all"},
        {"--compiler", &options.compilers,
         "steps that the modules take, judged by the modules before them: 'spirv-opt --ccp', 'spirv-opt "
         "{each}', a program with {in} or {glsl} and {out}; several joined by ' | '"},
        {"--inputs", &options.inputs, between(1, 1e8), "inputs for each equation"},
        {"--seed", &options.seed, "seed of the inputs"},
        {"--shard", &options.shard,
         "INDEX/COUNT: run only this part of the checks, counted from 0 (default: GTEST_SHARD_INDEX of "
         "GTEST_TOTAL_SHARDS)"},
        {"--coverage", &options.coverage, "report which lines and branches of the GLSL the inputs reach"},
        {"--validation", &options.validation, "Vulkan validation layers on; any message fails the check"},
        {"--timeout", &options.timeout, between(0.001, 1e6),
         "seconds that one check may take; one that takes longer is stopped and reported as a hang"},
        {"--jobs",
         &options.jobs,
         {.range = {{1, 1024}}, .shown = "one a core, fewer for a short check"},
         "worker processes for each device"},
        {"--in-process", &options.in_process, excludes("--jobs"),
         "no worker processes, for a debugger: a driver that crashes then ends the whole run"},
        {std::string(bisect_option), [] {},
         "for git bisect run: status 125 instead of 2, so that a build that cannot be judged is skipped"},
        {"--json", &options.json,
         "write the results to this file; until the run has ended, FILE.journal holds the results so far"},
        {"--resume", &options.resume, needs("--json"), "run only the checks that FILE.journal lacks"},
        {"--junit", &options.junit, "write the results as JUnit XML"},
        {"--html", &options.html, "write the results as a page: sortable, filterable, in one file"},
        {"--quiet", [&options] { options.rows = options.progress = false; },
         "print only the failures and the count"},
        {"--failures", &options.failures,
         "folder that receives each failure ready to report: the smallest input found, the shader, a program "
         "in C, an AmberScript"},
        driver_option()};
}

}  // namespace

Command check_command(EquationsNamed* equations) {
    static CheckOptions options{.named = equations};
    return {
        .name = "check",
        .about = "run equations on a Vulkan or OpenGL device and judge every result",
        .options = options_of(options),
        .run =
            [] {
                if (!options.compilers.empty() && options.device.empty())
                    options.device = check::interpreter_name;
                return run_check(options);
            },
        .examples =
            "  gloam check                                          every equation on the default device\n"
            "  gloam check 'gloam_linear_depth_*' 'TSSAO-*'         some of them\n"
            "  gloam check --device all --variant all --html r.html every device, every compiler setting\n"
            "  gloam check --quiet --junit results.xml              for continuous integration\n"
            "  gloam check --failures failures                      each failure ready to report\n"
            "  gloam check shader.frag 'luma(vec3)' --range c=0:1   a function of a file of your own\n"};
}

}  // namespace gloam::cli
