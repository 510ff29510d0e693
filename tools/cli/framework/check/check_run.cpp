// SPDX-License-Identifier: MIT
#include "cli/framework/check/check_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <mutex>
#include <thread>

#include "base/threads.hpp"
#include "cli/environment.hpp"
#include "cli/framework/check/worker.hpp"
#include "cli/framework/open_device.hpp"
#include "cli/progress.hpp"
#include "record/answer_json.hpp"

namespace gloam::cli {
namespace {

using judge::Answer;

// The conditions under which --resume goes on from a journal.
std::string journal_heading(const CheckOptions& options) {
    const nlohmann::ordered_json heading{{"check_journal", 2},
                                         {"versions", versions()},
                                         {"inputs", options.task.run.inputs},
                                         {"seed", options.task.run.seed},
                                         {"validation", options.validation}};
    return heading.dump();
}

// A line of the journal.
struct JournalRow {
    std::string device;
    Answer row;
};

GLOAM_MEMBERS(JournalRow, device, row)

// One worker for each core, unless the work is too short for another worker's start.
unsigned jobs_of(const CheckOptions& options, std::size_t checks) {
    constexpr std::size_t checks_that_pay = 64;
    constexpr std::size_t most = 16;
    if (options.in_process) return 1;
    const std::size_t jobs = std::min({checks / checks_that_pay, std::size_t{base::processors()}, most});
    return static_cast<unsigned>(std::max<std::size_t>(options.jobs == 0 ? jobs : options.jobs, 1));
}

constexpr std::size_t most_hangs = 5;  // in a row, before a device is given up

// The row of a device that cannot be opened, or is given up.
Answer device_row(judge::Reason reason, const std::string& error, std::size_t checks_left) {
    Answer row{{.equation = "device"}};
    row.error = fmt::format("the device does not answer, {} checks were not run: {}", checks_left, error);
    row.reason = reason;
    return row;
}

// The one that --device selects. Throws std::runtime_error where that is a name of devices of several
// drivers.
const backend::DeviceInfo& device_named(const std::vector<backend::DeviceInfo>& all,
                                        const std::string& selector) {
    const backend::DeviceInfo& found = all[backend::vulkan::select_device(all, selector)];
    if (selector.empty() || selector == std::to_string(found.index)) return found;
    std::string others;
    for (const backend::DeviceInfo& device : all)
        if (device.name == found.name && device.manifest != found.manifest)
            others += fmt::format(", {} of {}", device.index, device.manifest);
    if (others.empty()) return found;
    throw std::runtime_error(
        fmt::format("--device {}: there are {} of {}{}: expected an index, or --driver FILE", selector,
                    found.index, found.manifest, others));
}

// The workers and rows of one device, which its threads share.
struct Shared {
    CheckOptions options;
    std::map<std::thread::id, Worker> workers = {};  // each lives and dies with its thread
    std::vector<std::optional<Answer>> rows = {};    // of the tasks
    std::size_t reported = 0;                        // of these
    std::optional<NoWorker> given_up = {};           // why no more tasks are begun
    std::size_t hangs = 0;                           // of the last tasks, in a row
    std::mutex mutex = {};

    // The worker of this thread.
    Worker& worker() { return workers.try_emplace(std::this_thread::get_id(), options).first->second; }
};

// The checks of one call of `gloam check`, on one device after the other.
class CheckRun {
  public:
    CheckRun(const CheckOptions& options, const std::vector<CheckTask>& tasks)
        : options_(options),
          tasks_(tasks),
          journal_(options.journal(), journal_heading(options), options.resume,
                   [this](std::string_view line) {
                       const auto kept = record::from_line<JournalRow>(line);
                       // A hang or a crash can have other causes than the driver, so it is tried again.
                       if (kept.row.ran())
                           known_[{kept.device, kept.row.equation, kept.row.variant}] = kept.row;
                   }),
          progress_(progress_bar("checks", options.progress)) {
        if (!options.failures.empty()) failures_.emplace(options.failures);
    }
    ~CheckRun() { progress_(-1.0); }
    CheckRun(const CheckRun&) = delete;
    CheckRun& operator=(const CheckRun&) = delete;

    // What --device stands for, each with its driver's manifest if that is named. Adds a report for each
    // broken driver.
    [[nodiscard]] std::vector<backend::DeviceInfo> devices() {
        std::vector<backend::DeviceInfo> all;
        if (options_.device == every_opengl) {
            for (const std::string& name : gl_device_names()) all.push_back({.name = name});
            return all;
        }
        if (options_.device == subject::interpreter_name || is_opengl(options_.device))
            return {{.name = options_.device}};
        const Drivers drivers = load_drivers();
        for (const BrokenDriver& driver : drivers.broken) {
            if (options_.device != "all" && !drivers.devices.empty()) {
                say_skipped(driver);
                continue;
            }
            reports.push_back({.device = {.name = "driver " + driver.manifest.string()}, .rows = {}});
            begin();
            add(device_row(driver.reason, driver.error, tasks_.size()));
        }
        if (options_.device == "all")
            all = drivers.devices;
        else if (!drivers.devices.empty())
            all = {device_named(drivers.devices, options_.device)};
        if (!all.empty() || !drivers.broken.empty()) return all;
        if (options_.device == "all" && !drivers.error.empty()) throw std::runtime_error(drivers.error);
        return {{}};  // opening it reports why there is none
    }

