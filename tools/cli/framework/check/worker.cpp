// SPDX-License-Identifier: MIT
#include "cli/framework/check/worker.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "audit/audit.hpp"
#include "audit/own_domain.hpp"
#include "backend/gl/device.hpp"
#include "base/text.hpp"
#include "cli/environment.hpp"
#include "cli/framework/open_device.hpp"
#include "module/include.hpp"
#include "record/answer_json.hpp"

// The messages between workers and their parent are one line of JSON each: record::line_of(), and
// record::from_line(), which throws std::runtime_error with the missing or invalid part.
namespace gloam::judge {
GLOAM_MEMBERS(AnswerIdentity, equation, function, file, variant)
GLOAM_MEMBERS(RunOptions, inputs, seed)
GLOAM_MEMBERS(Reproduction, glsl, spirv, steps, before, opengl, assembly, count, failure,
              rules)  // what is written
}  // namespace gloam::judge

namespace gloam::record {
GLOAM_MEMBERS(FailureBundle, reproduction, amber, c_program, error)
}  // namespace gloam::record

namespace gloam::cli {

using record::FailureBundle;

GLOAM_MEMBERS(OwnFileOptions, ranges, includes, defines)
GLOAM_MEMBERS(CheckTask, identity, run, coverage, path, own)

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* this_program = "/proc/self/exe";
constexpr const char* subcommand = "check-worker";

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// The row of a check that has no result.
judge::Answer answer_without_result(const CheckTask& task, const std::exception& error,
                                    Clock::time_point begin) {
    judge::Answer answer{task.identity};
    answer.error = error.what();
    answer.reason = base::reason_of(error);
    answer.seconds = seconds_since(begin);
    return answer;
}

// To a worker: a check to run, or one that failed, to be prepared for a report. A check that did not run is
// not tried again, because that has already cost a worker.
struct Request {
    CheckTask task;
    std::optional<judge::Answer> failed = {};
};

GLOAM_MEMBERS(Request, task, failed)

// The devices that `list` returns, or why there are none.
template <class List>
Listing listing_of(const List& list) {
    try {
        return {.devices = list()};
    } catch (const std::exception& error) {
        return {.error = error.what()};
    }
}

// Opens the device in this process. A worker's greeting says so.
Listing greeting_of(std::optional<Checker>& checker, const CheckOptions& options) {
    return listing_of([&] {
        if (!options.manifest.empty())
            backend::vulkan::choose_drivers(std::array{std::filesystem::path(options.manifest)});
        return std::vector{checker.emplace(options).device()};
    });
}

// The way to the parent. Standard output itself becomes standard error, because a driver may print.
std::FILE* open_replies() {
    std::FILE* const replies = fdopen(dup(STDOUT_FILENO), "w");
    if (replies == nullptr || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        throw std::system_error(errno, std::generic_category(), "no standard output");
    return replies;
}

template <class T>
void send(std::FILE* replies, const T& message) {
    std::fputs((record::line_of(message) + "\n").c_str(), replies);
    std::fflush(replies);
}

std::vector<backend::DeviceInfo> devices_of(const std::string& what) {
    if (what == "vulkan" || what == "manifests") return backend::vulkan::list_devices();
    const auto found = backend::gl::list_devices(what);
    return {found.begin(), found.end()};
}

std::vector<std::string> worker_command(const CheckOptions& options) {
    std::vector<std::string> command{this_program, subcommand, "--timeout", fmt::to_string(options.timeout)};
    if (!options.device.empty()) command.push_back("--device=" + options.device);
    if (!options.manifest.empty()) command.push_back("--driver=" + options.manifest);
    if (options.validation) command.emplace_back("--validation");
    return command;
}

}  // namespace

Checker::Checker(const CheckOptions& options) : options_(options) {
    lab({.identity = {.variant = "shipped"}});
}

const subject::Lab& Checker::lab(const CheckTask& task) {
    if (!task.path.empty() && !file_)  // which the command has tried
        file_ = std::make_shared<const subject::OwnFile>(task.path, module::read_text(task.path),
                                                         include_roots_of(task.path, task.own.includes),
                                                         task.own.defines);
    const std::string& variant = task.identity.variant;
    if (lab_ && variant == lab_->options().variant.name && lab_->options().file == file_) return *lab_;
    subject::LabOptions options{.device = options_.device,
                                .validation = options_.validation,
                                .include_roots = {glsl_directory()},
                                .cache_directory = cache_directory(),
                                .variant = module::variant(variant),
                                .file = file_,
                                .timeout = options_.patience()};
    lab_ = lab_ ? std::make_unique<subject::Lab>(std::move(options), lab_->backend())
                : std::make_unique<subject::Lab>(std::move(options));
    return *lab_;
}

judge::Question Checker::question_of(const CheckTask& task, std::string* described) {
    const std::string& name = task.identity.equation;
    if (task.path.empty() && equations_.empty()) equations_ = options_.named({});
    if (task.path.empty()) return *std::ranges::find(equations_, name, &judge::Question::name);
    const subject::OwnFunctions own = subject::own_functions(lab(task).options(), {name});
    if (own.found.empty())
        throw std::invalid_argument(fmt::format("{}: {}: {}", file_->name, name, own.left_out.front().why));
    const subject::OwnFunction& function = own.found.front();
    const subject::Ranges ranges = ranges_from(task.own.ranges);
    judge::Question question = judge::question_of(*lab_, function, ranges);
    if (!question.must_hold) return question;
    const std::vector<audit::OrdinaryValues> values = audit::ordinary_values(function, ranges);
    question.domain = audit::ordinary_domain(function.function, values);  // for what it is meant for
    for (const audit::OrdinaryValues& one : values)
        if (described != nullptr)
            *described += fmt::format("{} {} {} ({})", described->empty() ? "" : ",", one.parameter, one.text,
                                      one.reason);
    return question;
}

judge::Answer Checker::run(const CheckTask& task) {
    const auto begin = Clock::now();
    try {
        std::string domain;
        const judge::Question question = question_of(task, &domain);
        judge::Answer answer = judge::run(lab(task), question, task.run);
        if (question.must_hold)
            answer.domain = fmt::format("{} different inputs:{}", answer.distinct, domain);
        if (task.coverage && !question.answers)
            answer.coverage = audit::measure_coverage(lab(task), question, task.run);
        answer.seconds = seconds_since(begin);
        return answer;
    } catch (const std::exception& error) {
        return answer_without_result(task, error, begin);
    }
}

FailureBundle Checker::bundle(const CheckTask& task, const judge::Answer& failed) {
    try {
        return bundle_of(lab(task), question_of(task), task, failed);
    } catch (const std::exception& error) {
        return {.error = error.what()};
    }
}

template <class T>
T Worker::asked(const std::string& line) {
    using Heard = base::WorkerProcess::Heard;
    process_->send(line);  // a worker that cannot receive has ended, which receive() will find
    std::string answer;
    const auto used = [this] { return base::processor_time_of(process_->id()); };
    Heard heard = Heard::silence;
    base::wait_patiently(options_.patience(), used, [&](auto until) {
        heard = process_->receive(answer, until);
        return heard != Heard::silence;
    });
    std::optional<base::Failure> failure;
    if (heard == Heard::end) {
        failure.emplace("the process " + process_->end(), judge::Reason::crash);
    } else if (heard == Heard::silence) {
        failure.emplace(fmt::format("not finished after {:g} s, the time limit",
                                    std::chrono::duration<double>(options_.patience()).count()),
                        judge::Reason::hang);
    } else {
        try {
            return record::from_line<T>(answer);
        } catch (const std::exception& error) {
            failure.emplace(fmt::format("the worker's answer makes no sense: {}", error.what()));
        }
    }
    process_.reset();
    throw *failure;
}

// Starts the worker, twice if need be: a driver may fail once.
const record::DeviceSummary& Worker::device() {
    if (process_ || here_) return device_;
    Listing greeting;
    if (options_.in_process) {
        greeting = greeting_of(here_, options_);
    } else {
        for (int attempts = 2; !process_; --attempts) {
            try {
                process_.emplace(worker_command(options_));
                greeting = asked<Listing>("");
            } catch (const std::exception& error) {
                process_.reset();
                if (attempts == 1) throw NoWorker(error.what(), base::reason_of(error));
            }
        }
    }
    if (!greeting.error.empty()) {
        process_.reset();
        throw NoWorker(greeting.error);
    }
    const backend::DeviceInfo& info = greeting.devices.at(0);
    return device_ = {.name = base::one_line(info.name),
                      .manifest = options_.manifest,
                      .driver = base::one_line(info.driver),
                      .type = info.type,
                      .api_version = info.api_version,
                      .float32 = info.float32};
}

judge::Answer Worker::run(const CheckTask& task) {
    device();
    if (here_) return here_->run(task);
    const auto begin = Clock::now();
    try {
        judge::Answer row = asked<judge::Answer>(record::line_of(Request{task}));
        using enum judge::Reason;  // those after which the device cannot be used
        if (row.reason == device_lost || row.reason == hang || row.reason == out_of_memory) process_.reset();
        return row;
    } catch (const base::Failure& failure) {
        return answer_without_result(task, failure, begin);
    }
}

FailureBundle Worker::bundle(const CheckTask& task, const judge::Answer& failed) {
    device();
    if (here_) return here_->bundle(task, failed);
    try {
        return asked<FailureBundle>(record::line_of(Request{task, failed}));
    } catch (const base::Failure& failure) {
        return {.error = failure.what()};
    }
}

std::vector<std::string> listing_command(const std::string& what) {
    return {this_program, subcommand, "--list", what};
}

Command check_worker_command(EquationsNamed* equations) {
    static CheckOptions options{.named = equations};
    static std::string list;
    return {.name = subcommand,
            .options = {{"--device", &options.device},
                        {"--driver", &options.manifest},
                        {"--timeout", &options.timeout, positive, "seconds"},
                        {"--validation", &options.validation},
                        {"--list", &list, "only list the devices: vulkan, manifests, or an OpenGL executor"}},
            .run = [] {
                if (list == "manifests") dup2(STDOUT_FILENO, STDERR_FILENO);  // there the loader says them
                std::FILE* const replies = open_replies();
                if (!list.empty()) {
                    send(replies, listing_of([] { return devices_of(list); }));
                    return 0;
                }
                std::optional<Checker> checker;
                std::string line;
                std::getline(std::cin, line);
                send(replies, greeting_of(checker, options));
                while (checker && std::getline(std::cin, line)) {
                    const auto request = record::from_line<Request>(line);
                    if (request.failed)
                        send(replies, checker->bundle(request.task, *request.failed));
                    else
                        send(replies, checker->run(request.task));
                }
                return 0;
            }};
}

}  // namespace gloam::cli
