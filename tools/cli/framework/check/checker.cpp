// SPDX-License-Identifier: MIT
#include "cli/framework/check/checker.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <new>
#include <set>
#include <stdexcept>
#include <utility>

#include "audit/coverage.hpp"
#include "audit/own_domain.hpp"
#include "backend/backend.hpp"
#include "base/compiler_limits.hpp"
#include "base/text.hpp"
#include "cli/environment.hpp"
#include "interpreter/program.hpp"
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

OwnFile own_file(const std::string& file, const std::vector<std::string>& names,
                 const std::vector<std::string>& ranges, const std::vector<std::string>& includes,
                 const std::vector<std::string>& defines) {
    const std::filesystem::path path = std::filesystem::absolute(file);
    const std::string text = shader::read_text(file);
    const check::Ranges known = ranges_from(ranges);
    OwnFile own = base::tried(file, [&] {
        const auto all = shader::excerpts({path.string(), text}, include_roots_of(path, includes), defines);
        return OwnFile{all.version, all.by_macro,
                       check::own_functions({.cache_directory = cache_directory(), .excerpts = all.functions},
                                            path.filename().string(), names)};
    });
    require_known(known, own.functions.found);
    return own;
}

check::Lab lab_of_file(const std::filesystem::path& file, const std::vector<std::string>& includes,
                       const std::vector<std::string>& defines, const std::string& device) {
    const std::filesystem::path path = std::filesystem::absolute(file);
    const auto roots = include_roots_of(path, includes);
    return check::Lab(
        {.device = device,
         .include_roots = roots,
         .cache_directory = cache_directory(),
         .excerpts = shader::excerpts({path.string(), shader::read_text(file)}, roots, defines).functions});
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
    const OwnFile own = own_file(file, {words.begin() + 1, words.end()}, ranges, includes, defines);
    OwnSelection selection;
    if (!own.version.empty() && own.version != "450" && own.version != "450 core")
        selection.notes.push_back(
            fmt::format("{}: #version {} is compiled as #version 450 for Vulkan", file, own.version));
    for (const std::string& made : own.by_macro)
        selection.notes.push_back(fmt::format(
            "{}: {}: functions that a macro makes are not looked at; write one out to check it", file, made));
    const std::vector<check::LeftOut>& left_out = own.functions.left_out;
    for (const check::LeftOut& function : left_out) {
        selection.notes.push_back(
            base::one_line(fmt::format("{}: {} was left out: {}", file, function.name, function.why)));
        selection.complete = selection.complete && !function.is_error && words.size() == 1;
    }
    for (const check::OwnFunction& function : own.functions.found) selection.names.push_back(function.name);
    if (!selection.names.empty()) return selection;
    if (left_out.size() > 1)
        for (const std::string& note : selection.notes) fmt::print("{}\n", note);
    throw std::runtime_error(fmt::format("{}: nothing was checked: {}", file, why_nothing(left_out)));
}

namespace {

// The question of a task about a function of its file.
check::Question own_question(const check::Lab& lab, const CheckTask& task) {
    const std::string file = std::filesystem::path(task.file).filename().string();
    const check::OwnFunctions own = check::own_functions(lab.options(), file, {task.equation});
    if (own.found.empty())
        throw std::invalid_argument(fmt::format("{}: {}: {}", file, task.equation, own.left_out.front().why));
    const check::OwnFunction& function = own.found.front();
    const check::Ranges ranges = ranges_from(task.ranges);
    check::Question question = check::question_of(lab, file, function, ranges);
    if (question.must_hold)  // for what it is meant for
        question.domain = check::ordinary_domain(function.function, check::ordinary_values(function, ranges));
    return question;
}

// The kind of an error, from an exception of the rooms.
check::Reason reason_of(const std::exception& error) {
    using check::Reason;
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return Reason::out_of_memory;
    if (dynamic_cast<const backend::OutOfMemory*>(&error) != nullptr) return Reason::out_of_memory;
    if (dynamic_cast<const backend::DeviceLost*>(&error) != nullptr) return Reason::device_lost;
    if (dynamic_cast<const backend::Hang*>(&error) != nullptr) return Reason::hang;
    if (dynamic_cast<const backend::Unsupported*>(&error) != nullptr) return Reason::unsupported;
    if (dynamic_cast<const shader::StepUnavailable*>(&error) != nullptr) return Reason::unsupported;
    if (dynamic_cast<const shader::Unchanged*>(&error) != nullptr) return Reason::unchanged;
    if (const auto* of_shader = dynamic_cast<const interpreter::Error*>(&error)) {
        if (of_shader->kind() == interpreter::Error::Kind::unknown_instruction) return Reason::unsupported;
        if (of_shader->kind() == interpreter::Error::Kind::race) return Reason::race;
        if (of_shader->kind() == interpreter::Error::Kind::divergent_barrier) return Reason::divergent;
    }
    return Reason::error;
}

constexpr std::string_view first_variant = "shipped";

std::unique_ptr<check::Lab> make_lab(const CheckerOptions& options, const shader::Variant& variant,
                                     const std::vector<std::filesystem::path>& roots,
                                     const std::filesystem::path& file,
                                     const std::vector<std::string>& defines,
                                     std::shared_ptr<backend::Backend> device) {
    std::vector<shader::Excerpt> excerpts;
    if (!file.empty())
        excerpts = shader::excerpts({file.string(), shader::read_text(file)}, roots, defines).functions;
    check::LabOptions made{.device = options.device,
                           .validation = options.validation,
                           .include_roots = roots,
                           .cache_directory = cache_directory(),
                           .variant = variant,
                           .excerpts = std::move(excerpts),
                           .timeout = options.timeout};
    if (device == nullptr) return std::make_unique<check::Lab>(std::move(made));
    return std::make_unique<check::Lab>(std::move(made), std::move(device));
}

check::RunOptions options_of(const CheckTask& task) {
    return {.inputs = task.inputs, .seed = task.seed};
}

}  // namespace

Checker::Checker(CheckerOptions options) : options_(std::move(options)), equations_(options_.equations({})) {
    lab(std::string(first_variant), {glsl_directory()}, {});
}

const check::Lab& Checker::lab(const std::string& variant, const std::vector<std::filesystem::path>& roots,
                               const std::filesystem::path& file, const std::vector<std::string>& defines) {
    if (!lab_ || variant != variant_ || roots != roots_ || file != file_ || defines != defines_) {
        const std::shared_ptr<backend::Backend> device = lab_ ? lab_->backend() : nullptr;
        lab_ = make_lab(options_, shader::variant(variant), roots, file, defines, device);
        variant_ = variant;
        roots_ = roots;
        file_ = file;
        defines_ = defines;
    }
    return *lab_;
}

const check::Lab& Checker::lab(const CheckTask& task) {
    if (task.file.empty()) return lab(task.variant, {glsl_directory()}, {});
    return lab(task.variant, include_roots_of(task.file, task.includes), task.file, task.defines);
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
        if (task.coverage) answer.coverage = measure_coverage(lab(task), question, options_of(task));
    } catch (const std::exception& error) {
        answer = answer_without_result(task, equations_, reason_of(error), error.what());
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
    check::Answer answer{.equation = task.equation,
                         .function = task.equation.substr(0, task.equation.find('(')),
                         .file = std::filesystem::path(task.file).filename().string(),
                         .variant = task.variant,
                         .error = error,
                         .reason = reason};
    const auto found = std::ranges::find(equations, task.equation, &check::Question::name);
    if (!task.file.empty() || found == equations.end()) return answer;
    answer.function = found->function;
    answer.file = found->file;
    return answer;
}

}  // namespace gloam::cli
