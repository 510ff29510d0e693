// SPDX-License-Identifier: MIT
#include "cli/framework/check/checker.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "audit/coverage.hpp"
#include "audit/own_domain.hpp"
#include "backend/backend.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "cli/environment.hpp"
#include "judge/reproduction.hpp"
#include "module/include.hpp"
#include "module/spirv.hpp"
#include "module/steps.hpp"

namespace gloam::cli {

check::Ranges ranges_from(const std::vector<std::string>& texts) {
    check::Ranges ranges;
    for (const std::string& text : texts) ranges.insert(check::range_from(text));
    return ranges;
}

namespace {

void require_known(const check::Ranges& ranges, const std::vector<check::OwnFunction>& functions) {
    std::set<std::string> names;
    for (const check::OwnFunction& own : functions)
        for (const shader::Parameter& parameter : own.function.parameters) names.insert(parameter.name);
    for (const auto& range : ranges) {
        if (!names.contains(range.first))
            throw std::invalid_argument(fmt::format("--range {}: no parameter has this name, only: {}",
                                                    range.first, fmt::join(names, ", ")));
    }
}

}  // namespace

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

std::vector<std::string> file_and_functions(const std::vector<std::string>& words,
                                            EquationsNamed* equations) {
    std::vector<std::string> all = words;
    std::error_code none;
    all.front() = path_of_shader(all.front());
    if (is_shader_file(all.front()) || std::filesystem::exists(all.front(), none)) return all;
    all.clear();
    for (const check::Question& equation : equations(words)) {
        const std::string file = path_of_shader(equation.file);
        if (all.empty()) all.push_back(file);
        if (all.front() != file)
            throw std::invalid_argument(
                fmt::format("{} and {}: expected equations of one file", all.front(), file));
        all.push_back(equation.function);
    }
    return all;
}

std::shared_ptr<const check::OwnFile> own_file(const std::filesystem::path& file,
                                               const std::vector<std::string>& includes,
                                               const std::vector<std::string>& defines) {
    const std::filesystem::path path = std::filesystem::absolute(file);
    std::string text = shader::read_text(file);
    return base::tried(file.string(), [&] {
        return std::make_shared<const check::OwnFile>(path, std::move(text), include_roots_of(path, includes),
                                                      defines);
    });
}

check::Lab lab_of(std::shared_ptr<const check::OwnFile> file, const std::string& device) {
    return check::Lab({.device = device, .cache_directory = cache_directory(), .file = std::move(file)});
}

check::OwnFunctions functions_of(const std::shared_ptr<const check::OwnFile>& file,
                                 const std::vector<std::string>& names, const check::Ranges& ranges) {
    check::OwnFunctions functions = base::tried(file->name, [&] {
        return check::own_functions({.cache_directory = cache_directory(), .file = file}, names);
    });
    require_known(ranges, functions.found);
    return functions;
}

std::string why_nothing(const std::vector<check::LeftOut>& left_out) {
    if (left_out.empty())
        return "it defines no function but main in GLSL (HLSL is not read), or its #if conditions leave none";
    if (left_out.size() == 1) return left_out.front().name + ": " + left_out.front().why;
    return fmt::format("all {} functions were left out", left_out.size());
}

OwnSelection own_selection(const std::vector<std::string>& words, const std::vector<std::string>& ranges,
                           const std::vector<std::string>& includes,
                           const std::vector<std::string>& defines) {
    const std::string& file = words.front();
    const std::shared_ptr<const check::OwnFile> own = own_file(file, includes, defines);
    const check::OwnFunctions functions =
        functions_of(own, {words.begin() + 1, words.end()}, ranges_from(ranges));
    OwnSelection selection;
    const std::string& version = own->excerpts.version;
    if (!version.empty() && version != "450" && version != "450 core")
        selection.notes.push_back(
            fmt::format("{}: #version {} is compiled as #version 450 for Vulkan", file, version));
    for (const std::string& made : own->excerpts.by_macro)
        selection.notes.push_back(fmt::format(
            "{}: {}: functions that a macro makes are not looked at; write one out to check it", file, made));
    const std::vector<check::LeftOut>& left_out = functions.left_out;
    for (const check::LeftOut& function : left_out) {
        selection.notes.push_back(
            base::one_line(fmt::format("{}: {} was left out: {}", file, function.name, function.why)));
        selection.complete = selection.complete && !function.is_error && words.size() == 1;
    }
    for (const check::OwnFunction& function : functions.found) selection.names.push_back(function.name);
    if (!selection.names.empty()) return selection;
    if (left_out.size() > 1)
        for (const std::string& note : selection.notes) fmt::print("{}\n", note);
    throw std::runtime_error(fmt::format("{}: nothing was checked: {}", file, why_nothing(left_out)));
}

namespace {

// The question of a task about a function of its file.
check::Question own_question(const check::Lab& lab, const CheckTask& task) {
    const check::OwnFunctions own = check::own_functions(lab.options(), {task.equation});
    if (own.found.empty())
        throw std::invalid_argument(
            fmt::format("{}: {}: {}", lab.options().file->name, task.equation, own.left_out.front().why));
    const check::OwnFunction& function = own.found.front();
    const check::Ranges ranges = ranges_from(task.ranges);
    check::Question question = check::question_of(lab, function, ranges);
    if (question.must_hold)  // for what it is meant for
        question.domain = check::ordinary_domain(function.function, check::ordinary_values(function, ranges));
    return question;
}

check::RunOptions options_of(const CheckTask& task) {
    return {.inputs = task.inputs, .seed = task.seed};
}

}  // namespace

Checker::Checker(CheckerOptions options) : options_(std::move(options)), equations_(options_.equations({})) {
    lab({.variant = "shipped"});
}

const check::Lab& Checker::lab(const CheckTask& task) {
    if (!task.file.empty() && !file_)  // which the command has tried
        file_ =
            std::make_shared<const check::OwnFile>(task.file, shader::read_text(task.file),
                                                   include_roots_of(task.file, task.includes), task.defines);
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
    return summary_of(lab_->info());
}

record::DeviceSummary summary_of(const backend::DeviceInfo& info) {
    return {.name = base::one_line(info.name),
            .driver = base::one_line(info.driver),
            .type = info.type,
            .api_version = info.api_version,
            .preserves_signed_zero_inf_nan = info.float32.preserves_signed_zero_inf_nan,
            .preserves_denormals = info.float32.preserves_denormals,
            .flushes_denormals = info.float32.flushes_denormals,
            .rounds_to_even = info.float32.rounds_to_even};
}

check::Answer Checker::run(const CheckTask& task) {
    const auto begin = std::chrono::steady_clock::now();
    check::Answer answer;
    try {
        const check::Question question = question_of(task);
        answer = check::run(lab(task), question, options_of(task));
        if (task.coverage && !question.answers)
            answer.coverage = measure_coverage(lab(task), question, options_of(task));
    } catch (const std::exception& error) {
        answer = answer_without_result(task, equations_, base::reason_of(error), error.what());
    }
    answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return answer;
}

HandOver Checker::hand_over(const HandOverRequest& request) {
    try {
        const CheckTask& task = request.task;
        return make_hand_over(lab(task), question_of(task), request, options_of(task));
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
