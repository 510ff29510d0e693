// SPDX-License-Identifier: MIT
#include "cli/framework/check/checker.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "audit/audit.hpp"
#include "audit/own_domain.hpp"
#include "backend/backend.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "cli/environment.hpp"
#include "module/include.hpp"
#include "module/spirv.hpp"
#include "module/steps.hpp"

namespace gloam::cli {

check::Ranges ranges_from(const std::vector<std::string>& texts) {
    check::Ranges ranges;
    for (const std::string& text : texts) ranges.insert(check::range_from(text));
    return ranges;
}

bool has_shader_ending(const std::string& word) {
    const std::string ending = base::lower(std::filesystem::path(word).extension().string());
    const std::set<std::string> known{".glsl", ".comp", ".frag", ".vert",  ".fs", ".vs",
                                      ".cs",   ".fsh",  ".vsh",  ".glslh", ".inc"};
    return known.contains(ending);
}

bool is_shader_file(const std::string& word) {
    std::error_code none;
    return has_shader_ending(word) || std::filesystem::is_regular_file(word, none);
}

std::pair<std::string, std::vector<std::string>> file_and_functions(const std::vector<std::string>& words,
                                                                    EquationsNamed* equations) {
    std::string file = path_of_shader(words.front());
    std::error_code none;
    if (is_shader_file(file) || std::filesystem::exists(file, none))
        return {file, {words.begin() + 1, words.end()}};
    std::vector<std::string> functions;
    for (const check::Question& equation : equations(words)) {
        const std::string other = path_of_shader(equation.file);
        if (functions.empty()) file = other;
        if (file != other)
            throw std::invalid_argument(
                fmt::format("{} and {}: expected equations of one file", file, other));
        functions.push_back(equation.function);
    }
    return {file, functions};
}

check::Lab lab_of(std::shared_ptr<const check::OwnFile> file, const std::string& device) {
    return check::Lab({.device = device, .cache_directory = cache_directory(), .file = std::move(file)});
}

FileFunctions functions_of(const std::filesystem::path& file, const std::vector<std::string>& names,
                           const OwnFileOptions& options) {
    const std::string text = shader::read_text(file);
    const check::Ranges ranges = ranges_from(options.ranges);
    FileFunctions all = base::tried(file.string(), [&] {
        const std::filesystem::path path = std::filesystem::absolute(file);
        FileFunctions read{std::make_shared<const check::OwnFile>(
                               path, text, include_roots_of(path, options.includes), options.defines),
                           {}};
        read.functions =
            check::own_functions({.cache_directory = cache_directory(), .file = read.file}, names);
        return read;
    });
    std::set<std::string> parameters;
    for (const check::OwnFunction& own : all.functions.found)
        for (const shader::Parameter& parameter : own.function.parameters) parameters.insert(parameter.name);
    for (const auto& range : ranges)
        if (!parameters.contains(range.first))
            throw std::invalid_argument(fmt::format("--range {}: no parameter has this name, only: {}",
                                                    range.first, fmt::join(parameters, ", ")));
    return all;
}

std::string why_nothing(const std::vector<check::LeftOut>& left_out) {
    if (left_out.empty())
        return "it defines no function but main in GLSL (HLSL is not read), or its #if conditions leave none";
    if (left_out.size() == 1) return left_out.front().name + ": " + left_out.front().why;
    return fmt::format("all {} functions were left out", left_out.size());
}

namespace {

// The question of a task about a function of its file.
check::Question own_question(const check::Lab& lab, const CheckTask& task) {
    const check::OwnFunctions own = check::own_functions(lab.options(), {task.equation});
    if (own.found.empty())
        throw std::invalid_argument(
            fmt::format("{}: {}: {}", lab.options().file->name, task.equation, own.left_out.front().why));
    const check::OwnFunction& function = own.found.front();
    const check::Ranges ranges = ranges_from(task.own.ranges);
    check::Question question = check::question_of(lab, function, ranges);
    if (question.must_hold)  // for what it is meant for
        question.domain = check::ordinary_domain(function.function, check::ordinary_values(function, ranges));
    return question;
}

}  // namespace

Checker::Checker(CheckerOptions options) : options_(std::move(options)), equations_(options_.equations({})) {
    lab({.variant = "shipped"});
}

const check::Lab& Checker::lab(const CheckTask& task) {
    if (!task.file.empty() && !file_)  // which the command has tried
        file_ = std::make_shared<const check::OwnFile>(task.file, shader::read_text(task.file),
                                                       include_roots_of(task.file, task.own.includes),
                                                       task.own.defines);
    if (lab_ && task.variant == lab_->options().variant.name && lab_->options().file == file_) return *lab_;
    check::LabOptions options{.device = options_.device,
                              .validation = options_.validation,
                              .include_roots = {glsl_directory()},
                              .cache_directory = cache_directory(),
                              .variant = shader::variant(task.variant),
                              .file = file_,
                              .timeout = options_.timeout};
    lab_ = lab_ ? std::make_unique<check::Lab>(std::move(options), lab_->backend())
                : std::make_unique<check::Lab>(std::move(options));
    return *lab_;
}

check::Question Checker::question_of(const CheckTask& task) {
    if (!task.file.empty()) return own_question(lab(task), task);
    const auto found = std::ranges::find(equations_, task.equation, &check::Question::name);
    if (found == equations_.end()) throw std::invalid_argument("no equation has the ID " + task.equation);
    return *found;
}

record::DeviceSummary Checker::device() const {
    const backend::DeviceInfo& info = lab_->info();
    return {.name = base::one_line(info.name),
            .driver = base::one_line(info.driver),
            .type = info.type,
            .api_version = info.api_version,
            .float32 = info.float32};
}

check::Answer Checker::run(const CheckTask& task) {
    const auto begin = std::chrono::steady_clock::now();
    check::Answer answer;
    try {
        const check::Question question = question_of(task);
        answer = check::run(lab(task), question, task.run);
        if (task.coverage && !question.answers)
            answer.coverage = measure_coverage(lab(task), question, task.run);
    } catch (const std::exception& error) {
        answer = answer_without_result(task, equations_, base::reason_of(error), error.what());
    }
    answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return answer;
}

FailureBundle Checker::bundle(const CheckTask& task, const check::Answer& failed) {
    try {
        return bundle_of(lab(task), question_of(task), task, failed);
    } catch (const std::exception& error) {
        return {.error = error.what()};
    }
}

check::Answer answer_without_result(const CheckTask& task, const std::vector<check::Question>& equations,
                                    check::Reason reason, const std::string& error) {
    check::Answer answer{{.equation = task.equation,
                          .function = task.equation.substr(0, task.equation.find('(')),
                          .file = std::filesystem::path(task.file).filename().string(),
                          .variant = task.variant}};
    answer.error = error;
    answer.reason = reason;
    const auto found = std::ranges::find(equations, task.equation, &check::Question::name);
    if (!task.file.empty() || found == equations.end()) return answer;
    answer.function = found->function;
    answer.file = found->file;
    return answer;
}

}  // namespace gloam::cli
