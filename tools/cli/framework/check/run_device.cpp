// SPDX-License-Identifier: MIT
#include "cli/framework/check/run_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>

#include "base/threads.hpp"
#include "cli/framework/check/checker.hpp"
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

// Distributes tasks to several threads and collects their rows; rows are reported in the order of the tasks.
class Board {
  public:
    Board(const DeviceRun& run, const record::DeviceSummary& device)
        : run_(run), device_(device), rows_(run.tasks.size()) {
        if (!run.known) return;
        for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] = run.known(device, run.tasks[i]);
        tell_next();
    }

    std::optional<std::size_t> take() {
        const std::scoped_lock lock(mutex_);
        while (taken_ < rows_.size() && rows_[taken_]) ++taken_;  // known before
        if (given_up_ || trouble_ || taken_ == rows_.size()) return std::nullopt;
        return taken_++;
    }

    void put(std::size_t task, Answer row) {
        const std::scoped_lock lock(mutex_);
        rows_[task] = std::move(row);
        try {
            tell_next();
        } catch (...) {
            keep_trouble();
        }
    }

    void hand_over(const Answer& row, const HandOver& failure) {
        const std::scoped_lock lock(mutex_);
        try {
            run_.on_failure(device_, row, failure);
        } catch (...) {
            keep_trouble();
        }
    }

    // Ends the distribution of tasks.
    void give_up(Reason reason, const std::string& error) {
        const std::scoped_lock lock(mutex_);
        if (!given_up_) given_up_ = {.line = {}, .reason = reason, .error = error};
    }

    // Returns all rows after all threads have ended. Throws what on_row and on_failure threw.
    std::vector<Answer> finish() {
        if (trouble_) std::rethrow_exception(trouble_);
        std::vector<Answer> all;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            if (!rows_[i]) continue;
            if (i >= told_) tell(*rows_[i]);
            all.push_back(std::move(*rows_[i]));
        }
        if (given_up_) {
            all.push_back(device_row(given_up_->reason, given_up_->error, rows_.size() - all.size()));
            tell(all.back());
        }
        return all;
    }

  private:
    void tell(const Answer& row) const {
        if (run_.on_row) run_.on_row(device_, row);
    }

    void tell_next() {
        while (told_ < rows_.size() && rows_[told_]) tell(*rows_[told_++]);
    }

    // Keeps the current exception, so that finish() throws it on its own thread.
    void keep_trouble() {
        if (!trouble_) trouble_ = std::current_exception();
    }

    const DeviceRun& run_;
    const record::DeviceSummary& device_;
    std::mutex mutex_;
    std::vector<std::optional<Answer>> rows_;
    std::size_t taken_ = 0;
    std::size_t told_ = 0;
    std::optional<Reply> given_up_;
    std::exception_ptr trouble_;
};

// Asks a worker for the row of one task. Throws NoWorker.
Answer ask(WorkerSession& session, const CheckTask& task, const std::vector<check::Question>& equations) {
    const auto begin = std::chrono::steady_clock::now();
    Reply reply = session.ask(record::line_of(WorkerRequest{.check = task, .hand_over = {}}));
    if (reply.error.empty()) {
        try {
            Answer row = record::from_line<Answer>(reply.line);
            if (is_unusable_after(row.reason)) session.dismiss();
            return row;
        } catch (const std::runtime_error& error) {
            reply.reason = Reason::error;
            reply.error = fmt::format("the worker's answer makes no sense: {}", error.what());
            session.dismiss();
        }
    }
    Answer row = answer_without_result(task, equations, reply.reason, reply.error);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return row;
}

// Asks a worker to prepare a failure for a report. Throws NoWorker.
HandOver ask_more(WorkerSession& session, const CheckTask& task, const Answer& row) {
    const Reply reply =
        session.ask(record::line_of(WorkerRequest{.check = {}, .hand_over = request_for(task, row)}));
    if (!reply.error.empty()) return {.error = reply.error};
    try {
        return record::from_line<HandOver>(reply.line);
    } catch (const std::exception& error) {
        session.dismiss();
        return {.error = fmt::format("the worker's answer makes no sense: {}", error.what())};
    }
}

void work(WorkerSession& session, const DeviceRun& run, const std::vector<check::Question>& equations,
          Board& board) {
    try {
        while (const auto task = board.take()) {
            const Answer row = ask(session, run.tasks[*task], equations);
            board.put(*task, row);
            if (row.failed() && run.on_failure)
                board.hand_over(row, ask_more(session, run.tasks[*task], row));
        }
    } catch (const NoWorker& none) {
        board.give_up(none.reason, none.what());
    } catch (const std::exception& error) {
        board.give_up(Reason::error, error.what());
    }
}

void run_in_workers(const DeviceRun& run, record::CheckReport& report) {
    const std::vector<std::string> command = worker_command(run.checker);
    const auto make_session = [&] { return WorkerSession(command, run.checker.timeout, refusal_of); };
    WorkerSession session = make_session();
    try {
        report.device = record::from_line<Greeting>(session.greeting()).device;
    } catch (const NoWorker& none) {
        if (none.reason == Reason::error) throw DeviceRefused(none.what());
        report.device.name = run.checker.device.empty() ? "default" : run.checker.device;
        report.rows.push_back(device_row(none.reason, none.what(), run.tasks.size()));
        if (run.on_row) run.on_row(report.device, report.rows.back());
        return;
    }
    if (run.on_device) run.on_device(report.device);
    const std::vector<check::Question> equations = run.checker.equations({});
    Board board(run, report.device);
    const std::size_t jobs = std::max<std::size_t>(1, std::min(run.jobs, run.tasks.size()));
    base::for_each_index(jobs, static_cast<unsigned>(jobs), [&](std::size_t job) {
        if (job == 0) return work(session, run, equations, board);
        WorkerSession own = make_session();  // lives and dies with this thread
        work(own, run, equations, board);
    });
    report.rows = board.finish();
}

void run_here(const DeviceRun& run, record::CheckReport& report) {
    std::optional<Checker> checker;
    try {
        checker.emplace(run.checker);
    } catch (const std::exception& error) {
        throw DeviceRefused(error.what());
    }
    report.device = checker->device();
    if (run.on_device) run.on_device(report.device);
    for (const CheckTask& task : run.tasks) {
        const auto known = run.known ? run.known(report.device, task) : std::nullopt;
        report.rows.push_back(known ? *known : checker->run(task));
        const Answer& row = report.rows.back();
        if (run.on_row) run.on_row(report.device, row);
        if (known || !row.failed() || !run.on_failure) continue;
        run.on_failure(report.device, row, checker->hand_over(request_for(task, row)));
    }
}

}  // namespace

check::Answer device_row(Reason reason, const std::string& error, std::size_t checks_left) {
    check::Answer row{{.equation = "device"}};
    row.error = fmt::format("the device cannot be opened, {} checks were not run: {}", checks_left, error);
    row.reason = reason;
    return row;
}

record::CheckReport run_on_device(const DeviceRun& run) {
    record::CheckReport report;
    (run.in_process ? run_here : run_in_workers)(run, report);
    return report;
}

}  // namespace gloam::cli