    // Adds the report of a device. Throws NoWorker if that is the only one and refuses to open.
    void run_on(const backend::DeviceInfo& device) {
        Shared shared{.options = options_};
        const std::size_t at = device.manifest.empty() ? device.index : device.of_manifest;
        shared.options.device = device.type.empty() ? device.name : std::to_string(at);
        shared.options.manifest = device.manifest;
        record::CheckReport& report = reports.emplace_back();
        try {
            report.device = shared.worker().device();
        } catch (const NoWorker& none) {
            const bool refuses = none.reason == judge::Reason::error;
            if (refuses && options_.device != "all" && options_.device != every_opengl) throw;
            report.device = {.name = device.name.empty() ? "default" : device.name,
                             .manifest = device.manifest,
                             .driver = device.driver,
                             .type = device.type,
                             .api_version = device.api_version};
            return add(device_row(none.reason, none.what(), tasks_.size()));
        }
        begin();
        for (const CheckTask& task : tasks_) {
            const auto known = known_.find(key_of(task.identity));
            const bool holds = known != known_.end() && !(known->second.failed() && failures_);
            shared.rows.push_back(holds ? std::optional(known->second) : std::nullopt);
        }
        take_next(shared);
        base::for_each_index(tasks_.size(), jobs_of(options_, tasks_.size()),
                             std::bind_front(&CheckRun::run_task, this, std::ref(shared)));
        for (std::size_t i = 0; i < tasks_.size(); ++i) {
            if (!shared.rows[i]) continue;
            if (i >= shared.reported) take(*shared.rows[i]);
            report.rows.push_back(std::move(*shared.rows[i]));
        }
        if (const auto& none = shared.given_up; none && report.rows.size() < tasks_.size())
            add(device_row(none->reason, none->what(), tasks_.size() - report.rows.size()));
    }

    std::vector<record::CheckReport> reports;
    std::size_t left = 0;  // checks; for the progress

  private:
    // Of equation and variant, on the device of the last report.
    using Key = std::array<std::string, 3>;
    [[nodiscard]] Key key_of(const judge::AnswerIdentity& row) const {
        return {last_device(), row.equation, row.variant};
    }
    // The name of the last report's device, and which of that name it is.
    [[nodiscard]] std::string last_device() const {
        const auto name = [](const record::CheckReport& report) { return record::name_of(report.device); };
        const auto alike = std::ranges::count(reports, name(reports.back()), name);
        return name(reports.back()) + (alike > 1 ? fmt::format(" {}", alike) : "");
    }

    // Names the last report's device.
    void begin() {
        progress_(-1.0);
        if (options_.rows) {
            fmt::print("device: {}\nversions: {}\n{}\n", record::name_of(reports.back().device), versions(),
                       record::table_header());
            std::fflush(stdout);
        }
        show_progress();
    }

    // Runs a task, and prepares its failure for a report; on any thread.
    void run_task(Shared& shared, std::size_t number) {
        std::unique_lock lock(shared.mutex);
        if (shared.rows[number] || shared.given_up) return;
        Worker& worker = shared.worker();
        lock.unlock();
        const CheckTask& task = tasks_[number];
        try {
            const Answer row = worker.run(task);
            lock.lock();
            shared.rows[number] = row;
            shared.hangs = row.reason == judge::Reason::hang ? shared.hangs + 1 : 0;
            if (shared.hangs == most_hangs)
                shared.given_up = NoWorker(fmt::format("{} checks in a row hung", most_hangs), row.reason);
            take_next(shared);
            if (!row.failed() || !failures_) return;
            lock.unlock();
            const record::FailureBundle bundle = worker.bundle(task, row);
            lock.lock();
            const record::DeviceSummary& on = reports.back().device;
            write_failure(*failures_, last_device(), on, row, bundle, command_for(options_, on, row));
        } catch (const NoWorker& none) {
            lock.lock();
            if (!shared.given_up) shared.given_up = none;
        }
    }

    // Takes the rows that come next, in the order of the tasks.
    void take_next(Shared& shared) {
        while (shared.reported < tasks_.size() && shared.rows[shared.reported])
            take(*shared.rows[shared.reported++]);
    }

    // Keeps and prints a row of the last report.
    void take(const Answer& row) {
        const bool is_known = known_.contains(key_of(row));
        if (!is_known) journal_.add(record::line_of(JournalRow{last_device(), row}));
        progress_(-1.0);
        if (options_.rows && row.reason != judge::Reason::unchanged) {  // which step_summary() counts
            std::string verdict = record::verdict_of(row);
            if (row.passed() || row.failed()) verdict = colored(verdict, row.passed() ? Ink::good : Ink::bad);
            fmt::print("{}\n", record::table_line(row, verdict));
            std::fflush(stdout);
        }
        if (left > 0) --left;
        if (!is_known) ++done_;  // what is known took no time
        show_progress();
    }

    void add(const Answer& row) {
        reports.back().rows.push_back(row);
        take(row);
    }

    void show_progress() const {
        progress_(static_cast<double>(done_) / static_cast<double>(std::max<std::size_t>(done_ + left, 1)));
    }

    const CheckOptions& options_;
    const std::vector<CheckTask>& tasks_;
    std::map<Key, Answer> known_;  // rows of an earlier run
    record::Journal journal_;
    std::optional<record::OutputFolder> failures_;
    std::size_t done_ = 0;  // checks, without those that are known
    std::function<void(double)> progress_;
};

}  // namespace

std::vector<record::CheckReport> run_tasks(const CheckOptions& options, const std::vector<CheckTask>& tasks) {
    CheckRun run(options, tasks);
    const std::vector<backend::DeviceInfo> devices = run.devices();
    run.left = tasks.size() * devices.size();
    for (const backend::DeviceInfo& device : devices) run.run_on(device);
    return std::move(run.reports);
}

}  // namespace gloam::cli
