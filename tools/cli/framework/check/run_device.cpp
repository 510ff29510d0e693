// SPDX-License-Identifier: MIT
#include "cli/framework/check/check_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>

#include "base/threads.hpp"
#include "cli/framework/check/worker_session.hpp"

namespace gloam::cli {
namespace {

using check::Answer;
using check::Reason;

std::string refusal_of(const std::string& greeting) {
    return record::from_line<Greeting>(greeting).error;
}

bool is_unusable_after(Reason reason) {
    return reason == Reason::device_lost || reason == Reason::hang || reason == Reason::out_of_memory;
}

// One worker for each core, unless the work is too short for another worker's start.
std::size_t jobs_of(std::size_t jobs, std::size_t checks) {
    constexpr std::size_t checks_that_pay = 64;
    constexpr std::size_t most = 16;
    if (jobs == 0) jobs = std::min({checks / checks_that_pay, std::size_t{base::processors()}, most});
    return std::clamp<std::size_t>(jobs, 1, std::max<std::size_t>(checks, 1));
}

// Distributes tasks to several threads and collects their rows; rows are reported in the order of the tasks.
class Board {
  public:
    Board(CheckRun& run, const record::DeviceSummary& device)
        : run_(run), device_(device), rows_(run.tasks().size()) {
        for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] = run.known(device, run.tasks()[i]);
        report_next();
    }

    std::optional<std::size_t> take() {
        const std::scoped_lock lock(mutex_);
        while (taken_ < rows_.size() && rows_[taken_]) ++taken_;  // known before
        if (given_up_ || trouble_ || taken_ == rows_.size()) return std::nullopt;
        return taken_++;
    }

    void put(std::size_t task, Answer row) {
        or_keep_trouble([&] {
            rows_[task] = std::move(row);
            report_next();
        });
    }

    void keep(const Answer& failed, const FailureBundle& bundle) {
        or_keep_trouble([&] { run_.keep(device_, failed, bundle); });
    }

    // Ends the distribution of tasks.
    void give_up(Reason reason, const std::string& error) {
        const std::scoped_lock lock(mutex_);
        if (!given_up_) given_up_ = {.line = {}, .reason = reason, .error = error};
    }

    // Returns all rows after all threads have ended. Throws what the run threw.
    std::vector<Answer> finish() {
        if (trouble_) std::rethrow_exception(trouble_);
        std::vector<Answer> all;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            if (!rows_[i]) continue;
            if (i >= reported_) run_.take(device_, *rows_[i]);
            all.push_back(std::move(*rows_[i]));
        }
        if (given_up_) {
            all.push_back(device_row(given_up_->reason, given_up_->error, rows_.size() - all.size()));
            run_.take(device_, all.back());
        }
        return all;
    }

  private:
    void report_next() {
        while (reported_ < rows_.size() && rows_[reported_]) run_.take(device_, *rows_[reported_++]);
    }

    // Keeps an exception of the work, so that finish() throws it on its own thread.
    template <class Work>
    void or_keep_trouble(const Work& work) {
        const std::scoped_lock lock(mutex_);
        try {
            work();
        } catch (...) {
            if (!trouble_) trouble_ = std::current_exception();
        }
    }

    CheckRun& run_;
    const record::DeviceSummary& device_;
    std::mutex mutex_;
    std::vector<std::optional<Answer>> rows_;
    std::size_t taken_ = 0;
    std::size_t reported_ = 0;
    std::optional<Reply> given_up_;
    std::exception_ptr trouble_;
};

// What a worker answers; where it answers nothing of the kind, `reply` has the reason. Throws NoWorker.
template <class T>
std::optional<T> answer_of(WorkerSession& session, const WorkerRequest& request, Reply& reply) {
    reply = session.ask(record::line_of(request));
    if (!reply.error.empty()) return std::nullopt;
    try {
        return record::from_line<T>(reply.line);
    } catch (const std::exception& error) {
        reply.reason = Reason::error;
        reply.error = fmt::format("the worker's answer makes no sense: {}", error.what());
        session.dismiss();
        return std::nullopt;
    }
}

Answer row_of(WorkerSession& session, const CheckTask& task, const std::vector<check::Question>& equations) {
    const auto begin = std::chrono::steady_clock::now();
    Reply reply;
    if (auto row = answer_of<Answer>(session, {.task = task, .failed = {}}, reply)) {
        if (is_unusable_after(row->reason)) session.dismiss();
        return *row;
    }
    Answer row = answer_without_result(task, equations, reply.reason, reply.error);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return row;
}

void work(WorkerSession& session, const CheckRun& run, const std::vector<check::Question>& equations,
          Board& board) {
    try {
        while (const auto number = board.take()) {
            const CheckTask& task = run.tasks()[*number];
            const Answer row = row_of(session, task, equations);
            board.put(*number, row);
            if (!row.failed() || !run.wants_bundles()) continue;
            Reply reply;
            const auto bundle = answer_of<FailureBundle>(session, {.task = task, .failed = row}, reply);
            board.keep(row, bundle.value_or(FailureBundle{.error = reply.error}));
        }
    } catch (const NoWorker& none) {
        board.give_up(none.reason, none.what());
    } catch (const std::exception& error) {
        board.give_up(Reason::error, error.what());
    }
}

void run_in_workers(CheckRun& run, const CheckerOptions& checker, record::CheckReport& report) {
    const std::vector<std::string> command = worker_command(checker);
    const auto make_session = [&] { return WorkerSession(command, checker.timeout, refusal_of); };
    WorkerSession session = make_session();
    try {
        report.device = record::from_line<Greeting>(session.greeting()).device;
    } catch (const NoWorker& none) {
        if (none.reason == Reason::error) throw DeviceRefused(none.what());
        report.device.name = checker.device.empty() ? "default" : checker.device;
        report.rows.push_back(device_row(none.reason, none.what(), run.tasks().size()));
        return run.take(report.device, report.rows.back());
    }
    run.begin(report.device);
    const std::vector<check::Question> equations = checker.equations({});
    Board board(run, report.device);
    const std::size_t jobs = jobs_of(run.options().jobs, run.tasks().size());
    base::for_each_index(jobs, static_cast<unsigned>(jobs), [&](std::size_t job) {
        if (job == 0) return work(session, run, equations, board);
        WorkerSession own = make_session();  // lives and dies with this thread
        work(own, run, equations, board);
    });
    report.rows = board.finish();
}

void run_here(CheckRun& run, const CheckerOptions& options, record::CheckReport& report) {
    std::optional<Checker> checker;
    try {
        checker.emplace(options);
    } catch (const std::exception& error) {
        throw DeviceRefused(error.what());
    }
    report.device = checker->device();
    run.begin(report.device);
    for (const CheckTask& task : run.tasks()) {
        const auto known = run.known(report.device, task);
        report.rows.push_back(known ? *known : checker->run(task));
        const Answer& row = report.rows.back();
        run.take(report.device, row);
        if (!known && row.failed() && run.wants_bundles())
            run.keep(report.device, row, checker->bundle(task, row));
    }
}

}  // namespace

check::Answer device_row(Reason reason, const std::string& error, std::size_t checks_left) {
    check::Answer row{{.equation = "device"}};
    row.error = fmt::format("the device cannot be opened, {} checks were not run: {}", checks_left, error);
    row.reason = reason;
    return row;
}

record::CheckReport run_on_device(CheckRun& run, const CheckerOptions& checker) {
    record::CheckReport report;
    (run.options().in_process ? run_here : run_in_workers)(run, checker, report);
    return report;
}

}  // namespace gloam::cli
